// SPDX-License-Identifier: MIT
#include "render/scene/model/model.h"

#include "physics/analysis/characteristic_time.h"
#include "physics/analysis/motion_errors.h"
#include "physics/body/euler.h"
#include "physics/exact/powers_of_two.h"
#include "physics/method.h"
#include "render/scene/model/euler_terms.h"
#include "render/scene/model/rotor.h"
#include "render/scene/model/translation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace polhode {
namespace {

constexpr double kHerpolhodePeriods = 3.0;  // enough for the annulus to show
constexpr double kShownSecondsPerPeriod = 8.0;
constexpr double kTurnsWithoutPeriod = 4.0;  // of ω, where torque leaves no polhode period
/// Of ω; more would have too few points to a turn (kMaxHerpolhodePoints).
constexpr double kMostHerpolhodeTurns = 1300;
constexpr int kFamilySize = 4;  // polhodes on each side of the separatrix

bool contains(const std::vector<View>& views, View view) {
  return std::find(views.begin(), views.end(), view) != views.end();
}

Quat turn_half_about_x() { return Quat(0.0, 1.0, 0.0, 0.0); }

/// Shortest rotation that takes `from_B` to `to_S`; where that exceeds a quarter turn, a half turn about x
/// comes first, so that the result is defined and continuous also for opposite directions.
Quat align(const Vec3& from_B, const Vec3& to_S) {
  if (from_B.isZero(0.0)) return Quat::Identity();
  if (from_B.dot(to_S) >= 0.0) return shortest_rotation(from_B, to_S);
  const Quat half = turn_half_about_x();
  return shortest_rotation(half * from_B, to_S) * half;
}

/// A vector along L, whatever the units: |L| itself may be out of range.
Vec3 along_L_B(const Scene& scene) {
  const Vec3 &I = scene.body.moments.vector(), &w_B = scene.w0_B;
  if (w_B.isZero(0.0) || !w_B.allFinite()) return Vec3::Zero();
  return times_two_to(-exponent_of(I), I).cwiseProduct(times_two_to(-exponent_of(w_B), w_B));
}

Quat initial_attitude(const Scene& scene) {
  const AttitudeSpec spec =
      scene.attitude.value_or(scene.show.contains(Overlay::plane) ? LPoints::down : LPoints::up);
  if (const Quat* given = std::get_if<Quat>(&spec)) return given->normalized();
  const double z = std::get<LPoints>(spec) == LPoints::down ? -1.0 : 1.0;
  return align(along_L_B(scene), Vec3(0.0, 0.0, z));
}

double natural_span(const Scene& scene) {
  const double turn_s = turn_time(scene.w0_B).value_or(1.0);
  if (!scene.torque.empty()) return kTurnsWithoutPeriod * turn_s;
  return polhode_period(scene.body.moments, scene.w0_B).value_or(turn_s);
}

/// What curves over time cover. Without `duration`: one polhode period, else some turns.
double span_of(const Scene& scene) { return scene.duration_s.value_or(natural_span(scene)); }

/// The longest |t| that a still of the scene asks its motion for.
double reach_of(const Scene& scene, const Requirements& needs) {
  const double span_s = span_of(scene);
  double reach_s = std::abs(scene.at_s);
  if (needs.trail_L || needs.trail_omega) reach_s += span_s;
  if (needs.terms && scene.torque.empty()) reach_s = std::max(reach_s, span_of(scene));
  if (needs.herpolhode) reach_s = std::max(reach_s, herpolhode_span_s(scene));
  return std::max(reach_s, std::abs(still_time_s(scene)));
}

struct Choice {
  std::unique_ptr<const Motion> motion;
  std::string why;
};

std::string why_closed_form(const Motion& motion, const Requirements& needs) {
  if (motion.method() == name_of(Method::uniform)) return "steady rotation: ω is constant, closed form";
  if (motion.method() == name_of(Method::symmetric))
    return "two moments are equal: symmetric top in closed form";
  return needs.attitude
             ? "no torque: closed form of ω and attitude by Jacobi's functions"
             : "no torque, and no overlay asks for attitude: closed form of ω by Jacobi's functions";
}

std::string why(const MotionSpec& spec, const MethodChoice& choice, const Motion& motion,
                const Requirements& needs) {
  if (choice.method == Method::exact) return why_closed_form(motion, needs);
  if (spec.method) return "the scene asks for it";
  return "torque acts: no closed form, " + std::string(facts_of(choice.method).term) + " with error control";
}

/// The longest |t| that a motion can be asked for in the time there is for a still.
double reach_of(const Motion& motion, const std::optional<double>& step_s) {
  return step_s ? std::min(motion.max_time_s(), double{kMostSteps} * *step_s) : motion.max_time_s();
}

void check_reach(const MethodChoice& choice, const Motion& motion, double reach_s) {
  const std::string name(facts_of(choice.method).name);
  if (choice.step_s && reach_s > double{kMostSteps} * *choice.step_s)
    throw std::domain_error("at and duration reach " + std::to_string(reach_s / *choice.step_s) +
                            " steps of \"" + name + "\" from the start, at most " +
                            std::to_string(kMostSteps) + " are made: choose a shorter time or a longer step");
  if (reach_s > motion.max_time_s())
    throw std::domain_error("at and duration reach " + std::to_string(reach_s) + " s from the start, \"" +
                            name + "\" at most " + std::to_string(motion.max_time_s()) +
                            " s: choose a shorter time");
}

void check_herpolhode(const Scene& scene, const Requirements& needs) {
  const std::optional<double> turn_s = turn_time(scene.w0_B);
  const double turns = turn_s ? herpolhode_span_s(scene) / *turn_s : 0.0;
  if (needs.herpolhode && turns > kMostHerpolhodeTurns)
    throw std::domain_error("a herpolhode of " + std::to_string(turns) +
                            " turns of ω is asked for, at most " + std::to_string(kMostHerpolhodeTurns) +
                            " are drawn: choose a shorter duration");
}

void check_drift(const Scene& scene) {
  constexpr double kMostSizes = 200;  // of the body: further off it would be a speck
  const double size_m = scene.body.shape.value_or(equivalent_box(scene.body.moments)).size_m.norm();
  for (double t_s : {scene.at_s, 0.5 * span_of(scene), span_of(scene)}) {
    const double sizes = translation_at(scene, t_s).r_S.norm() / size_m;
    if (!(sizes <= kMostSizes))
      throw std::domain_error("the centre of mass moves by " + std::to_string(sizes) +
                              " times the size of the body, at most " + std::to_string(kMostSizes) +
                              " are drawn: choose a smaller velocity, force or duration");
  }
}

/// The step of the methods side by side.
double table_step_s(const Scene& scene) {
  constexpr double kStepsPerTurn = 64.0;
  return scene.motion.step_s.value_or(turn_time(scene.w0_B).value_or(2.0 * std::numbers::pi) / kStepsPerTurn);
}

void check_method_table(const Scene& scene, const Requirements& needs) {
  const double shortest_s = table_step_s(scene) * (needs.orders ? std::exp2(1 - kOrderSteps) : 1.0);
  const double steps = std::abs(scene.at_s) / shortest_s;
  if ((needs.methods || needs.orders) && steps > kMostTableSteps)
    throw std::domain_error(std::string(needs.orders ? "order-plot" : "method-table") + " takes " +
                            std::to_string(steps) + " steps with each method, at most " +
                            std::to_string(kMostTableSteps) +
                            " are made: choose an earlier time `at` or a longer step");
}

bool is_computable(const Motion& motion, const Requirements& needs, double t_s) {
  return needs.attitude ? is_finite(motion.at(t_s)) : !needs.omega || motion.w_B_at(t_s).allFinite();
}

/// What is drawn is scaled to the picture, and what is written is a number of double.
void check_size(const Scene& scene, const Requirements& needs) {
  const PrincipalMoments& I = scene.body.moments;
  const Vec3& w_B = scene.w0_B;
  if (!needs.omega || w_B.isZero(0.0)) return;
  const double size = energy_ellipsoid_semi_axes(I, w_B).maxCoeff();
  if (!std::isfinite(size) || !std::isfinite(1.0 / w_B.cwiseAbs().maxCoeff()))
    throw std::domain_error("the angular velocity is too large or too small to be drawn");
  if (!std::isfinite(norm_of(angular_momentum_B(I, w_B))))
    throw std::domain_error("the angular momentum exceeds the largest number there is, 1.8e308 kg m²/s");
  const std::vector<Meter> meters = needs.meters ? shown_meters(scene) : std::vector<Meter>{};
  const bool tells_energy = scene.show.contains(Overlay::values) ||
                            std::find(meters.begin(), meters.end(), Meter::energy) != meters.end();
  if (tells_energy && !std::isfinite(2.0 * kinetic_energy(I, w_B)))
    throw std::domain_error("the kinetic energy exceeds the largest number there is, 1.8e308 J");
}

/// Only on the way is it seen how far steps by tolerance lead, and whether a motion overflows.
void check_course(const Scene& scene, const Problem& problem, const Motion& motion,
                  const Requirements& needs) {
  for (const double t_s : {scene.at_s, still_time_s(scene)})
    if (!is_computable(motion, needs, t_s))
      throw std::domain_error("the motion cannot be computed at t = " + std::to_string(t_s) +
                              " s: " + why_no_state(motion, problem, t_s));
  if (!needs.omega || facts_of(*method_from(motion.method())).control != StepControl::adaptive) return;
  const double reach_s = std::max(reach_of(scene, needs), needs.meters ? span_of(scene) : 0.0);
  const double end_s = std::copysign(reach_s, scene.at_s);
  if (!motion.w_B_at(end_s).allFinite() && motion.is_too_far(end_s))
    throw std::domain_error("at and duration reach " + std::to_string(reach_s) + " s from the start, \"" +
                            std::string(motion.method()) + "\" takes more than " +
                            std::to_string(kMostSteps) +
                            " steps to get there: choose a shorter time or a larger tolerance");
}

/// What the scene asks for, or the method that is best for body and torque.
Choice choose_motion(const Scene& scene, const Problem& problem, const Requirements& needs,
                     const Effort& effort) {
  const MotionSpec& spec = scene.motion;
  const MethodChoice choice{spec.method.value_or(default_method(problem)), spec.step_s, spec.tolerance,
                            kMostSteps};
  auto motion = make_motion(problem, choice, effort);
  check_size(scene, needs);
  check_reach(choice, *motion, reach_of(scene, needs));
  check_herpolhode(scene, needs);
  check_drift(scene);
  check_method_table(scene, needs);
  std::string reason = why(spec, choice, *motion, needs);
  return {std::move(motion), std::move(reason)};
}

/// Even steps of L²/2T between each extreme moment and the middle one; none where both are equal, or so
/// nearly that no number lies between.
std::vector<double> family_levels(const PrincipalMoments& I) {
  Vec3 sorted = I.vector();
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> levels;
  for (int side = 0; side < 2; ++side)
    for (int n = 1; n <= kFamilySize; ++n) {
      const double level =
          std::lerp(sorted[side], sorted[side + 1], (n - 0.5 * (1 - side) - 0.25) / kFamilySize);
      const bool is_new = levels.empty() || level > levels.back();
      if (is_new && level > sorted[side] && level < sorted[side + 1]) levels.push_back(level);
    }
  return levels;
}

/// Of a free body over a loop of its film; under torque, which may let the terms grow without end, until
/// `at`.
double longest_term(const SceneModel& model) {
  constexpr int kSamples = 32;  // a picture's scale: nothing hangs on its last digits
  const double reach_s = model.scene.torque.empty() ? model.span_s : model.scene.at_s;
  double longest = 0.0;
  for (int n = 0; n <= kSamples; ++n) {
    const double t_s = reach_s * n / kSamples;
    const double term =
        euler_terms_at(*model.motion, model.scene.body.moments, model.scene.torque, t_s).largest();
    if (std::isfinite(term)) longest = std::max(longest, term);
  }
  return longest;
}

/// As exact as there is: the closed form, under torque the best method at a tolerance near rounding.
std::unique_ptr<const Motion> exact_motion(const Problem& problem, const Effort& effort) {
  constexpr double kTolerance = 1e-13;
  const Method method = default_method(problem);
  const bool adaptive = facts_of(method).control == StepControl::adaptive;
  return make_motion(problem,
                     {.method = method,
                      .tolerance = adaptive ? std::optional(kTolerance) : std::nullopt,
                      .max_steps = kMostSteps},
                     effort);
}

/// A closed form tells nothing by itself: it is asked four times for each point, which is as dear as this.
void spend_on(const Curve& curve, const Effort& effort) {
  constexpr std::int64_t kEvaluationsPerPoint = 10;
  spend(effort, kEvaluationsPerPoint * static_cast<std::int64_t>(curve.points.size()));
}

void compute_parts(SceneModel& model, const Effort& effort, double chord_tolerance) {
  const Scene& scene = model.scene;
  const PrincipalMoments& I = scene.body.moments;
  const Vec3& w_B = scene.w0_B;
  const bool moves = !w_B.isZero(0.0);
  const double tolerance = moves ? chord_tolerance * energy_ellipsoid_semi_axes(I, w_B).maxCoeff() : 0.0;

  if (model.needs.polhode && moves) model.polhode_B = polhode_curve(I, w_B, tolerance);
  if (model.needs.polhode_family && moves)
    model.family_B = polhode_family(I, w_B, family_levels(I), tolerance);
  if (model.needs.separatrix && moves) model.separatrices_B = separatrices(I, w_B, tolerance);
  if (model.needs.herpolhode && moves)
    model.herpolhode_S = herpolhode(*model.motion, 0.0, herpolhode_span_s(scene), tolerance);
  spend_on(model.herpolhode_S, effort);
  if (model.needs.solid) model.solid = scene.body.shape.value_or(equivalent_box(I));
  if (model.needs.terms) model.longest_term = longest_term(model);
  for (int k = 0; model.needs.orders && k < kOrderSteps; ++k)
    model.orders.push_back(
        method_table(problem_of(scene), table_step_s(scene) * std::exp2(-k), scene.at_s, effort));
  if (model.needs.methods)
    model.methods = method_table(problem_of(scene), table_step_s(scene), scene.at_s, effort);
}

}  // namespace

