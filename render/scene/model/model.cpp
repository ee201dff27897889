// SPDX-License-Identifier: MIT
#include "render/scene/model/model.h"

#include "base/numbers.h"
#include "physics/analysis/characteristic_time.h"
#include "physics/analysis/euler_terms.h"
#include "physics/analysis/motion_errors.h"
#include "physics/body/euler.h"
#include "physics/exact/powers_of_two.h"
#include "physics/method.h"
#include "render/scene/model/scene_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace polhode {
namespace {

constexpr int kFamilySize = 4;  // polhodes on each side of the separatrix

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
  if (choice.method == Method::lagrange_top)
    return "weight alone on a symmetric top: closed form by theta functions";
  return "torque acts: no closed form, " + std::string(facts_of(choice.method).term) + " with error control";
}

/// The longest |t| that a motion can be asked for in the time there is for a still.
double reach_of(const Motion& motion, const std::optional<double>& step_s) {
  return step_s ? std::min(motion.max_time_s(), double{kMostStillSteps} * *step_s) : motion.max_time_s();
}

bool is_computable(const Motion& motion, const Requirements& needs, double t_s) {
  return needs.attitude ? is_finite(motion.at(t_s)) : !needs.omega || motion.w_B_at(t_s).allFinite();
}

/// Only on the way is it seen how far steps by tolerance lead, and whether a motion overflows.
void check_course(const Scene& scene, const Problem& problem, const Motion& motion,
                  const Requirements& needs) {
  for (const double t_s : {scene.at_s, still_time_s(scene)})
    if (!is_computable(motion, needs, t_s))
      throw std::domain_error("the motion cannot be computed at t = " + digits(t_s, 7) +
                              " s: " + why_no_state(motion, problem, t_s));
  if (!needs.omega || facts_of(*method_from(motion.method())).control != StepControl::adaptive) return;
  const double reach_s = std::max(reach_of_still_s(scene, needs), needs.meters ? span_s(scene) : 0.0);
  const double end_s = std::copysign(reach_s, scene.at_s);
  if (!motion.w_B_at(end_s).allFinite() && motion.is_too_far(end_s))
    throw std::domain_error("at and duration reach " + digits(reach_s, 7) + " s from the start, \"" +
                            std::string(motion.method()) + "\" takes more than " +
                            std::to_string(kMostStillSteps) +
                            " steps to get there: choose a shorter time or a larger tolerance");
}

/// What the scene asks for, or the method that is best for body and torque.
Choice choose_motion(const Scene& scene, const Problem& problem, const Requirements& needs,
                     const Effort& effort) {
  const MotionSpec& spec = scene.motion;
  const MethodChoice choice{spec.method.value_or(default_method(problem)), spec.step_s, spec.tolerance,
                            kMostStillSteps};
  auto motion = make_motion(problem, choice, effort);
  check_limits(scene, choice, *motion, needs);
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

/// A closed form tells nothing by itself: it is asked four times for each point, which is as dear as this.
void spend_on(const Curve& curve, const Effort& effort) {
  constexpr std::int64_t kEvaluationsPerPoint = 10;
  spend(effort, kEvaluationsPerPoint * static_cast<std::int64_t>(curve.points.size()));
}

/// The tip goes round no separatrix, and stays where it is in a steady rotation: neither has ticks.
RollingTicks rolling_ticks(const SceneModel& model, const Effort& effort) {
  constexpr std::int64_t kEvaluations = 2000;
  const Scene& scene = model.scene;
  const auto period_s = polhode_period(scene.body.moments, scene.w0_B);
  if (!period_s) return {};
  spend(effort, kEvaluations);
  return {equal_arc_times(*model.motion, scene.body.moments, still_time_s(scene), *period_s, kRollingTicks),
          *period_s};
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
  if (model.needs.rolling_ticks) model.ticks = rolling_ticks(model, effort);
  if (model.needs.solid) model.solid = scene.body.shape.value_or(equivalent_box(I, scene.body.mass_kg));
  if (model.needs.marks) model.courses = vector_courses(model, effort);
  if (model.needs.terms) model.longest_term = longest_term(model);
  for (int k = 0; model.needs.orders && k < kOrderSteps; ++k)
    model.orders.push_back(method_table(problem_of(scene), table_step_s(scene) * std::exp2(-k), scene.at_s,
                                        effort, scene.compared.methods));
  if (model.needs.methods)
    model.methods =
        method_table(problem_of(scene), table_step_s(scene), scene.at_s, effort, scene.compared.methods);
}

/// Null where the frame is the scene's own; also where no motion can begin with the ω that it is kept from,
/// which is no reason to refuse the scene.
std::unique_ptr<const SceneModel> framed_model(const Scene& scene, const Effort& effort,
                                               double chord_tolerance) {
  const std::optional<CameraFit>& fitted = scene.camera.fitted;
  if (!fitted || !fitted->w0_B || !frame_needs_motion(scene)) return nullptr;
  Scene before = scene;
  before.w0_B = *fitted->w0_B;
  if (fitted->attitude) before.attitude = fitted->attitude;
  if (before.w0_B == scene.w0_B && attitude_spec(before) == attitude_spec(scene)) return nullptr;
  before.beside.clear();
  try {
    return std::make_unique<const SceneModel>(make_model(before, ModelFor::figure, effort, chord_tolerance));
  } catch (const std::domain_error&) {
    return nullptr;
  }
}

}  // namespace

void check_scene(const Scene& scene, const Effort& effort) {
  const Problem problem = problem_of(scene);
  const Requirements needs = requirements(scene, ModelFor::page);
  check_course(scene, problem, *choose_motion(scene, problem, needs, effort).motion, needs);
  for (const Scene& other : scene.beside) check_scene(other, effort);
}

std::vector<const SceneModel*> shown_models(const SceneModel& model) {
  std::vector<const SceneModel*> shown;
  for (const SceneModel& other : model.beside) shown.push_back(&other);
  const std::size_t before = std::min(model.scene.before, shown.size());
  shown.insert(shown.begin() + static_cast<std::ptrdiff_t>(before), &model);
  return shown;
}

bool is_computable(const SceneModel& model, double t_s) {
  const auto serves = [&](const SceneModel* shown) {
    return is_computable(*shown->motion, shown->needs, t_s);
  };
  const std::vector<const SceneModel*> shown = shown_models(model);
  return std::all_of(shown.begin(), shown.end(), serves);
}

SceneModel make_model(const Scene& scene, ModelFor use, const Effort& effort, double chord_tolerance) {
  SceneModel model;
  model.scene = scene;
  model.drawn = drawn_overlays(scene);
  model.needs = requirements(scene, use);
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
  model.span_s = span_s(scene);
  model.reach_s = reach_of(*model.motion, scene.motion.step_s);
  model.rate = shown_rate(scene);
  if (model.needs.ghost) model.exact = reference_motion(problem, effort);
  compute_parts(model, effort, chord_tolerance);
  if (use == ModelFor::numbers) return model;
  model.framed = framed_model(scene, effort, chord_tolerance);
  for (const Scene& other : scene.beside) {
    model.beside.push_back(make_model(other, use, effort, chord_tolerance));
    model.reach_s = std::min(model.reach_s, model.beside.back().reach_s);
  }
  return model;
}

}  // namespace polhode
