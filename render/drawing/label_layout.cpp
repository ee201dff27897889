// SPDX-License-Identifier: MIT
#include "render/drawing/label_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>

namespace polhode {
namespace {

constexpr int kDirections = 16;

double unit_of(const LabelRequest& label) { return label.unit > 0.0 ? label.unit : label.height; }

/// Box whose nearest edge point lies `gap` from the anchor in a direction (y down).
PixelBox box_beside(const LabelRequest& label, double angle, double gap) {
  const Vec2 d(std::cos(angle), -std::sin(angle));
  const Vec2 half(0.5 * label.width, 0.5 * label.height);
  // Touch the box at the edge that faces the anchor: slide it so that sideways labels are centred vertically.
  const Vec2 center =
      label.anchor + gap * d +
      Vec2(half.x() * std::clamp(1.6 * d.x(), -1.0, 1.0), half.y() * std::clamp(1.6 * d.y(), -1.0, 1.0));
  return {center.x() - half.x(), center.y() - half.y(), center.x() + half.x(), center.y() + half.y()};
}

Vec2 nearest_on(const PixelBox& box, const Vec2& p) {
  return {std::clamp(p.x(), box.x0, box.x1), std::clamp(p.y(), box.y0, box.y1)};
}

bool is_level(const Vec2& leader) {
  constexpr double kSlope = 0.36;
  return std::abs(leader.y()) < kSlope * std::abs(leader.x());
}

Vec2 leader_end(const LabelRequest& label, const PixelBox& box, const LabelRules& rules) {
  const auto end = [&](double gap) { return nearest_on(box.grown(gap * unit_of(label)), label.anchor); };
  return end(is_level(end(rules.leader_gap) - label.anchor) ? rules.level_gap : rules.leader_gap);
}

bool segments_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto side = [](const Vec2& p, const Vec2& q, const Vec2& r) {
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  };
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

/// Distances from the anchor to try.
std::vector<double> gaps_of(const LabelRequest& label) {
  std::vector<double> heights;
  if (!label.leader || label.close) heights = {0.22, 0.55, 1.0};
  if (label.leader) heights.insert(heights.end(), {1.2, 1.9, 2.9, 4.2, 6.0});
  for (double& gap : heights) gap = gap * unit_of(label) + label.clear;
  return heights;
}

struct Crowd {
  const std::vector<Vec2>& obstacles;
  std::vector<PixelBox> taken;
  std::vector<std::pair<Vec2, Vec2>> leaders;
  PixelBox frame;
  LabelRules rules;

