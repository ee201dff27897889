// SPDX-License-Identifier: MIT
// The panel of questions: its formulas, and whose the keys are beside it.
#include "app/session/answers/answer_log.h"
#include "lessons/reader/questions/state_task.h"
#include "tests/app/window/screen_harness.h"

#include <gmock/gmock.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cstring>

namespace polhode {
namespace {

class QuestionsPanelTest : public ScreenTest {
 protected:
  /// To the step that asks this.
  const Ask& go_to_question(std::string_view id) {
    const auto& stages = session.lesson().stages;
    for (std::size_t stage = 0; stage < stages.size(); ++stage)
      for (std::size_t step = 0; step < stages[stage].steps.size(); ++step)
        for (const Ask* ask : blocks_of<Ask>(stages[stage].steps[step]))
          if (ask->id == id) {
            session.go_to({stage, step});
            return *ask;
          }
    throw std::runtime_error("no such question");
  }

  /// Of the button below the question, whatever it says; where there is none nothing is pressed.
  int hints_after_a_press(const Ask& ask) {
    session.panel = Panel::question;
    frame(3);
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
      if (window->Active && std::string_view(window->Name).starts_with("panel/contents"))
        ImGui::GetCurrentContext()->NavNextActivateId =
            ImHashStr("###hint", 0, ImHashStr(ask.id.c_str(), 0, window->ID));
    frame(3);
    const AnswerRecord* record = session.record(ask);
    return record == nullptr ? 0 : record->hints;
  }

  void expect_hints_by_enter(std::string_view id) {
    const Ask& ask = go_to_question(id);
    session.panel = Panel::question;
    frame(4);
    screen->press(session, "F6");
    frame(3);
    give_to_panel(ImGuiKey_DownArrow);  // from the field to the hint
    for (int hints = 1; hints <= 2; ++hints) {
      give_to_panel(ImGuiKey_Enter);
      ASSERT_NE(session.record(ask), nullptr);
      EXPECT_EQ(session.record(ask)->hints, hints);
    }
  }
};

TEST_F(QuestionsPanelTest, KeysThatWalkAndPlayAreThePages) {
  go_to_question("no-torque");
  screen->press(session, "Q");
  frame(4);
  ASSERT_EQ(session.panel, Panel::question);
  EXPECT_TRUE(screen->press(session, "Space"));
  EXPECT_TRUE(session.is_playing());
  session.set_playing(false);
  const StepPlace asked = session.place();
  for (const char* key : {"Right", "PageDown"}) {
    session.go_to(asked);
    frame(3);
    EXPECT_TRUE(screen->press(session, key));
    if (session.place() == asked) screen->press(session, key);  // a prediction asks once
    EXPECT_EQ(session.place(), (StepPlace{asked.stage, asked.step + 1})) << key;
  }
  EXPECT_EQ(session.panel, Panel::question) << "it stays open";
  screen->press(session, "F6");
  frame(3);
  EXPECT_FALSE(screen->press(session, "Right")) << "asked for by a key";
  screen->press(session, "F6");
  frame(3);
  EXPECT_TRUE(screen->press(session, "Left"));
}

// The reply stands in the panel, which opens; the mark stands where the choice is.
TEST_F(QuestionsPanelTest, AChoiceIsClickedWhereItStands) {
  const Ask& ask = go_to_question("no-torque");
  frame(3);
  const std::vector<Page::Choice> choices = screen->page().page().choices;
  ASSERT_EQ(choices.size(), ask.choices.size());
  const auto middle = [](const PixelBox& box) {
    return Vec2(0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1));
  };
  for (const Page::Choice& choice : choices) {
    EXPECT_EQ(choice.ask, &ask);
    click(middle(choice.box).x(), middle(choice.box).y());
    EXPECT_EQ(session.panel, Panel::question);
    ASSERT_NE(session.judged(ask), nullptr);
    session.end_play();
    frame(2);
    EXPECT_EQ(session.judged(ask)->judgement.choice, static_cast<int>(choice.number) + 1);
    if (session.judged(ask)->judgement.mark == AnswerJudgement::Mark::right) break;
  }
  EXPECT_EQ(session.judged(ask)->judgement.mark, AnswerJudgement::Mark::right);
  const AnswerRecord before = *session.record(ask);
  click(middle(choices.front().box).x(), middle(choices.front().box).y());
  EXPECT_EQ(session.record(ask)->tries, before.tries) << "it is answered";
}

// One that is typed is answered in the panel, which a click on it opens; one may type at once.
TEST_F(QuestionsPanelTest, AQuestionIsOpenedWhereItStands) {
  const Ask& ask = go_to_question("hold-steady");
  frame(3);
  const auto& questions = screen->page().page().open_questions;
  ASSERT_EQ(questions.size(), 1U);
  EXPECT_EQ(questions.front().ask, &ask);
  const PixelBox box = questions.front().box;
  click(0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1));
  frame(3);
  EXPECT_EQ(session.panel, Panel::question);
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
  const StepPlace asked = session.place();
  EXPECT_FALSE(screen->press(session, "Right"));
  EXPECT_EQ(session.place(), asked);
}

