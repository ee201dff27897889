// SPDX-License-Identifier: MIT
#include "physics/analysis/batch.h"

#include "physics/effort.h"
#include "physics/method.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <vector>

namespace polhode {
namespace {

std::vector<double> times(std::size_t count) {
  test::Random random(7);
  std::vector<double> t_s(count);
  for (double& t : t_s) t = random.uniform(-1e3, 1e3);
  if (count > 5) t_s[5] = 0;
  return t_s;
}

void expect_same_as_one_by_one(const Motion& motion, std::size_t count, unsigned threads) {
  const std::vector<double> t_s = times(count);
  std::vector<RigidBodyState> states(count);
  states_at(motion, t_s, states, threads);
  for (std::size_t i = 0; i < count; ++i)
    ASSERT_TRUE(test::same_bits(states[i], motion.at(t_s[i])))
        << motion.method() << " " << i << " of " << count;
}

// One body for each series of the asymmetric motion, and motions that only loop.
TEST(Batch, GivesTheBitsOfOneByOne) {
  const PrincipalMoments I(1, 1.75, 2.5);
  const std::vector<Problem> problems{{I, {Quat::Identity(), {0.2, 0.1, 3}}, {}},
                                      {I, {Quat::Identity(), {0.2, 3, 0.201}}, {}},
                                      {PrincipalMoments(1, 2, 3), {Quat::Identity(), {3, 1, 1}}, {}},
                                      {PrincipalMoments(1, 1, 1.5), {Quat::Identity(), {3, 1, 1}}, {}}};
  for (const Problem& problem : problems) {
    const auto motion = make_motion(problem, {Method::exact, {}, {}});
    for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 1000u})
      for (const unsigned threads : {1u, 2u, 3u, 7u}) expect_same_as_one_by_one(*motion, count, threads);
  }
}

// Times far from the start are in the pieces of the other threads, whichever end they lie at.
TEST(Batch, WhatAnEffortThrowsComesOutOfTheCallWhateverThreadItIsIn) {
  const Problem heavy{
      PrincipalMoments(1, 1.75, 2.5), {Quat::Identity(), {0.3, 0.2, 2}}, {HeavyTop{1.5, Vec3::UnitZ()}}};
  const auto motion = make_motion(heavy, {Method::rk4, 1e-3, {}}, [](std::int64_t) { throw BudgetSpent(); });
  std::vector<double> t_s(8, 0.0);  // at 0 there is nothing to compute
  std::vector<RigidBodyState> states(t_s.size());
  EXPECT_NO_THROW(states_at(*motion, t_s, states, 4));
  t_s.back() = 100;
  for (const unsigned threads : {1u, 2u, 4u})
    EXPECT_THROW(states_at(*motion, t_s, states, threads), BudgetSpent) << threads;
  t_s.assign(t_s.size(), 100.0);
  EXPECT_THROW(states_at(*motion, t_s, states, 4), BudgetSpent) << "in all threads at once";
}

}  // namespace
}  // namespace polhode
