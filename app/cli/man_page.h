// SPDX-License-Identifier: MIT
// Manual pages, as the macros of man(7): polhode(1), and polhode-COMMAND(1) for each command.
//
// They are made of the tables of options from which the program reads its line and writes its help.
#pragma once

#include "app/cli/command_line.h"

#include <string>
#include <vector>

namespace polhode {

/// polhode(1): what the program is, its commands, environment, files, exit status and examples.
std::string man_page(const std::vector<ProgramCommand>& commands);

/// polhode-COMMAND(1): what the command does and takes. It refers to those of `commands` that its text names.
std::string man_page(const ProgramCommand& command, const std::vector<ProgramCommand>& commands);

}  // namespace polhode
