// SPDX-License-Identifier: MIT
#include "lessons/reader/lesson.h"

#include "base/spelling.h"

#include <algorithm>

namespace polhode {

const Stage* Lesson::find_stage(std::string_view stage_id) const {
  const auto found =
      std::find_if(stages.begin(), stages.end(), [&](const Stage& s) { return s.id == stage_id; });
  return found == stages.end() ? nullptr : &*found;
}

Result<const Stage*> Lesson::stage_named(std::string_view stage_id) const {
  if (const Stage* stage = find_stage(stage_id)) return stage;
  std::vector<std::string> known;
  for (const Stage& stage : stages) known.push_back(stage.id);
  return failure("lesson \"" + id + "\" has no stage \"" + std::string(stage_id) + "\"" +
                 did_you_mean(stage_id, known));
}

std::vector<const Equation*> equations_of(const Stage& stage) {
  std::vector<const Equation*> all;
  for (const Step& step : stage.steps) {
    const auto more = blocks_of<Equation>(step);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

std::optional<StepPlace> target_of(const Lesson& lesson, std::string_view link) {
  if (!link.starts_with('#')) return std::nullopt;
  link.remove_prefix(1);
  const std::size_t slash = std::min(link.find('/'), link.size());
  const std::string_view equation = link.substr(std::min(slash + 1, link.size()));
  for (std::size_t i = 0; i < lesson.stages.size(); ++i) {
    if (lesson.stages[i].id != link.substr(0, slash)) continue;
    if (equation.empty()) return StepPlace{i, 0};
    for (std::size_t k = 0; k < lesson.stages[i].steps.size(); ++k)
      for (const Equation* here : blocks_of<Equation>(lesson.stages[i].steps[k]))
        if (here->id == equation) return StepPlace{i, k};
  }
  return std::nullopt;
}

const Equation* find_equation(const Lesson& lesson, std::string_view place) {
  const std::size_t slash = std::min(place.find('/'), place.size());
  const Stage* stage = lesson.find_stage(place.substr(0, slash));
  if (stage == nullptr || slash == place.size()) return nullptr;
  for (const Equation* equation : equations_of(*stage))
    if (equation->id == place.substr(slash + 1)) return equation;
  return nullptr;
}

std::string_view label_of(const Lesson& lesson, Callout::Kind kind) {
  const auto own = lesson.about.labels.find(kind);
  return own != lesson.about.labels.end() ? std::string_view(own->second)
                                          : names_of(kind).label.in(lesson.about.language);
}

namespace {

void add_ids(const Math& math, std::vector<int>& ids) {
  for (const LiveNumber& number : math.live) ids.push_back(number.id);
}

void append_to(std::vector<int>& ids, const std::vector<int>& more) {
  ids.insert(ids.end(), more.begin(), more.end());
}

}  // namespace

std::vector<int> numbers_in(const RichText& text) {
  std::vector<int> ids;
  for_each_span(text, [&](const TextSpan& span) { add_ids(span.math, ids); });
  return ids;
}

std::vector<int> numbers_in(const Block& block) {
  std::vector<int> ids;
  if (const auto* equation = std::get_if<Equation>(&block)) add_ids(equation->math, ids);
  if (const auto* prose = std::get_if<Prose>(&block)) ids = numbers_in(prose->text);
  if (const auto* callout = std::get_if<Callout>(&block)) ids = numbers_in(callout->text);
  if (const auto* note = std::get_if<Footnote>(&block)) ids = numbers_in(note->text);
  if (const auto* ask = std::get_if<Ask>(&block)) {
    for (const RichText& reply : ask->replies) append_to(ids, numbers_in(reply));
    append_to(ids, numbers_in(ask->because));
  }
  return ids;
}

std::vector<int> numbers_in(const Step& step) {
  std::vector<int> ids;
  for (const Block& block : step.blocks) append_to(ids, numbers_in(block));
  for (const Callout& note : step.notes) append_to(ids, numbers_in(note.text));
  return ids;
}

}  // namespace polhode
