// SPDX-License-Identifier: MIT
#include "app/session/answers/progress.h"

#include "base/words/window_words.h"

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
    if (question.ask->outcomes.empty()) count(progress.others);
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

std::string open_words(const QuestionCount& count, Language language) {
  std::string words;
  const auto add = [&](int number, const Phrase& phrase) {
    if (number > 0) words += (words.empty() ? "" : ", ") + phrase.with(language, {std::to_string(number)});
  };
  add(count.asked - count.answered, words::kCountNotAnswered);
  add(count.answered - count.right, words::kCountNotYetRight);
  return words;
}

std::string words_of(const QuestionCount& count, Language language) {
  const std::string right = std::to_string(count.right), asked = std::to_string(count.asked);
  return count.answered == count.right
             ? words::kCountRight.with(language, {right, asked})
             : words::kCountRightAnswered.with(language, {right, asked, std::to_string(count.answered)});
}

}  // namespace polhode
