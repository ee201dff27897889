// SPDX-License-Identifier: MIT
// What is to be said of a symbol or term that is pointed at.
#pragma once

#include "lessons/lesson.h"
#include "render/scene/model.h"

#include <string>

namespace polhode {

struct SymbolNote {
  std::string meaning;  ///< "angular velocity"; of a term its name in words
  std::string unit;     ///< "rad/s"; may be empty
  std::string value;    ///< "(0.31, −0.20, 1.13)", "2.94"; empty where the lesson's scene has none
  std::string frame;    ///< of the value's components: "space" or "body"; empty for scalars
};

/// `model` may be null. The value is that of the quantity of claims with the symbol's name
/// (lessons/expression_names.h), at t, in the frame of the scene's first view; three digits.
SymbolNote note_of(const Lesson& lesson, const std::string& name, const SceneModel* model, double t_s);

/// The overlay that shows a symbol in the scene: that of the same name; nothing if there is none. What to put
/// into Scene::highlight.
std::optional<Overlay> overlay_of_symbol(const std::string& name);

}  // namespace polhode
