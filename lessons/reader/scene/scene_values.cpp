// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/scene_values.h"

#include "base/angles.h"
#include "lessons/reader/front_matter/toml_text.h"
#include "lessons/reader/scene/scene_keys.h"
#include "physics/body/torque_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace polhode {

namespace {

// Numbers that the reader turns into others: the text is sought that gives the ones there are.

/// What reads as this angle: whole 1e-4° of a writable camera, else some ulps from the quotient.
double degrees_that_read_as(double angle_rad) {
  constexpr double kParts = 1e4;
  const auto reads = [&](double degrees) {
    return std::remainder(degrees, 360.0) * kRadiansPerDegree == angle_rad;
  };
  const double near = angle_rad * kDegreesPerRadian, whole = std::round(near * kParts) / kParts;
  if (reads(whole)) return whole;
  double above = near, below = near;
  for (int ulps = 0; ulps < 8; ++ulps) {
    if (reads(above)) return above;
    if (reads(below)) return below;
    above = std::nextafter(above, 1e9);
    below = std::nextafter(below, -1e9);
  }
  return near;
}

/// A direction is read by dividing it by its length, which may move the last digits of a unit vector: of what
/// is an ulp or none beside a multiple of it, some reads as itself.
template <class Reads>
std::vector<double> that_reads(const std::vector<double>& unit, const Reads& reads) {
  constexpr int kMultiples = 100;
  const auto sides = static_cast<int>(std::pow(3, unit.size()));
  for (int factor = 1; factor <= kMultiples; ++factor)
    for (int side = 0; side < sides; ++side) {
      std::vector<double> beside;
      for (int rest = side; beside.size() < unit.size(); rest /= 3) {
        const double x = factor * unit[beside.size()];
        beside.push_back(rest % 3 == 0 ? x : std::nextafter(x, rest % 3 == 1 ? HUGE_VAL : -HUGE_VAL));
      }
      if (reads(beside)) return beside;
    }
  return unit;
}

std::vector<double> wxyz_that_read_as(const Quat& q) {
  const std::vector<double> short_one = wxyz_in_short(q);
  const auto reads = [&](const std::vector<double>& v) { return attitude_from(v) == q; };
  return reads(short_one) ? short_one : that_reads({q.w(), q.x(), q.y(), q.z()}, reads);
}

std::string text_of(const HeavyTop& top) {
  const auto text = [&](const std::vector<double>& axis) {
    return fmt::format("heavy:{},{}", top.mgr, fmt::join(axis, ","));
  };
  return text(that_reads({top.axis_B[0], top.axis_B[1], top.axis_B[2]}, [&](const auto& axis) {
    const Result<TorqueTerm> read = parse_torque_term(text(axis));
    return read && *read == TorqueTerm(top);
  }));
}

std::string text_of(const SpaceTorque& torque) { return fmt::format("space:{}", fmt::join(torque.N_S, ",")); }
std::string text_of(const BodyTorque& torque) { return fmt::format("body:{}", fmt::join(torque.N_B, ",")); }
std::string text_of(const LinearDamping& damping) { return fmt::format("damping:{}", damping.c); }
std::string text_of(const EnergySink& sink) { return fmt::format("sink:{}", sink.c); }

}  // namespace

std::vector<double> wxyz_in_short(const Quat& q_SB) {
  constexpr double kParts = 1e12;
  const double largest = q_SB.coeffs().cwiseAbs().maxCoeff();
  std::vector<double> wxyz;
  for (double x : {q_SB.w(), q_SB.x(), q_SB.y(), q_SB.z()})
    wxyz.push_back(std::round(x / largest * kParts) / kParts);
  return wxyz;
}

std::string text_of(const AttitudeSpec& attitude) {
  if (const auto* q = std::get_if<Quat>(&attitude)) return toml(wxyz_that_read_as(*q));
  return toml(std::get<LPoints>(attitude) == LPoints::down ? "L-down" : "L-up");
}

std::string text_of(const Torque& torque) {
  std::vector<std::string> terms;
  for (const TorqueTerm& term : torque)
    terms.push_back(std::visit([](const auto& one) { return text_of(one); }, term));
  return toml_list(terms);
}

std::string text_of(ArrowHeld arrow) {
  if (arrow == ArrowHeld::in_space) return toml("space");
  return toml(arrow == ArrowHeld::in_body ? "body" : "free");
}

std::string text_of(const MotionSpec& motion) {
  std::vector<std::string> keys;
  if (motion.method) keys.push_back(fmt::format("method = \"{}\"", name_of(*motion.method)));
  if (motion.step_s) keys.push_back("step = " + toml(*motion.step_s));
  if (motion.tolerance) keys.push_back("tolerance = " + toml(*motion.tolerance));
  if (motion.ghost) keys.push_back("ghost = true");
  return fmt::format("{{ {} }}", fmt::join(keys, ", "));
}

std::string text_of(const std::vector<View>& views) {
  std::vector<std::string> names;
  for (View view : views) names.emplace_back(view == View::space ? "space" : "body");
  return toml_list(names);
}

std::string text_of(const OverlaySet& shown) {
  std::vector<std::string> names;
  for (const std::string& name : overlay_names())
    if (shown.contains(*overlay_from(name))) names.push_back(name);
  return toml_list(names);
}

std::string text_of(const ComparedMethods& compared) {
  std::vector<std::string> names;
  for (const Method method : compared.methods) names.emplace_back(name_of(method));
  std::string text;
  if (!names.empty()) text += "methods = " + toml_list(names);
  if (compared.by_evaluations) text += (text.empty() ? "" : ", ") + std::string("against = \"evaluations\"");
  return text.empty() ? "{}" : "{ " + text + " }";
}

std::string text_of(const CameraSpec& camera) {
  const auto angles = [](double azimuth_rad, double elevation_rad) {
    return fmt::format("azimuth_deg = {}, elevation_deg = {}", toml(degrees_that_read_as(azimuth_rad)),
                       toml(degrees_that_read_as(elevation_rad)));
  };
  std::string text =
      fmt::format("{{ {}, distance = {}, zoom = {}", angles(camera.azimuth_rad, camera.elevation_rad),
                  toml(camera.distance), toml(camera.zoom));
  if (camera.holds_still) text += ", hold = \"still\"";
  if (camera.fitted)
    text += fmt::format(
        ", fitted = {{ {}{}{} }}", angles(camera.fitted->azimuth_rad, camera.fitted->elevation_rad),
        camera.fitted->w0_B ? ", omega = " + toml(*camera.fitted->w0_B) : std::string(),
        camera.fitted->attitude ? ", attitude = " + text_of(*camera.fitted->attitude) : std::string());
  return text + " }";
}

}  // namespace polhode
