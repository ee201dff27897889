// SPDX-License-Identifier: MIT
#include "physics/integrators/dormand_prince.h"

#include "physics/integrators/checkpoints.h"
#include "physics/integrators/dormand_prince_coefficients.h"
#include "physics/integrators/scaled_problem.h"
#include "physics/integrators/subnormal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace polhode {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr int kSize = MotionVector::kSize;

bool w_is_finite(const MotionVector& y) {
  return std::isfinite(y[0]) && std::isfinite(y[1]) && std::isfinite(y[2]);
}

bool has_subnormal(const MotionVector& y) {
  return std::any_of(y.v, y.v + kSize, [](double x) { return any_subnormal(x); });
}

double largest_w(const MotionVector& y) { return std::max({std::abs(y[0]), std::abs(y[1]), std::abs(y[2])}); }

// ---- Weighted sums of rates, unrolled, without the terms whose weight is 0 --------------------------------

template <class Pair, int i>
struct StageRow {
  static constexpr int kCount = i;
  static constexpr double weight(int j) { return Pair::a[i][j]; }
};
template <class Pair, int i>
struct DenseRow {
  static constexpr int kCount = Pair::kDenseStages;
  static constexpr double weight(int j) { return Pair::d[i][j]; }
};
struct ErrorRow4 {
  static constexpr int kCount = DormandPrince54::kStages;
  static constexpr double weight(int j) { return DormandPrince54::e[j]; }
};
struct ErrorRow5 {
  static constexpr int kCount = DormandPrince853::kStages;
  static constexpr double weight(int j) { return DormandPrince853::e5[j]; }
};
struct ErrorRow3 {
  static constexpr int kCount = DormandPrince853::kStages;
  static constexpr double weight(int j) { return DormandPrince853::e3[j]; }
};

template <class Row, int j>
inline void add_term(double& sum, const MotionVector* k, int n) {
  constexpr double kWeight = Row::weight(j);
  if constexpr (kWeight != 0) sum += kWeight * k[j][n];
}

// Σ_j weight_j k_j. The first weight of every row is not 0.
template <class Row>
inline MotionVector weighted_sum(const MotionVector* k) {
  return [k]<int... j>(std::integer_sequence<int, 0, j...>) {
    MotionVector result;
    for (int n = 0; n < kSize; ++n) {
      double sum = Row::weight(0) * k[0][n];
      (add_term<Row, j>(sum, k, n), ...);
      result[n] = sum;
    }
    return result;
  }
  (std::make_integer_sequence<int, Row::kCount>());
}

inline MotionVector moved(const MotionVector& y, double h, const MotionVector& rate) {
  MotionVector result;
  for (int n = 0; n < kSize; ++n) result[n] = y[n] + h * rate[n];
  return result;
}

// ---- One step ---------------------------------------------------------------------------------------------

// k[0] = ẏ(y) is given. Fills k up to the last stage of the step and returns the solution at its end.
template <class Pair>
MotionVector take_step(const EquationsOfMotion& equations, const MotionVector& y, double h, MotionVector* k) {
  MotionVector stage;
  const auto next = [&]<int i>(std::integral_constant<int, i>) {
    stage = moved(y, h, weighted_sum<StageRow<Pair, i>>(k));
    equations.rate(stage, k[i]);
  };
  [&next]<int... i>(std::integer_sequence<int, 0, i...>) { (next(std::integral_constant<int, i>()), ...); }
  (std::make_integer_sequence<int, Pair::kStages>());
  return stage;
}

// The polynomial of the dense output, nested: c₀ + θ(c₁ + (1−θ)(c₂ + θ(c₃ + (1−θ)(c₄ + ...)))). The first
// four are Hermite's, from y and ẏ at both ends; the method's weights d give the others. HNW §II.6, §II.10.
template <class Pair>
struct DenseOutput {
  static constexpr int kTerms = 4 + Pair::kDenseTerms;
  MotionVector c[kTerms];

  MotionVector at(double theta) const {
    const double factor[2] = {theta, 1.0 - theta};
    MotionVector sum = c[kTerms - 1];
    for (int i = kTerms - 2; i >= 0; --i) sum = moved(c[i], factor[i % 2], sum);
    return sum;
  }
};

