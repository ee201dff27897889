// SPDX-License-Identifier: MIT
// Of every line that a lesson proves, every slip of the pen is refused, unless it says the same.
#include "tests/oracle/mutants.h"

#include "lessons/claims/proof/proof.h"
#include "lessons/reader/reader.h"
#include "tests/oracle/oracle.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace polhode::oracle {
namespace {

struct Line {
  Equality equality;
  LawsAssumed assumption;
  Given given;
  bool measured;  ///< in a scene: it need not hold in every motion
};

std::vector<Line> proved_lines_of(const Lesson& lesson) {
  std::vector<Line> lines;
  for (const Stage& stage : lesson.stages)
    for (const Step& step : stage.steps)
      for (const Block& block : step.blocks) {
        const auto* claim = std::get_if<Claim>(&block);
        if (!claim || claim->kind == ClaimKind::is_false || claim->kind == ClaimKind::non_sequitur) continue;
        if (!claim->given.small.empty()) continue;  // to an order: tex_mutants_test.cpp has those
        for (const ClaimLine& line : claim->lines)
          if (is_provable(line.equality) && line.relation == Relation::equal && !line.conclusion)
            lines.push_back({line.equality, laws_assumed_by(claim->kind, claim->given), claim->given,
                             claim->kind == ClaimKind::measured});
      }
  return lines;
}

/// What textbooks say of symmetric, flat and heavy bodies: the lessons assume little.
std::string lesson_under_assumptions() {
  const auto claims = [](const std::string& kind, const std::string& lines) {
    static int number = 0;
    const std::string id = "e" + std::to_string(++number);
    return "```math " + id + "\nT\n```\n```claim " + id + ' ' + kind + '\n' + lines + "```\n";
  };
  return "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n[constants]\nmgl = { value = 2, unit = \"N m\" "
         "}\n[assume]\n"
         "symmetric = \"I2 = I1\"\nsphere = [\"I2 = I1\", \"I3 = I1\"]\nflat = \"I3 = I1 + I2\"\n"
         "steady = [\"w1 = 0\", \"w2 = 0\"]\nheavy = \"N = mgl*cross(ez, e3)\"\n+++\n# A {a}\n" +
         claims("free given symmetric",
                "I1*dw1 = (I1 - I3)*w2*w3\nI1*dw2 = (I3 - I1)*w1*w3\ndw3 = 0\n"
                "I1*ddt(e3) = cross(L, e3)\nddt(w1^2 + w2^2) = 0\n") +
         claims("identity given symmetric",
                "L = I1*omega + (I3 - I1)*w3*e3\n2*T = I1*(w1^2 + w2^2) + I3*w3^2\ndot(cross(L, omega), e3) "
                "= 0\n") +
         claims("identity given sphere", "L = I1*omega\nnorm2(L) = 2*I1*T\n") +
         claims("identity given flat", "2*T = I1*(w1^2 + w3^2) + I2*(w2^2 + w3^2)\n") +
         claims("identity given steady", "L = I3*omega\ncross(omega, L) = 0\n2*T = dot(omega, I3*omega)\n") +
         claims("motion given heavy", "ddt(T + mgl*dot(ez, e3)) = 0\nddt(dot(L, ez)) = 0\n") +
         claims("motion given symmetric heavy", "I3*dw3 = 0\nddt(dot(L, e3)) = 0\n");
}

std::vector<Line> proved_lines_of_all_lessons() {
  const LessonReading own = read_lesson(lesson_under_assumptions(), "a.md");
  EXPECT_TRUE(own.lesson) << own.diagnostics.front().message;
  std::vector<Line> lines = own.lesson ? proved_lines_of(*own.lesson) : std::vector<Line>();
  for (const auto& entry : std::filesystem::directory_iterator(test::source_dir() / "lessons")) {
    if (entry.path().extension() != ".md" || entry.path().filename() == "FORMAT.md") continue;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    const LessonReading reading = read_lesson(text.str(), entry.path().filename().string());
    EXPECT_TRUE(reading.lesson) << entry.path();
    if (!reading.lesson) continue;
    for (Line& line : proved_lines_of(*reading.lesson)) lines.push_back(std::move(line));
  }
  return lines;
}

struct Counts {
  int lines = 0, mutants = 0, refused = 0, equivalent = 0, undefined = 0, without_counterexample = 0,
      given = 0;
};

/// Holds the mutants of one line against the oracle; a side that is not changed is written out once.
class MutantCheck {
 public:
  void check(const Line& line) {
    const Oracle& oracle = oracle_of(line);
    const Oracle::Side left = oracle.side(line.equality.left), right = oracle.side(line.equality.right);
    const bool holds = oracle.compare(left, right) == Decision::same;
    EXPECT_TRUE(holds || line.measured) << line.equality.left.text << " = " << line.equality.right.text;
    if (!holds) return;
    ++counts.lines;
    for (const Expression& mutant : mutants_of(line.equality.left))
      if (fit(mutant.type(), line.equality.right.type()))
        settle({mutant, line.equality.right}, oracle.compare(oracle.side(mutant), right), line);
    for (const Expression& mutant : mutants_of(line.equality.right))
      if (fit(line.equality.left.type(), mutant.type()))
        settle({line.equality.left, mutant}, oracle.compare(left, oracle.side(mutant)), line);
  }
  int by_points() const {
    int sum = 0;
    for (const auto& [name, oracle] : oracles_) sum += oracle.by_points();
    return sum;
  }