double herpolhode_span_s(const Scene& scene) {
  return scene.duration_s.value_or(kHerpolhodePeriods * natural_span(scene));
}

namespace {

/// What holds of a scene, of all that overlays may ask for.
SeenIf what_holds(const Scene& scene) {
  SeenIf holds = SeenIf::always;
  const auto if_so = [&](bool so, SeenIf what) { holds = so ? holds | what : holds; };
  const AttitudeSpec attitude = scene.attitude.value_or(LPoints::down);
  const LPoints* points = std::get_if<LPoints>(&attitude);
  if_so(scene.torque.empty(), SeenIf::free);
  if_so(!scene.torque.empty(), SeenIf::torque);
  if_so(!scene.torque.empty() || !scene.w0_B.isZero(0.0), SeenIf::moves);
  if_so(contains(scene.views, View::space), SeenIf::space_view);
  if_so(points && *points == LPoints::down, SeenIf::L_down);
  if_so(drifts(scene), SeenIf::translates);
  if_so(!scene.F_S.isZero(0.0), SeenIf::force);
  if_so(heavy_top_of(scene) != nullptr, SeenIf::pivot);
  return holds;
}

}  // namespace

OverlaySet drawn_overlays(const Scene& scene) {
  const SeenIf holds = what_holds(scene);
  const bool turns = scene.show.contains(Overlay::turn_orders);
  OverlaySet drawn;
  for (int i = 0; i < kOverlayCount; ++i) {
    const OverlayFacts& facts = facts_of(static_cast<Overlay>(i));
    const bool is_seen = (facts.seen_if | holds) == holds && (!turns || facts.stays_in_turns);
    if (is_seen && scene.show.contains(facts.overlay)) drawn.insert(facts.overlay);
  }
  return drawn;
}

