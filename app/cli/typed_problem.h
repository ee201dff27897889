// SPDX-License-Identifier: MIT
// A body, its state and the torque on it, from the command line: what `trace` and `measure` share.
#pragma once

#include "app/cli/command_line.h"
#include "physics/body/problem.h"

#include <string>
#include <vector>

namespace polhode {

/// As typed; empty where not given.
struct TypedProblem {
  std::string inertia, omega, attitude;
  std::vector<std::string> torques;
};

/// --inertia, --omega, --attitude and --torque; `typed` must outlive the reading of the line.
std::vector<CommandOption> problem_options(TypedProblem& typed, bool required);

/// What the forms of --torque mean, for the end of the help.
extern const char* const kTorqueHelp;

/// Whether any of the options was given.
bool names_a_body(const TypedProblem& typed);

/// @throws CommandError usage: malformed; invalid: not finite. std::domain_error: an impossible body or state
Problem problem_from(const TypedProblem& typed);

}  // namespace polhode
