// SPDX-License-Identifier: MIT
#include "app/page/figure_place.h"

#include "tests/render/drawing/sheet_texts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace polhode {
namespace {

Scene scene_of(const OverlaySet& show) {
  Scene scene;
  scene.show = show;
  scene.caption = "A caption";
  return scene;
}

FigurePlace place_of(Size size) {
  return {.rect = {7, 3, size.width, size.height}, .caption_px = caption_px_of(size)};
}

PlacedFigure placed(const Scene& scene, Size size) {
  return place_figure(make_model(scene), 0.4, place_of(size), fonts());
}

PixelBox box_of(const PixelRect& rect) {
  return {double(rect.x), double(rect.y), double(rect.x + rect.width), double(rect.y + rect.height)};
}

constexpr Size kSizes[] = {{480, 270}, {657, 504}, {500, 900}, {3840, 2160}};

TEST(FigurePlace, WithoutDiagramsIsTheFigureInSpaceAboveItsCaption) {
  for (const Size& size : kSizes) {
    const PlacedFigure figure = placed(scene_of({Overlay::omega}), size);
    ASSERT_EQ(figure.insets.size(), 1u);
    const PixelRect& space = figure.insets[0].place;
    EXPECT_EQ(space.width, size.width);
    EXPECT_EQ(space.x, 7);
    const auto captions = texts_of(figure.sheet, "A caption");
    ASSERT_EQ(captions.size(), 1u);
    const PixelBox caption = polhode::box_of(*captions[0]);
    EXPECT_GE(caption.y0, space.y + space.height);
    EXPECT_LE(caption.y1, 3 + size.height);
  }
}

TEST(FigurePlace, WithoutACaptionThePlaceIsTheFigures) {
  Scene scene = scene_of({Overlay::omega});
  scene.caption.clear();
  const PlacedFigure figure = placed(scene, {640, 480});
  EXPECT_EQ(figure.insets[0].place.height, 480);
  EXPECT_TRUE(figure.sheet.texts.empty());
}

// 2026-11-26: "halfway over" stood below all of the motion. The picture keeps its place without it.
TEST(FigurePlace, ACaptionOfTheStillIsWrittenThereAlone) {
  Scene scene = scene_of({Overlay::omega});
  scene.caption_when = CaptionWhen::still;
  scene.at_s = 0.5;
  const SceneModel model = make_model(scene);
  const auto at = [&](double t_s, bool is_frame) {
    FigurePlace place = place_of({640, 480});
    place.is_frame = is_frame;
    return place_figure(model, t_s, place, fonts());
  };
  const PlacedFigure still = at(0.5, false), later = at(0.6, false), frame = at(0.5, true);
  EXPECT_EQ(texts_of(still.sheet, "A caption").size(), 1u);
  EXPECT_TRUE(texts_of(later.sheet, "A caption").empty());
  EXPECT_TRUE(texts_of(frame.sheet, "A caption").empty()) << "it would flash";
  EXPECT_EQ(later.insets.at(0).place.height, still.insets.at(0).place.height);
  EXPECT_EQ(frame.insets.at(0).place.height, still.insets.at(0).place.height);
}

TEST(FigurePlace, ALongCaptionHasLines) {
  Scene scene = scene_of({Overlay::omega});
  scene.caption = std::string(60, 'n') + ' ' + std::string(59, 'n');
  const PlacedFigure figure = placed(scene, {480, 270});
  scene.caption = "n";
  const int lower = placed(scene, {480, 270}).insets[0].place.height - figure.insets[0].place.height;
  EXPECT_GE(lower, std::floor(caption_px_of({480, 270})));
}

TEST(FigurePlace, DiagramsAloneDrawNoSpace) {
  for (const Size& size : kSizes) {
    const PlacedFigure figure = placed(scene_of({Overlay::energy_rows, Overlay::labels}), size);
    EXPECT_TRUE(figure.insets.empty());
    EXPECT_EQ(texts_of(figure.sheet, "A caption").size(), 1u);
  }
}

TEST(FigurePlace, DiagramsSpaceAndCaptionStandClearOfEachOther) {
  for (const Size& size : kSizes)
    for (const OverlaySet& show :
         {OverlaySet{Overlay::omega, Overlay::tensor_bars}, OverlaySet{Overlay::shape, Overlay::cyclic_wheel},
          OverlaySet{Overlay::omega, Overlay::energy_rows, Overlay::momentum_rows}}) {
      const PlacedFigure figure = placed(scene_of(show), size);
      ASSERT_EQ(figure.insets.size(), 1u);
      const PixelBox space = box_of(figure.insets[0].place), whole = box_of(place_of(size).rect);
      EXPECT_GT(std::min(space.width(), space.height()), 0.3 * std::min(whole.width(), whole.height()));
      for (std::size_t i = 0; i < figure.sheet.texts.size(); ++i) {
        const PixelBox text = polhode::box_of(figure.sheet.texts[i]);
        EXPECT_EQ(text.overlap(space), 0.0) << figure.sheet.texts[i].text;
        EXPECT_NEAR(text.overlap(whole), text.width() * text.height(), 1e-6) << figure.sheet.texts[i].text;
        for (std::size_t k = 0; k < i; ++k)
          EXPECT_EQ(text.overlap(polhode::box_of(figure.sheet.texts[k])), 0.0)
              << figure.sheet.texts[i].text << " covers " << figure.sheet.texts[k].text << " at "
              << size.width;
      }
    }
}

TEST(FigurePlace, PaintsTheGroundThatItIsGiven) {
  const SceneModel model = make_model(scene_of({Overlay::cards}));
  FigurePlace place = place_of({640, 360});
  const std::size_t shapes = place_figure(model, 0.0, place, fonts()).sheet.shapes.size();
  place.ground = color_from_hex(0x22262C);
  const PlacedFigure figure = place_figure(model, 0.0, place, fonts());
  ASSERT_EQ(figure.sheet.shapes.size(), shapes + 2) << "of the caption, and of the diagram";
  EXPECT_EQ(std::get<Area>(figure.sheet.shapes[0]).color, *place.ground);
}

/// Two scenes beside the first.
Scene three_scenes(const OverlaySet& show) {
  Scene first = scene_of(show);
  first.beside = {scene_of(show), scene_of(show)};
  return first;
}

TEST(FigurePlace, ScenesSideBySideShareThePlace) {
  for (const Size& size : kSizes) {
    const PlacedFigure figure = placed(three_scenes({Overlay::omega}), size);
    ASSERT_EQ(figure.insets.size(), 3u);
    const PixelBox whole = box_of(place_of(size).rect);
    for (std::size_t i = 0; i < 3; ++i) {
      const PixelBox space = box_of(figure.insets[i].place);
      EXPECT_EQ(space.overlap(whole), space.width() * space.height());
      EXPECT_NEAR(space.width() * space.height(), whole.width() * whole.height() / 3,
                  0.1 * whole.width() * whole.height())
          << "but for the caption";
      for (std::size_t k = 0; k < i; ++k) EXPECT_EQ(space.overlap(box_of(figure.insets[k].place)), 0.0);
    }
    EXPECT_EQ(texts_of(figure.sheet, "A caption").size(), 1u);
  }
}

TEST(FigurePlace, ScenesStandBesideOrBelowEachOtherAsLetsThemBeLarger) {
  for (const bool is_upright : {true, false}) {
    Scene scene = three_scenes({Overlay::omega});
    const auto lay = [&](Scene& one) {
      one.w0_B = is_upright ? Vec3(0, 0, 2) : Vec3(2, 0, 0);
      one.views = {View::body};
      one.camera.azimuth_rad = -0.5 * std::numbers::pi;
      one.camera.elevation_rad = 0.1;
    };
    lay(scene);
    for (Scene& other : scene.beside) lay(other);
    const PlacedFigure figure = placed(scene, {600, 600});
    ASSERT_EQ(figure.insets.size(), 3u);
    EXPECT_EQ(figure.insets[0].place.y == figure.insets[2].place.y, is_upright);
    EXPECT_EQ(figure.insets[0].place.x == figure.insets[2].place.x, !is_upright);
  }
}

TEST(FigurePlace, CaptionsSideBySideStandOnOneLine) {
  Scene first = three_scenes({Overlay::omega});
  first.caption = "A tall $\\vec A$";
  first.beside[0].caption = "A caption of more words than the width of its picture has room for in a line";
  const PlacedFigure figure = placed(first, {900, 500});
  ASSERT_EQ(figure.sheet.texts.size(), 3u);
  for (const PlacedType& caption : figure.sheet.texts)
    EXPECT_EQ(caption.at.y(), figure.sheet.texts[0].at.y());
}

TEST(FigurePlace, ACaptionFollowsItsBoard) {
  const Size size{640, 900};
  const PlacedFigure figure = placed(scene_of({Overlay::energy_rows}), size);
  const auto captions = texts_of(figure.sheet, "A caption");
  ASSERT_EQ(captions.size(), 1u);
  double lowest = 0.0;
  for (const PlacedType& text : figure.sheet.texts)
    if (text.text != "A caption") lowest = std::max(lowest, polhode::box_of(text).y1);
  const double gap = polhode::box_of(*captions[0]).y0 - lowest;
  EXPECT_GT(gap, 0.0);
  EXPECT_LT(gap, 3.0 * caption_px_of(size)) << "not at the foot of the place";
}

TEST(FigurePlace, PicturesSideBySideEndAtOneHeightWhateverTheirCaptions) {
  Scene first = three_scenes({Overlay::omega});
  first.beside[0].caption = "A caption of more words than the width of its picture has room for in a line";
  const PlacedFigure figure = placed(first, {900, 500});
  ASSERT_EQ(figure.insets.size(), 3u);
  for (const Inset& inset : figure.insets) EXPECT_EQ(inset.place.height, figure.insets.front().place.height);
  EXPECT_EQ(texts_of(figure.sheet, "A caption").size(), 2u);
}

TEST(FigurePlace, EachSceneHasItsOwnCaptionViewsAndBoards) {
  Scene first = three_scenes({Overlay::omega});
  first.beside[0].caption = "Another";
  first.beside[0].views = {View::space, View::body};
  first.beside[1].show = {Overlay::energy_rows};
  const PlacedFigure figure = placed(first, {900, 500});
  ASSERT_EQ(figure.insets.size(), 2u);
  EXPECT_EQ(texts_of(figure.sheet, "Another").size(), 1u);
  EXPECT_EQ(figure.insets[0].figure.panes.size(), 1u);
  EXPECT_EQ(figure.insets[1].figure.panes.size(), 2u);
  EXPECT_EQ(texts_of(figure.sheet, "A caption").size(), 2u);
}

TEST(FigurePlace, TheFirstInsetIsTheModelsOwnWhereverItStands) {
  Scene first = three_scenes({Overlay::omega});
  first.before = 1;
  const std::array labels = {"a", "b", "c"};
  first.label = labels[1];
  first.beside[0].label = labels[0];
  first.beside[1].label = labels[2];
  const PlacedFigure figure = placed(first, {900, 300});
  ASSERT_EQ(figure.insets.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(polhode::box_of(*texts_of(figure.sheet, labels[i]).at(0)).x0,
                7 + 300.0 * static_cast<double>(i), 40);
  EXPECT_LT(figure.insets[1].place.x, figure.insets[0].place.x);
  EXPECT_GT(figure.insets[2].place.x, figure.insets[0].place.x);
}

/// Height in px of a scene unit at the middle of each picture.
std::vector<double> scales_of(const PlacedFigure& figure) {
  std::vector<double> scales;
  for (const Inset& inset : figure.insets) {
    const Camera& camera = inset.figure.panes.front().camera;
    const double half = (camera.eye - camera.target).norm() * std::tan(0.5 * camera.fov_y_rad);
    scales.push_back(0.5 * inset.place.height / half);
  }
  return scales;
}

TEST(FigurePlace, PicturesOfOneBodyHaveOneScale) {
  Scene scene = scene_of({Overlay::shape, Overlay::L});
  scene.beside.push_back(scene);
  scene.beside[0].show = {Overlay::L};
  scene.beside[0].w0_B = {2, 1, 0.5};
  const std::vector<double> alike = scales_of(placed(scene, {900, 300}));
  ASSERT_EQ(alike.size(), 2u);
  EXPECT_NEAR(alike[0], alike[1], 1e-9 * alike[0]);
  scene.beside[0].camera.zoom = 2;
  const std::vector<double> zoomed = scales_of(placed(scene, {900, 300}));
  EXPECT_GT(zoomed[1], 1.5 * zoomed[0]) << "as its camera says";
}

}  // namespace
}  // namespace polhode
