// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/question_check.h"

#include "lessons/reader/checks/claim_check.h"
#include "lessons/reader/questions/number_question.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// What is said of the questions of a lesson that reads.
std::vector<std::string> said_of(const std::string& body) {
  LessonReading reading = read_lesson(testing::lesson_with(body), "lesson.md");
  EXPECT_TRUE(reading.lesson) << ::testing::PrintToString(testing::lines_of(reading.diagnostics));
  if (!reading.lesson) return {};
  compute_answers(*reading.lesson);
  return testing::lines_of(check_questions(*reading.lesson, "lesson.md"));
}

std::string fence(const std::string& id, const std::string& content) {
  return "```ask " + id + '\n' + content + "\n```\n";
}
const std::string kScene = "```scene\nomega = [0, 0, 2]\n```\n";

std::string asked_for_number(const std::string& keys, bool has_scene = true) {
  return (has_scene ? kScene : "") + fence("n", "type = 'number'\nprompt = 'How much?'\n" + keys);
}

TEST(QuestionCheck, NumbersHaveAValueThatIsNot0) {
  EXPECT_THAT(said_of(asked_for_number("answer = 'norm(omega)'\nunit = 'rad/s'")), IsEmpty());
  EXPECT_THAT(said_of(asked_for_number("answer = 12\nunit = 'kg'", false)), IsEmpty());
  EXPECT_THAT(said_of(asked_for_number("answer = 'norm(omega)'\nunit = 'rad/s'", false)),
              ElementsAre(HasSubstr("the answer of question \"n\" needs a scene")));
  EXPECT_THAT(said_of(asked_for_number("answer = '1/w1'\nunit = 's'")),
              ElementsAre(HasSubstr("has no value on the scene's motion at t = 0 s")));
  EXPECT_THAT(said_of(asked_for_number("answer = 'w1'\nunit = 'rad/s'")),
              ElementsAre(HasSubstr("is 0, and 0 is right too, within 2 %")));
  EXPECT_THAT(said_of(asked_for_number("answer = 'w3'\nunit = 'rad/s'\nwithin = '2 rad/s'")),
              ElementsAre(HasSubstr("is 2, and 0 is right too, within 2 rad/s")));
  EXPECT_THAT(said_of(asked_for_number("answer = 'w3'\nunit = 'rad/s'\nwithin = '0.5 rad/s'")),
              ElementsAre(HasSubstr("0.5 rad/s of tolerance decides nothing")));
}

std::string prediction(const std::string& plays) {
  return fence("p",
               "type = 'predict'\nprompt = 'What?'\nplays = " + plays + "\n- [x] this\n- [ ] that\n  No.");
}

TEST(QuestionCheck, PredictionsPlayWhatTheirStepShows) {
  EXPECT_THAT(said_of(kScene + prediction("[0, 1]")), IsEmpty());
  EXPECT_THAT(said_of("Text.\n" + prediction("[0, 1]")), ElementsAre(HasSubstr("its step has none")));
  EXPECT_THAT(said_of("```scene\nomega = [0, 0, 2]\nduration = 0.5\n```\n" + prediction("[0, 1]")),
              ElementsAre(HasSubstr("plays beyond the scene's duration, 0.5 s")));
  EXPECT_THAT(said_of("```scene\nomega = [0, 0, 2]\nrate = 0.01\n```\n" + prediction("[0, 1]")),
              ElementsAre(HasSubstr("warning: question \"p\" plays for 100 s")));
}

TEST(QuestionCheck, AWrongChoiceOfAListHasAReply) {
  const std::string keys = "type = 'choice'\nprompt = 'What?'\n";
  EXPECT_THAT(said_of(fence("c", keys + "- [x] this\n- [ ] that\n  No.")), IsEmpty());
  EXPECT_THAT(said_of(fence("c", keys + "- [x] this\n- [ ] that\n- [ ] those\n  No.")),
              ElementsAre(HasSubstr("9:1: warning: who picks \"that\" is not told why it is wrong")));
  EXPECT_THAT(said_of(fence("c", keys + "choices = ['this', 'that']\nanswer = 1")), IsEmpty())
      << "the older form has no place for one";
}

/// Questions with the right choice under these letters, the choices as long as they are given.
std::string lesson_of(const std::string& letters, const std::array<const char*, 3>& choices) {
  std::string body;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    std::string list;
    for (std::size_t k = 0; k < choices.size(); ++k)
      list +=
          (letters[i] == letter_of_choice(k) ? std::string("- [x] ") : "- [ ] ") + choices[k] + "\n  Why.\n";
    body += fence("q" + std::to_string(i), "type = 'choice'\nprompt = 'What?'\nshuffle = false\n" + list);
  }
  return body;
}

TEST(QuestionCheck, NoLetterIsRightTooOften) {
  const std::array<const char*, 3> equal = {"aaa", "bbb", "ccc"};
  EXPECT_THAT(said_of(lesson_of("ABCABC", equal)), IsEmpty());
  EXPECT_THAT(said_of(lesson_of("BBBBB", equal)), IsEmpty()) << "five are too few to tell";
  EXPECT_THAT(said_of(lesson_of("ABBCB", equal)), IsEmpty());
  EXPECT_THAT(
      said_of(lesson_of("ABBCBA", equal)),
      ElementsAre(HasSubstr("in 3 of 6 questions the right choice is B: sample/q1, sample/q2, sample/q4")));
  EXPECT_THAT(said_of(lesson_of("AABBCABBCC", equal)), IsEmpty()) << "4 of 10 are just not too many";
}

