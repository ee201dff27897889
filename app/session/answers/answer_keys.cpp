// SPDX-License-Identifier: MIT
#include "app/session/answers/answer_keys.h"

#include "app/session/answers/answer_log.h"
#include "app/session/command.h"
#include "base/ascii.h"
#include "base/words/window_words.h"
#include "lessons/derivation/derivation.h"

#include <algorithm>

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

std::string why_no_choice(const LessonSession& session, std::string_view key) {
  if (key.size() != 1 || asked_by_letter(session) != nullptr) return {};
  const char c = key.front();
  const auto choice = static_cast<std::size_t>(c >= 'A' ? c - 'A' : c - '1');
  const bool is_choice = (c >= 'A' && c <= 'Z') || (c >= '1' && c <= '9');
  const Ask* closed = nullptr;
  for (const Ask* ask : session.questions())
    if (is_choice && picks_choice(ask->type) && choice < ask->choices.size()) closed = ask;
  if (closed == nullptr) return {};
  const Phrase& phrase = session.is_awaited(*closed) ? words::kMotionAnswersFirst : words::kIsAnsweredAlready;
  return std::string(phrase.in(session.lesson().about.language));
}

namespace {

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

bool can_begin_answer(char c) {
  return is_letter(c) || is_digit(c) || std::string_view("(-+=|.\\").find(c) != std::string_view::npos;
}

/// Whether a name in the line begins with the letter, large or small.
bool begins_name(std::string_view line, char letter) {
  for (std::size_t i = 0; i < line.size(); ++i)
    if (upper(line[i]) == letter && is_letter(line[i]) && (i == 0 || !is_letter(line[i - 1]))) return true;
  return false;
}

bool is_open(const LessonSession& session, const Ask& ask) {
  const AnswerRecord* record = session.record(ask);
  return record == nullptr || record->right == 0;
}

}  // namespace

bool awaits_answer(const LessonSession& session) {
  const std::vector<const Ask*> asked = session.questions();
  return std::any_of(asked.begin(), asked.end(), [&](const Ask* ask) { return session.is_awaited(*ask); });
}

bool has_open_prediction(const LessonSession& session) {
  const std::vector<const Ask*> asked = session.questions();
  return std::any_of(asked.begin(), asked.end(), [&](const Ask* ask) {
    if (ask->type != Ask::Type::predict || session.is_awaited(*ask)) return false;
    const AnswerRecord* known = session.record(*ask);
    return known == nullptr || (known->tries == 0 && !is_told(*known, ask->hints.size()));
  });
}

bool is_typed(const Ask& ask) {
  return ask.type == Ask::Type::expression || ask.type == Ask::Type::number || ask.type == Ask::Type::order ||
         ask.type == Ask::Type::derive;
}

const Ask* begun_by_letter(const LessonSession& session, std::string_view key) {
  if (key.size() != 1 || !can_begin_answer(key.front()) || session.is_presenting()) return nullptr;
  for (const Ask* ask : session.questions()) {
    if (!is_typed(*ask) || !is_open(session, *ask)) continue;
    if (session.panel == Panel::question) return ask;
    if (session.panel != Panel::none || !ask->derivation) continue;
    const Derivation& lines = *ask->derivation;
    const char c = key.front();
    if (!command_of(key) || begins_name(lines.start.typed, c) || begins_name(lines.goal.typed, c)) return ask;
  }
  return nullptr;
}

}  // namespace polhode
