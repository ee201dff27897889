// SPDX-License-Identifier: MIT
#include "render/typeset/math/commands.h"
#include "render/typeset/math/math.h"
#include "render/typeset/math/tree.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <set>
#include <sstream>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Kind = MathNode::Kind;

/// "offset: message (hint)"
std::vector<std::string> complaints(std::string_view tex, const MathMacros& macros = {}) {
  std::vector<std::string> lines;
  const auto math = parse_math(tex, macros);
  if (math.ok()) return lines;
  for (const TypeError& e : math.error())
    lines.push_back(std::to_string(e.offset) + ": " + e.message +
                    (e.hint.empty() ? "" : " (" + e.hint + ")"));
  return lines;
}

MathNode tree(std::string_view tex, const MathMacros& macros = {}) {
  const auto math = parse_math(tex, macros);
  EXPECT_TRUE(math.ok()) << tex << ": " << math.error().front().message;
  return math.ok() ? without_groups(*math->root) : MathNode{};
}

TEST(ParseMath, TakesWhatCloses) {
  for (const char* tex : {"{a}{b{c}}",
                          "\\{ a \\}",
                          "\\left\\{ a \\right.",
                          "\\left( \\left[ a \\right] \\right)",
                          "\\begin{aligned} {a} \\\\ b \\end{aligned}",
                          "% {\na",
                          "\\\\{a}",
                          "\\frac12",
                          "",
                          " ",
                          "{}^3H",
                          "\\sqrt[3]{x}",
                          "\\left(\\frac ab\\middle|c\\right)",
                          "x_\\text{max}",
                          "\\text{for $x>0$ only}",
                          "\\begin{array}{l|cr} a & b & c \\\\ \\hline d & e & f \\\\ \\hline \\end{array}",
                          "a \\over b",
                          "{n \\choose k}",
                          "\\sum\\limits_{\\substack{i<j\\\\j<k}} a",
                          "\\not\\in",
                          "\\xrightarrow[b]{a}",
                          "\\operatorname{arg\\,max}_x f",
                          "\\bigl( a \\bigr)",
                          "\\color{red} a",
                          "\\hspace{-0.5em}a",
                          "x''_1",
                          "x'^2",
                          "\\mathbf I",
                          "a\\ b~c",
                          "\\begin{aligned}[t] a \\end{aligned}",
                          "a &= b \\\\[4pt] c &= d",
                          "ω × L⃗",
                          "\\text{a {\\textbf{b} c} \\% \\& d}",
                          "\\hat\\imath",
                          "\\boxed{E = mc^2}"}) {
    EXPECT_THAT(complaints(tex), IsEmpty()) << tex;
  }
}

TEST(ParseMath, SaysWhereWhatIsNotClosedOpens) {
  EXPECT_THAT(complaints("a {b"), ElementsAre("2: { is never closed"));
  EXPECT_THAT(complaints("ω }"), ElementsAre("3: } closes nothing"));
  EXPECT_THAT(complaints("a\n\\left( b"), ElementsAre("2: \\left is never closed"));
  EXPECT_THAT(complaints("\\right)"), ElementsAre("0: \\right closes nothing"));
  EXPECT_THAT(complaints("\\end{cases}"), ElementsAre("0: \\end{cases} closes nothing"));
  EXPECT_THAT(complaints("\\frac{a}{b"), ElementsAre("8: { is never closed"));
  EXPECT_THAT(complaints("\\sqrt[3{x}"), ElementsAre("5: [ is never closed"));
}

TEST(ParseMath, NamesBothEndsOfWhatCrosses) {
  EXPECT_THAT(complaints("{\\left( }"), ElementsAre("0: { is never closed", "1: \\left is never closed",
                                                    "8: } closes nothing (\"\\left( }\" waits for \\right)"));
  EXPECT_THAT(
      complaints("\\begin{aligned} a \\end{matrix}"),
      ElementsAre("0: \\begin{aligned} is never closed",
                  "18: \\end{matrix} closes nothing (\"\\begin{aligned} …\" waits for \\end{aligned})"));
}

