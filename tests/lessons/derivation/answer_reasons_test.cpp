// SPDX-License-Identifier: MIT
// From the specification: what restates the question is no answer, what is right for the bodies that are
// given is right, a counterexample is one of them, and a wrong index or a missing term gets its reason.
#include "lessons/derivation/answer_reasons.h"

#include "lessons/reader/questions/line_notation.h"
#include "lessons/reader/reader.h"
#include "tests/lessons/peak_memory.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <regex>
#include <tuple>

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
    const AnswerJudgement judgement = judge_with_reasons(ask(), answer, prover, line_notation(lesson, ask()));
    EXPECT_EQ(is_right_answer(ask(), answer, prover, line_notation(lesson, ask())),
              judgement.mark == Mark::right)
        << answer;
    return judgement;
  }
};

Asked asking(const std::string& prompt, const std::string& answer, const std::string& more = "") {
  const LessonReading read = read_lesson(
      "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\naxes = \"xyz\"\n"
      "[constants]\nmgl = { value = 2.94, tex = 'm g \\ell', say = \"weight\", unit = \"N m\" }\nc = { value "
      "= 2, tex = 'c', say = \"c\" }\n"
      "[assume]\nsymmetric = \"I2 = I1\"\nsphere = [\"I2 = I1\", \"I3 = I1\"]\nflat = \"I3 = I1 + I2\"\n"
      "heavy = \"N = mgl*cross(ez, e3)\"\nbrake = \"N = -c*omega\"\noblate = [\"I2 = I1\", \"I3 > "
      "I1\"]\nspin = \"w3 = 0\"\n"
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
  EXPECT_THAT(judgement.tag, ::testing::AnyOf("restated", "derivative", "letters")) << judgement.reason;
  EXPECT_NE(judgement.reason, "");
}
const char* const kSix =
    "Write $d^*\\vec L/dt + \\vec\\omega\\times\\vec L$ with $\\mathbf I$ and $\\vec\\omega$.";
const char* const kSixAnswer = "inertia(ddt(omega)) + cross(omega, inertia(omega))";
const char* const kMiddle =
    "What is the $y$ component of $\\vec\\omega\\times(\\mathbf I\\cdot\\vec\\omega)$?";
const char* const kLength = "Write $2T$ with the components of $\\vec L$ and the moments.";
const char* const kLengthAnswer = "comp(L, 1)^2/I1 + comp(L, 2)^2/I2 + comp(L, 3)^2/I3";
const char* const kLengthLetters = "letters = ['L', 'I']";
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
        Restated{kMiddle, "w3*w1*(I1 - I3)", "", "dot(cross(omega, inertia(omega)), e2)"},
        Restated{kMiddle, "w3*w1*(I1 - I3)", "", "dot(e2, cross(omega, inertia(omega)))"},
        Restated{kMiddle, "w3*w1*(I1 - I3)", "", "dot(omega, cross(inertia(omega), e2))"},
        Restated{kMiddle, "w3*w1*(I1 - I3)", "", "-comp(cross(inertia(2*omega), omega/2), 2)"},
        Restated{kMiddle, "w3*w1*(I1 - I3)", "", "comp(cross(w1*e1 + w2*e2 + w3*e3, inertia(omega)), 2)"},
        Restated{kMiddle, "w3*w1*(I1 - I3)", "", "(omega x (I omega)) . e2"},
        Restated{kMiddle, "w3*w1*(I1 - I3)", "", "(omega x (I omega))_2"},
        Restated{"What is $\\vec\\omega\\cdot\\mathbf I\\cdot\\dot{\\vec\\omega}$?", "0", "modulo = 'free'",
                 "dot(omega, N)"},
        Restated{kLength, kLengthAnswer, kLengthLetters, "dot(L, omega)"},
        Restated{kLength, kLengthAnswer, kLengthLetters, "omega . (I omega)"},
        Restated{kSix, kSixAnswer, "letters = ['I', 'omega', \"omega'\"]", "ddt(inertia(omega))"},
        Restated{"What is $dT/dt$, in terms of $\\vec\\omega$?", "-c*norm2(omega)",
                 "given = 'brake'\nletters = ['c', 'omega']", "dot(N, omega)"},
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
        Answered{kMiddle, "w3*w1*(I1 - I3)", "", "w3 w1 (I1 - I3)"},
        Answered{kMiddle, "w3*w1*(I1 - I3)", "", "ω₃ω₁(I₁ − I₃)"},
        Answered{kLength, kLengthAnswer, kLengthLetters, "L1^2/I1 + L2^2/I2 + L_3²/I3"},
        Answered{kLength, kLengthAnswer, kLengthLetters, "dot(L, e1)^2/I1 + (L . e2)^2/I2 + (L)_3^2/I3"},
        Answered{kSix, kSixAnswer, "letters = ['I', 'omega', \"omega'\"]", "I omega' + omega x (I omega)"},
        Answered{"What is $dT/dt$, in terms of $\\vec\\omega$?", "-c*norm2(omega)",
                 "given = 'brake'\nletters = ['c', 'omega']", "-c |omega|^2"},
        Answered{"What is $\\vec\\omega\\cdot\\vec L$?", "2*T", "", "2T"},
        Answered{"What is $dT/dt$?", "dot(N, omega)", "modulo = 'motion'", "omega.N"},
        Answered{"What is $dT/dt$?", "dot(N, omega)", "modulo = 'motion'", "omega · N"},
        Answered{"What is $dT/dt$?", "dot(N, omega)", "modulo = 'motion'", "w1 N1 + w2 N2 + w3 N3"},
        Answered{"What torque?", "cross(omega, L)", "", "omega x L"},
        Answered{"What torque?", "cross(omega, L)", "", "ω × I ω"},
        Answered{"How long is it?", "norm2(L)", "", "|L|^2"},
        Answered{"How much?", "-k*norm2(omega)", "", "-k omega . omega"},
        // The lesson's own answer stands in its prompt.
        Answered{"Newton wrote $\\frac{d\\vec L}{dt} = \\vec N$. What is the rate of $\\vec L$?", "N",
                 "modulo = 'motion'", "N"},
        Answered{"Is it $I_1\\omega_1$ or $I_2\\omega_1$?", "I1*w1", "", "w1*I1"}));

