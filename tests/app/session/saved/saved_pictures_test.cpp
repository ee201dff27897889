// SPDX-License-Identifier: MIT
// The picture of a saved scene has the same bytes as what was shown.
#include "app/page/figure_place.h"
#include "app/page/page.h"
#include "app/session/saved/save_as.h"
#include "app/session/saved/saved_scene.h"
#include "lessons/reader/checks/lesson_check.h"
#include "render/figure/make_figure.h"
#include "render/image/png.h"
#include "tests/app/run_program.h"
#include "tests/app/session/example_lesson.h"
#include "tests/base/files/folder.h"
#include "tests/render/gl/drawn.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

constexpr Size kFigure{160, 120}, kPage{480, 320};

test::Drawn& drawn() {
  static test::Drawn drawn;
  return drawn;
}

Image figure_of(const SceneModel& model, double t_s) {
  const Background background = background_from("studio").value();
  const Quality quality = quality_of(model.scene.quality);
  if (!diagrams_in(model.drawn).empty()) {
    const PlacedFigure placed = place_figure(
        model, t_s, {.rect = {0, 0, kFigure.width, kFigure.height}, .caption_px = 10, .quality = quality},
        drawn().fonts());
    return drawn().renderer->draw(placed.sheet, placed.insets, kFigure, background).value();
  }
  const double aspect = static_cast<double>(kFigure.width) / kFigure.height;
  return drawn().renderer->draw(make_figure(model, t_s, aspect), kFigure, background, quality).value();
}

Image page_of(const Lesson& lesson, const Stage& stage, int step, const SceneModel* model, double t_s) {
  const Page page =
      compose_page(
          {.lesson = lesson, .stage = stage, .step = step, .model = model, .t_s = t_s, .size = kPage},
          drawn().fonts())
          .value();
  return drawn().renderer->draw(page.sheet, page.insets, kPage, background_from("paper").value()).value();
}

/// As an export of the saved lesson draws it.
void expect_same_pictures(const LessonSession& session) {
  const LessonReading reading = check_lesson(lesson_of(session), "saved.md");
  ASSERT_TRUE(reading.lesson) << to_string(reading.diagnostics.front());
  const Stage& stage = reading.lesson->stages[0];
  const Scene& scene = *stage.steps.back().scene;
  const double t_s = still_time_s(scene);
  EXPECT_TRUE(figure_of(make_model(scene), t_s).rgba == figure_of(*session.model(), session.t_s()).rgba)
      << lesson_of(session);
  if (session.lesson().stages.size() > 1) return;  // pages say which stage of how many, and which step
  const SceneModel model = make_model(scene, ModelFor::page);
  const int step = static_cast<int>(session.place().step) + 1;
  EXPECT_TRUE(page_of(*reading.lesson, stage, step, &model, t_s).rgba ==
              page_of(session.lesson(), session.stage(), step, session.model(), session.t_s()).rgba)
      << lesson_of(session);
}

TEST(SavedPictures, OfAFreeBodyThatWasChanged) {
  LessonSession session(test::example());
  ASSERT_TRUE(session.set_edits({.body = body_with_moments({1.1, 2.3, 3.0}).value(),
                                 .w0_B = Vec3(0.3, 1.7, 0.2),
                                 .motion = MotionSpec{.method = Method::rk4, .step_s = 0.05, .ghost = true},
                                 .on = {Overlay::shape, Overlay::values},
                                 .views = {{View::space, View::body}}}));
  session.set_camera({.azimuth_rad = 1.23456, .elevation_rad = 0.54321, .distance = 5, .zoom = 1.3});
  session.scrub_to(0.777);
  expect_same_pictures(session);
  const SceneModel& model = *session.model();
  EXPECT_FALSE(figure_of(model, 0.777).rgba == figure_of(model, 0.778).rgba) << "it can fail";
}

TEST(SavedPictures, UnderATorqueAtAnotherTimeThanTheLessons) {
  LessonSession session(test::example());
  session.go_to({2, 0});
  session.set_following(true);
  session.scrub_to(0.31);
  expect_same_pictures(session);
}

