// SPDX-License-Identifier: MIT
#include "render/figure/builders/extents.h"

#include "physics/analysis/euler_terms.h"
#include "physics/body/euler.h"
#include "physics/exact/powers_of_two.h"
#include "render/scene/model/translation.h"
#include "render/scene/model/transport_arrow.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <functional>
#include <numbers>

namespace polhode::builders {
namespace {

constexpr int kSamples = 24;         // of what only the motion knows, over the span
constexpr double kLine = 0.03;       // half the width of a line or of the head of an arrow
constexpr double kNumberName = 1.0;  // letters of "x" or "1"

/// Whether the centre of mass is seen to leave the origin of S.
bool flies(const Snapshot& m) {
  return m.view == View::space && drifts(m.model.scene) && !m.shows(Overlay::puck);
}

/// A driven motion may grow without end. It is held as far as it has no more than this of the size that it
/// has had up to its still, which lengths are made for.
constexpr double kMostGrowth = 1.3;

double growth_up_to_still(const Snapshot& m, const std::function<double(double t_s)>& size_at) {
  double most = 0.0;
  for (int n = 0; n <= kSamples; ++n) {
    const double size = size_at(still_time_s(m.model.scene) * n / kSamples);
    if (std::isfinite(size)) most = std::max(most, size);
  }
  return kMostGrowth * most;
}

RigidBodyState state_at(const SceneModel& model, double t_s) {
  RigidBodyState state{Quat::Identity(), model.scene.w0_B};
  if (model.needs.attitude)
    state = model.motion->at(t_s);
  else if (model.needs.omega)
    state.w_B = model.motion->w_B_at(t_s);
  return state;
}

/// Of the motion, at even times over the span and at that of the still; at least one.
std::vector<RigidBodyState> sampled_states(const Snapshot& m, std::vector<double>* times_s = nullptr) {
  const SceneModel& model = m.model;
  const bool is_driven = !model.scene.torque.empty();
  const double most =
      is_driven ? growth_up_to_still(m, [&](double t_s) { return state_at(model, t_s).w_B.norm(); }) : 0.0;
  std::vector<RigidBodyState> states;
  for (int n = 0; n <= kSamples + 1; ++n) {
    const double t_s = n > kSamples ? still_time_s(model.scene) : model.span_s * n / kSamples;
    const RigidBodyState state = state_at(model, t_s);
    if (!state.w_B.allFinite() || !state.q_SB.coeffs().allFinite()) continue;
    if (is_driven && state.w_B.norm() > most) continue;
    states.push_back(state);
    if (times_s != nullptr) times_s->push_back(t_s);
  }
  if (!states.empty()) return states;
  if (times_s != nullptr) times_s->push_back(0.0);
  return {{model.q0_SB, model.scene.w0_B}};
}

/// Points of the polhode, its vertices among them; what chords cut off is less than the margins. With c the
/// axis that it goes round, a and b the others: ω = (A cos φ, B sin φ, ...), and the rest of the energy along
/// c (physics/geometry/poinsot.h), at a fraction of what a curve to be drawn costs.
std::vector<Vec3> points_of_polhode(const PrincipalMoments& I, const Vec3& w_B) {
  constexpr int kPoints = 16;
  std::array<int, 3> axes = {0, 1, 2};
  std::sort(axes.begin(), axes.end(), [&](int i, int k) { return I[i] < I[k]; });
  const double size = norm_of(w_B);
  const Vec3 w = w_B / size;
  const auto [least, b, most] = axes;
  const bool round_most = I[most] * (I[most] - I[b]) * w[most] * w[most] >=
                          I[least] * (I[b] - I[least]) * w[least] * w[least];  // L² ≥ 2T I_b
  const int c = round_most ? most : least, a = round_most ? least : most;
  // 2T I_c − L², of which both amplitudes are parts, as a sum of terms of one sign.
  const double of_a = I[a] * (I[c] - I[a]), of_b = I[b] * (I[c] - I[b]);
  const auto amplitude = [](double own, double other, double ratio) {
    return other == 0.0 || !std::isfinite(ratio) ? std::abs(own)
                                                 : std::sqrt(own * own + ratio * other * other);
  };
  const double A = amplitude(w[a], w[b], of_b / of_a), B = amplitude(w[b], w[a], of_a / of_b);
  const double two_T = I[a] * w[a] * w[a] + I[b] * w[b] * w[b] + I[c] * w[c] * w[c];
  std::vector<Vec3> points;
  for (int k = 0; k < kPoints; ++k) {
    const double phi = 2.0 * std::numbers::pi * k / kPoints;
    Vec3 point;
    point[a] = A * std::cos(phi);
    point[b] = B * std::sin(phi);
    const double rest = two_T - I[a] * point[a] * point[a] - I[b] * point[b] * point[b];
    point[c] = std::copysign(std::sqrt(std::max(0.0, rest) / I[c]), w[c]);
    points.push_back(size * point);
  }
  return points;
}

/// How what is fixed in the body, in space, or to ω moves in the view.
class Film {
 public:
  explicit Film(const Snapshot& m) : m_(m) {
    const Scene& scene = m.model.scene;
    const bool rests = scene.w0_B.isZero(0.0);
    if (!scene.torque.empty() || flies(m)) {
      is_driven_ = true;
      std::vector<double> times_s;
      states_ = sampled_states(m, &times_s);
      for (const double t_s : times_s)
        if (flies(m)) centers_V_.push_back(center_of_mass_V(m, t_s));
    } else if (rests) {
      states_.push_back({m.model.q0_SB, scene.w0_B});
      is_driven_ = true;  // by nothing: one state is all there is
    } else {
      for (const Vec3& w_B : points_of_polhode(m.I(), scene.w0_B)) states_.push_back({Quat::Identity(), w_B});
      L_direction_V_ = m.model.q0_SB * angular_momentum_B(m.I(), scene.w0_B).stableNormalized();
    }
  }

