// SPDX-License-Identifier: MIT
#include "lessons/claims/live_claims.h"

#include "lessons/claims/expressions/expression_variants.h"
#include "lessons/claims/proof/proof.h"
#include "physics/analysis/difference.h"
#include "physics/analysis/motion_errors.h"
#include "physics/body/euler.h"
#include "physics/exact/powers_of_two.h"
#include "physics/method.h"
#include "render/scene/model/translation.h"
#include "render/scene/model/transport_arrow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// How fast things change, rad/s: |ω|, or what the torque brings about from rest.
double rate_scale(const SceneModel& model, const RigidBodyState& state) {
  const Scene& scene = model.scene;
  const PrincipalMoments& I = scene.body.moments;
  const double torque = torque_B(scene.torque, state).norm();
  const double scale = std::max(norm_of(state.w_B), std::sqrt(torque / I.vector().minCoeff()));
  return scale > 0 ? scale : 1;
}

/// What changes: attitude by rows, ω, the arrow, the velocity of the centre of mass, the torque. One vector,
/// so that one difference is taken of all.
using Moving = Eigen::Matrix<double, 21, 1>;

Moving moving(const SceneModel& model, double t_s, const RigidBodyState& state) {
  const Mat3 R_SB = state.q_SB.toRotationMatrix();
  Moving all;
  all << R_SB.row(0).transpose(), R_SB.row(1).transpose(), R_SB.row(2).transpose(), state.w_B,
      arrow_A_S(model, t_s, state.q_SB), translation_at(model.scene, t_s).v_S,
      torque_B(model.scene.torque, state);
  return all;
}

Vec3 part(const Moving& all, int index) { return all.segment<3>(3 * index); }

/// Components have the size of the whole vector, and their rates at least that which `rate` would give: what
/// is small by chance is no better known.
ComponentJets<SizedNumber> sized(const Vec3& x, double size, double rate, const Vec3& first,
                                 const Vec3& second) {
  ComponentJets<SizedNumber> result;
  for (int i = 0; i < 3; ++i)
    result[static_cast<std::size_t>(i)] = {{x[i], size},
                                           {first[i], std::max(rate * size, std::abs(first[i]))},
                                           {second[i], std::max(rate * rate * size, std::abs(second[i]))}};
  return result;
}

ComponentJets<SizedNumber> at_rest(const Vec3& x) {
  return sized(x, x.norm(), 0, Vec3::Zero(), Vec3::Zero());
}

Mat3 on_turned_axes(const PrincipalMoments& I) {
  static const Mat3 kTurn = Eigen::AngleAxisd(kTurnOfAxes, Vec3::Ones().normalized()).toRotationMatrix();
  return kTurn.transpose() * I.vector().asDiagonal() * kTurn;
}

/// By what the rates of a computed motion differ from those it should have, relative.
double error_of_method(const SceneModel& model, double rate) {
  const MotionSpec& spec = model.scene.motion;
  const Method method = spec.method.value_or(default_method(problem_of(model.scene)));
  const MethodFacts& facts = facts_of(method);
  if (facts.control == StepControl::adaptive)
    return kUnitsOfTolerance * spec.tolerance.value_or(kDefaultTolerance);
  if (facts.control == StepControl::none) return 0;
  const bool splits = facts.torque == ServedTorque::of_attitude && !model.scene.torque.empty();
  return kStepErrors * std::pow(rate * *spec.step_s, splits ? 2 : facts.order);
}

double rounding_at(double t_s, double rate) {
  constexpr double kRoundings = 64;  // of a state, of the sums, and of the terms that rates come from
  return kRoundings * kEpsilon * (1.0 + rate * std::abs(t_s)) / kDifferenceAngle;
}

/// What is so small beside its terms is no more than rounding, on a motion. Without rates nothing is divided
/// by the step of their differences.
double noise_in(const Expression& expression, const LiveState& live) {
  constexpr double kOfRates = 1e-9;
  return has_rates(expression) ? kOfRates : kDifferenceAngle * live.rounding;
}

bool has_rates(const Equality& equality) { return has_rates(equality.left) || has_rates(equality.right); }

