// SPDX-License-Identifier: MIT
#include "render/drawing/plots/time_plot.h"

#include "tests/render/drawing/sheet_texts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polhode {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity(),
                 kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr PixelBox kBox{100, 50, 460, 210};
constexpr TimePlotStyle kStyle{.type_size = 15};

Sheet sheet_of(const TimePlot& plot, const PixelBox& box = kBox) {
  return lay_out(plot, box, kStyle, fonts());
}

void expect_tidy(const Sheet& sheet, const PixelBox& picture = kBox) {
  for (std::size_t i = 0; i < sheet.texts.size(); ++i) {
    const PixelBox box = box_of(sheet.texts[i]);
    EXPECT_NEAR(box.overlap(picture), box.width() * box.height(), 1e-6)
        << sheet.texts[i].text << " leaves its box";
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_EQ(box.overlap(box_of(sheet.texts[k])), 0.0)
          << sheet.texts[i].text << " covers " << sheet.texts[k].text;
  }
  for (const FlatShape& shape : sheet.shapes)
    for (const Vec2& p : std::get<Stroke>(shape).points) {
      EXPECT_TRUE(p.allFinite());
      EXPECT_TRUE(picture.grown(1e-6).contains(p)) << p.transpose();
    }
}

/// Strokes of that colour.
std::vector<Stroke> strokes_of(const Sheet& sheet, const Color& color) {
  std::vector<Stroke> found;
  for (const FlatShape& shape : sheet.shapes)
    if (const auto& stroke = std::get<Stroke>(shape); stroke.color == color) found.push_back(stroke);
  return found;
}

TimePlot plot_of(std::vector<std::vector<double>> curves) {
  TimePlot plot{.title = "A title", .unit = "rad/s"};
  constexpr const char* kLabels[] = {"one", "two", "three", "four"};
  constexpr Role kRoles[] = {kOmegaRole, kLRole, kPolhodeRole, kNRole};
  std::size_t n = 1;
  for (const auto& y : curves) n = std::max(n, y.size());
  for (std::size_t i = 0; i < n; ++i) plot.t.push_back(static_cast<double>(i));
  for (std::size_t i = 0; i < curves.size(); ++i) plot.series.push_back({kLabels[i], kRoles[i], curves[i]});
  return plot;
}

std::vector<double> ramp(double from, double to, std::size_t count = 11) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(std::lerp(from, to, static_cast<double>(i) / static_cast<double>(count - 1)));
  return values;
}

TEST(TimePlot, NamesAxesAndCurves) {
  const Sheet sheet = sheet_of(plot_of({ramp(0, 3), ramp(1, -1)}));
  for (const char* text : {"A title", "rad/s", "s", "one", "two", "8", "10"})
    EXPECT_EQ(texts_of(sheet, text).size(), 1u) << text;
  expect_tidy(sheet);
}

TEST(TimePlot, ANameStandsWhereItsCurveEnds) {
  const Sheet sheet = sheet_of(plot_of({ramp(0, 3), ramp(1, -1)}));
  EXPECT_LT(only_text(sheet, "one").at.y(), only_text(sheet, "two").at.y());
  const Vec2 end = strokes_of(sheet, kOmegaRole.paint)[0].points.back();
  const PixelBox name = box_of(only_text(sheet, "one"));
  EXPECT_LE(name.y0, end.y());
  EXPECT_GE(name.y1, end.y());
}

TEST(TimePlot, CurvesThatEndInOnePlaceAreNamedApart) {
  expect_tidy(sheet_of(plot_of({ramp(0, 1), ramp(2, 1), ramp(1, 1), ramp(-1, 1)})));
  expect_tidy(sheet_of(plot_of({ramp(1, 0), ramp(2, 0), ramp(3, 0), ramp(4, 0)})));
}

TEST(TimePlot, ValuesThatAreNotNumbersLeaveGaps) {
  std::vector<double> y = ramp(0, 1);
  y[4] = kNaN;
  y[8] = kInf;
  EXPECT_EQ(strokes_of(sheet_of(plot_of({y})), kOmegaRole.paint).size(), 3u);
  expect_tidy(sheet_of(plot_of({y})));
}

