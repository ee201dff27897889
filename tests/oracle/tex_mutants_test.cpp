// SPDX-License-Identifier: MIT
// Slips of the pen in the TeX of what the lessons prove: each is refused, or it is read as something of which
// GiNaC says the same as the proof.
#include "lessons/claims/proof/proof.h"
#include "lessons/reader/reader.h"
#include "render/typeset/math/math.h"
#include "tests/oracle/oracle.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <sstream>

namespace polhode::oracle {
namespace {

/// Commands, and single characters with the blanks behind them.
std::vector<std::string> tokens_of(const std::string& tex) {
  std::vector<std::string> tokens;
  for (std::size_t at = 0; at < tex.size();) {
    std::size_t end = at + 1;
    if (tex[at] == '\\') {
      while (end < tex.size() && std::isalpha(static_cast<unsigned char>(tex[end]))) ++end;
      if (end == at + 1) ++end;
    }
    while (end < tex.size() && (tex[end] == ' ' || tex[end] == '\n')) ++end;
    end = std::min(end, tex.size());
    tokens.push_back(tex.substr(at, end - at));
    at = end;
  }
  return tokens;
}

/// What may be written in place of a token by mistake; "" leaves it out.
std::vector<std::string> slips_of(const std::string& token) {
  static const std::map<std::string, std::vector<std::string>> kSlips = {{"1", {"2", "3"}},
                                                                         {"2", {"3", "1"}},
                                                                         {"3", {"1", "2"}},
                                                                         {"+", {"-"}},
                                                                         {"-", {"+", ""}},
                                                                         {"\\cdot", {"\\times", ""}},
                                                                         {"\\times", {"\\cdot"}},
                                                                         {"\\omega", {"L", "N"}},
                                                                         {"L", {"\\omega", "N"}},
                                                                         {"N", {"L", "F"}},
                                                                         {"\\dot", {"", "\\ddot"}},
                                                                         {"\\vec", {""}},
                                                                         {"d", {"d^*", ""}},
                                                                         {"*", {"2"}},
                                                                         {"T", {"m", "N"}},
                                                                         {"I", {"L", "1"}},
                                                                         {"\\mathbf", {"", "\\vec"}},
                                                                         {"(", {""}},
                                                                         {"^", {"_"}},
                                                                         {"_", {"^"}},
                                                                         {"=", {"+", "\\le"}},
                                                                         {"x", {"y", "z"}},
                                                                         {"y", {"z", "x"}},
                                                                         {"z", {"x", "y"}},
                                                                         {"0", {"1", "\\vec N"}},
                                                                         {"\\frac", {""}},
                                                                         {"\\hat", {"\\vec"}}};
  std::string word = token;
  while (!word.empty() && (word.back() == ' ' || word.back() == '\n')) word.pop_back();
  const auto found = kSlips.find(word);
  if (found == kSlips.end()) return {};
  std::vector<std::string> slips = found->second;
  for (std::string& slip : slips)
    if (!slip.empty()) slip += ' ';
  return slips;
}

std::vector<std::string> mutants_of_tex(const std::string& tex) {
  const std::vector<std::string> tokens = tokens_of(tex);
  std::vector<std::string> mutants;
  const auto joined = [&](std::size_t at, const std::string& other) {
    std::string text;
    for (std::size_t i = 0; i < tokens.size(); ++i) text += i == at ? other : tokens[i];
    return text;
  };
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    for (const std::string& slip : slips_of(tokens[i])) mutants.push_back(joined(i, slip));
    if (i + 1 < tokens.size() && tokens[i] != tokens[i + 1]) {
      std::vector<std::string> swapped = tokens;
      std::swap(swapped[i], swapped[i + 1]);
      std::string text;
      for (const std::string& token : swapped) text += token;
      mutants.push_back(text);
    }
  }
  return mutants;
}

/// A lesson that declares nothing but the vectors' names.
std::string test_lesson() {
  return "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n+++\n# Sample {sample}\nText.\n";
}

class TexMutants : public ::testing::Test {
 protected:
  void check(const std::string& tex, const Claim& claim, const Lesson& lesson) {
    if (!texts_.insert(tex + std::string(name_of(claim.kind))).second) return;
    ++mutants_;
    const auto math = parse_math(tex, lesson.macros);
    const auto read = math ? std::optional(read_equation(*math, lesson.notation)) : std::nullopt;
    if (!read || !*read || (**read).without_torque || (**read).has_condition != has_condition_) {
      ++refused_;
      return;
    }
    const auto lines = claim_lines_of(**read, claim.kind, [](SourceSpan) { return SourcePlace{1, 1}; });
    if (!lines) {
      ++refused_;
      return;
    }
    const LawsAssumed assumption = laws_assumed_by(claim.kind, claim.given);
    for (const ClaimLine& line : *lines) {
      if (line.conclusion || line.relation != Relation::equal) continue;
      const Equality& sides = line.equality;
      if (sides.left.nodes.size() + sides.right.nodes.size() > kLargestSides) continue;
      const Decision theirs = oracle(assumption, claim.given).compare(with_lengths_squared(sides));
      const Verdict ours = prover_.settle(sides, assumption, claim.given);
      const Verdict wanted = theirs == Decision::same        ? Verdict::holds
                             : theirs == Decision::different ? Verdict::fails
                                                             : Verdict::undecided;
      ++lines_[static_cast<std::size_t>(theirs)];
      EXPECT_EQ(ours, wanted) << tex << " is read as " << sides.left.text << " = " << sides.right.text;
    }
  }

