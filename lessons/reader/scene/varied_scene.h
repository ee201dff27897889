// SPDX-License-Identifier: MIT
// The key `vary`: numbers of a scene that its readers may change, by a slider or along a filmstrip.
#pragma once

#include "base/result.h"
#include "lessons/reader/scene/scene_keys.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// A number that can be varied.
struct VariedNumber {
  std::string_view name;   ///< as lessons have it: "omega3"
  std::string_view tex;    ///< "\omega_3"
  std::string_view label;  ///< "ω3", beside a slider
  std::string_view unit;   ///< "rad/s"
};
/// All of them, in the order of FORMAT.md.
std::span<const VariedNumber> varied_numbers();
/// Null: there is none of this name.
const VariedNumber* find_varied_number(std::string_view name);

/// Whether it is a number of a `start`.
bool is_of_start(std::string_view name);

/// The number as the scene has it, or why the scene has none that can be varied.
Result<double, SceneFault> number_of(const LessonScene& scene, const LessonBodies& bodies,
                                     std::string_view name);

/// A scene whose numbers can be changed after it was read.
class VariedScene {
 public:
  /// `scene` varies numbers that it has (number_of).
  VariedScene(LessonScene scene, const LessonBodies& bodies);

  /// The scene of the lesson, with nothing beside it.
  const Scene& alone() const { return alone_; }
  /// The same with other values of its numbers, in their order; the error says why it cannot be. Whether its
  /// motion can be computed is another question (check_scene).
  Result<Scene> at(const std::vector<double>& values) const;
  /// The scene of the lesson between the scenes at the ends of the first number's range, or, where it is
  /// itself at an end, beside those at the middle and at the other end; each is labelled with its value. The
  /// error: why one of them cannot be.
  Result<Scene> strip() const;

 private:
  LessonScene written_;
  LessonBodies own_;  ///< its body, if that is one of the lesson
  Scene alone_;
};

}  // namespace polhode
