// SPDX-License-Identifier: MIT
#include "lessons/claims/answers/answers.h"

#include "base/utf8.h"
#include "lessons/claims/expressions/expression_variants.h"
#include "lessons/diagnostics/report.h"

#include <algorithm>
#include <charconv>

namespace polhode {
namespace {

using Mark = AnswerJudgement::Mark;

AnswerJudgement right() {
  AnswerJudgement judgement;
  judgement.mark = Mark::right;
  return judgement;
}
AnswerJudgement wrong(std::string tag, std::string reason, int column = 0) {
  AnswerJudgement judgement;
  judgement.reason = std::move(reason);
  judgement.column = column;
  judgement.tag = std::move(tag);
  return judgement;
}
AnswerJudgement unreadable(std::string reason, std::string hint = {}, int column = 0) {
  AnswerJudgement judgement = wrong({}, std::move(reason), column);
  judgement.mark = Mark::unreadable;
  judgement.hint = std::move(hint);
  return judgement;
}

LawsAssumed assumption_named(const std::string& modulo) {
  if (modulo == "free") return LawsAssumed::free;
  return modulo == "motion" ? LawsAssumed::motion : LawsAssumed::identity;
}

/// An answer that reads and has the right type, against the lesson's.
class ExpressionJudge {
 public:
  ExpressionJudge(const Expression& answer, const Question& question, const Prover& prover)
      : answer_(answer),
        question_(question),
        prover_(prover),
        assumption_(assumption_named(question.modulo)) {}

  AnswerJudgement judge(Reasons reasons) const {
    if (const auto refused = unasked_derivative()) return *refused;
    if (equals(answer_, assumption_)) return right();
    if (reasons == Reasons::unwanted) return not_equal();
    AnswerJudgement judgement = reason();
    judgement.counterexample = prover_.refute({answer_, *question_.expression}, assumption_, question_.given);
    return judgement;
  }

 private:
  bool equals(const Expression& variant, LawsAssumed laws) const {
    return prover_.settle({variant, *question_.expression}, laws, question_.given) == Verdict::holds;
  }
  bool equals(const Expression& variant) const { return equals(variant, assumption_); }

  int column_of(const ExpressionNode& node) const {
    return 1 + count_characters(std::string_view(answer_.text).substr(0, node.begin));
  }
  std::string words_of(const ExpressionNode& node) const {
    return in_quotes(trimmed(std::string_view(answer_.text).substr(node.begin, node.end - node.begin)));
  }

  /// ddt(T) is no answer to what dT/dt is.
  std::optional<AnswerJudgement> unasked_derivative() const {
    if (std::any_of(question_.expression->nodes.begin(), question_.expression->nodes.end(), is_rate))
      return std::nullopt;
    const auto found = std::find_if(answer_.nodes.begin(), answer_.nodes.end(), is_rate);
    if (found == answer_.nodes.end()) return std::nullopt;
    return wrong("derivative", "the answer is asked for without derivatives: " + words_of(*found) + " is one",
                 column_of(*found));
  }

  AnswerJudgement reason() const {
    if (equals(negated(answer_))) return wrong("signs", "wrong sign: every sign is the other way round");
    if (const auto found = one_term()) return *found;
    if (const auto found = factor()) return *found;
    if (const auto found = indices()) return *found;
    if (assumption_ == LawsAssumed::identity && equals(answer_, LawsAssumed::motion))
      return wrong("law", "this follows from the equations of motion; here it has to hold whatever ω̇ is");
    if (assumption_ != LawsAssumed::free && !question_.given.sets_torque() && !has_torque(answer_) &&
        !vanishes_without_torque() && equals(answer_, LawsAssumed::free))
      return wrong("torque", "this is right without torque only");
    return not_equal();
  }

  static AnswerJudgement not_equal() { return wrong("other", "not equal to what is asked for"); }

  static bool has_torque(const Expression& expression) {
    return expression.uses(Quantity::N) || expression.uses(Quantity::N1) || expression.uses(Quantity::N2) ||
           expression.uses(Quantity::N3);
  }

  /// Then that an answer is right without torque says nothing.
  bool vanishes_without_torque() const {
    return prover_.settle({*question_.expression, zero_expression()}, LawsAssumed::free, question_.given) ==
           Verdict::holds;
  }

  std::optional<AnswerJudgement> one_term() const {
    for (const int summand : summands_of(answer_)) {
      const ExpressionNode& node = answer_.nodes[static_cast<std::size_t>(summand)];
      if (equals(with_summand_negated(answer_, summand)))
        return wrong("sign", "wrong sign: that of " + words_of(node), column_of(node));
      if (equals(without_summand(answer_, summand)))
        return wrong("extra", words_of(node) + " does not belong there", column_of(node));
    }
    return std::nullopt;
  }

  std::optional<AnswerJudgement> factor() const {
    for (int denominator = 1; denominator <= 4; ++denominator)
      for (int numerator = -4; numerator <= 4; ++numerator)
        if (numerator != 0 && equals(times(answer_, numerator, denominator)))
          return wrong("factor", "a constant factor is wrong: this is " + fraction(denominator, numerator) +
                                     " times what is asked for");
    return std::nullopt;
  }

  static std::string fraction(int numerator, int denominator) {
    if (denominator < 0) numerator = -numerator, denominator = -denominator;
    return std::to_string(numerator) + (denominator == 1 ? "" : "/" + std::to_string(denominator));
  }

