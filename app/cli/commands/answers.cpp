// SPDX-License-Identifier: MIT
// polhode answers: what a learner has answered to all questions of a lesson, to be shown, forgotten or handed
// in; and what a class has.
#include "app/cli/commands/collect_answers.h"
#include "app/cli/commands/commands.h"
#include "app/cli/kept_answers.h"
#include "app/cli/lesson_lookup.h"
#include "app/cli/message.h"
#include "app/cli/or_fail.h"
#include "app/session/answers/answer_report.h"
#include "app/session/answers/progress.h"
#include "app/session/saved/answer_file.h"
#include "app/session/saved/state_file.h"
#include "base/files/atomic_file.h"
#include "base/printable.h"

#include <fmt/format.h>

#include <cstdio>

namespace polhode {

namespace {

struct Options {
  std::vector<std::string> words;
  std::string report, name, lesson, output;
  bool reset = false, csv = false, reasons = false;
};

AnswerLog kept_answers_of(const Lesson& lesson) {
  const auto folder = state_folder();
  if (!folder) throw CommandError(ExitCode::failed, "neither XDG_STATE_HOME nor HOME is set");
  auto reading = read_answer_log(answer_log_path(*folder, lesson.id));
  if (!reading) throw CommandError(ExitCode::failed, reading.error().text);
  if (!reading->warning.empty()) say("polhode: {}\n", reading->warning);
  return std::move(reading->log);
}

std::string times(int count, const char* one, const char* more) {
  return fmt::format("{} {}", count, count == 1 ? one : more);
}

std::string line_of(const PlacedAsk& question, const AnswerLog& answers) {
  const auto found = answers.find(question.name);
  if (found == answers.end()) return fmt::format("  {:<12}  {}\n", "not answered", question.name);
  const AnswerRecord& record = found->second;
  const char* state = record.right > 0 ? "right" : record.tries > 0 ? "not right" : "not answered";
  const std::string hints = record.hints == 0 ? "" : ", " + times(record.hints, "hint", "hints");
  return fmt::format("  {:<12}  {}: {}{}\n", state, question.name, times(record.tries, "try", "tries"),
                     hints);
}

ExitCode show(const Lesson& lesson) {
  const AnswerLog answers = kept_answers_of(lesson);
  const Progress progress = progress_of(lesson, answers);
  std::string text = fmt::format("{}: {}\n", lesson.id, words_of(progress.all));
  const auto add = [&](const QuestionCount& count, const std::string& of) {
    if (count.asked > 0) text += fmt::format("  {:>2} of {:<2}  {}\n", count.right, count.asked, of);
  };
  if (progress.tests_outcomes()) {
    text += "\nOutcomes\n";
    for (std::size_t i = 0; i < progress.outcomes.size(); ++i)
      add(progress.outcomes[i], lesson.about.outcomes[i]);
    add(progress.others, "(other questions)");
  }
  text += "\nQuestions\n";
  for (const PlacedAsk& question : questions_of(lesson)) text += line_of(question, answers);
  fmt::print("{}", printable(text));
  return ExitCode::done;
}

ExitCode reset(const Lesson& lesson) {
  std::size_t count = 0;
  or_fail(KeptAnswers(lesson.id, "").change([&](AnswerLog& log, const std::string&) {
    count = log.size();
    log.clear();
  }));
  fmt::print("{}: {} forgotten\n", lesson.id,
             times(static_cast<int>(count), "question was", "questions were"));
  return ExitCode::done;
}

ExitCode hand_in(const Lesson& lesson, const Options& options) {
  const std::string text = or_usage(answer_report(lesson, kept_answers_of(lesson), options.name));
  if (options.report == "-") {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return ExitCode::done;
  }
  or_fail(write_file_atomically(options.report,
                                {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
  return ExitCode::done;
}

ExitCode collect(const Options& options) {
  if (options.reset || !options.report.empty() || !options.name.empty())
    throw usage("collect takes --csv, --reasons, --lesson and -o alone");
  return collect_answers({{options.words.begin() + 1, options.words.end()},
                          options.lesson,
                          options.output,
                          options.csv,
                          options.reasons});
}

ExitCode answers(const Options& options) {
  if (options.words.front() == "collect") return collect(options);
  if (options.words.size() > 1)
    throw usage(fmt::format("unexpected argument \"{}\": one lesson is named, or collect and reports",
                            options.words[1]));
  if (options.csv || options.reasons || !options.lesson.empty() || !options.output.empty())
    throw usage("--csv, --reasons, --lesson and -o are of polhode answers collect");
  if (options.reset && !options.report.empty()) throw usage("give --report or --reset, not both");
  if (!options.name.empty() && options.report.empty()) throw usage("--name is of --report");
  const LoadedLesson loaded = or_fail(load_lesson(options.words.front()));
  if (options.reset) return reset(loaded.lesson);
  return options.report.empty() ? show(loaded.lesson) : hand_in(loaded.lesson, options);
}

}  // namespace

ProgramCommand answers_command() {
  const auto options = std::make_shared<Options>();
  return {
      "answers",
      "Show, forget or hand in answers to a lesson; collect those of a class",
      {{"LESSON", &options->words, "Lesson file or id; or collect, and the reports of a class",
        "LESSON | collect FILE...", true, offer_lessons({"collect"})},
       {"--report", &options->report, "Write a report to hand in; - is stdout", "FILE", false, offer_files()},
       {"--name", &options->name, "Your name in the report; without it there is none", "NAME"},
       {"--reset", &options->reset, "Forget all answers to the lesson, and their hints"},
       {"--csv", &options->csv, "collect: a table of students and questions, as CSV"},
       {"--reasons", &options->reasons, "collect: what was wrong, and how often, for each question"},
       {"--lesson", &options->lesson, "collect: the lesson, if it is not found by its id", "LESSON", false,
        offer_lessons()},
       {"-o,--output", &options->output, "collect: a file instead of stdout", "FILE", false, offer_files()}},
      "A report has answers, tries, hints and reasons, and a checksum that guards against accidents;\n"
      "it is no signature. collect judges what is called right again, with the lesson. Of a student\n"
      "with several reports the newest counts, by the time of its file. Each report that is skipped\n"
      "gets a line that says why. Exit code 4 if one was skipped, or called right what is not; else 0.",
      [options](const CommandWords&) { return answers(*options); }};
}

}  // namespace polhode
