// SPDX-License-Identifier: MIT
// The answers of a class: reports that students have handed in, side by side.
#pragma once

#include "app/session/answer_check.h"
#include "app/session/answer_report.h"
#include "app/session/progress.h"
#include "base/result.h"

#include <map>
#include <string>
#include <vector>

namespace polhode {

struct CollectedAnswer {
  enum class State { open, wrong, right } state = State::open;
  int tries = 0, hints = 0;
  std::map<std::string, int> reasons;
};
struct CollectedStudent {
  std::string name;  ///< as it was typed, or else that of the file without its ending
  std::string file;
  std::vector<CollectedAnswer> answers;  ///< to each question of the lesson, in its order
  int count(CollectedAnswer::State state) const;
};

class CollectedAnswers {
 public:
  /// `lesson` must outlive it.
  explicit CollectedAnswers(const Lesson& lesson);

  /// Takes a report, or says why it is passed over: it is of another lesson, or of another version, knows
  /// questions that the lesson does not have, or comes from a student who is there. What it calls right is
  /// judged again, and what is not is wrong. @returns what else is to be told; empty: nothing
  Result<std::string> add(const std::string& file, const AnswerReport& report);

  const Lesson& lesson() const { return lesson_; }
  const std::vector<PlacedAsk>& questions() const { return questions_; }
  const std::vector<CollectedStudent>& students() const { return students_; }

 private:
  const Lesson& lesson_;
  std::vector<PlacedAsk> questions_;
  std::map<std::string, std::size_t> number_of_;  ///< of a question, by its name
  AnswerCheck check_;
  std::vector<CollectedStudent> students_;
  std::map<std::string, std::string> file_of_;   ///< by names of students
  std::map<std::string, std::string> nameless_;  ///< files by the checksums of reports without a name
};

/// A row for each student: name, file, how many questions are right, answered and asked; and of each question
/// three columns: right, wrong or nothing, tries, hints.
std::string csv_of(const CollectedAnswers& collected);

/// Of one question: how many students had one reason.
struct ReasonCount {
  std::string tag;
  int students = 0;
};
/// The most frequent first.
std::vector<ReasonCount> reasons_of(const CollectedAnswers& collected, std::size_t question);
/// A row for each reason of each question: how many students had it, of how many who answered.
std::string csv_of_reasons(const CollectedAnswers& collected);
/// How many students have an answer in this state.
int students_with(const CollectedAnswers& collected, std::size_t question, CollectedAnswer::State state);

/// A cell of a table as RFC 4180 has it. What a spreadsheet would compute, because it begins with =, +, - or
/// @, gets an apostrophe before it, which spreadsheets take for "a text".
std::string csv_cell(const std::string& text);

}  // namespace polhode
