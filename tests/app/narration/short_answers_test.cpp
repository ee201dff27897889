// SPDX-License-Identifier: MIT
#include "app/narration/short_answers.h"

#include "lessons/reader/checks/lesson_check.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace polhode {
namespace {

Lesson lesson_of(const std::string& steps) {
  LessonReading reading = check_lesson(
      "+++\nformat = 1\nid = \"short\"\ntitle = \"Short\"\n[scene]\nbody = \"textbook\"\n"
      "omega = [0.9, 0.4, 1.0]\n+++\n# S {s}\n" +
          steps,
      "short.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  return std::move(*reading.lesson);
}

constexpr const char* kNumber =
    "```ask n\ntype = \"number\"\nprompt = \"How many?\"\nanswer = 12.5\nunit = \"J\"\nbecause = "
    "\"So.\"\n```\n";
constexpr const char* kChoice =
    "```ask c\ntype = \"predict\"\nprompt = \"Which?\"\nshuffle = false\nbecause = \"So.\"\n\n"
    "- [ ] this\n- [x] that\n- [ ] neither\n```\n";
constexpr const char* kExpression =
    "```ask e\ntype = \"expression\"\nprompt = \"What is twice the energy?\"\nanswer = \"dot(omega, "
    "L)\"\nbecause = \"So.\"\n```\n";

TEST(ShortAnswers, NameTheStepAndTheAnswerOfEachQuestion) {
  const Lesson lesson = lesson_of(std::string("Words.\n\n---\n\n") + kChoice + "\n---\n\nMore.\n" + kNumber +
                                  "\n---\n\n" + kExpression);
  EXPECT_EQ(short_answers(lesson, lesson.stages[0]),
            "step 2, B; step 3, 12.5 J; step 4, $\\vec\\omega\\cdot \\vec L$");
}

TEST(ShortAnswers, TellAStateAsAFormula) {
  const auto state = [](const std::string& solution) {
    return "```ask s\ntype = \"state\"\nprompt = \"Make it faster.\"\ngoals = [{ of = \"T\", at_least = 2, "
           "unit = \"J\" }]\nchange = [\"omega\", \"attitude\"]\nsolution = { " +
           solution + " }\nbecause = \"So.\"\n```\n";
  };
  const std::string words = "Words.\n\n```scene\nshow = [\"omega\"]\n```\n\n";
  const Lesson few = lesson_of(words + state("omega = [0.9, -1.25, 2]"));
  EXPECT_EQ(short_answers(few, few.stages[0]),
            "step 1, for example $\\vec\\omega = (0.9,\\ -1.25,\\ 2)\\,\\text{rad/s}$");
  const Lesson many = lesson_of(words + state("omega = [0.9123456, 0, 2]"));
  EXPECT_EQ(short_answers(many, many.stages[0]), "") << "nobody reads seven digits";
  const Lesson turned = lesson_of(words + state("omega = [0, 0, 2], attitude = [0, 1, 0, 0]"));
  EXPECT_EQ(short_answers(turned, turned.stages[0]), "");
}

TEST(ShortAnswers, AreNoneWhereNothingIsAsked) {
  const Lesson lesson = lesson_of("Words.\n");
  EXPECT_EQ(short_answers(lesson, lesson.stages[0]), "");
}

}  // namespace
}  // namespace polhode
