// SPDX-License-Identifier: MIT
#include "render/scene/description/overlay.h"

#include <algorithm>
#include <array>

namespace polhode {
namespace {

constexpr std::array<std::string_view, kOverlayCount> kNames = {"shape",
                                                                "energy-ellipsoid",
                                                                "momentum-sphere",
                                                                "momentum-ellipsoid",
                                                                "omega",
                                                                "L",
                                                                "N",
                                                                "axes-body",
                                                                "axes-space",
                                                                "polhode",
                                                                "polhode-family",
                                                                "separatrix",
                                                                "herpolhode",
                                                                "plane",
                                                                "trail-L",
                                                                "trail-omega",
                                                                "cones",
                                                                "labels",
                                                                "values",
                                                                "turn-orders",
                                                                "p",
                                                                "v",
                                                                "F",
                                                                "puck",
                                                                "transport",
                                                                "terms",
                                                                "pivot",
                                                                "tensor-bars",
                                                                "cofactors",
                                                                "cyclic-wheel",
                                                                "energy-rows",
                                                                "momentum-rows",
                                                                "cards",
                                                                "method-table",
                                                                "order-plot"};

}  // namespace

std::string_view name_of(Overlay overlay) { return kNames[static_cast<std::size_t>(overlay)]; }

std::optional<Overlay> overlay_from(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Overlay>(found - kNames.begin());
}

const std::vector<std::string>& overlay_names() {
  static const std::vector<std::string> names(kNames.begin(), kNames.end());
  return names;
}

}  // namespace polhode
