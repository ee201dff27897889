// SPDX-License-Identifier: MIT
// polhode completion: what a shell needs to complete the program's command line.
#include "app/cli/commands/commands.h"
#include "app/cli/shell_completion.h"
#include "base/spelling.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

namespace polhode {

namespace {

ExitCode completion(const std::string& name) {
  const std::vector<std::string>& names = shell_names();
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end())
    throw usage(
        fmt::format("\"{}\" is none of {}{}", name, fmt::join(names, ", "), did_you_mean(name, names)));
  fmt::print("{}", completion_script(static_cast<Shell>(at - names.begin()), program_commands()));
  return ExitCode::done;
}

}  // namespace

ProgramCommand completion_command() {
  const auto shell = std::make_shared<std::string>();
  return {
      "completion",
      "Print a script that completes the command line of polhode in a shell",
      {{"SHELL", shell.get(), "bash, zsh or fish", " ", true, offer(shell_names())}},
      "For this shell alone, in bash: source <(polhode completion bash); in fish: polhode completion fish\n"
      "| source. For all to come, the script goes where the shell looks for it:\n"
      "bash ~/.local/share/bash-completion/completions/polhode, zsh a folder of $fpath as _polhode,\n"
      "fish ~/.config/fish/completions/polhode.fish. Lessons are completed by polhode list.",
      [shell](const CommandWords&) { return completion(*shell); }};
}

}  // namespace polhode
