// SPDX-License-Identifier: MIT
// Markdown inside blocks, and its formulas, made ready to be set. md4c says what the Markdown means.
#pragma once

#include "lessons/claims/expressions/dimension.h"
#include "lessons/diagnostics/report.h"
#include "lessons/reader/checks/numbers/computed_number.h"
#include "lessons/reader/markdown/footnotes.h"
#include "lessons/reader/markdown/located_text.h"
#include "render/typeset/rich_text.h"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace polhode {

/// Text that stands together is at most so long: md4c takes time that grows with the square of it.
inline constexpr std::size_t kMaxPassageBytes = std::size_t{1} << 14;
/// All formulas of a lesson, and all its stretches of text of one kind: they bound its memory.
inline constexpr std::size_t kMaxLessonMathBytes = std::size_t{3} << 15;
inline constexpr std::size_t kMaxLessonSpans = 100'000;
/// Computed numbers of a lesson.
inline constexpr std::size_t kMaxNumbers = 1000;
/// Of a table; its head is no row.
inline constexpr std::size_t kMaxTableColumns = 12, kMaxTableRows = 64;

/// Reads the texts of one lesson. Everything it gives counts bytes of the lesson's file; what is wrong is
/// reported where it stands, and the rest is read.
class TextReader {
 public:
  explicit TextReader(Report& report) : report_(report) {}

  Report& report() { return report_; }
  const SourceText& source() const { return report_.source(); }
  /// The author's macros, which all formulas read after them may use.
  MathMacros& macros() { return macros_; }
  /// What a macro stands for, and where: a mistake in it is reported there, once.
  void locate_macro(const std::string& name, LocatedText body) { macro_bodies_[name] = std::move(body); }
  /// Marks of footnotes in passages are taken into account here.
  FootnoteMarks& notes() { return notes_; }
  /// What can be cited: true once it is.
  std::map<std::string, bool>& citable() { return citable_; }

  /// What the lesson is written in: that of all formulas read after it.
  void write_in(Language language) { written_in_ = language; }
  Language written_in() const { return written_in_; }

  /// From now on formulas may show computed numbers, whose expressions are in these words; `dimensions` are
  /// those of constants, by their numbers. Before, and in lines, \live and \value are errors.
  void speak(const Vocabulary& vocabulary, const std::map<int, Dimension>& dimensions) {
    language_.emplace(Speech{vocabulary, dimensions});
    add_motion_words(language_->vocabulary, language_->dimensions);
  }
  /// A number as it is written, with the places of its expression and its unit. Nothing, and a report, where
  /// one of them is wrong, or where there is no language yet.
  std::optional<ComputedNumber> computed_number(const LiveNumber& written, SourcePlace place,
                                                SourcePlace unit_place);
  /// A formula that shows this number alone. Nothing, and a report, where the lesson has too many.
  std::optional<Math> formula_of(ComputedNumber number);
  /// The words of computed numbers. Precondition: speak was called.
  const Vocabulary& vocabulary() const { return language_->vocabulary; }
  /// The dimensions of their constants, by their numbers. Precondition: speak was called.
  const std::map<int, Dimension>& dimensions() const { return language_->dimensions; }
  /// Those of all formulas read so far, by their ids.
  std::vector<ComputedNumber> take_numbers() { return std::move(numbers_); }

  /// Paragraphs, lists and tables: emphasis, code, links, hard breaks, entities, formulas, marks of
  /// footnotes, citations. Images, HTML, and quotes are reported. A link without text has one empty span:
  /// what is shown is what it leads to (references.h).
  RichText passage(const LocatedText& markdown);
  /// A footnote's text: a passage without marks of footnotes.
  RichText note(const LocatedText& markdown);
  /// One paragraph, whatever its lines begin with: titles, choices.
  RichText line(const LocatedText& markdown);
  /// One line of plain text with formulas, as set_line has it, without macros: captions.
  RichText caption(const LocatedText& text);
  /// A formula that stands in a figure, without macros. Empty if it does not parse.
  RichText label(const LocatedText& tex);
  /// Nothing if it does not parse.
  std::optional<Math> formula(const LocatedText& tex);

 private:
  class Builder;
  enum class Form { passage, note, line };
  RichText read(const LocatedText& markdown, Form form);
  std::optional<TextSpan> formula_in_figure(const LocatedText& text, std::size_t begin, std::size_t end);
  std::optional<Math> parse_inline(const LocatedText& text, std::size_t begin, std::size_t end,
                                   const MathMacros& macros, bool may_compute = true);
  std::optional<Math> parse(const LocatedText& text, std::size_t begin, std::size_t end,
                            const MathMacros& macros, bool may_compute = true);
  bool has_room_for_number(SourcePlace place);
  bool take_numbers_of(Math& math, const LocatedText& text, std::size_t begin, bool may_compute);
  bool take_unit(ComputedNumber& number, SourcePlace place);
  void report(const TypeError& error, SourcePlace used_at);
  bool take_spans(std::size_t count, std::size_t offset);

  Report& report_;
  MathMacros macros_;
  std::map<std::string, LocatedText> macro_bodies_;
  std::set<std::tuple<std::string, std::size_t, std::string>> said_of_macros_;
  FootnoteMarks notes_;
  std::map<std::string, bool> citable_;
  Language written_in_ = Language::en;
  struct Speech {
    Vocabulary vocabulary;
    std::map<int, Dimension> dimensions;
  };
  std::optional<Speech> language_;
  std::vector<ComputedNumber> numbers_;
  /// Formulas of the lesson that were read, by their TeX and how many macros there were: \vec\omega stands
  /// everywhere.
  std::map<std::pair<std::size_t, std::string>, Math, std::less<>> known_formulas_;
  std::size_t math_bytes_ = 0;
  std::size_t spans_ = 0;
};

}  // namespace polhode
