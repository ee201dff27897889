// SPDX-License-Identifier: MIT
#include "render/figure/make_figure.h"
#include "render/palette.h"
#include "tests/render/gl/drawn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace polhode {
namespace {

using O = Overlay;

struct Drawn : test::Drawn {
  using test::Drawn::Drawn;
  Image draw(const Scene& scene, Size size, const char* background = "studio") {
    const double aspect = static_cast<double>(size.width) / size.height;
    auto image = renderer->draw(make_figure(make_model(scene), scene.at_s, aspect), size,
                                background_from(background).value());
    if (!image) throw std::runtime_error(image.error());
    return std::move(image).value();
  }
};

/// A symmetric top with I1 = I2 = 1 kg m², I3 = 2 kg m², whose motion a page of paper gives.
Scene top_scene(OverlaySet show) {
  Scene scene;
  scene.body = {"top", PrincipalMoments(1.0, 1.0, 2.0), std::nullopt};
  scene.w0_B = Vec3(0.8, 0.0, 1.5);
  scene.show = show;
  scene.at_s = 1.37;
  scene.attitude = LPoints::up;
  return scene;
}

/// ω in space without any of the program's code: at t = 0 the body is turned about y so that L = (0.8, 0, 3)
/// points up; then ω goes round L at |L|/I1 (Goldstein §5.6).
Vec3 omega_S_by_hand(double t_s) {
  const double L = std::hypot(0.8, 3.0), s = 0.8 / L, c = 3.0 / L;
  const double x = c * 0.8 - s * 1.5, z = s * 0.8 + c * 1.5;
  return {x * std::cos(L * t_s), x * std::sin(L * t_s), z};
}

/// Pinhole projection by dot products, px from the upper left corner.
Eigen::Vector2d project_by_hand(const Camera& camera, const Vec3& point, Size size) {
  const Vec3 ahead = (camera.target - camera.eye).normalized();
  const Vec3 right = ahead.cross(camera.up).normalized(), up = right.cross(ahead);
  const Vec3 d = point - camera.eye;
  const double px = 0.5 * size.height / std::tan(0.5 * camera.fov_y_rad) / d.dot(ahead);
  return {0.5 * size.width + px * d.dot(right), 0.5 * size.height - px * d.dot(up)};
}

/// How much of a pixel on white is coloured, 0…1.
double coverage(const std::uint8_t* p) {
  return std::clamp((255.0 - std::min({p[0], p[1], p[2]})) / 150.0, 0.0, 1.0);
}

/// Tip of a cone that points along `direction`, found to a part of a pixel: its width falls linearly to zero
/// there. Looks at the last 4 to 24 px before the coloured pixel that lies furthest.
Eigen::Vector2d find_tip(const Image& image, const Eigen::Vector2d& direction) {
  constexpr int kFirst = 4, kLast = 24;
  const Eigen::Vector2d across(-direction.y(), direction.x());
  double furthest = -1e9;
  const auto each_pixel = [&](auto visit) {
    for (int y = 0; y < image.size.height; ++y)
      for (int x = 0; x < image.size.width; ++x)
        if (const double c = coverage(image.pixel(x, y)); c > 0.05)
          visit(Eigen::Vector2d(x + 0.5, y + 0.5), c);
  };
  each_pixel([&](const Eigen::Vector2d& p, double) { furthest = std::max(furthest, p.dot(direction)); });

  std::array<double, kLast> width{}, middle{};
  each_pixel([&](const Eigen::Vector2d& p, double c) {
    const int slice = static_cast<int>(furthest - p.dot(direction));
    if (slice < kFirst || slice >= kLast) return;
    width[static_cast<std::size_t>(slice)] += c;
    middle[static_cast<std::size_t>(slice)] += c * p.dot(across);
  });
  // Least squares of width = a (slice + ½) + b, whose zero is the tip.
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, lateral = 0, weight = 0;
  for (int i = kFirst; i < kLast; ++i) {
    const double x = i + 0.5, y = width[static_cast<std::size_t>(i)];
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    lateral += middle[static_cast<std::size_t>(i)], weight += y;
  }
  const double a = (n * sxy - sx * sy) / (n * sxx - sx * sx), b = (sy - a * sx) / n;
  return (furthest + b / a) * direction + lateral / weight * across;
}

void expect_tip(const Scene& scene, const Vec3& tip_S) {
  constexpr Size kSize{1920, 1080};
  const Image image = Drawn().draw(scene, kSize, "white");
  const Camera camera = make_figure(make_model(scene), scene.at_s, 16.0 / 9.0).panes[0].camera;
  const Eigen::Vector2d tip = project_by_hand(camera, tip_S, kSize);
  const Eigen::Vector2d root = project_by_hand(camera, Vec3::Zero(), kSize);
  const Eigen::Vector2d found = find_tip(image, (tip - root).normalized());
  EXPECT_LT((found - tip).norm(), 1.0) << "found " << found.transpose() << ", expected " << tip.transpose();
}

TEST(Renderer, OmegasTipIsWithinAPixelOfWherePhysicsPutsIt) {
  for (double t_s : {0.2, 1.37, 4.9}) {
    Scene scene = top_scene({O::omega});
    scene.at_s = t_s;
    const double scale = 1.0 / std::sqrt(1.0 * 0.8 * 0.8 + 2.0 * 1.5 * 1.5);  // 1 / √(2T/I1)
    expect_tip(scene, scale * omega_S_by_hand(t_s));
  }
}

TEST(Renderer, LsTipIsWithinAPixelOfWherePhysicsPutsIt) {
  expect_tip(top_scene({O::L}), Vec3(0.0, 0.0, 1.3));
}

const OverlaySet kMuch{O::energy_ellipsoid, O::omega, O::L, O::polhode, O::axes_body, O::labels, O::values};

TEST(Renderer, OsmesaAndEglDrawTheSameBytes) {
  const Scene scene = top_scene(kMuch);
  const Image osmesa = Drawn(ContextKind::osmesa).draw(scene, {480, 270});
  EXPECT_EQ(osmesa.rgba, Drawn(ContextKind::egl).draw(scene, {480, 270}).rgba);
}

TEST(Renderer, APictureDependsOnNothingDrawnBefore) {
  Drawn drawn;
  const Image first = drawn.draw(top_scene(kMuch), {480, 270});
  drawn.draw(top_scene({O::shape, O::omega}), {200, 300}, "transparent");
  EXPECT_EQ(first.rgba, drawn.draw(top_scene(kMuch), {480, 270}).rgba);
}

/// The most by which a transparent picture, laid over this colour, differs from an opaque one, in levels.
int worst_over(const std::array<int, 3>& ground, const Image& transparent, const Image& opaque) {
  int worst = 0;
  for (std::size_t i = 0; i < transparent.rgba.size(); i += 4) {
    const int a = transparent.rgba[i + 3];
    for (std::size_t k = 0; k < 3; ++k) {
      const int laid_over = (transparent.rgba[i + k] * a + ground[k] * (255 - a) + 127) / 255;
      worst = std::max(worst, std::abs(laid_over - opaque.rgba[i + k]));
    }
  }
  return worst;
}

TEST(Renderer, TransparentMeansTrueAlpha) {
  Drawn drawn;
  const Image image = drawn.draw(top_scene({O::energy_ellipsoid}), {320, 180}, "transparent");
  EXPECT_EQ(image.pixel(0, 0)[3], 0);
  EXPECT_EQ(image.pixel(319, 179)[3], 0);
  const int glass = image.pixel(150, 100)[3];
  EXPECT_GT(glass, 20);
  EXPECT_LT(glass, 200);

  // Laid over white it is the picture on white, but for two roundings of eight bits, each on either side.
  const Image on_white = drawn.draw(top_scene({O::energy_ellipsoid}), {320, 180}, "white");
  EXPECT_LE(worst_over({255, 255, 255}, image, on_white), 3);
}

// Names have halos of their own there, a little more transparent.
TEST(Renderer, TransparentForADarkSlideIsThePictureOnOne) {
  Drawn drawn;
  const Scene scene = top_scene({O::energy_ellipsoid, O::omega, O::L, O::polhode, O::axes_body});
  const Image image = drawn.draw(scene, {320, 180}, "transparent-dark");
  EXPECT_EQ(image.pixel(0, 0)[3], 0);
  std::array<int, 3> ground{};
  const std::array<float, 3> dark{kDarkGround.r, kDarkGround.g, kDarkGround.b};
  std::string hex = "#";
  for (std::size_t k = 0; k < 3; ++k) {
    ground[k] = static_cast<int>(std::lround(255 * dark[k]));
    for (const int digit : {ground[k] / 16, ground[k] % 16}) hex += "0123456789abcdef"[digit];
  }
  const Image on_dark = drawn.draw(scene, {320, 180}, hex.c_str());
  EXPECT_LE(worst_over(ground, image, on_dark), 3);
  // What is for a light slide is another picture: its lines are dark.
  EXPECT_GT(worst_over(ground, drawn.draw(scene, {320, 180}, "transparent"), on_dark), 50);
}

TEST(Renderer, EveryOtherBackgroundIsOpaque) {
  Drawn drawn;
  for (const char* background : {"studio", "paper", "white", "#204060"}) {
    const Image image = drawn.draw(top_scene(kMuch), {160, 90}, background);
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255) << background;
  }
  EXPECT_EQ(drawn.draw(top_scene({O::omega}), {160, 90}, "#204060").pixel(1, 1)[2], 0x60);
}

