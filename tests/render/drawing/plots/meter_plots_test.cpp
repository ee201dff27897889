// SPDX-License-Identifier: MIT
#include "render/drawing/plots/meter_plots.h"

#include "physics/body/euler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

namespace polhode {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
const std::vector<PlotSpec> kAll = {Meter::omega, Meter::energy, Meter::momentum, Meter::drift};

SceneModel page_of(Scene scene, std::vector<PlotSpec> meters = kAll) {
  scene.meters = std::move(meters);
  return make_model(scene, ModelFor::page);
}

Scene driven_top() {
  Scene scene;
  scene.w0_B = {0.2, 0.1, 30};
  scene.attitude = Quat(0.8, 0.6, 0, 0);
  scene.torque = {HeavyTop{1.0, Vec3(0, 0, 1)}};
  return scene;
}

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

TEST(MeterPlots, ShowTheNumbersOfTheMotion) {
  const SceneModel model = page_of(driven_top());
  const std::vector<TimePlot> plots = meter_plots(model, 0.3);
  ASSERT_EQ(plots.size(), 4u);
  const PrincipalMoments& I = model.scene.body.moments;
  for (std::size_t k = 0; k < plots[0].t.size(); k += 50) {
    const RigidBodyState state = model.motion->at(plots[0].t[k]);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(plots[0].series[static_cast<std::size_t>(i)].y[k], state.w_B[i]);
    EXPECT_EQ(plots[1].series[0].y[k], kinetic_energy(I, state.w_B));
    const Vec3 L_S = angular_momentum_S(I, state);
    EXPECT_EQ(plots[2].series[0].y[k], angular_momentum_B(I, state.w_B).stableNorm());
    for (int i = 0; i < 3; ++i) EXPECT_EQ(plots[2].series[static_cast<std::size_t>(i) + 1].y[k], L_S[i]);
  }
  for (const TimePlot& plot : plots) EXPECT_EQ(plot.now, 0.3);
}

TEST(MeterPlots, DriftIsFromTheStart) {
  const SceneModel model = page_of(driven_top(), {Meter::drift});
  const TimePlot plot = meter_plots(model, 0).front();
  const PrincipalMoments& I = model.scene.body.moments;
  const RigidBodyState start = problem_of(model.scene).start;
  const Vec3 L0 = angular_momentum_S(I, start);
  const double T0 = kinetic_energy(I, start.w_B);
  EXPECT_EQ(plot.t.front(), 0.0);
  EXPECT_EQ(plot.t.back(), model.span_s);
  const RigidBodyState end = model.motion->at(model.span_s);
  const Vec3 L = angular_momentum_S(I, end);
  // The last point holds the largest of its group: here the last, because all of them grow.
  constexpr double kRounding = 64 * kEpsilon;  // of quotients and roots near 1
  EXPECT_GE(plot.series[0].y.back(), std::abs(kinetic_energy(I, end.w_B) / T0 - 1) - kRounding);
  EXPECT_GE(plot.series[1].y.back(), std::abs(L.norm() / L0.norm() - 1) - kRounding);
  EXPECT_GE(plot.series[2].y.back(), std::atan2(L0.cross(L).norm(), L0.dot(L)) - kRounding);
  EXPECT_GT(largest(plot.series[2].y), 1e-3) << "a torque that turns nothing";
}

TEST(MeterPlots, AFreeMotionInClosedFormDriftsByRoundingAlone) {
  Scene scene;
  scene.w0_B = {0.5, 2, 1};
  const TimePlot plot = meter_plots(page_of(scene, {Meter::drift}), 1).front();
  ASSERT_EQ(plot.series.size(), 3u);
  for (const TimeSeries& series : plot.series) EXPECT_LT(largest(series.y), 64 * kEpsilon) << series.label;
}

TEST(MeterPlots, AnIntegratorDriftsByMore) {
  Scene scene;
  scene.w0_B = {0.5, 2, 1};
  scene.motion = {.method = Method::explicit_euler, .step_s = 0.01};
  const TimePlot plot = meter_plots(page_of(scene, {Meter::drift}), 1).front();
  ASSERT_EQ(plot.series.size(), 3u);
  for (const TimeSeries& series : plot.series) EXPECT_GT(largest(series.y), 1e-4) << series.label;
}

TEST(MeterPlots, TheWindowHoldsTheMarkedTimeAndStandsStillWithinIt) {
  const SceneModel model = page_of({}, {Meter::omega});
  const double span = model.span_s;
  const auto window = [&](double t) {
    const TimePlot plot = meter_plots(model, t).front();
    return std::pair(plot.t.front(), plot.t.back());
  };
  EXPECT_EQ(window(0), std::pair(0.0, span));
  EXPECT_EQ(window(0.3 * span), std::pair(0.0, span));
  EXPECT_EQ(window(span), std::pair(0.0, span));
  EXPECT_EQ(window(1.2 * span), std::pair(span, 2 * span));
  EXPECT_EQ(window(-0.2 * span), std::pair(-span, 0.0));
  for (double t : {1e6 * span, 1e17 * span, -1e300}) {
    EXPECT_LE(window(t).first, t);
    EXPECT_GE(window(t).second, t);
    EXPECT_LT(window(t).first, window(t).second);
  }
}

TEST(MeterPlots, NoTimeIsBeyondWhatTheMotionIsToBeAskedFor) {
  Scene scene;
  scene.motion = {.method = Method::rk4, .step_s = 1e-5};
  scene.duration_s = 1e6;
  const SceneModel model = page_of(scene, {Meter::omega});
  const TimePlot plot = meter_plots(model, 1).front();
  EXPECT_LE(plot.t.back(), model.reach_s);
  EXPECT_LT(model.reach_s, 1e3);
  for (double y : plot.series[2].y) EXPECT_TRUE(std::isfinite(y));
}

TEST(MeterPlots, ExtremeAndRestingBodiesHaveThemToo) {
  for (double size : {0.0, 1e-150, 1e-20, 1e100, 1e150}) {
    Scene scene;
    scene.w0_B = size * Vec3(1, 2, 1);
    const auto plots = meter_plots(page_of(scene), 0);
    ASSERT_EQ(plots.size(), 4u);
    EXPECT_LT(plots[0].t.front(), plots[0].t.back()) << size;
    for (const TimeSeries& series : plots[0].series)
      for (double y : series.y) EXPECT_TRUE(std::isfinite(y)) << size;
    for (const TimeSeries& series : plots[3].series) EXPECT_LT(largest(series.y), 64 * kEpsilon) << size;
  }
}

TEST(MeterPlots, AFigureHasNone) {
  Scene scene;
  scene.meters = kAll;
  EXPECT_TRUE(meter_plots(make_model(scene), 0).empty());
  EXPECT_TRUE(meter_plots(page_of(scene, {}), 0).empty());
}

/// A quantity that a lesson might have.
SceneQuantity quantity(const std::string& name, std::function<double(double t_s, const Vec3& w_B)> value,
                       const std::string& role = "") {
  return {
      .text = name,
      .tex = name,
      .fingerprint = name,
      .unit = "rad/s",
      .role = role,
      .value = [value](const SceneModel&, double t_s, const RigidBodyState& state) -> std::optional<Vec3> {
        const double now = value(t_s, state.w_B);
        return std::isfinite(now) ? std::optional(Vec3(now, 0, 0)) : std::nullopt;
      }};
}

SceneQuantity component(int i) {
  return quantity(
      "w" + std::to_string(i + 1), [i](double, const Vec3& w_B) { return w_B[i]; }, "omega");
}

TEST(MeterPlots, OwnQuantitiesAreInTheUnitOfTheirPlot) {
  OwnPlot own{.curves = {component(1)}, .title = "A title", .tex = {"w"}, .y = {"mrad/s", 1000}};
  own.range = std::pair(-1.0, 2.0);
  const SceneModel model = page_of({}, {own, Meter::omega});
  ASSERT_EQ(meter_count(model), 2u);
  const auto plots = meter_plots(model, 0.2);
  EXPECT_EQ(plots[0].title, "A title");
  EXPECT_EQ(plots[0].unit, "mrad/s");
  EXPECT_EQ(plots[0].series[0].label, "$w$");
  EXPECT_EQ(plots[0].range, own.range);
  EXPECT_EQ(plots[0].now, 0.2);
  for (std::size_t k = 0; k < plots[0].t.size(); k += 30)
    EXPECT_EQ(plots[0].series[0].y[k], plots[1].series[1].y[k] * 1000);
}

TEST(MeterPlots, OwnCurvesAreToldApart) {
  OwnPlot own;
  for (int i = 0; i < static_cast<int>(kMaxCurves); ++i)
    own.curves.push_back(quantity(
        "q" + std::to_string(i), [](double, const Vec3& w_B) { return w_B[0]; }, i == 2 ? "polhode" : ""));
  const auto series = meter_plots(page_of({}, {own}), 0).front().series;
  EXPECT_EQ(series[2].role.ink, kPolhodeRole.ink) << "a symbol keeps its colour";
  for (std::size_t i = 0; i < series.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_NE(series[i].dash, series[k].dash) << "in print";
      EXPECT_FALSE(series[i].role.ink == series[k].role.ink) << i << ' ' << k;
    }
}

TEST(MeterPlots, OfAnglesAreNotTornWhereTheyComeRound) {
  const auto turning = [](double t_s, const Vec3&) { return std::remainder(3 * t_s, 2 * std::numbers::pi); };
  OwnPlot own{.curves = {quantity("phi", turning)}, .y = {"deg", 180 / std::numbers::pi}};
  const auto largest_step = [](const std::vector<double>& y) {
    double largest = 0;
    for (std::size_t i = 1; i < y.size(); ++i) largest = std::max(largest, std::abs(y[i] - y[i - 1]));
    return largest;
  };
  const SceneModel model = page_of({}, {own});
  EXPECT_LT(largest_step(meter_plots(model, 0)[0].series[0].y), 90);
  own.range = std::pair(-180.0, 180.0);
  const SceneModel ranged = page_of({}, {own});
  EXPECT_GT(largest_step(meter_plots(ranged, 0)[0].series[0].y), 270);
}

TEST(MeterPlots, WhatIsNotDefinedLeavesGaps) {
  const SceneModel model = page_of({}, {OwnPlot{.curves = {quantity("gap", [](double t_s, const Vec3&) {
                                                  return t_s > 0.5 ? std::nan("") : 1.0;
                                                })}}});
  const TimePlot plot = meter_plots(model, 0).front();
  EXPECT_EQ(plot.series[0].y.front(), 1.0);
  EXPECT_TRUE(std::isnan(plot.series[0].y.back()));
}

TEST(MeterPlots, APathIsMarkedWhereTheMotionIs) {
  OwnPlot own{.curves = {component(1)}, .against = component(0)};
  own.is_scaled_alike = true;
  const SceneModel model = page_of({}, {own});
  const TimePlot plot = meter_plots(model, 0.7).front();
  const Vec3 now = model.motion->at(0.7).w_B;
  EXPECT_TRUE(plot.is_path && plot.is_scaled_alike);
  EXPECT_EQ(plot.now, now[0]);
  EXPECT_EQ(plot.y_now, std::vector<double>{now[1]});
  EXPECT_EQ(plot.title, "$w2$ against $w1$");
  EXPECT_EQ(plot.t.front(), model.scene.w0_B[0]);
}

TEST(MeterPlots, AFunctionIsDrawnAroundItsLevel) {
  PlotFunction well{.text = "1/(1 - x^2)",
                    .tex = "U",
                    .variable = "x",
                    .fingerprint = "U",
                    .of = component(0),
                    .from = -1,
                    .to = 1,
                    .level = quantity("E", [](double, const Vec3&) { return 1.25; }),
                    .values = {}};
  well.values = [](const SceneModel&, const std::vector<double>& x) {
    std::vector<double> y;
    for (double at : x) y.push_back(1 / (1 - at * at));
    return y;
  };
  const SceneModel model = page_of({}, {OwnPlot{.function = well}});
  const TimePlot plot = meter_plots(model, 0.7).front();
  ASSERT_EQ(plot.series.size(), 2u);
  EXPECT_EQ(plot.now, model.motion->at(0.7).w_B[0]);
  EXPECT_EQ(plot.series[1].y.front(), 1.25);
  ASSERT_TRUE(plot.range);
  // The bottom is 1, the level 1.25; the poles at ±1 are not what is to be seen.
  EXPECT_LT(plot.range->first, 1.0);
  EXPECT_GT(plot.range->second, 1.25);
  EXPECT_LT(plot.range->second, 2.0);
}

TEST(MeterPlots, ComponentsHaveTheColoursOfTheirAxes) {
  const TimePlot omega = meter_plots(page_of(driven_top(), {Meter::omega}), 0).front();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(omega.series[i].role.paint, kBodyAxisRoles[i].paint);

  OwnPlot own;
  for (const char* tex : {"I_1\\,\\omega_1^2", "T_{2}", "\\text{row 3}", "2T", "\\omega_1\\omega_2"}) {
    SceneQuantity quantity;
    quantity.tex = tex;
    quantity.value = [](const SceneModel&, double, const RigidBodyState&) {
      return std::optional<Vec3>(Vec3(1, 0, 0));
    };
    own.curves.push_back(quantity);
  }
  const TimePlot plot = meter_plots(page_of(driven_top(), {own}), 0).front();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(plot.series[i].role.paint, kBodyAxisRoles[i].paint) << i;
  for (std::size_t i = 3; i < 5; ++i)
    for (const Role& axis : kBodyAxisRoles) EXPECT_NE(plot.series[i].role.paint, axis.paint) << i;
}

TEST(MeterPlots, ALogarithmicAxisLeavesOutWhatIsNotAboveZero) {
  OwnPlot own;
  SceneQuantity quantity;
  quantity.value = [](const SceneModel&, double t_s, const RigidBodyState&) {
    return std::optional<Vec3>(Vec3(t_s, 0, 0));
  };
  own.curves.push_back(quantity);
  own.is_log = true;
  const TimePlot plot = meter_plots(page_of(driven_top(), {own}), 0).front();
  ASSERT_TRUE(plot.log_floor);
  EXPECT_EQ(*plot.log_floor, plot.t[1]) << "the least that is drawn";
  EXPECT_TRUE(std::isnan(plot.series[0].y[0])) << "0 has no logarithm";
  own.range = std::pair(1e-4, 1.0);
  EXPECT_EQ(meter_plots(page_of(driven_top(), {own}), 0).front().log_floor, 1e-4);
}

}  // namespace
}  // namespace polhode
