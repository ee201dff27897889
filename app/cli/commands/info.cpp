// SPDX-License-Identifier: MIT
// polhode info: what each scene requires, the motion chosen and why, what both cost, and the numbers of each
// motion.
#include "app/cli/commands/commands.h"
#include "app/cli/lesson_lookup.h"
#include "app/cli/or_fail.h"
#include "app/cli/scene_facts.h"
#include "app/export/json_values.h"
#include "base/angles.h"
#include "base/printable.h"
#include "base/stopwatch.h"
#include "lessons/reader/checks/lint_budget.h"
#include "physics/analysis/horizon.h"
#include "physics/effort.h"
#include "physics/exact/lagrange_top.h"
#include "physics/method.h"
#include "render/scene/model/model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace polhode {

namespace {

using Json = nlohmann::ordered_json;

struct StageInfo {
  const Stage* stage = nullptr;
  bool has_scene = false;
  std::vector<std::string> needs;
  std::string motion, why;
  double setup_ns = 0, call_ns = 0;
  Horizon horizon;
  std::vector<SceneFacts> scenes;
};

/// Time of one evaluation of what the scene asks for, at times spread over its span in no order.
double call_cost_ns(const SceneModel& model) {
  constexpr int kCalls = 64, kRepeats = 15;
  constexpr double kGolden = 0.6180339887498949;  // fractional parts of its multiples are spread evenly
  volatile double sink = 0;                       // keeps the calls from being optimised away
  const auto time = [&](int i) { return model.span_s * (i * kGolden - std::floor(i * kGolden)); };
  const auto evaluate = [&](double t_s) {
    return model.needs.attitude ? model.motion->at(t_s).w_B.x() : model.motion->w_B_at(t_s).x();
  };
  if (!model.needs.omega && !model.needs.attitude) return 0;
  const auto calls = [&] {
    for (int i = 1; i <= kCalls; ++i) sink = sink + evaluate(time(i));
  };
  return median_ns(kRepeats, calls) / kCalls;
}

/// Of all that it shows.
Requirements needs_of(const SceneModel& model) {
  Requirements needs = model.needs;
  for (const SceneModel& other : model.beside)
    for (const RequirementFacts& facts : requirement_facts()) needs.*facts.part |= other.needs.*facts.part;
  return needs;
}

/// Whatever the motion costs while it is asked is told to `effort`.
StageInfo info_of(const Stage& stage, const Effort& effort) {
  constexpr int kSetups = 5;
  StageInfo info;
  info.stage = &stage;
  const auto drawn = std::find_if(stage.steps.rbegin(), stage.steps.rend(),
                                  [](const Step& s) { return s.scene != nullptr; });
  if (drawn == stage.steps.rend()) return info;
  info.scenes = facts_of(stage);
  const auto set_up = [&] { return make_model(*drawn->scene, ModelFor::page, effort); };
  const SceneModel model = set_up();
  info.has_scene = true;
  info.needs = names_of(needs_of(model));
  info.motion = model.motion->method();
  info.why = model.why;
  info.setup_ns = median_ns(kSetups, [&] { static_cast<void>(set_up()); });
  info.call_ns = call_cost_ns(model);
  info.horizon = horizon_of(problem_of(*drawn->scene));
  return info;
}

/// What the closed form of a heavy top tells of its motion as a whole.
std::optional<TopFacts> means_of(const SceneFacts& facts) {
  if (closed_form(facts.problem) != Method::lagrange_top) return std::nullopt;
  return LagrangeTopMotion(facts.problem).facts();
}

Json to_json(const SceneFacts& facts) {
  const std::optional<TopFacts> means = means_of(facts);
  const Vec3& I = facts.body.moments.vector();
  const auto rate = [](const auto& from, auto member) {
    return from ? number_or_null((*from).*member) : Json(nullptr);
  };
  return {{"steps", {facts.first_step, facts.last_step}},
          {"body", facts.body.name},
          {"moments", {I[0], I[1], I[2]}},
          {"mass_kg", facts.body.mass_kg},
          {"T", facts.T},
          {"L", facts.L},
          {"period", number_or_null(facts.period_s)},
          {"free_precession",
           {{"in_space", rate(facts.free, &FreePrecession::in_space)},
            {"in_body", rate(facts.free, &FreePrecession::in_body)}}},
          {"heavy_top",
           {{"theta_deg", facts.theta_rad ? Json(*facts.theta_rad * kDegreesPerRadian) : Json(nullptr)},
            {"slow", rate(facts.steady, &SteadyPrecession::slow)},
            {"fast", rate(facts.steady, &SteadyPrecession::fast)},
            {"nutation", rate(facts.nutation, &Nutation::rate)},
            {"mean_precession", rate(means, &TopFacts::mean_precession)},
            {"mean_spin", rate(means, &TopFacts::mean_spin)},
            {"theta_least_deg",
             facts.nutation ? Json(facts.nutation->theta_least_rad * kDegreesPerRadian) : Json(nullptr)},
            {"theta_most_deg",
             facts.nutation ? Json(facts.nutation->theta_most_rad * kDegreesPerRadian) : Json(nullptr)}}}};
}

Json to_json(const StageInfo& info) {
  Json scenes = Json::array();
  for (const SceneFacts& facts : info.scenes) scenes.push_back(to_json(facts));
  const auto if_drawn = [&](Json value) { return info.has_scene ? std::move(value) : Json(nullptr); };
  return {{"id", info.stage->id},
          {"title", info.stage->title},
          {"steps", info.stage->steps.size()},
          {"requires", info.needs},
          {"motion", if_drawn(info.motion)},
          {"why", if_drawn(info.why)},
          {"setup_ns", if_drawn(std::round(info.setup_ns))},
          {"call_ns", if_drawn(std::round(info.call_ns * 10) / 10)},
          {"condition", number_or_null(info.horizon.condition)},
          {"horizon_periods",
           {{"1e-3", number_or_null(info.horizon.periods_1e_3)},
            {"1e-1", number_or_null(info.horizon.periods_1e_1)}}},
          {"scenes", std::move(scenes)}};
}

Json about_json(const Lesson& lesson) {
  const About& about = lesson.about;
  const auto text_or_null = [](const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); };
  Json references = Json::object();
  for (const Reference& reference : lesson.references) references[reference.key] = reference.text;
  return {{"author", about.authors},
          {"licence", text_or_null(about.licence)},
          {"language", tag_of(about.language)},
          {"outcomes", about.outcomes},
          {"prerequisites", about.prerequisites},
          {"next", text_or_null(about.next)},
          {"references", std::move(references)}};
}

