// SPDX-License-Identifier: MIT
#include "app/cli/usage.h"

#include "app/cli/message.h"
#include "app/export/picture_metadata.h"
#include "base/spelling.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string>
#include <vector>

namespace polhode {

namespace {

/// The sub-command the line names, or the program.
const CLI::App& named_command(const CLI::App& app) {
  const auto named = app.get_subcommands();
  return named.empty() ? app : *named.front();
}

std::vector<std::string> known_words(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  for (const CLI::App* sub : command.get_subcommands(nullptr)) words.push_back(sub->get_name());
  return words;
}

std::string unexpected_word(const CLI::App& app, const CLI::App& command) {
  const std::vector<std::string> words = app.remaining(true);
  const std::string word = words.empty() ? "" : words.front();
  const bool option = word.starts_with('-');
  const std::string what = option             ? "unknown option"
                           : &command == &app ? "unknown command"
                                              : "unexpected argument";
  return fmt::format("{} \"{}\"{}", what, word,
                     did_you_mean(word.substr(0, word.find('=')), known_words(command)));
}

}  // namespace

void describe_program(CLI::App& app) {
  constexpr std::size_t kOptionColumns = 28;
  app.set_version_flag("--version", program_name_and_version(), "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.get_formatter()->column_width(kOptionColumns);
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.get_formatter()->label("Subcommands", "Commands");
  app.footer(
      "LESSON is an id, looked up in $POLHODE_LESSONS, ./lessons and PROGRAM/../share/polhode/lessons,\n"
      "or a file. Numbers may be decimal or hexadecimal (0x1.8p+1).\n"
      "Exit codes: 0 done, 1 failed while running, 2 usage, 3 lesson, body or state invalid,\n"
      "4 compared and different, a wrong answer, or an export not whole, 130 interrupted.\n"
      "See: polhode COMMAND --help");
}

ExitCode report(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    app.exit(error);
    return ExitCode::done;
  }
  const CLI::App& command = named_command(app);
  const bool unexpected = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  const std::string text = unexpected ? unexpected_word(app, command) : error.what();
  say("polhode: {}\nSee: polhode {}--help\n", text, &command == &app ? "" : command.get_name() + " ");
  return ExitCode::usage;
}

std::string refuse_empty(const std::string& value) { return value.empty() ? "the value is empty" : ""; }

}  // namespace polhode
