// SPDX-License-Identifier: MIT
// Values of JSON that more than one file of ours has.
#pragma once

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>

namespace polhode {

/// null where there is no number, or none that JSON can hold.
inline nlohmann::ordered_json number_or_null(const std::optional<double>& value) {
  if (value && std::isfinite(*value)) return *value;
  return nullptr;
}

}  // namespace polhode
