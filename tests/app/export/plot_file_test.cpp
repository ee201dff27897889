// SPDX-License-Identifier: MIT
#include "app/export/plot_file.h"

#include "render/image/png.h"
#include "tests/app/run_program.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

WorkPrecisionPlot small_plot() {
  return {.title = "A title",
          .x_label = "ns per period",
          .y_label = "error, rad",
          .series = {{.label = "RK4", .points = {{100, 1e-2}, {1000, 1e-6}}}},
          .tolerance = 1e-6,
          .recommended = std::pair(1000.0, 1e-6),
          .recommended_label = "take this"};
}

TEST(PlotFile, IsASlideThatSaysWhatItShows) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_plot(folder / "plot.png", small_plot()));
  const auto file = read_png(folder / "plot.png");
  ASSERT_TRUE(file.ok()) << file.error();
  EXPECT_EQ(file->image.size, kPlotSize);
  EXPECT_EQ(file->metadata.text[0], (std::pair<std::string, std::string>("Title", "A title")));
  EXPECT_EQ(file->metadata.text[1].second, description_of(small_plot()));
}

TEST(PlotFile, IsDescribedInWords) {
  EXPECT_EQ(description_of(small_plot()),
            "A title: error, rad over ns per period, both logarithmic. RK4: down to 1e-06 at 1e+03. "
            "Tolerance 1e-06. Marked at 1e+03, 1e-06: take this.");
}

TEST(PlotFile, ThatCannotBeWrittenIsAnError) {
  const ScratchFolder folder;
  EXPECT_FALSE(write_plot(folder / "none" / "plot.png", small_plot()));
}

}  // namespace
}  // namespace polhode
