// SPDX-License-Identifier: MIT
#include "physics/geometry/flips.h"

#include "physics/geometry/poinsot.h"
#include "physics/method.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

using test::exact_motion;

/// Smallest, intermediate, largest moment on axes 2, 3, 1: no order of the axes is taken for granted.
const PrincipalMoments kTHandle(2.9, 1.0, 2.0);
constexpr int kMiddle = 2;

std::vector<double> flips_of(const PrincipalMoments& I, const Vec3& w0_B, double from_s, double to_s) {
  return flip_times(*exact_motion(I, {Quat::Identity(), w0_B}), I, from_s, to_s);
}

TEST(Flips, ComeEveryHalfPeriodOfThePolhode) {
  for (double off : {1e-2, 1e-4, 1e-8, 1e-12})
    for (const Vec3& w0_B : {Vec3(off, 0, 2), Vec3(0, off, -2), Vec3(0.3 * off, 0.1 * off, 2)}) {
      const double period_s = polhode_period(kTHandle, w0_B).value();
      const auto times = flips_of(kTHandle, w0_B, 0.01 * period_s, 5.01 * period_s);
      ASSERT_EQ(times.size(), 10u) << off << ", " << w0_B.transpose();
      // Times are found to 1e-14 of the interval; the rest is the phase of the motion near the separatrix.
      const double tolerance = 1e-9 * period_s;
      for (std::size_t i = 1; i < times.size(); ++i)
        EXPECT_NEAR(times[i] - times[i - 1], 0.5 * period_s, tolerance) << off << ", " << w0_B.transpose();
    }
}

TEST(Flips, AreWhereTheMiddleComponentVanishes) {
  test::Random random(3);
  int flips = 0;
  for (int body = 0; body < 50; ++body) {
    const Vec3 w0_B(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(1, 3));
    const auto motion = exact_motion(kTHandle, {Quat::Identity(), w0_B});
    const double period_s = polhode_period(kTHandle, w0_B).value();
    for (double t_s : flip_times(*motion, kTHandle, -period_s, 3 * period_s)) {
      ++flips;
      // ω̇ is at most |ω|², and t is found to 1e-14 of the interval and to an ulp.
      EXPECT_LT(std::abs(motion->w_B_at(t_s)[kMiddle]), w0_B.squaredNorm() * period_s * 1e-13);
    }
  }
  EXPECT_GE(flips, 300);
}

TEST(Flips, AreNoneOfABodyThatWobbles) {
  for (const Vec3& w0_B :
       {Vec3(2, 0.1, 0.1), Vec3(0.1, 2, 0.1), Vec3(2, 0, 0), Vec3(0, 2, 0), Vec3(1, 0.5, 0.5)}) {
    EXPECT_TRUE(flips_of(kTHandle, w0_B, 0, 50).empty()) << w0_B.transpose();
  }
}

TEST(Flips, BeginWhereThePolhodeLeadsNearEnoughToTheAxis) {
  // At a passage with ω₃ = 0 the larger of both wobbles decides: compared with the nearest that ω really
  // comes.
  int flipping = 0, wobbling = 0;
  for (double ratio = 0.05; ratio < 20; ratio *= 1.2) {
    const Vec3 w0_B(1, ratio, 0);
    const auto motion = exact_motion(kTHandle, {Quat::Identity(), w0_B});
    const double period_s = polhode_period(kTHandle, w0_B).value();
    const auto share = [&](double t_s) {
      const Vec3 L_B = kTHandle.vector().cwiseProduct(motion->w_B_at(t_s));
      return std::abs(L_B[kMiddle]) / L_B.norm();
    };
    const double nearest = share(0.25 * period_s);
    if (std::abs(nearest - kFlipsNearer) < 1e-9) continue;
    const bool flips = !flip_times(*motion, kTHandle, -0.1 * period_s, 0.1 * period_s).empty();
    EXPECT_EQ(flips, nearest > kFlipsNearer) << ratio << ": " << nearest;
    ++(flips ? flipping : wobbling);
  }
  EXPECT_GT(flipping, 0);
  EXPECT_GT(wobbling, 0);
}

