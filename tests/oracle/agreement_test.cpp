// SPDX-License-Identifier: MIT
// lessons/claims/proof/proof.h and GiNaC say the same of generated equalities, half of them true by
// construction.
#include "lessons/claims/proof/proof.h"
#include "tests/oracle/mutants.h"
#include "tests/oracle/oracle.h"
#include "tests/oracle/rewriting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace polhode::oracle {
namespace {

constexpr std::array kAssumptions = {LawsAssumed::identity, LawsAssumed::motion, LawsAssumed::free};
constexpr std::array kNames = {"identity", "motion", "free"};

Verdict verdict_of(Decision decision) {
  return decision == Decision::same        ? Verdict::holds
         : decision == Decision::different ? Verdict::fails
                                           : Verdict::undecided;
}

/// Second rates of long terms fill pages of algebra; they have tests of their own below.
bool is_long(const Equality& equality) {
  constexpr std::size_t kLongest = 16;
  return std::max(equality.left.order(), equality.right.order()) > 1 &&
         equality.left.nodes.size() + equality.right.nodes.size() > kLongest;
}

class Agreement : public ::testing::Test {
 protected:
  /// Of both under every assumption; what GiNaC says under `as`.
  Verdict compare(const Equality& equality, LawsAssumed as) {
    Verdict verdict = Verdict::undecided;
    for (std::size_t i = 0; i < kAssumptions.size(); ++i) {
      const Verdict ours = prover_.settle(equality, kAssumptions[i]);
      const Decision decision = oracles_[i].compare(equality);
      const Verdict theirs = verdict_of(decision);
      EXPECT_EQ(ours, theirs) << equality.left.text << " = " << equality.right.text << "  " << kNames[i];
      ++counts_[i][static_cast<std::size_t>(decision)];
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
  std::array<Oracle, 3> oracles_{Oracle(LawsAssumed::identity), Oracle(LawsAssumed::motion),
                                 Oracle(LawsAssumed::free)};
  std::array<std::array<int, 3>, 3> counts_{};  // by assumption and Decision
  int equalities_ = 0;
};

TEST_F(Agreement, OnWhatIsTrueByConstructionAndOnItsMutants) {
  constexpr int kTrue = 450;
  constexpr std::size_t kLongest = 60;  // of terms: beyond, algebra takes long and finds no more
  Rewriter rewriter(20260611);
  int made = 0, held = 0;
  for (int n = 0; made < kTrue; ++n) {
    const LawsAssumed assumption = kAssumptions[static_cast<std::size_t>(n) % 3];
    const Term term = n % 2 == 0 ? rewriter.scalar(3) : rewriter.vector(3);
    Term other = term;
    for (std::size_t laws = 1 + rewriter.below(5); laws > 0; --laws)
      other = rewriter.rewritten(std::move(other), assumption);
    if (other == term || size_of(term) + size_of(other) > kLongest) continue;
    const auto equality = equality_from(text_of(term), text_of(other));
    if (!equality || is_long(*equality)) continue;
    ++made;
    const Verdict verdict = compare(*equality, assumption);
    EXPECT_NE(verdict, Verdict::fails) << equality->left.text << " = " << equality->right.text;
    if (verdict == Verdict::holds) ++held;
    const auto mutants = mutants_of(equality->right);
    if (mutants.empty()) continue;
    const Expression& mutant = mutants[rewriter.below(mutants.size())];
    if (fit(mutant.type(), equality->left.type()) && !is_long({equality->left, mutant}))
      compare({equality->left, mutant}, assumption);
  }
  EXPECT_GE(equalities_, 500);
  EXPECT_GE(held, 9 * kTrue / 10) << "the others are divided by 0 everywhere";
  print();
}

/// "I2 = I1", each.
Given given_by(const std::vector<std::string>& settings) {
  Given given;
  for (const std::string& text : settings) {
    const std::size_t equals = text.find(" = ");
    const Expression left = expression_from(text.substr(0, equals)).value();
    given.settings.push_back(
        {left.nodes.back().quantity, expression_from(text.substr(equals + 3)).value(), text, {}, {}});
    EXPECT_FALSE(why_not_set(given.settings.back(), {given.settings.begin(), given.settings.end() - 1}));
  }
  return given;
}

// Tops, a plate, a torque by components, axes of space: what holds of them, and all its mutants.
TEST_F(Agreement, OnWhatIsGivenAndOnTheAxesOfSpace) {
  struct Case {
    std::vector<std::string> given;
    LawsAssumed assumption;
    std::vector<std::pair<const char*, const char*>> equal;
  };
  const std::string symmetric = "I2 = I1", heavy = "N = h*cross(ez, e3)";
  const Case cases[] = {
      {{symmetric},
       LawsAssumed::free,
       {{"dw3", "0"},
        {"dw1", "(I1 - I3)/I1*w2*w3"},
        {"ddt(w1^2 + w2^2)", "0"},
        {"ddt(e3)", "cross(L/I1, e3)"}}},
      {{symmetric},
       LawsAssumed::identity,
       {{"omega", "L/I1 + (I1 - I3)/I1*w3*e3"}, {"2*T", "I1*(w1^2 + w2^2) + I3*w3^2"}}},
      {{heavy},
       LawsAssumed::motion,
       {{"ddt(T + h*dot(ez, e3))", "0"}, {"ddt(dot(L, ez))", "0"}, {"dw3", "(I1 - I2)*w1*w2/I3"}}},
      {{symmetric, heavy}, LawsAssumed::motion, {{"ddt(dot(L, e3))", "0"}, {"dot(ddt(L), ez)", "0"}}},
      {{"I3 = I1 + I2"}, LawsAssumed::free, {{"dw1", "-w2*w3"}, {"dw2", "w3*w1"}}},
      {{"I1 = I3", "I2 = (I1 + I3)/2"}, LawsAssumed::motion, {{"ddt(omega)", "N/I3"}}},
      {{"N1 = -k*w1", "N2 = -k*w2", "N3 = -k*w3"}, LawsAssumed::motion, {{"ddt(T)", "-k*norm2(omega)"}}},
      {{"w1 = 0", "w2 = 0"}, LawsAssumed::identity, {{"L", "I3*omega"}, {"cross(omega, L)", "0"}}},
      {{symmetric}, LawsAssumed::free, {{"ddt(dw1)", "-((I1 - I3)/I1*w3)^2*w1"}, {"ddt(ddt(T))", "0"}}},
      {{symmetric, heavy},
       LawsAssumed::motion,
       {{"I1*ddt(ddt(dot(ez, e3)))",
         "I3*w3*dot(ez, omega - w3*e3) - h*(1 - dot(ez, e3)^2) - I1*dot(ez, e3)*norm2(cross(omega, e3))"},
        {"ddt(ddt(L))", "h*cross(ez, cross(omega, e3))"}}},
      {{},
       LawsAssumed::motion,
       {{"I1*ddt(dw1)", "(I2 - I3)*(dw2*w3 + w2*dw3) + ddt(N1)"}, {"m*ddt(ddt(v))", "ddt(F)"}}},
      {{},
       LawsAssumed::identity,
       {{"ddt(ddt(A))",
         "star(star(A)) + 2*cross(omega, star(A)) + cross(star(omega), A) + cross(omega, cross(omega, A))"},
        {"ddt(ddt(w1/w2))", "(ddt(dw1)*w2^2 - w1*w2*ddt(dw2) - 2*dw1*dw2*w2 + 2*w1*dw2^2)/w2^3"}}},
      {{"F = -h*ez"}, LawsAssumed::motion, {{"dot(ddt(p), ez)", "-h"}, {"ddt(dot(p, ex))", "0"}}},
      {{}, LawsAssumed::identity, {{"star(ez)", "cross(ez, omega)"}, {"ex", "cross(ey, ez)"}}},
  };
  int mutants = 0, held = 0;
  for (const Case& c : cases) {
    const Given given = given_by(c.given);
    const Oracle oracle(c.assumption, given);
    const auto agree = [&](const Equality& equality) {
      const Verdict ours = prover_.settle(equality, c.assumption, given);
      EXPECT_EQ(ours, verdict_of(oracle.compare(equality)))
          << equality.left.text << " = " << equality.right.text;
      return ours;
    };
    for (const auto& [left, right] : c.equal) {
      const Equality equality = equality_from(left, right).value();
      EXPECT_EQ(agree(equality), Verdict::holds) << left << " = " << right;
      for (const bool of_left : {true, false})
        for (Expression& mutant : mutants_of(of_left ? equality.left : equality.right)) {
          Equality changed = of_left ? Equality{std::move(mutant), equality.right}
                                     : Equality{equality.left, std::move(mutant)};
          if (!fit(changed.left.type(), changed.right.type())) continue;
          ++mutants;
          held += agree(changed) == Verdict::holds ? 1 : 0;
        }
    }
  }
  EXPECT_GE(mutants, 600);
  std::printf("%d mutants of what is given; %d of them say the same or something else that is true\n",
              mutants, held);
}

TEST_F(Agreement, OnTwoExpressionsThatHaveNothingToDoWithEachOther) {
  Rewriter rewriter(7);
  while (equalities_ < 150) {
    const bool vector = equalities_ % 2 == 0;
    const Term left = vector ? rewriter.vector(2) : rewriter.scalar(2);
    const Term right = vector ? rewriter.vector(2) : rewriter.scalar(2);
    if (const auto equality = equality_from(text_of(left), text_of(right)); equality && !is_long(*equality))
      compare(*equality, LawsAssumed::identity);
  }
  print();
}

}  // namespace
}  // namespace polhode::oracle