TEST(Renderer, OddSizesAreDrawn) {
  Drawn drawn;
  for (Size size : {Size{1, 1}, Size{3, 777}, Size{501, 2}}) {
    Scene scene = top_scene(kMuch);
    scene.views = {View::space, View::body};
    EXPECT_EQ(drawn.draw(scene, size).size, size);
  }
}

TEST(Renderer, ASizeTheDriverRefusesIsAnErrorAndTheNextPictureIsDrawn) {
  Drawn drawn;
  const Figure figure = make_figure(make_model(top_scene(kMuch)), 0.5, 1.0);
  const auto refused = drawn.renderer->draw(figure, {16385, 16385}, {});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().find("16385"), std::string::npos) << refused.error();
  EXPECT_TRUE(drawn.renderer->draw(figure, {64, 64}, {}).ok());
}

Image draw_at(Drawn& drawn, const Scene& scene, const Quality& quality, const char* background = "studio") {
  auto image = drawn.renderer->draw(make_figure(make_model(scene), scene.at_s, 16.0 / 9.0), {320, 180},
                                    background_from(background).value(), quality);
  if (!image) throw std::runtime_error(image.error());
  return std::move(image).value();
}

double mean_square(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::pow(a.rgba[i] - b.rgba[i], 2);
  return sum / static_cast<double>(a.rgba.size());
}

