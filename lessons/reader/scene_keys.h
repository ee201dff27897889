// SPDX-License-Identifier: MIT
// Keys of a scene, in the front matter's [scene] and in ```scene fences.
#pragma once

#include "lessons/reader/keys.h"
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
  std::string_view name, value, usual;
};
/// In the order in which a scene is written.
std::vector<SceneKeyFacts> scene_key_facts();

/// The keys of a ```scene block, without the fence: all that differs from Scene{}, a line each, with numbers
/// that read back as the same doubles. `still` is still_s, so that a picture has the same pixels as what is
/// shown then. The body is named: what stands for it in the front matter is another matter.
std::string scene_keys_text(Scene scene, double still_s);

/// The unit quaternion of the four numbers w, x, y, z of the key `attitude`, which are not all zero.
Quat attitude_from(const std::vector<double>& wxyz);

/// The lesson's own bodies; other names are those of physics/body/bodies.h.
struct LessonBodies {
  std::map<std::string, Body> named;
  std::set<std::string> drawn_as_box;  ///< of these: known by their moments, though they have a shape
  bool complete = true;  ///< false after an error in one: an unknown name is then no second error
};

/// A scene and what it needs besides.
struct LessonScene {
  Scene scene;
  std::shared_ptr<const RichText> caption;  ///< Scene::caption, ready to be set; null: none
  std::vector<PlacedText> shown{};          ///< the overlays of Scene::show, as they are written
};

/// The scene as it is to be modelled: a body known by its shape that hangs on a pivot under `heavy` has its
/// moments about that (physics/body/pivot.h). The scene that later keys change keeps those about the
/// centre of mass. Where they cannot be had, the reading has said so.
Scene finished(const Scene& scene, const LessonBodies& bodies);

/// Changes `scene` by the keys of a table; a key replaces its whole value.
/// @return what the table highlights, with places; the names are not checked here.
std::vector<PlacedText> read_scene_keys(const TomlTable& table, const LessonBodies& bodies,
                                        LessonScene& scene, TextReader& texts);

}  // namespace polhode
