// SPDX-License-Identifier: MIT
// What the window's session costs in its drawing loop, where a frame of 30 a second has 33 ms: the hand that
// takes ω's tip, the meter of accuracy and speed, the symbols that a page lights up under the pointer.
#include "app/cli/lesson_lookup.h"
#include "app/cli/or_fail.h"
#include "app/page/page.h"
#include "app/session/accuracy_meter.h"
#include "app/session/omega_drag.h"
#include "app/session/page_symbols.h"
#include "render/figure/make_figure.h"
#include "render/figure/omega_tip.h"
#include "tests/bench/poinsot_scene.h"
#include "tests/support/paths.h"

#include <benchmark/benchmark.h>

#include <numbers>

namespace polhode {
namespace {

constexpr PixelRect kPlace{623, 40, 657, 520};

Lesson lecture() {
  return or_fail(load_lesson((test::source_dir() / "lessons/euler-equations.md").string())).lesson;
}

/// A body of beads with the marks of its angular momentum: only its motion knows what the frame is.
Scene scene_with_marks() { return *lecture().find_stage("angular-momentum")->steps[0].scene; }

/// ω with its tip under a pointer that goes to and fro by a pixel, in the first pane.
void BM_OmegaUnderThePointer(benchmark::State& state, const Scene& scene) {
  const SceneModel model = make_model(scene);
  std::vector<Inset> insets(1);
  insets[0].figure = make_figure(model, 1.1, static_cast<double>(kPlace.width) / kPlace.height);
  insets[0].place = kPlace;
  const auto tips = omega_tips(model, 1.1, insets);
  double shift_px = 0;
  for (auto _ : state) {
    shift_px = 1 - shift_px;
    benchmark::DoNotOptimize(omega_at(model, 1.1, insets[0], 0, tips.at(0).x + shift_px, tips.at(0).y));
  }
}

/// The meter after 100 turns, whose way is known; what the panel takes of each frame.
void BM_AccuracyMeter(benchmark::State& state, const MotionSpec& motion) {
  Scene scene;
  scene.body.moments = PrincipalMoments(1, 2, 3);
  scene.w0_B = Vec3(0.1, 1.5, 0.2);
  scene.show = {Overlay::shape, Overlay::omega};
  scene.motion = motion;
  const SceneModel model = make_model(scene, ModelFor::page);
  const AccuracyMeter meter(model);
  const double t_s = 100 * 2 * std::numbers::pi / scene.w0_B.norm();
  benchmark::DoNotOptimize(meter.at(model, t_s));
  for (auto _ : state) benchmark::DoNotOptimize(meter.at(model, t_s));
}

/// All symbols of the lecture's page with the most formulas.
void BM_SymbolsOnAPage(benchmark::State& state) {
  const Lesson lesson = lecture();
  const Fonts fonts = Fonts::open().value();
  const Page page =
      compose_page(
          {.lesson = lesson, .stage = *lesson.find_stage("substitute"), .step = 2, .size = {1280, 800}},
          fonts)
          .value();
  for (auto _ : state) benchmark::DoNotOptimize(symbols_on(page.sheet, fonts));
}

BENCHMARK(BM_SymbolsOnAPage)->Unit(benchmark::kMicrosecond);
// With L held in space the solution is searched for.
BENCHMARK_CAPTURE(BM_OmegaUnderThePointer, L_held, bench::poinsot_scene())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_OmegaUnderThePointer, marks, scene_with_marks())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_AccuracyMeter, exact, MotionSpec{})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_AccuracyMeter, rk4, MotionSpec{.method = Method::rk4, .step_s = 0.02})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_AccuracyMeter, moser_veselov_10,
                  MotionSpec{.method = Method::moser_veselov_10, .step_s = 0.05})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_AccuracyMeter, dormand_prince_8,
                  MotionSpec{.method = Method::dormand_prince_8, .tolerance = 1e-10})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace polhode
