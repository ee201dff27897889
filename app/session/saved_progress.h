// SPDX-License-Identifier: MIT
// Where, with what answers and how a student left off, from one window to the next.
#pragma once

#include "app/session/bookmark.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace polhode {

/// Written when something of it changes. What cannot be kept does not stop a lesson: it is said once.
class Memory {
 public:
  /// Brings back what there is. @param folder state_folder(); nothing: nothing is kept
  Memory(Companion& companion, std::optional<std::filesystem::path> folder);
  /// What is to be told of the reading; empty: nothing.
  const std::string& news() const { return news_; }

  /// Writes what has changed, and waits for nobody: while another process has the answers, they are for the
  /// next time. @returns what is to be told; empty: nothing
  std::string keep(const Companion& companion);
  /// The same where there is no next time: waits a moment for others.
  std::string keep_at_last(const Companion& companion);

 private:
  StateResult<std::string> keep_within(const Companion& companion, std::chrono::milliseconds patience);
  StateResult<std::string> keep_answers(const Companion& companion, std::chrono::milliseconds patience);
  /// From now on nothing is kept.
  std::string given_up(const StateError& error);

  std::optional<std::filesystem::path> folder_;
  std::string news_;
  Bookmark bookmark_;
  AnswerLog answers_;
  Preferences preferences_;
};

}  // namespace polhode
