// SPDX-License-Identifier: MIT
#include "app/cli/measure/work_precision_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace polhode {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

WorkPrecisionRow row(Method method, double ns, double error) {
  WorkPrecisionRow made;
  made.method = method;
  made.ns_per_period = ns;
  made.error_omega = error;
  made.error_attitude_rad = error / 2;
  return made;
}

MeasureReport report() {
  MeasureReport made;
  made.rows = {row(Method::exact, 5, 0),           row(Method::rk4, 1000, NAN),
               row(Method::rk4, 2000, 1e-4),       row(Method::rk4, 4000, 1e-6),
               row(Method::splitting, 5000, 1e-5), row(Method::explicit_euler, 9000, NAN)};
  made.tolerance = 1e-3;
  made.recommended = 0;
  return made;
}

const Problem kFree{PrincipalMoments(1, 2, 3), {Quat::Identity(), Vec3(0.1, 1.5, 0.2)}, {}};

TEST(WorkPrecisionPlot, HasASeriesForEachMethodThatGaveANumber) {
  const WorkPrecisionPlot plot = plot_of(report(), kFree);
  ASSERT_EQ(plot.series.size(), 3u);
  EXPECT_EQ(plot.series[0].label, "exact");
  EXPECT_EQ(plot.series[0].look, PlotLook::star);
  EXPECT_TRUE(plot.series[0].emphasized);
  EXPECT_EQ(plot.series[1].label, "rk4");
  EXPECT_TRUE(plot.series[1].emphasized);  // on the front of the methods that go step by step
  EXPECT_FALSE(plot.series[2].emphasized);
  EXPECT_THAT(plot.series[1].points, ElementsAre(Pair(2.0, 1e-4), Pair(4.0, 1e-6)));
}

TEST(WorkPrecisionPlot, MarksWhatIsRecommended) {
  const WorkPrecisionPlot plot = plot_of(report(), kFree);
  EXPECT_EQ(plot.tolerance, 1e-3);
  EXPECT_EQ(plot.recommended, std::pair(0.005, 0.0));
  EXPECT_EQ(plot.recommended_label, "5 ns a period");
  EXPECT_THAT(plot.note, HasSubstr("(1, 2, 3)"));
  MeasureReport none = report();
  none.recommended.reset();
  EXPECT_FALSE(plot_of(none, kFree).recommended);
}

// An explosion, 1e20 times off, would press all that matters into a corner.
TEST(WorkPrecisionPlot, LeavesOutWhatExploded) {
  MeasureReport exploding = report();
  exploding.rows.push_back(row(Method::explicit_euler, 9500, 1e20));
  exploding.rows.push_back(row(Method::explicit_euler, 9900, 3));
  const WorkPrecisionPlot plot = plot_of(exploding, kFree);
  EXPECT_THAT(plot.series.back().points, ElementsAre(Pair(9.9, 3.0)));
}

TEST(WorkPrecisionPlot, WritesUnitsAsItsAxisDoes) {
  MeasureReport step = report();
  step.recommended = 2;
  step.rows[2].step_s = 0.0104719755;
  EXPECT_EQ(plot_of(step, kFree).recommended_label, "step 0.0105 s, 2 µs a period");
}

}  // namespace
}  // namespace polhode
