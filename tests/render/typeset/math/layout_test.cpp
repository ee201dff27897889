// SPDX-License-Identifier: MIT
#include "render/typeset/math/math.h"
#include "render/typeset/math/tree.h"
#include "tests/render/typeset/math/formulas.h"

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
using Kind = MathNode::Kind;

constexpr double kSize = 32.0;
/// Of sums of a dozen coordinates below 1000 px.
constexpr double kRounding = 12 * 1000 * 2.3e-16;

const Fonts& fonts() {
  static const Fonts kFonts = Fonts::open().value();
  return kFonts;
}

Math parsed(std::string_view tex) {
  auto math = parse_math(tex);
  EXPECT_TRUE(math.ok()) << tex << ": " << math.error().front().message;
  return math.ok() ? *math : Math{};
}

MathStyle display(double size = kSize) {
  MathStyle style;
  style.size = size;
  style.display = true;
  return style;
}

DisplayList set(std::string_view tex, const MathStyle& style = display()) {
  const auto list = set_math(parsed(tex), style, fonts());
  EXPECT_TRUE(list.ok()) << tex << ": " << list.error().front().message;
  return list.ok() ? *list : DisplayList{};
}

/// The glyph of a byte of the source.
const Glyph& glyph_at(const DisplayList& list, std::size_t byte) {
  const auto found = std::find_if(list.glyphs.begin(), list.glyphs.end(),
                                  [byte](const Glyph& g) { return g.source.begin == byte; });
  EXPECT_NE(found, list.glyphs.end()) << "byte " << byte;
  return *found;
}

double left(const Glyph& g) { return g.x + fonts().box(g.face, g.id).left * g.size; }
double right(const Glyph& g) { return g.x + fonts().box(g.face, g.id).right * g.size; }
double top(const Glyph& g) { return g.y - fonts().box(g.face, g.id).top * g.size; }
double bottom(const Glyph& g) { return g.y - fonts().box(g.face, g.id).bottom * g.size; }
double middle_y(const Glyph& g) { return 0.5 * (top(g) + bottom(g)); }

/// The characters of the formula that a reader sees, by the places of their sources.
void visible(const MathNode& node, std::vector<SourceSpan>& into) {
  if (node.kind == Kind::phantom) return;
  const bool one_glyph = node.kind == Kind::symbol || node.kind == Kind::accent ||
                         (node.kind == Kind::delimiter && node.character != 0);
  if (one_glyph) into.push_back(node.span);
  if (node.kind == Kind::text) {
    for (std::size_t i = 0; i < node.sources.size(); ++i)
      if (node.text.size() != node.sources.size() || node.text[i] != ' ') into.push_back(node.sources[i]);
  }
  for (const MathNode& child : node.children) visible(child, into);
}

bool covers(SourceSpan a, SourceSpan b) { return a.begin <= b.begin && b.end <= a.end; }

TEST(MathLayout, EveryFormulaIsTypesetAndNothingIsLost) {
  const auto formulas = testing::all_formulas();
  ASSERT_GE(formulas.size(), 300U);
  for (const testing::NamedFormula& formula : formulas) {
    const std::string &name = formula.name, &tex = formula.tex;
    const Math math = parsed(tex);
    ASSERT_TRUE(math.root) << name;
    const DisplayList list = set(tex);
    EXPECT_GT(list.width, 0.0) << name;
    std::vector<SourceSpan> seen, sought;
    for (const Glyph& g : list.glyphs) seen.push_back(g.source);
    for (const Rule& r : list.rules) seen.push_back(r.source);
    visible(*math.root, sought);
    for (const SourceSpan span : seen) {
      EXPECT_LT(span.begin, span.end) << name;
      EXPECT_LE(span.end, tex.size()) << name;
    }
    for (const SourceSpan span : sought) {
      const bool space = span.end == span.begin + 1 && tex[span.begin] == ' ';
      const bool drawn = std::any_of(seen.begin(), seen.end(),
                                     [&](SourceSpan s) { return s.begin == span.begin || covers(span, s); });
      // A ligature stands for the characters up to the next glyph.
      const bool in_ligature = std::any_of(seen.begin(), seen.end(), [&](SourceSpan s) {
        return s.begin < span.begin && span.begin <= s.begin + 2 && tex[s.begin] == 'f';
      });
      EXPECT_TRUE(drawn || space || in_ligature)
          << name << ": " << tex.substr(span.begin, span.end - span.begin);
    }
  }
}

