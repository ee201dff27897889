// SPDX-License-Identifier: MIT
// polhode lint: what is wrong with lessons, and where.
#include "app/cli/commands/commands.h"
#include "app/cli/lesson_lookup.h"
#include "app/cli/message.h"
#include "app/cli/or_fail.h"
#include "app/page/page_lint.h"
#include "base/printable.h"
#include "base/spelling.h"
#include "lessons/reader/checks/claim_check.h"
#include "lessons/reader/checks/lesson_check.h"
#include "lessons/reader/checks/lint_budget.h"
#include "lessons/reader/checks/question_check.h"
#include "lessons/reader/checks/translation_check.h"
#include "lessons/reader/checks/type_check.h"
#include "lessons/reader/scene/scene_keys.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Diagnostic& diagnostic) {
  return {{"file", diagnostic.file},
          {"line", diagnostic.place.line},
          {"column", diagnostic.place.column},
          {"severity", diagnostic.severity == Severity::error ? "error" : "warning"},
          {"message", diagnostic.message},
          {"hint", diagnostic.hint}};
}

struct Findings {
  std::vector<Diagnostic> diagnostics;
  bool all_read = true;
};

/// Of a lesson that reads: what the fonts lack, and if they lack nothing, what does not fit on a page.
std::vector<Diagnostic> type_and_page_diagnostics(const Lesson& lesson, std::string_view file,
                                                  const Effort& effort) {
  const Fonts fonts = or_fail(Fonts::open());
  std::vector<Diagnostic> found = check_type(lesson, fonts, file);
  return found.empty() ? page_diagnostics(lesson, fonts, file, effort) : found;
}

Diagnostic failed_check(const std::string& file, const std::exception& error) {
  return {Severity::error, file, {1, 1}, fmt::format("the lesson cannot be checked: {}", error.what()), ""};
}

/// What a lesson says of others is held against these, where they are beside it or in a folder of lessons.
class OtherLessons {
 public:
  explicit OtherLessons(const std::filesystem::path& file) : folders_(lesson_folders()) {
    folders_.insert(folders_.begin(), file.has_parent_path() ? file.parent_path() : ".");
  }

  std::vector<Diagnostic> check(const Lesson& lesson, const std::string& file) {
    std::vector<Diagnostic> found;
    for (const OutsideReference& reference : lesson.other_lessons)
      if (auto diagnostic = check(reference)) {
        diagnostic->file = file;
        diagnostic->place = reference.place;
        found.push_back(std::move(*diagnostic));
      }
    return found;
  }

 private:
  std::optional<Diagnostic> check(const OutsideReference& reference) {
    const auto unchecked = [](std::string why) {
      return Diagnostic{Severity::warning, "", {}, std::move(why), "so what refers to it is not checked"};
    };
    auto known = read_.find(reference.lesson);
    if (known == read_.end()) known = read_.emplace(reference.lesson, read(reference.lesson)).first;
    const Result<Lesson>& lesson = known->second;
    if (!lesson) return unchecked(lesson.error());
    const Result<const Stage*> stage = lesson->stage_named(reference.stage);
    if (reference.stage.empty()) return std::nullopt;
    if (!stage) return Diagnostic{Severity::error, "", {}, stage.error(), ""};
    if (reference.equation.empty()) return std::nullopt;
    std::vector<std::string> equations;
    for (const Equation* equation : equations_of(**stage)) equations.push_back(equation->id);
    if (std::find(equations.begin(), equations.end(), reference.equation) != equations.end())
      return std::nullopt;
    return Diagnostic{Severity::error,
                      "",
                      {},
                      fmt::format("stage \"{}\" of lesson \"{}\" has no equation \"{}\"", reference.stage,
                                  reference.lesson, reference.equation),
                      suggestion(reference.equation, equations)};
  }

  Result<Lesson> read(const std::string& id) const {
    for (const std::filesystem::path& folder : folders_) {
      const auto text = read_lesson_text(folder / (id + ".md"));
      if (!text) continue;
      LessonReading reading = read_lesson(*text, id + ".md");
      if (!reading.lesson) return failure(fmt::format("lesson \"{}\" has errors itself", id));
      return std::move(*reading.lesson);
    }
    std::vector<std::string> known;
    for (const FoundLesson& lesson : lessons_in(folders_)) known.push_back(lesson.id);
    return failure(fmt::format("no lesson \"{}\" is beside this one{}", id, did_you_mean(id, known)));
  }

  std::vector<std::filesystem::path> folders_;
  std::map<std::string, Result<Lesson>> read_;
};

/// Of a lesson in another language: where it differs from its original in more than words.
std::vector<Diagnostic> translation_diagnostics(const Lesson& lesson, const std::string& file) {
  const auto said = [&](Severity severity, std::string message, std::string hint) {
    return std::vector{Diagnostic{severity, file, {1, 1}, std::move(message), std::move(hint)}};
  };
  const std::string original = original_of(file);
  const std::string tag(tag_of(lesson.about.language));
  if (original.empty()) {
    if (lesson.about.language == Language::en) return {};
    return said(Severity::warning,
                "what the sentences of this lesson say is not checked: they are read in English alone",
                "call it NAME." + tag + ".md, beside NAME.md in English, which it is then held against");
  }
  if (!file.ends_with('.' + tag + ".md"))
    return said(Severity::error,
                "the name of this file is that of another language than the lesson's, \"" + tag + '"',
                "write language = \"…\" in the front matter, or give the file another name");
  const auto text = read_lesson_text(original);
  if (!text)
    return said(Severity::error, "the lesson that this one translates is missing: " + original,
                "a translation is held against its original, which stands beside it");
  LessonReading reading = read_lesson(*text, original);
  if (!reading.lesson)
    return said(Severity::error, "the lesson that this one translates has errors: " + original,
                "mend them first");
  return check_translation(lesson, file, *reading.lesson, original);
}

