// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/printed_claim_check.h"

#include "lessons/derivation/decided.h"
#include "lessons/notation/tex_items.h"
#include "lessons/reader/checks/formula_signs.h"
#include "lessons/reader/checks/lint_budget.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

namespace polhode {
namespace {

class PrintedClaimCheck {
 public:
  PrintedClaimCheck(const Lesson& lesson, const Prover& prover, Report& report, const Effort& effort)
      : lesson_(lesson), prover_(prover), report_(report), effort_(effort) {}

  void check(const Claim& claim, const std::vector<const Equation*>& equations) const {
    const auto named = std::find_if(equations.begin(), equations.end(),
                                    [&](const Equation* e) { return e->id == claim.equation; });
    if (named == equations.end() || !(*named)->math.root) return;
    const Math* above = named == equations.begin() ? nullptr : &(*std::prev(named))->math;
    const auto read = read_equation((*named)->math, lesson_.notation, above);
    if (read)
      compare(claim, *read);
    else if (hidden_part(*(*named)->math.root) != nullptr)
      report_.warning(claim.place,
                      "a colour, a phantom or a space that goes back may hide a part of this formula",
                      "mark parts with \\term{id}{…}, and leave spaces to TeX");
    else if (says_no_equality(*(*named)->math.root))
      report_.warning(claim.place, "the formula has a sign that no claim stands for",
                      "claim what = < > \\le \\ge or \\approx says, and write the formula so");
    else {
      check_is_not_empty(claim, report_);
      compare_relations(claim, (*named)->math);
      if (claim.in_other_words) check_indices(claim, (*named)->math);
      if (!claim.in_other_words) compare_letters(claim, (*named)->math);
      if (!claim.in_other_words) compare_factors(claim, (*named)->math);
      if (!claim.in_other_words) compare_signs(claim, (*named)->math);
    }
  }

 private:
  void compare(const Claim& claim, const ReadEquation& formula) const {
    std::vector<const EquationLink*> links;
    for (const EquationSentence& sentence : formula.sentences)
      for (const EquationLink& link : sentence.links) links.push_back(&link);
    const std::string as_printed = "write ```math " + claim.equation + ' ' +
                                   std::string(name_of(claim.kind)) + ", and leave out the claim";
    std::set<const EquationLink*> claimed;
    for (const ClaimLine& line : claim.lines) {
      const std::size_t before = claimed.size();
      for (const EquationLink* link : links)
        if (line.relation == link->relation &&
            (is_same(line.equality, link->equality, !is_order(line.relation)) ||
             (line.conclusion && is_same(*line.conclusion, link->equality, true))))
          claimed.insert(link);
      if (claimed.size() == before && !claim.in_other_words)
        report_.warning(line.place, "the formula does not say this", as_printed);
    }
    if (claimed.empty() && claim.in_other_words)
      report_.warning(claim.place, "the formula can be read, and says something else", as_printed);
    if (claimed.size() == links.size())
      report_.warning(claim.place, "the formula itself can be proved, as it is printed", as_printed);
    else if (!claimed.empty())
      report_.warning(claim.place,
                      "of the " + std::to_string(links.size()) + " equalities that the formula states only " +
                          std::to_string(claimed.size()) + " are claimed",
                      as_printed);
  }

  /// Whether two equalities have the same sides, in either order if that is all the same.
  bool is_same(const Equality& a, const Equality& b, bool in_any_order) const {
    spend(effort_, kClaimLineEvaluations + kClaimNodeEvaluations * (nodes_in(a) + nodes_in(b)));
    const auto same = [&](const Expression& x, const Expression& y) {
      if (!fit(x.type(), y.type())) return false;
      const Equality sides{x, y};
      return is_provable(sides) && prover_.settle(sides, LawsAssumed::identity) == Verdict::holds;
    };
    return (same(a.left, b.left) && same(a.right, b.right)) ||
           (in_any_order && same(a.left, b.right) && same(a.right, b.left));
  }

  /// "a > b" above "a = b" would be said to be proved.
  void compare_relations(const Claim& claim, const Math& formula) const {
    std::set<Relation> unclaimed = relations_in(*formula.root);
    for (const ClaimLine& line : claim.lines) unclaimed.erase(line.relation);
    if (!unclaimed.empty())
      report_.warning(claim.place,
                      "the formula says " + in_quotes(sign_of(*unclaimed.begin())) +
                          " of two things, and no line of the claim does",
                      "claim what is printed");
  }