/// What does not speak of rates has no part in the error of a step.
double tolerance_of(const Equality& equality, std::optional<double> within, const LiveState& live) {
  const bool is_second = std::max(equality.left.order(), equality.right.order()) > 1;
  const double allowed = live.rounding + (has_rates(equality) ? live.method_error : 0.0);
  return within.value_or(is_second ? live.growth_of_second * allowed : allowed);
}

double size_of(const ComponentJets<SizedNumber, 0>& x) {
  return std::hypot(x[0].value.size, x[1].value.size, x[2].value.size);
}

std::array<double, 3> values_of(const ComponentJets<SizedNumber, 0>& x) {
  return {x[0].value.value, x[1].value.value, x[2].value.value};
}

/// Nothing if it is not finite; 0 if it is nothing beside `size`, that of the terms it comes from.
std::optional<double> without_noise(const SizedNumber& number, double size, double noise) {
  if (std::abs(number.value) <= noise * size) return 0.0;
  return std::isfinite(number.value) ? std::optional(number.value) : std::nullopt;
}

bool are_small_in(const SmallQuantities& small, const ClaimState<SizedNumber>& state) {
  const auto& w = state.w_B;
  double spin = 0, twice_T = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    spin = std::hypot(spin, w[i].value.value);
    twice_T += state.I[i].value * w[i].value.value * w[i].value.value;
  }
  constexpr std::array kSpin{Quantity::w1, Quantity::w2, Quantity::w3},
      kTorque{Quantity::N1, Quantity::N2, Quantity::N3};
  for (std::size_t i = 0; i < 3; ++i) {
    if (small.has(kSpin[i]) && !(std::abs(w[i].value.value) <= kSmallOnMotion * spin)) return false;
    if (small.has(kTorque[i]) && !(std::abs(state.N_B[i].value.value) <= kSmallOnMotion * twice_T))
      return false;
  }
  return !small.has(Quantity::h) && !small.has(Quantity::k);
}

/// The motion as it begins, without its rates.
bool holds_at_start(const Given& given, const Scene& scene) {
  const RigidBodyState start = problem_of(scene).start;
  const Translation translation = translation_at(scene, 0);
  ClaimState<SizedNumber> s{};
  const Mat3 R_SB = start.q_SB.normalized().toRotationMatrix();
  for (int row = 0; row < 3; ++row)
    s.R[static_cast<std::size_t>(row)] =
        sized(Vec3(R_SB.row(row).transpose()), 1.0, 0, Vec3::Zero(), Vec3::Zero());
  s.w_B = at_rest(start.w_B);
  for (int i = 0; i < 3; ++i) s.I[static_cast<std::size_t>(i)] = scene.body.moments.vector()[i];
  s.N_B = at_rest(torque_B(scene.torque, start));
  s.F_S = at_rest(translation.F_S);
  s.m = translation.mass_kg;
  return holds_in(given, s, rounding_at(0, 1)) && are_small_in(given.small, s);
}

ComponentJets<SizedNumber, 0> in_body(const ComponentJets<SizedNumber, 0>& x_S,
                                      const ClaimState<SizedNumber>& state) {
  return Evaluation<SizedNumber, 0>(state).to_body(x_S);
}

struct Rates {
  Moving first = Moving::Zero(), second = Moving::Zero();
  double scale = 0;  ///< rad/s; 0: there are none
};

LiveState live_state(const SceneModel& model, double t_s, const Moving& now, const Rates& rates) {
  LiveState live;
  ClaimState<SizedNumber>& s = live.state;
  for (int row = 0; row < 3; ++row)
    s.R[static_cast<std::size_t>(row)] =
        sized(part(now, row), 1.0, rates.scale, part(rates.first, row), part(rates.second, row));
  const auto turning = [&](int index) {
    const Vec3 x = part(now, index);
    return sized(x, x.norm(), rates.scale, part(rates.first, index), part(rates.second, index));
  };
  s.w_B = turning(3);
  s.A_S = turning(4);
  s.v_S = turning(5);
  const Translation translation = translation_at(model.scene, t_s);
  const PrincipalMoments& I = model.scene.body.moments;
  s.F_S = at_rest(translation.F_S);  // it does not change
  s.m = translation.mass_kg;
  // No motion says what these are: what uses them has no value.
  s.h = s.k = std::numeric_limits<double>::quiet_NaN();
  s.N_B = turning(6);
  for (int i = 0; i < 3; ++i) s.I[static_cast<std::size_t>(i)] = I.vector()[i];
  const Mat3 J = on_turned_axes(I);
  s.J = {J(0, 0), J(0, 1), J(0, 2), J(1, 1), J(1, 2), J(2, 2)};
  live.rounding = rounding_at(t_s, rates.scale);
  return live;
}

}  // namespace

