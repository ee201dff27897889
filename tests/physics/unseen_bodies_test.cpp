// SPDX-License-Identifier: MIT
// The accuracy bar of the exact motion, |Δω|/|ω| and |Δq| ≤ 4ε(1 + cond): on every body of the reference, one
// test each, and on a second set that nobody looked at while the formulas were made
// (tests/reference/unseen.py).
#include "physics/analysis/conditioning.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace polhode {
namespace {

using test::kEps;
using test::ReferenceCase;
using test::ReferenceState;

// Beyond it (`use` in torque_free.json) the inputs do not determine the value; the invariants still hold.
constexpr double kLargestBar = 0.1;

class Accuracy : public testing::TestWithParam<ReferenceCase> {};

TEST_P(Accuracy, IsWithinTheBar) {
  const ReferenceCase& c = GetParam();
  ASSERT_FALSE(c.states.empty());
  const auto motion = test::exact_motion(c.I, c.start);
  for (const ReferenceState& truth : c.states) {
    const RigidBodyState state = motion->at(truth.t_s);
    const double bar_w = 4 * kEps * (1 + truth.cond_w), bar_q = 4 * kEps * (1 + truth.cond_q);
    if (bar_w <= kLargestBar) {
      EXPECT_LE(test::w_error(state.w_B, truth.state.w_B), bar_w) << c.name << " " << truth.t_s;
    }
    if (bar_q <= kLargestBar) {
      EXPECT_LE(test::q_error(state.q_SB, truth.state.q_SB), bar_q) << c.name << " " << truth.t_s;
    }
    const test::Drift drift = test::drift(c.I, c.start, state);
    EXPECT_LE(drift.T, 4e-15) << c.name << " " << truth.t_s;
    EXPECT_LE(drift.L, 4e-15) << c.name << " " << truth.t_s;
    EXPECT_LE(drift.direction, 1e-14) << c.name << " " << truth.t_s;
  }
}

std::string test_name(const testing::TestParamInfo<ReferenceCase>& named) {
  std::string name = named.param.name;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Reference, Accuracy, testing::ValuesIn(test::reference_cases()), test_name);
INSTANTIATE_TEST_SUITE_P(Unseen, Accuracy, testing::ValuesIn(test::unseen_cases()), test_name);

TEST(AccuracySets, AreWhole) {
  EXPECT_EQ(test::reference_cases().size(), 52u);
  EXPECT_EQ(test::unseen_cases().size(), 60u);
  for (const ReferenceCase& c : test::unseen_cases()) EXPECT_EQ(c.states.size(), 3u) << c.name;
}

// What `measure` says of the closed form may be too much, but never too little.
TEST(ClosedFormError, IsNeverBelowTheTruth) {
  double largest = 0;
  for (const auto* cases : {&test::reference_cases(), &test::unseen_cases()})
    for (const ReferenceCase& c : *cases) {
      const auto motion = test::exact_motion(c.I, c.start);
      for (const ReferenceState& truth : c.states) {
        const RigidBodyState state = motion->at(truth.t_s);
        const double angle_rad = 2 * std::asin(std::min(1.0, test::q_error(state.q_SB, truth.state.q_SB)));
        const double bound = closed_form_error(c.I, c.start.w_B, truth.t_s);
        EXPECT_LE(test::w_error(state.w_B, truth.state.w_B), bound) << c.name << " " << truth.t_s;
        EXPECT_LE(angle_rad, bound) << c.name << " " << truth.t_s;
        largest = std::max(largest, angle_rad / bound);
      }
    }
  EXPECT_GE(largest, 0.1) << "a bound that is never come near says nothing";
}

TEST(ClosedFormError, GrowsWithTimeAndIsNeverZero) {
  const ReferenceCase& c = test::reference_case("generic_above");
  const double at_once = closed_form_error(c.I, c.start.w_B, 0);
  EXPECT_EQ(at_once, 4 * kEps);
  const double once = closed_form_error(c.I, c.start.w_B, c.period_s) - at_once,
               often = closed_form_error(c.I, c.start.w_B, -1e6 * c.period_s) - at_once;
  EXPECT_NEAR(often / once, 1e6, 16 * kEps * 1e6 * (once + at_once) / once);  // a few roundings of the sums
  const double kappa = conditioning(c.I, c.start.w_B)->phase_per_period;
  EXPECT_GE(once, kEps * kappa);
}

// After n periods the phase moves by at most n · phase_per_period per relative change of the inputs, and ω
// with it: of the order of the reference's condition number, which was made by differences of the motion
// itself.
TEST(Conditioning, AgreesWithTheReferenceInOrderOfMagnitude) {
  int compared = 0;
  for (const char* name : {"generic_above", "generic_below", "generic_above_long", "generic_below_long",
                           "sep_1e-3", "sep_1e-6", "sep_1e-9", "sep_1e-12", "sep_1e-6_long"}) {
    const ReferenceCase& c = test::reference_case(name);
    const double phase_per_period = conditioning(c.I, c.start.w_B)->phase_per_period;
    double largest = 0;  // over the states: some lie where ω turns, and hardly feel the phase
    for (const ReferenceState& truth : c.states)
      largest = std::max(largest, truth.cond_w / (1 + phase_per_period * std::abs(truth.t_s) / c.period_s));
    EXPECT_LE(largest, 10) << name;
    EXPECT_GE(largest, 0.03) << name;
    ++compared;
  }
  EXPECT_EQ(compared, 9);
}

}  // namespace
}  // namespace polhode
