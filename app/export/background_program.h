// SPDX-License-Identifier: MIT
// Another program that runs beside this one: nothing is written to it, what it prints is for nobody unless it
// is asked for, and what it says on stderr is kept for whoever asks why it failed.
#pragma once

#include "base/result.h"

#include <sys/types.h>

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// The end, some 600 bytes, of what a program has said to this file, without the last line's end. The place
/// in the file is not kept.
std::string last_words_in(std::FILE* words);

class BackgroundProgram {
 public:
  /// `words`: its path, or its name, which is looked up in PATH, and its arguments. The error says why it
  /// cannot be started: "there is no spd-say".
  /// `keeps_answer`: what it prints is kept too, for answer().
  static Result<BackgroundProgram> start(std::vector<std::string> words, bool keeps_answer = false);
  BackgroundProgram(BackgroundProgram&& other) noexcept;
  BackgroundProgram& operator=(BackgroundProgram&& other) noexcept;
  /// Where it still runs it goes on, alone.
  ~BackgroundProgram();

  /// Its exit code, 128 + n where signal n ended it; nothing while it runs. Does not wait.
  std::optional<int> code();
  /// Ends it by SIGTERM, and waits for that.
  void end();
  /// Of what it said on stderr.
  std::string last_words() const { return last_words_in(words_); }
  /// The beginning of what it printed, and said on stderr, some 100 KB at most.
  std::string answer() const;

 private:
  BackgroundProgram() = default;

  pid_t process_ = 0;  ///< 0: it has ended
  std::optional<int> code_;
  std::FILE* words_ = nullptr;
};

}  // namespace polhode
