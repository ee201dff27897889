// SPDX-License-Identifier: MIT
// ffmpeg as a child process that reads what we write to it.
#pragma once

#include "base/interrupt.h"
#include "base/result.h"

#include <sys/types.h>

#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

namespace polhode {

/// A run of ffmpeg. It stands in a process group of its own, so that Ctrl-C reaches us alone; an object that
/// goes away ends it.
class Ffmpeg {
 public:
  /// `arguments` go to it as they are; no shell sees them.
  /// The error names the package if there is no ffmpeg.
  static Result<Ffmpeg> start(const std::vector<std::string>& arguments, const InterruptWatch& watch);
  ~Ffmpeg();
  Ffmpeg(Ffmpeg&& other) noexcept;
  Ffmpeg& operator=(Ffmpeg&&) = delete;

  /// Writes to its stdin. False if it no longer reads: finish() says why.
  /// @throws Interrupted
  bool feed(std::span<const std::uint8_t> bytes);

  /// Closes its stdin and waits for its end. The error has its last words. @throws Interrupted
  Status finish();

 private:
  explicit Ffmpeg(const InterruptWatch& watch) : watch_(&watch) {}
  void close_input();

  const InterruptWatch* watch_;
  pid_t process_ = 0;
  int input_ = -1;
  std::FILE* words_ = nullptr;  ///< an unnamed file that takes its stderr: no pipe that could fill up
};

}  // namespace polhode
