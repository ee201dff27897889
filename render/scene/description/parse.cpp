// SPDX-License-Identifier: MIT
#include "physics/exact/powers_of_two.h"
#include "render/scene/description/scene.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

namespace polhode {
namespace {

bool starts_with_hex_prefix(std::string_view text) {
  return text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X') &&
         (text[2] == '.' || std::isxdigit(static_cast<unsigned char>(text[2])) != 0);
}

// The numbers between commas, or the text that is not a finite number.
std::variant<std::vector<double>, std::string> finite_numbers(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::string_view part = text.substr(0, comma);
    const std::optional<double> number = parse_number(part);
    if (!number || !std::isfinite(*number)) {
      return '"' + std::string(part.substr(0, 40)) + "\" is not a finite number";
    }
    numbers.push_back(*number);
    if (comma == std::string_view::npos) return numbers;
    text.remove_prefix(comma + 1);
  }
}

struct TermKind {
  std::string_view name;
  std::size_t count;
  std::string_view usage;
};
constexpr std::array<TermKind, 5> kTermKinds = {{{"space", 3, "space:x,y,z"},
                                                 {"body", 3, "body:x,y,z"},
                                                 {"heavy", 4, "heavy:MGR,ax,ay,az"},
                                                 {"damping", 1, "damping:C"},
                                                 {"sink", 1, "sink:C"}}};

std::variant<TorqueTerm, std::string> heavy_top(const std::vector<double>& v) {
  const Vec3 axis(v[1], v[2], v[3]);
  if (axis.isZero(0.0)) return "the axis of a heavy top must not be zero: heavy:MGR,ax,ay,az";
  const Vec3 direction = times_two_to(-exponent_of(axis), axis);  // its length is in the range of numbers
  return HeavyTop{v[0], direction / std::hypot(direction[0], direction[1], direction[2])};
}

std::variant<TorqueTerm, std::string> make_term(const TermKind& kind, const std::vector<double>& v) {
  if (kind.name == "space") return SpaceTorque{Vec3(v[0], v[1], v[2])};
  if (kind.name == "body") return BodyTorque{Vec3(v[0], v[1], v[2])};
  if (kind.name == "heavy") return heavy_top(v);
  if (v[0] < 0) return "the coefficient of " + std::string(kind.name) + " must not be negative";
  if (kind.name == "damping") return LinearDamping{v[0]};
  return EnergySink{v[0]};
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  bool negative = false;
  if (!text.empty() && (text.front() == '+' || text.front() == '-')) {
    negative = text.front() == '-';
    text.remove_prefix(1);
  }
  const bool hex = starts_with_hex_prefix(text);
  if (hex) text.remove_prefix(2);
  if (text.empty() || text.front() == '-') return std::nullopt;  // from_chars would take a second sign

  double value = 0;
  const auto format = hex ? std::chars_format::hex : std::chars_format::general;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, format);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return negative ? -value : value;
}

std::variant<TorqueTerm, std::string> parse_torque_term(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  for (const TermKind& kind : kTermKinds) {
    if (name != kind.name) continue;
    if (colon == std::string_view::npos) return "numbers are missing: " + std::string(kind.usage);
    const auto numbers = finite_numbers(text.substr(colon + 1));
    if (const auto* wrong = std::get_if<std::string>(&numbers))
      return *wrong + ": " + std::string(kind.usage);
    const auto& values = std::get<std::vector<double>>(numbers);
    if (values.size() != kind.count) {
      return "expected " + std::to_string(kind.count) + (kind.count == 1 ? " number" : " numbers") +
             ", found " + std::to_string(values.size()) + ": " + std::string(kind.usage);
    }
    return make_term(kind, values);
  }
  return "unknown torque \"" + std::string(name.substr(0, 40)) +
         "\"; known: space:x,y,z, body:x,y,z, heavy:MGR,ax,ay,az, damping:C, sink:C";
}

std::optional<QualityLevel> quality_level_from(std::string_view name) {
  for (const QualityLevel level : {QualityLevel::draft, QualityLevel::normal, QualityLevel::fine})
    if (name == name_of(level)) return level;
  return std::nullopt;
}

const char* name_of(QualityLevel level) {
  switch (level) {
    case QualityLevel::draft:
      return "draft";
    case QualityLevel::normal:
      return "normal";
    case QualityLevel::fine:
      break;
  }
  return "fine";
}

}  // namespace polhode
