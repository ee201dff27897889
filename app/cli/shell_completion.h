// SPDX-License-Identifier: MIT
// Completion in a shell: what may be typed next on the program's command line, as a script for that shell.
//
// The scripts are made of the tables of options from which the program reads its line and writes its help, so
// that none of the three can know an option that the others do not. Lessons are looked up by `polhode list`
// at the moment they are asked for.
#pragma once

#include "app/cli/command_line.h"

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

enum class Shell { bash, zsh, fish };

/// "bash", "zsh", "fish", in the order of Shell.
const std::vector<std::string>& shell_names();

/// The script, to be sourced (bash, fish) or put on $fpath as _polhode (zsh). Needs bash 4.4, zsh 5 or fish 3
/// and no library of completions.
std::string completion_script(Shell shell, const std::vector<ProgramCommand>& commands);

}  // namespace polhode
