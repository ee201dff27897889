// SPDX-License-Identifier: MIT
// polhode trace: the numbers of a motion, row by row.
#include "app/cli/commands/commands.h"
#include "app/cli/lesson_lookup.h"
#include "app/cli/message.h"
#include "app/cli/or_fail.h"
#include "app/cli/trace/trace_motion.h"
#include "app/cli/trace/trace_times.h"
#include "app/cli/typed_problem.h"
#include "app/export/trace/trace_rows.h"
#include "base/numbers.h"
#include "physics/analysis/characteristic_time.h"
#include "physics/analysis/horizon.h"
#include "physics/analysis/motion_errors.h"
#include "physics/method_facts.h"
#include "render/scene/model/scene_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace polhode {

namespace {

/// As typed; empty where not given.
struct TypedOptions {
  std::string lesson, stage;
  TypedProblem problem;
  TypedMethod method;
  TypedTimes times;
  std::string columns, format;
};

/// What is followed, and how it is told.
struct Trace {
  Problem problem;
  TracedMotion traced;
  TraceTimes times;
  TraceColumns columns;
};

constexpr const char* kMethodHelp =
    "Methods: exact, uniform, symmetric, lagrange-top (closed forms); with a fixed step explicit-euler,\n"
    "explicit-midpoint, rk4, rk4-projected, splitting, implicit-midpoint (Cayley attitude),\n"
    "implicit-midpoint-exp, moser-veselov-2, moser-veselov-6, moser-veselov-10; adaptive\n"
    "dormand-prince-5, dormand-prince-8.";

/// What is not all numbers: the first row without a state, or else the first with a column that is too large.
struct Overflow {
  double t_s;
  std::optional<std::string_view> column;  ///< none: no state
};

std::optional<Overflow> overflow_in(const Trace& trace, double t_s, const RigidBodyState& state,
                                    const TraceRow& row) {
  if (!is_finite(state)) return Overflow{t_s, {}};
  const auto large = std::find_if(row.begin(), row.end(), [](double value) { return !std::isfinite(value); });
  if (large == row.end()) return {};
  return Overflow{t_s, trace.columns[static_cast<std::size_t>(large - row.begin())].name};
}

/// Tells each row to `print`, and whether it has a state.
template <class Print>
std::optional<Overflow> for_each_row(const Trace& trace, const Print& print) {
  std::optional<Overflow> overflow;
  for (std::int64_t i = 0; i < trace.times.count(); ++i) {
    const double t_s = trace.times(i);
    const RigidBodyState state = trace.traced.motion->at(t_s);
    const TraceRow row = trace_row(trace.columns, trace.problem, t_s, state);
    const bool has_state = is_finite(state);
    if (!overflow || (overflow->column && !has_state)) {
      const auto here = overflow_in(trace, t_s, state, row);
      if (here) overflow = here;
    }
    print(i, row, has_state);
  }
  return overflow;
}

/// Rows without a state are left out.
std::optional<Overflow> print_csv(const Trace& trace) {
  fmt::print("{}", trace_csv_header(trace.columns));
  return for_each_row(trace, [](std::int64_t, const TraceRow& row, bool has_state) {
    if (has_state) fmt::print("{}", csv_line(row));
  });
}

std::string number_or_null(double value) { return std::isfinite(value) ? digits17(value) : "null"; }

/// One sentence, without a full stop; empty where there is no horizon.
std::string sentence(const Horizon& horizon) {
  if (!horizon.periods_1e_3 || !horizon.periods_1e_1) return "";
  return fmt::format(
      "prediction horizon: rounding of the inputs alone moves the phase by 1e-3 rad after {:.2g} periods, by "
      "1e-1 rad after {:.2g}",
      *horizon.periods_1e_3, *horizon.periods_1e_1);
}

/// `"condition":c,"horizon_periods":{"1e-3":n,"1e-1":n}`: members of a JSON object.
std::string json_members(const Horizon& horizon) {
  return fmt::format("\"condition\":{},\"horizon_periods\":{{\"1e-3\":{},\"1e-1\":{}}}",
                     number_or_null(horizon.condition.value_or(NAN)),
                     number_or_null(horizon.periods_1e_3.value_or(NAN)),
                     number_or_null(horizon.periods_1e_1.value_or(NAN)));
}

std::optional<Overflow> print_json(const Trace& trace) {
  const Problem& problem = trace.problem;
  fmt::print("{{\"method\":\"{}\",\"period\":{},{},\n\"rows\":[", trace.traced.motion->method(),
             number_or_null(polhode_period(problem).value_or(NAN)), json_members(horizon_of(problem)));
  const auto overflow = for_each_row(trace, [&](std::int64_t i, const TraceRow& row, bool) {
    fmt::print("{}\n{{", i == 0 ? "" : ",");
    for (std::size_t c = 0; c < row.size(); ++c)
      fmt::print("{}\"{}\":{}", c == 0 ? "" : ",", trace.columns[c].name, number_or_null(row[c]));
    fmt::print("}}");
  });
  fmt::print("\n]}}\n");
  return overflow;
}

bool wants_json(const std::string& format) {
  if (!format.empty() && format != "csv" && format != "json")
    throw CommandError(ExitCode::usage, fmt::format("--format: \"{}\" is neither csv nor json", format));
  return format == "json";
}

void check_reach(const Motion& motion, const TraceTimes& times) {
  if (!std::isfinite(times.furthest_s())) throw usage("there is a time that is too large for a double");
  if (times.furthest_s() <= motion.max_time_s()) return;
  throw CommandError(ExitCode::usage,
                     fmt::format("{:.6g} s is further than the {:.6g} s that {} reaches with this step or "
                                 "tolerance; give a larger --step or --tolerance",
                                 times.furthest_s(), motion.max_time_s(), motion.method()));
}

/// A sentence where the last time is further than the phase is known to 0.1 rad; else empty.
std::string beyond_horizon(const Trace& trace) {
  const Horizon horizon = horizon_of(trace.problem);
  const double furthest_s = trace.times.furthest_s();
  if (!horizon.periods_1e_1 ||
      furthest_s <= *horizon.periods_1e_1 * characteristic_time(trace.problem).value_or(0))
    return "";
  return fmt::format(
      "t = {:.6g} s is beyond the horizon: rounding of the inputs alone moves the phase by more than 0.1 rad "
      "there",
      furthest_s);
}

void print_note(const std::string& note) {
  if (!note.empty()) say("polhode: {}\n", note);
}

TraceColumns chosen_columns(const TypedOptions& typed) {
  if (typed.columns.empty()) return usual_trace_columns();
  auto columns = trace_columns_named(typed.columns);
  if (!columns) throw usage("--columns: " + columns.error());
  return std::move(columns).value();
}

Trace trace_of_lesson(const TypedOptions& typed) {
  if (names_a_body(typed.problem))
    throw usage("either a LESSON with --stage, or --inertia and --omega: not both");
  const LoadedLesson loaded = or_fail(load_lesson(typed.lesson));
  if (typed.stage.empty())
    throw usage(fmt::format("--stage is needed: which scene of \"{}\"; see: polhode info {}",
                            loaded.lesson.id, typed.lesson));
  const Scene& scene = scene_of(loaded.lesson, typed.stage);
  const Problem problem = checked(problem_of(scene));
  return {problem, traced_motion(problem, typed.method, scene.motion),
          trace_times(typed.times, characteristic_time(problem).value_or(0), span_s(scene)),
          chosen_columns(typed)};
}

Trace trace_of_body(const TypedOptions& typed) {
  if (!typed.stage.empty()) throw usage("--stage is of a LESSON, and none is given");
  if (typed.problem.inertia.empty() || typed.problem.omega.empty())
    throw usage("what to trace is needed: --inertia and --omega, or a LESSON with --stage");
  const Problem problem = problem_from(typed.problem);
  return {problem, traced_motion(problem, typed.method),
          trace_times(typed.times, characteristic_time(problem).value_or(0)), chosen_columns(typed)};
}

ExitCode trace(const TypedOptions& typed) {
  const bool json = wants_json(typed.format);
  const Trace trace = typed.lesson.empty() ? trace_of_body(typed) : trace_of_lesson(typed);
  const Motion& motion = *trace.traced.motion;
  check_reach(motion, trace.times);

  print_note(trace.traced.note);
  if (!json) print_note(sentence(horizon_of(trace.problem)));
  print_note(beyond_horizon(trace));
  const auto overflow = json ? print_json(trace) : print_csv(trace);
  if (!overflow) return ExitCode::done;
  if (overflow->column)
    throw CommandError(ExitCode::failed, fmt::format("{} at t = {:.6g} s is too large for a double",
                                                     *overflow->column, overflow->t_s));
  throw CommandError(ExitCode::failed,
                     fmt::format("the motion cannot be computed at t = {:.6g} s: {}", overflow->t_s,
                                 why_no_state(motion, trace.problem, overflow->t_s)));
}

}  // namespace

