// SPDX-License-Identifier: MIT
// Reads aloud what the window shows, by the voices that a desktop has for screen readers: speech-dispatcher.
#pragma once

#include "app/export/background_program.h"

#include <optional>
#include <string>

namespace polhode {

class Voice {
 public:
  ~Voice() { be_quiet(); }

  /// Begins to speak, in place of what is spoken. `language`: BCP 47. The error says what is missing.
  Status say(const std::string& text, const std::string& language);
  void be_quiet();
  bool is_speaking() { return speech_ && !speech_->code(); }
  /// Why nothing is heard, once it is known; empty: nothing is wrong. Asked for a few times a second.
  std::string trouble();

 private:
  std::optional<BackgroundProgram> speech_, quiet_;  ///< that speaks, and that makes the service stop
};

}  // namespace polhode
