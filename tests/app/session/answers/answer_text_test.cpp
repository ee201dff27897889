// SPDX-License-Identifier: MIT
#include "app/session/answers/answer_text.h"

#include "app/session/lesson_session.h"
#include "lessons/claims/expressions/expression_variants.h"
#include "tests/app/session/example_lesson.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

/// Formulas between dollars, blocks on lines.
std::string written(const RichText& text) {
  std::string all;
  for (const TextBlock& block : text) {
    if (!all.empty()) all += '\n';
    for (const TextSpan& span : block.spans) {
      const char* const mark = span.kind == TextSpan::Kind::math ? "$" : span.code ? "`" : "";
      all += mark + span.text + mark;
    }
  }
  return all;
}

const Ask& asked(const Lesson& lesson, std::string_view id) {
  for (const Stage& stage : lesson.stages)
    for (const Step& step : stage.steps)
      for (const Ask* ask : blocks_of<Ask>(step))
        if (ask->id == id) return *ask;
  throw std::runtime_error("no such question");
}

TEST(AnswerText, LinesHaveTheirFormulas) {
  EXPECT_EQ(written(line_text("use $\\vec A = \\vec L$ there")), "use $\\vec A = \\vec L$ there");
  EXPECT_EQ(written(line_text("5 $ each")), "5 $ each") << "one dollar opens nothing";
  EXPECT_EQ(written(line_text("what $\\nosuch$ is")), "what \\nosuch is");
  EXPECT_EQ(written(opened_by("From  ", formula_text("a = b"))), "From  $a = b$");
  EXPECT_EQ(written(in_a_row(words_text("a"), words_text("b"))), "ab");
}

TEST(AnswerText, AnswersAreFormulasChoicesAndNumbers) {
  const Lesson& lesson = test::loaded_lesson("euler-equations")->lesson;
  const auto first_line = [](const std::string& text) { return text.substr(0, text.find('\n')); };
  const std::string formula = written(answer_text(lesson, asked(lesson, "hold-steady")));
  EXPECT_EQ(first_line(formula), "$\\omega_2\\,\\omega_3\\,(I_3 - I_2)$, typed `w2*w3*(I3 - I2)`.");
  EXPECT_NE(formula.find("Without it $\\omega_1$ would change"), formula.npos) << formula;
  EXPECT_EQ(first_line(written(answer_text(lesson, asked(lesson, "apart")))),
            "$\\vec\\omega = (1.15,\\ 0,\\ 0.34)\\,\\text{rad/s}$.");
  const Ask& choice = asked(lesson, "no-torque");
  const auto right = static_cast<std::size_t>(choice.answers.front() - 1);
  EXPECT_EQ(written(answer_text(lesson, choice)).substr(0, 6),
            std::string(1, letter_of_choice(right)) + ": It ");
}

// 2026-11-29: who came back to a question did not see what had been answered.
TEST(AnswerText, WhatWasRightIsSetAsItWasGiven) {
  const Lesson& lesson = test::loaded_lesson("euler-equations")->lesson;
  const auto told = [&](std::string_view id, const std::string& accepted) {
    return written(accepted_text(lesson, asked(lesson, id), accepted));
  };
  EXPECT_EQ(told("hold-steady", "(I3-I2) w2 w3"),
            "$\\left(I_{3} - I_{2}\\right)\\,\\omega_{2}\\,\\omega_{3}$");
  EXPECT_EQ(told("apart", "omega = [1.15, 0, 0.34]"),
            "$\\vec\\omega = (1.15,\\ 0,\\ 0.34)\\,\\text{rad/s}$.");
  for (const char* second : {"B", "b", "2"})
    EXPECT_EQ(told("no-torque", second).substr(0, 3), "B: ") << second;
  EXPECT_EQ(told("no-torque", ""), "");
  EXPECT_FALSE(choice_named(asked(lesson, "no-torque"), "Z"));
  EXPECT_FALSE(choice_named(asked(lesson, "hold-steady"), "A")) << "it has no choices";
}

