// SPDX-License-Identifier: MIT
#include "app/narration/mark_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>

namespace polhode {

std::pair<std::string, std::string> factors_of(std::string_view written) {
  constexpr std::string_view kOpening = "cross(";
  if (!written.starts_with(kOpening) || !written.ends_with(')')) return {};
  const std::string_view inside = written.substr(kOpening.size(), written.size() - kOpening.size() - 1);
  int depth = 0;
  std::size_t comma = inside.size();
  for (std::size_t i = 0; i < inside.size(); ++i) {
    depth += inside[i] == '(' ? 1 : inside[i] == ')' ? -1 : 0;
    if (depth < 0) return {};
    if (inside[i] == ',' && depth == 0) comma = i;
  }
  if (comma == inside.size()) return {};
  std::size_t second = comma + 1;
  while (second < inside.size() && inside[second] == ' ') ++second;
  return {std::string(inside.substr(0, comma)), std::string(inside.substr(second))};
}

bool is_right_angle(const AngleMark& angle, const SceneModel& model, double t_s) {
  const RigidBodyState state = model.motion->at(t_s);
  const auto from = angle.from.quantity.value(model, t_s, state),
             to = angle.to.quantity.value(model, t_s, state);
  constexpr double kRounding = 1e-9;
  return from && to && !from->isZero(0.0) && !to->isZero(0.0) &&
         std::abs(from->dot(*to)) <= kRounding * from->norm() * to->norm();
}

bool are_edges_of_box(const std::vector<LineMark>& lines) {
  constexpr std::size_t kEdges = 12, kCorners = 8;
  if (lines.size() != kEdges) return false;
  std::map<std::string, std::set<std::string>> next;
  for (const LineMark& line : lines) {
    next[line.from.quantity.text].insert(line.to.quantity.text);
    next[line.to.quantity.text].insert(line.from.quantity.text);
  }
  if (next.size() != kCorners) return false;
  for (const auto& [a, beside_a] : next) {
    if (beside_a.size() != 3) return false;
    for (const auto& [b, beside_b] : next) {
      if (a == b) continue;
      std::vector<std::string> common;
      std::set_intersection(beside_a.begin(), beside_a.end(), beside_b.begin(), beside_b.end(),
                            std::back_inserter(common));
      if (common.size() != 0 && (common.size() != 2 || beside_a.contains(b))) return false;
    }
  }
  return true;
}

bool are_tip_to_tail(const std::vector<const ArrowMark*>& arrows) {
  for (std::size_t i = 1; i < arrows.size(); ++i)
    if (!arrows[i]->at || arrows[i]->at->quantity.text != arrows[i - 1]->of.quantity.text) return false;
  return arrows.size() > 1;
}

}  // namespace polhode
