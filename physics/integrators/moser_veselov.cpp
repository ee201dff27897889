// SPDX-License-Identifier: MIT
#include "physics/integrators/moser_veselov.h"

#include "physics/integrators/midpoint_stepper.h"
#include "physics/integrators/moser_veselov_modification.h"

#include <stdexcept>

namespace polhode {
namespace {

template <int kOrder>
class MoserVeselovRule {
 public:
  explicit MoserVeselovRule(const PrincipalMoments& I)
      : g_(euler_coefficients(I)), modification_(I, kOrder) {}

  MidpointCoefficients coefficients(double h, const Triple& w_B) const {
    const auto [s, sigma] = modification_(h, w_B);
    const Triple G = over((h * s) * g_, {sigma.y * sigma.z, sigma.z * sigma.x, sigma.x * sigma.y});
    return {h, sigma, G, {0.5 * times(sigma, G), 0.25 * h * h}};
  }

 private:
  Triple g_;
  MoserVeselovModification modification_;
};

template <int kOrder>
std::unique_ptr<const Motion> made(std::string_view name, const Problem& problem, double step_s,
                                   const Effort& effort) {
  using Rule = MoserVeselovRule<kOrder>;
  using Free = FixedStepMotion<MidpointStepper<Rule, CayleyAttitude, NoTorque>>;
  using Driven = FixedStepMotion<MidpointStepper<Rule, CayleyAttitude, AttitudeTorque>>;
  if (problem.torque.empty()) return std::make_unique<Free>(name, problem, step_s, effort);
  return std::make_unique<Driven>(name, problem, step_s, effort);
}

}  // namespace

std::unique_ptr<const Motion> moser_veselov_motion(int order, const Problem& problem, double step_s,
                                                   const Effort& effort) {
  if (order == 2) return made<2>("moser-veselov-2", problem, step_s, effort);
  if (order == 6) return made<6>("moser-veselov-6", problem, step_s, effort);
  if (order == 10) return made<10>("moser-veselov-10", problem, step_s, effort);
  throw std::domain_error("Moser-Veselov integrators are of order 2, 6 or 10");
}

}  // namespace polhode
