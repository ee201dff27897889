// SPDX-License-Identifier: MIT
#include "app/session/answers/answer_log.h"

#include "lessons/claims/answers/reason_tags.h"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

namespace {

void merge_record(AnswerRecord& record, const AnswerRecord& before, const AnswerRecord& now) {
  record.right += std::max(0, now.right - before.right);
  record.tries += std::max(0, now.tries - before.tries);
  if (now.tries > before.tries) record.last = now.last;
  if (now.hints > before.hints) record.hints = std::max(record.hints, now.hints);
  if (now.right > before.right) record.accepted = now.accepted;
  for (const auto& [tag, count] : now.wrong) {
    const auto known = before.wrong.find(tag);
    record.wrong[tag] += std::max(0, count - (known == before.wrong.end() ? 0 : known->second));
  }
  std::erase_if(record.wrong, [](const auto& reason) { return reason.second == 0; });
}

}  // namespace

std::string answer_name(std::string_view stage_id, std::string_view ask_id) {
  return fmt::format("{}/{}", stage_id, ask_id);
}

void note_try(AnswerRecord& record, bool is_right, std::string_view answer) {
  if (is_right) {
    ++record.right;
    record.accepted = answer;
  }
  record.last = answer;
  ++record.tries;
}

void note_reason(AnswerRecord& record, std::string_view tag) {
  ++record.wrong[std::string(is_reason_tag(tag) ? tag : kOtherReason)];
}

void note_judged(AnswerRecord& record, const AnswerJudgement& judgement, std::string_view answer) {
  const bool is_right = judgement.mark == AnswerJudgement::Mark::right;
  note_try(record, is_right, answer);
  if (!is_right) note_reason(record, judgement.tag);
}

std::optional<std::size_t> note_hint(AnswerRecord& record, std::size_t hints) {
  const auto shown = static_cast<std::size_t>(std::max(0, record.hints));
  if (shown >= hints) return std::nullopt;
  record.hints = static_cast<int>(shown) + 1;
  return shown;
}

std::optional<std::size_t> note_help(AnswerRecord& record, std::size_t hints) {
  if (hints == 0 && record.tries == 0) return std::nullopt;
  return note_hint(record, hints + 1);
}

void merge_answers(AnswerLog& log, const AnswerLog& before, const AnswerLog& now) {
  for (const auto& [name, record] : before)
    if (!now.contains(name)) log.erase(name);
  for (const auto& [name, record] : now) {
    const auto found = before.find(name);
    const AnswerRecord old = found == before.end() ? AnswerRecord() : found->second;
    if (record != old) merge_record(log[name], old, record);
  }
}

}  // namespace polhode
