// SPDX-License-Identifier: MIT
#include "render/typeset/paragraph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kProse =
    "The body in the picture is a hard test: a slender rod with the moments 1, 1 and 0.0001. It spins with "
    "200 rad/s about its length and with 0.1 rad/s across it. The step is one millisecond, so the rod turns "
    "by 0.2 rad in each step. Watch the direction: in a free motion it must not move at all, and any trail "
    "that it leaves is an error of the well-known method.";

TextSpan text(std::string words) {
  TextSpan span;
  span.source = {0, static_cast<std::uint32_t>(words.size())};
  span.text = std::move(words);
  return span;
}
TextSpan bold(std::string words) {
  TextSpan span = text(std::move(words));
  span.bold = true;
  return span;
}
TextSpan formula(const std::string& tex) {
  TextSpan span = text(tex);
  span.kind = TextSpan::Kind::math;
  auto math = parse_math(tex);
  EXPECT_TRUE(math.ok()) << tex;
  if (math) span.math = *math;
  return span;
}
RichText one(std::vector<TextSpan> spans) {
  std::uint32_t at = 0;
  for (TextSpan& span : spans) {
    const std::uint32_t size = span.source.end - span.source.begin;
    span.source = {at, at + size};
    at += size;
  }
  return {{0, "", std::move(spans)}};
}
RichText one(std::string words) { return one({text(std::move(words))}); }

class Paragraph : public ::testing::Test {
 protected:
  void SetUp() override {
    auto opened = Fonts::open();
    ASSERT_TRUE(opened) << opened.error();
    fonts_.emplace(std::move(*opened));
    style_.size = 23.0;
    style_.width = 640.0;
  }
  DisplayList set(const RichText& text) {
    auto list = set_text(text, style_, *fonts_);
    EXPECT_TRUE(list.ok()) << list.error().front().message;
    return list ? *list : DisplayList{};
  }
  std::vector<std::string> errors(const RichText& text) {
    std::vector<std::string> lines;
    const auto list = set_text(text, style_, *fonts_);
    if (list) return lines;
    for (const TypeError& error : list.error())
      lines.push_back(std::to_string(error.offset) + ": " + error.message);
    return lines;
  }
  /// Baselines of the text's own size, from the top.
  std::set<double> baselines(const DisplayList& list) const {
    std::set<double> ys;
    for (const Glyph& glyph : list.glyphs)
      if (glyph.size == style_.size && glyph.face != Face::math) ys.insert(glyph.y);
    return ys;
  }

  std::optional<Fonts> fonts_;
  TextStyle style_;
};

TEST_F(Paragraph, NoLineIsWiderThanTheColumn) {
  for (const bool justified : {false, true})
    for (const double width : {120.0, 333.3, 640.0, 1200.0}) {
      style_.width = width;
      style_.justified = justified;
      const DisplayList list = set(one({text(kProse), formula("\\vec\\omega\\times\\vec L"), text(kProse)}));
      EXPECT_LE(list.width, width + 1e-6);
      for (const Glyph& g : list.glyphs)
        EXPECT_LE(g.x + fonts_->advance(g.face, g.id) * g.size, width + 0.1 * g.size) << width;
    }
}

TEST_F(Paragraph, EveryGlyphOfTheTextIsThereOnce) {
  style_.width = 0.0;
  const DisplayList line = set(one(kProse));
  style_.width = 300.0;
  const DisplayList lines = set(one(kProse));
  const auto ids = [](const DisplayList& list) {
    std::vector<std::uint32_t> all;
    for (const Glyph& g : list.glyphs) all.push_back(g.id);
    return all;
  };
  EXPECT_EQ(ids(line), ids(lines));
  const std::size_t spaces = static_cast<std::size_t>(std::count(kProse, kProse + std::strlen(kProse), ' '));
  EXPECT_EQ(line.glyphs.size(), std::strlen(kProse) - spaces);
}

