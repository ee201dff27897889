// SPDX-License-Identifier: MIT
#include "tests/bench/table.h"

#include <fmt/core.h>

namespace polhode::bench {
namespace {

constexpr const char* kLine = "{:<76}{:>9}  {:<22}{:<19}{}\n";

std::string number(double x) { return fmt::format("{:.3g}", x); }

std::string words(const Goal& goal) {
  const std::string sign = goal.sense == Goal::Sense::at_most ? "≤ " : "≥ ";
  return sign + number(goal.value) + (goal.stretch ? " (stretch " + number(*goal.stretch) + ")" : "");
}

bool meets(Goal::Sense sense, double bound, double x) {
  return sense == Goal::Sense::at_most ? x <= bound : x >= bound;
}

std::string verdict(const Goal& goal, double x) {
  if (!meets(goal.sense, goal.value, x)) return "FALLS SHORT";
  return goal.stretch && meets(goal.sense, *goal.stretch, x) ? "holds, stretch too" : "holds";
}

}  // namespace

void print_row_heading() {
  fmt::print(kLine, "benchmark", "measured", "[quartiles]", "goal", "verdict");
  fmt::print("{:-<144}\n", "");
}

void print(const Row& row) {
  const auto& m = row.measured;
  fmt::print(kLine, row.benchmark, m ? number(m->median) : "-",
             m ? "[" + number(m->low) + ", " + number(m->high) + "]" : "", row.goal ? words(*row.goal) : "",
             !m          ? "NOT MEASURED"
             : !row.goal ? "for information"
                         : verdict(*row.goal, m->median));
  if (!row.note.empty()) fmt::print("    {}\n", row.note);
  std::fflush(stdout);
}

}  // namespace polhode::bench
