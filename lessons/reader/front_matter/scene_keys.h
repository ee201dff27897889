// SPDX-License-Identifier: MIT
// Keys of a scene, in the front matter's [scene] and in ```scene fences.
#pragma once

#include "lessons/reader/front_matter/keys.h"
#include "lessons/reader/front_matter/quantity_key.h"
#include "lessons/reader/front_matter/top_start.h"
#include "lessons/reader/markdown/inline_text.h"
#include "render/scene/description/scene.h"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// Limits that bound the memory of the complete scenes of all steps.
inline constexpr std::size_t kMaxCaptionCharacters = 120;
inline constexpr std::size_t kMaxTorqueTerms = 4;
inline constexpr std::size_t kMaxHighlights = 4;

/// A key as FORMAT.md has it in its table, in Markdown.
struct SceneKeyFacts {
  std::string_view name;
  std::string value;  ///< with the limits that its reader holds it to
  std::string_view usual;
};
/// In the order in which a scene is written.
std::vector<SceneKeyFacts> scene_key_facts();

/// The keys of a ```scene block, without the fence: all that differs from Scene{}, a line each, with numbers
/// that read back as the same doubles. `still` is still_s, so that a picture has the same pixels as what is
/// shown then. The body is named: what stands for it in the front matter is another matter.
std::string scene_keys_text(Scene scene, double still_s);

/// Every key of the scene that has a value, a line each as above; what a lesson need not say, because it is
/// so anyway, ends with "# default". What follows from the rest (such as `duration`) is filled in: read in
/// the same lesson, it is the same picture.
std::string all_scene_keys_text(const Scene& scene);

/// The unit quaternion of the four numbers w, x, y, z of the key `attitude`, which are not all zero.
Quat attitude_from(const std::vector<double>& wxyz);

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
  std::optional<TopStart> start = {};  ///< in place of ω and attitude of the scene
  bool fault_said = false;             ///< it cannot be, and was reported
  std::string same = {};               ///< of the last fence: why the picture stays (Step::same)
  std::string from = {};               ///< likewise: what the slide recalls, as it is written (Step::from)
  /// Tables that change it to the scenes side by side, which are shown in its place; null: it is shown alone.
  std::shared_ptr<const TomlArray> scenes = {};
  std::vector<SourcePlace> vary_places =
      {};  ///< of the numbers in Scene::vary, whose values are not known yet
};

/// What a scene shows: itself, or its scenes side by side, each complete; the first is the one whose motion
/// the page speaks of. What is wrong with their tables is reported once, however often they are read anew.
/// `highlighted` gets what they highlight.
std::vector<LessonScene> side_by_side(const LessonScene& scene, const LessonBodies& bodies,
                                      const SceneWords& words, TextReader& texts,
                                      std::vector<PlacedText>& highlighted);

/// The scene with another motion: by those keys of a table that begins at `begin` which speak of the body and
/// how it moves. Others are errors, but `head` and `at`, which rows of tables have besides.
LessonScene changed_motion(LessonScene scene, const TomlTable& table, SourcePlace begin,
                           const LessonBodies& bodies, const SceneWords& words, TextReader& texts);

/// The first of the scenes with the others beside it.
Scene finished(const std::vector<LessonScene>& scenes, const LessonBodies& bodies);

/// The scene as it is to be modelled: "weight" is a HeavyTop, the first of its torques; a body known by its
/// shape or held at its `pivot_m` has its moments about the pivot (physics/body/pivot.h); a `start` is the ω
/// and attitude it stands for. Where one of them cannot be had, the reading has said so.
Scene finished(const LessonScene& scene, const LessonBodies& bodies);
/// The same, or what stands in the way of it.
Result<Scene, SceneFault> finished_or_fault(const LessonScene& scene, const LessonBodies& bodies);

/// Changes `scene` by the keys of a table; a key replaces its whole value. `fence` is where a scene that is
/// shown begins; without one it is the front matter's, whose body, torque or start the stages may give.
/// @return what the table highlights, with places; the names are not checked here.
std::vector<PlacedText> read_scene_keys(const TomlTable& table, const LessonBodies& bodies,
                                        const SceneWords& words, LessonScene& scene, TextReader& texts,
                                        std::optional<SourcePlace> fence = {});

}  // namespace polhode
