// SPDX-License-Identifier: MIT
#include "tests/fuzz/mutate.h"

#include <utility>

namespace polhode::fuzz {

Mutator::Mutator(std::vector<std::string> seeds, std::vector<std::string> tokens, std::uint64_t seed)
    : seeds_(std::move(seeds)), tokens_(std::move(tokens)), random_(seed) {}

std::size_t Mutator::below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random_() % n); }

std::string Mutator::next() {
  std::string text = seeds_[below(seeds_.size())];
  for (std::size_t i = below(6); i > 0; --i) change(text);
  return text;
}

void Mutator::change(std::string& text) {
  constexpr std::size_t kStretch = 24, kRepeats = 80, kLongest = 4096;
  const std::size_t at = below(text.size() + 1);
  const std::string stretch = text.substr(at, 1 + below(kStretch));
  switch (below(8)) {
    case 0:
      text.erase(at, 1 + below(kStretch));
      break;
    case 1:
      text.insert(at, tokens_[below(tokens_.size())]);
      break;
    case 2:
      text.insert(below(text.size() + 1), stretch);
      break;
    case 3:
      text.insert(at, 1, static_cast<char>(below(256)));
      break;
    case 4:
      if (at < text.size())
        text[at] = static_cast<char>(static_cast<unsigned char>(text[at]) ^ (1U << below(8)));
      break;
    case 5:
      for (std::size_t i = below(kRepeats); i > 0 && text.size() < kLongest; --i) text.insert(at, stretch);
      break;
    case 6: {
      const std::string& other = seeds_[below(seeds_.size())];
      text.insert(at, other, below(other.size() + 1));
      break;
    }
    default:
      text.replace(at, 1, tokens_[below(tokens_.size())]);
      break;
  }
}

}  // namespace polhode::fuzz
