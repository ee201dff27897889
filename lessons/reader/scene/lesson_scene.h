// SPDX-License-Identifier: MIT
// A scene as the keys of a lesson say it, and the complete scene that it stands for.
#pragma once

#include "base/result.h"
#include "lessons/diagnostics/source_text.h"
#include "lessons/reader/front_matter/keys.h"
#include "lessons/reader/scene/top_start.h"
#include "physics/body/bodies.h"
#include "render/scene/description/scene.h"
#include "render/typeset/rich_text.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace polhode {

/// The lesson's own bodies; other names are those of physics/body/bodies.h.
struct LessonBodies {
  std::map<std::string, Body> named;
  std::set<std::string> drawn;  ///< of these: known by their moments, though they have a shape to be drawn
  /// Of these: where it is held, m, from the centre of mass, about which its moments are then given.
  std::map<std::string, Vec3> pivots_m;
  bool complete = true;  ///< false after an error in one: an unknown name is then no second error
};

/// A scene as its keys say it, for later keys to change.
struct LessonScene {
  Scene scene;  ///< its body with moments about the centre of mass, if it has others
  std::shared_ptr<const RichText> caption;  ///< Scene::caption, ready to be set; null: none
  /// What the marks of each key write in the figure, ready to be set.
  std::map<std::string, std::shared_ptr<const RichText>> labels{};
  std::vector<PlacedText> shown{};     ///< the overlays of Scene::show, as they are written
  bool weighs = false;                 ///< torque = "weight", besides scene.torque
  bool falls = false;                  ///< force = "weight", in place of that of the scene
  std::optional<TopStart> start = {};  ///< in place of ω and attitude of the scene
  bool fault_said = false;             ///< it cannot be, and was reported
  std::string same = {};               ///< of the last fence: why the picture stays (Step::same)
  std::string from = {};               ///< likewise: what the slide recalls, as it is written (Step::from)
  /// Tables that change it to the scenes side by side, which are shown in its place; null: it is shown alone.
  std::shared_ptr<const TomlArray> scenes = {};
  std::vector<SourcePlace> vary_places =
      {};  ///< of the numbers in Scene::vary, whose values are not known yet
};

/// The first of the scenes with the others beside it.
Scene finished(const std::vector<LessonScene>& scenes, const LessonBodies& bodies);

/// The scene as it is to be modelled: "weight" is a HeavyTop, the first of its torques, or the force on the
/// mass of a body that falls; a body known by its
/// shape or held at its `pivot_m` has its moments about the pivot (physics/body/pivot.h); a `start` is the ω
/// and attitude it stands for. Where one of them cannot be had, the reading has said so.
Scene finished(const LessonScene& scene, const LessonBodies& bodies);
/// The same, or what stands in the way of it.
Result<Scene, SceneFault> finished_or_fault(const LessonScene& scene, const LessonBodies& bodies);

/// A scene with what stands in the way of it; it is complete if nothing does.
struct FinishedScene {
  Scene scene;
  std::optional<SceneFault> of_weight = {};  ///< its torque or the moments about the pivot
  std::optional<SceneFault> of_start = {};
};
FinishedScene finish(const LessonScene& scene, const LessonBodies& bodies);

bool has_heavy(const Torque& torque);

}  // namespace polhode
