// SPDX-License-Identifier: MIT
#include "render/gl/passes/far_sides.h"

#include "render/gl/passes/viewpoint.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr float kFaint = 0.5F;  // of the opacity
constexpr double kThin = 0.7;   // of the radius

/// Whether all points lie on the surface, but for what keeps a line from sinking into it.
bool lies_on(const Tube& tube, const GlassEllipsoid& ellipsoid) {
  constexpr double kOff = 0.02;  // of the semi-axis
  const Mat3 ball = to_ball(ellipsoid);
  return tube.points.size() > 2 && std::all_of(tube.points.begin(), tube.points.end(), [&](const Vec3& p) {
           return std::abs((ball * (p - ellipsoid.center)).norm() - 1.0) < kOff;
         });
}

/// A part of a tube, from one place to another as counted in its points.
class Cutter {
 public:
  Cutter(const Tube& tube, const GlassEllipsoid& ellipsoid, const Vec3& eye)
      : tube_(tube), ball_(to_ball(ellipsoid)), center_(ellipsoid.center), eye_(ball_ * (eye - center_)) {}

  std::vector<Tube> cut() const {
    const std::size_t n = tube_.points.size();
    const std::size_t segments = tube_.closed ? n : n - 1;
    std::vector<double> cuts;
    for (std::size_t i = 0; i < segments; ++i) {
      const double from = nearness(point(i)), to = nearness(point(i + 1));
      if ((from < 0.0) != (to < 0.0)) cuts.push_back(static_cast<double>(i) + from / (from - to));
    }
    if (cuts.empty()) {
      Tube whole = tube_;
      if (nearness(point(0)) < 0.0) make_faint(whole);
      return {whole};
    }
    const auto end = static_cast<double>(segments);
    std::vector<Tube> parts;
    if (tube_.closed) {
      for (std::size_t k = 0; k < cuts.size(); ++k)
        add(cuts[k], k + 1 < cuts.size() ? cuts[k + 1] : cuts[0] + end, parts);
      return parts;
    }
    cuts.insert(cuts.begin(), 0.0);
    cuts.push_back(end);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) add(cuts[k], cuts[k + 1], parts);
    return parts;
  }

 private:
  const Vec3& point(std::size_t i) const { return tube_.points[i % tube_.points.size()]; }

  Vec3 point_at(double place) const {
    const auto i = static_cast<std::size_t>(place);
    return point(i) + (place - static_cast<double>(i)) * (point(i + 1) - point(i));
  }

  /// Positive on the near side: before the plane in which the rays from the eye touch the unit ball.
  double nearness(const Vec3& p) const { return (ball_ * (p - center_)).dot(eye_) - 1.0; }

  static void make_faint(Tube& part) {
    part.color.a *= kFaint;
    part.radius *= kThin;
  }

  void add(double from, double to, std::vector<Tube>& parts) const {
    if (!(to - from > 1e-9)) return;
    Tube part = tube_;
    part.closed = false;
    part.points = {point_at(from)};
    for (auto i = static_cast<std::size_t>(from) + 1; static_cast<double>(i) < to; ++i)
      part.points.push_back(point(i));
    part.points.push_back(point_at(to));
    const auto segments = static_cast<double>(tube_.points.size() - 1);
    const double first = std::lerp(tube_.fade_start, 1.0, from / segments),
                 last = std::lerp(tube_.fade_start, 1.0, to / segments);
    if (tube_.fade_start < 1.0) {
      part.color.a *= static_cast<float>(last);
      part.fade_start = last > 0.0 ? std::min(first / last, std::nextafter(1.0, 0.0)) : 0.0;
    }
    if (nearness(point_at(0.5 * (from + to))) < 0.0) make_faint(part);
    parts.push_back(std::move(part));
  }

  const Tube& tube_;
  Mat3 ball_;
  Vec3 center_, eye_;
};

}  // namespace

std::vector<Tube> with_faint_far_sides(const DrawList& list, const Vec3& eye) {
  std::vector<Tube> tubes;
  tubes.reserve(list.tubes.size());
  for (const Tube& tube : list.tubes) {
    const auto on = std::find_if(list.ellipsoids.begin(), list.ellipsoids.end(),
                                 [&](const GlassEllipsoid& e) { return lies_on(tube, e); });
    if (on == list.ellipsoids.end()) {
      tubes.push_back(tube);
      continue;
    }
    for (Tube& part : Cutter(tube, *on, eye).cut()) tubes.push_back(std::move(part));
  }
  return tubes;
}

}  // namespace polhode
