// SPDX-License-Identifier: MIT
// Pages whose reader has chosen larger or smaller type.
#include "app/cli/lesson_lookup.h"
#include "app/cli/or_fail.h"
#include "app/page/page.h"
#include "app/page/text/page_text.h"
#include "lessons/reader/checks/lesson_check.h"
#include "tests/app/page/sheet_checks.h"
#include "tests/support/paths.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

constexpr Size kSizes[] = {{640, 480}, {1280, 800}, {1080, 1920}, {3840, 2160}};

const Lesson& lecture() {
  static const Lesson kLesson =
      or_fail(load_lesson((test::source_dir() / "lessons/euler-equations.md").string())).lesson;
  return kLesson;
}

PageRequest request_for(const Stage& stage, const SceneModel* model, Size size, double text_scale) {
  return {.lesson = lecture(),
          .stage = stage,
          .number = 29,
          .step = static_cast<int>(stage.steps.size()),
          .model = model,
          .t_s = 0.25,
          .size = size,
          .theme = Theme::paper,
          .text_scale = text_scale};
}

bool stands_in(const PixelBox& part, const PlacedType& text) {
  return part.overlap({text.at.x(), text.at.y(), text.at.x() + 1, text.at.y() + 1}) > 0.0;
}

/// `em` of prose as it is set.
void expect_valid(const Page& page, const Size& size, double em) {
  const PixelBox paper{0, 0, static_cast<double>(size.width), static_cast<double>(size.height)};
  const PixelBox column = page.column.grown(0.2 * em + 0.5);  // an italic f begins a line outside it
  const bool has_figure = page.figure.width() > 0.0;
  std::vector<PixelBox> boxes;
  for (const PlacedType& text : page.sheet.texts) {
    const PixelBox box = box_of(text);
    EXPECT_TRUE(is_within(box, paper));
    if (has_figure && (stands_in(page.figure, text) || stands_in(page.meters, text))) {
      EXPECT_TRUE(is_within(box, page.figure) || is_within(box, page.meters)) << text.text;
      continue;
    }
    EXPECT_TRUE(is_within(box, column)) << box.x0 << ' ' << box.y0 << ' ' << box.x1 << ' ' << box.y1;
    boxes.push_back(box);
  }
  for (const FlatShape& shape : page.sheet.shapes) EXPECT_TRUE(is_within(box_of(shape), paper));
  for (const Inset& inset : page.insets) EXPECT_TRUE(inset.place.width > 0 && inset.place.height > 0);
  if (has_figure) {
    EXPECT_EQ(page.figure.overlap(page.column.grown(0.7 * em)), 0.0) << "bars and panels stand out";
    EXPECT_EQ(page.meters.overlap(page.column), 0.0);
  }
}

class TextSize : public testing::TestWithParam<std::size_t> {};

TEST_P(TextSize, KeepsPagesValid) {
  const Stage& stage = lecture().stages[GetParam()];
  const Step& step = stage.steps.back();
  const SceneModel model = step.scene ? make_model(*step.scene, ModelFor::page) : SceneModel();
  for (const Size& size : kSizes)
    for (const double text_scale : {kLeastTextScale, 1.4, kMostTextScale}) {
      SCOPED_TRACE(fmt::format("{}x{} at {}", size.width, size.height, text_scale));
      const PageRequest request = request_for(stage, step.scene ? &model : nullptr, size, text_scale);
      const Page page = compose_page(request, test_fonts()).value();
      const PageRequest normal = request_for(stage, request.model, size, 1.0);
      const double em =
          compose_page(normal, test_fonts()).value().column.width() / 28.0;  // kMeasure of app/page/page.cpp
      expect_valid(page, size, text_scale * em * page.scale);
      if (request.model && size.width > size.height) {
        EXPECT_LE(page.column.x1, 0.62 * size.width);
      }
      EXPECT_GE(page.column.width(), std::min(text_scale, 1.0) * 28.0 * em - 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(OfTheLecture, TextSize, testing::Range(std::size_t{0}, std::size_t{29}));

/// Size of the title's type, which every page has.
double title_px(const Page& page) { return page.sheet.texts.at(1).list.glyphs.at(0).size; }

TEST(TextSize, IsThatOfTheTypeWhereThereIsRoom) {
  LessonReading reading = check_lesson(
      "+++\nformat = 1\nid = \"page\"\ntitle = \"Pages\"\n[scene]\nbody = \"textbook\"\n"
      "omega = [0.9, 0.4, 1.0]\nviews = [\"space\"]\n+++\n# A stage {one}\nA word.\n\n```scene\nshow = "
      "[\"shape\"]\n```\n",
      "page.md");
  ASSERT_TRUE(reading.lesson);
  const SceneModel model = make_model(*reading.lesson->stages[0].steps[0].scene, ModelFor::page);
  const auto page_at = [&](double text_scale, const SceneModel* shown, Size size) {
    return compose_page({.lesson = *reading.lesson,
                         .stage = reading.lesson->stages[0],
                         .model = shown,
                         .size = size,
                         .text_scale = text_scale},
                        test_fonts())
        .value();
  };
  for (const Size& size : {Size{1280, 800}, Size{1080, 1920}})
    for (const SceneModel* shown : {&model, static_cast<const SceneModel*>(nullptr)}) {
      const Page normal = page_at(1, shown, size);
      for (const double text_scale : {kLeastTextScale, 1.0, 1.25, kMostTextScale}) {
        const Page page = page_at(text_scale, shown, size);
        EXPECT_NEAR(title_px(page), text_scale * title_px(normal), 1e-9 * title_px(normal));
        if (shown && text_scale > 1) {
          EXPECT_LT(page.figure.width() * page.figure.height(),
                    normal.figure.width() * normal.figure.height());
        }
      }
    }
  EXPECT_NEAR(page_at(1.25, &model, {1280, 800}).column.width(),
              1.25 * page_at(1, &model, {1280, 800}).column.width(), 1e-9 * 1280)
      << "as many letters to a line, while there is room";
}

TEST(TextSize, OfAPageThatNoneFitsIsThatOfTheNormalPage) {
  // Type that had to be set much smaller is set as small as it has to be, whatever the reader would like.
  std::string text = "+++\nformat = 1\nid = \"page\"\ntitle = \"Pages\"\n+++\n# A stage {one}\n";
  for (int i = 0; i < 30; ++i)
    text += "Some words that fill a line of the column and then half of the next one below.\n\n";
  LessonReading reading = check_lesson(text, "page.md");
  ASSERT_TRUE(reading.lesson);
  const auto size_at = [&](double text_scale) {
    return text_scale * compose_page({.lesson = *reading.lesson,
                                      .stage = reading.lesson->stages[0],
                                      .size = {1024, 768},
                                      .text_scale = text_scale},
                                     test_fonts())
                            .value()
                            .scale;
  };
  const double normal = size_at(1);
  ASSERT_LT(normal, 0.5);
  EXPECT_NEAR(size_at(kMostTextScale), normal, 0.15 * normal) << "sizes are tried in steps of 6 %";
}

}  // namespace
}  // namespace polhode
