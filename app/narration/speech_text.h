// SPDX-License-Identifier: MIT
// Lessons as they would be read aloud: for alternative texts and transcripts. Formulas are in words, symbols
// as the lesson's `say` has them.
#pragma once

#include "app/narration/step_note.h"
#include "lessons/reader/lesson.h"

#include <string>
#include <vector>

namespace polhode {

class SpeechText {
 public:
  /// `lesson` must outlive it.
  explicit SpeechText(const Lesson& lesson);

  std::string words(const Math& math) const;
  /// Paragraphs and items of lists one after the other, in one line.
  /// `links`, if it is not null, gets those of the text, where they stand in what is returned.
  std::string words(const RichText& text, std::vector<NoteLink>* links = nullptr) const;
  std::string words(const TextBlock& block, std::vector<NoteLink>* links = nullptr) const;
  /// "Equation (5): d L over d t equals N."
  std::string words(const Equation& equation) const;
  /// "Motion: proved for any torque."
  std::string words(const Claim& claim) const;
  std::string words(const Callout& callout, std::vector<NoteLink>* links = nullptr) const;
  /// With its choices, without hints and answer.
  std::string words(const Ask& ask) const;
  /// "Euler's equation in vector form."
  std::string words_of_title(const Stage& stage) const;
  /// Of the step's figure (steps from 1); empty: none.
  std::string words_of_caption(const Stage& stage, int step) const;
  /// What the marks of a scene (mark.h) are, one after the other: "the arc of θ from e_z to e_3". Empty where
  /// they are not drawn.
  std::vector<std::string> words_of_marks(const Scene& scene) const;
  /// Title, and what the steps from `first` to `last` add.
  std::string words_of_page(const Stage& stage, int first, int last) const;

 private:
  std::string words_of_tex(const std::string& tex) const;
  std::string words_of_line(const std::string& line) const;

  const Lesson& lesson_;
  std::vector<MathSymbol> symbols_;
};

}  // namespace polhode