TEST(ParseMath, NamesTheNearestCommand) {
  EXPECT_THAT(complaints("\\ometa"), ElementsAre("0: unknown command \\ometa (did you mean \\omega?)"));
  EXPECT_THAT(complaints("x + \\farc{a}{b}"),
              ElementsAre("4: unknown command \\farc (did you mean \\frac?)"));
  EXPECT_THAT(complaints("\\Omgea_1"), ElementsAre("0: unknown command \\Omgea (did you mean \\Omega?)"));
  EXPECT_THAT(complaints("\\qqqqqqqq"), ElementsAre("0: unknown command \\qqqqqqqq"));
  EXPECT_THAT(complaints("\\ang", {{"angul", {0, "x"}}}), SizeIs(1));
  EXPECT_THAT(complaints("\\begin{pmatix} a \\end{pmatix}"),
              ElementsAre("0: unknown environment pmatix (did you mean pmatrix?)"));
  EXPECT_THAT(complaints("\\textcolor{bleu}{x}"), ElementsAre("0: unknown color bleu (did you mean blue?)"));
}

/// Each line: TeX, offset of the first error, its message, its hint.
TEST(ParseMath, RefusesWrongFormulasWhereTheyAreWrong) {
  std::ifstream in(test::source_dir() / "tests/data/formulas/wrong.tsv");
  int count = 0;
  for (std::string line; std::getline(in, line); ++count) {
    std::array<std::string, 4> fields;
    std::istringstream cells(line);
    for (std::string& field : fields) std::getline(cells, field, '\t');
    const auto math = parse_math(fields[0]);
    ASSERT_FALSE(math.ok()) << line;
    const auto& errors = math.error();
    const auto found = std::find_if(errors.begin(), errors.end(),
                                    [&](const TypeError& e) { return e.message == fields[2]; });
    ASSERT_NE(found, errors.end()) << line << ": " << errors.front().message;
    EXPECT_EQ(std::to_string(found->offset), fields[1]) << line;
    EXPECT_EQ(found->hint, fields[3]) << line;
  }
  EXPECT_GE(count, 30);
}

/// Two letters of each command's name change places.
TEST(ParseMath, KnowsCommandsThatAreMisspelt) {
  int misspelt = 0, meant = 0;
  for (const std::string_view name : math_command_names()) {
    if (name.size() < 5) continue;
    std::string wrong(name);
    std::swap(wrong[2], wrong[3]);
    if (math_command(wrong) != nullptr) continue;
    const auto math = parse_math("x + \\" + wrong + " y");
    ASSERT_FALSE(math.ok()) << wrong;
    EXPECT_EQ(math.error().front().offset, 4U);
    EXPECT_FALSE(math.error().front().hint.empty()) << wrong;
    ++misspelt;
    meant += math.error().front().hint == "did you mean \\" + std::string(name) + "?" ? 1 : 0;
  }
  EXPECT_GE(misspelt, 200);
  // Others, as \mathrm and \mathsf, are as near to each other as to what was written.
  EXPECT_GE(meant, misspelt * 95 / 100);
}

