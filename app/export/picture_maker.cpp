// SPDX-License-Identifier: MIT
#include "app/export/picture_maker.h"

#include "app/page/page_theme.h"
#include "physics/method.h"

#include <fmt/format.h>

namespace polhode {

const SceneModel& ModelOfScene::of(const Scene& scene) {
  if (scene_ != &scene) {
    model_ = make_model(scene, use_, effort_);
    scene_ = &scene;
  }
  return model_;
}

Done check_computable(const Stage& stage, const SceneModel& model, double t_s) {
  if (is_computable(model, t_s)) return done();
  return failure_of(Fault::failed,
                    fmt::format("stage \"{}\": the motion cannot be computed at t = {:.6g} s: {}", stage.id,
                                t_s, why_no_state(*model.motion, problem_of(model.scene), t_s)));
}

Outcome<Sheet> PictureMaker::sheet(const PlannedPicture& picture) {
  return failure_of(Fault::usage,
                    fmt::format("stage \"{}\": what stands in space has no outlines", picture.stage->id));
}

Background background_of(const ExportOptions& options) {
  if (options.what != What::figure && options.background == "paper")
    return {Background::Kind::color, colors_of(options.theme).paper};
  return *background_from(options.background);
}

}  // namespace polhode
