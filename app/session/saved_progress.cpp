// SPDX-License-Identifier: MIT
#include "app/session/saved_progress.h"

#include "app/session/state_file.h"

#include <fmt/format.h>

namespace polhode {

namespace {

using namespace std::chrono_literals;

/// At the end, when a user who has closed the window waits for the program to be gone.
constexpr std::chrono::milliseconds kLastPatience = 500ms;

}  // namespace

Memory::Memory(Companion& companion, std::optional<std::filesystem::path> folder)
    : folder_(std::move(folder)) {
  if (!folder_) {
    news_ = "Neither XDG_STATE_HOME nor HOME is set: place and answers are not kept.";
    return;
  }
  const std::string& id = companion.lesson().id;
  const auto note = [&](const std::string& warning) {
    if (!warning.empty()) news_ += (news_.empty() ? "" : "\n") + warning;
  };
  try {
    const PreferencesReading preferences = read_preferences(*folder_);
    note(preferences.warning);
    companion.preferences = preferences.preferences;
    AnswerLogReading answers = read_answer_log(answer_log_path(*folder_, id));
    note(answers.warning);
    companion.set_answers(std::move(answers.log));
    const BookmarkReading bookmark = read_bookmark(*folder_, id);
    note(bookmark.warning);
    restore(companion, bookmark.bookmark);
  } catch (const CommandError& error) {
    note(std::string(error.what()) + ": place and answers are not kept");
    folder_.reset();  // what cannot be read is not written over
  }
  preferences_ = companion.preferences;
  answers_ = companion.answers();
  bookmark_ = bookmark_of(companion);
}

std::string Memory::keep(const Companion& companion) try {
  return keep_within(companion, 0ms);
} catch (const StateIsHeld&) {
  return {};
}

std::string Memory::keep_at_last(const Companion& companion) try {
  return keep_within(companion, kLastPatience);
} catch (const StateIsHeld& error) {
  return fmt::format("{}: the last answers are not kept", error.what());
}

std::string Memory::keep_within(const Companion& companion, std::chrono::milliseconds patience) {
  if (!folder_) return {};
  try {
    if (const Bookmark now = bookmark_of(companion); now != bookmark_)
      write_bookmark(*folder_, companion.lesson().id, bookmark_ = now);
    if (companion.preferences != preferences_)
      write_preferences(*folder_, preferences_ = companion.preferences);
    return companion.answers() != answers_ ? keep_answers(companion, patience) : "";
  } catch (const StateIsHeld&) {
    throw;
  } catch (const CommandError& error) {
    folder_.reset();
    return std::string(error.what()) + ": place and answers are not kept";
  }
}

/// Into what is there by now: another window, or `polhode answer`, may have been at it.
std::string Memory::keep_answers(const Companion& companion, std::chrono::milliseconds patience) {
  const std::string warning = change_answer_log(
      answer_log_path(*folder_, companion.lesson().id),
      [&](AnswerLog& log) { merge_answers(log, answers_, companion.answers()); }, patience);
  answers_ = companion.answers();
  return warning;
}

}  // namespace polhode