TEST(ParseMath, SaysWhatACommandLacks) {
  EXPECT_THAT(complaints("\\frac{a}"), ElementsAre("0: \\frac needs its argument in braces (\\frac{…}{…})"));
  EXPECT_THAT(complaints("a^"), ElementsAre("1: ^ needs its argument in braces (x^{…})"));
  EXPECT_THAT(complaints("\\left a\\right)"), SizeIs(1));
  EXPECT_THAT(complaints("x^a^b"),
              ElementsAre("3: double superscript (braces tell which: {x^a}^b or x^{a^b})"));
  EXPECT_THAT(complaints("x_1_2"), SizeIs(1));
  EXPECT_THAT(complaints("a\\limits_b"), SizeIs(1));
  EXPECT_THAT(complaints("\\tag 5"), ElementsAre("0: \\tag needs text in braces (\\tag{…})"));
  EXPECT_THAT(complaints("\\tag{a{b}} c"), SizeIs(1)) << "what is wrong once is told once";
  EXPECT_THAT(
      complaints("\\term{a b}{c}"),
      ElementsAre("6: bad term id \"a b\" (an id has 1 to 64 of the characters a-z, A-Z, 0-9 and -)"));
  EXPECT_THAT(complaints("\\term{a}c"), ElementsAre("8: \\term needs its formula in braces (\\term{a}{…})"));
  EXPECT_THAT(complaints("{a & b}"), SizeIs(1));
  EXPECT_THAT(complaints("a $ b"), SizeIs(1));
  EXPECT_THAT(complaints("#1"), SizeIs(1));
  EXPECT_THAT(complaints("\\"), SizeIs(1));
}

TEST(ParseMath, RefusesWhatCannotBeRead) {
  EXPECT_THAT(complaints("a\xff\xfe"), ElementsAre("1: malformed UTF-8"));
  EXPECT_THAT(complaints("a\xe2\x82 b"), ElementsAre("1: malformed UTF-8"));
  EXPECT_THAT(complaints("x = אבג"), ElementsAre("4: characters from right to left cannot be set: U+05D0"));
  EXPECT_THAT(complaints(std::string("a\0b", 3)), ElementsAre("1: invisible character: U+0000"));
  EXPECT_THAT(complaints(std::string(kMaxMathBytes + 1, 'a')),
              ElementsAre("8192: formula is longer than 8192 bytes"));
  EXPECT_THAT(complaints(std::string(1 << 20, '{')), SizeIs(1));
}

TEST(ParseMath, TakesBracesOfTheLimitAndNoDeeper) {
  const std::string open(kMaxMathNesting, '{'), close(kMaxMathNesting, '}');
  EXPECT_THAT(complaints(open + close), IsEmpty());
  EXPECT_THAT(complaints(open + "{}" + close), ElementsAre("64: braces are nested deeper than 64"));
  for (const char* piece : {"{", "\\left(", "\\vec", "\\frac", "\\sqrt[", "a\\over ", "\\begin{matrix}", "x^",
                            "\\text{", "\\color{red}", "\\text{$", "\\substack{", "\\mathbf"}) {
    std::string tex;
    while (tex.size() + std::string_view(piece).size() <= kMaxMathBytes) tex += piece;
    EXPECT_THAT(complaints(tex), SizeIs(::testing::Ge(1U))) << piece;
  }
}

TEST(ParseMath, TellsAtMostSixteenErrors) {
  std::string tex;
  for (int i = 0; i < 100; ++i) tex += "\\nonsense } ";
  EXPECT_THAT(complaints(tex), SizeIs(16));
}

TEST(ParseMath, FindsTagsAndTermsWithTheirPlaces) {
  const auto math = parse_math("x \\tag{5}\n\\term{turn}{\\vec a \\term{inner}{b}} \\tag{6'}");
  ASSERT_TRUE(math.ok());
  EXPECT_EQ(math->tag, "5, 6'");
  EXPECT_THAT(math->tag_offsets, ElementsAre(7, 51));
  EXPECT_THAT(math->terms, ElementsAre("turn", "inner"));
  EXPECT_THAT(math->term_offsets, ElementsAre(16, 35));
}

TEST(ParseMath, GivesEachAtomItsPlace) {
  const MathNode fraction = tree("\\frac{d\\vec L}{dt}");
  ASSERT_EQ(fraction.kind, Kind::fraction);
  EXPECT_EQ(fraction.span, (SourceSpan{0, 18}));
  const MathNode& arrow = fraction.children[0].children[1];
  ASSERT_EQ(arrow.kind, Kind::accent);
  EXPECT_EQ(arrow.span, (SourceSpan{7, 13}));
  EXPECT_EQ(without_groups(arrow.children[0]).span, (SourceSpan{12, 13}));
}

