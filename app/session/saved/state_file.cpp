// SPDX-License-Identifier: MIT
#include "app/session/saved/state_file.h"

#include "base/files/atomic_file.h"
#include "base/files/file_bytes.h"
#include "base/files/reason_of.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <system_error>
#include <thread>

namespace polhode {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;

Failure<StateFileError> fails(std::string text) { return {{std::move(text)}}; }

/// Some hundred bytes for each question; a lesson of kMaxLessonBytes has at most some ten thousand.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;

StateFileResult<std::string> whole_text(const fs::path& path) {
  const auto bytes = read_file_bytes(path, kMostBytes);
  if (!bytes) return fails(fmt::format("cannot read {}: {}", path.string(), bytes.error()));
  return std::string(bytes->begin(), bytes->end());
}

StateFileResult<std::string> set_aside(const fs::path& path) {
  std::error_code error;
  fs::path aside = path.string() + ".damaged";
  for (int i = 2; fs::exists(fs::symlink_status(aside, error)); ++i)
    aside = fmt::format("{}.damaged-{}", path.string(), i);
  fs::rename(path, aside, error);
  if (error)
    return fails(fmt::format("{} is damaged and cannot be set aside: {}", path.string(), error.message()));
  return fmt::format("{} was damaged: it is now {}, and a new one is begun", path.string(), aside.string());
}

StateFileResult<std::monostate> make_folder_of(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) return fails(fmt::format("cannot make {}: {}", path.parent_path().string(), error.message()));
  return std::monostate{};
}

/// What flock says on network and user-space file systems that have no such thing.
bool means_no_locks(int error) { return error == ENOSYS || error == ENOLCK || error == EOPNOTSUPP; }

}  // namespace

StateFileResult<StateLock> StateLock::take(const fs::path& state_file, std::chrono::milliseconds patience,
                                           int (*lock_file)(int file, int operation)) {
  if (const auto made = make_folder_of(state_file); !made) return Failure{made.error()};
  const std::string name = state_file.string() + ".lock";
  const auto cannot = [&](const std::string& why) { return fmt::format("cannot lock {}: {}", name, why); };
  StateLock lock(::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
  if (lock.file_ < 0) return fails(cannot(reason_of(errno)));
  using namespace std::chrono_literals;
  const auto until = std::chrono::steady_clock::now() + patience;
  while (lock_file(lock.file_, LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    if (means_no_locks(error)) break;
    const bool is_held = error == EWOULDBLOCK || error == EINTR;
    if (is_held && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(5ms);
      continue;
    }
    if (!is_held) return fails(cannot(reason_of(error)));
    const double seconds = std::chrono::duration<double>(patience).count();
    return Failure{
        StateFileError{cannot(fmt::format("another polhode has held it for {:g} s", seconds)), true}};
  }
  return lock;
}

StateLock::~StateLock() {
  if (file_ >= 0) ::close(file_);
}

std::optional<fs::path> state_folder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state && fs::path(state).is_absolute()) return fs::path(state) / "polhode";
  const char* home = std::getenv("HOME");
  if (home && fs::path(home).is_absolute()) return fs::path(home) / ".local" / "state" / "polhode";
  return std::nullopt;
}

StateFileResult<std::string> read_state_file(const fs::path& path, const std::string& what,
                                             const TakeState& take) {
  std::error_code none;
  if (!fs::exists(path, none)) return std::string();
  auto text = whole_text(path);
  if (!text) return text;
  try {
    const Json json = Json::parse(*text);
    if (json.at("format") != kFormat)
      return fails(
          fmt::format("{}, {}, is of another version of this program; move it away", what, path.string()));
    take(json);
  } catch (const std::exception&) {  // as readers of JSON say that it is not what they expected
    return set_aside(path);
  }
  return std::string();
}

StateFileResult<std::monostate> write_state_file(const fs::path& path, const Json& members) {
  if (auto made = make_folder_of(path); !made) return made;
  Json json{{"format", kFormat}};
  json.update(members);
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  const Status written = write_file_atomically(path, bytes_of(text), Durability::sync);
  if (!written) return fails(written.error());
  return std::monostate{};
}

}  // namespace polhode