TEST(MathLayout, TwiceTheSizeIsTwiceEverything) {
  // Multiplying by two is exact.
  for (const auto& [name, tex] : testing::all_formulas()) {
    const DisplayList one = set(tex, display(24.0)), two = set(tex, display(48.0));
    EXPECT_EQ(2.0 * one.width, two.width) << name;
    ASSERT_EQ(one.glyphs.size(), two.glyphs.size()) << name;
    for (std::size_t i = 0; i < one.glyphs.size(); ++i) {
      EXPECT_EQ(one.glyphs[i].id, two.glyphs[i].id) << name;
      EXPECT_EQ(2.0 * one.glyphs[i].x, two.glyphs[i].x) << name;
      EXPECT_EQ(2.0 * one.glyphs[i].y, two.glyphs[i].y) << name;
      EXPECT_EQ(2.0 * one.glyphs[i].size, two.glyphs[i].size) << name;
    }
  }
}

TEST(MathLayout, MeasuresHoldTheInk) {
  for (const auto& [name, tex] : testing::all_formulas()) {
    const DisplayList list = set(tex);
    const TypeBox ink = ink_box(list, fonts());
    // Italic letters reach beyond their advance to the left, slanted strokes to all sides.
    constexpr double kBeyond = 0.25 * kSize;
    EXPECT_GE(ink.x0, -kBeyond) << name;
    EXPECT_LE(ink.x1, list.width + kBeyond) << name;
    EXPECT_GE(ink.y0, -list.ascent - kBeyond) << name;
    EXPECT_LE(ink.y1, list.depth + kBeyond) << name;
    EXPECT_GE(list.ascent, 0.0);
    EXPECT_GE(list.depth, 0.0);
  }
}

TEST(MathLayout, ARowStandsOnItsBaseline) {
  for (const Glyph& g : set("a + b = \\omega f (x)").glyphs) EXPECT_EQ(g.y, 0.0);
}

TEST(MathLayout, BarsOfFractionsLieOnTheAxis) {
  const double axis = -0.25 * kSize;  // AxisHeight of the font
  const DisplayList list = set("x = \\frac{a}{b} + \\frac{1+\\gamma^2}{2}");
  ASSERT_THAT(list.rules, SizeIs(2));
  for (const Rule& r : list.rules) {
    EXPECT_EQ(r.y0, axis);
    EXPECT_EQ(r.y1, axis);
  }
  const Glyph minus = set("-").glyphs.front();
  EXPECT_NEAR(middle_y(minus), axis, kRounding) << "as the sign of minus does";
}

TEST(MathLayout, FractionsAreSymmetric) {
  const std::string tex = "\\frac{1}{2+2}";
  const DisplayList list = set(tex);
  const Rule& bar = list.rules.front();
  const double middle = 0.5 * (bar.x0 + bar.x1);
  const Glyph& one = glyph_at(list, 6);
  const double advance = fonts().advance(one.face, one.id) * one.size;
  EXPECT_NEAR(one.x + 0.5 * advance, middle, kRounding);
  const Glyph& plus = glyph_at(list, 10);
  EXPECT_NEAR(0.5 * (left(plus) + right(plus)), middle, kRounding);
}

