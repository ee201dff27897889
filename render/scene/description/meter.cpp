// SPDX-License-Identifier: MIT
#include "render/scene/description/meter.h"

#include <algorithm>
#include <array>

namespace polhode {
namespace {

constexpr std::array<std::string_view, kMeterCount> kNames = {"omega", "energy", "momentum", "drift"};

}  // namespace

std::string_view name_of(Meter meter) { return kNames[static_cast<std::size_t>(meter)]; }

std::optional<Meter> meter_from(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Meter>(found - kNames.begin());
}

const std::vector<std::string>& meter_names() {
  static const std::vector<std::string> kAll(kNames.begin(), kNames.end());
  return kAll;
}

}  // namespace polhode
