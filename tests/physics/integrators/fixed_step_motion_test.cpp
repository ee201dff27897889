// SPDX-License-Identifier: MIT
// What every method of fixed step must do, whatever its formula.
#include "physics/integrators/fixed_step_motion.h"

#include "physics/body/euler.h"
#include "physics/exact/symmetric_motion.h"
#include "physics/method.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <thread>

namespace polhode {
namespace {

using test::kEps;
using test::Random;
using test::same_bits;

const PrincipalMoments kI(1.0, 1.75, 2.5);
const RigidBodyState kStart{Quat::Identity(), {0.2, 1.0, 0.3}};
const Torque kOfAttitude{SpaceTorque{{0.1, 0, 0.2}}, BodyTorque{{0, 0.1, 0}}, HeavyTop{0.5, Vec3::UnitY()}};
const Torque kEveryTorque{SpaceTorque{{0.1, 0, 0.2}}, BodyTorque{{0, 0.1, 0}}, HeavyTop{0.5, Vec3::UnitY()},
                          LinearDamping{0.05}, EnergySink{0.02}};

/// As much torque as the method serves.
Torque most_torque(Method method) {
  const ServedTorque served = facts_of(method).torque;
  return served == ServedTorque::any ? kEveryTorque
                                     : (served == ServedTorque::of_attitude ? kOfAttitude : Torque{});
}

std::unique_ptr<const Motion> motion_of(Method method, const PrincipalMoments& I, const RigidBodyState& start,
                                        const Torque& torque, double h) {
  return make_motion({I, start, torque}, {method, h, std::nullopt});
}

bool is_all_nan(const RigidBodyState& x) {
  return x.w_B.array().isNaN().all() && x.q_SB.coeffs().array().isNaN().all();
}

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

class FixedStep : public testing::TestWithParam<Method> {
 protected:
  std::unique_ptr<const Motion> motion(const RigidBodyState& start = kStart, double h = 0.01) const {
    return motion_of(GetParam(), kI, start, most_torque(GetParam()), h);
  }
  std::unique_ptr<const Motion> free_motion(const PrincipalMoments& I, const RigidBodyState& start,
                                            double h) const {
    return motion_of(GetParam(), I, start, {}, h);
  }
  const MethodFacts& facts() const { return facts_of(GetParam()); }
  bool keeps(std::string_view what) const { return facts().keeps.find(what) != std::string_view::npos; }
};

std::string test_name(const testing::TestParamInfo<Method>& info) {
  std::string name(name_of(info.param));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(, FixedStep,
                         testing::Values(Method::explicit_euler, Method::explicit_midpoint, Method::rk4,
                                         Method::rk4_projected, Method::splitting, Method::implicit_midpoint,
                                         Method::implicit_midpoint_exp, Method::moser_veselov_2,
                                         Method::moser_veselov_6, Method::moser_veselov_10),
                         test_name);

TEST_P(FixedStep, IsCalledByItsName) { EXPECT_EQ(motion()->method(), facts().name); }

// --- order ------------------------------------------------------------------------------------------------

struct Errors {
  double w, q;
};

/// log2 of the ratio of the errors at h and h/2 on the finest such pair with errors in [1e-12, 1e-5], where
/// neither rounding nor the next term of the error matters much. At order 10 that is a pair of 1e-9 and 1e-12
/// at some 50 and 100 steps a period, and the next term, h² beside the first, still adds 0.08 to 0.15: there
/// it is taken out by means of a second pair at about √2 h.
class ObservedOrder {
 public:
  void add_pair(double steps, double at_h, double at_half_h) {
    const auto counts = [](double e) { return e >= 1e-12 && e <= 1e-5; };
    if (counts(at_h) && counts(at_half_h)) pairs_.push_back({steps, std::log2(at_h / at_half_h)});
  }
  std::optional<double> finest() const {
    return pairs_.empty() ? std::nullopt : std::optional(pairs_.back().order);
  }
  std::optional<double> without_next_term() const {
    if (pairs_.empty()) return std::nullopt;
    const Pair& fine = pairs_.back();
    const auto coarse = std::find_if(pairs_.begin(), pairs_.end(), [&fine](const Pair& p) {
      return p.steps > fine.steps / std::sqrt(2.0);
    });
    const double a = std::pow(coarse->steps, 2), b = std::pow(fine.steps, 2);
    return (b * fine.order - a * coarse->order) / (b - a);
  }

 private:
  struct Pair {
    double steps, order;
  };
  std::vector<Pair> pairs_;
};

/// A state about one period from the start.
const test::ReferenceState& one_period_on(const test::ReferenceCase& c) {
  return *std::find_if(c.states.begin(), c.states.end(), [&c](const test::ReferenceState& s) {
    return std::abs(s.t_s) > 0.85 * c.period_s && std::abs(s.t_s) < 1.15 * c.period_s;
  });
}

TEST_P(FixedStep, HasItsOrderInOmegaAndInAttitudeOverOnePeriod) {
  for (const char* name : {"generic_above", "generic_below", "generic_perm_213", "generic_perm_312",
                           "generic_perm_321", "turning_point_mid_zero", "turning_point_max_zero"}) {
    if (facts().order == 1 && std::string_view(name) != "generic_above") continue;  // 10⁷ steps
    const test::ReferenceCase& c = test::reference_case(name);
    const test::ReferenceState& truth = one_period_on(c);
    const auto errors = [&](double n) {
      const RigidBodyState y = free_motion(c.I, c.start, std::abs(truth.t_s) / n)->at(truth.t_s);
      return Errors{test::w_error(y.w_B, truth.state.w_B), test::q_error(y.q_SB, truth.state.q_SB)};
    };
    // At high order few pairs lie in the window unless n is varied finely.
    const double factor = facts().order > 4 ? 1.03 : 2, first = facts().order == 1 ? 0x1p22 : 16;
    const double done = facts().order > 2 ? 1e-12 : (facts().order == 2 ? 2e-8 : 2e-6);
    ObservedOrder w, q;
    for (double n = first; n <= 0x1p25; n = std::ceil(factor * n)) {
      const Errors at_h = errors(n), at_half_h = errors(2 * n);
      w.add_pair(n, at_h.w, at_half_h.w);
      q.add_pair(n, at_h.q, at_half_h.q);
      if (at_half_h.w < done && at_half_h.q < done) break;
    }
    const bool high = facts().order > 8;
    const auto of_w = high ? w.without_next_term() : w.finest(),
               of_q = high ? q.without_next_term() : q.finest();
    ASSERT_TRUE(of_w && of_q) << name;
    EXPECT_NEAR(*of_w, facts().order, 0.1) << name;
    EXPECT_NEAR(*of_q, facts().order, 0.1) << name;
  }
}

// --- a function of time
// -------------------------------------------------------------------------------------

TEST_P(FixedStep, DependsOnTheTimeAloneAndNotOnTheTimesAskedBefore) {
  std::vector<double> times;
  for (int i = -100; i <= 100; ++i) times.push_back(i % 3 == 0 ? 0.04 * i : 0.0371 * i);
  const auto ordered = motion(), shuffled = motion();
  std::vector<RigidBodyState> expected;
  for (const double t : times) expected.push_back(ordered->at(t));

  std::vector<RigidBodyState> batch(times.size());
  motion()->at(times, batch);

  std::vector<std::size_t> order(times.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), Random(2).engine());
  for (const std::size_t i : order) {
    EXPECT_TRUE(same_bits(shuffled->at(times[i]), expected[i])) << times[i];
    EXPECT_TRUE(same_bits(motion()->at(times[i]), expected[i])) << times[i];
    EXPECT_TRUE(same_bits(batch[i], expected[i])) << times[i];
    EXPECT_EQ(shuffled->evaluations_to(times[i]), motion()->evaluations_to(times[i])) << times[i];
    EXPECT_EQ(ordered->w_B_at(times[i]), expected[i].w_B) << times[i];
  }
}

TEST_P(FixedStep, CountsItsEvaluations) {
  const auto m = motion();
  EXPECT_EQ(m->evaluations_to(0), 0);
  EXPECT_EQ(m->evaluations_to(-1.0), motion()->evaluations_to(-1.0));
  const std::int64_t of_100_steps = m->evaluations_to(1.0), of_200_steps = m->evaluations_to(2.0);
  EXPECT_GE(of_100_steps, 100);
  EXPECT_GE(of_200_steps, of_100_steps + 100);
  EXPECT_LE(of_200_steps, 200 * 8);
  EXPECT_GT(m->evaluations_to(1.005), 0);
}

TEST_P(FixedStep, ServesManyThreadsTheSame) {
  const auto shared = motion(), alone = motion();
  std::vector<RigidBodyState> expected;
  for (int i = 0; i < 400; ++i) expected.push_back(alone->at(0.05 * (i - 200)));
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (unsigned seed = 0; seed < 4; ++seed) {
    threads.emplace_back([&, seed] {
      std::mt19937 engine(seed);
      for (int n = 0; n < 400; ++n) {
        const int i = static_cast<int>(engine() % 400);
        if (!same_bits(shared->at(0.05 * (i - 200)), expected[static_cast<std::size_t>(i)])) ++wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

// h is not a double and k·h falls on either side of the grid point: no step may be lost or taken twice, near
// or far. On one side of it the step is made of a whole one, on the other of one and a rest of rounding.
TEST_P(FixedStep, IsContinuousAcrossGridPointsAndItsTimeDoesNotAccumulate) {
  const double h = 0.1, rate = 1.5;
  const auto m = free_motion(kI, kStart, h);
  const int steps =
      facts().order == 1 ? 111 : 9990;  // Euler leaves the ellipsoid for good after some hundred
  for (int k = -steps; k <= steps; k += 37) {
    const double t = k * h;
    const double one_step_of_t = 2 * kEps * std::abs(t);
    const RigidBodyState here = m->at(t), before = m->at(std::nextafter(t, 0.0));
    ASSERT_LE(test::w_error(here.w_B, before.w_B), rate * one_step_of_t + 16 * kEps) << t;
    ASSERT_LE(test::q_error(here.q_SB, before.q_SB), rate * one_step_of_t + 16 * kEps) << t;
  }
}

TEST_P(FixedStep, StartsAtTheStart) {
  const RigidBodyState start = Random(3).state();
  const auto m = motion(start);
  EXPECT_EQ(m->at(0).w_B, start.w_B);
  EXPECT_LE(test::q_error(m->at(0).q_SB, start.q_SB), 4 * kEps);
}

TEST_P(FixedStep, TurningTheStartTurnsTheMotion) {
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const RigidBodyState start = random.state();
    const Quat p = random.attitude();
    const double t = random.uniform(-2, 2), h = 0.02;
    const RigidBodyState plain = free_motion(kI, start, h)->at(t);
    const RigidBodyState turned = free_motion(kI, {p * start.q_SB, start.w_B}, h)->at(t);
    EXPECT_LE(test::q_error(turned.q_SB, p * plain.q_SB), 8 * kEps * (2 + std::abs(t) / h));
    EXPECT_EQ(turned.w_B, plain.w_B);
  }
}

// --- range
// --------------------------------------------------------------------------------------------------

TEST_P(FixedStep, BeyondItsLongestTimeIsNotANumber) {
  const auto m = free_motion(kI, kStart, 1e-3);
  EXPECT_EQ(m->max_time_s(), 1e5);
  for (const double t :
       {1.1e5, -1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(is_all_nan(m->at(t))) << t;
    EXPECT_TRUE(m->w_B_at(t).array().isNaN().all()) << t;
    EXPECT_EQ(m->evaluations_to(t), 0) << t;
  }
  EXPECT_TRUE(is_all_nan(free_motion(kI, kStart, std::numeric_limits<double>::denorm_min())->at(1)));
}

// Far too long a step: finite or NaN, never a hang or an exception; |q| = 1 where there is an answer.
TEST_P(FixedStep, WithAbsurdStepsStillAnswers) {
  EXPECT_LE(
      seconds_of([&] {
        for (const double h : {0.5, 1.0, 10.0, 1e6, 1e300}) {
          for (const Vec3& w_B : {Vec3(100, 200, 300), Vec3(0.2, 1, 0.3), Vec3(0, 0, 50)}) {
            const auto m = motion_of(GetParam(), kI, {Quat::Identity(), w_B}, most_torque(GetParam()), h);
            for (const double t : {1.0, 7.3 * h, -1000 * h}) {
              const RigidBodyState y = m->at(t);
              EXPECT_TRUE(is_all_nan(y) || std::abs(y.q_SB.norm() - 1) <= 4 * kEps) << h << ' ' << t;
              EXPECT_TRUE(is_all_nan(y) || y.w_B.allFinite()) << h << ' ' << t;
            }
          }
        }
      }),
      2.0);
}

// A step whose square, fourth power or determinant leaves the range of doubles: ω stays, q is unit or NaN.
TEST_P(FixedStep, SteadyRotationIsNeverAnsweredByWhatIsNoRotation) {
  for (int e = 10; e <= 1000; e += 10) {
    const double h = std::ldexp(1.0, e);
    const auto m = free_motion(kI, {Quat::Identity(), {0, 0, 1}}, h);
    const RigidBodyState y = m->at(h);
    EXPECT_TRUE(is_all_nan(y) || std::abs(y.q_SB.norm() - 1) <= 4 * kEps) << e;
  }
}

// A smallest moment more than 10³⁰⁸ times below the others cannot be told in their unit; the body is possible
// all the same. Splitting turns L, so that L_1 errs by the rounding of |L|: it answers, and no more.
TEST_P(FixedStep, ServesTheThinnestNeedle) {
  const Vec3 w_B(0.3, 1, 1);
  const RigidBodyState start{Quat::Identity(), w_B};
  for (const auto& [thin, thick] : {std::pair(1e-200, 1e200), std::pair(0x1p-1074, 0x1p1022)}) {
    const RigidBodyState y = free_motion({thin, thick, thick}, start, 1e-3)->at(0.01);
    if (GetParam() == Method::splitting) continue;
    EXPECT_NEAR(y.w_B[0], 0.3, 1e-9);  // ω_1 is constant
    EXPECT_LE(test::w_error(y.w_B, SymmetricMotion({thin, thick, thick}, start).at(0.01).w_B), 1e-3);
  }
}

TEST_P(FixedStep, ThatHasDiedStaysDeadAtOnce) {
  const auto m = free_motion(kI, {Quat::Identity(), {1e200, 2e200, 3e200}}, 1e200);
  EXPECT_LE(seconds_of([&] {
              for (const double t : {9e207, -9e207, 1e203}) {
                const RigidBodyState y = m->at(t);
                EXPECT_TRUE(is_all_nan(y)) << t;
              }
            }),
            1.0);
  EXPECT_EQ(m->at(0).w_B, Vec3(1e200, 2e200, 3e200));
}

TEST_P(FixedStep, RefusesStepsAndStatesThatAreNone) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const double h : {0.0, -0.1, kNaN, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(motion(kStart, h), std::domain_error);
  EXPECT_THROW(motion({Quat::Identity(), {kNaN, 0, 0}}), std::domain_error);
  EXPECT_THROW(motion({Quat(0, 0, 0, 0), {1, 0, 0}}), std::domain_error);
}

TEST_P(FixedStep, IsTheSameToTheBitAtAnyScale) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const PrincipalMoments I = random.moments();
    const RigidBodyState start = random.state();
    const double t = random.uniform(-3, 3), h = 0.03;
    const RigidBodyState y = free_motion(I, start, h)->at(t);
    for (const auto& [eI, ew] :
         {std::pair(301, 0), std::pair(-298, 203), std::pair(0, -203), std::pair(400, 330)}) {
      const auto to = [](double x, int e) { return std::scalbn(x, e); };
      const PrincipalMoments I2(to(I[0], eI), to(I[1], eI), to(I[2], eI));
      const RigidBodyState start2{start.q_SB, to(1.0, ew) * start.w_B};
      const RigidBodyState y2 = free_motion(I2, start2, to(h, -ew))->at(to(t, -ew));
      EXPECT_TRUE(same_bits({y2.q_SB, to(1.0, -ew) * y2.w_B}, y)) << eI << ' ' << ew;
    }
  }
}

class FixedStepUnderTorque : public FixedStep {};

INSTANTIATE_TEST_SUITE_P(, FixedStepUnderTorque,
                         testing::Values(Method::explicit_euler, Method::explicit_midpoint, Method::rk4,
                                         Method::splitting, Method::moser_veselov_2, Method::moser_veselov_6,
                                         Method::moser_veselov_10),
                         test_name);

TEST_P(FixedStepUnderTorque, IsTheSameToTheBitAtAnyScale) {
  for (const auto& [eI, ew] :
       {std::pair(301, 0), std::pair(-298, 203), std::pair(0, -201), std::pair(40, 33)}) {
    const auto to = [](double x, int e) { return std::scalbn(x, e); };
    Torque torque{SpaceTorque{to(1.0, eI + 2 * ew) * Vec3(0.1, 0, 0.2)},
                  HeavyTop{to(0.5, eI + 2 * ew), Vec3::UnitY()}};
    Torque plain{SpaceTorque{{0.1, 0, 0.2}}, HeavyTop{0.5, Vec3::UnitY()}};
    if (facts().torque == ServedTorque::any) {
      torque.push_back(LinearDamping{to(0.05, eI + ew)});
      plain.push_back(LinearDamping{0.05});
    }
    const PrincipalMoments I2(to(1, eI), to(1.75, eI), to(2.5, eI));
    const RigidBodyState y = motion_of(GetParam(), kI, kStart, plain, 0.03)->at(2.5);
    const RigidBodyState y2 =
        motion_of(GetParam(), I2, {kStart.q_SB, to(1.0, ew) * kStart.w_B}, torque, to(0.03, -ew))
            ->at(to(2.5, -ew));
    EXPECT_TRUE(same_bits({y2.q_SB, to(1.0, -ew) * y2.w_B}, y)) << eI << ' ' << ew;
  }
}

// Every body of the reference, to a time of a thousand steps that resolve its fastest rate: an answer, near
// the truth. (|ω| ≤ L/I_min bounds the rate.)
TEST_P(FixedStep, AnswersForEveryBodyOfTheReference) {
  for (const test::ReferenceCase& c : test::reference_cases()) {
    const double I_least = c.I.vector().minCoeff();
    const Vec3 m = c.I.vector() / c.I.vector().maxCoeff();
    const double rate = m.cwiseProduct(c.start.w_B).stableNorm() / (I_least / c.I.vector().maxCoeff());
    const double most = rate > 0 ? 40 / rate : 1.0;
    const test::ReferenceState* truth = nullptr;
    for (const test::ReferenceState& s : c.states)
      if (std::abs(s.t_s) <= most && (!truth || std::abs(s.t_s) > std::abs(truth->t_s))) truth = &s;
    const double t = truth ? truth->t_s : most;
    const double h = std::abs(t) / 4096;
    const RigidBodyState y = free_motion(c.I, c.start, h)->at(t);
    EXPECT_TRUE(y.w_B.allFinite() && y.q_SB.coeffs().allFinite()) << c.name;
    if (!truth) continue;
    // Local error (rate·h)^(p+1) per step, at worst, and 8ε of rounding, carried on by the motion's own
    // condition.
    const double local = 4096 * (std::pow(rate * h, std::min(facts().order, 4) + 1) + 8 * kEps) *
                         (1 + truth->cond_w + truth->cond_q);
    EXPECT_LE(test::w_error(y.w_B, truth->state.w_B), local) << c.name;
    EXPECT_LE(test::q_error(y.q_SB, truth->state.q_SB), local) << c.name;
  }
}

// --- what it keeps
// --------------------------------------------------------------------------------------------

struct Drift {
  double T = 0, L = 0, direction = 0;
};

Drift drift(const PrincipalMoments& I, const RigidBodyState& start, const RigidBodyState& y) {
  const Vec3 L0 = angular_momentum_S(I, start), L = angular_momentum_S(I, y);
  return {std::abs(kinetic_energy(I, y.w_B) / kinetic_energy(I, start.w_B) - 1),
          std::abs(L.norm() / L0.norm() - 1), std::atan2(L0.cross(L).norm(), L0.dot(L))};
}

// 400 steps that turn the body by about 0.05 each. What is kept errs by rounding: at most 4ε a step; what is
// not is worse than that by orders, for all but the order-10 method which errs by rounding anyway.
TEST_P(FixedStep, KeepsWhatItsFactsSay) {
  Random random(6);
  const int steps = 400;
  const double rounding = steps * 4 * kEps;
  Drift worst;
  double worst_return = 0;
  for (int i = 0; i < 100; ++i) {
    const PrincipalMoments I = random.moments();
    const RigidBodyState start = random.state();
    const double h = 0.05 / start.w_B.norm(), t = steps * h;
    const RigidBodyState y = free_motion(I, start, h)->at(t);
    const Drift d = drift(I, start, y);
    worst = {std::max(worst.T, d.T), std::max(worst.L, d.L), std::max(worst.direction, d.direction)};
    const RigidBodyState back = free_motion(I, y, h)->at(-t);
    worst_return =
        std::max({worst_return, test::w_error(back.w_B, start.w_B), test::q_error(back.q_SB, start.q_SB)});
  }
  const auto expect = [&](double error, bool kept, const char* what) {
    if (kept)
      EXPECT_LE(error, rounding) << what;
    else
      EXPECT_GE(error, 10 * rounding) << what;
  };
  expect(worst.T, keeps("T,"), "T");
  expect(worst.L, keeps("|L|") || keeps("L in space"), "|L|");
  expect(worst.direction, keeps("L in space"), "direction of L in space");
  // 20 rad on and back: rounding grows by the motion's own condition number, up to some hundreds.
  if (keeps("reversible"))
    EXPECT_LE(worst_return, 300 * rounding);
  else
    EXPECT_GE(worst_return, 1000 * rounding);
}

}  // namespace
}  // namespace polhode