std::vector<Meter> shown_meters(const Scene& scene) {
  if (scene.meters) return *scene.meters;
  if (scene.torque.empty()) return {Meter::omega, Meter::drift};
  return {Meter::omega, Meter::energy, Meter::momentum};
}

namespace {

bool needs_attitude(Meter meter, const Scene& scene) {
  return meter == Meter::drift || (meter == Meter::momentum && !scene.torque.empty());
}

/// A ghost of the exact motion would hide in the same motion.
bool asks_for_ghost(const Scene& scene) {
  return scene.motion.ghost && scene.motion.method &&
         facts_of(*scene.motion.method).control != StepControl::none;
}

Requirements requirements_of_figure(const Scene& scene) {
  const OverlaySet show = drawn_overlays(scene);
  const auto shown = [&](Overlay o) { return show.contains(o); };
  const bool in_space = contains(scene.views, View::space);
  const bool in_body = contains(scene.views, View::body);
  const bool turns = shown(Overlay::turn_orders);  // by a hand: no motion
  Requirements needs;
  for (int i = 0; i < kOverlayCount; ++i) {
    const OverlayFacts& facts = facts_of(static_cast<Overlay>(i));
    if (!shown(facts.overlay)) continue;
    for (bool Requirements::*part : facts.needs)
      if (part) needs.*part = true;
    needs.attitude = needs.attitude || facts.attitude == AttitudeIn::both ||
                     (facts.attitude == AttitudeIn::space && in_space && !turns) ||
                     (facts.attitude == AttitudeIn::body && in_body);
  }
  needs.herpolhode = needs.herpolhode && in_space;
  needs.attitude =
      needs.attitude || needs.herpolhode || (in_body && drifts(scene)) || depends_on_attitude(scene.torque);
  needs.omega = needs.omega || needs.attitude || needs.polhode;
  needs.ghost =
      asks_for_ghost(scene) && (needs.solid || shown(Overlay::omega) || shown(Overlay::L)) && !turns;
  return needs;
}

}  // namespace