TEST(TimePlot, TheTimeOfThePictureIsMarkedOnEveryCurve) {
  TimePlot plot = plot_of({ramp(0, 10), ramp(10, 0)});
  plot.now = 2.5;
  const Sheet sheet = sheet_of(plot);
  for (const Color& color : {kOmegaRole.paint, kLRole.paint}) {
    const auto strokes = strokes_of(sheet, color);
    ASSERT_EQ(strokes.size(), 2u) << "a curve and a dot";
    const Vec2 dot = strokes[1].points[0], from = strokes[0].points.front(), to = strokes[0].points.back();
    EXPECT_NEAR(dot.x(), std::lerp(from.x(), to.x(), 0.25), 1.0) << "and a pixel";
    EXPECT_NEAR(dot.y(), std::lerp(from.y(), to.y(), 0.25), 1e-6);
  }
  for (double outside : {-1.0, 11.0, kNaN}) {
    plot.now = outside;
    EXPECT_EQ(strokes_of(sheet_of(plot), kOmegaRole.paint).size(), 1u) << outside;
  }
  plot.now = 2.5;
  plot.series[0].y[3] = kNaN;
  EXPECT_EQ(strokes_of(sheet_of(plot), kOmegaRole.paint).size(), 2u) << "a dot in a gap";
}

TEST(TimePlot, ALogarithmicAxisBeginsAtItsFloor) {
  TimePlot plot = plot_of({{1e-9, 1e-8, 1e-7}, {0, 1e-12, 0}, {0, 0, 0}});
  plot.log_floor = 1e-16;
  const Sheet sheet = sheet_of(plot);
  EXPECT_EQ(texts_of(sheet, "10⁻¹⁶").size(), 1u);
  EXPECT_EQ(texts_of(sheet, "three: 0").size(), 1u);
  EXPECT_EQ(texts_of(sheet, "two").size(), 1u) << "zero at times only";
  const auto zero = strokes_of(sheet, kPolhodeRole.paint), partly = strokes_of(sheet, kLRole.paint);
  ASSERT_EQ(zero.size(), 1u);
  EXPECT_EQ(zero[0].points.front().y(), zero[0].points.back().y());
  EXPECT_EQ(partly[0].points.front().y(), zero[0].points.front().y());
  const auto rising = strokes_of(sheet, kOmegaRole.paint)[0].points;
  ASSERT_EQ(rising.size(), 2u) << "equal ratios make a straight line";
  expect_tidy(sheet);
}

TEST(TimePlot, DrawsTheExtremes) {
  const std::vector<std::vector<double>> cases[] = {
      {},
      {{}},
      {{0, 0, 0}},
      {{7, 7, 7}, {7, 7, 7}},
      {{3}},
      {{kNaN, kNaN}, {kInf, -kInf}},
      {{5e-324, 0, 5e-324}},
      {{-1.7e308, 1.7e308}},
      {{1e-300, 2e-300}, {1e300, 0}},
      {ramp(1e5, 1e5 + 1e-9)},
  };
  for (const auto& curves : cases)
    for (const double begin : {0.0, -1e-100, 1e6, 1e300})
      for (const std::optional<double>& floor : {std::optional<double>(), std::optional(1e-16)}) {
        TimePlot plot = plot_of(curves);
        for (double& t : plot.t) t = begin + t * std::max(1e-100, 1e-9 * std::abs(begin));
        plot.log_floor = floor;
        plot.now = plot.t.front();
        SCOPED_TRACE(plot.series.empty() ? "none" : std::to_string(begin));
        expect_tidy(sheet_of(plot));
      }
}

TEST(TimePlot, KeepsTidyWhenSmallAndWhenLarge) {
  TimePlot plot = plot_of({ramp(0, 3), ramp(1, -1), ramp(1, -1)});
  for (const auto& [width, height] :
       {std::pair{120.0, 30.0}, {60.0, 200.0}, {240.0, 120.0}, {900.0, 600.0}}) {
    const PixelBox box{10, 20, 10 + width, 20 + height};
    expect_tidy(sheet_of(plot, box), box);
  }
}

