// SPDX-License-Identifier: MIT
// Lines that a reader would see as false, and that were once called proved. Each was found by an attacker.
#include "lessons/reader/claim_check.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

/// Errors and warnings of a lesson whose front matter has `tables` too.
std::vector<std::string> complaints_of(const std::string& body, const std::string& tables = "") {
  std::string text = testing::lesson_with(body);
  const std::size_t end = text.find("+++", 3);
  text.insert(end, tables);
  LessonReading reading = read_lesson(text, "a.md");
  std::vector<std::string> lines = testing::lines_of(reading.diagnostics);
  if (!reading.lesson) return lines;
  if (prove_claims(*reading.lesson)) lines.push_back("too long");
  for (const std::string& line : testing::lines_of(check_claims(*reading.lesson, "a.md")))
    lines.push_back(line);
  return lines;
}

std::string math(const std::string& kind, const std::string& tex) {
  return "```math a " + kind + "\n" + tex + "\n```\n";
}

struct FalseLine {
  const char *name, *body, *tables;
  const char* scene = "show = [\"omega\"]";
};

class FalseLines : public ::testing::TestWithParam<FalseLine> {};

TEST_P(FalseLines, AreNotCalledProved) {
  const FalseLine& line = GetParam();
  const std::string scene = "```scene\n" + std::string(line.scene) + "\n```\n";
  EXPECT_THAT(complaints_of(line.body + scene, line.tables), ::testing::Not(::testing::IsEmpty()))
      << line.body;
}

