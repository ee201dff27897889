// SPDX-License-Identifier: MIT
#include "physics/geometry/flips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace polhode {

namespace {

constexpr int kSamples = 500, kHalvings = 40;

/// Axes in the order of their moments.
std::array<int, 3> axes_by_moment(const PrincipalMoments& I) {
  std::array<int, 3> axes{};
  std::iota(axes.begin(), axes.end(), 0);
  std::sort(axes.begin(), axes.end(), [&](int a, int b) { return I[a] < I[b]; });
  return axes;
}

class FlipSearch {
 public:
  FlipSearch(const Motion& motion, const PrincipalMoments& I)
      : motion_(motion), I_(I), axes_(axes_by_moment(I)) {}

  bool can_flip() const { return I_[axes_[0]] < I_[axes_[1]] && I_[axes_[1]] < I_[axes_[2]]; }

  std::vector<double> in(double from_s, double to_s) const {
    std::vector<double> times_s;
    const auto add = [&](double t_s) {
      if (comes_near(t_s)) times_s.push_back(t_s);
    };
    double before = 0, before_s = from_s;
    for (int i = 0; i <= kSamples; ++i) {
      const double t_s = std::lerp(from_s, to_s, static_cast<double>(i) / kSamples);
      const double here = middle_at(t_s);
      if (here == 0)
        add(t_s);
      else if ((here > 0 && before < 0) || (here < 0 && before > 0))
        add(passage(before_s, t_s, before > 0));
      before = here;
      before_s = t_s;
    }
    return times_s;
  }

 private:
  double middle_at(double t_s) const { return motion_.w_B_at(t_s)[axes_[1]]; }

  double passage(double from_s, double to_s, bool begins_positive) const {
    for (int i = 0; i < kHalvings; ++i) {
      const double half_s = std::midpoint(from_s, to_s);
      ((middle_at(half_s) > 0) == begins_positive ? from_s : to_s) = half_s;
    }
    return std::midpoint(from_s, to_s);
  }

  /// Whether the polhode through ω at a passage leads L near the intermediate axis.
  bool comes_near(double t_s) const {
    const Vec3 w_B = motion_.w_B_at(t_s).stableNormalized();
    const auto [a, b, c] = axes_;
    const double Ia = I_[a], Ib = I_[b], Ic = I_[c], wa2 = w_B[a] * w_B[a], wc2 = w_B[c] * w_B[c];
    const double L2 = Ia * Ia * wa2 + Ic * Ic * wc2;
    const double L2_middle = Ib * (Ic - Ia) * std::min(Ia * wa2 / (Ic - Ib), Ic * wc2 / (Ib - Ia));
    return L2_middle > kFlipsNearer * kFlipsNearer * L2;
  }

  const Motion& motion_;
  const PrincipalMoments& I_;
  std::array<int, 3> axes_;
};

}  // namespace

bool keeps_flipping(const PrincipalMoments& moments, const Vec3& w_B) {
  const auto [a, b, c] = axes_by_moment(moments);
  const double Ia = moments[a], Ib = moments[b], Ic = moments[c];
  if (!(Ia < Ib && Ib < Ic)) return false;
  // The scale of ω does not matter: squares stay within the range of numbers.
  const Vec3 w = w_B.stableNormalized();
  const double two_T = Ia * w[a] * w[a] + Ib * w[b] * w[b] + Ic * w[c] * w[c];
  const double L2 = Ia * Ia * w[a] * w[a] + Ib * Ib * w[b] * w[b] + Ic * Ic * w[c] * w[c];
  // L_b² is least where it is 0, if L² is beside 2T I_b: on either side of the separatrix it passes there.
  if (L2 == two_T * Ib) return false;
  const double most = std::min(Ib * (two_T * Ic - L2) / (Ic - Ib), Ib * (L2 - two_T * Ia) / (Ib - Ia));
  return most > kFlipsNearer * kFlipsNearer * L2;
}

std::vector<double> flip_times(const Motion& motion, const PrincipalMoments& moments, double from_s,
                               double to_s) {
  const FlipSearch search(motion, moments);
  if (!search.can_flip() || !(from_s < to_s) || !std::isfinite(to_s - from_s)) return {};
  return search.in(from_s, to_s);
}

}  // namespace polhode
