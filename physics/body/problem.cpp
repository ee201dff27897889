// SPDX-License-Identifier: MIT
#include "physics/body/problem.h"

#include <stdexcept>

namespace polhode {

Problem checked(const Problem& problem) {
  if (!is_finite(problem.torque)) throw std::domain_error("torque is not finite");
  return {problem.I, checked(problem.start), problem.torque};
}

}  // namespace polhode