TEST(Flips, AtTheEndsOfTheIntervalCount) {
  const Vec3 w0_B(0.02, 1.0, 0);
  const Vec3 flipping(1.0, 1.62, 0);  // near the separatrix: I1(I1−I3)ω1² and I2(I3−I2)ω2² are nearly equal
  EXPECT_TRUE(flips_of(kTHandle, w0_B, 0, 1).empty());
  const auto times = flips_of(kTHandle, flipping, 0, 1);
  ASSERT_EQ(times.size(), 1u);
  EXPECT_EQ(times[0], 0);
  EXPECT_EQ(flips_of(kTHandle, flipping, -1, 0), times);
}

TEST(Flips, AreNoneOfSymmetricBodiesAndOfSteadySpins) {
  for (const PrincipalMoments& I :
       {PrincipalMoments(1, 1, 1.5), PrincipalMoments(1, 2, 2), PrincipalMoments(1, 1, 1)})
    EXPECT_TRUE(flips_of(I, {0.1, 2, 0.1}, 0, 100).empty());
  EXPECT_TRUE(flips_of(kTHandle, {0, 0, 2}, 0, 100).empty()) << "unstable, but undisturbed";
  EXPECT_TRUE(flips_of(kTHandle, {0, 0, 0}, 0, 100).empty());
}

TEST(Flips, OfTheSeparatrixHappenOnce) {
  // L² = 2T I3 with ω3 = 0: I1(I1 − I3)ω1² = I2(I3 − I2)ω2².
  const Vec3 w0_B(std::sqrt(1.0 * (2.0 - 1.0)), std::sqrt(2.9 * 0.9), 0);
  const auto times = flips_of(kTHandle, w0_B, -20, 20);
  ASSERT_EQ(times.size(), 1u);
  EXPECT_NEAR(times[0], 0, 1e-12);
}

TEST(Flips, UnderATorqueAreThoseOfThePolhodeOfTheMoment) {
  // A weak torque leaves the flips of the free body where they were, but for its work over some periods.
  const Vec3 w0_B(0.02, 0.01, 2);
  const double torque_Nm = 1e-6;
  const Problem problem{kTHandle, {Quat::Identity(), w0_B}, {BodyTorque{{torque_Nm, 0, 0}}}};
  const auto motion = make_motion(problem, {.method = Method::dormand_prince_8, .tolerance = 1e-12});
  const double period_s = polhode_period(kTHandle, w0_B).value();
  const auto free = flips_of(kTHandle, w0_B, 0, 3 * period_s);
  const auto turned = flip_times(*motion, kTHandle, 0, 3 * period_s);
  ASSERT_EQ(turned.size(), free.size());
  ASSERT_EQ(free.size(), 6u);
  bool differs = false;
  for (std::size_t i = 0; i < free.size(); ++i) {
    EXPECT_NEAR(turned[i], free[i], 0.01 * period_s);
    differs = differs || turned[i] != free[i];
  }
  EXPECT_TRUE(differs);
}

TEST(Flips, AreNoneWhereNothingCanBeComputed) {
  const auto motion = make_motion({kTHandle, {Quat::Identity(), {0.02, 0.01, 2}}, {}},
                                  {.method = Method::rk4, .step_s = 1e-6});
  const double beyond_s = 2 * motion->max_time_s();
  EXPECT_TRUE(flip_times(*motion, kTHandle, beyond_s, beyond_s + 100).empty());
  const auto exact = exact_motion(kTHandle, {Quat::Identity(), {0.02, 0.01, 2}});
  EXPECT_TRUE(flip_times(*exact, kTHandle, 3, 2).empty());
  EXPECT_TRUE(flip_times(*exact, kTHandle, 0, std::numeric_limits<double>::infinity()).empty());
}

// Flips that are found are flips that keep coming.
TEST(Flips, KeepComingWhereThereAreSome) {
  test::Random random(8);
  int flipping = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 w0_B(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const double period_s = polhode_period(kTHandle, w0_B).value();
    const bool found = !flips_of(kTHandle, w0_B, 0.01 * period_s, 1.01 * period_s).empty();
    EXPECT_EQ(keeps_flipping(kTHandle, w0_B), found) << w0_B.transpose();
    flipping += found ? 1 : 0;
  }
  EXPECT_GT(flipping, 5);
  EXPECT_LT(flipping, 195);
  EXPECT_FALSE(keeps_flipping(PrincipalMoments(1, 1, 2), Vec3(1, 1, 1)));
  EXPECT_FALSE(keeps_flipping(kTHandle, Vec3::Zero()));
  EXPECT_FALSE(keeps_flipping(kTHandle, Vec3(0, 0, 2))) << "a steady spin";
}

}  // namespace
}  // namespace polhode
