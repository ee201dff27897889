// SPDX-License-Identifier: MIT
// Footnotes: their marks in a text, and the lines that hold what they say.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// Footnotes of one step.
inline constexpr std::size_t kMaxFootnotes = 20;

/// Numbers the marks of a stage 1, 2, … in the order in which they first stand in its text, so that all of
/// them differ on a page that shows several steps.
class FootnoteMarks {
 public:
  struct Mark {
    std::string id;
    std::size_t offset = 0;  ///< of the id in the file, where it stands first
    int number = 1;
  };

  void start_stage() { *this = {}; }
  /// The number of a mark of the present step.
  int number_of(std::string_view id, std::size_t offset);
  /// Those of the present step, in their order; the next step has none.
  std::vector<Mark> finish_step();

 private:
  std::vector<Mark> marks_;
  int next_ = 1;
};

/// "¹²"
std::string raised_number(int number);

/// The id of a line that begins a footnote, `[^id]: text`, and where its text begins. Nothing if the line is
/// none.
struct FootnoteOpening {
  std::string_view id;
  std::string_view text;  ///< the rest of the line
};
std::optional<FootnoteOpening> footnote_opening(std::string_view line);

}  // namespace polhode
