// SPDX-License-Identifier: MIT
// Inputs that are nearly right: seeds with bytes, tokens and stretches changed, repeated, or taken from other
// seeds.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace polhode::fuzz {

class Mutator {
 public:
  /// `tokens` are put in whole: commands, brackets, odd characters.
  Mutator(std::vector<std::string> seeds, std::vector<std::string> tokens, std::uint64_t seed);
  std::string next();

 private:
  std::size_t below(std::size_t n);
  void change(std::string& text);

  std::vector<std::string> seeds_, tokens_;
  std::mt19937_64 random_;
};

}  // namespace polhode::fuzz
