// SPDX-License-Identifier: MIT
#include "app/session/answers/answer_report.h"

#include "app/export/picture_metadata.h"
#include "app/narration/speech_text.h"
#include "app/session/answers/answer_check.h"
#include "app/session/answers/progress.h"
#include "app/session/answers/student_name.h"
#include "base/printable.h"
#include "base/sha256.h"
#include "base/utf8.h"
#include "lessons/claims/answers/reason_tags.h"
#include "lessons/diagnostics/source_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <stdexcept>

namespace polhode {

namespace {

constexpr std::string_view kFirstLine = "Answers to a lesson of polhode, format 1";
constexpr std::string_view kFirstWords = "Answers to a lesson of polhode, format ";
constexpr std::string_view kRight = "right", kWrong = "not right", kOpen = "not answered";
constexpr std::string_view kAnswer = "  answer: ", kReasons = "  reasons: ", kChecksum = "Checksum: ";
constexpr std::size_t kDigits = 16;

std::string short_hash(std::string_view text) { return sha256_hex(text).substr(0, kDigits); }

bool is_hash(std::string_view text) {
  return text.size() == kDigits && text.find_first_not_of("0123456789abcdef") == text.npos;
}

/// The lines as they were written, whatever became of their ends; at most one more than a report may have.
std::vector<std::string_view> lines_of(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() <= kMaxReportLines) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// Of the lines from `begin` to before `end`.
std::string checksum_of(const std::vector<std::string_view>& lines, std::size_t begin, std::size_t end) {
  std::string text;
  for (std::size_t i = begin; i < end; ++i) text.append(lines[i]) += '\n';
  return short_hash(text);
}

// Writing.

/// What was typed, as the report has it: each line without blanks around it. So it is read, and judged,
/// again.
std::string as_reported(std::string_view typed) {
  std::string text;
  while (!typed.empty()) {
    const std::size_t end = std::min(typed.find('\n'), typed.size());
    std::string line(trimmed(typed.substr(0, end)));
    std::replace(line.begin(), line.end(), '\t', ' ');
    if (!line.empty()) text += (text.empty() ? "" : "\n") + printable_line(line);
    typed.remove_prefix(std::min(end + 1, typed.size()));
  }
  return text;
}

std::string words_of(const ReportedAnswer& answer) {
  const std::string_view state = answer.right ? kRight : answer.tries > 0 ? kWrong : kOpen;
  std::string text = fmt::format("  {}, tries {}, hints {}\n", state, answer.tries, answer.hints);
  for (std::string_view rest = answer.answer; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    text += fmt::format("{}{}\n", kAnswer, rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  if (answer.reasons.empty()) return text;
  std::string reasons;
  for (const auto& [tag, count] : answer.reasons)
    reasons += fmt::format("{}{} {}", reasons.empty() ? "" : ", ", tag, count);
  return text + fmt::format("{}{}\n", kReasons, reasons);
}

ReportedAnswer reported(const PlacedAsk& question, const AnswerLog& answers, AnswerCheck& check) {
  ReportedAnswer reported{question.name, false, 0, 0, "", {}};
  const auto found = answers.find(question.name);
  if (found == answers.end()) return reported;
  const AnswerRecord& record = found->second;
  reported.tries = record.tries;
  reported.hints = record.hints;
  if (record.tries == 0) return reported;
  const std::string accepted = as_reported(record.accepted);
  reported.right = record.right > 0 && !accepted.empty() && check.is_right(*question.ask, accepted);
  reported.answer = reported.right ? accepted : as_reported(record.last);
  reported.reasons = record.wrong;
  return reported;
}

// Reading.

/// A line that is not as it should be. Thrown and caught here.
struct ReportFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class ReportReader {
 public:
  explicit ReportReader(std::string_view text) : lines_(lines_of(text)) {}

  AnswerReport read() {
    if (lines_.size() > kMaxReportLines)
      throw ReportFault(fmt::format("too long for a report: it has more than {} lines", kMaxReportLines));
    while (at_ < lines_.size() && lines_[at_].empty()) ++at_;
    if (at_ == lines_.size() || !lines_[at_].starts_with(kFirstWords))
      throw ReportFault("no report of polhode: it does not begin with \"" + std::string(kFirstWords) + "…\"");
    if (lines_[at_] != kFirstLine) fail("a report of another format, which this version does not read");
    begin_ = at_++;
    check_the_sum();
    report_.lesson_id = value_of("Lesson: ");
    report_.version = value_of("Version: ");
    if (!is_hash(report_.version)) fail("no version of a lesson", at_ - 1);
    report_.program = value_of("Program: ");
    if (at_ < end_ && lines_[at_].starts_with("Name: ")) {
      report_.student = value_of("Name: ");
      if (const std::string fault = fault_of_name(report_.student); !fault.empty()) fail(fault, at_ - 1);
    }
    while (at_ < end_) line();
    close_answer();
    return std::move(report_);
  }

 private:
  [[noreturn]] void fail(const std::string& what, std::optional<std::size_t> line = {}) const {
    throw ReportFault(fmt::format("line {}: {}", line.value_or(at_) + 1, what));
  }

  void check_the_sum() {
    end_ = begin_;
    while (end_ < lines_.size() && !lines_[end_].starts_with(kChecksum)) ++end_;
    if (end_ == lines_.size()) throw ReportFault("the end of the file, with its checksum, is missing");
    report_.checksum = lines_[end_].substr(kChecksum.size());
    if (report_.checksum != checksum_of(lines_, begin_, end_))
      throw ReportFault("the file was changed after it was saved");
    for (std::size_t i = end_; i < lines_.size(); ++i)
      if (lines_[i].starts_with(kFirstWords)) fail("a second report begins: each has a file of its own", i);
  }

  std::string value_of(std::string_view key) {
    if (at_ == end_ || !lines_[at_].starts_with(key)) fail(fmt::format("\"{}…\" is expected", key));
    return std::string(lines_[at_++].substr(key.size()));
  }

  void line() {
    const std::string_view text = lines_[at_];
    const bool is_for_people =
        text.empty() || (!is_open_ && (text.starts_with("Title: ") || text.starts_with("Right: ") ||
                                       text.starts_with("Outcome ")));
    if (is_for_people && !text.empty()) report_.head.append(text) += '\n';
    if (!is_for_people) {
      if (text.starts_with(' '))
        of_answer(text);
      else
        question(text);
    }
    ++at_;
  }

  void question(std::string_view text) {
    close_answer();
    const std::size_t colon = text.find(": ");
    const std::string_view name = text.substr(0, colon);
    if (colon == text.npos || name.find('/') == name.npos || name.find(' ') != name.npos)
      fail("the beginning of a question, \"stage/question: …\", is expected");
    if (!names_.insert(std::string(name)).second) fail(fmt::format("question {} twice", name));
    report_.answers.push_back({std::string(name), false, 0, 0, "", {}});
    is_open_ = true;
    has_state_ = has_reasons_ = is_answered_ = false;
  }

  void of_answer(std::string_view text) {
    if (!is_open_) fail("a question is expected before its answer");
    ReportedAnswer& answer = report_.answers.back();
    if (!has_state_) return state(text, answer);
    if (text.starts_with(kAnswer) && !has_reasons_) {
      if (!is_answered_) fail("an answer to what is not answered");
      answer.answer += (answer.answer.empty() ? "" : "\n") + std::string(text.substr(kAnswer.size()));
    } else if (text.starts_with(kReasons) && !has_reasons_) {
      if (!is_answered_) fail("reasons of what is not answered");
      reasons(text.substr(kReasons.size()), answer);
    } else {
      fail("\"answer: …\" or \"reasons: …\" is expected");
    }
  }

  void state(std::string_view text, ReportedAnswer& answer) {
    text.remove_prefix(std::min<std::size_t>(2, text.size()));
    const std::size_t comma = text.find(", ");
    const std::string_view state = text.substr(0, comma);
    if (comma == text.npos || (state != kRight && state != kWrong && state != kOpen))
      fail("\"right\", \"not right\" or \"not answered\" is expected, with tries and hints");
    text.remove_prefix(comma + 2);
    const std::size_t hints = text.find(", ");
    if (hints == text.npos) fail("tries and hints are expected");
    answer.tries = count_behind("tries ", text.substr(0, hints));
    answer.hints = count_behind("hints ", text.substr(hints + 2));
    answer.right = state == kRight;
    is_answered_ = state != kOpen;
    if (is_answered_ != (answer.tries > 0)) fail("what was tried is answered, and nothing else");
    has_state_ = true;
  }

  void reasons(std::string_view text, ReportedAnswer& answer) {
    has_reasons_ = true;
    while (!text.empty()) {
      const std::size_t end = std::min(text.find(", "), text.size());
      const std::string_view one = text.substr(0, end);
      const std::size_t blank = std::min(one.find(' '), one.size());
      const std::string_view tag = one.substr(0, blank);
      if (!is_reason_tag(tag)) fail("reasons are words with their numbers, \"sign 2, index 1\"");
      const int count = count_behind(" ", one.substr(blank));
      if (!answer.reasons.emplace(tag, count).second) fail(fmt::format("reason {} twice", tag));
      text.remove_prefix(std::min(end + 2, text.size()));
    }
  }

  int count_behind(std::string_view word, std::string_view text) const {
    constexpr int kMost = 1'000'000;
    int count = -1;
    const bool has_word = text.starts_with(word);
    if (has_word) text.remove_prefix(word.size());
    const auto read = std::from_chars(text.data(), text.data() + text.size(), count);
    if (!has_word || read.ec != std::errc() || read.ptr != text.data() + text.size() || count < 0 ||
        count > kMost)
      fail(fmt::format("a whole number is expected behind \"{}\"", word));
    return count;
  }

  /// What is said of an answer is all there.
  void close_answer() {
    if (is_open_ && !has_state_) fail("what became of the question above is missing");
    if (is_open_ && report_.answers.back().right && report_.answers.back().answer.empty())
      fail("the right answer to the question above is missing");
  }

  std::vector<std::string_view> lines_;
  std::size_t begin_ = 0, at_ = 0, end_ = 0;
  AnswerReport report_;
  std::set<std::string> names_;
  bool is_open_ = false, has_state_ = false, has_reasons_ = false, is_answered_ = false;
};

}  // namespace

std::string version_of(const Lesson& lesson) { return short_hash(lesson.source); }

std::string head_of_report(const Lesson& lesson, const AnswerLog& judged) {
  const Progress progress = progress_of(lesson, judged);
  std::string text =
      fmt::format("Title: {}\nRight: {}\n", printable_line(lesson.title), words_of(progress.all));
  for (std::size_t i = 0; i < progress.outcomes.size(); ++i)
    if (progress.outcomes[i].asked > 0)
      text += fmt::format("Outcome {}: {}: {}\n", i + 1, words_of(progress.outcomes[i]),
                          printable_line(lesson.about.outcomes[i]));
  return text;
}

Result<std::string> answer_report(const Lesson& lesson, const AnswerLog& answers, const std::string& name) {
  const std::string student = trimmed_name(name);
  if (std::string fault = fault_of_name(student); !fault.empty()) return failure(std::move(fault));
  std::string text = fmt::format("{}\nLesson: {}\nVersion: {}\nProgram: {}\n", kFirstLine, lesson.id,
                                 version_of(lesson), program_name_and_version());
  if (!student.empty()) text += fmt::format("Name: {}\n", student);
  AnswerCheck check(lesson);
  AnswerLog judged;
  std::string questions;
  const SpeechText speech(lesson);
  for (const PlacedAsk& question : questions_of(lesson)) {
    // What leads where in a derivation stands in its lines.
    const std::string prompt = printable_line(speech.words(question.ask->prompt_text.front()));
    const ReportedAnswer answer = reported(question, answers, check);
    if (answer.tries > 0) judged[question.name] = {answer.right ? 1 : 0, answer.tries, 0, ""};
    questions += fmt::format("\n{}: {}\n{}", question.name, prompt.empty() ? "…" : prompt, words_of(answer));
  }
  text += head_of_report(lesson, judged) + questions + '\n';
  const std::vector<std::string_view> lines = lines_of(text);
  return text + fmt::format(
                    "{}{}\n"
                    "It shows whether the text above has arrived as it was written. It is no signature: "
                    "anybody can compute it.\n",
                    kChecksum, checksum_of(lines, 0, lines.size()));
}

Result<AnswerReport> read_answer_report(std::string_view text) {
  if (text.size() > kMaxReportBytes)
    return failure(fmt::format("too long for a report: it has more than {} MiB", kMaxReportBytes >> 20U));
  try {
    return ReportReader(text).read();
  } catch (const ReportFault& fault) {
    return failure(fault.what());
  }
}

}  // namespace polhode
