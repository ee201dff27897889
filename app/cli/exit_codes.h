// SPDX-License-Identifier: MIT
// How the program ends; scripts rely on these numbers.
#pragma once

#include "base/outcome.h"
#include "base/printable.h"

#include <stdexcept>
#include <string>

namespace polhode {

enum class ExitCode : int {
  done = 0,
  failed = 1,        ///< while running: a missing file, font or context, a full disk
  usage = 2,         ///< unknown command, option, lesson id, stage, method; malformed number, bad size
  invalid = 3,       ///< the lesson, the body or the state cannot be (NaN too)
  different = 4,     ///< compared, and not the same; a wrong answer; an export not whole
  interrupted = 130  ///< SIGINT
};

inline ExitCode exit_code_of(Fault fault) {
  switch (fault) {
    case Fault::failed:
      break;
    case Fault::usage:
      return ExitCode::usage;
    case Fault::invalid:
      return ExitCode::invalid;
  }
  return ExitCode::failed;
}

/// Ends a command; main prints `what()` on stderr after "polhode: " and exits with `code`. The text is one
/// sentence for a user: what was found, what was expected, what to do. Empty: the command has said all
/// itself. What is echoed in it is made printable.
struct CommandError : std::runtime_error {
  CommandError(ExitCode exit_code, const std::string& text)
      : std::runtime_error(printable(text)), code(exit_code) {}
  ExitCode code;
};

/// What was asked for is malformed, unknown or out of range.
inline CommandError usage(const std::string& text) { return {ExitCode::usage, text}; }

}  // namespace polhode
