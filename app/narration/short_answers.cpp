// SPDX-License-Identifier: MIT
#include "app/narration/short_answers.h"

#include "app/narration/state_line.h"
#include "base/ascii.h"
#include "base/words/page_words.h"
#include "lessons/claims/answers/number_answer.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "lessons/reader/questions/state_task.h"

#include <string_view>

namespace polhode {

namespace {

/// Whether nobody would mind to read its numbers: each has few digits.
bool is_read_at_a_glance(std::string_view state) {
  constexpr int kMostDigits = 4;
  int digits = 0;
  for (const char c : state) {
    digits = is_digit(c) ? digits + 1 : c == '.' ? digits : 0;
    if (digits > kMostDigits) return false;
  }
  constexpr std::size_t kMostCharacters = 60;
  return !state.empty() && state.size() <= kMostCharacters;
}

/// Empty: it would be no answer that one reads.
std::string state_in_short(const SteeredState& state, Language language) {
  return state.attitude || !is_read_at_a_glance(text_of(state)) ? "" : state_line(state, language);
}

std::string answer_in_short(const Lesson& lesson, const Ask& ask) {
  const Language language = lesson.about.language;
  if (ask.type == Ask::Type::derive) return {};
  if (ask.expression) return '$' + tex_of(*ask.expression, &lesson.notation.vocabulary) + '$';
  if (ask.number) return with_decimals(words_of(*ask.number), language);
  if (ask.task) {
    const std::string state = state_in_short(ask.task->solution, language);
    return state.empty() ? state : words::kForExample.with(language, {state});
  }
  std::string letters;
  for (const int answer : ask.answers) {
    if (!letters.empty()) letters += ' ';
    letters += letter_of_choice(static_cast<std::size_t>(answer - 1));
  }
  return letters;
}

}  // namespace

std::string short_answers(const Lesson& lesson, const Stage& stage) {
  std::string line;
  for (std::size_t i = 0; i < stage.steps.size(); ++i)
    for (const Ask* ask : blocks_of<Ask>(stage.steps[i]))
      if (const std::string answer = answer_in_short(lesson, *ask); !answer.empty())
        line += (line.empty() ? "" : "; ") +
                words::kAnswerOfStep.with(lesson.about.language, {std::to_string(i + 1), answer});
  return line;
}

}  // namespace polhode
