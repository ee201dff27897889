// SPDX-License-Identifier: MIT
#include "lessons/claims/given.h"

#include "base/spelling.h"
#include "lessons/claims/expressions/expression_names.h"
#include "lessons/claims/expressions/expression_variants.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace polhode {
namespace {

bool is_one_of(Quantity quantity, Quantity first, int count) {
  const int place = static_cast<int>(quantity) - static_cast<int>(first);
  return place >= 0 && place < count;
}
bool is_moment(Quantity quantity) { return is_one_of(quantity, Quantity::I1, 3); }
bool is_spin(Quantity quantity) { return is_one_of(quantity, Quantity::w1, 3); }
bool is_torque(Quantity quantity) { return quantity == Quantity::N || is_one_of(quantity, Quantity::N1, 3); }

bool can_be_set(Quantity quantity) {
  return is_moment(quantity) || is_spin(quantity) || is_torque(quantity) || quantity == Quantity::F;
}

/// Whether they are one thing, or part of each other.
bool overlap(Quantity a, Quantity b) {
  return a == b || (is_torque(a) && is_torque(b) && (a == Quantity::N || b == Quantity::N));
}

/// Whether the value depends on what is set: T, L and I·a hold all moments, and T, ω and L all of ω.
bool depends_on(const Expression& value, Quantity set) {
  if (value.uses(set)) return true;
  const bool has_inertia =
      value.uses(Quantity::T) || value.uses(Quantity::L) || value.uses(Operation::inertia);
  if (is_moment(set)) return has_inertia;
  if (is_spin(set)) return value.uses(Quantity::omega) || value.uses(Quantity::T) || value.uses(Quantity::L);
  if (is_torque(set))
    return value.uses(Quantity::N) ||
           (set == Quantity::N &&
            (value.uses(Quantity::N1) || value.uses(Quantity::N2) || value.uses(Quantity::N3)));
  return false;
}

bool is_fixed(const Expression& value) {
  return std::all_of(value.nodes.begin(), value.nodes.end(), [](const ExpressionNode& node) {
    return node.operation != Operation::inertia && node.operation != Operation::apply &&
           node.operation != Operation::trace &&
           (node.operation != Operation::quantity || is_moment(node.quantity));
  });
}

}  // namespace

bool Given::sets(Quantity quantity) const {
  return std::any_of(settings.begin(), settings.end(),
                     [quantity](const Setting& setting) { return setting.quantity == quantity; });
}

bool Given::sets_torque() const {
  return std::any_of(settings.begin(), settings.end(),
                     [](const Setting& setting) { return is_torque(setting.quantity); });
}

bool Given::sets_spin() const {
  return std::any_of(settings.begin(), settings.end(),
                     [](const Setting& setting) { return is_spin(setting.quantity); });
}

bool SmallQuantities::has(Quantity quantity) const {
  return std::any_of(quantities.begin(), quantities.end(), [quantity](Quantity small) {
    return small == quantity || (small == Quantity::N && is_torque(quantity));
  });
}

bool SmallQuantities::has_torque() const {
  return std::any_of(quantities.begin(), quantities.end(), is_torque);
}

std::vector<std::string_view> SmallQuantities::names() const {
  std::vector<std::string_view> names;
  for (const Quantity quantity : quantities) names.push_back(facts_of(quantity).name);
  return names;
}

std::string_view name_of_order(int order) {
  constexpr std::array<std::string_view, kMaxSmallOrder> kNames{"first", "second", "third", "fourth"};
  return kNames[static_cast<std::size_t>(order - 1)];
}

bool can_be_small(Quantity quantity) {
  return is_spin(quantity) || is_torque(quantity) || quantity == Quantity::h || quantity == Quantity::k;
}

std::optional<SettingFault> why_not_bound(const Bound& bound) {
  for (const Expression* side : {&bound.sides.left, &bound.sides.right}) {
    if (side->type() == ExpressionType::vector)
      return SettingFault{"of two vectors none is the greater", "compare norm2(a) and norm2(b)"};
    if (std::any_of(side->nodes.begin(), side->nodes.end(), is_rate))
      return SettingFault{"an assumption holds at an instant: it has no rates", ""};
    if (!is_rational(*side))
      return SettingFault{"a proof has no roots and no angles: what is assumed has none", ""};
  }
  return std::nullopt;
}

std::optional<SettingFault> why_not_together(const Given& given) {
  for (const Setting& setting : given.settings)
    for (const Quantity small : given.small.quantities)
      if (overlap(setting.quantity, small))
        return SettingFault{"what is small is set already, by " + in_quotes(setting.text), "leave one out"};
  return std::nullopt;
}

std::optional<SettingFault> why_not_set(const Setting& setting, const std::vector<Setting>& before) {
  if (!can_be_set(setting.quantity))
    return SettingFault{"an assumption sets I1 I2 I3, w1 w2 w3, N, N1 N2 N3 or F", "for example I2 = I1"};
  const Expression& value = setting.value;
  if (std::any_of(value.nodes.begin(), value.nodes.end(), is_rate))
    return SettingFault{"an assumption holds at an instant: its value has no rates", ""};
  if (!is_rational(value))
    return SettingFault{"a proof has no roots and no angles: what is assumed has none", ""};
  if (is_moment(setting.quantity) && !is_fixed(value))
    return SettingFault{
        "a principal moment does not change: it is set to numbers, constants and other moments", ""};
  if (depends_on(value, setting.quantity))
    return SettingFault{"this sets a quantity to an expression of itself", "solve for it first"};
  const Degree& degree = value.nodes.back().degree;
  if (degree.numerator + degree.denominator > kMaxSettingDegree)
    return SettingFault{"the degree of this exceeds " + std::to_string(kMaxSettingDegree), ""};
  for (const Setting& other : before) {
    if (overlap(setting.quantity, other.quantity))
      return SettingFault{"this is set already, by " + in_quotes(other.text), "leave one out"};
    if (depends_on(other.value, setting.quantity))
      return SettingFault{"what is set here is used by " + in_quotes(other.text) + " before it",
                          "write this one first"};
  }
  return std::nullopt;
}

}  // namespace polhode
