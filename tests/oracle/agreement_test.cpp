// SPDX-License-Identifier: MIT
// lessons/claims/proof.h and GiNaC say the same of generated equalities, half of them true by construction.
#include "lessons/claims/proof.h"
#include "tests/oracle/mutants.h"
#include "tests/oracle/oracle.h"
#include "tests/oracle/rewriting.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

namespace polhode::oracle {
namespace {

constexpr std::array kAssumptions = {Assumption::identity, Assumption::motion, Assumption::free};
constexpr std::array kNames = {"identity", "motion", "free"};

Verdict verdict_of(Decision decision) {
  return decision == Decision::same        ? Verdict::holds
         : decision == Decision::different ? Verdict::fails
                                           : Verdict::undecided;
}

class Agreement : public ::testing::Test {
 protected:
  /// Of both under every assumption; what GiNaC says under `as`.
  Verdict compare(const Equality& equality, Assumption as) {
    Verdict verdict = Verdict::undecided;
    for (std::size_t i = 0; i < kAssumptions.size(); ++i) {
      const Verdict ours = prover_.settle(equality, kAssumptions[i]);
      const Verdict theirs = verdict_of(oracles_[i].compare(equality));
      EXPECT_EQ(ours, theirs) << equality.left.text << " = " << equality.right.text << "  " << kNames[i];
      ++counts_[i][static_cast<std::size_t>(theirs)];
      if (kAssumptions[i] == as) verdict = theirs;
    }
    ++equalities_;
    return verdict;
  }

  void print() const {
    int proofs = 0, by_points = 0;
    for (const Oracle& oracle : oracles_) proofs += oracle.proofs(), by_points += oracle.by_points();
    std::printf("%d equalities under 3 assumptions", equalities_);
    for (std::size_t i = 0; i < kAssumptions.size(); ++i)
      std::printf("; %s: %d hold, %d fail, %d undefined", kNames[i], counts_[i][0], counts_[i][1],
                  counts_[i][2]);
    std::printf("; %d proofs by algebra, %d components by points alone\n", proofs - by_points, by_points);
  }

  Prover prover_;
  std::array<Oracle, 3> oracles_{Oracle(Assumption::identity), Oracle(Assumption::motion),
                                 Oracle(Assumption::free)};
  std::array<std::array<int, 3>, 3> counts_{};
  int equalities_ = 0;
};

TEST_F(Agreement, OnWhatIsTrueByConstructionAndOnItsMutants) {
  constexpr int kTrue = 450;
  constexpr std::size_t kLongest = 60;  // of terms: beyond, algebra takes long and finds no more
  Rewriter rewriter(20260611);
  int made = 0, held = 0;
  for (int n = 0; made < kTrue; ++n) {
    const Assumption assumption = kAssumptions[static_cast<std::size_t>(n) % 3];
    const Term term = n % 2 == 0 ? rewriter.scalar(3) : rewriter.vector(3);
    Term other = term;
    for (std::size_t laws = 1 + rewriter.below(5); laws > 0; --laws)
      other = rewriter.rewritten(std::move(other), assumption);
    if (other == term || size_of(term) + size_of(other) > kLongest) continue;
    const auto equality = equality_from(text_of(term), text_of(other));
    if (!equality) continue;
    ++made;
    const Verdict verdict = compare(*equality, assumption);
    EXPECT_NE(verdict, Verdict::fails) << equality->left.text << " = " << equality->right.text;
    if (verdict == Verdict::holds) ++held;
    const auto mutants = mutants_of(equality->right);
    if (mutants.empty()) continue;
    const Expression& mutant = mutants[rewriter.below(mutants.size())];
    if (fit(mutant.type(), equality->left.type())) compare({equality->left, mutant}, assumption);
  }
  EXPECT_GE(equalities_, 500);
  EXPECT_GE(held, 9 * kTrue / 10) << "the others are divided by 0 everywhere";
  print();
}

TEST_F(Agreement, OnTwoExpressionsThatHaveNothingToDoWithEachOther) {
  Rewriter rewriter(7);
  while (equalities_ < 150) {
    const bool vector = equalities_ % 2 == 0;
    const Term left = vector ? rewriter.vector(2) : rewriter.scalar(2);
    const Term right = vector ? rewriter.vector(2) : rewriter.scalar(2);
    if (const auto equality = equality_from(text_of(left), text_of(right)))
      compare(*equality, Assumption::identity);
  }
  print();
}

}  // namespace
}  // namespace polhode::oracle
