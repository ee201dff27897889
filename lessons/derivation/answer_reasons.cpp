// SPDX-License-Identifier: MIT
#include "lessons/derivation/answer_reasons.h"

#include "base/utf8.h"
#include "lessons/claims/answers/reason_tags.h"
#include "lessons/claims/expressions/expression_variants.h"
#include "lessons/derivation/restatement.h"
#include "lessons/derivation/slips.h"
#include "lessons/derivation/typed_answer.h"

#include <algorithm>

namespace polhode {
namespace {

using Mark = AnswerJudgement::Mark;

/// Of an answer that is looked at more closely: nobody types more.
constexpr std::size_t kMostNodes = 400;
/// Parts of expressions that are evaluated while a reason is looked for: some 30 ms.
constexpr std::size_t kMostTried = 40'000;

class CloserLook {
 public:
  CloserLook(const Expression& answer, const Question& question, const Prover& prover,
             const Vocabulary& vocabulary)
      : answer_(answer), question_(question), prover_(prover), vocabulary_(vocabulary) {}

  std::optional<FoundSlip> slip() const {
    if (question_.expression->type() == ExpressionType::zero) return std::nullopt;  // all terms are extra
    if (auto missing = missing_term()) return missing;
    FoundSlip found = find_slip(
        {*question_.expression, answer_}, terms_of_the_answer(),
        [this](const Equality& mended) { return holds(mended); }, vocabulary_, MendedSides::right);
    if (found.slip == Slip::other) return std::nullopt;
    return found;
  }

 private:
  LawsAssumed laws() const {
    if (question_.modulo == "free") return LawsAssumed::free;
    return question_.modulo == "motion" ? LawsAssumed::motion : LawsAssumed::identity;
  }

  bool holds(const Equality& equality) const {
    tried_ += equality.left.nodes.size() + equality.right.nodes.size();
    return tried_ < kMostTried && prover_.settle(equality, laws(), question_.given) == Verdict::holds;
  }

  /// Of the lesson's answer, wherever it stands in it.
  std::optional<FoundSlip> missing_term() const {
    const Expression& whole = *question_.expression;
    for (const int summand : summands_of(whole)) {
      if (!holds({without_summand(whole, summand), answer_})) continue;
      const ExpressionNode& term = whole.nodes[static_cast<std::size_t>(summand)];
      const bool turns = term.operation == Operation::cross &&
                         whole.nodes[static_cast<std::size_t>(term.a)].quantity == Quantity::omega;
      return turns ? FoundSlip{Slip::transport, "a term with ω× is missing: the axes turn with the body"}
                   : FoundSlip{Slip::missing, "a term is missing"};
    }
    return std::nullopt;
  }

  std::vector<std::string> terms_of_the_answer() const {
    std::vector<std::string> terms = {"N", "N1", "N2", "N3", "dot(omega, N)"};
    const Expression& whole = *question_.expression;
    for (const int summand : summands_of(whole)) {
      const ExpressionNode& n = whole.nodes[static_cast<std::size_t>(summand)];
      if (n.end > n.begin && n.end <= whole.text.size())
        terms.push_back(whole.text.substr(n.begin, n.end - n.begin));
    }
    return terms;
  }

  const Expression& answer_;
  const Question& question_;
  const Prover& prover_;
  const Vocabulary& vocabulary_;
  mutable std::size_t tried_ = 0;
};

/// With blanks for the asked side and the "=" behind it, "N = w2 w3 (I3 - I2)": so columns stay.
std::string without_asked_side(const Question& question, std::string_view answer, const LineNotation& how) {
  const std::size_t equals = answer.find('=');
  if (equals == answer.npos || answer.find('=', equals + 1) != answer.npos) return std::string(answer);
  const auto side = read_typed_answer(answer.substr(0, equals), how);
  const bool is_asked =
      side && std::any_of(question.asked.begin(), question.asked.end(), [&](const Expression& asked) {
        return fit(asked.type(), side->expression.type()) && expanded_form({asked, side->expression}).empty();
      });
  if (!is_asked) return std::string(answer);
  const auto characters = static_cast<std::size_t>(count_characters(answer.substr(0, equals + 1)));
  return std::string(characters, ' ') + std::string(answer.substr(equals + 1));
}

AnswerJudgement unreadable(UnreadableLine fault) {
  AnswerJudgement judgement;
  judgement.mark = Mark::unreadable;
  judgement.reason = std::move(fault.message);
  judgement.hint = std::move(fault.hint);
  judgement.column = fault.column;
  return judgement;
}

}  // namespace

AnswerJudgement judge_with_reasons(const Question& question, std::string_view answer, const Prover& prover,
                                   const LineNotation& how) {
  if (question.type != Question::Type::expression)
    return judge_answer(question, answer, prover, &how.notation->vocabulary);
  auto read = read_typed_answer(without_asked_side(question, answer, how), how);
  if (!read) return unreadable(read.error());
  const Expression& expression = read->expression;
  AnswerJudgement judgement = judge_expression(question, expression, prover);
  const bool is_short = expression.nodes.size() <= kMostNodes;
  if (judgement.mark == Mark::right && is_short) {
    if (auto no = why_no_answer(expression, question, prover)) {
      judgement.mark = Mark::wrong;
      judgement.reason = std::move(no->reason);
      judgement.tag = no->tag;
    }
  } else if (judgement.mark == Mark::wrong && judgement.tag == kOtherReason && is_short) {
    if (auto slip = CloserLook(expression, question, prover, how.notation->vocabulary).slip()) {
      judgement.reason = std::move(slip->reason);
      judgement.tag = name_of(slip->slip);
    }
  }
  if (!read->is_as_typed) {
    judgement.column = 0;
    if (judgement.tag == "derivative") judgement.reason = "the answer is asked for without derivatives";
  }
  return judgement;
}

bool is_right_answer(const Question& question, std::string_view answer, const Prover& prover,
                     const LineNotation& how) {
  if (question.type != Question::Type::expression)
    return judge_answer(question, answer, prover, &how.notation->vocabulary, Reasons::unwanted).mark ==
           Mark::right;
  const auto read = read_typed_answer(without_asked_side(question, answer, how), how);
  if (!read || judge_expression(question, read->expression, prover, Reasons::unwanted).mark != Mark::right)
    return false;
  return read->expression.nodes.size() > kMostNodes || !why_no_answer(read->expression, question, prover);
}

}  // namespace polhode
