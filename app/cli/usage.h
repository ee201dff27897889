// SPDX-License-Identifier: MIT
// The command line as a whole: what --help says, and what is said to a line that cannot be read.
#pragma once

#include "app/cli/exit_codes.h"

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace polhode {

/// Version flag and layout of the help, which the sub-commands inherit; call before they are added.
void describe_program(CLI::App& app);

/// Answers --help and --version on stdout; for a mistake, one message on stderr with "did you mean".
ExitCode report(const CLI::App& app, const CLI::ParseError& error);

/// Validator of option values: one that is empty is a mistake, and not the same as an option not given.
std::string refuse_empty(const std::string& value);

}  // namespace polhode
