// SPDX-License-Identifier: MIT
// Where a student was in a lesson, and how they like it, from one run to the next: files in the state folder
// (app/session/saved/state_file.h). Damaged ones are set aside as NAME.damaged, and all starts clean; one of
// another version of the program stays as it is and is refused.
#pragma once

#include "app/session/lesson_session.h"
#include "app/session/saved/state_file.h"

#include <filesystem>
#include <set>
#include <string>

namespace polhode {

/// <lesson>.place.json
struct Bookmark {
  std::string stage;  ///< id; empty: none
  int step = 1;       ///< from 1
  std::set<std::string> visited;
  std::set<std::string> left_out{};  ///< stages that are not for this class
  bool operator==(const Bookmark&) const = default;
};
struct BookmarkReading {
  Bookmark bookmark;
  std::string warning;  ///< of a file that was set aside
};
/// An absent file is an empty bookmark. Fails as read_state_file.
StateFileResult<BookmarkReading> read_bookmark(const std::filesystem::path& folder,
                                               const std::string& lesson_id);
/// As write_state_file.
StateFileResult<std::monostate> write_bookmark(const std::filesystem::path& folder,
                                               const std::string& lesson_id, const Bookmark& bookmark);

/// preferences.json
struct PreferencesReading {
  Preferences preferences;
  std::string warning;
};
/// Fails as read_state_file.
StateFileResult<PreferencesReading> read_preferences(const std::filesystem::path& folder);
/// As write_state_file.
StateFileResult<std::monostate> write_preferences(const std::filesystem::path& folder,
                                                  const Preferences& preferences);

Bookmark bookmark_of(const LessonSession& session);
/// Stages and steps that the lesson no longer has are passed over.
void restore(LessonSession& session, const Bookmark& bookmark);

}  // namespace polhode
