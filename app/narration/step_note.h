// SPDX-License-Identifier: MIT
// What is said to a step, piece by piece.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace polhode {

/// Words that lead elsewhere.
struct NoteLink {
  std::size_t begin = 0, end = 0;  ///< bytes of the text
  std::string to;                  ///< as the texts of the lesson have it (lessons/reader/references.h)
};

/// A paragraph: plain text in one line. What is to be said (Step::notes) is for who speaks: it is in no text
/// that an audience may find behind a picture.
struct StepNote {
  enum class Kind { text, item, equation, callout, question, note, figure, to_say };
  Kind kind = Kind::text;
  std::string text;
  std::vector<NoteLink> links{};  ///< in their order
};

}  // namespace polhode
