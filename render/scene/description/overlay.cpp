// SPDX-License-Identifier: MIT
#include "render/scene/description/overlay.h"

#include <algorithm>

namespace polhode {
namespace {

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < kOverlays.size(); ++i)
    if (static_cast<std::size_t>(kOverlays[i].overlay) != i) return false;
  return true;
}
static_assert(is_in_order(), "the rows stand in the order of the enumeration");

std::vector<Overlay> those(const OverlaySet& drawn, bool (*wanted)(Overlay)) {
  std::vector<Overlay> found;
  for (int i = 0; i < kOverlayCount; ++i)
    if (const auto overlay = static_cast<Overlay>(i); drawn.contains(overlay) && wanted(overlay))
      found.push_back(overlay);
  return found;
}

}  // namespace

std::string_view name_of(Overlay overlay) { return facts_of(overlay).name; }

std::optional<Overlay> overlay_from(std::string_view name) {
  const auto found = std::find_if(kOverlays.begin(), kOverlays.end(),
                                  [&](const OverlayFacts& facts) { return facts.name == name; });
  return found == kOverlays.end() ? std::nullopt : std::optional(found->overlay);
}

const std::vector<std::string>& overlay_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> all;
    for (const OverlayFacts& facts : kOverlays) all.emplace_back(facts.name);
    return all;
  }();
  return kNames;
}

std::vector<Overlay> diagrams_in(const OverlaySet& drawn) { return those(drawn, is_diagram); }

namespace {

bool has_something_in_space(const OverlaySet& drawn) {
  const auto in_space = [](Overlay o) {
    return !is_diagram(o) && o != Overlay::labels && o != Overlay::values;
  };
  return !those(drawn, in_space).empty();
}

}  // namespace

bool shows_space(const OverlaySet& drawn, bool has_marks) {
  return has_marks || diagrams_in(drawn).empty() || has_something_in_space(drawn);
}

bool shows_nothing(const OverlaySet& drawn, bool has_marks) {
  return !has_marks && diagrams_in(drawn).empty() && !has_something_in_space(drawn);
}

}  // namespace polhode