  const std::vector<RigidBodyState>& states() const { return states_; }
  /// From the origin of S to the centre of mass in a state of the sampled film.
  Vec3 center_V(const RigidBodyState& state) const {
    return centers_V_.empty() ? Vec3(Vec3::Zero())
                              : centers_V_[static_cast<std::size_t>(&state - states_.data())];
  }
  /// Whether states say how the body lies; else they say ω alone, and the body may have turned about L.
  bool is_driven() const { return is_driven_; }

  /// A vector that the body has in this state, in body components.
  void add(const RigidBodyState& state, const Vec3& v_B, double radius, Extents& extents,
           double letters = 0) const {
    const auto add_at = [&](const Vec3& from_V, const Vec3& v_V) {
      extents.push_back(ball_at(from_V + v_V, radius));
      if (letters > 0) extents.push_back(name_beyond(from_V + v_V, from_V, letters));
    };
    if (m_.view == View::body) return add_at(Vec3::Zero(), v_B);
    if (is_driven_) return add_at(center_V(state), state.q_SB * v_B);
    const Vec3 L_B = angular_momentum_B(m_.I(), state.w_B).stableNormalized();
    const double along = v_B.dot(L_B);
    add_ring(along, (v_B - along * L_B).norm(), radius, extents);
    if (letters > 0) {
      const Extent name = name_beyond(v_B, Vec3::Zero(), letters);
      const double named = name.center.dot(L_B);
      add_ring(named, (name.center - named * L_B).norm(), name.spread(0, 0), extents, name.aside);
    }
  }

  /// A vector fixed in the body.
  void add_of_body(const Vec3& v_B, double radius, Extents& extents, double letters = 0) const {
    if (m_.view == View::body) return add(states_.front(), v_B, radius, extents, letters);
    for (const RigidBodyState& state : states_) add(state, v_B, radius, extents, letters);
  }

  /// A vector fixed in space.
  void add_of_space(const Vec3& v_S, double radius, Extents& extents, double letters = 0) const {
    const auto add_at = [&](const Vec3& v_V) {
      extents.push_back(ball_at(v_V, radius));
      if (letters > 0) extents.push_back(name_beyond(v_V, Vec3::Zero(), letters));
    };
    if (m_.view == View::space) return add_at(v_S);
    if (is_driven_)
      for (const RigidBodyState& state : states_) add_at(state.q_SB.conjugate() * v_S);
    else
      extents.push_back(ball_at(Vec3::Zero(), v_S.norm() + 2.0 * radius + (letters > 0 ? 0.1 : 0.0)));
  }

  /// A surface of revolution about L, or about the centre.
  void add_ring(double along_L, double across, double radius, Extents& extents, double aside = 0) const {
    Extent ring = disc_at(along_L * L_direction_V_, L_direction_V_, across + radius);
    ring.spread += radius * L_direction_V_ * L_direction_V_.transpose();
    ring.aside = aside;
    extents.push_back(ring);
  }

