// SPDX-License-Identifier: MIT
#include "render/drawing/log_axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

LogAxis axis_of(const std::vector<double>& values, double length_px = 1000.0) {
  LogAxis axis = LogAxis::covering(values, true, true);
  axis.start_px = 0.0;
  axis.end_px = length_px;
  return axis;
}

TEST(LogAxis, WritesPowersOfTenWithSuperscripts) {
  EXPECT_EQ(power_of_ten(-6), "10⁻⁶");
  EXPECT_EQ(power_of_ten(0), "10⁰");
  EXPECT_EQ(power_of_ten(123), "10¹²³");
}

TEST(LogAxis, WritesShortNumbers) {
  EXPECT_EQ(short_number(0.0), "0");
  EXPECT_EQ(short_number(1e-6), "10⁻⁶");
  EXPECT_EQ(short_number(3e-7), "3 × 10⁻⁷");
  EXPECT_EQ(short_number(2.46e-300), "2.5 × 10⁻³⁰⁰");
  EXPECT_EQ(short_number(0.05), "0.05");
  EXPECT_EQ(short_number(0.999), "1");
  EXPECT_EQ(short_number(20.0), "20");
  EXPECT_EQ(short_number(1234.0), "1200");
  EXPECT_EQ(short_number(1e4), "10⁴");
}

TEST(LogAxis, PutsEqualRatiosAtEqualDistances) {
  const LogAxis axis = axis_of({1e-3, 1.0, 1e3});
  const double decade = axis.px(10.0) - axis.px(1.0);
  EXPECT_GT(decade, 0.0);
  // Places up to 1000 px, with some roundings in each.
  constexpr double kRounding = 16.0 * 1000.0 * std::numeric_limits<double>::epsilon();
  for (double value : {1e-3, 2e-2, 0.5, 70.0})
    EXPECT_NEAR(axis.px(10.0 * value) - axis.px(value), decade, kRounding);
}

TEST(LogAxis, KeepsEveryValueInsideWithAir) {
  const std::vector<std::vector<double>> sets = {{5.0},    {1.0, 1.0}, {1e-15, 1e15}, {1e-300, 1e300},
                                                 {5e-324}, {3.0, 4.0}, {0.0, 1.0}};
  for (const auto& values : sets) {
    const LogAxis axis = axis_of(values);
    for (double value : values) {
      EXPECT_GT(axis.px(value), 5.0) << value;
      EXPECT_LT(axis.px(value), 995.0) << value;
    }
  }
}

TEST(LogAxis, LeavesImpossibleValuesOut) {
  constexpr double kInf = std::numeric_limits<double>::infinity(),
                   kNaN = std::numeric_limits<double>::quiet_NaN();
  const LogAxis axis = axis_of({-1.0, kInf, kNaN, 1.0, 10.0});
  EXPECT_FALSE(axis.has_zero);
  for (double value : {-1.0, kInf, kNaN, 0.0}) EXPECT_FALSE(axis.shows(value));
  EXPECT_GT(axis.low, -3.0);
  EXPECT_LT(axis.high, 3.0);
}

TEST(LogAxis, CoversTwoDecadesWithoutAnyValue) {
  const LogAxis axis = axis_of({});
  EXPECT_GE(axis.high - axis.low, 2.0);
  EXPECT_GE(axis.marks(50.0).labelled.size(), 2u);
}

TEST(LogAxis, HasAPlaceForZeroBelowAllElse) {
  const LogAxis axis = axis_of({0.0, 1e-9, 1e-6, 1e-3, 1.0});
  ASSERT_TRUE(axis.has_zero);
  EXPECT_GE(axis.px(1e-9) - axis.px(0.0), axis.gap_px);
  ASSERT_EQ(axis.gaps_px().size(), 1u);
  EXPECT_GT(axis.gaps_px()[0], axis.px(0.0));
  EXPECT_LT(axis.gaps_px()[0], axis.px(1e-9));
  EXPECT_FALSE(LogAxis::covering({0.0, 1.0}, false, true).has_zero);
}

