// SPDX-License-Identifier: MIT
// polhode list: the lessons there are.
#include "app/cli/commands/commands.h"
#include "app/cli/lesson_lookup.h"
#include "app/cli/message.h"
#include "app/cli/or_fail.h"
#include "base/printable.h"
#include "lessons/reader/reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace polhode {

namespace {

struct Entry {
  FoundLesson found;
  Lesson lesson;
};

/// Lessons that read without errors; of the others stderr says so.
std::vector<Entry> readable_lessons() {
  std::vector<Entry> entries;
  for (FoundLesson& found : lessons_and_translations_in(lesson_folders())) {
    LessonReading reading = read_lesson(or_fail(read_lesson_text(found.path)), found.path.string());
    if (reading.lesson)
      entries.push_back({std::move(found), std::move(*reading.lesson)});
    else
      say("polhode: {} has errors and is not listed; see: polhode lint {}\n", found.path.string(),
          found.path.string());
  }
  return entries;
}

void print_json(const std::vector<Entry>& entries) {
  auto json = nlohmann::ordered_json::array();
  for (const Entry& entry : entries)
    json.push_back({{"id", entry.found.id},
                    {"title", entry.lesson.title},
                    {"language", tag_of(entry.lesson.about.language)},
                    {"path", entry.found.path.string()},
                    {"stages", entry.lesson.stages.size()}});
  fmt::print("{}\n", printable(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)));
}

void print_table(const std::vector<Entry>& entries) {
  std::size_t width = 0;
  for (const Entry& entry : entries) width = std::max(width, entry.found.id.size());
  for (const Entry& entry : entries)
    fmt::print("{:<{}}  {:>3} stages  {}\n", entry.found.id, width, entry.lesson.stages.size(),
               entry.lesson.title);
}

ExitCode list(bool json) {
  const std::vector<Entry> entries = readable_lessons();
  if (json)
    print_json(entries);
  else
    print_table(entries);
  if (entries.empty()) {
    std::vector<std::string> places;
    for (const auto& folder : lesson_folders()) places.push_back(folder.string());
    say("polhode: no lessons in {}\n", fmt::join(places, ", "));
  }
  return ExitCode::done;
}

}  // namespace

ProgramCommand list_command() {
  const auto json = std::make_shared<bool>(false);
  return {"list",
          "List the lessons",
          {{"--json", json.get(), "id, title, language, path and number of stages as JSON"}},
          "Lessons are the files ID.md in $POLHODE_LESSONS, ./lessons and PROGRAM/../share/polhode/lessons;\n"
          "ID.de.md is one in German.",
          [json](const CommandWords&) { return list(*json); }};
}

}  // namespace polhode