TEST(TypedAnswer, ThatCannotBeReadSaysWhyAsItWasTyped) {
  const Asked question = asking("What is it?", "dot(omega, N)", "modulo = 'motion'");
  const std::vector<std::tuple<std::string, int, std::string>> cases = {
      {"omega . X", 9, "there is no \"X\" here"},
      {"omega . I", 9, "what is this tensor applied to?"},
      {"2 w1 )", 6, "bracket"},
      {"T = w1", 3, "one side of an equation"},
      {"w1\nw2", 0, "one line"},
      {"|L|", 0, "a length is a root"},
      {"w1 w4", 4, "w4"},
      {"d|L|/dt", 0, "a length is a root"},
      {"w9", 1, "there is no"},
      {"I", 1, "tensor"},
      {"2*T +", 6, "missing"},
      {"((w1+w2+w3+I1+I2+I3+N1)^16)^16", 0, "too large"}};
  for (const auto& [typed, column, reason] : cases) {
    const AnswerJudgement judgement = question.judged(typed);
    EXPECT_EQ(judgement.mark, Mark::unreadable) << typed;
    EXPECT_THAT(judgement.reason, HasSubstr(reason)) << typed;
    EXPECT_EQ(judgement.column, column) << typed << ": " << judgement.reason;
  }
  EXPECT_EQ(question.judged("2 omega . N").column, 0) << "no place: what is judged is not what was typed";
}