 private:
  const Snapshot& m_;
  std::vector<RigidBodyState> states_;
  std::vector<Vec3> centers_V_;
  bool is_driven_ = false;
  Vec3 L_direction_V_ = Vec3::UnitZ();
};

/// Under a torque the surfaces swell with the energy of the moment.
void add_extents_of_surfaces(const Snapshot& m, const Film& film, Extents& extents) {
  const bool on_ellipsoid = m.L_scale == 0.0 && (m.shows(Overlay::polhode_family) ||
                                                 m.shows(Overlay::separatrix) || m.shows(Overlay::polhode));
  const bool energy = m.shows(Overlay::energy_ellipsoid) || on_ellipsoid;
  const bool momentum = m.shows(Overlay::momentum_ellipsoid);
  const bool sphere = m.shows(Overlay::momentum_sphere);
  const bool alone = on_ellipsoid && !m.shows(Overlay::energy_ellipsoid) && !m.shows(Overlay::separatrix) &&
                     !m.shows(Overlay::polhode_family);
  for (const RigidBodyState& state : film.states()) {
    if (state.w_B.isZero(0.0)) continue;
    const double L = norm_of(angular_momentum_B(m.I(), state.w_B));
    const auto add = [&](const Vec3& semi_axes, double flat) {
      if (m.view == View::body || film.is_driven()) {
        const Mat3 q = m.view == View::body ? Mat3(Mat3::Identity()) : state.q_SB.toRotationMatrix();
        extents.push_back({film.center_V(state), q * semi_axes.asDiagonal() * q.transpose()});
        return;
      }
      // It turns about L, between the two planes that it touches.
      const double reach = semi_axes.maxCoeff();
      for (const double part : {-1.0, -0.7, -0.35, 0.0, 0.35, 0.7, 1.0}) {
        const double along = part * std::min(flat, reach);
        film.add_ring(along, std::sqrt(std::max(0.0, reach * reach - along * along)), 0.0, extents);
      }
    };
    const double plane = invariable_plane_distance(m.I(), state.w_B) * m.omega_scale;
    const Vec3 of_energy = energy_ellipsoid_semi_axes(m.I(), state.w_B) * m.omega_scale;
    if (alone && m.view == View::body)
      film.add(state, state.w_B * m.omega_scale, kLine, extents);
    else if (energy)
      add(of_energy, plane);
    const Vec3 of_momentum = momentum_ellipsoid_semi_axes(m.I(), state.w_B) * m.L_scale;
    if (momentum) add(of_momentum, of_momentum.maxCoeff());
    const Vec3 of_sphere = m.L_scale > 0.0 ? Vec3(Vec3::Constant(L * m.L_scale))
                                           : Vec3(L * m.omega_scale * m.I().vector().cwiseInverse());
    if (sphere) add(of_sphere, of_sphere.maxCoeff());
    if (!film.is_driven()) break;  // all states have one energy
  }
}

void add_extents_of_solid(const Snapshot& m, const Film& film, Extents& extents) {
  if (!m.model.needs.solid || m.shows(Overlay::energy_ellipsoid)) return;
  const bool may_lie_anyhow = is_computed(m.model.scene) || m.turn || m.shows(Overlay::pivot);
  const std::vector<Vec3> corners_B = may_lie_anyhow ? std::vector<Vec3>() : solid_corners_B(m);
  for (const Vec3& corner_B : corners_B) film.add_of_body(corner_B, 0.0, extents);
  if (corners_B.empty())
    for (const RigidBodyState& state : film.states())
      extents.push_back(ball_at(film.center_V(state), kAloneRadius));
  if (!m.shows(Overlay::pivot)) return;
  constexpr double kFoot = -1.12, kFootRadius = 0.42;  // of the stand
  if (m.view == View::space) extents.push_back(disc_at(Vec3(0.0, 0.0, kFoot), Vec3::UnitZ(), kFootRadius));
}

void add_extents_of_axes(const Snapshot& m, const Film& film, Extents& extents) {
  const bool may_lie_anyhow = m.turn || is_computed(m.model.scene);
  const bool stand_elsewhere = flies(m);
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = kTriadLength * Vec3::Unit(i);
    const double letters = m.shows(Overlay::labels) ? kNumberName : 0.0;
    if ((m.shows(Overlay::axes_space) && !stand_elsewhere) || m.turn)
      film.add_of_space(axis, kLine, extents, letters);
    if (!m.shows(Overlay::axes_body)) continue;
    if (may_lie_anyhow && m.view == View::space)
      extents.push_back(ball_at(Vec3::Zero(), kTriadLength + 2.0 * kLine));
    else
      film.add_of_body(axis, kLine, extents, letters);
  }
}

void add_extents_of_vectors(const Snapshot& m, const Film& film, Extents& extents) {
  const double letters = m.shows(Overlay::labels) ? 1.0 : 0.0;
  const bool L = m.shows(Overlay::L) || m.shows(Overlay::trail_L);
  const bool omega = m.shows(Overlay::omega) || m.shows(Overlay::trail_omega) || m.shows(Overlay::herpolhode);
  for (const RigidBodyState& state : film.states()) {
    if (state.w_B.isZero(0.0)) continue;
    const Vec3 L_B = angular_momentum_B(m.I(), state.w_B);
    if (omega)
      film.add(state, state.w_B * m.omega_scale, kLine, extents, m.shows(Overlay::omega) ? letters : 0);
    if (L) film.add(state, m.L_drawn_B(L_B), kLine, extents, m.shows(Overlay::L) ? letters : 0);
    const bool torque = m.shows(Overlay::N) && !m.shows(Overlay::terms);
    if (const Vec3 N_B = torque_B(m.model.scene.torque, state); torque && !N_B.isZero(0.0)) {
      const Vec3 tail_B = m.shows(Overlay::L) ? m.L_drawn_B(L_B) : Vec3(Vec3::Zero());
      film.add(state, tail_B + kTorqueLength * N_B.stableNormalized(), kLine, extents, letters);
    }
  }
  if (!is_computed(m.model.scene) || film.is_driven()) return;
  for (const RigidBodyState& state : sampled_states(m)) {  // a computed motion goes its own way
    const Quat q_VB = m.view == View::space ? state.q_SB : Quat::Identity();
    const auto hold = [&](const Vec3& v_B) { extents.push_back(ball_at(q_VB * v_B, kLine)); };
    if (omega) hold(state.w_B * m.omega_scale);
    if (L) hold(m.L_drawn_B(angular_momentum_B(m.I(), state.w_B)));
  }
}

/// The sides of triangles, sampled.
void add_extents_of_sums(const Snapshot& m, Extents& extents) {
  const SceneModel& model = m.model;
  const auto to_view = [&](const RigidBodyState& state, const Vec3& v_S) -> Vec3 {
    return m.view == View::space ? v_S : Vec3(state.q_SB.conjugate() * v_S);
  };
  constexpr double kName = 0.16;
  extents.push_back(ball_at(Vec3::Zero(), kLine));
  const auto hold = [&](const Vec3& at_V) {
    if (at_V.allFinite()) extents.push_back(ball_at(at_V, kName));
  };
  for (int n = 0; n <= kSamples; ++n) {
    const double t_s = model.span_s * n / kSamples;
    const RigidBodyState state = model.motion->at(t_s);
    if (m.shows(Overlay::transport)) {
      const ArrowRates rates = arrow_rates(model, t_s);
      const double speed = norm_of(model.scene.w0_B), scale = speed > 0.0 ? 1.0 / speed : 1.0;
      for (const Vec3& side_S : {Vec3(Vec3::Zero()), rates.star_rate_S, rates.rate_S})
        hold(to_view(state, rates.A_S + scale * side_S));
    }
    if (m.shows(Overlay::terms) && model.longest_term > 0.0) {
      const EulerTerms terms = euler_terms_at(*model.motion, m.I(), model.scene.torque, t_s);
      if (terms.largest() > kMostGrowth * model.longest_term) continue;
      const Vec3 at_B =
          m.shows(Overlay::L) ? m.L_drawn_B(angular_momentum_B(m.I(), state.w_B)) : Vec3(Vec3::Zero());
      if (at_B.norm() > kMostGrowth * m.L_length) continue;
      for (const Vec3& side_B : {Vec3(Vec3::Zero()), terms.inertial_B, terms.gyroscopic_B, terms.N_B}) {
        const Vec3 tip_B = at_B + side_B / model.longest_term;
        hold(m.view == View::body ? tip_B : Vec3(state.q_SB * tip_B));
      }
    }
  }
}

/// Of what goes along with the centre of mass.
Extents extents_round_center(const Snapshot& m, const Film& film) {
  Extents extents;
  add_extents_of_solid(m, film, extents);
  add_extents_of_surfaces(m, film, extents);
  add_extents_of_axes(m, film, extents);
  add_extents_of_vectors(m, film, extents);
  if (!extents.empty()) film.add_of_body(Vec3::Zero(), kLine, extents);  // where arrows begin
  if (m.shows(Overlay::transport) || m.shows(Overlay::terms)) add_extents_of_sums(m, extents);
  Extents marks;
  add_extents_of_marks(m, marks);
  if (!flies(m)) {
    extents.insert(extents.end(), marks.begin(), marks.end());
  } else if (!marks.empty()) {
    const double reach = reach_of(marks);
    for (const RigidBodyState& state : film.states()) extents.push_back(ball_at(film.center_V(state), reach));
  }
  return extents;
}

}  // namespace

