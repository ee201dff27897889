// SPDX-License-Identifier: MIT
#include "render/drawing/plots/plot.h"

#include "render/drawing/label_layout.h"
#include "tests/render/drawing/plots/plot_examples.h"
#include "tests/render/drawing/sheet_texts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

constexpr double kWidth = 1920, kHeight = 1080;

Sheet sheet_of(const WorkPrecisionPlot& plot, double width = kWidth, double height = kHeight) {
  return lay_out(plot, width, height, fonts());
}

/// Text that covers text, or leaves the picture.
void expect_tidy(const Sheet& sheet, double width = kWidth, double height = kHeight) {
  const PixelBox picture{0, 0, width, height};
  for (std::size_t i = 0; i < sheet.texts.size(); ++i) {
    const PixelBox box = box_of(sheet.texts[i]);
    EXPECT_GT(box.width() * box.height(), 0.0) << sheet.texts[i].text << " is not set";
    EXPECT_NEAR(box.overlap(picture), box.width() * box.height(), 1e-6)
        << sheet.texts[i].text << " leaves the picture";
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_EQ(box.overlap(box_of(sheet.texts[k])), 0.0)
          << sheet.texts[i].text << " covers " << sheet.texts[k].text;
  }
}

PlotSeries series(const char* label, std::vector<std::pair<double, double>> points) {
  return {.label = label, .points = std::move(points)};
}

WorkPrecisionPlot plot_of(std::vector<PlotSeries> all) {
  return {.title = "A title", .x_label = "ns per period", .y_label = "error, rad", .series = std::move(all)};
}

void expect_finite(const Sheet& sheet) {
  for (const FlatShape& shape : sheet.shapes)
    std::visit(
        [](const auto& s) {
          for (const Vec2& p : s.points) EXPECT_TRUE(p.allFinite());
        },
        shape);
  for (const PlacedType& type : sheet.texts) EXPECT_TRUE(type.at.allFinite()) << type.text;
}

TEST(Plot, NamesEveryCurveOnceAndClearOfAllOtherText) {
  const WorkPrecisionPlot plot = plot_of_all_methods();
  const Sheet sheet = sheet_of(plot);
  for (const PlotSeries& s : plot.series) EXPECT_EQ(texts_of(sheet, s.label).size(), 1u) << s.label;
  for (const char* text : {"tolerance 10⁻⁶", "cheapest within the tolerance", "10⁻¹²", "10⁴"})
    EXPECT_EQ(texts_of(sheet, text).size(), 1u) << text;
  expect_tidy(sheet);
}

TEST(Plot, NamesKeepClearAtOtherSizes) {
  expect_tidy(sheet_of(plot_of_all_methods(), 1280, 720), 1280, 720);
  expect_tidy(sheet_of(plot_of_all_methods(), 2400, 1000), 2400, 1000);
}

TEST(Plot, CurvesThatEndInOnePointAreStillNamedApart) {
  std::vector<PlotSeries> all;
  for (const char* label : {"one", "two", "three", "four", "five"})
    all.push_back(series(label, {{1e3, 1e-2}, {1e5, 1e-8}}));
  expect_tidy(sheet_of(plot_of(all)));
}

TEST(Plot, ANameStandsNearTheEndOfItsCurve) {
  const Sheet sheet =
      sheet_of(plot_of({series("falls", {{1e2, 1.0}, {1e4, 1e-6}}), series("other", {{1e6, 1e-3}})}));
  // The last but one text is the first name; both curves have room, so they need no leader.
  const PlacedType &falls = only_text(sheet, "falls"), &other = only_text(sheet, "other");
  EXPECT_GT(falls.at.y(), other.at.y()) << "the more accurate one is lower";
  EXPECT_LT(falls.at.x(), other.at.x()) << "the cheaper one is further left";
}

TEST(Plot, ACurveIsNamedWhereItStopsGettingBetter) {
  std::vector<std::pair<double, double>> flat = {{1e2, 1.0}, {1e3, 1e-6}};
  for (double work : {1e4, 1e5, 1e6}) flat.emplace_back(work, 2e-6);
  const Sheet sheet = sheet_of(plot_of({series("flat", flat)}));
  EXPECT_LT(only_text(sheet, "flat").at.x(), 0.5 * kWidth);
}