// k holds the stages of the step; the extra ones of the dense output are added to it.
template <class Pair>
DenseOutput<Pair> dense_output(const EquationsOfMotion& equations, const MotionVector& y,
                               const MotionVector& end, double h, MotionVector* k) {
  const auto extra_stage = [&]<int i>(std::integral_constant<int, i>) {
    equations.rate(moved(y, h, weighted_sum<StageRow<Pair, Pair::kStages + i>>(k)), k[Pair::kStages + i]);
  };
  [&extra_stage]<int... i>(std::integer_sequence<int, i...>) {
    (extra_stage(std::integral_constant<int, i>()), ...);
  }
  (std::make_integer_sequence<int, Pair::kDenseStages - Pair::kStages>());

  DenseOutput<Pair> dense;
  dense.c[0] = y;
  for (int n = 0; n < kSize; ++n) {
    const double difference = end[n] - y[n];
    dense.c[1][n] = difference;
    dense.c[2][n] = h * k[0][n] - difference;
    dense.c[3][n] = difference - h * k[Pair::kStages - 1][n] - dense.c[2][n];
  }
  const auto upper_term = [&]<int i>(std::integral_constant<int, i>) {
    dense.c[4 + i] = weighted_sum<DenseRow<Pair, i>>(k);
    for (int n = 0; n < kSize; ++n) dense.c[4 + i][n] *= h;
  };
  [&upper_term]<int... i>(std::integer_sequence<int, i...>) {
    (upper_term(std::integral_constant<int, i>()), ...);
  }
  (std::make_integer_sequence<int, Pair::kDenseTerms>());
  return dense;
}

// ---- Error and step control -------------------------------------------------------------------------------

// |v|² with ω in units of w, q absolute.
double squared_norm(const MotionVector& v, double w) {
  const double per_w = 1 / w;
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += (v[i] * per_w) * (v[i] * per_w);
  for (int i = 3; i < 7; ++i) sum += v[i] * v[i];
  return sum;
}

// Unit of ω in errors: see the header. Its floor keeps ω that has died away into the subnormals, where it has
// no digits left to control, from stopping the motion.
double unit_of_w(const MotionVector& before, const MotionVector& after) {
  constexpr double kFloor = 0x1p-960;
  return std::max({largest_w(before), largest_w(after), kFloor});
}

// The error of the step per unit of its length.
double error_rate(DormandPrince54, const MotionVector* k, double w) {
  return std::sqrt(squared_norm(weighted_sum<ErrorRow4>(k), w));
}
double error_rate(DormandPrince853, const MotionVector* k, double w) {
  const double fifth = squared_norm(weighted_sum<ErrorRow5>(k), w);
  const double third = squared_norm(weighted_sum<ErrorRow3>(k), w);
  return fifth == 0 ? 0.0 : fifth / std::sqrt(fifth + 0.01 * third);
}

double root(DormandPrince54, double x) { return std::pow(x, 1.0 / DormandPrince54::kOrder); }
double root(DormandPrince853, double x) { return std::sqrt(std::sqrt(std::sqrt(x))); }

// HNW (4.13). In steps of 1/64, so that the last bit of pow, which not every C library rounds alike, does not
// reach the motion. An error that is not a number counts as a large one.
template <class Pair>
double step_factor(double error_per_tolerance) {
  constexpr double kLeast = 0.2, kMost = 6.0, kSafety = 0.9;
  const double factor = kSafety / root(Pair(), error_per_tolerance);
  if (!(factor > kLeast)) return kLeast;
  return std::floor(64 * std::min(factor, kMost)) / 64;
}

// HNW p. 169, in the rates |ẏ| and |ÿ|^½; a power of two.
template <class Pair>
double starting_step(const EquationsOfMotion& equations, const MotionVector& y, const MotionVector& rate,
                     double h_sign, double tolerance) {
  const double fastest = std::max(largest_w(y), std::sqrt(largest_w(rate)));
  const double trial = fastest == 0 ? 1.0 : 0.01 / fastest;
  const MotionVector then = moved(y, h_sign * trial, rate);
  MotionVector change;
  equations.rate(then, change);
  for (int n = 0; n < kSize; ++n) change[n] -= rate[n];

  const double w = unit_of_w(y, then);
  const double first = std::sqrt(squared_norm(rate, w));
  const double second = std::sqrt(std::sqrt(squared_norm(change, w)) / trial);
  const double h = std::pow(0.01 * tolerance, 1.0 / Pair::kOrder) / std::max(first, second);
  return std::scalbn(1.0, std::ilogb(std::min(h, 100 * trial)));
}

// ---- Units in which the body and its rates are about 1 ----------------------------------------------------

