// SPDX-License-Identifier: MIT
#include "physics/geometry/poinsot.h"

#include "physics/body/euler.h"
#include "physics/exact/polhode_constants.h"
#include "physics/exact/powers_of_two.h"
#include "physics/exact/symmetric_motion.h"
#include "physics/exact/uniform_motion.h"
#include "physics/geometry/curve_sampling.h"
#include "physics/integrators/explicit_runge_kutta.h"
#include "physics/method.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace polhode {
namespace {

using test::kEps;
using test::Random;

const PrincipalMoments kI(1.0, 1.75, 2.5);
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// ν of symmetric_motion.h.
double nu(const PrincipalMoments& I, const Vec3& w_B) {
  const int c = symmetry_axis(I).value(), a = (c + 1) % 3;
  return w_B[c] * ((I[c] - I[a]) / I[a]);
}

double size_of(const Curve& curve) {
  double size = 0;
  for (const Vec3& p : curve.points) size = std::max(size, (p - curve.points.front()).norm());
  return size;
}

double distance_to(const Curve& curve, const Vec3& p) {
  const std::size_t n = curve.points.size();
  double nearest = (p - curve.points.front()).norm();
  for (std::size_t i = 1; i < n + (curve.closed ? 1 : 0); ++i) {
    nearest = std::min(nearest, distance_to_segment(p, curve.points[i - 1], curve.points[i % n]));
  }
  return nearest;
}

// Both quadrics, relative to their own size; I and ω are scaled lest the squares overflow.
void expect_on_both_quadrics(const PrincipalMoments& I, const Vec3& w_B, const Curve& curve) {
  const Vec3 J = I.vector() / I.vector().maxCoeff();
  const double w = w_B.cwiseAbs().maxCoeff();
  const auto two_T = [&](const Vec3& v_B) { return J.dot((v_B / w).cwiseAbs2()); };
  const auto L2 = [&](const Vec3& v_B) { return J.cwiseProduct(v_B / w).squaredNorm(); };
  for (const Vec3& p : curve.points) {
    ASSERT_NEAR(two_T(p), two_T(w_B), 32 * kEps * two_T(w_B));
    ASSERT_NEAR(L2(p), L2(w_B), 32 * kEps * L2(w_B));
  }
}

TEST(Polhode, OfEveryReferenceBodyLiesOnBothQuadricsAndHoldsTheState) {
  for (const test::ReferenceCase& c : test::reference_cases()) {
    SCOPED_TRACE(c.name);
    const Vec3& w_B = c.start.w_B;
    const double tolerance = std::max(1e-4 * w_B.stableNorm(), 1e-300);
    const Curve curve = polhode_curve(c.I, w_B, tolerance);
    if (c.kind == "steady") {
      ASSERT_EQ(curve.points.size(), 1U);
      EXPECT_EQ(curve.points[0], w_B);
      continue;
    }
    EXPECT_TRUE(curve.closed);
    EXPECT_GE(curve.points.size(), 16U);
    expect_on_both_quadrics(c.I, w_B, curve);
    EXPECT_LE(distance_to(curve, w_B), tolerance);
    for (const test::ReferenceState& state : c.states) {  // the true motion never leaves it
      EXPECT_LE(distance_to(curve, state.state.w_B), tolerance * (1 + 1e-6)) << state.t_s;
    }
  }
}

TEST(Polhode, OfRandomBodiesInEveryOctantAndAxisOrder) {
  Random random(1);
  for (int i = 0; i < 400; ++i) {
    const PrincipalMoments I = random.moments();
    const Vec3 w_B = random.vector(2);
    const double tolerance = std::pow(10.0, random.uniform(-5, -2));
    const Curve curve = polhode_curve(I, w_B, tolerance);
    expect_on_both_quadrics(I, w_B, curve);
    EXPECT_LE(distance_to(curve, w_B), tolerance);
    const int c = polhode_constants(I, w_B)->c;
    for (const Vec3& p : curve.points) EXPECT_GE(p[c] * w_B[c], 0) << "the other branch";
  }
}

TEST(Polhode, HonoursTheChordToleranceBothWays) {
  Random random(2);
  for (int i = 0; i < 30; ++i) {
    const PrincipalMoments I = random.moments();
    const Vec3 w_B = random.vector(2);
    for (const double tolerance : {3e-2, 3e-3}) {
      const Curve coarse = polhode_curve(I, w_B, tolerance), fine = polhode_curve(I, w_B, tolerance / 30);
      for (const Vec3& p : fine.points) EXPECT_LE(distance_to(coarse, p), tolerance);
      for (std::size_t k = 1; k < coarse.points.size(); ++k) {
        const Vec3 middle = 0.5 * (coarse.points[k - 1] + coarse.points[k]);
        EXPECT_LE(distance_to(fine, middle), tolerance * (1 + 1.0 / 30));
      }
    }
  }
}

// Close to the separatrix the curve nearly has corners, at its passages by the intermediate axis.
TEST(Polhode, HonoursTheChordToleranceNextToTheSeparatrix) {
  for (const char* name :
       {"sep_1e-3", "sep_1e-6", "sep_1e-9", "sep_1e-12", "sep_1e-15_above", "sep_1e-15_below"}) {
    const test::ReferenceCase& c = test::reference_case(name);
    const double tolerance = 1e-3;
    const Curve coarse = polhode_curve(c.I, c.start.w_B, tolerance),
                fine = polhode_curve(c.I, c.start.w_B, tolerance / 30);
    for (const Vec3& p : fine.points) EXPECT_LE(distance_to(coarse, p), tolerance) << name;
  }
}

TEST(Polhode, NeedsNoMorePointsThanItsBendingAsksFor) {
  // A circle of radius 1 needs π/√(2·tolerance) chords; halving and the margin may cost up to a factor 3.
  const PrincipalMoments I(1, 1, 1.5);
  const double tolerance = 1e-5;
  const double fewest = std::numbers::pi / std::sqrt(2 * tolerance);
  const std::size_t points = polhode_curve(I, {0.6, 0.8, 1}, tolerance).points.size();
  EXPECT_LE(static_cast<double>(points), 3 * fewest);
  EXPECT_GE(static_cast<double>(points), fewest);
}

TEST(Polhode, RunsInTheDirectionOfTheMotion) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const PrincipalMoments I = i % 4 == 0 ? random.symmetric_moments() : random.moments();
    const Curve curve = polhode_curve(I, random.vector(2), 1e-3);
    const std::size_t n = curve.points.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Vec3 middle = 0.5 * (curve.points[k] + curve.points[(k + 1) % n]);
      EXPECT_GT((curve.points[(k + 1) % n] - curve.points[k]).dot(angular_acceleration_B(I, middle)), 0);
    }
  }
}