// 2026-11-29: beside a question without rates stood how one writes them, which it refuses.
TEST(AnswerText, HowToTypeOffersNothingThatTheQuestionRefuses) {
  int without_rates = 0, with_letters = 0;
  for (const char* id : test::kLessons) {
    const Lesson& lesson = test::loaded_lesson(id)->lesson;
    for (const Stage& stage : lesson.stages)
      for (const Step& step : stage.steps)
        for (const Ask* ask : blocks_of<Ask>(step)) {
          if (!ask->expression) continue;
          const std::string how = how_to_type(*ask);
          EXPECT_NE(how.find("+ - * / ^"), how.npos) << how;
          const auto& nodes = ask->expression->nodes;
          const bool takes_rates = std::any_of(nodes.begin(), nodes.end(), is_rate);
          EXPECT_EQ(how.find("w1'") != how.npos && !takes_rates, false) << id << ' ' << ask->id;
          without_rates += !takes_rates;
          with_letters += !ask->letters.empty();
          const bool takes_torque =
              ask->letters.empty() ||
              std::find(ask->letters.begin(), ask->letters.end(), "N") != ask->letters.end();
          EXPECT_EQ(how.find("N1 N2 N3") != how.npos, takes_torque) << id << ' ' << ask->id;
        }
  }
  EXPECT_GT(without_rates, 3);
  EXPECT_GT(with_letters, 0);
}

TEST(AnswerText, WhatIsSaidOfAPickIsItsReplyAndWhyItIsRight) {
  const Lesson& lesson = test::loaded_lesson("euler-equations")->lesson;
  const Ask& ask = asked(lesson, "no-torque");
  for (std::size_t i = 0; i < ask.choices.size(); ++i) {
    const bool is_right = static_cast<int>(i) + 1 == ask.answers.front();
    AnswerJudgement judgement;
    judgement.mark = is_right ? AnswerJudgement::Mark::right : AnswerJudgement::Mark::wrong;
    judgement.choice = static_cast<int>(i) + 1;
    EXPECT_EQ(written(text_after(ask, judgement)), written(is_right ? ask.because : ask.replies[i]));
  }
}

// 2026-11-28: "Nicht richtig: too large."
TEST(AnswerText, AVerdictIsInOneLanguage) {
  const Lesson& lesson = test::loaded_lesson("intermediate-axis.de")->lesson;
  const Ask& number = asked(lesson, "grown-error");
  ASSERT_TRUE(number.number);
  const auto told = [&](std::string_view text) {
    return told_verdict(number, text, judge_answer(number, text, Prover()), Language::de);
  };
  EXPECT_EQ(told("1000 s").verdict, "Nicht richtig: zu groß.");
  EXPECT_EQ(
      told("3 kg").verdict,
      "Nicht richtig: die Einheit ist von anderer Art: gefragt ist eine Antwort in s, und dies ist in kg.");
  EXPECT_EQ(told("viel").verdict, "Nicht lesbar: das ist keine Zahl.");
  EXPECT_EQ(told("viel").hint, "etwa 4,2 oder -0,3 oder 1,2e3 schreiben");
  EXPECT_EQ(told_verdict(number, "1000 s", judge_answer(number, "1000 s", Prover()), Language::en).verdict,
            "Not right: too large.");
  const Ask& expression = asked(lesson, "middle-sign");
  AnswerJudgement judged;
  judged.reason = "wrong sign: every sign is the other way round";
  judged.tag = "signs";
  EXPECT_EQ(told_verdict(expression, "x", judged, Language::de).verdict,
            "Nicht richtig: alle Vorzeichen sind umgekehrt.");
  judged.tag = "other";
  EXPECT_EQ(told_verdict(expression, "x", judged, Language::de).verdict, "Nicht richtig.");
}

TEST(AnswerText, AnswersAreInTheLanguageOfTheLesson) {
  const Lesson& lesson = test::loaded_lesson("intermediate-axis.de")->lesson;
  EXPECT_NE(written(answer_text(lesson, asked(lesson, "middle-sign"))).find(", eingegeben `"),
            std::string::npos);
  EXPECT_NE(written(answer_text(lesson, asked(lesson, "grown-error"))).find(','), std::string::npos);
}

// 2026-11-28: "Given, at t = 0" had the ω that the reader had dragged.
TEST(AnswerText, WhatIsGivenIsTheLessons) {
  LessonSession session(
      test::loaded_text("+++\nformat = 1\nid = \"given\"\ntitle = \"Given\"\n+++\n# When {when}\nText.\n\n"
                        "```scene\nomega = [0.3, 3, 0]\nshow = [\"omega\"]\n```\n"
                        "```ask b\ntype = \"state\"\nprompt = \"When?\"\n"
                        "goals = [{ of = \"w2\", at_most = 0, unit = \"rad/s\" }]\nchange = [\"t\"]\n"
                        "solution = { t = 3 }\n```\n"));
  ASSERT_TRUE(session.set_edits({.w0_B = Vec3(1, 2, 3)}));
  const std::string given = written(given_text(*session.questions().front()->task, Language::en));
  EXPECT_EQ(given.find("Given, at $t = 0$: $\\vec\\omega = (0.3,\\ 3,\\ 0)"), 0u) << given;
}

}  // namespace
}  // namespace polhode
