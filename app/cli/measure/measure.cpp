// SPDX-License-Identifier: MIT
// polhode measure: what speed costs in accuracy, of every method for one motion, or of pictures.
#include "app/cli/commands/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/lesson_lookup.h"
#include "app/cli/measure/measure_rendering.h"
#include "app/cli/measure/measure_report.h"
#include "app/cli/measure/work_precision_plot.h"
#include "app/cli/message.h"
#include "app/cli/numbers.h"
#include "app/cli/or_fail.h"
#include "app/cli/progress.h"
#include "app/cli/trace/trace_motion.h"
#include "app/cli/typed_problem.h"
#include "app/export/plot_file.h"
#include "base/files/atomic_file.h"
#include "base/spelling.h"
#include "physics/analysis/characteristic_time.h"
#include "physics/method_facts.h"
#include "render/scene/model/model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace polhode {

namespace {

/// As typed; empty where not given.
struct TypedOptions {
  std::string lesson, stage;
  TypedProblem problem;
  std::string periods, tolerance, seconds;
  std::vector<std::string> methods;
  std::string csv, plot;
  bool json = false, all = false, rendering = false;
};

const Scene& chosen_scene(const Lesson& lesson, const TypedOptions& typed) {
  if (typed.stage.empty())
    throw usage(fmt::format("--stage is needed: which scene of \"{}\"; see: polhode info {}", lesson.id,
                            typed.lesson));
  return scene_of(lesson, typed.stage);
}

Problem chosen_problem(const TypedOptions& typed) {
  if (!typed.lesson.empty()) {
    if (names_a_body(typed.problem))
      throw usage("either a LESSON with --stage, or --inertia and --omega: not both");
    return checked(problem_of(chosen_scene(or_fail(load_lesson(typed.lesson)).lesson, typed)));
  }
  if (!typed.stage.empty()) throw usage("--stage is of a LESSON, and none is given");
  if (typed.problem.inertia.empty() || typed.problem.omega.empty())
    throw usage("what to measure is needed: --inertia and --omega, or a LESSON with --stage");
  return problem_from(typed.problem);
}

double positive(const char* option, const std::string& text, double otherwise) {
  if (text.empty()) return otherwise;
  const double value = finite_number(option, text);
  if (!(value > 0)) throw usage(fmt::format("{}: {} is not > 0", option, text));
  return value;
}

std::vector<Method> chosen_methods(const Problem& problem, const std::vector<std::string>& names) {
  std::vector<Method> methods;
  for (const std::string& name : names.empty() ? serving_methods(problem) : names)
    methods.push_back(serving_method(problem, name));
  return methods;
}

WorkPrecisionPlan plan_of(const Problem& problem, const TypedOptions& typed) {
  const WorkPrecisionPlan usual;
  WorkPrecisionPlan plan;
  plan.period_s = characteristic_time(problem).value_or(0);
  if (!(plan.period_s > 0)) throw usage("a body at rest has no period to count");
  plan.periods = positive("--periods", typed.periods, usual.periods);
  plan.cpu_seconds = positive("--seconds", typed.seconds, usual.cpu_seconds);
  plan.methods = chosen_methods(problem, typed.methods);
  return plan;
}

WorkPrecision measured(const Problem& problem, const WorkPrecisionPlan& plan) {
  const ProgressBar bar(static_cast<std::int64_t>(plan.methods.size()));
  return or_fail(measure_work_precision(problem, plan, [&](std::size_t i) {
    bar.show(static_cast<std::int64_t>(i), name_of(plan.methods[i]));
  }));
}

void print_notes(const Problem& problem, const WorkPrecisionPlan& plan, const WorkPrecision& found) {
  const std::string reference = closed_form(problem)
                                    ? "the closed form"
                                    : fmt::format("dormand-prince-8 at tolerance {:g}", kReferenceTolerance);
  say("polhode: {:g} {} of {:.6g} s, against {}, itself good to about {:.0e}\n", plan.periods,
      polhode_period(problem) ? "polhode periods" : "turns 2 pi/|omega|", plan.period_s, reference,
      found.reference_error);
  if (found.out_of_reach.empty()) return;
  std::vector<std::string_view> names;
  for (Method method : found.out_of_reach) names.push_back(name_of(method));
  say("polhode: left out, too many steps for --seconds {:g} even when they are long: {}; more reach "
      "further\n",
      plan.cpu_seconds, fmt::join(names, ", "));
}

void print_result(const MeasureReport& report, const TypedOptions& typed) {
  if (typed.json)
    fmt::print("{}", json_text(report));
  else
    fmt::print(
        "{}\n* no row is both faster and more accurate (Pareto front); + none that goes step by step;\n"
        "  no mark: an error of {:g} or more is no answer\n{}",
        table_text(report, typed.all), kNoAnswer, advice_text(report));
}

ExitCode measure_motion(const TypedOptions& typed) {
  const Problem problem = chosen_problem(typed);
  const WorkPrecisionPlan plan = plan_of(problem, typed);
  MeasureReport report;
  if (!typed.tolerance.empty()) report.tolerance = positive("--tolerance", typed.tolerance, 0);

  const WorkPrecision found = measured(problem, plan);
  print_notes(problem, plan, found);
  report.rows = found.rows;
  report.period_s = plan.period_s;
  report.periods = plan.periods;
  report.unit = polhode_period(problem) ? "periods" : "turns";
  if (report.tolerance) report.recommended = cheapest_within(report.rows, *report.tolerance);

  print_result(report, typed);
  if (!typed.csv.empty()) or_fail(write_file_atomically(typed.csv, bytes_of(csv_text(report.rows))));
  if (!typed.plot.empty()) or_fail(write_plot(typed.plot, plot_of(report, problem)));
  return ExitCode::done;
}

ExitCode measure_pictures(const TypedOptions& typed) {
  const bool of_motion = names_a_body(typed.problem) || !typed.periods.empty() || !typed.methods.empty() ||
                         !typed.seconds.empty();
  if (of_motion || typed.all)
    throw usage("--rendering goes with LESSON, --stage, --tolerance, --csv, --plot and --json alone");
  if (typed.lesson.empty() && !typed.stage.empty()) throw usage("--stage is of a LESSON, and none is given");

  RenderingRequest request;
  request.scene = usual_rendering_scene();
  request.of = "Poinsot's construction";
  if (!typed.lesson.empty()) {
    const LoadedLesson loaded = or_fail(load_lesson(typed.lesson));
    request.scene = chosen_scene(loaded.lesson, typed);
    request.of = fmt::format("stage {} of {}", typed.stage, loaded.lesson.id);
  }
  if (!typed.tolerance.empty()) request.tolerance = positive("--tolerance", typed.tolerance, 0);
  request.csv = typed.csv;
  request.plot = typed.plot;
  request.json = typed.json;
  return measure_rendering(request);
}

/// Said before seconds of measuring, and not after them.
void check_files(const TypedOptions& typed) {
  if (!typed.plot.empty() && !typed.plot.ends_with(".png"))
    throw usage(fmt::format("--plot {}: the name has to end in .png", typed.plot));
  for (const std::string& file : {typed.csv, typed.plot}) {
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    std::error_code error;
    if (!folder.empty() && !std::filesystem::is_directory(folder, error))
      throw CommandError(ExitCode::failed,
                         fmt::format("cannot write {}: there is no folder {}", file, folder.string()));
  }
}

ExitCode measure(const TypedOptions& typed) {
  check_files(typed);
  return typed.rendering ? measure_pictures(typed) : measure_motion(typed);
}

}  // namespace

