// SPDX-License-Identifier: MIT
#include "app/page/still_numbers.h"

#include "lessons/claims/live_claims.h"

#include <algorithm>

namespace polhode {

const StillNumbers::Values& StillNumbers::of(const Step& step) {
  const auto known = known_.find(&step);
  return known != known_.end() ? known->second : known_.emplace(&step, computed(step)).first->second;
}

StillNumbers::Values StillNumbers::computed(const Step& step) const {
  const auto has_numbers = [](const Block& block) {
    const auto* equation = std::get_if<Equation>(&block);
    return equation && !equation->live.empty();
  };
  if (!step.scene || std::none_of(step.blocks.begin(), step.blocks.end(), has_numbers)) return {};
  const std::optional<LiveState> live =
      live_state(make_model(*step.scene, Product::numbers, effort_), still_time_s(*step.scene));
  Values values;
  for (const Block& block : step.blocks)
    if (live && has_numbers(block))
      for (const Expression& number : std::get<Equation>(block).live)
        if (const auto value = live_number(number, *live)) values.emplace(&number, *value);
  return values;
}

}  // namespace polhode
