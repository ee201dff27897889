// SPDX-License-Identifier: MIT
#include "app/cli/commands/live_parts.h"

#include "app/cli/lesson_lookup.h"
#include "app/cli/or_fail.h"
#include "base/sha256.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

namespace polhode {

LiveProgram live_program() {
  if (const char* chosen = std::getenv("POLHODE_WEB"); chosen && *chosen)
    return or_fail(read_live_program({chosen}));
  return or_fail(read_live_program({"build/web", lesson_folders().back().parent_path() / "web"}));
}

std::string text_again(const LoadedLesson& loaded) {
  std::string text = or_fail(read_lesson_text(loaded.path));
  if (sha256_hex(text) != loaded.sha256)
    throw CommandError(ExitCode::failed,
                       fmt::format("lesson {} has changed meanwhile; try again", loaded.path.string()));
  return text;
}

}  // namespace polhode
