// SPDX-License-Identifier: MIT
// Equalities that are true by construction: an expression, and what laws of algebra and mechanics make of it.
#pragma once

#include "lessons/claims/claim_state.h"
#include "tests/oracle/term.h"

#include <random>

namespace polhode::oracle {

class Rewriter {
 public:
  explicit Rewriter(std::uint64_t seed) : random_(seed) {}

  /// A term of the language, nested `depth` deep at most.
  Term scalar(int depth) { return any(false, depth, true); }
  Term vector(int depth) { return any(true, depth, true); }

  /// The same once more, one law used in one place: one that holds always, or under the assumption. May be
  /// something that cannot be read: a rate of what has none.
  Term rewritten(Term term, LawsAssumed assumption);

  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

 private:
  Term any(bool vector, int depth, bool rates);
  Term leaf(bool vector, bool rates);

  std::mt19937_64 random_;
};

}  // namespace polhode::oracle
