// SPDX-License-Identifier: MIT
#include "app/session/words/step_words.h"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

std::string stage_count(const LessonSession& session) {
  const std::size_t here = session.place().stage, all = session.lesson().stages.size();
  const std::vector<std::size_t> chosen = session.chosen_stages();
  if (!session.is_presenting() || chosen.size() == all) return fmt::format("stage {} of {}", here + 1, all);
  const auto found = std::find(chosen.begin(), chosen.end(), here);
  if (found == chosen.end())
    return fmt::format("stage {} (not one of the {} chosen)", here + 1, chosen.size());
  return fmt::format("stage {} ({} of {} chosen)", here + 1, found - chosen.begin() + 1, chosen.size());
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
