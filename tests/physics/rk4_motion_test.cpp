// SPDX-License-Identifier: MIT
#include "physics/rk4_motion.h"

#include "physics/symmetric_motion.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

namespace polhode {
namespace {

using test::kEps;
using test::Random;
using test::same_bits;

const PrincipalMoments kI(1.0, 1.75, 2.5);
const RigidBodyState kStart{Quat::Identity(), {0.2, 1.0, 0.3}};
const Torque kEveryTorque{SpaceTorque{{0.1, 0, 0.2}}, BodyTorque{{0, 0.1, 0}}, HeavyTop{0.5, Vec3::UnitY()},
                          LinearDamping{0.05}, EnergySink{0.02}};
const Torque kTorqueOfOmega{BodyTorque{{0, 0.1, 0}}, LinearDamping{0.05}, EnergySink{0.02}};

struct Errors {
  double w, q;
};

Errors difference(const RigidBodyState& x, const RigidBodyState& y) {
  return {test::w_error(x.w_B, y.w_B), test::q_error(x.q_SB, y.q_SB)};
}

// Halving the step divides the error by 2⁴, in ω and in q each by itself. The steps are small enough for the
// next term of the error to shift the observed order by less than the 0.1 allowed, and large enough to drown
// rounding.
void expect_order_4(const Errors& coarse, const Errors& fine) {
  EXPECT_NEAR(std::log2(coarse.w / fine.w), 4.0, 0.1);
  EXPECT_NEAR(std::log2(coarse.q / fine.q), 4.0, 0.1);
}

TEST(Rk4Motion, HasOrderFourAgainstTheReference) {
  for (const char* name : {"generic_above", "generic_below", "generic_perm_213", "generic_perm_312"}) {
    const test::ReferenceCase& c = test::reference_case(name);
    const test::ReferenceState& truth = c.states[1];
    const double h = std::abs(truth.t_s) / 1024;
    SCOPED_TRACE(name);
    expect_order_4(difference(Rk4Motion(c.I, {}, c.start, h).at(truth.t_s), truth.state),
                   difference(Rk4Motion(c.I, {}, c.start, h / 2).at(truth.t_s), truth.state));
  }
}

TEST(Rk4Motion, HasOrderFourUnderEveryTorque) {
  const double t = 4, h = 1.0 / 128;
  const RigidBodyState a = Rk4Motion(kI, kEveryTorque, kStart, h).at(t);
  const RigidBodyState b = Rk4Motion(kI, kEveryTorque, kStart, h / 2).at(t);
  const RigidBodyState c = Rk4Motion(kI, kEveryTorque, kStart, h / 4).at(t);
  expect_order_4(difference(a, b), difference(b, c));
}

// By the order, the error at h/2 is 1/15 of the difference between h and h/2.
TEST(Rk4Motion, AgreesWithTheSymmetricTop) {
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const PrincipalMoments I = random.symmetric_moments();
    const RigidBodyState start = random.state();
    const double t = random.uniform(-4, 4), h = 1.0 / 256;
    const RigidBodyState coarse = Rk4Motion(I, {}, start, h).at(t),
                         fine = Rk4Motion(I, {}, start, h / 2).at(t);
    const RigidBodyState exact = SymmetricMotion(I, start).at(t);
    const double rounding = 2 * kEps * std::abs(t) / h;
    EXPECT_LE(difference(fine, exact).w, 2.0 / 15 * difference(coarse, fine).w + rounding);
    EXPECT_LE(difference(fine, exact).q, 2.0 / 15 * difference(coarse, fine).q + rounding);
  }
}

TEST(Rk4Motion, WithATightStepAgreesWithTheReferenceOfEveryOrdinaryBody) {
  int bodies = 0;
  for (const test::ReferenceCase& c : test::reference_cases()) {
    const test::ReferenceState& truth = c.states[0];
    const double rate = c.start.w_B.norm() * c.I.vector().maxCoeff() / c.I.vector().minCoeff();
    const double turned = std::abs(truth.t_s) * rate;
    if (!(rate > 0.01 && rate < 100 && turned < 40)) continue;
    ++bodies;
    const double h = std::abs(truth.t_s) / 8192;
    const Errors error = difference(Rk4Motion(c.I, {}, c.start, h).at(truth.t_s), truth.state);
    // Local error (rate·h)⁵/120 per step and 4ε of rounding, both carried on by the motion's own condition
    // number.
    const double local = 8192 * (std::pow(rate * h, 5) / 120 + 4 * kEps);
    EXPECT_LE(error.w, local * (1 + truth.cond_w)) << c.name;
    EXPECT_LE(error.q, local * (1 + truth.cond_q)) << c.name;
  }
  EXPECT_GE(bodies, 20);
}

TEST(Rk4Motion, DependsOnTheTimeAloneAndNotOnTheTimesAskedBefore) {
  std::vector<double> times;
  for (int i = -100; i <= 100; ++i) times.push_back(0.0371 * i);
  const Rk4Motion ordered(kI, kEveryTorque, kStart, 0.01), shuffled(kI, kEveryTorque, kStart, 0.01);
  std::vector<RigidBodyState> expected;
  for (const double t : times) expected.push_back(ordered.at(t));

  std::vector<std::size_t> order(times.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), Random(2).engine());
  for (const std::size_t i : order) {
    EXPECT_TRUE(same_bits(shuffled.at(times[i]), expected[i])) << times[i];
    EXPECT_TRUE(same_bits(ordered.at(times[i]), expected[i])) << times[i];
    EXPECT_TRUE(same_bits(Rk4Motion(kI, kEveryTorque, kStart, 0.01).at(times[i]), expected[i])) << times[i];
  }
}

