// SPDX-License-Identifier: MIT
#include "app/session/answers/progress.h"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

std::vector<PlacedAsk> questions_of(const Lesson& lesson) {
  std::vector<PlacedAsk> questions;
  for (std::size_t s = 0; s < lesson.stages.size(); ++s)
    for (PlacedAsk& question : questions_of_stage(lesson, s)) questions.push_back(std::move(question));
  return questions;
}

std::vector<PlacedAsk> questions_of_stage(const Lesson& lesson, std::size_t stage) {
  std::vector<PlacedAsk> questions;
  const Stage& asks = lesson.stages[stage];
  for (std::size_t i = 0; i < asks.steps.size(); ++i)
    for (const Ask* ask : blocks_of<Ask>(asks.steps[i]))
      questions.push_back({ask, answer_name(asks.id, ask->id), {stage, i}});
  return questions;
}

bool Progress::tests_outcomes() const {
  return std::any_of(outcomes.begin(), outcomes.end(),
                     [](const QuestionCount& count) { return count.asked > 0; });
}

Progress progress_of(const Lesson& lesson, const AnswerLog& answers) {
  Progress progress;
  progress.outcomes.resize(lesson.about.outcomes.size());
  for (const PlacedAsk& question : questions_of(lesson)) {
    const auto record = answers.find(question.name);
    const bool is_known = record != answers.end();
    const auto count = [&](QuestionCount& in) {
      ++in.asked;
      if (is_known && record->second.tries > 0) ++in.answered;
      if (is_known && record->second.right > 0) ++in.right;
    };
    count(progress.all);
    for (const int outcome : question.ask->outcomes)
      count(progress.outcomes[static_cast<std::size_t>(outcome - 1)]);
  }
  return progress;
}

ToRepeat to_repeat(const Lesson& lesson, const AnswerLog& answers) {
  ToRepeat repeat;
  for (PlacedAsk& question : questions_of(lesson)) {
    const auto record = answers.find(question.name);
    const bool is_tried = record != answers.end() && record->second.tries > 0;
    if (is_tried && record->second.right > 0) continue;
    (is_tried ? repeat.wrong : repeat.skipped).push_back(std::move(question));
  }
  return repeat;
}

std::string open_words(const QuestionCount& count) {
  std::string words;
  const auto add = [&](int number, const char* of) {
    if (number > 0) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", number, of);
  };
  add(count.asked - count.answered, "not answered");
  add(count.answered - count.right, "not yet right");
  return words;
}

std::string words_of(const QuestionCount& count) {
  const std::string right = fmt::format("{} of {} right", count.right, count.asked);
  return count.answered == count.right ? right : fmt::format("{}, {} answered", right, count.answered);
}

}  // namespace polhode