ProgramCommand measure_command() {
  const auto typed = std::make_shared<TypedOptions>();
  ProgramCommand command = {
      "measure",
      "Speed against accuracy: of methods, or of pictures",
      {{"LESSON", &typed->lesson, "Id or file, with --stage; or:", " ", false, offer_lessons()},
       {"--stage", &typed->stage, "the stage whose last scene is measured, or STAGE:STEP", "STAGE[:STEP]"}}};
  const auto add = [&](const std::vector<CommandOption>& options) {
    command.options.insert(command.options.end(), options.begin(), options.end());
  };
  add(problem_options(typed->problem, false));
  add({{"--periods", &typed->periods, "after N polhode periods; of none, of turns (default: 100)", "N"},
       {"--tolerance", &typed->tolerance, "recommend the cheapest with both errors at most E (pictures: rms)",
        "E"},
       {"--method", &typed->methods, "this method; repeat for more (default: all that serve)", "NAME", false,
        offer(method_names())},
       {"--seconds", &typed->seconds, "spend about S seconds of CPU time on it (default: 8)", "S"},
       {"--all", &typed->all, "every row in the table"},
       {"--csv", &typed->csv, "write every row to this file as CSV", "F", false, offer_files()},
       {"--plot", &typed->plot, "draw the work-precision diagram, 1920x1080", "F.png", false, offer_files()},
       {"--json", &typed->json, "every row and the recommended one as JSON, instead of the table"},
       {"--rendering", &typed->rendering,
        "measure pictures instead: qualities against time (1.4 GB of memory)"}});
  command.footer = fmt::format(
      "{}\n"
      "Errors: at the end, of omega relative to its length, of attitude as an angle in rad, against the\n"
      "closed form; under a torque against a tight Dormand-Prince 8. Never said to be below what that\n"
      "itself is good to: the closed form to 2^-53 (4 + 5 (|omega| + |L|/I2) t + condition * periods),\n"
      "whose condition number trace tells.\n"
      "Drifts: the largest on the way, relative, of T and |L|; of the direction of L in space in rad; - or\n"
      "null where the torque does not keep them. What could not be computed is - or null too.\n"
      "Steps are halved from a tenth of a period, tolerances divided by ten from 1e-3, until rounding ends\n"
      "the gain or the time is spent; what even with the longest cannot reach the end in time is left out.\n"
      "CPU time a period: median, from nothing to the state at the end.",
      kTorqueHelp);
  command.run = [typed](const CommandWords&) { return measure(*typed); };
  return command;
}

}  // namespace polhode
