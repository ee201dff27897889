// SPDX-License-Identifier: MIT
// What is to be said of a symbol, term or link that is pointed at.
#pragma once

#include "lessons/reader/lesson.h"
#include "render/scene/model/model.h"

#include <string>

namespace polhode {

struct SymbolNote {
  /// "angular velocity"; of a term its formula in words; of a link where it leads, of a citation what is
  /// cited; empty: nothing is known of it
  std::string meaning;
  std::string unit;  ///< "rad/s"; may be empty
  /// "(0.31, −0.20, 1.13)", "2.94", "3.10·10⁻⁶", with the lesson's decimal mark; empty where the scene has
  /// none
  std::string value;
  std::string frame;  ///< of the value's components: "space" or "body"; empty for scalars
};

/// `model` may be null. The value is that of the quantity of claims with the symbol's name
/// (lessons/claims/expressions/expression_names.h) at t, in the frame of the scene's first view, with three
/// digits of the largest component; of I the principal moments. Nothing of the centre of mass where it does
/// not drift, and of A where it is not shown. Symbols come before terms. Several terms have one name: that
/// which the reader has seen last is meant, in the stage of this id up to the step (from 0); without a stage
/// the first of the lesson. Some 10 µs.
SymbolNote note_of(const Lesson& lesson, const std::string& name, const SceneModel* model, double t_s,
                   const std::string& stage_id = {}, std::size_t step = 0);

/// A number for people, of so many digits, at least one: "−12.0", "1.03·10³⁸", "0". Empty where it is none.
std::string readable(double value, int digits = 3);
/// Of a vector's components, so many digits of the largest: "(0.90, −0.31, 0.02)".
std::string readable(const Vec3& components, int digits = 3);
/// A number that a format has made, its hyphens as minus signs.
std::string with_minus(std::string number);

}  // namespace polhode