// By the button in the bar as by the key.
TEST_F(QuestionsPanelTest, ItsFieldHasTheCursorHoweverItWasOpened) {
  go_to_question("hold-steady");
  frame(3);
  click(1104, 775);
  ASSERT_EQ(session.panel, Panel::question);
  frame(3);
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
  for (const char* key : {"W", "G", "-", "S"}) EXPECT_FALSE(screen->press(session, key)) << key;
  EXPECT_EQ(session.panel, Panel::question);
}

// An answer that is typed beside its field opens no panel and changes nothing.
TEST_F(QuestionsPanelTest, AMissedClickTypesNoCommands) {
  go_to_question("hold-steady");
  screen->press(session, "Q");
  frame(5);
  click(kSize.width - 150, 12);  // beside the field
  ASSERT_FALSE(ImGui::GetIO().WantTextInput);
  const double t_s = session.t_s(), text_scale = session.preferences.text_scale;
  for (const char* key : {"W", "1", "*", "-", "0", "G", "S", "E", "B", "+"})
    EXPECT_FALSE(screen->press(session, key)) << key;
  EXPECT_EQ(session.panel, Panel::question);
  EXPECT_EQ(session.preferences.text_scale, text_scale);
  EXPECT_EQ(session.t_s(), t_s);
  EXPECT_TRUE(session.edits().empty());
}

// 2026-11-26: a line that was typed while the keyboard was the page's fired commands letter by letter.
TEST_F(QuestionsPanelTest, ALineThatIsTypedOnThePageIsTheAnswer) {
  const Ask& ask = go_to_question("derive-six");
  frame(3);
  const auto type = [&](std::string_view text) {
    for (const char c : text) {
      const std::string key(1, c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c);
      if (c == ' ' || !screen->press(session, key))
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(c));
    }
    frame(5);
  };
  type("N = d");
  EXPECT_EQ(session.panel, Panel::question) << "N is a name of its lines";
  EXPECT_FALSE(session.has_speaker());
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
  type("L");
  const auto typed = [&] { return std::string(ImGui::GetInputTextState(ImGui::GetActiveID())->TextA.Data); };
  EXPECT_FALSE(session.shown_derivation().lines.empty());
  screen->press(session, "Escape");  // of the field
  frame(3);
  ASSERT_FALSE(ImGui::GetIO().WantTextInput);
  click(300, 500);  // on the page
  const double text_scale = session.preferences.text_scale;
  type("-w");
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  EXPECT_EQ(session.preferences.text_scale, text_scale);
  frame(2);
  EXPECT_EQ(typed(), "N = dL-w") << "behind what was there";
  screen->press(session, "Escape");
  frame(3);
  screen->press(session, "Escape");
  frame(3);
  ASSERT_EQ(session.panel, Panel::none);
  EXPECT_TRUE(screen->press(session, "B")) << "a command, which begins no line";
  EXPECT_EQ(session.panel, Panel::body);
  static_cast<void>(ask);
}

TEST_F(QuestionsPanelTest, AFieldGivesTheKeyboardBackAtEscape) {
  go_to_question("hold-steady");
  const StepPlace asked = session.place();
  screen->press(session, "Q");
  frame(5);
  ASSERT_TRUE(ImGui::GetIO().WantTextInput) << "one may type at once";
  EXPECT_FALSE(screen->press(session, "Right"));
  EXPECT_FALSE(screen->press(session, "Space"));
  EXPECT_TRUE(screen->press(session, "Escape"));
  frame(3);
  EXPECT_EQ(session.panel, Panel::question) << "of the field alone";
  EXPECT_TRUE(screen->press(session, "Left"));
  EXPECT_NE(session.place(), asked);
  EXPECT_TRUE(screen->press(session, "Escape"));
  EXPECT_EQ(session.panel, Panel::none);
}