  /// T_0 is not T, in whatever words that is claimed.
  void check_indices(const Claim& claim, const Math& formula) const {
    const std::set<std::string> shown = letters_in(formula, lesson_.notation, IndexedLetters::as_printed);
    for (const ClaimLine& line : claim.lines)
      for (const Expression* side : {&line.equality.left, &line.equality.right})
        for (const std::string& letter : letters_in(*side)) {
          if (shown.contains(letter)) continue;
          const auto other = std::find_if(shown.begin(), shown.end(),
                                          [&](const std::string& one) { return one == letter + "_0"; });
          if (other != shown.end())
            return report_.warning(claim.place,
                                   "the claim speaks of " + letter + ", and the formula of " + *other,
                                   "say with `means` what " + *other + " is, or claim what is printed");
        }
  }

  void compare_letters(const Claim& claim, const Math& formula) const {
    const std::set<std::string> shown = letters_in(formula, lesson_.notation);
    std::set<std::string> unseen, claimed;
    const auto look = [&](const Equality& equality) {
      for (const Expression* side : {&equality.left, &equality.right})
        for (const std::string& letter : letters_in(*side)) {
          claimed.insert(letter);
          if (!shown.contains(letter)) unseen.insert(letter);
        }
    };
    for (const ClaimLine& line : claim.lines) {
      look(line.equality);
      if (line.conclusion) look(*line.conclusion);
    }
    constexpr const char* kHint = "claim what is printed, or end the fence's line with in-other-words";
    if (!unseen.empty())
      return report_.warning(
          claim.place, "the claim speaks of " + joined(unseen) + ", which the formula does not show", kHint);
    std::set<std::string> unclaimed = shown;
    for (const std::string& letter : claimed) unclaimed.erase(letter);
    unclaimed.merge(operators_in(*formula.root));
    if (!unclaimed.empty())
      report_.warning(claim.place,
                      "the formula shows " + joined(unclaimed) + ", of which the claim does not speak",
                      kHint);
  }

  /// "T = w·L/3" above "T = w·L/2": the letters are the same.
  void compare_factors(const Claim& claim, const Math& formula) const {
    const std::set<double> shown = factors_in(*formula.root);
    std::set<double> claimed;
    const auto look = [&](const Expression& side) {
      for (const ExpressionNode& node : side.nodes)
        if (node.operation == Operation::number) add_factor(node.number.value, claimed);
    };
    for (const ClaimLine& line : claim.lines)
      for (const Equality* one : {&line.equality, line.conclusion ? &*line.conclusion : nullptr}) {
        if (one == nullptr) continue;
        look(one->left);
        look(one->right);
      }
    if (shown != claimed)
      report_.warning(claim.place, "the formula has other numbers than the claim",
                      "claim what is printed, or end the fence's line with in-other-words");
  }

  /// "dT = -N·ω dt" above "ddt(T) = dot(N, omega)": letters and numbers are the same.
  void compare_signs(const Claim& claim, const Math& formula) const {
    std::size_t claimed = 0;
    const auto look = [&](const Expression& side) {
      for (const ExpressionNode& node : side.nodes)
        if (node.operation == Operation::subtract || node.operation == Operation::negate) ++claimed;
    };
    for (const ClaimLine& line : claim.lines)
      for (const Equality* one : {&line.equality, line.conclusion ? &*line.conclusion : nullptr}) {
        if (one == nullptr) continue;
        if (!line.goes_on) look(one->left);  // else it is printed once, in the link before
        look(one->right);
      }
    if (minuses_in(*formula.root) != claimed)
      report_.warning(claim.place, "the formula has other minus signs than the claim",
                      "claim what is printed, or end the fence's line with in-other-words");
  }

  static std::string joined(const std::set<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
  }

  const Lesson& lesson_;
  const Prover& prover_;
  Report& report_;
  const Effort& effort_;
};

}  // namespace

void check_against_formula(const Claim& claim, const std::vector<const Equation*>& equations,
                           const Lesson& lesson, const Prover& prover, Report& report, const Effort& effort) {
  PrintedClaimCheck(lesson, prover, report, effort).check(claim, equations);
}

void check_is_not_empty(const Claim& claim, Report& report) {
  for (const ClaimLine& line : claim.lines)
    if (!line.conclusion && !line.is_number && is_mere_rearrangement(line.equality))
      report.error(line.place, "this says nothing: both sides are the same",
                   "claim what the formula says, or let it stand without a kind");
}

}  // namespace polhode
