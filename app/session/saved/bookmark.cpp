// SPDX-License-Identifier: MIT
#include "app/session/saved/bookmark.h"

#include "lessons/reader/reader.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace polhode {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path bookmark_path(const fs::path& folder, const std::string& lesson_id) {
  return folder / (lesson_id + ".place.json");
}

fs::path preferences_path(const fs::path& folder) { return folder / "preferences.json"; }

int step_from(const Json& json) {
  return static_cast<int>(std::clamp(json.get<double>(), 1.0, static_cast<double>(kMaxStepsPerStage)));
}

Theme theme_from(const std::string& name) {
  if (name == "paper") return Theme::paper;
  if (name == "dark") return Theme::dark;
  throw std::invalid_argument("no theme");
}

double text_scale_from(const Json& json) {
  return std::clamp(json.get<double>(), kLeastTextScale, kMostTextScale);
}

}  // namespace

StateFileResult<BookmarkReading> read_bookmark(const fs::path& folder, const std::string& lesson_id) {
  Bookmark bookmark;
  const auto warning =
      read_state_file(bookmark_path(folder, lesson_id), "the bookmark", [&](const Json& json) {
        bookmark = {json.at("stage").get<std::string>(), step_from(json.at("step")),
                    json.at("visited").get<std::set<std::string>>(),
                    json.value("left_out", std::set<std::string>())};
      });
  if (!warning) return Failure{warning.error()};
  return BookmarkReading{std::move(bookmark), *warning};
}

StateFileResult<std::monostate> write_bookmark(const fs::path& folder, const std::string& lesson_id,
                                               const Bookmark& bookmark) {
  Json json = {{"stage", bookmark.stage}, {"step", bookmark.step}, {"visited", Json(bookmark.visited)}};
  if (!bookmark.left_out.empty()) json["left_out"] = Json(bookmark.left_out);
  return write_state_file(bookmark_path(folder, lesson_id), json);
}

StateFileResult<PreferencesReading> read_preferences(const fs::path& folder) {
  Preferences preferences;
  const auto warning =
      read_state_file(preferences_path(folder), "the file of preferences", [&](const Json& json) {
        preferences = {theme_from(json.at("theme").get<std::string>()),
                       text_scale_from(json.at("text_scale")), json.at("reduced_motion").get<bool>(),
                       json.value("letter_keys", true)};
        // Before it was asked what the desktop wishes, what was not as usual was chosen.
        preferences.own_theme = json.value("own_theme", preferences.theme != Theme::paper);
        preferences.own_motion = json.value("own_motion", preferences.reduced_motion);
      });
  if (!warning) return Failure{warning.error()};
  return PreferencesReading{preferences, *warning};
}

StateFileResult<std::monostate> write_preferences(const fs::path& folder, const Preferences& preferences) {
  return write_state_file(preferences_path(folder),
                          {{"theme", preferences.theme == Theme::dark ? "dark" : "paper"},
                           {"text_scale", preferences.text_scale},
                           {"reduced_motion", preferences.reduced_motion},
                           {"letter_keys", preferences.letter_keys},
                           {"own_theme", preferences.own_theme},
                           {"own_motion", preferences.own_motion}});
}

Bookmark bookmark_of(const LessonSession& session) {
  return {session.stage().id, static_cast<int>(session.place().step) + 1, session.visited(),
          session.left_out()};
}

void restore(LessonSession& session, const Bookmark& bookmark) {
  const auto& stages = session.lesson().stages;
  const auto stage = std::find_if(stages.begin(), stages.end(),
                                  [&](const Stage& known) { return known.id == bookmark.stage; });
  if (stage != stages.end())
    session.go_to({static_cast<std::size_t>(stage - stages.begin()),
                   static_cast<std::size_t>(std::max(1, bookmark.step)) - 1});
  session.set_visited(bookmark.visited);
  session.set_left_out(bookmark.left_out);
}

}  // namespace polhode
