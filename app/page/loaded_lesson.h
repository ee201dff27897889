// SPDX-License-Identifier: MIT
// A lesson as it is shown, with the file and the text that it is of.
#pragma once

#include "lessons/reader/lesson.h"

#include <filesystem>
#include <string>

namespace polhode {

/// A lesson that reads without errors and whose scenes can be modelled
/// (lessons/reader/checks/lesson_check.h).
struct LoadedLesson {
  Lesson lesson;
  std::filesystem::path path;
  std::string sha256;  ///< of the text
};

}  // namespace polhode
