// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/prompt_check.h"

#include "base/numbers.h"
#include "lessons/claims/expressions/dimension.h"
#include "lessons/claims/motion_words.h"
#include "lessons/reader/checks/lint_budget.h"
#include "lessons/reader/checks/numbers/number_check.h"
#include "lessons/reader/checks/prose/quantity_words.h"
#include "lessons/reader/checks/prose/sentence.h"
#include "lessons/reader/questions/state_task.h"
#include "lessons/reader/text_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace polhode {
namespace {

constexpr int kDigitsOfHint = 6;

/// What stands behind "Find" at the beginning of a prompt, up to the end of its sentence; empty of other
/// prompts.
std::vector<TextSpan> what_is_to_be_found(const RichText& prompt) {
  if (prompt.empty() || prompt.front().spans.empty()) return {};
  std::vector<TextSpan> found = prompt.front().spans;
  if (found.front().kind != TextSpan::Kind::text) return {};
  std::string& begin = found.front().text;
  constexpr std::array<std::string_view, 14> kVerbs{
      "Find ",     "Compute ", "Calculate ", "Determine ",  "Give ",  "Work out ", "State ",
      "Evaluate ", "Express ", "Solve for ", "Write down ", "Write ", "Derive ",   "Name "};
  const auto verb = std::find_if(kVerbs.begin(), kVerbs.end(),
                                 [&](std::string_view word) { return begin.starts_with(word); });
  if (verb == kVerbs.end()) return {};
  begin.erase(0, verb->size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].kind != TextSpan::Kind::text) continue;
    std::string& text = found[i].text;
    std::size_t end = text.size();
    for (const std::string_view stop : {".", ",", ":", ";", "!", " in terms of", " by means of", " using ",
                                        " in joules", " in degrees", " in seconds"})
      end = std::min(end, text.find(stop));
    if (end == text.size()) continue;
    text.erase(end);
    found.resize(i + 1);
  }
  if (found.back().kind == TextSpan::Kind::text) take_unit_at_end(found.back().text);
  return found;
}

/// What stands behind "what is" in the last question of a prompt, up to its sign; empty of other prompts.
std::vector<TextSpan> what_is_asked(const RichText& prompt) {
  std::vector<TextSpan> asked = what_is_to_be_found(prompt);
  for (const TextBlock& block : prompt) {
    std::vector<TextSpan> behind;
    bool is_behind = false;
    for (TextSpan span : block.spans) {
      if (span.kind == TextSpan::Kind::math) {
        if (is_behind) behind.push_back(std::move(span));
        continue;
      }
      for (const std::string_view phrase :
           {"hat is ", "hich is ", "hich of these is ", "hich of these equals ", "hich equals ",
            "hat equals ", "ow large is ", "ow long is ", "ow big is "}) {
        const std::size_t at = span.text.rfind(phrase);
        if (at == std::string::npos) continue;
        span.text.erase(0, at + phrase.size());
        behind.clear();
        is_behind = true;
        break;
      }
      if (!is_behind) continue;
      const std::size_t end = span.text.find('?');
      for (const std::string_view more : {", in terms of", ", expressed", " in terms of", " then?", " now?"})
        if (const std::size_t at = span.text.find(more);
            at != std::string::npos && (end == std::string::npos || at < end)) {
          span.text.erase(at);
          behind.push_back(std::move(span));
          return behind;
        }
      if (end != std::string::npos) {
        span.text.erase(end);
        take_unit_at_end(span.text);
        behind.push_back(std::move(span));
        asked = std::exchange(behind, {});
        is_behind = false;
        continue;
      }
      behind.push_back(std::move(span));
    }
  }
  return asked;
}

constexpr std::array<std::string_view, 3> kQuestions{"What is ", "Which is ", "How large is "};

/// Takes "at $t = 3$ s" from the end of what is asked for; nothing if no time is said there.
std::optional<double> take_time_s(std::vector<TextSpan>& asked, const EquationNotation& notation) {
  constexpr std::string_view kAt = " at ";
  for (std::size_t i = 1; i < asked.size(); ++i) {
    if (asked[i].kind != TextSpan::Kind::math || !asked[i].text.starts_with("t") ||
        asked[i - 1].kind != TextSpan::Kind::text || !asked[i - 1].text.ends_with(kAt))
      continue;
    const auto at_s = Sentences(asked, notation).standing_of(i - 1).at_s;
    if (!at_s) continue;
    asked[i - 1].text.erase(asked[i - 1].text.size() - kAt.size());
    asked.resize(i);
    return at_s;
  }
  return std::nullopt;
}

