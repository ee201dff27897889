// SPDX-License-Identifier: MIT
#include "app/publish/ffmpeg.h"

#include "app/export/background_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace polhode {

namespace {

constexpr int kWakeMs = 50;  // to see an interrupt

/// What posix_spawn is told, freed at the end.
struct Spawning {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;

  Spawning() {
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
  }
  ~Spawning() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
  Spawning(const Spawning&) = delete;
  Spawning& operator=(const Spawning&) = delete;

  void standard_files(int input, int words) {
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, words, STDERR_FILENO);
  }
  void own_group() {
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  }
};

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::string reason(int error) {
  if (error == ENOENT) return "there is no ffmpeg; install the package ffmpeg";
  return fmt::format("ffmpeg cannot be started: {}", std::strerror(error));
}

}  // namespace

Result<Ffmpeg> Ffmpeg::start(const std::vector<std::string>& arguments, const InterruptWatch& watch) {
  Ffmpeg run(watch);
  // A socket, for a pipe without a reader would end us by SIGPIPE.
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return failure(reason(errno));
  run.input_ = ends[0];
  run.words_ = std::tmpfile();
  if (!run.words_) {
    const int error = errno;
    ::close(ends[1]);
    return failure(fmt::format("what ffmpeg says needs a temporary file, and {} takes none: {}", P_tmpdir,
                               std::strerror(error)));
  }
  std::vector<std::string> words = {"ffmpeg", "-nostdin", "-hide_banner", "-v", "error", "-y"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  Spawning spawning;
  spawning.standard_files(ends[1], ::fileno(run.words_));
  spawning.own_group();
  const int error = ::posix_spawnp(&run.process_, "ffmpeg", &spawning.files, &spawning.attributes,
                                   pointers_to(words).data(), environ);
  ::close(ends[1]);
  if (error != 0) {
    run.process_ = 0;
    return failure(reason(error));
  }
  return run;
}

Ffmpeg::Ffmpeg(Ffmpeg&& other) noexcept
    : watch_(other.watch_),
      process_(std::exchange(other.process_, 0)),
      input_(std::exchange(other.input_, -1)),
      words_(std::exchange(other.words_, nullptr)) {}

Ffmpeg::~Ffmpeg() {
  if (process_ > 0) {
    ::kill(-process_, SIGKILL);  // its group
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  close_input();
  if (words_) std::fclose(words_);
}

void Ffmpeg::close_input() {
  if (input_ >= 0) ::close(std::exchange(input_, -1));
}

bool Ffmpeg::feed(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    if (watch_->interrupted()) throw Interrupted();
    const ssize_t count = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      pollfd room{input_, POLLOUT, 0};
      ::poll(&room, 1, kWakeMs);
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

Status Ffmpeg::finish() {
  close_input();
  int status = 0;
  for (pid_t ended = 0; ended != process_;) {
    if (watch_->interrupted()) throw Interrupted();
    ended = ::waitpid(process_, &status, WNOHANG);
    if (ended == 0) ::poll(nullptr, 0, kWakeMs);
    if (ended < 0 && errno != EINTR) return failure(reason(errno));
  }
  process_ = 0;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return success();
  const std::string end = WIFEXITED(status) ? fmt::format("ended with code {}", WEXITSTATUS(status))
                                            : fmt::format("was ended by signal {}", WTERMSIG(status));
  const std::string words = last_words_in(words_);
  return failure(fmt::format("ffmpeg {}{}{}", end, words.empty() ? "" : ":\n", words));
}

}  // namespace polhode
