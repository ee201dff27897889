// SPDX-License-Identifier: MIT
#include "app/session/answer_log.h"

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

void merge_record(AnswerRecord& record, const AnswerRecord& before, const AnswerRecord& now) {
  record.right += std::max(0, now.right - before.right);
  record.tries += std::max(0, now.tries - before.tries);
  if (now.tries > before.tries) record.last = now.last;
  if (now.hints > before.hints) record.hints = std::max(record.hints, now.hints);
}

}  // namespace

std::string answer_name(std::string_view stage_id, std::string_view ask_id) {
  return fmt::format("{}/{}", stage_id, ask_id);
}

void note_try(AnswerRecord& record, bool is_right, std::string_view answer) {
  if (is_right) ++record.right;
  record.last = answer;
  ++record.tries;
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
    for (const auto& [name, entry] : json.at("answers").items())
      log[name] = {entry.at("right").get<bool>() ? 1 : 0, count_from(entry.at("tries")),
                   count_from(entry.at("hints")), entry.at("last").get<std::string>()};
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
  for (const auto& [name, record] : reading->log)
    answers[name] = {
        {"right", record.right > 0}, {"tries", record.tries}, {"hints", record.hints}, {"last", record.last}};
  if (const auto written = write_state_file(path, {{"answers", answers}}); !written)
    return Failure{written.error()};
  return std::move(reading->warning);
}

}  // namespace polhode
