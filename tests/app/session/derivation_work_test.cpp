// SPDX-License-Identifier: MIT
#include "app/session/derivation_work.h"

#include "tests/app/session/example_lesson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::HasSubstr;
using Mark = LineJudgement::Mark;

const Ask& derivation_of(const Lesson& lesson, const std::string& id) {
  for (const Stage& stage : lesson.stages)
    for (const Step& step : stage.steps)
      for (const Ask* ask : blocks_of<Ask>(step))
        if (ask->id == id) return *ask;
  throw std::runtime_error("no question " + id);
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

}  // namespace
}  // namespace polhode
