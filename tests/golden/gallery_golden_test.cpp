// SPDX-License-Identifier: MIT
// The pictures of docs/overlays: one of every overlay, as the program draws it today.
#include "app/page/figure_place.h"
#include "lessons/reader/checks/lesson_check.h"
#include "render/image/compare.h"
#include "tests/golden/approval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace polhode::golden {
namespace {

constexpr Size kSize{400, 300};
const std::filesystem::path kGallery = test::source_dir() / "docs/overlays";

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// A stage for each overlay.
const Lesson& gallery() {
  static const Lesson kLesson = [] {
    LessonReading reading = check_lesson(text_of(kGallery / "overlays.md"), "overlays.md");
    for (const Diagnostic& diagnostic : reading.diagnostics) ADD_FAILURE() << to_string(diagnostic);
    if (!reading.lesson) throw std::runtime_error("no gallery");
    return std::move(*reading.lesson);
  }();
  return kLesson;
}

const Scene& scene_of(const OverlayFacts& overlay) {
  const Stage* stage = gallery().find_stage(std::string(overlay.name));
  if (stage == nullptr) throw std::runtime_error("no stage " + std::string(overlay.name));
  return *stage->steps.at(0).scene;
}

Image picture(const Scene& scene) {
  const Color paper = colors_of(Theme::paper).paper;
  const Background background{Background::Kind::color, paper};
  const FigurePlace place{.rect = {0, 0, kSize.width, kSize.height},
                          .caption_px = caption_px_of(kSize),
                          .theme = Theme::paper,
                          .background = background,
                          .ground = paper,
                          .quality = quality_of(QualityLevel::fine)};
  const PlacedFigure placed = place_figure(make_model(scene), still_time_s(scene), place, renderer().fonts());
  auto image = renderer().draw(placed.sheet, placed.insets, kSize, background);
  if (!image) throw std::runtime_error(image.error());
  return std::move(image).value();
}

class Gallery : public testing::TestWithParam<OverlayFacts> {};

TEST_P(Gallery, ShowsTheOverlayAsItIsDrawn) {
  expect_as_approved(std::string(GetParam().name), picture(scene_of(GetParam())), kGallery);
}

TEST_P(Gallery, HasItInItsPicture) {
  Scene scene = scene_of(GetParam());
  const Image with = picture(scene);
  ASSERT_TRUE(scene.show.contains(GetParam().overlay));
  scene.show.erase(GetParam().overlay);
  EXPECT_FALSE(compare_images(with, picture(scene)).equal());
}

TEST_P(Gallery, HasItOnItsSheet) {
  const std::string name(GetParam().name);
  EXPECT_NE(text_of(kGallery / "README.md").find("![" + name + "](" + name + ".png)"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, Gallery, testing::ValuesIn(kOverlays), [](const auto& test) {
  std::string name(test.param.name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace polhode::golden