  void add(const LabelRequest& label, const PlacedLabel& placed) {
    taken.push_back(placed.box);
    if (placed.has_leader) leaders.emplace_back(label.anchor, placed.leader_end);
  }
};

/// Of the way from `from` to `to`, obstacles that lie on it, but for its first `clear`.
double crossed(const Vec2& from, const Vec2& to, double clear, const Crowd& crowd) {
  constexpr double kNear = 5.0;  // px
  const double length = (to - from).norm();
  const Vec2 way = (to - from) / std::max(length, 1e-9);
  double count = 0.0;
  for (const Vec2& p : crowd.obstacles) {
    const double along = (p - from).dot(way),
                 across = std::abs((p - from).x() * way.y() - (p - from).y() * way.x());
    if (across < kNear && along > clear + kNear && along < length) count += 1.0;
  }
  return count;
}

/// Of all but the lines under it and its leader.
double cost_beside(const PixelBox& box, const LabelRequest& label, double gap, const Crowd& crowd) {
  const double area = std::max(1.0, box.width() * box.height());
  const double unit = unit_of(label);
  const PixelBox with_air = box.grown(crowd.rules.air * unit);

  double cost = 0.35 * gap / unit;
  const Vec2 away = Vec2(0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)) - label.anchor;
  cost += 0.5 * (1.0 - away.normalized().dot(label.outward)) * label.outward.norm();
  for (const PixelBox& other : crowd.taken) cost += 40.0 * with_air.overlap(other) / area;
  cost += 60.0 * (1.0 - std::min(1.0, box.overlap(crowd.frame) / area));
  const Vec2 end = nearest_on(box, label.anchor);
  if (label.leader && gap > unit && is_level(end - label.anchor)) cost += crowd.rules.cost_level;
  for (const auto& [from, to] : crowd.leaders) {
    if (segments_cross(from, to, label.anchor, end)) cost += 6.0;
    for (double f : {0.15, 0.4, 0.65, 0.9}) cost += with_air.contains(from + f * (to - from)) ? 6.0 : 0.0;
  }
  // The way of one that stands beside its line begins on that line.
  for (const PixelBox& other : label.beside ? std::vector<PixelBox>() : crowd.taken)
    for (double f : {0.3, 0.6, 0.9})
      cost += other.contains(label.anchor + f * (end - label.anchor)) ? 8.0 : 0.0;
  return cost;
}

/// @param limit costs beyond it need not be exact: the many obstacles come last, and may not be looked at
double cost_of(const PixelBox& box, const LabelRequest& label, double gap, const Crowd& crowd, double limit) {
  double cost = cost_beside(box, label, gap, crowd);
  if (cost > limit) return cost;
  const PixelBox with_air = box.grown(crowd.rules.air * unit_of(label));
  const Vec2 end = nearest_on(box, label.anchor);
  double covered = 0.0;
  for (const Vec2& p : crowd.obstacles) covered += with_air.contains(p) ? 1.0 : 0.0;
  cost += 2.5 * covered / (covered + 4.0) + crowd.rules.cost_covered * covered;
  if (crowd.rules.cost_crossed > 0.0)
    cost += crowd.rules.cost_crossed * crossed(label.anchor, end, label.clear, crowd);
  return cost;
}

struct Candidate {
  PlacedLabel label;
  double cost;
};

/// The obstacles that any of its candidates can meet.
std::vector<Vec2> within_reach(const LabelRequest& label, const std::vector<Vec2>& obstacles) {
  const double reach = gaps_of(label).back() + label.width + label.height;
  std::vector<Vec2> near;
  for (const Vec2& p : obstacles)
    if ((p - label.anchor).norm() < reach) near.push_back(p);
  return near;
}

/// Moved no further than it must be to lie in the frame, if that is large enough.
PixelBox moved_into(const PixelBox& frame, const PixelBox& box) {
  const auto shift = [](double low, double high, double from, double to) {
    return to - from < high - low ? std::clamp(0.0, low - from, high - to) : 0.0;
  };
  const double dx = shift(frame.x0, frame.x1, box.x0, box.x1), dy = shift(frame.y0, frame.y1, box.y0, box.y1);
  return {box.x0 + dx, box.y0 + dy, box.x1 + dx, box.y1 + dy};
}

/// Of a label that keeps its side: there, or where something is in the way at the next angle that is free, so
/// that it hops no further than it must, and never because of the lines under it.
std::optional<Candidate> on_its_side(const LabelRequest& label, const Crowd& crowd) {
  constexpr double kInTheWay = 1.5;  // such as a thirtieth of it over another label or an arrow
  constexpr double kTurn = std::numbers::pi / 6;
  constexpr std::array<double, 7> kTurns{0, kTurn, -kTurn, 2 * kTurn, -2 * kTurn, 3 * kTurn, -3 * kTurn};
  constexpr std::array<double, 2> kBothSides{0, std::numbers::pi};
  if (!label.keeps_side) return std::nullopt;
  const std::size_t nearest = label.beside ? 3 : 2;
  const std::vector<double> gaps = gaps_of(label);
  for (const double turn : label.beside ? std::span<const double>(kBothSides) : kTurns)
    for (const double gap : std::span(gaps).first(nearest)) {
      const double angle = std::atan2(-label.outward.y(), label.outward.x()) + turn;
      const PixelBox box = moved_into(crowd.frame, box_beside(label, angle, gap));
      const double cost = cost_beside(box, label, gap, crowd);
      if (cost < kInTheWay) return Candidate{{.box = box}, cost};
    }
  return std::nullopt;
}

Candidate cheapest(const LabelRequest& label, const Crowd& crowd) {
  const std::optional<Candidate> own = on_its_side(label, crowd);
  Candidate best = own.value_or(Candidate{{}, std::numeric_limits<double>::infinity()});
  for (double gap : own ? std::vector<double>() : gaps_of(label))
    for (int k = 0; k < kDirections; ++k) {
      const PixelBox box = box_beside(label, 2.0 * std::numbers::pi * k / kDirections, gap);
      const double cost = cost_of(box, label, gap, crowd, best.cost);
      if (cost < best.cost - 1e-9) best = {{.box = box}, cost};
    }
  // No name is cut, even if its anchor lies where none of its places has room.
  if (best.label.box.overlap(crowd.frame) > 0.0) best.label.box = moved_into(crowd.frame, best.label.box);
  // The line stops short of the text.
  const double unit = unit_of(label);
  best.label.leader_end = leader_end(label, best.label.box, crowd.rules);
  best.label.has_leader =
      label.leader && (best.label.leader_end - label.anchor).norm() > 0.5 * unit + label.clear;
  return best;
}

struct Arrangement {
  std::vector<PlacedLabel> placed;  ///< in the order of the labels
  double cost = std::numeric_limits<double>::infinity();
};

/// Places those first that keep their side, of either kind first the label of index `first`, then those after
/// it, round to the one before it.
Arrangement arranged(const std::vector<LabelRequest>& labels, std::size_t first,
                     const std::vector<std::vector<Vec2>>& obstacles, const std::vector<PixelBox>& taken,
                     const PixelBox& frame, const LabelRules& rules) {
  Arrangement made;
  made.placed.resize(labels.size());
  std::vector<std::size_t> order;
  for (std::size_t n = 0; n < labels.size(); ++n) order.push_back((first + n) % labels.size());
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return labels[i].keeps_side; });
  std::vector<bool> is_placed(labels.size(), false);
  for (int round = 0; round <= rules.rounds; ++round) {
    made.cost = 0.0;
    for (const std::size_t i : order) {
      Crowd crowd{obstacles[i], taken, {}, frame, rules};
      for (std::size_t k = 0; k < labels.size(); ++k)
        if (k != i && is_placed[k]) crowd.add(labels[k], made.placed[k]);
      const Candidate best = cheapest(labels[i], crowd);
      made.placed[i] = best.label;
      made.cost += best.cost;
      is_placed[i] = true;
    }
  }
  return made;
}

}  // namespace

