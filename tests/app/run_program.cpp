// SPDX-License-Identifier: MIT
#include "tests/app/run_program.h"

#include "tests/support/paths.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace polhode {

namespace fs = std::filesystem;

namespace {

constexpr unsigned kTimeLimit_s = 120;

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> result;
  for (std::string& word : words) result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

/// In the child: never returns.
[[noreturn]] void become(std::vector<char*> words, const RunOptions& options, const fs::path& out,
                         const fs::path& err) {
  const int to_out = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int to_err = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(to_out, STDOUT_FILENO);
  dup2(to_err, STDERR_FILENO);
  for (const auto& [name, value] : options.environment) setenv(name.c_str(), value.c_str(), 1);
  signal(SIGINT, SIG_DFL);
  alarm(kTimeLimit_s);
  if (chdir(options.folder.c_str()) == 0) execvp(words[0], words.data());
  _exit(127);
}

}  // namespace

ProgramRun polhode(const std::vector<std::string>& arguments, const RunOptions& options) {
  const ScratchFolder scratch;
  const fs::path out = options.stdout_to.empty() ? scratch / "out" : fs::path(options.stdout_to),
                 err = scratch / "err";
  std::vector<std::string> words = options.wrapper;
  words.push_back(test::program());
  words.insert(words.end(), arguments.begin(), arguments.end());
  const std::vector<char*> argv = pointers(words);

  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) become(argv, options, out, err);
  if (options.while_running) options.while_running(child);
  int status = 0;
  waitpid(child, &status, 0);

  ProgramRun run;
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (options.stdout_to.empty()) run.out = text_of(out);
  run.err = text_of(err);
  return run;
}

ScratchFolder::ScratchFolder() {
  std::string name = (fs::temp_directory_path() / "polhode-test-XXXXXX").string();
  if (!mkdtemp(name.data())) std::abort();
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string test_lesson(const std::string& name) { return test::source_dir() / "tests/data/app" / name; }

}  // namespace polhode
