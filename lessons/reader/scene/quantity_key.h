// SPDX-License-Identifier: MIT
// Quantities that a scene's keys name in the language of claims.
#pragma once

#include "lessons/claims/expressions/dimension.h"
#include "lessons/reader/front_matter/keys.h"
#include "lessons/reader/lesson.h"
#include "lessons/reader/markdown/inline_text.h"
#include "render/scene/description/scene_quantity.h"

#include <map>
#include <optional>
#include <string>

namespace polhode {

/// A quantity and what it is measured in; of 0, A, and what is made of constants without a unit none is
/// known.
struct ReadQuantity {
  SceneQuantity quantity;
  std::optional<Dimension> dimension;
  Expression expression;
};

/// Those that were read with the same words, by their texts: scenes say the same again and again.
using QuantitiesRead = std::map<std::string, ReadQuantity>;

/// What the expressions of a lesson's scenes can speak of, besides the words of the language. Null: nothing
/// more.
struct SceneWords {
  const Vocabulary* vocabulary = nullptr;
  const std::map<int, Dimension>* dimensions = nullptr;  ///< of constants, by their numbers
  const std::map<std::string, Symbol>* symbols = nullptr;
  QuantitiesRead* read = nullptr;  ///< null: none are kept
};

/// Reads a scalar or vector of the lesson that any motion has: not h and k, which are any numbers. Its unit
/// is that of the symbol of that name, else the usual name of what it is measured in; its colour that of the
/// symbol, else of the ω, L or N that it is, or is a component or the length of.
/// Nothing where it cannot be read: the report says why.
std::optional<ReadQuantity> read_quantity(const PlacedText& text, const SceneWords& words, TextReader& texts);

/// Parts of a quantity, once the lesson's words are written out: plots have some thousand values of each.
inline constexpr std::size_t kMaxQuantityNodes = 256;

/// Whether an expression speaks of what motions have alone, and is not too long; else it is reported at
/// `place`.
bool has_value_on_motions(const Expression& expression, SourcePlace place, Report& report);

/// The usual name of a unit, "J", "rad/s"; empty of a number.
std::string usual_unit(const Dimension& dimension);

}  // namespace polhode
