// SPDX-License-Identifier: MIT
// Plots are read and pressed: rest on one for the values there, click or drag for the time.
#include "tests/app/window/screen_harness.h"

#include <cmath>
#include <cstring>

namespace polhode {
namespace {

class PlotHandTest : public ScreenTest {
 protected:
  /// To the first step whose page has a plot against time.
  const PlotReading& go_to_plot() {
    const auto& stages = session.lesson().stages;
    for (std::size_t stage = 0; stage < stages.size(); ++stage)
      for (std::size_t step = 0; step < stages[stage].steps.size(); ++step) {
        if (!stages[stage].steps[step].scene || stages[stage].steps[step].scene->meters.empty()) continue;
        session.go_to({stage, step});
        frame(3);
        for (const PlotReading& plot : screen->page().page().plots)
          if (plot.is_of_time) return plot;
      }
    throw std::runtime_error("no plot");
  }
  /// The pointer is on whole ones.
  static double pixel(const PlotReading& plot) {
    return (plot.x.back() - plot.x.front()) / plot.frame.width();
  }
  static double middle(const PixelBox& box) { return 0.5 * (box.y0 + box.y1); }
  static double at(const PlotReading& plot, double part) {
    return std::lerp(plot.frame.x0, plot.frame.x1, part);
  }
};

// Until 2026-11-27 plots were dead.
TEST_F(PlotHandTest, AClickIsATime) {
  const PlotReading plot = go_to_plot();
  const StepPlace place = session.place();
  session.set_playing(true);
  click(at(plot, 0.7), middle(plot.frame));
  EXPECT_NEAR(session.t_s(), std::lerp(plot.x.front(), plot.x.back(), 0.7), pixel(plot));
  EXPECT_FALSE(session.is_playing());
  EXPECT_EQ(session.place(), place);
}

TEST_F(PlotHandTest, AHeldPlotGoesOnOutsideOfItsAxes) {
  const PlotReading plot = go_to_plot();
  const CameraSpec camera = session.camera();
  const double to = plot.frame.x1 + 200;
  drag(at(plot, 0.2), middle(plot.frame), std::min(to, kSize.width - 2.0), plot.frame.y0 - 200);
  EXPECT_NEAR(session.t_s(), plot.x.back(), 1e-9 * plot.x.back()) << "as far as it goes";
  EXPECT_EQ(session.camera().azimuth_rad, camera.azimuth_rad) << "the figure was not taken";
}

TEST_F(PlotHandTest, BeforeAnAudienceItIsATimeToo) {
  go_to_plot();
  screen->press(session, "P");
  frame(3);
  const PlotReading plot = screen->page().page().plots.front();
  const StepPlace place = session.place();
  click(at(plot, 0.4), middle(plot.frame));
  EXPECT_EQ(session.place(), place) << "it does not go on to the next step";
  EXPECT_NEAR(session.t_s(), std::lerp(plot.x.front(), plot.x.back(), 0.4), pixel(plot));
}

TEST_F(PlotHandTest, WhereThePointerRestsTheValuesAreWritten) {
  const PlotReading plot = go_to_plot();
  move(5, 5);
  const Image before = screen->read();
  const double t_s = session.t_s();
  move(at(plot, 0.5), middle(plot.frame));
  const Image after = screen->read();
  int inside = 0, outside = 0;
  const PixelBox room = plot.frame.grown(30);
  for (int row = 0; row < kSize.height; ++row)
    for (int column = 0; column < kSize.width; ++column)
      if (std::memcmp(before.pixel(column, row), after.pixel(column, row), 4) != 0)
        ++(room.contains({column, row}) ? inside : outside);
  EXPECT_GT(inside, 150);
  EXPECT_EQ(outside, 0);
  EXPECT_EQ(session.t_s(), t_s) << "nothing is moved by looking";
  move(5, 5);
  EXPECT_EQ(screen->read().rgba, before.rgba);
}

// A panel that lies over a plot has the pointer.
TEST_F(PlotHandTest, APanelOverAPlotHasThePointer) {
  const PlotReading plot = go_to_plot();
  session.panel = Panel::help;
  frame(3);
  const double t_s = session.t_s();
  click(kSize.width - 20, middle(plot.frame));
  EXPECT_EQ(session.t_s(), t_s);
}

}  // namespace
}  // namespace polhode
