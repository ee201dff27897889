// SPDX-License-Identifier: MIT
#include "physics/exact/asymmetric_motion.h"

#include "physics/exact/asymmetric_evaluation.h"
#include "physics/exact/powers_of_two.h"
#include "physics/exact/symmetric_motion.h"
#include "physics/exact/uniform_motion.h"

#include <stdexcept>

namespace polhode {

AsymmetricMotion::AsymmetricMotion(const PrincipalMoments& I, const RigidBodyState& start)
    : start_(checked(start)) {
  if (is_steady(I, start_.w_B) || symmetry_axis(I))
    throw std::domain_error(
        "asymmetric motion needs three different moments and a rotation that is not steady");
  const int e_w = exponent_of(start_.w_B);
  f_ = Setup(I, start_.w_B, scalbn(Extended{1}, e_w)).formula(start_.q_SB);
  f_.time_scale = std::scalbn(1.0, e_w);
  for (std::size_t i = 0; i < 3; ++i) f_.w_scales[i] = f_.signs[i] * f_.time_scale;
}

RigidBodyState AsymmetricMotion::at(double t_s) const {
  if (t_s == 0) return start_;
  switch (f_.series) {
    case Series::in_nome:
      return Evaluation::of_state<Series::in_nome>(f_, t_s).state(f_);
    case Series::in_complementary_nome:
      return Evaluation::of_state<Series::in_complementary_nome>(f_, t_s).state(f_);
    case Series::separatrix:
      break;
  }
  return Evaluation::of_state<Series::separatrix>(f_, t_s).state(f_);
}

Vec3 AsymmetricMotion::w_B_at(double t_s) const {
  if (t_s == 0) return start_.w_B;
  switch (f_.series) {
    case Series::in_nome:
      return Evaluation::of_w<Series::in_nome>(f_, t_s).w_B(f_);
    case Series::in_complementary_nome:
      return Evaluation::of_w<Series::in_complementary_nome>(f_, t_s).w_B(f_);
    case Series::separatrix:
      break;
  }
  return Evaluation::of_w<Series::separatrix>(f_, t_s).w_B(f_);
}

void AsymmetricMotion::at(std::span<const double> t_s, std::span<RigidBodyState> states) const {
  switch (f_.series) {
    case Series::in_nome:
      Evaluation::of_states<Series::in_nome>(f_, start_, t_s, states);
      break;
    case Series::in_complementary_nome:
      Evaluation::of_states<Series::in_complementary_nome>(f_, start_, t_s, states);
      break;
    case Series::separatrix:
      Evaluation::of_states<Series::separatrix>(f_, start_, t_s, states);
      break;
  }
}

}  // namespace polhode
