// SPDX-License-Identifier: MIT
#include "lessons/claim_check.h"

#include "lessons/live_claims.h"
#include "lessons/proof.h"
#include "lessons/report.h"

#include <array>
#include <charconv>
#include <stdexcept>

namespace polhode {
namespace {

std::string short_number(double value) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3);
  return {text.data(), end.ptr};
}

class ClaimCheck {
 public:
  ClaimCheck(const Lesson& lesson, std::string_view file)
      : lesson_(lesson), source_(lesson.source), report_(source_, file) {}

  std::vector<Diagnostic> run() {
    for (const Stage& stage : lesson_.stages)
      for (const Step& step : stage.steps) {
        model_.reset();
        for (const Block& block : step.blocks)
          if (const auto* claim = std::get_if<Claim>(&block)) check(*claim, step);
      }
    return report_.take();
  }

 private:
  void check(const Claim& claim, const Step& step) {
    for (const ClaimLine& line : claim.lines) {
      if (claim.kind == ClaimKind::measured) {
        check_measured(line, step);
        continue;
      }
      const Judgement judgement = judge(line, claim.kind, prover_);
      if (judgement.verdict != Verdict::holds)
        report_.error(line.place,
                      "the claim (" + std::string(name_of(claim.kind)) + ") fails: " + judgement.message,
                      judgement.hint);
    }
  }

  void check_measured(const ClaimLine& line, const Step& step) {
    if (!step.scene) {
      report_.error(line.place, "a measured claim needs a scene to be measured on");
      return;
    }
    try {
      if (!model_) model_.emplace(make_model(*step.scene));
    } catch (const std::domain_error&) {
      return;  // whoever checks the scenes says so
    }
    const auto measured = measure(line.equality, line.within, *model_);
    if (!measured)
      report_.error(line.place, "this cannot be measured: the motion or a side has no value somewhere");
    else if (!measured->holds())
      report_.error(line.place, "the claim (measured) fails: at t = " + short_number(measured->t_s) +
                                    " s both sides differ by " + short_number(measured->residual) +
                                    " of their terms, allowed are " + short_number(measured->tolerance));
  }

  const Lesson& lesson_;
  SourceText source_;
  Report report_;
  Prover prover_;
  std::optional<SceneModel> model_;  // of the step
};

}  // namespace

std::vector<Diagnostic> check_claims(const Lesson& lesson, std::string_view file_name) {
  return ClaimCheck(lesson, file_name).run();
}

}  // namespace polhode
