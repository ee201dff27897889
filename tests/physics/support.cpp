// SPDX-License-Identifier: MIT
#include "tests/physics/support.h"

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

}  // namespace

const std::vector<ReferenceCase>& reference_cases() {
  static const std::vector<ReferenceCase> cases = [] {
    std::ifstream file(std::string(POLHODE_SOURCE_DIR) + "/tests/reference/torque_free.json");
    std::vector<ReferenceCase> read;
    const Json whole = Json::parse(file);
    for (const Json& json : whole.at("cases")) read.push_back(read_case(json));
    return read;
  }();
  return cases;
}

const ReferenceCase& reference_case(const std::string& name) {
  for (const ReferenceCase& c : reference_cases()) {
    if (c.name == name) return c;
  }
  throw std::runtime_error("no reference case " + name);
}

double w_error(const Vec3& w, const Vec3& truth) {
  const double size = truth.stableNorm();
  return size == 0 ? w.stableNorm() : (w - truth).stableNorm() / size;
}

double q_error(const Quat& q, const Quat& truth) {
  return std::min((q.coeffs() - truth.coeffs()).norm(), (q.coeffs() + truth.coeffs()).norm());
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
