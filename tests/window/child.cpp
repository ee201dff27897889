// SPDX-License-Identifier: MIT
#include "tests/window/child.h"

#include "tests/app/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace polhode::window_test {

namespace {

/// In the child: never returns.
[[noreturn]] void become(std::vector<char*> words, const Start& start) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setpgid(0, 0);
  dup2(open(start.out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
  dup2(open(start.err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
  if (start.kept_open >= 0) fcntl(start.kept_open, F_SETFD, 0);
  for (const auto& [name, value] : start.environment)
    value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
  if (chdir(start.folder.c_str()) == 0) execvp(words[0], words.data());
  _exit(127);
}

}  // namespace

Child::Child(const Start& start) {
  std::vector<std::string> copies = start.words;
  std::vector<char*> words;
  for (std::string& word : copies) words.push_back(word.data());
  words.push_back(nullptr);
  id_ = fork();
  if (id_ < 0) throw std::runtime_error("cannot fork");
  if (id_ == 0) become(words, start);
  setpgid(id_, id_);  // whoever of both is first: it has a group before it can be killed
}

Child::~Child() {
  if (code()) return;
  kill(-id_, SIGKILL);
  waitpid(id_, nullptr, 0);
}

std::optional<int> Child::code() {
  int status = 0;
  if (!code_ && waitpid(id_, &status, WNOHANG) == id_)
    code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return code_;
}

std::optional<int> Child::wait(std::chrono::milliseconds patience) {
  eventually([&] { return code().has_value(); }, patience);
  return code_;
}

double Child::cpu_s() const {
  // proc(5): after the name in brackets come the state and ten numbers, then utime and stime in ticks.
  const std::string stat = text_of("/proc/" + std::to_string(id_) + "/stat");
  std::istringstream fields(stat.substr(stat.rfind(')') + 1));
  std::string passed;
  for (int i = 0; i < 11; ++i) fields >> passed;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

std::string output_of(const std::vector<std::string>& words, const Environment& environment) {
  const ScratchFolder scratch;
  Child child({words, environment, ".", scratch / "out", scratch / "err"});
  if (child.wait() != 0) throw std::runtime_error(words[0] + ": " + text_of(scratch / "err"));
  return text_of(scratch / "out");
}

bool is_installed(const std::string& program) {
  std::istringstream folders(std::getenv("PATH") ? std::getenv("PATH") : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((folder + '/' + program).c_str(), X_OK) == 0) return true;
  return false;
}

}  // namespace polhode::window_test