// Commands with a backslash count as one, or as nothing where they only dress another.
double letters_of(const std::string& tex) {
  double letters = 0.0;
  for (std::size_t i = 0; i < tex.size(); ++i) {
    if (tex[i] == '\\') {
      std::size_t end = i + 1;
      while (end < tex.size() && std::isalpha(static_cast<unsigned char>(tex[end])) != 0) ++end;
      const std::string command = tex.substr(i + 1, end - i - 1);
      const bool dresses = command == "vec" || command == "dot" || command == "hat" || command == "mathbf" ||
                           command == "ddot" || command == "text" || command == "mathrm";
      letters += dresses ? 0.0 : 1.0;
      i = end - 1;
    } else if (std::strchr("{}$_^ ", tex[i]) == nullptr && (tex[i] & 0xC0) != 0x80) {
      letters += i > 0 && (tex[i - 1] == '_' || tex[i - 1] == '^') ? 0.6 : 1.0;
    }
  }
  return letters;
}

Extent name_beyond(const Vec3& tip, const Vec3& tail, double letters) {
  constexpr double kBeyond = 0.12, kHalfHeight = 0.07, kLetter = 0.05;
  const Vec3 way = tip - tail;
  const double length = way.norm();
  Extent name = ball_at(length > 0.0 ? Vec3(tip + (kBeyond / length) * way) : tip, kHalfHeight);
  name.aside = kLetter * std::max(0.0, letters - 1.0);
  return name;
}

