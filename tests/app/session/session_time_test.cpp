// SPDX-License-Identifier: MIT
// Time: played, scrubbed, stepped.
#include "app/session/lesson_session.h"
#include "physics/geometry/flips.h"
#include "tests/app/session/example_lesson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {
namespace {

using test::example;
using ::testing::ElementsAre;

constexpr double kRounding = 1e-14;  // some ε of times near 1 s

TEST(CompanionTime, BeginsAtTheScenesOwnTimeAndRests) {
  Companion companion(example());
  EXPECT_EQ(companion.t_s(), 0.5);
  EXPECT_FALSE(companion.is_playing());
  EXPECT_FALSE(companion.is_moving());
  companion.advance(1);
  EXPECT_EQ(companion.t_s(), 0.5);
}

TEST(CompanionTime, PassesAtTheRateOfTheSceneTimesTheSpeed) {
  Companion companion(example());
  const double rate = companion.model()->rate;
  companion.set_playing(true);
  EXPECT_TRUE(companion.is_moving());
  companion.advance(0.25);
  EXPECT_NEAR(companion.t_s(), 0.5 + 0.25 * rate, kRounding);
  companion.set_speed(4);
  companion.advance(0.25);
  EXPECT_NEAR(companion.t_s(), 0.5 + 1.25 * rate, kRounding);
  companion.set_playing(false);
  companion.advance(0.25);
  EXPECT_NEAR(companion.t_s(), 0.5 + 1.25 * rate, kRounding);
}

TEST(CompanionTime, SpeedHasBounds) {
  Companion companion(example());
  companion.set_speed(1e9);
  EXPECT_EQ(companion.speed(), kFastest);
  companion.set_speed(0);
  EXPECT_EQ(companion.speed(), kSlowest);
  companion.set_speed(std::nan(""));
  EXPECT_EQ(companion.speed(), kSlowest);
}

TEST(CompanionTime, StepsByFramesOfAFilmAndStops) {
  Companion companion(example());
  const double frame_s = kFrameSeconds * companion.model()->rate;
  companion.set_playing(true);
  companion.step_frames(1);
  EXPECT_FALSE(companion.is_playing());
  EXPECT_NEAR(companion.t_s(), 0.5 + frame_s, kRounding);
  companion.step_frames(-2);
  EXPECT_NEAR(companion.t_s(), 0.5 - frame_s, kRounding);
  companion.reset_time();
  EXPECT_EQ(companion.t_s(), 0.5);
}

TEST(CompanionTime, ScrubsAnywhereAtOnceButNotToWhatIsNoTime) {
  Companion companion(example());
  for (double t_s : {-3.0, 1e6, 0.125}) {
    companion.scrub_to(t_s);
    EXPECT_EQ(companion.t_s(), t_s);
  }
  companion.scrub_to(std::nan(""));
  EXPECT_EQ(companion.t_s(), 0.125);
}

TEST(CompanionTime, EndsWhereTheMotionDoes) {
  Companion companion(example());
  ASSERT_TRUE(companion.set_edits({.motion = MotionSpec{.method = Method::rk4, .step_s = 1e-5}}));
  const double reach_s = companion.model()->reach_s;
  ASSERT_TRUE(std::isfinite(reach_s));
  companion.scrub_to(-2 * reach_s);
  EXPECT_EQ(companion.t_s(), -reach_s);
  companion.scrub_to(reach_s - 1e-3);
  companion.set_playing(true);
  for (int frame = 0; frame < 100 && companion.is_playing(); ++frame) companion.advance(0.5);
  EXPECT_FALSE(companion.is_playing());
  EXPECT_EQ(companion.t_s(), reach_s);
}

TEST(CompanionTime, StopsBeforeWhatOverflows) {
  // ω grows without bound under a torque that works on it.
  Companion companion(test::loaded_text(R"(+++
format = 1
id = "runaway"
title = "Runaway"
+++
# Runaway {runaway}

Faster and faster.

```scene
body = "textbook"
omega = [1.0, 0.1, 0.1]
torque = "body:1e150,0,0"
motion = { method = "explicit-euler", step = 1.0 }
show = "omega"
rate = 10.0
```
)"));
  companion.set_playing(true);
  companion.advance(1);
  EXPECT_FALSE(companion.is_playing());
  ASSERT_FALSE(companion.model()->motion->w_B_at(10).allFinite());
  EXPECT_EQ(companion.t_s(), 0);
}

TEST(CompanionTime, LineShowsTheLoopThatTimeIsIn) {
  Companion companion(example());
  const double span_s = companion.model()->span_s;
  const auto line = [&] { return std::pair(companion.time_line().from_s, companion.time_line().to_s); };
  EXPECT_EQ(line(), std::pair(0.0, span_s));
  companion.scrub_to(span_s);
  EXPECT_EQ(line(), std::pair(0.0, span_s)) << "the end of what is shown is shown";
  companion.scrub_to(1.25 * span_s);
  EXPECT_EQ(line(), std::pair(span_s, 2 * span_s));
  companion.scrub_to(span_s);
  EXPECT_EQ(line(), std::pair(span_s, 2 * span_s));
  companion.scrub_to(-0.25 * span_s);
  EXPECT_EQ(line(), std::pair(-span_s, 0.0));
  companion.reset_time();
  EXPECT_EQ(line(), std::pair(0.0, span_s));
}

TEST(CompanionTime, LineMarksTheFlips) {
  Companion companion(example());
  const double period_s = companion.model()->span_s;
  ASSERT_EQ(companion.flips().size(), 2u) << "a period of a spin about the intermediate axis";
  const std::vector<double> first = companion.flips();
  companion.scrub_to(1.5 * period_s);
  const std::vector<double> second = companion.flips();
  ASSERT_EQ(second.size(), 2u);
  for (std::size_t i : {0u, 1u}) EXPECT_NEAR(second[i] - first[i], period_s, 1e-9 * period_s);
  ASSERT_TRUE(companion.set_edits({.w0_B = Vec3(0.1, 0.1, 2)}));
  EXPECT_THAT(companion.flips(), ElementsAre()) << "it only wobbles";
  companion.reset_edits();
  EXPECT_EQ(companion.flips(), first);
  companion.go_to({1, 0});
  EXPECT_THAT(companion.flips(), ElementsAre()) << "nothing turns here";
  companion.go_to({0, 0});
  EXPECT_EQ(companion.flips(), first);
}

TEST(CompanionTime, GoesOnFromStepToStepWithTheSameMotion) {
  Companion companion(example());
  companion.scrub_to(0.75);
  companion.set_playing(true);
  for (int step = 1; step <= 2; ++step) {
    ASSERT_TRUE(companion.next_step());
    EXPECT_EQ(companion.t_s(), 0.75) << step;
    EXPECT_TRUE(companion.is_playing()) << step;
  }
  ASSERT_TRUE(companion.next_step());
  EXPECT_EQ(companion.t_s(), 0.5) << "another body: the scene's own time";
  EXPECT_FALSE(companion.is_playing());
}

TEST(CompanionTime, StopsInANewStage) {
  Companion companion(example());
  companion.scrub_to(0.75);
  companion.set_playing(true);
  companion.go_to({2, 0});
  EXPECT_EQ(companion.t_s(), 0);
  EXPECT_FALSE(companion.is_playing());
  companion.set_playing(true);
  companion.go_to({1, 0});
  EXPECT_FALSE(companion.is_playing()) << "there is nothing to play";
  companion.set_playing(true);
  EXPECT_FALSE(companion.is_playing());
}

TEST(CompanionTime, ASceneWithADurationPlaysAgainAndAgain) {
  Companion companion(test::loaded_lesson("intermediate-axis"));
  const auto& stages = companion.lesson().stages;
  const auto stage =
      std::find_if(stages.begin(), stages.end(), [](const Stage& s) { return s.id == "separatrix"; });
  ASSERT_NE(stage, stages.end());
  companion.go_to({static_cast<std::size_t>(stage - stages.begin()), 0});
  const double end_s = companion.lesson_scene().duration_s.value();
  companion.set_playing(true);
  int returns = 0;
  for (int i = 0; i < 1000; ++i) {
    const double before_s = companion.t_s();
    companion.advance(0.04);
    ASSERT_GE(companion.t_s(), 0);
    ASSERT_LE(companion.t_s(), end_s);
    returns += companion.t_s() < before_s;
  }
  EXPECT_TRUE(companion.is_playing());
  EXPECT_NEAR(returns, 40 / end_s, 1);
  companion.scrub_to(3 * end_s + 1);  // by hand any t
  EXPECT_EQ(companion.t_s(), 3 * end_s + 1);
}

}  // namespace
}  // namespace polhode
