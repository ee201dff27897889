// SPDX-License-Identifier: MIT
// The texts of a lesson as HTML: RichText with its formulas as MathML. Whatever a lesson says is text: no
// part of it can become markup, and no link leads elsewhere than to the page itself, to the web or to a mail.
// Well-formed as XML too.
#pragma once

#include "app/narration/speech_text.h"
#include "app/page/live_numbers.h"
#include "app/publish/html_text.h"
#include "lessons/reader/lesson.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// The class of what has the colour of a role; empty: the ink of the text.
std::string class_of_role(std::string_view role);

/// The id of a step's section: "stage/step.2", from 1; no equation is called so.
std::string step_id(const Stage& stage, std::size_t step);
/// That of an equation: "stage/equation"; where links of the lesson lead.
std::string equation_id(const Stage& stage, const Equation& equation);
/// "stage/note.2"
std::string note_id(const Stage& stage, int number);

/// The computed numbers of texts as they stand still.
struct TextNumbers {
  PageNumbers shown;
  std::map<int, std::string> tex{};  ///< of those that have a value, by their ids
};

class LessonHtml {
 public:
  /// All outlive it. `numbers` has the computed ones of every text that is asked for.
  /// @param stages that are on the page, by their ids: no link leads to another
  LessonHtml(const Lesson& lesson, const SpeechText& speech, const TextNumbers& numbers,
             std::set<std::string> stages);

  /// A formula that stands by itself as a `math` element, with its words, and its TeX to copy.
  std::string formula(const Math& math, std::string_view tex) const;
  /// One in a line of text; `before` is what stands before it there.
  std::string formula_in_line(const Math& math, std::string_view tex, std::string_view before = {}) const;
  /// Paragraphs, lists and tables.
  std::string blocks(const RichText& text) const;
  /// What stands within a line. Blocks one after the other, with a blank between.
  std::string line(const RichText& text) const;
  /// A line of the program's own words with formulas between dollars, as set_line has it.
  std::string line(std::string_view words) const;
  /// What a link of the lesson leads to, as a browser takes it; empty: it leads to nothing here.
  std::string address_of(std::string_view link) const;

  /// Links to these other lessons lead to ID.html beside the page.
  void lead_to(std::set<std::string> lessons) { lessons_ = std::move(lessons); }

  /// Marks of footnotes lead from here on to those of this stage; null: nowhere.
  void number_notes_of(const Stage* stage) { stage_ = stage; }

  const Lesson& lesson() const { return lesson_; }

 private:
  std::string spans(const std::vector<TextSpan>& spans) const;
  std::string span(const TextSpan& span, std::string_view before, char32_t last) const;
  std::string formula(const Math& math, std::string_view tex, bool display, const std::string& words) const;
  std::string tex_to_copy(const Math& math, std::string_view tex) const;
  std::string reference_alone(const Math& math) const;
  std::string note_mark(const TextSpan& span) const;
  std::string table(const TextTable& table) const;

  const Lesson& lesson_;
  const SpeechText& speech_;
  const TextNumbers& numbers_;
  std::set<std::string> stages_, lessons_;
  std::vector<MathSymbol> symbols_;
  const Stage* stage_ = nullptr;
};

}  // namespace polhode