TEST(Polhode, OfASymmetricTopIsACircle) {
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    const PrincipalMoments I = random.symmetric_moments();
    const Vec3 w_B = random.vector(2);
    const int c = *symmetry_axis(I);
    const double radius = std::hypot(w_B[(c + 1) % 3], w_B[(c + 2) % 3]);
    for (const Vec3& p : polhode_curve(I, w_B, 1e-3).points) {
      EXPECT_NEAR(p[c], w_B[c], 16 * kEps * std::abs(w_B[c]));
      EXPECT_NEAR(std::hypot(p[(c + 1) % 3], p[(c + 2) % 3]), radius, 16 * kEps * radius);
    }
  }
}

// D is then a single product, below the range of double beside the square of the other components.
TEST(Polhode, OfASymmetricTopThatHardlySpinsIsACircleToo) {
  for (const PrincipalMoments& I : {PrincipalMoments(1, 1, 1.5), PrincipalMoments(0.5, 1, 1)})
    for (const double spin : {1e-150, -1e-155, 1e-165, -1e-300}) {
      const int c = *symmetry_axis(I), a = (c + 1) % 3, b = (c + 2) % 3;
      Vec3 w_B = Vec3::Unit(a);
      w_B[c] = spin;
      const Curve curve = polhode_curve(I, w_B, 1e-3);
      double across = 0;
      for (const Vec3& p : curve.points) {
        EXPECT_NEAR(p[c], spin, 16 * kEps * std::abs(spin));
        EXPECT_NEAR(std::hypot(p[a], p[b]), 1, 16 * kEps) << spin;
        across = std::max(across, std::abs(p[b]));
      }
      EXPECT_NEAR(across, 1, 16 * kEps) << spin;
      const double expected = 2 * std::numbers::pi / std::abs(nu(I, w_B));
      const auto period_s = polhode_period(I, w_B);
      ASSERT_TRUE(period_s) << spin;
      EXPECT_NEAR(*period_s / expected, 1, 8 * kEps) << spin;
    }
}

