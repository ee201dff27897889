// SPDX-License-Identifier: MIT
#include "app/answer_log.h"

#include "app/exit_codes.h"
#include "app/or_fail.h"
#include "render/image/atomic_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace polhode {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;

/// Whatever stands there: enough to go on counting.
int count_from(const Json& json) {
  constexpr double kMost = 1e6;
  return static_cast<int>(std::clamp(json.get<double>(), 0.0, kMost));
}

AnswerLog log_from(const std::string& text) {
  const Json json = Json::parse(text);
  if (json.at("format") != kFormat)
    throw CommandError(ExitCode::failed,
                       "the log of answers is of another version of this program; move it away");
  AnswerLog log;
  for (const auto& [name, entry] : json.at("answers").items())
    log[name] = {entry.at("right").get<bool>(), count_from(entry.at("tries")), count_from(entry.at("hints")),
                 entry.at("last").get<std::string>()};
  return log;
}

std::string text_of(const AnswerLog& log) {
  Json answers = Json::object();
  for (const auto& [name, record] : log)
    answers[name] = {
        {"right", record.right}, {"tries", record.tries}, {"hints", record.hints}, {"last", record.last}};
  return Json{{"format", kFormat}, {"answers", answers}}.dump(2, ' ', false, Json::error_handler_t::replace) +
         '\n';
}

}  // namespace

std::string answer_name(std::string_view stage_id, std::string_view ask_id) {
  return fmt::format("{}/{}", stage_id, ask_id);
}

void note_try(AnswerRecord& record, bool is_right, std::string_view answer) {
  record.right = record.right || is_right;
  record.last = answer;
  ++record.tries;
}

std::optional<std::size_t> note_hint(AnswerRecord& record, std::size_t hints) {
  const auto shown = static_cast<std::size_t>(std::max(0, record.hints));
  if (shown >= hints) return std::nullopt;
  record.hints = static_cast<int>(shown) + 1;
  return shown;
}

std::optional<fs::path> state_folder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state && fs::path(state).is_absolute()) return fs::path(state) / "polhode";
  const char* home = std::getenv("HOME");
  if (home && fs::path(home).is_absolute()) return fs::path(home) / ".local" / "state" / "polhode";
  return std::nullopt;
}

fs::path answer_log_path(const fs::path& folder, const std::string& lesson_id) {
  return folder / (lesson_id + ".answers.json");
}

AnswerLogReading read_answer_log(const fs::path& path) {
  std::error_code none;
  if (!fs::exists(path, none)) return {};
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw CommandError(ExitCode::failed, fmt::format("cannot read {}", path.string()));
  try {
    return {log_from(text), {}};
  } catch (const CommandError&) {
    throw;
  } catch (const std::exception&) {
    const fs::path aside = path.string() + ".damaged";
    std::error_code error;
    fs::rename(path, aside, error);
    if (error)
      throw CommandError(ExitCode::failed, fmt::format("{} is damaged and cannot be set aside: {}",
                                                       path.string(), error.message()));
    return {
        {},
        fmt::format("{} was damaged: it is now {}, and a new one is begun", path.string(), aside.string())};
  }
}

void write_answer_log(const fs::path& path, const AnswerLog& log) {
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error)
    throw CommandError(ExitCode::failed,
                       fmt::format("cannot make {}: {}", path.parent_path().string(), error.message()));
  const std::string text = text_of(log);
  or_fail(write_file_atomically(
      path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), Durability::sync));
}

}  // namespace polhode
