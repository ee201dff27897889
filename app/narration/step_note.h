// SPDX-License-Identifier: MIT
// What is said to a step, piece by piece.
#pragma once

#include <string>

namespace polhode {

/// A paragraph: plain text in one line.
struct StepNote {
  enum class Kind { text, item, equation, callout, question, figure };
  Kind kind = Kind::text;
  std::string text;
};

}  // namespace polhode
