// SPDX-License-Identifier: MIT
// What `polhode export --live` puts into pages.
#pragma once

#include "app/page/loaded_lesson.h"
#include "app/publish/live/live_program.h"

#include <string>

namespace polhode {

/// Looked for in $POLHODE_WEB alone, if set and not empty; else where ./web builds it in a source folder, and
/// where it is installed beside the lessons. @throws CommandError
LiveProgram live_program();

/// The lesson's text once more, the same as was read before. @throws CommandError
std::string text_again(const LoadedLesson& loaded);

}  // namespace polhode
