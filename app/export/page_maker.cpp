// SPDX-License-Identifier: MIT
#include "app/export/folder/manifest.h"
#include "app/export/picture_maker.h"
#include "app/narration/short_answers.h"
#include "app/narration/speech_text.h"
#include "app/narration/still_numbers.h"
#include "app/page/figure_cells.h"
#include "app/page/page.h"
#include "app/page/plot_words.h"
#include "app/page/text/page_text.h"
#include "base/words/speech_words.h"

#include <algorithm>
#include <deque>

namespace polhode {

namespace {

constexpr double kFadeSeconds = 0.4;

class PageMaker : public PictureMaker {
 public:
  explicit PageMaker(const MakerContext& context) : context_(context), speech_(context.lesson) {}

  Done check(const PlannedPicture& picture) override {
    const auto content = content_of(picture);
    if (!content) return passed_on(content);
    return done();
  }

  Outcome<PictureDescription> describe(const PlannedPicture& picture) override {
    const auto content = content_of(picture);
    if (!content) return passed_on(content);
    const auto& [shown, words] = *content;
    PictureDescription description{words->alt, words->tex, {}, {}, context_.options.size};
    const PageRequest request = request_of(picture, shown);
    for (const FigureCell& cell : figures_on_page(request)) {
      const Scene& scene = cell.model->scene;  // which a hand may have changed
      description.alt += ' ' + speech_.opening(words::kFigure) +
                         figure_in_words(*cell.model, speech_.words_of_scenes(*cell.step, scene), cell.t_s,
                                         speech_, &fonts());
    }
    const int first = request.before ? request.step - static_cast<int>(request.before->size()) : request.step;
    if (const std::string answers = answers_at_foot(request, first); !answers.empty())
      description.alt += ' ' + speech_.words_of_line(answers) + '.';
    if (!shown.model) return description;
    description.t_s = shown.t_s;
    description.method = shown.model->motion->method();
    return description;
  }

  Outcome<Image> draw(const PlannedPicture& picture) override {
    const auto content = content_of(picture);
    if (!content) return passed_on(content);
    const auto& [shown, words] = *content;
    const Page page = compose_page(request_of(picture, shown), words->set, fonts());
    return outcome_of(context_.renderer.draw(page.sheet, page.insets, context_.options.size,
                                             background_of(context_.options)));
  }

  bool same_bytes(const PlannedPicture& a, const PlannedPicture& b) const override {
    return !a.scene && a.stage == b.stage && a.step == b.step && opacity_in(a) == opacity_in(b);
  }

 private:
  struct Shown {
    const SceneModel* model = nullptr;
    double t_s = 0;
    std::vector<FiguredStep> before{};  ///< of a page with several steps
  };

  /// What a page has apart from its figure is the same at all times: laid out once for a step.
  struct StepText {
    const Stage* stage = nullptr;
    int step = 0;
    FittedText set;
    std::string alt;
    std::vector<std::string> tex;
  };

  struct Content {
    Shown shown;
    const StepText* words;  ///< until the next picture
  };

  Outcome<Content> content_of(const PlannedPicture& picture) {
    const auto shown = shown_in(picture);
    if (!shown) return passed_on(shown);
    if (const Done set = set_text(picture, *shown); !set) return passed_on(set);
    return Content{*shown, &text_};
  }

  Done set_text(const PlannedPicture& picture, const Shown& shown) {
    if (text_.stage == picture.stage && text_.step == picture.step) return done();
    Result<FittedText> fitted = text_of_page(request_of(picture, shown), fonts());
    if (!fitted) return failure_of(Fault::invalid, fitted.error());
    FittedText set = std::move(fitted).value();
    std::vector<std::string> tex;
    for (const Equation* equation : set.equations) tex.push_back(equation->tex);
    std::string alt = speech_.words_of_page(*picture.stage, set.whole_from, picture.step);
    text_ = {picture.stage, picture.step, std::move(set), std::move(alt), std::move(tex)};
    return done();
  }

  Outcome<Shown> shown_in(const PlannedPicture& picture) {
    Shown shown;
    if (picture.first_step > 0)
      if (const Done taken = take_steps_before(picture, shown.before); !taken) return passed_on(taken);
    if (!picture.scene) return shown;
    shown.model = &models_.of(*picture.scene);
    shown.t_s = time_of(picture, context_.options, shown.model->rate);
    if (const Done computable = check_computable(*picture.stage, *shown.model, shown.t_s); !computable)
      return passed_on(computable);
    return shown;
  }