TEST(TimePlot, ATightAxisNeedNotShowZero) {
  TimePlot plot = plot_of({ramp(100, 101)});
  const auto zeros = [](const Sheet& sheet) {
    return std::count_if(sheet.texts.begin(), sheet.texts.end(),
                         [](const PlacedType& type) { return type.text == "0"; });
  };
  EXPECT_EQ(zeros(sheet_of(plot)), 2) << "of the values and of time";
  plot.is_tight = true;
  EXPECT_LE(zeros(sheet_of(plot)), 1);
  expect_tidy(sheet_of(plot));
}

TEST(TimePlot, WhatLiesOutsideOfARangeIsNotDrawn) {
  TimePlot plot = plot_of({ramp(-10, 10), {5, -50, 5}});
  plot.range = std::pair(-1.0, 6.0);
  plot.now = 0.5;  // outside of both
  const Sheet sheet = sheet_of(plot);
  expect_tidy(sheet);
  // The ramp reaches −1 and 6 between two of its points: its ends are the lower and the upper edge.
  const auto ramp_line = strokes_of(sheet, kOmegaRole.paint);
  ASSERT_EQ(ramp_line.size(), 1u);
  const auto ys = [](const Stroke& stroke) {
    return std::pair(stroke.points.front().y(), stroke.points.back().y());
  };
  const auto [low, high] = ys(ramp_line.front());
  // Two stretches of the other, which end at the lower edge.
  const auto dip = strokes_of(sheet, kLRole.paint);
  ASSERT_EQ(dip.size(), 2u);
  EXPECT_NEAR(dip[0].points.back().y(), low, 1e-9);
  EXPECT_NEAR(dip[1].points.front().y(), low, 1e-9);
  EXPECT_LT(high, dip[0].points.front().y());
}

TEST(TimePlot, APathOfOneUnitIsDrawnToScale) {
  TimePlot plot{.title = "a circle", .unit = "rad/s"};
  plot.is_path = plot.is_scaled_alike = true;
  plot.x_label = "$\\omega_1$";
  plot.x_unit = "rad/s";
  TimeSeries circle{.label = "$\\omega_2$", .role = kOmegaRole};
  for (int i = 0; i <= 100; ++i) {
    plot.t.push_back(3 * std::cos(0.0628 * i));
    circle.y.push_back(3 * std::sin(0.0628 * i));
  }
  plot.series.push_back(circle);
  plot.now = 3;
  plot.y_now = {0};
  for (const PixelBox& box : {kBox, PixelBox{0, 0, 200, 300}}) {
    const Sheet sheet = lay_out(plot, box, kStyle, fonts());
    expect_tidy(sheet, box);
    PixelBox seen{1e9, 1e9, -1e9, -1e9};
    for (const Stroke& stroke : strokes_of(sheet, kOmegaRole.paint))
      for (const Vec2& p : stroke.points)
        if (stroke.points.size() > 2)
          seen = {std::min(seen.x0, p.x()), std::min(seen.y0, p.y()), std::max(seen.x1, p.x()),
                  std::max(seen.y1, p.y())};
    // Points of a polygon of 100 corners lie within 1 − cos(π/100) of a circle; a tenth of a px is
    // simplified.
    EXPECT_NEAR(seen.width(), seen.height(), 0.001 * seen.width() + 0.2);
  }
}

TEST(TimePlot, WithTheMarginsOfAnotherItsAxisIsThatOfTheOther) {
  const auto now_of = [](TimePlot plot, const TimePlotStyle& style) {
    plot.now = 5;
    const Sheet sheet = lay_out(plot, kBox, style, fonts());
    return std::get<Stroke>(sheet.shapes.back()).points.front().x();
  };
  TimePlot wide = plot_of({ramp(0, 12345)});
  wide.series[0].label = "a long name";
  const TimePlot narrow = plot_of({ramp(0, 1)});
  TimePlotStyle style = kStyle;
  EXPECT_GT(std::abs(now_of(narrow, style) - now_of(wide, style)), 1.0);
  style.least_margins = margins_of(wide, kBox, kStyle, fonts());
  EXPECT_EQ(now_of(narrow, style), now_of(wide, style));
}

