// SPDX-License-Identifier: MIT
#include "app/cli/typed_problem.h"

#include "app/cli/exit_codes.h"
#include "app/cli/numbers.h"
#include "base/numbers.h"
#include "physics/body/torque_text.h"

#include <fmt/format.h>

#include <cmath>

namespace polhode {

namespace {

Quat attitude_from(const std::string& text) {
  if (text.empty()) return Quat::Identity();
  const std::vector<double> wxyz = finite_numbers("--attitude", text);
  if (wxyz.size() != 4)
    throw CommandError(ExitCode::usage, fmt::format("--attitude: \"{}\" has {} numbers; w,x,y,z are needed",
                                                    text, wxyz.size()));
  return Quat(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
}

TorqueTerm torque_term_from(const std::string& text) {
  const Result<TorqueTerm> read = parse_torque_term(text);
  if (read) return *read;

  // Numbers that can be read but are infinite or NaN are no mistake of writing: no such torque can be.
  for (std::string_view part : split(std::string_view(text).substr(text.find(':') + 1), ','))
    if (const auto number = parse_number(part); number && !std::isfinite(*number))
      throw CommandError(ExitCode::invalid, fmt::format("--torque: {} is not a finite number", part));
  throw CommandError(ExitCode::usage, fmt::format("--torque: {}", read.error()));
}

}  // namespace

const char* const kTorqueHelp =
    "Torques: space:x,y,z and body:x,y,z in N m, heavy:MGR,ax,ay,az (gravity along -z of space, MGR in\n"
    "N m, centre of mass along that body axis), damping:C in N m s, sink:C (energy lost at constant L).";

std::vector<CommandOption> problem_options(TypedProblem& typed, bool required) {
  const std::string mark = required ? " (required)" : "";
  return {
      {"--inertia", &typed.inertia, "principal moments in kg m^2" + mark, "I1,I2,I3", required},
      {"--omega", &typed.omega, "angular velocity at t = 0 in rad/s, body axes" + mark, "w1,w2,w3", required},
      {"--attitude", &typed.attitude, "body to space at t = 0, quaternion (default: 1,0,0,0)", "w,x,y,z"},
      {"--torque", &typed.torques, "a torque, see below; repeat to add more (default: none)", "SPEC"}};
}

bool names_a_body(const TypedProblem& typed) {
  return !typed.inertia.empty() || !typed.omega.empty() || !typed.attitude.empty() || !typed.torques.empty();
}

Problem problem_from(const TypedProblem& typed) {
  const Vec3 I = finite_vector("--inertia", typed.inertia);
  const Vec3 w_B = finite_vector("--omega", typed.omega);
  const Quat q_SB = attitude_from(typed.attitude);
  Torque torque;
  for (const std::string& text : typed.torques) torque.push_back(torque_term_from(text));
  return checked(Problem{PrincipalMoments(I[0], I[1], I[2]), {q_SB, w_B}, std::move(torque)});
}

}  // namespace polhode
