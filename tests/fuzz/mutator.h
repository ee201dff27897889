// SPDX-License-Identifier: MIT
// Damages texts in the same way every time: for tests that nothing a reader may be given breaks it.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace polhode::testing {

/// How many inputs a test tries: `standard`, or what POLHODE_FUZZ says.
inline int fuzz_count(int standard) {
  const char* told = std::getenv("POLHODE_FUZZ");
  return told == nullptr ? standard : std::max(1, std::atoi(told));
}

class Mutator {
 public:
  /// `pieces` are what a text of this kind is made of: marks, words, bytes that do not belong there.
  Mutator(unsigned seed, std::vector<std::string> pieces) : random_(seed), pieces_(std::move(pieces)) {}

  /// The text with one to four changes.
  std::string operator()(std::string text) {
    for (int changes = 1 + below(4); changes > 0; --changes) change(text);
    return text;
  }

  int below(std::size_t n) { return n == 0 ? 0 : static_cast<int>(random_() % n); }

 private:
  void change(std::string& text) {
    const auto at = static_cast<std::size_t>(below(text.size() + 1));
    const auto length = static_cast<std::size_t>(below(40));
    switch (below(5)) {
      case 0:
        text.erase(std::min(at, text.size()), length);
        break;
      case 1:
        text.insert(at, pieces_[static_cast<std::size_t>(below(pieces_.size()))]);
        break;
      case 2:
        text.insert(at, text.substr(static_cast<std::size_t>(below(text.size() + 1)), length));
        break;
      case 3:
        text.resize(at);
        break;
      default:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
    }
  }

  std::mt19937 random_;
  std::vector<std::string> pieces_;
};

}  // namespace polhode::testing
