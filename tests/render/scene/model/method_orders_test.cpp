// SPDX-License-Identifier: MIT
#include "render/scene/model/method_orders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace polhode {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Half a second by steps of 1/10 s, 1/20 s, ..., where a step has an error of its own.
std::vector<MethodTable> tables(const std::vector<double>& errors, double evaluations_a_step = 4) {
  std::vector<MethodTable> all;
  double step_s = 0.1;
  for (const double error : errors) {
    MethodTable& table = all.emplace_back();
    table.t_s = 0.5;
    table.step_s = step_s;
    table.rows.resize(2);
    table.rows[0].error.omega = kNone;
    table.rows[1].method = Method::rk4;
    table.rows[1].error.omega = error;
    table.rows[1].evaluations_per_s = evaluations_a_step / step_s;
    step_s /= 2;
  }
  return all;
}

TEST(MethodOrders, AreOfTheShortestStepsAboveRounding) {
  // Order 3 of the first two, order 4 of the next; the last is rounding, which does not fall any more.
  const std::vector<MethodOrder> orders = method_orders(tables({8e-3, 1e-3, 1e-3 / 16, 2e-12, 3e-12}), false);
  ASSERT_EQ(orders.size(), 1u) << "the reference has no steps";
  EXPECT_EQ(orders[0].method, Method::rk4);
  ASSERT_TRUE(orders[0].order);
  EXPECT_DOUBLE_EQ(*orders[0].order, 4.0);
  ASSERT_EQ(orders[0].points.size(), 5u);
  EXPECT_DOUBLE_EQ(orders[0].points.front().first, 5.0) << "steps in half a second";
  EXPECT_DOUBLE_EQ(orders[0].points.back().first, 80.0);
  EXPECT_DOUBLE_EQ(orders[0].points.front().second, 8e-3);
}

TEST(MethodOrders, WorkIsCountedInStepsOrInEvaluations) {
  const std::vector<MethodOrder> orders = method_orders(tables({1e-2, 1e-4}), true);
  ASSERT_EQ(orders.size(), 1u);
  EXPECT_DOUBLE_EQ(orders[0].points.front().first, 20.0) << "four in each of five steps";
}

TEST(MethodOrders, AMethodThatDidNotFollowHasNoPointAndALargeErrorNoOrder) {
  EXPECT_TRUE(method_orders(tables({kNone, 1e3}), false).empty());
  const std::vector<MethodOrder> orders = method_orders(tables({1e3, 0.8, 0.2}), false);
  ASSERT_EQ(orders.size(), 1u);
  EXPECT_EQ(orders[0].points.size(), 2u);
  EXPECT_FALSE(orders[0].order);
  EXPECT_TRUE(method_orders({}, false).empty());
}

}  // namespace
}  // namespace polhode