/// All that is wrong with a text, for no more than kLintBudget.
std::vector<Diagnostic> diagnostics_of(std::string_view text, const std::string& file) {
  Budget budget(kLintBudget);
  LessonReading reading = check_lesson(text, file, budget.effort());
  if (!reading.lesson) return std::move(reading.diagnostics);
  add_in_order(OtherLessons(file).check(*reading.lesson, file), reading.diagnostics);
  add_in_order(translation_diagnostics(*reading.lesson, file), reading.diagnostics);
  try {
    add_in_order(check_claims(*reading.lesson, file, budget.effort()), reading.diagnostics);
    if (!budget.is_spent())
      add_in_order(check_questions(*reading.lesson, file, budget.effort()), reading.diagnostics);
    if (!budget.is_spent())
      add_in_order(type_and_page_diagnostics(*reading.lesson, file, budget.effort()), reading.diagnostics);
  } catch (const std::domain_error& error) {  // that no check has given a place
    add_in_order({failed_check(file, error)}, reading.diagnostics);
  }
  return std::move(reading.diagnostics);
}

/// One file; a file that cannot be read is a message on stderr, and the others are still looked at.
void lint_one(const std::string& name, Findings& findings) {
  const auto path = or_fail(find_lesson(name, lesson_folders()));
  const auto text = read_lesson_text(path);
  if (!text) {
    say("polhode: {}\n", text.error().text);
    findings.all_read = false;
    return;
  }
  for (Diagnostic& diagnostic : diagnostics_of(*text, path.string()))
    findings.diagnostics.push_back(std::move(diagnostic));
}

void print(const std::vector<Diagnostic>& diagnostics, bool json) {
  if (!json) {
    for (const Diagnostic& diagnostic : diagnostics) fmt::print("{}\n", to_string(diagnostic));
    return;
  }
  Json list = Json::array();
  for (const Diagnostic& diagnostic : diagnostics) list.push_back(to_json(diagnostic));
  fmt::print("{}\n", printable(list.dump(2, ' ', false, Json::error_handler_t::replace)));
}

/// The scene of a step with every key it has. A lesson that cannot be read is told as `lint` tells it.
ExitCode explain(const std::vector<std::string>& names, const std::string& stage_and_step) {
  if (names.size() != 1) throw usage("--explain is of one FILE");
  const LoadedLesson loaded = or_fail(load_lesson(names.front()));
  fmt::print("```scene\n{}```\n", printable(all_scene_keys_text(scene_of(loaded.lesson, stage_and_step))));
  return ExitCode::done;
}

ExitCode lint(const std::vector<std::string>& names, bool json) {
  Findings findings;
  try {
    for (const std::string& name : names) lint_one(name, findings);
  } catch (...) {
    print(findings.diagnostics, json);  // whatever it is: who reads JSON gets JSON
    throw;
  }
  print(findings.diagnostics, json);

  const auto errors = std::count_if(findings.diagnostics.begin(), findings.diagnostics.end(),
                                    [](const Diagnostic& d) { return d.severity == Severity::error; });
  const auto warnings = static_cast<long>(findings.diagnostics.size()) - errors;
  say("{} error{}, {} warning{}\n", errors, errors == 1 ? "" : "s", warnings, warnings == 1 ? "" : "s");
  if (!findings.all_read) return ExitCode::failed;
  return errors > 0 ? ExitCode::invalid : ExitCode::done;
}

}  // namespace

ProgramCommand lint_command() {
  struct Options {
    std::vector<std::string> files;
    std::string explain;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  return {
      "lint",
      "Check lessons, prove claims; print file:line:column: error|warning: ...",
      {{"FILE", &options->files, "Lesson files or ids", "...", true, offer_lessons()},
       {"--explain", &options->explain, "print the scene of a step, or the last of a stage, with every key",
        "STAGE[:STEP]"},
       {"--json", &options->json, "file, line, column, severity, message and hint as JSON"}},
      "Exit code 3 if there is an error; warnings alone give 0. A lesson that takes more than 100 million\n"
      "evaluations of the equations of motion to check, 5 to 10 s of one core, is an error too.\n"
      "--explain: the scene as a fence that can stand in the lesson. What a key leaves to others is\n"
      "filled in (weight and start as the torque, omega and attitude they stand for); what need not be\n"
      "said is marked \"default\".",
      [options](const CommandWords&) {
        if (options->explain.empty()) return lint(options->files, options->json);
        if (options->json) throw usage("--explain prints a fence, and no JSON");
        return explain(options->files, options->explain);
      }};
}

}  // namespace polhode
