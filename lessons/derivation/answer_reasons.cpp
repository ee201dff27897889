// SPDX-License-Identifier: MIT
#include "lessons/derivation/answer_reasons.h"

#include "lessons/claims/expression_variants.h"
#include "lessons/claims/reason_tags.h"
#include "lessons/derivation/canonical_form.h"
#include "lessons/derivation/slips.h"
#include "lessons/notation/tex_equation.h"

#include <algorithm>
#include <set>

namespace polhode {
namespace {

using Mark = AnswerJudgement::Mark;

/// Of an answer that is looked at more closely: nobody types more.
constexpr std::size_t kMostNodes = 400;
/// Parts of expressions that are evaluated while a reason is looked for: some 30 ms.
constexpr std::size_t kMostTried = 40'000;

/// With I·ω for L, so that who writes one for the other writes the same.
Expression without_L(const Expression& expression) {
  Expression written{expression.text, {}, expression.constants};
  std::vector<int> places;
  for (ExpressionNode node : expression.nodes) {
    for (int* operand : {&node.a, &node.b})
      if (*operand >= 0) *operand = places[static_cast<std::size_t>(*operand)];
    if (node.operation == Operation::quantity && node.quantity == Quantity::L) {
      node.quantity = Quantity::omega;
      written.nodes.push_back(node);
      node.operation = Operation::inertia;
      node.a = static_cast<int>(written.nodes.size()) - 1;
    }
    places.push_back(static_cast<int>(written.nodes.size()));
    written.nodes.push_back(node);
  }
  return written;
}

/// Whether they are one but for the order of terms and for brackets.
bool are_written_alike(const Expression& a, const Expression& b) {
  return fit(a.type(), b.type()) && expanded_form({without_L(a), without_L(b)}).empty();
}

/// The vector itself, or one of its components: a question may ask for one.
std::vector<Expression> parts_of(const Expression& asked) {
  std::vector<Expression> parts{asked};
  if (asked.type() != ExpressionType::vector) return parts;
  for (int axis = 0; axis < 3; ++axis) {
    Expression part = asked;
    ExpressionNode node = part.nodes.back();
    node.operation = Operation::comp;
    node.a = static_cast<int>(part.nodes.size()) - 1;
    node.b = -1;
    node.integer = axis;
    node.type = ExpressionType::scalar;
    part.nodes.push_back(node);
    parts.push_back(std::move(part));
  }
  return parts;
}

class CloserLook {
 public:
  CloserLook(const Expression& answer, const Question& question, const Prover& prover,
             const Vocabulary& vocabulary)
      : answer_(answer), question_(question), prover_(prover), vocabulary_(vocabulary) {}

  /// What is to be said of it; nothing: it is an answer.
  std::optional<std::string> restatement() const {
    const std::set<std::string> wanted = letters_in(*question_.expression), typed = letters_in(answer_);
    for (const Expression& formula : question_.asked)
      for (const Expression& asked : parts_of(formula)) {
        if (are_written_alike(asked, *question_.expression)) continue;
        const bool is_same = are_written_alike(answer_, asked);
        const std::set<std::string> letters = letters_in(asked);
        const auto left = std::find_if(letters.begin(), letters.end(), [&](const std::string& letter) {
          return typed.contains(letter) && !wanted.contains(letter);
        });
        if ((!is_same && left == letters.end()) || !is_what_is_asked(asked)) continue;
        return is_same ? "this is what is asked, written again: work it out"
                       : "the answer is asked for without " + (*left == "omega" ? "ω" : *left);
      }
    return std::nullopt;
  }

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
  bool is_what_is_asked(const Expression& asked) const {
    return fit(asked.type(), question_.expression->type()) && is_provable({asked, *question_.expression}) &&
           prover_.settle({asked, *question_.expression}, assumption(), question_.given) == Verdict::holds;
  }

  Assumption assumption() const {
    if (question_.modulo == "free") return Assumption::free;
    return question_.modulo == "motion" ? Assumption::motion : Assumption::identity;
  }

  bool holds(const Equality& equality) const {
    tried_ += equality.left.nodes.size() + equality.right.nodes.size();
    return tried_ < kMostTried && prover_.settle(equality, assumption(), question_.given) == Verdict::holds;
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

/// The answer as an expression that a closer look can be taken at.
std::optional<Expression> expression_of(const Question& question, std::string_view answer,
                                        const Vocabulary& vocabulary) {
  if (question.type != Question::Type::expression) return std::nullopt;
  const SourceText source(answer);
  Report report(source, "");
  auto read = read_expression(answer, {1, 1}, report, &vocabulary);
  return read && read->nodes.size() <= kMostNodes ? std::move(read) : std::nullopt;
}

}  // namespace

AnswerJudgement judge_with_reasons(const Question& question, std::string_view answer, const Prover& prover,
                                   const Vocabulary& vocabulary) {
  AnswerJudgement judgement = judge_answer(question, answer, prover, &vocabulary);
  const bool is_open = judgement.mark == Mark::wrong && judgement.tag == kOtherReason;
  if (judgement.mark != Mark::right && !is_open) return judgement;
  const auto read = expression_of(question, answer, vocabulary);
  if (!read) return judgement;
  const CloserLook look(*read, question, prover, vocabulary);
  if (auto restated = look.restatement()) {
    judgement.mark = Mark::wrong;
    judgement.reason = std::move(*restated);
    judgement.tag = "restated";
  } else if (is_open) {
    if (auto slip = look.slip()) {
      judgement.reason = std::move(slip->reason);
      judgement.tag = name_of(slip->slip);
    }
  }
  return judgement;
}

bool is_right_answer(const Question& question, std::string_view answer, const Prover& prover,
                     const Vocabulary& vocabulary) {
  if (judge_answer(question, answer, prover, &vocabulary, Reasons::unwanted).mark != Mark::right)
    return false;
  const auto read = expression_of(question, answer, vocabulary);
  return !read || !CloserLook(*read, question, prover, vocabulary).restatement();
}

}  // namespace polhode
