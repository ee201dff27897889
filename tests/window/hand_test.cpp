// SPDX-License-Identifier: MIT
// What a hand does in the figure and in the panels.
#include "tests/window/controls.h"
#include "tests/window/window_test.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace polhode::window_test {
namespace {

class Hand : public WindowTest {};

Point beside(Point point, int dx, int dy) { return {point.x + dx, point.y + dy}; }

enum class Plots { same, others };

/// What was done by hand is seen in the figure, and in the plots if the motion is another one; one key gives
/// the lesson's scene back, to the last pixel.
void expect_change_and_return(PlayedLesson& lesson, const Image& start, Plots plots) {
  EXPECT_TRUE(lesson.changes_from(start));
  lesson.move_to({1, 1});
  const Image changed = lesson.picture_at_rest();
  EXPECT_GT(changed_part(start, changed, kFigureFrom, kFigureTo), 0.01);
  const double of_plots = changed_part(start, changed, kPlotsFrom, kPlotsTo);
  if (plots == Plots::same)
    EXPECT_EQ(of_plots, 0);
  else
    EXPECT_GT(of_plots, 1e-3);
  lesson.press({"r"});
  EXPECT_TRUE(lesson.changes_from(changed));
  EXPECT_EQ(lesson.picture_at_rest().rgba, start.rgba);
}

TEST_F(Hand, TurnsTheCamera) {
  PlayedLesson lesson(display(), home(), {kPlayed});
  const Image start = lesson.picture_at_rest();
  lesson.drag({kInFigure, beside(kInFigure, 60, 0), beside(kInFigure, 120, 20)});
  expect_change_and_return(lesson, start, Plots::same);
}

TEST_F(Hand, ZoomsByTheWheel) {
  PlayedLesson lesson(display(), home(), {kPlayed});
  const Image start = lesson.picture_at_rest();
  lesson.turn_wheel(kInFigure, 3);
  expect_change_and_return(lesson, start, Plots::same);
}

TEST_F(Hand, TakesOmegaByItsTip) {
  PlayedLesson lesson(display(), home(), {kPlayed});
  const Image start = lesson.picture_at_rest();
  lesson.drag({kOmegaTip, beside(kOmegaTip, -20, 10), beside(kOmegaTip, -40, 20)});
  expect_change_and_return(lesson, start, Plots::others);
}

TEST_F(Hand, ChoosesAnotherMethodByKeysAlone) {
  PlayedLesson lesson(display(), home(), {kPlayed});
  const Image start = lesson.picture_at_rest();
  lesson.press({"m"});
  ASSERT_TRUE(eventually([&] {  // the methods are measured: there is a slider, at the closed form
    const Image picture = lesson.picture();
    const std::uint8_t* grab = picture.pixel(kFrontEnd.x, kFrontEnd.y);
    return grab[2] > grab[0] + 20;
  }));
  // The panel opened on the list of methods, before there was a slider above it.
  lesson.press({"Up", "space", "Left", "Left", "Left", "space", "Escape", "Escape"});
  EXPECT_TRUE(eventually([&] {  // it drifts otherwise, beside the same words
    const Image changed = lesson.picture_at_rest();
    return changed_part(start, changed, kPlotsFrom, kPlotsTo) > 1e-3 &&
           changed_part(start, changed, kTextFrom, kTextTo) == 0;
  }));
  lesson.press({"r"});
  EXPECT_TRUE(eventually([&] { return lesson.picture_at_rest().rgba == start.rgba; }));
}

// By the pointer or by Tab: a symbol is lit in the text and in the figure, with a note beside it.
TEST_F(Hand, PointsAtASymbol) {
  PlayedLesson lesson(display(), home(), {kPlayed});
  const Image start = lesson.picture_at_rest();
  const auto expect_lit = [&] {
    ASSERT_TRUE(lesson.changes_from(start));
    const Image lit = lesson.picture_at_rest();
    EXPECT_GT(changed_part(start, lit, kTextFrom, kTextTo), 0.005);
    EXPECT_GT(changed_part(start, lit, kFigureFrom, kFigureTo), 1e-4);
  };
  lesson.move_to(kOmegaWord);
  expect_lit();
  lesson.move_to({1, 1});
  EXPECT_TRUE(eventually([&] { return lesson.picture().rgba == start.rgba; }));
  lesson.press({"Tab"});
  expect_lit();
  lesson.press({"Escape"});
  EXPECT_TRUE(eventually([&] { return lesson.picture().rgba == start.rgba; }));
}

nlohmann::json answers(const Home& home, const std::string& lesson_id) {
  const auto path = home.state() / (lesson_id + ".answers.json");
  if (!std::filesystem::exists(path)) return nlohmann::json::object();
  return nlohmann::json::parse(text_of(path)).at("answers");
}

TEST_F(Hand, AnswersAQuestionWrongAndRight) {
  PlayedLesson lesson(display(), home(), {kPlayed, "--stage", "question"});
  const auto tries = [&](int number, bool right) {
    return eventually([&] {
      const nlohmann::json given =
          answers(home(), "played").value("question/twice", nlohmann::json::object());
      return given.value("tries", 0) == number && given.value("right", false) == right;
    });
  };
  const Image start = lesson.picture_at_rest();
  lesson.press({"q"});
  ASSERT_TRUE(lesson.changes_from(start));
  const Image asked = lesson.picture_at_rest();
  lesson.type("3*w1");
  lesson.press({"Return"});
  EXPECT_TRUE(tries(1, false));
  const Image wrong = lesson.picture_at_rest();
  EXPECT_GT(changed_part(asked, wrong, {0, 0}, {1280, 800}), 1e-3);

  lesson.press({"ctrl+a"});
  lesson.type("w1 + w1");
  lesson.press({"Return"});
  EXPECT_TRUE(tries(2, true));
  EXPECT_TRUE(lesson.changes_from(wrong));
  lesson.picture_at_rest();
  EXPECT_EQ(lesson.place().stage, 2) << "letters and Enter are for the question";
  lesson.press({"Left"});
  EXPECT_TRUE(eventually([&] { return lesson.place().stage == 1; })) << "what is right needs no other try";
}

// The tip is dragged to where the goal is reached; only Check makes an answer of it, which is the state
// itself.
TEST_F(Hand, BringsAMotionToItsGoal) {
  PlayedLesson lesson(display(), home(), {kSteered});
  const Image start = lesson.picture_at_rest();
  lesson.press({"q"});
  ASSERT_TRUE(lesson.changes_from(start));
  const Image asked = lesson.picture_at_rest();
  lesson.drag({kSteeredTip, beside(kSteeredTip, -25, 27), beside(kSteeredTip, -50, 54)});
  ASSERT_TRUE(lesson.changes_from(asked));
  lesson.picture_at_rest();
  EXPECT_TRUE(answers(home(), "steered").empty()) << "nothing was checked";
  lesson.click(kCheckState);
  EXPECT_TRUE(eventually([&] {
    const nlohmann::json given = answers(home(), "steered").value("apart/apart", nlohmann::json::object());
    return given.value("right", false) && given.value("last", "").find("omega = [") == 0;
  })) << answers(home(), "steered").dump();
}

TEST_F(Hand, EditsAnAnswer) {
  PlayedLesson lesson(display(), home(), {kPlayed, "--stage", "question"});
  const Image start = lesson.picture_at_rest();
  lesson.press({"q"});
  ASSERT_TRUE(lesson.changes_from(start));
  lesson.picture_at_rest();
  lesson.type("w1w1*w3");
  lesson.press({"BackSpace", "BackSpace", "shift+Left", "Delete", "Home", "Right", "Right"});
  lesson.type(" + ");
  lesson.press({"Return"});
  EXPECT_TRUE(eventually([&] {
    return answers(home(), "played").dump().find("w1 + w1") != std::string::npos;
  })) << answers(home(), "played").dump();
}

}  // namespace
}  // namespace polhode::window_test
