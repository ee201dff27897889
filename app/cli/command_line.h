// SPDX-License-Identifier: MIT
// What the program takes on its command line: commands and options as data, and the reading of a line.
#pragma once

#include "app/cli/exit_codes.h"

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace polhode {

/// One option of a command, a flag, or an argument known by its place.
struct CommandOption {
  /// Where the value goes: a flag's to bool; the last one given to string; all that are given to vector. Only
  /// an optional takes an empty value too; in the others that is a mistake, and not the same as none.
  using Target = std::variant<bool*, std::string*, std::optional<std::string>*, std::vector<std::string>*>;

  std::string names;  ///< "--stage", "-o,--output"; without a dash, "LESSON": an argument by its place
  Target target;      ///< outlives the reading of the line; what it holds before is the default
  std::string about;  ///< for the help
  /// How the help writes the value, "DIR"; empty: as the parser does, with the default if there is one. " ":
  /// not.
  std::string form = {};
  bool required = false;
};

/// The words of a line that say the same again, in the order of the options, without its flags: what resumes
/// an export.
using CommandWords = std::vector<std::string>;

struct Command {
  std::string name, about;
  std::vector<CommandOption> options;
  std::string footer = {};  ///< of its help
  /// What the command does, its options filled: results on stdout, messages on stderr. @throws CommandError
  std::function<ExitCode(const CommandWords&)> run = {};
  /// A word such as -w1*w2 is a value and no option; --long options and -h remain.
  bool dash_begins_value = false;
};

/// Reads the line and runs the command it names. Answers --help and --version on stdout; a mistake gets one
/// message on stderr, with "did you mean", and ExitCode::usage. @throws what the command throws
ExitCode run_command_line(const std::vector<Command>& commands, int argc, const char* const* argv);

}  // namespace polhode