TEST(MathLayout, DelimitersAreAsHighAsEachOtherAndCoverTheirContents) {
  const DisplayList list = set("\\left(\\frac{a}{b}\\right)");
  const Glyph& open = list.glyphs.front();
  const Glyph& close = list.glyphs.back();
  EXPECT_EQ(top(open), top(close));
  EXPECT_EQ(bottom(open), bottom(close));
  EXPECT_NEAR(middle_y(open), -0.25 * kSize, kRounding);
  EXPECT_LT(right(open), left(list.glyphs[1]));
}

TEST(MathLayout, GlyphsAreInReadingOrder) {
  const std::string tex = "\\left(\\frac{a}{b}\\right)^2 \\sqrt[3]{x} \\binom{n}{k}";
  std::string read;
  for (const Glyph& g : set(tex).glyphs)
    read += tex[g.source.begin] == '\\' ? tex[g.source.begin + 1] : tex[g.source.begin];
  EXPECT_EQ(read, "(ab)23sxbnkb") << "s: the root, b: \\binom's parentheses";
}

TEST(MathLayout, AParenthesisMadeOfPartsIsReadAsOne) {
  const std::string tall = "{\\frac{\\frac{\\frac{a}{a}}{\\frac{a}{a}}}{\\frac{\\frac{a}{a}}{\\frac{a}{a}}}}";
  const std::string tex = "\\binom" + tall + tall;
  std::string read;
  for (const Glyph& g : set(tex).glyphs) read += g.source.begin == 0 ? '(' : tex[g.source.begin];
  const std::size_t parts = read.find('a');
  ASSERT_GT(parts, 1U) << "more than one glyph is needed";
  EXPECT_EQ(read, std::string(parts, '(') + std::string(16, 'a') + std::string(parts, '('));
}

TEST(MathLayout, RootsCoverWhatIsUnderThem) {
  const DisplayList list = set("\\sqrt{a+b}");
  ASSERT_THAT(list.rules, SizeIs(1));
  const Rule& bar = list.rules.front();
  EXPECT_LE(bar.x0, left(list.glyphs[1]));
  EXPECT_GE(bar.x1, right(list.glyphs.back()) - 0.02 * kSize);
  for (const Glyph& g : list.glyphs) EXPECT_GE(top(g), bar.y0 - 0.5 * bar.thickness - kRounding);
  EXPECT_NEAR(top(list.glyphs.front()), bar.y0 - 0.5 * bar.thickness, 0.01 * kSize)
      << "the sign meets its bar";
}

TEST(MathLayout, ScriptsAreSmallerAndStandWhereTheyBelong) {
  const DisplayList list = set("x_1^2");
  const Glyph& x = list.glyphs[0];
  const Glyph& sub = list.glyphs[1];
  const Glyph& sup = list.glyphs[2];
  EXPECT_NEAR(sub.size, 0.74 * kSize, kRounding) << "ScriptPercentScaleDown of the font";
  EXPECT_LT(sup.y, x.y);
  EXPECT_GT(sub.y, x.y);
  EXPECT_GE(top(sub) - bottom(sup), 0.16 * kSize - kRounding) << "SubSuperscriptGapMin";
  EXPECT_NEAR(set("x_{1_{2_3}}").glyphs.back().size, 0.55 * kSize, kRounding) << "there is no smaller style";
}

TEST(MathLayout, SuperscriptsKeepClearOfSlantedLetters) {
  const DisplayList list = set("f^2_2");
  EXPECT_GT(list.glyphs[2].x, list.glyphs[1].x) << "by the italic correction";
}

TEST(MathLayout, AccentsStandAboveTheirLetters) {
  for (const std::string letter : {"\\omega", "L", "v", "f", "\\mathbf n"}) {
    const DisplayList list = set("\\vec{" + letter + "}");
    ASSERT_THAT(list.glyphs, SizeIs(2));
    const Glyph& base = list.glyphs[0];
    const Glyph& arrow = list.glyphs[1];
    EXPECT_LT(bottom(arrow), top(base)) << letter;
    const double middle = 0.5 * (left(arrow) + right(arrow));
    EXPECT_GT(middle, left(base)) << letter;
    EXPECT_LT(middle, right(base) + 0.05 * kSize) << letter;
  }
  EXPECT_NE(set("\\hat i").glyphs.front().id, set("i").glyphs.front().id) << "without its dot";
  const DisplayList both = set("\\dot{\\vec\\omega}");
  EXPECT_LT(bottom(both.glyphs[2]), top(both.glyphs[1])) << "the dot above the arrow";
}

