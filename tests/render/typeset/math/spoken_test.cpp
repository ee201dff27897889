// SPDX-License-Identifier: MIT
// What is said of formulas: whoever hears it writes the same formula down.
#include "base/words/formula_words.h"
#include "render/typeset/math/commands.h"
#include "render/typeset/math/math.h"
#include "tests/render/typeset/math/formulas.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

Math parsed(std::string_view tex, Language language = Language::en) {
  auto math = parse_math(tex, {}, language);
  EXPECT_TRUE(math.ok()) << tex << ": " << math.error().front().message;
  return math.ok() ? *math : Math{};
}

std::string said(std::string_view tex, Language language = Language::en) {
  const std::vector<MathSymbol> symbols = {
      {"omega", parsed("\\vec\\omega"), {}}, {"L", parsed("\\vec L"), {}}, {"mgl", parsed("m g \\ell"), {}}};
  return spoken(parsed(tex, language), symbols, [](std::string_view name) {
    return std::string(name == "L"     ? "angular momentum"
                       : name == "mgl" ? "weight times arm"
                                       : "omega vector");
  });
}

std::string said_in_german(std::string_view tex) { return said(tex, Language::de); }

TEST(SpokenMath, IsWhatAReaderWouldSay) {
  EXPECT_EQ(said("I_1\\dot\\omega_1"), "I sub 1 omega dot sub 1");
  EXPECT_EQ(said("\\dot{\\vec\\omega}"), "the time derivative of omega vector");
  EXPECT_EQ(said("x^2 + y^3 = 12.5"), "x squared plus y cubed equals 12.5");
  EXPECT_EQ(said("\\vec F"), "vector F");
  EXPECT_EQ(said("x = 90^\\circ"), "x equals 90 degrees");
  EXPECT_EQ(said("a \\xrightarrow[b]{c} d"), "a goes to by c with below b d");
  EXPECT_EQ(said("a \\xrightarrow{c} d"), "a goes to by c d");
  EXPECT_EQ(said("\\mathbf I^{-1}"), "I inverse");
  EXPECT_EQ(said("\\sum_{i=1}^n a_i"), "the sum from i equals 1 to n of a sub i");
  EXPECT_EQ(said("\\sum m_i a_i"), "the sum of m sub i a sub i") << "over what is not printed";
  EXPECT_EQ(said("\\begin{pmatrix} 1 & 2 \\\\ 3 & 4 \\end{pmatrix}"), "the matrix with rows 1, 2; 3, 4");
  EXPECT_EQ(said("a_i \\qquad (i = 1, 2)"), "a sub i, open parenthesis i equals 1, 2 close parenthesis");
  EXPECT_EQ(said("\\text{tempting:}\\quad a = 0"), "tempting: a equals 0");
}

// 28 November 2026: "I 3 over I 1 omega 3" was (I3/I1) ω3, and "I 3 omega 3 over I 1 cos theta" was
// I3ω3/(I1 cos θ).
TEST(SpokenMath, AFractionSaysWhereItEnds) {
  EXPECT_EQ(said("\\frac{I_3}{I_1}\\omega_3"),
            "the fraction I sub 3 over I sub 1 end of fraction omega sub 3");
  EXPECT_EQ(said("\\frac{I_3\\omega_3}{I_1\\cos\\theta}"),
            "the fraction I sub 3 omega sub 3 over I sub 1 cos theta end of fraction");
  EXPECT_EQ(said("\\frac{a+b}{c}"), "the fraction a plus b over c end of fraction");
  EXPECT_EQ(said("\\frac{2\\pi}{T}"), "the fraction 2 pi over T end of fraction");
  EXPECT_EQ(said("\\frac{a}{b}\\cdot c"), "the fraction a over b end of fraction times c");
  EXPECT_EQ(said("\\frac{a}{b}(c + d)"),
            "the fraction a over b end of fraction open parenthesis c plus d close parenthesis");
  EXPECT_EQ(said("\\frac{a}{b}\\,\\sin x"), "the fraction a over b end of fraction sin x");
  EXPECT_EQ(said("{\\frac{a}{b}}{c}"), "the fraction a over b end of fraction c") << "a group is no end";
  EXPECT_EQ(said("\\frac{a}{b}^2"), "the fraction a over b end of fraction squared");
  EXPECT_EQ(said("\\frac{\\frac{a}{b}}{c}"), "the fraction a over b over c end of fraction");
  EXPECT_EQ(said_in_german("\\frac{I_3}{I_1}\\omega_3"), "Bruch I 3 durch I 1 Ende des Bruchs Omega 3");
}

// 28 November 2026: where what is struck out ends was not said.
TEST(SpokenMath, WhatIsStruckOutHasABeginningAndAnEnd) {
  EXPECT_EQ(said("a + \\cancel{b + c} = d"), "a plus struck out: b plus c end of struck out equals d");
  EXPECT_EQ(said_in_german("a + \\cancel{b}"), "a plus durchgestrichen: b Ende des Durchgestrichenen");
  EXPECT_EQ(said("\\cancel{\\frac{a}{b}}c"), "struck out: a over b end of struck out c");
}