// Whatever was chosen by keys in another panel before.
TEST_F(QuestionsPanelTest, ItsKeysAreThePagesHoweverTheLastPanelWasUsed) {
  go_to_question("no-torque");
  screen->press(session, "M");
  frame(3);
  give_to_panel(ImGuiKey_DownArrow);
  ASSERT_TRUE(ImGui::GetIO().NavVisible) << "a control is chosen";
  screen->press(session, "Q");
  frame(4);
  const StepPlace asked = session.place();
  EXPECT_TRUE(screen->press(session, "Left"));
  EXPECT_NE(session.place(), asked);
}

// What a prediction asks is told by the next step.
TEST_F(QuestionsPanelTest, APredictionHoldsTheNextStepBackOnce) {
  const Ask& ask = go_to_question("no-torque");
  const StepPlace asked = session.place();
  EXPECT_TRUE(screen->press(session, "Right"));
  EXPECT_EQ(session.place(), asked);
  EXPECT_THAT(screen->notice(), testing::HasSubstr("Answer first"));
  EXPECT_TRUE(screen->press(session, "Right", true)) << "held";
  EXPECT_EQ(session.place(), asked);
  EXPECT_TRUE(screen->press(session, "Right"));
  EXPECT_EQ(session.place(), (StepPlace{asked.stage, asked.step + 1}));
  session.go_to(asked);
  session.answer(ask, "A");  // its motion is played now: it is answered all the same
  EXPECT_TRUE(screen->press(session, "Right"));
  EXPECT_EQ(session.place(), (StepPlace{asked.stage, asked.step + 1}));
}

// 2026-11-27: the arrow to the next stage passed it over at the first press, and every way of going on
// counts.
TEST_F(QuestionsPanelTest, APredictionHoldsBackByEveryWayOfGoingOn) {
  const auto go_on = [&](const std::string& way) {
    if (way == "the button")
      click(148, 775);
    else
      screen->press(session, way);
    frame(2);
  };
  for (const char* way : {"Right", "PageDown", "Down", "Ctrl+PageDown", "Shift+PageDown", "the button"}) {
    session.go_to({0, 0});
    frame(2);
    go_to_question("no-torque");
    frame(3);
    const StepPlace asked = session.place();
    go_on(way);
    EXPECT_EQ(session.place(), asked) << way;
    EXPECT_THAT(screen->notice(), testing::HasSubstr("Answer first")) << way;
    go_on(way);
    EXPECT_NE(session.place(), asked) << way << ": once";
    session.go_to(asked);
    screen->press(session, "P");
    frame(2);
    if (std::string_view(way) != "the button") {
      go_on(way);
      EXPECT_NE(session.place(), asked) << way << ": an audience does not wait";
    }
    screen->press(session, "P");
    frame(2);
  }
}

