// SPDX-License-Identifier: MIT
// Markdown inside blocks, and its formulas, made ready to be set. md4c says what the Markdown means.
#pragma once

#include "lessons/diagnostics/report.h"
#include "lessons/reader/markdown/located_text.h"
#include "render/typeset/rich_text.h"

#include <cstddef>
#include <optional>

namespace polhode {

/// Text that stands together is at most so long: md4c takes time that grows with the square of it.
inline constexpr std::size_t kMaxPassageBytes = std::size_t{1} << 14;
/// All formulas of a lesson, and all its stretches of text of one kind: they bound its memory.
inline constexpr std::size_t kMaxLessonMathBytes = std::size_t{3} << 15;
inline constexpr std::size_t kMaxLessonSpans = 100'000;

/// Reads the texts of one lesson. Everything it gives counts bytes of the lesson's file; what is wrong is
/// reported where it stands, and the rest is read.
class TextReader {
 public:
  explicit TextReader(Report& report) : report_(report) {}

  Report& report() { return report_; }
  const SourceText& source() const { return report_.source(); }
  /// The author's macros, which all formulas read after them may use.
  MathMacros& macros() { return macros_; }

  /// Paragraphs and lists: emphasis, code, links, hard breaks, entities, formulas. Images, tables, HTML, and
  /// quotes are reported.
  RichText passage(const LocatedText& markdown);
  /// One paragraph, whatever its lines begin with: titles, choices.
  RichText line(const LocatedText& markdown);
  /// One line of plain text with formulas, as set_line has it, without macros: captions.
  RichText caption(const LocatedText& text);
  /// Nothing if it does not parse.
  std::optional<Math> formula(const LocatedText& tex);

 private:
  class Builder;
  RichText read(const LocatedText& markdown, bool one_paragraph);
  std::optional<Math> parse_inline(const LocatedText& text, std::size_t begin, std::size_t end,
                                   const MathMacros& macros);
  std::optional<Math> parse(const LocatedText& text, std::size_t begin, std::size_t end,
                            const MathMacros& macros);
  bool take_spans(std::size_t count, std::size_t offset);

  Report& report_;
  MathMacros macros_;
  std::size_t math_bytes_ = 0;
  std::size_t spans_ = 0;
};

}  // namespace polhode
