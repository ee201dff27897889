// SPDX-License-Identifier: MIT
#include "render/gl/passes/cover.h"

#include "render/figure/figure.h"
#include "render/figure/orbit_camera.h"
#include "tests/render/gl/drawn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

namespace polhode {
namespace {

using Random = std::mt19937;

double between(double low, double high, Random& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

bool holds(const PixelArea& box, double x, double y) {
  return x >= box.x && x <= box.x + box.width && y >= box.y && y <= box.y + box.height;
}

bool hold(const std::vector<PixelArea>& boxes, double x, double y) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const PixelArea& box) { return holds(box, x, y); });
}

double area(const std::vector<PixelArea>& boxes) {
  double sum = 0.0;
  for (const PixelArea& box : boxes) sum += static_cast<double>(box.width) * box.height;
  return sum;
}

TEST(Cover, HoldsWhatIsNearATriangle) {
  Random random(1);
  const PixelArea part{120, 40, 301, 203};
  for (int k = 0; k < 300; ++k) {
    Cover cover(part);
    std::array<Eigen::Vector2d, 3> corners;
    for (Eigen::Vector2d& c : corners) c = {between(-100, 400, random), between(-100, 300, random)};
    if (k % 3 == 0) corners[2] = corners[1];  // a line
    const double margin = between(0, 20, random);
    cover.add(corners, margin);
    const auto boxes = cover.boxes();
    for (int i = 0; i < 200; ++i) {
      const double u = between(0, 1, random), v = between(0, 1 - u, random), turn = between(-4, 4, random);
      const Eigen::Vector2d point = corners[0] + u * (corners[1] - corners[0]) +
                                    v * (corners[2] - corners[0]) +
                                    margin * Eigen::Vector2d(std::cos(turn), std::sin(turn));
      if (point.x() < 0 || point.y() < 0 || point.x() > part.width || point.y() > part.height) continue;
      EXPECT_TRUE(hold(boxes, part.x + point.x(), part.y + point.y())) << k << ": " << point.transpose();
    }
  }
}

TEST(Cover, BoxesAreFewInsideAndApart) {
  Random random(2);
  const PixelArea part{7, 11, 640, 360};
  for (int k = 0; k < 100; ++k) {
    Cover cover(part);
    for (int i = 0; i < 12; ++i) {
      const Eigen::Vector2d at(between(-50, 700, random), between(-50, 400, random));
      cover.add({at, at, at}, between(1, 40, random));
    }
    const auto boxes = cover.boxes();
    EXPECT_LE(boxes.size(), Cover::kMostBoxes);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const PixelArea& box = boxes[i];
      EXPECT_GE(box.x, part.x);
      EXPECT_GE(box.y, part.y);
      EXPECT_LE(box.x + box.width, part.x + part.width);
      EXPECT_LE(box.y + box.height, part.y + part.height);
      // What lay in two of them would be laid over twice.
      if (i > 0) {
        EXPECT_GE(box.y, boxes[i - 1].y + boxes[i - 1].height);
      }
    }
  }
}

TEST(Cover, OfNothingIsNothingAndOfWhatIsNotFiniteAll) {
  const PixelArea part{0, 0, 640, 360};
  EXPECT_TRUE(Cover(part).boxes().empty());
  Cover beyond(part);
  beyond.add({Eigen::Vector2d(700, 10), Eigen::Vector2d(800, 20), Eigen::Vector2d(700, 30)}, 1.0);
  EXPECT_TRUE(beyond.boxes().empty());
  Cover infinite(part);
  infinite.add({Eigen::Vector2d(10, 10), Eigen::Vector2d(20, 20), Eigen::Vector2d(10, 30)}, HUGE_VAL);
  EXPECT_EQ(area(infinite.boxes()), 640.0 * 360.0);
}

Mesh random_mesh(Random& random) {
  Mesh mesh{.positions = {}, .normals = {}, .triangles = {}, .color = {0.3F, 0.4F, 0.6F, 1}};
  for (unsigned i = 0; i < 9; ++i) {
    mesh.positions.push_back(0.5 *
                             Vec3(between(-1, 1, random), between(-1, 1, random), between(-1, 1, random)));
    mesh.normals.emplace_back(0, 0, 1);
    mesh.triangles.push_back(i);
  }
  return mesh;
}