struct Units {
  int inertia, rate;  // exponents of two; torque: inertia + 2 rate, damping: inertia + rate
};

struct TorqueSizes {
  double torque = 0, damping = 0;
  void operator()(const SpaceTorque& term) { torque = std::max(torque, term.N_S.cwiseAbs().maxCoeff()); }
  void operator()(const BodyTorque& term) { torque = std::max(torque, term.N_B.cwiseAbs().maxCoeff()); }
  void operator()(const HeavyTop& term) { torque = std::max(torque, std::abs(term.mgr)); }
  void operator()(const LinearDamping& term) { damping = std::max(damping, std::abs(term.c)); }
  void operator()(const EnergySink&) {}
};

// The rate: the larger of ω and √(N/I), but not so small that the square of a damping's rate, c/I, leaves the
// range.
Units units_of(const Problem& problem) {
  constexpr int kLargestI = 1000;
  const int I_exponent = std::ilogb(problem.I.vector().minCoeff());
  const int largest = std::ilogb(problem.I.vector().maxCoeff());
  const int inertia = std::max((largest + I_exponent) >> 1, largest - kLargestI);
  TorqueSizes sizes;
  for (const TorqueTerm& term : problem.torque) std::visit(sizes, term);

  constexpr int kNone = -10'000, kRange = 400;
  const double w = problem.start.w_B.cwiseAbs().maxCoeff();
  int rate = w > 0 ? std::ilogb(w) : kNone;
  if (sizes.torque > 0) rate = std::max(rate, (std::ilogb(sizes.torque) - I_exponent) >> 1);
  if (sizes.damping > 0) rate = std::max(rate, std::ilogb(sizes.damping) - I_exponent - kRange);
  return {inertia, rate == kNone ? 0 : std::clamp(rate, -1074, 1023)};
}

// ---- Steps one after the other ----------------------------------------------------------------------------

struct Node {
  MotionVector y, rate;         // ẏ(y)
  double t = 0.0, t_low = 0.0;  // time from the start, ≥ 0: their sum, to twice the digits
  double h = 0.0;               // > 0, the step to be tried
  std::int64_t steps = 0, evaluations = 0;

  bool is_alive() const { return w_is_finite(y); }
  bool is_at_or_before(double time) const { return t < time || (t == time && t_low <= 0); }

  // Two-sum (Knuth), then normalised.
  void add_time(double duration) {
    const double sum = t + duration, part = sum - t;
    const double low = t_low + ((t - (sum - part)) + (duration - part));
    t = sum + low;
    t_low = low - (t - sum);
  }
};

// ẏ is linear in q beside its direction, so that the rate at q/|q| is at hand.
void normalise_q(MotionVector& y, MotionVector& rate) {
  const double per_size = 1 / std::sqrt(y[3] * y[3] + y[4] * y[4] + y[5] * y[5] + y[6] * y[6]);
  for (int i = 3; i < 7; ++i) {
    y[i] *= per_size;
    rate[i] *= per_size;
  }
}

RigidBodyState not_a_number() { return {Quat(kNaN, kNaN, kNaN, kNaN), Vec3::Constant(kNaN)}; }

struct Limits {
  double tolerance;
  std::int64_t max_steps;
  Effort effort;
};

// The motion in its own units on one side of t = 0; times are ≥ 0.
template <class Pair>
class Side {
 public:
  // A step with its dense output.
  struct Piece {
    double t, t_low, h;
    DenseOutput<Pair> dense;
    Node end;

    bool contains(double time) const {
      return (t < time || (t == time && t_low <= 0)) && !end.is_at_or_before(time);
    }
    MotionVector at(double time) const { return dense.at(((time - t) - t_low) / h); }
  };

  Side(const EquationsOfMotion& equations, const MotionVector& start, Limits limits, double h_sign)
      : equations_(equations),
        limits_(std::move(limits)),
        h_sign_(h_sign),
        nodes_(
            first(start), [this](Node& node, std::int64_t n) { advance(node, n); },
            [](const Node& node) { return node.is_alive(); }) {}

  std::optional<Piece> piece_at(double t) const {
    const auto is_before = [t](const Node& node) { return node.is_at_or_before(t); };
    const auto node = nodes_.last_before(is_before, limits_.max_steps);
    return node ? piece_from(*node) : std::nullopt;
  }

  // Whether all the steps that may be made end before t.
  bool is_too_far(double t) const {
    const auto last = nodes_.after(limits_.max_steps);
    return last && last->is_at_or_before(t);
  }

