// SPDX-License-Identifier: MIT
#include "tests/physics/support.h"

#include "physics/method.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace polhode::test {
namespace {

using Json = nlohmann::json;

double number(const Json& text) { return std::strtod(text.get<std::string>().c_str(), nullptr); }

Vec3 vector3(const Json& texts) { return {number(texts[0]), number(texts[1]), number(texts[2])}; }

ReferenceCase read_case(const Json& json) {
  const Vec3 I = vector3(json["inertia_hex"]);
  ReferenceCase result{json["name"], json["kind"], PrincipalMoments(I[0], I[1], I[2]), {}, 0, {}};
  result.start.w_B = vector3(json["omega0_hex"]);
  result.period_s =
      json["period"].is_null() ? std::numeric_limits<double>::quiet_NaN() : number(json["period"]);
  for (const Json& s : json["states"]) {
    const Json& q = s["q"];
    result.states.push_back(
        {number(s["t_hex"]),
         {Quat(number(q[0]), number(q[1]), number(q[2]), number(q[3])), vector3(s["omega"])},
         s["cond_omega_structured"],
         s["cond_q_structured"]});
  }
  return result;
}

std::vector<ReferenceCase> read_cases(const char* name) {
  std::ifstream file(std::string(POLHODE_SOURCE_DIR) + "/tests/reference/" + name);
  std::vector<ReferenceCase> read;
  const Json whole = Json::parse(file);
  for (const Json& json : whole.at("cases")) read.push_back(read_case(json));
  return read;
}

using VectorL = Eigen::Matrix<long double, 3, 1>;

VectorL in_units(const Vec3& v, int e) {
  return v.cast<long double>().unaryExpr([e](long double x) { return std::scalbn(x, -e); });
}

int exponent(const Vec3& v) { return std::ilogb(std::max(v.cwiseAbs().maxCoeff(), 0x1p-1074)); }

}  // namespace

const std::vector<ReferenceCase>& reference_cases() {
  static const std::vector<ReferenceCase> cases = read_cases("torque_free.json");
  return cases;
}

const std::vector<ReferenceCase>& unseen_cases() {
  static const std::vector<ReferenceCase> cases = read_cases("unseen.json");
  return cases;
}

std::unique_ptr<const Motion> exact_motion(const PrincipalMoments& I, const RigidBodyState& start) {
  return make_motion({I, start, {}}, {Method::exact, {}, {}});
}

Drift drift(const PrincipalMoments& I, const RigidBodyState& start, const RigidBodyState& now) {
  const int e_w = exponent(start.w_B);
  const VectorL moments = in_units(I.vector(), exponent(I.vector()));
  const VectorL w0 = in_units(start.w_B, e_w), w = in_units(now.w_B, e_w);
  const VectorL L0 = moments.cwiseProduct(w0), L = moments.cwiseProduct(w);
  const long double T0 = L0.dot(w0) / 2, T = L.dot(w) / 2, G0 = L0.norm(), G = L.norm();
  if (G0 == 0) return {static_cast<double>(T), static_cast<double>(G), 0};

  const long double grid = std::scalbn(1.0L, -1074 - e_w);
  const VectorL grid_L = moments * grid;
  const long double slack_T = (w.cwiseAbs() + VectorL::Constant(grid)).dot(grid_L) / T0;
  const long double slack_L = grid_L.norm() / G0;
  const VectorL before_S = start.q_SB.cast<long double>().normalized() * (L0 / G0).eval();
  const VectorL after_S = now.q_SB.cast<long double>().normalized() * (L / G).eval();
  const long double direction = std::atan2(before_S.cross(after_S).norm(), before_S.dot(after_S));
  const auto beyond = [](long double change, long double slack) {
    return static_cast<double>(std::max(0.0L, change - slack));
  };
  return {beyond(std::abs(T - T0) / T0, slack_T), beyond(std::abs(G - G0) / G0, slack_L),
          beyond(direction, slack_L)};
}

const ReferenceCase& reference_case(std::string_view name) {
  for (const ReferenceCase& c : reference_cases()) {
    if (c.name == name) return c;
  }
  throw std::runtime_error("no reference case " + std::string(name));
}

double w_error(const Vec3& w, const Vec3& truth) {
  const double size = truth.stableNorm();
  return size == 0 ? w.stableNorm() : (w - truth).stableNorm() / size;
}

double q_error(const Quat& q, const Quat& truth) {
  return std::min((q.coeffs() - truth.coeffs()).norm(), (q.coeffs() + truth.coeffs()).norm());
}

Eigen::Vector4d attitude_rate(const Quat& q_SB, const Vec3& w_B) {
  return 0.5 * (q_SB * Quat(0, w_B[0], w_B[1], w_B[2])).coeffs();
}

bool same_bits(const RigidBodyState& x, const RigidBodyState& y) {
  return std::memcmp(x.w_B.data(), y.w_B.data(), sizeof(double) * 3) == 0 &&
         std::memcmp(x.q_SB.coeffs().data(), y.q_SB.coeffs().data(), sizeof(double) * 4) == 0;
}

Vec3 Random::vector(double size) {
  return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
}

Quat Random::attitude() {
  std::normal_distribution<double> normal;
  Quat q(normal(engine_), normal(engine_), normal(engine_), normal(engine_));
  return q.normalized();
}

// Moments are sums of second moments x, y, z ≥ 0, in pairs: every such triple is a body.
PrincipalMoments Random::moments() {
  const double x = uniform(0.01, 1), y = uniform(0.01, 1), z = uniform(0.01, 1);
  return {y + z, z + x, x + y};
}

PrincipalMoments Random::symmetric_moments() {
  const double equal = uniform(0.5, 1.5);
  Vec3 I = Vec3::Constant(equal);
  I[std::uniform_int_distribution<int>(0, 2)(engine_)] = equal * uniform(0.01, 1.99);
  return {I[0], I[1], I[2]};
}

}  // namespace polhode::test
