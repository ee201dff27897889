// SPDX-License-Identifier: MIT
#include "app/window/voice.h"

#include <utility>

namespace polhode {

// It waits until all is spoken, by which it is known that it speaks.
Status Voice::say(const std::string& text, const std::string& language) {
  be_quiet();
  auto speech = BackgroundProgram::start({"spd-say", "--wait", "--application-name", "polhode", "--language",
                                          language.substr(0, language.find('-')), "--", text});
  if (!speech)
    return failure("Nothing can be read aloud: " + speech.error() +
                   "; it comes with the package speech-dispatcher.");
  speech_ = std::move(speech).value();
  return success();
}

void Voice::be_quiet() {
  if (!is_speaking()) return;
  speech_->end();
  speech_.reset();
  // What was handed over the service would speak to its end.
  if (auto quiet = BackgroundProgram::start({"spd-say", "--cancel"})) quiet_ = std::move(quiet).value();
}

std::string Voice::trouble() {
  if (quiet_ && quiet_->code()) quiet_.reset();
  if (!speech_) return {};
  const auto code = speech_->code();
  if (!code) return {};
  const std::string words = speech_->last_words();
  speech_.reset();
  return *code == 0 ? "" : "Nothing is read aloud: " + (words.empty() ? "spd-say has failed." : words);
}

}  // namespace polhode