Requirements requirements(const Scene& scene, Product product) {
  Requirements needs = requirements_of_figure(scene);
  if (product == Product::figure) return needs;
  for (Meter meter : shown_meters(scene)) {
    needs.meters = needs.omega = true;
    needs.attitude = needs.attitude || needs_attitude(meter, scene);
  }
  return needs;
}

Problem problem_of(const Scene& scene) {
  return {scene.body.moments, {initial_attitude(scene), scene.w0_B}, scene.torque};
}

void check_scene(const Scene& scene, const Effort& effort) {
  const Problem problem = problem_of(scene);
  const Requirements needs = requirements(scene, Product::page);
  check_course(scene, problem, *choose_motion(scene, problem, needs, effort).motion, needs);
}

bool is_computable(const SceneModel& model, double t_s) {
  return is_computable(*model.motion, model.needs, t_s);
}

SceneModel make_model(const Scene& scene, Product product, const Effort& effort, double chord_tolerance) {
  SceneModel model;
  model.scene = scene;
  model.drawn = drawn_overlays(scene);
  model.needs = requirements(scene, product);
  const Problem problem = problem_of(scene);
  model.q0_SB = problem.start.q_SB;

  Choice choice = choose_motion(scene, problem, model.needs, effort);
  model.motion = std::move(choice.motion);
  model.why = std::move(choice.why);

  model.L_reference = angular_momentum_B(scene.body.moments, scene.w0_B).stableNorm();
  if (!scene.torque.empty() && model.needs.omega)
    model.L_reference =
        std::max(model.L_reference,
                 angular_momentum_B(scene.body.moments, model.motion->w_B_at(scene.at_s)).stableNorm());
  model.span_s = span_of(scene);
  model.reach_s = reach_of(*model.motion, scene.motion.step_s);
  model.rate = scene.rate.value_or(natural_span(scene) / kShownSecondsPerPeriod);
  if (model.needs.ghost) model.exact = exact_motion(problem, effort);
  compute_parts(model, effort, chord_tolerance);
  return model;
}

}  // namespace polhode
