// SPDX-License-Identifier: MIT
#include "app/session/answers/answer_report.h"

#include "tests/app/session/quiz_lesson.h"
#include "tests/lessons/peak_memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

namespace polhode {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const Lesson& quiz() { return test::quiz()->lesson; }

AnswerLog some_answers() {
  AnswerLog answers = test::all_right();
  answers["first/sign"] = {1, 3, 2, "w1", "w3*w1*(I1 - I3)", {{"sign", 1}, {"index", 2}}};
  answers["first/which"] = {0, 1, 0, "A", "", {{"choice-A", 1}}};
  answers.erase("first/order");
  return answers;
}

std::string report(const AnswerLog& answers, const std::string& name = "") {
  auto text = answer_report(quiz(), answers, name);
  EXPECT_TRUE(text) << text.error();
  return text ? *text : "";
}

TEST(AnswerReport, IsReadableByAPerson) {
  const std::string text = report(some_answers());
  EXPECT_THAT(text, StartsWith("Answers to a lesson of polhode, format 1\nLesson: quiz\nVersion: " +
                               version_of(quiz()) + "\nProgram: polhode "));
  EXPECT_THAT(text, HasSubstr("\nTitle: Quiz\nRight: 2 of 4 right, 3 answered\n"
                              "Outcome 1: 2 of 3 right, 3 answered: know the signs\n"));
  EXPECT_THAT(text, HasSubstr("\n\nfirst/sign: What is the y component?\n"
                              "  right, tries 3, hints 2\n"
                              "  answer: w3*w1*(I1 - I3)\n"
                              "  reasons: index 2, sign 1\n"));
  EXPECT_THAT(text, HasSubstr("\nfirst/order: In which order?\n  not answered, tries 0, hints 0\n"));
  EXPECT_THAT(text, HasSubstr("  answer: d*L/dt + omega x L = N\n  answer: I d*omega/dt"));
  EXPECT_THAT(text, HasSubstr("It is no signature"));
}

TEST(AnswerReport, SaysNothingOfWhoItIsUnlessThatWasTyped) {
  EXPECT_THAT(report(some_answers()), Not(HasSubstr("Name")));
  EXPECT_THAT(report(some_answers(), "  "), Not(HasSubstr("Name")));
  EXPECT_THAT(report(some_answers(), " Zoë O'Neill "), HasSubstr("\nName: Zoë O'Neill\n"));
  for (const char* no :
       {"two\nlines", "\x1b[1m", "a\tb", "\xff", "\u202Eright to left", "Ann\u200Ba", "\u00ADAnna"})
    EXPECT_FALSE(answer_report(quiz(), {}, no)) << no;
  EXPECT_FALSE(answer_report(quiz(), {}, std::string(101, 'x')));
}

TEST(AnswerReport, GivesBackWhatWasWritten) {
  const auto read = read_answer_report(report(some_answers(), "Zoë"));
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->lesson_id, "quiz");
  EXPECT_EQ(read->version, version_of(quiz()));
  EXPECT_EQ(read->student, "Zoë");
  ASSERT_EQ(read->answers.size(), 4u);
  EXPECT_EQ(read->answers[0],
            (ReportedAnswer{"first/sign", true, 3, 2, "w3*w1*(I1 - I3)", {{"index", 2}, {"sign", 1}}}));
  EXPECT_EQ(read->answers[1], (ReportedAnswer{"first/which", false, 1, 0, "A", {{"choice-A", 1}}}));
  EXPECT_EQ(read->answers[2], (ReportedAnswer{"first/order", false, 0, 0, "", {}}));
  EXPECT_EQ(read->answers[3], (ReportedAnswer{"second/derive", true, 1, 0, test::kDerived, {}}));
}