TEST(MathLayout, LimitsStandAboveAndBelowInDisplaysOnly) {
  const DisplayList big = set("\\sum_{i}^{n}");
  EXPECT_LT(bottom(big.glyphs[2]), top(big.glyphs[0]));
  EXPECT_GT(top(big.glyphs[1]), bottom(big.glyphs[0]));
  MathStyle in_line = display();
  in_line.display = false;
  const DisplayList small = set("\\sum_{i}^{n}", in_line);
  EXPECT_GT(left(small.glyphs[1]), right(small.glyphs[0]) - 0.05 * kSize);
  EXPECT_LT(bottom(small.glyphs[0]) - top(small.glyphs[0]), bottom(big.glyphs[0]) - top(big.glyphs[0]));
  EXPECT_GT(left(set("\\int_0^1").glyphs[2]), left(set("\\int_0^1").glyphs[1])) << "an integral leans";
}

TEST(MathLayout, AlignmentsStandOnTheirRelations) {
  const std::string tex = "\\begin{aligned} a &= b \\\\ long + c &= d \\end{aligned}";
  const DisplayList list = set(tex);
  std::vector<double> equals;
  for (const Glyph& g : list.glyphs)
    if (tex[g.source.begin] == '=') equals.push_back(g.x);
  ASSERT_THAT(equals, SizeIs(2));
  EXPECT_NEAR(equals[0], equals[1], kRounding);
  const double space = 5.0 / 18.0 * kSize;
  const Glyph& a = list.glyphs[0];
  EXPECT_NEAR(equals[0] - (a.x + fonts().advance(a.face, a.id) * kSize), space, 0.03 * kSize)
      << "with a relation's space";
}

TEST(MathLayout, MatricesAreCentredOnTheAxis) {
  const std::string tex = "\\begin{vmatrix} 1 & 2 \\\\ 3 & 4 \\end{vmatrix}";
  const DisplayList list = set(tex);
  ASSERT_THAT(list.rules, SizeIs(2)) << "tall bars are rules";
  for (const Rule& r : list.rules) EXPECT_NEAR(0.5 * (r.y0 + r.y1), -0.25 * kSize, kRounding);
  EXPECT_EQ(list.glyphs[0].y, list.glyphs[1].y);
  EXPECT_EQ(list.glyphs[0].x, list.glyphs[2].x);
  EXPECT_NEAR(list.glyphs[2].y - list.glyphs[0].y, 1.2 * kSize, kRounding);
}

TEST(MathLayout, SpacesAtomsByTheirClasses) {
  const auto gap = [](const char* tex) {
    const DisplayList list = set(tex);
    const Glyph& first = list.glyphs[0];
    return (list.glyphs[1].x - first.x) / kSize - fonts().advance(first.face, first.id);
  };
  // Digits have no italic correction.
  EXPECT_NEAR(gap("1+1"), 4.0 / 18.0, 1e-12);
  EXPECT_NEAR(gap("1=1"), 5.0 / 18.0, 1e-12);
  EXPECT_NEAR(gap("1,1"), 0.0, 1e-12);
  EXPECT_NEAR(gap("-1"), 0.0, 1e-12) << "a sign, not an operator";
  EXPECT_NEAR(gap("1{+}1"), 0.0, 1e-12) << "braces make it ordinary";
  EXPECT_NEAR(gap("1\\textcolor{blue}{+}1"), 4.0 / 18.0, 1e-12) << "colours do not";
  EXPECT_NEAR(gap("1\\term{t}{+ 1}"), 4.0 / 18.0, 1e-12) << "nor do terms";
  EXPECT_NEAR(gap("1\\quad1"), 1.0, 1e-12);
}

