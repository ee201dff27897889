// SPDX-License-Identifier: MIT
// polhode trace: the numbers of a motion, row by row.
#include "app/commands.h"
#include "app/numbers.h"
#include "app/trace_motion.h"
#include "app/trace_times.h"
#include "app/usage.h"
#include "physics/euler.h"
#include "render/scene/scene.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace polhode {

namespace {

/// As typed; empty where not given.
struct TypedOptions {
  std::string inertia, omega, attitude, method, step, format;
  std::vector<std::string> torques;
  TypedTimes times;
};

constexpr std::array<std::string_view, 13> kColumns = {"t",  "w1", "w2", "w3", "qw", "qx", "qy",
                                                       "qz", "T",  "L",  "Lx", "Ly", "Lz"};
using Row = std::array<double, kColumns.size()>;

Quat attitude_from(const std::string& text) {
  if (text.empty()) return Quat::Identity();
  const std::vector<double> wxyz = finite_numbers("--attitude", text);
  if (wxyz.size() != 4)
    throw CommandError(ExitCode::usage, fmt::format("--attitude: \"{}\" has {} numbers; w,x,y,z are needed",
                                                    text, wxyz.size()));
  return Quat(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
}

TorqueTerm torque_term_from(const std::string& text) {
  const std::variant<TorqueTerm, std::string> read = parse_torque_term(text);
  if (const auto* term = std::get_if<TorqueTerm>(&read)) return *term;

  // Numbers that can be read but are infinite or NaN are no mistake of writing: no such torque can be.
  for (std::string_view part : split(std::string_view(text).substr(text.find(':') + 1), ','))
    if (const auto number = parse_number(part); number && !std::isfinite(*number))
      throw CommandError(ExitCode::invalid, fmt::format("--torque: {} is not a finite number", part));
  throw CommandError(ExitCode::usage, fmt::format("--torque: {}", std::get<std::string>(read)));
}

TracedBody body_from(const TypedOptions& typed) {
  const Vec3 I = finite_vector("--inertia", typed.inertia);
  const Vec3 w_B = finite_vector("--omega", typed.omega);
  const Quat q_SB = attitude_from(typed.attitude);
  Torque torque;
  for (const std::string& text : typed.torques) torque.push_back(torque_term_from(text));
  return {PrincipalMoments(I[0], I[1], I[2]), checked({q_SB, w_B}), std::move(torque)};
}

Row row_at(const TracedBody& body, const Motion& motion, double t_s) {
  const RigidBodyState state = motion.at(t_s);
  const Vec3& w = state.w_B;
  const Quat& q = state.q_SB;
  const Vec3 L_B = angular_momentum_B(body.I, w);
  const Vec3 L_S = angular_momentum_S(body.I, state);
  return {t_s,        w[0],   w[1],   w[2],  q.w(), q.x(), q.y(), q.z(), kinetic_energy(body.I, w),
          L_B.norm(), L_S[0], L_S[1], L_S[2]};
}

/// Whether the motion has overflowed: what it cannot compute is NaN from ω on.
bool overflowed(const Row& row) {
  return !std::all_of(&row[1], &row[8], [](double x) { return std::isfinite(x); });
}

/// Both return the first time whose row could not be computed.
std::optional<double> print_csv(const TracedBody& body, const Motion& motion, const TraceTimes& times) {
  std::optional<double> overflow_s;
  fmt::print("{}\n", fmt::join(kColumns, ","));
  for (std::int64_t i = 0; i < times.count(); ++i) {
    const Row row = row_at(body, motion, times(i));
    fmt::print("{:.17g}\n", fmt::join(row, ","));
    if (!overflow_s && overflowed(row)) overflow_s = times(i);
  }
  return overflow_s;
}

std::string number_or_null(double value) { return std::isfinite(value) ? digits17(value) : "null"; }

std::optional<double> print_json(const TracedBody& body, const Motion& motion, const TraceTimes& times) {
  std::optional<double> overflow_s;
  fmt::print("{{\"method\":\"{}\",\"period\":{},\"condition\":null,", motion.method(),
             number_or_null(period_s(body).value_or(NAN)));
  fmt::print("\"horizon_periods\":{{\"1e-3\":null,\"1e-1\":null}},\n\"rows\":[");
  for (std::int64_t i = 0; i < times.count(); ++i) {
    const Row row = row_at(body, motion, times(i));
    if (!overflow_s && overflowed(row)) overflow_s = times(i);
    fmt::print("{}\n{{", i == 0 ? "" : ",");
    for (std::size_t c = 0; c < row.size(); ++c)
      fmt::print("{}\"{}\":{}", c == 0 ? "" : ",", kColumns[c], number_or_null(row[c]));
    fmt::print("}}");
  }
  fmt::print("\n]}}\n");
  return overflow_s;
}

bool wants_json(const std::string& format) {
  if (!format.empty() && format != "csv" && format != "json")
    throw CommandError(ExitCode::usage, fmt::format("--format: \"{}\" is neither csv nor json", format));
  return format == "json";
}

ExitCode trace(const TypedOptions& typed) {
  const bool json = wants_json(typed.format);
  const TracedBody body = body_from(typed);
  std::optional<double> step_s;
  if (!typed.step.empty()) step_s = finite_number("--step", typed.step);
  const TracedMotion traced = traced_motion(body, typed.method, step_s);
  const TraceTimes times = trace_times(typed.times, counted_period_s(body));
  if (traced.max_time_s && times.furthest_s() > *traced.max_time_s)
    throw CommandError(ExitCode::usage,
                       fmt::format("{:.6g} s is further than the {:.6g} s that rk4 reaches with this "
                                   "step; give a larger --step",
                                   times.furthest_s(), *traced.max_time_s));

  if (!traced.note.empty()) fmt::print(stderr, "polhode: {}\n", traced.note);
  const auto overflow_s =
      json ? print_json(body, *traced.motion, times) : print_csv(body, *traced.motion, times);
  if (overflow_s)
    throw CommandError(ExitCode::failed,
                       fmt::format("the motion cannot be computed at t = {:.6g} s: torque, speed or "
                                   "step is too large",
                                   *overflow_s));
  return ExitCode::done;
}

}  // namespace

void add_trace(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("trace", "Print the numbers of a motion as CSV or JSON");
  auto typed = std::make_shared<TypedOptions>();
  const auto option = [&](const char* name, std::string& value, const char* form, const char* text) {
    return command->add_option(name, value, text)->option_text(form)->check(refuse_empty);
  };
  option("--inertia", typed->inertia, "I1,I2,I3", "principal moments in kg m^2 (required)")->required();
  option("--omega", typed->omega, "w1,w2,w3", "angular velocity at t = 0 in rad/s, body axes (required)")
      ->required();
  option("--attitude", typed->attitude, "w,x,y,z", "body to space at t = 0, quaternion (default: 1,0,0,0)");
  command->add_option("--torque", typed->torques, "a torque, see below; repeat to add more (default: none)")
      ->option_text("SPEC")
      ->allow_extra_args(false);
  option("--times", typed->times.times, "t1,t2,...", "these times in s, in this order");
  option("--from", typed->times.from, "A", "or: from A s ...");
  option("--to", typed->times.to, "B", "... to B s ...");
  option("--every", typed->times.every, "D", "... every D s");
  option("--periods", typed->times.periods, "P",
         "or: over P polhode periods; of none, of turns 2 pi/|omega| ...");
  option("--samples", typed->times.samples, "N", "... N rows, 2 or more, both ends included");
  option("--method", typed->method, "NAME",
         "exact, uniform, symmetric or rk4 (default: exact if it can, else rk4)");
  option("--step", typed->step, "H", "step of rk4 in s (default: 1/2000 of the period or of a turn)");
  option("--format", typed->format, "csv|json", "form of the result (default: csv)");
  command->footer(
      "Torques: space:x,y,z and body:x,y,z in N m, heavy:MGR,ax,ay,az (gravity along -z of space, MGR in\n"
      "N m, centre of mass along that body axis), damping:C in N m s, sink:C (energy lost at constant L).\n"
      "Columns: t in s; w1 w2 w3 in rad/s, body axes; qw qx qy qz body to space; T in J; L = |L|;\n"
      "Lx Ly Lz in kg m^2/s, space axes. 17 significant digits.");
  command->callback([typed, &action] { action = [typed] { return trace(*typed); }; });
}

}  // namespace polhode
