// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/camera_keys.h"

#include "base/angles.h"
#include "base/spelling.h"
#include "lessons/reader/scene/scene_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

void read_azimuth(const TomlEntry& entry, double& azimuth_rad, Report& report) {
  if (const auto degrees = read_number(entry, report))
    azimuth_rad = std::remainder(*degrees, 360.0) * kRadiansPerDegree;
}

void read_elevation(const TomlEntry& entry, double& elevation_rad, Report& report) {
  const auto degrees = read_number(entry, report);
  if (!degrees) return;
  if (std::abs(*degrees) <= kMostElevationDeg)
    elevation_rad = *degrees * kRadiansPerDegree;
  else
    report.error(entry.value.place, fmt::format("\"elevation_deg\" must lie between {} and {}",
                                                -kMostElevationDeg, kMostElevationDeg));
}

void read_hold(const TomlEntry& entry, CameraSpec& camera, Report& report) {
  const auto text = read_text(entry, report);
  if (!text) return;
  if (*text == "still" || *text == "film")
    camera.holds_still = *text == "still";
  else
    report.error(entry.value.place, "\"hold\" must be \"film\" or \"still\"");
}

void read_fitted(const TomlEntry& entry, CameraSpec& camera, Report& report) {
  const TomlTable* table = read_table(entry, "fitted = { azimuth_deg = 35, elevation_deg = 20 }", report);
  if (table == nullptr) return;
  CameraFit fit{CameraSpec{}.azimuth_rad, CameraSpec{}.elevation_rad};
  read_keys(*table, "the fitted camera",
            {{"azimuth_deg", [&](const TomlEntry& e) { read_azimuth(e, fit.azimuth_rad, report); }},
             {"elevation_deg", [&](const TomlEntry& e) { read_elevation(e, fit.elevation_rad, report); }},
             {"omega", [&](const TomlEntry& e) { fit.w0_B = read_vector(e, report); }},
             {"attitude", [&](const TomlEntry& e) { fit.attitude = read_attitude(e, report); }}},
            report);
  camera.fitted = fit;
}

/// Of the camera: what lies outside shows nothing, and is most likely a slip.
std::optional<double> read_scale(const TomlEntry& entry, Report& report) {
  const auto number = read_positive_number(entry, report);
  if (!number || (*number >= kLeastCameraScale && *number <= kMostCameraScale)) return number;
  report.error(entry.value.place, fmt::format("{} must lie between {} and {}", in_quotes(entry.key),
                                              kLeastCameraScale, kMostCameraScale));
  return std::nullopt;
}

}  // namespace

std::optional<AttitudeSpec> read_attitude(const TomlEntry& entry, Report& report) {
  if (const auto* name = entry.value.as<std::string>()) {
    if (*name == "L-down") return LPoints::down;
    if (*name == "L-up") return LPoints::up;
    report_unknown("attitude", {*name, entry.value.place}, {"L-down", "L-up", "[w, x, y, z]"}, report);
    return std::nullopt;
  }
  const auto wxyz = read_numbers(entry, 4, report);
  if (!wxyz) return std::nullopt;
  if (std::any_of(wxyz->begin(), wxyz->end(), [](double x) { return x != 0; })) return attitude_from(*wxyz);
  report.error(entry.value.place, "the quaternion of an attitude must not be zero");
  return std::nullopt;
}

std::optional<CameraSpec> read_camera(const TomlEntry& entry, Report& report) {
  const TomlTable* table = read_table(entry, "camera = { azimuth_deg = 35, elevation_deg = 20 }", report);
  if (table == nullptr) return std::nullopt;
  CameraSpec camera;
  read_keys(*table, "the camera",
            {{"azimuth_deg", [&](const TomlEntry& e) { read_azimuth(e, camera.azimuth_rad, report); }},
             {"elevation_deg", [&](const TomlEntry& e) { read_elevation(e, camera.elevation_rad, report); }},
             {"distance",
              [&](const TomlEntry& e) { camera.distance = read_scale(e, report).value_or(camera.distance); }},
             {"zoom", [&](const TomlEntry& e) { camera.zoom = read_scale(e, report).value_or(camera.zoom); }},
             {"fitted", [&](const TomlEntry& e) { read_fitted(e, camera, report); }},
             {"hold", [&](const TomlEntry& e) { read_hold(e, camera, report); }}},
            report);
  return camera;
}

}  // namespace polhode
