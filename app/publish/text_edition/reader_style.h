// SPDX-License-Identifier: MIT
// The style of pages to read: assets/text_edition/reader.css, with colours for light and dark as its reader
// has it.
#pragma once

#include "lessons/reader/lesson.h"

#include <string>

namespace polhode {

/// With a class for the colour of each role of the lesson's symbols (class_of_role). Paper is always light.
std::string reader_style(const Lesson& lesson);

}  // namespace polhode
