// SPDX-License-Identifier: MIT
// Finds lessons on disk and reads them.
#pragma once

#include "app/page/loaded_lesson.h"
#include "base/outcome.h"
#include "render/typeset/fonts.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// Where ids are looked up, first hit wins: $POLHODE_LESSONS (if set and not empty), ./lessons,
/// <program>/../share/polhode/lessons.
std::vector<std::filesystem::path> lesson_folders();

struct FoundLesson {
  std::string id;  ///< the file's name without .md
  std::filesystem::path path;
};
/// Every <folder>/<id>.md, sorted by id; of equal ids the one in the earlier folder. Folders that do not
/// exist, and documents that do not open with the +++ of a lesson's front matter, are passed over; so are
/// translations, which are the same lesson.
std::vector<FoundLesson> lessons_in(const std::vector<std::filesystem::path>& folders);

/// Those beside a lesson's file: NAME.de.md beside NAME.md.
std::vector<std::filesystem::path> translations_of(const std::filesystem::path& lesson);

/// Each lesson of lessons_in with its translations behind it; their ids are "euler-equations.de".
std::vector<FoundLesson> lessons_and_translations_in(const std::vector<std::filesystem::path>& folders);

/// `name` is an id, with a dot and a language behind it that of a translation, or a file if it has a slash or
/// ends in .md. An unknown id is a fault of usage (with "did you mean"); a file's existence is not checked
/// here.
Outcome<std::filesystem::path> find_lesson(std::string_view name,
                                           const std::vector<std::filesystem::path>& folders);

/// The text, at most one byte more than a lesson may have (the reader refuses that).
Outcome<std::string> read_lesson_text(const std::filesystem::path& path);

/// With kLintBudget. The error of an invalid lesson has all its diagnostics.
Outcome<LoadedLesson> load_lesson(std::string_view name);

/// Invalid if the fonts lack something of what the lesson says, with all diagnostics.
Done check_type_of(const LoadedLesson& loaded, const Fonts& fonts);

/// Invalid if the scene of a step cannot be, or checking that takes more than kLintBudget, with all
/// diagnostics. About 0.5 ms a step. What is more than a page holds is no fault in a window, which scrolls.
Done check_scenes_of(const LoadedLesson& loaded);

/// The stage of that id. @throws CommandError usage with "did you mean"
const Stage& stage_of(const Lesson& lesson, std::string_view id);

/// The scene of "STAGE:STEP", steps from 1, or the last one of "STAGE". @throws CommandError usage: neither,
/// with "did you mean", or no scene is shown there
const Scene& scene_of(const Lesson& lesson, std::string_view stage_and_step);

}  // namespace polhode