TEST(AnswerReport, OfEveryLessonIsRead) {
  for (const char* id : test::kLessons) {
    const Lesson& lesson = test::loaded_lesson(id)->lesson;
    const auto text = answer_report(lesson, {}, "A");
    ASSERT_TRUE(text);
    const auto read = read_answer_report(*text);
    ASSERT_TRUE(read) << id << ": " << read.error();
    EXPECT_GT(read->answers.size(), 10u);
  }
}

// An answer may be of a time when the lesson asked for something else.
TEST(AnswerReport, SaysRightOnlyOfWhatIs) {
  AnswerLog answers;
  answers["first/which"] = {1, 1, 0, "C", "C", {}};
  answers["first/sign"] = {1, 2, 0, "w9", "", {}};
  const auto read = read_answer_report(report(answers));
  ASSERT_TRUE(read) << read.error();
  for (const ReportedAnswer& answer : read->answers) EXPECT_FALSE(answer.right) << answer.name;
}

TEST(AnswerReport, HoldsAnythingThatAnOldLogHolds) {
  AnswerLog answers;
  answers["first/sign"] = {0,  1, 0, "\xff\x1b[1m\n\nChecksum: 0\nLesson: x\r\n  right, tries 1, hints 0",
                           "", {}};
  answers["first/which"] = {1, 1, 0, " B\t", " B\t", {}};
  answers["first/order"] = {0, 1, 0, " \n\t", "", {}};
  const auto read = read_answer_report(report(answers));
  ASSERT_TRUE(read) << read.error();
  EXPECT_TRUE(read->answers[1].right);
  EXPECT_FALSE(read->answers[0].right);
}

TEST(ReadAnswerReport, BearsWhatMailDoesToATextAndRefusesWhatElseChanges) {
  const std::string text = report(some_answers(), "A");
  std::string windows = "\xEF\xBB\xBF";
  for (const char c : text) windows += c == '\n' ? " \r\n" : std::string(1, c);
  EXPECT_TRUE(read_answer_report(windows)) << read_answer_report(windows).error();
  EXPECT_TRUE(read_answer_report("\n\n" + text + "\n-- \nSent from a phone\n"));
  std::string changed = text;
  changed[text.find("tries 3") + 6] = '2';
  EXPECT_EQ(read_answer_report(changed).error(), "the file was changed after it was saved");
  EXPECT_THAT(read_answer_report(text.substr(0, text.size() / 2)).error(),
              HasSubstr("the end of the file, with its checksum, is missing"));
  EXPECT_THAT(read_answer_report("Dear all").error(), HasSubstr("no report of polhode"));
  EXPECT_THAT(read_answer_report("").error(), HasSubstr("no report of polhode"));
  EXPECT_THAT(read_answer_report(text + text).error(), HasSubstr("a second report begins"));
  EXPECT_THAT(read_answer_report("Answers to a lesson of polhode, format 2\n").error(),
              HasSubstr("line 1: a report of another format"));
  EXPECT_THAT(read_answer_report(text + std::string(kMaxReportBytes, ' ')).error(), HasSubstr("1 MiB"));
}

TEST(ReadAnswerReport, IsQuickAndSmallWhateverItIsGiven) {
  if (testing::kSanitized) GTEST_SKIP() << "its own time and memory would be measured";
  const std::string small = report(some_answers(), "A");
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(read_answer_report(small));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(10));
  const std::string head =
      "Answers to a lesson of polhode, format 1\nLesson: quiz\nVersion: 0123456789abcdef\n";
  for (const std::string& part :
       {std::string("\n"), std::string("a/b: c\n"), std::string("  answer: x\n"),
        std::string("Answers to a lesson of polhode, format 1\n"), std::string("x")}) {
    std::string hostile = head;
    while (hostile.size() + part.size() < kMaxReportBytes - 64) hostile += part;
    hostile += "\nChecksum: 0123456789abcdef\n";
    const long kilobytes =
        testing::peak_kilobytes([&] { return std::size_t{read_answer_report(hostile) ? 1U : 0U}; });
    EXPECT_LT(kilobytes, 16 * 1024) << part;
  }
}

}  // namespace
}  // namespace polhode