  Done take_steps_before(const PlannedPicture& picture, std::vector<FiguredStep>& before) {
    const bool is_known = stage_before_ == picture.stage && first_before_ == picture.first_step;
    if (!is_known) models_before_.clear();
    stage_before_ = picture.stage;
    first_before_ = picture.first_step;
    std::size_t known = 0;
    for (int step = picture.first_step; step < picture.step; ++step) {
      const std::shared_ptr<const Scene>& scene =
          picture.stage->steps[static_cast<std::size_t>(step - 1)].scene;
      before.push_back({.step = step});
      if (!scene) continue;
      if (known == models_before_.size())
        models_before_.push_back(make_model(*scene, ModelFor::page, context_.effort));
      const SceneModel& model = models_before_[known++];
      before.back().model = &model;
      before.back().t_s = context_.options.at_s.value_or(still_time_s(*scene));
      if (const Done computable = check_computable(*picture.stage, model, before.back().t_s); !computable)
        return passed_on(computable);
    }
    return done();
  }

  /// Frame by frame, what a step adds comes softly; a stage begins with its first step whole.
  std::optional<double> opacity_in(const PlannedPicture& picture) const {
    if (!picture.frame) return std::nullopt;
    if (picture.frame_of_step == picture.frame_of_stage) return 1.0;
    const FrameRate& fps = context_.options.fps;
    const double shown_s =
        static_cast<double>((picture.frame_of_step + 1) * fps.seconds) / static_cast<double>(fps.frames);
    const double u = std::min(1.0, shown_s / kFadeSeconds);
    return u * u * (3.0 - 2.0 * u);
  }

  static PageEntrance entrance_of(std::optional<double> opacity) {
    if (!opacity) return StandingStill{};
    return FadingIn{*opacity};
  }

  /// Of the picture's stage, found once for all its slides; null if it is not asked for, or cannot be set.
  const SlideType* slide_type_in(const PlannedPicture& picture, const PageRequest& request) {
    if (request.profile != Profile::slides) return nullptr;
    if (stage_of_type_ != picture.stage) {
      const Result<SlideType> found = slide_type_of(request, fonts());
      if (!found) return nullptr;  // the text of the slide that has it says why
      type_ = *found;
      stage_of_type_ = picture.stage;
    }
    return &type_;
  }

  PageRequest request_of(const PlannedPicture& picture, const Shown& shown) {
    PageRequest request = plain_request_of(picture, shown);
    request.slide_type = slide_type_in(picture, request);
    return request;
  }

  /// Absent: as the lesson counts.
  std::optional<PageRequest::Count> count_of(const Stage& stage) const {
    const std::vector<std::string>& chosen = context_.options.stages;
    if (!context_.options.counts_chosen || chosen.empty()) return std::nullopt;
    PageRequest::Count here{0, 0};
    for (const Stage& known : context_.lesson.stages) {
      if (std::find(chosen.begin(), chosen.end(), known.id) == chosen.end()) continue;
      ++here.count;
      if (&known == &stage) here.number = here.count;
    }
    return here;
  }

  PageRequest plain_request_of(const PlannedPicture& picture, const Shown& shown) {
    return {.lesson = context_.lesson,
            .stage = *picture.stage,
            .number = picture.number,
            .counted_as = count_of(*picture.stage),
            .step = picture.step,
            .model = shown.model,
            .t_s = shown.t_s,
            .before = picture.first_step > 0 ? std::optional(std::span(shown.before)) : std::nullopt,
            .size = context_.options.size,
            .theme = context_.options.theme,
            .profile = context_.options.profile,
            .quality = context_.options.quality,
            .text_scale = context_.options.text_scale,
            .entrance = entrance_of(opacity_in(picture)),
            .runs = picture.frame.has_value(),
            .is_frame = picture.frame.has_value(),
            .still_numbers = &still_numbers_,
            .effort = context_.effort};
  }

  const Fonts& fonts() const { return context_.renderer.fonts(); }

  MakerContext context_;
  SpeechText speech_;
  ModelOfScene models_{ModelFor::page, context_.effort};
  const Stage* stage_before_ = nullptr;
  int first_before_ = 0;
  std::deque<SceneModel> models_before_;  ///< of the steps from there that are on the same page
  StillNumbers still_numbers_{context_.effort};
  StepText text_;  ///< of the picture seen last
  const Stage* stage_of_type_ = nullptr;
  SlideType type_;  ///< of that stage
};

}  // namespace

std::unique_ptr<PictureMaker> make_page_maker(const MakerContext& context) {
  return std::make_unique<PageMaker>(context);
}

}  // namespace polhode
