// SPDX-License-Identifier: MIT
#include "app/page/figure_cells.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

namespace polhode {
namespace {

/// A stage whose steps have these scenes, and their models.
class Figures {
 public:
  explicit Figures(const std::vector<Scene>& scenes) {
    lesson_.stages.push_back({"s", "S", {}, {}, {}});
    for (const Scene& scene : scenes) {
      Step step;
      step.scene = std::make_shared<const Scene>(scene);
      lesson_.stages[0].steps.push_back(std::move(step));
      models_.push_back(make_model(scene, ModelFor::page));
      steps_.push_back({static_cast<int>(models_.size()), &models_.back(), 0.1});
    }
  }
  /// They point into this.
  std::vector<FigureCell> on_one_page() const {
    return figures_on_page({.lesson = lesson_,
                            .stage = lesson_.stages[0],
                            .step = steps_.back().step,
                            .model = steps_.back().model,
                            .t_s = 0.1,
                            .before = std::span(steps_).first(steps_.size() - 1),
                            .size = {1600, 900}});
  }

 private:
  Lesson lesson_;
  std::deque<SceneModel> models_;
  std::vector<FiguredStep> steps_;
};

Scene at(double t_s) {
  Scene scene;
  scene.at_s = t_s;
  scene.show = {Overlay::omega};
  return scene;
}

Scene with_plot(double t_s) {
  Scene scene = at(t_s);
  scene.meters.emplace_back(Meter::energy);
  return scene;
}

constexpr PixelBox kColumn{800, 0, 1600, 900};
constexpr double kGap = 10;

PixelBox box_of(const FigureCell& cell) {
  const PixelRect& rect = cell.figure;
  return {double(rect.x), double(rect.y), double(rect.x + rect.width), double(rect.y + rect.height)};
}

TEST(FigureCells, StepsOfOnePictureShareIt) {
  Scene other_words = at(1);
  other_words.caption = "The same, seen again";
  const Figures figures({at(1), other_words, at(2)});
  const std::vector<FigureCell> cells = figures.on_one_page();
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_EQ(cells[0].first_step, 1);
  EXPECT_EQ(cells[0].last_step, 2);
  EXPECT_EQ(cells[0].step->scene->caption, "The same, seen again");
  EXPECT_EQ(cells[1].first_step, 3);
}

TEST(FigureCells, EachBeginsWhereItsTextBeginsIfAllHaveRoom) {
  const Figures figures({at(1), at(2)});
  for (const double top : {400.0, 450.0, 540.0}) {
    std::vector<FigureCell> cells = figures.on_one_page();
    place_beside({120, top}, kColumn, kGap, cells);
    EXPECT_EQ(box_of(cells[0]).y0, 0);
    EXPECT_EQ(box_of(cells[1]).y0, top);
    EXPECT_EQ(box_of(cells[0]).y1, top - kGap);
    EXPECT_EQ(box_of(cells[1]).y1, 900);
  }
}

TEST(FigureCells, NoneIsTooLowHoweverShortItsTextIs) {
  const Figures figures({at(1), at(2), at(3)});
  for (const std::vector<double>& tops : {std::vector{100.0, 140.0, 180.0}, {100.0, 800.0, 850.0}}) {
    std::vector<FigureCell> cells = figures.on_one_page();
    place_beside(tops, kColumn, kGap, cells);
    for (const FigureCell& cell : cells) EXPECT_GE(box_of(cell).height(), 0.8 * 300 - kGap);
    for (std::size_t k = 1; k < 3; ++k) EXPECT_EQ(box_of(cells[k]).y0, box_of(cells[k - 1]).y1 + kGap);
  }
}

TEST(FigureCells, PlotsStandBesideAFigureThatIsBesideText) {
  const Figures figures({with_plot(1), at(2)});
  std::vector<FigureCell> cells = figures.on_one_page();
  place_beside({100, 450}, kColumn, kGap, cells);
  EXPECT_TRUE(cells[0].are_plots_beside);
  EXPECT_EQ(cells[0].meters.x0, box_of(cells[0]).x1);
  EXPECT_LE(cells[0].meters.height(), 0.91 * cells[0].meters.width()) << "no tower";
  EXPECT_EQ(cells[0].meters.y0 - box_of(cells[0]).y0, box_of(cells[0]).y1 - cells[0].meters.y1);
  EXPECT_EQ(box_of(cells[1]).width(), kColumn.width()) << "it has none";
}

TEST(FigureCells, AboveTextFiguresStandSideBySideOverTheirPlots) {
  const Figures figures({with_plot(1), at(2)});
  std::vector<FigureCell> cells = figures.on_one_page();
  place_above({0, 0, 900, 600}, kGap, cells);
  EXPECT_EQ(box_of(cells[1]).x0, box_of(cells[0]).x1 + kGap);
  EXPECT_EQ(box_of(cells[1]).x1, 900);
  EXPECT_FALSE(cells[0].are_plots_beside);
  EXPECT_EQ(cells[0].meters.y0, box_of(cells[0]).y1);
  EXPECT_EQ(cells[0].meters.y1, 600);
  EXPECT_EQ(box_of(cells[1]).y1, 600);
}

}  // namespace
}  // namespace polhode
