// SPDX-License-Identifier: MIT
// Questions, and what is to be said of a learner's answer.
#pragma once

#include "lessons/claims/answers/number_answer.h"
#include "lessons/claims/proof/proof.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// What is asked, and the answer.
struct Question {
  enum class Type { expression, choice, predict, order, number, derive, state };
  Type type = Type::expression;
  std::vector<std::string> choices;
  std::optional<Expression> expression;  ///< the answer, of type expression
  std::vector<int> answers;              ///< the answer, among choices: 1-based, one index or all in order
  /// The answer, of type number. Shared: a lesson has many blocks, each with the room that a question takes.
  std::shared_ptr<const NumberAnswer> number;
  std::string modulo;  ///< identity | motion | free; of expressions
  Given given;         ///< what the answer may assume, of expressions
  /// What the formulas of the prompt say, as far as they can be read: to write that again is no answer.
  std::vector<Expression> asked{};
  /// Of expressions: what an answer may be written with, "I", "omega", "omega'" for its rate (letters_in);
  /// empty: anything.
  std::vector<std::string> letters{};
};

/// Whether the learner picks one of the choices, and whether there are any to pick or to order.
constexpr bool picks_choice(Question::Type type) {
  return type == Question::Type::choice || type == Question::Type::predict;
}
constexpr bool has_choices(Question::Type type) {
  return picks_choice(type) || type == Question::Type::order;
}

/// Choices are called A, B, C … wherever they are shown or read; there are at most 16.
constexpr char letter_of_choice(std::size_t index) { return static_cast<char>('A' + index); }

struct AnswerJudgement {
  enum class Mark { right, wrong, unreadable };
  Mark mark = Mark::wrong;
  std::string reason;  ///< of what is not right: one sentence, without a full stop
  std::string hint;    ///< how it is written, of what cannot be read; may be empty
  int column = 0;      ///< from 1, what the reason is about; 0: the whole
  int choice = 0;      ///< from 1, the choice that was picked; 0: none was
  /// Of a wrong expression, if one of small whole numbers was found: the learner's value on the left.
  std::optional<Counterexample> counterexample;
  std::string tag{};  ///< of what is wrong: the reason in a word, to be counted (reason_tags.h)
};

/// Whether a wrong answer is to have its reason, which takes most of the time.
enum class Reasons { wanted, unwanted };

/// Expressions are right if they equal the lesson's answer modulo what the question says, proved as claims
/// are; derivatives in them only if the lesson's answer has some. Reasons that are looked for: the type, all
/// signs, the sign of one term, a term too many, a constant factor, indices mixed up, what holds only along
/// motions or without torque. Choices: a number from 1, or a letter; an order: all of them, with or without
/// commas or spaces between. Numbers: number_answer.h. Up to some 50 ms.
/// `vocabulary` has the words that the lesson adds to those of expressions; null: none. What a learner is
/// told of an expression comes from lessons/derivation/answer_reasons.h, which knows more slips.
AnswerJudgement judge_answer(const Question& question, std::string_view answer, const Prover& prover,
                             const Vocabulary* vocabulary = nullptr, Reasons reasons = Reasons::wanted);

/// The same of an expression that was read already. Columns are those of its text.
AnswerJudgement judge_expression(const Question& question, const Expression& answer, const Prover& prover,
                                 Reasons reasons = Reasons::wanted);

/// The words of an expression that is asked for, for help: those that a learner may need.
inline constexpr std::string_view kWordsOfAnswers =
    "w1 w2 w3 (ω), I1 I2 I3, N1 N2 N3, w1' … (their rates), T; vectors omega, L, N, e1 e2 e3; + - * / ^; "
    "I1 w1, a . b, a x b, |a|^2, I omega, dL/dt, d*L/dt; comp(a, 2) for a component";

/// How such an answer is written, for an empty box and for help: of letters that no quantity and no choice
/// has, so that it answers no question, neither right nor wrong. Of choices, which are taken, empty.
std::string_view form_of_answer(Question::Type type);

}  // namespace polhode
