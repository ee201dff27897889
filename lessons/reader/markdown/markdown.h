// SPDX-License-Identifier: MIT
// The blocks of a Markdown text and the lines they stand on. md4c says what the blocks are.
#pragma once

#include "lessons/diagnostics/report.h"
#include "lessons/diagnostics/source_text.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// A block that is not inside another one. Lines count from 1 and both ends are included.
struct MarkdownBlock {
  enum class Kind {
    heading,
    rule,
    fence,
    quote,
    prose
  };  ///< prose: paragraphs and lists that follow one another
  Kind kind = Kind::prose;
  int first_line = 1;
  int last_line = 1;
  int level = 0;            ///< of a heading: 1…6
  bool underlined = false;  ///< of a heading: text above a line of = or -
  bool closed = true;       ///< of a fence: has its closing line
};

/// Copy of a text with the same bytes at the places that make blocks, and letters for the marks that make
/// inline Markdown: links, emphasis, code, entities, HTML. md4c takes quadratic time for some texts full of
/// such marks, and only blocks are asked of it here.
std::string without_inline_marks(std::string_view text);

/// Byte at which one line opens more than `limit` quotes and list items; nothing if none does.
std::optional<std::size_t> first_markdown_nested_deeper(std::string_view text, int limit);

struct MarkdownReading {
  std::vector<MarkdownBlock> blocks;
  bool complete = true;  ///< false: a limit was passed and reported, the rest is left out
};
/// The blocks of the lines from `first_line` to the end, in order. Reports nesting beyond kMaxNesting, more
/// blocks than kMaxParts, and headings and fences inside other blocks.
MarkdownReading read_markdown(const SourceText& source, int first_line, Report& report);

/// Level of an `#` heading line, 0 if it is none.
int heading_level(std::string_view line);
/// `---`, `***`, `___`, spaces allowed.
bool is_rule_line(std::string_view line);

}  // namespace polhode
