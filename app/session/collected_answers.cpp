// SPDX-License-Identifier: MIT
#include "app/session/collected_answers.h"

#include "lessons/claims/reason_tags.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace polhode {

namespace {

using State = CollectedAnswer::State;

std::string_view word_of(State state) {
  return state == State::right ? "right" : state == State::wrong ? "wrong" : "";
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

Result<std::string> CollectedAnswers::add(const std::string& file, const AnswerReport& report) {
  if (report.lesson_id != lesson_.id)
    return failure(fmt::format("a report of the lesson {}, not of {}", report.lesson_id, lesson_.id));
  if (const std::string version = version_of(lesson_); report.version != version)
    return failure(
        fmt::format("a report of another version of the lesson: {}, here it is {}", report.version, version));
  CollectedStudent student{report.student, file, std::vector<CollectedAnswer>(questions_.size())};
  if (student.name.empty()) student.name = std::filesystem::path(file).stem().string();
  if (const auto known = file_of_.find(student.name); known != file_of_.end())
    return failure(fmt::format("a second report of {}, whose first is {}", student.name, known->second));
  std::vector<std::string> notes;
  for (const ReportedAnswer& reported : report.answers) {
    const auto number = number_of_.find(reported.name);
    if (number == number_of_.end())
      return failure(fmt::format("damaged: the lesson has no question {}", reported.name));
    CollectedAnswer& answer = student.answers[number->second];
    answer = {reported.tries > 0 ? State::wrong : State::open, reported.tries, reported.hints,
              reported.reasons};
    if (!reported.right) continue;
    if (check_.is_right(*questions_[number->second].ask, reported.answer))
      answer.state = State::right;
    else
      notes.push_back(fmt::format("{} is said to be right, and its answer is not", reported.name));
  }
  if (report.student.empty())
    if (const auto [same, is_new] = nameless_.emplace(report.checksum, file); !is_new)
      notes.push_back(fmt::format("the same as {}, to the letter, and neither has a name", same->second));
  file_of_.emplace(student.name, file);
  students_.push_back(std::move(student));
  std::string told;
  for (const std::string& note : notes) told += (told.empty() ? "" : "; ") + note;
  return told;
}

std::string csv_cell(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool computes =
      first != text.npos && std::string_view("=+-@").find(text[first]) != std::string_view::npos;
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
    csv += fmt::format(",{0},{0} tries,{0} hints", question.name);
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
