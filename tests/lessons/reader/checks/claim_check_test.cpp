// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/claim_check.h"

#include "lessons/reader/checks/lint_budget.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<std::string> faults(const std::string& kind, const std::string& claim, bool scene = true) {
  const std::string body = "```math a\nx\n```\n```claim a " + kind + " in-other-words\n" + claim + "\n```\n";
  const std::string with_scene = "```scene\nshow = [\"omega\"]\n```\n";
  LessonReading reading = read_lesson(testing::lesson_with(body + (scene ? with_scene : "")), "a.md");
  EXPECT_TRUE(reading.lesson) << ::testing::PrintToString(testing::lines_of(reading.diagnostics));
  if (!reading.lesson) return {};
  EXPECT_FALSE(prove_claims(*reading.lesson));
  return testing::lines_of(check_claims(*reading.lesson, "a.md"));
}

std::vector<std::string> faults_of(const std::string& body) {
  LessonReading reading = read_lesson(testing::lesson_with(body), "a.md");
  EXPECT_TRUE(reading.lesson);
  if (!reading.lesson) return {};
  EXPECT_FALSE(prove_claims(*reading.lesson));
  return testing::lines_of(check_claims(*reading.lesson, "a.md"));
}

TEST(CheckClaims, EveryLineOfALessonIsProvedAtItsPlace) {
  EXPECT_THAT(faults("motion", "ddt(L) = N\nddt(T) = dot(N, omega)"), IsEmpty());
  const auto wrong = faults("motion", "ddt(L) = N\nddt(T) = 2*dot(N, omega)\nddt(L) = -N");
  ASSERT_THAT(wrong, SizeIs(2));
  EXPECT_THAT(wrong[0], HasSubstr("14:1: error: the claim (motion) fails: this does not hold: at I = "));
  EXPECT_THAT(wrong[1], HasSubstr("15:1: error:"));
}

// 2026-11-28: it was read by what throws then, and no lesson was checked any further.
TEST(CheckClaims, ANumberTooLargeForADoubleIsAFactorThatNoClaimHas) {
  const std::string digits(400, '9');
  EXPECT_THAT(faults_of("```math a\n" + digits +
                        "\\,T = x\n```\n```claim a identity\n2*T = dot(omega, L)\n```\n"
                        "```scene\nshow = [\"omega\"]\n```\n"),
              ::testing::Contains(HasSubstr("the formula has other numbers than the claim")));
}

// 2026-11-23: "dT/dt = 0 = 3.76 W" was true when no torque acts, beside a top.
TEST(CheckClaims, NumbersAreOfAMotionOfWhichTheEquationHolds) {
  const auto said = [](const std::string& kind, const std::string& tex, const std::string& scene) {
    const std::string body = "```math a " + kind + "\n" + tex + "\n```\n```scene\n" + scene + "\n```\n";
    LessonReading reading = read_lesson(testing::lesson_with(body), "a.md");
    EXPECT_TRUE(reading.lesson) << ::testing::PrintToString(testing::lines_of(reading.diagnostics));
    if (!reading.lesson) return std::vector<std::string>();
    EXPECT_FALSE(prove_claims(*reading.lesson));
    return testing::lines_of(check_claims(*reading.lesson, "a.md"));
  };
  const std::string rate = "\\frac{dT}{dt} = 0 = \\live[unit={W}]{ddt(T)}",
                    power = "\\frac{dT}{dt} = \\vec\\omega\\cdot\\vec N = \\live[unit={W}]{ddt(T)}";
  EXPECT_THAT(said("free", rate, "show = 'L'"), IsEmpty());
  EXPECT_THAT(said("free", rate, "torque = 'damping:0.5'"), ElementsAre(HasSubstr("on which a torque acts")));
  EXPECT_THAT(said("motion", power, "torque = 'damping:0.5'"), IsEmpty());
  EXPECT_THAT(said("motion", power, "torque = 'sink:0.1'"), ElementsAre(HasSubstr("loses energy inside")));
}

