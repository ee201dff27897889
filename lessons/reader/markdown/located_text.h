// SPDX-License-Identifier: MIT
// A text taken out of a lesson, and where in the lesson's file each of its bytes stands.
#pragma once

#include "lessons/diagnostics/source_text.h"
#include "render/typeset/display_list.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

class LocatedText {
 public:
  LocatedText() = default;
  /// A part of the source as it stands there.
  LocatedText(const SourceText& source, std::string_view part) { append(part, source.offset_of(part)); }

  /// Bytes that stand at `offset` of the file just so.
  void append(std::string_view bytes, std::size_t offset);
  /// Bytes that the file spells in another way, or not at all, at `offset`.
  void append_as(std::string_view bytes, std::size_t offset);

  const std::string& text() const { return text_; }
  /// Place in the file of a byte, or of the end.
  std::size_t offset_of(std::size_t at) const;
  SourceSpan span_of(std::size_t begin, std::size_t end) const;
  /// Up to where the bytes from `at` on stand in the file side by side.
  std::size_t end_of_piece(std::size_t at) const;

 private:
  struct Piece {
    std::size_t begin;   // in text_
    std::size_t offset;  // in the file
    bool verbatim;
  };
  const Piece* piece_of(std::size_t at) const;
  void add_piece(std::string_view bytes, std::size_t offset, bool verbatim);

  std::string text_;
  std::vector<Piece> pieces_;
};

/// The value of a TOML string that is written at `place` of the source: escapes and line ends are found
/// again.
LocatedText located_string(const SourceText& source, SourcePlace place, std::string_view value);

}  // namespace polhode
