// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/quantity_key.h"

#include "lessons/reader/scene/scene_keys.h"
#include "physics/body/euler.h"
#include "render/scene/model/model.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace polhode {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kMgl = 2.5;

/// A top whose scene has a plot of each.
std::string lesson_plotting(const std::vector<std::string>& curves, const std::string& mgl = "2.5") {
  std::string plots;
  for (const std::string& curve : curves) plots += "{ plot = \"" + curve + "\" }, ";
  return "+++\nformat = 1\nid = \"quantities\"\ntitle = \"Quantities\"\n"
         "[constants]\nmgl = { value = " +
         mgl +
         ", tex = 'm g \\ell', unit = \"N m\" }\n"
         "[define]\nu = { means = \"dot(ez, e3)\", tex = 'u', unit = \"1\" }\n"
         "E = { means = \"T + mgl*u\", tex = 'E', unit = \"J\" }\n"
         "[symbols]\nL = { tex = '\\vec L', role = \"L\", say = \"angular momentum\" }\n"
         "[scene]\nbody = \"book\"\nomega = [0.3, 1, 20]\nattitude = [0.8, 0.6, 0, 0]\n"
         "torque = \"heavy:2.5,0,0,1\"\nduration = 0.5\nmeters = [" +
         plots + "]\n+++\n\n# A stage {stage}\n\n```scene\n```\n";
}

Scene scene_of(const std::string& text) {
  LessonReading reading = read_lesson(text, "quantities.md");
  EXPECT_THAT(testing::lines_of(reading.diagnostics), ::testing::IsEmpty());
  if (!reading.lesson) return {};
  return *reading.lesson->stages.front().steps.front().scene;
}

std::vector<SceneQuantity> curves_of(const Scene& scene) {
  std::vector<SceneQuantity> curves;
  for (const PlotSpec& plot : scene.meters) curves.push_back(std::get<OwnPlot>(plot).curves.front());
  return curves;
}

double value_of(const SceneQuantity& quantity, const SceneModel& model, double t_s) {
  const auto value = quantity.value(model, t_s, model.motion->at(t_s));
  return value ? value->x() : std::numeric_limits<double>::quiet_NaN();
}

TEST(SceneQuantity, IsWhatTheLessonSaysOnTheMotionOfTheScene) {
  const Scene scene = scene_of(lesson_plotting({"E", "u", "norm(L)", "ddt(T)", "mgl*u + T", "w1"}));
  const SceneModel model = make_model(scene, ModelFor::page);
  EXPECT_TRUE(model.needs.omega && model.needs.attitude) << "a quantity may speak of all of the motion";

  const PrincipalMoments& I = model.scene.body.moments;
  const auto curves = curves_of(scene);
  ASSERT_EQ(curves.size(), 6u);
  for (const double t_s : {0.0, 0.2, 0.5}) {
    const RigidBodyState now = model.motion->at(t_s);
    const double T = kinetic_energy(I, now.w_B), u = (now.q_SB * Vec3::UnitZ()).z();
    // A few roundings of terms no larger than T + mgl, or of the vector.
    const double rounding = 32 * kEpsilon * (T + kMgl);
    EXPECT_NEAR(value_of(curves[0], model, t_s), T + kMgl * u, rounding);
    EXPECT_NEAR(value_of(curves[1], model, t_s), u, 32 * kEpsilon);
    const double L = angular_momentum_B(I, now.w_B).norm();
    EXPECT_NEAR(value_of(curves[2], model, t_s), L, 32 * kEpsilon * L);
    // dT/dt = N·ω, by a difference good to 1e-13 of the terms ω·I·ω̇, at most 2T times the rate of ω.
    const double power = torque_B(scene.torque, now).dot(now.w_B);
    EXPECT_NEAR(value_of(curves[3], model, t_s), power, 1e-8 * T * now.w_B.norm());
    EXPECT_EQ(value_of(curves[4], model, t_s), value_of(curves[0], model, t_s));
    EXPECT_EQ(value_of(curves[5], model, t_s), now.w_B[0]);
  }
}

TEST(SceneQuantity, HasTheTexTheUnitAndTheColourOfItsWords) {
  const Scene scene = scene_of(lesson_plotting({"E", "mgl*u", "T", "E + T"}));
  const auto curves = curves_of(scene);
  EXPECT_EQ(curves[0].tex, "E");
  EXPECT_EQ(curves[1].tex, "m g \\ell\\,u");
  for (const SceneQuantity& quantity : curves) EXPECT_EQ(quantity.unit, "J") << quantity.text;

  const Scene other = scene_of(lesson_plotting({"comp(L, 1)", "dot(L, ez)", "norm(L)"}));
  for (const SceneQuantity& quantity : curves_of(other)) {
    EXPECT_EQ(quantity.role, "L") << quantity.text;
    EXPECT_EQ(quantity.unit, "kg m²/s") << quantity.text;
  }
  EXPECT_EQ(curves_of(scene_of(lesson_plotting({"w2"}))).front().role, "omega");
  EXPECT_EQ(curves_of(scene_of(lesson_plotting({"N1"}))).front().unit, "N m");
  EXPECT_EQ(curves_of(scene_of(lesson_plotting({"acos(u)"}))).front().unit, "rad");
}

TEST(SceneQuantity, IsTheSameIfItsTextAndItsMeaningAre) {
  const auto quantity = [](const std::string& text, const std::string& mgl = "2.5") {
    return curves_of(scene_of(lesson_plotting({text}, mgl))).front();
  };
  EXPECT_EQ(quantity("E"), quantity("E"));
  EXPECT_NE(quantity("E"), quantity("T"));
  EXPECT_NE(quantity("E"), quantity("T + mgl*u")) << "another text is printed";
  EXPECT_NE(quantity("E"), quantity("E", "2.6")) << "a lesson that was changed";
}

TEST(SceneQuantity, HasNoValueWhereItIsNotDefined) {
  const Scene scene = scene_of(lesson_plotting({"1/(u - u)", "sqrt(0 - u^2 - 1)"}));
  const SceneModel model = make_model(scene, ModelFor::page);
  for (const SceneQuantity& quantity : curves_of(scene))
    EXPECT_TRUE(std::isnan(value_of(quantity, model, 0.1))) << quantity.text;
}

TEST(SceneQuantity, RefusesWhatNoMotionHas) {
  const auto complaint = [](const std::string& expression) {
    const auto lines = testing::complaints(lesson_plotting({expression}));
    return lines.empty() ? std::string() : lines.front();
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(complaint("h*T"), HasSubstr("\"h\" is any number"));
  EXPECT_THAT(complaint("tilt"), HasSubstr("tilt"));
  EXPECT_THAT(complaint("T + u"), HasSubstr("units disagree"));
  EXPECT_THAT(complaint("L"), HasSubstr("is a vector"));
  EXPECT_THAT(complaint("T +"), HasSubstr("error"));
}

}  // namespace
}  // namespace polhode
