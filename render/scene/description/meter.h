// SPDX-License-Identifier: MIT
// What the plots of a page can show of a motion. To add one: a line here, one in meter.cpp's table, its
// curves in meter_plots.cpp.
#pragma once

#include "render/scene/description/scene_quantity.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace polhode {

enum class Meter {
  omega,     ///< ω₁, ω₂, ω₃, rad/s
  energy,    ///< T, J
  momentum,  ///< |L|, kg m²/s; under torque also its components in space
  drift,     ///< how far T, |L| and the direction of L are from their start; logarithmic
};
inline constexpr int kMeterCount = static_cast<int>(Meter::drift) + 1;

/// Plots of a page, and curves of one plot.
inline constexpr std::size_t kMaxPlots = 6, kMaxCurves = 6;

/// A plot of the lesson's own: scalars against time, at least one.
struct OwnPlot {
  std::vector<SceneQuantity> curves;
  bool operator==(const OwnPlot&) const = default;
};

/// One plot of a page.
using PlotSpec = std::variant<Meter, OwnPlot>;

/// "omega", "energy", … as in lessons.
std::string_view name_of(Meter meter);
std::optional<Meter> meter_from(std::string_view name);
/// All names in the order of the enumeration (for "did you mean").
const std::vector<std::string>& meter_names();

}  // namespace polhode
