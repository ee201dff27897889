// SPDX-License-Identifier: MIT
#include "app/session/words/step_words.h"

#include "lessons/derivation/derivation.h"
#include "tests/app/session/example_lesson.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

using test::example;

// 2026-11-28: with two stages for a class it said "stage 18 of 29".
TEST(StepWords, CountTheStagesThatAreForAClass) {
  LessonSession session(example());
  EXPECT_EQ(stage_count(session), "stage 1 of 3");
  session.leave_out(session.lesson().stages[1].id, true);
  session.go_to({2, 0});
  EXPECT_EQ(stage_count(session), "stage 3 of 3") << "who does not present sees all";
  session.set_presenting(true);
  EXPECT_EQ(stage_count(session), "stage 2 of 2") << "as the page says, and as a number is typed";
  session.go_to({1, 0});
  EXPECT_EQ(stage_count(session), "stage 2 (not one of the 2 chosen)");
}

// 2026-11-28: it named the first stage of a lesson while all lessons were listed.
TEST(StepWords, TheWindowsTitleSaysWhereOneIs) {
  LessonSession session(example());
  const std::string stage = "A stage";
  EXPECT_EQ(window_title(session, stage).find("A stage — stage 1 of 3, step 1 of "), 0U)
      << window_title(session, stage);
  session.panel = Panel::lessons;
  EXPECT_EQ(window_title(session, stage), "Lessons — polhode");
}

TEST(StepWords, AreInTheLessonsLanguage) {
  const LessonSession session(test::loaded_lesson("intermediate-axis.de"));
  EXPECT_EQ(stage_count(session).find("Abschnitt 1 von "), 0U) << stage_count(session);
  EXPECT_EQ(step_count(session).find("Schritt 1 von "), 0U) << step_count(session);
}

// 2026-11-28: a step that derives had none to be copied.
TEST(StepWords, HaveTheFormulasOfADerivation) {
  const auto loaded = test::loaded_lesson("euler-equations");
  LessonSession session(loaded);
  for (std::size_t stage = 0; stage < loaded->lesson.stages.size(); ++stage)
    for (std::size_t step = 0; step < loaded->lesson.stages[stage].steps.size(); ++step)
      for (const Ask* one : blocks_of<Ask>(loaded->lesson.stages[stage].steps[step]))
        if (one->id == "derive-transport") session.go_to({stage, step});
  const Ask& ask = *session.questions().front();
  const std::string tex = tex_of_step(session);
  EXPECT_NE(tex.find(ask.derivation->start.tex + "\n"), std::string::npos) << tex;
  EXPECT_NE(tex.find(ask.derivation->goal.tex + "\n"), std::string::npos) << tex;
  session.go_to({0, 0});
  EXPECT_EQ(tex_of_step(session).find("\n\n"), std::string::npos);
}

}  // namespace
}  // namespace polhode
