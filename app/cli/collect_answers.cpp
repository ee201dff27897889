// SPDX-License-Identifier: MIT
#include "app/cli/collect_answers.h"

#include "app/cli/lesson_lookup.h"
#include "app/cli/message.h"
#include "app/cli/or_fail.h"
#include "app/narration/speech_text.h"
#include "app/session/collected_answers.h"
#include "base/files/atomic_file.h"
#include "base/printable.h"
#include "lessons/claims/reason_tags.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace polhode {

namespace {

using State = CollectedAnswer::State;

struct ReadReport {
  std::string file;
  AnswerReport report;
};

/// At most one byte more than a report may have, which the reader refuses.
Result<std::string> text_of_file(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return failure(fmt::format("cannot be read: {}", std::strerror(errno)));
  std::string text, portion(std::size_t{1} << 16, '\0');
  while (text.size() <= kMaxReportBytes) {
    const std::size_t read = std::fread(portion.data(), 1, portion.size(), file.get());
    text.append(portion, 0, read);
    if (read < portion.size()) break;
  }
  if (std::ferror(file.get())) return failure(fmt::format("cannot be read: {}", std::strerror(errno)));
  return text;
}

void pass_over(const std::string& file, const std::string& why) {
  say("polhode: {}: {}: passed over\n", printable_line(file), printable_line(why));
}

std::vector<ReadReport> read_reports(const std::vector<std::string>& files) {
  std::vector<ReadReport> reports;
  for (const std::string& file : files) {
    const auto text = text_of_file(file);
    auto report = text ? read_answer_report(*text) : Failure{text.error()};
    if (report)
      reports.push_back({file, std::move(*report)});
    else
      pass_over(file, report.error());
  }
  return reports;
}

/// The lesson of which there are most; of as many, that of the first report.
std::string lesson_of_most(const std::vector<ReadReport>& reports) {
  std::string most;
  std::ptrdiff_t count = 0;
  for (const ReadReport& one : reports) {
    const auto same = std::count_if(reports.begin(), reports.end(), [&](const ReadReport& other) {
      return other.report.lesson_id == one.report.lesson_id;
    });
    if (same > count) {
      most = one.report.lesson_id;
      count = same;
    }
  }
  return most;
}

std::string table_of(const CollectedAnswers& collected) {
  std::string text = "right  answered  student\n";
  for (const CollectedStudent& student : collected.students()) {
    const int right = student.count(State::right), wrong = student.count(State::wrong);
    text += fmt::format("{:5}  {:8}  {}\n", right, right + wrong, student.name);
  }
  text += "\nright  answered  question\n";
  for (std::size_t i = 0; i < collected.questions().size(); ++i) {
    const int right = students_with(collected, i, State::right);
    text += fmt::format("{:5}  {:8}  {}\n", right, right + students_with(collected, i, State::wrong),
                        collected.questions()[i].name);
  }
  return text;
}

/// `B was chosen ("It turns over.")`
std::string words_of(const ReasonCount& reason, const Ask& ask, const SpeechText& speech) {
  std::string words = words_of_reason(reason.tag);
  for (std::size_t i = 0; i < ask.choice_texts.size(); ++i)
    if (reason.tag == std::string("choice-") + letter_of_choice(i))
      words += fmt::format(" (\"{}\")", speech.words(ask.choice_texts[i]));
  return words;
}

std::string reasons_in_words(const CollectedAnswers& collected) {
  const SpeechText speech(collected.lesson());
  std::string text;
  for (std::size_t i = 0; i < collected.questions().size(); ++i) {
    const int right = students_with(collected, i, State::right);
    const int answered = right + students_with(collected, i, State::wrong);
    if (answered == 0) continue;
    const PlacedAsk& question = collected.questions()[i];
    text += fmt::format("{}: {} of {} right\n", question.name, right, answered);
    for (const ReasonCount& reason : reasons_of(collected, i))
      text +=
          fmt::format("  {} of {}: {}\n", reason.students, answered, words_of(reason, *question.ask, speech));
  }
  return text;
}

void write(const std::string& text, const std::string& output) {
  if (output.empty() || output == "-") {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return;
  }
  or_fail(write_file_atomically(output, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

}  // namespace

ExitCode collect_answers(const CollectOptions& options) {
  if (options.files.empty()) throw usage("name the reports: polhode answers collect FILE…");
  const std::vector<ReadReport> reports = read_reports(options.files);
  if (reports.empty()) throw CommandError(ExitCode::different, "no report could be read");
  const std::string name = options.lesson.empty() ? lesson_of_most(reports) : options.lesson;
  if (options.lesson.empty() && name.find_first_of("/.") != name.npos)
    throw usage(fmt::format("no lesson is called \"{}\"", name));
  const LoadedLesson loaded = or_fail(load_lesson(name));
  CollectedAnswers collected(loaded.lesson);
  for (const ReadReport& one : reports) {
    const auto told = collected.add(one.file, one.report);
    if (!told)
      pass_over(one.file, told.error());
    else if (!told->empty())
      say("polhode: {}: {}\n", printable_line(one.file), printable_line(*told));
  }
  write(options.reasons ? (options.csv ? csv_of_reasons(collected) : printable(reasons_in_words(collected)))
        : options.csv   ? csv_of(collected)
                        : printable(table_of(collected)),
        options.output);
  return collected.students().size() == options.files.size() ? ExitCode::done : ExitCode::different;
}

}  // namespace polhode
