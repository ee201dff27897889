// SPDX-License-Identifier: MIT
// What a reader reads stands still: whatever panel opens, from step to step, in windows of all sizes.
#include "tests/app/window/screen_harness.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace polhode {
namespace {

class StillPageTest : public ScreenTest {
 protected:
  /// Pixels of the text column, of the page as it is shown.
  std::vector<std::uint8_t> text() {
    const Image shown = screen->page().picture().read();
    const PixelBox& column = screen->page().page().column;
    std::vector<std::uint8_t> pixels;
    for (int row = 0; row < shown.size.height; ++row)
      for (int at = static_cast<int>(column.x0); at < static_cast<int>(column.x1); ++at)
        pixels.insert(pixels.end(), shown.pixel(at, row), shown.pixel(at, row) + 4);
    return pixels;
  }
  void draw_at(Size size, int count = 3) {
    for (int i = 0; i < count; ++i)
      ASSERT_TRUE(screen->draw(session, {.size = size, .scale = 1, .seconds = 0.02}));
  }
};

TEST_F(StillPageTest, APanelLiesBesideTheTextWithoutTouchingIt) {
  frame(3);
  const auto before = text();
  const double figure_right = screen->page().page().figure.x1;
  for (const Panel panel : {Panel::outline, Panel::body, Panel::method, Panel::show, Panel::question,
                            Panel::save, Panel::settings, Panel::help}) {
    session.panel = panel;
    frame(3);
    EXPECT_EQ(text(), before);
    const PixelBox& figure = screen->page().page().figure;
    EXPECT_LT(figure.x1, figure_right - 200) << "it keeps clear of the panel";
    EXPECT_GT(figure.width(), 200);
  }
  session.panel = Panel::none;
  frame(3);
  EXPECT_EQ(screen->page().page().figure.x1, figure_right);
}

// Where the figure is above the text, the panel is beside the figure.
TEST_F(StillPageTest, InAHighWindowAPanelLiesOverTheFigureAlone) {
  const Size high{800, 1200};
  const auto below_figure = [&] {
    const Image shown = screen->read();
    const auto ceiling = static_cast<std::ptrdiff_t>(screen->page().page().ceiling) + 1;
    constexpr int kBar = 100;  // where the panel's button is pressed
    return std::vector<std::uint8_t>(shown.rgba.begin() + 4 * ceiling * high.width,
                                     shown.rgba.end() - std::ptrdiff_t{4} * kBar * high.width);
  };
  for (const StepPlace place : {StepPlace{0, 1}, StepPlace{26, 2}}) {
    session.panel = Panel::none;
    session.go_to(place);
    draw_at(high, 4);
    const auto before = below_figure();
    const PixelBox figure = screen->page().page().figure;
    ASSERT_GT(figure.width(), 700);
    for (const Panel panel : {Panel::outline, Panel::body, Panel::method, Panel::show, Panel::question,
                              Panel::save, Panel::settings, Panel::help}) {
      session.panel = panel;
      draw_at(high);
      EXPECT_TRUE(below_figure() == before) << static_cast<int>(panel);
      EXPECT_LT(screen->page().page().figure.x1, figure.x1 - 200) << "it keeps clear of the panel";
    }
  }
}

// That a scene was changed is told beside a panel, not over it: neither hides the other. Nor does it lie over
// the text where the panel leaves too little of the figure.
TEST_F(StillPageTest, WhatLiesOnTheFigureKeepsClearOfAPanelAndOfTheText) {
  for (const auto& [size, has_room] : {std::pair(Size{1280, 800}, true), {Size{900, 600}, false}}) {
    session.reset_edits();
    session.panel = Panel::body;
    draw_at(size, 4);
    const Image before = screen->read();
    const PixelBox figure = screen->page().page().figure;
    const float panel = ImGui::FindWindowByName("panel")->Pos.x;
    SceneEdits edits = session.edits();
    edits.on.insert(Overlay::labels);
    ASSERT_TRUE(session.set_edits(edits));
    draw_at(size, 4);
    const Image after = screen->read();
    int on_text = 0, told = 0, hidden = 0;
    for (int row = 0; row < 60; ++row)
      for (int at = 0; at < size.width; ++at) {
        if (std::memcmp(before.pixel(at, row), after.pixel(at, row), 4) == 0) continue;
        ++(at < figure.x0 ? on_text : static_cast<float>(at) < panel ? told : hidden);
      }
    EXPECT_EQ(on_text, 0) << size.width;
    EXPECT_EQ(hidden, 0) << size.width;
    EXPECT_EQ(told > 100, has_room) << size.width;
  }
}

// One size of type for all steps of all stages; what was there is there still, above what is new.
TEST_F(StillPageTest, TypeHasOneSizeAndEarlierStepsStay) {
  session.preferences.text_scale = kMostTextScale;
  for (std::size_t stage : {std::size_t{0}, std::size_t{8}, session.lesson().stages.size() - 1})
    for (std::size_t step = 0; step < session.lesson().stages[stage].steps.size(); ++step) {
      session.go_to({stage, step});
      frame(2);
      const Page& page = screen->page().page();
      EXPECT_EQ(page.scale, 1) << stage << ' ' << step << ": 200 % is 200 %";
      EXPECT_EQ(page.whole_from, 1) << stage << ' ' << step;
      EXPECT_LE(page.hidden, page.overflow);
    }
}

TEST_F(StillPageTest, WhatDoesNotFitIsScrolledByWheelAndKeys) {
  session.go_to({0, session.lesson().stages[0].steps.size() - 1});
  frame(3);
  const Page& page = screen->page().page();
  ASSERT_GT(page.overflow, 0) << "ten steps";
  EXPECT_GT(page.hidden, 0) << "the new step is seen";
  const double begun = page.hidden;
  move(page.column.x0 + 20, page.column.y0 + 100);
  for (int i = 0; i < 100; ++i) {
    ImGui::GetIO().MouseWheel = 1;
    frame();
  }
  frame(2);
  EXPECT_EQ(page.hidden, 0) << "the head of the stage";
  const auto head = text();
  screen->press(session, "J");
  frame(2);
  EXPECT_GT(page.hidden, 0);
  EXPECT_NE(text(), head);
  screen->press(session, "K");
  frame(2);
  EXPECT_EQ(page.hidden, 0);
  session.previous_step();
  frame(2);
  session.next_step();
  frame(2);
  EXPECT_EQ(page.hidden, begun) << "a step that is come to is read from its beginning";
}

// Forward from what is seen, and then back to the beginning.
TEST_F(StillPageTest, ASymbolInFocusIsScrolledTo) {
  session.go_to({0, session.lesson().stages[0].steps.size() - 1});
  frame(3);
  ASSERT_GT(screen->page().page().hidden, 0);
  const std::size_t first = screen->page().first_seen(), count = screen->page().symbols().size();
  ASSERT_GT(first, 0U);
  const auto come_to = [&](std::size_t symbol, const char* key) {
    screen->press(session, key);
    frame(2);
    const TypeBox& box = screen->page().symbols()[symbol].box;
    EXPECT_GE(box.y0, 0) << key << ' ' << symbol;
    EXPECT_LE(box.y1, screen->page().picture().size().height) << key << ' ' << symbol;
  };
  for (std::size_t i = first; i < count; ++i) come_to(i, "Tab");
  for (std::size_t i = count - 1; i-- > 0;) come_to(i, "Shift+Tab");
}

// 2026-11-27: in a window that is higher than wide what was scrolled away was written over the figure.
TEST_F(StillPageTest, WhatIsScrolledAwayIsNotOverTheFigureAboveIt) {
  const Size high{800, 1100};
  session.go_to({0, session.lesson().stages[0].steps.size() - 1});
  draw_at(high);
  const Page& page = screen->page().page();
  ASSERT_GT(page.hidden, 0);
  ASSERT_GT(page.ceiling, 200);
  const auto figure_rows = [&] {
    const Image shown = screen->page().picture().read();
    const auto rows = static_cast<std::ptrdiff_t>(page.ceiling) * shown.size.width * 4;
    return std::vector<std::uint8_t>(shown.rgba.begin(), shown.rgba.begin() + rows);
  };
  const auto end = figure_rows();
  const std::size_t symbols = screen->page().symbols().size();
  for (int i = 0; i < 40; ++i) screen->press(session, "K");
  draw_at(high);
  ASSERT_EQ(page.hidden, 0);
  EXPECT_EQ(figure_rows(), end);
  EXPECT_EQ(screen->page().symbols().size(), symbols) << "Tab goes to what is scrolled away too";
  // The wheel over the figure is the figure's.
  ImGui::GetIO().MousePos = {300, 100};
  ImGui::GetIO().MouseWheel = -3;
  draw_at(high, 1);
  ImGui::GetIO().MouseWheel = 0;
  draw_at(high);
  EXPECT_EQ(page.hidden, 0);
}

// 2026-11-28: the upper half of a verdict stood between the caption and the line that names the step.
TEST_F(StillPageTest, VerdictsThatAreScrolledAwayAreGoneAsAWhole) {
  const Size high{720, 1280};
  const auto& stages = session.lesson().stages;
  const auto stage = std::ranges::find(stages, "poinsot", &Stage::id);
  ASSERT_NE(stage, stages.end());
  session.go_to({static_cast<std::size_t>(stage - stages.begin()), 6});
  draw_at(high);
  const auto above_text = [&] {
    const Image shown = screen->page().picture().read();
    const auto rows = static_cast<std::ptrdiff_t>(screen->page().page().ceiling) * shown.size.width * 4;
    return std::vector<std::uint8_t>(shown.rgba.begin(), shown.rgba.begin() + rows);
  };
  const auto at_end = above_text();
  double hidden = screen->page().page().hidden;
  ASSERT_GT(hidden, 0);
  while (hidden > 0) {
    screen->press(session, "K");
    draw_at(high, 2);
    EXPECT_EQ(above_text(), at_end) << hidden;
    const double before = std::exchange(hidden, screen->page().page().hidden);
    ASSERT_LT(hidden, before);
  }
}

// 2026-11-27: in a small window, where small type is held at what can be read, "Question" was broken in the
// word.
TEST_F(StillPageTest, TheNameBesideAQuestionIsOneWord) {
  for (const Size size : {Size{1280, 800}, Size{800, 560}, Size{640, 480}, Size{800, 1200}}) {
    session.go_to({0, 0});
    draw_at(size);
    const Page& page = screen->page().page();
    ASSERT_FALSE(page.choices.empty());
    int names = 0;
    for (const PlacedType& text : page.sheet.texts) {
      if (text.list.glyphs.size() != std::strlen("Question") || std::abs(text.at.x() - page.column.x0) > 1)
        continue;
      ++names;
      for (const Glyph& glyph : text.list.glyphs)
        EXPECT_EQ(glyph.y, text.list.glyphs.front().y) << size.width;
    }
    EXPECT_EQ(names, 1) << size.width;
  }
}

// Indices apart, which are set within a line of larger type.
TEST_F(StillPageTest, NoTypeIsTooSmallToBeRead) {
  for (const Size size : {Size{1280, 800}, Size{900, 600}, Size{800, 560}, Size{640, 480}})
    for (const StepPlace place : {StepPlace{0, 6}, StepPlace{9, 1}, StepPlace{20, 0}}) {
      session.go_to(place);
      draw_at(size);
      for (const PlacedType& text : screen->page().page().sheet.texts) {
        double largest = 0;
        for (const Glyph& glyph : text.list.glyphs)
          largest = std::max(largest, static_cast<double>(glyph.size));
        if (largest == 0) continue;
        EXPECT_GE(largest, 11.9) << size.width << ' ' << place.stage << ": " << text.text;
      }
    }
}

TEST_F(StillPageTest, NormalSizeIsReachedFromBothEnds) {
  for (const int there : {100, -100}) {
    session.change_text_scale(there);
    for (int i = 0; i < 12 && session.preferences.text_scale != 1; ++i)
      session.change_text_scale(there > 0 ? -1 : 1);
    EXPECT_EQ(session.preferences.text_scale, 1);
  }
  session.change_text_scale(3);
  EXPECT_TRUE(screen->press(session, "Ctrl+0"));
  EXPECT_EQ(session.preferences.text_scale, 1);
}

// What is told lies beside the text, or above it, as long as it lasts.
TEST_F(StillPageTest, WhatIsToldCoversNoText) {
  for (const Size size : {Size{1280, 800}, Size{1280, 720}, Size{900, 600}, Size{800, 1200}}) {
    session.go_to({0, session.lesson().stages[0].steps.size() - 1});
    draw_at(size, 3);
    const Image before = screen->read();
    screen->tell(
        "This is told for a while, in as many words as it takes, and nobody is to lose a line by it.");
    draw_at(size, 3);
    const Image after = screen->read();
    const Page& page = screen->page().page();
    int told = 0, hidden = 0;
    for (int row = 0; row < size.height; ++row)
      for (int at = 0; at < size.width; ++at) {
        if (std::memcmp(before.pixel(at, row), after.pixel(at, row), 4) == 0) continue;
        const bool is_text = at >= page.column.x0 && at < page.column.x1 && row >= page.ceiling;
        ++(is_text ? hidden : told);
      }
    EXPECT_GT(told, 1000) << size.width;
    EXPECT_EQ(hidden, 0) << size.width << 'x' << size.height;
    for (int i = 0; i < 400; ++i) draw_at(size, 1);
  }
}

/// A window, and the scale of its display.
struct Shown {
  Size size;
  double scale;
};
constexpr std::array kShown = {Shown{{1280, 800}, 1}, Shown{{960, 720}, 1},   Shown{{800, 560}, 1},
                               Shown{{640, 480}, 1},  Shown{{1280, 960}, 2},  Shown{{1600, 1200}, 2},
                               Shown{{720, 1280}, 1}, Shown{{1920, 1440}, 2}, Shown{{720, 1280}, 2}};

// 2026-11-28: it cut the figure and its caption in two, and at twice the dots per inch lay over the text.
TEST_F(StillPageTest, APanelIsBesideTheFigureOrOverAllOfIt) {
  for (const auto& [size, scale] : kShown)
    for (const Panel panel : {Panel::body, Panel::show}) {
      session.go_to({0, 3});
      session.panel = panel;
      for (int i = 0; i < 4; ++i)
        ASSERT_TRUE(screen->draw(session, {.size = size, .scale = scale, .seconds = 0.02}));
      const ImRect at = ImGui::FindWindowByName("panel")->Rect();
      const Page& page = screen->page().page();
      const bool is_beside = page.ceiling <= 0;
      if (is_beside) {
        EXPECT_GE(static_cast<double>(at.Min.x), page.column.x1) << size.width << ' ' << scale;
      }
      for (const Inset& inset : page.insets) {
        const auto left = static_cast<float>(inset.place.x),
                   right = static_cast<float>(inset.place.x + inset.place.width);
        EXPECT_TRUE(right <= at.Min.x || left >= at.Min.x) << size.width << ' ' << scale;
      }
    }
}

// 2026-11-28: where a panel leaves less than 10 em beside the text it lay over that.
TEST_F(StillPageTest, WhatIsToldBesideAPanelCoversNoText) {
  for (const auto& [size, scale] : kShown) {
    session.go_to({0, 3});
    session.panel = Panel::body;
    screen->tell("This is told for a while, and nobody is to lose a line by it.");
    for (int i = 0; i < 4; ++i)
      ASSERT_TRUE(screen->draw(session, {.size = size, .scale = scale, .seconds = 0.02}));
    const ImGuiWindow* strip = ImGui::FindWindowByName("strip");
    ASSERT_TRUE(strip != nullptr && strip->Active);
    const Page& page = screen->page().page();
    const bool is_clear = static_cast<double>(strip->Rect().Min.x) >= page.column.x1 ||
                          static_cast<double>(strip->Rect().Max.y) <= page.ceiling;
    EXPECT_TRUE(is_clear) << size.width << ' ' << scale;
    EXPECT_LE(strip->Rect().Max.x, static_cast<float>(size.width));
  }
}

/// Where two pictures differ.
PixelBox difference(const Image& a, const Image& b) {
  PixelBox box{1e9, 1e9, -1, -1};
  for (int row = 0; row < a.size.height; ++row)
    for (int at = 0; at < a.size.width; ++at)
      if (std::memcmp(a.pixel(at, row), b.pixel(at, row), 4) != 0)
        box = {std::min<double>(box.x0, at), std::min<double>(box.y0, row), std::max<double>(box.x1, at),
               std::max<double>(box.y1, row)};
  return box;
}

// 2026-11-28: in a narrow column the line of help for who is new crossed the figure.
TEST_F(StillPageTest, HowToBeginIsToldInTheColumnBelowTheText) {
  int told = 0;
  for (const auto& [size, scale] : kShown) {
    session.set_visited({});
    for (int i = 0; i < 3; ++i)
      ASSERT_TRUE(screen->draw(session, {.size = size, .scale = scale, .seconds = 0.02}));
    const Image with = screen->read();
    session.set_visited({session.lesson().stages[1].id});
    for (int i = 0; i < 3; ++i)
      ASSERT_TRUE(screen->draw(session, {.size = size, .scale = scale, .seconds = 0.02}));
    const PixelBox words = difference(with, screen->read());
    if (words.x1 < 0) continue;
    ++told;
    const Page& page = screen->page().page();
    EXPECT_GE(words.x0, page.column.x0 - 1) << size.width;
    EXPECT_LE(words.x1, page.column.x1 + 1) << size.width;
    for (std::size_t i = 0; i < page.column_texts; ++i)
      EXPECT_LT(page.sheet.texts[i].at.y() + page.sheet.texts[i].list.depth, words.y0) << size.width;
  }
  EXPECT_GT(told, 1);
}

// 2026-11-28: with large controls the mark of how far the text is scrolled stood in the figure.
TEST_F(StillPageTest, TheMarkOfScrollingIsBetweenTextAndFigure) {
  for (const double text_scale : {1.0, 1.5})
    for (const Shown& shown : kShown) {
      const Size size = shown.size;
      const double scale = shown.scale;
      session.preferences.text_scale = text_scale;
      session.go_to({0, 3});
      const auto draw = [&] {
        for (int i = 0; i < 3; ++i)
          ASSERT_TRUE(screen->draw(session, {.size = size, .scale = scale, .seconds = 0.02}));
      };
      draw();
      const Image before = screen->read();
      screen->press(session, "K");
      draw();
      if (screen->page().page().overflow <= 0) continue;
      const Page& page = screen->page().page();
      if (page.ceiling <= 0) {
        EXPECT_LT(difference(before, screen->read()).x1, page.meters.x0) << size.width << ' ' << scale;
      }
    }
}

}  // namespace
}  // namespace polhode
