// SPDX-License-Identifier: MIT
#include "app/session/accuracy_meter.h"

#include "app/session/lesson_session.h"
#include "base/stopwatch.h"
#include "physics/analysis/work_precision.h"

#include <limits>
#include <vector>

namespace polhode {

namespace {

MethodChoice choice_of(const SceneModel& model, const Problem& problem) {
  const MotionSpec& spec = model.scene.motion;
  return {spec.method.value_or(default_method(problem)), spec.step_s, spec.tolerance};
}

/// Evenly spread, t_s the last. Adaptive methods take steps again to each of them: they get fewer.
std::vector<RigidBodyState> states_until(const Motion& motion, Method method, double t_s) {
  const int count = facts_of(method).control == StepControl::adaptive ? 16 : 64;
  std::vector<double> times_s;
  for (int i = 1; i <= count; ++i) times_s.push_back(t_s * i / count);
  std::vector<RigidBodyState> states(times_s.size());
  motion.at(times_s, states);
  return states;
}

/// CPU time of a call that goes one frame further, ns: over as many frames as the clock needs.
template <class F>
double mean_ns(F&& next_frame) {
  constexpr double kLongEnough_s = 20e-6;
  constexpr int kMostFrames = 64;
  const double start_s = cpu_time_s();
  double spent_s = 0;
  int frames = 0;
  for (; frames < kMostFrames && spent_s < kLongEnough_s; spent_s = cpu_time_s() - start_s)
    for (const int until = 2 * frames + 1; frames < until; ++frames) next_frame();
  return 1e9 * spent_s / frames;
}

/// From `now` on, frame by frame, by a motion that starts there: what the present one knows of the way ahead
/// does not make it look cheap.
double ns_per_frame(const SceneModel& model, const Problem& problem, const MethodChoice& choice,
                    const RigidBodyState& now) {
  constexpr int kTimings = 3;
  if (!is_finite(now)) return std::numeric_limits<double>::quiet_NaN();
  const double frame_s = model.rate * kFrameSeconds;
  volatile double sink = 0;  // keeps the calls from being optimised away
  std::vector<double> times_ns;
  for (int i = 0; i < kTimings; ++i) {
    const auto ahead = make_motion({problem.I, now, problem.torque}, choice);
    double t_s = 0;
    times_ns.push_back(mean_ns([&] {
      t_s += frame_s;
      sink = sink + (model.needs.attitude ? ahead->at(t_s).w_B.x() : ahead->w_B_at(t_s).x());
    }));
  }
  return median(times_ns);
}

}  // namespace

AccuracyMeter::AccuracyMeter(const SceneModel& model)
    : problem_(problem_of(model.scene)), choice_(choice_of(model, problem_)) {
  const auto exact = closed_form(problem_);
  if (exact && goes_step_by_step(choice_.method)) exact_ = make_motion(problem_, {*exact});
}

AccuracyMeter::~AccuracyMeter() = default;

AccuracyReading AccuracyMeter::errors_at(const SceneModel& model, double t_s) const {
  const auto states = states_until(*model.motion, choice_.method, t_s);
  AccuracyReading reading;
  if (exact_) reading.error = error_of(states.back(), exact_->at(t_s));
  reading.drift = drift_along(problem_, states);
  return reading;
}

AccuracyReading AccuracyMeter::at(const SceneModel& model, double t_s) const {
  AccuracyReading reading = errors_at(model, t_s);
  reading.ns_per_frame = ns_per_frame(model, problem_, choice_, model.motion->at(t_s));
  return reading;
}

}  // namespace polhode
