// SPDX-License-Identifier: MIT
#include "app/session/answers/answer_keys.h"

#include "tests/app/session/example_lesson.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

using Mark = AnswerJudgement::Mark;

const Ask& question(const LessonSession& session) { return *session.questions().front(); }

TEST(AnswerKeys, LettersAndDigitsAnswerUntilItIsRight) {
  LessonSession session(test::example());
  EXPECT_FALSE(answer_by_key(session, "A")) << "nothing is asked here";
  session.next_step();
  for (const char* no : {"C", "3", "0", "Q", "Shift+A", "Enter", "", "a"})
    EXPECT_FALSE(answer_by_key(session, no)) << no;
  EXPECT_EQ(session.judged(question(session)), nullptr);
  EXPECT_TRUE(answer_by_key(session, "1"));
  EXPECT_EQ(session.judged(question(session))->judgement.choice, 1);
  EXPECT_TRUE(answer_by_key(session, "B"));
  EXPECT_EQ(session.judged(question(session))->judgement.mark, Mark::right);
  EXPECT_FALSE(answer_by_key(session, "B")) << "then a letter is a command again";
}

TEST(AnswerKeys, GoToTheFirstQuestionForAChoiceThatIsNotRightYet) {
  LessonSession session(test::loaded_text(
      "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n+++\n# S {s}\n"
      "```ask typed\ntype = 'expression'\nprompt = 'p'\nanswer = 'w1'\n```\n"
      "```ask first\ntype = 'choice'\nprompt = 'p'\nchoices = ['x', 'y']\nanswer = 1\n```\n"
      "```ask second\ntype = 'choice'\nprompt = 'p'\nchoices = ['x', 'y', 'z']\nanswer = 3\n```\n"));
  EXPECT_FALSE(answer_by_key(session, "C")) << "the first has two choices";
  EXPECT_TRUE(answer_by_key(session, "A"));
  ASSERT_NE(asked_by_letter(session), nullptr);
  EXPECT_EQ(asked_by_letter(session)->id, "second");
  EXPECT_TRUE(answer_by_key(session, "C"));
  EXPECT_EQ(asked_by_letter(session), nullptr);
}

}  // namespace
}  // namespace polhode