TEST(Polhode, NextToASteadyAxisIsASmallEllipseNotAPoint) {
  for (const double size : {1e-8, 1e-150, 1e-300}) {
    const Curve curve = polhode_curve(kI, {size, 0, 3}, 1e-3);
    EXPECT_GE(curve.points.size(), 16U);
    // Ratio of the half axes, from I1(I3 − I1)ω1² + I2(I3 − I2)ω2² = const.
    double along_1 = 0, along_2 = 0;
    for (const Vec3& p : curve.points) {
      along_1 = std::max(along_1, p[0]);
      along_2 = std::max(along_2, p[1]);
    }
    EXPECT_NEAR(along_1, size, 8 * kEps * size);
    EXPECT_NEAR(along_2, size * std::sqrt(1.5 / (1.75 * 0.75)), 8 * kEps * along_2);
  }
}

TEST(Polhode, OnTheSeparatrixIsTheWholeEllipseThroughTheState) {
  for (const char* name : {"sep_exact", "sep_exact_perm"}) {
    const test::ReferenceCase& c = test::reference_case(name);
    const double two_T = 2 * kinetic_energy(c.I, c.start.w_B);
    const Curve curve = polhode_curve(c.I, c.start.w_B, 1e-4);
    const std::vector<Curve> both = separatrices(c.I, two_T, 1e-4);
    ASSERT_EQ(both.size(), 2U);
    const double to_first = distance_to(both[0], c.start.w_B), to_second = distance_to(both[1], c.start.w_B);
    EXPECT_LE(std::min(to_first, to_second), 1e-4) << name;
    EXPECT_GE(std::max(to_first, to_second), 0.1) << name;
    const Curve& mine = to_first < to_second ? both[0] : both[1];
    for (const Vec3& p : curve.points) EXPECT_LE(distance_to(mine, p), 2e-4) << name;
    EXPECT_NEAR(size_of(curve), size_of(mine), 1e-3) << name;
    const Vec3 normal = curve.points[0].cross(curve.points[curve.points.size() / 4]);
    for (const Vec3& p : curve.points)
      EXPECT_NEAR(p.dot(normal) / normal.norm(), 0, 16 * kEps * p.norm()) << name;
  }
}

TEST(Polhode, OfExtremeScalesIsTheSameCurve) {
  const Vec3 w_B(0.4, 1.1, -0.3);
  const Curve plain = polhode_curve(kI, w_B, 1e-3);
  const PrincipalMoments big(1e300, 1.75e300, 2.5e300);
  const Curve scaled = polhode_curve(big, w_B * 0x1p-600, 1e-3 * 0x1p-600);
  ASSERT_EQ(plain.points.size(), scaled.points.size());
  for (std::size_t i = 0; i < plain.points.size(); ++i) {
    EXPECT_LE((scaled.points[i] * 0x1p600 - plain.points[i]).norm(), 32 * kEps * w_B.norm());
  }
}

