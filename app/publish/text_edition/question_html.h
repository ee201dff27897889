// SPDX-License-Identifier: MIT
// Questions of a text edition. Without script a question can be read, and its hints and its answer opened;
// with the page's script choices, orders and numbers are judged on the spot, and nothing of it is kept.
#pragma once

#include "app/publish/text_edition/lesson_html.h"

#include <string>

namespace polhode {

/// The question with its choices, hints, and the answer with the reply to each choice and why it is right.
/// @param shown what the motion does, as HTML, behind the answer; may be empty
std::string question_html(const LessonHtml& html, const Stage& stage, const Ask& ask,
                          const std::string& shown);

}  // namespace polhode
