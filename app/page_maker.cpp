// SPDX-License-Identifier: MIT
#include "app/alt_text.h"
#include "app/manifest.h"
#include "app/or_fail.h"
#include "app/page.h"
#include "app/picture_maker.h"
#include "app/speaker.h"

namespace polhode {

namespace {

class PageMaker : public PictureMaker {
 public:
  explicit PageMaker(const MakerContext& context) : context_(context), speaker_(context.lesson) {}

  void check(const PlannedPicture& picture) override {
    const Shown shown = shown_in(picture);
    static_cast<void>(page_of(picture, shown));
  }

  MadePicture make(const PlannedPicture& picture) override {
    const Shown shown = shown_in(picture);
    const Page page = page_of(picture, shown);
    MadePicture made;
    made.image = or_fail(context_.renderer.draw(page.sheet, page.insets, context_.options.size,
                                                background_of(context_.options)));
    made.alt = speaker_.words_of_page(*picture.stage, page.whole_from, picture.step);
    for (const Equation* equation : page.equations) made.tex.push_back(equation->tex);
    if (!shown.model) return made;
    made.t_s = shown.t_s;
    made.method = shown.model->motion->method();
    made.alt +=
        " Figure: " + alt_text(*picture.scene, speaker_.words_of_caption(*picture.stage, picture.step),
                               shown.model->motion->w_B_at(shown.t_s), shown.t_s);
    return made;
  }

 private:
  struct Shown {
    const SceneModel* model = nullptr;
    double t_s = 0;
  };

  Shown shown_in(const PlannedPicture& picture) {
    if (!picture.scene) return {};
    const SceneModel& model = models_.of(*picture.scene);
    const double t_s = time_of(picture, context_.options, model.rate);
    check_computable(*picture.stage, model, t_s);
    return {&model, t_s};
  }

  Page page_of(const PlannedPicture& picture, const Shown& shown) const {
    return compose_page({.lesson = context_.lesson,
                         .stage = *picture.stage,
                         .number = picture.number,
                         .step = picture.step,
                         .model = shown.model,
                         .t_s = shown.t_s,
                         .size = context_.options.size,
                         .theme = context_.options.theme},
                        context_.renderer.fonts());
  }

  MakerContext context_;
  Speaker speaker_;
  ModelOfScene models_{Product::page};
};

}  // namespace

std::unique_ptr<PictureMaker> make_page_maker(const MakerContext& context) {
  return std::make_unique<PageMaker>(context);
}

}  // namespace polhode
