// SPDX-License-Identifier: MIT
#include "physics/analysis/euler_terms.h"

#include "physics/analysis/difference.h"
#include "physics/method.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace polhode {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
const PrincipalMoments kI(1.0, 1.75, 2.5);
const Vec3 kOmega_B(0.7, 0.4, 1.1);

double gap(const EulerTerms& terms) {
  return (terms.inertial_B + terms.gyroscopic_B - terms.N_B).norm() / terms.largest();
}

TEST(EulerTerms, OfAFreeMotionCancel) {
  const auto motion = make_motion({kI, {Quat::Identity(), kOmega_B}, {}}, {});
  // ω of this body changes at most at thrice |ω|; rounding of the closed form, some tens of ε, over h.
  const double tolerance = std::pow(3 * kDifferenceAngle, 6) / 140 + 256 * kEpsilon / kDifferenceAngle;
  for (double t_s : {0.0, 0.9, 4.0, 31.0}) {
    const EulerTerms terms = euler_terms_at(*motion, kI, {}, t_s);
    EXPECT_LT(gap(terms), tolerance) << t_s;
    EXPECT_GT(terms.largest(), 0.1);
    EXPECT_EQ(terms.N_B, Vec3::Zero());
  }
}

TEST(EulerTerms, OfADrivenMotionAddUpToTheTorque) {
  const Torque torque = {SpaceTorque{Vec3(0.5, -0.3, 0.2)}, LinearDamping{0.2}};
  const auto motion = make_motion({kI, {Quat::Identity(), kOmega_B}, torque},
                                  {.method = Method::dormand_prince_8, .tolerance = 1e-12});
  for (double t_s : {0.0, 0.9, 4.0}) {
    const EulerTerms terms = euler_terms_at(*motion, kI, torque, t_s);
    EXPECT_LT(gap(terms), 4e-12 / kDifferenceAngle * 10) << t_s;  // the tolerance over h, and ω over a term
    EXPECT_GT(terms.N_B.norm(), 0.1);
  }
}

TEST(EulerTerms, FromRestTheTorqueDoesItAll) {
  const Torque torque = {BodyTorque{Vec3(0.0, 0.3, 0.0)}};
  const auto motion = make_motion({kI, {Quat::Identity(), Vec3::Zero()}, torque}, {Method::dormand_prince_8});
  const EulerTerms terms = euler_terms_at(*motion, kI, torque, 0.0);
  EXPECT_EQ(terms.gyroscopic_B, Vec3::Zero());
  EXPECT_LT((terms.inertial_B - terms.N_B).norm(), 0.3 * 4 * kDefaultTolerance / kDifferenceAngle);
}

// ω̇ is taken from the motion: what a bad method makes of (6) shows.
TEST(EulerTerms, OfABadMethodLeaveAGap) {
  const auto motion =
      make_motion({kI, {Quat::Identity(), kOmega_B}, {}}, {.method = Method::explicit_euler, .step_s = 0.4});
  EXPECT_GT(gap(euler_terms_at(*motion, kI, {}, 1.9)), 1e-3);
}

}  // namespace
}  // namespace polhode
