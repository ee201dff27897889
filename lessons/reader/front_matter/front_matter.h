// SPDX-License-Identifier: MIT
// The TOML between the +++ lines at the top of a lesson.
#pragma once

#include "lessons/claims/expressions/dimension.h"
#include "lessons/notation/tex_equation.h"
#include "lessons/reader/front_matter/about_keys.h"
#include "lessons/reader/front_matter/assumptions.h"
#include "lessons/reader/lesson.h"
#include "lessons/reader/markdown/inline_text.h"
#include "lessons/reader/scene/scene_keys.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace polhode {

struct FrontMatter {
  std::string id;
  std::string title;
  std::map<std::string, Symbol> symbols;
  LessonBodies bodies;
  LessonScene scene;          ///< what every stage starts from
  EquationNotation notation;  ///< how its formulas are read: its symbols and words, and what x, y, z are
  std::map<int, Dimension> dimensions;  ///< of its constants, as far as they have a unit
  Assumptions assumptions;              ///< what its claims and questions can be given
  AboutKeys about;
  /// What its scenes can speak of.
  SceneWords words() const { return {&notation.vocabulary, &dimensions, &symbols, quantities.get()}; }
  std::shared_ptr<QuantitiesRead> quantities = std::make_shared<QuantitiesRead>();
  int next_line = 1;  ///< first line after the closing +++
};

/// Whether it is checked that a symbol is printed, said and coloured as what it means, which takes most of
/// the time, or known from an earlier reading.
enum class Meanings { checked, known };
/// Reports what is wrong and goes on with defaults. The author's macros go to `texts`.
FrontMatter read_front_matter(TextReader& texts, Meanings meanings = Meanings::checked);

inline constexpr std::size_t kMaxMacros = 64;
/// Constants, definitions and symbols. Each atom of a formula is compared with each.
inline constexpr std::size_t kMaxSymbols = 200;

/// Roles a symbol's colour can have.
const std::vector<std::string>& color_roles();

}  // namespace polhode