TEST(SpokenMath, AShortFractionIsShort) {
  EXPECT_EQ(said("\\frac{I_3}{I_1} = 2"), "I sub 3 over I sub 1 equals 2");
  EXPECT_EQ(said("1 - \\frac{a}{b} + c"), "1 minus a over b plus c");
  EXPECT_EQ(said("\\frac{12.5}{T^2}"), "12.5 over T squared");
  EXPECT_EQ(said("2\\frac{\\vec L}{I_1},"), "2 angular momentum over I sub 1,");
  EXPECT_EQ(said("\\frac{m g \\ell}{I_1}"), "weight times arm over I sub 1") << "one name of the lesson";
  EXPECT_EQ(said("\\frac{a}{b}\\qquad c = 1"), "a over b, c equals 1");
  EXPECT_EQ(said("\\frac12 m"), "one half m");
  EXPECT_EQ(said("\\left(\\frac{a}{b}\\right)c"), "open parenthesis a over b close parenthesis c");
}

TEST(SpokenMath, ARateIsOneThing) {
  EXPECT_EQ(said("\\frac{d\\vec L}{dt} = N"), "d angular momentum over d t equals N");
  EXPECT_EQ(said("\\frac{d^*\\vec L}{dt}"), "d star angular momentum over d t");
  EXPECT_EQ(said("\\frac{d^2\\vec r}{dt^2} = 0"), "d squared vector r over d t squared equals 0");
  EXPECT_EQ(said("\\frac{d}{dt}\\left(x + y\\right)"),
            "d over d t of open parenthesis x plus y close parenthesis");
  EXPECT_EQ(said("\\frac{dm}{dt}\\vec v"), "the fraction d m over d t end of fraction vector v");
  EXPECT_EQ(said("\\frac{d}{2}\\omega"), "the fraction d over 2 end of fraction omega") << "a distance";
}

TEST(SpokenMath, RootsAndPowersSayWhereTheyEnd) {
  EXPECT_EQ(said("\\sqrt{x}"), "the square root of x");
  EXPECT_EQ(said("\\sqrt{x}\\,y"), "the square root of x end of root y");
  EXPECT_EQ(said("\\sqrt{x y}"), "the square root of x y end of root");
  EXPECT_EQ(said("e^{-kt}\\cos x"), "e to the power minus k t end of power cos x");
  EXPECT_EQ(said("x^n y"), "x to the power n y");
}

TEST(SpokenMath, AMagnitudeOfMoreThanOneSaysWhereItEnds) {
  EXPECT_EQ(said("|\\vec L|^2"), "magnitude of angular momentum squared");
  EXPECT_EQ(said("|x|_2^2"), "magnitude of x sub 2 squared");
  EXPECT_EQ(said("|\\vec F| = F"), "magnitude of vector F equals F");
  EXPECT_EQ(said("|\\vec\\omega\\times\\vec L| = 1"),
            "magnitude of omega vector cross angular momentum end of magnitude equals 1");
  EXPECT_EQ(said("\\left|\\vec\\omega\\times\\vec L\\right|"),
            "magnitude of omega vector cross angular momentum end of magnitude");
  EXPECT_EQ(said("|a|^2\\,b"), "magnitude of a end of magnitude squared b");
  EXPECT_EQ(said("|a|\\,b"), "magnitude of a end of magnitude b");
  EXPECT_EQ(said("|a|\\,|b|"), "magnitude of a end of magnitude magnitude of b");
  EXPECT_EQ(said_in_german("|a + b|"), "Betrag von a plus b Ende des Betrags");
}

// 29 November 2026: "lesssim", "nRightarrow" and "varphi" were said.
TEST(SpokenMath, NoCommandIsSaidByItsName) {
  for (const std::string_view name : math_command_names()) {
    const MathCommand& command = *math_command(name);
    const bool makes_sign = command.action == MathCommand::Action::symbol ||
                            command.action == MathCommand::Action::large_operator;
    const char32_t c = command.character;
    const bool is_named_letter =
        ((U'Α' <= c && c <= U'Ω') || (U'α' <= c && c <= U'ω')) && !name.starts_with("var");
    if (!makes_sign || is_named_letter || c == U'|' || c == U'.') continue;  // bars and points have rules
    EXPECT_TRUE(std::any_of(words::kSigns.begin(), words::kSigns.end(),
                            [c](const words::SignWords& row) { return row.sign == c; }))
        << name << " is said as it is written";
  }
  EXPECT_EQ(said("a \\lesssim b"), "a at most about b");
  EXPECT_EQ(said("a \\nRightarrow b"), "a does not imply b");
  EXPECT_EQ(said("\\varphi + \\varepsilon"), "phi plus epsilon");
  EXPECT_EQ(said_in_german("a \\lesssim \\varphi"), "a höchstens etwa Phi");
  EXPECT_EQ(said("a \\not\\prec b"), "a not precedes b");
  EXPECT_EQ(said("a \\xRightarrow{c} d"), "a implies by c d");
}