ProgramCommand trace_command() {
  const auto typed = std::make_shared<TypedOptions>();
  ProgramCommand command = {
      "trace",
      "Print the numbers of a motion as CSV or JSON",
      {{"LESSON", &typed->lesson, "Id or file, with --stage; or:", " ", false, offer_lessons()},
       {"--stage", &typed->stage, "its scene: the last of a stage, or that of a step, from 1",
        "STAGE[:STEP]"}}};
  const auto of_body = problem_options(typed->problem, false);
  command.options.insert(command.options.end(), of_body.begin(), of_body.end());
  command.options.insert(
      command.options.end(),
      {{"--times", &typed->times.times, "these times in s, in this order", "t1,t2,..."},
       {"--from", &typed->times.from, "or: from A s ...", "A"},
       {"--to", &typed->times.to, "... to B s ...", "B"},
       {"--every", &typed->times.every, "... every D s", "D"},
       {"--periods", &typed->times.periods,
        "or: over P polhode periods; of none, turns 2 pi/|omega|; with --samples", "P"},
       {"--samples", &typed->times.samples, "... or N rows, 2 or more, both ends included", "N"},
       {"--method", &typed->method.method, "see below (default: the scene's, or the best that serves)",
        "NAME", false, offer(method_names())},
       {"--step", &typed->method.step, "step in s, needed by methods with a fixed one", "H"},
       {"--tolerance", &typed->method.tolerance, "of dormand-prince-5 and -8 (default: 1e-10)", "E"},
       {"--columns", &typed->columns, "those to print, in this order, see below (default: t to Lz)",
        "NAME,..."},
       {"--format", &typed->format, "form of the result (default: csv)", "csv|json", false,
        offer({"csv", "json"})}});
  command.footer = fmt::format(
      "{}\n{}\n"
      "Times of a LESSON need not be said: 101 rows, or --samples N, over the duration of the scene.\n"
      "Without a method: exact without torque, lagrange-top for a symmetric top under its weight\n"
      "alone, dormand-prince-8 under any other torque.\n"
      "Columns: t in s; w1 w2 w3 in rad/s, body axes; qw qx qy qz body to space; T in J; L = |L|;\n"
      "Lx Ly Lz in kg m^2/s, space axes. If asked for also theta_deg phi_deg psi_deg, Euler's angles\n"
      "z-x-z (theta is that of axis 3 from the vertical; phi, psi from -180 to 180); e3x e3y e3z, axis 3\n"
      "in space; V in J, potential energy under gravity, zero at the height of the pivot; E = T + V.\n"
      "17 significant digits.",
      kMethodHelp, kTorqueHelp);
  command.run = [typed](const CommandWords&) { return trace(*typed); };
  return command;
}

}  // namespace polhode
