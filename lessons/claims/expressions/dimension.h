// SPDX-License-Identifier: MIT
// Dimensions of expressions: whether what is added has the same, and whether a unit is that of what it stands
// for.
#pragma once

#include "lessons/claims/expressions/expression_names.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

/// "kg m²/s", "N m", "rad/s", "1": names of SI units with powers (², ^2), blanks or · between them; all that
/// stands behind the first / is below the line. Nothing for what is no such unit.
std::optional<Dimension> dimension_of_unit(std::string_view unit);

/// A unit in which numbers can be shown: besides those above, with a prefix from p to G, as "mJ", "km/s".
struct ScaledUnit {
  Dimension dimension;
  double size = 1;  ///< of SI units in it; of "deg" π/180
};
std::optional<ScaledUnit> scaled_unit(std::string_view unit);
/// The names of these, for messages.
inline constexpr std::string_view kUnitNames =
    "kg, g, m, s, N, J, W, Hz, rad, deg, ° with powers and prefixes";

/// "kg m²/s²"; "a number" of what has none.
std::string to_string(const Dimension& dimension);

/// What is wrong, and the bytes of the expression's text where it is.
struct DimensionFault {
  std::string message;
  std::size_t begin = 0;
};

struct DimensionReading {
  std::optional<Dimension>
      dimension;  ///< nothing: any, or it cannot be told (0, h, k, A, constants without a unit)
  std::optional<DimensionFault> fault;
};

/// Of constants the dimensions are given by their numbers; of others nothing is known.
DimensionReading dimension_of(const Expression& expression, const std::map<int, Dimension>& constants);

}  // namespace polhode
