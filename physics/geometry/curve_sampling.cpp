// SPDX-License-Identifier: MIT
#include "physics/geometry/curve_sampling.h"

#include <algorithm>

namespace polhode {
namespace {

constexpr double kMargin = 0.75;  // of the tolerance: the curve is looked at in three places only

struct Knot {
  double x;
  Vec3 p;
};

class Sampler {
 public:
  Sampler(const std::function<Vec3(double)>& curve, const Sampling& sampling)
      : curve_(curve), sampling_(sampling) {}

  Knot at(double x) const { return {x, curve_(x)}; }

  // Appends the points of (first, last], knowing the one half way.
  void refine(const Knot& first, const Knot& middle, const Knot& last, int halvings_left) {
    const Knot quarter = at(0.5 * (first.x + middle.x));
    const Knot three_quarters = at(0.5 * (middle.x + last.x));
    const bool bends = std::max({distance_to_segment(quarter.p, first.p, last.p),
                                 distance_to_segment(middle.p, first.p, last.p),
                                 distance_to_segment(three_quarters.p, first.p, last.p)}) >
                       kMargin * sampling_.chord_tolerance;  // false for NaN: nothing to refine
    if (!bends || halvings_left == 0 || points.size() >= sampling_.max_points) {
      points.push_back(last.p);
      return;
    }
    refine(first, quarter, middle, halvings_left - 1);
    refine(middle, three_quarters, last, halvings_left - 1);
  }

  std::vector<Vec3> points;

 private:
  const std::function<Vec3(double)>& curve_;
  Sampling sampling_;
};

}  // namespace

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double size = std::max((b - a).cwiseAbs().maxCoeff(), (p - a).cwiseAbs().maxCoeff());
  if (size == 0) return 0.0;
  const Vec3 chord = (b - a) / size;  // about 1, lest squares underflow
  const Vec3 offset = (p - a) / size;
  const double length2 = chord.squaredNorm();
  const double along = length2 > 0 ? std::clamp(offset.dot(chord) / length2, 0.0, 1.0) : 0.0;
  return size * (offset - along * chord).norm();
}

std::vector<Vec3> sample_curve(const std::function<Vec3(double)>& curve, double x0, double x1,
                               const Sampling& sampling) {
  Sampler sampler(curve, sampling);
  const int pieces = std::max(1, sampling.first_pieces);
  const auto x_at = [&](double piece) { return piece == pieces ? x1 : x0 + (x1 - x0) * (piece / pieces); };

  Knot first = sampler.at(x0);
  sampler.points.push_back(first.p);
  for (int i = 0; i < pieces && first.p.allFinite(); ++i) {
    const Knot last = sampler.at(x_at(i + 1));
    sampler.refine(first, sampler.at(x_at(i + 0.5)), last, sampling.max_halvings);
    first = last;
  }

  std::vector<Vec3>& points = sampler.points;
  points.erase(std::find_if(points.begin(), points.end(), [](const Vec3& p) { return !p.allFinite(); }),
               points.end());
  return std::move(points);
}

}  // namespace polhode