TEST_F(Paragraph, BaselinesAreWholePixelsDown) {
  style_.size = 17.3;
  const DisplayList list = set({{0, "", {text(kProse)}}, {1, "•", {text(kProse)}}, {0, "", {text(kProse)}}});
  const std::set<double> ys = baselines(list);
  EXPECT_GE(ys.size(), 9U);
  for (const double y : ys) EXPECT_EQ(y, std::round(y));
  EXPECT_EQ(*ys.begin(), 0.0);
  EXPECT_NEAR(list.depth, *ys.rbegin(), 0.3 * style_.size);
}

TEST_F(Paragraph, TheSameTextInTwoSpansGivesTheSameGlyphs) {
  const std::string words = "AV office fly To We.";
  const DisplayList whole = set(one(words));
  for (std::size_t cut = 1; cut < words.size(); ++cut) {
    const DisplayList parts = set(one({text(words.substr(0, cut)), text(words.substr(cut))}));
    EXPECT_EQ(parts, whole) << cut;
  }
}

TEST_F(Paragraph, GlyphsKnowWhereTheyComeFrom) {
  const DisplayList list = set(one({text("Äx "), bold("y")}));
  ASSERT_THAT(list.glyphs, SizeIs(3));
  EXPECT_EQ(list.glyphs[0].source, (SourceSpan{0, 2}));
  EXPECT_EQ(list.glyphs[1].source, (SourceSpan{2, 3}));
  EXPECT_EQ(list.glyphs[2].source, (SourceSpan{4, 5}));
  EXPECT_EQ(list.glyphs[2].face, Face::serif_bold);
}

TEST_F(Paragraph, AnEntityComesFromAllOfItsSource) {
  TextSpan entity = text("𝐿");
  entity.source = {10, 16};
  const DisplayList list = set({{0, "", {entity}}});
  ASSERT_THAT(list.glyphs, SizeIs(1));
  EXPECT_EQ(list.glyphs[0].source, (SourceSpan{10, 16}));
  EXPECT_EQ(list.glyphs[0].face, Face::math) << "the text face lacks it";
}

TEST_F(Paragraph, FacesFollowTheSpans) {
  TextSpan both = text("c"), code = text("d"), italic = text("b");
  both.bold = both.italic = code.code = italic.italic = true;
  const DisplayList list = set(one({text("a"), italic, both, code}));
  std::vector<Face> faces;
  for (const Glyph& g : list.glyphs) faces.push_back(g.face);
  EXPECT_THAT(faces, ElementsAre(Face::serif, Face::serif_italic, Face::serif_bold_italic, Face::mono));
  style_.sans = true;
  EXPECT_EQ(set(one("a")).glyphs.at(0).face, Face::sans);
  style_.bold = true;
  EXPECT_EQ(set(one("a")).glyphs.at(0).face, Face::sans_bold);
}

TEST_F(Paragraph, ALinkHasItsColourAndALineBelow) {
  style_.link_color = color_from_hex(0x005F99);
  style_.width = 150.0;
  TextSpan link = text("the second law and its proof");
  link.link = "https://example.org";
  const DisplayList list = set(one({text("See "), link, text(".")}));
  EXPECT_GE(list.rules.size(), 2U) << "one on each line";
  for (const Rule& rule : list.rules) {
    EXPECT_EQ(rule.color, style_.link_color);
    EXPECT_LE(rule.x1, 150.0 + 1e-6);
    EXPECT_EQ(rule.y0, rule.y1);
  }
  EXPECT_EQ(list.glyphs.front().color, style_.color);
  EXPECT_EQ(list.glyphs[4].color, style_.link_color);
}

TEST_F(Paragraph, AFormulaStandsOnTheBaselineAndKeepsItsPunctuation) {
  style_.width = 0.0;
  const DisplayList list = set(one({text("a "), formula("L"), text(", b")}));
  ASSERT_THAT(list.glyphs, SizeIs(4));
  EXPECT_EQ(list.glyphs[1].face, Face::math);
  for (const Glyph& g : list.glyphs) EXPECT_EQ(g.y, 0.0);
  // Too narrow for both: the comma goes with the formula.
  style_.width = list.glyphs[2].x + 1.0;
  const DisplayList narrow = set(one({text("a "), formula("L"), text(", b")}));
  EXPECT_EQ(narrow.glyphs[1].y, narrow.glyphs[2].y);
  EXPECT_GT(narrow.glyphs[1].y, 0.0);
}

