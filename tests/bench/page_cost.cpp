// SPDX-License-Identifier: MIT
#include "tests/bench/page_cost.h"

#include "app/cli/lesson_lookup.h"
#include "app/cli/or_fail.h"
#include "app/page/page.h"
#include "app/session/answers/derivation_work.h"
#include "render/figure/make_figure.h"
#include "tests/bench/timing.h"
#include "tests/support/paths.h"

#include <stdexcept>

namespace polhode::bench {
namespace {

constexpr Size kPage{1600, 1000};

template <class T>
T value_of(Result<T> result) {
  if (!result) throw std::runtime_error(result.error());
  return std::move(result).value();
}

/// A shape, a glyph and a rule: the driver compiles what draws them when they first come.
Sheet sheet_of_all_kinds() {
  Sheet sheet;
  sheet.shapes = {Area{{{10, 10}, {20, 10}, {10, 20}}, kInk},
                  Stroke{.points = {{30, 30}, {40, 40}}, .color = kInk}};
  DisplayList list;
  list.glyphs.push_back(
      {.face = Face::mono, .id = 50, .size = 7.0, .color = kInk, .naming = {}, .source = {}});
  list.rules.push_back({.x1 = 10, .color = kInk, .naming = {}, .source = {}});
  sheet.texts.push_back({.list = list, .at = {50, 50}, .halo = kOmegaRole.ink});
  return sheet;
}

/// ms of CPU that a page takes beyond its figure: laid out and drawn by a renderer that has drawn no text
/// yet.
double cost_ms(const Lesson& lesson, const Stage& stage, const GlContext& context) {
  const Step& step = stage.steps.back();
  const SceneModel model = make_model(*step.scene, ModelFor::page);
  const Fonts fonts = Fonts::open().value();
  const auto renderer = value_of(Renderer::create(context, fonts));
  const PageRequest request{.lesson = lesson,
                            .stage = stage,
                            .step = static_cast<int>(stage.steps.size()),
                            .model = &model,
                            .t_s = step.scene->at_s,
                            .size = kPage};
  const Inset inset = compose_page(request, renderer->fonts()).value().insets.front();
  const Size size{inset.place.width, inset.place.height};
  const auto draw_figure = [&] {
    const double aspect = static_cast<double>(size.width) / size.height;
    Figure figure = make_figure(model, request.t_s, aspect);
    value_of(renderer->draw(figure, size, inset.background));
  };
  draw_figure();  // shaders, buffers, and the figure's own names
  const double figure = spread_of({cpu_s(draw_figure), cpu_s(draw_figure), cpu_s(draw_figure)}).median;
  value_of(renderer->draw(sheet_of_all_kinds(), kPage, {}));
  const double page = cpu_s([&] {
    const Page made = compose_page(request, renderer->fonts()).value();
    value_of(renderer->draw(made.sheet, made.insets, kPage, {Background::Kind::paper, {}}));
  });
  return 1e3 * (page - figure);
}

LoadedLesson lecture() {
  return or_fail(load_lesson((test::source_dir() / "lessons/euler-equations.md").string()));
}

/// Every question that asks for a derivation, with its stage and step, from 1.
template <class Visit>
void for_each_derivation(const Lesson& lesson, const Visit& visit) {
  for (const Stage& stage : lesson.stages)
    for (std::size_t i = 0; i < stage.steps.size(); ++i)
      for (const Ask* ask : blocks_of<Ask>(stage.steps[i]))
        if (ask->derivation) visit(stage, static_cast<int>(i) + 1, *ask);
}

}  // namespace

std::vector<double> typing_costs_ms() {
  constexpr Size kWindow{1280, 740};
  const LoadedLesson loaded = lecture();
  const Fonts fonts = Fonts::open().value();
  std::vector<double> costs;
  for_each_derivation(loaded.lesson, [&](const Stage& stage, int step, const Ask& ask) {
    const SceneModel model =
        make_model(*stage.steps[static_cast<std::size_t>(step - 1)].scene, ModelFor::page);
    DerivationWork work(loaded.lesson, ask);
    PageRequest request{.lesson = loaded.lesson,
                        .stage = stage,
                        .step = step,
                        .model = &model,
                        .t_s = model.scene.at_s,
                        .size = kWindow,
                        .scrolls = true};
    request.derivation.ask = &ask;
    for (const WorkedLine& worked : work.derivation().worked) {
      for (std::size_t n = 1; n <= worked.line.typed.size(); ++n)
        costs.push_back(1e3 * cpu_s([&] {
                          work.type(worked.line.typed.substr(0, n));
                          request.derivation.lines.push_back({work.typed_tex(), "", Certainty::stated});
                          value_of(compose_page(request, fonts));
                          request.derivation.lines.pop_back();
                        }));
      request.derivation.lines.push_back({worked.line.tex, "holds", Certainty::proved});
    }
  });
  return costs;
}

std::vector<double> judging_costs_ms() {
  const LoadedLesson loaded = lecture();
  std::vector<double> costs;
  for_each_derivation(loaded.lesson, [&](const Stage&, int, const Ask& ask) {
    DerivationWork work(loaded.lesson, ask);
    for (const WorkedLine& worked : work.derivation().worked)
      costs.push_back(1e3 * cpu_s([&] { work.add(worked.line.typed); }));
  });
  return costs;
}

std::vector<double> page_costs_ms() {
  const LoadedLesson loaded = lecture();
  const auto context = value_of(open_context(ContextKind::any));
  std::vector<double> costs;
  for (const Stage& stage : loaded.lesson.stages)
    if (stage.steps.back().scene) {
      const auto cost = [&] { return cost_ms(loaded.lesson, stage, *context); };
      costs.push_back(spread_of({cost(), cost(), cost()}).median);
    }
  return costs;
}

}  // namespace polhode::bench
