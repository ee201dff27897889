// SPDX-License-Identifier: MIT
// Small JSON files in the state folder, $XDG_STATE_HOME/polhode or ~/.local/state/polhode (XDG Base Directory
// Specification 0.8): what is kept from one run to the next.
#pragma once

#include "base/result.h"

#include <nlohmann/json_fwd.hpp>
#include <sys/file.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace polhode {

/// Nothing where neither XDG_STATE_HOME (absolute) nor HOME says where.
std::optional<std::filesystem::path> state_folder();

/// Why a state file can be neither read nor written.
struct StateFileError {
  std::string text;      ///< as that of a Result
  bool is_held = false;  ///< another process has its StateLock, and keeps it
};
template <class T>
using StateFileResult = Result<T, StateFileError>;

/// Held by one process at a time while it reads a state file, changes what it read and writes it again. It is
/// an advisory lock (flock) on a file beside it, NAME.lock, which stays there; a process that dies gives it
/// back. On a file system that has no locks nothing is locked: a state file is written whole all the same.
class StateLock {
 public:
  /// Makes the folder, and waits for others, but not for longer than `patience`; 0: looks once.
  /// @param lock_file stands in for flock
  static StateFileResult<StateLock> take(const std::filesystem::path& state_file,
                                         std::chrono::milliseconds patience,
                                         int (*lock_file)(int file, int operation) = ::flock);
  ~StateLock();
  StateLock(StateLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  StateLock& operator=(StateLock&&) = delete;

 private:
  explicit StateLock(int file) : file_(file) {}

  int file_ = -1;
};

/// Takes what a file says. Throws any std::exception if it is not such a file.
using TakeState = std::function<void(const nlohmann::ordered_json&)>;

/// Gives `take` what the file says; of an absent file nothing. A damaged one is set aside as NAME.damaged (or
/// -2, -3 … behind it), and the answer is a warning that says so; else empty. What `take` has got of it is
/// to be forgotten. `what` names the file in the warning: "the log of answers". Fails if the file is there
/// but cannot be read, is no regular file or has more than 16 MiB, or has another "format" than 1.
StateFileResult<std::string> read_state_file(const std::filesystem::path& path, const std::string& what,
                                             const TakeState& take);

/// Whole or not at all; makes the folder, and puts "format" first.
StateFileResult<std::monostate> write_state_file(const std::filesystem::path& path,
                                                 const nlohmann::ordered_json& members);

}  // namespace polhode
