// SPDX-License-Identifier: MIT
#include "app/narration/verdict_row.h"

#include "physics/method.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polhode {

bool refutes(ClaimKind kind) { return kind == ClaimKind::is_false || kind == ClaimKind::non_sequitur; }

namespace {

std::string upper(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

std::string how_it_is_computed(const Scene* scene) {
  if (!scene) return "";
  const MotionSpec& motion = scene->motion;
  const MethodFacts& facts = facts_of(motion.method.value_or(default_method(problem_of(*scene))));
  if (facts.control == StepControl::none) return "on the exact motion";
  if (facts.control == StepControl::fixed)
    return fmt::format("with {}, $h$ = {:g} s", facts.name, *motion.step_s);
  return fmt::format("with {}, tolerance {:g}", facts.name, motion.tolerance.value_or(kDefaultTolerance));
}

std::string note_of(ClaimKind kind, const std::optional<Counterexample>& counter, const Scene* scene) {
  switch (kind) {
    case ClaimKind::identity:
      return "proved for every state";
    case ClaimKind::definition:
      return "nothing to prove";
    case ClaimKind::law:
      return "assumed";
    case ClaimKind::motion:
      return "proved for any torque";
    case ClaimKind::free:
      return "proved without torque";
    case ClaimKind::measured:
      return how_it_is_computed(scene);
    case ClaimKind::is_false:
      return counter ? fmt::format("at {}: {} ≠ {}", counter->state, counter->left, counter->right) : "";
    case ClaimKind::non_sequitur:
      return counter ? fmt::format("at {} the premise holds, yet {} ≠ {}", counter->state, counter->left,
                                   counter->right)
                     : "";
  }
  return "";
}

/// 10^−15 as type: what comes out of measuring has one digit that means something.
std::string rounded_text(double value) {
  if (value == 0) return "0";
  if (value >= 0.001 && value < 1000) return fmt::format("{:.2g}", value);
  int exponent = static_cast<int>(std::floor(std::log10(value)));
  int digit = static_cast<int>(std::lround(value / std::pow(10.0, exponent)));
  if (digit == 10) digit = 1, ++exponent;
  return fmt::format("${}{{\\cdot}}10^{{{}}}$", digit, exponent);
}

/// Two or three digits of the largest component, a factor of ten set apart where it is not near 1. What is
/// nothing beside the terms it comes from is 0.
class SideText {
 public:
  explicit SideText(const LiveValue& value) : value_(value) {
    constexpr double kNothing = 1e-6;
    double largest = 0;
    for (const auto& side : {value.left, value.right})
      for (const double x : side) largest = std::max(largest, std::abs(x));
    is_nothing_ = largest <= kNothing * value.size;
    const int exponent = is_nothing_ ? 0 : static_cast<int>(std::floor(std::log10(largest)));
    if (exponent < -1 || exponent > 2) factor_ = exponent;
    decimals_ = std::clamp(2 - (exponent - factor_), 0, 2);
  }

  std::string operator()(const std::array<double, 3>& side) const {
    if (is_nothing_ || side == std::array<double, 3>{}) return "0";
    const std::string tail = factor_ == 0 ? "" : fmt::format("${{\\cdot}}10^{{{}}}$", factor_);
    if (!value_.is_vector) return number(side[0]) + tail;
    return fmt::format("({}, {}, {}){}", number(side[0]), number(side[1]), number(side[2]), tail);
  }

 private:
  std::string number(double value) const {
    std::string text = fmt::format("{:.{}f}", value / std::pow(10.0, factor_), decimals_);
    if (text.find_first_not_of("-0.") == std::string::npos) return "0";
    return text.front() == '-' ? "−" + text.substr(1) : text;
  }

  const LiveValue& value_;
  bool is_nothing_ = false;
  int factor_ = 0, decimals_ = 2;
};

}  // namespace

namespace {

/// Of several lines the page could not say whose sides a pair of values is.
bool has_sides(const Claim& claim) { return claim.lines.size() == 1; }

/// Why a measured claim fails on its motion; nothing if it holds.
std::optional<std::string> why_not_measured(const Claim& claim, const SceneModel& model) {
  for (const ClaimLine& line : claim.lines) {
    const auto measured = measure(line.equality, line.within, model);
    if (!measured) return "has no value at some time";
    if (measured->tolerance > kDecisive) return "the step is too long to tell";
    if (!measured->holds()) return fmt::format("fails at $t$ = {:.3g} s", measured->t_s);
  }
  return std::nullopt;
}

}  // namespace

VerdictRow verdict_row(const Claim& claim, const Scene* scene, const SceneModel* model) {
  VerdictRow row{.claim = &claim,
                 .word = upper(name_of(claim.kind)),
                 .note = {},
                 .refutes = refutes(claim.kind),
                 .proved = true};
  std::optional<Counterexample> counter;
  for (const ClaimLine& line : claim.lines) {
    row.proved = row.proved && line.judgement && line.judgement->verdict == Verdict::holds;
    if (!counter && line.judgement) counter = line.judgement->counterexample;
  }
  row.note = note_of(claim.kind, counter, scene);
  if (!row.proved) row.note = counter ? "does not hold: " + to_string(*counter) : "not proved";
  if (claim.kind != ClaimKind::measured || !model) return row;
  if (const auto why = why_not_measured(claim, *model)) row.note = *why, row.proved = false;
  return row;
}

std::string live_text(const Claim& claim, const LiveState& live, View view) {
  const auto value = live_value(claim, live, view);
  if (!value) return "";
  const bool apart = value->residual > std::min(value->tolerance, kDecisive);
  const std::string distance =
      fmt::format("{} {} {} {}", claim.kind == ClaimKind::identity ? "rounding" : "apart",
                  rounded_text(value->residual), apart ? ">" : "≤", rounded_text(value->tolerance));
  const bool refutes = claim.kind == ClaimKind::is_false;
  if (value->tolerance > kDecisive) return refutes ? "" : "the step is too long to tell";
  if (!has_sides(claim)) return refutes ? "" : distance;
  const SideText side(*value);
  const std::string frame = !value->is_vector ? "" : view == View::space ? "in $S$ " : "in $S^*$ ";
  const std::string left = side(value->left);
  // What is equal is printed equal, whichever way the last digit was rounded.
  const std::string right = apart || value->right == std::array<double, 3>{} ? side(value->right) : left;
  const std::string sides = fmt::format("{}{} {} {}", frame, left, apart ? "≠" : "=", right);
  return refutes ? sides : sides + ",  " + distance;
}

std::string widest_live_text(const Claim& claim) {
  constexpr const char* kDistance = "rounding $8{\\cdot}10^{-16}$ ≤ $8{\\cdot}10^{-13}$";
  if (!has_sides(claim)) return kDistance;
  const bool vector = claim.lines.front().equality.is_vector();
  const std::string side = vector ? "(−0.00, −0.00, −0.00)" : "−0.00${\\cdot}10^{-4}$";
  std::string sides = fmt::format("{}{} = {}", vector ? "in $S^*$ " : "", side, side);
  if (claim.kind == ClaimKind::is_false) return sides;
  return sides + ",  " + kDistance;
}

}  // namespace polhode
