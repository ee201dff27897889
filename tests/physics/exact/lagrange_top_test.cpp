// SPDX-License-Identifier: MIT
#include "physics/exact/lagrange_top.h"

#include "physics/analysis/conditioning.h"
#include "physics/body/euler.h"
#include "physics/body/euler_angles.h"
#include "physics/exact/symmetric_motion.h"
#include "physics/integrators/dormand_prince.h"
#include "tests/physics/support.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace polhode {
namespace {

using Json = nlohmann::json;
using test::kEps;
using test::Random;
using Series = LagrangeTopMotion::Series;

Problem top_of(double I1, double I3, double mgl, const RigidBodyState& start) {
  return {PrincipalMoments(I1, I1, I3), start, {HeavyTop{mgl, Vec3::UnitZ()}}};
}

double number(const Json& text) { return std::strtod(text.get<std::string>().c_str(), nullptr); }
Vec3 vector_of(const Json& x) { return {number(x[0]), number(x[1]), number(x[2])}; }
Quat quaternion_of(const Json& x) { return {number(x[0]), number(x[1]), number(x[2]), number(x[3])}; }

const Json& references() {
  static const Json whole = [] {
    std::ifstream file(test::source_dir() / "tests/reference/lagrange_top.json");
    return Json::parse(file);
  }();
  return whole.at("cases");
}
Problem problem_of(const Json& c) {
  return top_of(number(c["I1_hex"]), number(c["I3_hex"]), number(c["mgl_hex"]),
                {quaternion_of(c["q0_hex"]), vector_of(c["omega0_hex"])});
}

TEST(LagrangeTop, IsWithinTheBarOnEveryReferenceTop) {
  ASSERT_GE(references().size(), 60u);
  double worst = 0;
  for (const Json& c : references()) {
    ASSERT_GE(c["agreement_digits"].get<double>(), 40) << "the two ways to the truth";
    const LagrangeTopMotion motion(problem_of(c));
    for (const Json& s : c["states"]) {
      const double bar_w = 4 * kEps * (1 + s["cond_omega"].get<double>()),
                   bar_q = 4 * kEps * (1 + s["cond_q"].get<double>());
      const RigidBodyState state = motion.at(number(s["t_hex"]));
      const double w = test::w_error(state.w_B, vector_of(s["omega"])),
                   q = test::q_error(state.q_SB, quaternion_of(s["q"]));
      EXPECT_LE(w, bar_w) << c["name"] << " " << s["t_hex"];
      EXPECT_LE(q, bar_q) << c["name"] << " " << s["t_hex"];
      worst = std::max({worst, 4 * w / bar_w, 4 * q / bar_q});
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

// What `measure` says of it may be too much, but not too little.
TEST(TopError, IsNeverBelowTheTruth) {
  double nearest = 0;
  for (const Json& c : references()) {
    const Problem problem = problem_of(c);
    const LagrangeTopMotion motion(problem);
    for (const Json& s : c["states"]) {
      const double t_s = number(s["t_hex"]), bound = top_error(problem, t_s);
      const RigidBodyState state = motion.at(t_s);
      const double angle_rad = 2 * std::asin(std::min(1.0, test::q_error(state.q_SB, quaternion_of(s["q"]))));
      EXPECT_LE(test::w_error(state.w_B, vector_of(s["omega"])), bound) << c["name"] << " " << t_s;
      EXPECT_LE(angle_rad, bound) << c["name"] << " " << t_s;
      nearest = std::max(nearest, angle_rad / bound);
    }
  }
  EXPECT_GE(nearest, 0.05) << "a bound that is never come near says nothing";
}

TEST(LagrangeTop, HasThePeriodOfTheReference) {
  for (const Json& c : references()) {
    const std::string name = c["name"];
    if (name == "separatrix_exact") continue;
    double cond = 1e3;  // of a period: near the separatrix the cond of the states has it
    for (const Json& s : c["states"]) cond = std::max(cond, s["cond_omega"].get<double>());
    const double period = number(c["period"]);
    EXPECT_NEAR(LagrangeTopMotion(problem_of(c)).facts().nutation_period_s, period, 4 * kEps * cond * period)
        << name;
  }
}

// A top of any kind: with little and with much weight, slow and fast, also almost upright and almost hanging.
Problem some_top(Random& random) {
  const double I1 = random.uniform(0.5, 1.5), I3 = I1 * random.uniform(0.01, 1.99);
  const double mgl = std::pow(10, random.uniform(-2, 1));
  RigidBodyState start{random.attitude(), random.vector(3)};
  start.w_B[2] *= std::pow(10, random.uniform(-2, 1));
  const double small = std::pow(10, random.uniform(-12, -1));
  switch (random.uniform_int(0, 5)) {
    case 0:
      start.q_SB = Quat(0.8, small, -small, 0.6).normalized();
      break;
    case 1:
      start.q_SB = Quat(small, 0.8, -0.6, small).normalized();
      break;
    case 2:
      start.w_B[0] = start.w_B[1] = 0;
      break;
    default:
      break;
  }
  return top_of(I1, I3, mgl, start);
}

double energy(const Problem& p, const RigidBodyState& s) {
  return kinetic_energy(p.I, s.w_B) + potential_energy(p.torque, s);
}
double L_z(const Problem& p, const RigidBodyState& s) { return angular_momentum_S(p.I, s).z(); }

TEST(LagrangeTop, KeepsEnergyAndMomentumAtAnyTime) {
  Random random(301);
  double worst_energy = 0, worst_L = 0, worst_norm = 0;
  for (int i = 0; i < 3000; ++i) {
    const Problem p = some_top(random);
    const LagrangeTopMotion motion(p);
    const double mgl = std::get<HeavyTop>(p.torque[0]).mgr;
    const double E_scale = kinetic_energy(p.I, p.start.w_B) + 2 * mgl;
    // The largest |L| that this energy allows.
    const double L_scale = std::sqrt(2 * E_scale * p.I.vector().maxCoeff());
    for (const double t : {random.uniform(-100, 100), random.uniform(-1e6, 1e6), 1e12, -1e18}) {
      const RigidBodyState s = motion.at(t);
      worst_energy = std::max(worst_energy, std::abs(energy(p, s) - energy(p, p.start)) / E_scale);
      worst_L = std::max(worst_L, std::abs(L_z(p, s) - L_z(p, p.start)) / L_scale);
      worst_norm = std::max(worst_norm, std::abs(s.q_SB.norm() - 1));
      ASSERT_EQ(s.w_B[2], p.start.w_B[2]);
    }
  }
  // Some twenty roundings of the series and amplitudes, and those of the check itself.
  EXPECT_LE(worst_energy, 64 * kEps);
  EXPECT_LE(worst_L, 64 * kEps);
  EXPECT_LE(worst_norm, 8 * kEps);
  RecordProperty("energy", std::to_string(worst_energy / kEps));
  RecordProperty("L_z", std::to_string(worst_L / kEps));
}

TEST(LagrangeTop, AgreesWithDormandPrince) {
  Random random(302);
  for (int i = 0; i < 40; ++i) {
    const Problem p = some_top(random);
    const double rate = p.start.w_B.norm() + std::sqrt(std::get<HeavyTop>(p.torque[0]).mgr / p.I[0]);
    const double t = random.uniform(-4, 4) / rate;
    const DormandPrinceMotion other(DormandPrincePair::eight_five_three, p, 1e-13);
    const RigidBodyState a = LagrangeTopMotion(p).at(t), b = other.at(t);
    // Each of a few dozen steps adds 1e-13, which what follows enlarges by e⁴ at most in this time.
    EXPECT_LE((a.w_B - b.w_B).norm(), 50 * 55 * 1e-13 * rate) << i;
    EXPECT_LE(test::q_error(a.q_SB, b.q_SB), 50 * 55 * 1e-13) << i;
  }
}

TEST(LagrangeTop, StartsAtTheStartToTheBit) {
  Random random(303);
  for (int i = 0; i < 500; ++i) {
    const Problem p = some_top(random);
    const LagrangeTopMotion motion(p);
    EXPECT_TRUE(test::same_bits(motion.at(0), checked(p).start));
    // And the formula with it, without a jump.
    const RigidBodyState at_once = motion.at(1e-300);
    EXPECT_LE(test::q_error(at_once.q_SB, p.start.q_SB), 16 * kEps) << i;
    const double rate = p.start.w_B.norm() + std::sqrt(std::get<HeavyTop>(p.torque[0]).mgr / p.I[0]);
    EXPECT_LE((at_once.w_B - p.start.w_B).norm(), 32 * kEps * rate) << i;
  }
}

TEST(LagrangeTop, RunsBackwardsAsForwards) {
  Random random(304);
  for (int i = 0; i < 500; ++i) {
    const Problem p = some_top(random);
    Problem reversed = p;
    reversed.start.w_B = -p.start.w_B;
    const double rate = p.start.w_B.norm() + std::sqrt(std::get<HeavyTop>(p.torque[0]).mgr / p.I[0]);
    const double t = random.uniform(0, 3) / rate;
    const RigidBodyState forth = LagrangeTopMotion(p).at(t), back = LagrangeTopMotion(reversed).at(-t);
    // The same numbers in mirrored order: roundings of a few angles below 4.
    EXPECT_LE((forth.w_B + back.w_B).norm(), 64 * kEps * rate) << i;
    EXPECT_LE(test::q_error(forth.q_SB, back.q_SB), 64 * kEps) << i;
  }
}

// Axis 1, 2 or 3, weight on either side: the body's axes renamed. The length of q is summed in another order.
TEST(LagrangeTop, DoesNotDependOnTheNamesOfTheAxes) {
  Random random(305);
  for (int i = 0; i < 200; ++i) {
    const Problem p = some_top(random);
    const double mgl = std::get<HeavyTop>(p.torque[0]).mgr, t = random.uniform(-20, 20);
    const RigidBodyState plain = LagrangeTopMotion(p).at(t);
    for (int c = 0; c < 3; ++c)
      for (const double sign : {1.0, -1.0}) {
        const auto renamed = [&](const Vec3& v) {
          Vec3 r;
          r[(c + 1) % 3] = v[0], r[(c + 2) % 3] = sign * v[1], r[c] = sign * v[2];
          return r;
        };
        // Space does not turn with the names.
        Mat3 names;
        for (int k = 0; k < 3; ++k) names.col(k) = renamed(Vec3::Unit(k));
        const Quat back(Mat3(names.transpose()));
        const auto of = [&](const RigidBodyState& s) {
          return RigidBodyState{s.q_SB * back, renamed(s.w_B)};
        };
        const Vec3 I = renamed(p.I.vector()).cwiseAbs();
        const Problem other{
            PrincipalMoments(I[0], I[1], I[2]), of(p.start), {HeavyTop{sign * mgl, Vec3::Unit(c)}}};
        const RigidBodyState state = LagrangeTopMotion(other).at(t), wanted = of(plain);
        const double bar = top_error(p, t) + 16 * kEps;  // the attitude is turned and turned back
        EXPECT_LE(test::q_error(state.q_SB, wanted.q_SB), bar) << i << " " << c << " " << sign;
        EXPECT_LE(test::w_error(state.w_B, wanted.w_B), bar) << i << " " << c << " " << sign;
      }
  }
}

// 2026-11-27: with another axis than +3 space was turned with the body, as in the test above: a body that
// hangs moved as one that stands on its head.
TEST(LagrangeTop, IsTheMotionOfTheEquationsAboutEveryAxis) {
  Random random(311);
  for (int i = 0; i < 20; ++i) {
    const Problem top = some_top(random);
    const double mgl = std::get<HeavyTop>(top.torque[0]).mgr;
    const double t_s = 0.5 / (top.start.w_B.norm() + std::sqrt(mgl / top.I[0]));
    for (int c = 0; c < 3; ++c)
      for (const double sign : {1.0, -1.0}) {
        Vec3 I = Vec3::Constant(top.I[0]), w_B;
        I[c] = top.I[2];
        for (int k = 0; k < 3; ++k) w_B[(c + 1 + k) % 3] = top.start.w_B[k];
        const Problem p{
            PrincipalMoments(I[0], I[1], I[2]), {top.start.q_SB, w_B}, {HeavyTop{sign * mgl, Vec3::Unit(c)}}};
        const RigidBodyState closed = LagrangeTopMotion(p).at(t_s),
                             stepped =
                                 DormandPrinceMotion(DormandPrincePair::eight_five_three, p, 1e-14).at(t_s);
        EXPECT_LE(test::q_error(closed.q_SB, stepped.q_SB), 1e-9) << i << " " << c << " " << sign;
        EXPECT_LE(test::w_error(closed.w_B, stepped.w_B), 1e-9) << i << " " << c << " " << sign;
      }
  }
}

TEST(LagrangeTop, ScalesByPowersOfTwoToTheBit) {
  Random random(306);
  for (int i = 0; i < 500; ++i) {
    const Problem p = some_top(random);
    const double mgl = std::get<HeavyTop>(p.torque[0]).mgr, t = random.uniform(-50, 50);
    const RigidBodyState plain = LagrangeTopMotion(p).at(t);
    const int e_I = random.uniform_int(-300, 300), e_w = random.uniform_int(-150, 150);
    RigidBodyState start = p.start;
    start.w_B *= std::scalbn(1.0, e_w);
    const Problem scaled =
        top_of(std::scalbn(p.I[0], e_I), std::scalbn(p.I[2], e_I), std::scalbn(mgl, e_I + 2 * e_w), start);
    RigidBodyState state = LagrangeTopMotion(scaled).at(std::scalbn(t, -e_w));
    state.w_B *= std::scalbn(1.0, -e_w);
    EXPECT_TRUE(test::same_bits(state, plain)) << i;
  }
}

TEST(LagrangeTop, NutatesBetweenItsLimitsInItsPeriod) {
  Random random(307);
  for (int i = 0; i < 300; ++i) {
    const Problem p = some_top(random);
    const LagrangeTopMotion motion(p);
    const TopFacts facts = motion.facts();
    double least = 4, most = -1;
    const auto theta_at = [&](double t) {
      const Vec3 e = motion.at(t).q_SB * Vec3::UnitZ();
      return std::atan2(std::hypot(e.x(), e.y()), e.z());
    };
    constexpr int kSamples = 2000;
    for (int k = 0; k < kSamples; ++k) {
      const double theta = theta_at(k * facts.nutation_period_s / kSamples);
      least = std::min(least, theta);
      most = std::max(most, theta);
      // Six roundings of u: √ε of θ in the vertical.
      ASSERT_GE(theta, facts.theta_least_rad - std::sqrt(16 * kEps)) << i;
      ASSERT_LE(theta, facts.theta_most_rad + std::sqrt(16 * kEps)) << i;
    }
    // A turning point is missed by half a sample at most; the axis turns there with less than 4|ω|.
    const double swing = facts.theta_most_rad - facts.theta_least_rad;
    EXPECT_NEAR(least, facts.theta_least_rad, std::sqrt(16 * kEps) + 0.02 * swing) << i;
    EXPECT_NEAR(most, facts.theta_most_rad, std::sqrt(16 * kEps) + 0.02 * swing) << i;
  }
}

TEST(LagrangeTop, PrecessesAndSpinsAtItsMeanRates) {
  Random random(308);
  for (int i = 0; i < 300; ++i) {
    const Problem p = some_top(random);
    const LagrangeTopMotion motion(p);
    const TopFacts facts = motion.facts();
    if (facts.theta_least_rad < 1e-4 || facts.theta_most_rad > 3.1415)
      continue;  // φ and ψ are not told apart
    const double T = facts.nutation_period_s;
    const EulerAngles a = euler_angles_of(p.start.q_SB), b = euler_angles_of(motion.at(T).q_SB);
    const double bar = 1e-10 * (1 + T * p.start.w_B.norm());
    EXPECT_NEAR(std::remainder(b.phi_rad - a.phi_rad - facts.mean_precession * T, 2 * std::numbers::pi), 0,
                bar);
    EXPECT_NEAR(std::remainder(b.psi_rad - a.psi_rad - facts.mean_spin * T, 2 * std::numbers::pi), 0, bar);
  }
}

TEST(LagrangeTop, WithoutWeightIsTheFreeSymmetricBody) {
  Random random(309);
  for (int i = 0; i < 200; ++i) {
    Problem p = some_top(random);
    std::get<HeavyTop>(p.torque[0]).mgr = 0;
    const double t = random.uniform(-10, 10);
    const RigidBodyState a = LagrangeTopMotion(p).at(t), b = SymmetricMotion(p.I, p.start).at(t);
    const double turned = 4 * p.start.w_B.norm() * std::abs(t);
    EXPECT_LE((a.w_B - b.w_B).norm(), 8 * kEps * (1 + turned) * p.start.w_B.norm()) << i;
    EXPECT_LE(test::q_error(a.q_SB, b.q_SB), 8 * kEps * (1 + turned)) << i;
  }
}

TEST(LagrangeTop, SleepsHangsAndRests) {
  for (const Quat& q : {Quat(0.6, 0, 0, 0.8), Quat(0, 0.6, 0.8, 0)})
    for (const double w3 : {7.0, -0.5, 0.0}) {
      const LagrangeTopMotion motion(top_of(1, 0.5, 2, {q, Vec3(0, 0, w3)}));
      EXPECT_EQ(motion.series(), Series::rotation);
      const RigidBodyState s = motion.at(3);
      EXPECT_EQ(s.w_B, Vec3(0, 0, w3));
      EXPECT_LE(test::q_error(s.q_SB, q * Quat(std::cos(1.5 * w3), 0, 0, std::sin(1.5 * w3))), 8 * kEps);
    }
}

TEST(LagrangeTop, OnTheSeparatrixComesToRestUpright) {
  const LagrangeTopMotion motion(top_of(1, 1, 1, {Quat(0, 1, 0, 0), Vec3(2, 0, 0)}));
  EXPECT_EQ(motion.series(), Series::separatrix);
  for (const double t : {700.0, -700.0, 1e9}) {
    const RigidBodyState s = motion.at(t);
    EXPECT_GE((s.q_SB * Vec3::UnitZ()).z(), 1 - 4 * kEps);
    EXPECT_LE(s.w_B.norm(), 1e-200);
  }
}

// The ends of the range: finite, with the invariants, at any time.
TEST(LagrangeTop, HoldsAtTheEndsOfTheRange) {
  constexpr double kMax = std::numeric_limits<double>::max(),
                   kTiny = std::numeric_limits<double>::denorm_min();
  const Quat q = Quat(1, 2, -3, 4).normalized();
  for (const double ratio : {1e-300, 1e-8, 1.0, 2.0})
    for (const double mgl : {0.0, kTiny, 1e-150, 1.0, 1e150, 1e300})
      for (const double w : {0.0, 1e-300, 1e-150, 1.0, 1e150})
        for (const double w3 : {0.0, 1e-150, -1.0, 1e150})
          for (const double tilt : {0.0, 1e-160, 1.0}) {
            const Quat start = tilt == 1 ? q : Quat(1, tilt, 0, 0);
            const Problem p = top_of(1, ratio, mgl, {start, Vec3(w, -w, w3)});
            const LagrangeTopMotion motion(p);
            for (const double t : {kTiny, 1e-150, 1.0, 1e150, kMax, -kMax}) {
              const RigidBodyState s = motion.at(t);
              ASSERT_TRUE(s.w_B.allFinite())
                  << ratio << " " << mgl << " " << w << " " << w3 << " " << tilt << " " << t;
              ASSERT_NEAR(s.q_SB.norm(), 1, 8 * kEps)
                  << ratio << " " << mgl << " " << w << " " << w3 << " " << tilt << " " << t;
            }
          }
}

TEST(LagrangeTop, SaysWhyItDoesNotServe) {
  const PrincipalMoments symmetric(1, 1, 0.5);
  EXPECT_FALSE(why_no_top(symmetric, {}));
  EXPECT_FALSE(why_no_top(symmetric, {HeavyTop{-1, Vec3::UnitZ()}}));
  EXPECT_FALSE(why_no_top(symmetric, {HeavyTop{1, Vec3::UnitX()}, HeavyTop{-1, Vec3::UnitX()}}));
  EXPECT_EQ(why_no_top(symmetric, {HeavyTop{1, Vec3::UnitX()}}),
            "the two moments across the axis of the weight are not equal");
  EXPECT_EQ(why_no_top(symmetric, {HeavyTop{1, Vec3(0, 0.6, 0.8)}}), "the weight acts on no principal axis");
  EXPECT_EQ(why_no_top(symmetric, {LinearDamping{0.1}}), "it serves weight alone");
  EXPECT_EQ(why_no_top(PrincipalMoments(1, 2, 2.5), {}), "no two moments are equal");
  EXPECT_EQ(why_no_top(PrincipalMoments(1, std::nextafter(1.0, 2), 0.5), {HeavyTop{1, Vec3::UnitZ()}}),
            "the two moments across the axis of the weight are not equal");
  EXPECT_THROW(LagrangeTopMotion({PrincipalMoments(1, 2, 2.5), {}, {HeavyTop{1, Vec3::UnitZ()}}}),
               std::domain_error);
}

}  // namespace
}  // namespace polhode
