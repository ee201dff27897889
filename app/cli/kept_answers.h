// SPDX-License-Identifier: MIT
// Questions of a stage, and what was answered to one, where it is kept.
#pragma once

#include "app/session/answers/answer_log.h"
#include "base/result.h"
#include "lessons/reader/lesson.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace polhode {

/// @throws CommandError, with those there are, if the stage has no question of that id
const Ask& ask_of(const Stage& stage, const std::string& id);

class KeptAnswers {
 public:
  KeptAnswers(const std::string& lesson_id, std::string name);

  using Change = std::function<void(AnswerLog&, const std::string& name)>;

  /// Fails if it cannot be kept.
  Status change(const Change& change) const;

  /// A verdict, or a hint, is given also where it cannot be kept; `what_if_not` is said then.
  void change_if_possible(const Change& wanted, const char* what_if_not) const;

 private:
  std::string name_;
  std::optional<std::filesystem::path> path_;
};

}  // namespace polhode