bool has_rates(const Expression& expression) {
  return std::any_of(expression.nodes.begin(), expression.nodes.end(), is_rate);
}

bool loses_energy_inside(const Scene& scene) {
  return std::any_of(scene.torque.begin(), scene.torque.end(),
                     [](const TorqueTerm& term) { return std::holds_alternative<EnergySink>(term); });
}

std::optional<LiveState> live_state(const SceneModel& model, double t_s) {
  const RigidBodyState state = model.motion->at(t_s);
  if (!is_finite(state)) return std::nullopt;
  const double rate = rate_scale(model, state);
  const Moving now = moving(model, t_s, state);
  const auto [first, second] =
      derivatives_at([&](double at_s) { return moving(model, at_s, model.motion->at(at_s)); }, now, t_s,
                     kDifferenceAngle / rate);
  if (!first.allFinite() || !second.allFinite()) return std::nullopt;
  LiveState live = live_state(model, t_s, now, {first, second, rate});
  live.method_error = error_of_method(model, rate);
  const double turn_in_step = rate * model.scene.motion.step_s.value_or(kDifferenceAngle / rate);
  live.growth_of_second = 1 / std::min(kDifferenceAngle, turn_in_step);
  return live;
}

std::optional<LiveState> still_state(const SceneModel& model, double t_s, const RigidBodyState& state) {
  if (!is_finite(state)) return std::nullopt;
  return live_state(model, t_s, moving(model, t_s, state), {});
}

std::optional<LiveValue> live_value(const Claim& claim, const LiveState& live, View view) {
  std::optional<LiveValue> worst;
  if (claim.kind == ClaimKind::non_sequitur) return worst;
  for (const ClaimLine& line : claim.lines) {
    const auto value = live_value(line, live, view);
    if (!value) return std::nullopt;
    if (!worst || value->residual / value->tolerance > worst->residual / worst->tolerance) worst = value;
  }
  return worst;
}

std::optional<LiveValue> live_value(const ClaimLine& line, const LiveState& live, View view) {
  const auto sides = sides_of(line.equality, live.state);
  if (!sides || line.conclusion) return std::nullopt;
  LiveValue value;
  value.is_vector = line.equality.is_vector();
  const bool is_measured = line.relation == Relation::equal || line.within;
  value.residual = is_measured ? sides->residual : 0;
  value.tolerance = tolerance_of(line.equality, line.within, live);
  value.size = std::max(size_of(sides->left), size_of(sides->right));
  const bool turned = view == View::body && value.is_vector;
  value.left = values_of(turned ? in_body(sides->left, live.state) : sides->left);
  value.right = values_of(turned ? in_body(sides->right, live.state) : sides->right);
  return value;
}

std::optional<double> live_number(const Expression& scalar, const LiveState& live) {
  const auto value = value_in(live.state, scalar);
  if (!value) return std::nullopt;
  const SizedNumber& number = (*value)[0].value;
  return without_noise(number, number.size, noise_in(scalar, live));
}

std::optional<LiveQuantity> live_quantity(const Expression& expression, const LiveState& live, View view) {
  const auto has_value = value_in(live.state, expression);
  if (!has_value) return std::nullopt;
  ComponentJets<SizedNumber, 0> value = *has_value;
  LiveQuantity quantity{.is_vector = expression.type() == ExpressionType::vector};
  if (quantity.is_vector && view == View::body) value = in_body(value, live.state);
  const double size = quantity.is_vector ? size_of(value) : value[0].value.size;
  for (std::size_t i = 0; i < (quantity.is_vector ? 3u : 1u); ++i) {
    const auto component = without_noise(value[i].value, size, noise_in(expression, live));
    if (!component) return std::nullopt;
    quantity.components[i] = *component;
  }
  return quantity;
}

