// SPDX-License-Identifier: MIT
#include "app/export/background_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace polhode {

namespace {

constexpr long kMostWords = 600;
constexpr std::size_t kMostAnswer = 100'000;

/// Which files it has, freed at the end.
struct StandardFiles {
  posix_spawn_file_actions_t actions;

  StandardFiles(int words, bool keeps_answer) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (keeps_answer)
      posix_spawn_file_actions_adddup2(&actions, words, STDOUT_FILENO);
    else
      posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, words, STDERR_FILENO);
  }
  ~StandardFiles() { posix_spawn_file_actions_destroy(&actions); }
  StandardFiles(const StandardFiles&) = delete;
  StandardFiles& operator=(const StandardFiles&) = delete;
};

std::string reason(const std::string& program, int error) {
  if (error == ENOENT) return "there is no " + program;
  return fmt::format("{} cannot be started: {}", program, std::strerror(error));
}

int code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

Result<BackgroundProgram> BackgroundProgram::start(std::vector<std::string> words, bool keeps_answer) {
  BackgroundProgram program;
  program.words_ = std::tmpfile();
  if (!program.words_) return failure(reason(words.front(), errno));
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const StandardFiles files(::fileno(program.words_), keeps_answer);
  const int error =
      ::posix_spawnp(&program.process_, pointers.front(), &files.actions, nullptr, pointers.data(), environ);
  if (error != 0) {
    program.process_ = 0;
    return failure(reason(words.front(), error));
  }
  return program;
}

BackgroundProgram::BackgroundProgram(BackgroundProgram&& other) noexcept
    : process_(std::exchange(other.process_, 0)),
      code_(other.code_),
      words_(std::exchange(other.words_, nullptr)) {}

BackgroundProgram& BackgroundProgram::operator=(BackgroundProgram&& other) noexcept {
  std::swap(process_, other.process_);
  std::swap(code_, other.code_);
  std::swap(words_, other.words_);
  return *this;
}

BackgroundProgram::~BackgroundProgram() {
  if (words_) std::fclose(words_);
}

std::optional<int> BackgroundProgram::code() {
  int status = 0;
  if (process_ > 0 && ::waitpid(process_, &status, WNOHANG) == process_) {
    process_ = 0;
    code_ = code_of(status);
  }
  return code_;
}

void BackgroundProgram::end() {
  if (process_ <= 0) return;
  ::kill(process_, SIGTERM);
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = 0;
  code_ = code_of(status);
}

std::string BackgroundProgram::answer() const {
  std::rewind(words_);
  std::string text(kMostAnswer, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), words_));
  return text;
}

std::string last_words_in(std::FILE* words) {
  std::fseek(words, 0, SEEK_END);
  const long length = std::ftell(words);
  std::fseek(words, std::max(0L, length - kMostWords), SEEK_SET);
  std::string text(static_cast<std::size_t>(kMostWords), '\0');
  text.resize(std::fread(text.data(), 1, text.size(), words));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

}  // namespace polhode
