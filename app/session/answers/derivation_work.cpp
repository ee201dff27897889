// SPDX-License-Identifier: MIT
#include "app/session/answers/derivation_work.h"

#include "lessons/derivation/leading_lines.h"
#include "lessons/reader/questions/line_notation.h"

#include <utility>

namespace polhode {
namespace {

using Mark = LineJudgement::Mark;

bool leads_on(Mark mark) { return mark == Mark::holds || mark == Mark::goal; }

constexpr const char* kBesideTheWay =
    "true, but no line behind it has a term of it: it does not lead to the goal";

/// Once the goal is there, which lines lead to it. More lines before it may make another use of them.
void mark_what_leads(const Derivation& derivation, std::vector<DerivationWork::TypedLine>& lines) {
  std::vector<DerivationWork::TypedLine*> hold;
  std::vector<DerivedLine> read;
  for (DerivationWork::TypedLine& line : lines) {
    const LineJudgement& judgement = line.judgement;
    if (!leads_on(judgement.mark) && judgement.reason != kBesideTheWay) continue;
    hold.push_back(&line);
    read.push_back(*judgement.line);
  }
  const std::vector<bool> lead = lines_that_lead(derivation, read);
  for (std::size_t i = 0; i + 1 < hold.size(); ++i) {
    hold[i]->judgement.mark = lead[i] ? Mark::holds : Mark::away;
    hold[i]->judgement.reason = lead[i] ? "" : kBesideTheWay;
  }
}

/// Without the goal all that hold may lead to it.
void forget_what_leads(std::vector<DerivationWork::TypedLine>& lines) {
  for (DerivationWork::TypedLine& line : lines)
    if (line.judgement.reason == kBesideTheWay) {
      line.judgement.mark = Mark::holds;
      line.judgement.reason.clear();
    }
}

}  // namespace

DerivationWork::DerivationWork(const Lesson& lesson, const Ask& ask)
    : derivation_(*ask.derivation), how_(line_notation(lesson, ask)) {}

std::vector<DerivedLine> DerivationWork::held() const {
  std::vector<DerivedLine> held;
  for (const TypedLine& line : lines_)
    if (leads_on(line.judgement.mark)) held.push_back(*line.judgement.line);
  return held;
}

const LineJudgement& DerivationWork::add(std::string_view typed) {
  if (!lines_.empty() && !leads_on(lines_.back().judgement.mark)) lines_.pop_back();
  if (is_too_short()) undo();  // the goal, before there was a way to it
  lines_.push_back({std::string(typed), judge_line(derivation_, held(), typed, how_, prover_)});
  if (is_at_goal()) mark_what_leads(derivation_, lines_);
  return lines_.back().judgement;
}

std::string DerivationWork::typed_tex() const {
  return typing_.empty() ? "" : typed_formula(typing_, how_.names).tex;
}

void DerivationWork::undo() {
  if (!lines_.empty()) lines_.pop_back();
  forget_what_leads(lines_);
}

std::string DerivationWork::hint(int level) const {
  std::vector<DerivedLine> lines = held();
  if (is_too_short()) lines.pop_back();
  const std::size_t next = next_worked(derivation_, lines);
  if (next >= derivation_.worked.size()) return "";
  const WorkedLine& worked = derivation_.worked[next];
  if (level <= 1 && !worked.point.empty()) return worked.point;
  if (level <= 2 && !worked.teach.empty()) return worked.teach;
  return "Type: " + worked.line.typed;
}

std::string DerivationWork::text() const {
  std::string text;
  for (const TypedLine& line : lines_)
    if (leads_on(line.judgement.mark)) text += (text.empty() ? "" : "\n") + line.text;
  return text;
}

void DerivationWork::restore(std::string_view text) {
  clear();
  while (!text.empty() && lines_.size() < kMostDerivedLines) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (!leads_on(add(text.substr(0, end)).mark)) return clear();  // the lesson is another now
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace polhode