DrawList random_list(Random& random) {
  const auto point = [&] {
    return Vec3(between(-1, 1, random), between(-1, 1, random), between(-1, 1, random));
  };
  const Color color{0.8F, 0.3F, 0.1F, 1};
  DrawList list;
  list.meshes = {random_mesh(random)};
  list.arrows = {{point(), point(), between(0.01, 0.05, random), color}};
  list.balls = {{point(), between(0.02, 0.3, random), color}};
  Tube tube{.points = {}, .closed = true, .radius = between(0.005, 0.1, random), .color = color};
  for (int i = 0; i < 5; ++i) tube.points.push_back(point());
  list.tubes = {tube};
  GlassEllipsoid e;
  e.center = 0.5 * point();
  e.semi_axes = Vec3(between(0.1, 0.6, random), between(0.1, 0.6, random), between(0.1, 0.6, random));
  e.tint = {0.4F, 0.6F, 0.8F, 1};
  if (between(0, 1, random) < 0.5) list.ellipsoids = {e};
  return list;
}

// Drawn the common way, which knows of no cover: what is there and not covered would be missing.
TEST(Cover, HoldsEveryPixelThatIsDrawn) {
  test::Drawn drawn;
  Random random(3);
  const Size size{320, 180};
  const Background clear{Background::Kind::transparent, {}};
  double covered = 0.0;
  constexpr int kFigures = 60;
  for (int k = 0; k < kFigures; ++k) {
    Figure figure{{Pane{}}, 0};
    Pane& pane = figure.panes[0];
    pane.list = random_list(random);
    pane.camera = orbit({.azimuth_rad = between(-3, 3, random),
                         .elevation_rad = between(-1, 1, random),
                         .distance = between(1.7, 5, random)},
                        Vec3::Zero(), 1);
    const auto image = drawn.renderer->draw(figure, size, clear, {4, 1, false});
    ASSERT_TRUE(image) << image.error();
    const Viewpoint at = viewpoint_of(pane.camera, 16.0 / 9.0, size.height);
    const auto boxes = cover_of(pane.list, at, {0, 0, size.width, size.height}).boxes();
    covered += area(boxes) / (kFigures * static_cast<double>(size.width) * size.height);
    int missed = 0;
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const auto alpha = image.value().rgba[4 * static_cast<std::size_t>(y * size.width + x) + 3];
        missed += alpha > 0 && !hold(boxes, x + 0.5, size.height - y - 0.5) ? 1 : 0;
      }
    EXPECT_EQ(missed, 0) << "figure " << k;
  }
  EXPECT_LT(covered, 0.85);  // 0.7 when this was written: a cover of all would be no help
}

// Around a body the layer is as the figure before left it, and nobody looks at it.
TEST(Cover, LayersShowNoTraceOfTheFigureBefore) {
  Random random(4);
  std::vector<Figure> figures(10, Figure{{Pane{}}, 0});
  for (Figure& figure : figures) {
    figure.panes[0].list = random_list(random);
    figure.panes[0].camera =
        orbit({.azimuth_rad = between(-3, 3, random), .elevation_rad = 0.4, .distance = 4}, Vec3::Zero(), 1);
  }
  const auto draw = [](test::Drawn& drawn, const Figure& figure) {
    auto image = drawn.renderer->draw(figure, {320, 180}, {}, {});
    if (!image) throw std::runtime_error(image.error());
    return std::move(image.value().rgba);
  };
  std::vector<std::vector<std::uint8_t>> in_turn;
  {
    test::Drawn one;
    for (const Figure& figure : figures) in_turn.push_back(draw(one, figure));
  }
  for (std::size_t k = 0; k < figures.size(); ++k) {
    test::Drawn fresh;
    EXPECT_TRUE(draw(fresh, figures[k]) == in_turn[k]) << "figure " << k;
  }
}

}  // namespace
}  // namespace polhode
