// SPDX-License-Identifier: MIT
#include "lessons/claims/motion_words.h"

#include "lessons/diagnostics/report.h"
#include "physics/analysis/work_precision.h"
#include "physics/geometry/flips.h"
#include "physics/method.h"
#include "render/scene/model/method_table.h"
#include "render/scene/model/scene_problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace polhode {
namespace {

/// Of what the motion may not have.
template <class Facts, class T>
std::optional<double> part(const std::optional<Facts>& facts, T Facts::*member) {
  return facts ? std::optional<double>((*facts).*member) : std::nullopt;
}

using M = MotionNumbers;

/// What a text in the language of claims comes to on a free symmetric body.
std::optional<double> of_free(M& m, const std::string& text) {
  const SourceText source(text);
  Report unused(source, "");
  const auto expression = read_expression(text, {1, 1}, unused, nullptr);
  return expression && m.facts().free ? m.value_of(*expression) : std::nullopt;
}
std::optional<double> body_cone_rad(M& m) {
  const std::string axis = std::to_string(m.facts().free ? m.facts().free->axis + 1 : 0);
  return of_free(m, "atan2(norm(cross(omega, e" + axis + ")), sqrt(w" + axis + "^2))");
}
std::optional<double> space_cone_rad(M& m) {
  return of_free(m, "atan2(norm(cross(L, omega)), dot(L, omega))");
}

std::optional<double> horizon_s(M& m) {
  const auto periods = m.horizon().periods_1e_1, period_s = m.facts().period_s;
  return periods && period_s ? std::optional(*periods * *period_s) : std::nullopt;
}

constexpr std::array kWords = std::to_array<MotionWord>({
    {"period", "s", R"(\text{period})", "period of the polhode", [](M& m) { return m.facts().period_s; }},
    {"flip_interval", "s", R"(\text{time between two flips})",
     "free body that turns over again and again about its intermediate axis: time from one flip to the next",
     [](M& m) { return m.flip_interval_s(); }},
    {"condition", "1", R"(\kappa)",
     "free body: rad by which its phase moves in one period for each relative change of 1 in moments and ω",
     [](M& m) { return m.horizon().condition; }},
    {"horizon", "s", R"(\text{horizon})",
     "free body: time after which rounding of moments and ω to double may have moved its phase by 0.1 rad",
     [](M& m) { return horizon_s(m); }},
    {"precession", "rad/s", R"(\text{precession})",
     R"(free symmetric body: rate at which its axis turns about L; \|L\|/I1 with the axis 3)",
     [](M& m) { return part(m.facts().free, &FreePrecession::in_space); }},
    {"body_precession", "rad/s", R"(\text{precession in the body})",
     "rate at which ω turns about this axis, seen from the body; (I3 − I1) ω3/I1 with the axis 3",
     [](M& m) { return part(m.facts().free, &FreePrecession::in_body); }},
    {"body_cone", "rad", R"(\text{half-angle of the body cone})",
     "half-angle of the cone on which ω turns about this axis", [](M& m) { return body_cone_rad(m); }},
    {"space_cone", "rad", R"(\text{half-angle of the space cone})",
     "half-angle of the cone on which ω turns about L", [](M& m) { return space_cone_rad(m); }},
    {"slow_precession", "rad/s", R"(\text{slow precession})",
     "symmetric top under its weight alone: the slow rate of steady precession at its tilt and ω3 of t = 0",
     [](M& m) { return part(m.facts().steady, &SteadyPrecession::slow); }},
    {"fast_precession", "rad/s", R"(\text{fast precession})", "the fast one",
     [](M& m) { return m.facts().steady ? m.facts().steady->fast : std::nullopt; }},
    {"nutation", "rad/s", R"(\text{nutation})", "2π by the period of its nutation",
     [](M& m) { return part(m.facts().nutation, &Nutation::rate); }},
    {"least_tilt", "rad", R"(\text{least tilt})", "the least angle between its axis and the vertical",
     [](M& m) { return part(m.facts().nutation, &Nutation::theta_least_rad); }},
    {"most_tilt", "rad", R"(\text{largest tilt})", "the largest one",
     [](M& m) { return part(m.facts().nutation, &Nutation::theta_most_rad); }},
    {"error_omega", "1", R"(\text{error of }\vec\omega)",
     R"(computed motion: its relative error in ω at t, \|ω − ω′\|/\|ω′\|; ω′ is that of the closed form, )"
     "under a torque that of Dormand–Prince 8 with the tolerance 1e-13",
     [](M& m) { return part(m.error(), &StateError::omega); }},
    {"error_attitude", "rad", R"(\text{error of the attitude})", "the angle between both attitudes at t",
     [](M& m) { return part(m.error(), &StateError::attitude_rad); }},
    {"drift_T", "1", R"(\text{drift of }T)", "the largest relative change of T from 0 to t",
     [](M& m) { return std::optional(m.drift().T); }},
    {"drift_L", "1", R"(\text{drift of }|\vec L|)", R"(that of \|L\|)",
     [](M& m) { return std::optional(m.drift().L); }},
    {"drift_direction", "rad", R"(\text{drift of the direction of }\vec L)",
     "the largest angle between L and L at t = 0, in space",
     [](M& m) { return std::optional(m.drift().L_direction_rad); }},
    {"evaluations", "1", R"(\text{evaluations})",
     "computed motion: so many evaluations of the equations of motion from 0 to t",
     [](M& m) { return m.evaluations(); }},
});

bool is_motion_word(const ExpressionNode& node) {
  return node.operation == Operation::constant && std::isnan(node.number.value);
}

}  // namespace

