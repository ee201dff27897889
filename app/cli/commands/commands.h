// SPDX-License-Identifier: MIT
// The commands of the program, one per source file.
#pragma once

#include "app/cli/command_line.h"

namespace polhode {

ProgramCommand list_command();
ProgramCommand play_command();
ProgramCommand export_command();
ProgramCommand verify_command();
ProgramCommand lint_command();
ProgramCommand info_command();
ProgramCommand trace_command();
ProgramCommand measure_command();
ProgramCommand answer_command();
ProgramCommand answers_command();
ProgramCommand derive_command();
ProgramCommand compare_command();
ProgramCommand completion_command();
/// @param others the names of the other commands, which a shell offers.
ProgramCommand help_command(std::vector<std::string> others);

/// All of them, in the order of the help.
std::vector<ProgramCommand> program_commands();

}  // namespace polhode
