// SPDX-License-Identifier: MIT
// Where in a lesson words stand, or a formula: as it is read aloud, or as its author typed it.
#pragma once

#include "app/narration/speech_text.h"
#include "app/session/lesson_session.h"

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

class LessonSearch {
 public:
  /// Reads the whole lesson once.
  LessonSearch(const Lesson& lesson, const SpeechText& speech);

  struct Found {
    StepPlace place;
    std::string around;  ///< what stands there, some words of it
  };
  /// The steps that have all the words that are typed, or begin with them, in their order. Capitals do not
  /// matter, and a Greek letter is its name: "ω" is found where "omega" is. What has a sign of TeX, \ _ ^ {
  /// or
  /// =, is looked for in displayed formulas as well.
  std::vector<Found> find(std::string_view typed) const;

 private:
  struct StepText {
    StepPlace place;
    std::string words;    ///< as they are read aloud
    std::string lowered;  ///< the same, byte for byte, without capitals
    std::string tex;      ///< of its equations, without capitals and blanks
  };
  std::vector<StepText> steps_;
};

}  // namespace polhode
