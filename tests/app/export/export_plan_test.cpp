// SPDX-License-Identifier: MIT
#include "app/export/export_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

using testing::ElementsAre;

Step drawn(double at_s, std::optional<double> still_s = {}) {
  Step step;
  Scene scene;
  scene.at_s = at_s;
  scene.still_s = still_s;
  step.scene = std::make_shared<const Scene>(std::move(scene));
  return step;
}

/// Three stages: two drawn steps, none, then a drawn one before one of text alone.
Lesson lesson() {
  Lesson result;
  result.id = "l";
  result.stages.push_back({"a", "A", {}, {drawn(1), drawn(2)}, {}});
  result.stages.push_back({"b", "B", {}, {Step{}}, {}});
  result.stages.push_back({"c", "C", {}, {drawn(3), Step{}}, {}});
  return result;
}

std::vector<std::string> names(const ExportPlan& plan) {
  std::vector<std::string> result;
  for (const auto& picture : plan.pictures) result.push_back(picture.file);
  return result;
}

ExportOptions figures() {
  ExportOptions options;
  options.what = What::figure;
  return options;
}

ExportOptions film(FrameRate fps, double seconds) {
  ExportOptions options = figures();
  options.each = Each::frame;
  options.fps = fps;
  options.seconds = seconds;
  return options;
}

TEST(ExportPlan, StageShowsItsLastDrawnStep) {
  const Lesson l = lesson();
  const ExportPlan plan = plan_export(l, figures()).value();
  EXPECT_THAT(names(plan), ElementsAre("01-a.png", "03-c.png"));
  EXPECT_THAT(plan.left_out, ElementsAre("b"));
  EXPECT_EQ(plan.pictures[0].step, 2);
  EXPECT_EQ(plan.pictures[1].step, 1);
  EXPECT_EQ(time_of(plan.pictures[0], {}, 5.0), 2.0);
}

TEST(ExportPlan, AStillMayBeOfAnotherTimeThanTheScenesOwn) {
  Lesson l = lesson();
  l.stages[0].steps[1] = drawn(2, 7.0);
  ExportOptions options = figures();
  const ExportPlan plan = plan_export(l, options).value();
  EXPECT_EQ(time_of(plan.pictures[0], options, 5.0), 7.0);
  options.at_s = 3.0;
  EXPECT_EQ(time_of(plan.pictures[0], options, 5.0), 3.0);
}

TEST(ExportPlan, NumberIsThePlaceInTheLessonNotInTheSelection) {
  const Lesson l = lesson();
  ExportOptions options = figures();
  options.stages = {"c", "c"};
  EXPECT_THAT(names(plan_export(l, options).value()), ElementsAre("03-c.png"));
  options.stages = {"c", "d"};
  EXPECT_FALSE(plan_export(l, options));
}

TEST(ExportPlan, StepsAreNumberedFromOne) {
  const Lesson l = lesson();
  ExportOptions options = figures();
  options.each = Each::step;
  EXPECT_THAT(names(plan_export(l, options).value()),
              ElementsAre("01-a-step1.png", "01-a-step2.png", "03-c-step1.png"));
}

TEST(ExportPlan, FramesAreNumberedOverTheSelection) {
  const Lesson l = lesson();
  const ExportOptions options = film({4, 1}, 1.5);
  const ExportPlan plan = plan_export(l, options).value();
  ASSERT_EQ(plan.pictures.size(), 12u);
  EXPECT_EQ(plan.pictures.front().file, "01-a-frame00.png");
  EXPECT_EQ(plan.pictures[6].file, "03-c-frame06.png");
  EXPECT_EQ(plan.pictures[6].frame_of_stage, 0);
  EXPECT_EQ(time_of(plan.pictures[7], options, 2.0), 0.5);
}

TEST(ExportPlan, FramesOfAStageAreSharedAmongItsDrawnSteps) {
  const Lesson l = lesson();
  ExportOptions options = film({5, 1}, 1.0);
  const auto steps = [&] {
    std::vector<std::string> shown;
    const ExportPlan plan = plan_export(l, options).value();
    for (const PlannedPicture& picture : plan.pictures)
      shown.push_back(picture.stage->id + std::to_string(picture.step) + ':' +
                      std::to_string(picture.frame_of_step));
    return shown;
  };
  EXPECT_THAT(steps(), ElementsAre("a1:0", "a1:1", "a2:0", "a2:1", "a2:2",  //
                                   "c1:0", "c1:1", "c1:2", "c1:3", "c1:4"));
  const ExportPlan plan = plan_export(l, options).value();
  EXPECT_EQ(plan.pictures[1].scene, &*l.stages[0].steps[0].scene);
  EXPECT_EQ(plan.pictures[2].scene, &*l.stages[0].steps[1].scene);
  EXPECT_EQ(time_of(plan.pictures[2], options, 1.0), 0.4) << "time runs on";
  options.what = What::page;
  options.stages = {"c"};
  EXPECT_THAT(steps(), ElementsAre("c1:0", "c1:1", "c2:0", "c2:1", "c2:2"));
  options.seconds = 0.2;
  EXPECT_THAT(steps(), ElementsAre("c2:0")) << "too few frames end with the last step all the same";
}

