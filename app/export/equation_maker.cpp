// SPDX-License-Identifier: MIT
#include "app/export/folder/manifest.h"
#include "app/export/picture_maker.h"
#include "app/narration/speech_text.h"
#include "app/page/live_numbers.h"
#include "base/words/page_words.h"
#include "render/typeset/morph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace polhode {

namespace {

constexpr double kPointsPerInch = 72, kTypePoints = 12;
constexpr double kMargin = 0.35;  // around the ink, em

/// Whole pixels that hold the ink of some lists, whose origin lies at (x, y) in it.
struct Canvas {
  double x = 0, y = 0;
  Size size;
};

void unite(TypeBox& all, const TypeBox& box) {
  if (box.empty()) return;
  all = all.empty() ? box
                    : TypeBox{std::min(all.x0, box.x0), std::min(all.y0, box.y0), std::max(all.x1, box.x1),
                              std::max(all.y1, box.y1)};
}

Canvas canvas_around(const TypeBox& ink, double margin) {
  const double x = std::ceil(margin - ink.x0), y = std::ceil(margin - ink.y0);
  const auto length = [](double end) { return static_cast<int>(std::min(std::ceil(end), 1e9)); };
  return {x, y, {std::max(1, length(x + ink.x1 + margin)), std::max(1, length(y + ink.y1 + margin))}};
}

/// About x = 0, as displays stand on a page.
DisplayList centred(const DisplayList& list) {
  DisplayList moved = list;
  moved.glyphs.clear();
  moved.rules.clear();
  moved.names.clear();
  append(moved, list, -0.5 * list.width, 0.0);
  return moved;
}

/// What a frame of a film shows: a line, or the way from it to the next.
struct MorphPlace {
  std::size_t line = 0;
  double way = 0;  ///< 0: the line itself
};

/// Lines stand as long as the ways between them take; the ways begin and end softly.
MorphPlace place_at(std::int64_t frame, std::int64_t frames, std::size_t lines) {
  const double parts = 2.0 * static_cast<double>(lines) - 1.0;
  const double at =
      parts * (static_cast<double>(frame) + 0.5) / static_cast<double>(std::max<std::int64_t>(1, frames));
  const auto part = static_cast<std::size_t>(std::min(at, parts - 0.5));
  const double u = at - static_cast<double>(part);
  return {part / 2, part % 2 == 0 ? 0.0 : u * u * (3.0 - 2.0 * u)};
}

class EquationMaker : public PictureMaker {
 public:
  explicit EquationMaker(const MakerContext& context)
      : context_(context),
        speech_(context.lesson),
        symbols_(symbols_of(context.lesson, context.options.theme)),
        em_(kTypePoints / kPointsPerInch * context.options.dpi) {}

  Done check(const PlannedPicture& picture) override {
    const auto canvas = canvas_of(picture);
    if (!canvas) return passed_on(canvas);
    const Size size = canvas->size;
    if (std::max(size.width, size.height) <= kMaxImageSide) return done();
    return failure_of(
        Fault::usage,
        fmt::format("stage \"{}\": at --dpi {} the equation would be {}x{} pixels, at most {} are made",
                    picture.stage->id, context_.options.dpi, size.width, size.height, kMaxImageSide));
  }

  Outcome<PictureDescription> describe(const PlannedPicture& picture) override {
    const auto canvas = canvas_of(picture);
    if (!canvas) return passed_on(canvas);
    const auto [line, next, way] = shown_in(picture);
    PictureDescription description{speech_.words(*line), {line->tex}, {}, {}, canvas->size};
    if (way == 0.0) return description;
    description.alt =
        words::kBetweenTwoLines.with(context_.lesson.about.language, {description.alt, speech_.words(*next)});
    description.tex.push_back(next->tex);
    return description;
  }

  Outcome<Image> draw(const PlannedPicture& picture) override {
    const auto canvas = canvas_of(picture);
    if (!canvas) return passed_on(canvas);
    const Outcome<Sheet> flat = sheet(picture);
    if (!flat) return passed_on(flat);
    return outcome_of(context_.renderer.draw(*flat, canvas->size, background_of(context_.options)));
  }

