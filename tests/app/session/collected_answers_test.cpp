// SPDX-License-Identifier: MIT
#include "app/session/collected_answers.h"

#include "tests/app/session/quiz_lesson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using State = CollectedAnswer::State;

const Lesson& quiz() { return test::quiz()->lesson; }

AnswerReport report_of(const AnswerLog& answers, const std::string& name = "") {
  return *read_answer_report(*answer_report(quiz(), answers, name));
}

AnswerLog with(const std::string& question, const AnswerRecord& record) {
  AnswerLog answers = test::all_right();
  answers[question] = record;
  return answers;
}

TEST(CollectedAnswers, StandSideBySide) {
  CollectedAnswers collected(quiz());
  EXPECT_THAT(*collected.add("in/anna.txt", report_of(test::all_right(), "Anna")), IsEmpty());
  EXPECT_THAT(
      *collected.add("in/ben.txt", report_of(with("first/which", {0, 2, 1, "C", "", {{"choice-C", 2}}}))),
      IsEmpty());
  EXPECT_EQ(
      csv_of(collected),
      "student,file,right,answered,asked,first/sign,first/sign tries,first/sign hints,first/which,"
      "first/which tries,first/which hints,first/order,first/order tries,first/order hints,second/derive,"
      "second/derive tries,second/derive hints\n"
      "Anna,in/anna.txt,4,4,4,right,1,0,right,1,0,right,1,0,right,1,0\n"
      "ben,in/ben.txt,3,4,4,right,1,0,wrong,2,1,right,1,0,right,1,0\n");
}

TEST(CollectedAnswers, BelieveNobodyThatAnAnswerIsRight) {
  AnswerReport report = report_of(with("first/which", {0, 1, 0, "C", "", {}}));
  report.answers[1].right = true;
  CollectedAnswers collected(quiz());
  EXPECT_EQ(*collected.add("a.txt", report), "first/which is said to be right, and its answer is not");
  EXPECT_EQ(collected.students()[0].answers[1].state, State::wrong);
  report.answers[3].answer = "dL/dt = N";
  report.student = "B";
  EXPECT_THAT(*collected.add("b.txt", report), HasSubstr("second/derive is said to be right"));
}

TEST(CollectedAnswers, PassOverWhatIsOfAnotherLessonOrThereAlready) {
  CollectedAnswers collected(quiz());
  ASSERT_TRUE(collected.add("a.txt", report_of(test::all_right(), "Anna")));
  AnswerReport other = report_of({}, "Ben");
  other.lesson_id = "maze";
  EXPECT_EQ(collected.add("b.txt", other).error(), "a report of the lesson maze, not of quiz");
  other = report_of({}, "Ben");
  other.version = "0000000000000000";
  EXPECT_THAT(collected.add("b.txt", other).error(),
              HasSubstr("another version of the lesson: 0000000000000000"));
  other = report_of({}, "Ben");
  other.answers[0].name = "first/none";
  EXPECT_THAT(collected.add("b.txt", other).error(), HasSubstr("the lesson has no question first/none"));
  EXPECT_EQ(collected.add("b.txt", report_of({}, "Anna")).error(),
            "a second report of Anna, whose first is a.txt");
  EXPECT_EQ(collected.students().size(), 1u);
}

TEST(CollectedAnswers, TellOfReportsThatAreAlikeToTheLetter) {
  CollectedAnswers collected(quiz());
  ASSERT_TRUE(collected.add("a.txt", report_of(test::all_right())));
  EXPECT_THAT(*collected.add("b.txt", report_of(test::all_right())),
              HasSubstr("the same as a.txt, to the letter, and neither has a name"));
  EXPECT_EQ(collected.students().size(), 2u) << "two students may have answered alike";
}

TEST(CollectedAnswers, CountStudentsByTheReasonsOfTheirErrors) {
  CollectedAnswers collected(quiz());
  ASSERT_TRUE(
      collected.add("a", report_of(with("first/sign", {0, 3, 0, "w1", "", {{"sign", 2}, {"index", 1}}}))));
  ASSERT_TRUE(collected.add("b", report_of(with("first/sign", {0, 1, 0, "w2", "", {{"index", 1}}}))));
  ASSERT_TRUE(collected.add("c", report_of(test::all_right())));
  const auto reasons = reasons_of(collected, 0);
  ASSERT_EQ(reasons.size(), 2u);
  EXPECT_EQ(reasons[0].tag, "index");
  EXPECT_EQ(reasons[0].students, 2);
  EXPECT_EQ(reasons[1].students, 1) << "two tries of one student";
  EXPECT_EQ(csv_of_reasons(collected),
            "question,reason,in words,students,answered\n"
            "first/sign,index,an index is wrong,2,3\n"
            "first/sign,sign,the sign of a term is wrong,1,3\n");
}

TEST(CsvCell, IsATextWhateverAStudentIsCalled) {
  EXPECT_EQ(csv_cell("Anna"), "Anna");
  EXPECT_EQ(csv_cell("O'Neill, Zoë"), "\"O'Neill, Zoë\"");
  EXPECT_EQ(csv_cell("the \"great\""), "\"the \"\"great\"\"\"");
  EXPECT_EQ(csv_cell("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csv_cell(""), "");
  for (const char* formula : {"=1+1", "+1", "-1", "@SUM(A1)", "=cmd|' /C calc'!A0"})
    EXPECT_EQ(csv_cell(formula), std::string("'") + formula);
  EXPECT_EQ(csv_cell(" =1"), "' =1") << "blanks do not hide it";
  EXPECT_EQ(csv_cell("\t=1"), "\"'\t=1\"");
  EXPECT_EQ(csv_cell("=HYPERLINK(\"x\",\"y\")"), "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\"");
}

}  // namespace
}  // namespace polhode