// For any number of frames and steps: in order, no step left out while there are frames for all, and no step
// has two frames more than another.
TEST(ExportPlan, FramesAreSharedEvenly) {
  for (std::size_t steps = 1; steps <= 7; ++steps)
    for (int frames = 1; frames <= 40; ++frames) {
      Lesson l;
      l.stages.push_back({"a", "A", {}, std::vector<Step>(steps, drawn(0)), {}});
      std::vector<std::int64_t> count(steps);
      int last = 1;
      const ExportPlan plan = plan_export(l, film({frames, 1}, 1.0)).value();
      for (const PlannedPicture& picture : plan.pictures) {
        ASSERT_GE(picture.step, last);
        last = picture.step;
        ASSERT_EQ(picture.frame_of_step, count[static_cast<std::size_t>(last - 1)]++)
            << frames << "/" << steps;
      }
      EXPECT_EQ(last, static_cast<int>(steps));
      const auto [least, most] = std::minmax_element(count.begin(), count.end());
      EXPECT_LE(*most - *least, 1) << frames << " frames, " << steps << " steps";
    }
}

// Any range is the same files, in the same order, as that part of the whole.
TEST(ExportPlan, RangeIsAPartOfTheWhole) {
  const Lesson l = lesson();
  ExportOptions options = film({5, 1}, 1.0);
  const auto whole = names(plan_export(l, options).value());
  for (std::int64_t begin = 0; begin < 10; ++begin)
    for (std::int64_t end = begin + 1; end <= 10; ++end) {
      options.frames = FrameRange{begin, end};
      EXPECT_EQ(names(plan_export(l, options).value()),
                std::vector(whole.begin() + begin, whole.begin() + end));
    }
  options.frames = FrameRange{0, 11};
  EXPECT_FALSE(plan_export(l, options));
}

TEST(ExportPlan, RefusesMoreFramesThanALessonMayHave) {
  const Lesson l = lesson();
  EXPECT_EQ(plan_export(l, film({kMaxFrames / 2, 1}, 1.0)).value().pictures.size(),
            static_cast<std::size_t>(kMaxFrames));
  EXPECT_FALSE(plan_export(l, film({kMaxFrames / 2 + 1, 1}, 1.0)));
  EXPECT_FALSE(plan_export(l, film({1, 1}, 1e300)));
}

TEST(ExportPlan, NoFramesAreNoPictures) {
  const Lesson l = lesson();
  EXPECT_TRUE(plan_export(l, film({5, 1}, 0.0)).value().pictures.empty());
}

/// The first stage has two equations in its first step, the last one in its second.
Lesson with_equations() {
  Lesson result = lesson();
  const auto add = [](Step& step, const char* id) {
    Equation equation;
    equation.id = id;
    step.blocks.emplace_back(std::move(equation));
  };
  add(result.stages[0].steps[0], "e1");
  add(result.stages[0].steps[0], "e2");
  add(result.stages[2].steps[1], "e3");
  return result;
}

ExportOptions of(What what, Each each = Each::stage) {
  ExportOptions options;
  options.what = what;
  options.each = each;
  options.seconds = 1;
  options.fps = {2, 1};
  return options;
}

TEST(ExportPlan, EveryStageHasPages) {
  const Lesson l = lesson();
  const ExportPlan plan = plan_export(l, of(What::page)).value();
  EXPECT_THAT(names(plan), ElementsAre("01-a.png", "02-b.png", "03-c.png"));
  EXPECT_THAT(plan.left_out, ElementsAre());
  EXPECT_EQ(plan.pictures[0].scene, &*l.stages[0].steps[1].scene);
  EXPECT_EQ(plan.pictures[1].scene, nullptr);
  EXPECT_EQ(plan.pictures[2].step, 2);
  EXPECT_EQ(plan.pictures[2].number, 3);
  EXPECT_THAT(
      names(plan_export(l, of(What::page, Each::step)).value()),
      ElementsAre("01-a-step1.png", "01-a-step2.png", "02-b-step1.png", "03-c-step1.png", "03-c-step2.png"));
  EXPECT_EQ(plan_export(l, of(What::page, Each::frame)).value().pictures.size(), 6u);
}

TEST(ExportPlan, EquationsHaveTheirNames) {
  const Lesson l = with_equations();
  const ExportPlan plan = plan_export(l, of(What::equation)).value();
  EXPECT_THAT(names(plan), ElementsAre("01-a-e1.png", "01-a-e2.png", "03-c-e3.png"));
  EXPECT_THAT(plan.left_out, ElementsAre("b"));
  EXPECT_EQ(plan.pictures[1].equation->id, "e2");
  EXPECT_EQ(plan.pictures[2].step, 2);
}

TEST(ExportPlan, AStepOfEquationsIsWhatItComesTo) {
  const Lesson l = with_equations();
  const ExportPlan plan = plan_export(l, of(What::equation, Each::step)).value();
  EXPECT_THAT(names(plan), ElementsAre("01-a-step1.png", "03-c-step2.png"));
  EXPECT_EQ(plan.pictures[0].equation->id, "e2");
}

TEST(ExportPlan, AFilmOfEquationsIsOneForEachStage) {
  const Lesson l = with_equations();
  const ExportPlan plan = plan_export(l, of(What::equation, Each::frame)).value();
  EXPECT_THAT(names(plan),
              ElementsAre("01-a-frame0.png", "01-a-frame1.png", "03-c-frame2.png", "03-c-frame3.png"));
  for (const PlannedPicture& picture : plan.pictures) EXPECT_EQ(picture.equation, nullptr);
  EXPECT_EQ(equations_of(l.stages[0]).size(), 2u);
}

}  // namespace
}  // namespace polhode