// Of several that are typed the next one has the cursor, and Q begins in the first that is open.
TEST_F(QuestionsPanelTest, TheCursorGoesOnToWhatIsStillToBeAnswered) {
  session.replace_lesson(test::loaded_text(R"(+++
format = 1
id = "two"
title = "Two questions"
+++
# Two {two}
Two numbers.

```ask first
type = "expression"
prompt = "Twice $\\omega_1$?"
answer = "2*w1"
hints = ["Add it to itself."]
```
```ask second
type = "expression"
prompt = "Twice $\\omega_2$?"
answer = "2*w2"
hints = ["Add it to itself."]
```
)"));
  const auto enter = [&](const char* text) {
    ImGui::GetIO().AddInputCharactersUTF8(text);
    frame(2);
    give_to_panel(ImGuiKey_Enter);
    frame(2);
  };
  screen->press(session, "Q");
  frame(5);
  enter("2*w1");
  ASSERT_EQ(session.answers().at("two/first").right, 1);
  EXPECT_TRUE(ImGui::GetIO().WantTextInput) << "that of the second";
  screen->press(session, "Escape");
  frame(3);
  screen->press(session, "Escape");
  frame(3);
  screen->press(session, "Q");
  frame(5);
  enter("2*w2");
  ASSERT_EQ(session.answers().at("two/second").right, 1);
  EXPECT_FALSE(ImGui::GetIO().WantTextInput) << "there is no other";
}

// 2026-11-29: who typed one more line behind the goal changed the figure, the panel and the text by its
// letters.
TEST_F(QuestionsPanelTest, ALineBehindTheGoalIsNoCommand) {
  const Ask& ask = go_to_question("derive-six");
  screen->press(session, "Q");
  frame(5);
  for (const auto& worked : session.derivation(ask).derivation().worked) {
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
    ImGui::GetIO().AddInputCharactersUTF8(worked.line.typed.c_str());
    frame(2);
    give_to_panel(ImGuiKey_Enter);
    frame(2);
  }
  ASSERT_TRUE(session.derivation(ask).is_done());
  for (const char* letter : {"B", "T", "-", "O", "0", "2"})
    EXPECT_FALSE(screen->press(session, letter)) << letter;
  EXPECT_EQ(session.panel, Panel::question);
  const StepPlace asked = session.place();
  frame(2);
  EXPECT_TRUE(screen->press(session, "Right"));
  EXPECT_NE(session.place(), asked) << "arrows walk";
}

// 2026-11-26: Enter pressed nothing, and a button that says something else after it was pressed lost the
// focus.
TEST_F(QuestionsPanelTest, EnterPressesWhatIsChosenWhichStaysChosen) { expect_hints_by_enter("hold-steady"); }
TEST_F(QuestionsPanelTest, EnterPressesWhatIsChosenBesideADerivation) { expect_hints_by_enter("derive-six"); }

#if IMGUI_VERSION_NUM < 18900
// 2026-11-26: behind a long line the hint was seen from its middle, "= b + c".
TEST_F(QuestionsPanelTest, AnEmptyFieldShowsItsHintFromTheLeft) {
  const Ask& ask = go_to_question("derive-transport");
  screen->press(session, "Q");
  frame(5);
  ImGui::GetIO().AddInputCharactersUTF8(
      "dA/dt = A1' e1 + A2' e2 + A3' e3 + A1 de1/dt + A2 de2/dt + A3 de3/dt");
  frame(3);
  ASSERT_GT(ImGui::GetCurrentContext()->InputTextState.ScrollX, 0) << "it is longer than the field";
  give_to_panel(ImGuiKey_Enter);
  frame(3);
  ASSERT_EQ(session.derivation(ask).count(), 1u);
  EXPECT_EQ(ImGui::GetCurrentContext()->InputTextState.ScrollX, 0);
}
#endif

// What was set once is drawn, not set again: at rest, while the motion plays, and beside another answer.
TEST_F(QuestionsPanelTest, TextsAreSetWhenTheyChange) {
  const Ask& ask = go_to_question("length-kept");
  session.panel = Panel::question;
  frame(4);
  const int set = screen->texts().count();
  EXPECT_EQ(set, 1 + static_cast<int>(ask.choices.size())) << "the prompt and its choices";
  session.scrub_to(session.t_s() + 0.1);
  frame(4);
  EXPECT_EQ(screen->texts().count(), set);
  session.show_hint(ask);
  frame(4);
  EXPECT_EQ(screen->texts().count(), set + 1);
  session.preferences.theme = Theme::dark;
  frame(4);
  EXPECT_EQ(screen->texts().count(), 2 * (set + 1));
}

/// How many triangles of letters, pictures and frames reach to the right of what is seen of them, by more
/// than the margin of a text. Lines do, on purpose.
int cut_at_right() {
  constexpr float kMargin = 3, kHighestLine = 5;
  int cut = 0;
  const ImDrawData& drawn = *ImGui::GetDrawData();
  for (int i = 0; i < drawn.CmdListsCount; ++i) {
    const ImDrawList& list = *drawn.CmdLists[i];
    for (const ImDrawCmd& command : list.CmdBuffer)
      for (unsigned k = 0; k + 2 < command.ElemCount; k += 3) {
        const auto corner = [&](unsigned n) {
          const ImDrawIdx index = list.IdxBuffer[static_cast<int>(command.IdxOffset + k + n)];
          return list.VtxBuffer[static_cast<int>(command.VtxOffset + index)].pos;
        };
        const auto [low, high] = std::minmax({corner(0).y, corner(1).y, corner(2).y});
        const float right = std::max({corner(0).x, corner(1).x, corner(2).x});
        cut += high - low > kHighestLine && right > command.ClipRect.z + kMargin;
      }
  }
  return cut;
}

TEST_F(QuestionsPanelTest, NothingIsCutAtItsEdge) {
  for (const double scale : {1.0, 1.5}) {
    session.preferences.text_scale = scale;
    const auto& stages = session.lesson().stages;
    session.go_to({stages.size() - 1, stages.back().steps.size() - 1});  // the end, with its summary
    session.panel = Panel::question;
    frame(4);
    EXPECT_EQ(cut_at_right(), 0) << scale;
    for (const char* id : {"hold-steady", "apart", "derive-six", "cards", "no-torque"}) {
      const Ask& ask = go_to_question(id);
      while (!ask.derivation &&
             !is_told(session.record(ask) ? *session.record(ask) : AnswerRecord(), ask.hints.size()))
        session.show_hint(ask);
      frame(4);
      EXPECT_EQ(cut_at_right(), 0) << id << " " << scale;
    }
  }
}

TEST_F(QuestionsPanelTest, WhatWasAskedBeforeCanBeGoneBackTo) {
  go_to_question("length-kept");
  const StepPlace asked = session.place();
  ASSERT_TRUE(session.next_step());
  ASSERT_TRUE(session.questions().empty());
  session.panel = Panel::question;
  frame(4);
  for (int row = 60; row < 200 && session.place() != asked; row += 12) click(1100, row);
  EXPECT_EQ(session.place(), asked);
  EXPECT_EQ(session.panel, Panel::question);
}

TEST_F(QuestionsPanelTest, WhatWasAskedForGoesWhenItIsDone) {
  const Ask& ask = go_to_question("no-torque");
  frame(3);
  screen->press(session, "Right");
  frame(2);
  ASSERT_THAT(screen->notice(), testing::HasSubstr("Answer first"));
  screen->press(session, "Right");
  frame(2);
  EXPECT_EQ(screen->notice(), "") << "at the step behind it";
  session.previous_step();
  frame(2);
  screen->press(session, "Right");
  frame(2);
  ASSERT_THAT(screen->notice(), testing::HasSubstr("Answer first"));
  session.answer(ask, "A");
  frame(2);
  EXPECT_EQ(screen->notice(), "") << "answered";
}

TEST_F(QuestionsPanelTest, ALetterOfAClosedQuestionSaysSo) {
  const Ask& ask = go_to_question("no-torque");
  screen->press(session, "Q");
  frame(3);
  for (const char* key : {"A", "B", "C", "D", "E"}) {
    if (session.judged(ask) && session.judged(ask)->judgement.mark == AnswerJudgement::Mark::right) break;
    screen->press(session, key);
    session.end_play();
    frame(2);
  }
  ASSERT_EQ(session.judged(ask)->judgement.mark, AnswerJudgement::Mark::right);
  const int tries = session.record(ask)->tries;
  for (const char* key : {"A", "2"}) {
    EXPECT_TRUE(screen->press(session, key));
    EXPECT_THAT(screen->notice(), testing::HasSubstr("answered already")) << key;
    EXPECT_EQ(session.panel, Panel::question) << key;
  }
  EXPECT_EQ(session.record(ask)->tries, tries);
  EXPECT_TRUE(screen->press(session, "B"));
  EXPECT_EQ(session.panel, Panel::body) << "one that is a command is that again: " << screen->notice();
}

// A letter that was a choice a moment ago opened a panel over the answer: B the body, D the figure alone.
TEST_F(QuestionsPanelTest, WhileTheMotionAnswersALetterIsNoCommand) {
  session.preferences.reduced_motion = false;
  const Ask& ask = go_to_question("opening");
  screen->press(session, "Q");
  frame(3);
  ASSERT_TRUE(screen->press(session, "A"));
  frame(2);
  ASSERT_TRUE(session.is_awaited(ask));
  for (const char* key : {"B", "D"}) {
    if (static_cast<std::size_t>(key[0] - 'A') >= ask.choices.size()) continue;
    EXPECT_TRUE(screen->press(session, key));
    EXPECT_EQ(screen->notice(), "The motion answers first.") << key;
    EXPECT_EQ(session.panel, Panel::question) << key;
    EXPECT_FALSE(session.is_enlarged());
  }
  session.end_play();
  frame(2);
  ASSERT_TRUE(screen->press(session, "Right") && screen->press(session, "Right"));
  frame(2);
  EXPECT_EQ(screen->notice(), "") << "it was of the step before";
}

// 2026-11-28: in a small window the panel lay over all of the figure whose motion answered.
TEST_F(QuestionsPanelTest, InASmallWindowThePanelGivesWayToTheMotionThatAnswers) {
  session.preferences.reduced_motion = false;
  const Ask& ask = go_to_question("opening");
  const auto draw = [&] {
    for (int i = 0; i < 3; ++i)
      ASSERT_TRUE(screen->draw(session, {.size = {800, 560}, .scale = 1, .seconds = 0.02}));
  };
  const auto is_drawn = [] {
    const ImGuiWindow* panel = ImGui::FindWindowByName("panel");
    return panel != nullptr && panel->Active;
  };
  screen->press(session, "Q");
  draw();
  EXPECT_TRUE(is_drawn());
  ASSERT_TRUE(screen->press(session, "A"));
  draw();
  ASSERT_TRUE(session.is_awaited(ask));
  EXPECT_FALSE(is_drawn());
  EXPECT_GT(screen->page().page().figure.width(), 200);
  session.set_playing(false);
  draw();
  EXPECT_TRUE(is_drawn()) << "what rests is not hidden by it";
  session.set_playing(true);
  session.panel = Panel::outline;
  draw();
  EXPECT_TRUE(is_drawn()) << "another one was asked for";
  session.panel = Panel::question;
  draw();
  EXPECT_FALSE(is_drawn());
  session.end_play();
  draw();
  EXPECT_TRUE(is_drawn()) << "with the verdict";
}

TEST_F(QuestionsPanelTest, ChoicesOnThePageAreReachedByTab) {
  const Ask& ask = go_to_question("no-torque");
  frame(3);
  const std::size_t symbols = screen->page().symbols().size(), choices = screen->page().page().choices.size();
  ASSERT_GT(choices, 1U);
  for (std::size_t i = screen->page().first_seen(); i < symbols; ++i)
    EXPECT_TRUE(screen->press(session, "Tab"));
  const Image before = screen->read();
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(screen->press(session, "Tab"));
  frame(2);
  EXPECT_FALSE(screen->read().rgba == before.rgba) << "it has a frame";
  EXPECT_TRUE(screen->press(session, "Enter"));
  frame(2);
  ASSERT_NE(session.judged(ask), nullptr);
  EXPECT_EQ(session.judged(ask)->judgement.choice, 2);
  EXPECT_EQ(session.panel, Panel::question) << "where the reply stands";
  session.panel = Panel::none;
  EXPECT_TRUE(screen->press(session, "Shift+Tab")) << "from the last one";
}

// 2026-11-28: an expression was never seen as it is meant.
TEST_F(QuestionsPanelTest, AnExpressionIsSetAsItIsTyped) {
  go_to_question("wheel");
  screen->press(session, "Q");
  frame(5);
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  const int before = screen->texts().count();
  ImGui::GetIO().AddInputCharactersUTF8("w1/w2*(I2 - I1)");
  frame(3);
  EXPECT_EQ(screen->texts().count(), before + 1) << "once, not in each frame";
  ImGui::GetIO().AddInputCharactersUTF8("^2");
  frame(3);
  EXPECT_EQ(screen->texts().count(), before + 2);
}

// 2026-11-28: "A hint" stood below "Right." where a state was asked for.
TEST_F(QuestionsPanelTest, WhoHasAnsweredAStateIsOfferedNoHint) {
  const Ask& ask = go_to_question("apart");
  ASSERT_TRUE(ask.task && !ask.hints.empty());
  const SteeredState& solution = ask.task->solution;
  ASSERT_TRUE(solution.w0_B);
  ASSERT_TRUE(session.set_edits({.w0_B = solution.w0_B}));
  ASSERT_EQ(session.answer(ask, text_of(solution)).mark, AnswerJudgement::Mark::right);
  session.show_hint(ask);
  const int hints = session.record(ask)->hints;
  EXPECT_EQ(hints_after_a_press(ask), hints);
  session.answer(ask, "omega = [1, 1, 1]");
  EXPECT_EQ(hints_after_a_press(ask), hints) << "the motion is the one that was right";
  session.reset_edits();
  session.forget_answer(ask);
  EXPECT_EQ(hints_after_a_press(ask), 1) << "who has not is";
}

// 2026-11-28: the notice that asks for an answer stood there after it.
TEST_F(QuestionsPanelTest, AnswerFirstGoesWithTheAnswerAndBeforeAnAudience) {
  const Ask& ask = go_to_question("no-torque");
  frame(2);
  screen->press(session, "Right");
  frame(2);
  ASSERT_THAT(screen->notice(), testing::HasSubstr("Answer first"));
  session.answer(ask, "A");
  frame(2);
  EXPECT_EQ(screen->notice(), "");
  session.forget_answer(ask);
  session.go_to({0, 0});
  frame(2);
  go_to_question("no-torque");
  frame(2);
  screen->press(session, "Right");
  frame(2);
  ASSERT_THAT(screen->notice(), testing::HasSubstr("Answer first"));
  session.set_presenting(true);
  frame(2);
  EXPECT_EQ(screen->notice(), "");
}

/// The lowest row of the panel in which something is drawn.
int lowest_ink(const Image& image) {
  constexpr int kLeft = 960, kRight = 1240, kEnd = 744;
  for (int row = kEnd; row > 0; --row)
    for (int at = kLeft + 1; at < kRight; ++at)
      if (std::memcmp(image.pixel(at, row), image.pixel(kLeft, kEnd), 4) != 0) return row;
  return 0;
}

// 2026-11-28: the buttons below the line that says whose the keys are moved as it changed.
TEST_F(QuestionsPanelTest, TheButtonsStandWhoeverHasTheKeys) {
  go_to_question("hold-steady");
  for (const double scale : {1.0, 1.2}) {
    session.preferences.text_scale = scale;
    session.panel = Panel::none;
    frame(2);
    screen->press(session, "Q");
    frame(5);
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
    const int typing = lowest_ink(screen->read());
    ASSERT_GT(typing, 300);
    screen->press(session, "Escape");
    frame(4);
    ASSERT_FALSE(ImGui::GetIO().WantTextInput);
    EXPECT_EQ(lowest_ink(screen->read()), typing) << "keys go to the page, " << scale;
    screen->press(session, "F6");
    frame(4);
    EXPECT_EQ(lowest_ink(screen->read()), typing) << "keys go to the panel, " << scale;
    screen->press(session, "F6");
    frame(2);
  }
}

// 2026-11-28: at 200 % "right" stood between two choices, where one took two lines.
TEST_F(QuestionsPanelTest, TheMarkOfAChoiceStandsAtItsFirstLine) {
  const auto draw = [&] {
    for (int i = 0; i < 3; ++i)
      ASSERT_TRUE(screen->draw(session, {.size = {1280, 1600}, .scale = 2, .seconds = 0.02}));
  };
  constexpr double kEnd = 1400;  // above the bar
  int seen = 0;
  for (bool more = true; more && seen == 0; more = session.next_step()) {
    const std::vector<const Ask*> asked = session.questions();
    if (asked.empty() || !picks_choice(asked.front()->type)) continue;
    draw();
    const std::vector<Page::Choice> choices = screen->page().page().choices;
    double line = 1e9;
    for (const Page::Choice& choice : choices) line = std::min(line, choice.box.height());
    for (const Page::Choice& choice : choices) {
      if (choice.box.y1 > kEnd || choice.box.height() < 1.7 * line) continue;
      const Image before = screen->read();
      session.answer(*choice.ask, std::string(1, letter_of_choice(choice.number)));
      session.end_play();
      draw();
      const Image marked = screen->read();
      const auto differs = [&](double y0, double y1) {
        int count = 0;
        for (int row = static_cast<int>(y0); row < static_cast<int>(y1); ++row)
          for (int at = 0; at < static_cast<int>(choice.box.x0) - 8; ++at)
            count += std::memcmp(marked.pixel(at, row), before.pixel(at, row), 4) != 0;
        return count;
      };
      const int upper = differs(choice.box.y0, choice.box.y0 + line),
                lower = differs(choice.box.y0 + line + 1, choice.box.y1);
      EXPECT_GT(upper, 100) << session.stage().id;
      EXPECT_LT(lower, upper / 10) << session.stage().id << ": no more than what is below the line of a g";
      ++seen;
      break;
    }
  }
  EXPECT_EQ(seen, 1);
}

// 2026-11-29: the notes said that every question holds the next stage back.
TEST_F(QuestionsPanelTest, WhatIsNoPredictionHoldsNothingBack) {
  LessonSession top(test::loaded_lesson("symmetric-top"));
  const auto& stages = top.lesson().stages;
  int ends = 0;
  for (std::size_t stage = 0; stage + 1 < stages.size(); ++stage) {
    const std::vector<const Ask*> asked = blocks_of<Ask>(stages[stage].steps.back());
    const bool predicts = std::any_of(asked.begin(), asked.end(),
                                      [](const Ask* ask) { return ask->type == Ask::Type::predict; });
    if (asked.empty() || predicts) continue;
    top.go_to({stage, stages[stage].steps.size() - 1});
    ASSERT_TRUE(screen->draw(top, {.size = kSize, .scale = 1, .seconds = 0.02}));
    screen->press(top, "Right");
    EXPECT_EQ(top.place(), (StepPlace{stage + 1, 0}));
    ++ends;
  }
  EXPECT_GT(ends, 0);
}

// 2026-11-29: the verdict pushed the button below it from under the hand.
TEST_F(QuestionsPanelTest, AVerdictMovesNoButtonThatChangesTheState) {
  const Ask& ask = go_to_question("apart");
  session.panel = Panel::question;
  ASSERT_TRUE(session.set_edits({.w0_B = Vec3(0.1, 0.1, 1)}));
  frame(4);
  /// The last row of frames that go from edge to edge of the panel.
  const auto end_of_buttons = [&] {
    frame(3);
    const Image image = screen->read();
    int last = 0;
    for (int row = 60; row < 744; ++row) {
      int of_border = 0;
      for (int at = 1000; at < 1200; ++at)
        of_border += std::memcmp(image.pixel(at, row), image.pixel(1000, row), 4) == 0 &&
                     std::memcmp(image.pixel(at, row), image.pixel(955, row), 4) != 0;
      if (of_border == 200) last = row;
    }
    return last;
  };
  const int before = end_of_buttons();
  ASSERT_GT(before, 300);
  ASSERT_EQ(session.answer(ask, "omega = [0.1, 0.1, 1.0]").mark, AnswerJudgement::Mark::wrong);
  EXPECT_EQ(end_of_buttons(), before);
}

// 2026-11-29: of an answer that was typed nothing was seen when one came back.
TEST_F(QuestionsPanelTest, WhatWasAnsweredRightIsMarkedOnThePageWhenOneComesBack) {
  for (const auto& [id, answer] : {std::pair("hold-steady", "w2*w3*(I3 - I2)"), std::pair("no-torque", "")}) {
    const Ask& ask = go_to_question(id);
    const StepPlace asked = session.place();
    frame(3);
    const Page& page = screen->page().page();
    ASSERT_EQ(page.choices.empty(), page.open_questions.size() == 1);
    const double x0 = page.choices.empty() ? page.open_questions.front().box.x0 : page.choices.front().box.x0;
    const Image before = screen->read();
    const auto differing = [&] {
      const Image now = screen->read();
      int count = 0;
      for (int row = 0; row < 700; ++row)
        for (int at = 0; at < static_cast<int>(x0) - 4; ++at)
          count += std::memcmp(now.pixel(at, row), before.pixel(at, row), 4) != 0;
      return count;
    };
    session.answer(
        ask, *answer ? answer
                     : std::string(1, letter_of_choice(static_cast<std::size_t>(ask.answers.front() - 1))));
    session.end_play();
    ASSERT_GT(session.record(ask)->right, 0) << id;
    session.go_to({0, 0});
    frame(2);
    session.go_to(asked);
    frame(3);
    EXPECT_GT(differing(), 20) << id << ": \"right\" stands there";
    session.set_presenting(true);
    frame(3);
    session.set_presenting(false);
    session.forget_answer(ask);
    frame(3);
    EXPECT_EQ(differing(), 0) << id;
  }
}

}  // namespace
}  // namespace polhode
