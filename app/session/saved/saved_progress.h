// SPDX-License-Identifier: MIT
// Where, with what answers and how a student left off, from one window to the next.
#pragma once

#include "app/session/saved/bookmark.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace polhode {

/// Written when something of it changes. What cannot be kept does not stop a lesson: it is said once.
class SavedProgress {
 public:
  /// Brings back what there is. @param folder state_folder(); nothing: nothing is kept
  SavedProgress(LessonSession& session, std::optional<std::filesystem::path> folder);
  /// What is to be told of the reading; empty: nothing.
  const std::string& notice() const { return notice_; }

  /// Writes what has changed, and waits for nobody: while another process has the answers, they are for the
  /// next time. @returns what is to be told; empty: nothing
  std::string keep(const LessonSession& session);
  /// The same where there is no next time: waits a moment for others.
  std::string keep_at_last(const LessonSession& session);

 private:
  StateFileResult<std::string> keep_within(const LessonSession& session, std::chrono::milliseconds patience);
  StateFileResult<std::string> keep_answers(const LessonSession& session, std::chrono::milliseconds patience);
  /// From now on nothing is kept.
  std::string given_up(const StateFileError& error);

  std::optional<std::filesystem::path> folder_;
  std::string notice_;
  Bookmark bookmark_;
  AnswerLog answers_;
  Preferences preferences_;
};

}  // namespace polhode
