// SPDX-License-Identifier: MIT
#include "app/session/answers/answer_log.h"

#include "lessons/claims/answers/reason_tags.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace polhode {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Whatever stands there: enough to go on counting.
int count_from(const Json& json) {
  constexpr double kMost = 1e6;
  return static_cast<int>(std::clamp(json.get<double>(), 0.0, kMost));
}

/// What the log has of one question. Logs of before 0.6 have no reasons, and of the last answer whether one
/// was right.
AnswerRecord record_from(const Json& entry) {
  AnswerRecord record;
  record.right = entry.at("right").get<bool>() ? 1 : 0;
  record.tries = count_from(entry.at("tries"));
  record.hints = count_from(entry.at("hints"));
  record.last = entry.at("last").get<std::string>();
  record.accepted = entry.value("accepted", record.right > 0 ? record.last : std::string());
  if (const auto wrong = entry.find("wrong"); wrong != entry.end())
    for (const auto& [tag, count] : wrong->items())
      if (is_reason_tag(tag)) record.wrong[tag] = count_from(count);
  return record;
}

Json json_of(const AnswerRecord& record) {
  Json entry = {
      {"right", record.right > 0}, {"tries", record.tries}, {"hints", record.hints}, {"last", record.last}};
  if (!record.accepted.empty()) entry["accepted"] = record.accepted;
  if (!record.wrong.empty()) entry["wrong"] = record.wrong;
  return entry;
}

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

fs::path answer_log_path(const fs::path& folder, const std::string& lesson_id) {
  return folder / (lesson_id + ".answers.json");
}

StateFileResult<AnswerLogReading> read_answer_log(const fs::path& path) {
  AnswerLog log;
  const auto warning = read_state_file(path, "the log of answers", [&](const Json& json) {
    for (const auto& [name, entry] : json.at("answers").items()) log[name] = record_from(entry);
  });
  if (!warning) return Failure{warning.error()};
  if (!warning->empty()) log.clear();
  return AnswerLogReading{std::move(log), *warning};
}

StateFileResult<std::string> change_answer_log(const fs::path& path,
                                               const std::function<void(AnswerLog&)>& change,
                                               std::chrono::milliseconds patience) {
  const auto lock = StateLock::take(path, patience);
  if (!lock) return Failure{lock.error()};
  auto reading = read_answer_log(path);
  if (!reading) return Failure{reading.error()};
  change(reading->log);
  Json answers = Json::object();
  for (const auto& [name, record] : reading->log) answers[name] = json_of(record);
  if (const auto written = write_state_file(path, {{"answers", answers}}); !written)
    return Failure{written.error()};
  return std::move(reading->warning);
}

}  // namespace polhode
