// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/derivation_check.h"

#include "lessons/derivation/decided.h"
#include "lessons/reader/checks/lint_budget.h"

#include <algorithm>
#include <string>
#include <vector>

namespace polhode {

void check_derivation(const Ask& ask, const Derivation& derivation, const Prover& prover, Report& report,
                      const Effort& effort) {
  const auto check_line = [&](const DerivedLine& line, const char* which) {
    for (const Equality& link : line.links) {
      spend(effort, kClaimLineEvaluations + kClaimNodeEvaluations * nodes_in(link));
      if (is_provable(link) && prover.settle(link, derivation.laws, derivation.given) == Verdict::holds)
        continue;
      report.error(
          ask.place,
          "the " + std::string(which) + " of question " + in_quotes(ask.id) + " does not hold: " + line.typed,
          "modulo = \"motion\" lets it use Euler's law, \"free\" that there is no torque");
      return false;
    }
    return true;
  };
  bool all = check_line(derivation.start, "start") && check_line(derivation.goal, "goal");
  for (const DerivedLine& fact : derivation.facts) all = all && check_line(fact, "fact");
  for (const WorkedLine& worked : derivation.worked) all = all && check_line(worked.line, "solution");
  Derivation unsolved = derivation;  // no line is decided by being one of the solution
  unsolved.worked.clear();
  for (const WorkedLine& worked : derivation.worked)
    for (const Equality& link : worked.line.links)
      if (all && !is_decided(link, unsolved, prover))
        report.error(ask.place,
                     "a line of the solution of question " + in_quotes(ask.id) +
                         " would hold with any factor, for both its sides are 0: " + worked.line.typed,
                     "write each term as what was put in for it, (I2 - I3) w1 w2 w3 for I1 w1 w1'");
  if (all && !is_goal(derivation, derivation.worked.back().line, prover))
    report.error(ask.place,
                 "the last line of the solution of question " + in_quotes(ask.id) + " is not its goal",
                 "it says the same in the goal's quantities");
  const std::vector<WorkedLine>& worked = derivation.worked;
  const auto first_goal = std::find_if(worked.begin(), worked.end(), [&](const WorkedLine& one) {
    return is_goal(derivation, one.line, prover);
  });
  if (all && first_goal < worked.end() - 1)
    report.warning(
        ask.place,
        "the solution of question " + in_quotes(ask.id) +
            " is at its goal before its last line, and nobody sees the rest: " + first_goal->line.typed,
        "leave out this line or those behind it, or make one line of them: a = b = c");
}

}  // namespace polhode
