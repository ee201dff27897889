// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/claim_kind_check.h"

#include "base/numbers.h"
#include "lessons/claims/live_claims.h"
#include "lessons/derivation/decided.h"
#include "lessons/reader/checks/lint_budget.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace polhode {
namespace {

bool is_identity(const Equality& sides, const Prover& prover, const Effort& effort, const Given& given = {}) {
  spend(effort, kClaimLineEvaluations + kClaimNodeEvaluations * nodes_in(sides));
  return is_provable(sides) && prover.settle(sides, LawsAssumed::identity, given) == Verdict::holds;
}

bool is_name(const Expression& side) {
  return !side.text.empty() && std::isalpha(static_cast<unsigned char>(side.text.front())) &&
         std::all_of(side.text.begin(), side.text.end(),
                     [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

/// A formula that is proved, and is what one of its symbols means.
bool is_definition_of_symbol(const ClaimLine& line) {
  const auto& [left, right] = line.equality;
  return !line.conclusion && !line.is_number && line.relation == Relation::equal &&
         (is_name(left) || is_name(right)) && left.text != right.text && is_mere_rearrangement(line.equality);
}

/// A law, or what is given, is said to be needed for what holds without.
void check_is_needed(const Claim& claim, const Prover& prover, Report& report, const Effort& effort) {
  const auto all_hold = [&](const Given& given) {
    return std::all_of(claim.lines.begin(), claim.lines.end(), [&](const ClaimLine& line) {
      return !line.conclusion && line.relation == Relation::equal &&
             is_identity(line.equality, prover, effort, given);
    });
  };
  Given where_defined;  // an inequality may say where the formula has a meaning
  where_defined.bounds = claim.given.bounds;
  if (claim.kind != ClaimKind::identity && all_hold(claim.given))
    report.warning(claim.place, "no law of motion is needed: it holds by what its quantities are",
                   "its kind is identity");
  else if (claim.kind == ClaimKind::identity && !claim.given.settings.empty() && all_hold(where_defined))
    report.warning(claim.place, "what is given is not needed: it holds by what its quantities are",
                   "leave out \"given\", but for what says where it is defined");
}

}  // namespace

void check_kind(const Claim& claim, const Prover& prover, Report& report, const Effort& effort) {
  const bool is_all_identity =
      claim.kind == ClaimKind::measured &&
      std::all_of(claim.lines.begin(), claim.lines.end(), [&](const ClaimLine& line) {
        return !line.conclusion && is_identity(line.equality, prover, effort);
      });
  if (is_all_identity && !claim.lines.empty())
    report.error(claim.place, "this measures nothing: it holds by what its quantities are, on every motion",
                 "its kind is identity");
  const bool is_proved =
      claim.kind == ClaimKind::identity || claim.kind == ClaimKind::motion || claim.kind == ClaimKind::free;
  const bool is_printed = claim.origin == Claim::Origin::formula;
  if (is_proved && is_printed && claim.lines.size() == 1 && is_definition_of_symbol(claim.lines.front()))
    report.warning(claim.place, "this proves nothing: it is what one of its symbols means",
                   "its kind is definition");
  else if (is_proved && is_printed && !claim.lines.empty())
    check_is_needed(claim, prover, report, effort);
  for (const ClaimLine& line : claim.lines) {
    const Equality& sides = line.equality;
    if (claim.kind == ClaimKind::definition && !line.goes_on && line.is_side_by_side &&
        !is_name(sides.left) && !is_name(sides.right))
      report.error(line.place, "this defines nothing: no side is a quantity alone",
                   "its kind is identity, or write what it defines alone on a side");
    if (claim.kind == ClaimKind::law && !line.goes_on && is_identity(sides, prover, effort))
      report.error(line.place, "this is no law: it holds by what its quantities are",
                   "its kind is identity, or definition");
  }
}

void check_measured(const Claim& claim, const ClaimLine& line, const SceneModel& model, Report& report) {
  for (const double t_s : {0.0, model.span_s}) {
    const auto live = claim.given.empty() ? std::nullopt : live_state(model, t_s);
    if (!live || holds_on(claim.given, *live)) continue;
    report.error(line.place, "this is measured on a motion on which what is given does not hold",
                 "show a body and a torque of which it does, or leave out \"given\"");
    return;
  }
  constexpr double kLeastTurn_rad = 0.01;
  if (model.span_s * model.scene.w0_B.norm() < kLeastTurn_rad) {
    report.error(line.place, "this measures nothing: the motion lasts " + digits(model.span_s, 3) + " s",
                 "give the scene a longer duration");
    return;
  }
  const auto measured = measure(line.equality, line.within, model, claim.given);
  if (!measured)
    report.error(line.place, "this cannot be measured: the motion or a side has no value somewhere");
  else if (measured->tolerance > kDecisive)
    report.error(line.place,
                 "this measures nothing: allowed are " + digits(measured->tolerance, 3) + " of the terms",
                 line.within ? "at most " + digits(kDecisive, 3) + " decides anything"
                             : "shorten the step of the motion");
  else if (!measured->decides())
    report.error(line.place,
                 "this measures nothing: the terms cancel down to " + digits(measured->side, 3) +
                     " of their size, and " + digits(measured->allowed, 3) + " of it is allowed",
                 line.within ? "a hundredth of the sides decides: write within " +
                                   digits(0.9 * kDecisive * measured->side, 1)
                             : "prove the claim, or measure it on a motion where its sides are larger");
  else if (!measured->holds())
    report.error(line.place, "the claim (measured) fails: at t = " + digits(measured->t_s, 3) +
                                 " s both sides differ by " + digits(measured->residual, 3) +
                                 " of their terms, allowed are " + digits(measured->tolerance, 3));
}

}  // namespace polhode
