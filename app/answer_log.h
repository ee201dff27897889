// SPDX-License-Identifier: MIT
// What a learner has answered so far, kept from one run to the next: one file for a lesson in the state
// folder (state_file.h).
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

struct AnswerRecord {
  bool right = false;  ///< was right once
  int tries = 0;       ///< that could be read
  int hints = 0;       ///< that were shown
  std::string last;    ///< answer
  bool operator==(const AnswerRecord&) const = default;
};

/// Answers of one lesson by "STAGE/ASK".
using AnswerLog = std::map<std::string, AnswerRecord>;
std::string answer_name(std::string_view stage_id, std::string_view ask_id);

void note_try(AnswerRecord& record, bool is_right, std::string_view answer);
/// Which of so many hints comes next, from 0, noted as shown; nothing if all were.
std::optional<std::size_t> note_hint(AnswerRecord& record, std::size_t hints);

/// Adds to a record what came between `before` and `now`, two moments of a copy of it: tries of both count.
void merge_record(AnswerRecord& record, const AnswerRecord& before, const AnswerRecord& now);

std::filesystem::path answer_log_path(const std::filesystem::path& folder, const std::string& lesson_id);

struct AnswerLogReading {
  AnswerLog log;
  std::string warning;  ///< of a file that was set aside, as NAME.damaged, because it is not such a log
};
/// An absent file is an empty log. @throws CommandError as read_state_file
AnswerLogReading read_answer_log(const std::filesystem::path& path);
/// Reads the log, lets `change` change it, and writes it, whole or not at all, with the folder it lies in.
/// Nothing that another process notes meanwhile is lost: one at a time does this.
/// @returns the warning of the reading
/// @throws CommandError as read_state_file; failed if it cannot be written
std::string change_answer_log(const std::filesystem::path& path,
                              const std::function<void(AnswerLog&)>& change);

}  // namespace polhode