TEST(Rk4Motion, ServesManyThreadsTheSame) {
  const Rk4Motion motion(kI, {}, kStart, 0.01), alone(kI, {}, kStart, 0.01);
  std::vector<RigidBodyState> expected;
  for (int i = 0; i < 400; ++i) expected.push_back(alone.at(0.5 * (i - 200)));
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (unsigned seed = 0; seed < 4; ++seed) {
    threads.emplace_back([&, seed] {
      std::mt19937 engine(seed);
      for (int n = 0; n < 400; ++n) {
        const int i = static_cast<int>(engine() % 400);
        const RigidBodyState& truth = expected[static_cast<std::size_t>(i)];
        if (!same_bits(motion.at(0.5 * (i - 200)), truth)) ++wrong;
        if (motion.w_B_at(0.5 * (i - 200)) != truth.w_B) ++wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

TEST(Rk4Motion, OmegaAloneIsTheSameToTheBit) {
  for (const Torque& torque : {Torque{}, kTorqueOfOmega, kEveryTorque}) {
    const Rk4Motion motion(kI, torque, kStart, 0.03);
    for (double t = -8; t < 8; t += 0.171) EXPECT_EQ(motion.w_B_at(t), motion.at(t).w_B) << t;
  }
}

// h is not a double and k·h falls on either side of the grid point: no step may be lost or taken twice, near
// or far.
TEST(Rk4Motion, IsContinuousAcrossGridPointsAndItsTimeDoesNotAccumulate) {
  const double h = 0.1, rate = 1.5;
  const Rk4Motion motion(kI, {}, kStart, h);
  for (int k = -20000; k <= 20000; k += 37) {
    const double t = k * h;
    const double one_step_of_t = 2 * kEps * std::abs(t);
    const Errors jump = difference(motion.at(t), motion.at(std::nextafter(t, 0.0)));
    ASSERT_LE(jump.w, rate * one_step_of_t + 16 * kEps) << t;
    ASSERT_LE(jump.q, rate * one_step_of_t + 16 * kEps) << t;
  }
}

TEST(Rk4Motion, StartsAtTheStart) {
  Random random(3);
  const RigidBodyState start = random.state();
  const RigidBodyState state = Rk4Motion(kI, kEveryTorque, start, 0.1).at(0);
  EXPECT_EQ(state.w_B, start.w_B);
  EXPECT_LE(test::q_error(state.q_SB, start.q_SB), 4 * kEps);
}

TEST(Rk4Motion, TurningTheStartTurnsTheMotion) {
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const RigidBodyState start = random.state();
    const Quat p = random.attitude();
    const double t = random.uniform(-5, 5), h = 0.02;
    const RigidBodyState plain = Rk4Motion(kI, kTorqueOfOmega, start, h).at(t);
    const RigidBodyState turned = Rk4Motion(kI, kTorqueOfOmega, {p * start.q_SB, start.w_B}, h).at(t);
    EXPECT_LE(test::q_error(turned.q_SB, p * plain.q_SB), 8 * kEps * (2 + std::abs(t) / h));
    EXPECT_EQ(turned.w_B, plain.w_B);
  }
}

TEST(Rk4Motion, AnswersUnitQuaternionsEvenWithAbsurdSteps) {
  const Rk4Motion motion(kI, {}, {Quat::Identity(), {0, 0, 50}}, 1.0);  // |q| grows by 10⁴ per step
  for (const double t : {1.0, 10.0, 500.0, -2000.0, 0.3}) {
    EXPECT_NEAR(motion.at(t).q_SB.norm(), 1, 4 * kEps) << t;
    EXPECT_EQ(motion.at(t).w_B, Vec3(0, 0, 50));
  }
}

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Rk4Motion, ThatBlowsUpSaysSoAndDoesNotHang) {
  const Rk4Motion motion(kI, {}, {Quat::Identity(), {100, 200, 300}}, 1.0);
  EXPECT_LE(seconds_of([&] {
              for (const double t : {9e7, -9e7, 1000.0}) {
                EXPECT_TRUE(std::isnan(motion.at(t).w_B[0])) << t;
                EXPECT_TRUE(std::isnan(motion.at(t).q_SB.w())) << t;
                EXPECT_TRUE(std::isnan(motion.w_B_at(t)[0])) << t;
              }
            }),
            1.0);
  EXPECT_EQ(motion.at(0).w_B, Vec3(100, 200, 300));
}

TEST(Rk4Motion, BeyondItsLongestTimeIsNotANumber) {
  const Rk4Motion motion(kI, {}, kStart, 1e-3);
  EXPECT_EQ(motion.max_time_s(), 1e5);
  EXPECT_LE(seconds_of([&] {
              for (const double t : {1.1e5, -1e300, std::numeric_limits<double>::infinity(),
                                     std::numeric_limits<double>::quiet_NaN()}) {
                EXPECT_TRUE(motion.at(t).w_B.array().isNaN().all()) << t;
                EXPECT_TRUE(motion.at(t).q_SB.coeffs().array().isNaN().all()) << t;
                EXPECT_TRUE(motion.w_B_at(t).array().isNaN().all()) << t;
              }
            }),
            1.0);
  const Rk4Motion tiny(kI, {}, kStart, std::numeric_limits<double>::denorm_min());
  EXPECT_TRUE(std::isnan(tiny.at(1).w_B[0]));
}

TEST(Rk4Motion, RefusesStepsStatesAndTorquesThatAreNone) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const double h : {0.0, -0.1, kNaN, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(Rk4Motion(kI, {}, kStart, h), std::domain_error);
  }
  EXPECT_THROW(Rk4Motion(kI, {}, {Quat::Identity(), {kNaN, 0, 0}}, 0.1), std::domain_error);
  EXPECT_THROW(Rk4Motion(kI, {LinearDamping{kNaN}}, kStart, 0.1), std::domain_error);
  EXPECT_EQ(Rk4Motion(kI, {}, kStart, 0.1).method(), "rk4");
  EXPECT_EQ(Rk4Motion(kI, {}, kStart, 0.1).step_s(), 0.1);
}

}  // namespace
}  // namespace polhode
