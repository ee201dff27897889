// SPDX-License-Identifier: MIT
// One maker for each kind of picture that is exported.
#pragma once

#include "app/export/export_plan.h"
#include "app/page/loaded_lesson.h"
#include "base/outcome.h"
#include "render/gl/renderer.h"
#include "render/scene/model/model.h"

#include <memory>

namespace polhode {

/// What the manifest and the file say of a picture.
struct PictureDescription {
  std::string alt;
  std::vector<std::string> tex;  ///< the display mathematics in it
  std::optional<double> t_s;
  std::string method;  ///< of the motion; empty: none
  Size size;
};

/// Any picture in any order; neighbours in the plan are cheaper.
class PictureMaker {
 public:
  virtual ~PictureMaker() = default;
  /// Does what can fail without drawing.
  virtual Done check(const PlannedPicture& picture) = 0;
  /// Draws nothing, so that a process can write the manifest of pictures which others have drawn.
  virtual Outcome<PictureDescription> describe(const PlannedPicture& picture) = 0;
  virtual Outcome<Image> draw(const PlannedPicture& picture) = 0;
  /// What is drawn, before it is pixels, of a kind that lies flat: equations. Others fail.
  virtual Outcome<Sheet> sheet(const PlannedPicture& picture);
  /// Whether two pictures are known, without drawing, to have the same bytes as files. Frames of a scene
  /// never are, even where nothing in it moves: each file has its t.
  virtual bool same_bytes(const PlannedPicture&, const PlannedPicture&) const { return false; }
};

/// What a maker works with; all outlive it.
struct MakerContext {
  const Lesson& lesson;
  const ExportOptions& options;
  Renderer& renderer;
  Effort effort{};  ///< is told what motions cost
};

std::unique_ptr<PictureMaker> make_figure_maker(const MakerContext& context);
std::unique_ptr<PictureMaker> make_page_maker(const MakerContext& context);
std::unique_ptr<PictureMaker> make_equation_maker(const MakerContext& context);

/// The model of the scene asked for last: neighbours in an export mostly share it.
class ModelOfScene {
 public:
  explicit ModelOfScene(ModelFor use, Effort effort = {}) : use_(use), effort_(std::move(effort)) {}
  const SceneModel& of(const Scene& scene);

 private:
  ModelFor use_;
  Effort effort_;
  const Scene* scene_ = nullptr;
  SceneModel model_;
};

/// Behind the pictures of an export.
Background background_of(const ExportOptions& options);

/// A motion may overflow (a huge torque), or lie beyond the steps that its method takes.
Done check_computable(const Stage& stage, const SceneModel& model, double t_s);

}  // namespace polhode
