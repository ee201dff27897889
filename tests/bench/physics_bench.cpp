// SPDX-License-Identifier: MIT
// The performance of the physics core as one table of ratios, all measured within one run on one machine:
// trust the ratios, not the times. A bench, not a test: it always ends with 0.
//
// ours/yardstick  one call of a closed form against one bare step of RK4 (yardstick.h)
// peers/ours      CPU time of the fastest of Boost.Odeint, GSL and SUNDIALS against ours, each at the
// cheapest
//                 setting (work_precision.h) that reaches the error named, at the end of 1000 periods
#include "physics/analysis/batch.h"
#include "physics/method.h"
#include "tests/bench/table.h"
#include "tests/bench/timing.h"
#include "tests/bench/work_precision.h"
#include "tests/bench/yardstick.h"

#include <fmt/core.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace polhode::bench {
namespace {

constexpr int kTurns = 101;     // of ratios whose sides take a millisecond
constexpr int kLongTurns = 11;  // of those whose sides take up to a tenth of a second
constexpr int kCalls = 4096;    // a side of a short turn
constexpr std::size_t kBatch = 1'000'000;

volatile double g_sink;  // what is computed is used

// ---- ours ----

Problem problem_of(const BenchProblem& p) {
  Problem problem{{p.I[0], p.I[1], p.I[2]}, {}, {}};
  problem.start.w_B = Vec3(p.start[0], p.start[1], p.start[2]);
  problem.start.q_SB = Quat(p.start[3], p.start[4], p.start[5], p.start[6]);
  return problem;
}

State state_of(const RigidBodyState& s) {
  return {s.w_B.x(), s.w_B.y(), s.w_B.z(), s.q_SB.w(), s.q_SB.x(), s.q_SB.y(), s.q_SB.z()};
}

using MotionPtr = std::unique_ptr<const Motion>;

/// Nothing where the method is not built yet.
MotionPtr motion_or_none(const BenchProblem& p, const MethodChoice& choice) {
  try {
    MotionPtr motion = make_motion(problem_of(p), choice);
    return motion->method() == name_of(choice.method) ? std::move(motion) : nullptr;
  } catch (const std::domain_error&) {
    return nullptr;
  }
}

MotionPtr exact_motion(const BenchProblem& p) { return make_motion(problem_of(p), {}); }

std::array<State, 2> ends_of(const BenchProblem& p, const Motion& motion) {
  return {state_of(motion.at(p.truth[0].t_s)), state_of(motion.at(p.truth[1].t_s))};
}

MethodChoice choice_of(const BenchProblem& p, Method method, double knob) {
  MethodChoice choice{method, {}, {}};
  if (facts_of(method).control == StepControl::adaptive)
    choice.tolerance = knob;
  else
    choice.step_s = step_for(p, knob);
  return choice;
}

Stepper ours(Method method) {
  const bool adaptive = facts_of(method).control == StepControl::adaptive;
  return {"polhode " + std::string(name_of(method)),
          adaptive ? Stepper::Knob::tolerance : Stepper::Knob::steps_per_period,
          [method](const BenchProblem& p, double knob) -> std::optional<std::array<State, 2>> {
            const MotionPtr motion = motion_or_none(p, choice_of(p, method, knob));
            if (!motion) return std::nullopt;
            return ends_of(p, *motion);
          },
          false};
}

// ---- single calls ----

/// Times in no order over 1000 periods: whoever steps from one to the next gains nothing.
std::vector<double> scattered_times(const BenchProblem& p, std::size_t n) {
  std::vector<double> t_s(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double golden = static_cast<double>(i) * 0.6180339887498949;
    t_s[i] = 1000 * p.period_s * (golden - std::floor(golden));
  }
  return t_s;
}

double seconds_of_calls(const Motion& motion, const std::vector<double>& t_s) {
  return cpu_s([&] {
    double sum = 0;
    for (const double t : t_s) {
      const RigidBodyState s = motion.at(t);
      sum += s.w_B.x() + s.q_SB.w();
    }
    g_sink = sum;
  });
}

double seconds_of_w_calls(const Motion& motion, const std::vector<double>& t_s) {
  return cpu_s([&] {
    double sum = 0;
    for (const double t : t_s) sum += motion.w_B_at(t).x();
    g_sink = sum;
  });
}

double yardstick_step_s(const BenchProblem& p) { return p.period_s / 200; }

double seconds_of_rk4_steps(const BenchProblem& p) {
  State y = p.start;
  return cpu_s([&] {
    rk4_steps(euler_factors(p.I), yardstick_step_s(p), kCalls, y);
    g_sink = y[0];
  });
}

double seconds_of_rk4_w_steps(const BenchProblem& p) {
  std::array<double, 3> w = {p.start[0], p.start[1], p.start[2]};
  return cpu_s([&] {
    rk4_w_steps(euler_factors(p.I), yardstick_step_s(p), kCalls, w);
    g_sink = w[0];
  });
}

/// The RK4 of the product on new ground, as a user of it meets it.
double seconds_of_our_rk4_steps(const BenchProblem& p) {
  const double h = yardstick_step_s(p);
  const MotionPtr motion = motion_or_none(p, {Method::rk4, h, {}});
  return cpu_s([&] { g_sink = motion->at(h * kCalls).w_B.x(); });
}

double ns_per_call(double s) { return s / kCalls * 1e9; }

void print_call_row(const BenchProblem& p, const Goal& goal) {
  const MotionPtr exact = exact_motion(p);
  const std::vector<double> t_s = scattered_times(p, kCalls);
  const auto calls = [&] { return seconds_of_calls(*exact, t_s); };
  const Paired paired = in_turns(kTurns, calls, [&] { return seconds_of_rk4_steps(p); });
  const Paired to_own = in_turns(kLongTurns, calls, [&] { return seconds_of_our_rk4_steps(p); });
  print(
      {fmt::format("exact (ω, q) call / RK4 step of 7 states, {}", p.name), paired.ratio, goal,
       fmt::format(
           "{:.1f} ns; yardstick {:.1f} ns a step; the product's own RK4 {:.1f} ns: ratio to it {:.2f}",
           ns_per_call(paired.a_s), ns_per_call(paired.b_s), ns_per_call(to_own.b_s), to_own.ratio.median)});
}

/// The heavy top at times in no order.
void print_top_row(const BenchProblem& yardstick, const Goal& goal) {
  const Problem top{
      {1, 1, 0.5}, {Quat(0.9, 0.3, -0.2, 0.1), Vec3(0.3, -0.8, 5)}, {HeavyTop{2, Vec3::UnitZ()}}};
  const MotionPtr exact = make_motion(top, {Method::lagrange_top});
  const std::vector<double> t_s = scattered_times(yardstick, kCalls);
  const Paired paired = in_turns(
      kTurns, [&] { return seconds_of_calls(*exact, t_s); }, [&] { return seconds_of_rk4_steps(yardstick); });
  const double setup_s = cpu_s([&] {
    for (int i = 0; i < 1000; ++i) g_sink = make_motion(top, {Method::lagrange_top})->at(1).w_B.x();
  });
  print({"heavy top (ω, q) call / RK4 step of 7 states, free", paired.ratio, goal,
         fmt::format("{:.1f} ns; yardstick {:.1f} ns a step; set up in {:.1f} µs", ns_per_call(paired.a_s),
                     ns_per_call(paired.b_s), setup_s / 1000 * 1e6)});
}

void print_w_call_row(const BenchProblem& p, const Goal& goal) {
  const MotionPtr exact = exact_motion(p);
  const std::vector<double> t_s = scattered_times(p, kCalls);
  const Paired paired = in_turns(
      kTurns, [&] { return seconds_of_w_calls(*exact, t_s); }, [&] { return seconds_of_rk4_w_steps(p); });
  print({fmt::format("exact ω call / RK4 step of 3 states, {}", p.name), paired.ratio, goal,
         fmt::format("{:.1f} ns; yardstick {:.1f} ns a step", ns_per_call(paired.a_s),
                     ns_per_call(paired.b_s))});
}

/// log2 of how much nearer a period's end comes with half the step, from three runs: 4 if the yardstick is
/// RK4.
double yardstick_order() {
  const BenchProblem& p = kProblems[0];
  const auto end = [&p](int steps) {
    State y = p.start;
    rk4_steps(euler_factors(p.I), p.period_s / steps, steps, y);
    return y;
  };
  const State coarse = end(400), middle = end(800), fine = end(1600);
  double first = 0, second = 0;
  for (std::size_t i = 0; i < kStates; ++i) {
    first += std::abs(coarse[i] - middle[i]);
    second += std::abs(middle[i] - fine[i]);
  }
  return std::log2(first / second);
}

// ---- batches ----

void print_batch_rows(const BenchProblem& p) {
  const MotionPtr exact = exact_motion(p);
  const std::vector<double> t_s = scattered_times(p, kBatch);
  std::vector<RigidBodyState> states(kBatch);
  const auto loop = [&] {
    for (std::size_t i = 0; i < kBatch; ++i) states[i] = exact->at(t_s[i]);
  };
  const auto batch = [&] { exact->at(std::span<const double>(t_s), std::span(states)); };
  const auto one = [&] { states_at(*exact, t_s, states, 1); };
  const auto two = [&] { states_at(*exact, t_s, states, 2); };

  const Paired ways = in_turns(
      kLongTurns, [&] { return cpu_s(loop); }, [&] { return cpu_s(batch); });
  print({fmt::format("loop over at(t) / batch of 1e6 times, one core, {}", p.name), ways.ratio, at_least(2),
         fmt::format("{:.1f} ns, {:.1f} ns a state", ways.a_s / kBatch * 1e9, ways.b_s / kBatch * 1e9)});

  const Paired wall = in_turns(
      kLongTurns, [&] { return seconds_of(CLOCK_MONOTONIC, one); },
      [&] { return seconds_of(CLOCK_MONOTONIC, two); });
  const Paired cpu = in_turns(
      kLongTurns, [&] { return cpu_s(one); }, [&] { return cpu_s(two); });
  print({fmt::format("the batch on one thread / on two, wall time, {}", p.name), wall.ratio, at_least(1.8),
         fmt::format("{:.1f} ms, {:.1f} ms; with both cores free, by CPU time at an even split: {:.2f}",
                     wall.a_s * 1e3, wall.b_s * 1e3, 2 * cpu.ratio.median)});
}

// ---- peers ----

struct Choice {
  Stepper stepper;
  Setting setting;

