// SPDX-License-Identifier: MIT
// Reads a lesson script. Takes text and a name, never a path: no files, no environment, no includes, no code.
#pragma once

#include "lessons/reader/lesson.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace polhode {

/// Checked before anything is parsed or allocated for it; each is accepted at the limit and refused one past
/// it.
inline constexpr std::size_t kMaxLessonBytes = std::size_t{1} << 20;
inline constexpr int kMaxStages = 200;
inline constexpr int kMaxStepsPerStage = 100;
inline constexpr int kMaxNesting = 16;
inline constexpr int kMaxOverlays = 40;  ///< names in one list, repeated ones too; not fewer than there are
/// Each has up to three complete scenes.
inline constexpr int kMaxStepsWithSeveral = 1000;
inline constexpr int kMaxParts = 50'000;  ///< headings, rules, blocks, claims and call-outs together

struct LessonReading {
  std::optional<Lesson> lesson;  ///< present if no diagnostic is an error
  /// In the order of their places; all that were found, not only the first, but at most 100 errors and 100
  /// warnings.
  std::vector<Diagnostic> diagnostics;
};

/// 1 MiB of anything takes at most 1 s and 64 MiB. Every refusal has at least one diagnostic with a valid
/// place.
LessonReading read_lesson(std::string_view text, std::string_view file_name);

/// One stage of a lesson in which read_lesson() found no error, in a fraction of its time: its scenes,
/// captions and labels are as there. The others have their ids, titles and one step with nothing, references
/// lead nowhere, and what is not needed for that is not checked. An id that no stage has: all are so.
LessonReading read_stage(std::string_view text, std::string_view file_name, const std::string& stage_id);

}  // namespace polhode