TEST(MathLayout, TermsColoursAndSymbolsAreNamed) {
  std::vector<MathSymbol> symbols = {{"omega", parsed("\\vec\\omega"), color_from_hex(0xB04A00)},
                                     {"w1", parsed("\\omega_1"), color_from_hex(0x006B62)},
                                     {"dL", parsed("dL"), color_from_hex(0x7D2E8C)}};
  MathStyle style = display();
  style.symbols = &symbols;
  const std::string tex =
      "\\term{gyro}{\\vec{\\omega}\\times L} + \\omega_1^2 + \\textcolor{blue}{\\vec\\omega} + dL";
  const DisplayList list = set(tex, style);
  const auto name = [&](std::int16_t i) {
    return i < 0 ? std::string() : list.names[static_cast<std::size_t>(i)];
  };
  std::map<std::string, int> symbol_glyphs, term_glyphs;
  for (const Glyph& g : list.glyphs) {
    ++symbol_glyphs[name(g.naming.symbol)];
    ++term_glyphs[name(g.naming.term)];
  }
  EXPECT_EQ(symbol_glyphs["omega"], 4) << "twice a letter and its arrow";
  EXPECT_EQ(symbol_glyphs["w1"], 2) << "its square is no part of it";
  EXPECT_EQ(symbol_glyphs["dL"], 2) << "two atoms";
  EXPECT_EQ(term_glyphs["gyro"], 4);
  EXPECT_EQ(list.glyphs[0].color, symbols[0].color);
  EXPECT_EQ(list.glyphs[1].color, symbols[0].color);
  for (const Glyph& g : list.glyphs)
    if (g.source.begin > tex.find("blue")) {
      EXPECT_EQ(g.color, color_from_hex(0x0B5CA8)) << "\\textcolor wins";
      break;
    }
}

TEST(MathLayout, LongDisplaysAreBrokenAtRelations) {
  const std::string tex = "T = aaaaaaaa + bbbbbbbb = cccccccc + dddddddd = eeeeeeee";
  MathStyle narrow = display();
  narrow.line_width = 380.0;
  const DisplayList whole = set(tex), broken = set(tex, narrow);
  EXPECT_LE(broken.width, narrow.line_width);
  EXPECT_GT(whole.width, narrow.line_width);
  ASSERT_EQ(broken.glyphs.size(), whole.glyphs.size());
  std::set<double> baselines;
  std::string first_of_line;
  for (const Glyph& g : broken.glyphs)
    if (baselines.insert(g.y).second) first_of_line += tex[g.source.begin];
  EXPECT_EQ(first_of_line, "T==");
  EXPECT_EQ(*baselines.begin(), 0.0);
  EXPECT_GT(broken.depth, *baselines.rbegin());
  EXPECT_GT(glyph_at(broken, tex.find('=', 5)).x, 0.0) << "indented";
}

TEST(MathLayout, AlignmentsAreNeverBroken) {
  MathStyle narrow = display();
  narrow.line_width = 100.0;
  const char* tex = "\\begin{aligned} a &= bbbbbbbbbbbbbbbbbbbb + c \\end{aligned}";
  EXPECT_EQ(set(tex, narrow), set(tex));
  EXPECT_GT(set(tex, narrow).width, 100.0);
}

TEST(MathLayout, TallDelimitersArePutTogether) {
  std::string rows;
  for (int i = 0; i < 12; ++i) rows += "x \\\\ ";
  for (const char* kind : {"pmatrix", "bmatrix", "Bmatrix"}) {
    const DisplayList list = set(std::string("\\begin{") + kind + "}" + rows + "\\end{" + kind + "}");
    double top_left = 0.0, bottom_left = 0.0, reach = 0.0;
    for (const Glyph& g : list.glyphs) {
      if (g.x > list.width / 3) continue;
      top_left = std::min(top_left, top(g));
      bottom_left = std::max(bottom_left, bottom(g));
      reach = std::max(reach, g.y);
    }
    EXPECT_GT(bottom_left - top_left, 0.9 * 12 * 1.2 * kSize) << kind;
    EXPECT_NEAR(0.5 * (bottom_left + top_left), -0.25 * kSize, 0.2 * kSize) << kind;
  }
}

