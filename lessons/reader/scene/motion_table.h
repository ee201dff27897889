// SPDX-License-Identifier: MIT
// Tables whose numbers are those of several motions: ```table.
#pragma once

#include "lessons/reader/front_matter/keys.h"
#include "lessons/reader/markdown/inline_text.h"
#include "lessons/reader/scene/scene_keys.h"

namespace polhode {

/// Reads the keys `columns`, `rows` and `at`. Each row changes the motion of `scene`; each column is words of
/// the rows, or a number of their motions, which is computed when the table is shown.
/// @return one table, whose head has the units of the columns; nothing where it cannot be read, which is
/// reported
RichText read_motion_table(const TomlTable& table, SourcePlace fence, const LessonScene& scene,
                           const LessonBodies& bodies, const SceneWords& words, TextReader& texts);

}  // namespace polhode
