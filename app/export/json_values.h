// SPDX-License-Identifier: MIT
// Values of JSON that more than one file of ours has.
#pragma once

#include <nlohmann/json.hpp>

#include <cmath>
#include <istream>
#include <optional>

namespace polhode {

/// null where there is no number, or none that JSON can hold.
inline nlohmann::ordered_json number_or_null(const std::optional<double>& value) {
  if (value && std::isfinite(*value)) return *value;
  return nullptr;
}

/// What files of ours nest at most, with room. Values are copied and printed by recursion.
inline constexpr int kDeepestJson = 16;

using TakeJson = nlohmann::ordered_json::parser_callback_t;

/// A file that others may have written: discarded if it is no JSON; what is nested deeper is left out. `take`
/// chooses what is kept of the rest.
inline nlohmann::ordered_json shallow_json(std::istream& file, const TakeJson& take = {}) {
  using Json = nlohmann::ordered_json;
  return Json::parse(
      file,
      [&](int depth, Json::parse_event_t event, Json& parsed) {
        return depth <= kDeepestJson && (!take || take(depth, event, parsed));
      },
      false);
}

}  // namespace polhode
