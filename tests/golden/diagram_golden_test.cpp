// SPDX-License-Identifier: MIT
// Golden diagrams at 480x270, as figures by themselves, each proved able to fail.
#include "app/page/figure_place.h"
#include "render/image/compare.h"
#include "tests/golden/approval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace polhode::golden {
namespace {

constexpr Size kSize{480, 270};

struct Row {
  std::string name;
  Scene scene;
  bool moves = true;       ///< with time
  bool is_of_body = true;  ///< depends on the moments
  Theme theme = Theme::paper;
};

Scene scene_of(const OverlaySet& show, const Vec3& w0_B, double at_s) {
  Scene scene;
  scene.show = show;
  scene.w0_B = w0_B;
  scene.at_s = at_s;
  scene.caption = "A caption";
  return scene;
}

Scene slender_rod() {
  Scene scene = scene_of({Overlay::method_table}, {0.1, 0, 200}, 4.56);
  scene.body.moments = PrincipalMoments(1, 1, 1e-4);
  scene.motion.step_s = 0.001;
  scene.motion.method = Method::rk4;
  return scene;
}

std::vector<Row> rows() {
  const Vec3 w_B(1.2, 0.35, 0.85);
  return {{"board-tensor-bars", scene_of({Overlay::omega, Overlay::tensor_bars}, w_B, 1.5)},
          {"board-cofactors", scene_of({Overlay::cofactors}, w_B, 4.0)},
          {"board-wheel", scene_of({Overlay::cyclic_wheel}, w_B, 1.5), true, true, Theme::dark},
          {"board-energy-rows", scene_of({Overlay::energy_rows}, w_B, 1.5)},
          {"board-methods", slender_rod(), false},
          {"board-orders", scene_of({Overlay::order_plot}, w_B, 10.0), false},
          {"board-cards", scene_of({Overlay::cards}, w_B, 1.0), false, false}};
}

Image picture(const Row& row, double later_s = 0.0) {
  const SceneModel model = make_model(row.scene);
  const Color paper = colors_of(row.theme).paper;
  const Background background{Background::Kind::color, paper};
  const FigurePlace place{.rect = {0, 0, kSize.width, kSize.height},
                          .caption_px = caption_px_of(kSize),
                          .theme = row.theme,
                          .background = background,
                          .ground = paper,
                          .quality = {}};
  const PlacedFigure placed = place_figure(model, row.scene.at_s + later_s, place, renderer().fonts());
  auto image = renderer().draw(placed.sheet, placed.insets, kSize, background);
  if (!image) throw std::runtime_error(image.error());
  return std::move(image).value();
}

class GoldenDiagram : public testing::TestWithParam<Row> {};

TEST_P(GoldenDiagram, IsAsApproved) { expect_as_approved(GetParam().name, picture(GetParam())); }

TEST_P(GoldenDiagram, RefusesEveryMutationThatCanChangeIt) {
  const Row& row = GetParam();
  const Image approved = picture(row);
  const auto refused = [&](const Row& mutated, double later_s = 0.0) {
    return !compare_images(approved, picture(mutated, later_s)).equal();
  };
  EXPECT_EQ(refused(row, make_model(row.scene).rate / 4.0), row.moves) << "a quarter of a second later";
  Row mutated = row;
  mutated.scene.body.moments = PrincipalMoments(1.0, 1.8, 2.45);
  EXPECT_EQ(refused(mutated), row.is_of_body) << "other moments";
  mutated = row;
  mutated.theme = row.theme == Theme::paper ? Theme::dark : Theme::paper;
  EXPECT_TRUE(refused(mutated)) << "the other theme";
  mutated = row;
  mutated.scene.caption = "A coption";
  EXPECT_TRUE(refused(mutated)) << "one letter of the caption";
}

TEST_P(GoldenDiagram, RepeatsToTheByte) { EXPECT_EQ(picture(GetParam()).rgba, picture(GetParam()).rgba); }

INSTANTIATE_TEST_SUITE_P(All, GoldenDiagram, testing::ValuesIn(rows()), [](const auto& row) {
  std::string name = row.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace

std::vector<std::string> diagram_names() {
  std::vector<std::string> names;
  for (const Row& row : rows()) names.push_back(row.name);
  return names;
}

}  // namespace polhode::golden
