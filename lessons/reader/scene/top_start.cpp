// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/top_start.h"

#include "base/angles.h"
#include "base/numbers.h"
#include "base/spelling.h"
#include "lessons/reader/scene/scene_keys.h"
#include "physics/analysis/symmetric_top.h"
#include "physics/body/euler_angles.h"

#include <cmath>

namespace polhode {
namespace {

constexpr int kToldDigits = 7;

std::optional<double> read_theta(const TomlEntry& entry, Report& report) {
  const auto degrees = read_number(entry, report);
  if (!degrees || (*degrees >= 0 && *degrees <= 180)) return degrees;
  report.error(entry.value.place, "\"theta_deg\" must lie between 0 and 180");
  return std::nullopt;
}

std::optional<std::variant<double, SteadyRoot>> read_precession(const TomlEntry& entry, Report& report) {
  const auto* name = entry.value.as<std::string>();
  if (name == nullptr) return read_number(entry, report);
  if (*name == "slow") return SteadyRoot::slow;
  if (*name == "fast") return SteadyRoot::fast;
  report.error(entry.value.place, "unknown precession " + in_quotes(*name),
               "\"slow\", \"fast\", or a rate in rad/s");
  return std::nullopt;
}

Failure<SceneFault> fault(std::string message, std::string hint) {
  return {{std::move(message), std::move(hint)}};
}

/// Of the least spin, so that it is enough when it is typed.
std::string rounded_up(double least) { return digits(least * (1 + 1e-6), kToldDigits); }

Result<double, SceneFault> steady_rate(const TopStart& start, SteadyRoot root, const PrincipalMoments& I,
                                       const Torque& torque) {
  const std::string quoted = root == SteadyRoot::slow ? "\"slow\"" : "\"fast\"";
  bool has_weight = false;
  for (const TorqueTerm& term : torque) {
    const auto* heavy = std::get_if<HeavyTop>(&term);
    has_weight = has_weight || (heavy != nullptr && heavy->mgr != 0);
  }
  if (!has_weight)
    return fault("start: precession = " + quoted + " is that of a top with weight, and there is none",
                 "write torque = \"weight\", or precession as a number, in rad/s");
  const auto top = symmetric_top(I, torque);
  if (!top || top->axis_B.z() == 0)
    return fault(
        "start: a steady precession is that of a top with I1 = I2 and its weight on axis 3; the moments "
        "about the pivot are " +
            digits(I[0], kToldDigits) + ", " + digits(I[1], kToldDigits) + " and " +
            digits(I[2], kToldDigits) + " kg m²",
        "write precession as a number, in rad/s");
  // θ and ω3 as the centre of mass sees them: below the pivot if that is where axis 3 does not point.
  const double side = top->axis_B.z();
  const double cos_theta = side * std::cos(start.theta_deg * kRadiansPerDegree), w3 = side * start.spin;
  const auto steady = steady_precession(*top, cos_theta, w3);
  const std::string at = "theta_deg = " + digits(start.theta_deg, kToldDigits);
  if (!steady) {
    const double least = least_spin(*top, cos_theta);
    return fault(
        "start: no steady precession at " + at + " with spin = " + digits(start.spin, kToldDigits) +
            (least > 0 ? ": it takes at least " + rounded_up(least) + " rad/s" : ": it takes some spin"),
        "let it spin faster, or write precession as a number, in rad/s");
  }
  if (root == SteadyRoot::slow) return steady->slow;
  if (!steady->fast)
    return fault("start: at " + at + " there is one steady precession, the slow one",
                 "write precession = \"slow\"");
  return *steady->fast;
}

}  // namespace

std::optional<TopStart> read_top_start(const TomlEntry& entry, Report& report) {
  const auto* table = entry.value.as<TomlTable>();
  if (table == nullptr) {
    report.error(entry.value.place, "\"start\" takes a table, found " + std::string(entry.value.kind()),
                 "write start = { theta_deg = 60, spin = 100 }");
    return std::nullopt;
  }
  TopStart start;
  bool all_read = true;
  const auto take = [&all_read](auto& target, const auto& value) {
    if (value) target = *value;
    all_read = all_read && value.has_value();
  };
  read_keys(*table, "\"start\"",
            {{"theta_deg", [&](const TomlEntry& e) { take(start.theta_deg, read_theta(e, report)); }},
             {"phi_deg", [&](const TomlEntry& e) { take(start.phi_deg, read_number(e, report)); }},
             {"psi_deg", [&](const TomlEntry& e) { take(start.psi_deg, read_number(e, report)); }},
             {"spin", [&](const TomlEntry& e) { take(start.spin, read_number(e, report)); }},
             {"precession", [&](const TomlEntry& e) { take(start.precession, read_precession(e, report)); }}},
            report);
  for (const char* key : {"theta_deg", "spin"})
    if (table->find(key) == nullptr) {
      report.error(entry.place, std::string("\"start\" lacks ") + in_quotes(key),
                   "write start = { theta_deg = 60, spin = 100 }");
      all_read = false;
    }
  if (!all_read) return std::nullopt;
  return start;
}

Result<RigidBodyState, SceneFault> state_of(const TopStart& start, const PrincipalMoments& I,
                                            const Torque& torque) {
  const bool is_upright = start.theta_deg == 0 || start.theta_deg == 180;
  const auto* root = std::get_if<SteadyRoot>(&start.precession);
  const auto* rate = std::get_if<double>(&start.precession);
  if (is_upright && (root != nullptr || *rate != 0))
    return fault("start: a vertical axis does not precess", "leave precession out, or tilt axis 3");
  const auto phi_rate = root ? steady_rate(start, *root, I, torque) : Result<double, SceneFault>(*rate);
  if (!phi_rate) return Failure<SceneFault>{phi_rate.error()};
  const auto angle = [](double degrees) { return std::remainder(degrees, 360.0) * kRadiansPerDegree; };
  const EulerAngles angles{angle(start.phi_deg), start.theta_deg * kRadiansPerDegree, angle(start.psi_deg)};
  const Quat q = attitude_of(angles);
  const RigidBodyState state{attitude_from({q.w(), q.x(), q.y(), q.z()}),
                             w_B_of(angles, *phi_rate, 0, start.spin)};
  if (!state.w_B.allFinite())
    return fault("start: the precession is too fast to be a number", "choose a smaller spin");
  return state;
}

}  // namespace polhode