// 2026-11-23: what was called nothing could say anything, and so could what is proved to an order.
TEST(CheckClaims, NumbersAreWhatStandsBeforeThem) {
  const std::string scene = "```scene\nshow = [\"omega\"]\n```\n";
  const auto display = [&](const std::string& tex) {
    return faults_of("```math a\n" + tex + "\n```\n" + scene);
  };
  EXPECT_THAT(display("T = \\live{T}"), IsEmpty());
  EXPECT_THAT(display("T = \\live{2*T}"), ElementsAre(HasSubstr("not the number of what it stands behind")));
  EXPECT_THAT(display("2T \\approx \\live{2.1*T}"), IsEmpty());
  EXPECT_THAT(display("2T \\approx \\live{2.5*T}"), ElementsAre(HasSubstr("allows for a tenth")));
  EXPECT_THAT(faults_of("It has $T = \\live{T}$.\n" + scene), IsEmpty());
  EXPECT_THAT(faults_of("It has $T = \\live{2*T}$.\n" + scene), SizeIs(1));
}

// 2026-11-23: \proved{T = T} = 0 was green.
TEST(CheckClaims, APartThatSaysNothingIsAnError) {
  EXPECT_THAT(faults_of("```math a identity\n\\proved{T = T},\\quad \\zeta = 0\n```\n"),
              ElementsAre(HasSubstr("error: this says nothing")));
}

// 2026-11-23: with cos(acos(2)) = 2 the line \cos\theta = 2 was always true.
TEST(CheckClaims, AnAngleHasACosine) {
  EXPECT_THAT(faults("identity", "cos(acos(2)) = 2"), ElementsAre(HasSubstr("never between -1 and 1")));
  EXPECT_THAT(faults("identity", "cos(acos(1 + norm2(e1))) = 2"), SizeIs(1));
  EXPECT_THAT(faults("identity", "cos(acos(dot(e3, ez))) = dot(e3, ez)"), IsEmpty());
  EXPECT_THAT(faults("identity", "cos(acos(2*dot(e3, ez))) = 2*dot(e3, ez)"), IsEmpty())
      << "where there is such an angle";
}

TEST(CheckClaims, FalseAndNonSequiturFailIfTheyHold) {
  EXPECT_THAT(faults("false", "star(L) = 0"), IsEmpty());
  EXPECT_THAT(faults("false", "ddt(T) = 0"), SizeIs(1));
  EXPECT_THAT(faults("non-sequitur", "ddt(T) = 0 => N = 0"), IsEmpty());
  EXPECT_THAT(faults("non-sequitur", "N = 0 => ddt(T) = 0"), SizeIs(1));
}

TEST(CheckClaims, MeasuredOnesAreMeasuredOnTheirScene) {
  EXPECT_THAT(faults("measured", "ddt(T) = 0"), IsEmpty());
  EXPECT_THAT(faults("measured", "ddt(L) = 0 within 1e-18"),
              ElementsAre(HasSubstr("the claim (measured) fails: at t = ")));
  EXPECT_THAT(faults("measured", "star(L) = 0"), SizeIs(1));
  EXPECT_THAT(faults("measured", "ddt(T) = 0", false),
              ElementsAre(HasSubstr("a measured claim needs a scene")));
  EXPECT_THAT(faults("measured", "1/(w1 - w1) = 0"), ElementsAre(HasSubstr("cannot be measured")));
}

TEST(CheckClaims, WhatMeasuresNothingIsRefused) {
  EXPECT_THAT(faults("measured", "L = -L within 5"), ElementsAre(HasSubstr("this measures nothing")));
}

std::vector<std::string> faults_within(const std::string& body, std::int64_t evaluations) {
  LessonReading reading = read_lesson(testing::lesson_with(body), "a.md");
  EXPECT_TRUE(reading.lesson);
  Budget budget(evaluations);
  if (const auto unproved = prove_claims(*reading.lesson, budget.effort()))
    return testing::lines_of({too_long_to_check("a.md", *unproved)});
  return testing::lines_of(check_claims(*reading.lesson, "a.md", budget.effort()));
}