  double seconds(const BenchProblem& p) const {
    return cpu_s([&] { g_sink = stepper.run(p, setting.knob).value()[1][0]; });
  }
  std::string words(const BenchProblem& p) const {
    const bool steps = stepper.knob == Stepper::Knob::steps_per_period;
    return fmt::format("{} ({}, error {:.1e}) {:.3g} µs a period", stepper.name,
                       steps ? fmt::format("{:.0f} steps a period", setting.knob)
                             : fmt::format("tolerance {:.1e}", setting.knob),
                       setting.error, setting.cpu_s / p.periods() * 1e6);
  }
};

using Curves = std::vector<Curve>;

template <class Wanted>
std::optional<Choice> fastest(const Curves& curves, double error, const Wanted& wanted) {
  std::optional<Choice> best;
  for (const Curve& curve : curves) {
    if (!wanted(curve.stepper)) continue;
    const auto setting = curve.cheapest(error);
    if (setting && (!best || setting->cpu_s < best->setting.cpu_s)) best = Choice{curve.stepper, *setting};
  }
  return best;
}

std::optional<Choice> fastest_peer(const Curves& curves, double error) {
  return fastest(curves, error, [](const Stepper& s) { return s.is_peer; });
}

std::optional<Choice> fastest_named(const Curves& curves, double error, std::string_view name) {
  return fastest(curves, error, [name](const Stepper& s) { return s.name == name; });
}

std::string cost_at(const BenchProblem& p, const Curve& curve, double error) {
  const auto setting = curve.cheapest(error);
  return setting ? fmt::format("{:.3g}", setting->cpu_s / p.periods() * 1e6) : "-";
}

Curves scan_all(const BenchProblem& p, const std::vector<Stepper>& steppers) {
  constexpr const char* kLine = "{:<32}{:>9}{:>9}{:>9}{:>14}\n";
  fmt::print(
      "Work and precision, {}: µs of CPU a period at the cheapest setting that reaches the error after "
      "1000\n",
      p.name);
  fmt::print(kLine, "", "1e-4", "1e-6", "1e-8", "best error");
  Curves curves;
  for (const Stepper& stepper : steppers) {
    curves.push_back(scan(stepper, p));
    const Curve& curve = curves.back();
    if (curve.settings.empty()) {
      fmt::print("{:<32}not built yet\n", stepper.name);
      continue;
    }
    fmt::print(kLine, stepper.name, cost_at(p, curve, 1e-4), cost_at(p, curve, 1e-6), cost_at(p, curve, 1e-8),
               fmt::format("{:.1e}", curve.best_error()));
    std::fflush(stdout);
  }
  fmt::print("{:<32}{:>41.1e}\n", "polhode exact", error_of(p, ends_of(p, *exact_motion(p))));
  fmt::print("\n");
  return curves;
}

/// Construction and one state.
double seconds_of_first_call(const BenchProblem& p, double t_s) {
  return seconds_of(CLOCK_MONOTONIC, [&] { g_sink = make_motion(problem_of(p), {})->at(t_s).w_B.x(); });
}

/// Its times in turns, warm; or each after the caches L1 and L2 have been filled with something else.
std::vector<double> first_calls_s(const BenchProblem& p, bool emptied) {
  std::vector<char> something_else(emptied ? std::size_t{8} << 20 : 0);
  std::vector<double> s;
  for (int turn = 0; turn < kTurns; ++turn) {
    for (std::size_t i = 0; i < something_else.size(); i += 64) ++something_else[i];
    s.push_back(seconds_of_first_call(p, p.truth[1].t_s));
  }
  return s;
}

void print_end_state_rows(const BenchProblem& p, const Curves& curves, double error,
                          std::optional<Goal> goal) {
  const auto peer = fastest_peer(curves, error);
  std::vector<double> turns_s;
  for (int turn = 0; peer && turn < kLongTurns; ++turn) turns_s.push_back(peer->seconds(p));
  for (const bool emptied : {false, true}) {
    Row row{fmt::format("end state at 1000 periods to {:.0e}: peer / ours{}, {}", error,
                        emptied ? ", caches emptied" : "", p.name),
            {},
            goal,
            "no peer"};
    if (peer) {
      const double peer_s = spread_of(turns_s).median;
      const Spread own_s = spread_of(first_calls_s(p, emptied));
      row.measured = Spread{peer_s / own_s.high, peer_s / own_s.median, peer_s / own_s.low};
      row.note = fmt::format("{}; ours {:.2f} µs, setup and one call", peer->words(p), own_s.median * 1e6);
    }
    print(row);
  }
}

void print_moser_veselov_row(const BenchProblem& p, const Curves& curves, double error, const Goal& goal) {
  Row row{fmt::format("Moser-Veselov 10 at {:.0e}: peer / ours, {}", error, p.name), {}, goal, "no peer"};
  const auto peer = fastest_peer(curves, error);
  const auto own = fastest_named(curves, error, "polhode moser-veselov-10");
  if (peer && own) {
    row.measured = in_turns(
                       kLongTurns, [&] { return peer->seconds(p); }, [&] { return own->seconds(p); })
                       .ratio;
    row.note = peer->words(p) + ";\n    " + own->words(p);
  } else if (peer) {
    row.note = "not built yet, or does not reach it; " + peer->words(p);
  }
  print(row);
}

void print_best_error_row(const BenchProblem& p, const Curves& curves, const Goal& goal) {
  Row row{fmt::format("best error reachable at 1000 periods: peer / ours, {}", p.name), {}, goal, "no peer"};
  const Curve* best = nullptr;
  for (const Curve& curve : curves)
    if (curve.stepper.is_peer && (!best || curve.best_error() < best->best_error())) best = &curve;
  if (best) {
    const double own = error_of(p, ends_of(p, *exact_motion(p))), ratio = best->best_error() / own;
    row.measured = Spread{ratio, ratio, ratio};
    row.note = fmt::format("{} {:.1e}; ours {:.1e}", best->stepper.name, best->best_error(), own);
  }
  print(row);
}

void print_frames_row(const BenchProblem& p, const Curves& curves, double error, const Goal& goal) {
  constexpr std::size_t kFrames = 60'000;
  Row row{fmt::format("60 frames a period over 1000, to {:.0e}: peer / ours, {}", error, p.name),
          {},
          goal,
          "no peer"};
  if (const auto peer = fastest_peer(curves, error)) {
    const MotionPtr exact = exact_motion(p);
    std::vector<double> t_s(kFrames);
    for (std::size_t i = 0; i < kFrames; ++i) t_s[i] = p.truth[1].t_s * static_cast<double>(i + 1) / kFrames;
    row.measured =
        in_turns(
            kLongTurns, [&] { return peer->seconds(p); }, [&] { return seconds_of_calls(*exact, t_s); })
            .ratio;
    row.note = "the peer is charged its path to the end, and nothing for the frames on the way";
  }
  print(row);
}

// ---- what was measured where ----

/// What follows the key, or the separator after it, on the first line that starts so.
std::string value_in(const char* file, std::string_view key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(key)) {
      const std::size_t value = line.find_first_not_of(" \t:", key.size());
      return value == line.npos ? "" : line.substr(value);
    }
  return "unknown";
}

