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

TEST(SessionTime, BeginsAtTheScenesOwnTimeAndRests) {
  LessonSession session(example());
  EXPECT_EQ(session.t_s(), 0.5);
  EXPECT_FALSE(session.is_playing());
  EXPECT_FALSE(session.is_moving());
  session.advance(1);
  EXPECT_EQ(session.t_s(), 0.5);
}

TEST(SessionTime, PassesAtTheRateOfTheSceneTimesTheSpeed) {
  LessonSession session(example());
  const double rate = session.model()->rate;
  session.set_playing(true);
  EXPECT_TRUE(session.is_moving());
  session.advance(0.25);
  EXPECT_NEAR(session.t_s(), 0.5 + 0.25 * rate, kRounding);
  session.set_speed(4);
  session.advance(0.25);
  EXPECT_NEAR(session.t_s(), 0.5 + 1.25 * rate, kRounding);
  session.set_playing(false);
  session.advance(0.25);
  EXPECT_NEAR(session.t_s(), 0.5 + 1.25 * rate, kRounding);
}

TEST(SessionTime, SpeedHasBounds) {
  LessonSession session(example());
  session.set_speed(1e9);
  EXPECT_EQ(session.speed(), kFastest);
  session.set_speed(0);
  EXPECT_EQ(session.speed(), kSlowest);
  session.set_speed(std::nan(""));
  EXPECT_EQ(session.speed(), kSlowest);
}

TEST(SessionTime, StepsByFramesOfAFilmAndStops) {
  LessonSession session(example());
  const double frame_s = kFrameSeconds * session.model()->rate;
  session.set_playing(true);
  session.step_frames(1);
  EXPECT_FALSE(session.is_playing());
  EXPECT_NEAR(session.t_s(), 0.5 + frame_s, kRounding);
  session.step_frames(-2);
  EXPECT_NEAR(session.t_s(), 0.5 - frame_s, kRounding);
  session.reset_time();
  EXPECT_EQ(session.t_s(), 0.5);
}

TEST(SessionTime, ScrubsAnywhereAtOnceButNotToWhatIsNoTime) {
  LessonSession session(example());
  for (double t_s : {-3.0, 1e6, 0.125}) {
    session.scrub_to(t_s);
    EXPECT_EQ(session.t_s(), t_s);
  }
  session.scrub_to(std::nan(""));
  EXPECT_EQ(session.t_s(), 0.125);
}

TEST(SessionTime, EndsWhereTheMotionDoes) {
  LessonSession session(example());
  ASSERT_TRUE(session.set_edits({.motion = MotionSpec{.method = Method::rk4, .step_s = 1e-5}}));
  const double reach_s = session.model()->reach_s;
  ASSERT_TRUE(std::isfinite(reach_s));
  session.scrub_to(-2 * reach_s);
  EXPECT_EQ(session.t_s(), -reach_s);
  session.scrub_to(reach_s - 1e-3);
  session.set_playing(true);
  for (int frame = 0; frame < 100 && session.is_playing(); ++frame) session.advance(0.5);
  EXPECT_FALSE(session.is_playing());
  EXPECT_EQ(session.t_s(), reach_s);
}

