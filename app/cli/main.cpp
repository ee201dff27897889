// SPDX-License-Identifier: MIT
#include "app/cli/commands/commands.h"
#include "app/cli/message.h"

#include <signal.h>

#include <cstdio>
#include <iostream>

namespace polhode {

namespace {

ExitCode fail(ExitCode code, const char* text) {
  say("polhode: {}\n", text);
  return code;
}

ExitCode run(int argc, char** argv) {
  try {
    return run_command_line(program_commands(), argc, argv);
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