std::span<const MotionWord> motion_words() { return kWords; }

void add_motion_words(Vocabulary& vocabulary, std::map<int, Dimension>& dimensions) {
  for (const MotionWord& word : kWords) {
    if (vocabulary.find(word.name) != nullptr) continue;
    const int number = vocabulary.constants() ? static_cast<int>(vocabulary.constants()->size()) : 0;
    vocabulary.add_constant(std::string(word.name), std::numeric_limits<double>::quiet_NaN(),
                            std::string(word.tex));
    dimensions[number] = dimension_of_unit(word.unit).value();
  }
}

namespace {

/// Whether a word for the motion, or a constant of a lesson, is in an expression, of this unit; of constants
/// any.
bool has_word_in(const Expression& expression, std::string_view unit) {
  return std::any_of(expression.nodes.begin(), expression.nodes.end(), [&](const ExpressionNode& node) {
    if (node.operation != Operation::constant) return false;
    if (!is_motion_word(node)) return true;
    const std::string& name = (*expression.constants)[static_cast<std::size_t>(node.integer)];
    return std::any_of(kWords.begin(), kWords.end(),
                       [&](const MotionWord& word) { return word.name == name && word.unit == unit; });
  });
}

bool has_spin(const Expression& expression) {
  using Q = Quantity;
  for (const Q rate : {Q::omega, Q::w1, Q::w2, Q::w3, Q::dw1, Q::dw2, Q::dw3})
    if (expression.uses(rate)) return true;
  return false;
}

/// How a number counts turns: by which power of π it is more than one that counts radians. 0 of ω and of
/// 2π/period, −1 of ω/2π and of 1/period, which are turns per second.
struct Turns {
  std::optional<double> power;  ///< nothing: it cannot be told
  bool is_rate = false;         ///< ω or a period is in it
};

/// Of the whole expression, or nothing where turns are added to radians.
std::optional<Turns> turns_of(const Expression& expression) {
  using O = Operation;
  std::vector<Turns> known;
  const auto at = [&](int index) -> const Turns& { return known[static_cast<std::size_t>(index)]; };
  for (const ExpressionNode& n : expression.nodes) {
    Turns made{0.0, false};
    const auto join = [&](double sign) {
      const Turns &a = at(n.a), &b = at(n.b);
      made.is_rate = a.is_rate || b.is_rate;
      made.power = a.power && b.power ? std::optional(*a.power + sign * *b.power) : std::nullopt;
    };
    switch (n.operation) {
      case O::pi:
        made.power = 1;
        break;
      case O::quantity:
        made.is_rate = n.quantity == Quantity::omega || n.quantity == Quantity::w1 ||
                       n.quantity == Quantity::w2 || n.quantity == Quantity::w3;
        break;
      case O::constant:
        if (!is_motion_word(n)) {
          made.power.reset();
        } else {
          const std::string& name = (*expression.constants)[static_cast<std::size_t>(n.integer)];
          const auto word =
              std::find_if(kWords.begin(), kWords.end(), [&](const MotionWord& w) { return w.name == name; });
          if (word->unit == "s") made = {1.0, true};  // so long is a turn
        }
        break;
      case O::multiply:
      case O::dot:
      case O::cross:
        join(1);
        break;
      case O::divide:
        join(-1);
        break;
      case O::add:
      case O::subtract: {
        const Turns &a = at(n.a), &b = at(n.b);
        const bool differ = a.power && b.power && *a.power != *b.power;
        if (differ && a.is_rate && b.is_rate) return std::nullopt;
        made = {differ ? std::nullopt : a.power ? a.power : b.power, a.is_rate || b.is_rate};
        break;
      }
      case O::power:
        made = at(n.a);
        if (made.power) *made.power *= n.integer;
        break;
      case O::norm2:
        made = at(n.a);
        if (made.power) *made.power *= 2;
        break;
      case O::sqrt:
        made = at(n.a);
        if (made.power) *made.power /= 2;
        break;
      case O::acos:
      case O::atan2:
        made.power.reset();  // an angle, in what it is counted in
        break;
      case O::negate:
      case O::norm:
      case O::comp:
      case O::inertia:
      case O::apply:
      case O::star:
      case O::ddt:
        made = at(n.a);
        break;
      case O::number:
      case O::trace:
      case O::sin:
      case O::exp:
      case O::log:
      case O::cos:
        break;
    }
    known.push_back(made);
  }
  return known.back();
}

/// What is wrong with the turns or radians that it counts.
std::string why_not_turns(const Expression& expression, std::string_view unit) {
  const auto turns = turns_of(expression);
  if (!turns) return "turns per second and radians per second are added";
  if (!turns->power || !turns->is_rate) return "";
  if (unit.find("Hz") != unit.npos && *turns->power == 0)
    return "a rate of radians is in rad/s; turns per second are that by 2*pi, in Hz";
  if (unit.find("Hz") != unit.npos && *turns->power != -1)
    return "this does not count turns per second, and Hz does: |ω|/(2*pi), 1/period";
  const bool in_angles = unit == "rad/s" || unit == "deg/s" || unit == "°/s";
  if (in_angles && *turns->power != 0)
    return "this does not count radians per second: turns per second are in Hz, and 2*pi as many radians";
  return "";
}

/// Radians are of angles alone: J/rad would be a joule.
bool is_unit_of_angles(std::string_view unit) {
  const auto read = scaled_unit(unit);
  const bool is_squared = unit.find("rad²") != unit.npos || unit.find("rad^") != unit.npos;
  return read && read->dimension[0] == 0 && read->dimension[1] == 0 && read->dimension[2] <= 0 &&
         (!is_squared || read->dimension[2] == -2);
}

}  // namespace

