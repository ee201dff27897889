// SPDX-License-Identifier: MIT
#include "tests/fuzz/text_inputs.h"

#include <gtest/gtest.h>

namespace polhode::fuzz {
namespace {

TEST(TextFuzz, MutatedTextsAreSetOrRefused) {
  const auto fonts = Fonts::open();
  ASSERT_TRUE(fonts.ok()) << fonts.error();
  Mutator texts = mutated_texts(2026);
  for (int i = 0; i < 3000; ++i) {
    const std::string text = texts.next();
    EXPECT_EQ(finding_in_text(text, i % 7 == 0, *fonts), "") << text;
  }
}

}  // namespace
}  // namespace polhode::fuzz