TEST(NoAnswer, SaysOfWhatIsTrueThatItIs) {
  const auto reason = [](const char* prompt, const char* answer, const char* more, const char* typed) {
    return asking(prompt, answer, more).judged(typed).reason;
  };
  EXPECT_EQ(reason("What is $\\vec\\omega\\cdot\\mathbf I\\cdot\\dot{\\vec\\omega}$?", "0", "modulo = 'free'",
                   "dot(omega, N)"),
            "this is true, and it can be written without ω");
  for (const char* zero : {"N1", "dot(e1, N)"})
    EXPECT_EQ(reason("What is $\\vec\\omega\\cdot\\mathbf I\\cdot\\dot{\\vec\\omega}$?", "0",
                     "modulo = 'free'", zero),
              "no torque acts here: say what is left without N")
        << zero;
  EXPECT_EQ(reason(kMiddle, "w3*w1*(I1 - I3)", "", "dot(omega, cross(inertia(omega), e2))"),
            "this is true, and the cross product in it is to be worked out");
  EXPECT_EQ(reason(kLength, kLengthAnswer, kLengthLetters, "dot(L, omega)"),
            "this is true, but it is to be written with L and I alone: ω stands in it");
  EXPECT_EQ(asking(kMiddle, "w3*w1*(I1 - I3)").judged("comp(cross(L, omega), 2)").tag, "signs")
      << "what is wrong is called wrong first";
}

TEST(LettersOfAQuestion, AreThoseOfItsOwnAnswer) {
  const auto fault = [](const std::string& answer, const std::string& more) -> std::string {
    try {
      asking("What?", answer, more);
      return "";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  };
  EXPECT_EQ(fault("mgl*w1*ddt(w2)*dot(e1, L)", "letters = ['mgl', 'omega', \"omega'\", 'L']"), "");
  EXPECT_THAT(fault("w1*I1", "letters = ['omega']"),
              HasSubstr("the answer itself has \"I\", which is not among the letters"));
  EXPECT_THAT(fault("ddt(I1*w1)", "letters = ['omega', 'I']"), HasSubstr("a rate of more than one letter"));
  EXPECT_THAT(fault("w1", "letters = ['omega', 'w2']"), HasSubstr("unknown letter \"w2\""));
  EXPECT_EQ(fault("w1", "letters = 'omega'"), "") << "one text is a list of one, as of other keys";
}

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
                      // I3 - I3 would be true as well, but no index is wrong.
                      Slipped{"w1*w2*w3*(I2 - I3 + I3 - I1 + I1 - I2)", "w1*w2*w3*(I2 - I3)", "other"},
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
  const EquationNotation none;
  const LineNotation no_names{&none, {}, {}};
  choice.type = Question::Type::choice;
  choice.choices = {"x", "y", "z"};
  choice.answers = {2};
  EXPECT_EQ(judge_with_reasons(choice, "c", Prover(), no_names).tag, "choice-C");
  EXPECT_EQ(judge_with_reasons(choice, "B", Prover(), no_names).tag, "");
  choice.type = Question::Type::order;
  choice.answers = {1, 3, 2};
  EXPECT_EQ(judge_with_reasons(choice, "A B C", Prover(), no_names).tag, "place-2");
}

TEST(AnswerReasons, LongAnswersTakeNoLonger) {
  const Asked question = asking(kMiddle, "w3*w1*(I1 - I3)");
  for (const std::string& part :
       {std::string("+w1*w2^2"), std::string("*(w1 + I2)"), std::string("/(I1 + w2)")}) {
    std::string answer = "w1";
    while (answer.size() + part.size() < 380) answer += part;
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(question.judged(answer).mark, Mark::wrong);
    const auto took = std::chrono::steady_clock::now() - begin;
    if (!testing::kSanitized) {
      EXPECT_LT(took, std::chrono::milliseconds(2000)) << answer;
    }
  }
}