  void check_lesson(const Lesson& lesson) {
    for (const Stage& stage : lesson.stages)
      for (const Step& step : stage.steps)
        for (const Block& block : step.blocks) {
          const auto* claim = std::get_if<Claim>(&block);
          if (!claim || claim->origin != Claim::Origin::formula || claim->kind == ClaimKind::measured ||
              claim->kind == ClaimKind::non_sequitur)
            continue;
          for (const Equation* equation : equations_of(stage)) {
            if (equation->id != claim->equation) continue;
            const auto read = read_equation(equation->math, lesson.notation);
            if (!read) continue;  // it goes on with the one above
            has_condition_ = read->has_condition;
            for (const std::string& mutant : mutants_of_tex(equation->tex)) check(mutant, *claim, lesson);
          }
        }
  }

  const Oracle& oracle(LawsAssumed assumption, const Given& given) {
    std::string name = std::to_string(static_cast<int>(assumption));
    for (const Setting& setting : given.settings) name += ";" + setting.text;
    auto& one = oracles_[name];
    if (!one) one = std::make_unique<Oracle>(assumption, given);
    return *one;
  }

  static constexpr std::size_t kLargestSides = 80;  // of nodes: beyond, algebra takes long and finds no more
  Prover prover_;
  std::map<std::string, std::unique_ptr<Oracle>> oracles_;
  std::set<std::string> texts_;
  bool has_condition_ = false;
  int mutants_ = 0, refused_ = 0;
  std::array<int, 3> lines_{};
};

TEST_F(TexMutants, OfTheLessonsAreRefusedOrReadAsWhatGinacDecidesAlike) {
  for (const auto& entry : std::filesystem::directory_iterator(test::source_dir() / "lessons")) {
    if (entry.path().extension() != ".md" || entry.path().filename() == "FORMAT.md") continue;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    const LessonReading reading = read_lesson(text.str(), entry.path().filename().string());
    ASSERT_TRUE(reading.lesson) << entry.path();
    check_lesson(*reading.lesson);
  }
  std::printf(
      "%d mutants of the lessons' TeX: %d refused; of the lines read %d hold, %d differ, %d are nowhere "
      "defined\n",
      mutants_, refused_, lines_[0], lines_[1], lines_[2]);
  EXPECT_GE(mutants_, 2000);
  EXPECT_GE(lines_[1], 500);
}

/// A formula, what is small in it, and of what kind it is.
struct NearFormula {
  const char* tex;
  std::vector<Quantity> small;
  LawsAssumed assumption;
};

// What is linearised in lectures, to all orders, with its slips: GiNaC says the same of each.
TEST_F(TexMutants, OfWhatHoldsToAnOrderAreDecidedAlike) {
  using Q = Quantity;
  const std::vector<NearFormula> formulas{
      {R"(\ddot\omega_1 \approx \frac{(I_2 - I_3)(I_1 - I_2)}{I_1 I_3}\omega_2^2\omega_1)",
       {Q::w1, Q::w3},
       LawsAssumed::free},
      {R"(\ddot\omega_2 \approx -\frac{(I_2 - I_1)(I_3 - I_1)}{I_2 I_3}\omega_1^2\omega_2)",
       {Q::w2, Q::w3},
       LawsAssumed::free},
      {R"(I_1\dot\omega_1 \approx (I_2 - I_3)\omega_2\omega_3)", {Q::w1, Q::w3}, LawsAssumed::free},
      {R"(I_1\dot\omega_1 \approx (I_2 - I_3)\omega_2\omega_3 + N_1)", {Q::w1, Q::w3}, LawsAssumed::motion},
      {R"(\dot\omega_2 \approx 0)", {Q::w1, Q::w3}, LawsAssumed::free},
      {R"(2T \approx I_2\omega_2^2)", {Q::w1, Q::w3}, LawsAssumed::identity},
      {R"(\mathbf I\cdot\vec\omega \approx I_2\omega_2\hat e_2 + I_1\omega_1\hat e_1 + I_3\omega_3\hat e_3)",
       {Q::w1, Q::w3},
       LawsAssumed::identity},
      {R"(\frac{|\vec L|^2}{2T} \approx I_2 + \frac{I_1(I_1 - I_2)\omega_1^2 + I_3(I_3 - I_2)\omega_3^2}{I_2\omega_2^2})",
       {Q::w1, Q::w3},
       LawsAssumed::identity},
      {R"(\frac{2T - I_2\omega_2^2}{\omega_1} \approx I_1\omega_1 + \frac{I_3\omega_3^2}{\omega_1})",
       {Q::w1, Q::w3},
       LawsAssumed::identity},
      {R"(\vec L \approx I_2\omega_2\hat e_2)", {Q::w1, Q::w3}, LawsAssumed::identity},
      {R"(\frac{d}{dt}(\omega_1\omega_3) \approx \frac{I_2 - I_3}{I_1}\omega_2\omega_3^2 + \frac{I_1 - I_2}{I_3}\omega_2\omega_1^2)",
       {Q::w1, Q::w3},
       LawsAssumed::free},
  };
  const auto macros = read_lesson(test_lesson(), "a.md").lesson->macros;
  const auto notation = read_lesson(test_lesson(), "a.md").lesson->notation;
  int mutants = 0, refused = 0, vacuous = 0;
  std::array<int, 3> decided{};
  for (const NearFormula& formula : formulas) {
    std::vector<std::string> all = mutants_of_tex(formula.tex);
    all.emplace_back(formula.tex);
    for (int order = 1; order <= kMaxSmallOrder; ++order) {
      Given given;
      given.small = {formula.small, order};
      const Oracle theirs_of(formula.assumption, given);
      for (const std::string& tex : all) {
        ++mutants;
        const auto math = parse_math(tex, macros);
        const auto read = math ? std::optional(read_equation(*math, notation)) : std::nullopt;
        const auto lines = read && *read && !(**read).has_condition
                               ? std::optional(claim_lines_of(**read, ClaimKind::identity,
                                                              [](SourceSpan) {
                                                                return SourcePlace{1, 1};
                                                              }))
                               : std::nullopt;
        if (!lines || !*lines) {
          ++refused;
          continue;
        }
        for (const ClaimLine& line : **lines) {
          const Equality& sides = line.equality;
          if (line.conclusion || line.relation != Relation::approximate || sides.left.uses(Operation::norm) ||
              sides.right.uses(Operation::norm))
            continue;
          bool are_zero = false;
          const Decision theirs = theirs_of.compare_to_order(sides, are_zero);
          const bool says_nothing = are_zero && theirs == Decision::same &&
                                    sides.left.type() != ExpressionType::zero &&
                                    sides.right.type() != ExpressionType::zero;
          vacuous += says_nothing ? 1 : 0;
          ++decided[static_cast<std::size_t>(theirs)];
          const Verdict wanted = says_nothing                    ? Verdict::undecided
                                 : theirs == Decision::same      ? Verdict::holds
                                 : theirs == Decision::different ? Verdict::fails
                                                                 : Verdict::undecided;
          const Judgement ours = prover_.settle_in_series(sides, formula.assumption, given);
          EXPECT_EQ(ours.verdict, wanted) << tex << " to order " << order << " is read as " << sides.left.text
                                          << " = " << sides.right.text << ": " << ours.message;
        }
      }
    }
  }
  std::printf(
      "%d mutants of what holds to an order: %d refused; of the lines read %d hold (%d of them say "
      "nothing), %d differ, %d are nowhere defined\n",
      mutants, refused, decided[0], vacuous, decided[1], decided[2]);
  EXPECT_GE(mutants, 1000);
  EXPECT_GE(decided[0], 30);
  EXPECT_GE(decided[1], 1000);
}

}  // namespace
}  // namespace polhode::oracle
