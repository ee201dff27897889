// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"

#include "app/cli/message.h"
#include "app/export/picture_metadata.h"
#include "base/spelling.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>

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

/// "Exit codes: 0 done, 1 ...", broken where a line would be longer than the help is wide.
std::string exit_codes_line() {
  constexpr std::size_t kHelpColumns = 100;
  std::string text, line = "Exit codes:";
  for (const auto& [code, meaning] : exit_meanings()) {
    const bool is_last = code == exit_meanings().back().code;
    const std::string item = fmt::format(" {} {}{}", static_cast<int>(code), meaning, is_last ? "." : ",");
    if (line.size() + item.size() > kHelpColumns) {
      text += line + "\n";
      line = item.substr(1);
    } else {
      line += item;
    }
  }
  return text + line + "\n";
}

/// Version flag and layout of the help, which the commands inherit.
void describe_program(CLI::App& app) {
  constexpr std::size_t kOptionColumns = 28;
  app.set_version_flag(kVersionFlag.names, program_name_and_version(), kVersionFlag.about);
  app.set_help_flag(kHelpFlag.names, kHelpFlag.about);
  app.get_formatter()->column_width(kOptionColumns);
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.get_formatter()->label("Subcommands", "Commands");
  app.footer(fmt::format("{}\n{}See: polhode COMMAND --help", kLessonAndNumbers, exit_codes_line()));
}

/// What is said to a line that is no command to run: help, the version, or what is wrong with it.
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

void add_option(CLI::App& app, const CommandOption& option) {
  CLI::Option* added = nullptr;
  if (bool* const* flag = std::get_if<bool*>(&option.target)) {
    app.add_flag(option.names, **flag, option.about);
    return;
  }
  if (std::string* const* text = std::get_if<std::string*>(&option.target)) {
    added = app.add_option(option.names, **text, option.about)->check(refuse_empty);
    if (!(*text)->empty()) added->capture_default_str();
  } else if (std::vector<std::string>* const* all = std::get_if<std::vector<std::string>*>(&option.target)) {
    added = app.add_option(option.names, **all, option.about)->check(refuse_empty);
    if (!added->get_positional()) added->allow_extra_args(false);
  } else {
    added = app.add_option(option.names, *std::get<std::optional<std::string>*>(option.target), option.about);
  }
  added->required(option.required);
  if (!option.form.empty()) added->option_text(option.form);
}

/// The line as the parser takes it, last word first. A value that begins with a dash is shielded by a space.
std::vector<std::string> words_for_parser(const std::vector<ProgramCommand>& commands, int argc,
                                          const char* const* argv) {
  std::vector<std::string> words(argv + std::min(1, argc), argv + argc);
  const bool shielded =
      !words.empty() && std::any_of(commands.begin(), commands.end(), [&](const ProgramCommand& command) {
        return command.dash_begins_value && command.name == words.front();
      });
  if (shielded)
    for (std::string& word : words)
      if (word.size() > 1 && word[0] == '-' && word[1] != '-' && word != "-h") word.insert(0, 1, ' ');
  std::reverse(words.begin(), words.end());
  return words;
}

void unshield(std::string& value) {
  if (value.starts_with(" -")) value.erase(0, 1);
}

void unshield_values(const ProgramCommand& command) {
  for (const CommandOption& option : command.options) {
    if (std::string* const* text = std::get_if<std::string*>(&option.target)) unshield(**text);
    if (const auto* text = std::get_if<std::optional<std::string>*>(&option.target))
      if (*text && **text) unshield(***text);
  }
}

CommandWords words_of(const CLI::App& command) {
  CommandWords words = {program_invocation_name, command.get_name()};
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_items_expected_max() == 0) continue;  // flags
    for (const std::string& value : option->results()) {
      if (!option->get_positional()) words.push_back("--" + option->get_lnames().front());
      words.push_back(value);
    }
  }
  return words;
}

}  // namespace

Offered offer(std::vector<std::string> words) { return {Offered::nothing, std::move(words)}; }
Offered offer_files() { return {Offered::files}; }
Offered offer_folders() { return {Offered::folders}; }
Offered offer_lessons(std::vector<std::string> or_words) { return {Offered::lessons, std::move(or_words)}; }

std::vector<std::string> spellings_of(std::string_view names) {
  std::vector<std::string> parts;
  for (std::size_t comma; (comma = names.find(',')) != names.npos; names.remove_prefix(comma + 1))
    parts.emplace_back(names.substr(0, comma));
  parts.emplace_back(names);
  return parts;
}

std::vector<std::string> CommandOption::spellings() const { return spellings_of(names); }

const std::vector<ExitMeaning>& exit_meanings() {
  static const std::vector<ExitMeaning> meanings = {
      {ExitCode::done, "done"},
      {ExitCode::failed, "failed while running"},
      {ExitCode::usage, "usage"},
      {ExitCode::invalid, "lesson, body or state invalid"},
      {ExitCode::different, "compared and different, a wrong answer, an export or a class not whole"},
      {ExitCode::interrupted, "interrupted"}};
  return meanings;
}

ExitCode run_command_line(const std::vector<ProgramCommand>& commands, int argc, const char* const* argv) {
  CLI::App app(kProgramAbout, "polhode");
  describe_program(app);
  app.require_subcommand(0, 1);  // the name of a second one is a value: polhode help export
  for (const ProgramCommand& command : commands) {
    CLI::App& added = *app.add_subcommand(command.name, command.about);
    for (const CommandOption& option : command.options) add_option(added, option);
    added.footer(command.footer);
  }
  try {
    app.parse(words_for_parser(commands, argc, argv));
  } catch (const CLI::ParseError& error) {
    return report(app, error);
  }
  for (const ProgramCommand& command : commands)
    if (const CLI::App& parsed = *app.get_subcommand(command.name); parsed.parsed()) {
      if (command.dash_begins_value) unshield_values(command);
      return command.run(words_of(parsed));
    }
  throw CommandError(ExitCode::usage, "a command is needed; see: polhode --help");
}

}  // namespace polhode