TEST_F(Paragraph, HighFormulasPushTheirLineDownByWholePixels) {
  const DisplayList flat = set(one({text(kProse), text(kProse)}));
  const DisplayList high =
      set(one({text(kProse), formula("\\frac{\\frac{a}{b}}{\\frac{c}{d}}"), text(kProse)}));
  EXPECT_GT(high.depth, flat.depth);
  double below = -1e9, last = 0.0;
  std::map<double, std::pair<double, double>> lines;  // highest and lowest ink of each line
  for (const Glyph& g : high.glyphs) {
    if (g.face != Face::math && g.size == style_.size) last = g.y;
    const GlyphBox box = fonts_->box(g.face, g.id);
    auto [line, is_new] = lines.try_emplace(last, 1e9, -1e9);
    line->second.first = std::min(line->second.first, g.y - box.top * g.size);
    line->second.second = std::max(line->second.second, g.y - box.bottom * g.size);
  }
  for (const auto& [y, ink] : lines) {
    EXPECT_EQ(y, std::round(y));
    EXPECT_GT(ink.first, below) << "lines overlap at " << y;
    below = ink.second;
  }
}

TEST_F(Paragraph, WideFormulasAreBrokenOrMadeSmaller) {
  style_.width = 200.0;
  const DisplayList list =
      set(one({text("So "), formula("a+b+c+d+e+f+g+h+i+j+k+l+m+n+o+p+q=r+s+t+u+v+w"), text(" it is, and "),
               formula("\\overline{aaaaaaaaaaaaaaaaaaaaaaaaaaaaaa}")}));
  EXPECT_LE(list.width, 200.0 + 1e-6);
}

TEST_F(Paragraph, WordsWiderThanTheColumnAreBrokenAnywhere) {
  style_.width = 100.0;
  const std::string word(60, 'm');
  const DisplayList list = set(one("a " + word + " b"));
  EXPECT_THAT(list.glyphs, SizeIs(62));
  EXPECT_LE(list.width, 100.0 + 1e-6);
  EXPECT_GT(baselines(list).size(), 5U);
}

TEST_F(Paragraph, HeadingsAreBalanced) {
  style_.bold = true;
  style_.size = 34.0;
  style_.width = 560.0;
  const DisplayList list = set(one("From the space frame to the body frame"));
  ASSERT_EQ(baselines(list).size(), 2U);
  std::map<double, double> right;
  for (const Glyph& g : list.glyphs) right[g.y] = std::max(right[g.y], g.x);
  EXPECT_GT(right.rbegin()->second, 0.7 * right.begin()->second);
}

TEST_F(Paragraph, JustifiedLinesEndAtTheEdge) {
  style_.justified = true;
  style_.width = 420.0;
  const DisplayList list = set(one(kProse));
  std::map<double, double> right;
  for (const Glyph& g : list.glyphs)
    right[g.y] = std::max(right[g.y], g.x + fonts_->advance(g.face, g.id) * g.size);
  const double last = right.rbegin()->first;
  for (const auto& [y, x] : right) EXPECT_NEAR(x, y == last ? x : 420.0, 1e-6) << y;
}

TEST_F(Paragraph, ListsHangTheirMarkers) {
  const DisplayList list =
      set({{1, "•", {text(kProse)}}, {2, "10.", {text("inner")}}, {1, "", {text("more")}}});
  const double text_x = list.glyphs.front().x;  // the marker is set with its line
  std::map<double, double> left;
  for (const Glyph& g : list.glyphs) {
    const auto [line, is_new] = left.try_emplace(g.y, g.x);
    line->second = std::min(line->second, g.x);
  }
  EXPECT_GE(left.begin()->second, 0.0);
  EXPECT_LT(left.begin()->second, text_x) << "the marker is left of its text";
  EXPECT_NEAR(std::next(left.begin())->second, text_x, 0.1 * style_.size)
      << "and the next line is below the text";
}

