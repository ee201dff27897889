// SPDX-License-Identifier: MIT
#include "physics/integrators/explicit_runge_kutta.h"

#include "physics/body/equations_of_motion.h"
#include "physics/integrators/fixed_step_motion.h"

#include <array>
#include <stdexcept>

namespace polhode {
namespace {

// A point of the phase space, or its rate of change.
struct Point {
  Triple w_B;
  Quadruple q_SB;
};
Point operator+(const Point& a, const Point& b) { return {a.w_B + b.w_B, a.q_SB + b.q_SB}; }
Point operator*(double f, const Point& a) { return {f * a.w_B, f * a.q_SB}; }

Quadruple attitude_rate(const Quadruple& q_SB, const Triple& w_B) { return product(q_SB, 0.5 * w_B); }

// The equations without torque, in registers: a third cheaper than EquationsOfMotion.
class FreeBody {
 public:
  explicit FreeBody(const Problem& problem) : g_(euler_coefficients(problem.I)) {}

  Point operator()(const Point& y) const {
    return {times(g_, pairs(y.w_B, y.w_B)), attitude_rate(y.q_SB, y.w_B)};
  }

 private:
  Triple g_;
};

class DrivenBody {
 public:
  explicit DrivenBody(const Problem& problem) : equations_(problem.I, problem.torque) {}

  Point operator()(const Point& y) const {
    const auto& [w, q] = y;
    MotionVector rate;
    equations_.rate({{w.x, w.y, w.z, q.x, q.y, q.z, q.s, 0.0}}, rate);
    return {{rate[0], rate[1], rate[2]}, {rate[6], rate[3], rate[4], rate[5]}};
  }

 private:
  EquationsOfMotion equations_;
};

struct Euler {
  static constexpr int kStages = 1;
  template <class Rate>
  static Point step(const Rate& rate, const Point& y, double h) {
    return y + h * rate(y);
  }
};

struct Midpoint {
  static constexpr int kStages = 2;
  template <class Rate>
  static Point step(const Rate& rate, const Point& y, double h) {
    return y + h * rate(y + (0.5 * h) * rate(y));
  }
};

struct Rk4 {
  static constexpr int kStages = 4;
  template <class Rate>
  static Point step(const Rate& rate, const Point& y, double h) {
    const Point k1 = rate(y);
    const Point k2 = rate(y + (0.5 * h) * k1);
    const Point k3 = rate(y + (0.5 * h) * k2);
    const Point k4 = rate(y + h * k3);
    return y + (h / 6.0) * (k1 + 2.0 * (k2 + k3) + k4);
  }
};

// Keeps |q| in range by exact powers of two; see the header.
class RangeOfQ {
 public:
  explicit RangeOfQ(const Problem&) {}

  void apply(Point& y) const {
    const double squared = dot(y.q_SB, y.q_SB);
    if (!(squared > 0x1p-8 && squared < 0x1p8)) rescale(y.q_SB);
  }

 private:
  static void rescale(Quadruple& q) {
    const double length = std::abs(q.s) + size({q.x, q.y, q.z});
    if (!std::isfinite(length) || length == 0) return;
    const int e = -std::ilogb(length);
    q = {std::scalbn(q.s, e), std::scalbn(q.x, e), std::scalbn(q.y, e), std::scalbn(q.z, e)};
  }
};

// Back to the T and L² of the start, and to |q| = 1.
class Projection {
 public:
  explicit Projection(const Problem& problem)
      : I_(triple(problem.I.vector())),
        dI_(differences(problem.I)),
        two_T_(two_T(triple(problem.start.w_B))) {
    for (int j = 0; j < 3; ++j) D_[static_cast<std::size_t>(j)] = D(j, triple(problem.start.w_B));
  }

  void apply(Point& y) const {
    const Triple L_B = times(I_, y.w_B);
    const int j = std::abs(L_B.x) >= std::abs(L_B.y) ? (std::abs(L_B.x) >= std::abs(L_B.z) ? 0 : 2)
                                                     : (std::abs(L_B.y) >= std::abs(L_B.z) ? 1 : 2);
    for (int i = 0; i < kMostIterations; ++i)
      if (!improve(y.w_B, j)) break;
    y.q_SB = (1.0 / std::sqrt(dot(y.q_SB, y.q_SB))) * y.q_SB;
  }

