// SPDX-License-Identifier: MIT
#include "app/session/answers/collected_answers.h"

#include "tests/app/session/quiz_lesson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

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
  EXPECT_EQ(csv_of(collected),
            "student,file,right,answered,asked,first/sign,first/sign tries as reported,first/sign hints as "
            "reported,first/which,"
            "first/which tries as reported,first/which hints as reported,first/order,first/order tries as "
            "reported,first/order hints as reported,second/derive,"
            "second/derive tries as reported,second/derive hints as reported\n"
            "Anna,in/anna.txt,4,4,4,right,1,0,right,1,0,right,1,0,right,1,0\n"
            "ben,in/ben.txt,3,4,4,right,1,0,wrong,2,1,right,1,0,right,1,0\n");
}

TEST(CollectedAnswers, BelieveNobodyThatAnAnswerIsRight) {
  AnswerReport report = report_of(with("first/which", {0, 1, 0, "C", "", {}}));
  report.answers[1].right = true;
  CollectedAnswers collected(quiz());
  EXPECT_EQ(*collected.add("a.txt", report), "first/which is said to be right, and its answer is not");
  EXPECT_EQ(collected.students()[0].answers[1].state, State::wrong);
  EXPECT_TRUE(collected.has_false_rights());
  report.answers[3].answer = "dL/dt = N";
  report.student = "B";
  EXPECT_THAT(*collected.add("b.txt", report), HasSubstr("second/derive is said to be right"));
}

// What stands at the head for people is computed from the answers, and nothing else is believed.
TEST(CollectedAnswers, BelieveNoHeadAndNoNumbersThatCannotBe) {
  const auto told = [](AnswerReport report) {
    CollectedAnswers collected(quiz());
    const auto added = collected.add("a.txt", report);
    EXPECT_EQ(collected.has_false_rights(), added && !added->empty());
    return added ? *added : "skipped";
  };
  const AnswerReport whole = report_of(with("first/which", {0, 2, 1, "C", "", {{"choice-C", 2}}}), "Anna");
  EXPECT_EQ(told(whole), "");
  AnswerReport changed = whole;
  changed.head.replace(changed.head.find("3 of 4"), 6, "4 of 4");
  EXPECT_THAT(told(changed), HasSubstr("its first lines say otherwise than its answers"));
  changed = whole;
  changed.answers[1].hints = 900;
  EXPECT_THAT(told(changed), HasSubstr("first/which: 900 hints"));
  changed = whole;
  changed.answers[1].reasons = {{"choice-C", 7}};
  EXPECT_THAT(told(changed), HasSubstr("first/which: 7 reasons of 2 wrong tries"));
  changed.answers[1].reasons = {{"choice-B", 1}};
  EXPECT_THAT(told(changed), HasSubstr("there is no reason \"choice-B\"")) << "that is the right one";
  changed.answers[1].reasons = {{"sign", 1}};
  EXPECT_THAT(told(changed), HasSubstr("there is no reason \"sign\"")) << "of a choice";
}

TEST(CollectedAnswers, JudgeAgainWhyAnAnswerIsWrong) {
  AnswerReport report = report_of(with("first/sign", {0, 1, 0, "w3*w1*(I3 - I1)", "", {{"other", 1}}}), "B");
  CollectedAnswers collected(quiz());
  ASSERT_TRUE(collected.add("b.txt", report));
  EXPECT_TRUE(collected.students()[0].answers[0].reasons.contains("signs"));
}

TEST(CollectedAnswers, SkipWhatIsOfAnotherLesson) {
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
  EXPECT_EQ(collected.students().size(), 1u);
}

FileTime at_s(int seconds) { return FileTime() + std::chrono::seconds(seconds); }

TEST(CollectedAnswers, TakeTheNewestReportOfAStudent) {
  CollectedAnswers collected(quiz());
  ASSERT_TRUE(collected.add("a.txt", report_of({}, "Anna"), at_s(10)));
  ASSERT_TRUE(collected.add("b.txt", report_of({}, "Ben"), at_s(10)));
  EXPECT_EQ(*collected.add("a2.txt", report_of(test::all_right(), "Anna"), at_s(20)),
            "the newest report of Anna: a.txt is skipped");
  EXPECT_EQ(collected.add("a3.txt", report_of({}, "Anna"), at_s(15)).error(),
            "an older report of Anna than a2.txt");
  ASSERT_EQ(collected.students().size(), 2u);
  EXPECT_EQ(collected.students()[0].file, "a2.txt");
  EXPECT_EQ(collected.students()[0].count(State::right), 4);
  EXPECT_THAT(*collected.add("a4.txt", report_of({}, "Anna"), at_s(20)), HasSubstr("a2.txt is skipped"))
      << "of two as old the later one counts";
}

