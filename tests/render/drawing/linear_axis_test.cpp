// SPDX-License-Identifier: MIT
#include "render/drawing/linear_axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace polhode {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity(),
                 kNaN = std::numeric_limits<double>::quiet_NaN();

LinearAxis axis_of(double low, double high, double length_px = 300) {
  LinearAxis axis = LinearAxis::between(low, high);
  axis.start_px = 0;
  axis.end_px = length_px;
  return axis;
}

std::vector<std::string> texts_of(const LinearAxis& axis, double spacing_px = 50) {
  std::vector<std::string> texts;
  for (const LinearAxis::Mark& mark : axis.marks(spacing_px)) texts.push_back(mark.text);
  return texts;
}

using Texts = std::vector<std::string>;

TEST(LinearAxis, MarksAreMultiplesOfOneTwoOrFive) {
  EXPECT_EQ(texts_of(axis_of(0, 5)), (Texts{"0", "1", "2", "3", "4", "5"}));
  EXPECT_EQ(texts_of(axis_of(0, 8)), (Texts{"0", "2", "4", "6", "8"}));
  EXPECT_EQ(texts_of(axis_of(0, 20)), (Texts{"0", "5", "10", "15", "20"}));
  EXPECT_EQ(texts_of(axis_of(-0.3, 1.2)), (Texts{"0.0", "0.5", "1.0"}));
  EXPECT_EQ(texts_of(axis_of(-0.5, 0.5), 60), (Texts{"−0.4", "−0.2", "0.0", "0.2", "0.4"}));
}

TEST(LinearAxis, NoMarkIsWrittenAsMinusZero) {
  for (const std::string& text : texts_of(axis_of(-3e-2, 3e-2), 20)) EXPECT_NE(text, "−0.00");
}

TEST(LinearAxis, MarksStandApartAndOnTheAxis) {
  for (const auto& [low, high] :
       {std::pair{0.0, 1.0}, {-7.3, 2.9}, {19.37, 38.74}, {1e-9, 3e-9}, {-1e7, 4e8}})
    for (double spacing : {20.0, 50.0, 140.0}) {
      const auto marks = axis_of(low, high).marks(spacing);
      EXPECT_GE(marks.size(), spacing < 100 ? 2u : 1u) << low << ' ' << high << ' ' << spacing;
      for (std::size_t i = 0; i < marks.size(); ++i) {
        // A mark at an end is on the axis up to the rounding of its place.
        EXPECT_GE(marks[i].px, -1e-6);
        EXPECT_LE(marks[i].px, 300 + 1e-6);
        if (i > 0) {
          EXPECT_GE(marks[i].px - marks[i - 1].px, spacing * (1 - 1e-8)) << low << ' ' << high;
        }
      }
    }
}

TEST(LinearAxis, CoversValuesAndZero) {
  for (const std::vector<double>& values :
       {std::vector{3.0, 4.0}, {-2.0, -1.0}, {0.0, 0.0}, {}, {kNaN, kInf, 2.0}, {1e-300}, {-1e300, 1e300}}) {
    LinearAxis axis = LinearAxis::covering(values);
    axis.round_out(3);
    axis.start_px = 100;
    axis.end_px = 0;
    EXPECT_TRUE(axis.shows(0.0));
    for (double value : values)
      if (axis.shows(value)) {
        EXPECT_GE(axis.px(value), -1e-6) << value;
        EXPECT_LE(axis.px(value), 100 + 1e-6) << value;
      }
    EXPECT_GE(axis.px(0.0), -1e-6);
    EXPECT_LE(axis.px(0.0), 100 + 1e-6);
  }
}

TEST(LinearAxis, RoundedOutItEndsAtMarks) {
  for (double high : {0.7, 1.0, 3.0, 4.6, 29.9, 1234.0, 9.99e5})
    for (double low : {0.0, -0.2, -5.0, -80.0})
      for (int intervals : {2, 3, 4}) {
        LinearAxis axis = axis_of(low, high);
        axis.round_out(intervals);
        const auto marks = axis.marks();
        ASSERT_GE(marks.size(), 2u) << low << ' ' << high;
        EXPECT_LE(marks.size(), static_cast<std::size_t>(intervals) + 1) << low << ' ' << high;
        EXPECT_NEAR(marks.front().px, 0.0, 1e-6);
        EXPECT_NEAR(marks.back().px, 300.0, 1e-6);
        EXPECT_GE(axis.px(low), -1e-6);
        EXPECT_LE(axis.px(high), 300 + 1e-6);
      }
}

TEST(LinearAxis, AnySizeIsWrittenWithFewDigits) {
  for (double size : {1e-300, 3e-102, 1e-9, 1.0, 4.4e5, 2e99, 1.7e308, 5e-324}) {
    const LinearAxis axis = axis_of(0, size);
    for (const std::string& text : texts_of(axis)) EXPECT_LE(text.size(), 6u) << size << ": " << text;
    EXPECT_NEAR(axis.px(size), 300, 1e-6) << size;
  }
  EXPECT_EQ(axis_of(0, 7).unit_of("s"), "s");
  EXPECT_EQ(axis_of(0, 7e-100).unit_of("s"), "10⁻¹⁰² s");
  EXPECT_EQ(axis_of(0, 7e6).unit_of(""), "10⁶");
}

TEST(LinearAxis, WhereThereIsNothingBetweenTheEndsItReachesToBothSides) {
  for (double value : {0.0, 1.0, -3e50}) {
    const LinearAxis axis = axis_of(value, value);
    EXPECT_NEAR(axis.px(value), 150, 1e-3) << value;
    EXPECT_GE(axis.marks(50).size(), 1u);
  }
}

TEST(LinearAxis, AroundValuesIsNoLongerThanTheyReach) {
  const LinearAxis axis = LinearAxis::around({3.0, 5.0, std::numeric_limits<double>::quiet_NaN(), 4.0});
  EXPECT_EQ(axis.low, 3.0);
  EXPECT_EQ(axis.high, 5.0);
}

TEST(LinearAxis, AroundWhatDoesNotChangeRoundingIsNotSeen) {
  const double value = 36.0, noise = 1e-9 * value;
  const LinearAxis axis = LinearAxis::around({value, value + noise, value - noise});
  EXPECT_NEAR(axis.high - axis.low, 0.1 * value, 4 * noise) << "5 % to both sides";
  const LinearAxis at_zero = LinearAxis::around({0.0, 0.0});
  EXPECT_LT(at_zero.low, 0.0);
  EXPECT_GT(at_zero.high, 0.0);
  const LinearAxis of_none = LinearAxis::around({});
  EXPECT_LT(of_none.low, of_none.high);
}

}  // namespace
}  // namespace polhode
