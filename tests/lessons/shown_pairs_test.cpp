// SPDX-License-Identifier: MIT
// The two numbers that a page shows below an equation are those of its two sides: of all equations of all
// lessons, against values that are computed here from the equation as it is printed, not from its claim.
#include "lessons/claims/live_claims.h"
#include "physics/body/euler.h"
#include "render/scene/model/translation.h"
#include "render/scene/model/transport_arrow.h"
#include "tests/lessons/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace polhode {
namespace {

/// A side of a printed equation: a scalar, a vector by its components on the body axes, or 0.
struct Side {
  Side(double scalar) : x(scalar, 0, 0) {}  // numbers and vectors are sides: implicit
  Side(const Vec3& vector_B) : x(vector_B), is_vector(true) {}
  Vec3 x;
  bool is_vector = false;
};
using Sides2 = std::pair<Side, Side>;

/// What equations speak of, from the motion alone. Vectors on the body axes; rates are central differences.
class Now {
 public:
  Now(const SceneModel& model, double t_s) : model_(model), t_s_(t_s), at_(model.motion->at(t_s)) {}

  Vec3 I() const { return model_.scene.body.moments.vector(); }
  Mat3 R() const { return at_.q_SB.toRotationMatrix(); }
  Vec3 w() const { return at_.w_B; }
  Vec3 L() const { return times_I(w()); }
  Vec3 N() const { return torque_B(model_.scene.torque, at_); }
  double T() const { return 0.5 * w().dot(L()); }
  static Vec3 e(int i) { return Vec3::Unit(i - 1); }

  /// d*/dt: of components on the body axes.
  Vec3 star_w() const {
    return rate([](const Now& now) { return now.w(); });
  }
  Vec3 star_L() const { return times_I(star_w()); }
  /// d/dt: of components in space.
  Vec3 ddt_w() const {
    return to_body(rate([](const Now& now) -> Vec3 { return now.R() * now.w(); }));
  }
  Vec3 ddt_L() const {
    return to_body(rate([](const Now& now) -> Vec3 { return now.R() * now.L(); }));
  }
  Vec3 star_e(int i) const {
    return rate([i](const Now&) -> Vec3 { return e(i); });
  }
  Vec3 ddt_e(int i) const {
    return to_body(rate([i](const Now& now) -> Vec3 { return now.R().col(i - 1); }));
  }
  double ddt(const std::function<double(const Now&)>& f) const {
    return rate([&](const Now& now) { return Vec3(f(now), 0, 0); })[0];
  }
  double second_w1() const {
    return ddt([](const Now& now) { return now.star_w()[0]; });
  }

  /// The vertical; u = cos θ of the axis 3; Ω, at which the azimuth of its tip in space grows, and θ̇.
  Vec3 z() const { return to_body(Vec3::UnitZ()); }
  double u() const { return R()(2, 2); }
  double sine() const { return std::hypot(R()(0, 2), R()(1, 2)); }
  double Omega() const {
    const Vec3 tip = R().col(2), speed = R() * w().cross(e(3));
    return (tip[0] * speed[1] - tip[1] * speed[0]) / (sine() * sine());
  }
  double theta_rate() const { return -(R() * w().cross(e(3)))[2] / sine(); }

  double m() const { return translation().mass_kg; }
  Vec3 v() const { return to_body(translation().v_S); }
  Vec3 F() const { return to_body(translation().F_S); }
  Vec3 ddt_v() const {
    return to_body(rate([](const Now& now) { return now.translation().v_S; }));
  }
  Vec3 A() const { return to_body(A_S()); }
  Vec3 ddt_A() const {
    return to_body(rate([](const Now& now) { return now.A_S(); }));
  }
  Vec3 star_A() const {
    return rate([](const Now& now) { return now.A(); });
  }

  /// The tensor on axes turned by 29° about (1, 1, 1), the columns of Q: J_ij = e'_i·I·e'_j.
  Mat3 J() const {
    const Mat3 Q = Eigen::AngleAxisd(0.5, Vec3(1, 1, 1).normalized()).toRotationMatrix();
    Mat3 made;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) made(i, j) = Q.col(i).dot(I().cwiseProduct(Q.col(j)));
    return made;
  }
  Vec3 times_I(const Vec3& x) const { return I().cwiseProduct(x); }
  Vec3 to_body(const Vec3& x_S) const { return R().transpose() * x_S; }

 private:
  template <class F>
  Vec3 rate(const F& f) const {
    constexpr double kStep_s = 1e-3;  // error kStep² of what turns once in some seconds
    const double h = kStep_s / std::max(1.0, w().norm());
    return (8 * (f(Now(model_, t_s_ + h)) - f(Now(model_, t_s_ - h))) -
            (f(Now(model_, t_s_ + 2 * h)) - f(Now(model_, t_s_ - 2 * h)))) /
           (12 * h);
  }
  Translation translation() const { return translation_at(model_.scene, t_s_); }
  Vec3 A_S() const { return arrow_A_S(model_, t_s_, at_.q_SB); }

