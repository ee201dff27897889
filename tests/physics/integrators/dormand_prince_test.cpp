// SPDX-License-Identifier: MIT
#include "physics/integrators/dormand_prince.h"

#include "physics/body/euler.h"
#include "physics/method.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <thread>

namespace polhode {
namespace {

using test::kEps;
using test::q_error;
using test::Random;
using test::same_bits;
using test::w_error;
using enum DormandPrincePair;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kTolerance = 1e-10;

const PrincipalMoments kI(1.0, 1.75, 2.5);
const RigidBodyState kStart{Quat::Identity(), {0.2, 1.0, 0.3}};
const Torque kEveryTorque{SpaceTorque{{0.1, 0, 0.2}}, BodyTorque{{0, 0.1, 0}}, HeavyTop{0.5, Vec3::UnitY()},
                          LinearDamping{0.05}, EnergySink{0.02}};
const DormandPrincePair kPairs[] = {five_four, eight_five_three};

int order_of(DormandPrincePair pair) { return pair == five_four ? 5 : 8; }
int stages_of(DormandPrincePair pair) { return pair == five_four ? 6 : 12; }

// Each step adds at most the tolerance and some ε of rounding.
double sum_of_local_errors(const DormandPrinceMotion& motion, DormandPrincePair pair, double t) {
  const double steps = static_cast<double>(motion.evaluations_to(t)) / stages_of(pair);
  return steps * (motion.tolerance() + 8 * kEps);
}

// ---- Order observed
// ----------------------------------------------------------------------------------------

struct Errors {
  double w, q;
};

Errors difference(const RigidBodyState& x, const RigidBodyState& y) {
  return {w_error(x.w_B, y.w_B), q_error(x.q_SB, y.q_SB)};
}

// q as the steps give it: scaled to unit length it would show order 6 in a body that spins much more than it
// tumbles, because the error of order 5 then is in the length.
RigidBodyState after_steps(DormandPrincePair pair, const EquationsOfMotion& equations,
                           const RigidBodyState& start, double h, int n) {
  MotionVector y = packed(start);
  for (int i = 0; i < n; ++i) y = dormand_prince_step(pair, equations, y, h);
  return unpacked(y);
}

bool is_in_window(double error) { return error >= 1e-12 && error <= 1e-5; }

// Observed order in ω and in q, each of its finest pair of halved steps with errors in [1e-12, 1e-5].
Errors observed_orders(DormandPrincePair pair, const Problem& problem, double t,
                       const RigidBodyState& truth) {
  const EquationsOfMotion equations(problem.I, problem.torque);
  const auto error = [&](int n) {
    return difference(after_steps(pair, equations, problem.start, t / n, n), truth);
  };
  Errors orders{kNaN, kNaN};
  for (int n = 8; n < 1000; n += std::max(1, n / 6)) {
    const Errors coarse = error(n), fine = error(2 * n);
    if (is_in_window(coarse.w) && is_in_window(fine.w)) orders.w = std::log2(coarse.w / fine.w);
    if (is_in_window(coarse.q) && is_in_window(fine.q)) orders.q = std::log2(coarse.q / fine.q);
  }
  return orders;
}

struct StateOfReference {
  const char* name;
  std::size_t place;
};

TEST(DormandPrince, HasItsOrderAgainstTheReference) {
  for (const DormandPrincePair pair : kPairs) {
    for (const StateOfReference s : {StateOfReference{"generic_above", 1}, {"generic_perm_312", 2}}) {
      const test::ReferenceCase& c = test::reference_case(s.name);
      const test::ReferenceState& truth = c.states[s.place];
      const Errors orders = observed_orders(pair, {c.I, c.start, {}}, truth.t_s, truth.state);
      EXPECT_NEAR(orders.w, order_of(pair), 0.1) << s.name;
      EXPECT_NEAR(orders.q, order_of(pair), 0.1) << s.name;
    }
  }
}

// More than its order is no mistake: where the leading term of the error is small, the next one still shows
// at 1e-12 (order 8: up to 8.4 here).
TEST(DormandPrince, HasNoLessThanItsOrderInAnyGenericBody) {
  for (const DormandPrincePair pair : kPairs) {
    for (const char* name : {"generic_above", "generic_below", "generic_perm_213", "generic_perm_312"}) {
      const test::ReferenceCase& c = test::reference_case(name);
      for (const test::ReferenceState& truth : c.states) {
        const double periods = std::abs(truth.t_s) / c.period_s;
        if (periods < 0.4 || periods > 1.1) continue;
        const Errors orders = observed_orders(pair, {c.I, c.start, {}}, truth.t_s, truth.state);
        EXPECT_GE(orders.w, order_of(pair) - 0.1) << name;
        EXPECT_GE(orders.q, order_of(pair) - 0.1) << name;
      }
    }
  }
}

// 0.2 for the same reason.
TEST(DormandPrince, HasItsOrderUnderEveryTorque) {
  const Problem problem{kI, kStart, kEveryTorque};
  const double t = 8;
  const RigidBodyState truth =
      after_steps(eight_five_three, {problem.I, problem.torque}, problem.start, t / 1024, 1024);
  for (const DormandPrincePair pair : kPairs) {
    const Errors orders = observed_orders(pair, problem, t, truth);
    EXPECT_NEAR(orders.w, order_of(pair), 0.2);
    EXPECT_NEAR(orders.q, order_of(pair), 0.2);
  }
}

// Error of a polynomial of order p within one step: h^(p+1).
TEST(DormandPrince, DenseOutputHasItsOrder) {
  for (const DormandPrincePair pair : kPairs) {
    const EquationsOfMotion equations(kI, kEveryTorque);
    for (const double theta : {0.25, 0.7}) {
      double order = kNaN, last = 1;
      for (double h = 1; h > 1.0 / 1024; h /= 2) {
        const RigidBodyState truth = after_steps(eight_five_three, equations, kStart, theta * h / 64, 64);
        const RigidBodyState state =
            unpacked(dormand_prince_dense(pair, equations, packed(kStart), h, theta));
        const double error = difference(state, truth).w + difference(state, truth).q;
        if (is_in_window(last) && is_in_window(error)) order = std::log2(last / error);
        last = error;
      }
      EXPECT_NEAR(order, (pair == five_four ? 4 : 7) + 1, 0.2) << theta;
    }
  }
}

TEST(DormandPrince, DenseOutputMeetsTheStepAndTheRateAtBothEnds) {
  for (const DormandPrincePair pair : kPairs) {
    const EquationsOfMotion equations(kI, kEveryTorque);
    const MotionVector y = packed(kStart);
    const double h = 0.2, d = 0x1p-20;
    const MotionVector end = dormand_prince_step(pair, equations, y, h);
    MotionVector rate, end_rate;
    equations.rate(y, rate);
    equations.rate(end, end_rate);
    const auto dense = [&](double theta) { return dormand_prince_dense(pair, equations, y, h, theta); };
    for (int n = 0; n < 7; ++n) {
      EXPECT_EQ(dense(0)[n], y[n]);
      EXPECT_NEAR(dense(1)[n], end[n], 4 * kEps);
      // One-sided difference quotients: ½ d of the second derivative, of size 1, and rounding over d.
      EXPECT_NEAR((dense(d)[n] - y[n]) / (d * h), rate[n], d + 4 * kEps / (d * h));
      EXPECT_NEAR((end[n] - dense(1 - d)[n]) / (d * h), end_rate[n], d + 8 * kEps / (d * h));
    }
  }
}

// ---- Accuracy by tolerance
// ----------------------------------------------------------------------------------

TEST(DormandPrinceMotion, AgreesWithTheReferenceOfEveryBodyThatDoesNotTurnForEver) {
  int bodies = 0;
  for (const test::ReferenceCase& c : test::reference_cases()) {
    const test::ReferenceState& truth = c.states[0];
    if (c.start.w_B.stableNorm() * std::abs(truth.t_s) > 500) continue;
    ++bodies;
    for (const DormandPrincePair pair : kPairs) {
      const DormandPrinceMotion motion(pair, {c.I, c.start, {}}, 1e-12);
      const Errors error = difference(motion.at(truth.t_s), truth.state);
      // What each step adds is carried on by the motion's own condition number.
      const double local = sum_of_local_errors(motion, pair, truth.t_s) + kEps;
      EXPECT_LE(error.w, local * (1 + truth.cond_w)) << c.name;
      EXPECT_LE(error.q, local * (1 + truth.cond_q)) << c.name;
    }
  }
  EXPECT_GE(bodies, 40);
}

TEST(DormandPrinceMotion, ErrorIsProportionalToTheTolerance) {
  const test::ReferenceCase& c = test::reference_case("generic_above");
  const test::ReferenceState& truth = c.states[1];
  for (const DormandPrincePair pair : kPairs) {
    double least = 1e300, most = 0;
    for (const double tolerance : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12}) {
      const Errors error =
          difference(DormandPrinceMotion(pair, {c.I, c.start, {}}, tolerance).at(truth.t_s), truth.state);
      least = std::min(least, std::max(error.w, error.q) / tolerance);
      most = std::max(most, std::max(error.w, error.q) / tolerance);
    }
    // Over seven decades the ratio may wander by one: the dense output and the phase of the steps take part.
    EXPECT_LE(most / least, 20);
    EXPECT_LE(most, 5 * (1 + truth.cond_w));
  }
}

// Of 5(4) as tolerance^(−1/5). Of 8(5,3), whose estimate mixes orders, slower.
TEST(DormandPrinceMotion, EvaluationsGrowWithTheRootOfTheTolerance) {
  const auto growth = [](DormandPrincePair pair) {
    const auto evaluations = [pair](double tolerance) {
      return static_cast<double>(DormandPrinceMotion(pair, {kI, kStart, {}}, tolerance).evaluations_to(200));
    };
    return std::log10(evaluations(1e-12) / evaluations(1e-7));
  };
  EXPECT_NEAR(growth(five_four), 5.0 / 5, 0.1);
  EXPECT_GE(growth(eight_five_three), 0.3);
  EXPECT_LE(growth(eight_five_three), 0.7);
}

TEST(DormandPrinceMotion, GoesBackTheWayItCame) {
  Random random(21);
  for (const DormandPrincePair pair : kPairs) {
    for (int i = 0; i < 10; ++i) {
      const PrincipalMoments I = random.moments();
      const RigidBodyState start = random.state();
      const DormandPrinceMotion there(pair, {I, start, kEveryTorque}, kTolerance);
      const double t = random.uniform(-3, 3);
      const DormandPrinceMotion back(pair, {I, there.at(t), kEveryTorque}, kTolerance);
      const Errors error = difference(back.at(-t), start);
      // Two ways, and what is carried on grows at most as e^(rate t), whose size random bodies keep below
      // 1e4.
      const double local = sum_of_local_errors(there, pair, t) + sum_of_local_errors(back, pair, -t);
      EXPECT_LE(std::max(error.w, error.q), 1e4 * local);
    }
  }
}

// ---- A function of time
// -------------------------------------------------------------------------------------

TEST(DormandPrinceMotion, DependsOnTheTimeAloneAndNotOnTheTimesAskedBefore) {
  for (const DormandPrincePair pair : kPairs) {
    const Problem problem{kI, kStart, kEveryTorque};
    std::vector<double> times;
    for (int i = -100; i <= 100; ++i) times.push_back(0.371 * i);
    const DormandPrinceMotion ordered(pair, problem, kTolerance), shuffled(pair, problem, kTolerance),
        batch(pair, problem, kTolerance);
    std::vector<RigidBodyState> expected;
    for (const double t : times) expected.push_back(ordered.at(t));

    std::vector<RigidBodyState> states(times.size());
    batch.at(times, states);
    std::vector<std::size_t> order(times.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), Random(22).engine());
    for (const std::size_t i : order) {
      EXPECT_TRUE(same_bits(states[i], expected[i])) << times[i];
      EXPECT_TRUE(same_bits(shuffled.at(times[i]), expected[i])) << times[i];
      EXPECT_TRUE(same_bits(DormandPrinceMotion(pair, problem, kTolerance).at(times[i]), expected[i]));
      EXPECT_EQ(shuffled.evaluations_to(times[i]),
                DormandPrinceMotion(pair, problem, kTolerance).evaluations_to(times[i]));
      EXPECT_EQ(shuffled.w_B_at(times[i]), expected[i].w_B);
    }
  }
}

