// SPDX-License-Identifier: MIT
// From the specification: what restates the question is no answer, what is right for the bodies that are
// given is right, a counterexample is one of them, and a wrong index or a missing term gets its reason.
#include "lessons/derivation/answer_reasons.h"

#include "lessons/reader/reader.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <regex>

namespace polhode {
namespace {

using ::testing::HasSubstr;
using Mark = AnswerJudgement::Mark;

/// Keys of a question, in a lesson with assumptions, which is read as authors' lessons are.
struct Asked {
  Lesson lesson;
  const Ask& ask() const { return *blocks_of<Ask>(lesson.stages[0].steps[0])[0]; }
  AnswerJudgement judged(const std::string& answer) const {
    static const Prover prover;
    const AnswerJudgement judgement = judge_with_reasons(ask(), answer, prover, lesson.notation.vocabulary);
    EXPECT_EQ(is_right_answer(ask(), answer, prover, lesson.notation.vocabulary),
              judgement.mark == Mark::right)
        << answer;
    return judgement;
  }
};

Asked asking(const std::string& prompt, const std::string& answer, const std::string& more = "") {
  const LessonReading read = read_lesson(
      "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\naxes = \"xyz\"\n"
      "[constants]\nmgl = { value = 2.94, tex = 'm g \\ell', say = \"weight\", unit = \"N m\" }\n"
      "[assume]\nsymmetric = \"I2 = I1\"\nsphere = [\"I2 = I1\", \"I3 = I1\"]\nflat = \"I3 = I1 + I2\"\n"
      "heavy = \"N = mgl*cross(ez, e3)\"\noblate = [\"I2 = I1\", \"I3 > I1\"]\nspin = \"w3 = 0\"\n"
      "+++\n# A {a}\nText.\n\n```ask q\ntype = 'expression'\nprompt = '''" +
          prompt + "'''\nanswer = '" + answer + "'\n" + more + "\n```\n",
      "a.md");
  if (!read.lesson) throw std::runtime_error(testing::lines_of(read.diagnostics).front());
  return {*read.lesson};
}

// Restating the question.

struct Restated {
  const char *prompt, *answer, *more, *typed;
};
class Restating : public ::testing::TestWithParam<Restated> {};
TEST_P(Restating, IsNoAnswer) {
  const auto& [prompt, answer, more, typed] = GetParam();
  const AnswerJudgement judgement = asking(prompt, answer, more).judged(typed);
  EXPECT_EQ(judgement.mark, Mark::wrong) << typed;
  EXPECT_THAT(judgement.tag, ::testing::AnyOf("restated", "derivative")) << judgement.reason;
  EXPECT_NE(judgement.reason, "");
}
const char* const kSix =
    "Write $d^*\\vec L/dt + \\vec\\omega\\times\\vec L$ with $\\mathbf I$ and $\\vec\\omega$.";
const char* const kSixAnswer = "inertia(ddt(omega)) + cross(omega, inertia(omega))";
const char* const kMiddle =
    "What is the $y$ component of $\\vec\\omega\\times(\\mathbf I\\cdot\\vec\\omega)$?";
INSTANTIATE_TEST_SUITE_P(
    All, Restating,
    ::testing::Values(
        Restated{"What is $dT/dt$?", "dot(N, omega)", "modulo = 'motion'", "ddt(T)"},
        Restated{"What is $dT/dt$?", "dot(N, omega)", "modulo = 'motion'", "2*ddt(T)/2"},
        Restated{"What is $d(\\vec L\\cdot\\vec L)/dt$?", "2*dot(L, N)", "modulo = 'motion'",
                 "2*dot(L, ddt(L))"},
        Restated{"Use the product rule on $d(\\vec L\\cdot\\vec L)/dt$.", "2*dot(L, ddt(L))", "",
                 "ddt(norm2(L))"},
        Restated{"Use the product rule on $d(\\vec L\\cdot\\vec L)/dt$.", "2*dot(L, ddt(L))", "",
                 "ddt(dot(L, L))"},
        Restated{kSix, kSixAnswer, "", "star(L) + cross(omega, L)"},
        Restated{kSix, kSixAnswer, "", "cross(omega, L) + star(L)"},
        Restated{kSix, kSixAnswer, "", "-cross(L, omega) + star(inertia(omega))"},
        Restated{kSix, kSixAnswer, "", "ddt(L)"},
        Restated{kSix, kSixAnswer, "", "inertia(ddt(omega)) + cross(omega, L)"},
        Restated{kMiddle, "w3*w1*(I1 - I3)", "", "comp(cross(omega, inertia(omega)), 2)"},
        Restated{kMiddle, "w3*w1*(I1 - I3)", "", "comp(cross(omega, L), 2)"},
        Restated{kMiddle, "w3*w1*(I1 - I3)", "", "-comp(cross(L, omega), 2)"},
        Restated{"Write $2T$ with the components of $\\vec L$ and the moments.",
                 "comp(L, 1)^2/I1 + comp(L, 2)^2/I2 + comp(L, 3)^2/I3", "", "2*T"},
        Restated{"Write $2T$ with the components of $\\vec L$ and the moments.",
                 "comp(L, 1)^2/I1 + comp(L, 2)^2/I2 + comp(L, 3)^2/I3", "", "T + T"},
        Restated{"Solve $I_2\\dot\\omega_2 + \\omega_3\\omega_1(I_1 - I_3) = N_2$ for $\\dot\\omega_2$.",
                 "(N2 - w3*w1*(I1 - I3))/I2", "modulo = 'motion'", "dw2"}));

struct Answered {
  const char *prompt, *answer, *more, *typed;
};
class Answering : public ::testing::TestWithParam<Answered> {};
TEST_P(Answering, InOtherWordsIsRight) {
  const auto& [prompt, answer, more, typed] = GetParam();
  const AnswerJudgement judgement = asking(prompt, answer, more).judged(typed);
  EXPECT_EQ(judgement.mark, Mark::right) << typed << ": " << judgement.reason;
}
INSTANTIATE_TEST_SUITE_P(
    All, Answering,
    ::testing::Values(
        Answered{kSix, kSixAnswer, "", "inertia(star(omega)) + cross(omega, inertia(omega))"},
        Answered{kSix, kSixAnswer, "",
                 "cross(omega, inertia(omega)) + ddt(I1*w1)*e1 + I2*dw2*e2 + I3*dw3*e3 - "
                 "inertia(cross(omega, omega)) - w1*I1*ddt(w1)*e1/w1 + dw1*I1*e1"},
        Answered{kMiddle, "w3*w1*(I1 - I3)", "", "w3*comp(inertia(omega), 1) - w1*I3*w3"},
        Answered{kMiddle, "w3*w1*(I1 - I3)", "", "-(I3 - I1)*w1*w3"},
        Answered{"What is $dT/dt$?", "dot(N, omega)", "modulo = 'motion'", "w1*N1 + w2*N2 + w3*N3"},
        // The lesson's own answer stands in its prompt.
        Answered{"Newton wrote $\\frac{d\\vec L}{dt} = \\vec N$. What is the rate of $\\vec L$?", "N",
                 "modulo = 'motion'", "N"},
        Answered{"Is it $I_1\\omega_1$ or $I_2\\omega_1$?", "I1*w1", "", "w1*I1"}));

// What is given.

struct GivenAnswer {
  const char *given, *modulo, *answer, *right, *wrong;
};
class GivenBodies : public ::testing::TestWithParam<GivenAnswer> {
 protected:
  Asked question() const {
    return asking("What is it?", GetParam().answer,
                  std::string("modulo = '") + GetParam().modulo + "'\ngiven = '" + GetParam().given + "'");
  }
};
TEST_P(GivenBodies, WhatIsRightForThemIsRight) {
  EXPECT_EQ(question().judged(GetParam().right).mark, Mark::right);
  EXPECT_NE(asking("What is it?", GetParam().answer, std::string("modulo = '") + GetParam().modulo + "'")
                .judged(GetParam().right)
                .mark,
            Mark::right)
      << "it is right for all bodies, and proves nothing";
}

std::vector<double> moments_in(const std::string& state) {
  std::smatch found;
  static const std::regex kMoments(R"(I = \(([0-9.]+), ([0-9.]+), ([0-9.]+)\))");
  if (!std::regex_search(state, found, kMoments)) return {};
  return {std::stod(found[1]), std::stod(found[2]), std::stod(found[3])};
}

TEST_P(GivenBodies, ACounterexampleIsOneOfThem) {
  const AnswerJudgement judgement = question().judged(GetParam().wrong);
  EXPECT_EQ(judgement.mark, Mark::wrong);
  ASSERT_TRUE(judgement.counterexample) << GetParam().wrong;
  EXPECT_NE(judgement.counterexample->left, judgement.counterexample->right);
  const std::string& state = judgement.counterexample->state;
  const std::vector<double> I = moments_in(state);
  ASSERT_EQ(I.size(), 3u) << state;
  const std::string given = GetParam().given;
  if (given == "symmetric" || given == "sphere" || given == "oblate") {
    EXPECT_EQ(I[1], I[0]) << state;
  }
  if (given == "sphere") {
    EXPECT_EQ(I[2], I[0]) << state;
  }
  if (given == "oblate") {
    EXPECT_GT(I[2], I[0]) << state;
  }
  if (given == "flat") {
    EXPECT_EQ(I[2], I[0] + I[1]) << state;
  }
}
INSTANTIATE_TEST_SUITE_P(
    All, GivenBodies,
    ::testing::Values(
        GivenAnswer{"symmetric", "free", "w2*w3*(I2 - I3)/I1", "w2*w3*(I1 - I3)/I1", "w2*w3*(I3 - I1)/I1"},
        GivenAnswer{"symmetric", "identity", "T", "I1*(w1^2 + w2^2)/2 + I3*w3^2/2",
                    "I1*(w1^2 + w2^2) + I3*w3^2"},
        GivenAnswer{"sphere", "identity", "cross(omega, L)", "0", "I1*omega"},
        GivenAnswer{"sphere", "motion", "inertia(N)", "I3*N", "2*I3*N"},
        GivenAnswer{"flat", "identity", "I3*w3", "(I1 + I2)*w3", "(I1 - I2)*w3"},
        GivenAnswer{"oblate", "identity", "I2*w3*(I3 - I1)", "I1*w3*(I3 - I2)", "I1*w3*(I2 - I3)"}));

TEST(GivenTorque, CounterexamplesAreUnderIt) {
  const Asked question = asking("What is $N_z$?", "N3", "given = 'heavy'");
  EXPECT_EQ(question.judged("0").mark, Mark::right);
  EXPECT_EQ(question.judged("mgl*w3").mark, Mark::wrong);
}

// Slips.

struct Slipped {
  const char *answer, *typed, *tag;
};
class AnswerSlips : public ::testing::TestWithParam<Slipped> {};
TEST_P(AnswerSlips, GetTheirReason) {
  const AnswerJudgement judgement =
      asking("What is it?", GetParam().answer, "modulo = 'motion'").judged(GetParam().typed);
  EXPECT_EQ(judgement.mark, Mark::wrong);
  EXPECT_EQ(judgement.tag, GetParam().tag) << GetParam().typed << ": " << judgement.reason;
}
INSTANTIATE_TEST_SUITE_P(
    All, AnswerSlips,
    ::testing::Values(Slipped{"w3*w1*(I1 - I3)", "w3*w1*(I1 - I2)", "index"},
                      Slipped{"w3*w1*(I1 - I3)", "w3*w2*(I1 - I3)", "index"},
                      Slipped{"I1*w1", "I2*w1", "index"},
                      Slipped{"(N2 - w3*w1*(I1 - I3))/I2", "(N2 - w3*w1*(I1 - I3))/I3", "index"},
                      Slipped{"(N2 - w3*w1*(I1 - I3))/I2", "(N1 - w3*w1*(I1 - I3))/I2", "index"},
                      Slipped{"N1*w1 + N2*w2 + N3*w3", "N1*w1 + N2*w2", "missing"},
                      Slipped{"N1*w1 + N2*w2 + N3*w3", "N1*w1 + N2*w2 + N3*w2", "index"},
                      Slipped{"(N2 - w3*w1*(I1 - I3))/I2", "N2/I2", "missing"},
                      Slipped{"w3*w1*(I1 - I3)", "w3*w1*I1", "missing"},
                      Slipped{"comp(L, 1)^2/I1 + comp(L, 2)^2/I2", "comp(L, 1)^2/I1", "missing"},
                      Slipped{kSixAnswer, "inertia(ddt(omega))", "transport"},
                      Slipped{"star(L) + cross(omega, L)", "star(L)", "transport"},
                      Slipped{kSixAnswer, "inertia(ddt(omega)) + cross(inertia(omega), omega)", "sign"},
                      Slipped{"w3*w1*(I1 - I3)", "w3*w1*(I3 - I1)", "signs"},
                      Slipped{"w3*w1*(I1 - I3)", "w3*w1*(I1 + I3)", "sign"},
                      Slipped{"dot(N, omega)", "2*dot(N, omega)", "factor"},
                      Slipped{"I1*w1", "I1*w1 + N1", "extra"},
                      Slipped{"w2*w3*(I3 - I2)", "w3*w1*(I1 - I3)", "indices"},
                      Slipped{"cross(omega, L)", "dot(omega, L)", "kind"},
                      Slipped{"(N1 - w2*w3*(I3 - I2))/I1", "-w2*w3*(I3 - I2)/I1", "torque"},
                      Slipped{"I1*w1^2 + I2*w2^2", "I1*w1 + I2*w2^2", "power"},
                      Slipped{"I1*w1^2 + I2*w2^2", "w1^2 + I2*w2^2", "inertia"},
                      Slipped{"dot(N, omega)", "m*I1^2", "other"}));

TEST(AnswerSlip, OfAChoiceOrAnOrderHasATagToo) {
  Question choice;
  choice.type = Question::Type::choice;
  choice.choices = {"x", "y", "z"};
  choice.answers = {2};
  EXPECT_EQ(judge_with_reasons(choice, "c", Prover(), Vocabulary()).tag, "choice-C");
  EXPECT_EQ(judge_with_reasons(choice, "B", Prover(), Vocabulary()).tag, "");
  choice.type = Question::Type::order;
  choice.answers = {1, 3, 2};
  EXPECT_EQ(judge_with_reasons(choice, "A B C", Prover(), Vocabulary()).tag, "place-2");
}

TEST(AnswerReasons, LongAnswersTakeNoLonger) {
  const Asked question = asking(kMiddle, "w3*w1*(I1 - I3)");
  for (const std::string& part :
       {std::string("+w1*w2^2"), std::string("*(w1 + I2)"), std::string("/(I1 + w2)")}) {
    std::string answer = "w1";
    while (answer.size() + part.size() < 380) answer += part;
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(question.judged(answer).mark, Mark::wrong);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(2000)) << answer;
  }
}

}  // namespace
}  // namespace polhode
