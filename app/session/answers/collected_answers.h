// SPDX-License-Identifier: MIT
// The answers of a class: reports that students have handed in, side by side.
#pragma once

#include "app/session/answers/answer_check.h"
#include "app/session/answers/answer_report.h"
#include "app/session/answers/progress.h"
#include "base/result.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace polhode {

using FileTime = std::filesystem::file_time_type;

struct CollectedAnswer {
  enum class State { open, wrong, right } state = State::open;
  int tries = 0, hints = 0;
  std::map<std::string, int> reasons;
};
struct CollectedStudent {
  /// As it was typed; of a report without a name that of its file without its ending, or the whole path where
  /// another student is called so.
  std::string name;
  std::string file;                      ///< as one line
  std::vector<CollectedAnswer> answers;  ///< to each question of the lesson, in its order
  bool is_named = true;                  ///< in its report
  int count(CollectedAnswer::State state) const;
};

class CollectedAnswers {
 public:
  /// `lesson` must outlive it.
  explicit CollectedAnswers(const Lesson& lesson);

  /// Takes a report, or says why it is skipped: it is of another lesson, or of another version, knows
  /// questions that the lesson does not have, or is older than one of the same student, by when its file was
  /// `written`; of as old ones the later one counts. What it calls right is judged again, and what is not is
  /// wrong; why is judged again too. Of tries, hints and earlier reasons nothing can be judged: what cannot
  /// be, as more hints than there are, is left out, and so is a head that says otherwise than the answers.
  /// @returns what else is to be told; empty: nothing
  Result<std::string> add(const std::string& file, const AnswerReport& report, FileTime written = {});

  /// Whether a report says what is not so: of an answer that it is right, of numbers that cannot be.
  bool has_false_rights() const { return has_false_rights_; }
  const Lesson& lesson() const { return lesson_; }
  const std::vector<PlacedAsk>& questions() const { return questions_; }
  const std::vector<CollectedStudent>& students() const { return students_; }

 private:
  void give_name(CollectedStudent& student);
  void check_numbers(const Ask& ask, const ReportedAnswer& reported, CollectedAnswer& answer,
                     std::vector<std::string>& notes);

  const Lesson& lesson_;
  std::vector<PlacedAsk> questions_;
  std::map<std::string, std::size_t> number_of_;  ///< of a question, by its name
  AnswerCheck check_;
  std::vector<CollectedStudent> students_;
  struct Taken {
    std::size_t student = 0;
    FileTime written;
  };
  std::map<std::string, Taken> taken_;           ///< by comparable names; of reports without a name by files
  std::map<std::string, std::string> nameless_;  ///< files by the checksums of reports without a name
  bool has_false_rights_ = false;
};

/// A row for each student: name, file, how many questions are right, answered and asked; and of each question
/// three columns: right, wrong or not answered, and the tries and hints that the report says.
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
/// @, or one of these in full width, behind whatever cannot be seen, gets an apostrophe before it, which
/// spreadsheets take for "a text".
std::string csv_cell(const std::string& text);

}  // namespace polhode
