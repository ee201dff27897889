// SPDX-License-Identifier: MIT
#include "app/session/saved_progress.h"

#include <fmt/format.h>

namespace polhode {

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// At the end, when a user who has closed the window waits for the program to be gone.
constexpr std::chrono::milliseconds kLastPatience = 500ms;

/// Brings back what there is. @param warnings gains those of the readings, a line each
StateResult<std::monostate> bring_back(Companion& companion, const fs::path& folder, std::string& warnings) {
  const auto note = [&](const std::string& warning) {
    if (!warning.empty()) warnings += (warnings.empty() ? "" : "\n") + warning;
  };
  const std::string& id = companion.lesson().id;
  const auto preferences = read_preferences(folder);
  if (!preferences) return Failure{preferences.error()};
  note(preferences->warning);
  companion.preferences = preferences->preferences;
  const auto answers = read_answer_log(answer_log_path(folder, id));
  if (!answers) return Failure{answers.error()};
  note(answers->warning);
  companion.set_answers(answers->log);
  const auto bookmark = read_bookmark(folder, id);
  if (!bookmark) return Failure{bookmark.error()};
  note(bookmark->warning);
  restore(companion, bookmark->bookmark);
  return std::monostate{};
}

constexpr const char* kNotKept = ": place and answers are not kept";

}  // namespace

Memory::Memory(Companion& companion, std::optional<std::filesystem::path> folder)
    : folder_(std::move(folder)) {
  if (!folder_) {
    news_ = "Neither XDG_STATE_HOME nor HOME is set: place and answers are not kept.";
    return;
  }
  if (const auto done = bring_back(companion, *folder_, news_); !done)
    news_ += (news_.empty() ? "" : "\n") + given_up(done.error());  // what cannot be read is not written over
  preferences_ = companion.preferences;
  answers_ = companion.answers();
  bookmark_ = bookmark_of(companion);
}

std::string Memory::keep(const Companion& companion) {
  const auto told = keep_within(companion, 0ms);
  return told ? *told : told.error().is_held ? "" : given_up(told.error());
}

std::string Memory::keep_at_last(const Companion& companion) {
  const auto told = keep_within(companion, kLastPatience);
  if (told) return *told;
  if (told.error().is_held) return fmt::format("{}: the last answers are not kept", told.error().text);
  return given_up(told.error());
}

std::string Memory::given_up(const StateError& error) {
  folder_.reset();
  return error.text + kNotKept;
}

StateResult<std::string> Memory::keep_within(const Companion& companion, std::chrono::milliseconds patience) {
  if (!folder_) return std::string();
  if (const Bookmark now = bookmark_of(companion); now != bookmark_) {
    bookmark_ = now;
    const auto written = write_bookmark(*folder_, companion.lesson().id, now);
    if (!written) return Failure{written.error()};
  }
  if (companion.preferences != preferences_) {
    preferences_ = companion.preferences;
    const auto written = write_preferences(*folder_, preferences_);
    if (!written) return Failure{written.error()};
  }
  return companion.answers() != answers_ ? keep_answers(companion, patience) : std::string();
}

/// Into what is there by now: another window, or `polhode answer`, may have been at it.
StateResult<std::string> Memory::keep_answers(const Companion& companion,
                                              std::chrono::milliseconds patience) {
  auto warning = change_answer_log(
      answer_log_path(*folder_, companion.lesson().id),
      [&](AnswerLog& log) { merge_answers(log, answers_, companion.answers()); }, patience);
  if (warning) answers_ = companion.answers();
  return warning;
}

}  // namespace polhode
