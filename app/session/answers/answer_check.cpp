// SPDX-License-Identifier: MIT
#include "app/session/answers/answer_check.h"

#include "app/session/answers/derivation_work.h"
#include "lessons/derivation/answer_reasons.h"
#include "lessons/reader/questions/line_notation.h"
#include "lessons/reader/questions/state_task.h"

namespace polhode {

AnswerCheck::AnswerCheck(const Lesson& lesson) : lesson_(lesson) {}

bool AnswerCheck::is_right(const Ask& ask, std::string_view answer) {
  const auto [known, is_new] = known_.try_emplace({&ask, std::string(answer)}, false);
  if (is_new) known->second = judge(ask, answer);
  return known->second;
}

std::string AnswerCheck::reason(const Ask& ask, std::string_view answer) {
  if (ask.derivation) return "";
  const auto [known, is_new] = reasons_.try_emplace({&ask, std::string(answer)}, "");
  if (is_new)
    known->second =
        (ask.task ? judge_state(*ask.task, answer) : judge_with_reasons(ask, answer, prover_, notation(ask)))
            .tag;
  return known->second;
}

const LineNotation& AnswerCheck::notation(const Ask& ask) {
  const auto known = how_.find(&ask);
  return known != how_.end() ? known->second : how_.emplace(&ask, line_notation(lesson_, ask)).first->second;
}

bool AnswerCheck::judge(const Ask& ask, std::string_view answer) {
  if (ask.task) return judge_state(*ask.task, answer).mark == AnswerJudgement::Mark::right;
  if (!ask.derivation) return is_right_answer(ask, answer, prover_, notation(ask));
  DerivationWork work(lesson_, ask);
  work.restore(answer);
  return work.is_done();
}

}  // namespace polhode