TEST(MathLayout, NestedLabelsAreSetOnce) {
  for (const std::string piece :
       {"\\xrightarrow[a]{", "\\overset{a}{", "\\underbrace{", "\\hat{", "\\sqrt{", "\\left(", "\\frac{a}{",
        "\\mathbf{", "\\term{t}{", "x^{", "\\phantom{", "\\cancel{"}) {
    std::string tex;
    for (int i = 0; i < 60; ++i) tex += piece;
    tex += "x";
    for (int i = 0; i < 60; ++i) tex += piece == "\\left(" ? "\\right)" : "}";
    // Arrows have parts for each em of their labels; twice the labels for each level would never end.
    EXPECT_LE(set(tex).glyphs.size(), 60U * 60U * 4U) << piece;
  }
}

TEST(MathLayout, LabelledArrowsAreReadBeforeTheirLabels) {
  const std::string tex = "A\\xrightarrow[b]{c}D";
  std::string read;
  for (const Glyph& g : set(tex).glyphs)
    if (read.empty() || read.back() != tex[g.source.begin]) read += tex[g.source.begin];
  EXPECT_EQ(read, "A\\bcD");
}

TEST(MathLayout, SaysWhichCharacterTheFontsLack) {
  const auto list = set_math(parsed("x + 漢"), display(), fonts());
  ASSERT_FALSE(list.ok());
  ASSERT_THAT(list.error(), SizeIs(1));
  EXPECT_EQ(list.error().front().offset, 4U);
  EXPECT_EQ(list.error().front().message, "the fonts lack 漢 (U+6F22)");
  EXPECT_FALSE(set_math(parsed("\\text{a 漢}"), display(), fonts()).ok());
}

TEST(MathLayout, PhantomsTakeRoomAndShowNothing) {
  EXPECT_EQ(set("a\\phantom{b}").width, set("ab").width);
  EXPECT_THAT(set("\\phantom{\\frac{a}{b}}").glyphs, IsEmpty());
  EXPECT_THAT(set("\\phantom{\\frac{a}{b}}").rules, IsEmpty());
  EXPECT_EQ(set("\\hphantom{\\frac{a}{b}}").ascent, 0.0);
}

TEST(MathLayout, AnEmptyFormulaIsEmpty) {
  EXPECT_EQ(set("").glyphs.size(), 0U);
  EXPECT_EQ(set("").width, 0.0);
  EXPECT_THAT(set("\\frac{}{}").rules, SizeIs(1));
}

/// Colours of the glyphs of a formula in which ω₁ is a symbol, from left to right.
std::vector<Color> colors_in(const std::string& tex) {
  const std::vector<MathSymbol> symbols = {{"w1", parsed("\\omega_1"), color_from_hex(0x006B62)}};
  MathStyle style = display();
  style.symbols = &symbols;
  std::vector<Color> colors;
  const DisplayList list = set_math(parsed(tex), style, fonts()).value();
  for (const Glyph& glyph : list.glyphs) colors.push_back(glyph.color);
  return colors;
}

TEST(MathLayout, PowersAndRatesOfASymbolHaveItsColour) {
  const Color own = color_from_hex(0x006B62);
  for (const char* tex : {"\\omega_1^2", "\\dot\\omega_1", "\\ddot\\omega_1", "\\dot\\omega_1^2"})
    for (const Color& color : colors_in(tex)) EXPECT_EQ(color, own) << tex;
  for (const char* tex : {"\\dot\\omega_2", "\\hat\\omega_1", "x^2"})
    for (const Color& color : colors_in(tex)) EXPECT_NE(color, own) << tex;
}

}  // namespace
}  // namespace polhode
