// SPDX-License-Identifier: MIT
#include "app/session/answers/answer_keys.h"

namespace polhode {

const Ask* asked_by_letter(const LessonSession& session) {
  for (const Ask* ask : session.questions()) {
    const JudgedAnswer* judged = session.judged(*ask);
    const bool is_right = judged != nullptr && judged->judgement.mark == AnswerJudgement::Mark::right;
    if (picks_choice(ask->type) && !is_right && !session.is_awaited(*ask)) return ask;
  }
  return nullptr;
}

bool answer_by_key(LessonSession& session, std::string_view key) {
  if (key.size() != 1) return false;
  const char c = key.front();
  const bool is_letter = c >= 'A' && c <= 'Z', is_digit = c >= '1' && c <= '9';
  const Ask* ask = is_letter || is_digit ? asked_by_letter(session) : nullptr;
  const auto choice = static_cast<std::size_t>(is_letter ? c - 'A' : c - '1');
  if (ask == nullptr || choice >= ask->choices.size()) return false;
  session.answer(*ask, key);
  return true;
}

}  // namespace polhode