bool holds_on(const Given& given, const LiveState& live) {
  return holds_in(given, live.state, live.rounding) && are_small_in(given.small, live.state);
}

bool can_be_shown(const Claim& claim, const Scene& scene) {
  if (claim.kind == ClaimKind::non_sequitur) return false;
  if (!claim.given.empty() && !holds_at_start(claim.given, scene)) return false;
  if (claim.kind == ClaimKind::measured) return true;
  using Q = Quantity;
  const bool has_no_rates = loses_energy_inside(scene);
  return std::all_of(claim.lines.begin(), claim.lines.end(), [&](const ClaimLine& line) {
    const auto uses = [&](auto what) {
      return line.equality.left.uses(what) || line.equality.right.uses(what);
    };
    const auto uses_any = [&](auto... what) { return (uses(what) || ...); };
    if (uses_any(Q::h, Q::k)) return false;
    if (uses_any(Q::m, Q::p, Q::v, Q::F) && !drifts(scene)) return false;
    if (uses(Q::A) && !scene.show.contains(Overlay::transport)) return false;
    const bool of_tensor = uses_any(Q::Jxx, Q::Jxy, Q::Jxz, Q::Jyy, Q::Jyz, Q::Jzz) ||
                           uses_any(Operation::apply, Operation::trace);
    // J has its components on other axes than these.
    const bool on_principal_axes = uses_any(Q::T, Q::omega, Q::L, Q::N, Q::w1, Q::w2, Q::w3, Q::dw1, Q::dw2,
                                            Q::dw3, Q::N1, Q::N2, Q::N3) ||
                                   uses(Operation::inertia);
    if (of_tensor && (claim.kind != ClaimKind::is_false || on_principal_axes)) return false;
    return !(has_no_rates && has_rates(line.equality));
  });
}

