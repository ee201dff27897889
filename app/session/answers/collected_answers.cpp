// SPDX-License-Identifier: MIT
#include "app/session/answers/collected_answers.h"

#include "app/session/answers/derivation_work.h"
#include "app/session/answers/student_name.h"
#include "base/printable.h"
#include "base/utf8.h"
#include "lessons/claims/answers/reason_tags.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace polhode {

namespace {

using State = CollectedAnswer::State;

std::string_view word_of(State state) {
  return state == State::right ? "right" : state == State::wrong ? "wrong" : "not answered";
}

std::string number_cell(State state, int number) {
  return state == State::open && number == 0 ? "" : std::to_string(number);
}

}  // namespace

int CollectedStudent::count(State state) const {
  return static_cast<int>(
      std::count_if(answers.begin(), answers.end(),
                    [state](const CollectedAnswer& answer) { return answer.state == state; }));
}

CollectedAnswers::CollectedAnswers(const Lesson& lesson)
    : lesson_(lesson), questions_(questions_of(lesson)), check_(lesson) {
  for (std::size_t i = 0; i < questions_.size(); ++i) number_of_[questions_[i].name] = i;
}

Result<std::string> CollectedAnswers::add(const std::string& file, const AnswerReport& report,
                                          FileTime written) {
  if (report.lesson_id != lesson_.id)
    return failure(fmt::format("a report of the lesson {}, not of {}", report.lesson_id, lesson_.id));
  if (const std::string version = version_of(lesson_); report.version != version)
    return failure(
        fmt::format("a report of another version of the lesson: {}, here it is {}", report.version, version));
  CollectedStudent student{report.student, printable_line(file),
                           std::vector<CollectedAnswer>(questions_.size()), !report.student.empty()};
  const auto known =
      taken_.find(student.is_named ? "n" + comparable_name(report.student) : "f" + student.file);
  if (known != taken_.end() && written < known->second.written)
    return failure(fmt::format("an older report of {} than {}",
                               report.student.empty() ? "it" : report.student,
                               students_[known->second.student].file));
  std::vector<std::string> notes;
  bool has_false_rights = false;
  for (const ReportedAnswer& reported : report.answers) {
    const auto number = number_of_.find(reported.name);
    if (number == number_of_.end())
      return failure(fmt::format("damaged: the lesson has no question {}", reported.name));
    const Ask& ask = *questions_[number->second].ask;
    CollectedAnswer& answer = student.answers[number->second];
    answer = {reported.tries > 0 ? State::wrong : State::open, reported.tries, reported.hints,
              reported.reasons};
    const bool is_right = reported.right && check_.is_right(ask, reported.answer);
    const std::size_t notes_before = notes.size();
    check_numbers(ask, reported, answer, notes);
    has_false_rights = has_false_rights || notes.size() > notes_before;
    if (answer.state == State::wrong && !is_right)
      if (const std::string reason = check_.reason(ask, reported.answer);
          !reason.empty() && reason != kOtherReason)
        answer.reasons.try_emplace(reason, 1);
    if (!reported.right) continue;
    if (is_right) {
      answer.state = State::right;
    } else {
      has_false_rights = true;
      notes.push_back(fmt::format("{} is said to be right, and its answer is not", reported.name));
    }
  }
  AnswerLog judged;
  for (std::size_t i = 0; i < questions_.size(); ++i)
    if (student.answers[i].state != State::open)
      judged[questions_[i].name].tries = 1,
      judged[questions_[i].name].right = student.answers[i].state == State::right ? 1 : 0;
  if (report.head != head_of_report(lesson_, judged)) {
    has_false_rights = true;
    notes.emplace_back(fmt::format("its first lines say otherwise than its answers; they are not believed"));
  }
  if (report.student.empty())
    if (const auto [same, is_new] = nameless_.emplace(report.checksum, student.file); !is_new)
      notes.push_back(fmt::format("the same as {}, to the letter, and neither has a name", same->second));
  has_false_rights_ = has_false_rights_ || has_false_rights;
  if (known != taken_.end()) {
    CollectedStudent& older = students_[known->second.student];
    notes.insert(notes.begin(), fmt::format("the newest report of {}: {} is skipped",
                                            student.is_named ? student.name : "this file", older.file));
    known->second.written = written;
    if (!student.is_named) student.name = older.name;
    older = std::move(student);
  } else {
    taken_[student.is_named ? "n" + comparable_name(report.student) : "f" + student.file] = {students_.size(),
                                                                                             written};
    give_name(student);
    students_.push_back(std::move(student));
  }
  std::string told;
  for (const std::string& note : notes) told += (told.empty() ? "" : "; ") + note;
  return told;
}

