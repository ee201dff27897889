// SPDX-License-Identifier: MIT
// Keys of a scene, in the front matter's [scene] and in ```scene fences.
#pragma once

#include "lessons/inline_text.h"
#include "lessons/keys.h"
#include "render/scene/scene.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace polhode {

/// Limits that bound the memory of the complete scenes of all steps.
inline constexpr std::size_t kMaxCaptionCharacters = 120;
inline constexpr std::size_t kMaxTorqueTerms = 4;
inline constexpr std::size_t kMaxHighlights = 4;

/// The unit quaternion of the four numbers w, x, y, z of the key `attitude`, which are not all zero.
Quat attitude_from(const std::vector<double>& wxyz);

/// The lesson's own bodies; other names are those of physics/bodies.h.
struct LessonBodies {
  std::map<std::string, Body> named;
  bool complete = true;  ///< false after an error in one: an unknown name is then no second error
};

/// A scene and what it needs besides.
struct LessonScene {
  Scene scene;
  std::shared_ptr<const RichText> caption;  ///< Scene::caption, ready to be set; null: none
};

/// Changes `scene` by the keys of a table; a key replaces its whole value.
/// @return what the table highlights, with places; the names are not checked here.
std::vector<PlacedText> read_scene_keys(const TomlTable& table, const LessonBodies& bodies,
                                        LessonScene& scene, TextReader& texts);

}  // namespace polhode
