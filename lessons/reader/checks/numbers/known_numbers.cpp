// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/numbers/known_numbers.h"

#include "lessons/claims/expressions/dimension.h"
#include "lessons/claims/motion_words.h"
#include "render/scene/model/model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>
#include <utility>

namespace polhode {
namespace {

/// What every motion has, and what is said of it most.
constexpr std::array<std::string_view, 36> kKnown{
    "T",
    "2*T",
    "norm(L)",
    "norm(omega)",
    "w1",
    "w2",
    "w3",
    "I1",
    "I2",
    "I3",
    "norm(N)",
    "N1",
    "N2",
    "N3",
    "m",
    "norm(v)",
    "norm(p)",
    "norm(F)",
    "norm(omega)/(2*pi)",
    "2*pi/norm(omega)",
    "acos(dot(omega, L)/(norm(omega)*norm(L)))",
    "acos(dot(omega, e1)/norm(omega))",
    "acos(dot(omega, e2)/norm(omega))",
    "acos(dot(omega, e3)/norm(omega))",
    "acos(dot(L, e1)/norm(L))",
    "acos(dot(L, e2)/norm(L))",
    "acos(dot(L, e3)/norm(L))",
    "acos(dot(e3, ez))",
    "period",
    "flip_interval",
    "precession",
    "body_precession",
    "slow_precession",
    "fast_precession",
    "least_tilt",
    "most_tilt",
};

/// To half a unit of its last digit.
bool is_near(const TypedNumber& number, const ScaledUnit& unit, double value) {
  return std::abs(std::abs(value) / unit.size - std::abs(number.value)) <=
         0.5 * number.last_digit * (1 + 1e-9);
}

class KnownNumbers {
 public:
  KnownNumbers(const TypedNumber& number, const ScaledUnit& unit, const Lesson& lesson, const Effort& effort)
      : number_(number),
        unit_(unit),
        lesson_(lesson),
        effort_(effort),
        vocabulary_(lesson.notation.vocabulary) {
    add_motion_words(vocabulary_, dimensions_);
  }

  bool is_constant() const {
    for (const Vocabulary::Word& word : lesson_.notation.vocabulary.words())
      if (const auto constant = word.constant(); constant && is_near(constant->second) && fits(word.name))
        return true;
    return false;
  }

  bool is_of(const ShownMotion& motion, std::optional<double> at_s) {
    const Scene& scene = motion.model.scene;
    if (unit_.dimension == kTime) {
      const double step_s = scene.motion.step_s.value_or(0);
      if (scene.show.contains(Overlay::order_plot) && is_near(std::ldexp(step_s, 1 - kOrderSteps)))
        return true;
      for (const double time_s :
           {scene.at_s, motion.still_s, scene.duration_s.value_or(0), motion.model.span_s,
            motion.model.span_s / motion.model.rate, step_s, scene.poses.over_s})
        if (is_near(time_s)) return true;
    }
    constexpr Dimension kLength{0, 1, 0}, kMass{1, 0, 0}, kForce{1, 1, -2};
    // What the motion has none of is nothing that it contradicts.
    const bool has_force = !scene.torque.empty() || !scene.F_S.isZero();
    if ((unit_.dimension == kLength && !scene.body.shape) || (unit_.dimension == kForce && !has_force))
      return true;
    if (unit_.dimension == kMass && is_near(scene.body.mass_kg)) return true;
    if (unit_.dimension == kLength)
      for (const double size_m : scene.body.shape->size_m)
        if (is_near(size_m)) return true;
    for (const double t_s : {motion.still_s, 0.0, at_s.value_or(0.0)}) {
      MotionNumbers numbers(motion.model, t_s, effort_);
      for (const std::string_view text : kKnown)
        if (is_value(text, numbers)) return true;
      for (const Vocabulary::Word& word : lesson_.notation.vocabulary.words())
        if (!word.constant() && is_value(word.name, numbers)) return true;
    }
    return false;
  }

 private:
  /// What a constant says of its unit.
  bool fits(const std::string& name) const {
    const auto symbol = lesson_.symbols.find(name);
    const auto unit = symbol == lesson_.symbols.end() ? std::nullopt : dimension_of_unit(symbol->second.unit);
    return !unit || *unit == unit_.dimension;
  }

  bool is_near(double value) const { return polhode::is_near(number_, unit_, value); }

  bool is_value(std::string_view text, MotionNumbers& numbers) const {
    const SourceText source(text);
    Report unused(source, "");
    const auto expression = read_expression(text, {1, 1}, unused, &vocabulary_);
    if (!expression || expression->type() == ExpressionType::vector) return false;
    const auto dimension = dimension_of(*expression, dimensions_).dimension;
    if (dimension && *dimension != unit_.dimension) return false;
    const auto value = numbers.value_of(*expression);
    return value && is_near(*value);
  }

