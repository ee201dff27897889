// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/dimension.h"

#include "base/angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace polhode {
namespace {

struct UnitFacts {
  std::string_view name;
  Dimension dimension;
  double size = 1;  ///< of SI units in it
};
constexpr std::array<UnitFacts, 12> kUnits{{{"kg", {1, 0, 0}},
                                            {"m", {0, 1, 0}},
                                            {"s", {0, 0, 1}},
                                            {"N", {1, 1, -2}},
                                            {"J", kEnergy},
                                            {"W", {1, 2, -3}},
                                            {"Hz", {0, 0, -1}},
                                            {"rad", kNumber},
                                            {"deg", kNumber, kRadiansPerDegree},
                                            {"°", kNumber, kRadiansPerDegree},
                                            {"1", kNumber},
                                            {"", kNumber}}};

struct PrefixFacts {
  std::string_view name;
  double size;
};
constexpr std::array<PrefixFacts, 9> kPrefixes{{{"p", 1e-12},
                                                {"n", 1e-9},
                                                {"µ", 1e-6},  // the micro sign
                                                {"μ", 1e-6},  // the letter mu
                                                {"m", 1e-3},
                                                {"c", 1e-2},
                                                {"k", 1e3},
                                                {"M", 1e6},
                                                {"G", 1e9}}};
/// They stand before these, and before g.
constexpr std::array<std::string_view, 7> kPrefixed{"m", "s", "N", "J", "W", "Hz", "rad"};

std::optional<UnitFacts> find_unit(std::string_view name) {
  const auto known = std::find_if(kUnits.begin(), kUnits.end(),
                                  [name](const UnitFacts& facts) { return facts.name == name; });
  return known == kUnits.end() ? std::nullopt : std::optional(*known);
}

std::optional<UnitFacts> find_prefixed_unit(std::string_view name) {
  constexpr UnitFacts kGram{"g", {1, 0, 0}, 1e-3};
  if (const auto known = find_unit(name)) return known;
  if (name == kGram.name) return kGram;
  for (const PrefixFacts& prefix : kPrefixes) {
    if (!name.starts_with(prefix.name)) continue;
    const std::string_view rest = name.substr(prefix.name.size());
    auto unit = rest == kGram.name ? std::optional(kGram)
                : std::find(kPrefixed.begin(), kPrefixed.end(), rest) != kPrefixed.end() ? find_unit(rest)
                                                                                         : std::nullopt;
    if (!unit) continue;
    unit->size *= prefix.size;
    return unit;
  }
  return std::nullopt;
}

/// A power behind a unit, which is cut off; 1 if there is none.
int take_power(std::string_view& unit) {
  constexpr std::array<std::pair<std::string_view, int>, 6> kPowers{
      {{"²", 2}, {"³", 3}, {"⁴", 4}, {"^2", 2}, {"^3", 3}, {"^4", 4}}};
  for (const auto& [text, power] : kPowers)
    if (unit.size() > text.size() && unit.ends_with(text)) {
      unit.remove_suffix(text.size());
      return power;
    }
  return 1;
}

Dimension times(const Dimension& a, const Dimension& b, double power = 1) {
  Dimension product = a;
  for (std::size_t i = 0; i < 3; ++i) product[i] += power * b[i];
  return product;
}

using Known = std::optional<Dimension>;

class DimensionReader {
 public:
  DimensionReader(const Expression& expression, const std::map<int, Dimension>& constants)
      : expression_(expression), constants_(constants) {}

  DimensionReading read() {
    for (const ExpressionNode& node : expression_.nodes) {
      known_.push_back(of(node));
      if (fault_) break;
    }
    if (fault_) return {{}, fault_};
    return {known_.back(), {}};
  }

 private:
  const Known& at(int index) const { return known_[static_cast<std::size_t>(index)]; }
  const ExpressionNode& node(int index) const { return expression_.nodes[static_cast<std::size_t>(index)]; }

  Known fail(const ExpressionNode& node, std::string message) {
    fault_ = DimensionFault{std::move(message), node.begin};
    return {};
  }

  Known product(int a, int b, double power = 1) const {
    return at(a) && at(b) ? Known(times(*at(a), *at(b), power)) : std::nullopt;
  }

  Known both(const ExpressionNode& n, const char* what) {
    if (at(n.a) && at(n.b) && *at(n.a) != *at(n.b))
      return fail(node(n.b), "units disagree: " + to_string(*at(n.a)) + " and " + to_string(*at(n.b)) + what);
    return at(n.a) ? at(n.a) : at(n.b);
  }

