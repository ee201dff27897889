// SPDX-License-Identifier: MIT
#include "app/session/answers/derivation_work.h"

#include "app/session/answers/progress.h"
#include "app/session/lesson_session.h"
#include "tests/app/session/example_lesson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string_view>

namespace polhode {
namespace {

using ::testing::HasSubstr;
using Mark = LineJudgement::Mark;

const Ask& derivation_of(const Lesson& lesson, std::string_view id) {
  for (const Stage& stage : lesson.stages)
    for (const Step& step : stage.steps)
      for (const Ask* ask : blocks_of<Ask>(step))
        if (ask->id == id) return *ask;
  throw std::runtime_error("no question " + std::string(id));
}

// The lesson's own solutions lead to their goals, and so does the last hint at every step.
TEST(DerivationWork, EveryDerivationOfTheLessonsCanBeDoneByItsHints) {
  int derivations = 0;
  for (const char* id : test::kLessons) {
    const auto loaded = test::loaded_lesson(id);
    for (const Stage& stage : loaded->lesson.stages)
      for (const Step& step : stage.steps)
        for (const Ask* ask : blocks_of<Ask>(step)) {
          if (!ask->derivation) continue;
          SCOPED_TRACE(ask->id);
          ++derivations;
          DerivationWork work(loaded->lesson, *ask);
          for (std::size_t i = 0; !work.is_done() && i <= ask->derivation->worked.size(); ++i) {
            EXPECT_NE(work.hint(1), "");
            EXPECT_NE(work.hint(2), work.hint(1)) << "how is not what";
            const std::string told = work.hint(DerivationWork::kMostHints);
            ASSERT_TRUE(told.starts_with("Type: ")) << told;
            const Mark mark = work.add(told.substr(6)).mark;
            EXPECT_TRUE(mark == Mark::holds || mark == Mark::goal)
                << told << ": " << work.lines().back().judgement.reason;
          }
          EXPECT_TRUE(work.is_done());
        }
  }
  EXPECT_GE(derivations, 6);
}

// 2026-11-26: any true line counted.
TEST(DerivationWork, ALineBesideTheWayIsNotCounted) {
  const auto loaded = test::loaded_lesson("euler-equations");
  DerivationWork work(loaded->lesson, derivation_of(loaded->lesson, "derive-six"));
  EXPECT_EQ(work.add("omega . L = omega . (I omega)").mark, Mark::holds);
  EXPECT_EQ(work.add("I d*omega/dt + omega x (I omega) = N").mark, Mark::goal);
  EXPECT_TRUE(work.is_too_short());
  EXPECT_EQ(work.lines()[0].judgement.mark, Mark::away);
  EXPECT_THAT(work.lines()[0].judgement.reason, HasSubstr("does not lead to the goal"));
  work.add("d*L/dt + omega x L = N");
  EXPECT_EQ(work.lines()[0].judgement.mark, Mark::holds) << "it may be used yet";
  EXPECT_EQ(work.add("I d*omega/dt + omega x (I omega) = N").mark, Mark::goal);
  EXPECT_TRUE(work.is_done());
  EXPECT_EQ(work.count(), 2u);
}

TEST(DerivationWork, AWrongLineStaysUntilTheNext) {
  const auto loaded = test::loaded_lesson("euler-equations");
  DerivationWork work(loaded->lesson, derivation_of(loaded->lesson, "derive-six"));
  EXPECT_EQ(work.add("d*L/dt - omega x L = N").mark, Mark::wrong);
  EXPECT_EQ(work.count(), 0u);
  EXPECT_EQ(work.add("d*L/dt + omega x L = N").mark, Mark::holds);
  ASSERT_EQ(work.lines().size(), 1u);
  EXPECT_EQ(work.count(), 1u);
  EXPECT_EQ(work.add("d*L/dt + omega x L = N").mark, Mark::away);
  work.undo();
  EXPECT_EQ(work.lines().size(), 1u);
  EXPECT_EQ(work.add("= dL/dt").mark, Mark::holds) << "goes on from the line before";
}

TEST(DerivationWork, TheGoalAloneIsNoDerivation) {
  const auto loaded = test::loaded_lesson("euler-equations");
  DerivationWork work(loaded->lesson, derivation_of(loaded->lesson, "derive-energy"));
  EXPECT_EQ(work.add("dT/dt = 0").mark, Mark::goal);
  EXPECT_TRUE(work.is_too_short());
  EXPECT_FALSE(work.is_done());
  EXPECT_THAT(work.hint(1), HasSubstr("change")) << "of the first line, for there is none yet";
  EXPECT_EQ(work.add("T' = I1 w1 w1' + I2 w2 w2' + I3 w3 w3'").mark, Mark::holds);
  EXPECT_EQ(work.count(), 1u);
}

// The page says of it what the panel does: it is no goal that was reached.
TEST(LessonSession, AGoalWithoutAWayIsNotShownAsReached) {
  LessonSession session(test::loaded_lesson("euler-equations"));
  const Ask* ask = nullptr;
  for (const PlacedAsk& question : questions_of(session.lesson()))
    if (question.ask->id == "derive-energy")
      session.go_to({question.place.stage, question.place.step}), ask = question.ask;
  ASSERT_NE(ask, nullptr);
  session.derive(*ask, "dT/dt = 0");
  ASSERT_EQ(session.shown_derivation().lines.size(), 1u);
  EXPECT_EQ(session.shown_derivation().lines[0].certainty, Certainty::open);
  EXPECT_NE(session.shown_derivation().lines[0].word, name_of(LineJudgement::Mark::goal));
}

TEST(DerivationWork, WhatIsKeptIsReadAgain) {
  const auto loaded = test::loaded_lesson("euler-equations");
  const Ask& ask = derivation_of(loaded->lesson, "derive-six");
  DerivationWork work(loaded->lesson, ask);
  work.add("d*L/dt + omega x L = N");
  work.add("L = omega");
  DerivationWork again(loaded->lesson, ask);
  again.restore(work.text());
  EXPECT_EQ(again.count(), 1u);
  EXPECT_EQ(again.text(), "d*L/dt + omega x L = N");
  again.restore("nonsense\nL = I omega");
  EXPECT_TRUE(again.lines().empty()) << "of another lesson";
}

// What the page shows below the question: each line with its verdict, and the one that is being typed as it
// grows.
TEST(LessonSession, ADerivationIsShownAsItIsTyped) {
  LessonSession session(test::loaded_lesson("euler-equations"));
  const Ask* ask = nullptr;
  for (std::size_t stage = 0; ask == nullptr && stage < session.lesson().stages.size(); ++stage)
    for (std::size_t step = 0; ask == nullptr && step < session.lesson().stages[stage].steps.size(); ++step)
      for (const Ask* one : blocks_of<Ask>(session.lesson().stages[stage].steps[step]))
        if (one->id == "derive-six") session.go_to({stage, step}), ask = one;
  ASSERT_NE(ask, nullptr);
  EXPECT_EQ(session.shown_derivation(), ShownDerivation());
  session.derivation(*ask).type("d*L/dt + om");
  ASSERT_EQ(session.shown_derivation().lines.size(), 1u);
  EXPECT_EQ(session.shown_derivation().lines[0].word, "") << "it is not judged yet";
  session.derive(*ask, "d*L/dt - omega x L = N");
  session.derivation(*ask).type("");
  ASSERT_EQ(session.shown_derivation().lines.size(), 1u);
  EXPECT_EQ(session.shown_derivation().lines[0].certainty, Certainty::refuted);
  session.derive(*ask, "d*L/dt + omega x L = N");
  EXPECT_EQ(session.shown_derivation().lines[0].word, "holds");
  EXPECT_EQ(session.record(*ask)->last, "d*L/dt + omega x L = N");
  session.undo_derived_line(*ask);
  EXPECT_TRUE(session.shown_derivation().lines.empty());
  session.forget_answer(*ask);
  EXPECT_EQ(session.record(*ask), nullptr);
}

// 2026-11-28: it was gone from the page until Answer was opened.
TEST(DerivationWork, StandsOnThePageWhenOneComesBack) {
  const auto loaded = test::loaded_lesson("euler-equations");
  LessonSession session(loaded);
  const Ask* ask = nullptr;
  for (std::size_t stage = 0; stage < loaded->lesson.stages.size(); ++stage)
    for (std::size_t step = 0; step < loaded->lesson.stages[stage].steps.size(); ++step)
      for (const Ask* one : blocks_of<Ask>(loaded->lesson.stages[stage].steps[step]))
        if (one->id == "derive-six") session.go_to({stage, step}), ask = one;
  ASSERT_NE(ask, nullptr);
  session.derive(*ask, ask->derivation->worked.front().line.typed);
  const ShownDerivation shown = session.shown_derivation();
  ASSERT_EQ(shown.lines.size(), 1U);
  const StepPlace here = session.place();
  session.go_to({0, 0});
  EXPECT_EQ(session.shown_derivation(), ShownDerivation());
  session.go_to(here);
  EXPECT_EQ(session.shown_derivation(), shown);
  LessonSession another(loaded);
  another.set_answers(session.answers());
  another.go_to(here);
  EXPECT_EQ(another.shown_derivation(), shown);
}

}  // namespace
}  // namespace polhode