  const SceneModel& model_;
  double t_s_;
  RigidBodyState at_;
};

/// ω×(I·ω) by its three cofactors.
Vec3 by_cofactors(const Now& s) {
  const Vec3 w = s.w(), L = s.L();
  return {w[1] * L[2] - w[2] * L[1], -(w[0] * L[2] - w[2] * L[0]), w[0] * L[1] - w[1] * L[0]};
}

/// ω1 ω2 ω3 (I3 − I2), and cyclic.
double product(const Now& s, int row) { return s.w().prod() * (s.I()[(row + 2) % 3] - s.I()[(row + 1) % 3]); }
double sum_of_products(const Now& s) { return product(s, 0) + product(s, 1) + product(s, 2); }
/// Left side of (7), (8), (9) without the torque.
double euler_left(const Now& s, int row) {
  const int j = (row + 1) % 3, k = (row + 2) % 3;
  return s.I()[row] * s.star_w()[row] + s.w()[j] * s.w()[k] * (s.I()[k] - s.I()[j]);
}
double T_rate(const Now& s) {
  return s.ddt([](const Now& now) { return now.T(); });
}
double L2_rate(const Now& s) {
  return s.ddt([](const Now& now) { return now.L().squaredNorm(); });
}
double L2_minus_2TI(const Now& s, int i) { return s.L().squaredNorm() - 2 * s.T() * s.I()[i]; }
/// I_i (I_i − I_k) ω_i²: what |L|² − 2T I_k is the sum of.
double part(const Now& s, int i, int k) { return s.I()[i] * (s.I()[i] - s.I()[k]) * s.w()[i] * s.w()[i]; }