TEST_F(Paragraph, ARaisedNumberAsAMarkerHasAllItsDigits) {
  for (const char* marker : {"³", "⁴", "¹²"}) {
    const DisplayList list = set({{1, marker, {text("a note")}}});
    for (const Glyph& glyph : list.glyphs) EXPECT_NE(glyph.id, 0u) << marker;
    const auto raised = std::count_if(list.glyphs.begin(), list.glyphs.end(), [this](const Glyph& glyph) {
      return glyph.size < style_.size && glyph.y < 0.0;
    });
    EXPECT_EQ(static_cast<std::size_t>(raised), marker == std::string("¹²") ? 2u : 1u) << marker;
  }
}

TEST_F(Paragraph, ALineDoesNotEndWithinWhatBelongsTogether) {
  const auto first_words = [this](const std::string& words) {
    std::vector<std::string> first;
    double y = 0.0;
    for (const Glyph& glyph : set(one(words)).glyphs) {
      const std::size_t at = glyph.source.begin;
      if (glyph.y > y) first.push_back(words.substr(at, words.find_first_of(" –", at) - at));
      y = std::max(y, glyph.y);
    }
    return first;
  };
  const std::string words =
      "The axis turns about axis 3, and then about axis 2 with a mass of 25 kg that hangs below axis 1 at a "
      "depth of 12 m or less, and so Moser–Veselov computes it.";
  const std::set<std::string> never = {"kg", "m", "3,", "2", "1", "Veselov"};
  for (style_.width = 300.0; style_.width < 900.0; style_.width += 7.0)
    for (const std::string& word : first_words(words))
      EXPECT_FALSE(never.contains(word)) << word << " at " << style_.width;
}

TEST_F(Paragraph, BreaksWhereItIsTold) {
  TextSpan first = text("one");
  first.break_after = true;
  EXPECT_EQ(baselines(set(one({first, text("two")}))).size(), 2U);
  EXPECT_EQ(baselines(set(one({first, text(" two")}))), baselines(set(one({first, text("two")}))));
}

TEST_F(Paragraph, SpacesCountOnce) {
  EXPECT_EQ(set(one("a   b\n\tc ")).width, set(one("a b c")).width);
  EXPECT_EQ(set(one("  a")).width, set(one("a")).width);
  EXPECT_TRUE(set({}).glyphs.empty());
  EXPECT_TRUE(set(one("")).glyphs.empty());
}

TEST_F(Paragraph, QuotationMarksAreCurled) {
  const auto same = [this](const char* straight, const char* curly) {
    std::vector<std::uint32_t> a, b;
    for (const Glyph& g : set(one(straight)).glyphs) a.push_back(g.id);
    for (const Glyph& g : set(one(curly)).glyphs) b.push_back(g.id);
    EXPECT_EQ(a, b) << straight;
  };
  same("Euler's \"4 'equations'\", (\"so\")", "Euler’s “4 ‘equations’”, (“so”)");
  EXPECT_EQ(set(one({text("\""), formula("L"), text("\"")})).glyphs.back().id,
            *fonts_->glyph(Face::serif, 0x201D))
      << "closes after a formula";
  TextSpan code = text("'");
  code.code = true;
  EXPECT_EQ(set(one({code})).glyphs.at(0).id, *fonts_->glyph(Face::mono, U'\''));
}

TEST_F(Paragraph, RefusesWhatCannotBeSetWithItsPlace) {
  EXPECT_THAT(errors(one("ab \xFF.")), ElementsAre("3: this is not UTF-8 text"));
  EXPECT_THAT(errors(one("ω שלום")), SizeIs(4));
  EXPECT_THAT(errors(one("ab שc")), ElementsAre("3: text from right to left is not set: U+05E9"));
  EXPECT_THAT(errors(one("ab \xE2\x80\xAE")), ElementsAre("3: text from right to left is not set: U+202E"));
  EXPECT_THAT(errors(one({text("ab "), bold("水")})), ElementsAre("3: no font has the character U+6C34"));
  EXPECT_THAT(errors(one("a\x01")), ElementsAre("1: the character U+0001 shows nothing"));
}

