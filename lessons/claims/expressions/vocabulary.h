// SPDX-License-Identifier: MIT
// The words that a lesson adds to those of expressions: its constants, and what it defines.
#pragma once

#include "lessons/claims/expressions/expression.h"

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace polhode {

/// Constants of one lesson.
inline constexpr std::size_t kMaxConstants = 16;

class Vocabulary {
 public:
  struct Word {
    std::string name;
    Expression means;
    std::string tex;  ///< as it is printed; empty: the lesson does not say

    /// The number of a constant among these, and what the lesson says that it is; nothing of what is defined.
    std::optional<std::pair<int, double>> constant() const;
  };

  /// A number that does not change. What is proved of it holds whatever it is; its value is for what is
  /// measured and shown. Precondition: a name that is not taken; where something is to be proved, fewer
  /// than kMaxConstants constants.
  void add_constant(const std::string& name, double value, std::string tex);
  /// What the name stands for, wherever it is read from now on. Precondition: a name that is not taken.
  void define(const std::string& name, Expression means, std::string tex);
  /// How a word is printed. Precondition: it is there.
  void print_as(std::string_view name, std::string tex);
  /// What is read from now on knows these no more.
  void forget(const std::set<std::string>& names);
  /// Names that will be defined later: whoever uses one now is told so.
  void announce(std::set<std::string> names) { later_ = std::move(names); }

  /// Null if there is none.
  const Word* find(std::string_view name) const;
  bool is_announced(std::string_view name) const { return later_.contains(std::string(name)); }
  const std::vector<Word>& words() const { return words_; }  ///< in the order in which they were defined
  std::vector<std::string> names() const;
  const std::shared_ptr<const std::vector<std::string>>& constants() const { return constants_; }

 private:
  std::vector<Word> words_;
  std::set<std::string> later_;
  std::shared_ptr<const std::vector<std::string>> constants_;
};

/// Why a lesson cannot have a word of this name: empty if it can. Words begin with a letter, have letters,
/// digits and _, and none is a quantity, a function, J or pi.
std::string why_no_word(std::string_view name);

}  // namespace polhode