Extents extents_of_drawn(const DrawList& list, const Vec3& center) {
  Extents extents;
  const auto hold = [&](const Vec3& at, double radius) {
    if (at.allFinite()) extents.push_back(ball_at(center + at, radius));
  };
  for (const Tube& tube : list.tubes)
    for (const Vec3& p : tube.points) hold(p, tube.radius);
  for (const Arrow& arrow : list.arrows) {
    hold(arrow.tail, arrow.radius);
    hold(arrow.tip, kLine);
  }
  for (const Ball& ball : list.balls) hold(ball.center, ball.radius);
  for (const Mesh& mesh : list.meshes)
    for (const Vec3& p : mesh.positions) hold(p, 0.0);
  for (const GlassEllipsoid& e : list.ellipsoids) {
    const Mat3 q = e.rotation.toRotationMatrix();
    extents.push_back({center + e.center, q * e.semi_axes.asDiagonal() * q.transpose()});
  }
  for (const Label& label : list.labels) {
    if (!label.anchor.allFinite() || (!list.floors.empty() && label.anchor.z() <= list.floors[0].z)) continue;
    Extent name = name_beyond(label.anchor, Vec3::Zero(), label.size * letters_of(label.text));
    name.center += center;
    extents.push_back(name);
  }
  return extents;
}

double reach_of(const Extents& extents) {
  double reach = 0.0;
  for (const Extent& extent : extents)
    reach = std::max(reach, extent.center.norm() + extent.spread.colwise().norm().maxCoeff());
  return reach;
}

Extents extents_of(const Snapshot& m) {
  const bool in_space = m.view == View::space;
  const bool puck = in_space && m.shows(Overlay::puck);
  Extents extents;
  if (!puck || !puck_alone(m)) extents = extents_round_center(m, Film(m));
  if (in_space && (puck || drifts(m.model.scene))) add_extents_of_translation(m, extents);
  if (extents.empty()) extents.push_back(ball_at(Vec3::Zero(), 1.0));
  return extents;
}

}  // namespace polhode::builders