TEST_F(Paragraph, ReportsAFewErrorsOfMany) {
  std::string many;
  for (int i = 0; i < 1000; ++i) many += "水";
  EXPECT_THAT(errors(one(many)), SizeIs(16));
}

TEST_F(Paragraph, TakesCharactersOfTheMathFaceAndAccents) {
  EXPECT_THAT(errors(one("𝐿 ≤ 𝜔⃗ → café, e\xCC\x81, 1 ½ m² “so” – naïve…")), IsEmpty());
}

TEST_F(Paragraph, DigitsOfExponentsAndIndicesAreSmallAndOfOneSize) {
  style_.sans = true;
  for (const char* words : {"10⁻¹²", "10²³", "ω₁₂", "L⁰"}) {
    const DisplayList list = set(one(words));
    const Glyph &base = list.glyphs.front(), &last = list.glyphs.back();
    EXPECT_LT(last.size, 0.8 * style_.size) << words;
    EXPECT_EQ(list.glyphs[list.glyphs.size() - 2].size == last.size, words != std::string("L⁰"));
    EXPECT_EQ(last.y < base.y, words != std::string("ω₁₂")) << words;
    EXPECT_EQ(last.face, Face::sans);
    EXPECT_NE(last.id, 0u);
  }
  EXPECT_EQ(set(one("kg m²")).glyphs.back().size, style_.size) << "the font's own, where it stands alone";
  EXPECT_EQ(set(one("kg m²")).glyphs.back().y, 0.0);
}

TEST_F(Paragraph, TallTextFitsItsOwnBox) {
  const DisplayList list = set(one({text(kProse), formula("\\sum_i \\hat x_i"), text(kProse)}));
  const TypeBox ink = ink_box(list, *fonts_);
  EXPECT_GE(ink.y0, -list.ascent - 0.1 * style_.size);
  EXPECT_LE(ink.y1, list.depth + 0.1 * style_.size);
}

TEST_F(Paragraph, LinesAreSetWhateverTheyHold) {
  for (const char* line :
       {"", "$", "a $\\vec L$ b", "$\\nosuch$ x", "\xFF\xFE", "水", "שלום", "\\$5", "a\nb", "$x^{$", "$$"}) {
    const DisplayList list = set_line(line, style_, *fonts_);
    EXPECT_EQ(list.glyphs.empty(), *line == '\0') << line;
    for (const Glyph& g : list.glyphs) EXPECT_EQ(g.size > 0.0, true);
  }
  EXPECT_EQ(set_line("$\\nosuch$", style_, *fonts_).glyphs.size(), 9U) << "shown as it stands";
  EXPECT_EQ(set_line("a\\$", style_, *fonts_).glyphs.size(), 2U);
}

TEST_F(Paragraph, ALineIsOneLine) {
  style_.width = 10.0;
  std::set<double> ys;
  for (const Glyph& g : set_line(kProse, style_, *fonts_).glyphs) ys.insert(g.y);
  EXPECT_EQ(ys.size(), 1U);
}

TEST_F(Paragraph, FormulasOfSansLinesGrowToTheirLetters) {
  style_.sans = true;
  const DisplayList list = set_line("x $x$", style_, *fonts_);
  ASSERT_THAT(list.glyphs, SizeIs(2));
  EXPECT_GT(list.glyphs[1].size, list.glyphs[0].size);
}

TEST_F(Paragraph, TenThousandWordsAreSetInTimeThatGrowsWithThem) {
  std::string many;
  for (int i = 0; i < 200; ++i) many += std::string(kProse) + ' ';
  EXPECT_GT(baselines(set(one(many))).size(), 1000U);
}

RichText table_of(const std::vector<TextTable::Align>& columns,
                  const std::vector<std::vector<std::string>>& rows) {
  TextTable table{columns, {}};
  for (const auto& row : rows) {
    table.rows.emplace_back();
    for (const std::string& words : row)
      table.rows.back().push_back(words.empty() ? TextTable::Cell() : TextTable::Cell{text(words)});
  }
  return {TextBlock{.indent = 0, .marker = {}, .spans = {}, .table = std::move(table)}};
}
constexpr auto kLeft = TextTable::Align::left, kCenter = TextTable::Align::center,
               kRight = TextTable::Align::right;

