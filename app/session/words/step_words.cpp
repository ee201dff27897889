// SPDX-License-Identifier: MIT
#include "app/session/words/step_words.h"

#include "base/words/page_words.h"
#include "base/words/window_words.h"

#include <fmt/format.h>

namespace polhode {

std::string stage_count(const LessonSession& session) {
  const Language language = session.lesson().about.language;
  const std::size_t here = session.place().stage;
  if (const auto stage = session.stage_number(here))
    return words::kStageOf.with(language, {std::to_string(stage->number), std::to_string(stage->count)});
  const std::string count = std::to_string(session.counted_stages().size());
  return words::kStageNotChosen.with(language, {std::to_string(here + 1), count});
}

std::string step_count(const LessonSession& session) {
  return words::kStepOf.with(session.lesson().about.language, {std::to_string(session.place().step + 1),
                                                               std::to_string(session.stage().steps.size())});
}

std::string window_title(const LessonSession& session, const std::string& stage) {
  if (session.panel == Panel::lessons)
    return std::string(words::kLessons.in(session.lesson().about.language)) + " — polhode";
  return fmt::format("{} — {}, {} — polhode", stage, stage_count(session), step_count(session));
}

std::string tex_of_step(const LessonSession& session) {
  std::string tex;
  for (const Equation* equation : blocks_of<Equation>(session.step())) tex += equation->tex + "\n";
  for (const Ask* ask : session.questions())
    if (ask->derivation) tex += ask->derivation->start.tex + "\n" + ask->derivation->goal.tex + "\n";
  for (const ShownDerivedLine& line : session.shown_derivation().lines) tex += line.tex + "\n";
  return tex;
}

}  // namespace polhode
