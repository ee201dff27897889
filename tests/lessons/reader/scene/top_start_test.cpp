// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/top_start.h"

#include "lessons/reader/scene/scene_keys.h"
#include "physics/analysis/symmetric_top.h"
#include "physics/body/euler_angles.h"
#include "physics/body/pivot.h"
#include "render/scene/model/scene_problem.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kDegree = std::numbers::pi / 180;

/// The bodies begin on line 5, the scene of the one stage on line 9.
std::string with_body(const std::string& body, const std::string& scenes) {
  return "+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n" + body + "\n+++\n# X {x}\n```scene\n" + scenes +
         "\n```\n";
}

const std::string kTop =
    "body.top = { shape = \"cylinder\", size_m = [0.2, 0.2, 0.02], mass_kg = 1.0, pivot_m = [0, 0, -0.1] }";
constexpr double kI1 = 0.01 / 4 + 0.0004 / 12 + 0.01, kI3 = 0.01 / 2, kMgl = 0.980665;

std::vector<std::string> complaints(const std::string& body, const std::string& scenes) {
  return testing::complaints(with_body(body, scenes));
}

Scene scene_of(const std::string& body, const std::string& scenes, std::size_t step = 0) {
  const LessonReading reading = read_lesson(with_body(body, scenes), "x.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  return *reading.lesson->stages[0].steps.at(step).scene;
}

Scene top_with(const std::string& start) {
  return scene_of(kTop, "body = \"top\"\ntorque = \"weight\"\nstart = " + start);
}

TEST(Weight, IsGravityOnABodyHeldAtItsPivot) {
  const Scene scene = scene_of(kTop, "body = \"top\"\ntorque = [\"damping:0.5\", \"weight\"]");
  EXPECT_LT((scene.body.moments.vector() - Vec3(kI1, kI1, kI3)).norm(), 8 * kEpsilon * kI1);
  ASSERT_EQ(scene.torque.size(), 2U);
  const auto& top = std::get<HeavyTop>(scene.torque[0]);
  EXPECT_NEAR(top.mgr, kMgl, 4 * kEpsilon);
  EXPECT_EQ(top.axis_B, Vec3::UnitZ());
  EXPECT_EQ(scene.torque[1], TorqueTerm(LinearDamping{0.5}));
}

TEST(Weight, OfABodyWithMomentsMovesThemToo) {
  const std::string body = "body.plate = { moments = [1.0, 2.0, 2.9], mass_kg = 3, pivot_m = [0.5, 0, 0] }";
  const Scene scene = scene_of(body, "body = \"plate\"\ntorque = \"weight\"");
  EXPECT_LT((scene.body.moments.vector() - Vec3(1.0, 2.75, 3.65)).norm(), 16 * kEpsilon);  // m l² = 3/4
  EXPECT_EQ(std::get<HeavyTop>(scene.torque[0]).axis_B, -Vec3::UnitX());
  EXPECT_EQ(scene_of(body, "body = \"plate\"").body.moments, PrincipalMoments(1.0, 2.0, 2.9)) << "free";
}

TEST(Weight, HoldsFromStepToStepAndMovesNothingTwice) {
  const std::string later =
      "body = \"top\"\ntorque = \"weight\"\n```\n---\n```scene\nat = 1\n```\n---\n```scene\n";
  const Vec3 I = scene_of(kTop, later + "at = 2", 0).body.moments.vector();
  EXPECT_EQ(scene_of(kTop, later + "at = 2", 1).body.moments.vector(), I);
  const Scene free = scene_of(kTop, later + "torque = []", 2);
  EXPECT_TRUE(free.torque.empty());
  EXPECT_LT((free.body.moments.vector() - Vec3(kI1 - 0.01, kI1 - 0.01, kI3)).norm(), 8 * kEpsilon);
}

TEST(Weight, IsSaidByHeavyInOtherWords) {
  const Scene scene = scene_of(kTop, "body = \"top\"\ntorque = \"heavy:0.980665,0,0,1\"");
  EXPECT_LT((scene.body.moments.vector() - Vec3(kI1, kI1, kI3)).norm(), 8 * kEpsilon * kI1);
  EXPECT_THAT(
      complaints(kTop, "body = \"top\"\ntorque = \"heavy:0.98,0,0,1\""),
      ElementsAre("10:10: error: \"heavy\" holds \"top\" at another point than its pivot_m (write torque "
                  "= \"weight\", or leave pivot_m out)"));
}

TEST(Weight, NeedsAPivot) {
  EXPECT_THAT(
      complaints("", "torque = \"weight\""),
      ElementsAre(
          "9:10: error: \"weight\" turns a body about the point where it is held, and \"textbook\" "
          "has none (give the lesson a [body.NAME] of its own, with mass_kg and pivot_m = [x, y, z])"));
  EXPECT_THAT(
      complaints("body.rod = { moments = [1, 2, 2] }", "body = \"rod\"\ntorque = \"weight\""),
      ElementsAre("10:10: error: \"weight\" turns a body about the point where it is held, and \"rod\" has "
                  "none (give [body.rod] a mass_kg and pivot_m = [x, y, z], in m from its centre of mass)"));
  EXPECT_THAT(
      complaints(kTop, "body = \"top\"\ntorque = \"weight\"\n```\n---\n```scene\nbody = \"book\""),
      ElementsAre(HasSubstr("14:8: error: \"weight\" turns a body about the point where it is held, and "
                            "\"book\" has none")));
}

TEST(Weight, OfTheFrontMatterIsThatOfTheStagesBodies) {
  const auto complaints_of = [](const std::string& base, const std::string& scene) {
    return complaints(kTop + "\n[scene]\n" + base, scene);
  };
  EXPECT_THAT(complaints_of("torque = \"weight\"", "body = \"top\""), IsEmpty());
  EXPECT_THAT(complaints_of("body = \"top\"\nstart = { theta_deg = 60, spin = 60, precession = \"slow\" }",
                            "torque = \"weight\""),
              IsEmpty());
  EXPECT_THAT(complaints_of("torque = \"weight\"", "at = 1\n```\n---\n```scene\nat = 2"),
              ElementsAre(HasSubstr("10:1: error: \"weight\" turns a body")))
      << "once, where it is shown";
  EXPECT_THAT(complaints_of("torque = \"weight\"", ""), ElementsAre(HasSubstr("10:1: error: \"weight\"")));
  EXPECT_THAT(complaints_of("body = \"book\"\ntorque = \"weight\"", "at = 1"),
              ElementsAre(HasSubstr("8:10: error: \"weight\"")));
}

TEST(Weight, IsAllOfGravity) {
  EXPECT_THAT(complaints(kTop, "body = \"top\"\ntorque = [\"weight\", \"weight\"]"),
              ElementsAre("10:21: error: \"weight\" is there already"));
  EXPECT_THAT(complaints(kTop, "body = \"top\"\ntorque = [\"weight\", \"heavy:0.980665,0,0,1\"]"),
              ::testing::Contains("10:10: error: \"weight\" and \"heavy\" are both gravity (leave one out)"));
  EXPECT_THAT(complaints(kTop, "body = \"top\"\ntorque = \"wieght\""),
              ElementsAre(HasSubstr("or \"weight\": gravity on a body with a pivot_m")));
}

TEST(Pivot, LiesOnAnAxisAndHasAMass) {
  const auto refused = [](const std::string& body) {
    return complaints("body.b = { " + body + " }", "body = \"b\"");
  };
  const std::string box = "shape = \"box\", size_m = [1, 2, 3], mass_kg = 2, pivot_m = ";
  EXPECT_THAT(
      refused(box + "[0, 0.5, 0.5]"),
      ElementsAre(HasSubstr("error: the moments of \"b\" about the pivot: its weight hangs on no principal "
                            "axis, so that 1, 2, 3 are not principal at the pivot (let two of its numbers be "
                            "0, or give moments about the pivot and a torque \"heavy:…\")")));
  EXPECT_THAT(refused(box + "[0, 0, 0]"), ElementsAre(HasSubstr("\"pivot_m\" is the centre of mass")));
  EXPECT_THAT(refused(box + "[0, 0, 1e200]"), ElementsAre(HasSubstr("is not finite")));
  EXPECT_THAT(refused(box + "[0, 0, nan]"), ElementsAre(HasSubstr("finite")));
  EXPECT_THAT(refused(box + "0.1"), ElementsAre(HasSubstr("takes a list of 3 numbers")));
  EXPECT_THAT(refused(box + "[0, 0, 1e-300]"), IsEmpty());
  EXPECT_THAT(
      refused("moments = [1, 2, 2], pivot_m = [0, 0, 1]"),
      ElementsAre(HasSubstr("lacks \"mass_kg\": its weight is to turn it (write mass_kg = 1.0 in kg)")));
  EXPECT_THAT(refused("moments = [1, 2, 2], mass_kg = 1, pivot_m = [0, 0, 1], draw = \"box\""),
              ElementsAre(HasSubstr("\"draw\" is for bodies without a pivot")));
}

TEST(Body, GivenByMomentsMayHaveAMass) {
  const auto body = [](const std::string& keys) {
    return scene_of("body.b = { moments = [1.0, 2.0, 2.9]" + keys + " }", "body = \"b\"").body;
  };
  EXPECT_EQ(body("").mass_kg, 1.0);
  EXPECT_EQ(body(", mass_kg = 4").mass_kg, 4.0);
  // m (b² + c²)/12 and cyclic: four times the mass, edges half as long.
  const Shape light = *body(", draw = \"box\"").shape, heavy = *body(", mass_kg = 4, draw = \"box\"").shape;
  EXPECT_LT((heavy.size_m - 0.5 * light.size_m).norm(), 8 * kEpsilon);
  EXPECT_LT((box_moments(heavy.size_m, 4).vector() - Vec3(1.0, 2.0, 2.9)).norm(), 32 * kEpsilon);
}

TEST(Pivot, HoldsTheCentreOfMass) {
  const std::string says =
      "error: a body that is held at a pivot does not follow a velocity or force of its centre of "
      "mass (leave them out, or write velocity = [0, 0, 0] and force = [0, 0, 0])";
  EXPECT_THAT(complaints(kTop, "body = \"top\"\ntorque = \"weight\"\nforce = [0, 0, -9.8]"),
              ElementsAre("11:9: " + says));
  EXPECT_THAT(complaints("", "torque = \"heavy:1,0,0,1\"\nvelocity = [1, 0, 0]"),
              ElementsAre("10:12: " + says));
  EXPECT_THAT(complaints("", "force = [1, 0, 0]\n```\n---\n```scene\ntorque = \"heavy:1,0,0,1\""),
              ElementsAre("13:10: " + says));
  EXPECT_THAT(
      complaints("", "force = [1, 0, 0]\n```\n---\n```scene\ntorque = \"heavy:1,0,0,1\"\nforce = [0, 0, 0]"),
      IsEmpty());
}

TEST(TopStart, IsTheAttitudeAndTheAngularVelocity) {
  const Scene scene =
      top_with("{ theta_deg = 60, phi_deg = 400, psi_deg = -30, spin = 50, precession = -2.5 }");
  const EulerAngles angles = euler_angles_of(std::get<Quat>(*scene.attitude));
  EXPECT_NEAR(angles.theta_rad, 60 * kDegree, 8 * kEpsilon);
  EXPECT_NEAR(angles.phi_rad, 40 * kDegree, 8 * kEpsilon);
  EXPECT_NEAR(angles.psi_rad, -30 * kDegree, 8 * kEpsilon);
  const double across = -2.5 * std::sin(60 * kDegree);
  EXPECT_LT(
      (scene.w0_B - Vec3(across * std::sin(-30 * kDegree), across * std::cos(-30 * kDegree), 50)).norm(),
      16 * kEpsilon);
  EXPECT_EQ(top_with("{ theta_deg = 60, spin = 50 }").w0_B, Vec3(0, 0, 50));
  EXPECT_EQ(top_with("{ theta_deg = 0, spin = 50 }").w0_B, Vec3(0, 0, 50));
}

/// Ω of a scene whose ψ is 0: ω2 = Ω sinθ.
double precession_of(const std::string& start) {
  const Scene scene = top_with(start);
  const double theta = euler_angles_of(std::get<Quat>(*scene.attitude)).theta_rad;
  return scene.w0_B[1] / std::sin(theta);
}

TEST(TopStart, SolvesTheQuadraticOfSteadyPrecession) {
  for (double theta_deg : {10.0, 60.0, 89.0, 120.0, 170.0})
    for (double spin : {60.0, 200.0, -60.0}) {
      const auto start = [&](const std::string& which) {
        return "{ theta_deg = " + std::to_string(theta_deg) + ", spin = " + std::to_string(spin) +
               ", precession = \"" + which + "\" }";
      };
      const double a = kI1 * std::cos(theta_deg * kDegree), b = kI3 * spin;
      const double slow = precession_of(start("slow")), fast = precession_of(start("fast"));
      for (double rate : {slow, fast})
        EXPECT_NEAR(a * rate * rate - b * rate + kMgl, 0, 64 * kEpsilon * (std::abs(b * rate) + kMgl))
            << theta_deg << ' ' << spin;
      EXPECT_LT(std::abs(slow), std::abs(fast));
    }
  EXPECT_NEAR(precession_of("{ theta_deg = 90, spin = 60, precession = \"slow\" }"), kMgl / (kI3 * 60),
              1e-14);
}

TEST(TopStart, KnowsWhichWayTheCentreOfMassIs) {
  const std::string hung =
      "body.top = { shape = \"cylinder\", size_m = [0.2, 0.2, 0.02], mass_kg = 1.0, pivot_m = [0, 0, 0.1] }";
  const Scene scene = scene_of(hung,
                               "body = \"top\"\ntorque = \"weight\"\nstart = { theta_deg = 60, spin = 60, "
                               "precession = \"slow\" }");
  const double rate = scene.w0_B[1] / std::sin(60 * kDegree);
  EXPECT_NEAR(kI1 * 0.5 * rate * rate - kI3 * 60 * rate - kMgl, 0, 64 * kEpsilon);
  EXPECT_LT(rate, 0) << "it goes the other way round";
}

TEST(TopStart, RefusesWhatNoTopDoes) {
  const auto refused = [](const std::string& start) {
    return complaints(kTop, "body = \"top\"\ntorque = \"weight\"\nstart = " + start);
  };
  const double least = std::sqrt(4 * kI1 * kMgl * 0.5) / kI3;  // 31.357
  EXPECT_THAT(
      refused("{ theta_deg = 60, spin = 20, precession = \"slow\" }"),
      ElementsAre("11:9: error: start: no steady precession at theta_deg = 60 with spin = 20: it takes at "
                  "least 31.35733 rad/s (let it spin faster, or write precession as a number, in rad/s)"));
  EXPECT_NEAR(least, 31.35733, 1e-4);
  EXPECT_THAT(refused("{ theta_deg = 60, spin = 31.35733, precession = \"fast\" }"), IsEmpty())
      << "what was said";
  EXPECT_THAT(refused("{ theta_deg = 90, spin = 60, precession = \"fast\" }"),
              ElementsAre(HasSubstr("at theta_deg = 90 there is one steady precession, the slow one")));
  EXPECT_THAT(refused("{ theta_deg = 90, spin = 0, precession = \"slow\" }"),
              ElementsAre(HasSubstr("some spin")));
  EXPECT_THAT(refused("{ theta_deg = 0, spin = 60, precession = \"slow\" }"),
              ElementsAre(HasSubstr("a vertical axis does not precess")));
  EXPECT_THAT(refused("{ theta_deg = 180, spin = 60, precession = 2 }"), ElementsAre(HasSubstr("vertical")));
  EXPECT_THAT(refused("{ theta_deg = 1, spin = 1e200, precession = \"fast\" }"),
              ElementsAre(HasSubstr("too fast")));
  EXPECT_THAT(refused("{ theta_deg = 181, spin = 1 }"),
              ElementsAre(HasSubstr("\"theta_deg\" must lie between 0 and 180")));
  EXPECT_THAT(refused("{ theta_deg = nan, spin = 1, precession = \"slow\" }"),
              ElementsAre(HasSubstr("11:23")));
  EXPECT_THAT(refused("{ theta_deg = 60 }"), ElementsAre(HasSubstr("\"start\" lacks \"spin\"")));
  EXPECT_THAT(refused("{ spin = 60 }"), ElementsAre(HasSubstr("\"start\" lacks \"theta_deg\"")));
  EXPECT_THAT(refused("{ theta_deg = 60, spin = \"fast\" }"), ElementsAre(HasSubstr("takes a number")));
  EXPECT_THAT(refused("{ theta_deg = 60, spin = 1, precession = \"quick\" }"),
              ElementsAre(HasSubstr("unknown precession \"quick\"")));
  EXPECT_THAT(
      refused("{ theta_deg = 60, spin = 1, precesion = 1 }"),
      ElementsAre(HasSubstr("unknown key \"precesion\" in \"start\" (did you mean \"precession\"?)")));
  EXPECT_THAT(refused("60"), ElementsAre(HasSubstr("\"start\" takes a table")));
}

TEST(TopStart, IsSteadyOnlyUnderTheWeightOfASymmetricTop) {
  const std::string slow = "start = { theta_deg = 60, spin = 60, precession = \"slow\" }";
  EXPECT_THAT(complaints(kTop, "body = \"top\"\n" + slow),
              ElementsAre(HasSubstr("is that of a top with weight, and there is none")));
  EXPECT_THAT(
      complaints("body.book = { shape = \"box\", size_m = [1, 2, 3], mass_kg = 1, pivot_m = [0, 0, 1] }",
                 "body = \"book\"\ntorque = \"weight\"\n" + slow),
      ElementsAre(
          HasSubstr("a top with I1 = I2 and its weight on axis 3; the moments about the pivot are ")));
  EXPECT_THAT(
      complaints(kTop, "body = \"top\"\ntorque = \"weight\"\n" + slow + "\n```\n---\n```scene\ntorque = []"),
      ElementsAre(HasSubstr("15:10: error: start: precession = \"slow\"")));
  EXPECT_THAT(complaints("", "start = { theta_deg = 60, spin = 3, precession = 1 }"), IsEmpty())
      << "a free body";
}

TEST(TopStart, IsInPlaceOfOmegaAndAttitude) {
  EXPECT_THAT(
      complaints(kTop, "omega = [1, 2, 3]\nstart = { theta_deg = 60, spin = 60 }"),
      ElementsAre(
          "10:1: error: a scene has a start, or omega and attitude, not both (leave out \"omega\", or "
          "write it in place of the start)"));
  const std::string steps =
      "start = { theta_deg = 60, spin = 60 }\n```\n---\n```scene\nomega = [1, 2, 3]\n```\n---\n"
      "```scene\nstart = { theta_deg = 30, spin = 5 }\n```\n---\n```scene\nattitude = \"L-up\"";
  EXPECT_EQ(scene_of("", steps, 1).w0_B, Vec3(1, 2, 3));
  EXPECT_EQ(*scene_of("", steps, 1).attitude, *scene_of("", steps, 0).attitude)
      << "the rest of the start stays";
  EXPECT_EQ(scene_of("", steps, 2).w0_B, Vec3(0, 0, 5));
  EXPECT_EQ(scene_of("", steps, 3).w0_B, Vec3(0, 0, 5));
  EXPECT_EQ(std::get<LPoints>(*scene_of("", steps, 3).attitude), LPoints::up);
}

// A steady precession is solved for the body and torque of each step.
TEST(TopStart, IsOfTheStepsOwnBody) {
  const std::string bodies = kTop +
                             "\nbody.heavy = { shape = \"cylinder\", size_m = [0.2, 0.2, 0.02], mass_kg = "
                             "1.0, pivot_m = [0, 0, -0.2] }";
  const LessonReading reading = read_lesson(
      with_body(bodies,
                "body = \"top\"\ntorque = \"weight\"\nstart = { theta_deg = 90, spin = 60, precession = "
                "\"slow\" }\n```\n---\n```scene\nbody = \"heavy\""),
      "x.md");
  ASSERT_TRUE(reading.lesson);
  const auto& steps = reading.lesson->stages[0].steps;
  EXPECT_NEAR(steps[1].scene->w0_B[1], 2 * steps[0].scene->w0_B[1], 16 * kEpsilon) << "m g l/(I3 ω3)";
}

// Bug B2 of a shape under `heavy`: moments about its centre made the nutation a fifth of what it is.
TEST(Weight, TiltsTheTopAsFarAsItShould) {
  const Scene scene =
      scene_of("body.rod = { shape = \"cylinder\", size_m = [0.2, 0.2, 0.02], mass_kg = 1.0 }",
               "body = \"rod\"\ntorque = \"heavy:0.980665,0,0,1\"\nomega = [0, 0, 60]\n"
               "attitude = [0.8660254037844386, 0.5, 0, 0]");
  const auto found = nutation(*symmetric_top(scene.body.moments, scene.torque), problem_of(scene).start);
  ASSERT_TRUE(found);
  // The other turning point of a top let go at u0: u of (1 − u²) β = a² (u0 − u).
  const double a = kI3 * 60 / kI1, beta = 2 * kMgl / kI1;
  const double u = (a * a - std::sqrt(a * a * a * a - 4 * beta * (a * a * 0.5 - beta))) / (2 * beta);
  EXPECT_NEAR(found->theta_most_rad, std::acos(u), 1e-12);
  EXPECT_NEAR(found->theta_most_rad / kDegree, 75.9, 0.05) << "as an instructor computed it";
}

}  // namespace
}  // namespace polhode
