// SPDX-License-Identifier: MIT
#include "render/gl/passes/sheet_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr Color kBlack{0, 0, 0, 1};

/// What shape.frag makes of a piece of a stroke, added up over its rectangle.
double area_of_piece(const ShapeVertex& corner) {
  const double half = corner.piece[2], radius = corner.piece[3];
  const double width = std::abs(corner.piece[0]), height = std::abs(corner.piece[1]), step = 0.05;
  double sum = 0.0;
  for (double x = -width + 0.5 * step; x < width; x += step)
    for (double y = -height + 0.5 * step; y < height; y += step)
      sum += step * step * corner.color[3] *
             std::clamp(radius + 0.5 - std::hypot(std::max(std::abs(x) - half, 0.0), y), 0.0, 1.0);
  return sum;
}

/// Area weighted by coverage, as the rasteriser will add it up.
double covered_area(const std::vector<FlatShape>& shapes) {
  const auto g = make_geometry(shapes);
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < g.indices.size(); i += 3) {
    const auto &a = g.vertices[g.indices[i]], &b = g.vertices[g.indices[i + 1]],
               &c = g.vertices[g.indices[i + 2]];
    if (a.piece != kNoPiece) {  // two triangles each
      if (i % 6 == 0) sum += area_of_piece(a);
      continue;
    }
    const double ux = b.position[0] - a.position[0], uy = b.position[1] - a.position[1];
    const double vx = c.position[0] - a.position[0], vy = c.position[1] - a.position[1];
    sum += 0.5 * std::abs(ux * vy - uy * vx) * (a.color[3] + b.color[3] + c.color[3]) / 3.0;
  }
  return sum;
}

TEST(SheetGeometry, AnAreaKeepsItsSize) {
  // A soft corner loses a twelfth of a square pixel and the miter gains as much, four times.
  EXPECT_NEAR(covered_area({Area{{{10, 10}, {30, 10}, {30, 25}, {10, 25}}, kBlack}}), 300.0, 1.0);
  EXPECT_NEAR(covered_area({Area{{{10, 25}, {30, 25}, {30, 10}, {10, 10}}, kBlack}}), 300.0, 1.0)
      << "either way round";
}

TEST(SheetGeometry, AStrokeCoversItsWidthAndRoundEnds) {
  for (double width : {1.0, 3.0, 12.0}) {
    const double capsule = 50.0 * width + 0.25 * M_PI * width * width;
    // The soft edge of a disc of radius r adds up to pi (r^2 + 1/12).
    const double fringe = M_PI / 12.0;
    EXPECT_NEAR(covered_area({Stroke{{{5, 5}, {35, 45}}, width, kBlack}}), capsule + fringe, 0.002 * capsule)
        << width;
  }
}

TEST(SheetGeometry, AHairlineIsAPixelWideAndFaint) {
  EXPECT_NEAR(covered_area({Stroke{{{0, 0}, {100, 0}}, 0.25, kBlack}}), 25.0, 1.0);
}

TEST(SheetGeometry, ADashedStrokeIsHalfThere) {
  const double solid = covered_area({Stroke{{{0, 0}, {400, 0}}, 2.0, kBlack}});
  const double dashed = covered_area({Stroke{{{0, 0}, {150, 0}, {400, 0}}, 2.0, kBlack, 20.0}});
  // Ten dashes of 20 px; each has two round ends of 1 px radius and the fringe of those.
  EXPECT_NEAR(dashed, 0.5 * solid, 10 * 4.0);
}

TEST(SheetGeometry, AStarIsFilledWithoutItsNotches) {
  std::vector<Vec2> star;
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 ? 8.0 : 20.0, a = M_PI * i / 5.0;
    star.emplace_back(50 + r * std::cos(a), 50 + r * std::sin(a));
  }
  const double area = 5.0 * 20.0 * 8.0 * std::sin(M_PI / 5.0);
  EXPECT_NEAR(covered_area({Area{star, kBlack}}), area, 0.05 * area);
}

TEST(SheetGeometry, ColoursArePremultiplied) {
  const auto g = make_geometry({Area{{{0, 0}, {9, 0}, {9, 9}}, Color{1.0F, 0.5F, 0.0F, 0.5F}}});
  EXPECT_EQ(g.vertices[0].color, (std::array<float, 4>{0.5F, 0.25F, 0.0F, 0.5F}));
}

TEST(SheetGeometry, NothingIsDrawnOfNothing) {
  EXPECT_TRUE(
      make_geometry({Area{{}, kBlack}, Area{{{1, 1}, {2, 2}}, kBlack}, Area{{{1, 1}, {1, 1}, {1, 1}}, kBlack},
                     Stroke{{}, 1, kBlack}, Stroke{{{1, 1}}, 1, kBlack}})
          .indices.empty());
}

TEST(SheetGeometry, APointDrawnAsAStrokeIsADisc) {
  EXPECT_NEAR(covered_area({Stroke{{{5, 5}, {5, 5}}, 10.0, kBlack}}), 25.0 * M_PI, 3.0);
}

}  // namespace
}  // namespace polhode
