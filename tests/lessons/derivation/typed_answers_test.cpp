// SPDX-License-Identifier: MIT
// Every question of every lesson with its right answer in several typings, and with wrong ones that come
// naturally: no wrong one is right, no right one wrong, and the reason is that of the slip.
#include "lessons/derivation/answer_reasons.h"
#include "lessons/notation/typed/expression_typing.h"
#include "lessons/notation/typed/typed_formula.h"
#include "lessons/reader/questions/line_notation.h"
#include "lessons/reader/questions/number_question.h"
#include "lessons/reader/questions/state_task.h"
#include "tests/lessons/support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace polhode {
namespace {

using Mark = AnswerJudgement::Mark;

struct Typed {
  std::string text;
  std::vector<std::string> tags{};  ///< of what is wrong, one of these; none: any
};
struct Typings {
  std::vector<Typed> right, wrong;
};

std::string letters_of(const std::vector<int>& answers, const char* between, bool are_small = false) {
  std::string text;
  for (const int answer : answers)
    text += (text.empty() ? "" : between) +
            std::string(1, static_cast<char>((are_small ? 'a' : 'A') + answer - 1));
  return text;
}

Typings of_choice(const Ask& ask) {
  const std::string letter = letters_of(ask.answers, "");
  Typings typings{
      {{letter}, {'(' + letters_of(ask.answers, "", true) + ')'}, {std::to_string(ask.answers[0])}}, {}};
  for (std::size_t i = 0; i < ask.choices.size(); ++i)
    if (static_cast<int>(i) + 1 != ask.answers[0])
      typings.wrong.push_back(
          {std::string(1, letter_of_choice(i)), {std::string("choice-") + letter_of_choice(i)}});
  return typings;
}

Typings of_order(const Ask& ask) {
  Typings typings{{{letters_of(ask.answers, "")},
                   {letters_of(ask.answers, ", ", true)},
                   {letters_of(ask.answers, " > ")}},
                  {}};
  for (std::size_t i = 0; i + 1 < ask.answers.size(); ++i) {
    std::vector<int> swapped = ask.answers;
    std::swap(swapped[i], swapped[i + 1]);
    typings.wrong.push_back({letters_of(swapped, " "), {"place-" + std::to_string(i + 1)}});
  }
  return typings;
}

Typings of_number(const Ask& ask) {
  const double value = *ask.number->value;
  const std::string unit = ask.number->unit == "1" ? "" : ' ' + ask.number->unit;
  const auto number = [](double x) { return fmt::format("{:.5g}", x); };
  return {{{number(value)}, {number(value) + unit}, {fmt::format("≈ {:.5e}", value) + unit}},
          {{number(-value), {"signs"}},
           {number(2 * value), {"factor", "turns"}},
           {number(value / 2) + unit, {"factor", "turns", "rounding"}},
           {number(10 * value), {"power-of-ten"}},
           {number(1.37 * value), {}},
           {number(value) + " kg^4", {"unit"}}}};
}

Typings of_expression(const Ask& ask) {
  const Expression& answer = *ask.expression;
  const std::string line = typing_of(answer, static_cast<int>(answer.nodes.size()) - 1);
  std::string dense;
  for (const char c : answer.text)
    if (c != ' ') dense += c;
  Typings typings{{{answer.text}, {line}, {dense}, {"1*(" + answer.text + ')'}}, {}};
  if (answer.type() == ExpressionType::zero) {
    typings.wrong = {{"1", {}}, {"w1", {}}};
    return typings;
  }
  const bool is_vector = answer.type() == ExpressionType::vector;
  typings.wrong = {{"-(" + answer.text + ')', {"signs"}},
                   {"2*(" + answer.text + ')', {"factor"}},
                   {"0", {}},
                   {is_vector ? "omega" : "w1", {}},
                   {answer.text + (is_vector ? " + L" : " + T"), {}}};
  if (is_vector) typings.wrong.push_back({"w1", {"kind"}});
  if (!is_vector) typings.wrong.push_back({"omega", {"kind"}});
  return typings;
}

Typings of_state(const Ask& ask) {
  const std::string right = text_of(ask.task->solution);
  std::string greek = right;
  if (const auto at = greek.find("omega"); at != greek.npos) greek.replace(at, 5, "ω");
  return {{{right}, {greek}}, {}};
}

TEST(TypedAnswers, AreJudgedAsTheyAreMeantInAllLessons) {
  int right = 0, wrong = 0;
  const Prover prover;
  for (const auto& path : testing::files_in(test::source_dir() / "lessons", ".md")) {
    if (path.filename() == "FORMAT.md") continue;
    LessonReading read = read_lesson(testing::read_file(path), path.filename().string());
    ASSERT_TRUE(read.lesson) << path;
    compute_answers(*read.lesson);
    for (const Stage& stage : read.lesson->stages)
      for (const Step& step : stage.steps)
        for (const Ask* ask : blocks_of<Ask>(step)) {
          if (ask->derivation) continue;  // mutated_solutions_test.cpp
          const Typings typings = picks_choice(ask->type)              ? of_choice(*ask)
                                  : ask->type == Ask::Type::order      ? of_order(*ask)
                                  : ask->type == Ask::Type::number     ? of_number(*ask)
                                  : ask->type == Ask::Type::expression ? of_expression(*ask)
                                                                       : of_state(*ask);
          const LineNotation how = line_notation(*read.lesson, *ask);
          const auto judged = [&](const std::string& text) {
            return ask->task ? judge_state(*ask->task, text) : judge_with_reasons(*ask, text, prover, how);
          };
          const std::string where = path.stem().string() + ' ' + stage.id + '/' + ask->id + ": ";
          for (const Typed& typed : typings.right) {
            const AnswerJudgement judgement = judged(typed.text);
            EXPECT_EQ(judgement.mark, Mark::right) << where << typed.text << ": " << judgement.reason;
            ++right;
          }
          for (const Typed& typed : typings.wrong) {
            const AnswerJudgement judgement = judged(typed.text);
            EXPECT_EQ(judgement.mark, Mark::wrong) << where << typed.text << ": " << judgement.reason;
            EXPECT_TRUE(typed.tags.empty() ||
                        std::find(typed.tags.begin(), typed.tags.end(), judgement.tag) != typed.tags.end())
                << where << typed.text << " has the reason " << judgement.tag << ": " << judgement.reason;
            EXPECT_NE(judgement.reason, "") << where << typed.text;
            ++wrong;
          }
        }
  }
  std::printf("%d right typings, %d wrong ones\n", right, wrong);
  EXPECT_GT(right, 300);
  EXPECT_GT(wrong, 300);
}

}  // namespace
}  // namespace polhode