  std::optional<AnswerJudgement> indices() const {
    for (const AxisPermutation& permutation : kAxisPermutations)
      if (equals(renamed(answer_, permutation)))
        return wrong("indices", "the indices are mixed up: right would be " +
                                    std::to_string(permutation[0] + 1) + " for 1, " +
                                    std::to_string(permutation[1] + 1) + " for 2, " +
                                    std::to_string(permutation[2] + 1) + " for 3");
    return std::nullopt;
  }

  const Expression& answer_;
  const Question& question_;
  const Prover& prover_;
  LawsAssumed assumption_;
};

/// The choices that a text names, from 1, by letters or numbers; nothing if it names anything else.
std::optional<std::vector<int>> read_choices(std::string_view text, std::size_t count) {
  std::vector<int> choices;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (std::string_view(" ,\t.();>").find(c) != std::string_view::npos) {
      ++i;
      continue;
    }
    int choice = 0;
    if (c >= 'A' && c <= 'Z')
      choice = c - 'A' + 1, ++i;
    else if (c >= 'a' && c <= 'z')
      choice = c - 'a' + 1, ++i;
    else {
      const auto read = std::from_chars(text.data() + i, text.data() + text.size(), choice);
      if (read.ec != std::errc()) return std::nullopt;
      i = static_cast<std::size_t>(read.ptr - text.data());
    }
    if (choice < 1 || choice > static_cast<int>(count)) return std::nullopt;
    choices.push_back(choice);
  }
  return choices;
}

std::string letters_of(std::size_t count) {
  return std::string("A to ") + letter_of_choice(count - 1) + " or 1 to " + std::to_string(count);
}

AnswerJudgement judge_choice(const Question& question, std::string_view text) {
  const auto choices = read_choices(text, question.choices.size());
  if (!choices || choices->size() != 1)
    return unreadable("the answer is one of the choices, " + letters_of(question.choices.size()));
  AnswerJudgement judgement = right();
  if (*choices != question.answers) {
    const std::string letter(1, letter_of_choice(static_cast<std::size_t>(choices->front() - 1)));
    judgement = wrong("choice-" + letter, letter + " is not right");
  }
  judgement.choice = choices->front();
  return judgement;
}

AnswerJudgement judge_order(const Question& question, std::string_view text) {
  const auto choices = read_choices(text, question.choices.size());
  auto sorted = choices.value_or(std::vector<int>());
  std::sort(sorted.begin(), sorted.end());
  const bool all_once = sorted.size() == question.choices.size() &&
                        std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  if (!all_once)
    return unreadable("the answer names every choice once, in their order: " +
                      letters_of(question.choices.size()));
  if (*choices == question.answers) return right();
  const auto parting = std::mismatch(choices->begin(), choices->end(), question.answers.begin()).first;
  const auto right = parting - choices->begin();
  const std::string place = std::to_string(right + 1);
  return wrong("place-" + place, "place " + place + " is not right" +
                                     (right == 0   ? ""
                                      : right == 1 ? ", the one before it is"
                                                   : ", those before it are"));
}

AnswerJudgement read_and_judge(const Question& question, std::string_view text, const Prover& prover,
                               const Vocabulary* vocabulary, Reasons reasons) {
  const SourceText source(text);
  Report report(source, "");
  if (source.line_count() > 1) return unreadable("an answer is one line");
  const auto answer = read_expression(text, {1, 1}, report, vocabulary);
  if (answer) return judge_expression(question, *answer, prover, reasons);
  const Diagnostic fault = report.take().front();
  return unreadable(fault.message, fault.hint, fault.place.column);
}

}  // namespace

AnswerJudgement judge_expression(const Question& question, const Expression& answer, const Prover& prover,
                                 Reasons reasons) {
  if (answer.uses(Operation::norm))
    return unreadable("a length is a root, and a proof has none", "write |a|^2 or norm2(a), its square");
  if (!is_rational(answer)) return unreadable("a proof has no roots and no angles", "write it without them");
  if (prover.settle({answer, answer}, LawsAssumed::identity) != Verdict::holds)
    return prover.is_defined({answer, answer}, LawsAssumed::identity)
               ? unreadable("its numbers become too large to be judged", "write it with smaller powers")
               : unreadable("this is nowhere defined", "is something divided by 0?");
  if (!fit(answer.type(), question.expression->type()))
    return wrong("kind", "wrong type: " + std::string(name_of(question.expression->type())) +
                             " is asked for, this is " + std::string(name_of(answer.type())));
  return ExpressionJudge(answer, question, prover).judge(reasons);
}

AnswerJudgement judge_answer(const Question& question, std::string_view answer, const Prover& prover,
                             const Vocabulary* vocabulary, Reasons reasons) {
  if (question.type == Question::Type::expression)
    return read_and_judge(question, answer, prover, vocabulary, reasons);
  if (question.type == Question::Type::order) return judge_order(question, answer);
  if (question.number) return judge_number(*question.number, answer);
  return judge_choice(question, answer);
}

std::string_view form_of_answer(Question::Type type) {
  switch (type) {
    case Question::Type::expression:
      return "2*a*(b - c)";
    case Question::Type::order:
      return "X Y Z";
    case Question::Type::number:
      return "x.xx";
    case Question::Type::choice:
    case Question::Type::predict:
    case Question::Type::derive:
      return "";
    case Question::Type::state:
      return "omega = [a, b, c]; t = d";
  }
  return "";
}

}  // namespace polhode
