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

  PictureDescription describe(const PlannedPicture& picture) override {
    const Shown shown = shown_in(picture);
    const Words& words = words_of(picture, shown);
    PictureDescription description{words.alt, words.tex, {}, {}, context_.options.size};
    if (!shown.model) return description;
    description.t_s = shown.t_s;
    description.method = shown.model->motion->method();
    description.alt +=
        " Figure: " + alt_text(*picture.scene, speaker_.words_of_caption(*picture.stage, picture.step),
                               shown.model->motion->w_B_at(shown.t_s), shown.t_s);
    return description;
  }

  Image draw(const PlannedPicture& picture) override {
    const Page page = page_of(picture, shown_in(picture));
    return or_fail(context_.renderer.draw(page.sheet, page.insets, context_.options.size,
                                          background_of(context_.options)));
  }

  bool same_bytes(const PlannedPicture& a, const PlannedPicture& b) const override {
    return !a.scene && a.stage == b.stage && a.step == b.step;  // nothing on it has a time
  }

 private:
  struct Shown {
    const SceneModel* model = nullptr;
    double t_s = 0;
  };

  /// What a page says apart from its figure. Its text is the same at all times: laid out once for a step.
  struct Words {
    const Stage* stage = nullptr;
    int step = 0;
    std::string alt;
    std::vector<std::string> tex;
  };

  const Words& words_of(const PlannedPicture& picture, const Shown& shown) {
    if (words_.stage == picture.stage && words_.step == picture.step) return words_;
    const Page page = page_of(picture, shown);
    words_ = {picture.stage,
              picture.step,
              speaker_.words_of_page(*picture.stage, page.whole_from, picture.step),
              {}};
    for (const Equation* equation : page.equations) words_.tex.push_back(equation->tex);
    return words_;
  }

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
  Words words_;  ///< of the last picture described
};

}  // namespace

std::unique_ptr<PictureMaker> make_page_maker(const MakerContext& context) {
  return std::make_unique<PageMaker>(context);
}

}  // namespace polhode
