// SPDX-License-Identifier: MIT
#include "render/gl/label_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {
namespace {

constexpr int kDirections = 16;

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

bool segments_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto side = [](const Vec2& p, const Vec2& q, const Vec2& r) {
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  };
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

struct Crowd {
  const std::vector<Vec2>& obstacles;
  std::vector<PixelBox> taken;
  std::vector<std::pair<Vec2, Vec2>> leaders;
  PixelBox frame;
};

double cost_of(const PixelBox& box, const LabelRequest& label, double gap, const Crowd& crowd) {
  const double area = std::max(1.0, box.width() * box.height());
  const double unit = label.height;
  const PixelBox with_air = box.grown(0.18 * unit);

  double cost = 0.35 * gap / unit;
  const Vec2 away = Vec2(0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)) - label.anchor;
  cost += 0.5 * (1.0 - away.normalized().dot(label.outward)) * label.outward.norm();
  for (const PixelBox& other : crowd.taken) cost += 40.0 * with_air.overlap(other) / area;
  cost += 60.0 * (1.0 - std::min(1.0, box.overlap(crowd.frame) / area));
  double covered = 0.0;
  for (const Vec2& p : crowd.obstacles) covered += with_air.contains(p) ? 1.0 : 0.0;
  cost += 2.5 * covered / (covered + 4.0) + 0.05 * covered;

  const Vec2 end = nearest_on(box, label.anchor);
  for (const auto& [from, to] : crowd.leaders) {
    if (segments_cross(from, to, label.anchor, end)) cost += 6.0;
    for (double f : {0.15, 0.4, 0.65, 0.9}) cost += with_air.contains(from + f * (to - from)) ? 6.0 : 0.0;
  }
  for (const PixelBox& other : crowd.taken)
    for (double f : {0.3, 0.6, 0.9})
      cost += other.contains(label.anchor + f * (end - label.anchor)) ? 8.0 : 0.0;
  return cost;
}

}  // namespace

double PixelBox::overlap(const PixelBox& o) const {
  const double w = std::min(x1, o.x1) - std::max(x0, o.x0);
  const double h = std::min(y1, o.y1) - std::max(y0, o.y0);
  return w > 0.0 && h > 0.0 ? w * h : 0.0;
}

std::vector<PlacedLabel> place_labels(const std::vector<LabelRequest>& labels,
                                      const std::vector<Vec2>& obstacles, const std::vector<PixelBox>& taken,
                                      const PixelBox& frame) {
  Crowd crowd{obstacles, taken, {}, frame};
  std::vector<PlacedLabel> placed;
  for (const LabelRequest& label : labels) {
    PixelBox best;
    double best_cost = std::numeric_limits<double>::infinity();
    const double unit = label.height;
    const std::vector<double> gaps = label.leader
                                         ? std::vector<double>{1.2 * unit, 1.9 * unit, 2.9 * unit, 4.2 * unit}
                                         : std::vector<double>{0.22 * unit, 0.55 * unit, 1.0 * unit};
    for (double gap : gaps)
      for (int k = 0; k < kDirections; ++k) {
        const PixelBox box = box_beside(label, 2.0 * std::numbers::pi * k / kDirections, gap);
        const double cost = cost_of(box, label, gap, crowd);
        if (cost < best_cost - 1e-9) best_cost = cost, best = box;
      }
    // The line stops short of the text.
    const Vec2 end = nearest_on(best.grown(0.16 * unit), label.anchor);
    const bool far_away = (end - label.anchor).norm() > 0.5 * unit;
    placed.push_back({best, label.leader && far_away, end});
    crowd.taken.push_back(best);
    if (placed.back().has_leader) crowd.leaders.emplace_back(label.anchor, end);
  }
  return placed;
}

}  // namespace polhode