TEST(CheckClaims, EndAtTheClaimThatIsTooDear) {
  const std::string claim =
      "```math a\nx\n```\n```claim a measured in-other-words\nddt(T) = dot(N, omega)\n```\n";
  const std::string scene = "```scene\nshow = [\"omega\"]\ntorque = \"heavy:1,0,0,1\"\nduration = 100\n```\n";
  const auto far = faults_within(claim + scene, 1'000'000'000);
  EXPECT_THAT(far, IsEmpty());
  const auto near = faults_within(claim + scene, kClaimLineEvaluations + 5'000);
  ASSERT_THAT(near, SizeIs(1));
  EXPECT_THAT(near[0], HasSubstr("error: the lesson is too long to check"));
  EXPECT_THAT(near[0], ::testing::StartsWith("12:1: error:"));
}

TEST(CheckClaims, ASearchInVainIsPaidFor) {
  // False, and true in every state of small whole numbers that is tried: found out by the prover alone.
  const std::string claim =
      "```math a\nx\n```\n```claim a false in-other-words\nw1*(w1-1)*(w1+1)*(w1-2)*(w1+2)*(w1-3)*(w1+3) = "
      "0\n```\n";
  EXPECT_THAT(faults_within(claim, kVainSearchEvaluations + 100'000), IsEmpty());
  EXPECT_THAT(faults_within(claim, kVainSearchEvaluations), SizeIs(1));
}

TEST(CheckClaims, LiveNumbersAndAnswersHaveValues) {
  const std::string scene = "```scene\nshow = [\"omega\"]\n```\n";
  EXPECT_THAT(faults_of("```math a\nT = \\live{T}\n```\n" + scene), IsEmpty());
  EXPECT_THAT(faults_of("```math a\nT = \\live{T}\n```\n"), ElementsAre(HasSubstr("needs a scene")));
  EXPECT_THAT(faults_of("```math a\nT = \\live{1/(T - T)}\n```\n" + scene),
              ElementsAre(HasSubstr("has no value")));
  EXPECT_THAT(faults_of("```ask a\ntype = \"expression\"\nprompt = 'x'\nanswer = \"1/0\"\n```\n"),
              ElementsAre(HasSubstr("is nowhere defined")));
}

TEST(CheckClaims, OfTheLessonsAllHold) {
  for (const auto& path : testing::files_in(test::source_dir() / "lessons", ".md")) {
    const std::string text = testing::read_file(path);
    if (text.rfind("+++", 0) != 0) continue;
    LessonReading reading = read_lesson(text, path.filename().string());
    ASSERT_TRUE(reading.lesson) << path;
    EXPECT_FALSE(prove_claims(*reading.lesson));
    EXPECT_THAT(testing::lines_of(check_claims(*reading.lesson, "")), IsEmpty()) << path;
  }
}

// The sides are lost in rounding, or the scene makes them 0: what is not proved is then not measured either.
TEST(CheckClaims, WhatIsLostInRoundingIsNotMeasured) {
  const auto measured = [](const std::string& scene, const std::string& claim) {
    LessonReading reading =
        read_lesson(testing::lesson_with("```math a\nx\n```\n```claim a measured in-other-words\n" + claim +
                                         "\n```\n```scene\nshow = [\"omega\"]\n" + scene + "\n```\n"),
                    "a.md");
    EXPECT_TRUE(reading.lesson) << ::testing::PrintToString(testing::lines_of(reading.diagnostics));
    if (!reading.lesson) return std::vector<std::string>();
    prove_claims(*reading.lesson);
    return testing::lines_of(check_claims(*reading.lesson, "a.md"));
  };
  const std::string top = "omega = [0.01, 0, 30000]\ntorque = \"heavy:0.01,0,0,1\"\nduration = 0.01";
  for (const char* wrong : {"ddt(T) = 0", "ddt(L) = 0", "ddt(L) = 2*N", "ddt(T) = 5*dot(omega, N)"})
    EXPECT_THAT(measured(top, wrong), ElementsAre(HasSubstr("this measures nothing"))) << wrong;
  EXPECT_THAT(measured("omega = [0, 0, 3000]", "I1*dw1 = (I3 - I2)*w2*w3"),
              ElementsAre(HasSubstr("this measures nothing")));
  EXPECT_THAT(measured("omega = [0.3, 1, 2]", "ddt(T) = 0"), IsEmpty()) << "true of every free body";
}

// Within any tolerance of its terms an equality holds to whose sides the same large term was added.
TEST(CheckClaims, WhatIsLostBesideAnotherTermIsNotMeasured) {
  const auto measured = [](const std::string& claim) {
    LessonReading reading =
        read_lesson(testing::lesson_with("```math a\nx\n```\n```claim a measured in-other-words\n" + claim +
                                         "\n```\n```scene\nshow = [\"omega\"]\nomega = [0.3, 1, 2]\n```\n"),
                    "a.md");
    EXPECT_TRUE(reading.lesson) << ::testing::PrintToString(testing::lines_of(reading.diagnostics));
    if (!reading.lesson) return std::vector<std::string>();
    prove_claims(*reading.lesson);
    return testing::lines_of(check_claims(*reading.lesson, "a.md"));
  };
  const std::string large = "1e12*";
  for (const std::string& wrong :
       {"w1 + " + large + "w2 = " + large + "w2 + 2*w1", large + "w2 - w1 - " + large + "w2 = w3",
        "T + " + large + "dot(omega, L) = 2*T + 2*" + large + "T",
        "I1*dw1 + " + large + "T = (I2 - 2*I3)*w2*w3 + " + large + "T",
        "ddt(L) + " + large + "T*e1 = " + large + "T*e1 + T*e2"})
    EXPECT_THAT(measured(wrong), ElementsAre(HasSubstr("this measures nothing"))) << wrong;
  for (const char* right : {"I1*dw1 = (I2 - I3)*w2*w3", "I1*dw1 + 3*T = (I2 - I3)*w2*w3 + 3*T"})
    EXPECT_THAT(measured(right), IsEmpty()) << right;
}

// --- beside the formula ---------------------------------------------------------------------------------

std::vector<std::string> remarks(const std::string& tex, const std::string& opening,
                                 const std::string& claim) {
  LessonReading reading = read_lesson(
      testing::lesson_with("```math a\n" + tex + "\n```\n```claim a " + opening + "\n" + claim + "\n```\n"),
      "a.md");
  EXPECT_TRUE(reading.lesson) << ::testing::PrintToString(testing::lines_of(reading.diagnostics));
  if (!reading.lesson) return {};
  EXPECT_FALSE(prove_claims(*reading.lesson));
  return testing::lines_of(check_claims(*reading.lesson, "a.md"));
}

TEST(AClaimBesideAFormula, MaySayNoMoreThanTheFormula) {
  EXPECT_THAT(remarks("2T = \\vec\\omega\\cdot\\vec L", "identity", "I1 = I1"),
              ElementsAre(HasSubstr("warning: the formula does not say this")));
  EXPECT_THAT(remarks("E = mc^3", "identity", "I1 = I1"),
              ElementsAre(HasSubstr("warning: the claim speaks of I, which the formula does not show"),
                          HasSubstr("error: this says nothing")));
  EXPECT_THAT(remarks("E = mc^3", "identity in-other-words", "I1 = I1"),
              ElementsAre(HasSubstr("error: this says nothing")));
}

// Every line is compared with every link: 64 by 64 long ones would take minutes.
TEST(AClaimBesideAFormula, IsComparedWithinTheBudget) {
  std::string tex = "T", lines;
  for (int i = 1; i < 40; ++i)
    tex += " = " + std::to_string(i) + "T", lines += "T = " + std::to_string(i) + "*dot(omega, L)\n";
  const std::string lesson = "```math a\n" + tex + "\n```\n```claim a measured\n" + lines + "```\n";
  EXPECT_THAT(faults_within(lesson, 39 * kClaimLineEvaluations * 3),
              ::testing::Contains(HasSubstr("the lesson is too long to check")));
}

TEST(AClaimBesideAFormula, IsNotNeededWhereTheFormulaCanBeRead) {
  EXPECT_THAT(remarks("2T = \\vec\\omega\\cdot\\vec L", "identity", "dot(L, omega) = 2*T"),
              ElementsAre(HasSubstr("warning: the formula itself can be proved, as it is printed")));
}

TEST(AClaimBesideAFormula, OfAPartSaysSo) {
  EXPECT_THAT(remarks("2T = \\vec\\omega\\cdot\\vec L,\\quad I_1 = I_1", "identity", "dot(L, omega) = 2*T"),
              ElementsAre(HasSubstr("of the 2 equalities that the formula states only 1 are claimed")));
}

TEST(AClaimBesideAFormula, MayUseOtherWordsIfTheAuthorSaysSo) {
  EXPECT_THAT(remarks("\\vec L = \\sum m\\,\\vec r", "identity in-other-words", "cross(e1, e2) = e3"),
              IsEmpty());
  EXPECT_THAT(remarks("\\vec L = \\vec r\\bullet\\vec L", "identity", "cross(L, L) = 0"), IsEmpty())
      << "no other letter that is known";
  EXPECT_THAT(remarks("\\vec L = \\sum m\\,\\vec r", "identity", "cross(L, L) = 0"),
              ElementsAre(HasSubstr("shows m, of which")));
  EXPECT_THAT(remarks("\\vec L = \\sum m\\,\\vec r", "identity", "cross(e1, e2) = e3"),
              ElementsAre(HasSubstr("speaks of e, which")));
}

}  // namespace
}  // namespace polhode