  const TypedNumber& number_;
  ScaledUnit unit_;
  const Lesson& lesson_;
  const Effort& effort_;
  Vocabulary vocabulary_;  ///< with the words of motions as a whole
  std::map<int, Dimension> dimensions_;
};

/// 90°, 45°, 30°: nobody computes them.
bool is_constructed(const TypedNumber& number, const ScaledUnit& unit) {
  constexpr double kSixth = std::numbers::pi / 12;
  if (unit.dimension != kNumber) return false;
  const double parts = number.value * unit.size / kSixth;
  return std::abs(parts - std::round(parts)) < 1e-9;
}

}  // namespace

double rounded_off(const TypedNumber& number, Relation relation) {
  constexpr double kOfWhole = 0.03;
  const double half = 0.5 * number.last_digit * (1 + 1e-9);
  return relation == Relation::approximate ? half : std::min(half, kOfWhole * std::abs(number.value));
}

std::vector<double> times_of(const ShownMotion& motion, SaidOf when) {
  if (when == SaidOf::some_time) return {motion.still_s, 0.0};
  std::vector<double> times_s{motion.still_s};
  for (int i = 0; i < kMeasuredTimes; ++i) times_s.push_back(motion.model.span_s * i / (kMeasuredTimes - 1));
  return times_s;
}

namespace {

/// Whether what is asked of a value is so on one of the motions: at one of the times, or at all.
template <class IsSo>
std::optional<bool> is_so_on(const std::vector<ShownMotion>& motions, const Expression& quantity,
                             const Effort& effort, SaidOf when, const IsSo& is_so_of,
                             std::optional<double> at_s = {}) {
  std::optional<bool> is_so;
  for (const ShownMotion& motion : motions) {
    std::optional<bool> on_motion;
    const auto is_so_at = [&](double t_s) -> std::optional<bool> {
      MotionNumbers numbers(motion.model, t_s, effort);
      const auto value = numbers.value_of(quantity);
      return value ? std::optional(is_so_of(*value)) : std::nullopt;
    };
    if (when == SaidOf::start_or_all_times && is_so_at(0).value_or(false)) return true;
    for (const double t_s : at_s ? std::vector{*at_s} : times_of(motion, when)) {
      const auto is_so_now = is_so_at(t_s);
      if (!is_so_now) continue;
      on_motion = when == SaidOf::some_time ? on_motion.value_or(false) || *is_so_now
                                            : on_motion.value_or(true) && *is_so_now;
    }
    if (on_motion) is_so = is_so.value_or(false) || *on_motion;
  }
  return is_so;
}

}  // namespace

std::optional<bool> is_between(const Expression& quantity, const TypedNumber& low, const TypedNumber& high,
                               const std::vector<ShownMotion>& motions, const Effort& effort, SaidOf when) {
  const ScaledUnit unit = scaled_unit(high.unit).value_or(ScaledUnit{});
  const auto dimension = has_motion_words(quantity) ? std::nullopt : dimension_of(quantity, {}).dimension;
  if (dimension && !high.unit.empty() && *dimension != unit.dimension) return false;
  const double low_unit = low.unit.empty() ? unit.size : scaled_unit(low.unit).value_or(unit).size;
  double least = low_unit * low.value, most = unit.size * high.value;
  double off_least = low_unit * rounded_off(low, Relation::approximate),
         off_most = unit.size * rounded_off(high, Relation::approximate);
  if (least > most) std::swap(least, most), std::swap(off_least, off_most);  // "between 3 and -3"
  least -= off_least, most += off_most;
  return is_so_on(motions, quantity, effort, when,
                  [&](double value) { return value >= least && value <= most; });
}

std::optional<bool> is_number_of(const TypedNumber& number, const Expression& quantity,
                                 const std::vector<ShownMotion>& motions, const Effort& effort,
                                 Relation relation, SaidOf when, std::optional<double> at_s) {
  const ScaledUnit unit = scaled_unit(number.unit).value_or(ScaledUnit{});
  const auto dimension = has_motion_words(quantity) ? std::nullopt : dimension_of(quantity, {}).dimension;
  if (dimension && !number.unit.empty() && *dimension != unit.dimension) return false;
  const auto is_so_of = [&](double value) {
    const double typed = number.value * unit.size;
    constexpr double kRounding = 1e-9;  // of "at most 3 rad/s" where it is 3
    if (relation == Relation::greater) return value > typed;
    if (relation == Relation::less) return value < typed;
    if (relation == Relation::greater_or_equal) return value >= typed - kRounding * std::abs(typed);
    if (relation == Relation::less_or_equal) return value <= typed + kRounding * std::abs(typed);
    return std::abs(std::abs(value) / unit.size - std::abs(number.value)) <= rounded_off(number, relation) &&
           (number.value >= 0 || value < 0);
  };
  return is_so_on(motions, quantity, effort, when, is_so_of, at_s);
}

bool is_known_number(const TypedNumber& number, const Lesson& lesson, const std::vector<ShownMotion>& motions,
                     const Effort& effort, std::optional<double> at_s) {
  const auto unit = scaled_unit(number.unit);
  if (!unit || number.unit.empty() || number.value == 0 || is_constructed(number, *unit)) return true;
  KnownNumbers known(number, *unit, lesson, effort);
  if (known.is_constant()) return true;
  for (const ShownMotion& motion : motions)
    if (known.is_of(motion, at_s)) return true;
  return false;
}

}  // namespace polhode