// Names of arrows in figures are words of the lesson's file: who guesses one has no answer, and none is
// offered.
TEST(Answers, HaveNoNamesThatNoPageShows) {
  const auto asked = [](const std::string& prompt, const std::string& answer) {
    const LessonReading read = read_lesson(
        "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n[symbols]\n"
        "omega = { tex = '\\vec\\omega', say = \"omega\", unit = \"rad/s\" }\n[constants]\n"
        "c = { value = 2, tex = 'c', say = \"c\" }\n[define]\n"
        "row10 = { tex = 'b_{10}', means = \"w1*w2*w3*(I3 - I2)\", say = \"row\" }\n"
        "q = { tex = 'q', means = \"w1*w2\", say = \"q\" }\nhid = \"w1*w2\"\n"
        "+++\n# A {a}\nText.\n\n```ask q\ntype = 'expression'\nprompt = '''" +
            prompt + "'''\nanswer = '" + answer + "'\n\n```\n",
        "a.md");
    if (!read.lesson) throw std::runtime_error(testing::lines_of(read.diagnostics).front());
    return Asked{*read.lesson};
  };
  const Asked row = asked("What is the product?", "w1*w2*w3*(I3 - I2)");
  for (const char* hidden :
       {"row10", "1*row10", "hid*w3*(I3 - I2)", "q w3 (I3 - I2)", "c*w1*w2*w3*(I3 - I2)/c"}) {
    const AnswerJudgement judgement = row.judged(hidden);
    EXPECT_EQ(judgement.mark, Mark::unreadable) << hidden << ": " << judgement.reason;
  }
  EXPECT_EQ(row.judged("row1").hint.find("row10"), std::string::npos);
  const Asked with_q = asked("Write $q\\,\\omega_3$ with the components.", "w1*w2*w3");
  EXPECT_EQ(with_q.judged("row10").mark, Mark::unreadable);
  EXPECT_EQ(with_q.judged("2 q w3").tag, "factor") << "q stands in the question";
  EXPECT_EQ(asked("What is it?", "2*c*q").judged("2 q c").mark, Mark::right) << "so is the answer written";
}

// As people type who were told nothing.
TEST(Answers, AreReadAsTheyAreTyped) {
  const Asked four = asking("What is it?", "-4*k*T");
  for (const char* typed : {"-4kT", "-4 k T", "−4kT", "–4kT", "-4*k*T", "-4 T k", "-4·k·T"})
    EXPECT_EQ(four.judged(typed).mark, Mark::right) << typed << ": " << four.judged(typed).reason;
  const Asked row = asking("What is $N_1$?", "w2*w3*(I3 - I2)", "modulo = 'identity'");
  for (const char* typed :
       {"w2 w3 (I3 - I2)", "\\omega_2\\omega_3(I_3 - I_2)", "ω₂ω₃(I₃ – I₂)", "w_2 w_3 (I_3 − I_2)",
        "\\omega_{2} \\cdot \\omega_{3} \\cdot (I_{3} - I_{2})", "N1 = w2 w3 (I3 - I2)", "N_1 = w2w3(I3-I2)"})
    EXPECT_EQ(row.judged(typed).mark, Mark::right) << typed << ": " << row.judged(typed).reason;
  EXPECT_EQ(row.judged("N2 = w2 w3 (I3 - I2)").mark, Mark::unreadable) << "that is not what is asked for";
  const Asked rate = asking("What is it?", "I1*dw1 + I2*dw2");
  for (const char* typed : {"I1 ω̇₁ + I2 ω₂̇", "I1 ẇ1 + I2 w2'", "I1 \\omega_1' + I2 dw2"})
    EXPECT_EQ(rate.judged(typed).mark, Mark::right) << typed << ": " << rate.judged(typed).reason;
  const Asked power = asking("What is it?", "2*dot(L, N)");
  EXPECT_EQ(power.judged("2 L . N").mark, Mark::right);
  EXPECT_THAT(power.judged("2LN").reason, HasSubstr("without a sign"));
  EXPECT_THAT(power.judged("\\frac{1}{2}").hint, HasSubstr("a/b for a fraction"));
}

}  // namespace
}  // namespace polhode
