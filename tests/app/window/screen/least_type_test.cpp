// SPDX-License-Identifier: MIT
// The smallest type of all pages of all lessons in the smallest window that is meant to be read.
#include "app/page/text/text_column.h"
#include "tests/app/window/screen_harness.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace polhode {
namespace {

/// Of the text of the sheet, without what is raised or lowered in it, px, and what it says.
struct LeastType {
  double px = std::numeric_limits<double>::infinity();
  std::string text{};
};

LeastType least_type(const Page& page) {
  LeastType least;
  for (const PlacedType& text : page.sheet.texts) {
    double size = 0;
    for (const Glyph& glyph : text.list.glyphs) size = std::max(size, glyph.size);
    if (size > 0 && size < least.px) least = {size, text.text};
  }
  for (const Inset& inset : page.insets)
    if (inset.figure.caption_px < least.px) least = {inset.figure.caption_px, "of a figure"};
  return least;
}

class LeastTypeTest : public ScreenTest {
 protected:
  void draw_small() {
    const Status drawn = screen->draw(session, {.size = {800, 560}, .scale = 1, .seconds = 0.02});
    ASSERT_TRUE(drawn) << drawn.error();
  }
};

// What is too small beside the text is read in the figure as large as the page, to which a button leads that
// stands there.
TEST_F(LeastTypeTest, EveryWordCanBeReadInASmallWindow) {
  constexpr double kRounding = 0.01;  // px
  for (const char* id : test::kLessons) {
    LessonSession walked(test::loaded_lesson(id));
    std::string before;
    for (bool more = true; more; more = walked.next_step()) {
      walked.preferences.reduced_motion = true;
      const Status drawn = screen->draw(walked, {.size = {800, 560}, .scale = 1, .seconds = 0.02});
      ASSERT_TRUE(drawn) << drawn.error();
      const std::string where = fmt::format("{} {}.{}", id, walked.stage().id, walked.place().step + 1);
      const LeastType beside = least_type(screen->page().page());
      const bool is_small = beside.px < kLeastSmall - kRounding;
      EXPECT_EQ(screen->page().has_small_type(), is_small) << where;
      if (!is_small) continue;
      ASSERT_TRUE(screen->press(walked, "D")) << where;
      ASSERT_TRUE(screen->draw(walked, {.size = {800, 560}, .scale = 1, .seconds = 0.02}));
      const LeastType alone = least_type(screen->page().page());
      EXPECT_GE(alone.px, kLeastSmall - kRounding)
          << where << ": \"" << alone.text << "\", beside the text " << beside.px;
      ASSERT_TRUE(screen->press(walked, "Escape"));
      EXPECT_FALSE(walked.is_enlarged()) << where;
    }
  }
}

TEST_F(LeastTypeTest, ALargeFigureKeepsClearOfAPanelAndEndsWithTheStep) {
  session.go_to({16, 0});
  draw_small();
  const auto text = screen->page().page().column.width();
  EXPECT_GT(text, 0);
  ASSERT_TRUE(screen->press(session, "D"));
  draw_small();
  EXPECT_EQ(screen->page().page().figure.x1, 800);
  EXPECT_TRUE(session.is_enlarged());
  session.panel = Panel::show;
  draw_small();
  EXPECT_LT(screen->page().page().figure.x1, 600);
  session.panel = Panel::none;
  ASSERT_TRUE(screen->press(session, "Right"));
  draw_small();
  EXPECT_FALSE(session.is_enlarged());
  EXPECT_EQ(screen->page().page().column.width(), text);
}

// What can be read of a curve is as high as some lines of its names.
TEST_F(LeastTypeTest, PlotsAreHighEnoughToBeRead) {
  constexpr double kLines = 4;
  for (const Size size : {Size{1280, 720}, Size{800, 560}})
    for (const char* id : test::kLessons) {
      LessonSession walked(test::loaded_lesson(id));
      walked.preferences.reduced_motion = true;
      for (bool more = true; more; more = walked.next_step()) {
        ASSERT_TRUE(screen->draw(walked, {.size = size, .scale = 1, .seconds = 0.02}));
        for (const PlotReading& plot : screen->page().page().plots)
          EXPECT_GE(plot.frame.y1 - plot.frame.y0, kLines * kLeastSmall)
              << fmt::format("{} {}.{}, {} wide, of {} plots", id, walked.stage().id, walked.place().step + 1,
                             size.width, screen->page().page().plots.size());
      }
    }
}

/// Of the text column.
double least_of_text(const Page& page) {
  Page text;
  const auto first = page.sheet.texts.begin();
  text.sheet.texts.assign(first, first + static_cast<std::ptrdiff_t>(page.column_texts));
  return least_type(text).px;
}

// 2026-11-28: at twice the dots per inch 12 px of the display were 6 of those that a reader knows.
TEST_F(LeastTypeTest, TypeGrowsWithTheScaleOfTheDisplay) {
  constexpr double kRounding = 1;  // px, of either end of the column
  const auto draw = [&](Size size, double scale) {
    for (int i = 0; i < 3; ++i) {
      const Status drawn = screen->draw(session, {.size = size, .scale = scale, .seconds = 0.02});
      ASSERT_TRUE(drawn) << drawn.error();
    }
  };
  for (const Size& size : {Size{640, 480}, Size{800, 560}, Size{360, 640}, Size{1280, 800}}) {
    session.go_to({1, 2});
    draw(size, 1);
    const double once = least_of_text(screen->page().page()), width = screen->page().page().column.width();
    EXPECT_GE(once, kLeastSmall - 0.01) << size.width;
    EXPECT_LE(screen->page().page().column.x1, size.width) << size.width;
    EXPECT_GE(screen->page().page().column.x0, 0) << size.width;
    draw({2 * size.width, 2 * size.height}, 2);
    const Page& page = screen->page().page();
    EXPECT_GE(least_of_text(page), 2 * kLeastSmall - 0.01) << size.width;
    EXPECT_NEAR(page.column.width(), 2 * width, 2 * kRounding) << size.width;
    EXPECT_EQ(screen->page().has_small_type(), least_type(page).px < 2 * kLeastSmall - 0.01) << size.width;
  }
}

}  // namespace
}  // namespace polhode
