// SPDX-License-Identifier: MIT
#include "lessons/reader/claim_check.h"

#include "base/numbers.h"
#include "lessons/claims/live_claims.h"
#include "lessons/claims/proof.h"
#include "lessons/diagnostics/report.h"
#include "lessons/reader/lint_budget.h"

#include <array>
#include <charconv>
#include <stdexcept>

namespace polhode {
namespace {

std::int64_t nodes_in(const ClaimLine& line) {
  const auto nodes = [](const Equality& equality) {
    return equality.left.nodes.size() + equality.right.nodes.size();
  };
  return static_cast<std::int64_t>(nodes(line.equality) + (line.conclusion ? nodes(*line.conclusion) : 0));
}

void prove(Claim& claim, const Prover& prover, const Effort& effort) {
  for (ClaimLine& line : claim.lines) {
    spend(effort, kClaimLineEvaluations + kClaimNodeEvaluations * nodes_in(line));
    Judgement judgement = judge(line, claim.kind, prover);
    const bool searched = judgement.verdict == Verdict::fails || claim.kind == ClaimKind::is_false;
    if (searched && !judgement.counterexample) spend(effort, kVainSearchEvaluations);
    line.judgement = std::move(judgement);
  }
}

class ClaimCheck {
 public:
  ClaimCheck(const Lesson& lesson, std::string_view file, const Effort& effort)
      : lesson_(lesson), source_(lesson.source), report_(source_, file), effort_(effort) {}

  std::vector<Diagnostic> run() {
    SourcePlace place;
    try {
      for (const Stage& stage : lesson_.stages)
        for (const Step& step : stage.steps) {
          model_.reset();
          for (const Block& block : step.blocks) {
            if (report_.is_full()) return report_.take();
            check_block(block, step, place);
          }
        }
    } catch (const BudgetSpent&) {
      const Diagnostic all = too_long_to_check("", place);
      report_.error(place, all.message, all.hint);
    }
    return report_.take();
  }

 private:
  void check_block(const Block& block, const Step& step, SourcePlace& place) {
    place = std::visit([](const auto& b) { return b.place; }, block);
    try {
      std::visit([&](const auto& b) { check(b, step); }, block);
    } catch (const std::domain_error& error) {
      report_.error(place, std::string("this cannot be checked: ") + error.what());
    }
  }

  template <class Other>
  void check(const Other&, const Step&) {}

  void check(const Ask& ask, const Step&) {
    const auto& answer = ask.expression;
    if (answer && prover_.settle({*answer, *answer}, Assumption::identity) != Verdict::holds)
      report_.error(ask.place, "the answer of question " + in_quotes(ask.id) + " is nowhere defined");
  }

  void check(const Equation& equation, const Step& step) {
    for (std::size_t i = 0; i < equation.live.size(); ++i) {
      const SourcePlace place = source_.place_of(equation.offset + equation.math.live[i].offset);
      if (!step.scene) {
        report_.error(place, "a live number needs a scene");
      } else if (const SceneModel* model = model_of(step)) {
        const auto live = live_state(*model, still_time_s(*step.scene));
        if (!live || !live_number(equation.live[i], *live))
          report_.error(place, "this has no value on the scene's motion");
      }
    }
  }

  void check(const Claim& claim, const Step& step) {
    for (const ClaimLine& line : claim.lines) {
      if (report_.is_full()) return;
      if (claim.kind == ClaimKind::measured)
        check_measured(line, step);
      else if (const auto& judgement = line.judgement; judgement && judgement->verdict != Verdict::holds)
        report_.error(line.place,
                      "the claim (" + std::string(name_of(claim.kind)) + ") fails: " + judgement->message,
                      judgement->hint);
    }
  }

  void check_measured(const ClaimLine& line, const Step& step) {
    if (!step.scene) {
      report_.error(line.place, "a measured claim needs a scene to be measured on");
      return;
    }
    const SceneModel* model = model_of(step);
    if (!model) return;
    const auto measured = measure(line.equality, line.within, *model);
    if (!measured)
      report_.error(line.place, "this cannot be measured: the motion or a side has no value somewhere");
    else if (measured->tolerance > kDecisive)
      report_.error(line.place,
                    "this measures nothing: allowed are " + digits(measured->tolerance, 3) + " of the terms",
                    line.within ? "at most 0.01 decides anything" : "shorten the step of the motion");
    else if (!measured->holds())
      report_.error(line.place, "the claim (measured) fails: at t = " + digits(measured->t_s, 3) +
                                    " s both sides differ by " + digits(measured->residual, 3) +
                                    " of their terms, allowed are " + digits(measured->tolerance, 3));
  }

  /// Null if the scene cannot be: whoever checks the scenes says so.
  const SceneModel* model_of(const Step& step) {
    try {
      if (!model_) model_.emplace(make_model(*step.scene, Product::figure, effort_));
      return &*model_;
    } catch (const std::domain_error&) {
      return nullptr;
    }
  }

  const Lesson& lesson_;
  SourceText source_;
  Report report_;
  const Effort& effort_;
  Prover prover_;
  std::optional<SceneModel> model_;  // of the step
};

}  // namespace

std::optional<SourcePlace> prove_claims(Lesson& lesson, const Effort& effort) {
  const Prover prover;
  for (Stage& stage : lesson.stages)
    for (Step& step : stage.steps)
      for (Block& block : step.blocks)
        if (auto* claim = std::get_if<Claim>(&block)) try {
            prove(*claim, prover, effort);
          } catch (const BudgetSpent&) {
            return claim->place;
          }
  return std::nullopt;
}

std::vector<Diagnostic> check_claims(const Lesson& lesson, std::string_view file_name, const Effort& effort) {
  return ClaimCheck(lesson, file_name, effort).run();
}

}  // namespace polhode