std::string duration_text(double ns) {
  if (ns < 1e3) return fmt::format("{:.0f} ns", ns);
  return ns < 1e6 ? fmt::format("{:.1f} us", ns / 1e3) : fmt::format("{:.1f} ms", ns / 1e6);
}

/// The number of a reason in the list of reasons, from 1; adds it if it is new.
std::size_t reason_number(std::vector<std::string>& reasons, const std::string& why) {
  const auto known = std::find(reasons.begin(), reasons.end(), why);
  if (known != reasons.end()) return static_cast<std::size_t>(known - reasons.begin()) + 1;
  reasons.push_back(why);
  return reasons.size();
}

void print_row(const StageInfo& info, std::size_t width, std::vector<std::string>& reasons) {
  if (!info.has_scene) {
    fmt::print("{:<{}}  {:>5}  no scene\n", info.stage->id, width, info.stage->steps.size());
    return;
  }
  const auto& periods = info.horizon.periods_1e_1;
  fmt::print("{:<{}}  {:>5}  {:<20}  {:>9}  {:>8}  {:>7}  {}\n", info.stage->id, width,
             info.stage->steps.size(), fmt::format("{} [{}]", info.motion, reason_number(reasons, info.why)),
             duration_text(info.setup_ns), duration_text(info.call_ns),
             periods ? fmt::format("{:.0e}", *periods) : "-",
             info.needs.empty() ? "nothing" : fmt::format("{}", fmt::join(info.needs, " ")));
}

/// What the front matter says of the lesson itself: a line for each thing it says.
void print_about(const Lesson& lesson) {
  const About& about = lesson.about;
  const auto print_lines = [](std::string_view name, const std::vector<std::string>& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i)
      fmt::print("{:<14} {}\n", i == 0 ? name : "", printable(lines[i]));
  };
  const auto print_line = [&](std::string_view name, const std::string& line) {
    if (!line.empty()) print_lines(name, {line});
  };
  print_lines("author", about.authors);
  print_line("licence", about.licence);
  print_line("language", std::string(tag_of(about.language)));
  print_lines("outcomes", about.outcomes);
  print_lines("prerequisites", about.prerequisites);
  print_line("next", about.next);
  for (const Reference& reference : lesson.references)
    fmt::print("{:<14} {}\n", '[' + reference.key + ']', printable(reference.text));
}

std::string rates_text(const SceneFacts& facts) {
  if (facts.free)
    return fmt::format("free: {:.6g} about L, {:.6g} in the body", facts.free->in_space, facts.free->in_body);
  if (!facts.theta_rad) return {};
  std::string text = fmt::format("heavy at {:.6g} deg:", *facts.theta_rad * kDegreesPerRadian);
  if (facts.steady) {
    text += fmt::format(" slow {:.6g},", facts.steady->slow);
    if (facts.steady->fast) text += fmt::format(" fast {:.6g},", *facts.steady->fast);
  } else if (*facts.theta_rad > 0 && *facts.theta_rad < std::numbers::pi) {
    text += " no steady precession,";
  }
  if (!facts.nutation) return text + " no nutation";
  const auto [least, most, rate] = *facts.nutation;
  text += fmt::format(" nutation {:.6g} between {:.6g} and {:.6g} deg", rate, least * kDegreesPerRadian,
                      most * kDegreesPerRadian);
  if (const auto means = means_of(facts))
    text +=
        fmt::format(", on average precession {:.6g}, spin {:.6g}", means->mean_precession, means->mean_spin);
  return text;
}

