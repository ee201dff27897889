// SPDX-License-Identifier: MIT
// The sub-commands, one per source file. Each adds its options to the parser and, when the user names it,
// sets the action that main runs once the whole line is parsed.
#pragma once

#include "app/cli/exit_codes.h"

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace polhode {

/// Results on stdout, messages on stderr. @throws CommandError
using Action = std::function<ExitCode()>;

void add_list(CLI::App& app, Action& action);
void add_play(CLI::App& app, Action& action);
void add_export(CLI::App& app, Action& action);
void add_lint(CLI::App& app, Action& action);
void add_info(CLI::App& app, Action& action);
void add_trace(CLI::App& app, Action& action);
void add_measure(CLI::App& app, Action& action);
void add_verify(CLI::App& app, Action& action);
void add_answer(CLI::App& app, Action& action);
/// The words of a command line as the parser is to see them: an answer such as -w1*w2 is no option.
std::vector<std::string> with_answers_shielded(int argc, const char* const* argv);
void add_compare(CLI::App& app, Action& action);

}  // namespace polhode
