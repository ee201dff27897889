// SPDX-License-Identifier: MIT
#include "lessons/claims/answers/reason_tags.h"

#include <algorithm>
#include <array>
#include <utility>

namespace polhode {

namespace {

using Row = std::pair<std::string_view, std::string_view>;

/// With a letter, and with a number, behind them.
constexpr std::string_view kChoice = "choice-", kPlace = "place-";

/// Those of answers (lessons/claims/answers/answers.h, number_answer.h) and of lines of derivations (Slip,
/// whose names they are).
constexpr std::array<Row, 25> kReasons{{
    {"degrees", "degrees and radians are mixed up"},
    {"derivative", "a derivative is left in the answer"},
    {"extra", "a term is too many"},
    {"factor", "a number as a factor is wrong"},
    {"frame", "the rate is that seen from the other frame"},
    {"goal", "the motion does not reach its goal"},
    {"index", "an index is wrong"},
    {"indices", "the indices are mixed up"},
    {"inertia", "a moment of inertia is missing or misplaced"},
    {"kind", "a vector stands where a number belongs, or a number where a vector does"},
    {"law", "Euler's law is used where it is not given"},
    {"letters", "it is written with letters that are not asked for"},
    {"missing", "a term is missing"},
    {"other", "another reason"},
    {"power", "a square or a factor is missing or too many"},
    {"power-of-ten", "it is off by a power of ten"},
    {"rate", "a derivative is missing or too many"},
    {"restated", "the question is written again"},
    {"rounding", "it is rounded too coarsely"},
    {"sign", "the sign of a term is wrong"},
    {"signs", "all signs are the other way round"},
    {"torque", "the torque is left out"},
    {"transport", "omega x … is missing"},
    {"turns", "turns and radians are mixed up"},
    {"unit", "the unit is wrong"},
}};

}  // namespace

bool is_reason_tag(std::string_view text) {
  constexpr std::size_t kMostCharacters = 24;
  return !text.empty() && text.size() <= kMostCharacters && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  });
}

bool is_known_reason(std::string_view tag, std::size_t choices) {
  if (std::any_of(kReasons.begin(), kReasons.end(), [tag](const Row& row) { return row.first == tag; }))
    return true;
  for (std::size_t i = 0; i < choices; ++i)
    if (tag == std::string(kChoice) + static_cast<char>('A' + i) ||
        tag == std::string(kPlace) + std::to_string(i + 1))
      return true;
  return false;
}

std::string words_of_reason(std::string_view tag) {
  const auto found =
      std::find_if(kReasons.begin(), kReasons.end(), [tag](const Row& row) { return row.first == tag; });
  if (found != kReasons.end()) return std::string(found->second);
  if (tag.starts_with(kChoice)) return std::string(tag.substr(kChoice.size())) + " was chosen";
  if (tag.starts_with(kPlace))
    return "the order is wrong from place " + std::string(tag.substr(kPlace.size()));
  return std::string(tag);
}

}  // namespace polhode
