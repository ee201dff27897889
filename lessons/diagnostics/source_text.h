// SPDX-License-Identifier: MIT
// A lesson's text with its lines, and whether it is text at all.
#pragma once

#include "lessons/diagnostics/diagnostic.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// A text and where its lines begin. Lines and columns count from 1; a column counts characters (UTF-8), not
/// bytes. Holds a view: the text must live longer.
class SourceText {
 public:
  explicit SourceText(std::string_view text);

  std::string_view text() const { return text_; }
  /// At least 1; a text that ends with a line feed has an empty last line.
  int line_count() const { return static_cast<int>(begins_.size()); }
  /// Without its line end. Precondition: 1 ≤ line ≤ line_count().
  std::string_view line(int line) const;
  /// Lines first…last with their line ends but the last one's; empty if last < first.
  std::string_view lines(int first, int last) const;
  std::size_t begin_of(int line) const { return begins_[static_cast<std::size_t>(line - 1)]; }
  /// Line that holds the byte at `offset` (at most the size of the text).
  int line_of(std::size_t offset) const;
  SourcePlace place_of(std::size_t offset) const;
  /// Place of a view into this text.
  SourcePlace place_of(std::string_view part) const { return place_of(offset_of(part)); }
  /// Byte where a view into this text begins.
  std::size_t offset_of(std::string_view part) const {
    return static_cast<std::size_t>(part.data() - text_.data());
  }
  /// Byte of the nearest place that exists.
  std::size_t offset_of(SourcePlace place) const;
  /// The nearest place that exists.
  SourcePlace clamp(SourcePlace place) const;

 private:
  std::string_view text_;
  std::vector<std::size_t> begins_;
};

/// The place `offset` bytes after `start` on the same line.
SourcePlace advanced(SourcePlace start, std::string_view line, std::size_t offset);

/// Spaces, tabs and carriage returns taken off both ends.
std::string_view trimmed(std::string_view text);

/// True if there is nothing but spaces and tabs.
bool is_blank(std::string_view line);

/// True if a UTF-8 text is one line that shows as it is written: no line feed or other control character
/// (U+0000-1F, U+007F-9F), no override of the writing direction (U+202A-2E, U+2066-69).
bool is_plain_line(std::string_view utf8);

struct NotText {
  std::size_t offset;
  std::string message;
  std::string hint;
};
/// Why this is no text a lesson can be: the first byte that is not UTF-8, or a control character (U+0000-1F,
/// U+007F-9F) other than tab, line feed and carriage return before a line feed. Linear.
std::optional<NotText> why_not_text(std::string_view bytes);

}  // namespace polhode