TEST(Polhode, RefusesTolerancesThatAreNone) {
  for (const double bad : {0.0, -1.0, kNaN, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(polhode_curve(kI, {1, 1, 1}, bad), std::domain_error);
    EXPECT_THROW(polhode_family(kI, 1, {2}, bad), std::domain_error);
    EXPECT_THROW(separatrices(kI, 1, bad), std::domain_error);
    EXPECT_THROW(herpolhode(UniformMotion(kI, {}), 0, 1, bad), std::domain_error);
  }
  EXPECT_LE(polhode_curve(kI, {1, 1, 1}, 1e-300).points.size(), 1U << 17);  // taken as 2⁻²⁶ of the size
}

TEST(Poinsot, OfABodyWhoseEnergyIsOutOfRangeIsThatOfASlowOneToTheBit) {
  const Vec3 w_B(0.4, 1.1, -0.3);
  const double two_T = 2 * kinetic_energy(kI, w_B);
  const std::vector<double> levels = {1.2, 2.1};
  const auto plain = polhode_family(kI, two_T, levels, 1e-3);
  const auto ellipses = separatrices(kI, two_T, 1e-3);
  EXPECT_EQ(energy_ellipsoid_semi_axes(kI, w_B), energy_ellipsoid_semi_axes(kI, two_T));
  EXPECT_EQ(momentum_ellipsoid_semi_axes(kI, w_B), momentum_ellipsoid_semi_axes(kI, two_T));
  for (const int e : {-900, 0, 900}) {
    const Vec3 fast_B = times_two_to(e, w_B);
    EXPECT_EQ(energy_ellipsoid_semi_axes(kI, fast_B), times_two_to(e, energy_ellipsoid_semi_axes(kI, two_T)));
    EXPECT_EQ(momentum_ellipsoid_semi_axes(kI, fast_B),
              times_two_to(e, momentum_ellipsoid_semi_axes(kI, two_T)));
    const auto family = polhode_family(kI, fast_B, levels, std::scalbn(1e-3, e));
    ASSERT_EQ(family.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
      EXPECT_EQ(family[i].L2_over_2T, levels[i]);
      ASSERT_EQ(family[i].branches[1].points.size(), plain[i].branches[1].points.size());
      for (std::size_t k = 0; k < plain[i].branches[1].points.size(); ++k)
        EXPECT_EQ(family[i].branches[1].points[k], times_two_to(e, plain[i].branches[1].points[k]));
    }
    const auto fast_ellipses = separatrices(kI, fast_B, std::scalbn(1e-3, e));
    ASSERT_EQ(fast_ellipses.size(), ellipses.size());
    EXPECT_EQ(fast_ellipses[0].points[3], times_two_to(e, ellipses[0].points[3]));
  }
}

TEST(Poinsot, OfMomentsAtTheEndOfTheRangeHasItsSemiAxes) {
  const PrincipalMoments huge(1.2e308, 1.3e308, 1.5e308);
  const Vec3 axes = energy_ellipsoid_semi_axes(huge, Vec3(3, 2, 1));
  const Vec3 same = energy_ellipsoid_semi_axes(PrincipalMoments(1.2, 1.3, 1.5), Vec3(3, 2, 1));
  EXPECT_LE((axes - same).norm(), 8 * kEps * same.norm());
}

// √(2T) √I = I |ω| of a sphere: 5.6e303, though the moments themselves are all but the largest number.
TEST(Poinsot, OfMomentsAtTheEndOfTheRangeHasItsMomentumEllipsoid) {
  const double I = 1.7e308, rate = 1.9e-5;
  const Vec3 axes = momentum_ellipsoid_semi_axes(PrincipalMoments(I, I, I), Vec3(rate, rate, rate));
  const double expected = I * (std::sqrt(3.0) * rate);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(axes[i], expected, 8 * kEps * expected);
}

TEST(PolhodeFamily, HasTheAskedMomentumAndTheCommonEnergy) {
  for (const PrincipalMoments& I : {kI, PrincipalMoments(2.5, 1, 1.75), PrincipalMoments(1, 1, 1.5),
                                    PrincipalMoments(1, 1, 1e-6), PrincipalMoments(1, 1 + 1e-9, 1 + 2e-9)}) {
    const double low = I.vector().minCoeff(), high = I.vector().maxCoeff(), two_T = 7;
    std::vector<double> wanted;
    for (const double x : {0.01, 0.3, 0.5, 0.8, 0.999}) wanted.push_back(low + x * (high - low));
    const auto family = polhode_family(I, two_T, wanted, 1e-3);
    ASSERT_EQ(family.size(), wanted.size());
    for (std::size_t i = 0; i < family.size(); ++i) {
      EXPECT_EQ(family[i].L2_over_2T, wanted[i]);
      ASSERT_EQ(family[i].branches.size(), 2U);
      for (const Curve& branch : family[i].branches) {
        EXPECT_TRUE(branch.closed);
        for (const Vec3& p : branch.points) {
          ASSERT_NEAR(2 * kinetic_energy(I, p), two_T, 32 * kEps * two_T);
          ASSERT_NEAR(angular_momentum_B(I, p).squaredNorm(), two_T * wanted[i], 32 * kEps * two_T * high);
        }
      }
      EXPECT_LE((family[i].branches[0].points[0] - family[i].branches[1].points[0])
                        .dot(family[i].branches[0].points[0]) *
                    -1,
                0);
    }
  }
}

TEST(PolhodeFamily, HoldsThePolhodeOfAStateOfThatMomentum) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const PrincipalMoments I = random.moments();
    const Vec3 w_B = random.vector(2);
    const double two_T = 2 * kinetic_energy(I, w_B);
    const double J = angular_momentum_B(I, w_B).squaredNorm() / two_T;
    const auto family = polhode_family(I, two_T, {J}, 1e-4);
    EXPECT_LE(std::min(distance_to(family[0].branches[0], w_B), distance_to(family[0].branches[1], w_B)),
              2e-4);
    EXPECT_GE(std::max(distance_to(family[0].branches[0], w_B), distance_to(family[0].branches[1], w_B)),
              1e-3);
  }
}

