// SPDX-License-Identifier: MIT
#include "physics/integrators/implicit_midpoint.h"

#include "physics/integrators/midpoint_stepper.h"

#include <stdexcept>

namespace polhode {
namespace {

class MidpointRule {
 public:
  explicit MidpointRule(const PrincipalMoments& I) : g_(euler_coefficients(I)) {}

  MidpointCoefficients coefficients(double h, const Triple&) const {
    return {h, {1, 1, 1}, h * g_, {(0.5 * h) * g_, 0.0}};
  }

 private:
  Triple g_;
};

template <class Attitude>
std::unique_ptr<const Motion> made(std::string_view name, const Problem& problem, double step_s,
                                   const Effort& effort) {
  if (!problem.torque.empty())
    throw std::domain_error("the implicit midpoint rule is for torque-free motion");
  return std::make_unique<FixedStepMotion<MidpointStepper<MidpointRule, Attitude, NoTorque>>>(name, problem,
                                                                                              step_s, effort);
}

}  // namespace

std::unique_ptr<const Motion> implicit_midpoint_motion(const Problem& problem, double step_s,
                                                       const Effort& effort) {
  return made<CayleyAttitude>("implicit-midpoint", problem, step_s, effort);
}

std::unique_ptr<const Motion> implicit_midpoint_exp_motion(const Problem& problem, double step_s,
                                                           const Effort& effort) {
  return made<ExponentialAttitude>("implicit-midpoint-exp", problem, step_s, effort);
}

}  // namespace polhode
