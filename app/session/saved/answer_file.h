// SPDX-License-Identifier: MIT
// The answers of a learner (app/session/answers/answer_log.h) from one run to the next: one file for a
// lesson in the state folder (state_file.h).
#pragma once

#include "app/session/answers/answer_log.h"
#include "app/session/saved/state_file.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

namespace polhode {

std::filesystem::path answer_log_path(const std::filesystem::path& folder, const std::string& lesson_id);

struct AnswerLogReading {
  AnswerLog log;
  std::string warning;  ///< of a file that was set aside, as NAME.damaged, because it is not such a log
};
/// An absent file is an empty log. Fails as read_state_file.
StateFileResult<AnswerLogReading> read_answer_log(const std::filesystem::path& path);
/// How long one process waits for another to be done with a log.
inline constexpr std::chrono::seconds kAnswerPatience{10};
/// Reads the log, lets `change` change it, and writes it, whole or not at all, with the folder it lies in.
/// Nothing that another process notes meanwhile is lost: one at a time does this.
/// @returns the warning of the reading; fails as read_state_file, StateLock::take and write_state_file
StateFileResult<std::string> change_answer_log(const std::filesystem::path& path,
                                               const std::function<void(AnswerLog&)>& change,
                                               std::chrono::milliseconds patience = kAnswerPatience);

}  // namespace polhode
