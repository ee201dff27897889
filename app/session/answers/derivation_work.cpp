// SPDX-License-Identifier: MIT
#include "app/session/answers/derivation_work.h"

#include "lessons/reader/questions/line_notation.h"

#include <utility>

namespace polhode {
namespace {

using Mark = LineJudgement::Mark;

bool leads_on(Mark mark) { return mark == Mark::holds || mark == Mark::goal; }

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
  if (is_too_short()) lines_.pop_back();  // the goal, before there was a way to it
  lines_.push_back({std::string(typed), judge_line(derivation_, held(), typed, how_, prover_)});
  return lines_.back().judgement;
}

std::string DerivationWork::typed_tex() const {
  return typing_.empty() ? "" : typed_formula(typing_, how_.names).tex;
}

void DerivationWork::undo() {
  if (!lines_.empty()) lines_.pop_back();
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
