// SPDX-License-Identifier: MIT
// From issue 20: no wrong factor reaches a goal, or is called right, in any lesson. Each part of each line of
// the lessons' own solutions, and of the answers that are expressions, is taken times 2 and -1, and each term
// is dropped.
#include "lessons/claims/expressions/expression_variants.h"
#include "lessons/derivation/answer_reasons.h"
#include "lessons/notation/typed/expression_typing.h"
#include "lessons/reader/questions/line_notation.h"
#include "tests/lessons/support.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace polhode {
namespace {

using Mark = LineJudgement::Mark;

/// With a number as a factor of one of its nodes.
Expression with_factor(const Expression& old, std::size_t node, int factor) {
  Expression made{old.text, {}, old.constants};
  std::vector<int> now(old.nodes.size());
  const auto push = [&](const ExpressionNode& n) {
    made.nodes.push_back(n);
    return static_cast<int>(made.nodes.size()) - 1;
  };
  for (std::size_t i = 0; i < old.nodes.size(); ++i) {
    ExpressionNode n = old.nodes[i];
    if (n.a >= 0) n.a = now[static_cast<std::size_t>(n.a)];
    if (n.b >= 0) n.b = now[static_cast<std::size_t>(n.b)];
    now[i] = push(n);
    if (i != node) continue;
    ExpressionNode product = old.nodes[i];
    if (factor == -1) {
      product.operation = Operation::negate;
      product.a = now[i];
      product.b = -1;
    } else {
      ExpressionNode number;
      number.number = {factor, 0, static_cast<double>(factor)};
      product.operation = Operation::multiply;
      product.a = push(number);
      product.b = now[i];
    }
    now[i] = push(product);
  }
  return made;
}

std::vector<Expression> mutants_of(const Expression& expression) {
  std::vector<Expression> all;
  for (std::size_t node = 0; node < expression.nodes.size(); ++node)
    for (const int factor : {2, -1}) all.push_back(with_factor(expression, node, factor));
  for (const int summand : summands_of(expression)) all.push_back(without_summand(expression, summand));
  return all;
}

std::string typed(const Expression& expression) {
  return typing_of(expression, static_cast<int>(expression.nodes.size()) - 1);
}

template <class Do>
void for_each_question(const Do& act) {
  for (const auto& path : testing::files_in(test::source_dir() / "lessons", ".md")) {
    if (path.filename() == "FORMAT.md") continue;
    const LessonReading read = read_lesson(testing::read_file(path), path.filename().string());
    ASSERT_TRUE(read.lesson) << path;
    for (const Stage& stage : read.lesson->stages)
      for (const Step& step : stage.steps)
        for (const Ask* ask : blocks_of<Ask>(step)) act(*read.lesson, *ask);
  }
}

bool is_zero(const Expression& side) { return side.type() == ExpressionType::zero; }

TEST(MutatedSolutions, NoLineWithAWrongFactorLeadsOn) {
  const Prover prover;
  int judged = 0, undecided = 0;
  for_each_question([&](const Lesson& lesson, const Ask& ask) {
    if (!ask.derivation) return;
    const Derivation& derivation = *ask.derivation;
    const LineNotation how = line_notation(lesson, ask);
    std::vector<DerivedLine> before;
    for (const WorkedLine& worked : derivation.worked) {
      const Equality& line = worked.line.whole;
      const auto expect_no_step = [&](const std::string& text, const Equality& meant) {
        // What is the same line, times a number on both sides, or with squares of signs, is none that is
        // wrong.
        if (canonical_form(meant) == canonical_form(line) || expanded_form(meant) == expanded_form(line))
          return;
        const LineJudgement judgement = judge_line(derivation, before, text, how, prover);
        ++judged;
        undecided += judgement.mark == Mark::away ? 1 : 0;
        EXPECT_TRUE(judgement.mark == Mark::wrong || judgement.mark == Mark::away ||
                    judgement.mark == Mark::unreadable)
            << ask.id << ": " << text << "  is called " << name_of(judgement.mark);
      };
      for (const Expression& left : mutants_of(line.left))
        if (!is_zero(line.right)) expect_no_step(typed(left) + " = " + typed(line.right), {left, line.right});
      for (const Expression& right : mutants_of(line.right))
        if (!is_zero(line.right)) expect_no_step(typed(line.left) + " = " + typed(right), {line.left, right});
      before.push_back(worked.line);
    }
  });
  std::printf("%d changed lines, %d of them true of no account\n", judged, undecided);
  EXPECT_GT(judged, 500);
}

TEST(MutatedSolutions, NoAnswerWithAWrongFactorIsRight) {
  const Prover prover;
  int judged = 0;
  for_each_question([&](const Lesson& lesson, const Ask& ask) {
    if (!ask.expression || is_zero(*ask.expression)) return;
    const LineNotation how = line_notation(lesson, ask);
    EXPECT_TRUE(is_right_answer(ask, typed(*ask.expression), prover, how)) << ask.id;
    for (const Expression& mutant : mutants_of(*ask.expression)) {
      if (prover.settle({mutant, *ask.expression}, LawsAssumed::identity) == Verdict::holds) continue;
      ++judged;
      EXPECT_FALSE(is_right_answer(ask, typed(mutant), prover, how)) << ask.id << ": " << typed(mutant);
    }
  });
  std::printf("%d changed answers\n", judged);
  EXPECT_GT(judged, 200);
}

// Without torque both sides of these are 0; what the learner may type to the end, and what not.
TEST(MutatedSolutions, WhatIsZeroOnBothSidesDecidesNoFactor) {
  for_each_question([&](const Lesson& lesson, const Ask& ask) {
    if (ask.id != "derive-length" && ask.id != "derive-energy") return;
    const LineNotation how = line_notation(lesson, ask);
    const Prover prover;
    const auto mark = [&](const std::string& line) {
      return judge_line(*ask.derivation, {}, line, how, prover).mark;
    };
    const bool is_energy = ask.id == "derive-energy";
    const std::string rate = is_energy ? "dT/dt = " : "d|L|^2/dt = ";
    const std::vector<std::string> right =
        is_energy ? std::vector<std::string>{"w1 w2 w3 (I2 - I3 + I3 - I1 + I1 - I2)",
                                             "I1 w1 w1' + w2 (I3 - I1) w3 w1 + w3 I3 w3'",
                                             "I2 w1 w2 w3 - I3 w1 w2 w3 + I3 w1 w2 w3 - I1 w1 w2 w3 + "
                                             "I1 w1 w2 w3 - I2 w1 w2 w3"}
                  : std::vector<std::string>{
                        "2 I1 w1 (I2 - I3) w2 w3 + 2 I2 w2 (I3 - I1) w3 w1 + "
                        "2 I3 w3 (I1 - I2) w1 w2",
                        "-2 w1 w2 w3 (I1 (I3 - I2) + I2 (I1 - I3) + I3 (I2 - I1))"};
    for (const std::string& side : right) EXPECT_EQ(mark(rate + side), Mark::holds) << side;
    const std::vector<std::string> wrong =
        is_energy ? std::vector<std::string>{"2 w1 w2 w3 (I2 - I3 + I3 - I1 + I1 - I2)",
                                             "1/2 (I1 w1 w1' + I2 w2 w2' + I3 w3 w3')", "3 dT/dt",
                                             "d(omega . (I omega))/dt",
                                             "(I3 - I2) w1 w2 w3 + (I1 - I3) w1 w2 w3 + (I2 - I1) w1 w2 w3"}
                  : std::vector<std::string>{"I1^2 w1 w1' + I2^2 w2 w2' + I3^2 w3 w3'",
                                             "w1 w2 w3 (I1 (I2 - I3) + I2 (I3 - I1) + I3 (I1 - I2))",
                                             "2 w1 w2 w3 (I1 (I3 - I2) + I2 (I1 - I3) + I3 (I2 - I1))"};
    for (const std::string& side : wrong) {
      const LineJudgement judgement = judge_line(*ask.derivation, {}, rate + side, how, prover);
      EXPECT_EQ(judgement.mark, Mark::away) << side;
      EXPECT_NE(judgement.reason.find("both sides are 0 here: this line does not decide the factor"),
                std::string::npos)
          << side << ": " << judgement.reason;
    }
    EXPECT_EQ(mark(rate + "0"), Mark::goal);
    EXPECT_NE(mark(rate + "1/2 d|L|^2/dt = 0"), Mark::goal);
  });
}

// A lesson whose own solution has such a line cannot be learnt from.
TEST(MutatedSolutions, ALessonsSolutionHasNoLineOfAnyFactor) {
  const auto said = [](const char* middle) {
    return testing::complaints_of(
        "```ask d\ntype = \"derive\"\nprompt = \"Go.\"\nmodulo = \"free\"\nstart = \"T = 1/2 omega . L\"\n"
        "goal = \"dT/dt = 0\"\nworked = [{ line = \"dT/dt = " +
        std::string(middle) + "\" }, { line = \"dT/dt = 0\" }]\n```\n");
  };
  EXPECT_EQ(said("omega . (I omega')"), std::vector<std::string>());
  const std::vector<std::string> wrong = said("1/2 omega . (I omega')");
  ASSERT_EQ(wrong.size(), 1u);
  EXPECT_NE(wrong[0].find("would hold with any factor"), std::string::npos) << wrong[0];
}

// 2026-11-26: of three derivations of the lecture the last line could not be typed, for the one before it was
// the goal.
TEST(MutatedSolutions, ALessonsSolutionEndsWhereItReachesItsGoal) {
  const auto said = [](const std::string& worked) {
    return testing::complaints_of(
        "```ask d\ntype = \"derive\"\nprompt = \"Go.\"\nstart = \"comp(omega x L, 3) = w1 L2 - w2 L1\"\n"
        "goal = \"comp(omega x L, 3) = (I2 - I1) w1 w2\"\nleast = 1\nworked = [" +
        worked + "]\n```\n");
  };
  const std::string expanded = "comp(omega x L, 3) = w1 I2 w2 - w2 I1 w1", factored = "(I2 - I1) w1 w2";
  EXPECT_EQ(said("{ line = \"" + expanded + " = " + factored + "\" }"), std::vector<std::string>());
  const std::vector<std::string> wrong =
      said("{ line = \"" + expanded + "\" }, { line = \"= " + factored + "\" }");
  ASSERT_EQ(wrong.size(), 1u);
  EXPECT_NE(wrong[0].find("is at its goal before its last line"), std::string::npos) << wrong[0];
  EXPECT_NE(wrong[0].find(expanded), std::string::npos) << wrong[0];
}

}  // namespace
}  // namespace polhode
