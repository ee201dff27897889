// SPDX-License-Identifier: MIT
// What the program takes on its command line: commands and options as data, and the reading of a line.
#pragma once

#include "app/cli/exit_codes.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace polhode {

/// What a shell offers where a value is typed: these words, or names that it looks up.
struct Offered {
  enum Names { nothing, files, folders, lessons };  ///< lessons: their ids, and files
  Names names = nothing;
  std::vector<std::string> words = {};
};
Offered offer(std::vector<std::string> words);
Offered offer_files();
Offered offer_folders();
Offered offer_lessons(std::vector<std::string> or_words = {});

/// One option of a command, a flag, or an argument known by its place.
struct CommandOption {
  /// Where the value goes. A bool is set by a flag; a string keeps the last value given, a vector all of
  /// them. Only an optional accepts an empty value; for the others, which cannot tell it from no value, it is
  /// a mistake of the user.
  using Target = std::variant<bool*, std::string*, std::optional<std::string>*, std::vector<std::string>*>;

  std::string names;  ///< "--stage", "-o,--output"; without a dash, "LESSON": an argument by its place
  Target target;      ///< outlives the reading of the line; what it holds before is the default
  std::string about;  ///< for the help
  /// How the help writes the value: "DIR". Empty: as the parser does, with the default if there is one.
  /// A blank: not at all.
  std::string form = {};
  bool required = false;
  Offered offered = {};  ///< for the value

  bool is_flag() const { return std::holds_alternative<bool*>(target); }
  bool is_argument() const { return !names.starts_with('-'); }
  bool may_be_repeated() const { return std::holds_alternative<std::vector<std::string>*>(target); }
  /// "-o", "--output"; of an argument its one name.
  std::vector<std::string> spellings() const;
};

/// The words of a command line that says the same as the one that was read, in the order of the options and
/// without its flags. An export is resumed by them.
using CommandWords = std::vector<std::string>;

struct ProgramCommand {
  std::string name, about;
  std::vector<CommandOption> options;
  std::string footer = {};  ///< of its help
  /// What the command does, its options filled: results on stdout, messages on stderr. @throws CommandError
  std::function<ExitCode(const CommandWords&)> run = {};
  /// A word such as -w1*w2 is a value and no option; --long options and -h remain.
  bool dash_begins_value = false;
};

/// A flag that is no command's own.
struct CommonFlag {
  const char *names, *about;
};
inline constexpr CommonFlag kHelpFlag = {"-h,--help", "Print this help and exit"};  ///< of every command, too
inline constexpr CommonFlag kVersionFlag = {"--version", "Print the version and exit"};

/// What the program is, in one sentence, and what holds for all its commands.
inline constexpr const char* kProgramAbout = "Lecture companion for the rotation of a rigid body.";
inline constexpr const char* kLessonAndNumbers =
    "LESSON is an id, looked up in $POLHODE_LESSONS, ./lessons and PROGRAM/../share/polhode/lessons,\n"
    "or a file. Numbers may be decimal or hexadecimal (0x1.8p+1).";

struct ExitMeaning {
  ExitCode code;
  const char* meaning;
};
/// How the program can end, in the order of the codes.
const std::vector<ExitMeaning>& exit_meanings();

/// The parts of "-o,--output".
std::vector<std::string> spellings_of(std::string_view names);

/// Reads the line and runs the command it names. Answers --help and --version on stdout; a mistake gets one
/// message on stderr, with "did you mean", and ExitCode::usage. @throws what the command throws
ExitCode run_command_line(const std::vector<ProgramCommand>& commands, int argc, const char* const* argv);

}  // namespace polhode
