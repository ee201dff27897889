// SPDX-License-Identifier: MIT
#include "physics/integrators/lie_poisson_splitting.h"

#include "physics/integrators/attitude_torque.h"
#include "physics/integrators/fixed_step_motion.h"

namespace polhode {
namespace {

// A rotation of the body by an angle 2a about one of its axes.
struct AxisRotation {
  double c, s;  // cos a, sin a
  double cos2a, sin2a;

  explicit AxisRotation(double a) : c(std::cos(a)), s(std::sin(a)), cos2a(1 - 2 * s * s), sin2a(2 * s * c) {}

  // Components of what stands still in space, along the axes (j, k) that turn.
  void turn(double& v_j, double& v_k) const {
    const double v = v_j;
    v_j = cos2a * v + sin2a * v_k;
    v_k = cos2a * v_k - sin2a * v;
  }
  // q ⊗ (c, s e_i) for q with components q_i along the axis, (q_j, q_k) across.
  void turn(double& q_s, double& q_i, double& q_j, double& q_k) const {
    const Quadruple q{q_s, q_i, q_j, q_k};
    q_s = c * q.s - s * q.x;
    q_i = c * q.x + s * q.s;
    q_j = c * q.y + s * q.z;
    q_k = c * q.z - s * q.y;
  }
};

template <class TorqueOnBody>
class LiePoissonSplitting {
 public:
  using State = StepState;  // v = L_B
  struct Plan {
    double h;
    Triple half, whole;  // half of the angles turned in h/2 and in h, per L_i
  };

  explicit LiePoissonSplitting(const Problem& problem)
      : I_(triple(problem.I.vector())), torque_(problem.torque) {}

  Plan plan(double h) const {
    const Triple one{1, 1, 1};
    return {h, over((0.25 * h) * one, I_), over((0.5 * h) * one, I_)};
  }
  State start(const RigidBodyState& state) const {
    return {times(I_, triple(state.w_B)), quadruple(state.q_SB)};
  }
  Vec3 w_B(const State& y) const { return vec3(over(y.v, I_)); }

  void advance(State& state, const Plan& plan, std::int64_t n) const {
    state.evaluations += n;
    Triple L = state.v;
    Quadruple q = state.q;
    if constexpr (TorqueOnBody::kActs) {
      Triple kick = (0.5 * plan.h) * torque_.N_B(q);
      for (; n > 0; --n) {
        L = L + kick;
        AxisRotation first(plan.half.x * L.x);
        flow(L, q, first, plan);
        kick = (0.5 * plan.h) * torque_.N_B(q);
        L = L + kick;
      }
    } else {
      AxisRotation first(plan.half.x * L.x);
      for (; n > 0; --n) flow(L, q, first, plan);
    }
    state.v = L;
    state.q = q;
  }

 private:
  // `first` is the rotation about axis 1 to begin with, and then the one that has ended the step.
  static void flow(Triple& L, Quadruple& q, AxisRotation& first, const Plan& plan) {
    about_1(first, L, q);
    about_2(AxisRotation(plan.half.y * L.y), L, q);
    about_3(AxisRotation(plan.whole.z * L.z), L, q);
    about_2(AxisRotation(plan.half.y * L.y), L, q);
    first = AxisRotation(plan.half.x * L.x);
    about_1(first, L, q);
  }

  static void about_1(const AxisRotation& r, Triple& L, Quadruple& q) {
    r.turn(L.y, L.z);
    r.turn(q.s, q.x, q.y, q.z);
  }
  static void about_2(const AxisRotation& r, Triple& L, Quadruple& q) {
    r.turn(L.z, L.x);
    r.turn(q.s, q.y, q.z, q.x);
  }
  static void about_3(const AxisRotation& r, Triple& L, Quadruple& q) {
    r.turn(L.x, L.y);
    r.turn(q.s, q.z, q.x, q.y);
  }

  Triple I_;
  TorqueOnBody torque_;
};

}  // namespace

std::unique_ptr<const Motion> splitting_motion(const Problem& problem, double step_s, const Effort& effort) {
  constexpr std::string_view kName = "splitting";
  if (problem.torque.empty())
    return std::make_unique<FixedStepMotion<LiePoissonSplitting<NoTorque>>>(kName, problem, step_s, effort);
  return std::make_unique<FixedStepMotion<LiePoissonSplitting<AttitudeTorque>>>(kName, problem, step_s,
                                                                                effort);
}

}  // namespace polhode