/// Of what was tried before the last answer nothing is left but numbers. Those that cannot be are left out.
void CollectedAnswers::check_numbers(const Ask& ask, const ReportedAnswer& reported, CollectedAnswer& answer,
                                     std::vector<std::string>& notes) {
  const auto note = [&](std::string what) { notes.push_back(reported.name + ": " + std::move(what)); };
  const auto is_possible = [&](const std::string& tag) {
    if (!is_known_reason(tag, ask.choices.size())) return false;
    if (picks_choice(ask.type))
      return tag.starts_with("choice-") &&
             tag.back() != letter_of_choice(static_cast<std::size_t>(ask.answers[0] - 1));
    return tag.starts_with("place-") == (ask.type == Ask::Type::order) && !tag.starts_with("choice-");
  };
  int errors = 0;
  for (const auto& [tag, count] : reported.reasons) {
    if (is_possible(tag)) {
      errors += count;
      continue;
    }
    answer.reasons.erase(tag);
    note(fmt::format("there is no reason \"{}\"; it is left out", tag));
  }
  const int wrong_tries = reported.tries - (reported.right ? 1 : 0);
  if (!ask.derivation && errors > wrong_tries) {  // a derivation has several lines to a try
    answer.reasons.clear();
    note(fmt::format("{} reasons of {} wrong tries; they are left out", errors, wrong_tries));
  }
  const auto most = ask.derivation ? std::size_t{DerivationWork::kMostHints} : ask.hints.size() + 1;
  if (reported.hints > static_cast<int>(most)) {
    answer.hints = 0;
    note(fmt::format("{} hints, and there are {}; they are left out", reported.hints, most));
  }
}

/// Of two that would be called alike the one without a name of its own gets that of its file.
void CollectedAnswers::give_name(CollectedStudent& student) {
  if (!student.is_named) student.name = printable_line(std::filesystem::path(student.file).stem().string());
  const auto same = std::find_if(students_.begin(), students_.end(), [&](const CollectedStudent& other) {
    return comparable_name(other.name) == comparable_name(student.name);
  });
  if (same == students_.end()) return;
  if (!student.is_named)
    student.name = student.file;
  else if (!same->is_named)
    same->name = same->file;
}

std::string csv_cell(const std::string& text) {
  const std::u32string characters = code_points(text);
  const auto first = std::find_if_not(characters.begin(), characters.end(), is_unseen);
  const bool computes = first != characters.end() &&
                        std::u32string_view(U"=+-@＝＋－＠").find(*first) != std::u32string_view::npos;
  const std::string plain = (computes ? "'" : "") + text;
  if (plain.find_first_of(",\"\r\n\t;") == plain.npos &&
      plain == plain.substr(0, plain.find_last_not_of(' ') + 1))
    return plain;
  std::string quoted = "\"";
  for (const char c : plain) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string csv_of(const CollectedAnswers& collected) {
  std::string csv = "student,file,right,answered,asked";
  for (const PlacedAsk& question : collected.questions())
    csv += fmt::format(",{0},{0} tries as reported,{0} hints as reported", question.name);
  csv += '\n';
  for (const CollectedStudent& student : collected.students()) {
    const int right = student.count(State::right), wrong = student.count(State::wrong);
    csv += fmt::format("{},{},{},{},{}", csv_cell(student.name), csv_cell(student.file), right, right + wrong,
                       collected.questions().size());
    for (const CollectedAnswer& answer : student.answers)
      csv += fmt::format(",{},{},{}", word_of(answer.state), number_cell(answer.state, answer.tries),
                         number_cell(answer.state, answer.hints));
    csv += '\n';
  }
  return csv;
}

int students_with(const CollectedAnswers& collected, std::size_t question, State state) {
  const auto& students = collected.students();
  return static_cast<int>(std::count_if(
      students.begin(), students.end(),
      [&](const CollectedStudent& student) { return student.answers[question].state == state; }));
}

std::vector<ReasonCount> reasons_of(const CollectedAnswers& collected, std::size_t question) {
  std::map<std::string, int> counts;
  for (const CollectedStudent& student : collected.students())
    for (const auto& [tag, count] : student.answers[question].reasons)
      if (count > 0) ++counts[tag];
  std::vector<ReasonCount> reasons;
  for (const auto& [tag, students] : counts) reasons.push_back({tag, students});
  std::stable_sort(reasons.begin(), reasons.end(),
                   [](const ReasonCount& a, const ReasonCount& b) { return a.students > b.students; });
  return reasons;
}

std::string csv_of_reasons(const CollectedAnswers& collected) {
  std::string csv = "question,reason,in words,students,answered\n";
  for (std::size_t i = 0; i < collected.questions().size(); ++i) {
    const int answered =
        students_with(collected, i, State::right) + students_with(collected, i, State::wrong);
    for (const ReasonCount& reason : reasons_of(collected, i))
      csv += fmt::format("{},{},{},{},{}\n", csv_cell(collected.questions()[i].name), reason.tag,
                         csv_cell(words_of_reason(reason.tag)), reason.students, answered);
  }
  return csv;
}

}  // namespace polhode