TEST_F(Paragraph, TablesHaveThreeLinesAndTheirColumnsStraight) {
  const DisplayList list = set(
      table_of({kLeft, kCenter, kRight}, {{"aaaaaa", "aaaaaa", "aaaaaa"}, {"a", "a", "a"}, {"", "aa", ""}}));
  ASSERT_THAT(list.rules, SizeIs(3));
  for (const Rule& rule : list.rules) {
    EXPECT_EQ(rule.y0, rule.y1);
    EXPECT_EQ(rule.x0, list.rules[0].x0);
    EXPECT_EQ(rule.x1, list.rules[0].x1);
    EXPECT_NEAR(rule.x0, style_.width - rule.x1, 1.0) << "in the middle";
  }
  EXPECT_GT(list.rules[0].thickness, list.rules[1].thickness);
  EXPECT_EQ(list.rules[0].thickness, list.rules[2].thickness);
  ASSERT_THAT(list.glyphs, SizeIs(23));
  const double a = fonts_->advance(Face::serif, list.glyphs[0].id) * style_.size;
  const auto at = [&](std::size_t i) { return list.glyphs[i].x; };
  constexpr double kGrid = 0.05;  // glyphs are set on their own grid
  EXPECT_NEAR(at(18), at(0), kGrid) << "left";
  EXPECT_NEAR(at(19) + 0.5 * a, at(6) + 3 * a, kGrid) << "in the middle";
  EXPECT_NEAR(at(20), at(17), kGrid) << "right";
  EXPECT_NEAR(at(21) + a, at(6) + 3 * a, kGrid);
  // Line, head, line, two rows, line: each below the other.
  EXPECT_LT(list.rules[0].y0, list.glyphs[0].y - 0.4 * style_.size);
  EXPECT_GT(list.rules[1].y0, list.glyphs[0].y);
  EXPECT_LT(list.rules[1].y0, list.glyphs[18].y - 0.4 * style_.size);
  EXPECT_GT(list.glyphs[21].y, list.glyphs[18].y + style_.size);
  EXPECT_GT(list.rules[2].y0, list.glyphs[21].y);
  const TypeBox ink = ink_box(list, *fonts_);
  EXPECT_GE(ink.y0, -list.ascent - 1e-9);
  EXPECT_LE(ink.y1, list.depth + 1e-9);
}

TEST_F(Paragraph, TablesAreNoWiderThanTheColumn) {
  const std::string words(kProse);
  for (const double width : {60.0, 150.0, 400.0, 640.0}) {
    style_.width = width;
    for (const RichText& one :
         {table_of({kLeft, kRight}, {{"a", "b"}, {words, words}}),
          table_of({kLeft, kCenter, kLeft}, {{words, "b", "c"}, {"a", "b", std::string(60, 'm')}})}) {
      const DisplayList list = set(one);
      for (const Rule& rule : list.rules) EXPECT_LE(rule.x1, width + 1.0) << width;
      for (const Glyph& g : list.glyphs)
        EXPECT_LE(g.x + fonts_->advance(g.face, g.id) * g.size, width + 2.0) << width;
    }
  }
}

TEST_F(Paragraph, TextGoesOnBelowATable) {
  RichText text = one(std::string("Above."));
  const RichText table = table_of({kLeft}, {{"a"}, {"b"}}), below = one(std::string("Below."));
  text.insert(text.end(), table.begin(), table.end());
  text.insert(text.end(), below.begin(), below.end());
  const DisplayList list = set(text);
  ASSERT_THAT(list.rules, SizeIs(3));
  EXPECT_GT(list.rules[0].y0, list.glyphs.front().y);
  EXPECT_LT(list.rules[2].y0, list.glyphs.back().y - 0.7 * style_.size);
}

TEST_F(Paragraph, WhatTheFontsLackInATableIsSaidOnce) {
  EXPECT_THAT(errors(table_of({kLeft, kLeft}, {{"a", "b"}, {"水", "c"}})), SizeIs(1));
}

}  // namespace
}  // namespace polhode
