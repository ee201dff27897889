// SPDX-License-Identifier: MIT
// What proofs of claims cost: one core, the lecture as it is.
#include "lessons/claims/live_claims.h"
#include "lessons/claims/proof/proof.h"
#include "lessons/reader/checks/claim_check.h"
#include "lessons/reader/reader.h"
#include "tests/bench/table.h"
#include "tests/support/paths.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <sstream>
#include <string>

namespace polhode::bench {
namespace {

struct Line {
  const ClaimLine* line;
  ClaimKind kind;
};

/// The lessons that come with the program, as files hold them.
std::vector<std::string> lesson_texts() {
  std::vector<std::string> texts;
  for (const char* name :
       {"euler-equations", "intermediate-axis", "numerical-lab", "symmetric-top", "heavy-top"}) {
    std::ostringstream text;
    text << std::ifstream(test::source_dir() / "lessons" / (std::string(name) + ".md")).rdbuf();
    texts.push_back(text.str());
  }
  return texts;
}

std::vector<Line> proved_lines(const Lesson& lesson) {
  std::vector<Line> lines;
  for (const Stage& stage : lesson.stages)
    for (const Step& step : stage.steps)
      for (const Block& block : step.blocks)
        if (const auto* claim = std::get_if<Claim>(&block); claim && claim->kind != ClaimKind::measured)
          for (const ClaimLine& line : claim->lines) lines.push_back({&line, claim->kind});
  return lines;
}

/// Seconds for one of many runs.
template <class Work>
double each_s(int runs, const Work& work) {
  return cpu_s([&] {
           for (int run = 0; run < runs; ++run) work();
         }) /
         runs;
}

/// CPU ms to evaluate both sides of every claim of a step at one time, at 60 times a second of its scene.
std::vector<double> live_ms_of_steps(const Lesson& lesson) {
  constexpr int kTimes = 60;
  std::vector<double> all_ms;
  for (const Stage& stage : lesson.stages)
    for (const Step& step : stage.steps) {
      if (!step.scene) continue;
      const SceneModel model = make_model(*step.scene, ModelFor::page);
      int frame = 0;
      const auto all_values = [&] {
        const double t_s = model.scene.at_s + model.rate * frame++ / kTimes;
        const auto live = live_state(model, t_s);
        for (const Block& block : step.blocks)
          if (const auto* claim = std::get_if<Claim>(&block); claim && live)
            (void)live_value(*claim, *live, model.scene.views.front());
      };
      all_ms.push_back(1e3 * each_s(kTimes, all_values));
    }
  return all_ms;
}

int run() {
  const std::vector<std::string> texts = lesson_texts();
  const LessonReading reading = read_lesson(texts.front(), "euler-equations.md");
  if (!reading.lesson) {
    std::fprintf(stderr, "the lecture cannot be read\n");
    return 1;
  }
  const std::vector<Line> lines = proved_lines(*reading.lesson);
  std::vector<double> prover_us, settle_us, refute_ms, lecture_ms;
  for (int i = 0; i < 20; ++i)
    prover_us.push_back(1e6 * each_s(5, [] {
                          const Prover one;
                          (void)one;
                        }));
  const Prover prover;
  for (const auto& [line, kind] : lines) {
    const Equality& equality = line->equality;
    const LawsAssumed laws = laws_assumed_by(kind);
    settle_us.push_back(1e6 * each_s(50, [&] { prover.settle(equality, laws); }));
    refute_ms.push_back(1e3 * cpu_s([&] { (void)prover.refute(equality, laws); }));
  }
  for (int i = 0; i < 20; ++i)
    lecture_ms.push_back(1e3 * cpu_s([&] {
                           const Prover fresh;
                           for (const auto& [line, kind] : lines) (void)judge(*line, kind, fresh);
                         }));
  const auto dearest = [](const std::vector<double>& values) {
    return "the dearest " + std::to_string(*std::max_element(values.begin(), values.end()));
  };
  std::vector<double> read_ms, prove_ms, both_ms;
  for (int i = 0; i < 10; ++i) {
    std::vector<LessonReading> readings;
    read_ms.push_back(1e3 * cpu_s([&] {
                        for (const std::string& one : texts)
                          readings.push_back(read_lesson(one, "lesson.md"));
                      }));
    prove_ms.push_back(1e3 * cpu_s([&] {
                         for (LessonReading& one : readings) (void)prove_claims(*one.lesson);
                       }));
    both_ms.push_back(read_ms.back() + prove_ms.back());
  }
  const std::string count = std::to_string(lines.size()) + " lines of the lecture; ";
  print_row_heading();
  print({"drawing the points, µs", spread_of(prover_us), {}, "once"});
  print({"settling a claim, µs", spread_of(settle_us), at_most(30.0), count + dearest(settle_us)});
  print({"looking for a counterexample that is not there, ms", spread_of(refute_ms), at_most(50.0),
         count + dearest(refute_ms)});
  print({"all claims of the lecture judged, ms", spread_of(lecture_ms), at_most(50.0),
         "points drawn anew, counterexamples found for what is false; " + dearest(lecture_ms)});
  print({"reading the five lessons, ms",
         spread_of(read_ms),
         {},
         std::to_string(std::accumulate(texts.begin(), texts.end(), std::size_t(0),
                                        [](std::size_t sum, const auto& one) { return sum + one.size(); }) /
                        1000) +
             " kB"});
  print({"proving all their claims, ms", spread_of(prove_ms), {}, dearest(prove_ms)});
  print({"reading and proving them, ms", spread_of(both_ms), at_most(100.0), dearest(both_ms)});
  const std::vector<double> live_ms = live_ms_of_steps(*reading.lesson);
  print({"live values of a step, each time, ms", spread_of(live_ms), at_most(0.2),
         std::to_string(live_ms.size()) + " steps, " + dearest(live_ms)});
  return 0;
}

}  // namespace
}  // namespace polhode::bench

int main() { return polhode::bench::run(); }
