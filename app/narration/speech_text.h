// SPDX-License-Identifier: MIT
// Lessons as they would be read aloud: for alternative texts and transcripts. Formulas are in words, symbols
// by their letters wherever they stand. Computed numbers are those of the stills of their steps.
#pragma once

#include "app/narration/alt_text.h"
#include "app/narration/step_note.h"
#include "app/narration/still_numbers.h"
#include "lessons/reader/lesson.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// "Figure: " and the caption, or "Figure 2 of 3: " and that of a scene beside others.
struct FigureWords {
  std::string opening, caption;
  bool operator==(const FigureWords&) const = default;
};

class SpeechText {
 public:
  /// `lesson` must outlive it. `effort` is told what the motions of stills cost.
  explicit SpeechText(const Lesson& lesson, Effort effort = {});

  /// A phrase in the lesson's language: "Question: ".
  std::string opening(const Phrase& phrase) const { return std::string(phrase.in(lesson_.about.language)); }

  /// Of a formula that stands by itself: symbols are their letters, as they are printed, "vector L". Their
  /// names would run into each other, "mass velocity", and need not be known yet.
  std::string words(const Math& math) const { return words_in_line(math); }
  /// Of a formula in a line of text: "the angular momentum vector L". `before` is the line as far as there;
  /// behind "the vector" it is not said again that it is one.
  std::string words_in_line(const Math& math, std::string_view before = {}) const;
  /// Paragraphs and items of lists one after the other, in one line.
  /// `links`, if it is not null, gets those of the text, where they stand in what is returned.
  std::string words(const RichText& text, std::vector<NoteLink>* links = nullptr) const;
  std::string words(const TextBlock& block, std::vector<NoteLink>* links = nullptr) const;
  /// Of a table its head, and each row with the words of the head: "Table with the columns body, period.",
  /// "body: coin; period: 0.2 s."
  std::vector<std::string> words_of_rows(const TextTable& table) const;
  /// "Equation (5): d L over d t equals N."
  std::string words(const Equation& equation) const;
  /// "True in every motion." `scene` is that of its step; null: there is none.
  std::string words(const Claim& claim, const Scene* scene = nullptr) const;
  std::string words(const Callout& callout, std::vector<NoteLink>* links = nullptr) const;
  /// With its choices, without hints and answer.
  std::string words(const Ask& ask) const;
  /// What is right, and why: "B: the intermediate axis.", "C, A, B.", "w1*w2.", "4.19 rad/s. It is …".
  std::string words_of_answer(const Ask& ask) const;
  /// What is said to who gave this answer: the reply to the choice, and after a right one why it is right;
  /// may be empty.
  std::string words_after(const Ask& ask, const AnswerJudgement& judgement) const;
  /// "Euler's equation in vector form."
  std::string words_of_title(const Stage& stage) const;
  /// Of each scene that is shown at the step, in their order: its label and caption, and what its marks are.
  /// `shown` is the step's scene, or what a reader has made of it: in the window no filmstrip is shown.
  std::vector<SceneInWords> words_of_scenes(const Step& step, const Scene& shown) const;
  /// What is said of the step's figure: its caption, which scenes side by side may have in common, or a line
  /// for each of them.
  std::vector<FigureWords> words_of_figure(const Step& step) const;
  /// What the lesson's own plots of a scene show: "T and E against time; U against u, with the level E.";
  /// empty: there are none.
  std::string words_of_plots(const Scene& scene) const;
  /// What the marks (mark.h) of a step's scene, and of those beside it, are: "The angle theta from e z to e
  /// 3; the trail of the tip of L."; empty: none is drawn. Vectors have the names that stand in the figure,
  /// or that the lesson has printed so far; of others it is said how many there are.
  std::string words_of_marks(const Step& step) const;
  /// Of a line with formulas between dollars: "use the transport theorem with A equals L".
  std::string words_of_line(const std::string& line) const;
  /// Title, and what the steps from `first` to `last` add.
  std::string words_of_page(const Stage& stage, int first, int last) const;

 private:
  Language language() const { return lesson_.about.language; }
  std::string number_in_words(double value) const;
  /// One after the other, of this scene alone.
  std::vector<std::string> marks_in_words(const Scene& scene, std::size_t step) const;
  std::vector<std::string> captions_in_words(const Step& step, const Scene& shown) const;
  std::string words_of_tex(const std::string& tex) const;
  /// Of a name in a figure: letters, or its words in quotes.
  std::string words_of_label(const std::string& tex) const;
  std::array<std::string, 3> names_of_axes(const Scene& scene) const;
  /// What a reader of the step knows a vector by that is written so, "omega"; empty: by nothing.
  std::string words_of_vector(const std::string& written, const Scene& scene, std::size_t step) const;
  /// By its order in the lesson; that of a step of no lesson is behind all.
  std::size_t place_of(const Step& step) const;
  /// What the lesson prints in its lines and equations, and where first.
  struct Printed {
    std::map<std::string, std::size_t> names;  ///< of symbols and axes, and the steps
    std::string text;                          ///< all lines, with a blank around each
  };
  const Printed& printed() const;
  std::string words(const std::vector<TextSpan>& spans, std::vector<NoteLink>* links,
                    bool is_sentence = true) const;
  std::string words_of_caption(const Step& step, std::size_t shown) const;
  /// With these numbers; null: each as on the still of its own step.
  std::string words_in_line(const Math& math, std::string_view before,
                            const StillNumbers::Values* numbers) const;
  Math with_spoken_numbers(const Math& math, const StillNumbers::Values* numbers) const;

  const Lesson& lesson_;
  std::vector<const Step*> steps_of_numbers_;  ///< by their ids
  std::map<const Step*, std::size_t> places_;
  mutable std::optional<Printed> printed_;  ///< looked for when a mark is first spoken
  mutable StillNumbers stills_;             ///< computed when they are first spoken
};

}  // namespace polhode
