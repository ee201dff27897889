// SPDX-License-Identifier: MIT
#include "render/scene/model/scene_checks.h"

#include "base/numbers.h"
#include "physics/analysis/characteristic_time.h"
#include "physics/body/euler.h"
#include "physics/exact/powers_of_two.h"
#include "physics/geometry/poinsot.h"
#include "render/scene/model/method_table.h"
#include "render/scene/model/scene_needs.h"
#include "render/scene/model/scene_problem.h"
#include "render/scene/model/translation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace polhode {
namespace {

/// Of ω; more would have too few points to a turn (kMaxHerpolhodePoints).
constexpr double kMostHerpolhodeTurns = 1300;

/// As many digits as the limits have.
std::string told(double value) { return digits(value, 7); }

void check_reach(const MethodChoice& choice, const Motion& motion, double reach_s) {
  const std::string name(facts_of(choice.method).name);
  if (choice.step_s && reach_s > double{kMostStillSteps} * *choice.step_s)
    throw std::domain_error("at and duration reach " + told(reach_s / *choice.step_s) + " steps of \"" +
                            name + "\" from the start, at most " + std::to_string(kMostStillSteps) +
                            " are made: choose a shorter time or a longer step");
  if (reach_s > motion.max_time_s())
    throw std::domain_error("at and duration reach " + told(reach_s) + " s from the start, \"" + name +
                            "\" at most " + told(motion.max_time_s()) + " s: choose a shorter time");
}

void check_herpolhode(const Scene& scene, const Requirements& needs) {
  const std::optional<double> turn_s = turn_time(scene.w0_B);
  const double turns = turn_s ? herpolhode_span_s(scene) / *turn_s : 0.0;
  if (needs.herpolhode && turns > kMostHerpolhodeTurns)
    throw std::domain_error("a herpolhode of " + told(turns) + " turns of ω is asked for, at most " +
                            told(kMostHerpolhodeTurns) + " are drawn: choose a shorter duration");
}

void check_drift(const Scene& scene) {
  constexpr double kMostSizes = 200;  // of the body: further off it would be a speck
  const double size_m =
      scene.body.shape.value_or(equivalent_box(scene.body.moments, scene.body.mass_kg)).size_m.norm();
  for (double t_s : {scene.at_s, 0.5 * span_s(scene), span_s(scene)}) {
    const double sizes = translation_at(scene, t_s).r_S.norm() / size_m;
    if (!(sizes <= kMostSizes))
      throw std::domain_error("the centre of mass moves by " + told(sizes) +
                              " times the size of the body, at most " + told(kMostSizes) +
                              " are drawn: choose a smaller velocity, force or duration");
  }
}

void check_method_table(const Scene& scene, const Requirements& needs) {
  const double shortest_s = table_step_s(scene) * (needs.orders ? std::exp2(1 - kOrderSteps) : 1.0);
  const double steps = std::abs(scene.at_s) / shortest_s;
  if ((needs.methods || needs.orders) && steps > kMostTableSteps)
    throw std::domain_error(std::string(needs.orders ? "order-plot" : "method-table") + " takes " +
                            told(steps) + " steps with each method, at most " + told(kMostTableSteps) +
                            " are made: choose an earlier time `at` or a longer step");
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
  const std::vector<PlotSpec> meters = needs.meters ? scene.meters : std::vector<PlotSpec>{};
  const bool tells_energy = scene.show.contains(Overlay::values) ||
                            std::find(meters.begin(), meters.end(), PlotSpec(Meter::energy)) != meters.end();
  if (tells_energy && !std::isfinite(2.0 * kinetic_energy(I, w_B)))
    throw std::domain_error("the kinetic energy exceeds the largest number there is, 1.8e308 J");
}

}  // namespace

double reach_of_still_s(const Scene& scene, const Requirements& needs) {
  double reach_s = std::abs(scene.at_s);
  if (needs.trail_L || needs.trail_omega || needs.marks) reach_s += span_s(scene);
  if (needs.terms && scene.torque.empty()) reach_s = std::max(reach_s, span_s(scene));
  if (needs.rolling_ticks) reach_s = std::abs(still_time_s(scene)) + natural_span_s(scene);
  if (needs.herpolhode) reach_s = std::max(reach_s, herpolhode_span_s(scene));
  return std::max(reach_s, std::abs(still_time_s(scene)));
}

void check_limits(const Scene& scene, const MethodChoice& choice, const Motion& motion,
                  const Requirements& needs) {
  check_size(scene, needs);
  check_reach(choice, motion, reach_of_still_s(scene, needs));
  check_herpolhode(scene, needs);
  check_drift(scene);
  check_method_table(scene, needs);
}

}  // namespace polhode