TEST(DormandPrinceMotion, ABatchInAnyOrderIsALoop) {
  const DormandPrinceMotion motion(eight_five_three, {kI, kStart, {}}, kTolerance);
  std::vector<double> times{0, kNaN, 1e300, -0.0};
  Random random(23);
  for (int i = 0; i < 300; ++i) times.push_back(random.uniform(-1, 1) * std::pow(10, random.uniform(-6, 3)));
  times.push_back(times.back());
  times[2] = std::numeric_limits<double>::infinity();
  std::vector<RigidBodyState> states(times.size());
  motion.at(times, states);
  for (std::size_t i = 4; i < times.size(); ++i)
    EXPECT_TRUE(same_bits(states[i], motion.at(times[i]))) << times[i];
  EXPECT_TRUE(same_bits(states[0], kStart));
  EXPECT_TRUE(std::isnan(states[1].w_B[0]));
  EXPECT_TRUE(std::isnan(states[2].q_SB.w()));
}

TEST(DormandPrinceMotion, ServesManyThreadsTheSame) {
  const Problem problem{kI, kStart, {EnergySink{0.01}}};
  const DormandPrinceMotion motion(eight_five_three, problem, kTolerance),
      alone(eight_five_three, problem, kTolerance);
  std::vector<RigidBodyState> expected;
  for (int i = 0; i < 400; ++i) expected.push_back(alone.at(0.5 * (i - 200)));
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (unsigned seed = 0; seed < 4; ++seed) {
    threads.emplace_back([&, seed] {
      std::mt19937 engine(seed);
      for (int n = 0; n < 400; ++n) {
        const int i = static_cast<int>(engine() % 400);
        if (!same_bits(motion.at(0.5 * (i - 200)), expected[static_cast<std::size_t>(i)])) ++wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

// Across the ends of some 10⁵ steps too: a time one ulp later is a state |ω| ulp and some rounding later.
TEST(DormandPrinceMotion, IsContinuousFarOut) {
  const double tolerance = 1e-6, rate = 2;
  const DormandPrinceMotion motion(eight_five_three, {kI, kStart, {}}, tolerance);
  for (const double far : {0.0, 1000.0, -50'000.0}) {
    std::vector<double> times;
    for (int i = 1; i <= 2000; ++i) {
      const double t = far + 0.0173 * i;
      times.insert(times.end(), {t, std::nextafter(t, 1e9)});
    }
    std::vector<RigidBodyState> states(times.size());
    motion.at(times, states);
    for (std::size_t i = 0; i < times.size(); i += 2) {
      const Errors jump = difference(states[i], states[i + 1]);
      const double allowed = rate * (times[i + 1] - times[i]) + 32 * kEps;
      ASSERT_LE(jump.w, allowed) << times[i];
      ASSERT_LE(jump.q, allowed) << times[i];
    }
  }
}

TEST(DormandPrinceMotion, StartsAtTheStartToTheBit) {
  const RigidBodyState start{Quat::Identity(), {5e-324, 1e-310, 0}};
  const DormandPrinceMotion motion(five_four, {kI, start, {BodyTorque{{1, 2, 3}}}}, kTolerance);
  EXPECT_TRUE(same_bits(motion.at(0), start));
  EXPECT_EQ(motion.evaluations_to(0), 0);
}

// ---- Torques
// ------------------------------------------------------------------------------------------------

TEST(DormandPrinceMotion, ConstantBodyTorqueAboutAPrincipalAxisSpeedsUpEvenly) {
  for (const DormandPrincePair pair : kPairs) {
    for (const double w0 : {0.0, 0.7, -2.0}) {  // from rest; ahead; through rest and back
      const double N = 0.5, I = kI[2];
      const DormandPrinceMotion motion(pair, {kI, {Quat::Identity(), {0, 0, w0}}, {BodyTorque{{0, 0, N}}}},
                                       kTolerance);
      for (const double t : {1e-9, 0.3, 9.999999, 10.0, 25.0, -7.0}) {
        const RigidBodyState state = motion.at(t);
        const double angle = w0 * t + 0.5 * (N / I) * t * t, local = sum_of_local_errors(motion, pair, t);
        // ω is a polynomial of degree 1, which the method has exactly but for some ε a step.
        const double steps = 2 + local / kTolerance, size = std::abs(w0) + N / I * std::abs(t);
        EXPECT_NEAR(state.w_B[2], w0 + N / I * t, 4 * kEps * steps * size) << t;
        EXPECT_LE(q_error(state.q_SB, Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()))), local + 4 * kEps);
      }
    }
  }
}

TEST(DormandPrinceMotion, ConstantTorqueInSpaceTurnsMomentumEvenly) {
  Random random(31);
  for (const DormandPrincePair pair : kPairs) {
    for (int i = 0; i < 10; ++i) {
      const PrincipalMoments I = random.moments();
      RigidBodyState start = random.state();
      if (i == 0) start.w_B = Vec3::Zero();
      const Vec3 N_S = random.vector(1), L_S = angular_momentum_S(I, start);
      const DormandPrinceMotion motion(pair, {I, start, {SpaceTorque{N_S}}}, kTolerance);
      const double t = random.uniform(-5, 5);
      const Vec3 L = angular_momentum_S(I, motion.at(t)), expected = L_S + N_S * t;
      // δL = R I δω + δR L, of a body that grows faster as L does: its largest |L| is at one of the ends.
      const double size =
          3 * I.vector().maxCoeff() / I.vector().minCoeff() * std::max(L_S.norm(), expected.norm());
      EXPECT_LE((L - expected).norm(), size * sum_of_local_errors(motion, pair, t));
    }
  }
}

TEST(DormandPrinceMotion, DampingAboutAPrincipalAxisAndOfASphereIsExponential) {
  for (const DormandPrincePair pair : kPairs) {
    const double c = 0.6;
    const DormandPrinceMotion axis(pair, {kI, {Quat::Identity(), {0, 1.5, 0}}, {LinearDamping{c}}},
                                   kTolerance);
    const PrincipalMoments sphere_I(2, 2, 2);
    const RigidBodyState start{Quat::Identity(), {0.5, -1, 2}};
    const DormandPrinceMotion sphere(pair, {sphere_I, start, {LinearDamping{c}}}, kTolerance);
    for (const double t : {-3.0, 0.2, 4.0, 60.0, 400.0}) {
      const Vec3 w_axis(0, 1.5 * std::exp(-c / kI[1] * t), 0), w_sphere = start.w_B * std::exp(-c / 2 * t);
      // Relative also when little is left.
      EXPECT_LE(w_error(axis.at(t).w_B, w_axis), sum_of_local_errors(axis, pair, t)) << t;
      EXPECT_LE(w_error(sphere.at(t).w_B, w_sphere), sum_of_local_errors(sphere, pair, t)) << t;
      const double angle = 1.5 * kI[1] / c * (1 - std::exp(-c / kI[1] * t));
      EXPECT_LE(q_error(axis.at(t).q_SB, Quat(Eigen::AngleAxisd(angle, Vec3::UnitY()))),
                std::exp(std::max(0.0, -c / kI[1] * t)) * sum_of_local_errors(axis, pair, t));
    }
  }
}

// Stable steps of an explicit method are then of the length I/c, however little happens: some 3·10⁴ of them.
// ω dies below the smallest double on the way.
TEST(DormandPrinceMotion, StrongDampingIsSlowButWorks) {
  for (const DormandPrincePair pair : kPairs) {
    const DormandPrinceMotion motion(pair, {kI, kStart, {LinearDamping{1e4}}}, 1e-6);
    EXPECT_LE(motion.at(10).w_B.norm(), 1e-280);
    const RigidBodyState end = motion.at(10), earlier = motion.at(0.01);
    // ∫ω dt = I ω₀/c, to the first order in what turns meanwhile.
    EXPECT_NEAR(end.q_SB.x(), 0.5e-4 * kI[0] * kStart.w_B[0], 1e-8);
    EXPECT_NEAR(end.q_SB.y(), 0.5e-4 * kI[1] * kStart.w_B[1], 1e-8);
    EXPECT_LE(q_error(end.q_SB, earlier.q_SB), sum_of_local_errors(motion, pair, 10));
    EXPECT_LE(motion.evaluations_to(10), 2'000'000);
  }
}

TEST(DormandPrinceMotion, HeavyTopKeepsEnergyAndVerticalMomentum) {
  Random random(32);
  for (const DormandPrincePair pair : kPairs) {
    for (int i = 0; i < 10; ++i) {
      const PrincipalMoments I = random.moments();
      RigidBodyState start = random.state();
      if (i == 0) start.w_B = Vec3::Zero();  // let go at rest
      const Torque top{HeavyTop{random.uniform(0.2, 2), random.vector(1).normalized()}};
      const DormandPrinceMotion motion(pair, {I, start, top}, kTolerance);
      const auto energy = [&](const RigidBodyState& s) {
        return kinetic_energy(I, s.w_B) + potential_energy(top, s);
      };
      const auto L_z = [&](const RigidBodyState& s) { return angular_momentum_S(I, s).z(); };
      const double mgr = std::get<HeavyTop>(top[0]).mgr, T_most = energy(start) + mgr;
      const double L_most = std::sqrt(2 * T_most * I.vector().maxCoeff());
      for (const double t : {5.0, -5.0, 30.0}) {
        const double local = sum_of_local_errors(motion, pair, t);
        // δE = L·δω + N·δ(angle), δL_z = e_z·(R I δω + δR L).
        const double spread = I.vector().maxCoeff() / I.vector().minCoeff();
        EXPECT_NEAR(energy(motion.at(t)), energy(start), 2 * local * (spread * T_most + mgr)) << t;
        EXPECT_NEAR(L_z(motion.at(t)), L_z(start), 3 * local * spread * L_most) << t;
      }
    }
  }
}

// Goldstein, 3rd ed., eq. (5.72) ff.: at the tilt ϑ a symmetric top precesses steadily at Ω if
// mgr = Ω (I₃ω₃ − I₁ Ω cos ϑ).
TEST(DormandPrinceMotion, SymmetricTopPrecessesSteadily) {
  const PrincipalMoments I(1, 1, 1.5);
  const double tilt = 0.6, Omega = 0.8, w3 = 5;
  const double mgr = Omega * (I[2] * w3 - I[0] * Omega * std::cos(tilt));
  const Quat q0(Eigen::AngleAxisd(tilt, Vec3::UnitX()));
  const Vec3 w0 = q0.conjugate() * Vec3(0, 0, Omega) + Vec3(0, 0, w3 - Omega * std::cos(tilt));
  for (const DormandPrincePair pair : kPairs) {
    const DormandPrinceMotion motion(pair, {I, {q0, w0}, {HeavyTop{mgr, Vec3::UnitZ()}}}, kTolerance);
    for (const double t : {0.5, 8.0, -20.0}) {
      const Vec3 axis = Eigen::AngleAxisd(Omega * t, Vec3::UnitZ()) * (q0 * Vec3::UnitZ());
      const double turns = 1 + w3 * std::abs(t);  // an error of ω₃ becomes one of Ω and grows with time
      EXPECT_LE((motion.at(t).q_SB * Vec3::UnitZ() - axis).norm(),
                turns * sum_of_local_errors(motion, pair, t));
    }
  }
}

TEST(DormandPrinceMotion, EnergySinkKeepsMomentumAndEndsOnTheMajorAxis) {
  for (const DormandPrincePair pair : kPairs) {
    const DormandPrinceMotion motion(pair, {kI, {Quat::Identity(), {1, 0.02, 0.01}}, {EnergySink{0.1}}},
                                     kTolerance);
    const Vec3 L_S = angular_momentum_S(kI, motion.at(0));
    double T = kinetic_energy(kI, motion.at(0).w_B);
    for (double t = 1; t <= 300; t += 1) {
      const RigidBodyState state = motion.at(t);
      EXPECT_LE((angular_momentum_S(kI, state) - L_S).norm(),
                3 * L_S.norm() * sum_of_local_errors(motion, pair, t));
      const double T_now = kinetic_energy(kI, state.w_B);
      EXPECT_LE(T_now, T * (1 + 4 * kTolerance)) << t;
      T = T_now;
    }
    const double T_least = 0.5 * L_S.squaredNorm() / kI[2];
    EXPECT_NEAR(T, T_least, 2 * T_least * sum_of_local_errors(motion, pair, 300));
    EXPECT_NEAR(std::abs(motion.at(300).w_B[2]), L_S.norm() / kI[2], 1e-6);
  }
}

// ---- Scales and ends
// ----------------------------------------------------------------------------------------

Torque scaled(const Torque& torque, double torque_unit, double damping_unit) {
  struct Scaled {
    double N, c;
    TorqueTerm operator()(const SpaceTorque& term) const { return SpaceTorque{N * term.N_S}; }
    TorqueTerm operator()(const BodyTorque& term) const { return BodyTorque{N * term.N_B}; }
    TorqueTerm operator()(const HeavyTop& term) const { return HeavyTop{N * term.mgr, term.axis_B}; }
    TorqueTerm operator()(const LinearDamping& term) const { return LinearDamping{c * term.c}; }
    TorqueTerm operator()(const EnergySink& term) const { return term; }
  };
  Torque result;
  for (const TorqueTerm& term : torque) result.push_back(std::visit(Scaled{torque_unit, damping_unit}, term));
  return result;
}

TEST(DormandPrinceMotion, ScalesToTheBitWithPowersOfTwo) {
  Random random(41);
  for (int i = 0; i < 60; ++i) {
    const DormandPrincePair pair = kPairs[i % 2];
    const PrincipalMoments I = random.moments();
    RigidBodyState start = random.state();
    if (i % 5 == 0) start.w_B = Vec3::Zero();
    const Torque torque = i % 3 == 0 ? Torque{} : kEveryTorque;
    const double t = random.uniform(-5, 5);
    const RigidBodyState plain = DormandPrinceMotion(pair, {I, start, torque}, 1e-8).at(t);
    for (const auto& [inertia, rate] : {std::pair(0x1p301, 0x1p-203), {0x1p-300, 0x1p300}, {0x1p5, 0x1p-7}}) {
      const PrincipalMoments scaled_I(I[0] * inertia, I[1] * inertia, I[2] * inertia);
      const Torque scaled_torque = scaled(torque, inertia * rate * rate, inertia * rate);
      const DormandPrinceMotion motion(pair, {scaled_I, {start.q_SB, start.w_B * rate}, scaled_torque}, 1e-8);
      RigidBodyState state = motion.at(t / rate);
      state.w_B /= rate;
      EXPECT_TRUE(same_bits(state, plain)) << i;
    }
  }
}

// However many steps that takes.
TEST(DormandPrinceMotion, AtRestEveryAttitudeStays) {
  Random random(43);
  for (int i = 0; i < 50; ++i) {
    const DormandPrinceMotion motion(kPairs[i % 2], {kI, {random.attitude(), Vec3::Zero()}, {}}, kTolerance);
    EXPECT_TRUE(same_bits(motion.at(1e-3), motion.at(1e300)));
    EXPECT_LE(q_error(motion.at(1e300).q_SB, motion.at(0).q_SB), 4 * kEps);
  }
}

TEST(DormandPrinceMotion, WithoutMotionNothingMovesForEver) {
  const RigidBodyState rest{Quat(0.5, 0.5, -0.5, 0.5), Vec3::Zero()};
  for (const DormandPrincePair pair : kPairs)
    for (const Torque& torque : {Torque{}, {LinearDamping{1}}, {EnergySink{1}}, {BodyTorque{}}})
      for (const double t : {1.0, -1e9, 1e300}) {
        const DormandPrinceMotion motion(pair, {kI, rest, torque}, kTolerance);
        if (!torque.empty() && std::abs(t) > 1e3 && torque.front().index() == 3) continue;
        EXPECT_TRUE(same_bits(motion.at(t), rest)) << t;
      }
}

TEST(DormandPrinceMotion, BeyondItsLastStepIsNotANumber) {
  const DormandPrinceMotion motion(eight_five_three, {kI, kStart, {}}, kTolerance, 1000);
  EXPECT_EQ(motion.max_time_s(), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(motion.at(100).w_B.allFinite());
  for (const double t : {1e5, -1e200, 1e308, std::numeric_limits<double>::infinity(), kNaN}) {
    EXPECT_TRUE(motion.at(t).w_B.array().isNaN().all()) << t;
    EXPECT_TRUE(motion.at(t).q_SB.coeffs().array().isNaN().all()) << t;
    EXPECT_EQ(motion.evaluations_to(t), 0) << t;
  }
  EXPECT_TRUE(motion.at(100).w_B.allFinite());
}

TEST(DormandPrinceMotion, OverflowIsNotANumberAndEndsSoon) {
  // ω itself leaves the range at t ≈ 1e-308.
  const DormandPrinceMotion faster(
      eight_five_three, {kI, {Quat::Identity(), {1.5e308, 0, 0}}, {LinearDamping{-1e308}}}, kTolerance);
  EXPECT_TRUE(faster.at(1e-309).w_B.allFinite());
  EXPECT_TRUE(faster.at(1e-308).w_B.array().isNaN().all());
  EXPECT_TRUE(faster.at(1e-308).q_SB.coeffs().array().isNaN().all());
  // A friction no step is short enough for.
  const DormandPrinceMotion stuck(five_four, {kI, kStart, {EnergySink{1e308}}}, kTolerance);
  EXPECT_TRUE(stuck.at(1).w_B.array().isNaN().all());
  // Growth without end: ω = e^(1000 t) takes e^(1000 t) radians.
  const DormandPrinceMotion growing(five_four, {kI, kStart, {LinearDamping{-1000}}}, kTolerance, 10'000);
  EXPECT_TRUE(growing.at(1).w_B.array().isNaN().all());
}

TEST(DormandPrinceMotion, ServesTheWholeRangeOfDoubles) {
  Random random(42);
  const double sizes[] = {5e-324, 1e-310, 1e-200, 1.0, 1e200, 1e307};
  for (const double w : sizes)
    for (const double N : {0.0, 5e-324, 1e-200, 1.0, 1e200, 1e307})
      for (const double c : {0.0, 5e-324, 1.0, 1e307}) {
        const Torque torque{SpaceTorque{{N, 0, N}}, LinearDamping{c}, EnergySink{0.1}};
        const DormandPrinceMotion motion(eight_five_three, {kI, {Quat::Identity(), {w, w, -w}}, torque}, 1e-6,
                                         1000);
        // About one radian, or one decay, on.
        const double t = 1 / std::max({w, std::sqrt(N), c, 1e-300});
        EXPECT_TRUE(motion.at(t).w_B.allFinite()) << w << " " << N << " " << c;
        EXPECT_NEAR(motion.at(-t / 8).q_SB.norm(), 1, 4 * kEps) << w << " " << N << " " << c;
      }
}

TEST(DormandPrinceMotion, RefusesTolerancesStatesAndTorquesThatAreNone) {
  for (const double tolerance : {0.0, -1e-6, 1.0, kNaN, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(DormandPrinceMotion(five_four, {kI, kStart, {}}, tolerance), std::domain_error);
  EXPECT_THROW(DormandPrinceMotion(five_four, {kI, {Quat::Identity(), {kNaN, 0, 0}}, {}}, 1e-6),
               std::domain_error);
  EXPECT_THROW(DormandPrinceMotion(five_four, {kI, kStart, {LinearDamping{kNaN}}}, 1e-6), std::domain_error);
  EXPECT_EQ(DormandPrinceMotion(five_four, {kI, kStart, {}}, 1e-30).tolerance(),
            DormandPrinceMotion::kMinTolerance);
}

TEST(DormandPrinceMotion, IsMadeByName) {
  const Problem problem{kI, kStart, kEveryTorque};
  for (const DormandPrincePair pair : kPairs) {
    const Method method = pair == five_four ? Method::dormand_prince_5 : Method::dormand_prince_8;
    const auto by_default = make_motion(problem, {method, {}, {}}),
               loose = make_motion(problem, {method, {}, 1e-4});
    EXPECT_EQ(by_default->method(), name_of(method));
    EXPECT_TRUE(same_bits(by_default->at(3), DormandPrinceMotion(pair, problem, kDefaultTolerance).at(3)));
    EXPECT_TRUE(same_bits(loose->at(3), DormandPrinceMotion(pair, problem, 1e-4).at(3)));
    EXPECT_THROW(make_motion(problem, {method, 0.1, {}}), std::domain_error);
    EXPECT_THROW(make_motion(problem, {method, {}, 2.0}), std::domain_error);
  }
}

// Its moments are further apart than doubles reach from any unit between them.
TEST(DormandPrince, ServesTheThinnestNeedle) {
  const PrincipalMoments I(0x1p-1074, 0x1p1022, 0x1p1022);
  const RigidBodyState start{Quat::Identity(), {0.3, 1, 1}};
  for (const DormandPrincePair pair : kPairs)
    EXPECT_NEAR(DormandPrinceMotion(pair, {I, start, {}}, 1e-10).at(0.01).w_B[0], 0.3, 1e-9);
}

}  // namespace
}  // namespace polhode
