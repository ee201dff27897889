// SPDX-License-Identifier: MIT
#include "app/alt_text.h"
#include "app/manifest.h"
#include "app/or_fail.h"
#include "app/picture_maker.h"
#include "app/speaker.h"

#include <fmt/format.h>

namespace polhode {

namespace {

class FigureMaker : public PictureMaker {
 public:
  explicit FigureMaker(const MakerContext& context) : context_(context), speaker_(context.lesson) {}

  void check(const PlannedPicture& picture) override {
    const SceneModel& model = models_.of(*picture.scene);
    check_computable(*picture.stage, model, time_of(picture, context_.options, model.rate));
  }

  MadePicture make(const PlannedPicture& picture) override {
    const SceneModel& model = models_.of(*picture.scene);
    const ExportOptions& options = context_.options;
    const double t_s = time_of(picture, options, model.rate);
    check_computable(*picture.stage, model, t_s);
    const double aspect = static_cast<double>(options.size.width) / options.size.height;
    Image image = or_fail(
        context_.renderer.draw(make_figure(model, t_s, aspect), options.size, background_of(options)));
    const std::string alt = speaker_.words_of_title(*picture.stage) + ' ' +
                            alt_text(*picture.scene, speaker_.words_of_caption(*picture.stage, picture.step),
                                     model.motion->w_B_at(t_s), t_s);
    return {std::move(image), alt, tex_shown(*picture.stage, picture.step), t_s,
            std::string(model.motion->method())};
  }

 private:
  MakerContext context_;
  Speaker speaker_;
  ModelOfScene models_{Product::figure};
};

}  // namespace

const SceneModel& ModelOfScene::of(const Scene& scene) {
  if (scene_ != &scene) {
    model_ = make_model(scene, product_);
    scene_ = &scene;
  }
  return model_;
}

void check_computable(const Stage& stage, const SceneModel& model, double t_s) {
  const bool finite = model.needs.attitude ? model.motion->at(t_s).w_B.allFinite() &&
                                                 model.motion->at(t_s).q_SB.coeffs().allFinite()
                                           : !model.needs.omega || model.motion->w_B_at(t_s).allFinite();
  if (!finite)
    throw CommandError(
        ExitCode::failed,
        fmt::format("stage \"{}\": the motion cannot be computed at t = {:.6g} s: the torque is too "
                    "large, or it is too many steps away",
                    stage.id, t_s));
}

std::unique_ptr<PictureMaker> make_figure_maker(const MakerContext& context) {
  return std::make_unique<FigureMaker>(context);
}

}  // namespace polhode