double PixelBox::overlap(const PixelBox& o) const {
  const double w = std::min(x1, o.x1) - std::max(x0, o.x0);
  const double h = std::min(y1, o.y1) - std::max(y0, o.y0);
  return w > 0.0 && h > 0.0 ? w * h : 0.0;
}

std::vector<PlacedLabel> place_labels(const std::vector<LabelRequest>& labels,
                                      const std::vector<Vec2>& obstacles, const std::vector<PixelBox>& taken,
                                      const PixelBox& frame, const LabelRules& rules) {
  std::vector<std::vector<Vec2>> near;
  for (const LabelRequest& label : labels) near.push_back(within_reach(label, obstacles));
  Arrangement best;
  const auto starts = std::clamp<std::size_t>(static_cast<std::size_t>(rules.starts), 1,
                                              std::max<std::size_t>(1, labels.size()));
  for (std::size_t s = 0; s < starts; ++s) {
    Arrangement made = arranged(labels, s * labels.size() / starts, near, taken, frame, rules);
    if (made.cost < best.cost) best = std::move(made);
  }
  return std::move(best.placed);
}

// With spacing·i taken off the i-th place, the places need only ascend: isotonic regression, whose solution
// within bounds is the clamped one. Neighbours that would cross share their mean.
std::vector<double> spread_apart(const std::vector<double>& wanted, double spacing, double low, double high) {
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return wanted[a] < wanted[b]; });

  struct Group {
    double mean;
    std::size_t count;
  };
  std::vector<Group> groups;
  for (std::size_t i = 0; i < order.size(); ++i) {
    groups.push_back({wanted[order[i]] - spacing * static_cast<double>(i), 1});
    while (groups.size() > 1 && groups[groups.size() - 2].mean > groups.back().mean) {
      const Group last = groups.back();
      groups.pop_back();
      Group& before = groups.back();
      const auto n = static_cast<double>(before.count), m = static_cast<double>(last.count);
      before = {(n * before.mean + m * last.mean) / (n + m), before.count + last.count};
    }
  }

  const double highest = std::max(low, high - spacing * (static_cast<double>(wanted.size()) - 1.0));
  std::vector<double> placed(wanted.size());
  std::size_t i = 0;
  for (const Group& group : groups)
    for (std::size_t k = 0; k < group.count; ++k, ++i)
      placed[order[i]] = std::clamp(group.mean, low, highest) + spacing * static_cast<double>(i);
  return placed;
}

}  // namespace polhode
