// SPDX-License-Identifier: MIT
#include "app/session/saved/answer_file.h"

#include "lessons/claims/answers/reason_tags.h"

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

}  // namespace

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
