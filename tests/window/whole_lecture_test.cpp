// SPDX-License-Identifier: MIT
// The whole lecture by the mouse alone: every step by its button, and on each the first question that is
// answered by picking a choice.
#include "lessons/claims/answers/answers.h"
#include "lessons/reader/lesson.h"
#include "lessons/reader/reader.h"
#include "tests/window/controls.h"
#include "tests/window/window_test.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <set>

namespace polhode::window_test {
namespace {

const Lesson& lecture() {
  static const Lesson lesson = [] {
    LessonReading read =
        read_lesson(text_of(test::source_dir() / "lessons/euler-equations.md"), "euler-equations.md");
    if (!read.lesson) throw std::runtime_error("the lecture cannot be read");
    return std::move(*read.lesson);
  }();
  return lesson;
}

class WholeLecture : public WindowTest {
 protected:
  /// Whether the window comes to note an answer to the question as right.
  bool comes_right(const std::string& stage, const Ask& ask) const {
    return eventually([&] {
      const auto path = home().state() / "euler-equations.answers.json";
      if (!std::filesystem::exists(path)) return false;
      const auto all = nlohmann::json::parse(text_of(path), nullptr, false);
      if (all.is_discarded() || !all.contains("answers")) return false;
      return all["answers"].value(stage + '/' + ask.id, nlohmann::json::object()).value("right", false);
    });
  }
};

/// Where boxes begin at the left edge of the panel, from above: the letters of choices, buttons, fields.
std::vector<Point> boxes_of_panel(const Image& picture) {
  constexpr int kLeft = 968, kLeastHeight = 16, kMostHeight = 40;
  std::vector<Point> boxes;
  const auto is_bright = [&](int y) {
    const std::uint8_t* pixel = picture.pixel(kLeft, y);
    return pixel[0] >= 252 && pixel[1] >= 252 && pixel[2] >= 252;
  };
  for (int y = 60; y < 745;) {
    int end = y;
    while (end < 745 && is_bright(end)) ++end;
    if (end - y >= kLeastHeight && end - y <= kMostHeight) boxes.push_back({kLeft + 8, (y + end) / 2});
    y = std::max(end, y + 1);
  }
  return boxes;
}

constexpr std::chrono::seconds kPanelComes{20};

TEST_F(WholeLecture, IsPickedByTheMouseAlone) {
  const auto begin = std::chrono::steady_clock::now();
  PlayedLesson lesson(display(), home(), {"euler-equations"});
  lesson.click(kAnswer);
  lesson.picture_at_rest();
  int picked = 0;
  std::set<std::size_t> with_answers;
  for (std::size_t s = 0; s < lecture().stages.size(); ++s) {
    const Stage& stage = lecture().stages[s];
    for (std::size_t k = 0; k < stage.steps.size(); ++k) {
      ASSERT_TRUE(lesson.comes_to(static_cast<int>(s) + 1, static_cast<int>(k) + 1)) << stage.id;
      const auto asks = blocks_of<Ask>(stage.steps[k]);
      // Of two questions on a step the second moves as the first is answered: the first alone is picked.
      if (!asks.empty() && picks_choice(asks[0]->type)) {
        const auto choice = static_cast<std::size_t>(asks[0]->answers[0] - 1);
        // On a busy machine two pictures can be equal before the panel is drawn.
        std::vector<Point> boxes;
        const auto asked = std::chrono::steady_clock::now();
        do {
          boxes = boxes_of_panel(lesson.picture_at_rest());
        } while (choice >= boxes.size() && std::chrono::steady_clock::now() - asked < kPanelComes);
        ASSERT_LT(choice, boxes.size()) << stage.id << '/' << asks[0]->id;
        lesson.click(boxes[choice]);
        ASSERT_TRUE(comes_right(stage.id, *asks[0])) << stage.id << '/' << asks[0]->id;
        ++picked;
        with_answers.insert(s);
      }
      lesson.click(kNextStep);
    }
  }
  EXPECT_GT(picked, 25);
  EXPECT_GT(with_answers.size(), 20u);
  EXPECT_EQ(lesson.said(), "");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  std::printf("%d questions picked in %zu stages, %.0f s\n", picked, with_answers.size(), took.count());
}

}  // namespace
}  // namespace polhode::window_test
