// SPDX-License-Identifier: MIT
// Sheets as the renderer draws them.
#include "render/figure/make_figure.h"
#include "tests/render/gl/drawn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace polhode {
namespace {

using test::Drawn;
using test::shaped;

std::array<int, 3> rgb(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return {p[0], p[1], p[2]};
}
using Rgb = std::array<int, 3>;

TEST(Sheet, LaterShapesLieOverEarlierOnesFromTheUpperLeft) {
  Sheet sheet;
  sheet.shapes.push_back(Area{{{10, 10}, {60, 10}, {60, 40}, {10, 40}}, {1, 0, 0, 1}});
  sheet.shapes.push_back(Stroke{{{0, 20}, {100, 20}}, 6, {0, 0, 1, 1}});
  const Image image = Drawn().draw(sheet);
  EXPECT_EQ(rgb(image, 30, 12), (Rgb{255, 0, 0}));
  EXPECT_EQ(rgb(image, 30, 20), (Rgb{0, 0, 255}));
  EXPECT_EQ(rgb(image, 30, 35), (Rgb{255, 0, 0}));
  EXPECT_EQ(rgb(image, 30, 45), (Rgb{255, 255, 255}));
  EXPECT_EQ(rgb(image, 100, 70), (Rgb{255, 255, 255}));
}

TEST(Sheet, EdgesCoverWhatTheyCoverOfAPixel) {
  Sheet sheet;
  sheet.shapes.push_back(Area{{{10, 10.25}, {100, 10.25}, {100, 40}, {10, 40}}, {0, 0, 0, 1}});
  // Three quarters of row 10, by a ramp over a pixel; 8 bits.
  EXPECT_NEAR(rgb(Drawn().draw(sheet), 50, 10)[0], 255 * 0.25, 2);
}

TEST(Sheet, TextStartsAtItsOriginOverAllShapes) {
  Drawn drawn;
  Sheet sheet;
  sheet.shapes.push_back(Area{{{0, 0}, {120, 0}, {120, 80}, {0, 80}}, {1, 0, 0, 1}});
  sheet.over_insets.push_back(Area{{{0, 0}, {90, 0}, {90, 80}, {0, 80}}, {0, 1, 0, 1}});
  sheet.texts.push_back({.list = shaped(drawn.fonts(), "HH", 30, {0, 0, 1, 1}), .at = {60, 50}});
  const Image image = drawn.draw(sheet);
  int left = 120, bottom = 0;
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 120; ++x)
      if (image.pixel(x, y)[2] > 128) left = std::min(left, x), bottom = std::max(bottom, y);
  EXPECT_GE(left, 60);
  EXPECT_LE(left, 62) << "a small space before the stem";
  EXPECT_EQ(bottom, 49) << "the baseline is the edge between two rows";
}

TEST(Sheet, TransparentMeansTrueAlpha) {
  Sheet sheet;
  sheet.shapes.push_back(Area{{{10, 10}, {60, 10}, {60, 40}, {10, 40}}, {1, 0, 0, 0.5F}});
  const Image image = Drawn().draw(sheet, "transparent");
  EXPECT_EQ(image.pixel(100, 70)[3], 0);
  EXPECT_NEAR(image.pixel(30, 20)[3], 128, 1);
  EXPECT_NEAR(image.pixel(30, 20)[0], 255, 1);
}

TEST(Sheet, DependsOnNothingDrawnBefore) {
  Drawn drawn;
  Sheet sheet;
  sheet.shapes.push_back(Stroke{{{5, 5}, {90, 60}}, 3, {0.2F, 0.4F, 0.6F, 1}, 7});
  sheet.texts.push_back({.list = shaped(drawn.fonts(), "10", 22, {0, 0, 0, 1}), .at = {40, 50}});
  const Image first = drawn.draw(sheet);
  Figure figure;
  figure.panes.resize(1);
  ASSERT_TRUE(drawn.renderer->draw(figure, {64, 64}, {}).ok());
  EXPECT_EQ(first.rgba, drawn.draw(sheet).rgba);
}

Figure figure_of(double at_s) {
  Scene scene;
  scene.w0_B = Vec3(0.2, 1.1, 1.6);
  scene.show = {Overlay::energy_ellipsoid, Overlay::omega, Overlay::plane};
  return make_figure(make_model(scene), at_s, 1.5);
}

bool same_part(const Image& whole, int x0, int y0, const Image& part) {
  for (int y = 0; y < part.size.height; ++y)
    for (int x = 0; x < part.size.width; ++x)
      for (int k = 0; k < 4; ++k)
        if (whole.pixel(x0 + x, y0 + y)[k] != part.pixel(x, y)[k]) return false;
  return true;
}

TEST(Insets, AreTheFiguresPicturesByteForByte) {
  Drawn drawn;
  const Figure figure = figure_of(0.4);
  const Image alone = drawn.renderer->draw(figure, {150, 100}, {}).value();
  const Image fine = drawn.renderer->draw(figure, {90, 60}, {}, {0, 2}).value();
  const std::vector<Inset> insets = {{figure, {20, 30, 150, 100}, {}, {}},
                                     {figure, {200, 7, 90, 60}, {}, {0, 2}}};
  const Image page = drawn.draw({}, "paper", {300, 200}, insets);
  EXPECT_TRUE(same_part(page, 20, 30, alone));
  EXPECT_TRUE(same_part(page, 200, 7, fine));
  EXPECT_EQ(rgb(page, 19, 30), (Rgb{0xFB, 0xFA, 0xF6}));
  EXPECT_EQ(rgb(page, 170, 129), (Rgb{0xFB, 0xFA, 0xF6}));
}