  Counts counts;

 private:
  /// One for all lines that are given the same.
  const Oracle& oracle_of(const Line& line) {
    std::string name = std::to_string(static_cast<int>(line.assumption));
    for (const Setting& setting : line.given.settings) name += ';' + setting.text;
    return oracles_.try_emplace(name, line.assumption, line.given).first->second;
  }

  void settle(const Equality& mutant, Decision decision, const Line& line) {
    if (!is_provable(mutant)) return;  // lessons/reader/claim_lines.h refuses to read it
    const Verdict verdict = prover_.settle(mutant, line.assumption, line.given);
    const auto text = [&] { return mutant.left.text + " = " + mutant.right.text; };
    ++counts.mutants;
    counts.given += line.given.empty() ? 0 : 1;
    switch (decision) {
      case Decision::same:
        ++counts.equivalent;
        EXPECT_EQ(verdict, Verdict::holds) << "says the same, but is refused: " << text();
        break;
      case Decision::different:
        ++counts.refused;
        EXPECT_EQ(verdict, Verdict::fails) << "a slip that is not seen: " << text();
        if (!prover_.refute(mutant, line.assumption, line.given)) ++counts.without_counterexample;
        break;
      case Decision::undefined:
        ++counts.undefined;
        EXPECT_EQ(verdict, Verdict::undecided) << text();
    }
  }

  Prover prover_;
  std::map<std::string, Oracle> oracles_;
};

TEST(Mutants, OfEveryProvedLineAreRefusedUnlessTheySayTheSame) {
  MutantCheck check;
  for (const Line& line : proved_lines_of_all_lessons()) check.check(line);
  const Counts& c = check.counts;
  std::printf(
      "%d lines, %d mutants, %d of them under assumptions: %d differ, %d say the same, %d are nowhere "
      "defined; %d by points alone; "
      "%d without a counterexample in small whole numbers\n",
      c.lines, c.mutants, c.given, c.refused, c.equivalent, c.undefined, check.by_points(),
      c.without_counterexample);
  EXPECT_GE(c.mutants, 2000);
  EXPECT_GE(c.given, 100);
  EXPECT_GE(c.refused, 1500);
  EXPECT_GE(c.equivalent, 20) << "none refused for nothing";
  EXPECT_LE(100 * c.without_counterexample, c.refused);
}

}  // namespace
}  // namespace polhode::oracle
