// SPDX-License-Identifier: MIT
// The exact motion at the ends of the range of double and beside its special cases: every possible body at
// every time gives a finite state of the right T and L. Accuracy on the reference bodies:
// unseen_bodies_test.cpp.
#include "physics/analysis/conditioning.h"
#include "physics/exact/asymmetric_motion.h"
#include "physics/geometry/poinsot.h"
#include "physics/method.h"
#include "tests/physics/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace polhode {
namespace {

using test::exact_motion;
using test::kEps;
using Series = AsymmetricMotion::Series;

constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();

struct Extreme {
  const char* name;
  PrincipalMoments I;
  Vec3 w_B;
};

void PrintTo(const Extreme& e, std::ostream* out) { *out << e.name; }

double up(double x) { return std::nextafter(x, kMax); }
double down(double x) { return std::nextafter(x, -kMax); }

const Quat kStart = Quat(1, 2, -3, 4).normalized();

class Extremes : public testing::TestWithParam<Extreme> {};

TEST_P(Extremes, StartAtTheStart) {
  const Extreme& e = GetParam();
  for (const double t : {0.0, -0.0}) {
    const RigidBodyState state = exact_motion(e.I, {kStart, e.w_B})->at(t);
    // Of a subnormal ω a step of the grid is the rounding.
    EXPECT_LE((state.w_B - e.w_B).stableNorm(), std::max(8 * kEps * e.w_B.stableNorm(), 2 * kTiny));
    EXPECT_LE(test::q_error(state.q_SB, kStart), 8 * kEps);
  }
}

TEST_P(Extremes, KeepEnergyAndMomentumAtAnyTime) {
  const Extreme& e = GetParam();
  const auto motion = exact_motion(e.I, {kStart, e.w_B});
  const double P = polhode_period(e.I, e.w_B).value_or(2 * M_PI / e.w_B.stableNorm());
  std::vector<double> times{0, kTiny, 1, 1e-300, 1e300, kMax};
  for (const double periods : {0.1, 0.25, 0.5, 1.0, 17.3, 1e6, 1e9, 1e15, 1e20})
    if (std::isfinite(periods * P)) times.push_back(periods * P);
  for (const double after : times)
    for (const double t : {after, -after}) {
      const RigidBodyState state = motion->at(t);
      ASSERT_TRUE(state.w_B.allFinite()) << t;
      ASSERT_NEAR(state.q_SB.norm(), 1, 8 * kEps) << t;
      const test::Drift drift = test::drift(e.I, {kStart, e.w_B}, state);
      EXPECT_LE(drift.T, 4e-15) << t;
      EXPECT_LE(drift.L, 4e-15) << t;
      EXPECT_LE(drift.direction, 1e-14) << t;
      EXPECT_EQ(motion->w_B_at(t), state.w_B) << t;
    }
}

TEST_P(Extremes, HaveAConditionNumber) {
  const Extreme& e = GetParam();
  const auto number = conditioning(e.I, e.w_B);
  EXPECT_EQ(number.has_value(), !e.w_B.isZero(0.0) && std::string(e.name) != "separatrix_exact");
  EXPECT_TRUE(!number || number->phase_per_period > 0);
}

const PrincipalMoments kGeneric(1, 1.75, 2.5);
const PrincipalMoments kSeparatrix(3, 4, 6);  // I3(I3 − I2) = 4 I1(I2 − I1): D = 0 exactly for |ω1| = 2|ω3|

INSTANTIATE_TEST_SUITE_P(
    Gallery, Extremes,
    testing::Values(
        Extreme{"at_rest", kGeneric, {0, 0, 0}}, Extreme{"omega_1e300", kGeneric, {1e300, -2e300, 3e300}},
        Extreme{"omega_near_the_largest", kGeneric, {3e307, -3e307, 3e307}},
        Extreme{"omega_1e_minus_300", kGeneric, {1e-300, -2e-300, 3e-300}},
        Extreme{"omega_subnormal", kGeneric, {3e-310, -2e-310, 1e-310}},
        Extreme{"omega_smallest", kGeneric, {kTiny, kTiny, -kTiny}},
        Extreme{"omega_spread_below_the_range", kGeneric, {1e200, 1e-200, 1e-220}},
        Extreme{"omega_spread_about_the_middle_axis", kGeneric, {1e-160, 1e200, -1e-200}},
        Extreme{"omega_from_smallest_to_largest", kGeneric, {kTiny, 1e307, kTiny}},
        Extreme{"omega_spread_symmetric", PrincipalMoments(1, 1, 1.5), {1e-320, 1e300, 1e10}},
        Extreme{"moments_largest", PrincipalMoments(0.7 * kMax, 0.8 * kMax, kMax), {1, -2, 3}},
        Extreme{"moments_subnormal", PrincipalMoments(1e-310, 1.5e-310, 2e-310), {1, -2, 3}},
        Extreme{"moments_smallest", PrincipalMoments(2 * kTiny, 3 * kTiny, 4 * kTiny), {1, -2, 3}},
        Extreme{"both_largest", PrincipalMoments(0.7 * kMax, 0.8 * kMax, kMax), {3e307, -3e307, 3e307}},
        Extreme{
            "both_smallest", PrincipalMoments(2 * kTiny, 3 * kTiny, 4 * kTiny), {kTiny, kTiny, 2 * kTiny}},
        Extreme{"mixed", PrincipalMoments(2 * kTiny, 3 * kTiny, 4 * kTiny), {1e300, 2e300, -3e300}},
        Extreme{"needle_1e_minus_9", PrincipalMoments(1e-9, 1, 1 + 0.5e-9), {1, 1, -1}},
        Extreme{"needle_thinnest_asymmetric", PrincipalMoments(0x1p-52, 1, up(1)), {1, 1, -1}},
        Extreme{"needle_thinnest_asymmetric_spinning", PrincipalMoments(0x1p-52, 1, up(1)), {1e8, 1, -1}},
        Extreme{"needle_1e_minus_300", PrincipalMoments(1, 1e-300, 1), {1, 1, -1}},
        Extreme{"needle_1e_minus_300_spinning", PrincipalMoments(1, 1e-300, 1), {1, 1e300, -1}},
        Extreme{"needle_ratio_below_the_range", PrincipalMoments(1e200, 1e200, 1e-120), {1e-13, 0, 1e307}},
        Extreme{"disc_largest_spin", PrincipalMoments(1, 1, 2), {1e307, 0, 1.5e308}},
        Extreme{"flat_exact", PrincipalMoments(1, 2, 3), {1, -2, 0.3}},
        Extreme{"flat_in_decimal", PrincipalMoments(0.1, 0.7, 0.8), {1, -2, 0.3}},
        Extreme{"flat_and_needle", PrincipalMoments(1e-12, 1, 1 + 1e-12), {1, -2, 0.3}},
        Extreme{"near_sphere_by_ulps", PrincipalMoments(1, up(1), up(up(1))), {1, -2, 3}},
        Extreme{"near_sphere_about_the_middle", PrincipalMoments(1, up(1), up(up(1))), {1e-9, -2, 1e-9}},
        Extreme{"near_sphere_two_sides", PrincipalMoments(1, down(1), up(1)), {1, -2, 3}},
        Extreme{"near_oblate_ulp_above", PrincipalMoments(1, up(1), 1.5), {1, -2, 3}},
        Extreme{"near_oblate_ulp_below", PrincipalMoments(1, down(1), 1.5), {1, -2, 3}},
        Extreme{"near_oblate_equatorial", PrincipalMoments(1, up(1), 1.5), {1, -2, 1e-9}},
        Extreme{"near_prolate_ulp_above", PrincipalMoments(0.5, 1, up(1)), {1, -2, 3}},
        Extreme{"near_prolate_ulp_below", PrincipalMoments(0.5, 1, down(1)), {1, -2, 3}},
        Extreme{"sphere", PrincipalMoments(1, 1, 1), {1, -2, 3}},
        Extreme{"separatrix_exact", kSeparatrix, {2, 0.3, -1}},
        Extreme{"separatrix_ulp_above", kSeparatrix, {down(2), 0.3, -1}},
        Extreme{"separatrix_ulp_below", kSeparatrix, {up(2), 0.3, -1}},
        Extreme{"separatrix_smallest_ulp_above", kSeparatrix, {2, 0.3, -up(1)}},
        Extreme{"separatrix_smallest_ulp_below", kSeparatrix, {2, 0.3, -down(1)}},
        Extreme{"separatrix_far_out", kSeparatrix, {2e-300, 1, 1e-300 * (1 + 0x1p-52)}},
        Extreme{"min_axis_1e_minus_300", kGeneric, {2, 1e-300, -1e-300}},
        Extreme{"mid_axis_1e_minus_300", kGeneric, {1e-300, 2, -1e-300}},
        Extreme{"max_axis_1e_minus_300", kGeneric, {1e-300, -1e-300, 2}},
        Extreme{"max_axis_smallest", kGeneric, {kTiny, 0, 2}},
        Extreme{"mid_axis_smallest", kGeneric, {kTiny, 2, 0}}),
    [](const auto& named) { return std::string(named.param.name); });

TEST(ExtremesOnTheSeparatrix, OneUlpDecidesTheSide) {
  const auto series_of = [](const Vec3& w_B) {
    return AsymmetricMotion(kSeparatrix, {kStart, w_B}).series();
  };
  for (const double scale : {1.0, -1.0, 1e-300, 1e300}) {
    EXPECT_EQ(series_of(Vec3(2, 0.3, -1) * scale), Series::separatrix);
    EXPECT_EQ(series_of(Vec3(up(2), 0.3, -1) * scale), Series::in_complementary_nome);
    EXPECT_EQ(series_of(Vec3(2, 0.3, -up(1)) * scale), Series::in_complementary_nome);
  }
}

// The neighbours leave the separatrix as e^{λt}, from an ulp; they return, it does not.
TEST(ExtremesOnTheSeparatrix, NeighboursStayTogetherThenPart) {
  const Vec3 on_it(2, 0.3, -1);
  const auto motion = exact_motion(kSeparatrix, {kStart, on_it});
  for (const Vec3& w_B : {Vec3(up(2), 0.3, -1), Vec3(down(2), 0.3, -1)}) {
    const auto neighbour = exact_motion(kSeparatrix, {kStart, w_B});
    for (const double t : {-3.0, -1.0, 0.0, 1.0, 3.0}) {
      const double parted = 16 * kEps * std::exp(2 * std::abs(t));  // λ < 2 here
      EXPECT_LE(test::w_error(neighbour->w_B_at(t), motion->w_B_at(t)), parted) << t;
      EXPECT_LE(test::q_error(neighbour->at(t).q_SB, motion->at(t).q_SB), parted) << t;
    }
    const double P = *polhode_period(kSeparatrix, w_B);
    EXPECT_LE(test::w_error(neighbour->w_B_at(P), w_B), 1e-12);  // ω_a there grows as e^{2t}, P is rounded
    EXPECT_LE(motion->w_B_at(P).cwiseProduct(Vec3(1, 0, 1)).norm(), 1e-12);  // e^{−λP}
  }
}

TEST(ExtremePerturbations, ShowOnlyAboutTheMiddleAxis) {
  for (const double small : {1e-300, kTiny}) {
    for (const int axis : {0, 2}) {
      Vec3 w_B = Vec3::Constant(small);
      w_B[axis] = 2;
      const auto motion = exact_motion(kGeneric, {kStart, w_B});
      for (const double t : {1.0, 1e3, 1e9}) EXPECT_NEAR(motion->w_B_at(t)[axis], 2, 8 * kEps) << axis;
    }
    const Vec3 w_B(small, 2, small);
    const double P = *polhode_period(kGeneric, w_B);
    const double lambda = 2 * std::sqrt(0.75 * 0.75 / 2.5);  // ω2 √((I2 − I1)(I3 − I2)/(I1 I3))
    EXPECT_NEAR(P * lambda / 4, -std::log(small), 10);       // K = ln 4/k', k' about small/2
    const auto motion = exact_motion(kGeneric, {kStart, w_B});
    EXPECT_NEAR(motion->w_B_at(P / 8)[1], 2, 1e-9);  // midway between two flips, P/2 apart
    EXPECT_NEAR(motion->w_B_at(P / 2)[1], -2, 1e-9);
  }
}

// Near it the flip is ω_b = 2 tanh λ(t − t_flip), also for k' below the range of double.
TEST(ExtremePerturbations, FlipAtTheRateOfTheSeparatrix) {
  const double lambda = 2 * std::sqrt(0.75 * 0.75 / 2.5);
  for (const double small : {1e-150, 1e-300, 1e-306, kTiny})
    for (const double scale : {1.0, 1e300}) {
      const Vec3 w_B(small, 2 * scale, small);
      const auto motion = exact_motion(kGeneric, {kStart, w_B});
      const double t = *polhode_period(kGeneric, w_B) / 4, dt = 0.5 / scale;
      const auto angle = [&](double at) { return std::atanh(motion->w_B_at(at)[1] / (2 * scale)); };
      // the phase, of some 10³ rad, is rounded
      EXPECT_NEAR(std::abs(angle(t + dt) - angle(t)), lambda * scale * dt, 1e-11) << small << " " << scale;
    }
}

// The components differ by more than the range of double; scaled by the largest, the others must not vanish.
TEST(ExtremePerturbations, FlipTheBodyAlsoBelowTheRangeOfDouble) {
  const Vec3 w_B(1e-170, 1e160, -1e-175);
  const double P = *polhode_period(kGeneric, w_B);
  ASSERT_TRUE(std::isfinite(P));
  const auto motion = exact_motion(kGeneric, {kStart, w_B});
  EXPECT_EQ(motion->method(), "exact");
  EXPECT_NEAR(motion->w_B_at(P / 8)[1] / 1e160, 1, 1e-9);
  EXPECT_NEAR(motion->w_B_at(P / 2)[1] / 1e160, -1, 1e-9);
  EXPECT_NEAR(motion->w_B_at(P)[1] / 1e160, 1, 1e-9);
}

// Such a body turns 10¹⁵ times and more in a period: its attitude is then lost, ω is not.
TEST(ExtremeNearSphere, KnowsOmegaWhenTheAttitudeIsLost) {
  const PrincipalMoments I(1, up(1), up(up(1)));
  const Vec3 w_B(0.3, -0.2, 1.5);
  const double P = *polhode_period(I, w_B);
  ASSERT_GT(P, 1e15);
  const auto motion = exact_motion(I, {kStart, w_B});
  for (const double periods : {1.0, -1.0, 7.0, 1000.0})
    EXPECT_LE(test::w_error(motion->w_B_at(periods * P), w_B), 50 * kEps * std::abs(periods)) << periods;
  const Vec3 half = motion->w_B_at(P / 2);
  EXPECT_LE(test::w_error(half, {-w_B[0], -w_B[1], w_B[2]}), 50 * kEps);
}

TEST(ExtremeAttitudes, AreScaledToUnitLength) {
  for (const double size : {kTiny, 1e-310, 1e-160, 1e160, 0.4 * kMax}) {
    const Quat given(size, -size, size, 2 * size);
    const Quat unit = Quat(1, -1, 1, 2).normalized();
    for (const PrincipalMoments& I : {kGeneric, PrincipalMoments(1, 1, 1.5), PrincipalMoments(1, 1, 1)})
      EXPECT_LE(test::q_error(exact_motion(I, {given, {1, 2, 3}})->at(0).q_SB, unit), 8 * kEps) << size;
  }
}

// |L|/I_a of a disc is twice ω_c, beyond the largest double: the attitude must turn all the same.
TEST(ExtremeAttitudes, TurnWithTheLargestSpin) {
  const PrincipalMoments disc(1, 1, 2);
  const Vec3 w_B(1e307, 0, 1.5e308);
  for (const double t : {1e-308, 1e-307, -1e-300}) {
    const Quat q_SB = exact_motion(disc, {kStart, w_B})->at(t).q_SB;
    const Quat slower = exact_motion(disc, {kStart, w_B * 0x1p-200})->at(t * 0x1p200).q_SB;
    EXPECT_EQ(q_SB.coeffs(), slower.coeffs()) << t;
  }
}

std::string refusal(const std::function<void()>& make) {
  try {
    make();
  } catch (const std::domain_error& error) {
    return error.what();
  }
  return "not refused";
}

TEST(Refusals, NameTheReason) {
  using testing::HasSubstr;
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const auto of_moments = [](double I1, double I2, double I3) {
    return refusal([=] { PrincipalMoments(I1, I2, I3); });
  };
  EXPECT_THAT(of_moments(1, 2, 3.1), HasSubstr("I3 = 3.1 exceeds I1 + I2 = 3"));
  EXPECT_THAT(of_moments(1, 0, 1), HasSubstr("I2 = 0 is not positive"));
  EXPECT_THAT(of_moments(-1, 1, 1), HasSubstr("I1 = -1 is not positive"));
  EXPECT_THAT(of_moments(1, 1, nan), HasSubstr("I3 = nan is not finite"));
  EXPECT_THAT(of_moments(inf, 1, 1), HasSubstr("I1 = inf is not finite"));
  const auto of_state = [](const Quat& q_SB, const Vec3& w_B) {
    return refusal([&] { exact_motion(kGeneric, {q_SB, w_B}); });
  };
  for (const double bad : {inf, -inf, nan}) {
    EXPECT_EQ(of_state(kStart, {1, bad, 0}), "angular velocity is not finite");
    EXPECT_EQ(of_state(Quat(1, 0, bad, 0), {1, 2, 3}), "attitude is not a finite non-zero quaternion");
  }
  EXPECT_EQ(of_state(Quat(0, 0, 0, 0), {1, 2, 3}), "attitude is not a finite non-zero quaternion");
}

}  // namespace
}  // namespace polhode