TEST(QuestionCheck, TheLongestChoiceIsNotRightTooOften) {
  const std::array<const char*, 3> first_is_long = {"aaaaa", "bb", "cc"};
  EXPECT_THAT(said_of(lesson_of("ABCABC", first_is_long)), IsEmpty()) << "2 of 6";
  const auto said = said_of(lesson_of("AAAABC", first_is_long));
  ASSERT_EQ(said.size(), 2U);
  EXPECT_THAT(said, ::testing::Contains(HasSubstr(
                        "in 4 of 6 questions the right choice is the longest: sample/q0, sample/q1")));
  EXPECT_THAT(said_of(lesson_of("AABBCC", {"aaa", "äää", "ccc"})), IsEmpty()) << "letters, and not bytes";
}

TEST(QuestionCheck, TheExamplesOfTheReferenceAreRight) {
  const std::string format = testing::read_file(test::source_dir() / "lessons/FORMAT.md");
  std::set<Ask::Type> types;
  std::string body = kScene;
  for (std::size_t at = format.find("\n```ask "); at != format.npos; at = format.find("\n```ask ", at + 1))
    body += format.substr(at + 1, format.find("\n```\n", at) + 5 - at - 1) + '\n';
  LessonReading reading = read_lesson(testing::lesson_with(body), "lesson.md");
  EXPECT_THAT(testing::lines_of(reading.diagnostics), IsEmpty()) << body;
  ASSERT_TRUE(reading.lesson);
  prove_claims(*reading.lesson);
  compute_answers(*reading.lesson);
  EXPECT_THAT(testing::lines_of(check_claims(*reading.lesson, "lesson.md")), IsEmpty());
  EXPECT_THAT(testing::lines_of(check_questions(*reading.lesson, "lesson.md")), IsEmpty());
  for (const Ask* ask : blocks_of<Ask>(reading.lesson->stages[0].steps[0])) types.insert(ask->type);
  for (const auto type : {Ask::Type::expression, Ask::Type::choice, Ask::Type::predict, Ask::Type::order,
                          Ask::Type::number, Ask::Type::derive, Ask::Type::state})
    EXPECT_TRUE(types.contains(type)) << static_cast<int>(type);
}

// A free symmetric body: w1 = w1(0) cos(λt), λ = (I3 − I1) ω3/I1.
TEST(ComputedAnswers, AreThoseOfTheStillInTheirUnit) {
  LessonReading reading = read_lesson(
      "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n[body.pencil]\nmoments = [1, 1, 0.3]\n[scene]\n"
      "body = \"pencil\"\n+++\n# S {s}\n```scene\nomega = [0.8, 0, 2]\nat = 0.25\n```\n" +
          fence("n", "type = 'number'\nprompt = 'p'\nanswer = 'w1'\nunit = 'deg/s'"),
      "a.md");
  ASSERT_TRUE(reading.lesson) << ::testing::PrintToString(testing::lines_of(reading.diagnostics));
  ASSERT_FALSE(compute_answers(*reading.lesson));
  const Ask& ask = *blocks_of<Ask>(reading.lesson->stages[0].steps[0]).front();
  ASSERT_TRUE(ask.number->value);
  const double right = 0.8 * std::cos((0.3 - 1) * 2 * 0.25) * 180 / std::numbers::pi;
  constexpr double kClosedForm = 1e-12;  // relative
  EXPECT_NEAR(*ask.number->value, right, kClosedForm * right);
}

TEST(CheckQuestions, ChoicesDiffer) {
  const std::string choice =
      "type = 'choice'\nprompt = 'Which?'\nshuffle = false\n\n- [x] one\n- [ ] two\n  No.\n";
  EXPECT_THAT(said_of(fence("c", choice)), IsEmpty());
  EXPECT_THAT(said_of(fence("c", choice + "- [ ] one\n  No.\n")),
              ElementsAre(HasSubstr("error: two choices are the same: \"one\"")));
}

TEST(CheckQuestions, APromptNamesTheUnitOfItsAnswer) {
  const auto said = [](const std::string& prompt, const std::string& unit) {
    return said_of(kScene + fence("n", "type = 'number'\nprompt = '" + prompt + "'\nanswer = 'T'\nunit = '" +
                                           unit + "'\n"));
  };
  for (const char* prompt : {"How large is the energy in kJ?", "How large is the energy in joules?"})
    EXPECT_THAT(said(prompt, "mJ"), ElementsAre(HasSubstr("and its unit is mJ"))) << prompt;
  for (const char* prompt :
       {"How large is the energy, in mJ?", "How much is in it?", "What is the energy in space?", "In kJ?"})
    EXPECT_THAT(said(prompt, "mJ"), IsEmpty()) << prompt;
}

}  // namespace
}  // namespace polhode
