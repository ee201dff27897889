// SPDX-License-Identifier: MIT
// polhode lint: what is wrong with lessons, and where.
#include "app/commands.h"
#include "app/lesson_lookup.h"
#include "app/message.h"
#include "app/or_fail.h"
#include "app/page_lint.h"
#include "lessons/claim_check.h"
#include "lessons/type_check.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

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
std::vector<Diagnostic> type_and_page_diagnostics(const Lesson& lesson, std::string_view file) {
  const Fonts fonts = or_fail(Fonts::open());
  std::vector<Diagnostic> found = check_type(lesson, fonts, file);
  return found.empty() ? page_diagnostics(lesson, fonts, file) : found;
}

/// One file; a file that cannot be read is a message on stderr, and the others are still looked at.
void lint_one(const std::string& name, Findings& findings) {
  try {
    const auto path = find_lesson(name, lesson_folders());
    LessonReading reading = check_lesson(read_lesson_text(path), path.string());
    if (reading.lesson) {
      add_in_order(check_claims(*reading.lesson, path.string()), reading.diagnostics);
      add_in_order(type_and_page_diagnostics(*reading.lesson, path.string()), reading.diagnostics);
    }
    for (Diagnostic& diagnostic : reading.diagnostics) findings.diagnostics.push_back(std::move(diagnostic));
  } catch (const CommandError& error) {
    if (error.code != ExitCode::failed) throw;
    say("polhode: {}\n", error.what());
    findings.all_read = false;
  }
}

void print(const std::vector<Diagnostic>& diagnostics, bool json) {
  if (!json) {
    for (const Diagnostic& diagnostic : diagnostics) fmt::print("{}\n", to_string(diagnostic));
    return;
  }
  Json list = Json::array();
  for (const Diagnostic& diagnostic : diagnostics) list.push_back(to_json(diagnostic));
  fmt::print("{}\n", list.dump(2, ' ', false, Json::error_handler_t::replace));
}

ExitCode lint(const std::vector<std::string>& names, bool json) {
  Findings findings;
  for (const std::string& name : names) lint_one(name, findings);
  print(findings.diagnostics, json);

  const auto errors = std::count_if(findings.diagnostics.begin(), findings.diagnostics.end(),
                                    [](const Diagnostic& d) { return d.severity == Severity::error; });
  const auto warnings = static_cast<long>(findings.diagnostics.size()) - errors;
  say("{} error{}, {} warning{}\n", errors, errors == 1 ? "" : "s", warnings, warnings == 1 ? "" : "s");
  if (!findings.all_read) return ExitCode::failed;
  return errors > 0 ? ExitCode::invalid : ExitCode::done;
}

}  // namespace

void add_lint(CLI::App& app, Action& action) {
  struct Options {
    std::vector<std::string> files;
    bool json = false;
  };
  CLI::App* command =
      app.add_subcommand("lint", "Check lessons, prove claims; print file:line:column: error|warning: ...");
  auto options = std::make_shared<Options>();
  command->add_option("FILE", options->files, "Lesson files or ids")->required()->option_text("...");
  command->add_flag("--json", options->json, "file, line, column, severity, message and hint as JSON");
  command->footer("Exit code 3 if there is an error; warnings alone give 0.");
  command->callback(
      [options, &action] { action = [options] { return lint(options->files, options->json); }; });
}

}  // namespace polhode