TEST(ParseMath, GroupsOfOneAtomAreThatAtom) {
  const auto same = [](const char* a, const char* b) { return same_math(tree(a), tree(b)); };
  EXPECT_TRUE(same("\\vec\\omega", "\\vec{\\omega}"));
  EXPECT_TRUE(same("\\mathbf I", "\\mathbf{I}"));
  EXPECT_TRUE(same("x_1", "x_{1}"));
  EXPECT_FALSE(same("\\mathbf I", "I"));
  EXPECT_FALSE(same("\\vec L", "\\hat L"));
  EXPECT_FALSE(same("x_1", "x^1"));
}

TEST(MathMacros, StandForTheirBodies) {
  const MathMacros macros = {{"dd", {2, "\\frac{d#1}{d#2}"}}, {"w", {0, "\\vec\\omega"}}};
  EXPECT_TRUE(same_math(tree("\\dd{\\w}t", macros), tree("\\frac{d\\vec\\omega}{dt}")));
  EXPECT_EQ(tree("a \\w", macros).children[1].span, (SourceSpan{2, 4})) << "the call is the place";
  EXPECT_TRUE(same_math(tree("\\w{}", {{"w", {1, "a#1"}}}), tree("a")));
}

TEST(MathMacros, MayBeLongerThanTheFormula) {
  const std::string body(3000, 'x');
  const MathNode made = tree("\\long & \\long", {{"long", {0, body}}});
  EXPECT_EQ(made.kind, Kind::grid);
  EXPECT_EQ(made.span, (SourceSpan{0, 13}));
}

TEST(MathMacros, AreBounded) {
  EXPECT_THAT(complaints("a\\f", {{"f", {0, "x\\g"}}, {"g", {0, "\\f"}}}),
              ElementsAre("1: macro \\f calls itself"));
  MathMacros bomb;
  for (char c = 'a'; c < 'z'; ++c)
    bomb[std::string(1, c)] = {0, std::string("\\") + char(c + 1) + "\\" + char(c + 1) + "\\" + char(c + 1)};
  bomb["z"] = {0, "x"};
  EXPECT_THAT(complaints("\\a", bomb), SizeIs(1));
  EXPECT_THAT(complaints("\\f", {{"f", {1, "#1"}}}), ElementsAre("0: \\f needs 1 argument"));
  EXPECT_THAT(complaints("x\\f", {{"f", {0, "\\ometa"}}}),
              ElementsAre("1: in \\f: unknown command \\ometa (did you mean \\omega?)"));
  EXPECT_THAT(complaints("\\f{\\f{a}}", {{"f", {1, "(#1)"}}}), IsEmpty()) << "in its argument it may stand";
}

TEST(MathMacros, SayWhereTheirMistakesAre) {
  const MathMacros macros = {{"f", {1, "x + \\ometa #1"}}, {"g", {0, "\\f{y}"}}};
  for (const char* tex : {"\\f{y}", "a \\g"}) {
    const auto math = parse_math(tex, macros);
    ASSERT_FALSE(math.ok()) << tex;
    ASSERT_THAT(math.error(), SizeIs(1)) << tex;
    EXPECT_EQ(math.error()[0].macro, "f");
    EXPECT_EQ(math.error()[0].macro_offset, 4U);
  }
  const auto of_argument = parse_math("\\f{\\nope}", {{"f", {1, "(#1)"}}});
  ASSERT_FALSE(of_argument.ok());
  EXPECT_EQ(of_argument.error()[0].macro, "") << "what it is given is no mistake of the macro";
  EXPECT_EQ(parse_math("\\f", {{"f", {0, "\\f"}}}).error()[0].macro, "f");
}