  // The same, from a piece that may be at hand and near.
  void move_to(double t, std::optional<Piece>& piece) const {
    for (std::int64_t i = 0; i < decltype(nodes_)::kFirstSpacing && piece; ++i) {
      if (piece->contains(t)) return;
      if (!piece->end.is_at_or_before(t)) break;
      piece = piece_from(Node(piece->end));
    }
    piece = piece_at(t);
  }

 private:
  using Rates = MotionVector[Pair::kDenseStages];

  Node first(const MotionVector& start) const {
    Node node;
    node.y = start;
    equations_.rate(node.y, node.rate);
    node.h = starting_step<Pair>(equations_, node.y, node.rate, h_sign_, limits_.tolerance);
    node.evaluations = 2;
    return node;
  }

  void advance(Node& node, std::int64_t n) const {
    Rates k;
    MotionVector unnormalised;
    for (; n > 0 && node.is_alive(); --n) step(node, k, unnormalised);
  }

  // One accepted step on: its length, in h its stages. Without any the node is dead.
  double step(Node& node, MotionVector* k, MotionVector& end) const {
    const std::int64_t before = node.evaluations;
    const double h = tried_step(node, k, end);
    if (limits_.effort) {
      const bool is_dear = has_subnormal(node.y) || has_subnormal(node.rate);
      spend(limits_.effort, (node.evaluations - before) * (is_dear ? kSubnormalFactor : 1));
    }
    return h;
  }

  double tried_step(Node& node, MotionVector* k, MotionVector& end) const {
    constexpr double kShortest = std::numeric_limits<double>::min(), kLongest = 0x1p1022;
    k[0] = node.rate;
    bool refused = false;
    for (double h = node.h; h >= kShortest && h <= kLongest; refused = true) {
      end = take_step<Pair>(equations_, node.y, h_sign_ * h, k);
      node.evaluations += Pair::kStages - 1;
      const double error = h * error_rate(Pair(), k, unit_of_w(node.y, end)) / limits_.tolerance;
      const double factor = step_factor<Pair>(error);
      if (error <= 1) {
        const bool has_turned = !std::equal(end.v + 3, end.v + 7, node.y.v + 3);
        node.y = end;
        node.rate = k[Pair::kStages - 1];
        if (has_turned) normalise_q(node.y, node.rate);  // at rest, rounding would turn it
        node.add_time(h);
        node.h = std::min(refused ? std::min(factor, 1.0) * h : factor * h, kLongest);
        ++node.steps;
        return h;
      }
      h *= factor;
    }
    node.y[0] = kNaN;
    return kNaN;
  }

  std::optional<Piece> piece_from(const Node& node) const {
    if (node.steps >= limits_.max_steps) return std::nullopt;
    Rates k;
    MotionVector unnormalised;
    Piece piece{node.t, node.t_low, 0.0, {}, node};
    piece.h = step(piece.end, k, unnormalised);
    if (!piece.end.is_alive()) return std::nullopt;
    piece.dense = dense_output<Pair>(equations_, node.y, unnormalised, h_sign_ * piece.h, k);
    return piece;
  }

  EquationsOfMotion equations_;
  Limits limits_;
  double h_sign_;
  Checkpoints<Node> nodes_;
};

double checked_tolerance(double tolerance) {
  if (!(tolerance > 0 && tolerance < 1)) throw std::domain_error("the tolerance must be > 0 and < 1");
  return std::max(tolerance, DormandPrinceMotion::kMinTolerance);
}

// What `with` makes of the coefficients of the pair.
template <class With>
auto with_coefficients(DormandPrincePair pair, const With& with) {
  return pair == DormandPrincePair::five_four ? with(DormandPrince54()) : with(DormandPrince853());
}

}  // namespace

MotionVector dormand_prince_step(DormandPrincePair pair, const EquationsOfMotion& equations,
                                 const MotionVector& y, double h) {
  return with_coefficients(pair, [&]<class Pair>(Pair) {
    MotionVector k[Pair::kDenseStages];
    equations.rate(y, k[0]);
    return take_step<Pair>(equations, y, h, k);
  });
}

MotionVector dormand_prince_dense(DormandPrincePair pair, const EquationsOfMotion& equations,
                                  const MotionVector& y, double h, double theta) {
  return with_coefficients(pair, [&]<class Pair>(Pair) {
    MotionVector k[Pair::kDenseStages];
    equations.rate(y, k[0]);
    const MotionVector end = take_step<Pair>(equations, y, h, k);
    return dense_output<Pair>(equations, y, end, h, k).at(theta);
  });
}