TEST(CollectedAnswers, KnowAStudentHoweverTheNameIsSpelled) {
  CollectedAnswers collected(quiz());
  ASSERT_TRUE(collected.add("1", report_of({}, "Zoë O'Neill")));
  AnswerReport report = report_of({}, "x");
  for (const char* same : {"Zoe\u0308 O'Neill", "Zoë  O'Neill", " Zoë\u00A0O'Neill\u3000"}) {
    report.student = same;
    EXPECT_THAT(*collected.add("2", report), HasSubstr("is skipped")) << same;
  }
  for (const char* other : {"Zoe O'Neill", "ZoëO'Neill"}) {
    report.student = other;
    EXPECT_THAT(*collected.add("3", report), IsEmpty()) << other;
  }
  EXPECT_EQ(collected.students().size(), 3u);
}

TEST(CollectedAnswers, KnowLettersOfOtherScriptsThatLookLikeLatinOnes) {
  CollectedAnswers collected(quiz());
  ASSERT_TRUE(collected.add("a.txt", report_of(test::all_right(), "Anna Ilves")));
  for (const char* same : {"\u0410nna Ilves", "Ann\u0430 llves", "\uFF21nna Ilves"}) {
    ASSERT_TRUE(collected.add("b.txt", report_of(test::all_right(), same), FileTime::max())) << same;
    EXPECT_EQ(collected.students().size(), 1u) << same;
  }
}

TEST(CollectedAnswers, AFileWithoutANameIsInNobodysWay) {
  for (const bool is_named_first : {true, false}) {
    CollectedAnswers collected(quiz());
    const auto add_named = [&] { EXPECT_THAT(*collected.add("b.txt", report_of({}, "Bella")), IsEmpty()); };
    if (is_named_first) add_named();
    EXPECT_THAT(*collected.add("in/Bella.txt", report_of(test::all_right())), IsEmpty());
    if (!is_named_first) add_named();
    std::vector<std::string> names;
    for (const CollectedStudent& student : collected.students()) names.push_back(student.name);
    EXPECT_THAT(names, ::testing::UnorderedElementsAre("Bella", "in/Bella.txt"));
  }
}

TEST(CollectedAnswers, LeaveOutReasonsThatDoNotExist) {
  AnswerReport report = report_of(with("first/which", {0, 4, 0, "C", "", {{"choice-C", 4}}}));
  report.answers[1].reasons = {{"choice-C", 4}, {"choice-D", 1}, {"bogus", 2}};
  CollectedAnswers collected(quiz());
  EXPECT_EQ(*collected.add("a.txt", report),
            "first/which: there is no reason \"bogus\"; it is left out; first/which: there is no reason "
            "\"choice-D\"; it is left out");
  ASSERT_EQ(reasons_of(collected, 1).size(), 1u);
  EXPECT_EQ(reasons_of(collected, 1)[0].tag, "choice-C");
}

TEST(CollectedAnswers, AreOneRowEachWhateverAFileIsCalled) {
  CollectedAnswers collected(quiz());
  ASSERT_TRUE(collected.add("x\n=1+1.txt", report_of(test::all_right())));
  const std::string csv = csv_of(collected);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2) << csv;
  EXPECT_EQ(collected.students()[0].name, "x\\u000a=1+1");
}

TEST(CollectedAnswers, CountWhatIsNotAnswered) {
  CollectedAnswers collected(quiz());
  ASSERT_TRUE(collected.add("a.txt", report_of({}, "Anna")));
  EXPECT_THAT(csv_of(collected), HasSubstr("Anna,a.txt,0,0,4,not answered,,,not answered,,,"));
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
  for (const char* hidden :
       {"\u00A0=1", "\u200B=1", "\uFEFF=1", "\u3000+1", "\u2060@x", "＝1", "＋1", "－1", "＠x"})
    EXPECT_EQ(csv_cell(hidden), std::string("'") + hidden);
  EXPECT_EQ(csv_cell("\t=1"), "\"'\t=1\"");
  EXPECT_EQ(csv_cell("=HYPERLINK(\"x\",\"y\")"), "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\"");
}

}  // namespace
}  // namespace polhode