TEST(PolhodeFamily, AtTheIntermediateMomentIsTheSeparatrices) {
  const auto family = polhode_family(kI, 2, {1.75}, 1e-3);
  const auto both = separatrices(kI, 2, 1e-3);
  ASSERT_EQ(family[0].branches.size(), 2U);
  EXPECT_EQ(family[0].branches[0].points, both[0].points);
  EXPECT_EQ(family[0].branches[1].points, both[1].points);
}

TEST(PolhodeFamily, RefusesWhatIsNoPolhode) {
  for (const double bad : {1.0, 2.5, 0.5, 3.0, kNaN})
    EXPECT_THROW(polhode_family(kI, 1, {bad}, 1e-3), std::domain_error);
  for (const double bad : {0.0, -1.0, kNaN, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(polhode_family(kI, bad, {2}, 1e-3), std::domain_error);
    EXPECT_THROW(separatrices(kI, bad, 1e-3), std::domain_error);
  }
  EXPECT_TRUE(polhode_family(kI, 1, {}, 1e-3).empty());
}

TEST(Separatrices, AreTwoPlaneEllipsesThroughTheIntermediateAxis) {
  for (const PrincipalMoments& I :
       {kI, PrincipalMoments(2.5, 1, 1.75), PrincipalMoments(1, 1 + 1e-9, 1 + 2e-9)}) {
    const double two_T = 3;
    const int middle = sorted_axes(I)[1];
    const auto both = separatrices(I, two_T, 1e-3);
    ASSERT_EQ(both.size(), 2U);
    for (const Curve& ellipse : both) {
      EXPECT_TRUE(ellipse.closed);
      double farthest = 0;
      for (const Vec3& p : ellipse.points) {
        ASSERT_NEAR(2 * kinetic_energy(I, p), two_T, 32 * kEps * two_T);
        ASSERT_NEAR(angular_momentum_B(I, p).squaredNorm(), two_T * I[middle], 32 * kEps * two_T * I[middle]);
        farthest = std::max(farthest, p[middle]);
      }
      EXPECT_NEAR(farthest, std::sqrt(two_T / I[middle]), 4 * kEps * farthest);
    }
    EXPECT_GT((both[0].points[0] - both[1].points[0]).norm(), 0.1);
  }
  EXPECT_TRUE(separatrices(PrincipalMoments(1, 1, 1.5), 1, 1e-3).empty());
  EXPECT_TRUE(separatrices(PrincipalMoments(1, 1.5, 1.5), 1, 1e-3).empty());
}

TEST(Poinsot, SemiAxesAndPlane) {
  EXPECT_EQ(energy_ellipsoid_semi_axes(PrincipalMoments(1, 4, 4), 16), Vec3(4, 2, 2));
  EXPECT_EQ(momentum_ellipsoid_semi_axes(PrincipalMoments(1, 4, 4), 16), Vec3(4, 8, 8));
  EXPECT_EQ(invariable_plane_distance(kI, {0, 0, 3}), 3);
  EXPECT_EQ(invariable_plane_distance(kI, {0, 0, 0}), 0);
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    const PrincipalMoments I = random.moments();
    const Vec3 w_B = random.vector(2);
    const double expected = 2 * kinetic_energy(I, w_B) / angular_momentum_B(I, w_B).norm();
    EXPECT_NEAR(invariable_plane_distance(I, w_B), expected, 8 * kEps * expected);
    const double two_T = 2 * kinetic_energy(I, w_B);
    EXPECT_NEAR(w_B.cwiseQuotient(energy_ellipsoid_semi_axes(I, two_T)).squaredNorm(), 1, 16 * kEps);
    EXPECT_NEAR(
        angular_momentum_B(I, w_B).cwiseQuotient(momentum_ellipsoid_semi_axes(I, two_T)).squaredNorm(), 1,
        16 * kEps);
  }
  EXPECT_NEAR(invariable_plane_distance(PrincipalMoments(1e300, 1e300, 1e300), {1e200, 0, 0}), 1e200,
              4 * kEps * 1e200);
}

