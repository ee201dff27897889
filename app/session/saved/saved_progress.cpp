// SPDX-License-Identifier: MIT
#include "app/session/saved/saved_progress.h"

#include "app/session/saved/answer_file.h"

#include <fmt/format.h>

namespace polhode {

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// At the end, when a user who has closed the window waits for the program to be gone.
constexpr std::chrono::milliseconds kLastPatience = 500ms;

/// Brings back what there is. @param warnings gains those of the readings, a line each
StateFileResult<std::monostate> bring_back(LessonSession& session, const fs::path& folder,
                                           std::string& warnings) {
  const auto note = [&](const std::string& warning) {
    if (!warning.empty()) warnings += (warnings.empty() ? "" : "\n") + warning;
  };
  const std::string& id = session.lesson().id;
  const auto preferences = read_preferences(folder);
  if (!preferences) return Failure{preferences.error()};
  note(preferences->warning);
  session.preferences = preferences->preferences;
  const auto answers = read_answer_log(answer_log_path(folder, id));
  if (!answers) return Failure{answers.error()};
  note(answers->warning);
  session.set_answers(answers->log);
  const auto bookmark = read_bookmark(folder, id);
  if (!bookmark) return Failure{bookmark.error()};
  note(bookmark->warning);
  restore(session, bookmark->bookmark);
  return std::monostate{};
}

constexpr const char* kNotKept = ": place and answers are not kept";

}  // namespace

SavedProgress::SavedProgress(LessonSession& session, std::optional<std::filesystem::path> folder)
    : folder_(std::move(folder)) {
  if (!folder_) {
    notice_ = "Neither XDG_STATE_HOME nor HOME is set: place and answers are not kept.";
    return;
  }
  if (const auto done = bring_back(session, *folder_, notice_); !done)
    notice_ +=
        (notice_.empty() ? "" : "\n") + given_up(done.error());  // what cannot be read is not written over
  preferences_ = session.preferences;
  answers_ = session.answers();
  bookmark_ = bookmark_of(session);
}

std::string SavedProgress::keep(const LessonSession& session) {
  const auto told = keep_within(session, 0ms);
  return told ? *told : told.error().is_held ? "" : given_up(told.error());
}

std::string SavedProgress::keep_at_last(const LessonSession& session) {
  const auto told = keep_within(session, kLastPatience);
  if (told) return *told;
  if (told.error().is_held) return fmt::format("{}: the last answers are not kept", told.error().text);
  return given_up(told.error());
}

std::string SavedProgress::given_up(const StateFileError& error) {
  folder_.reset();
  return error.text + kNotKept;
}

StateFileResult<std::string> SavedProgress::keep_within(const LessonSession& session,
                                                        std::chrono::milliseconds patience) {
  if (!folder_) return std::string();
  if (const Bookmark now = bookmark_of(session); now != bookmark_) {
    bookmark_ = now;
    const auto written = write_bookmark(*folder_, session.lesson().id, now);
    if (!written) return Failure{written.error()};
  }
  if (session.preferences != preferences_) {
    preferences_ = session.preferences;
    const auto written = write_preferences(*folder_, preferences_);
    if (!written) return Failure{written.error()};
  }
  return session.answers() != answers_ ? keep_answers(session, patience) : std::string();
}

/// Into what is there by now: another window, or `polhode answer`, may have been at it.
StateFileResult<std::string> SavedProgress::keep_answers(const LessonSession& session,
                                                         std::chrono::milliseconds patience) {
  auto warning = change_answer_log(
      answer_log_path(*folder_, session.lesson().id),
      [&](AnswerLog& log) { merge_answers(log, answers_, session.answers()); }, patience);
  if (warning) answers_ = session.answers();
  return warning;
}

}  // namespace polhode