  Outcome<Sheet> sheet(const PlannedPicture& picture) override {
    const auto canvas = canvas_of(picture);
    if (!canvas) return passed_on(canvas);
    const auto [line, next, way] = shown_in(picture);
    Sheet sheet;
    const DisplayList& list = lists_.at(line);
    sheet.texts.push_back({.list = way == 0.0 ? list : morph(list, lists_.at(next), way),
                           .at = {canvas->x, canvas->y},
                           .moving = picture.equation == nullptr});
    return sheet;
  }

  bool same_bytes(const PlannedPicture& a, const PlannedPicture& b) const override {
    const Shown of_a = shown_in(a), of_b = shown_in(b);
    return of_a.way == 0.0 && of_b.way == 0.0 && of_a.line == of_b.line;
  }

 private:
  /// A line; in a film also the way to the next.
  struct Shown {
    const Equation* line;
    const Equation* next;  ///< null where way is 0
    double way;
  };

  Shown shown_in(const PlannedPicture& picture) const {
    if (picture.equation) return {picture.equation, nullptr, 0.0};
    const std::vector<const Equation*> lines = equations_of(*picture.stage);
    const std::int64_t frames = frame_count(context_.options.fps, context_.options.seconds);
    const auto [line, way] = place_at(picture.frame_of_stage, frames, lines.size());
    return {lines[line], way == 0.0 ? nullptr : lines[line + 1], way};
  }

  static std::vector<const Equation*> lines_of(const PlannedPicture& picture) {
    if (picture.equation) return {picture.equation};
    return equations_of(*picture.stage);
  }

  Done set(const Equation& equation) {
    if (lists_.contains(&equation)) return done();
    MathStyle style;
    style.size = em_;
    style.display = true;
    style.color = colors_of(context_.options.theme).ink;
    style.strike = colors_of(context_.options.theme).accent;
    style.symbols = &symbols_;
    auto list = set_math(with_numbers_of_still(equation), style, context_.renderer.fonts());
    if (!list)
      return failure_of(Fault::invalid, fmt::format("equation \"{}\" cannot be set: {}", equation.id,
                                                    list.error().front().message));
    lists_.emplace(&equation, centred(*list));
    return done();
  }

  /// As it is on the still of its step.
  Math with_numbers_of_still(const Equation& equation) {
    if (equation.math.live.empty()) return equation.math;
    PageNumbers numbers(context_.lesson, context_.renderer.fonts());
    if (const Step* step = step_of(equation))
      for (const auto& [id, value] : stills_.of(context_.lesson, *step)) numbers.keep(id, value);
    return numbers.put_into(equation.math);
  }

  const Step* step_of(const Equation& equation) const {
    for (const Stage& stage : context_.lesson.stages)
      for (const Step& step : stage.steps)
        for (const Block& block : step.blocks)
          if (std::get_if<Equation>(&block) == &equation) return &step;
    return nullptr;
  }

  /// Sets all lines of the picture.
  Outcome<Canvas> canvas_of(const PlannedPicture& picture) {
    TypeBox ink;
    for (const Equation* equation : lines_of(picture)) {
      if (const Done is_set = set(*equation); !is_set) return passed_on(is_set);
      unite(ink, ink_box(lists_.at(equation), context_.renderer.fonts()));
    }
    return canvas_around(ink, kMargin * em_);
  }

  MakerContext context_;
  SpeechText speech_;
  StillNumbers stills_{context_.effort};
  std::vector<MathSymbol> symbols_;
  double em_;                                     ///< px
  std::map<const Equation*, DisplayList> lists_;  ///< looked up only: its order is never used
};

}  // namespace

std::unique_ptr<PictureMaker> make_equation_maker(const MakerContext& context) {
  return std::make_unique<EquationMaker>(context);
}

}  // namespace polhode
