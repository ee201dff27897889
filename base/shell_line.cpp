// SPDX-License-Identifier: MIT
#include "base/shell_line.h"

#include "base/printable.h"

#include <algorithm>
#include <string_view>

namespace polhode {

std::string shell_line(const std::vector<std::string>& words) {
  const auto quoted = [](const std::string& word) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
    if (!word.empty() && word.find_first_not_of(kPlain) == word.npos) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
    return text + "'";
  };
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + quoted(word);
  return line;
}

bool shows_as_it_is(const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(),
                     [](const std::string& word) { return shows_as_it_is(word); });
}

}  // namespace polhode
