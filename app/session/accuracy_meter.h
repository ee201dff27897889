// SPDX-License-Identifier: MIT
// How wrong the motion that is shown is now, and what it costs.
#pragma once

#include "physics/analysis/motion_errors.h"
#include "physics/method.h"
#include "render/scene/model/model.h"

#include <memory>
#include <optional>

namespace polhode {

/// Of the present motion at t. Numbers are NaN where the motion cannot reach t.
struct AccuracyReading {
  std::optional<StateError>
      error;                ///< against the exact motion; absent with torque, and of what is exact itself
  InvariantDrift drift;     ///< from the start to t, over at most 64 times; NaN where nothing is kept
  double ns_per_frame = 0;  ///< CPU time to get from one shown frame (1/25 s) to the next, measured
};

/// Of one model. at() takes some 0.1 ms of CPU time (Dormand-Prince: 0.4 ms) once the way to t is known.
class AccuracyMeter {
 public:
  explicit AccuracyMeter(const SceneModel& model);
  ~AccuracyMeter();
  /// `model` is the one it was made for, or the same made anew.
  AccuracyReading at(const SceneModel& model, double t_s) const;
  /// The same without measuring what a frame costs, which is left 0.
  AccuracyReading errors_at(const SceneModel& model, double t_s) const;

 private:
  Problem problem_;
  MethodChoice choice_;
  std::unique_ptr<const Motion> exact_;  ///< null: there is none, or the motion is exact
};

}  // namespace polhode
