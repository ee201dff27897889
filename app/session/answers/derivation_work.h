// SPDX-License-Identifier: MIT
// A learner's derivation as far as it goes: lines that were typed, and what is to be said of each.
#pragma once

#include "lessons/derivation/derivation.h"
#include "lessons/reader/lesson.h"

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

class DerivationWork {
 public:
  /// Precondition: the question is one of the lesson, of the type derive. Both must outlive it.
  DerivationWork(const Lesson& lesson, const Ask& ask);

  struct TypedLine {
    std::string text;
    LineJudgement judgement;
  };

  /// Judges a line behind those that hold. What does not hold stays to be seen until the next line is typed.
  const LineJudgement& add(std::string_view typed);
  /// Takes the last line back, or a wrong one behind it.
  void undo();
  void clear() { lines_.clear(); }

  const std::vector<TypedLine>& lines() const { return lines_; }
  /// What is being typed, to be seen as it will be set.
  void type(std::string_view line) { typing_ = line; }
  /// TeX of that; empty: nothing.
  std::string typed_tex() const;
  /// Of those that lead on.
  std::size_t count() const { return held().size(); }
  /// The goal stands behind as many lines as the lesson asks for; or it does, but they are too few.
  bool is_done() const { return is_at_goal() && count() >= least(); }
  bool is_too_short() const { return is_at_goal() && count() < least(); }
  const Derivation& derivation() const { return derivation_; }

  /// What to do next: 1 what to use, 2 how, 3 the line itself, as it is typed. Markdown of a line.
  std::string hint(int level) const;
  static constexpr int kMostHints = 3;

  /// The lines that hold, one below the other: what is kept, and read again.
  std::string text() const;
  void restore(std::string_view text);

 private:
  std::vector<DerivedLine> held() const;
  std::size_t least() const { return static_cast<std::size_t>(derivation_.least_lines); }
  bool is_at_goal() const {
    return !lines_.empty() && lines_.back().judgement.mark == LineJudgement::Mark::goal;
  }

  const Derivation& derivation_;
  LineNotation how_;
  Prover prover_;
  std::vector<TypedLine> lines_;
  std::string typing_;
};

/// A derivation has at most so many lines.
inline constexpr std::size_t kMostDerivedLines = 200;

}  // namespace polhode
