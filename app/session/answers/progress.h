// SPDX-License-Identifier: MIT
// How far a learner has come: which questions of a lesson were answered right, for each of its outcomes.
#pragma once

#include "app/session/answers/answer_log.h"
#include "base/words/language.h"
#include "lessons/reader/lesson.h"

#include <string>
#include <vector>

namespace polhode {

/// A question where it stands.
struct PlacedAsk {
  const Ask* ask = nullptr;
  std::string name;  ///< of its answers in a log (answer_name)
  StepPlace place;
};
/// All questions, in the order in which they are asked.
std::vector<PlacedAsk> questions_of(const Lesson& lesson);
/// Those that are to be repeated: answered, but never right, or passed over.
struct ToRepeat {
  std::vector<PlacedAsk> wrong, skipped;
};
ToRepeat to_repeat(const Lesson& lesson, const AnswerLog& answers);
/// Those of one stage.
std::vector<PlacedAsk> questions_of_stage(const Lesson& lesson, std::size_t stage);

struct QuestionCount {
  int right = 0, answered = 0, asked = 0;
  bool operator==(const QuestionCount&) const = default;
};
struct Progress {
  QuestionCount all;
  std::vector<QuestionCount> outcomes;  ///< in the order of About::outcomes; a question may test several
  QuestionCount others;                 ///< those that say none, so that what is told of all is accounted for
  /// Whether any question says which outcome it tests.
  bool tests_outcomes() const;
};
Progress progress_of(const Lesson& lesson, const AnswerLog& answers);

/// How far a learner is in one of several lessons.
struct LessonProgress {
  std::string id, title;
  std::size_t stages = 0, seen = 0;
  QuestionCount questions{};
  std::vector<std::string> outcomes{};  ///< what one learns in it
  std::string next{};                   ///< id of the lesson behind it; empty: none
  std::size_t at = 0;                   ///< the stage where one left, from 1; 0: it was never begun
};

/// "7 of 9 right", and how many were answered where that says more: "7 of 9 right, 8 answered".
std::string words_of(const QuestionCount& count, Language language = Language::en);
/// What is still open of them: "3 not answered, 1 not yet right"; empty: nothing.
std::string open_words(const QuestionCount& count, Language language = Language::en);

}  // namespace polhode
