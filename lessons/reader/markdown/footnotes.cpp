// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/footnotes.h"

#include "lessons/reader/markdown/inline_marks.h"

#include <algorithm>
#include <array>
#include <utility>

namespace polhode {

int FootnoteMarks::number_of(std::string_view id, std::size_t offset) {
  const auto known =
      std::find_if(marks_.begin(), marks_.end(), [&](const Mark& mark) { return mark.id == id; });
  if (known != marks_.end()) return known->number;
  // A step with more is refused; its marks are not compared with each other without end.
  if (marks_.size() <= kMaxFootnotes) marks_.push_back({std::string(id), offset, next_++});
  return marks_.back().number;
}

std::vector<FootnoteMarks::Mark> FootnoteMarks::finish_step() { return std::exchange(marks_, {}); }

std::string raised_number(int number) {
  constexpr std::array<std::string_view, 10> kDigits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string raised;
  for (const char digit : std::to_string(number)) raised += kDigits[static_cast<std::size_t>(digit - '0')];
  return raised;
}

std::optional<FootnoteOpening> footnote_opening(std::string_view line) {
  if (line.substr(0, kNoteOpening.size()) != kNoteOpening) return std::nullopt;
  const std::size_t end = line.find(']');
  if (end == line.npos || line.substr(end, 2) != "]:") return std::nullopt;
  return FootnoteOpening{line.substr(kNoteOpening.size(), end - kNoteOpening.size()), line.substr(end + 2)};
}

}  // namespace polhode
