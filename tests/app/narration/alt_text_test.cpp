// SPDX-License-Identifier: MIT
#include "app/narration/alt_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace polhode {
namespace {

using testing::HasSubstr;
using testing::Not;

Scene rolling() {
  Scene scene;
  scene.show = {Overlay::energy_ellipsoid, Overlay::omega, Overlay::labels, Overlay::polhode};
  return scene;
}

TEST(AltText, SaysWhatIsShownAndNothingElse) {
  const std::string text = alt_text(rolling(), {}, Vec3(0, 0, 2), 1.25);
  EXPECT_THAT(text, testing::StartsWith(
                        "Seen from space: the energy ellipsoid, the angular velocity ω and the polhode."));
  EXPECT_THAT(text, Not(HasSubstr("plane")));
  EXPECT_THAT(text, testing::EndsWith("At t = 1.25 seconds the body turns at 2 radians per second."));
}

Scene with_L() {
  Scene scene = rolling();
  scene.show.insert(Overlay::L);
  return scene;
}

/// Half a second of a torque-free motion, by steps of 1/40 s and less.
SceneModel orders(bool by_evaluations) {
  Scene scene;
  scene.show = {Overlay::order_plot};
  scene.compared.methods = {Method::explicit_euler, Method::rk4};
  scene.motion = {.method = Method::rk4, .step_s = 0.025};
  scene.compared.by_evaluations = by_evaluations;
  scene.at_s = 0.5;
  return make_model(scene);
}

// 29 November 2026: all plots of orders had the same words, by which they were drawn against steps, and no
// curve was told.
TEST(AltText, CurvesOfMethodsAreToldByTheirEndsAndOrders) {
  const std::string steps = alt_text(orders(false), {{}}, 0.5),
                    evaluations = alt_text(orders(true), {{}}, 0.5);
  EXPECT_THAT(steps, HasSubstr("against the number of their steps"));
  EXPECT_THAT(steps,
              testing::ContainsRegex("Explicit Euler: an error of [^;]* with 20 steps, of [^;]* with 1280, "
                                     "order 1;"));
  EXPECT_THAT(steps, testing::ContainsRegex("[^;]* with 20 steps, of [^;]*, order 4[.]"));
  EXPECT_THAT(evaluations, HasSubstr("against the number of their evaluations"));
  EXPECT_THAT(evaluations, testing::ContainsRegex("with 80 evaluations, of [^;]* with 5120, order 4[.]"));
  EXPECT_THAT(alt_text(orders(true), {{.is_asked = true}}, 0.5), HasSubstr("order 4")) << "it is printed";
}

// 29 November 2026: captions spoke of arrows that the alternative text left out.
TEST(AltText, TellsTheExactMotionBesideAndTheWeight) {
  Scene scene = with_L();
  scene.motion = {.method = Method::explicit_euler, .step_s = 0.01, .ghost = true};
  const std::string text = alt_text(scene, {}, Vec3(0, 0, 2), 1.25);
  EXPECT_THAT(text, HasSubstr("the exact L, dashed"));
  EXPECT_THAT(text, HasSubstr("the exact ω, dashed"));
  scene.motion.ghost = false;
  EXPECT_THAT(alt_text(scene, {}, Vec3(0, 0, 2), 1.25), Not(HasSubstr("exact")));
  EXPECT_THAT(text, Not(HasSubstr("the weight")));
  scene.torque = {HeavyTop{1, Vec3::UnitZ()}};
  scene.show = {Overlay::pivot};
  EXPECT_THAT(alt_text(scene, {}, Vec3(0, 0, 2), 1.25), HasSubstr("the weight"));
}

// 28 November 2026: it was told of pictures without L, and of those that ask for it.
TEST(AltText, HowOmegaLiesToLIsToldWhereBothAreDrawn) {
  EXPECT_THAT(
      alt_text(with_L(), {}, Vec3(0, 0, 2), 1.25),
      testing::EndsWith("At t = 1.25 seconds the body turns at 2 radians per second, with ω along L."));
  EXPECT_THAT(alt_text(rolling(), {}, Vec3(0, 0, 2), 1.25), Not(HasSubstr("along L")));
  Scene arrow = rolling();
  ArrowMark mark;
  mark.of.overlay = Overlay::L;
  arrow.marks.arrows = {mark};
  EXPECT_THAT(alt_text(arrow, {}, Vec3(0, 0, 2), 1.25), HasSubstr("with ω along L"));
}

TEST(AltText, AQuestionsFigureDoesNotAnswerIt) {
  EXPECT_THAT(
      alt_text(with_L(), {.is_asked = true}, Vec3(0, 0, 2), 1.25),
      testing::EndsWith("The body has the principal moments 1, 1.75 and 2.5 kilogram square metres."));
}

TEST(AltText, TellsWhatChangesFromMomentToMoment) {
  Scene scene = rolling();
  scene.show = {Overlay::shape, Overlay::omega};
  scene.w0_B = {0, 2, 0};
  SceneModel model = make_model(scene);
  EXPECT_EQ(moment_in_words(model, {}, 0.0, 3.0, 0.0), "") << "nothing has changed yet";
  EXPECT_EQ(
      moment_in_words(model, {}, 0.0, 3.0, 1.5707963),
      "The same at t = 1.571 seconds. Axis 3 of the body points 180 degrees away from where it pointed at "
      "t = 0 seconds.")
      << "no axis that stays where it is";
  scene.views = {View::body};
  model = make_model(scene);
  EXPECT_EQ(moment_in_words(model, {}, 0.0, 3.0, 0.0),
            "Along axes 1, 2, 3 ω has the components 0, 2 and 0 radians per second.");
  scene.show = {Overlay::shape};
  EXPECT_EQ(moment_in_words(make_model(scene), {}, 0.0, 1.0, 1.0), "The same at t = 1 second.")
      << "nothing else is drawn";
}

// 29 November 2026: of two books on ice, "Axis 1 of the body points 0 degrees away" and no word of a centre.
TEST(AltText, MomentsTellHowFarTheCentreHasCome) {
  Scene pushed = rolling();
  pushed.show = {Overlay::shape};
  pushed.w0_B = {0, 0, 0};
  pushed.v0_S = {0, 3, 0};
  EXPECT_EQ(moment_in_words(make_model(pushed), {}, 2.0, 3.0, 3.0),
            "The same at t = 3 seconds. The centre of mass is 3 metres from where it was at t = 2 seconds.")
      << "it does not turn";
  pushed.w0_B = {0, 0, 0.5};
  EXPECT_THAT(
      moment_in_words(make_model(pushed), {}, 0.0, 2.0, 2.0),
      HasSubstr("Axis 1 of the body points 57 degrees away from where it pointed at t = 0 seconds. The "
                "centre of mass is 6 metres"));
}

TEST(AltText, MomentsTellOfAnArrowThatRestsInSpace) {
  Scene scene = rolling();
  scene.show = {Overlay::shape, Overlay::transport};
  scene.w0_B = {0, 0, 1};
  scene.arrow = ArrowHeld::in_space;
  EXPECT_EQ(
      moment_in_words(make_model(scene), {}, 0.0, 2.0, 2.0),
      "The same at t = 2 seconds. Axis 1 of the body points 115 degrees away from where it pointed at t = 0 "
      "seconds. The arrow A points 0 degrees away from where it pointed at t = 0 seconds.");
}

// 28 November 2026: of a plate, "how many wobbles?", the angles that the axes had turned by, but no round.
// I₁ = 1, I₃ = 2, ω₃ = 1, and hardly a lean: the axis goes round L twice a turn of the body.
TEST(AltText, MomentsCountRoundsAboutL) {
  Scene scene = rolling();
  scene.body = {"plate", PrincipalMoments(1, 1, 2), std::nullopt};
  scene.show = {Overlay::shape, Overlay::L};
  scene.w0_B = {0.04, 0, 1};
  const double turn_s = 2.0 * std::numbers::pi;
  EXPECT_EQ(moment_in_words(make_model(scene), {}, 0.0, turn_s, turn_s),
            "The same at t = 6.283 seconds. Since t = 0 seconds, axis 3 has gone round L 2 times, and axis 1 "
            "once.");
}

// A million turns would have to be looked at too often: fewer looks count others than there are.
TEST(AltText, MomentsCountNoRoundsThatAreTooMany) {
  Scene scene = rolling();
  scene.body = {"plate", PrincipalMoments(1, 1, 2), std::nullopt};
  scene.show = {Overlay::shape, Overlay::L};
  scene.w0_B = {0.04, 0, 1};
  EXPECT_THAT(moment_in_words(make_model(scene), {}, 0.0, 1e6, 1e6), HasSubstr("Axis 3 of the body points"));
}

TEST(AltText, MomentsCallAxesByTheirNamesInTheFigure) {
  Scene scene = rolling();
  scene.body = {"plate", PrincipalMoments(1, 1, 2), std::nullopt};
  scene.show = {Overlay::shape, Overlay::L};
  scene.w0_B = {0.04, 0, 1};
  EXPECT_THAT(moment_in_words(make_model(scene), {{.axes = {"\"mark\"", "", ""}}}, 0.0, 6.2831853, 6.2831853),
              testing::EndsWith("axis 3 has gone round L 2 times, and \"mark\" once."));
  scene.body = {"book", PrincipalMoments(1, 1.5, 2), std::nullopt};
  EXPECT_THAT(moment_in_words(make_model(scene), {}, 0.0, 6.2831853, 6.2831853),
              HasSubstr("Axis 3 of the body points"))
      << "of a body that may turn over rounds tell nothing";
}

// λ = (I₃ − I₁)/I₁ ω₃ = 1 rad/s, from axis 1 towards axis 2.
TEST(AltText, MomentsSayWhichWayRoundOmegaGoesInTheBody) {
  Scene scene = rolling();
  scene.body = {"plate", PrincipalMoments(1, 1, 2), std::nullopt};
  scene.views = {View::body};
  scene.show = {Overlay::shape, Overlay::omega};
  scene.w0_B = {0.5, 0, 1};
  EXPECT_EQ(moment_in_words(make_model(scene), {}, 0.0, 3.1415927, 1.5707963),
            "The same at t = 1.571 seconds. Since t = 0 seconds, ω has gone 0.25 times round axis 3, "
            "anticlockwise seen from its tip.");
  scene.body = {"rod", PrincipalMoments(2, 2, 1), std::nullopt};  // λ = −½ rad/s
  EXPECT_THAT(moment_in_words(make_model(scene), {}, 0.0, 6.2831853, 3.1415927),
              HasSubstr("ω has gone 0.25 times round axis 3, clockwise"));
}

// 28 November 2026: 'The body is "near"', which is a word of the file.
TEST(AltText, ABodyHasTheNameThatTheLessonGivesIt) {
  EXPECT_THAT(alt_text(rolling(), {}, Vec3(0, 0, 2), 0.0),
              HasSubstr("The body has the principal moments 1, "));
  EXPECT_THAT(alt_text(rolling(), {.body = "plate"}, Vec3(0, 0, 2), 0.0),
              HasSubstr("The plate has the principal moments 1, "));
}

TEST(AltText, TheSameBodyIsToldOnce) {
  Scene first = rolling(), other = rolling();
  first.beside = {other};
  const std::string text = alt_text(make_model(first), {{}, {}}, 0.0);
  EXPECT_EQ(text.find("principal moments"), text.rfind("principal moments"));
}

// I = (1, 1.75, 2.5), ω = (1, 0, 1): L = (1, 0, 2.5), the angle is atan(2.5) − 45° = 23.2°.
TEST(AltText, NumbersAreComputedForTheMoment) {
  EXPECT_THAT(alt_text(with_L(), {}, Vec3(1, 0, 1), 0.0),
              HasSubstr("1.41 radians per second, with ω 23 degrees away from L"));
}

TEST(AltText, ABodyAtRestHasNoAngle) {
  EXPECT_THAT(alt_text(with_L(), {}, Vec3::Zero(), 0.0), Not(HasSubstr("with ω")));
}

TEST(AltText, NamesTheViewsAndTheCaption) {
  Scene scene = rolling();
  scene.views = {View::space, View::body};
  const std::string text = alt_text(scene, {.caption = "No torque acts", .marks = {}}, Vec3(0, 0, 1), 0.0);
  EXPECT_THAT(text, HasSubstr("side by side"));
  EXPECT_THAT(text, HasSubstr("No torque acts."));
  EXPECT_THAT(
      alt_text(scene, {.caption = "", .marks = {"the arrow of a", "the arrow of b"}}, Vec3(0, 0, 1), 0.0),
      HasSubstr(", the arrow of a and the arrow of b. "));
  scene.views = {View::body};
  EXPECT_THAT(alt_text(scene, {}, Vec3(0, 0, 1), 0.0), HasSubstr("Seen from the body:"));
}

TEST(AltText, DiagramsAloneAreSeenFromNowhere) {
  Scene scene;
  scene.show = {Overlay::cards};
  EXPECT_THAT(alt_text(scene, {}, Vec3(0, 0, 1), 0.0), testing::StartsWith("A diagram: cards"));
  scene.show.insert(Overlay::cofactors);
  EXPECT_THAT(alt_text(scene, {}, Vec3(0, 0, 1), 0.0), testing::StartsWith("Diagrams: "));
  scene.show.insert(Overlay::omega);
  EXPECT_THAT(alt_text(scene, {}, Vec3(0, 0, 1), 0.0), testing::StartsWith("Seen from space: "));
}

TEST(AltText, EveryOverlayButLabelsHasWords) {
  for (int i = 0; i < kOverlayCount; ++i) {
    const auto overlay = static_cast<Overlay>(i);
    Scene scene;
    scene.show = {overlay};
    if (overlay == Overlay::N) scene.torque = {BodyTorque{Vec3(0.1, 0, 0)}};
    if (overlay == Overlay::pivot) scene.torque = {HeavyTop{0.1}};
    scene.v0_S = scene.F_S = Vec3(0, 0, 1);  // for p, v and F
    const std::string text = alt_text(scene, {}, Vec3(0, 0, 1), 0.0);
    EXPECT_EQ(text.find(": nothing.") != std::string::npos, overlay == Overlay::labels) << name_of(overlay);
  }
}

TEST(AltText, NamesNothingThatIsNotDrawn) {  // 2026-11-21: it named the plane of a driven body
  Scene scene;
  scene.show = {Overlay::plane, Overlay::omega};
  scene.torque = {BodyTorque{Vec3(0.1, 0, 0)}};
  EXPECT_EQ(alt_text(scene, {}, Vec3(0, 0, 1), 0.0).find("plane"), std::string::npos);
}

TEST(AltText, ScenesSideBySideAreSaidInTurn) {
  Scene first = with_L();
  first.w0_B = {0, 0, 2};
  Scene other = first;
  other.w0_B = {3, 0, 0};
  other.views = {View::body};
  first.beside = {other};
  const std::string text = alt_text(
      make_model(first), {{.caption = "Left"}, {.caption = "Right", .marks = {"the arrow of a"}}}, 0.5);
  EXPECT_THAT(text, testing::StartsWith("Scene 1 of 2. Seen from space: "));
  EXPECT_THAT(text, HasSubstr("Left. "));
  EXPECT_THAT(text,
              HasSubstr("the body turns at 2 radians per second, with ω along L. Scene 2 of 2. Seen from the "
                        "body: "));
  EXPECT_THAT(text, HasSubstr("and the arrow of a. Right. "));
  EXPECT_THAT(text, testing::EndsWith("the body turns at 3 radians per second, with ω along L."));
}

}  // namespace
}  // namespace polhode