std::string steps_text(const SceneFacts& facts) {
  return facts.first_step == facts.last_step ? fmt::format("{}", facts.first_step)
                                             : fmt::format("{}-{}", facts.first_step, facts.last_step);
}

void print_scenes(const std::vector<StageInfo>& infos, std::size_t width) {
  constexpr const char* kRow = "{:<{}}  {:>5}  {:<34}  {:>8}  {:>10}  {:>10}  {:>10}  {}";
  const auto print = [&](const auto&... cells) {
    std::string line = fmt::format(fmt::runtime(kRow), cells...);
    line.erase(line.find_last_not_of(' ') + 1);
    fmt::print("{}\n", line);
  };
  print("stage", width, "steps", "I1, I2, I3 in kg m^2", "m in kg", "T in J", "L kg m^2/s", "period s",
        "precession, nutation in rad/s");
  for (const StageInfo& info : infos)
    for (const SceneFacts& facts : info.scenes) {
      const Vec3& I = facts.body.moments.vector();
      print(info.stage->id, width, steps_text(facts), fmt::format("{:.5g}, {:.5g}, {:.5g}", I[0], I[1], I[2]),
            fmt::format("{:.6g}", facts.body.mass_kg), fmt::format("{:.6g}", facts.T),
            fmt::format("{:.6g}", facts.L), facts.period_s ? fmt::format("{:.6g}", *facts.period_s) : "-",
            rates_text(facts));
    }
}

void print_table(const Lesson& lesson, const std::vector<StageInfo>& infos) {
  std::size_t width = 5;
  for (const StageInfo& info : infos) width = std::max(width, info.stage->id.size());
  fmt::print("{} ({})\n", lesson.title, lesson.id);
  print_about(lesson);
  fmt::print("\n");
  fmt::print("{:<{}}  steps  {:<20}  {:>9}  {:>8}  {:>7}  requires\n", "stage", width, "motion", "setup",
             "call", "horizon");
  std::vector<std::string> reasons;
  for (const StageInfo& info : infos) print_row(info, width, reasons);
  fmt::print("\n");
  for (std::size_t i = 0; i < reasons.size(); ++i) fmt::print("[{}] {}\n", i + 1, reasons[i]);
  fmt::print("\n");
  print_scenes(infos, width);
}

/// Of all stages, for no more than kLintBudget: a lesson of 5 kB can ask for minutes.
std::vector<StageInfo> infos_of(const LoadedLesson& loaded) {
  Budget budget(kLintBudget);
  std::vector<StageInfo> infos;
  for (const Stage& stage : loaded.lesson.stages) {
    try {
      infos.push_back(info_of(stage, budget.effort()));
    } catch (const BudgetSpent&) {
      throw CommandError(ExitCode::invalid, to_string(too_long_to_check(loaded.path.string(), stage.place)));
    }
  }
  return infos;
}

ExitCode show_info(const std::string& name, bool json) {
  const LoadedLesson loaded = or_fail(load_lesson(name));
  const std::vector<StageInfo> infos = infos_of(loaded);
  if (!json) {
    print_table(loaded.lesson, infos);
    return ExitCode::done;
  }
  Json stages = Json::array();
  for (const StageInfo& info : infos) stages.push_back(to_json(info));
  const Json all = {{"lesson", loaded.lesson.id},
                    {"title", loaded.lesson.title},
                    {"about", about_json(loaded.lesson)},
                    {"stages", std::move(stages)}};
  fmt::print("{}\n", printable(all.dump(2, ' ', false, Json::error_handler_t::replace)));
  return ExitCode::done;
}

}  // namespace

ProgramCommand info_command() {
  struct Options {
    std::string lesson;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  return {
      "info",
      "What a lesson is about, what its scenes require, and their numbers",
      {{"LESSON", &options->lesson, "Id or file", " ", true, offer_lessons()},
       {"--json", &options->json, "the same as JSON, costs in ns"}},
      "Of a page of each stage's last scene: setup is the time to choose the motion and compute the\n"
      "parts required, call that of one evaluation at a time t; both measured now, medians. Horizon: how\n"
      "many polhode periods pass until rounding of the inputs alone moves the phase by 0.1 rad; none\n"
      "without a period.\n"
      "Of each motion of a stage, at t = 0: moments (about the pivot, if it has one), mass, T, L = |L|,\n"
      "period of the polhode. Of a free body with two equal moments the rates at which its axis turns\n"
      "about L, |L|/I1, and omega about the axis in the body, (I3 - I1)/I1 w3. Of such a body on a pivot\n"
      "under gravity alone the two steady precessions at its present tilt theta and spin, roots of\n"
      "I1 cos(theta) x^2 - I3 w3 x + m g l = 0, and its nutation: 2 pi by the exact period of theta between\n"
      "its turning points, or that of a small one, where it precesses steadily or sleeps. theta is the tilt\n"
      "of the axis towards the centre of mass. On average, over a nutation, phi grows at the rate of\n"
      "precession and psi at that of the spin (without half a turn where the axis passes the vertical).",
      [options](const CommandWords&) { return show_info(options->lesson, options->json); }};
}

}  // namespace polhode
