// SPDX-License-Identifier: MIT
// Damaged Markdown with formulas, read and set: no crash, every complaint at a place that exists, nothing set
// outside its column. POLHODE_FUZZ=200000 tries more of it, best with the sanitizers of the asan preset.
#include "lessons/inline_text.h"
#include "render/type/paragraph.h"
#include "tests/fuzz/mutator.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polhode {
namespace {

constexpr int kCount = 3000;
constexpr double kWidth = 210.0;

const std::vector<std::string> kPieces = {"*",
                                          "**",
                                          "_",
                                          "`",
                                          "``",
                                          "[",
                                          "](",
                                          ")",
                                          "<",
                                          ">",
                                          "&",
                                          ";",
                                          "&amp;",
                                          "&#x",
                                          "\\",
                                          "$",
                                          "$$",
                                          "\\vec",
                                          "\\frac{",
                                          "}",
                                          "^",
                                          "_{",
                                          "\n",
                                          "\n\n",
                                          "  \n",
                                          "- ",
                                          "1. ",
                                          "> ",
                                          "# ",
                                          "|",
                                          "---",
                                          "```",
                                          "![",
                                          "<b>",
                                          "~",
                                          "\\$",
                                          "\xFF",
                                          "\xE2\x83",
                                          "ω",
                                          "ש",
                                          "水",
                                          "\t",
                                          "\r",
                                          "\"",
                                          "'",
                                          "\xC2\xA0",
                                          "\xE2\x80\x8B",
                                          "\\begin{",
                                          "\\left(",
                                          "&nbsp;",
                                          "[a]: b\n\n",
                                          "\\term{a}{",
                                          "𝐿⃗",
                                          "-",
                                          "—"};

const std::vector<std::string> kSamples = {
    "The tip of $\\vec L$ *moves* with **velocity** $\\vec N$, and `code`.",
    "- One $x_1^2$ \"item\".\n- Two: [a link](http://b.c)\n  1. inner $\\frac{a}{b}$\n\n  more\n",
    "If $|\\vec\\omega|\\ne 0$  \nthen &amp; only then — it's 3-dimensional.",
    "A$\\begin{pmatrix}a&b\\\\c&d\\end{pmatrix}$, 𝐿⃗ and é."};

class InlineTextFuzz : public ::testing::Test {
 protected:
  void SetUp() override {
    auto opened = Fonts::open();
    ASSERT_TRUE(opened) << opened.error();
    fonts_.emplace(std::move(*opened));
  }

  void expect_sound(const std::string& markdown, bool justified) const {
    const SourceText source(markdown);
    Report report(source, "text");
    TextReader texts(report);
    const LocatedText located(source, source.text());
    const RichText text = texts.passage(located);
    const RichText line = texts.line(located);
    for (const Diagnostic& d : report.take()) {
      ASSERT_FALSE(d.message.empty());
      ASSERT_EQ(source.clamp(d.place), d.place) << to_string(d);
    }
    expect_set(text, justified, markdown.size());
    expect_set(line, justified, markdown.size());
    TextStyle style;
    expect_finite(set_line(markdown, style, *fonts_), 1e9, 0);
  }

  void expect_set(const RichText& text, bool justified, std::size_t bytes) const {
    TextStyle style;
    style.width = kWidth;
    style.justified = justified;
    const auto set = set_text(text, style, *fonts_);
    if (set) return expect_finite(*set, kWidth, bytes);
    for (const TypeError& error : set.error()) ASSERT_LE(error.offset, bytes) << error.message;
  }

  static void expect_finite(const DisplayList& list, double width, std::size_t bytes) {
    ASSERT_LE(list.width, width + 1e-6);
    ASSERT_TRUE(std::isfinite(list.width) && std::isfinite(list.ascent) && std::isfinite(list.depth));
    for (const Glyph& g : list.glyphs) {
      ASSERT_TRUE(std::isfinite(g.x) && std::isfinite(g.y) && g.size > 0.0);
      ASSERT_TRUE(bytes == 0 || g.source.end <= bytes);
    }
  }

  std::optional<Fonts> fonts_;
};

TEST_F(InlineTextFuzz, DamagedTextsAreReadAndSet) {
  testing::Mutator mutate(4, kPieces);
  const int count = testing::fuzz_count(kCount);
  for (int i = 0; i < count; ++i) {
    const std::string text = mutate(kSamples[static_cast<std::size_t>(i) % kSamples.size()]);
    expect_sound(text, i % 7 == 0);
    if (HasFatalFailure()) FAIL() << i << ": " << text;
  }
}

TEST_F(InlineTextFuzz, PiecesInAnyOrderToo) {
  testing::Mutator any(9, kPieces);
  const int count = testing::fuzz_count(kCount) / 3;
  for (int i = 0; i < count; ++i) {
    std::string text;
    for (int pieces = any.below(30); pieces > 0; --pieces)
      text += kPieces[static_cast<std::size_t>(any.below(kPieces.size()))] + (any.below(3) == 0 ? "a" : "");
    expect_sound(text, false);
    if (HasFatalFailure()) FAIL() << i << ": " << text;
  }
}

}  // namespace
}  // namespace polhode
