// SPDX-License-Identifier: MIT
// The trade between speed and accuracy of the motion that is shown: what it costs and how wrong it is now,
// and what the other methods would cost, measured on the spot.
#pragma once

#include "app/work_precision.h"
#include "physics/motion_errors.h"
#include "render/scene/model.h"

#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// Of the present motion at t.
struct LiveTrade {
  std::optional<StateError>
      error;                ///< against the exact motion; absent with torque, and of what is exact itself
  InvariantDrift drift;     ///< from the start to t, over at most 64 times; NaN where nothing is kept
  double ns_per_frame = 0;  ///< CPU time to get from one shown frame to the next, measured
};

/// Keeps the exact motion of the model it was made for.
class TradeMeter {
 public:
  explicit TradeMeter(const SceneModel& model);
  ~TradeMeter();
  LiveTrade at(const SceneModel& model, double t_s) const;

 private:
  std::unique_ptr<const Motion> exact_;  ///< null: there is none, or the motion is exact
};

/// Steps of the Pareto front from fast to accurate, for one slider. `choice` is what to make the motion with.
struct ParetoStep {
  MethodChoice choice;
  double error = 0;  ///< the larger of ω's and the attitude's, at the end
  double ns_per_period = 0;
  std::string name;  ///< "rk4, step 0.02 s"
};

/// Measures in a thread of its own (no OpenGL in it); asked from the thread that made it.
class FrontMeasurement {
 public:
  /// `cpu_seconds` about; 10 periods (or turns).
  explicit FrontMeasurement(const Problem& problem, double cpu_seconds = 1.5);
  ~FrontMeasurement();  ///< waits for what it is measuring just now, at most some 0.1 s
  bool is_ready() const;
  /// Empty until it is ready, or if nothing could be measured. The closed form comes last.
  const std::vector<ParetoStep>& steps();

 private:
  std::future<std::vector<ParetoStep>> future_;
  std::vector<ParetoStep> steps_;
};

/// "needs: ω, attitude, polhode" and what it does not compute, in words, from requirements of the drawn
/// scene.
struct RequirementWords {
  std::vector<std::string> computed, left_out;
};
RequirementWords requirement_words(const SceneModel& model);

}  // namespace polhode