TEST(Quality, FinerPicturesComeNearerToOneScene) {
  Drawn drawn;
  Scene scene = top_scene(kMuch);
  scene.attitude = LPoints::down;
  scene.show.insert(O::plane);
  const Image reference = draw_at(drawn, scene, {4, 5, false});  // 100 samples a pixel, no soft edges
  const auto error = [&](const Quality& quality) {
    return mean_square(draw_at(drawn, scene, quality), reference);
  };
  const double rough = error({0, 1, false}), by_samples = error({4, 1, false}), soft = error({}),
               fine = error({.supersampling = 2});
  EXPECT_LT(by_samples, 0.5 * rough);
  EXPECT_LT(soft, by_samples) << "edges are smoother than by 4 samples";
  EXPECT_LT(fine, 0.5 * soft);
  EXPECT_LT(fine, 2.0 * 2.0) << "the same look: lines as wide, colours as light";
}

TEST(Quality, WithoutAFloorLinesAreAsStrongByEitherWay) {
  Drawn drawn;
  const Scene scene = top_scene({O::energy_ellipsoid, O::omega, O::L});
  // Edges alone give 0.6; lines as faint as below a floor 22.
  EXPECT_LT(mean_square(draw_at(drawn, scene, {}), draw_at(drawn, scene, {4, 1, false})), 3.0);
}

TEST(Quality, TextIsTheSameInAll) {
  Drawn drawn;
  Scene scene = top_scene({});
  scene.show = {O::values};
  const Image usual = draw_at(drawn, scene, {});
  EXPECT_EQ(draw_at(drawn, scene, {0, 1}).rgba, usual.rgba);
  EXPECT_EQ(draw_at(drawn, scene, {4, 3}).rgba, usual.rgba);
}