// 29 November 2026: "omega sub is perpendicular to", "the arrow of parallel to".
TEST(SpokenMath, APartOfAVectorIsSaidAsOne) {
  EXPECT_EQ(said("\\omega_\\perp"), "omega perpendicular");
  EXPECT_EQ(said("\\vec N_{\\parallel}"), "vector N parallel");
  EXPECT_EQ(said("\\omega_\\perp^2"), "omega perpendicular squared");
  EXPECT_EQ(said_in_german("\\omega_\\perp + \\omega_\\parallel"), "Omega senkrecht plus Omega parallel");
  EXPECT_EQ(said("\\parallel"), "parallel");
  EXPECT_EQ(said("a \\perp b"), "a is perpendicular to b");
}

TEST(SpokenMath, NumbersAreMultipliedByTimes) {
  EXPECT_EQ(said("3\\times 10^{-4}"), "3 times 10 to the power minus 4");
  EXPECT_EQ(said("2.5{\\cdot}10^{-2}"), "2.5 times 10 to the power minus 2");
  EXPECT_EQ(said("{\\cdot}10^{-2}"), "times 10 to the power minus 2")
      << "the number stands before the formula";
  EXPECT_EQ(said("\\omega_1\\cdot\\omega_2"), "omega sub 1 times omega sub 2");
  EXPECT_EQ(said("2\\cdot\\vec L"), "2 times angular momentum");
  EXPECT_EQ(said("|\\vec L|\\cdot|\\vec\\omega|"),
            "magnitude of angular momentum end of magnitude times magnitude of omega vector");
  EXPECT_EQ(said_in_german("3\\times 4"), "3 mal 4");
}

TEST(SpokenMath, VectorsHaveADotAndACross) {
  EXPECT_EQ(said("\\vec\\omega\\cdot\\vec L"), "omega vector dot angular momentum");
  EXPECT_EQ(said("\\mathbf I\\cdot\\vec\\omega"), "I dot omega vector");
  EXPECT_EQ(said("\\omega_3\\hat e_3\\times\\vec\\omega"), "omega sub 3 e hat sub 3 cross omega vector");
  EXPECT_EQ(said("\\vec\\omega\\times(\\mathbf I\\cdot\\vec\\omega)"),
            "omega vector cross open parenthesis I dot omega vector close parenthesis");
  EXPECT_EQ(said("\\nabla\\times\\vec F"), "nabla cross vector F");
  EXPECT_EQ(said("\\vec F\\cdot d\\vec r"), "vector F dot d vector r");
  EXPECT_EQ(said("\\times\\vec F"), "cross vector F") << "a line that goes on";
}

// 28 November 2026: "I dot vector omega dot plus vector omega cross …" was İ·ω or I·ω·(…) to who heard it.
TEST(SpokenMath, ARateOfAVectorIsNoHalfOfAScalarProduct) {
  EXPECT_EQ(said("\\mathbf I\\cdot\\dot{\\vec\\omega}+\\vec N"),
            "I dot the time derivative of omega vector plus vector N");
  EXPECT_EQ(said("\\dot{\\vec r}_i"), "the time derivative of vector r sub i");
  EXPECT_EQ(said("\\ddot{\\vec r}"), "the second time derivative of vector r");
  EXPECT_EQ(said("\\ddot\\omega_1"), "omega double dot sub 1");
  EXPECT_EQ(said_in_german("\\dot{\\vec r}_i"), "Zeitableitung von Vektor r Index i");
}

TEST(SpokenMath, AnIndexThatIsNoNumberIsSaidToBeOneInGerman) {
  EXPECT_EQ(said_in_german("5\\,t_f"), "5 t Index f");
  EXPECT_EQ(said_in_german("I_i\\,\\omega_i"), "I Index i Omega Index i");
  EXPECT_EQ(said_in_german("I_3"), "I 3");
}

TEST(SpokenMath, ABoldOneIsTheUnitTensor) {
  EXPECT_EQ(said("r^2\\,\\mathbf 1"), "r squared the unit tensor");
  EXPECT_EQ(said("\\mathbf I = I_1\\mathbf{1}"), "I equals I sub 1 the unit tensor");
}

TEST(SpokenMath, UprightLettersAreThoseOfAUnit) {
  EXPECT_EQ(said("5\\,\\mathrm{kg^2\\,m^4/s^2}"), "5 kg squared m to the power 4 over s squared");
  EXPECT_EQ(said("5\\,\\mathrm{N\\,m}"), "5 N m");
}

TEST(SpokenMath, ADecimalCommaPartsNoNumberInTwo) {
  EXPECT_EQ(said_in_german("(0, 0, -0{,}25)"), "Klammer auf 0; 0; minus 0,25 Klammer zu");
  EXPECT_EQ(said_in_german("(0, 0, -0.25)"), "Klammer auf 0; 0; minus 0,25 Klammer zu");
  EXPECT_EQ(said_in_german("x_{1,2}"), "x 1, 2");
}

TEST(SpokenMath, SaysSomethingOfEveryFormula) {
  for (const auto& [name, tex] : testing::all_formulas()) EXPECT_FALSE(said(tex).empty()) << name;
}

}  // namespace
}  // namespace polhode
