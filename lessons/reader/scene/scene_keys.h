// SPDX-License-Identifier: MIT
// Keys of a scene, in the front matter's [scene] and in ```scene fences.
#pragma once

#include "lessons/reader/front_matter/keys.h"
#include "lessons/reader/markdown/inline_text.h"
#include "lessons/reader/scene/lesson_scene.h"
#include "lessons/reader/scene/quantity_key.h"
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

/// Changes `scene` by the keys of a table; a key replaces its whole value. `fence` is where a scene that is
/// shown begins; without one it is the front matter's, whose body, torque or start the stages may give.
/// @return what the table highlights, with places; the names are not checked here.
std::vector<PlacedText> read_scene_keys(const TomlTable& table, const LessonBodies& bodies,
                                        const SceneWords& words, LessonScene& scene, TextReader& texts,
                                        std::optional<SourcePlace> fence = {});

}  // namespace polhode