TEST(LogAxis, CutsOutLongEmptyStretchesAlone) {
  EXPECT_FALSE(axis_of({1e-2, 1.0, 1e2}).cut);
  EXPECT_FALSE(axis_of({1.0, 1e4}).cut) << "four decades are not too many";
  EXPECT_FALSE(LogAxis::covering({1e-6, 1e3}, true, false).cut) << "not allowed";
  const LogAxis axis = axis_of({1e-6, 1e3, 1e6});
  ASSERT_TRUE(axis.cut);
  EXPECT_GT(axis.cut->first, -6.0);
  EXPECT_LT(axis.cut->second, 3.0);
  // The order of values survives, and what is cut takes the length of a gap.
  EXPECT_LT(axis.px(1e-6), axis.px(1e3));
  EXPECT_NEAR(axis.px_of_log(axis.cut->second) - axis.px_of_log(axis.cut->first), axis.gap_px, 1e-9);
  for (int n : axis.marks(1.0).labelled) EXPECT_TRUE(n <= axis.cut->first || n >= axis.cut->second) << n;
}

TEST(LogAxis, ThereAreLabelsOnBothSidesOfACut) {
  for (double low : {1.2e-4, 2.6e-4, 9.9e-4, 1e-3})
    for (double high : {0.4, 1.0, 4.0, 9.9}) {
      const LogAxis axis = axis_of({low, 1e3 * high, 1e3 * high * 5.0});
      ASSERT_TRUE(axis.cut);
      const std::vector<int> labelled = axis.marks(50.0).labelled;
      const auto before =
          std::count_if(labelled.begin(), labelled.end(), [&](int n) { return n <= axis.cut->first; });
      EXPECT_GE(before, 1) << low << ' ' << high;
      EXPECT_GE(static_cast<std::ptrdiff_t>(labelled.size()) - before, 2) << low << ' ' << high;
    }
}

TEST(LogAxis, EndsWhereItIsToldEitherWay) {
  LogAxis axis = axis_of({0.0, 1e-6, 1e3, 1e6});
  EXPECT_NEAR(axis.px_of_log(axis.high), 1000.0, 1e-9);
  axis.start_px = 900.0;
  axis.end_px = 100.0;
  EXPECT_NEAR(axis.px_of_log(axis.high), 100.0, 1e-9);
  EXPECT_GT(axis.px(1e-6), axis.px(1e3));
}

TEST(LogAxis, LabelsStandApart) {
  for (double decades : {2.0, 7.0, 17.0, 30.0, 300.0})
    for (double spacing : {30.0, 56.0, 90.0}) {
      const LogAxis axis = axis_of(
          {1.0, std::pow(10.0, decades / 3.0), std::pow(10.0, 2.0 * decades / 3.0), std::pow(10.0, decades)});
      const std::vector<int> labelled = axis.marks(spacing).labelled;
      EXPECT_GE(labelled.size(), 2u) << decades;
      for (std::size_t i = 1; i < labelled.size(); ++i)
        EXPECT_GE(axis.px_of_log(labelled[i]) - axis.px_of_log(labelled[i - 1]), spacing - 1e-9);
    }
}

TEST(LogAxis, MinorMarksAreDecadesOrTheirParts) {
  const LogAxis dense = axis_of({1.0, 1e3, 1e6});
  const std::vector<double> parts = dense.marks(50.0).minor;
  EXPECT_TRUE(std::any_of(parts.begin(), parts.end(),
                          [](double v) { return std::abs(v - std::log10(20.0)) < 1e-12; }));
  const LogAxis sparse = axis_of({1.0, 1e10, 1e20, 1e30});
  for (double mark : sparse.marks(56.0).minor) EXPECT_EQ(mark, std::round(mark));
}

}  // namespace
}  // namespace polhode
