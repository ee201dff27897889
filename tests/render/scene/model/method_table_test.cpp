// SPDX-License-Identifier: MIT
#include "render/scene/model/method_table.h"

#include "physics/method.h"
#include "render/scene/model/model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode {
namespace {

double degrees(double rad) { return rad * 180.0 / std::numbers::pi; }

const MethodRow& row_of(const MethodTable& table, Method method) {
  return *std::ranges::find(table.rows, method, &MethodRow::method);
}

Scene slender_rod() {
  Scene scene;
  scene.body.moments = PrincipalMoments(1, 1, 1e-4);
  scene.w0_B = {0.1, 0, 200};
  scene.motion = {.method = Method::rk4, .step_s = 0.001};
  scene.at_s = 4.56;
  scene.show = {Overlay::method_table};
  return scene;
}

// The lecture's stage `trust`: no conserved quantity proves a motion.
TEST(MethodTable, KeptQuantitiesDoNotProveAMotion) {
  const MethodTable table = make_model(slender_rod()).methods;
  const MethodRow& exponential = row_of(table, Method::implicit_midpoint_exp);
  EXPECT_LT(exponential.drift.T, 1e-12);
  EXPECT_LT(exponential.drift.L, 1e-12);
  EXPECT_NEAR(degrees(exponential.drift.L_direction_rad), 141.0, 0.5) << "as the lecture has it, in degrees";
  const MethodRow& cayley = row_of(table, Method::implicit_midpoint);
  EXPECT_LT(cayley.drift.T, 1e-12);
  EXPECT_LT(cayley.drift.L_direction_rad, 1e-12);
  EXPECT_GT(degrees(cayley.error.attitude_rad), 170.0);
  const MethodRow& best = row_of(table, Method::moser_veselov_10);
  EXPECT_LT(best.error.attitude_rad, 1e-10);
}

TEST(MethodTable, ComesWithItsReferenceAndItsCost) {
  const MethodTable table = make_model(slender_rod()).methods;
  EXPECT_EQ(table.rows.front().method, Method::exact);
  EXPECT_TRUE(std::isnan(table.rows.front().error.omega));
  EXPECT_EQ(table.rows.size(), 12u);
  // Four a step; the last one is as short as is left, and may be one more.
  EXPECT_NEAR(row_of(table, Method::rk4).evaluations_per_s, 4000.0, 4.0 / 4.56 + 1e-9);
  EXPECT_NEAR(row_of(table, Method::explicit_euler).evaluations_per_s, 1000.0, 1.0 / 4.56 + 1e-9);
}

TEST(MethodTable, UnderTorqueHasTheMethodsThatServeIt) {
  Scene scene = slender_rod();
  scene.body = find_body("book").value();
  scene.w0_B = {1, 2, 1};
  scene.torque = {LinearDamping{0.01}};
  scene.motion = {};
  const MethodTable table = make_model(scene).methods;
  for (const MethodRow& row : table.rows) {
    EXPECT_FALSE(why_not(row.method, problem_of(scene))) << name_of(row.method);
    EXPECT_TRUE(std::isnan(row.drift.T)) << "nothing is kept";
    EXPECT_TRUE(std::isfinite(row.error.omega)) << name_of(row.method);
  }
  EXPECT_LT(row_of(table, Method::dormand_prince_8).error.omega, 100 * kDefaultTolerance);
}

TEST(MethodTable, WithoutAStepItTakes64ToATurn) {
  Scene scene = slender_rod();
  scene.motion = {};
  scene.at_s = 0.1;
  EXPECT_NEAR(make_model(scene).methods.step_s, 2.0 * std::numbers::pi / (64.0 * scene.w0_B.norm()), 1e-15);
}

TEST(MethodTable, TooManyStepsAreRefusedBeforeTheyAreMade) {
  Scene scene = slender_rod();
  scene.at_s = 101.0;
  EXPECT_THROW(check_scene(scene), std::domain_error);
  EXPECT_THROW(make_model(scene), std::domain_error);
  scene.show = {Overlay::omega};
  EXPECT_NO_THROW(check_scene(scene));
}

}  // namespace
}  // namespace polhode