std::vector<Library> libraries() {
  return {
#ifdef POLHODE_BENCH_BOOST
      boost_odeint(),
#else
      {"no Boost.Odeint (libboost-dev): left out", {}},
#endif
#ifdef POLHODE_BENCH_GSL
      gsl(),
#else
      {"no GSL (libgsl-dev): left out", {}},
#endif
#ifdef POLHODE_BENCH_SUNDIALS
      sundials(),
#else
      {"no SUNDIALS (libsundials-dev): left out", {}},
#endif
  };
}

void print_circumstances(const std::vector<Library>& peers) {
  fmt::print(
      "polhode physics bench: ratios within one run; medians, [quartiles]; CPU time unless said otherwise\n");
  fmt::print("machine   {}; {} cores; load {}\n", value_in("/proc/cpuinfo", "model name"),
             std::thread::hardware_concurrency(), value_in("/proc/loadavg", ""));
  fmt::print("compiler  {}; {}; ours without, yardstick and peers' templates with fused multiply-add\n",
             POLHODE_BENCH_COMPILER, POLHODE_BENCH_FLAGS);
  fmt::print("peers    ");
  for (const Library& library : peers) fmt::print(" {};", library.name_and_version);
  fmt::print(
      "\nbodies    I = (1, 2, 3); generic ω0 = (0.1, 1.5, 0.2), near-separatrix ω0 = (0.34641, 1.5, 0.2); "
      "periods {:.5g} s and {:.5g} s\n\n",
      kProblems[0].period_s, kProblems[1].period_s);
}

