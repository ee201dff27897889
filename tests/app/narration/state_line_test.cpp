// SPDX-License-Identifier: MIT
#include "app/narration/state_line.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polhode {
namespace {

TEST(StateLine, HasUnits) {
  const double third = 1.0 / 3;
  EXPECT_EQ(state_line({.w0_B = Vec3(1.5, 0, -third)}, Language::en),
            "$\\vec\\omega = (1.5,\\ 0,\\ -0.3333)\\,\\text{rad/s}$");
  EXPECT_EQ(state_line({.moments = Vec3(1.75, 1.75, 2.5), .t_s = 3.55}, Language::en),
            "$(I_1,\\ I_2,\\ I_3) = (1.75,\\ 1.75,\\ 2.5)\\,\\text{kg m²}$; $t = 3.55\\,\\text{s}$");
  EXPECT_EQ(state_line({.torque = SpaceTorque{Vec3(0, 2e-5, 0)}}, Language::en),
            "$\\vec N = (0,\\ 2{\\cdot}10^{-5},\\ 0)\\,\\text{N m}$ along the axes of space");
  EXPECT_EQ(state_line({.attitude = Quat(Eigen::AngleAxisd(std::acos(0.0), Vec3::UnitX()))}, Language::en),
            "$(\\varphi,\\ \\theta,\\ \\psi) = (0,\\ 90,\\ 0)\\text{°}$");
  EXPECT_EQ(state_line({}, Language::en), "");
}

TEST(StateLine, IsInTheLanguage) {
  EXPECT_EQ(state_line({.w0_B = Vec3(1.5, 0, -0.25)}, Language::de),
            "$\\vec\\omega = (1{,}5;\\ 0;\\ -0{,}25)\\,\\text{rad/s}$");
  EXPECT_EQ(state_line({.attitude = LPoints::up}, Language::de), "$\\vec L$ aufrecht");
}

}  // namespace
}  // namespace polhode
