// SPDX-License-Identifier: MIT
#include "tests/lessons/peak_memory.h"

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

namespace polhode::testing {
namespace {

long resident_kilobytes() {
  std::ifstream status("/proc/self/statm");
  long total = 0;
  long resident = 0;
  status >> total >> resident;
  return resident * (sysconf(_SC_PAGESIZE) / 1024);
}

}  // namespace

long peak_kilobytes(const std::function<std::size_t()>& work) {
  malloc_trim(0);  // what earlier tests left free must not hide what this takes
  int pipe_ends[2];
  if (pipe(pipe_ends) != 0) return -1;
  const pid_t child = fork();
  if (child == 0) {
    const long before = resident_kilobytes();
    const std::size_t result = work();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const long grown = usage.ru_maxrss - before + (result == static_cast<std::size_t>(-1) ? 1 : 0);
    const bool sent = write(pipe_ends[1], &grown, sizeof grown) == static_cast<ssize_t>(sizeof grown);
    _exit(sent ? 0 : 1);
  }
  close(pipe_ends[1]);
  long grown = -1;
  if (read(pipe_ends[0], &grown, sizeof grown) != static_cast<ssize_t>(sizeof grown)) grown = -1;
  close(pipe_ends[0]);
  waitpid(child, nullptr, 0);
  return grown;
}

}  // namespace polhode::testing
