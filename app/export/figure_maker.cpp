// SPDX-License-Identifier: MIT
#include "app/export/folder/manifest.h"
#include "app/export/picture_maker.h"
#include "app/narration/alt_text.h"
#include "app/narration/speech_text.h"
#include "app/page/figure_place.h"
#include "app/page/live_numbers.h"
#include "app/page/plot_words.h"
#include "base/words/speech_words.h"
#include "physics/method.h"
#include "render/figure/make_figure.h"

#include <fmt/format.h>

namespace polhode {

namespace {

class FigureMaker : public PictureMaker {
 public:
  explicit FigureMaker(const MakerContext& context) : context_(context), speech_(context.lesson) {}

  Done check(const PlannedPicture& picture) override {
    const auto shown = shown_in(picture);
    if (!shown) return passed_on(shown);
    return done();
  }

  Outcome<PictureDescription> describe(const PlannedPicture& picture) override {
    const auto shown = shown_in(picture);
    if (!shown) return passed_on(shown);
    const auto& [model, t_s] = *shown;
    std::string alt = speech_.words_of_title(*picture.stage) + ' ' +
                      alt_text(*model, speech_.words_of_scenes(step_of(picture), *picture.scene), t_s);
    if (const std::string diagrams = words_of_diagrams(*model, t_s, speech_, context_.renderer.fonts());
        !diagrams.empty())
      alt += ' ' + speech_.opening(words::kInTheDiagram) + diagrams;
    return {{alt, tex_shown(*picture.stage, picture.step), t_s, std::string(model->motion->method()),
             context_.options.size}};
  }

  Outcome<Image> draw(const PlannedPicture& picture) override {
    const auto shown = shown_in(picture);
    if (!shown) return passed_on(shown);
    const auto& [model, t_s] = *shown;
    const Size size = context_.options.size;
    const Background background = background_of(context_.options);
    const Quality quality = quality_of(context_.options.quality.value_or(picture.scene->quality));
    const std::vector<std::string> captions = captions_in(picture, *shown);
    const bool has_parts = !diagrams_in(model->drawn).empty() || !model->beside.empty();
    if (has_parts || !captions.front().empty())
      return outcome_of(draw_in_parts(*model, t_s, captions, picture.frame.has_value(), background, quality));
    const Figure figure = make_figure(*model, t_s, static_cast<double>(size.width) / size.height);
    return outcome_of(context_.renderer.draw(figure, size, background, quality));
  }

 private:
  struct Shown {
    const SceneModel* model;
    double t_s;
  };

  Outcome<Shown> shown_in(const PlannedPicture& picture) {
    const SceneModel& model = models_.of(*picture.scene);
    const double t_s = time_of(picture, context_.options, model.rate);
    if (const Done computable = check_computable(*picture.stage, model, t_s); !computable)
      return passed_on(computable);
    return Shown{&model, t_s};
  }

  std::vector<std::string> captions_in(const PlannedPicture& picture, const Shown& shown) const {
    const Step& step = step_of(picture);
    const auto& [model, t_s] = shown;
    const LongestNumbers longest =
        picture.frame ? longest_in_captions(context_.lesson, step, *model) : LongestNumbers();
    return captions_at(context_.lesson, step, *model, t_s, longest);
  }

  /// Diagrams and captions stand on a plain ground: paper instead of the studio.
  Result<Image> draw_in_parts(const SceneModel& model, double t_s, const std::vector<std::string>& captions,
                              bool is_frame, const Background& background, const Quality& quality) {
    using Kind = Background::Kind;
    const Size size = context_.options.size;
    const Background ground = background.kind == Kind::studio ? Background{Kind::paper, {}} : background;
    FigurePlace place{.rect = {0, 0, size.width, size.height},
                      .caption_px = caption_px_of(size),
                      .theme = is_dark(halo_of(ground)) ? Theme::dark : Theme::paper,
                      .background = background,
                      .ground = {},
                      .quality = quality,
                      .captions = captions,
                      .is_frame = is_frame};
    if (ground.kind != Kind::transparent) place.ground = sky_of(ground);
    const PlacedFigure placed = place_figure(model, t_s, place, context_.renderer.fonts());
    return context_.renderer.draw(placed.sheet, placed.insets, size, ground);
  }

  MakerContext context_;
  SpeechText speech_;
  ModelOfScene models_{ModelFor::figure, context_.effort};
};

}  // namespace

std::unique_ptr<PictureMaker> make_figure_maker(const MakerContext& context) {
  return std::make_unique<FigureMaker>(context);
}

}  // namespace polhode
