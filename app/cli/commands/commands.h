// SPDX-License-Identifier: MIT
// The commands of the program, one per source file.
#pragma once

#include "app/cli/command_line.h"

namespace polhode {

Command list_command();
Command play_command();
Command export_command();
Command verify_command();
Command lint_command();
Command info_command();
Command trace_command();
Command measure_command();
Command answer_command();
Command answers_command();
Command derive_command();
Command compare_command();
Command completion_command();
/// @param others the names of the other commands, which a shell offers.
Command help_command(std::vector<std::string> others);

/// All of them, in the order of the help.
std::vector<Command> program_commands();

}  // namespace polhode