TEST(TimePlot, ALongNameBecomesSmaller) {
  TimePlot plot = plot_of({ramp(0, 1)});
  plot.series.front().label = "$\\frac{(p_\\varphi - p_\\psi u)^2}{2 I_1 (1 - u^2)} + m g \\ell u$";
  expect_tidy(sheet_of(plot));
}

TEST(TimePlot, ALogarithmicAxisGoesAsFarAsItsRange) {
  TimePlot plot = plot_of({{1e-5, 1e-3, 1e-1}});
  plot.range = std::pair(1e-6, 1.0);
  plot.log_floor = 1e-6;
  const Sheet sheet = sheet_of(plot);
  expect_tidy(sheet);
  EXPECT_EQ(texts_of(sheet, "10⁻⁶").size(), 1u);
  EXPECT_EQ(texts_of(sheet, "10⁰").size() + texts_of(sheet, "1").size(), 1u);
  EXPECT_TRUE(texts_of(sheet, "10⁻⁸").empty());
  // Equal factors are equally far apart.
  const auto line = strokes_of(sheet, kOmegaRole.paint);
  ASSERT_EQ(line.size(), 1u);
  const double low = line[0].points.front().y(), high = line[0].points.back().y();
  EXPECT_NEAR(low - high,
              4.0 / 6.0 * (box_of(only_text(sheet, "10⁻⁶")).y0 - box_of(*texts_of(sheet, "10⁰").front()).y0),
              2.0);
}

// What a hand reads is what is drawn: the axes' rectangle, the samples, gaps where nothing is.
TEST(TimePlot, AReadingIsOfWhatIsDrawn) {
  TimePlot plot = plot_of({ramp(0, 3), {0, 1, kNaN, 3, 4, 5, 6, 7, 8, 9, 10}});
  const auto reading = reading_of(plot, kBox, kStyle, fonts());
  ASSERT_TRUE(reading);
  EXPECT_TRUE(reading->is_of_time);
  EXPECT_EQ(reading->unit, "rad/s");
  const std::vector<Stroke> curves = strokes_of(sheet_of(plot), kOmegaRole.paint);
  ASSERT_FALSE(curves.empty());
  const Vec2 begin = curves.front().points.front(), end = curves.front().points.back();
  EXPECT_NEAR(reading->frame.x0, begin.x(), 1e-9);
  EXPECT_NEAR(reading->frame.x1, end.x(), 1e-9);
  EXPECT_NEAR(reading->curves[0].y_px.front(), begin.y(), 1e-9);
  EXPECT_NEAR(reading->curves[0].y_px.back(), end.y(), 1e-9);
  EXPECT_EQ(reading->curves[0].y.back(), 3);
  EXPECT_TRUE(std::isnan(reading->curves[1].y_px[2]));
  const double middle = 0.5 * (reading->frame.x0 + reading->frame.x1);
  EXPECT_NEAR(reading->x_at(middle), 5, 1e-9);
  EXPECT_EQ(reading->nearest(middle + 3), 5U);
  EXPECT_EQ(reading->x_at(kBox.x0 - 100), 0) << "not beyond its ends";
  EXPECT_EQ(reading->x_at(kBox.x1 + 100), 10);
  EXPECT_EQ(reading->nearest(kBox.x0 - 100), 0U);
  EXPECT_EQ(reading->nearest(kBox.x1 + 100), 10U);
}

TEST(TimePlot, APathIsNotReadByTheTime) {
  TimePlot plot = plot_of({ramp(0, 3)});
  plot.x_label = "x";
  ASSERT_TRUE(reading_of(plot, kBox, kStyle, fonts()));
  EXPECT_FALSE(reading_of(plot, kBox, kStyle, fonts())->is_of_time);
  plot.is_path = true;
  EXPECT_FALSE(reading_of(plot, kBox, kStyle, fonts()));
}

}  // namespace
}  // namespace polhode