TEST(Plot, DrawsTheExtremes) {
  constexpr double kInf = std::numeric_limits<double>::infinity(),
                   kNaN = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::vector<PlotSeries>> cases = {
      {},
      {series("empty", {})},
      {series("a point", {{100.0, 1e-6}})},
      {series("all equal", {{7.0, 7.0}, {7.0, 7.0}, {7.0, 7.0}})},
      {series("thirty decades", {{1.0, 1e-30}, {1e30, 1.0}})},
      {series("all of double", {{5e-324, 5e-324}, {1.7e308, 1.7e308}})},
      {series("zero", {{10.0, 0.0}}), series("not zero", {{20.0, 1e-3}})},
      {series("only zero", {{10.0, 0.0}, {20.0, 0.0}})},
      {series("no numbers", {{kNaN, 1.0}, {1.0, kInf}, {-1.0, 1.0}, {1.0, -1.0}, {0.0, 1.0}})},
  };
  for (const auto& all : cases) {
    WorkPrecisionPlot plot = plot_of(all);
    for (const auto& tolerance :
         {std::optional<double>(), std::optional(1e-6), std::optional(0.0), std::optional(kNaN)}) {
      plot.tolerance = tolerance;
      const Sheet sheet = sheet_of(plot);
      SCOPED_TRACE(all.empty() ? "no series" : all.front().label);
      expect_finite(sheet);
      expect_tidy(sheet);
    }
  }
}

TEST(Plot, AnErrorOfZeroLiesInItsOwnRowBelowAllOthers) {
  const Sheet sheet =
      sheet_of(plot_of({series("zero", {{10.0, 0.0}}), series("tiny", {{20.0, 1e-300}, {30.0, 1e-290}})}));
  const double zero = only_text(sheet, "0").at.y();
  for (const PlacedType& type : sheet.texts)
    if (type.text.starts_with("10⁻")) {
      EXPECT_LT(type.at.y(), zero) << type.text;
    }
}

TEST(Plot, TheRecommendedPointIsRinged) {
  WorkPrecisionPlot plot = plot_of({series("it", {{1e2, 1e-2}, {1e4, 1e-8}})});
  const std::size_t shapes = sheet_of(plot).shapes.size();
  plot.recommended = {1e4, 1e-8};
  plot.recommended_label = "take this";
  const Sheet sheet = sheet_of(plot);
  EXPECT_GT(sheet.shapes.size(), shapes);
  EXPECT_EQ(texts_of(sheet, "take this").size(), 1u);
  expect_tidy(sheet);
}

/// Width of the slanted line between the first two points of a curve, by its place among those that slant.
std::vector<double> curve_widths(const WorkPrecisionPlot& plot) {
  std::vector<std::pair<double, double>> by_left_end;
  for (const FlatShape& shape : sheet_of(plot).shapes)
    if (const auto* stroke = std::get_if<Stroke>(&shape);
        stroke && stroke->points.size() == 2 &&
        (stroke->points[1] - stroke->points[0]).cwiseAbs().minCoeff() > 100.0)
      by_left_end.emplace_back(stroke->points[0].x(), stroke->width);
  std::sort(by_left_end.begin(), by_left_end.end());
  std::vector<double> widths;
  for (const auto& [x, width] : by_left_end) widths.push_back(width);
  return widths;
}

WorkPrecisionPlot two_curves() {
  return plot_of({series("cheap", {{1e2, 1e-2}, {1e4, 1e-8}}), series("dear", {{1e3, 1e-2}, {1e5, 1e-8}})});
}

TEST(Plot, EmphasizedCurvesAreHeavier) {
  WorkPrecisionPlot plot = two_curves();
  plot.series[1].emphasized = true;
  const auto widths = curve_widths(plot);
  ASSERT_EQ(widths.size(), 2u);
  EXPECT_GT(widths[1], 1.5 * widths[0]);
}

TEST(Plot, IfOnlyAStarIsEmphasizedTheFrontOfTheOthersIsHeavier) {
  WorkPrecisionPlot plot = two_curves();
  plot.series.push_back(
      {.label = "exact", .points = {{1.0, 0.0}}, .emphasized = true, .look = PlotLook::star});
  const auto widths = curve_widths(plot);
  ASSERT_EQ(widths.size(), 2u);
  EXPECT_GT(widths[0], 1.5 * widths[1]);
}

}  // namespace
}  // namespace polhode
