// SPDX-License-Identifier: MIT
#include "app/export/timeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace polhode {
namespace {

TEST(FrameRate, IsAWholeNumberOrARatio) {
  EXPECT_EQ(frame_rate_from("25"), (FrameRate{25, 1}));
  EXPECT_EQ(frame_rate_from("30000/1001"), (FrameRate{30000, 1001}));
  EXPECT_EQ(frame_rate_from("1000000/1"), (FrameRate{1000000, 1}));
  for (const char* text : {"", "0", "-1", "+25", "25 ", " 25", "29.97", "1/0", "0/1", "1/", "/1", "1/2/3",
                           "1000001", "1/1000001", "99999999999999999999", "nan"})
    EXPECT_FALSE(frame_rate_from(text)) << text;
}

TEST(FrameRate, WritesWhatItReads) {
  for (const char* text : {"25", "30000/1001"}) EXPECT_EQ(to_string(*frame_rate_from(text)), text);
}

TEST(FrameRange, IsHalfOpenAndNotEmpty) {
  EXPECT_EQ(frame_range_from("0:1"), (FrameRange{0, 1}));
  EXPECT_EQ(frame_range_from("12:240"), (FrameRange{12, 240}));
  for (const char* text : {"", ":", "1", "1:", ":1", "1:1", "2:1", "-1:3", "0:1:2", "0-3", "0:x"})
    EXPECT_FALSE(frame_range_from(text)) << text;
}

TEST(FrameCount, RoundsHalvesUp) {
  EXPECT_EQ(frame_count({30, 1}, 8), 240);
  EXPECT_EQ(frame_count({30, 1}, 0), 0);
  EXPECT_EQ(frame_count({1, 1}, 0.5), 1);
  // 2025-11-21: 0.5 + (0.5 − 2⁻⁵⁴) rounds to 1.
  EXPECT_EQ(frame_count({1, 1}, std::nextafter(0.5, 0)), 0);
  EXPECT_EQ(frame_count({1, 1}, std::nextafter(2.5, 0)), 2);
  EXPECT_EQ(frame_count({1, 1}, 2.5), 3);
  EXPECT_EQ(frame_count({30000, 1001}, 10.01), 300);
  EXPECT_EQ(frame_count({kMaxFrames, 1}, 1), kMaxFrames);
  EXPECT_GT(frame_count({1, 1}, 1e300), kMaxFrames);
  EXPECT_GT(frame_count({1, 1}, std::numeric_limits<double>::max()), kMaxFrames);
}

// n = round(A·S/B), halves up, is the only whole number with 2nB − B ≤ 2AS < 2nB + B. S = m·2⁻³⁰ makes every
// term a whole number below 2⁶³, so the test decides without rounding.
TEST(FrameCount, IsExact) {
  std::mt19937_64 random(20251121);
  std::uniform_int_distribution<std::int64_t> term(1, 4000), mantissa(0, std::int64_t{1} << 33);
  for (int i = 0; i < 100000; ++i) {
    const std::int64_t A = term(random), B = term(random), scale = std::int64_t{1} << 30;
    std::int64_t m = mantissa(random);
    if (i % 2) m = (2 * (m % 100) + 1) * B * scale / 2 / A;  // near a half
    const std::int64_t n = frame_count({A, B}, static_cast<double>(m) / static_cast<double>(scale));
    ASSERT_LE((2 * n - 1) * B * scale, 2 * A * m) << A << '/' << B << ' ' << m;
    ASSERT_GT((2 * n + 1) * B * scale, 2 * A * m) << A << '/' << B << ' ' << m;
  }
}

TEST(FrameTime, OfWholeSecondsIsExact) {
  for (std::int64_t k = 0; k < 1000; ++k) {
    EXPECT_EQ(frame_time({24, 1}, 24 * k, 1.0, 0.0), static_cast<double>(k));
    EXPECT_EQ(frame_time({30000, 1001}, 30000 * k, 1.0, 0.0), static_cast<double>(1001 * k));
  }
}

// One division, one product: two roundings, whatever the frame's number. A sum of k steps would be k
// roundings off.
TEST(FrameTime, DoesNotAccumulate) {
  const double ulps = 2 * std::numeric_limits<double>::epsilon() / 2;
  for (std::int64_t k : {1, 7, 999, 123456, 999999}) {
    const long double exact = static_cast<long double>(k) * 1001 / 30000 * 0.7L;
    EXPECT_NEAR(frame_time({30000, 1001}, k, 0.7, 0.0), static_cast<double>(exact),
                static_cast<double>(exact) * 1.5 * ulps);
  }
  EXPECT_EQ(frame_time({10, 1}, 3, 2.0, 5.0), 5.0 + 3.0 / 10.0 * 2.0);
}

TEST(ZeroPadded, HasTheDigitsOfTheLastNumber) {
  EXPECT_EQ(zero_padded(0, 9), "0");
  EXPECT_EQ(zero_padded(7, 10), "07");
  EXPECT_EQ(zero_padded(239, 239), "239");
  EXPECT_EQ(zero_padded(0, 99999), "00000");
  EXPECT_EQ(zero_padded(3, 9, 2), "03");
}

}  // namespace
}  // namespace polhode
