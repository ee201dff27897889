// SPDX-License-Identifier: MIT
#include "tests/physics/support.h"

#include "physics/method.h"
#include "tests/support/paths.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <numbers>
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
  std::ifstream file(source_dir() / "tests/reference" / name);
  std::vector<ReferenceCase> read;
  const Json whole = Json::parse(file);
  for (const Json& json : whole.at("cases")) read.push_back(read_case(json));
  return read;
}

using Vec3DoubleDouble = Eigen::Matrix<DoubleDouble, 3, 1>;

// eˣ − 1 of |x| < 0.35, where 0.35²⁵/25! < 2⁻¹⁰⁶ · 0.35.
DoubleDouble expm1_of_small(const DoubleDouble& x) {
  DoubleDouble term = x, sum = x;
  for (int n = 2; n < 25; ++n) sum += term *= x / n;
  return sum;
}

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
  const Vec3DoubleDouble moments = I.vector().cast<DoubleDouble>();
  const Vec3DoubleDouble w0 = start.w_B.cast<DoubleDouble>(), w = now.w_B.cast<DoubleDouble>();
  const Vec3DoubleDouble L0 = moments.cwiseProduct(w0), L = moments.cwiseProduct(w);
  const DoubleDouble T0 = L0.dot(w0) / 2, T = L.dot(w) / 2, G0 = L0.norm(), G = L.norm();
  if (G0 == 0) return {static_cast<double>(T), static_cast<double>(G), 0};

  const DoubleDouble grid = 0x1p-1074;
  const Vec3DoubleDouble grid_L = moments * grid;
  const DoubleDouble slack_T = (w.cwiseAbs() + Vec3DoubleDouble::Constant(grid)).dot(grid_L) / T0;
  const DoubleDouble slack_L = grid_L.norm() / G0;
  const Vec3DoubleDouble before_S = start.q_SB.cast<DoubleDouble>().normalized() * (L0 / G0).eval();
  const Vec3DoubleDouble after_S = now.q_SB.cast<DoubleDouble>().normalized() * (L / G).eval();
  const auto beyond = [](const DoubleDouble& change, const DoubleDouble& slack) {
    const auto rest = static_cast<double>(change - slack);
    return rest < 0 ? 0.0 : rest;  // NaN stays
  };
  const double direction = std::atan2(static_cast<double>(before_S.cross(after_S).norm()),
                                      static_cast<double>(before_S.dot(after_S)));
  return {beyond(abs(T - T0) / T0, slack_T), beyond(abs(G - G0) / G0, slack_L), beyond(direction, slack_L)};
}

SinCosTruth sin_cos(const DoubleDouble& x) {
  const DoubleDouble quarter = std::numbers::pi_v<DoubleDouble> / 2;
  const double quarters = std::nearbyint(static_cast<double>(x / quarter));
  const DoubleDouble r = x - quarters * quarter, minus_r2 = -r * r;
  DoubleDouble sine = r, cosine = 1, sine_term = r, cosine_term = 1;
  for (int n = 1; n < 14; ++n) {  // (π/4)²⁸/28! < 2⁻¹⁰⁶
    cosine += cosine_term *= minus_r2 / (2 * n * (2 * n - 1));
    sine += sine_term *= minus_r2 / (2 * n * (2 * n + 1));
  }
  const std::array<DoubleDouble, 4> sines{sine, cosine, -sine, -cosine};
  const auto quadrant = static_cast<std::size_t>(static_cast<std::int64_t>(quarters) & 3);
  return {sines[quadrant], sines[(quadrant + 1) % 4]};
}

DoubleDouble exp(const DoubleDouble& x) {
  const DoubleDouble ln2 = DoubleDouble::of_parts(0x1.62e42fefa39efp0, 0x1.abc9e3b39803fp-55, -1);
  const double n = std::nearbyint(static_cast<double>(x / ln2));
  return scalbn(1 + expm1_of_small(x - n * ln2), static_cast<int>(n));
}

DoubleDouble expm1(const DoubleDouble& x) { return abs(x) < 0.34 ? expm1_of_small(x) : exp(x) - 1; }

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
