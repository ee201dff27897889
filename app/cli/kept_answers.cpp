// SPDX-License-Identifier: MIT
#include "app/cli/kept_answers.h"

#include "app/cli/command_line.h"
#include "app/cli/message.h"
#include "app/session/saved/answer_file.h"
#include "app/session/saved/state_file.h"
#include "base/spelling.h"

#include <fmt/format.h>

namespace polhode {

const Ask& ask_of(const Stage& stage, const std::string& id) {
  std::vector<std::string> ids;
  for (const Step& step : stage.steps)
    for (const Block& block : step.blocks)
      if (const auto* ask = std::get_if<Ask>(&block)) {
        if (ask->id == id) return *ask;
        ids.push_back(ask->id);
      }
  const std::string message = fmt::format("no question \"{}\" in stage \"{}\"", id, stage.id);
  if (ids.empty()) throw CommandError(ExitCode::usage, message + ": it has none");
  throw CommandError(ExitCode::usage, fmt::format("{}: {}", message, suggestion(id, ids)));
}

KeptAnswers::KeptAnswers(const std::string& lesson_id, std::string name) : name_(std::move(name)) {
  if (const auto folder = state_folder()) path_ = answer_log_path(*folder, lesson_id);
}

Status KeptAnswers::change(const Change& change) const {
  if (!path_) return failure("neither XDG_STATE_HOME nor HOME is set");
  const auto warning = change_answer_log(*path_, [&](AnswerLog& log) { change(log, name_); });
  if (!warning) return failure(warning.error().text);
  if (!warning->empty()) say("polhode: {}\n", *warning);
  return success();
}

void KeptAnswers::change_if_possible(const Change& wanted, const char* what_if_not) const {
  if (const Status changed = change(wanted); !changed) say("polhode: {}: {}\n", changed.error(), what_if_not);
}

}  // namespace polhode
