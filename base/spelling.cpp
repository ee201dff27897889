// SPDX-License-Identifier: MIT
#include "base/spelling.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace polhode {
namespace {

constexpr std::size_t kMaxNameBytes = 64;
constexpr std::size_t kMinAbbreviation = 3;
constexpr std::size_t kMostListed = 32;

char lower(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = lower(c);
  return result;
}

/// One bit for each letter that occurs, capitals and small ones in one.
std::uint32_t letters_of(std::string_view name) {
  std::uint32_t letters = 0;
  for (const char c : name) letters |= 1U << (static_cast<unsigned char>(c) & 31U);
  return letters;
}

/// What is sought, and what is known of it before it is compared.
struct Sought {
  explicit Sought(std::string_view word) : text(lower(word)), letters(letters_of(word)) {}

  bool abbreviates(std::string_view name) const {
    return text.size() >= kMinAbbreviation && text.size() < name.size() &&
           std::equal(text.begin(), text.end(), name.begin(), [](char a, char b) { return a == lower(b); });
  }

  /// Quickly told: a change adds or takes two kinds of letters at most.
  bool is_far(std::string_view name, int allowed) const {
    const auto longer = std::max(text.size(), name.size()), shorter = std::min(text.size(), name.size());
    return static_cast<int>(longer - shorter) > allowed ||
           std::popcount(letters ^ letters_of(name)) > 2 * allowed;
  }

  std::string text;
  std::uint32_t letters;
};

/// `did you mean "omega"?`, or nothing.
std::string question(std::string_view word, const std::vector<std::string>& known) {
  const std::string closest = closest_name(word, {known.begin(), known.end()});
  return closest.empty() ? "" : "did you mean \"" + closest + "\"?";
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

std::string closest_name(std::string_view word, const std::vector<std::string_view>& known) {
  if (word.empty() || word.size() > kMaxNameBytes) return {};
  const Sought sought(word);
  std::string_view closest;
  int smallest = 0;
  for (const std::string_view name : known) {
    if (name.empty() || name.size() > kMaxNameBytes) continue;
    const int allowed = std::max(1, static_cast<int>(std::max(word.size(), name.size()) / 3));
    const bool abbreviated = sought.abbreviates(name);
    if (!abbreviated && sought.is_far(name, allowed)) continue;
    const int differences = abbreviated ? 1 : edit_distance(sought.text, lower(name));
    if (differences > allowed || differences >= static_cast<int>(name.size())) continue;
    const int distance = 2 * differences + (word.front() == name.front() ? 0 : 1);
    if (!closest.empty() && distance >= smallest) continue;
    closest = name;
    smallest = distance;
  }
  return std::string(closest);
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  if (known.empty()) return {};
  if (std::string asked = question(word, known); !asked.empty()) return asked;
  std::string list = known.size() == 1 ? "only " : "one of ";
  for (std::size_t i = 0; i < std::min(known.size(), kMostListed); ++i) {
    if (i > 0) list += ", ";
    list += known[i];
  }
  if (known.size() > kMostListed) list += ", …";
  return list;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::string asked = question(word, known);
  return asked.empty() ? "" : "; " + asked;
}

}  // namespace polhode