TEST(SavedPictures, OfDiagramsAndTables) {
  LessonSession session(test::loaded_text(
      "+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n+++\n# A {a}\n\n```scene\nomega = [0.3, 1, 2]\nshow = "
      "[\"method-table\", \"energy-rows\"]\nmotion = { method = \"rk4\", step = 0.1 }\nat = 1.5\n```\n"));
  ASSERT_TRUE(session.has_scene() && session.model()->needs.methods);
  session.scrub_to(session.t_s() + 0.123);
  expect_same_pictures(session);
}

TEST(SavedPictures, ExportDrawsWhatItDrawsOfTheLessonAtThatTime) {
  const std::string lesson = test::source_dir() / "lessons/euler-equations.md";
  LessonSession session(test::loaded_lesson("euler-equations"));
  std::size_t stage = 0;
  while (session.lesson().stages[stage].id != "rotation-law") ++stage;
  session.go_to({stage, kMaxStepsPerStage});
  session.scrub_to(0.625);
  const ScratchFolder scratch;
  write_text(scratch / "rotation-law.md", lesson_of(session));
  const auto exported = [&](const std::string& from, const char* to, std::vector<std::string> more) {
    more.insert(more.begin(),
                {"export", from, "-o", (scratch / to).string(), "--what", "figure", "--size", "160x120"});
    const ProgramRun run = polhode(more);
    EXPECT_EQ(run.code, 0) << run.err;
    return scratch / to;
  };
  const auto saved = exported((scratch / "rotation-law.md").string(), "saved", {}) / "01-rotation-law.png";
  const auto names = names_in(exported(lesson, "own", {"--stage", "rotation-law", "--at", "0.625"}));
  const auto own = std::find_if(names.begin(), names.end(),
                                [](const auto& name) { return name.ends_with("-rotation-law.png"); });
  ASSERT_NE(own, names.end());
  const ProgramRun run = polhode({"compare", saved.string(), (scratch / "own" / *own).string(), "--json"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("\"max\": 0"), std::string::npos) << run.out;
}

TEST(SavedPictures, OfAWholePage) {
  std::string text = test::example()->lesson.source;
  LessonSession session(test::loaded_text(text.substr(0, text.find("\n# Words"))));
  session.go_to({0, 3});
  session.set_camera({.azimuth_rad = 1.0});
  session.scrub_to(0.9);
  expect_same_pictures(session);
}

// 2026-11-28: where a step derives the button was grey.
TEST(SavedPictures, OfADerivationAsFarAsItGoes) {
  LessonSession session(test::loaded_lesson("euler-equations"));
  const auto derives = [&] {
    const std::vector<const Ask*> asked = session.questions();
    return blocks_of<Equation>(session.step()).empty() && !asked.empty() && asked.front()->derivation;
  };
  for (bool more = true; more && !derives(); more = session.next_step()) {
  }
  ASSERT_TRUE(derives());
  EXPECT_TRUE(saves_derivation(session));
  EXPECT_FALSE(can_save_as(session, SaveAs::equation)) << "the lesson's line alone is none";
  const Ask& ask = *session.questions().front();
  session.derive(ask, ask.derivation->worked.front().line.typed);
  ASSERT_TRUE(can_save_as(session, SaveAs::equation));
  const test::Folder folder;
  const auto begun = save_as(session, SaveAs::equation, {}, folder.path(), *drawn().renderer);
  ASSERT_TRUE(begun) << begun.error();
  EXPECT_NE(begun->filename().string().find(ask.id), std::string::npos) << *begun;
  ASSERT_GT(ask.derivation->worked.size(), 1u);
  session.derive(ask, ask.derivation->worked[1].line.typed);
  const auto longer = save_as(session, SaveAs::equation, {}, folder.path(), *drawn().renderer);
  ASSERT_TRUE(longer) << longer.error();
  EXPECT_GT(read_png(*longer).value().image.size.height, read_png(*begun).value().image.size.height);
}

}  // namespace
}  // namespace polhode
