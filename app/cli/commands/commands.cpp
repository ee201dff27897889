// SPDX-License-Identifier: MIT
#include "app/cli/commands/commands.h"

namespace polhode {

std::vector<ProgramCommand> program_commands() {
  std::vector<ProgramCommand> commands = {
      list_command(),   play_command(),    export_command(),    verify_command(), lint_command(),
      info_command(),   trace_command(),   measure_command(),   answer_command(), answers_command(),
      derive_command(), compare_command(), completion_command()};
  std::vector<std::string> names;
  for (const ProgramCommand& command : commands) names.push_back(command.name);
  commands.push_back(help_command(std::move(names)));
  return commands;
}

}  // namespace polhode
