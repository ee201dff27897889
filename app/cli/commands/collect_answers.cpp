// SPDX-License-Identifier: MIT
#include "app/cli/commands/collect_answers.h"

#include "app/cli/lesson_lookup.h"
#include "app/cli/message.h"
#include "app/cli/or_fail.h"
#include "app/narration/speech_text.h"
#include "app/session/answers/collected_answers.h"
#include "base/files/atomic_file.h"
#include "base/printable.h"
#include "lessons/claims/answers/reason_tags.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

namespace polhode {

namespace {

namespace fs = std::filesystem;
using State = CollectedAnswer::State;

struct ReadReport {
  std::string file;
  AnswerReport report;
  FileTime written;
};

struct FileText {
  std::string text;
  FileTime written;
};

/// At most one byte more than a report may have, which the reader refuses. Of regular files alone: a pipe or
/// a device may keep one waiting for ever.
Result<FileText> text_of_file(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  const auto cannot = [](const std::string& why) { return failure("cannot be read: " + why); };
  if (error || status.type() == fs::file_type::not_found)
    return cannot(std::strerror(error ? error.value() : ENOENT));
  if (status.type() == fs::file_type::directory) return cannot("it is a folder");
  if (status.type() != fs::file_type::regular) return cannot("it is no regular file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return cannot(std::strerror(errno));
  FileText read;
  std::string portion(std::size_t{1} << 16, '\0');
  while (read.text.size() <= kMaxReportBytes) {
    const std::size_t bytes = std::fread(portion.data(), 1, portion.size(), file.get());
    read.text.append(portion, 0, bytes);
    if (bytes < portion.size()) break;
  }
  if (std::ferror(file.get())) return cannot(std::strerror(errno));
  read.written = fs::last_write_time(path, error);
  return read;
}

void skip(const std::string& file, const std::string& why) {
  say("polhode: {}: {}: skipped\n", printable_line(file), printable_line(why));
}

std::vector<ReadReport> read_reports(const std::vector<std::string>& files) {
  std::vector<ReadReport> reports;
  for (const std::string& file : files) {
    const auto read = text_of_file(file);
    auto report = read ? read_answer_report(read->text) : Failure{read.error()};
    if (report)
      reports.push_back({file, std::move(*report), read->written});
    else
      skip(file, report.error());
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
  constexpr const char* kRow = "{:>5}  {:>9}  {:>12}  {}\n";
  std::string text = fmt::format(fmt::runtime(kRow), "right", "not right", "not answered", "student");
  for (const CollectedStudent& student : collected.students())
    text += fmt::format(fmt::runtime(kRow), student.count(State::right), student.count(State::wrong),
                        student.count(State::open), student.name);
  text += '\n' + fmt::format(fmt::runtime(kRow), "right", "not right", "not answered", "question");
  for (std::size_t i = 0; i < collected.questions().size(); ++i)
    text += fmt::format(fmt::runtime(kRow), students_with(collected, i, State::right),
                        students_with(collected, i, State::wrong), students_with(collected, i, State::open),
                        collected.questions()[i].name);
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
    const int open = students_with(collected, i, State::open);
    const PlacedAsk& question = collected.questions()[i];
    text += fmt::format("{}: {} of {} right{}\n", question.name, right, answered,
                        open == 0 ? "" : fmt::format(", {} not answered", open));
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
    const auto told = collected.add(one.file, one.report, one.written);
    if (!told)
      skip(one.file, told.error());
    else if (!told->empty())
      say("polhode: {}: {}\n", printable_line(one.file), printable_line(*told));
  }
  write(options.reasons ? (options.csv ? csv_of_reasons(collected) : printable(reasons_in_words(collected)))
        : options.csv   ? csv_of(collected)
                        : printable(table_of(collected)),
        options.output);
  const bool is_whole = collected.students().size() == options.files.size() && !collected.has_false_rights();
  return is_whole ? ExitCode::done : ExitCode::different;
}

}  // namespace polhode