TEST(Herpolhode, OfASymmetricTopIsACircleInTheInvariablePlane) {
  Random random(7);
  for (int i = 0; i < 20; ++i) {
    const PrincipalMoments I = random.symmetric_moments();
    const RigidBodyState start = random.state();
    const SymmetricMotion motion(I, start);
    const double tolerance = 1e-3;
    const Curve curve = herpolhode(motion, 0, 5, tolerance);
    const Vec3 axis_S = angular_momentum_S(I, start).normalized();
    const double distance = invariable_plane_distance(I, start.w_B);
    const double radius = std::sqrt(std::max(0.0, start.w_B.squaredNorm() - distance * distance));
    const double rounding = 1e3 * kEps * start.w_B.norm();  // up to 100 rad turned, ε each, in ω and q
    for (const Vec3& p : curve.points) {
      EXPECT_NEAR(p.dot(axis_S), distance, rounding);
      EXPECT_NEAR((p - distance * axis_S).norm(), radius, rounding * (1 + start.w_B.norm() / radius));
    }
    EXPECT_FALSE(curve.closed);
    for (double t = 0; t <= 5; t += 0.0371) {
      const RigidBodyState state = motion.at(t);
      EXPECT_LE(distance_to(curve, state.q_SB * state.w_B), tolerance) << t;
    }
  }
}

TEST(Herpolhode, OfAnAsymmetricBodyStaysInTheInvariablePlaneToTheMotionsOwnError) {
  const RigidBodyState start{Random(8).attitude(), {0.3, 1.5, -0.4}};
  const double h = 1.0 / 512, t = 20;
  const auto motion = rk4_motion({kI, start, {}}, h);
  const Vec3 axis_S = angular_momentum_S(kI, start).normalized();
  const Curve curve = herpolhode(*motion, 0, t, 1e-3);
  EXPECT_GT(curve.points.size(), 50U);
  EXPECT_LT(curve.points.size(), 5000U);
  for (const Vec3& p : curve.points) {
    EXPECT_NEAR(p.dot(axis_S), invariable_plane_distance(kI, start.w_B), t / h * std::pow(2 * h, 5));
  }
}

TEST(Herpolhode, OfSteadyRotationIsOnePoint) {
  const UniformMotion motion(kI, {Quat::Identity(), {0, 0, 3}});
  const Curve curve = herpolhode(motion, 0, 100, 1e-6);
  ASSERT_EQ(curve.points.size(), 1U);
  EXPECT_LE((curve.points[0] - Vec3(0, 0, 3)).norm(), 16 * kEps);
  EXPECT_EQ(herpolhode(motion, 1, 1, 1e-6).points.size(), 1U);
}

TEST(Herpolhode, BackwardsIsTheSameCurveReversed) {
  const SymmetricMotion motion(PrincipalMoments(1, 1, 1.5), {Quat::Identity(), {0.5, 0, 1}});
  Curve forward = herpolhode(motion, -2, 3, 1e-3);
  const Curve backward = herpolhode(motion, 3, -2, 1e-3);
  EXPECT_EQ(forward.points.front(), backward.points.back());
  EXPECT_EQ(forward.points.back(), backward.points.front());
}

