// SPDX-License-Identifier: MIT
// The whole lecture by the mouse alone: every step by its button, and on each the first question that is
// answered by picking a choice. And by the keyboard alone: every question of it, and all derivations.
#include "lessons/claims/answers/answers.h"
#include "lessons/derivation/derivation.h"
#include "lessons/reader/lesson.h"
#include "lessons/reader/questions/number_question.h"
#include "lessons/reader/questions/state_task.h"
#include "lessons/reader/reader.h"
#include "tests/window/controls.h"
#include "tests/window/window_test.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <set>
#include <sstream>
#include <utility>

namespace polhode::window_test {
namespace {

const Lesson& lecture() {
  static const Lesson lesson = [] {
    LessonReading read =
        read_lesson(text_of(test::source_dir() / "lessons/euler-equations.md"), "euler-equations.md");
    if (!read.lesson || compute_answers(*read.lesson)) throw std::runtime_error("the lecture cannot be read");
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
  lesson.click(kPreviousStep);
  EXPECT_TRUE(lesson.comes_to(static_cast<int>(lecture().stages.size()),
                              static_cast<int>(lecture().stages.back().steps.size()) - 1));
  EXPECT_GT(picked, 25);
  EXPECT_GT(with_answers.size(), 20u);
  EXPECT_EQ(lesson.said(), "");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  std::printf("%d questions picked in %zu stages, %.0f s\n", picked, with_answers.size(), took.count());
}

using Keys = std::vector<std::string>;

bool is_typed(const Ask& ask) { return !picks_choice(ask.type) && ask.type != Ask::Type::state; }

std::string text_of_number(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

/// What is typed into its field.
Keys lines_of(const Ask& ask) {
  Keys lines;
  switch (ask.type) {
    case Ask::Type::expression:
      return {ask.expression->text};
    case Ask::Type::number:
      return {text_of_number(*ask.number->value)};
    case Ask::Type::order:
      lines.emplace_back();
      for (const int choice : ask.answers) lines[0] += letter_of_choice(static_cast<std::size_t>(choice - 1));
      return lines;
    case Ask::Type::derive:
      for (const WorkedLine& worked : ask.derivation->worked) lines.push_back(worked.line.typed);
      return lines;
    default:
      return lines;
  }
}

/// Of its sliders, in their order.
std::vector<double> numbers_of(const SteeredState& solution) {
  std::vector<double> numbers;
  const auto add = [&](const Vec3& vector) { numbers.insert(numbers.end(), vector.begin(), vector.end()); };
  if (solution.w0_B) add(*solution.w0_B);
  if (solution.moments) add(*solution.moments);
  if (solution.torque) add(components_of(*solution.torque));
  return numbers;
}

/// As one run of xdotool, whose start takes longer than its keys.
class Typed {
 public:
  void keys(const Keys& names) {
    if (names.empty()) return;
    commands_.insert(commands_.end(), {"key", "--delay", "1"});
    commands_.insert(commands_.end(), names.begin(), names.end());
  }
  void text(const std::string& text) {
    commands_.insert(commands_.end(), {"type", "--delay", "1", "--args", "1", "--", text});
  }
  const Keys& commands() const { return commands_; }

 private:
  Keys commands_;
};

/// Opens the panel and answers all that the step asks. Nothing is waited for: what is pressed ahead of the
/// picture goes where it belongs.
void answer_by_keys(Typed& typed, const std::vector<const Ask*>& asks) {
  typed.keys({"q"});
  // Into the first field; behind an answer that is right the next one has the keyboard, then the page.
  for (const Ask* ask : asks) {
    if (!is_typed(*ask)) continue;
    for (const std::string& line : lines_of(*ask)) {
      typed.text(line);
      typed.keys({"Return"});  // a line end in the text would be another key
    }
  }
  for (const Ask* ask : asks)
    if (picks_choice(ask->type)) typed.keys({std::string(1, static_cast<char>('a' + ask->answers[0] - 1))});
  for (const Ask* ask : asks) {
    if (ask->type != Ask::Type::state) continue;
    typed.keys({"F6"});  // to the first slider
    for (const double number : numbers_of(ask->task->solution)) {
      typed.keys({"Return"});  // its number is typed from here
      typed.text(text_of_number(number));
      typed.keys({"Return", "Tab"});
    }
    typed.keys({"space"});  // the button behind them
  }
}

/// From its last step to its first.
void walk_back(PlayedLesson& lesson) {
  const std::vector<Stage>& stages = lecture().stages;
  ASSERT_TRUE(lesson.comes_to(static_cast<int>(stages.size()), static_cast<int>(stages.back().steps.size())));
  for (std::size_t s = stages.size(); s-- > 0;) {
    lesson.press(Keys(stages[s].steps.size() - 1, "Left"));
    ASSERT_TRUE(lesson.comes_to(static_cast<int>(s) + 1, 1)) << "back to " << stages[s].id;
    lesson.press({"Left"});  // to the last step of the stage before, if there is one
  }
}

TEST_F(WholeLecture, IsDerivedByTheKeyboardAloneAndWalkedBack) {
  const auto begin = std::chrono::steady_clock::now();
  PlayedLesson lesson(display(), home(), {"euler-equations"});
  int answered = 0, derived = 0;
  Keys on_the_way;
  for (std::size_t s = 0; s < lecture().stages.size(); ++s) {
    const Stage& stage = lecture().stages[s];
    for (std::size_t k = 0; k < stage.steps.size(); ++k, on_the_way.push_back("Right")) {
      const auto asks = blocks_of<Ask>(stage.steps[k]);
      if (asks.empty()) continue;
      Typed typed;
      typed.keys(std::exchange(on_the_way, {"Escape"}));  // which closes the panel
      answer_by_keys(typed, asks);
      display().act(typed.commands());
      ASSERT_TRUE(lesson.comes_to(static_cast<int>(s) + 1, static_cast<int>(k) + 1)) << stage.id;
      for (const Ask* ask : asks) {
        const bool is_right = comes_right(stage.id, *ask);
        if (!is_right) lesson.picture();  // for who looks into it
        ASSERT_TRUE(is_right) << stage.id << '/' << ask->id;
        ++answered;
        derived += ask->derivation ? 1 : 0;
      }
    }
  }
  on_the_way.push_back("Escape");
  lesson.press(
      on_the_way);  // once more than there are steps, to the list of lessons, and back to the last step
  walk_back(lesson);
  EXPECT_GT(answered, 50);
  EXPECT_EQ(derived, 8);
  EXPECT_EQ(lesson.said(), "");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  std::printf("%d questions answered, %d of them derivations, %.0f s\n", answered, derived, took.count());
}

}  // namespace
}  // namespace polhode::window_test
