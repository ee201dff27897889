// SPDX-License-Identifier: MIT
// The trade between speed and accuracy of the motion that is shown: what the other methods would cost,
// measured on the spot.
#pragma once

#include "base/words/language.h"
#include "physics/analysis/work_precision.h"
#include "physics/method.h"

#include <atomic>
#include <future>
#include <string>
#include <vector>

namespace polhode {

/// Steps of the Pareto front from fast to accurate, for one slider. `choice` is what to make the motion with.
struct ParetoStep {
  MethodChoice choice;
  double error = 0;  ///< the larger of ω's and the attitude's, at the end
  double ns_per_period = 0;
};

/// "rk4, step 0.02 s".
std::string named_in(Language language, const MethodChoice& choice);

/// The front of the methods that go step by step, each step dearer and more accurate than the one before;
/// then the closed form, if it was measured.
std::vector<ParetoStep> pareto_steps(const std::vector<WorkPrecisionRow>& rows);

/// Measures in a thread of its own (no OpenGL in it); asked from the thread that made it.
class FrontMeasurement {
 public:
  /// `cpu_seconds` about; 10 periods (or turns). Of a body at rest nothing is measured.
  explicit FrontMeasurement(const Problem& problem, double cpu_seconds = 1.5);
  ~FrontMeasurement();  ///< waits until the method that it is measuring just now is done, some 0.2 s
  bool is_ready() const;
  /// Empty until it is ready, or if nothing could be measured. The closed form comes last.
  const std::vector<ParetoStep>& steps();

 private:
  std::atomic<bool> stopped_ = false;
  std::future<std::vector<ParetoStep>> future_;
  std::vector<ParetoStep> steps_;
};

}  // namespace polhode
