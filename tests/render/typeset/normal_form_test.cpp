// SPDX-License-Identifier: MIT
#include "render/typeset/normal_form.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

// Examples of Unicode Standard Annex 15, figures 3 to 5.
TEST(NormalForm, TakesApartWhatIsPutTogether) {
  EXPECT_EQ(decomposed("Anna"), "Anna");
  EXPECT_EQ(decomposed("\u00E9"), "e\u0301");
  EXPECT_EQ(decomposed("\u212B"), "A\u030A") << "the unit ångström is the letter";
  EXPECT_EQ(decomposed("\u1E69"), "s\u0323\u0307") << "a letter with two marks";
  EXPECT_EQ(decomposed("s\u0307\u0323"), "s\u0323\u0307") << "marks in the order of their classes";
  EXPECT_EQ(decomposed("\uD55C"), "\u1112\u1161\u11AB") << "a syllable of Hangul";
  EXPECT_EQ(decomposed("\uFB01"), "\uFB01") << "a ligature looks otherwise";
}

TEST(NormalForm, OfWhatIsNoTextIsOne) {
  EXPECT_EQ(decomposed(""), "");
  EXPECT_EQ(decomposed("\xff"), "\uFFFD");
  EXPECT_EQ(decomposed("\u0301"), "\u0301");
}

}  // namespace
}  // namespace polhode