TEST(Insets, LieOverShapesAndUnderTheRest) {
  Drawn drawn;
  const auto bar = [](double x, const Color& color) {
    return Area{{{x, 0}, {x + 40, 0}, {x + 40, 200}, {x, 200}}, color};
  };
  Sheet sheet;
  sheet.shapes.push_back(bar(30, {1, 0, 0, 1}));
  sheet.over_insets.push_back(bar(100, {0, 0, 1, 1}));
  const std::vector<Inset> insets = {{figure_of(0.4), {20, 30, 150, 100}, {}, {}}};
  const Image page = drawn.draw(sheet, "paper", {300, 200}, insets);
  EXPECT_EQ(rgb(page, 50, 20), (Rgb{255, 0, 0}));
  EXPECT_NE(rgb(page, 50, 40), (Rgb{255, 0, 0}));
  EXPECT_EQ(rgb(page, 120, 40), (Rgb{0, 0, 255}));
}

TEST(Insets, ATransparentOneShowsWhatIsUnderIt) {
  Drawn drawn;
  const Figure figure = figure_of(0.4);
  Sheet sheet;
  sheet.shapes.push_back(Area{{{0, 0}, {300, 0}, {300, 200}, {0, 200}}, color_from_hex(0x204060)});
  Background clear = background_from("transparent").value();
  const std::vector<Inset> insets = {{figure, {20, 30, 150, 100}, clear, {}}};
  const Image page = drawn.draw(sheet, "paper", {300, 200}, insets);
  const Image part = drawn.renderer->draw(figure, {150, 100}, clear).value();
  int worst = 0;
  constexpr int kUnder[] = {0x20, 0x40, 0x60};
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 150; ++x) {
      const std::uint8_t* p = part.pixel(x, y);
      for (int k = 0; k < 3; ++k)
        worst = std::max(worst, std::abs(page.pixel(20 + x, 30 + y)[k] -
                                         (p[k] * p[3] + kUnder[k] * (255 - p[3]) + 127) / 255));
    }
  EXPECT_LE(worst, 3) << "two roundings of eight bits on either side";
}

TEST(Insets, MayLeaveThePage) {
  Drawn drawn;
  const std::vector<Inset> insets = {{figure_of(0.4), {-50, 150, 150, 100}, {}, {}},
                                     {figure_of(0.4), {250, -20, 150, 100}, {}, {}}};
  const Image page = drawn.draw({}, "paper", {300, 200}, insets);
  const Image alone = drawn.renderer->draw(figure_of(0.4), {150, 100}, {}).value();
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(page.pixel(10, 160)[k], alone.pixel(60, 10)[k]);
    EXPECT_EQ(page.pixel(260, 40)[k], alone.pixel(10, 60)[k]);
  }
}

/// Levels of green between two pictures, a pixel.
double apart(const Image& a, const Image& b) {
  double levels = 0;
  for (std::size_t i = 1; i < a.rgba.size(); i += 4) levels += std::abs(a.rgba[i] - b.rgba[i]);
  return levels / (static_cast<double>(a.rgba.size()) / 4);
}

TEST(Insets, OfLessResolutionFillTheSamePlaceAlike) {
  Drawn drawn;
  constexpr PixelRect kPlace{50, 30, 201, 141};
  std::vector<Inset> insets = {{figure_of(0.4), kPlace, {}, {}}};
  const Image full = drawn.draw({}, "paper", {300, 200}, insets);
  const Image none = drawn.draw({}, "paper", {300, 200});
  insets[0].resolution = 0.5;
  const Image coarse = drawn.draw({}, "paper", {300, 200}, insets);
  EXPECT_NE(full.rgba, coarse.rgba);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 300; ++x) {
      const bool inside = x >= 50 && x < 251 && y >= 30 && y < 171;
      ASSERT_TRUE(inside || coarse.pixel(x, y)[1] == none.pixel(x, y)[1]) << x << ", " << y;
    }
  EXPECT_LT(apart(full, coarse), 0.2 * apart(full, none)) << "edges and type differ, not what is shown";
}

TEST(Insets, OfLessResolutionAreWrittenInFull) {
  Drawn drawn;
  Figure names{{Pane{}}, 16};
  names.panes[0].title = "seen from space";
  std::vector<Inset> insets = {{names, {50, 30, 201, 141}, {Background::Kind::color, {1, 1, 1, 1}}, {}}};
  const Image full = drawn.draw({}, "paper", {300, 200}, insets);
  insets[0].figure.panes[0].title.clear();
  EXPECT_NE(drawn.draw({}, "paper", {300, 200}, insets).rgba, full.rgba) << "something is written";
  insets[0].figure = names;
  insets[0].resolution = 0.35;
  EXPECT_EQ(drawn.draw({}, "paper", {300, 200}, insets).rgba, full.rgba);
}

TEST(Insets, OneThatCannotBeDrawnIsAnErrorAndTheNextPageIsDrawn) {
  Drawn drawn;
  for (const PixelRect& place : {PixelRect{0, 0, 0, 10}, PixelRect{0, 0, 17000, 10}}) {
    const std::vector<Inset> insets = {{figure_of(0.4), place, {}, {}}};
    EXPECT_FALSE(drawn.renderer->draw({}, insets, {60, 40}, {}).ok());
    EXPECT_TRUE(drawn.renderer->draw(Sheet{}, {60, 40}, {}).ok());
  }
}

}  // namespace
}  // namespace polhode
