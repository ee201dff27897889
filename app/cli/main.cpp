// SPDX-License-Identifier: MIT
#include "app/cli/commands.h"
#include "app/cli/message.h"
#include "app/cli/usage.h"
#include "app/export/picture_metadata.h"

#include <CLI/CLI.hpp>
#include <signal.h>

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace polhode {

namespace {

ExitCode fail(ExitCode code, const char* text) {
  say("polhode: {}\n", text);
  return code;
}

ExitCode run(int argc, char** argv) {
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
    return action();
  } catch (const CLI::ParseError& error) {
    return report(app, error);
  } catch (const CommandError& error) {
    return fail(error.code, error.what());
  } catch (const std::domain_error& error) {
    return fail(ExitCode::invalid, error.what());
  } catch (const std::exception& error) {
    return fail(ExitCode::failed, error.what());
  }
}

/// What was printed so far, help and version among it, has left the program.
bool stdout_is_written() {
  std::cout.flush();
  return std::fflush(stdout) == 0 && !std::ferror(stdout) && std::cout.good();
}

}  // namespace

}  // namespace polhode

int main(int argc, char** argv) {
  using namespace polhode;
  reserve_standard_streams();
  signal(SIGXFSZ, SIG_IGN);  // a file larger than `ulimit -f` allows is then an error like a full disk
  ExitCode code = run(argc, argv);
  if (!stdout_is_written() && code != ExitCode::failed)
    code = fail(ExitCode::failed, "cannot write to stdout");
  return static_cast<int>(code);
}