/// Whether a prompt is one question and nothing besides: "What is $T$?"
bool asks_at_once(std::string_view prompt) {
  const bool begins = std::any_of(kQuestions.begin(), kQuestions.end(),
                                  [&](std::string_view word) { return prompt.starts_with(word); });
  return begins && prompt.find_first_of(".,:;!") == prompt.npos && prompt.find('?') + 1 == prompt.size();
}

class PromptCheck {
 public:
  PromptCheck(const Ask& ask, const Lesson& lesson, const Prover& prover,
              const std::function<std::vector<ShownMotion>()>& motions, Report& report, const Effort& effort)
      : ask_(ask), lesson_(lesson), prover_(prover), motions_(motions), report_(report), effort_(effort) {}

  void run() {
    if (ask_.task) check_goals(*ask_.task);
    if (ask_.type == Question::Type::order) check_order();
    if (ask_.number && ask_.number->expression && speaks_of_motion(*ask_.number->expression)) check_given();
    std::vector<TextSpan> asked = what_is_asked(ask_.prompt_text);
    if (asked.empty()) return;
    asked_at_s_ = take_time_s(asked, lesson_.notation);
    const auto said = quantity_said(asked, lesson_, VectorsSaid::as_vectors);
    if (!said) return;
    for (const TextSpan& span : asked) words_ += span.text;
    if (ask_.expression) check_expression(*said, *ask_.expression);
    if (ask_.number) check_number(*said, *ask_.number);
    if (picks_choice(ask_.type)) check_choice(*said);
  }

 private:
  void refuse(const std::string& why, const std::string& hint = "ask for what the answer is") {
    report_.error(ask_.place,
                  "question " + in_quotes(ask_.id) + " asks for " + in_quotes(words_) + ", and " + why, hint);
  }

  void check_expression(const Expression& said, const Expression& answer) {
    if (!fit(said.type(), answer.type()))
      return refuse("its answer is " + std::string(name_of(answer.type())));
    const Equality sides{said, answer};
    if (!is_provable(sides)) return;
    spend(effort_, kClaimLineEvaluations);
    // A prompt may ask for a rate, and leave Euler's law to the learner.
    const LawsAssumed laws = ask_.modulo == "free" ? LawsAssumed::free : LawsAssumed::motion;
    if (prover_.settle(sides, laws, ask_.given) == Verdict::fails)
      refuse("its answer is something else",
             "what the prompt assumes is given = \"NAME\", an assumption of [assume]");
  }

  void check_number(const Expression& said, const NumberAnswer& answer) {
    if (said.type() == ExpressionType::vector) return refuse("its answer is a number", "ask for its length");
    const auto of_said = dimension_of(said, {}).dimension, of_unit = dimension_of_unit_scaled(answer.unit);
    if (of_said && of_unit && *of_said != *of_unit)
      return refuse("its answer is in " + (answer.unit.empty() ? std::string("no unit") : answer.unit));
    const bool is_computed = answer.expression && speaks_of_motion(*answer.expression);
    // What is given in the prompt may be another motion's: that is so if it asks for anything but the
    // quantity.
    if (!is_computed && (!asks_at_once(ask_.prompt) || !speaks_of_motion(said))) return;
    const auto motions = motions_();
    if (motions.empty() || (!is_computed && motions.size() > 1)) return;
    MotionNumbers numbers(motions.front().model, motions.front().still_s, effort_),
        then(motions.front().model, asked_at_s_.value_or(motions.front().still_s), effort_);
    const auto typed = answer.value ? std::optional(*answer.value * answer.unit_si) : std::nullopt;
    const auto asked = then.value_of(said),
               own = answer.expression ? numbers.value_of(*answer.expression) : typed;
    if (!asked || !own) return;
    NumberAnswer computed = answer;
    computed.value = *own / answer.unit_si;
    if (std::abs(*asked - *own) / answer.unit_si > tolerance_of(computed))
      refuse("that is " + digits(*asked / answer.unit_si, kDigitsOfHint) + " on its scene, the answer " +
             digits(*computed.value, kDigitsOfHint));
  }

  void check_choice(const Expression& said) {
    const auto right = static_cast<std::size_t>(ask_.answers.front() - 1);
    const auto answer = formula_alone(ask_.choice_texts.at(right));
    if (!answer) return;
    if (!fit(said.type(), answer->type()))
      return refuse("its answer is " + std::string(name_of(answer->type())));
    const Equality sides{said, *answer};
    if (!is_provable(sides)) return;
    for (const LawsAssumed laws : {LawsAssumed::identity, LawsAssumed::motion, LawsAssumed::free})
      if (prover_.settle(sides, laws) != Verdict::fails) return;
    const auto motions = motions_();
    for (const ShownMotion& motion : motions) {
      MotionNumbers numbers(motion.model, motion.still_s, effort_);
      const auto a = numbers.value_of(said), b = numbers.value_of(*answer);
      if (a && b && std::abs(*a - *b) <= 1e-9 * (std::abs(*a) + std::abs(*b))) return;
    }
    refuse("the right choice is something else");
  }

