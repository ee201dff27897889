// SPDX-License-Identifier: MIT
#include "app/window/screen/pace.h"

#include <gtest/gtest.h>

#include <random>

namespace polhode {
namespace {

/// A machine that takes so long for a frame with all pixels: a part does not depend on them.
double cost(double full_s, double resolution) { return full_s * (0.2 + 0.8 * resolution * resolution); }

double settle(Pace& pace, double full_s, int frames = 1000) {
  for (int i = 0; i < frames; ++i) pace.drew(cost(full_s, pace.resolution()));
  return pace.resolution();
}

TEST(Pace, AFastMachineKeepsAllPixels) {
  Pace pace;
  EXPECT_EQ(settle(pace, 0.9 * Pace::kMostSeconds), 1.0);
}

TEST(Pace, ASlowMachineGetsTheFinestLevelThatIsFastEnough) {
  for (const double full_s : {0.035, 0.05, 0.08}) {
    Pace pace;
    const double resolution = settle(pace, full_s);
    EXPECT_LT(resolution, 1.0) << full_s;
    EXPECT_LE(cost(full_s, resolution), Pace::kMostSeconds) << full_s;
  }
}

TEST(Pace, AVerySlowMachineGetsTheCoarsest) {
  Pace pace;
  const double coarsest = settle(pace, 10);
  EXPECT_GT(coarsest, 0.25);
  EXPECT_EQ(settle(pace, 10), coarsest);
}

TEST(Pace, OneSlowFrameDecidesNothing) {
  Pace pace;
  settle(pace, 0.5 * Pace::kMostSeconds, 20);
  pace.drew(2 * Pace::kMostSeconds);
  EXPECT_EQ(pace.resolution(), 1.0);
}

TEST(Pace, PixelsComeBackWhenTheMachineIsFree) {
  Pace pace;
  ASSERT_LT(settle(pace, 0.1), 1.0);
  EXPECT_EQ(settle(pace, 0.4 * Pace::kMostSeconds), 1.0);
}

TEST(Pace, ItDoesNotSwing) {
  Pace pace;
  settle(pace, 0.04);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(0.9, 1.1);
  int changes = 0;
  for (int i = 0; i < 2000; ++i) {
    const double before = pace.resolution();
    pace.drew(cost(0.04, before) * noise(random));
    changes += pace.resolution() != before;
  }
  EXPECT_LE(changes, 1);
}

}  // namespace
}  // namespace polhode
