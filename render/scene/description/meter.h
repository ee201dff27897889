// SPDX-License-Identifier: MIT
// What the plots of a page can show of a motion. To add one: a line here, one in meter.cpp's table, its
// curves in meter_plots.cpp.
#pragma once

#include "render/scene/description/scene_quantity.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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

/// What the numbers on an axis are: multiples of `unit`, of which one of SI has `per_si`.
struct PlotUnit {
  std::string unit;  ///< "mJ"; empty: numbers
  double per_si = 1;
  bool operator==(const PlotUnit&) const = default;
};

/// A function of a variable, with the body, and what else it speaks of, as they are at t = 0.
struct PlotFunction {
  std::string text;                    ///< as it is written
  std::string tex;                     ///< as it is printed
  std::string variable;                ///< the word for the variable in it
  std::string fingerprint;             ///< as of a SceneQuantity
  SceneQuantity of;                    ///< what the variable is on the motion
  double from = 0, to = 1;             ///< SI
  std::optional<SceneQuantity> level;  ///< a horizontal line at what it is now
  /// One value for each x, SI; NaN where it is not defined. Pure.
  std::function<std::vector<double>(const SceneModel&, const std::vector<double>& x)> values;

  bool operator==(const PlotFunction& other) const {
    return text == other.text && tex == other.tex && variable == other.variable &&
           fingerprint == other.fingerprint && of == other.of && from == other.from && to == other.to &&
           level == other.level;
  }
};

/// A plot of the lesson's own: scalars against time, or against another; or a function. One of `curves` and
/// `function` is there.
struct OwnPlot {
  std::vector<SceneQuantity> curves{};
  std::optional<SceneQuantity> against{};  ///< absent: time
  std::optional<PlotFunction> function{};
  std::string title{};             ///< empty: names what is plotted
  std::vector<std::string> tex{};  ///< names of the curves, in place of their own; empty: none
  PlotUnit y{}, x{};               ///< x is not used where that is time
  bool is_scaled_alike = false;    ///< against another quantity of the same unit
  bool is_tight = false;           ///< the axis need not show 0
  bool is_log = false;             ///< the axis is logarithmic: what is not above 0 is not drawn
  std::optional<std::pair<double, double>> range{};  ///< of the axis, in units of y
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
