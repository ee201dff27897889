// SPDX-License-Identifier: MIT
#include "app/session/words/method_words.h"

#include "tests/app/session/example_lesson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

// 2026-11-26: "the scene asks for it" was said of a method that the reader had chosen.
TEST(WhyMethod, IsNotTheSceneWhereTheReaderChose) {
  LessonSession session(test::example());
  EXPECT_EQ(why_method(session), session.model()->why);
  SceneEdits edits;
  edits.motion = MotionSpec{.method = Method::rk4, .step_s = 0.01};
  ASSERT_TRUE(session.set_edits(edits));
  EXPECT_EQ(why_method(session), "chosen here, in place of the lesson's");
  session.reset_edits();
  EXPECT_EQ(why_method(session), session.model()->why);
}

TEST(RequirementWords, TellWhatIsComputedAndWhatIsNot) {
  Scene scene;
  scene.body.moments = PrincipalMoments(1, 2, 3);
  scene.w0_B = Vec3(0.1, 1.5, 0.2);
  scene.views = {View::body};
  scene.show = {Overlay::omega, Overlay::polhode};
  const RequirementWords words = requirement_words(make_model(scene));
  EXPECT_THAT(words.computed, ElementsAre("ω(t)", "polhode"));
  EXPECT_THAT(words.left_out, Contains("attitude"));
  EXPECT_THAT(words.left_out, Contains("herpolhode"));
  EXPECT_THAT(words.left_out, Not(Contains("polhode")));
}

// A requirement that came later would be missing from the words.
TEST(RequirementWords, HaveAWordForEachRequirement) {
  SceneModel model;
  std::fill_n(reinterpret_cast<bool*>(&model.needs), sizeof model.needs / sizeof(bool), true);
  EXPECT_EQ(requirement_words(model).computed.size(), names_of(model.needs).size());
  EXPECT_THAT(requirement_words(model).left_out, IsEmpty());
}

}  // namespace
}  // namespace polhode
