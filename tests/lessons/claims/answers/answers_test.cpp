// SPDX-License-Identifier: MIT
#include "lessons/claims/answers/answers.h"

#include "lessons/claims/expressions/expression_names.h"
#include "lessons/reader/questions/ask_block.h"
#include "lessons/reader/reader.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <regex>
#include <set>

namespace polhode {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Mark = AnswerJudgement::Mark;

const Prover& prover() {
  static const Prover one;
  return one;
}

Question asking(const std::string& answer, const std::string& modulo) {
  testing::TextReport at(answer);
  Question ask;
  ask.type = Question::Type::expression;
  ask.modulo = modulo;
  ask.expression = read_expression(at.text, {1, 1}, at.report);
  EXPECT_TRUE(ask.expression) << answer;
  return ask;
}

AnswerJudgement judged(const Question& ask, const std::string& answer) {
  return judge_answer(ask, answer, prover());
}

Question choosing(Question::Type type, std::vector<int> answers, std::size_t choices) {
  Question ask;
  ask.type = type;
  ask.choices.assign(choices, "text");
  ask.answers = std::move(answers);
  return ask;
}

TEST(JudgeAnswer, TakesEveryFormOfTheSameExpression) {
  const Question ask = asking("w3*w1*(I1 - I3)", "identity");
  for (const char* answer : {"w3*w1*(I1 - I3)", "w1*w3*I1 - I3*w3*w1", "-(I3-I1)*w1*w3",
                             "comp(cross(omega, L), 2)", "2*w1*(I1 - I3)*w3/2"})
    EXPECT_EQ(judged(ask, answer).mark, Mark::right) << answer;
}

struct Slip {
  const char *right, *modulo, *answer, *reason;
  int column;
};
class Slips : public ::testing::TestWithParam<Slip> {};
TEST_P(Slips, AreNamedWithTheirPlace) {
  const AnswerJudgement judgement = judged(asking(GetParam().right, GetParam().modulo), GetParam().answer);
  EXPECT_EQ(judgement.mark, Mark::wrong);
  EXPECT_THAT(judgement.reason, HasSubstr(GetParam().reason)) << GetParam().answer;
  EXPECT_EQ(judgement.column, GetParam().column) << judgement.reason;
}
INSTANTIATE_TEST_SUITE_P(
    All, Slips,
    ::testing::Values(
        Slip{"w3*w1*(I1 - I3)", "identity", "w3*w1*(I3 - I1)", "every sign is the other way round", 0},
        Slip{"I3*I1 - I2*I3", "identity", "I3*I1 + I2*I3", "wrong sign: that of \"I2*I3\"", 9},
        Slip{"I3*I1 - I2*I3", "identity", "-I3*I1 - I2*I3", "wrong sign: that of \"-I3*I1\"", 1},
        Slip{"(N2 - w3*w1*(I1 - I3))/I2", "motion", "(N2 - w3*w1*(I3 - I1))/I2",
             "wrong sign: that of \"w3*w1*(I3 - I1)\"", 7},
        Slip{"w3*w1*(I1 - I3)", "identity", "w3*w1*(I1 + I3)", "wrong sign: that of \"I3\"", 13},
        Slip{"(N2 - w3*w1*(I1 - I3))/I2", "motion", "N2 - w3*w1*(I1 - I3)/I2", "not equal", 0},
        Slip{"T + m", "identity", "T + m + w1", "\"w1\" does not belong there", 9},
        Slip{"dot(N, omega)", "motion", "2*dot(N, omega)", "2 times what is asked for", 0},
        Slip{"dot(N, omega)", "motion", "dot(N, omega)/2", "1/2 times what is asked for", 0},
        Slip{"w2*w3*(I3 - I2)", "identity", "w3*w1*(I1 - I3)", "the indices are mixed up", 0},
        Slip{"cross(omega, L)", "identity", "dot(omega, L)",
             "wrong type: a vector is asked for, this is a scalar", 0},
        Slip{"dot(N, omega)", "motion", "ddt(T)", "without derivatives: \"ddt(T)\"", 1},
        Slip{"T", "motion", "m + T + dw1*T", "without derivatives: \"dw1\"", 9},
        Slip{"(N1 - w2*w3*(I3 - I2))/I1", "motion", "-w2*w3*(I3 - I2)/I1", "right without torque only", 0},
        Slip{"ddt(omega)", "identity", "cross(L, omega)", "not equal to what is asked for", 0},
        Slip{"dw1*I1", "identity", "N1 - w2*w3*(I3 - I2)", "follows from the equations of motion", 0}));

TEST(JudgeAnswer, ThatNothingEqualsNothingWithoutTorqueIsNoPraise) {
  EXPECT_THAT(judged(asking("dot(N, omega)", "motion"), "dot(N, L)").reason, HasSubstr("not equal"));
}

TEST(JudgeAnswer, AWrongExpressionHasACounterexampleWithItsOwnValueFirst) {
  const auto counter = judged(asking("I1*w1", "identity"), "I2*w1").counterexample;
  ASSERT_TRUE(counter);
  EXPECT_EQ(counter->state, "I = (2, 3, 4), ω = (1, 0, 0)");
  EXPECT_EQ(counter->left, "3");
  EXPECT_EQ(counter->right, "2");
}

TEST(JudgeAnswer, SaysWhatCannotBeReadAndWhere) {
  const AnswerJudgement unknown = judged(asking("T", "identity"), "T + w4");
  EXPECT_EQ(unknown.mark, Mark::unreadable);
  EXPECT_EQ(unknown.column, 5);
  EXPECT_THAT(unknown.reason, HasSubstr("unknown symbol \"w4\""));
  EXPECT_THAT(unknown.hint, HasSubstr("w1"));
  EXPECT_EQ(judged(asking("T", "identity"), "1/(T - T)").reason, "this is nowhere defined");
  EXPECT_THAT(judged(asking("T", "identity"), "norm(L)").reason, HasSubstr("a length is a root"));
  EXPECT_EQ(judged(asking("T", "identity"), "").mark, Mark::unreadable);
  EXPECT_EQ(judged(asking("T", "identity"), "T\nT").mark, Mark::unreadable);
}

TEST(JudgeAnswer, ChoicesGoByLetterOrNumber) {
  const Question ask = choosing(Question::Type::choice, {2}, 3);
  for (const char* right : {"B", "b", "2", " 2 "}) EXPECT_EQ(judged(ask, right).mark, Mark::right) << right;
  EXPECT_EQ(judged(ask, "C").reason, "C is not right");
  for (const char* no : {"", "D", "0", "4", "two", "A B", "99999999999999999999", "-1"})
    EXPECT_EQ(judged(ask, no).mark, Mark::unreadable) << no;
  EXPECT_EQ(judged(choosing(Question::Type::predict, {1}, 2), "A").mark, Mark::right);
}

TEST(JudgeAnswer, AnOrderNamesEveryChoiceOnce) {
  const Question ask = choosing(Question::Type::order, {3, 1, 2}, 3);
  for (const char* right : {"CAB", "C A B", "3,1,2", "3 1 2", "c,A 2"})
    EXPECT_EQ(judged(ask, right).mark, Mark::right) << right;
  EXPECT_EQ(judged(ask, "A B C").reason, "place 1 is not right");
  EXPECT_EQ(judged(ask, "C B A").reason, "place 2 is not right, the one before it is");
  for (const char* no : {"A B", "A A B", "A B C A", "ABD"})
    EXPECT_EQ(judged(ask, no).mark, Mark::unreadable) << no;
}

TEST(WordsOfAnswers, AreThoseThatAnswersAreReadBy) {
  static const std::regex kWord("[A-Za-z]\\w*");
  const std::set<std::string> of_the_sentence = {"their", "rates", "vectors", "a", "b",   "x",
                                                 "d",     "dL",    "dt",      "I", "for", "component"};
  std::string words(kWordsOfAnswers);
  int known = 0;
  for (std::sregex_iterator word(words.begin(), words.end(), kWord); word != std::sregex_iterator(); ++word) {
    if (of_the_sentence.contains(word->str())) continue;
    ++known;
    EXPECT_TRUE(find_quantity(word->str()) || find_function(word->str())) << word->str();
  }
  EXPECT_GT(known, 20);
}

TEST(FormOfAnAnswer, AnswersNoQuestionOfItsKind) {
  for (const char* right : {"w3*w1*(I1 - I3)", "cross(omega, L)", "0"}) {
    const AnswerJudgement form =
        judged(asking(right, "motion"), std::string(form_of_answer(Question::Type::expression)));
    EXPECT_EQ(form.mark, Mark::unreadable) << right;
    EXPECT_THAT(form.reason, HasSubstr("unknown symbol")) << "it is written as expressions are";
  }
  for (std::size_t choices = 2; choices <= kMaxChoices; ++choices) {
    std::vector<int> in_order(choices);
    std::iota(in_order.begin(), in_order.end(), 1);
    const Question order = choosing(Question::Type::order, in_order, choices);
    EXPECT_EQ(judged(order, std::string(form_of_answer(order.type))).mark, Mark::unreadable) << choices;
  }
}

TEST(FormOfAnAnswer, AnswersNoQuestionOfTheLessons) {
  for (const auto& path : testing::files_in(test::source_dir() / "lessons", ".md")) {
    if (path.filename() == "FORMAT.md") continue;  // no lesson
    const LessonReading reading = read_lesson(testing::read_file(path), path.filename().string());
    ASSERT_TRUE(reading.lesson) << path;
    std::size_t written = 0;
    for (const Stage& stage : reading.lesson->stages)
      for (const Step& step : stage.steps)
        for (const Block& block : step.blocks) {
          const auto* ask = std::get_if<Ask>(&block);
          if (!ask || form_of_answer(ask->type).empty()) continue;
          ++written;
          EXPECT_EQ(judged(*ask, std::string(form_of_answer(ask->type))).mark, Mark::unreadable)
              << path << ' ' << stage.id << ' ' << ask->id;
        }
    EXPECT_GT(written, 0u) << path;
  }
}

}  // namespace
}  // namespace polhode
