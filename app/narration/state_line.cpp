// SPDX-License-Identifier: MIT
#include "app/narration/state_line.h"

#include "base/angles.h"
#include "base/words/answer_words.h"
#include "physics/body/euler_angles.h"
#include "render/typeset/math/math.h"

#include <fmt/format.h>

#include <cmath>
#include <variant>

namespace polhode {

namespace {

constexpr int kDigits = 4;  ///< of a state: a goal asks for three at most

/// "1.5", "2\cdot 10^{-5}"
std::string short_tex(double value) {
  std::string text = fmt::format("{:.{}g}", value, kDigits);
  const std::size_t e = text.find('e');
  if (e == text.npos) return text;
  return fmt::format("{}{{\\cdot}}10^{{{}}}", text.substr(0, e), std::stoi(text.substr(e + 1)));
}

/// What is noise of a conversion beside the others is none of the number.
std::string components_tex(const Vec3& v, Language language) {
  const char* const between = decimal_mark(language) == ',' ? ";\\ " : ",\\ ";
  const double noise = 1e-12 * v.cwiseAbs().maxCoeff();
  std::string tex;
  for (const double x : v) tex += (tex.empty() ? "" : between) + short_tex(std::abs(x) <= noise ? 0 : x);
  return '(' + tex + ')';
}

std::string vector_line(std::string_view name, const Vec3& v, const std::string& unit, Language language) {
  return fmt::format("${} = {}{}$", name, components_tex(v, language), unit_tex(unit));
}

std::string attitude_line(const AttitudeSpec& attitude, Language language) {
  if (const auto* points = std::get_if<LPoints>(&attitude)) {
    const Phrase& how = *points == LPoints::up ? words::kLUpright : words::kLHanging;
    return "$\\vec L$ " + std::string(how.in(language));
  }
  const EulerAngles angles = euler_angles_of(std::get<Quat>(attitude));
  const Vec3 degrees = kDegreesPerRadian * Vec3(angles.phi_rad, angles.theta_rad, angles.psi_rad);
  return vector_line("(\\varphi,\\ \\theta,\\ \\psi)", degrees, "°", language);
}

std::string torque_line(const TorqueTerm& torque, Language language) {
  const bool in_space = std::holds_alternative<SpaceTorque>(torque);
  return vector_line("\\vec N", components_of(torque), "N m", language) +
         (in_space ? std::string(words::kAlongAxesOfSpace.in(language)) : "");
}

}  // namespace

std::string state_line(const SteeredState& state, Language language) {
  std::string line;
  const auto add = [&](const std::string& part) { line += (line.empty() ? "" : "; ") + part; };
  if (state.w0_B) add(vector_line("\\vec\\omega", *state.w0_B, "rad/s", language));
  if (state.moments) add(vector_line("(I_1,\\ I_2,\\ I_3)", *state.moments, "kg m²", language));
  if (state.attitude) add(attitude_line(*state.attitude, language));
  if (state.torque) add(torque_line(*state.torque, language));
  if (state.t_s) add(fmt::format("$t = {}{}$", short_tex(*state.t_s), unit_tex("s")));
  return with_decimals(std::move(line), language);
}

}  // namespace polhode
