// SPDX-License-Identifier: MIT
// The whole lecture as a student goes through it who answers every question: derivations by typing their
// lines, motions by bringing them to their goals. Once by keys alone; and by the mouse alone, which cannot
// type: it answers what is picked, and goes on with the button of each step.
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

namespace polhode::window_test {
namespace {

const Lesson& lecture() {
  static const Lesson lesson = [] {
    LessonReading read =
        read_lesson(text_of(test::source_dir() / "lessons/euler-equations.md"), "euler-equations.md");
    if (!read.lesson) throw std::runtime_error("the lecture cannot be read");
    compute_answers(*read.lesson);
    return std::move(*read.lesson);
  }();
  return lesson;
}

std::string letters_of(const Ask& ask) {
  std::string letters;
  for (const int answer : ask.answers) letters += letter_of_choice(static_cast<std::size_t>(answer - 1));
  return letters;
}

class WholeLecture : public WindowTest {
 protected:
  /// What the window has noted of a question.
  nlohmann::json noted(const std::string& stage, const Ask& ask) const {
    const auto path = home().state() / "euler-equations.answers.json";
    if (!std::filesystem::exists(path)) return nlohmann::json::object();
    const auto all = nlohmann::json::parse(text_of(path), nullptr, false);
    if (all.is_discarded() || !all.contains("answers")) return nlohmann::json::object();
    return all["answers"].value(stage + '/' + ask.id, nlohmann::json::object());
  }
  bool is_right(const std::string& stage, const Ask& ask) const {
    return noted(stage, ask).value("right", false);
  }
  bool comes_right(const std::string& stage, const Ask& ask) const {
    return eventually([&] { return is_right(stage, ask); });
  }
};

/// What the panel does as it is opened by its key: the first field has the keys.
void open_again(PlayedLesson& lesson, bool& is_open) {
  if (is_open) {
    const Image open = lesson.picture_at_rest();
    lesson.press({"q"});
    lesson.changes_from(open);
  }
  const Image closed = lesson.picture_at_rest();
  lesson.press({"q"});
  lesson.changes_from(closed);
  lesson.picture_at_rest();
  is_open = true;
}

/// Opens the slider with the keys on it, types its number and goes down to the next one.
void type_into_slider(PlayedLesson& lesson, double value) {
  const Image before = lesson.picture_at_rest();
  lesson.press({"Return"});
  lesson.changes_from(before);
  lesson.picture_at_rest();
  lesson.type(nlohmann::json(value).dump());
  lesson.press({"Return"});
  lesson.picture_at_rest();
  lesson.press({"Down"});
  lesson.picture_at_rest();
}

std::vector<double> numbers_of(const StateTask& task) {
  std::vector<double> numbers;
  const auto add = [&](const Vec3& v) { numbers.insert(numbers.end(), v.begin(), v.end()); };
  const SteeredState& state = task.solution;
  if (task.change.contains(Steered::omega)) add(state.w0_B.value_or(task.scene->w0_B));
  if (task.change.contains(Steered::moments)) add(state.moments.value_or(task.scene->body.moments.vector()));
  if (task.change.contains(Steered::torque))
    add(components_of(state.torque.value_or(constant_torque(task.scene->torque))));
  return numbers;
}

TEST_F(WholeLecture, IsDerivedByTheKeyboardAlone) {
  const auto begin = std::chrono::steady_clock::now();
  PlayedLesson lesson(display(), home(), {"euler-equations"});
  bool is_open = false;
  int answered = 0, derived = 0;
  for (std::size_t s = 0; s < lecture().stages.size(); ++s) {
    const Stage& stage = lecture().stages[s];
    for (std::size_t k = 0; k < stage.steps.size(); ++k) {
      ASSERT_TRUE(lesson.comes_to(static_cast<int>(s) + 1, static_cast<int>(k) + 1)) << stage.id;
      bool has_typed = false;
      for (const Ask* ask : blocks_of<Ask>(stage.steps[k])) {
        const std::string what = stage.id + '/' + ask->id;
        if (picks_choice(ask->type)) {
          if (!is_open) open_again(lesson, is_open);
          const std::string letter = letters_of(*ask);
          lesson.press({std::string(1, static_cast<char>(letter[0] - 'A' + 'a'))});
        } else if (ask->task) {
          open_again(lesson, is_open);
          lesson.press({"F6"});
          lesson.picture_at_rest();
          lesson.press({"Down", "Down"});
          lesson.picture_at_rest();
          for (const double value : numbers_of(*ask->task)) type_into_slider(lesson, value);
          lesson.press({"space"});
        } else {
          ASSERT_FALSE(has_typed) << what << ": the second field of a step is not reached by q";
          has_typed = true;
          open_again(lesson, is_open);
          if (ask->derivation) {
            for (const WorkedLine& worked : ask->derivation->worked) {
              lesson.type(worked.line.typed);
              lesson.press({"Return"});
              ASSERT_TRUE(eventually([&] {
                return noted(stage.id, *ask).value("last", "").ends_with(worked.line.typed);
              })) << what
                  << ": " << worked.line.typed << "\n"
                  << noted(stage.id, *ask).dump();
              lesson.picture_at_rest();  // the field has the keys again in the frame behind
              ++derived;
              if (is_right(stage.id, *ask)) break;  // the goal in fewer lines: a solution may have more
            }
          } else {
            lesson.type(ask->number       ? nlohmann::json(*ask->number->value).dump()
                        : ask->expression ? ask->expression->text
                                          : letters_of(*ask));
            lesson.press({"Return"});
          }
        }
        ASSERT_TRUE(comes_right(stage.id, *ask)) << what << "\n" << noted(stage.id, *ask).dump();
        ++answered;
        if (picks_choice(ask->type)) continue;
        lesson.picture_at_rest();  // a field that is right gives the keys back, in the frame behind
        if (ask->task) lesson.press({"F6"});
      }
      lesson.press({"Right"});
    }
  }
  EXPECT_GT(answered, 50);
  EXPECT_GT(derived, 15);
  const Image end = lesson.picture_at_rest();
  EXPECT_FALSE(is_blank(end));
  EXPECT_EQ(lesson.said(), "");
  lesson.press({"ctrl+q"});
  EXPECT_EQ(lesson.process().wait(), 0);
  const std::string told = output_of({test::program(), "answers", "euler-equations"},
                                     {{"XDG_STATE_HOME", (home().folder / "state").string()},
                                      {"POLHODE_LESSONS", test::source_dir() / "lessons"}});
  EXPECT_NE(told.find(std::to_string(answered) + " of " + std::to_string(answered) + " right"),
            std::string::npos)
      << told;
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  std::printf("%d questions, %d typed lines, %.0f s\n", answered, derived, took.count());
}

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
        const std::vector<Point> boxes = boxes_of_panel(lesson.picture_at_rest());
        const auto choice = static_cast<std::size_t>(asks[0]->answers[0] - 1);
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