  Known number_of(const ExpressionNode& n) {
    if (at(n.a) && *at(n.a) != kNumber)
      return fail(node(n.a), "units disagree: a function of numbers is taken of " + to_string(*at(n.a)));
    return kNumber;
  }

  Known of(const ExpressionNode& n) {
    using O = Operation;
    switch (n.operation) {
      case O::number:
        return n.type == ExpressionType::zero ? Known() : Known(kNumber);
      case O::constant: {
        const auto found = constants_.find(n.integer);
        return found == constants_.end() ? Known() : Known(found->second);
      }
      case O::pi:
        return kNumber;
      case O::quantity:
        return facts_of(n.quantity).dimension;
      case O::negate:
      case O::norm:
      case O::comp:
        return at(n.a);
      case O::add:
      case O::subtract:
        return both(n, " are added");
      case O::multiply:
      case O::dot:
      case O::cross:
        return product(n.a, n.b);
      case O::divide:
        return product(n.a, n.b, -1);
      case O::power:
        return at(n.a) ? Known(times(kNumber, *at(n.a), n.integer)) : std::nullopt;
      case O::norm2:
        return product(n.a, n.a);
      case O::inertia:
      case O::apply:
        return at(n.a) ? Known(times(*at(n.a), kInertia)) : std::nullopt;
      case O::trace:
        return kInertia;
      case O::star:
      case O::ddt:
        return at(n.a) ? Known(times(*at(n.a), {0, 0, -1})) : std::nullopt;
      case O::sqrt:
        return at(n.a) ? Known(times(kNumber, *at(n.a), 0.5)) : std::nullopt;
      case O::sin:
      case O::cos:
      case O::acos:
      case O::exp:
      case O::log:
        return number_of(n);
      case O::atan2:
        both(n, " make no angle");
        return kNumber;
    }
    return std::nullopt;
  }

  const Expression& expression_;
  const std::map<int, Dimension>& constants_;
  std::vector<Known> known_;
  std::optional<DimensionFault> fault_;
};

template <class Find>
std::optional<ScaledUnit> read_unit(std::string_view unit, const Find& find) {
  ScaledUnit read{kNumber, 1};
  double sign = 1;
  std::size_t at = 0;
  constexpr std::string_view kDot = "·";
  while (at <= unit.size()) {
    std::size_t end = at;
    while (end < unit.size() && unit[end] != ' ' && unit[end] != '/' && unit.substr(end, kDot.size()) != kDot)
      ++end;
    std::string_view name = unit.substr(at, end - at);
    const int power = take_power(name);
    const std::optional<UnitFacts> known = find(name);
    if (!known) return std::nullopt;
    read.dimension = times(read.dimension, known->dimension, sign * power);
    read.size *= std::pow(known->size, sign * power);
    if (end == unit.size()) break;
    if (unit[end] == '/') {
      if (sign < 0) return std::nullopt;
      sign = -1;
    }
    at = end + (unit.substr(end, kDot.size()) == kDot ? kDot.size() : 1);
  }
  return read;
}

}  // namespace

std::optional<Dimension> dimension_of_unit(std::string_view unit) {
  const auto read = read_unit(unit, find_unit);
  return read ? std::optional(read->dimension) : std::nullopt;
}

std::optional<ScaledUnit> scaled_unit(std::string_view unit) { return read_unit(unit, find_prefixed_unit); }

std::string to_string(const Dimension& dimension) {
  constexpr std::array<std::string_view, 3> kNames{"kg", "m", "s"};
  const auto with_power = [&](std::size_t i, double power) {
    std::string text(kNames[i]);
    if (power == 2) return text + "²";
    if (power == 3) return text + "³";
    if (power == 1) return text;
    std::string number = std::to_string(power);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.ends_with('.')) number.pop_back();
    return text + '^' + number;
  };
  std::string above, below;
  for (std::size_t i = 0; i < 3; ++i) {
    if (dimension[i] > 0) above += (above.empty() ? "" : " ") + with_power(i, dimension[i]);
    if (dimension[i] < 0) below += (below.empty() ? "" : " ") + with_power(i, -dimension[i]);
  }
  if (above.empty() && below.empty()) return "a number";
  return (above.empty() ? "1" : above) + (below.empty() ? "" : "/" + below);
}

DimensionReading dimension_of(const Expression& expression, const std::map<int, Dimension>& constants) {
  return DimensionReader(expression, constants).read();
}

}  // namespace polhode
