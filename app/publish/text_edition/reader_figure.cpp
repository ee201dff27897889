// SPDX-License-Identifier: MIT
#include "app/publish/text_edition/reader_figure.h"

#include "app/narration/alt_text.h"
#include "app/page/live_numbers.h"
#include "app/page/page.h"
#include "app/page/plot_words.h"
#include "app/publish/html_text.h"
#include "render/gl/passes/background.h"
#include "render/image/webp.h"

#include <fmt/format.h>

namespace polhode {

namespace {

Background ground_of(Theme theme) { return {Background::Kind::color, colors_of(theme).paper}; }

}  // namespace

ReaderFigures::ReaderFigures(const Lesson& lesson, const SpeechText& speech, Renderer& renderer,
                             const Look& look, const Effort& effort)
    : lesson_(lesson), speech_(speech), renderer_(renderer), look_(look), models_(ModelFor::page, effort) {}

std::vector<SceneInWords> ReaderFigures::words_of_scenes(const Step& step) const {
  std::vector<SceneInWords> said = speech_.words_of_scenes(step, *step.scene);
  const std::vector<const Scene*> scenes = shown_scenes(*step.scene);
  for (std::size_t i = 0; i < said.size(); ++i) said[i].caption = speech_.words_of_line(scenes[i]->label);
  return said;
}

Outcome<std::string> ReaderFigures::source(const PageRequest& request) {
  const Page page = compose_picture(request, renderer_.fonts());
  const Result<Image> image = renderer_.draw(page.sheet, page.insets, request.size, ground_of(request.theme));
  if (!image) return failed(image);
  const Result<std::vector<std::uint8_t>> webp = encode_small_webp(*image);
  if (!webp) return failed(webp);
  return "data:image/webp;base64," + base64(*webp);
}

Outcome<ReaderPicture> ReaderFigures::moment(const Stage& stage, int step, double t_s, Size size) {
  const Step& of = stage.steps[static_cast<std::size_t>(step - 1)];
  const SceneModel& model = model_of(of);
  if (const Done computable = check_computable(stage, model, t_s); !computable) return passed_on(computable);
  PageRequest request{.lesson = lesson_,
                      .stage = stage,
                      .step = step,
                      .model = &model,
                      .t_s = t_s,
                      .size = size,
                      .theme = look_.theme,
                      .quality = look_.quality};
  Outcome<std::string> shown = source(request);
  if (!shown) return passed_on(shown);
  ReaderPicture made{.size = size, .source = std::move(shown).value(), .alt = {}, .t_s = t_s};
  if (look_.both) {
    request.theme = Theme::dark;
    Outcome<std::string> dark = source(request);
    if (!dark) return passed_on(dark);
    made.dark = std::move(dark).value();
  }
  made.alt = figure_in_words(model, words_of_scenes(of), t_s, speech_, &renderer_.fonts());
  return made;
}

Outcome<ReaderPicture> ReaderFigures::still(const Stage& stage, int step) {
  const Step& of = stage.steps[static_cast<std::size_t>(step - 1)];
  return moment(stage, step, still_time_s(*of.scene), picture_size_of(model_of(of), kReaderPictureWidth));
}

Outcome<std::vector<ReaderPicture>> ReaderFigures::moments(const Stage& stage, int step,
                                                           const PlayedInterval& interval) {
  const Size size =
      picture_size_of(model_of(stage.steps[static_cast<std::size_t>(step - 1)]), kReaderMomentWidth);
  const Step& of = stage.steps[static_cast<std::size_t>(step - 1)];
  std::vector<ReaderPicture> all;
  for (int i = 0; i < kReaderMoments; ++i) {
    const double part = static_cast<double>(i) / (kReaderMoments - 1);
    const double t_s = interval.from_s + part * (interval.to_s - interval.from_s);
    Outcome<ReaderPicture> one = moment(stage, step, t_s, size);
    if (!one) return passed_on(one);
    // They are the answer: the first is told whole, of the others what has changed.
    std::string change =
        moment_in_words(model_of(of), words_of_scenes(of), interval.from_s, interval.to_s, t_s);
    if (i > 0)
      one->alt = std::move(change);
    else if (!change.empty())
      one->alt += ' ' + change;
    all.push_back(std::move(one).value());
  }
  return all;
}

std::vector<std::string> ReaderFigures::captions(const Step& step) {
  const SceneModel& model = model_of(step);
  std::vector<std::string> all = captions_at(lesson_, step, model, still_time_s(*step.scene));
  if (have_one_caption(shown_scenes(*step.scene))) all = {all[step.scene->before]};
  std::erase(all, "");
  return all;
}

}  // namespace polhode
