// SPDX-License-Identifier: MIT
#include "app/export_plan.h"

#include "app/exit_codes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using testing::ElementsAre;

Step drawn(double at_s) {
  Step step;
  step.scene = Scene{};
  step.scene->at_s = at_s;
  return step;
}

/// Three stages: two drawn steps, none, then a drawn one before one of text alone.
Lesson lesson() {
  Lesson result;
  result.id = "l";
  result.stages.push_back({"a", "A", {drawn(1), drawn(2)}, {}});
  result.stages.push_back({"b", "B", {Step{}}, {}});
  result.stages.push_back({"c", "C", {drawn(3), Step{}}, {}});
  return result;
}

std::vector<std::string> names(const ExportPlan& plan) {
  std::vector<std::string> result;
  for (const auto& picture : plan.pictures) result.push_back(picture.file);
  return result;
}

ExportOptions film(FrameRate fps, double seconds) {
  ExportOptions options;
  options.each = Each::frame;
  options.fps = fps;
  options.seconds = seconds;
  return options;
}

TEST(ExportPlan, StageShowsItsLastDrawnStep) {
  const Lesson l = lesson();
  const ExportPlan plan = plan_export(l, {});
  EXPECT_THAT(names(plan), ElementsAre("01-a.png", "03-c.png"));
  EXPECT_THAT(plan.without_scene, ElementsAre("b"));
  EXPECT_EQ(plan.pictures[0].step, 2);
  EXPECT_EQ(plan.pictures[1].step, 1);
  EXPECT_EQ(time_of(plan.pictures[0], {}, 5.0), 2.0);
}

TEST(ExportPlan, NumberIsThePlaceInTheLessonNotInTheSelection) {
  const Lesson l = lesson();
  ExportOptions options;
  options.stages = {"c", "c"};
  EXPECT_THAT(names(plan_export(l, options)), ElementsAre("03-c.png"));
  options.stages = {"c", "d"};
  EXPECT_THROW(plan_export(l, options), CommandError);
}

TEST(ExportPlan, StepsAreNumberedFromOne) {
  const Lesson l = lesson();
  ExportOptions options;
  options.each = Each::step;
  EXPECT_THAT(names(plan_export(l, options)),
              ElementsAre("01-a-step1.png", "01-a-step2.png", "03-c-step1.png"));
}

TEST(ExportPlan, FramesAreNumberedOverTheSelection) {
  const Lesson l = lesson();
  const ExportOptions options = film({4, 1}, 1.5);
  const ExportPlan plan = plan_export(l, options);
  ASSERT_EQ(plan.pictures.size(), 12u);
  EXPECT_EQ(plan.pictures.front().file, "01-a-frame00.png");
  EXPECT_EQ(plan.pictures[6].file, "03-c-frame06.png");
  EXPECT_EQ(plan.pictures[6].frame_of_stage, 0);
  EXPECT_EQ(time_of(plan.pictures[7], options, 2.0), 0.5);
}

// Any range is the same files, in the same order, as that part of the whole.
TEST(ExportPlan, RangeIsAPartOfTheWhole) {
  const Lesson l = lesson();
  ExportOptions options = film({5, 1}, 1.0);
  const auto whole = names(plan_export(l, options));
  for (std::int64_t begin = 0; begin < 10; ++begin)
    for (std::int64_t end = begin + 1; end <= 10; ++end) {
      options.frames = FrameRange{begin, end};
      EXPECT_EQ(names(plan_export(l, options)), std::vector(whole.begin() + begin, whole.begin() + end));
    }
  options.frames = FrameRange{0, 11};
  EXPECT_THROW(plan_export(l, options), CommandError);
}

TEST(ExportPlan, RefusesMoreFramesThanALessonMayHave) {
  const Lesson l = lesson();
  EXPECT_EQ(plan_export(l, film({kMaxFrames / 2, 1}, 1.0)).pictures.size(),
            static_cast<std::size_t>(kMaxFrames));
  EXPECT_THROW(plan_export(l, film({kMaxFrames / 2 + 1, 1}, 1.0)), CommandError);
  EXPECT_THROW(plan_export(l, film({1, 1}, 1e300)), CommandError);
}

TEST(ExportPlan, NoFramesAreNoPictures) {
  const Lesson l = lesson();
  EXPECT_TRUE(plan_export(l, film({5, 1}, 0.0)).pictures.empty());
}

}  // namespace
}  // namespace polhode