std::string why_not_in(const Expression& expression, std::string_view unit) {
  if (std::string why = why_not_turns(expression, unit); !why.empty()) return why;
  if (unit.find("rad") != unit.npos && !is_unit_of_angles(unit))
    return "radians are of angles and their rates: rad, rad/s, rad/s², rad²/s²";
  const bool is_ratio = expression.type() == ExpressionType::scalar && !expression.uses(Operation::acos) &&
                        !expression.uses(Operation::atan2) && !expression.uses(Operation::pi) &&
                        !has_word_in(expression, "rad") && !has_spin(expression);
  if (unit == "rad" && is_ratio) return "this is no angle, and radians are of angles: acos(…), atan2(…)";
  const bool has_pi = expression.uses(Operation::pi);
  const bool is_angle = expression.uses(Operation::acos) || expression.uses(Operation::atan2);
  if (unit.find("Hz") != unit.npos && !has_pi && !has_word_in(expression, "s"))
    return "a rate of radians is in rad/s; turns per second are that by 2*pi, in Hz";
  const bool in_degrees = unit.find("deg") != unit.npos || unit.find("°") != unit.npos;
  if (!in_degrees) return "";
  const bool of_rate = unit.find("/s") != unit.npos;
  const bool is_alone = unit == "deg" || unit == "°" || unit == "deg/s" || unit == "°/s" || unit == "deg/s²";
  const bool has_turned = is_angle || has_pi || has_word_in(expression, of_rate ? "rad/s" : "rad") ||
                          (of_rate && has_spin(expression));
  return is_alone && has_turned
             ? ""
             : "this is no angle, and degrees are of angles: acos(…), atan2(…), or rates in deg/s";
}