const FalseLine kFalseLines[] = {
    {"TwoArrows",
     "```math a identity\nT = 5T \\Rightarrow \\vec N = 0 \\Rightarrow 2T = \\vec\\omega\\cdot\\vec L\n```\n",
     ""},
    {"TwoArrowsFree",
     "```math a free\n\\frac{dT}{dt} = 0 \\Rightarrow \\vec N = 0 \\Rightarrow \\frac{d\\vec L}{dt} = "
     "0\n```\n",
     ""},
    {"GoesOnFromAPart",
     "```math a\n\\proved{2T}+1\n```\n```math b identity\n= \\vec\\omega\\cdot\\vec L\n```\n", ""},
    {"NumberUnderACondition", "```math a free\n\\vec N = 0 \\Rightarrow T = \\live[unit={J}]{T}\n```\n", ""},
    {"NumberBesideAnother",
     "```math a identity\n2T = \\vec\\omega\\cdot\\vec L,\\quad \\omega_1 = \\live[unit={rad/s}]{w1}\n```\n",
     ""},
    {"NumberWhereItsConditionFails",
     "```math a identity\n\\omega_2 = 0\\cdot\\omega_1 = \\live[unit={rad/s}]{w2} \\quad (\\omega_2 = "
     "0)\n```\n",
     ""},
    {"NumberOfADriftingMethod",
     "```math a free\n\\frac{dT}{dt} = 0\\cdot\\frac{dT}{dt} = \\live[unit={W}]{ddt(T)}\n```\n", "",
     "motion = { method = \"explicit-euler\", step = 0.05 }\nat = 3"},
    {"NumberOfABodyThatSlips",
     "```math a law\n\\frac{dT}{dt} = \\vec\\omega\\cdot\\vec N = \\live[unit={W}]{dot(omega, N)}\n```\n", "",
     "torque = \"sink:0.01\""},
    {"CosineOfAConstant", "```math a identity\n\\cos\\gamma = c\n```\n",
     "[constants]\nc = { value = 2, tex = 'c' }\n[define]\ngam = { means = \"acos(c)\", tex = '\\gamma' }\n"},
    {"NotEqual",
     "```math a\n2T \\ne \\vec\\omega\\cdot\\vec L\n```\n```claim a identity\n2*T = dot(omega, L)\n```\n",
     ""},
    {"OtherWords",
     "```math a\n3T = \\vec\\omega\\cdot\\vec L\n```\n```claim a identity in-other-words\n2*T = dot(omega, "
     "L)\n```\n",
     ""},
    {"GoesOnFromASimilarSign", "```math a\nT \\simeq 0\n```\n```math b identity\n= 0\\cdot T\n```\n", ""},
    {"GoesOnFromAnArrow", "```math a\nT \\triangleq 0\n```\n```math b identity\n= 0\\cdot T\n```\n", ""},
    {"InverseCosine", "```math a identity\n\\cos^{-1}\\theta = \\frac{1}{u}\n```\n",
     "[define]\nu = { means = \"dot(ez, e3)\", tex = 'u' }\ntheta = { means = \"acos(u)\", tex = '\\theta' "
     "}\n"},
    {"OfAnInstant",
     "```math a non-sequitur\n\\frac{d\\vec L}{dt} = 0 \\quad\\text{does not give}\\quad \\frac{d^2\\vec "
     "L}{dt^2} = 0\n```\n",
     ""},
    {"SymbolAsIndex", "```math a identity\n\\sum_k k\\,I_k = k\\,I_1 + k\\,I_2 + k\\,I_3\n```\n",
     "[symbols]\nk = { tex = 'k', say = \"k\" }\n"},
    {"TwinsInOtherType", "```math a identity\nE = \\frac{1}{2}\\mathit{E}\n```\n",
     "[symbols]\na = { tex = 'E', means = 'T' }\nb = { tex = '\\mathit{E}', means = '2*T' }\n"},
    {"UnitsInAnInequality", "```math a identity\nT + 1 > 0\n```\n", ""},
    {"UnitsInASum", "```math a identity\nI_1 + \\omega_1 = \\omega_1 + I_1\n```\n", ""},
    {"DegreesOfARadian", "Text.\n", "[define]\nth = { means = \"acos(dot(ez, e3))\", unit = \"deg\" }\n"},
    {"ConstantInGrams", "Text.\n", "[constants]\nm0 = { value = 300, unit = \"g\" }\n"},
    {"HertzOfAnL", "It is $\\live[unit={Hz}]{norm(L)/I1}$.\n", ""},
    {"DegreesOfARatio", "It is $\\live[unit={deg}]{I1/I2}$.\n", ""},
    {"NumberInACaption", "Text.\n", "", "caption = '$T = \\live[unit={J}]{2*T}$'"},
    {"NothingLeftOfANumber", "It is $\\value[unit={J}]{0\\cdot10^{6}}{2*T}$.\n", ""},
    {"NumberInANote", "Text.\n", "", "notes = [{ text = '$\\live{T}$', at = \"e3\" }]"},
    {"MeasuredOverNoTime", "```math a measured\n\\omega_1 = 0.2\n```\n", "", "duration = 1e-14"},
    {"PowerOfABrace", "```math a identity\n\\underbrace{T}_{T}^{2} = T\n```\n", ""},
    {"DecimalComma", "```math a identity\n\\frac{5T}{T} = 5{,}0 = 0\n```\n", ""},
    {"ZeroToTheZero", "```math a identity\n0^0 = 1\n```\n", ""},
    {"SignAsASymbol", "Text.\n", "[define]\na = { means = \"2*T\", tex = '\\pm' }\n"},
    {"InfinityAsASymbol", "Text.\n", "[define]\na = { means = \"2*T\", tex = '\\infty' }\n"},
    {"BoldDigitAsASymbol", "Text.\n", "[define]\na = { means = \"2*T\", tex = '\\mathbf 2' }\n"},
};

INSTANTIATE_TEST_SUITE_P(Of2026, FalseLines, ::testing::ValuesIn(kFalseLines),
                         [](const auto& line) { return std::string(line.param.name); });

// A rule that refuses everything would pass, too.
TEST(TrueLines, AreCalledProved) {
  const std::string scene = "```scene\nshow = [\"omega\"]\n```\n";
  struct Case {
    const char *kind, *tex;
  };
  for (const Case& one : {Case{"identity", "2T = \\vec\\omega\\cdot\\vec L = \\live[unit={J}]{2*T}"},
                          Case{"identity", "\\cos^2\\theta = u^2"}, Case{"identity", "T \\ge 0"},
                          Case{"free", "\\vec N = 0 \\Rightarrow \\frac{dT}{dt} = 0"}})
    EXPECT_THAT(complaints_of(math(one.kind, one.tex) + scene,
                              "[define]\nu = { means = \"dot(ez, e3)\", tex = 'u' }\n"
                              "theta = { means = \"acos(u)\", tex = '\\theta', unit = \"rad\" }\n"),
                ::testing::IsEmpty())
        << one.tex;
}

}  // namespace
}  // namespace polhode