TEST(SessionTime, StopsBeforeWhatOverflows) {
  // ω grows without bound under a torque that works on it.
  LessonSession session(test::loaded_text(R"(+++
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
  session.set_playing(true);
  session.advance(1);
  EXPECT_FALSE(session.is_playing());
  ASSERT_FALSE(session.model()->motion->w_B_at(10).allFinite());
  EXPECT_EQ(session.t_s(), 0);
}

TEST(SessionTime, LineShowsTheLoopThatTimeIsIn) {
  LessonSession session(example());
  const double span_s = session.model()->span_s;
  const auto line = [&] { return std::pair(session.time_line().from_s, session.time_line().to_s); };
  EXPECT_EQ(line(), std::pair(0.0, span_s));
  session.scrub_to(span_s);
  EXPECT_EQ(line(), std::pair(0.0, span_s)) << "the end of what is shown is shown";
  session.scrub_to(1.25 * span_s);
  EXPECT_EQ(line(), std::pair(span_s, 2 * span_s));
  session.scrub_to(span_s);
  EXPECT_EQ(line(), std::pair(span_s, 2 * span_s));
  session.scrub_to(-0.25 * span_s);
  EXPECT_EQ(line(), std::pair(-span_s, 0.0));
  session.reset_time();
  EXPECT_EQ(line(), std::pair(0.0, span_s));
}

TEST(SessionTime, LineMarksTheFlips) {
  LessonSession session(example());
  const double period_s = session.model()->span_s;
  ASSERT_EQ(session.flips().size(), 2u) << "a period of a spin about the intermediate axis";
  const std::vector<double> first = session.flips();
  session.scrub_to(1.5 * period_s);
  const std::vector<double> second = session.flips();
  ASSERT_EQ(second.size(), 2u);
  for (std::size_t i : {0u, 1u}) EXPECT_NEAR(second[i] - first[i], period_s, 1e-9 * period_s);
  ASSERT_TRUE(session.set_edits({.w0_B = Vec3(0.1, 0.1, 2)}));
  EXPECT_THAT(session.flips(), ElementsAre()) << "it only wobbles";
  session.reset_edits();
  EXPECT_EQ(session.flips(), first);
  session.go_to({1, 0});
  EXPECT_THAT(session.flips(), ElementsAre()) << "nothing turns here";
  session.go_to({0, 0});
  EXPECT_EQ(session.flips(), first);
}

TEST(SessionTime, GoesOnFromStepToStepWithTheSameMotion) {
  LessonSession session(example());
  session.scrub_to(0.75);
  session.set_playing(true);
  for (int step = 1; step <= 2; ++step) {
    ASSERT_TRUE(session.next_step());
    EXPECT_EQ(session.t_s(), 0.75) << step;
    EXPECT_TRUE(session.is_playing()) << step;
  }
  ASSERT_TRUE(session.next_step());
  EXPECT_EQ(session.t_s(), 0.5) << "another body: the scene's own time";
  EXPECT_FALSE(session.is_playing());
}

TEST(SessionTime, StopsInANewStage) {
  LessonSession session(example());
  session.scrub_to(0.75);
  session.set_playing(true);
  session.go_to({2, 0});
  EXPECT_EQ(session.t_s(), 0);
  EXPECT_FALSE(session.is_playing());
  session.set_playing(true);
  session.go_to({1, 0});
  EXPECT_FALSE(session.is_playing()) << "there is nothing to play";
  session.set_playing(true);
  EXPECT_FALSE(session.is_playing());
}

TEST(SessionTime, ASceneWithADurationPlaysAgainAndAgain) {
  LessonSession session(test::loaded_lesson("intermediate-axis"));
  const auto& stages = session.lesson().stages;
  const auto stage =
      std::find_if(stages.begin(), stages.end(), [](const Stage& s) { return s.id == "separatrix"; });
  ASSERT_NE(stage, stages.end());
  session.go_to({static_cast<std::size_t>(stage - stages.begin()), 0});
  const double end_s = session.lesson_scene().duration_s.value();
  session.set_playing(true);
  int returns = 0;
  for (int i = 0; i < 1000; ++i) {
    const double before_s = session.t_s();
    session.advance(0.04);
    ASSERT_GE(session.t_s(), 0);
    ASSERT_LE(session.t_s(), end_s);
    returns += session.t_s() < before_s;
  }
  EXPECT_TRUE(session.is_playing());
  EXPECT_NEAR(returns, 40 / end_s, 1);
  session.scrub_to(3 * end_s + 1);  // by hand any t
  EXPECT_EQ(session.t_s(), 3 * end_s + 1);
}

}  // namespace
}  // namespace polhode
