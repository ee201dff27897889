// SPDX-License-Identifier: MIT
// polhode trace: the numbers of a motion, row by row.
#include "app/cli/commands.h"
#include "app/cli/message.h"
#include "app/cli/trace/trace_motion.h"
#include "app/cli/trace/trace_times.h"
#include "app/cli/typed_problem.h"
#include "app/export/trace/trace_rows.h"
#include "base/numbers.h"
#include "physics/analysis/characteristic_time.h"
#include "physics/analysis/horizon.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace polhode {

namespace {

/// As typed; empty where not given.
struct TypedOptions {
  TypedProblem problem;
  TypedMethod method;
  TypedTimes times;
  std::string format;
};

constexpr const char* kMethodHelp =
    "Methods: exact, uniform, symmetric (closed forms); with a fixed step explicit-euler,\n"
    "explicit-midpoint, rk4, rk4-projected, splitting, implicit-midpoint (Cayley attitude),\n"
    "implicit-midpoint-exp, moser-veselov-2, moser-veselov-6, moser-veselov-10; adaptive\n"
    "dormand-prince-5, dormand-prince-8.";

/// Both return the first time whose row could not be computed.
std::optional<double> print_csv(const Problem& problem, const Motion& motion, const TraceTimes& times) {
  std::optional<double> overflow_s;
  fmt::print("{}", trace_csv_header());
  for (std::int64_t i = 0; i < times.count(); ++i) {
    const TraceRow row = trace_row(problem, motion, times(i));
    fmt::print("{}", csv_line(row));
    if (!overflow_s && overflowed(row)) overflow_s = times(i);
  }
  return overflow_s;
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

std::optional<double> print_json(const Problem& problem, const Motion& motion, const TraceTimes& times) {
  std::optional<double> overflow_s;
  fmt::print("{{\"method\":\"{}\",\"period\":{},{},\n\"rows\":[", motion.method(),
             number_or_null(polhode_period(problem).value_or(NAN)), json_members(horizon_of(problem)));
  for (std::int64_t i = 0; i < times.count(); ++i) {
    const TraceRow row = trace_row(problem, motion, times(i));
    if (!overflow_s && overflowed(row)) overflow_s = times(i);
    fmt::print("{}\n{{", i == 0 ? "" : ",");
    for (std::size_t c = 0; c < row.size(); ++c)
      fmt::print("{}\"{}\":{}", c == 0 ? "" : ",", kTraceColumns[c], number_or_null(row[c]));
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

void check_reach(const Motion& motion, const TraceTimes& times) {
  if (times.furthest_s() <= motion.max_time_s()) return;
  throw CommandError(ExitCode::usage,
                     fmt::format("{:.6g} s is further than the {:.6g} s that {} reaches with this step or "
                                 "tolerance; give a larger --step or --tolerance",
                                 times.furthest_s(), motion.max_time_s(), motion.method()));
}

void print_note(const std::string& note) {
  if (!note.empty()) say("polhode: {}\n", note);
}

ExitCode trace(const TypedOptions& typed) {
  const bool json = wants_json(typed.format);
  const Problem problem = problem_from(typed.problem);
  const TracedMotion traced = traced_motion(problem, typed.method);
  const TraceTimes times = trace_times(typed.times, characteristic_time(problem).value_or(0));
  check_reach(*traced.motion, times);

  print_note(traced.note);
  if (!json) print_note(sentence(horizon_of(problem)));
  const auto overflow_s =
      json ? print_json(problem, *traced.motion, times) : print_csv(problem, *traced.motion, times);
  if (overflow_s)
    throw CommandError(ExitCode::failed,
                       fmt::format("the motion cannot be computed at t = {:.6g} s: {}", *overflow_s,
                                   why_no_state(*traced.motion, problem, *overflow_s)));
  return ExitCode::done;
}

}  // namespace

Command trace_command() {
  const auto typed = std::make_shared<TypedOptions>();
  Command command = {"trace", "Print the numbers of a motion as CSV or JSON",
                     problem_options(typed->problem, true)};
  command.options.insert(
      command.options.end(),
      {{"--times", &typed->times.times, "these times in s, in this order", "t1,t2,..."},
       {"--from", &typed->times.from, "or: from A s ...", "A"},
       {"--to", &typed->times.to, "... to B s ...", "B"},
       {"--every", &typed->times.every, "... every D s", "D"},
       {"--periods", &typed->times.periods, "or: over P polhode periods; of none, of turns 2 pi/|omega| ...",
        "P"},
       {"--samples", &typed->times.samples, "... N rows, 2 or more, both ends included", "N"},
       {"--method", &typed->method.method,
        "see below (default: exact without torque, dormand-prince-8 with one)", "NAME"},
       {"--step", &typed->method.step, "step in s, needed by methods with a fixed one", "H"},
       {"--tolerance", &typed->method.tolerance, "of dormand-prince-5 and -8 (default: 1e-10)", "E"},
       {"--format", &typed->format, "form of the result (default: csv)", "csv|json"}});
  command.footer = fmt::format(
      "{}\n{}\n"
      "Columns: t in s; w1 w2 w3 in rad/s, body axes; qw qx qy qz body to space; T in J; L = |L|;\n"
      "Lx Ly Lz in kg m^2/s, space axes. 17 significant digits.",
      kMethodHelp, kTorqueHelp);
  command.run = [typed](const CommandWords&) { return trace(*typed); };
  return command;
}

}  // namespace polhode