TEST(Herpolhode, IsBoundedAndEndsWithTheMotion) {
  const SymmetricMotion motion(PrincipalMoments(1, 1, 1.5), {Quat::Identity(), {0.5, 0, 1}});
  EXPECT_LE(herpolhode(motion, 0, 1e9, 1e-6).points.size(), static_cast<std::size_t>(kMaxHerpolhodePoints));
  const auto blows_up = rk4_motion({kI, {Quat::Identity(), {100, 200, 300}}, {}}, 1.0);
  for (const Vec3& p : herpolhode(*blows_up, 0, 1000, 1e-3).points) EXPECT_TRUE(p.allFinite());
  EXPECT_THROW(herpolhode(motion, 0, kNaN, 1e-3), std::domain_error);
  EXPECT_THROW(herpolhode(motion, -std::numeric_limits<double>::infinity(), 0, 1e-3), std::domain_error);
}

TEST(PolhodePeriod, MatchesTheReference) {
  for (const test::ReferenceCase& c : test::reference_cases()) {
    const auto period_s = polhode_period(c.I, c.start.w_B);
    ASSERT_EQ(period_s.has_value(), !std::isnan(c.period_s)) << c.name;
    if (period_s) {
      EXPECT_NEAR(*period_s / c.period_s, 1, 8 * kEps) << c.name;
    }
  }
}

TEST(PolhodePeriod, OfASymmetricTopIsOneTurnInTheBody) {
  Random random(9);
  for (int i = 0; i < 50; ++i) {
    const PrincipalMoments I = random.symmetric_moments();
    const RigidBodyState start = random.state();
    const double expected = 2 * std::numbers::pi / std::abs(nu(I, start.w_B));
    EXPECT_NEAR(*polhode_period(I, start.w_B), expected, 8 * kEps * expected);
  }
}

/// Length of ω's way in space, rad/s, by a fine polyline.
double way_S(const Motion& motion, double t0_s, double t1_s) {
  constexpr int kChords = 4000;
  double length = 0;
  const auto tip_S = [&](int n) -> Vec3 {
    const RigidBodyState state = motion.at(std::lerp(t0_s, t1_s, double{1} * n / kChords));
    return state.q_SB * state.w_B;
  };
  for (int n = 0; n < kChords; ++n) length += (tip_S(n + 1) - tip_S(n)).norm();
  return length;
}

TEST(EqualArcTimes, AreEquallyFarApartOnBothCurves) {
  constexpr int kCount = 24;
  constexpr double kFrom_s = 1.3, kPolyline = 1e-6;  // chords of 1/4000 of a tick
  for (const Vec3& w_B : {Vec3(0.3, 1.1, 1.6), Vec3(0.02, 1.6, 0.03), Vec3(1.4, 0.2, 0.1)}) {
    const auto motion = make_motion({kI, {Quat::Identity(), w_B}, {}}, {});
    const double period_s = polhode_period(kI, w_B).value();
    std::vector<double> times_s = equal_arc_times(*motion, kI, kFrom_s, period_s, kCount);
    ASSERT_EQ(times_s.size(), static_cast<std::size_t>(kCount));
    EXPECT_EQ(times_s.front(), kFrom_s);
    times_s.push_back(kFrom_s + period_s);
    // The whole is that of the closed curve, which no motion was asked for.
    const Curve polhode = polhode_curve(kI, w_B, 1e-7);
    double whole = 0;
    for (std::size_t i = 0; i < polhode.points.size(); ++i)
      whole += (polhode.points[(i + 1) % polhode.points.size()] - polhode.points[i]).norm();
    for (std::size_t k = 0; k < kCount; ++k)
      EXPECT_NEAR(way_S(*motion, times_s[k], times_s[k + 1]), whole / kCount, kPolyline * whole) << k;
  }
}

TEST(EqualArcTimes, RefuseWhatIsNoPeriod) {
  const UniformMotion motion(kI, {});
  for (const double bad : {0.0, -1.0, kNaN, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(equal_arc_times(motion, kI, 0, bad, 4), std::domain_error);
  EXPECT_THROW(equal_arc_times(motion, kI, kNaN, 1, 4), std::domain_error);
  EXPECT_THROW(equal_arc_times(motion, kI, 0, 1, 0), std::domain_error);
}

}  // namespace
}  // namespace polhode
