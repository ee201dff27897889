// SPDX-License-Identifier: MIT
#include "app/publish/html_text.h"

#include <gtest/gtest.h>

#include <vector>

namespace polhode {
namespace {

TEST(HtmlText, WhatHtmlReadsBecomesReferences) {
  EXPECT_EQ(html_escaped("</title><img src=x onerror=\"f('&')\">"),
            "&lt;/title&gt;&lt;img src=x onerror=&quot;f(&#39;&amp;&#39;)&quot;&gt;");
  EXPECT_EQ(html_escaped("ω² − 1"), "ω² − 1");
  EXPECT_EQ(html_escaped(std::string_view("a\0b\x1B\n", 5)), "a b \n");
}

// RFC 4648, section 10.
TEST(HtmlText, Base64IsThatOfTheRfc) {
  const auto of = [](std::string_view text) {
    return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foob"), "Zm9vYg==");
  EXPECT_EQ(of("fooba"), "Zm9vYmE=");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::vector<std::uint8_t>{0xFF, 0xEF, 0xBE}), "/+++");
}

// Content Security Policy Level 3, section 6.7.2: the hash of alert('Hello, world.');
TEST(HtmlText, AHashIsThatOfTheStandardsExample) {
  EXPECT_EQ(policy_hash("alert('Hello, world.');"), "'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='");
}

}  // namespace
}  // namespace polhode
