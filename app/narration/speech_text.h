// SPDX-License-Identifier: MIT
// Lessons as they would be read aloud: for alternative texts and transcripts. Formulas are in words, symbols
// as the lesson's `say` has them, and computed numbers those of the stills of their steps.
#pragma once

#include "app/narration/step_note.h"
#include "app/narration/still_numbers.h"
#include "lessons/reader/lesson.h"

#include <string>
#include <vector>

namespace polhode {

class SpeechText {
 public:
  /// `lesson` must outlive it. `effort` is told what the motions of stills cost.
  explicit SpeechText(const Lesson& lesson, Effort effort = {});

  std::string words(const Math& math) const;
  /// Paragraphs and items of lists one after the other, in one line.
  /// `links`, if it is not null, gets those of the text, where they stand in what is returned.
  std::string words(const RichText& text, std::vector<NoteLink>* links = nullptr) const;
  std::string words(const TextBlock& block, std::vector<NoteLink>* links = nullptr) const;
  /// Of a table its head, and each row with the words of the head: "Table with the columns body, period.",
  /// "body: coin; period: 0.2 s."
  std::vector<std::string> words_of_rows(const TextTable& table) const;
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
  /// Title, and what the steps from `first` to `last` add.
  std::string words_of_page(const Stage& stage, int first, int last) const;

 private:
  std::string words_of_line(const std::string& line) const;
  std::string words(const std::vector<TextSpan>& spans, std::vector<NoteLink>* links) const;
  /// With the numbers of the still of this step; null: each of its own.
  std::string words(const Math& math, const Step* step) const;
  Math with_spoken_numbers(const Math& math, const Step* step) const;

  const Lesson& lesson_;
  std::vector<MathSymbol> symbols_;
  std::vector<const Step*> steps_of_numbers_;  ///< by their ids
  mutable StillNumbers stills_;                ///< computed when they are first spoken
};

}  // namespace polhode