double angle(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// The symmetric top: the rate at which ω goes round on the body, L/I1, and the sum of two arrows.
double lambda(const Now& s) { return (s.I()[2] - s.I()[0]) / s.I()[0] * s.w()[2]; }
Vec3 wobble(const Now& s) { return s.L() / s.I()[0]; }
Vec3 sum_of_two_arrows(const Now& s) { return wobble(s) + (1 - s.I()[2] / s.I()[0]) * s.w()[2] * s.e(3); }
double out_of_plane(const Now& s) { return s.L().dot(s.w().cross(s.e(3))); }

/// The heavy top: 1 kg, 10 cm from the pivot; its friction is 0.001 N m s.
constexpr double kWeightTimesArm_Nm = 1.0 * 9.80665 * 0.1, kFriction_Nms = 0.001;
double height_energy(const Now& s) { return kWeightTimesArm_Nm * s.u(); }
double spin_momentum(const Now& s) { return s.I()[2] * s.w()[2]; }
/// Left side of the condition of steady precession.
double steady_left(const Now& s) {
  return spin_momentum(s) * s.Omega() - s.I()[0] * s.Omega() * s.Omega() * s.u();
}
double energy_rate(const Now& s) {
  return s.ddt([](const Now& now) { return now.T() + height_energy(now); });
}
/// Energy without that of the spin.
double rest_energy(const Now& s) { return s.T() + height_energy(s) - 0.5 * spin_momentum(s) * s.w()[2]; }

Vec3 w_x_L(const Now& s) { return s.w().cross(s.L()); }
Vec3 seen_from_body_plus_turn(const Now& s) { return s.star_L() + w_x_L(s); }

// clang-format off
const std::map<std::string, std::function<Sides2(const Now&)>>& printed() {
  static const std::map<std::string, std::function<Sides2(const Now&)>> kPrinted = {
    {"euler-equations/frames-three", [](const Now& s) { return Sides2(s.w()[2], -s.e(1).dot(s.ddt_e(2))); }},
    {"euler-equations/eq1", [](const Now& s) { return Sides2(s.m() * s.ddt_v(), s.F()); }},
    {"euler-equations/eq2", [](const Now& s) { return Sides2(s.ddt_L(), s.N()); }},
    {"euler-equations/rotation-dot", [](const Now& s) { return Sides2(2 * s.L().dot(s.ddt_L()), 2 * s.L().dot(s.N())); }},
    {"euler-equations/rotation-length", [](const Now& s) { return Sides2(L2_rate(s), 2 * s.L().dot(s.N())); }},
    {"euler-equations/eq3", [](const Now& s) { return Sides2(s.m() * s.v(), s.m() * s.v()); }},
    {"euler-equations/momentum-parallel", [](const Now& s) { return Sides2((s.m() * s.v()).cross(s.v()), 0.0); }},
    {"euler-equations/momentum-product", [](const Now& s) { return Sides2(s.m() * s.ddt_v(), s.m() * s.ddt_v()); }},
    {"euler-equations/momentum-ma", [](const Now& s) { return Sides2(s.m() * s.ddt_v(), s.F()); }},
    {"euler-equations/angular-rigid", [](const Now& s) { return Sides2(s.ddt_e(1), s.w().cross(s.e(1))); }},
    {"euler-equations/eq4", [](const Now& s) { return Sides2(s.L(), s.times_I(s.w())); }},
    {"euler-equations/angular-normal", [](const Now& s) { return Sides2(T_rate(s), s.L().dot(s.ddt_w())); }},
    {"euler-equations/contrast-not-parallel", [](const Now& s) { return Sides2(w_x_L(s), 0.0); }},
    {"euler-equations/contrast-hypotenuse", [](const Now& s) {
       const double I1 = s.I()[0], I3 = s.I()[2];
       return Sides2((I3 + I1) * (I3 + I1) - (I3 - I1) * (I3 - I1), 4 * I1 * I3); }},
    {"euler-equations/tensor-symmetric", [](const Now& s) {
       return Sides2(s.w().cross(s.times_I(s.e(1))) - s.times_I(s.w().cross(s.e(1))), s.w()[2] * (s.I()[0] - s.I()[1]) * s.e(2)); }},
    {"euler-equations/tensor-symmetric-rest", [](const Now& s) {
       const Vec3 w = s.w()[2] * s.e(3);  // as its parenthesis has it
       return Sides2(w.cross(s.times_I(s.e(2))) - s.times_I(w.cross(s.e(2))), s.w()[2] * (s.I()[0] - s.I()[1]) * s.e(1)); }},
    {"euler-equations/tensor-rotated", [](const Now& s) {
       const Mat3 I_S = s.R() * s.I().asDiagonal() * s.R().transpose();
       double sum = 0;  // over the body axes
       for (int i = 0; i < 3; ++i) sum += s.I()[i] * s.R()(0, i) * s.R()(1, i);
       return Sides2(I_S(0, 1), sum); }},
    {"euler-equations/vector-transport", [](const Now& s) { return Sides2(s.ddt_L(), seen_from_body_plus_turn(s)); }},
    {"euler-equations/eq5", [](const Now& s) { return Sides2(seen_from_body_plus_turn(s), s.N()); }},
    {"euler-equations/vector-tempting", [](const Now& s) { return Sides2(s.star_L(), s.N()); }},
    {"euler-equations/substitute-from", [](const Now& s) { return Sides2(seen_from_body_plus_turn(s), s.N()); }},
    {"euler-equations/substitute-both", [](const Now& s) { return Sides2(seen_from_body_plus_turn(s), s.N()); }},
    {"euler-equations/substitute-normal", [](const Now& s) { return Sides2(s.L().dot(w_x_L(s)), 0.0); }},
    {"euler-equations/tensor-two-terms", [](const Now& s) { return Sides2(s.star_L(), s.times_I(s.star_w())); }},
    {"euler-equations/tensor-product-rule", [](const Now& s) { return Sides2(s.star_L(), s.times_I(s.star_w())); }},
    {"euler-equations/tensor-outside", [](const Now& s) { return Sides2(s.times_I(s.star_w()) + w_x_L(s), s.N()); }},
    {"euler-equations/omega-transport", [](const Now& s) { return Sides2(s.ddt_w(), s.star_w()); }},
    {"euler-equations/omega-dot", [](const Now& s) { return Sides2(s.ddt_w(), s.star_w()); }},
    {"euler-equations/tensor-collect", [](const Now& s) { return Sides2(seen_from_body_plus_turn(s), s.N()); }},
    {"euler-equations/eq6", [](const Now& s) { return Sides2(s.times_I(s.star_w()) + w_x_L(s), s.N()); }},
    {"euler-equations/euler-moved", [](const Now& s) { return Sides2(s.times_I(s.star_w()), s.N() - w_x_L(s)); }},
    {"euler-equations/euler-solved", [](const Now& s) { return Sides2(s.star_w(), (s.N() - w_x_L(s)).cwiseQuotient(s.I())); }},
    {"euler-equations/determinant", [](const Now& s) { return Sides2(w_x_L(s), by_cofactors(s)); }},
    {"euler-equations/determinant-signs", [](const Now& s) { return Sides2(w_x_L(s), by_cofactors(s)); }},
    {"euler-equations/determinant-first", [](const Now& s) { return Sides2(by_cofactors(s)[0], by_cofactors(s)[0]); }},
    {"euler-equations/determinant-second", [](const Now& s) { return Sides2(by_cofactors(s)[1], by_cofactors(s)[1]); }},
    {"euler-equations/determinant-third", [](const Now& s) { return Sides2(by_cofactors(s)[2], by_cofactors(s)[2]); }},
    {"euler-equations/determinant-cofactors", [](const Now& s) { return Sides2(w_x_L(s), by_cofactors(s)); }},
    {"euler-equations/determinant-flipped", [](const Now& s) { return Sides2(w_x_L(s), by_cofactors(s)); }},
    {"euler-equations/determinant-xyz", [](const Now& s) { return Sides2(w_x_L(s), by_cofactors(s)); }},
    {"euler-equations/components-along-i", [](const Now& s) { return Sides2(euler_left(s, 0) * s.e(1), s.N()[0] * s.e(1)); }},
    {"euler-equations/components-along-two", [](const Now& s) { return Sides2(euler_left(s, 1) * s.e(2), s.N()[1] * s.e(2)); }},
    {"euler-equations/eq7", [](const Now& s) { return Sides2(euler_left(s, 0), s.N()[0]); }},
    {"euler-equations/eq8", [](const Now& s) { return Sides2(euler_left(s, 1), s.N()[1]); }},
    {"euler-equations/eq9", [](const Now& s) { return Sides2(euler_left(s, 2), s.N()[2]); }},
    {"euler-equations/eq10", [](const Now& s) { return Sides2(euler_left(s, 0), 0.0); }},
    {"euler-equations/eq11", [](const Now& s) { return Sides2(euler_left(s, 1), 0.0); }},
    {"euler-equations/eq12", [](const Now& s) { return Sides2(euler_left(s, 2), 0.0); }},
    {"euler-equations/euler-driven", [](const Now& s) { return Sides2(s.I()[2] * s.star_w()[2], s.N()[2] + s.w()[0] * s.w()[1] * (s.I()[0] - s.I()[1])); }},
    {"euler-equations/euler-solved-two", [](const Now& s) { return Sides2(s.star_w()[1], (s.N()[1] - s.w()[2] * s.w()[0] * (s.I()[0] - s.I()[2])) / s.I()[1]); }},
    {"euler-equations/free-tempting", [](const Now& s) { return Sides2(s.star_w(), 0.0); }},
    {"euler-equations/energy-first-row", [](const Now& s) { return Sides2(s.w()[0] * s.I()[0] * s.star_w()[0] + product(s, 0), 0.0); }},
    {"euler-equations/energy-dot", [](const Now& s) { return Sides2(s.w().dot(s.star_L()) + s.w().dot(w_x_L(s)), 0.0); }},
    {"euler-equations/energy-vector", [](const Now& s) { return Sides2(s.w().dot(w_x_L(s)), 0.0); }},
    {"euler-equations/energy-two-products", [](const Now& s) { return Sides2(product(s, 1) + product(s, 2), s.w().prod() * (s.I()[1] - s.I()[2])); }},
    {"euler-equations/energy-vector-L", [](const Now& s) { return Sides2(s.L().dot(w_x_L(s)), 0.0); }},
    {"euler-equations/energy-cancel", [](const Now& s) { return Sides2(sum_of_products(s), 0.0); }},
    {"euler-equations/energy-left", [](const Now& s) { return Sides2(s.w().dot(s.star_L()), 0.0); }},
    {"euler-equations/energy-cancel-tempting", [](const Now& s) { return Sides2(product(s, 0), 0.0); }},
    {"euler-equations/energy-definition", [](const Now& s) { return Sides2(s.T(), 0.5 * s.I().dot(s.w().cwiseAbs2())); }},
    {"euler-equations/energy-conserved", [](const Now& s) { return Sides2(T_rate(s), 0.0); }},
    {"euler-equations/energy-work", [](const Now& s) { return Sides2(T_rate(s), s.N().dot(s.w())); }},
    {"euler-equations/momentum-dot", [](const Now& s) { return Sides2(s.L().dot(s.times_I(s.star_w())), 0.0); }},
    {"euler-equations/momentum-expanded", [](const Now& s) {
       const double I1 = s.I()[0], I2 = s.I()[1], I3 = s.I()[2];
       return Sides2(I1 * (I3 - I2) + I2 * (I1 - I3) + I3 * (I2 - I1), 0.0); }},
    {"euler-equations/momentum-left", [](const Now& s) { return Sides2(s.L().dot(s.star_L()), 0.0); }},
    {"euler-equations/momentum-torque", [](const Now& s) { return Sides2(s.L().dot(s.star_L()), s.L().dot(s.N())); }},
    {"euler-equations/magnitude-square", [](const Now& s) { return Sides2(s.L().squaredNorm(), s.I().cwiseAbs2().dot(s.w().cwiseAbs2())); }},
    {"euler-equations/magnitude-conserved", [](const Now& s) { return Sides2(L2_rate(s), 0.0); }},
    {"euler-equations/magnitude-bounds", [](const Now& s) { return Sides2(2 * s.T() * s.I()[0], 2 * s.T() * s.I()[2]); }},
    {"euler-equations/follows-product", [](const Now& s) { return Sides2(L2_rate(s), 2 * s.L().dot(s.ddt_L())); }},
    {"euler-equations/follows-zero", [](const Now& s) { return Sides2(s.L().dot(s.ddt_L()), 0.0); }},
    {"euler-equations/follows-star", [](const Now& s) { return Sides2(s.L().dot(s.star_L()), 0.0); }},
    {"euler-equations/why-fixed", [](const Now& s) { return Sides2(s.ddt_L(), 0.0); }},
    {"euler-equations/why-star", [](const Now& s) { return Sides2(s.star_L(), -w_x_L(s)); }},
    {"euler-equations/why-tempting", [](const Now& s) { return Sides2(s.star_L(), 0.0); }},
    {"euler-equations/why-positive", [](const Now& s) { return Sides2(s.w().dot(s.L()), 0.0); }},
    {"euler-equations/poinsot-energy", [](const Now& s) { return Sides2(s.w().dot(s.L()), 2 * s.T()); }},
    {"euler-equations/poinsot-distance", [](const Now& s) {
       return Sides2(s.w().dot(s.L()) / s.L().squaredNorm() * s.L(), 2 * s.T() / s.L().squaredNorm() * s.L()); }},
    {"euler-equations/poinsot-square", [](const Now& s) {
       const double two_T = s.w().dot(s.L()), L2 = s.L().squaredNorm();
       return Sides2(two_T * two_T / L2, two_T * two_T / L2); }},
    {"euler-equations/poinsot-normal", [](const Now& s) { return Sides2(T_rate(s), s.L().dot(s.ddt_w())); }},
    {"euler-equations/poinsot-no-slip", [](const Now& s) { return Sides2(s.w().cross(s.w()), 0.0); }},
    {"euler-equations/poinsot-speed", [](const Now& s) { return Sides2(s.ddt_w().norm(), s.star_w().norm()); }},

    {"symmetric-top/third", [](const Now& s) {
       return Sides2(s.I()[2] * s.star_w()[2], (s.I()[0] - s.I()[1]) * s.w()[0] * s.w()[1]); }},
    {"symmetric-top/third-zero", [](const Now& s) { return Sides2(s.star_w()[2], 0.0); }},
    {"symmetric-top/third-false", [](const Now& s) { return Sides2(s.star_w()[2], 0.0); }},
    {"symmetric-top/L-split", [](const Now& s) {
       return Sides2(s.L(), s.I()[0] * s.w() + (s.I()[2] - s.I()[0]) * s.w()[2] * s.e(3)); }},
    {"symmetric-top/lambda", [](const Now& s) { return Sides2(lambda(s), lambda(s)); }},
    {"symmetric-top/turning", [](const Now& s) { return Sides2(s.star_w(), lambda(s) * s.e(3).cross(s.w())); }},
    {"symmetric-top/radius", [](const Now& s) {
       return Sides2(s.ddt([](const Now& now) { return now.w().head<2>().squaredNorm(); }), 0.0); }},
    {"symmetric-top/harmonic", [](const Now& s) { return Sides2(s.second_w1(), -lambda(s) * lambda(s) * s.w()[0]); }},
    {"symmetric-top/L-cone", [](const Now& s) {
       return Sides2(s.ddt([](const Now& now) { return now.L()[2]; }), 0.0); }},
    {"symmetric-top/split", [](const Now& s) { return Sides2(s.w(), sum_of_two_arrows(s)); }},
    {"symmetric-top/coplanar", [](const Now& s) { return Sides2(out_of_plane(s), 0.0); }},
    {"symmetric-top/coplanar-false", [](const Now& s) { return Sides2(out_of_plane(s), 0.0); }},
    {"symmetric-top/coplanar-rest", [](const Now& s) {
       return Sides2(out_of_plane(s), (s.I()[0] - s.I()[1]) * s.w()[0] * s.w()[1]); }},
    {"symmetric-top/axis-rate", [](const Now& s) { return Sides2(s.ddt_e(3), wobble(s).cross(s.e(3))); }},
    {"symmetric-top/omega-rate", [](const Now& s) { return Sides2(s.ddt_w(), wobble(s).cross(s.w())); }},
    {"symmetric-top/wobble-rate", [](const Now& s) { return Sides2(wobble(s)[2], s.I()[2] / s.I()[0] * s.w()[2]); }},
    {"symmetric-top/rolls", [](const Now& s) {
       return Sides2(lambda(s) * s.e(3).cross(s.w()), wobble(s).cross(s.w())); }},
    {"symmetric-top/outside", [](const Now& s) {
       return Sides2(angle(s.w(), s.L()), angle(s.e(3), s.L()) - angle(s.e(3), s.w())); }},
    {"symmetric-top/inside", [](const Now& s) {
       return Sides2(angle(s.w(), s.L()), angle(s.e(3), s.w()) - angle(s.e(3), s.L())); }},
    {"symmetric-top/flattest", [](const Now& s) { return Sides2(s.I()[2], 2 * s.I()[0]); }},
    {"symmetric-top/flat-plate", [](const Now& s) { return Sides2(s.I()[2], 2 * s.I()[0]); }},
    {"symmetric-top/plate-rate", [](const Now& s) { return Sides2(wobble(s)[2], 2 * s.w()[2]); }},
    {"symmetric-top/ball-rate", [](const Now& s) { return Sides2(wobble(s)[2] / s.w()[2], s.I()[2] / s.I()[0]); }},
    {"symmetric-top/needs-torque", [](const Now& s) { return Sides2(s.ddt_L(), s.N()); }},
    {"symmetric-top/near-constant", [](const Now& s) { return Sides2(s.star_w()[2], 0.0); }},
    {"symmetric-top/near-ellipse", [](const Now& s) {
       const double I1 = s.I()[0], I2 = s.I()[1], I3 = s.I()[2];
       return Sides2(s.second_w1(), -(I3 - I1) * (I3 - I2) / (I1 * I2) * s.w()[2] * s.w()[2] * s.w()[0]); }},
    {"symmetric-top/recap-split", [](const Now& s) { return Sides2(s.w(), sum_of_two_arrows(s)); }},

    {"heavy-top/torque", [](const Now& s) { return Sides2(s.N(), kWeightTimesArm_Nm * s.z().cross(s.e(3))); }},
    {"heavy-top/size", [](const Now& s) { return Sides2(s.N().norm(), kWeightTimesArm_Nm * s.sine()); }},
    {"heavy-top/work", [](const Now& s) { return Sides2(T_rate(s), s.N().dot(s.w())); }},
    {"heavy-top/t-tempting", [](const Now& s) { return Sides2(T_rate(s), 0.0); }},
    {"heavy-top/potential", [](const Now& s) { return Sides2(height_energy(s), height_energy(s)); }},
    {"heavy-top/energy", [](const Now& s) { return Sides2(energy_rate(s), 0.0); }},
    {"heavy-top/vertical", [](const Now& s) {
       return Sides2(s.ddt([](const Now& now) { return now.L().dot(now.z()); }), 0.0); }},
    {"heavy-top/third", [](const Now& s) {
       return Sides2(s.ddt([](const Now& now) { return now.L()[2]; }), out_of_plane(s)); }},
    {"heavy-top/third-term", [](const Now& s) {
       return Sides2(out_of_plane(s), (s.I()[0] - s.I()[1]) * s.w()[0] * s.w()[1]); }},
    {"heavy-top/spin", [](const Now& s) {
       return Sides2(s.ddt([](const Now& now) { return now.L()[2]; }), 0.0); }},
    {"heavy-top/spin-tempting", [](const Now& s) { return Sides2(s.star_w()[2], 0.0); }},
    {"heavy-top/LN-tempting", [](const Now& s) { return Sides2(s.L().dot(s.N()), 0.0); }},
    {"heavy-top/omega-steady", [](const Now& s) {
       return Sides2(s.w(), s.Omega() * s.z() + (s.w()[2] - s.Omega() * s.u()) * s.e(3)); }},
    {"heavy-top/L-steady", [](const Now& s) {
       const double upright = s.I()[0] * s.Omega();
       return Sides2(s.L(), upright * s.z() + (spin_momentum(s) - upright * s.u()) * s.e(3)); }},
    {"heavy-top/compare", [](const Now& s) {
       return Sides2(s.Omega() * s.z().cross(s.L()) - s.N(), (steady_left(s) - kWeightTimesArm_Nm) * s.z().cross(s.e(3))); }},
    {"heavy-top/condition", [](const Now& s) { return Sides2(steady_left(s), kWeightTimesArm_Nm); }},
    {"heavy-top/quadratic", [](const Now& s) { return Sides2(steady_left(s), kWeightTimesArm_Nm); }},
    {"heavy-top/exists", [](const Now& s) {
       const double spin = spin_momentum(s), four_I_u = 4 * s.I()[0] * s.u(), root = spin - 2 * s.I()[0] * s.u() * s.Omega();
       return Sides2(spin * spin - four_I_u * steady_left(s), root * root); }},
    {"heavy-top/law", [](const Now& s) { return Sides2(s.ddt_L(), s.N()); }},
    {"heavy-top/perpendicular", [](const Now& s) { return Sides2(s.L().dot(s.N()), 0.0); }},
    {"heavy-top/tilt", [](const Now& s) {
       return Sides2(s.I()[0] * s.ddt([](const Now& now) { return now.theta_rate(); }),
                     (kWeightTimesArm_Nm - steady_left(s)) * s.sine()); }},
    {"heavy-top/vertical-two", [](const Now& s) {
       return Sides2(s.L().dot(s.z()), spin_momentum(s) * s.u() + s.I()[0] * s.Omega() * s.sine() * s.sine()); }},
    {"heavy-top/rate-of-turn", [](const Now& s) {
       return Sides2(s.Omega(), (s.L().dot(s.z()) - spin_momentum(s) * s.u()) / (s.I()[0] * s.sine() * s.sine())); }},
    {"heavy-top/path-rate", [](const Now& s) {
       return Sides2(s.I()[0] * s.sine() * s.sine() * s.Omega(), s.L().dot(s.z()) - spin_momentum(s) * s.u()); }},
    {"heavy-top/rest-energy", [](const Now& s) { return Sides2(rest_energy(s), rest_energy(s)); }},
    {"heavy-top/rest-constant", [](const Now& s) { return Sides2(s.ddt(rest_energy), 0.0); }},
    {"heavy-top/one-dimension", [](const Now& s) {
       const double falling = 0.5 * s.I()[0] * s.theta_rate() * s.theta_rate();
       const double round = 0.5 * s.I()[0] * std::pow(s.Omega() * s.sine(), 2);
       return Sides2(rest_energy(s), falling + round + height_energy(s)); }},
    {"heavy-top/near-vertical", [](const Now& s) {
       const double spin = spin_momentum(s), u = s.u(), I1 = s.I()[0], mgl = kWeightTimesArm_Nm;
       return Sides2(std::pow(spin - spin * u, 2) / (2 * I1 * (1 - u * u)) + mgl * u - mgl,
                     (1 - u) * (spin * spin / (2 * I1 * (1 + u)) - mgl)); }},
    {"heavy-top/damped-energy", [](const Now& s) { return Sides2(energy_rate(s), -kFriction_Nms * s.w().squaredNorm()); }},
    {"heavy-top/damped-spin", [](const Now& s) {
       return Sides2(s.I()[2] * s.star_w()[2], -kFriction_Nms * s.w()[2]); }},
    {"heavy-top/recap-steady", [](const Now& s) { return Sides2(steady_left(s), kWeightTimesArm_Nm); }},

    {"intermediate-axis/no-torque-balance",
     [](const Now& s) { return Sides2(-w_x_L(s) - s.times_I(s.star_w()), 0.0); }},
    {"intermediate-axis/spins-component", [](const Now& s) {
       return Sides2(w_x_L(s)[0], s.w()[1] * s.w()[2] * (s.I()[2] - s.I()[1])); }},
    {"intermediate-axis/recap-product", [](const Now& s) {
       return Sides2(s.I()[0] * s.star_w()[0] * s.I()[2] * s.star_w()[2],
                     (s.I()[2] - s.I()[1]) * (s.I()[1] - s.I()[0]) * s.w()[1] * s.w()[1] * s.w()[0] * s.w()[2]); }},
    {"intermediate-axis/small-second", [](const Now& s) {
       return Sides2(s.I()[1] * s.star_w()[1], (s.I()[2] - s.I()[0]) * s.w()[2] * s.w()[0]); }},
    {"intermediate-axis/growth-product", [](const Now& s) {
       const double D = s.I()[2] - s.I()[1];
       return Sides2(s.ddt([D](const Now& now) { return -D * now.w()[1] * now.w()[2]; }),
                     -D * (s.star_w()[1] * s.w()[2] + s.w()[1] * s.star_w()[2])); }},
    {"intermediate-axis/growth-exact", [](const Now& s) {
       const double I1 = s.I()[0], I2 = s.I()[1], I3 = s.I()[2];
       return Sides2(s.second_w1(), ((I2 - I1) * (I3 - I2) / (I1 * I3) * s.w()[1] * s.w()[1] -
                                     (I3 - I2) * (I3 - I1) / (I1 * I2) * s.w()[2] * s.w()[2]) * s.w()[0]); }},
    {"intermediate-axis/growth-near", [](const Now& s) {
       const double I1 = s.I()[0], I2 = s.I()[1], I3 = s.I()[2];
       return Sides2(s.second_w1(), (I2 - I1) * (I3 - I2) / (I1 * I3) * s.w()[1] * s.w()[1] * s.w()[0]); }},
    {"intermediate-axis/signs-proof", [](const Now& s) { return Sides2(L2_minus_2TI(s, 0), part(s, 1, 0) + part(s, 2, 0)); }},
    {"intermediate-axis/signs-proof-three", [](const Now& s) { return Sides2(-L2_minus_2TI(s, 2), -part(s, 0, 2) - part(s, 1, 2)); }},
    {"intermediate-axis/signs-saddle", [](const Now& s) { return Sides2(L2_minus_2TI(s, 1), part(s, 2, 1) + part(s, 0, 1)); }},
    {"intermediate-axis/separatrix-constant", [](const Now& s) { return Sides2(-L2_minus_2TI(s, 2), -part(s, 0, 2) - part(s, 1, 2)); }},
    {"intermediate-axis/L-space", [](const Now& s) { return Sides2(s.ddt_L(), 0.0); }},
    {"intermediate-axis/L-along-two", [](const Now& s) { return Sides2(s.L()[1], s.I()[1] * s.w()[1]); }},
    {"intermediate-axis/no-torque-body", [](const Now& s) { return Sides2(s.star_L(), -w_x_L(s)); }},
    {"intermediate-axis/no-torque-plane", [](const Now& s) { return Sides2(s.w().dot(s.L()), 2 * s.T()); }},
    {"intermediate-axis/sink-bounds", [](const Now& s) {
       const double L2 = s.L().squaredNorm();
       return Sides2(L2 / (2 * s.I()[2]), L2 / (2 * s.I()[0])); }},
    {"intermediate-axis/sink-proof", [](const Now& s) { return Sides2(-L2_minus_2TI(s, 2), -part(s, 0, 2) - part(s, 1, 2)); }},
    {"intermediate-axis/extremes-difference", [](const Now& s) { return Sides2(L2_minus_2TI(s, 1), part(s, 2, 1) + part(s, 0, 1)); }},

    {"numerical-lab/task-equations", [](const Now& s) { return Sides2(s.times_I(s.star_w()), s.N() - w_x_L(s)); }},
    {"numerical-lab/lab-length", [](const Now& s) { return Sides2(L2_rate(s), 2 * s.L().dot(s.N())); }},
    {"numerical-lab/order-energy", [](const Now& s) { return Sides2(2 * s.T(), s.I().dot(s.w().cwiseAbs2())); }},
    {"numerical-lab/splitting-parts", [](const Now& s) { return Sides2(s.star_L(), s.L().cross(s.w())); }},
    {"numerical-lab/splitting-energy", [](const Now& s) { return Sides2(s.T(), 0.5 * s.I().dot(s.w().cwiseAbs2())); }},
  };
  return kPrinted;
}
// clang-format on

/// The lines whose sides stand on the page, if they are one equality or a chain of them, whose ends are its
/// two sides; else none.
std::vector<ClaimLine> one_equation(const Claim& claim) {
  std::vector<ClaimLine> lines;
  for (const ClaimLine& line : claim.lines) {
    if (!line.is_side_by_side) continue;
    if (!lines.empty() && !line.goes_on) return {};
    lines.push_back(line);
  }
  return lines;
}

/// Calls `use(name, claim, scene)` for every claim whose two sides a page shows, as
/// app/narration/verdict_row.h has it.
template <class Use>
void for_each_shown_pair(const Use& use) {
  for (const char* id :
       {"euler-equations", "symmetric-top", "intermediate-axis", "heavy-top", "numerical-lab"}) {
    const auto path = test::source_dir() / "lessons" / (std::string(id) + ".md");
    const LessonReading reading = read_lesson(testing::read_file(path), id);
    ASSERT_TRUE(reading.lesson) << id;
    for (const Stage& stage : reading.lesson->stages)
      for (const Step& step : stage.steps)
        for (const Block& block : step.blocks)
          if (const auto* claim = std::get_if<Claim>(&block))
            if (step.scene && !one_equation(*claim).empty() && can_be_shown(*claim, *step.scene))
              use(std::string(id) + '/' + claim->equation, *claim, *step.scene);
  }
}

void expect_side(const Side& side, const std::array<double, 3>& shown, const Now& now, View view,
                 double apart) {
  const Vec3 expected = side.is_vector && view == View::space ? Vec3(now.R() * side.x) : side.x;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(shown[static_cast<std::size_t>(i)], expected[i], apart);
}

TEST(ShownPairs, AreTheTwoSidesOfThePrintedEquation) {
  std::set<std::string> seen;
  for_each_shown_pair([&](const std::string& name, const Claim& claim, const Scene& scene) {
    SCOPED_TRACE(name);
    const auto found = printed().find(name);
    ASSERT_NE(found, printed().end()) << "its printed sides are not written down here";
    seen.insert(name);
    const SceneModel model = make_model(scene);
    for (const double t_s : {still_time_s(scene), 0.37 * model.span_s}) {
      const Now now(model, t_s);
      const auto live = live_state(model, t_s);
      ASSERT_TRUE(live);
      const View view = scene.views.front();
      const auto lines = one_equation(claim);
      const auto first = live_value(lines.front(), *live, view), last = live_value(lines.back(), *live, view);
      ASSERT_TRUE(first && last);
      const auto [left, right] = found->second(now);
      // Rates are differences here and there; a method that goes step by step has kinks between its steps.
      const auto apart = [](const LiveValue& shown) { return (1e-7 + shown.tolerance) * shown.size; };
      expect_side(left, first->left, now, view, apart(*first));
      expect_side(right, last->right, now, view, apart(*last));
    }
  });
  for (const auto& [name, sides] : printed()) EXPECT_TRUE(seen.contains(name)) << name << " shows no pair";
}

}  // namespace
}  // namespace polhode
