// SPDX-License-Identifier: MIT
// polhode help: what --help prints, and the same as manual pages.
#include "app/cli/commands/commands.h"
#include "app/cli/man_page.h"
#include "base/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace polhode {

namespace {

struct Options {
  std::string command;
  bool man = false;
};

ExitCode help(const Options& options) {
  const std::vector<ProgramCommand> commands = program_commands();
  std::vector<std::string> names;
  for (const ProgramCommand& command : commands) names.push_back(command.name);
  const auto at = std::find(names.begin(), names.end(), options.command);
  if (!options.command.empty() && at == names.end())
    throw usage(
        fmt::format("unknown command \"{}\"{}", options.command, did_you_mean(options.command, names)));
  if (options.man) {
    fmt::print("{}", options.command.empty()
                         ? man_page(commands)
                         : man_page(commands[static_cast<std::size_t>(at - names.begin())], commands));
    return ExitCode::done;
  }
  std::vector<const char*> line = {"polhode", options.command.c_str(), "--help"};
  if (options.command.empty()) line.erase(line.begin() + 1);
  return run_command_line(commands, static_cast<int>(line.size()), line.data());
}

}  // namespace

ProgramCommand help_command(std::vector<std::string> others) {
  const auto options = std::make_shared<Options>();
  return {"help",
          "Print the help of the program, or of a command",
          {{"COMMAND", &options->command, "Its name", " ", false, offer(std::move(others))},
           {"--man", &options->man, "as a manual page: polhode help export --man | man -l -"}},
          "The pages are made of the same tables as the help: polhode.1, and polhode-COMMAND.1 for each\n"
          "command.",
          [options](const CommandWords&) { return help(*options); }};
}

}  // namespace polhode
