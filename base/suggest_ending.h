// SPDX-License-Identifier: MIT
// "Did you mean" as the end of a sentence.
#pragma once

#include "base/suggest.h"

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// `; did you mean "omega"?`, or nothing if no known name is near.
inline std::string did_you_mean(std::string_view typed, const std::vector<std::string>& known) {
  const auto nearest = nearest_name(typed, known);
  return nearest ? "; did you mean \"" + *nearest + "\"?" : "";
}

}  // namespace polhode
