// SPDX-License-Identifier: MIT
#include "render/typeset/math/mathml.h"

#include "render/typeset/math/tree.h"
#include "tests/render/typeset/math/formulas.h"
#include "tests/support/xml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

namespace polhode {
namespace {

using test::all_named;
using test::for_each_node;
using test::read_xml;
using test::XmlNode;
using ::testing::HasSubstr;
using ::testing::Not;

Math parsed(const std::string& tex) {
  auto math = parse_math(tex);
  EXPECT_TRUE(math) << tex << ": " << math.error().front().message;
  return math ? std::move(*math) : Math();
}

std::string written(const std::string& tex) { return mathml(parsed(tex), {}); }

/// What stands between the tags of `math` and its row.
std::string inside(const std::string& tex) {
  const std::string all = written(tex), open = "<math><mrow>", close = "</mrow></math>";
  EXPECT_TRUE(all.starts_with(open) && all.ends_with(close)) << all;
  return all.substr(open.size(), all.size() - open.size() - close.size());
}

/// How many elements each takes; -1: any number.
const std::map<std::string, int>& takes() {
  static const std::map<std::string, int> kTakes = {
      {"math", -1},     {"mrow", -1},      {"mstyle", -1},  {"mi", 0},        {"mn", 0},
      {"mo", 0},        {"mtext", -1},     {"mspace", 0},   {"mfrac", 2},     {"msqrt", -1},
      {"mroot", 2},     {"msub", 2},       {"msup", 2},     {"msubsup", 3},   {"munder", 2},
      {"mover", 2},     {"munderover", 3}, {"mtable", -1},  {"mtr", -1},      {"mtd", -1},
      {"mphantom", -1}, {"a", 0},          {"mpadded", -1}, {"semantics", 2}, {"annotation", 0}};
  return kTakes;
}

void expect_core(const XmlNode& root, const std::string& tex) {
  for_each_node(root, [&](const XmlNode& node) {
    if (node.name.empty()) return;
    const auto known = takes().find(node.name);
    ASSERT_NE(known, takes().end()) << node.name << " is not of MathML Core: " << tex;
    const auto elements = std::count_if(node.children.begin(), node.children.end(),
                                        [](const XmlNode& child) { return !child.name.empty(); });
    if (known->second >= 0) {
      EXPECT_EQ(elements, known->second) << node.name << " in " << tex;
    }
    for (const XmlNode& child : node.children) {
      EXPECT_EQ(child.name == "mtr", node.name == "mtable") << tex;
      EXPECT_EQ(child.name == "mtd", node.name == "mtr") << tex;
    }
    EXPECT_EQ(node.attributes.count("style"), 0u) << "a strict policy would drop it: " << tex;
  });
}

TEST(MathMl, EveryFormulaIsWellFormedAndOfMathMlCore) {
  for (const auto& [name, tex] : testing::all_formulas()) {
    const std::string html = mathml(parsed(tex), {.display = true, .words = "words", .tex = tex});
    XmlNode root;
    ASSERT_NO_THROW(root = read_xml(html)) << name << ": " << html;
    expect_core(root, name);
    EXPECT_EQ(all_named(root, "annotation").front()->children.front().text, tex) << name;
  }
}

/// The signs that a formula shows, without what only tells their place.
std::multiset<std::string> signs_of(const MathNode& node) {
  std::multiset<std::string> signs;
  if (node.kind == MathNode::Kind::text) signs.insert(node.text);
  for (const MathNode& child : node.children) signs.merge(signs_of(child));
  return signs;
}

TEST(MathMl, NoWordOfAFormulaIsLost) {
  for (const auto& [name, tex] : testing::all_formulas()) {
    const Math math = parsed(tex);
    const XmlNode root = read_xml(mathml(math, {}));
    std::string shown;
    for_each_node(root, [&](const XmlNode& node) { shown += node.text + '\n'; });
    for (std::string word : signs_of(*math.root)) {
      if (word.starts_with(' ')) word.erase(0, 1);
      if (word.ends_with(' ')) word.pop_back();
      EXPECT_THAT(shown, HasSubstr(word)) << name;
    }
  }
}

struct Case {
  const char *tex, *html;
};

TEST(MathMl, WritesEachConstruct) {
  const Case cases[] = {
      {"x", "<mi>x</mi>"},
      {"\\Omega", "<mi mathvariant=\"normal\">Ω</mi>"},
      {"\\mathbf I", "<mi>𝐈</mi>"},
      {"\\mathcal L", "<mi>ℒ</mi>"},
      {"12.5", "<mn>12.5</mn>"},
      {"\\infty", "<mi>∞</mi>"},
      {"x'",
       "<mrow><mi>x</mi><mo form=\"postfix\" lspace=\"0\" rspace=\"0\" stretchy=\"false\">′</mo></mrow>"},
      {"x_a'",
       "<mrow><msub><mi>x</mi><mrow><mi>a</mi></mrow></msub>"
       "<mo form=\"postfix\" lspace=\"0\" rspace=\"0\" stretchy=\"false\">′</mo></mrow>"},
      {"\\sqrt{x}", "<msqrt><mrow><mi>x</mi></mrow></msqrt>"},
      {"\\sqrt[3]{x}", "<mroot><mrow><mi>x</mi></mrow><mrow><mn>3</mn></mrow></mroot>"},
      {"\\frac{a}{b}", "<mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac>"},
      {"x_1^2", "<msubsup><mi>x</mi><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></msubsup>"},
      {"\\hat e", "<mover accent=\"true\"><mrow><mi>e</mi></mrow><mo stretchy=\"false\">ˆ</mo></mover>"},
      {"\\vec L",
       "<mover accent=\"true\"><mrow><mi>L</mi></mrow><mo stretchy=\"false\" class=\"vec\">→</mo></mover>"},
      {"\\overline{ab}",
       "<mover accent=\"true\"><mrow><mrow><mi>a</mi><mi>b</mi></mrow></mrow><mo "
       "stretchy=\"true\">‾</mo></mover>"},
      {"\\text{if }", "<mtext>if\u00A0</mtext>"},
      {"\\quad", "<mspace width=\"1em\"/>"},
      {"\\textcolor{#336699}{x}", "<mrow mathcolor=\"#336699\"><mi>x</mi></mrow>"},
      {"\\cancel{x}", "<mrow class=\"cancel-up\"><mi>x</mi></mrow>"},
      {"\\boxed{x}", "<mrow class=\"box\"><mrow><mi>x</mi></mrow></mrow>"},
      {"\\phantom{x}", "<mphantom><mrow><mi>x</mi></mrow></mphantom>"},
      {"\\hphantom{x}",
       "<mpadded height=\"0\" depth=\"0\"><mphantom><mrow><mi>x</mi></mrow></mphantom></mpadded>"},
      {"\\vphantom{x}", "<mpadded width=\"0\"><mphantom><mrow><mi>x</mi></mrow></mphantom></mpadded>"},
  };
  for (const auto& [tex, html] : cases) EXPECT_EQ(inside(tex), html) << tex;
}

TEST(MathMl, StacksAndTablesSayWhatTheyAre) {
  EXPECT_THAT(inside("\\sum_{i=1}^n x_i"),
              HasSubstr("<munderover><mo largeop=\"true\" movablelimits=\"true\">∑</mo>"));
  EXPECT_THAT(inside("\\int_0^1 x"), HasSubstr("<msubsup><mo largeop=\"true\""));
  EXPECT_THAT(inside("\\lim_{x\\to 0} x"), HasSubstr("<munder><mo form=\"prefix\""));
  EXPECT_THAT(inside("\\overset{!}{=}"), HasSubstr("<mover><mo form=\"infix\""));
  EXPECT_THAT(inside("\\underbrace{x}_{y}"), HasSubstr("<munder><mrow><munder accentunder=\"true\">"));
  EXPECT_THAT(inside("\\xrightarrow{a}"), HasSubstr("<mover><mo stretchy=\"true\""));
  EXPECT_THAT(inside("\\binom{n}{k}"), HasSubstr("<mfrac linethickness=\"0\">"));
  EXPECT_THAT(inside("\\left(\\frac12\\right)"),
              HasSubstr("<mo form=\"prefix\" fence=\"true\" stretchy=\"true\" symmetric=\"true\">(</mo>"));
  EXPECT_THAT(inside("\\bigl( x \\bigr)"), HasSubstr("symmetric=\"true\" minsize=\""));
  const std::string aligned = inside("\\begin{aligned} a &= b \\\\ &= c \\end{aligned}");
  EXPECT_THAT(aligned,
              HasSubstr("<mtable class=\"aligned\" displaystyle=\"true\"><mtr><mtd class=\"right\">"));
  EXPECT_THAT(aligned, HasSubstr("</mtd><mtd class=\"left\">"));
  EXPECT_THAT(inside("\\begin{cases} a & b \\\\ c & d \\end{cases}"),
              HasSubstr("symmetric=\"true\">{</mo><mtable class=\"cases\">"));
  EXPECT_THAT(
      inside("\\begin{array}{l|r} a & b \\\\ \\hline c & d \\end{array}"),
      ::testing::AllOf(HasSubstr("<mtd class=\"left\">"), HasSubstr("class=\"right line-above line-left\"")));
}

TEST(MathMl, ASignInFrontIsNoDifference) {
  EXPECT_THAT(inside("-a"), HasSubstr("<mo form=\"prefix\" lspace=\"0\" rspace=\"0\">−</mo>"));
  EXPECT_THAT(inside("a = -b"), HasSubstr("<mo form=\"prefix\" lspace=\"0\" rspace=\"0\">−</mo>"));
  EXPECT_THAT(inside("a - b"), HasSubstr("<mo form=\"infix\">−</mo>"));
  EXPECT_THAT(inside("\\term{t}{a} - b"), HasSubstr("<mo form=\"infix\">−</mo>"));
  EXPECT_THAT(inside("a\\term{t}{- b}"), HasSubstr("<mo form=\"infix\">−</mo>"));
  EXPECT_THAT(inside("10{,}000"), HasSubstr("<mo lspace=\"0\" rspace=\"0\" stretchy=\"false\">,</mo>"));
}

TEST(MathMl, SymbolsHaveTheirClass) {
  const std::vector<MathSymbol> symbols = {{"omega", parsed("\\vec\\omega"), {}},
                                           {"w1", parsed("\\omega_1"), {}}};
  const MathMlStyle style{.symbols = &symbols,
                          .class_of = [](std::string_view name) { return "r-" + std::string(name); }};
  EXPECT_THAT(mathml(parsed("2\\vec\\omega"), style), HasSubstr("<mn>2</mn><mrow class=\"r-omega\"><mover"));
  EXPECT_THAT(mathml(parsed("\\omega_1^2"), style), HasSubstr("<mrow class=\"r-w1\"><msubsup>"));
  EXPECT_THAT(mathml(parsed("\\dot\\omega_1"), style), HasSubstr("<mrow class=\"r-w1\"><msub>"));
  EXPECT_THAT(mathml(parsed("\\omega_2"), style), Not(HasSubstr("class")));
}

TEST(MathMl, SaysItsWordsAndKeepsItsTex) {
  EXPECT_EQ(
      mathml(parsed("x"), {.display = true, .words = "a \"b\" <c>", .tex = "x < y & z"}),
      "<math display=\"block\" aria-label=\"a &quot;b&quot; &lt;c&gt;\" alttext=\"a &quot;b&quot; "
      "&lt;c&gt;\"><semantics><mrow><mi>x</mi></mrow><annotation encoding=\"application/x-tex\">x &lt; y "
      "&amp; z</annotation></semantics></math>");
}

/// The rows that a line may be broken into, each as the text of its signs.
std::vector<std::string> pieces(const std::string& tex) {
  const XmlNode root = read_xml(mathml(parsed(tex), {.tex = tex, .in_pieces = true}));
  std::vector<std::string> all;
  for (const XmlNode& row : all_named(root, "math").front()->children) {
    std::string text;
    for_each_node(row, [&](const XmlNode& node) { text += node.text; });
    all.push_back(text);
  }
  return all;
}

TEST(MathMl, ALongLineMayBeBrokenBeforeRelationsAndSums) {
  using ::testing::ElementsAre;
  EXPECT_THAT(pieces("a = b + c - d"), ElementsAre("a", "=b", "+c", "−d"));
  EXPECT_THAT(pieces("-a\\cdot b = -b"), ElementsAre("−a⋅b", "=−b"));
  EXPECT_THAT(pieces("|a + b| = (c + d)^2 + \\left(e + f\\right)"),
              ElementsAre("|a+b|", "=(c+d)2", "+(e+f)"));
  EXPECT_THAT(pieces("\\term{one}{a = \\frac{b + c}{d}} \\ne e"), ElementsAre("a", "=b+cd", "≠e"));
  EXPECT_THAT(pieces("\\displaystyle a = b"), ElementsAre("a", "=b"));
  EXPECT_THAT(pieces("a = b \\qquad (c = 0)"), ElementsAre("a", "=b", "(c=0)"));
}

TEST(MathMl, BrokenOrNotItIsTheSame) {
  const std::string tex = "a = \\frac{b + c}{d}", whole = written(tex);
  std::string broken = mathml(parsed(tex), {.tex = tex, .in_pieces = true});
  EXPECT_THAT(broken, HasSubstr("<math class=\"pieces\" data-tex=\"" + tex + "\"><mrow>"));
  EXPECT_THAT(broken, Not(HasSubstr("annotation")));
  broken.erase(broken.find("</mrow><mrow>"), std::string("</mrow><mrow>").size());
  EXPECT_EQ(broken.substr(broken.find('>')), whole.substr(whole.find('>')));
  EXPECT_THAT(mathml(parsed("\\displaystyle a = b"), {.in_pieces = true}),
              HasSubstr(" displaystyle=\"true\"><mrow>"));
  EXPECT_EQ(mathml(parsed("a\\,b"), {.tex = "x", .in_pieces = true}), mathml(parsed("a\\,b"), {.tex = "x"}))
      << "no place to break";
}

TEST(MathMl, AReferenceIsALinkThatANameDoesNotHide) {
  const Math math = with_references(parsed("x\\ \\eqref{law}"), {{"law", {"#a/law", "5"}}});
  const auto address = [](std::string_view link) { return std::string(link); };
  const std::string html = mathml(math, {.address_of = address, .words = "x 5"});
  EXPECT_THAT(html, HasSubstr("<mtext><a href=\"#a/law\">(5)</a></mtext>"));
  EXPECT_THAT(html, ::testing::AllOf(HasSubstr("alttext=\"x 5\""), Not(HasSubstr("aria-label"))));
  EXPECT_THAT(mathml(math, {.words = "x 5"}), Not(HasSubstr("<a ")));
}

TEST(MathMl, WhatIsTypedNeverBecomesMarkup) {
  const XmlNode root = read_xml(written("\\text{</math><script>alert(1)</script>} < \\text{\"&amp;}"));
  EXPECT_TRUE(all_named(root, "script").empty());
  EXPECT_EQ(all_named(root, "mtext").front()->children.front().text, "</math><script>alert(1)</script>");
}

}  // namespace
}  // namespace polhode