bool has_motion_words(const Expression& expression) {
  return std::any_of(expression.nodes.begin(), expression.nodes.end(), is_motion_word);
}

MotionNumbers::MotionNumbers(const SceneModel& model, double t_s, Effort effort)
    : model_(model),
      t_s_(t_s),
      effort_(std::move(effort)),
      problem_(problem_of(model.scene)),
      live_(live_state(model, t_s)) {}

std::optional<double> MotionNumbers::value_of(const Expression& scalar) {
  if (!live_) return std::nullopt;
  const auto known = written_out(scalar);
  return known ? live_number(*known, *live_) : std::nullopt;
}

std::optional<Expression> MotionNumbers::written_out(const Expression& expression) {
  Expression known = expression;
  for (ExpressionNode& node : known.nodes) {
    if (!is_motion_word(node)) continue;
    const std::string& name = (*expression.constants)[static_cast<std::size_t>(node.integer)];
    const auto word =
        std::find_if(kWords.begin(), kWords.end(), [&](const auto& w) { return w.name == name; });
    const auto value = word->value(*this);
    if (!value || !std::isfinite(*value)) return std::nullopt;
    node.number.value = *value;
  }
  return known;
}

const MotionFacts& MotionNumbers::facts() {
  if (!facts_) facts_ = motion_facts(problem_);
  return *facts_;
}

std::optional<double> MotionNumbers::flip_interval_s() {
  const bool flips = problem_.torque.empty() && keeps_flipping(problem_.I, problem_.start.w_B);
  if (!flips || !facts().period_s) return std::nullopt;
  return 0.5 * *facts().period_s;
}

bool MotionNumbers::is_computed() const {
  const Method method = model_.scene.motion.method.value_or(default_method(problem_));
  return facts_of(method).control != StepControl::none;
}

std::optional<StateError> MotionNumbers::error() {
  if (!is_computed()) return std::nullopt;
  if (!error_) error_ = error_of(model_.motion->at(t_s_), reference_motion(problem_, effort_)->at(t_s_));
  return error_;
}

const InvariantDrift& MotionNumbers::drift() {
  if (drift_) return *drift_;
  const std::vector<double> times_s = drift_times_s(t_s_);
  std::vector<RigidBodyState> states(times_s.size());
  const RigidBodyState end = model_.motion->at(t_s_);  // first: the way is known then
  model_.motion->at(times_s, states);
  states.push_back(end);
  drift_ = drift_along(problem_, states);
  return *drift_;
}

std::optional<double> MotionNumbers::evaluations() const {
  if (!is_computed()) return std::nullopt;
  return static_cast<double>(model_.motion->evaluations_to(t_s_));
}

}  // namespace polhode
