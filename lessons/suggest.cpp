// SPDX-License-Identifier: MIT
#include "lessons/suggest.h"

#include <algorithm>
#include <cctype>

namespace polhode {
namespace {

constexpr std::size_t kMaxNameBytes = 64;
constexpr std::size_t kMaxListed = 32;
constexpr std::size_t kMinAbbreviation = 3;

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  // Rows of the table for prefixes of a: the one before the last, the last, this one.
  std::vector<int> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::optional<std::string> nearest_name(std::string_view word, const std::vector<std::string>& known) {
  if (word.empty() || word.size() > kMaxNameBytes) return std::nullopt;
  const std::string sought = lower(word);
  std::optional<std::string> nearest;
  int smallest = 0;
  for (const std::string& name : known) {
    if (name.size() > kMaxNameBytes) continue;
    const bool abbreviated =
        sought.size() >= kMinAbbreviation && lower(name).compare(0, sought.size(), sought) == 0;
    const int distance = abbreviated ? 1 : edit_distance(sought, lower(name));
    const int allowed = std::max(1, static_cast<int>(std::max(word.size(), name.size()) / 3));
    if (distance > allowed || (nearest && distance >= smallest)) continue;
    nearest = name;
    smallest = distance;
  }
  return nearest;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  if (known.empty()) return {};
  if (const auto nearest = nearest_name(word, known)) return "did you mean \"" + *nearest + "\"?";
  std::string list = known.size() == 1 ? "only " : "one of ";
  for (std::size_t i = 0; i < std::min(known.size(), kMaxListed); ++i) {
    if (i > 0) list += ", ";
    list += known[i];
  }
  if (known.size() > kMaxListed) list += ", …";
  return list;
}

}  // namespace polhode