namespace {

/// The state with the rates of attitude, ω and v that the laws of motion say, not those of the motion.
ClaimState<SizedNumber> with_lawful_rates(ClaimState<SizedNumber> s, const SceneModel& model, double t_s) {
  const RigidBodyState state = model.motion->at(t_s);
  const PrincipalMoments& I = model.scene.body.moments;
  const Vec3 torque = torque_B(model.scene.torque, state);
  const Vec3 dw_B = angular_acceleration_B(I, state.w_B, torque);
  const Mat3 R = state.q_SB.toRotationMatrix();
  const Translation translation = translation_at(model.scene, t_s);
  const auto set = [](ComponentJets<SizedNumber>& x, const Vec3& rate, const Vec3& second) {
    for (int i = 0; i < 3; ++i) {
      Jet<SizedNumber>& old = x[static_cast<std::size_t>(i)];
      old.rate = {rate[i], std::max(old.rate.size, std::abs(rate[i]))};
      old.second = {second[i], std::max(old.second.size, std::abs(second[i]))};
    }
  };
  for (int i = 0; i < 3; ++i) {
    const Vec3 row = R.row(i).transpose(), rate = row.cross(state.w_B);
    set(s.R[static_cast<std::size_t>(i)], rate, rate.cross(state.w_B) + row.cross(dw_B));
  }
  Vec3 torque_rate;  // no law says it
  for (int i = 0; i < 3; ++i) torque_rate[i] = s.N_B[static_cast<std::size_t>(i)].rate.value;
  const Vec3 L_B = I.vector().cwiseProduct(state.w_B), dL_B = I.vector().cwiseProduct(dw_B);
  set(s.w_B, dw_B, (torque_rate - dw_B.cross(L_B) - state.w_B.cross(dL_B)).cwiseQuotient(I.vector()));
  set(s.v_S, translation.F_S / translation.mass_kg, Vec3::Zero());
  return s;
}

/// What is so small beside its terms is no more than rounding.
constexpr double kRounding = 256 * kEpsilon;

/// How large the sides are beside their terms; 0 where they are no more than rounding.
double relative_side(const Equality& equality, const ClaimState<SizedNumber>& lawful) {
  const auto sides = sides_of(equality, lawful);
  if (!sides) return 0;
  const double size = std::max(size_of(sides->left), size_of(sides->right));
  double largest = 0;
  for (const auto& side : {values_of(sides->left), values_of(sides->right)})
    largest = std::max(largest, std::hypot(side[0], side[1], side[2]));
  return largest <= kRounding * size ? 0 : largest / size;
}

/// The summands of a side with their signs, each as an expression of its own.
void add_summands(const Expression& side, int index, double sign,
                  std::vector<std::pair<Expression, double>>& into) {
  const ExpressionNode& n = side.nodes[static_cast<std::size_t>(index)];
  if (n.operation == Operation::negate) return add_summands(side, n.a, -sign, into);
  if (n.operation == Operation::add || n.operation == Operation::subtract) {
    add_summands(side, n.a, sign, into);
    return add_summands(side, n.b, n.operation == Operation::add ? sign : -sign, into);
  }
  // Operands stand before what they are operands of.
  into.push_back({{side.text, {side.nodes.begin(), side.nodes.begin() + index + 1}, side.constants}, sign});
}

/// Of an equality with more than two summands: where two of them cancel, how large the others are beside all.
/// It is these that the equality is about: "10^12 + a = b + 10^12" holds within any tolerance, whatever a and
/// b are. Nothing where there are no others, or they are 0.
std::optional<double> relative_rest(const Equality& equality, const ClaimState<SizedNumber>& state) {
  std::vector<std::pair<Expression, double>> summands;
  for (const Expression* side : {&equality.left, &equality.right})
    add_summands(*side, static_cast<int>(side->nodes.size()) - 1, side == &equality.left ? 1 : -1, summands);
  if (summands.size() < 3) return std::nullopt;
  std::vector<Vec3> values;
  double all = 0;
  for (const auto& [summand, sign] : summands) {
    const auto value = value_in(state, summand);
    if (!value) return std::nullopt;
    const auto [x, y, z] = values_of(*value);
    values.push_back(sign * Vec3(x, y, z));
    all += values.back().norm();
  }
  double least = all;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t j = i + 1; j < values.size(); ++j) {
      double rest = 0;
      for (std::size_t k = 0; k < values.size(); ++k)
        if (k != i && k != j) rest += values[k].norm();
      if (rest > 0 && (values[i] + values[j]).norm() <= rest + kRounding * all) least = std::min(least, rest);
    }
  return least < all ? std::optional(least / all) : std::nullopt;
}

}  // namespace

std::optional<MeasuredResidual> measure(const Equality& equality, std::optional<double> within,
                                        const SceneModel& model, const Given& given) {
  MeasuredResidual worst{-1, 1, 0};
  double side = 0, allowed = 0, rest = 0;
  bool has_rest = false;
  for (int n = 0; n < kMeasuredTimes; ++n) {
    const double t_s = model.span_s * n / (kMeasuredTimes - 1);
    const auto live = live_state(model, t_s);
    const auto sides = live ? sides_of(equality, live->state) : std::nullopt;
    if (!sides) return std::nullopt;
    const double tolerance = tolerance_of(equality, within, *live);
    if (sides->residual / tolerance > worst.residual / worst.tolerance)
      worst = {sides->residual, tolerance, t_s};
    const ClaimState<SizedNumber> lawful = with_lawful_rates(live->state, model, t_s);
    side = std::max(side, relative_side(equality, lawful));
    if (const auto others = relative_rest(equality, lawful)) {
      rest = std::max(rest, *others);
      has_rest = true;
    }
    allowed = std::max(allowed, tolerance);
  }
  // Sides that are lost in rounding all the time have to be 0 for a reason.
  const bool is_free = model.scene.torque.empty() && !given.sets_torque();
  const LawsAssumed laws = is_free ? LawsAssumed::free : LawsAssumed::motion;
  const bool is_proved =
      side == 0 && is_provable(equality) && Prover().settle(equality, laws, given) == Verdict::holds;
  worst.side = side == 0 && !is_proved ? kRounding : side;
  if (has_rest && side > 0) worst.side = std::min(worst.side, rest);
  worst.allowed = allowed;
  return worst;
}

}  // namespace polhode