std::vector<Stepper> all_steppers(const std::vector<Library>& peers) {
  std::vector<Stepper> steppers;
  for (const Library& library : peers)
    steppers.insert(steppers.end(), library.steppers.begin(), library.steppers.end());
  for (const Method method : {Method::rk4, Method::rk4_projected, Method::dormand_prince_5,
                              Method::dormand_prince_8, Method::moser_veselov_6, Method::moser_veselov_10})
    steppers.push_back(ours(method));
  return steppers;
}

void run(bool with_peers, double first_of_all_s) {
  const BenchProblem &generic = kProblems[0], &near = kProblems[1];
  const std::vector<Library> peers = libraries();
  print_circumstances(peers);
  Curves of_generic, of_near;
  if (with_peers) {
    of_generic = scan_all(generic, all_steppers(peers));
    of_near = scan_all(near, all_steppers(peers));
  }

  print_row_heading();
  print_call_row(generic, at_most(3, 2.5));
  print_call_row(near, at_most(3.5));
  print_top_row(generic, at_most(6));
  print_w_call_row(generic, at_most(2));
  print_w_call_row(near, at_most(2));
  print_batch_rows(generic);
  if (with_peers) {
    print_end_state_rows(generic, of_generic, 1e-6, at_least(1e4));
    print_end_state_rows(near, of_near, 1e-4, {});
    print_moser_veselov_row(generic, of_generic, 1e-8, at_least(3));
    print_moser_veselov_row(near, of_near, 1e-4, at_least(2, 5));
    print_best_error_row(generic, of_generic, at_least(1e3));
    print_best_error_row(near, of_near, at_least(1e6));
    print_frames_row(generic, of_generic, 1e-6, at_least(5));
    print_frames_row(near, of_near, 1e-4, at_least(8));
  }
  fmt::print("setup and one call as the first thing this process did: {:.1f} µs, most of it the loader's\n",
             first_of_all_s * 1e6);
  fmt::print("observed order of the yardstick: {:.2f} (RK4: 4)\n", yardstick_order());
}

}  // namespace
}  // namespace polhode::bench

int main(int argc, char** argv) {
  using namespace polhode::bench;
  const double first_of_all_s = seconds_of_first_call(kProblems[0], kProblems[0].truth[1].t_s);
  const bool quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  if (argc > 1 && !quick) {
    fmt::print("usage: physics_bench [--quick]   --quick: without the peers, a few seconds\n");
    return 2;
  }
  run(!quick, first_of_all_s);
  return 0;
}
