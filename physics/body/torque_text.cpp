// SPDX-License-Identifier: MIT
#include "physics/body/torque_text.h"

#include "base/numbers.h"
#include "physics/exact/powers_of_two.h"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace polhode {
namespace {

// The numbers between commas, or the text that is not a finite number.
Result<std::vector<double>> finite_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<double> number = parse_number(part);
    if (!number || !std::isfinite(*number))
      return failure('"' + std::string(part.substr(0, 40)) + "\" is not a finite number");
    numbers.push_back(*number);
  }
  return numbers;
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

Result<TorqueTerm> heavy_top(const std::vector<double>& v) {
  const Vec3 axis(v[1], v[2], v[3]);
  if (axis.isZero(0.0)) return failure("the axis of a heavy top must not be zero: heavy:MGR,ax,ay,az");
  const Vec3 direction = times_two_to(-exponent_of(axis), axis);  // its length is in the range of numbers
  return TorqueTerm(HeavyTop{v[0], direction / std::hypot(direction[0], direction[1], direction[2])});
}

Result<TorqueTerm> make_term(const TermKind& kind, const std::vector<double>& v) {
  if (kind.name == "space") return TorqueTerm(SpaceTorque{Vec3(v[0], v[1], v[2])});
  if (kind.name == "body") return TorqueTerm(BodyTorque{Vec3(v[0], v[1], v[2])});
  if (kind.name == "heavy") return heavy_top(v);
  if (v[0] < 0) return failure("the coefficient of " + std::string(kind.name) + " must not be negative");
  if (kind.name == "damping") return TorqueTerm(LinearDamping{v[0]});
  return TorqueTerm(EnergySink{v[0]});
}

}  // namespace

Result<TorqueTerm> parse_torque_term(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  for (const TermKind& kind : kTermKinds) {
    if (name != kind.name) continue;
    if (colon == std::string_view::npos) return failure("numbers are missing: " + std::string(kind.usage));
    const auto numbers = finite_numbers(text.substr(colon + 1));
    if (!numbers) return failure(numbers.error() + ": " + std::string(kind.usage));
    if (numbers->size() != kind.count)
      return failure("expected " + std::to_string(kind.count) + (kind.count == 1 ? " number" : " numbers") +
                     ", found " + std::to_string(numbers->size()) + ": " + std::string(kind.usage));
    return make_term(kind, *numbers);
  }
  return failure("unknown torque \"" + std::string(name.substr(0, 40)) +
                 "\"; known: space:x,y,z, body:x,y,z, heavy:MGR,ax,ay,az, damping:C, sink:C");
}

}  // namespace polhode
