// SPDX-License-Identifier: MIT
// The table the bench prints.
#pragma once

#include "tests/bench/timing.h"

#include <optional>
#include <string>
#include <vector>

namespace polhode::bench {

struct Goal {
  enum class Sense { at_most, at_least };
  Sense sense = Sense::at_least;
  double value = 1;
  std::optional<double> stretch;
};
inline Goal at_most(double value, std::optional<double> stretch = {}) {
  return {Goal::Sense::at_most, value, stretch};
}
inline Goal at_least(double value, std::optional<double> stretch = {}) {
  return {Goal::Sense::at_least, value, stretch};
}

struct Row {
  std::string benchmark;
  std::optional<Spread> measured;  ///< none: the note says why
  std::optional<Goal> goal;        ///< none: for information
  std::string note;                ///< what stands behind the ratio, on the line below
};

void print_row_heading();
void print(const Row& row);

}  // namespace polhode::bench
