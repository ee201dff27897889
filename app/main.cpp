// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/picture_metadata.h"
#include "app/usage.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

int main(int argc, char** argv) {
  using namespace polhode;
  CLI::App app("Lecture companion for the rotation of a rigid body.", "polhode");
  Action action;
  describe_program(app);
  for (const auto add : {add_list, add_play, add_export, add_verify, add_lint, add_info, add_trace,
                         add_measure, add_answer, add_compare})
    add(app, action);

  try {
    std::vector<std::string> words = with_answers_shielded(argc, argv);
    words.erase(words.begin(), words.begin() + std::min<std::ptrdiff_t>(1, argc));
    std::reverse(words.begin(), words.end());  // as the parser takes them
    app.parse(std::move(words));
    if (!action) throw CommandError(ExitCode::usage, "a command is needed; see: polhode --help");
    ExitCode code = action();
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
      throw CommandError(ExitCode::failed, "cannot write to stdout");
    return static_cast<int>(code);
  } catch (const CLI::ParseError& error) {
    return static_cast<int>(report(app, error));
  } catch (const CommandError& error) {
    fmt::print(stderr, "polhode: {}\n", error.what());
    return static_cast<int>(error.code);
  } catch (const std::domain_error& error) {
    fmt::print(stderr, "polhode: {}\n", error.what());
    return static_cast<int>(ExitCode::invalid);
  } catch (const std::exception& error) {
    fmt::print(stderr, "polhode: {}\n", error.what());
    return static_cast<int>(ExitCode::failed);
  }
}