  void check_order() {
    const auto says = [&](std::initializer_list<std::string_view> words) {
      return std::any_of(words.begin(), words.end(),
                         [&](std::string_view one) { return ask_.prompt.find(one) != std::string::npos; });
    };
    const bool rises = says({"smallest first", "ascending", "increasing", "from the smallest"}),
               falls = says({"largest first", "descending", "decreasing", "from the largest"});
    const auto motions = rises != falls ? motions_() : std::vector<ShownMotion>();
    if (motions.empty()) return;
    MotionNumbers numbers(motions.front().model, motions.front().still_s, effort_);
    std::optional<double> last;
    for (const int place : ask_.answers) {
      const auto formula = formula_alone(ask_.choice_texts.at(static_cast<std::size_t>(place - 1)));
      const auto value =
          formula && formula->type() != ExpressionType::vector ? numbers.value_of(*formula) : std::nullopt;
      if (!value) return;
      if (last && (rises ? *value < *last : *value > *last))
        return report_.error(ask_.place,
                             "the order of question " + in_quotes(ask_.id) + " is not that of its scene",
                             "write the list in the right order");
      last = value;
    }
  }

  void check_goals(const StateTask& task) {
    const auto motions = motions_();
    if (motions.empty()) return;
    MotionNumbers numbers(motions.front().model, judged_time_s(task, motions.front().still_s), effort_);
    for (const StateGoal& goal : task.goals) {
      const auto said = quantity_said(stretches_of(goal.say), lesson_, VectorsSaid::as_lengths);
      if (!said) continue;
      const auto a = numbers.value_of(*said), b = numbers.value_of(goal.number.expression);
      if (a && b && std::abs(*a - *b) > 1e-6 * (std::abs(*a) + std::abs(*b)))
        report_.error(ask_.place,
                      "a goal of question " + in_quotes(ask_.id) + " is called " + in_quotes(goal.say) +
                          ", which is " + digits(*a, kDigitsOfHint) + " on its scene, and it is " +
                          digits(*b, kDigitsOfHint),
                      "say what \"of\" is");
    }
  }

  void check_given() {
    for (const ShownMotion& motion : motions_()) {
      for (const TextBlock& block : ask_.prompt_text)
        for (std::size_t i = 0; i < block.spans.size(); ++i) {
          if (block.spans[i].kind != TextSpan::Kind::math) continue;
          for (TypedStatement& statement : typed_statements(block.spans[i].math, lesson_.notation)) {
            if (!statement.of) continue;
            if (statement.number.unit.empty() && i + 1 < block.spans.size() && !block.spans[i].break_after)
              statement.number.unit = unit_behind(block.spans[i + 1].text);
            if (const auto wrong = wrong_value(statement, motion.model, {motion.still_s, 0}))
              return report_.error(ask_.place,
                                   "the prompt of question " + in_quotes(ask_.id) + " gives $" +
                                       block.spans[i].text +
                                       "$, and on the scene that its answer is computed on that is " +
                                       digits(*wrong, kDigitsOfHint),
                                   "show the scene that the prompt speaks of");
          }
        }
      return;  // questions are about the first
    }
  }

  std::optional<Expression> formula_alone(const RichText& text) const {
    const bool is_alone =
        text.size() == 1 && text[0].spans.size() == 1 && text[0].spans[0].kind == TextSpan::Kind::math;
    return is_alone ? read_side(text[0].spans[0].math, lesson_.notation) : std::nullopt;
  }

  static std::optional<Dimension> dimension_of_unit_scaled(const std::string& unit) {
    const auto read = scaled_unit(unit);
    return read ? std::optional(read->dimension) : std::nullopt;
  }

  static bool speaks_of_motion(const Expression& expression) {
    return has_motion_words(expression) ||
           std::any_of(expression.nodes.begin(), expression.nodes.end(),
                       [](const ExpressionNode& node) { return node.operation == Operation::quantity; });
  }

  const Ask& ask_;
  const Lesson& lesson_;
  const Prover& prover_;
  const std::function<std::vector<ShownMotion>()>& motions_;
  Report& report_;
  const Effort& effort_;
  std::string words_;
  std::optional<double> asked_at_s_{};  ///< the t that the prompt names
};

}  // namespace

void check_prompt(const Ask& ask, const Lesson& lesson, const Prover& prover,
                  const std::function<std::vector<ShownMotion>()>& motions, Report& report,
                  const Effort& effort) {
  PromptCheck(ask, lesson, prover, motions, report, effort).run();
}

}  // namespace polhode
