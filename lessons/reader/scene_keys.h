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
#include <vector>

namespace polhode {

/// Limits that bound the memory of the complete scenes of all steps.
inline constexpr std::size_t kMaxCaptionCharacters = 120;
inline constexpr std::size_t kMaxTorqueTerms = 4;
inline constexpr std::size_t kMaxHighlights = 4;

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
};

/// The scene as it is to be modelled: a body known by its shape that hangs on a pivot under `heavy` has its
/// moments about that (render/scene/model/rotor.h). The scene that later keys change keeps those about the
/// centre of mass. Where they cannot be had, the reading has said so.
Scene finished(const Scene& scene, const LessonBodies& bodies);

/// Changes `scene` by the keys of a table; a key replaces its whole value.
/// @return what the table highlights, with places; the names are not checked here.
std::vector<PlacedText> read_scene_keys(const TomlTable& table, const LessonBodies& bodies,
                                        LessonScene& scene, TextReader& texts);

}  // namespace polhode