TEST(MathReferences, ShowTheNumberOfWhatTheyNameOnceItIsKnown) {
  const auto math = parse_math("a \\eqref{one} \\frac{\\eqref{two/b}}{\\eqref{one}}");
  ASSERT_TRUE(math.ok());
  ASSERT_THAT(math->references, SizeIs(3));
  EXPECT_EQ(math->references[0].id, "one");
  EXPECT_EQ(math->references[0].offset, 9U);
  EXPECT_EQ(math->references[1].id, "two/b");
  const auto say = [](std::string_view) { return std::string(); };
  EXPECT_EQ(spoken(*math, {}, say), "a (?) (?) over (?)");
  const Math shown = with_references(*math, {{"one", {"#s/one", "7"}}});
  EXPECT_EQ(spoken(shown, {}, say), "a (7) (?) over (7)");
  EXPECT_EQ(spoken(*math, {}, say), "a (?) (?) over (?)") << "the formula itself stays as it was";
  const auto fonts = Fonts::open();
  ASSERT_TRUE(fonts.ok());
  const auto list = set_math(shown, MathStyle{}, *fonts);
  ASSERT_TRUE(list.ok());
  EXPECT_THAT(list->names, testing::Contains("#s/one"));
  EXPECT_THAT(complaints("\\eqref"), SizeIs(1));
}

TEST(ParseMath, ReadsComputedNumbers) {
  const auto math = parse_math(
      "a = \\live[ unit = {rad/s}, digits=4 ]{w1 + w2} + \\value[unit=m]{-2.5\\,0\\cdot10^{-3}}{h}");
  ASSERT_TRUE(math.ok());
  ASSERT_THAT(math->live, SizeIs(2));
  const LiveNumber &live = math->live[0], &typed = math->live[1];
  EXPECT_EQ(live.expression, "w1 + w2");
  EXPECT_EQ(live.digits, 4);
  EXPECT_EQ(live.unit, "rad/s");
  EXPECT_EQ(live.unit_offset, 19U);
  EXPECT_EQ(live.typed, "");
  EXPECT_EQ(live.whole, (SourceSpan{4, 46}));
  EXPECT_EQ(typed.typed, "-2.50e-3");
  EXPECT_EQ(typed.unit, "m");
  EXPECT_EQ(typed.expression, "h");
  const auto say = [](std::string_view) { return std::string(); };
  EXPECT_EQ(spoken(*math, {}, say),
            "a equals its value now rad/s plus minus 2.50 times 10 to the power minus 3 m");
  const Math shown = with_numbers(*math, {{parse_math("7").value(), "x"}, {}});
  EXPECT_EQ(spoken(shown, {}, say), "a equals 7 rad/s plus minus 2.50 times 10 to the power minus 3 m");
  EXPECT_EQ(unit_tex("kg m^2/s"), "\\,\\text{kg m²/s}");
  EXPECT_EQ(unit_tex("deg"), "\\text{°}");
  EXPECT_EQ(unit_tex("1"), "");
}

TEST(ParseMath, TellsWhatIsWrongWithOptions) {
  for (const char* wrong :
       {"\\live[", "\\live[digits=3", "\\live[digits=3{T}", "\\live[,]{T}", "\\live[\\x]{T}",
        "\\live[digits=999999999999]{T}", "\\value[unit=m]", "\\value{1}", "\\value"})
    EXPECT_FALSE(complaints(wrong).empty()) << wrong;
}

TEST(MathCommands, HaveEachNameOnce) {
  std::set<std::string_view> names;
  for (const std::string_view name : math_command_names()) EXPECT_TRUE(names.insert(name).second) << name;
}

TEST(MathCommands, AreInTheFont) {
  const auto fonts = Fonts::open();
  ASSERT_TRUE(fonts.ok()) << fonts.error();
  for (const std::string_view name : math_command_names()) {
    const MathCommand& c = *math_command(name);
    const bool is_sign =
        c.action == MathCommand::Action::symbol || c.action == MathCommand::Action::large_operator;
    EXPECT_TRUE(!is_sign || fonts->glyph(Face::math, c.character)) << name;
  }
}

}  // namespace
}  // namespace polhode
