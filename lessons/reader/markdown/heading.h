// SPDX-License-Identifier: MIT
// The lines that start a stage and name a step, and words of a line with their places.
#pragma once

#include "lessons/diagnostics/report.h"
#include "lessons/reader/front_matter/keys.h"
#include "lessons/reader/markdown/inline_text.h"

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

struct Heading {
  std::string title;
  RichText title_text;
  std::string id;  ///< empty after an error
  SourcePlace id_place;
};

/// Reads `# Title {stage-id}`, line `number` of the source.
Heading read_heading(int number, TextReader& texts);

/// Reads `## Title`, line `number` of the source.
RichText read_step_title(int number, TextReader& texts);

/// The words of a line from byte `begin` on (past its end: none), at most four of them.
std::vector<PlacedText> read_words(std::string_view line, std::size_t begin, int number);

/// Without the blank characters and line ends around it.
std::string_view trimmed_lines(std::string_view text);

}  // namespace polhode