class DormandPrinceMotion::Path {
 public:
  virtual ~Path() = default;
  virtual void at(std::span<const double> t_s, std::span<RigidBodyState> states) const = 0;
  virtual std::int64_t evaluations_to(double t_s) const = 0;
  virtual bool is_too_far(double t_s) const = 0;

  template <class Pair>
  class Of;
};

template <class Pair>
class DormandPrinceMotion::Path::Of final : public Path {
 public:
  Of(const Problem& problem, Limits limits) : Of(problem, units_of(problem), limits) {}

  void at(std::span<const double> t_s, std::span<RigidBodyState> states) const override {
    Cursor cursor;
    for (std::size_t i = 0; i < t_s.size(); ++i) states[i] = t_s[i] == 0 ? start_ : at(t_s[i], cursor);
  }

  std::int64_t evaluations_to(double t_s) const override {
    const double t = in_own_unit(t_s);
    if (t_s == 0 || !std::isfinite(t)) return 0;
    const auto piece = side_of(t_s).piece_at(t);
    return piece ? piece->end.evaluations + Pair::kDenseStages - Pair::kStages : 0;
  }

  bool is_too_far(double t_s) const override {
    const double t = in_own_unit(t_s);
    return !std::isfinite(t) || side_of(t_s).is_too_far(t);
  }

 private:
  Of(const Problem& problem, Units units, Limits limits)
      : Of(problem, in_units(problem, units.inertia, units.rate), std::scalbn(1.0, units.rate), limits) {}

  Of(const Problem& problem, const Problem& in_own_units, double rate_unit, Limits limits)
      : start_(problem.start),
        rate_unit_(rate_unit),
        future_({in_own_units.I, in_own_units.torque}, packed(in_own_units.start), limits, 1.0),
        past_({in_own_units.I, in_own_units.torque}, packed(in_own_units.start), limits, -1.0) {}

  using Pieces = Side<Pair>;
  struct Cursor {
    const Pieces* side = nullptr;
    std::optional<typename Pieces::Piece> piece;
  };

  const Pieces& side_of(double t_s) const { return t_s < 0 ? past_ : future_; }
  double in_own_unit(double t_s) const { return std::abs(t_s) * rate_unit_; }

  RigidBodyState at(double t_s, Cursor& cursor) const {
    const double t = in_own_unit(t_s);
    if (!std::isfinite(t)) return not_a_number();
    if (cursor.side != &side_of(t_s)) cursor = {&side_of(t_s), std::nullopt};
    cursor.side->move_to(t, cursor.piece);
    return cursor.piece ? state(cursor.piece->at(t)) : not_a_number();
  }

  RigidBodyState state(const MotionVector& y) const {
    RigidBodyState result = unpacked(y);
    result.q_SB.normalize();
    result.w_B *= rate_unit_;
    return result.w_B.allFinite() && result.q_SB.coeffs().allFinite() ? result : not_a_number();
  }

  RigidBodyState start_;
  double rate_unit_;  // rad/s, a power of two
  Side<Pair> future_, past_;
};

DormandPrinceMotion::DormandPrinceMotion(DormandPrincePair pair, const Problem& unchecked, double tolerance,
                                         std::int64_t max_steps, const Effort& effort)
    : pair_(pair), tolerance_(checked_tolerance(tolerance)) {
  const Problem problem = checked(unchecked);
  const Limits limits{tolerance_, max_steps, effort};
  path_ = with_coefficients(pair, [&]<class Pair>(Pair) -> std::unique_ptr<const Path> {
    return std::make_unique<const Path::Of<Pair>>(problem, limits);
  });
}

DormandPrinceMotion::~DormandPrinceMotion() = default;

RigidBodyState DormandPrinceMotion::at(double t_s) const {
  RigidBodyState state;
  path_->at({&t_s, 1}, {&state, 1});
  return state;
}

void DormandPrinceMotion::at(std::span<const double> t_s, std::span<RigidBodyState> states) const {
  path_->at(t_s, states);
}

std::int64_t DormandPrinceMotion::evaluations_to(double t_s) const { return path_->evaluations_to(t_s); }

bool DormandPrinceMotion::is_too_far(double t_s) const { return path_->is_too_far(t_s); }

std::string_view DormandPrinceMotion::method() const {
  return pair_ == DormandPrincePair::five_four ? "dormand-prince-5" : "dormand-prince-8";
}

}  // namespace polhode
