// SPDX-License-Identifier: MIT
#include "lessons/reader/claim_rules.h"

#include "lessons/claims/expressions/expression_variants.h"

#include <algorithm>
#include <string>
#include <utility>

namespace polhode {
namespace {

/// What holds of ω at an instant says nothing of rates. False, and a report, if a claim speaks of them.
bool check_given(const Claim& claim, Report& report) {
  if (!claim.given.sets_spin()) return true;
  const auto has_rates = [](const Expression& side) {
    return std::any_of(side.nodes.begin(), side.nodes.end(), is_rate);
  };
  for (const ClaimLine& line : claim.lines) {
    const bool concludes =
        line.conclusion && (has_rates(line.conclusion->left) || has_rates(line.conclusion->right));
    if (!has_rates(line.equality.left) && !has_rates(line.equality.right) && !concludes) continue;
    report.error(line.place, "what is given of ω holds at an instant, and says nothing of rates");
    return false;
  }
  return true;
}

/// What is claimed where something is small holds to an order and is printed so; what is not, is not. False,
/// and a report, where a line says otherwise.
bool check_order(const Claim& claim, Report& report) {
  const bool has_small = !claim.given.small.empty();
  const bool is_printed = claim.origin != Claim::Origin::beside;
  const std::string sign = is_printed ? "\\approx" : "~=";
  for (const ClaimLine& line : claim.lines) {
    const auto refuse = [&](std::string message, std::string hint) {
      report.error(line.place, std::move(message), std::move(hint));
      return false;
    };
    const bool is_approximate = line.relation == Relation::approximate;
    if (is_approximate && claim.kind == ClaimKind::measured && !line.within)
      return refuse("an approximation is measured within a tolerance that is said",
                    "write a claim: left ~= right within 0.01");
    if (!has_small && is_approximate && claim.kind != ClaimKind::measured)
      return refuse(
          "an approximation is proved to an order in what is small, and nothing is small here",
          "write near = { small = [\"w1\"], order = 1 } into [assume], and given near behind the kind");
    if (!has_small) continue;
    if (line.conclusion)
      return refuse("what follows from what is not proved to an order", "claim what holds near there itself");
    if (is_order(line.relation))
      return refuse("an inequality is not proved to an order", "leave out what is small");
    if (!is_approximate)
      return refuse("write " + sign + ": with what is given it holds to " +
                        std::string(name_of_order(claim.given.small.order)) + " order only",
                    "what holds exactly is a claim of its own, without what is small");
    if (claim.kind != ClaimKind::measured &&
        (line.equality.left.uses(Operation::norm) || line.equality.right.uses(Operation::norm)))
      return refuse("a length is a root, and has no series where it may be 0", "square both sides");
  }
  return true;
}

/// Of different units nothing is added, and no sides are compared, but where that is what is false of a line.
/// False, and a report, if a line does.
bool check_units(const Claim& claim, const std::map<int, Dimension>& constants, Report& report) {
  if (claim.kind == ClaimKind::is_false) return true;
  for (const ClaimLine& line : claim.lines) {
    for (const Equality* equality : {&line.equality, line.conclusion ? &*line.conclusion : nullptr}) {
      if (equality == nullptr) continue;
      const DimensionReading left = dimension_of(equality->left, constants),
                             right = dimension_of(equality->right, constants);
      const auto& fault = left.fault ? left.fault : right.fault;
      const bool differ = left.dimension && right.dimension && *left.dimension != *right.dimension;
      if (fault) report.error(line.place, fault->message);
      if (!fault && differ)
        report.error(line.place, "units disagree: the sides are " + to_string(*left.dimension) + " and " +
                                     to_string(*right.dimension));
      if (fault || differ) return false;
    }
  }
  return true;
}

}  // namespace

bool keeps_claim_rules(const Claim& claim, const std::map<int, Dimension>& constants, Report& report) {
  return check_given(claim, report) && check_order(claim, report) && check_units(claim, constants, report);
}

}  // namespace polhode