TEST(Quality, LastsForOnePicture) {
  Drawn drawn;
  const Image first = draw_at(drawn, top_scene(kMuch), {});
  draw_at(drawn, top_scene(kMuch), {0, 2});
  EXPECT_EQ(draw_at(drawn, top_scene(kMuch), {}).rgba, first.rgba);
}

TEST(Quality, SupersamplingKeepsAlpha) {
  Drawn drawn;
  const Image usual = draw_at(drawn, top_scene({O::energy_ellipsoid}), {}, "transparent");
  const Image fine = draw_at(drawn, top_scene({O::energy_ellipsoid}), {4, 3}, "transparent");
  EXPECT_EQ(fine.pixel(0, 0)[3], 0);
  EXPECT_NEAR(fine.pixel(160, 120)[3], usual.pixel(160, 120)[3], 3);  // glass alone
}

TEST(Quality, WhatTheDriverHasNotIsRefused) {
  Drawn drawn;
  const Figure figure = make_figure(make_model(top_scene(kMuch)), 0.5, 1.0);
  for (const Quality& quality :
       {Quality{drawn.renderer->most_samples() + 1, 1}, Quality{0, 1000}, Quality{0, 0}}) {
    EXPECT_FALSE(drawn.renderer->draw(figure, {64, 64}, {}, quality).ok());
    EXPECT_TRUE(drawn.renderer->draw(figure, {64, 64}, {}).ok());
  }
}

/// Where two pictures differ by a lot.
std::vector<bool> differences(const Image& a, const Image& b, int levels) {
  std::vector<bool> differ;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int most = 0;
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(a.rgba[i + k] - b.rgba[i + k]));
    differ.push_back(most > levels);
  }
  return differ;
}

TEST(Labels, LeaveArrowsFree) {
  Drawn drawn;
  Scene scene;
  scene.body = find_body("sphere").value();
  scene.w0_B = Vec3(0.4, 0.2, 1.0);
  scene.show = {O::shape, O::omega, O::L, O::axes_body, O::labels};
  const auto draw = [&](const Figure& figure) {
    return drawn.renderer->draw(figure, {480, 270}, {}).value();
  };
  for (int k = 0; k < 12; ++k) {  // names come close to arrows at some of the times
    Figure figure = make_figure(make_model(scene), 1.5 + 0.37 * k, 16.0 / 9.0);
    const Image named = draw(figure);
    figure.panes[0].list.labels.clear();
    const Image bare = draw(figure);
    figure.panes[0].list.arrows.clear();
    const std::vector<bool> arrows = differences(bare, draw(figure), 40), names = differences(named, bare, 4);
    EXPECT_GT(std::count(arrows.begin(), arrows.end(), true), 200);
    EXPECT_GT(std::count(names.begin(), names.end(), true), 100);
    for (std::size_t i = 0; i < arrows.size(); ++i) EXPECT_FALSE(arrows[i] && names[i]) << k;
  }
}

TEST(Labels, NamesOfViewsStandOutOnAnyBackdrop) {
  Drawn drawn;
  Scene scene = top_scene({});
  scene.views = {View::space, View::body};
  for (const char* background : {"#1F2328", "#FBFAF6", "studio", "white"}) {
    const Image image = drawn.draw(scene, {640, 360}, background);
    int least = 255, most = 0;
    for (int y = 0; y < 40; ++y)
      for (int x = 80; x < 240; ++x) {
        least = std::min<int>(least, image.pixel(x, y)[1]);
        most = std::max<int>(most, image.pixel(x, y)[1]);
      }
    // 4.5:1 (WCAG 2.1 §1.4.3) against paper, with luminance 0.95, is (0.95 + 0.05) / 4.5 − 0.05: sRGB level
    // 115. And against #1F2328, with luminance 0.017: level 137.
    EXPECT_LT(least, 115) << background;
    EXPECT_GT(most, 137) << background;
  }
}

TEST(Background, IsReadFromItsName) {
  EXPECT_EQ(background_from("#ff8000")->color, (Color{1.0F, 128.0F / 255.0F, 0.0F, 1.0F}));
  for (const char* text : {"", "black", "#12345", "#1234567", "#12345g", "#-12345", "studio "})
    EXPECT_FALSE(background_from(text)) << text;
}

}  // namespace
}  // namespace polhode