 private:
  static constexpr int kMostIterations = 4;
  static constexpr double kRounding =
      0x1p-51;  // of the sums T and D_j, relative to the sum of their terms' sizes

  // I_i − I_j in row j.
  static std::array<Triple, 3> differences(const PrincipalMoments& I) {
    std::array<Triple, 3> d{};
    for (int j = 0; j < 3; ++j) d[static_cast<std::size_t>(j)] = {I[0] - I[j], I[1] - I[j], I[2] - I[j]};
    return d;
  }

  const Triple& d(int j) const { return dI_[static_cast<std::size_t>(j)]; }
  double two_T(const Triple& w) const { return dot(times(I_, w), w); }
  double D(int j, const Triple& w) const { return dot(times(d(j), times(I_, w)), w); }

  // One Newton step; false once there is nothing to gain.
  bool improve(Triple& w, int j) const {
    const Triple t = times(I_, w);    // ½ ∇(2T)
    const Triple u = times(d(j), t);  // ½ ∇D_j
    const double of_T = 0.5 * (two_T_ - dot(t, w));
    const double of_D = 0.5 * (D_[static_cast<std::size_t>(j)] - dot(u, w));
    const Triple uw = times(u, w);
    if (std::abs(of_T) <= kRounding * two_T_ && std::abs(of_D) <= kRounding * size(uw)) return false;

    const Triple n = cross(u, t);
    const double n2 = dot(n, n);
    if (n2 > 0)
      w = w + (1.0 / n2) * (of_D * cross(t, n) + of_T * cross(n, u));
    else if (const double t2 = dot(t, t); t2 > 0)
      w = w + (of_T / t2) * t;
    return true;
  }

  Triple I_;
  std::array<Triple, 3> dI_;
  double two_T_;
  std::array<double, 3> D_{};
};

template <class Tableau, class Rate, class After>
class ExplicitRungeKutta {
 public:
  using State = StepState;
  using Plan = double;

  explicit ExplicitRungeKutta(const Problem& problem) : rate_(problem), after_(problem) {}

  Plan plan(double h) const { return h; }
  State start(const RigidBodyState& state) const { return {triple(state.w_B), quadruple(state.q_SB)}; }
  Vec3 w_B(const State& y) const { return vec3(y.v); }

  void advance(State& state, const Plan& h, std::int64_t n) const {
    state.evaluations += n * Tableau::kStages;
    const Rate rate = rate_;
    Point y{state.v, state.q};
    for (; n > 0; --n) {
      y = Tableau::step(rate, y, h);
      after_.apply(y);
    }
    state.v = y.w_B;
    state.q = y.q_SB;
  }

 private:
  Rate rate_;
  After after_;
};

template <class Tableau>
std::unique_ptr<const Motion> made(std::string_view name, const Problem& problem, double step_s,
                                   const Effort& effort) {
  using Free = FixedStepMotion<ExplicitRungeKutta<Tableau, FreeBody, RangeOfQ>>;
  using Driven = FixedStepMotion<ExplicitRungeKutta<Tableau, DrivenBody, RangeOfQ>>;
  if (problem.torque.empty()) return std::make_unique<Free>(name, problem, step_s, effort);
  return std::make_unique<Driven>(name, problem, step_s, effort);
}

}  // namespace

std::unique_ptr<const Motion> explicit_euler_motion(const Problem& problem, double step_s,
                                                    const Effort& effort) {
  return made<Euler>("explicit-euler", problem, step_s, effort);
}

std::unique_ptr<const Motion> explicit_midpoint_motion(const Problem& problem, double step_s,
                                                       const Effort& effort) {
  return made<Midpoint>("explicit-midpoint", problem, step_s, effort);
}

std::unique_ptr<const Motion> rk4_motion(const Problem& problem, double step_s, const Effort& effort) {
  return made<Rk4>("rk4", problem, step_s, effort);
}

std::unique_ptr<const Motion> rk4_projected_motion(const Problem& problem, double step_s,
                                                   const Effort& effort) {
  if (!problem.torque.empty()) throw std::domain_error("projection is for torque-free motion");
  return std::make_unique<FixedStepMotion<ExplicitRungeKutta<Rk4, FreeBody, Projection>>>(
      "rk4-projected", problem, step_s, effort);
}

}  // namespace polhode
