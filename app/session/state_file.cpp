// SPDX-License-Identifier: MIT
#include "app/session/state_file.h"

#include "app/cli/or_fail.h"
#include "base/files/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>
#include <thread>

namespace polhode {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;

/// A folder of the file's name opens, and throws when it is read.
std::string whole_text(const fs::path& path) {
  const CommandError unreadable(ExitCode::failed, fmt::format("cannot read {}", path.string()));
  std::ifstream file(path, std::ios::binary);
  if (!file) throw unreadable;
  try {
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  } catch (const std::ios_base::failure&) {
    throw unreadable;
  }
}

std::string set_aside(const fs::path& path) {
  const fs::path aside = path.string() + ".damaged";
  std::error_code error;
  fs::rename(path, aside, error);
  if (error)
    throw CommandError(ExitCode::failed, fmt::format("{} is damaged and cannot be set aside: {}",
                                                     path.string(), error.message()));
  return fmt::format("{} was damaged: it is now {}, and a new one is begun", path.string(), aside.string());
}

void make_folder_of(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error)
    throw CommandError(ExitCode::failed,
                       fmt::format("cannot make {}: {}", path.parent_path().string(), error.message()));
}

/// What flock says on network and user-space file systems that have no such thing.
bool means_no_locks(int error) { return error == ENOSYS || error == ENOLCK || error == EOPNOTSUPP; }

}  // namespace

StateLock::StateLock(const fs::path& state_file, std::chrono::milliseconds patience,
                     int (*lock_file)(int file, int operation)) {
  make_folder_of(state_file);
  const std::string name = state_file.string() + ".lock";
  const auto reason = [](int error) { return std::generic_category().message(error); };
  const auto cannot = [&](const std::string& why) { return fmt::format("cannot lock {}: {}", name, why); };
  file_ = ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (file_ < 0) throw CommandError(ExitCode::failed, cannot(reason(errno)));
  using namespace std::chrono_literals;
  const auto until = std::chrono::steady_clock::now() + patience;
  while (lock_file(file_, LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    if (means_no_locks(error)) return;
    const bool is_held = error == EWOULDBLOCK || error == EINTR;
    if (is_held && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(5ms);
      continue;
    }
    ::close(file_);
    if (!is_held) throw CommandError(ExitCode::failed, cannot(reason(error)));
    const double seconds = std::chrono::duration<double>(patience).count();
    throw StateIsHeld(ExitCode::failed,
                      cannot(fmt::format("another polhode has held it for {:g} s", seconds)));
  }
}

StateLock::~StateLock() { ::close(file_); }

std::optional<fs::path> state_folder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state && fs::path(state).is_absolute()) return fs::path(state) / "polhode";
  const char* home = std::getenv("HOME");
  if (home && fs::path(home).is_absolute()) return fs::path(home) / ".local" / "state" / "polhode";
  return std::nullopt;
}

std::string read_state_file(const fs::path& path, const std::string& what, const TakeState& take) {
  std::error_code none;
  if (!fs::exists(path, none)) return {};
  const std::string text = whole_text(path);
  try {
    const Json json = Json::parse(text);
    if (json.at("format") != kFormat)
      throw CommandError(ExitCode::failed,
                         fmt::format("{} is of another version of this program; move it away", what));
    take(json);
  } catch (const CommandError&) {
    throw;
  } catch (const std::exception&) {
    return set_aside(path);
  }
  return {};
}

void write_state_file(const fs::path& path, const Json& members) {
  make_folder_of(path);
  Json json{{"format", kFormat}};
  json.update(members);
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  or_fail(write_file_atomically(
      path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), Durability::sync));
}

}  // namespace polhode
