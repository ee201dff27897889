// SPDX-License-Identifier: MIT
#include "lessons/claims/answers/typed_unit.h"

#include "base/angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace polhode {
namespace {

struct Named {
  std::string_view name;
  TypedUnit unit;
};

/// Those that no lesson has.
const std::array<Named, 5> kMore{{{"min", {{kTime, 60}}},
                                  {"h", {{kTime, 3600}}},
                                  {"rev", {{kNumber, kRadiansPerTurn}, 1}},
                                  {"rpm", {{kRate, kRadiansPerTurn / 60}, 1}},
                                  {"%", {{kNumber, 0.01}, 0, 0, true}}}};

/// Units as words, and what they are written as.
constexpr std::array<std::pair<std::string_view, std::string_view>, 31> kInWords{
    {{"degree", "deg"}, {"degrees", "deg"}, {"degs", "deg"},       {"radian", "rad"},      {"radians", "rad"},
     {"rads", "rad"},   {"second", "s"},    {"seconds", "s"},      {"sec", "s"},           {"secs", "s"},
     {"minute", "min"}, {"minutes", "min"}, {"mins", "min"},       {"hour", "h"},          {"hours", "h"},
     {"turn", "rev"},   {"turns", "rev"},   {"revolution", "rev"}, {"revolutions", "rev"}, {"revs", "rev"},
     {"joule", "J"},    {"joules", "J"},    {"newton", "N"},       {"newtons", "N"},       {"metre", "m"},
     {"metres", "m"},   {"meter", "m"},     {"meters", "m"},       {"kilograms", "kg"},    {"kilogram", "kg"},
     {"percent", "%"}}};

TypedUnit product(const TypedUnit& a, const TypedUnit& b, int power) {
  TypedUnit c = a;
  for (std::size_t i = 0; i < 3; ++i) c.scaled.dimension[i] += power * b.scaled.dimension[i];
  c.scaled.size *= std::pow(b.scaled.size, power);
  c.angles += power * b.angles;
  c.cycles += power * b.cycles;
  c.is_percent = a.is_percent || b.is_percent;
  return c;
}

/// One name without a power.
std::optional<TypedUnit> named(std::string_view name) {
  for (const auto& [word, written] : kInWords)
    if (word == name) return named(written);
  for (const Named& more : kMore)
    if (more.name == name) return more.unit;
  const std::string with_mu = name.starts_with('u') ? "µ" + std::string(name.substr(1)) : std::string(name);
  // A million radians are nobody's unit, and "Grad" is a degree in German.
  const bool is_of_angles = name.ends_with("rad") && name != "rad" && name != "mrad" && with_mu != "µrad";
  const auto scaled = name.empty() || name == "1" || is_of_angles ? std::nullopt : scaled_unit(with_mu);
  if (!scaled) return std::nullopt;
  TypedUnit unit{*scaled};
  unit.cycles = name.ends_with("Hz") ? 1 : 0;
  unit.angles = name.ends_with("rad") || name == "deg" || name == "°" ? 1 : 0;
  return unit;
}

/// One name, or several in a row without blanks; a power at the end is that of the last.
std::optional<TypedUnit> run_of(std::string_view names, int power) {
  if (const auto one = named(names)) return product({{kNumber, 1}}, *one, power);
  // The longest first name that leaves something to read: "kgm" is kg m.
  for (std::size_t length = names.size(); length > 1;) {
    --length;
    const std::string_view front = names.substr(0, length);
    const bool is_prefix = front == "h" || front == "min";  // "hJ" is meant to be 100 J
    const auto first = is_prefix ? std::nullopt : named(front);
    const auto rest = first ? run_of(names.substr(length), power) : std::nullopt;
    if (rest) return product(*rest, *first, 1);
  }
  return std::nullopt;
}

bool take(std::string_view& text, std::string_view front) {
  if (!text.starts_with(front)) return false;
  text.remove_prefix(front.size());
  return true;
}

/// The digit at the front, as it is written or raised; −1 if there is none.
int take_digit(std::string_view& text, bool raised) {
  constexpr std::array<std::string_view, 10> kRaised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  for (int digit = 0; digit < 10; ++digit)
    if (take(text, raised ? kRaised[static_cast<std::size_t>(digit)] : std::to_string(digit))) return digit;
  return -1;
}

/// The power behind a name, and nothing else; nothing if it is no such power.
std::optional<int> power_of(std::string_view text) {
  if (text.empty()) return 1;
  const bool has_sign = take(text, "^");
  const bool has_bracket = has_sign && take(text, "(");
  const bool is_raised = !has_sign && static_cast<unsigned char>(text.front()) >= 0x80U;
  const bool is_negative = is_raised ? take(text, "⁻") : take(text, "-") || take(text, "−");
  const int digit = take_digit(text, is_raised);
  if (digit < 1 || (has_bracket && !take(text, ")")) || !text.empty()) return std::nullopt;
  return is_negative ? -digit : digit;
}

/// The bytes of a name at the front: letters, %, µ and °.
std::size_t size_of_name(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%'; };
  std::size_t end = 0;
  while (end < text.size()) {
    const std::string_view rest = text.substr(end);
    std::size_t length = is_letter(rest.front()) ? 1 : 0;
    for (const std::string_view letter : {"µ", "μ", "°"})
      if (rest.starts_with(letter)) length = letter.size();
    if (length == 0) break;
    end += length;
  }
  return end;
}

/// "kgm2", "kgm²s⁻¹": names, each run of them with the power of its last.
std::optional<TypedUnit> factor(std::string_view text, int sign) {
  TypedUnit unit{{kNumber, 1}};
  while (!text.empty()) {
    const std::size_t names = size_of_name(text);
    std::size_t end = names;
    while (end < text.size() && size_of_name(text.substr(end)) == 0) ++end;
    const auto power = power_of(text.substr(names, end - names));
    const auto run = power && names > 0 ? run_of(text.substr(0, names), sign * *power) : std::nullopt;
    if (!run) return std::nullopt;
    unit = product(unit, *run, 1);
    text.remove_prefix(end);
  }
  return unit;
}

}  // namespace

std::optional<TypedUnit> typed_unit(std::string_view text) {
  TypedUnit unit{{kNumber, 1}};
  int sign = 1;
  bool is_open = false;  // behind a sign something has to stand
  while (!text.empty()) {
    if (take(text, " ") || take(text, "\t")) continue;
    if (text.starts_with("per ") && !is_open && sign > 0) {
      text.remove_prefix(4);
      sign = -1;
      is_open = true;
      continue;
    }
    const bool is_product = take(text, "·") || take(text, "⋅") || take(text, "*");
    if (is_product || take(text, "/")) {
      if (is_open || (!is_product && sign < 0)) return std::nullopt;
      if (!is_product) sign = -1;
      is_open = true;
      continue;
    }
    std::size_t end = 0;
    while (end < text.size() && std::string_view(" \t/*").find(text[end]) == std::string_view::npos &&
           !text.substr(end).starts_with("·") && !text.substr(end).starts_with("⋅"))
      ++end;
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    is_open = false;
    if (word == "1" && text.substr(std::min(text.find_first_not_of(" \t"), text.size())).starts_with('/'))
      continue;
    const auto read = factor(word, sign);
    if (!read) return std::nullopt;
    unit = product(unit, *read, 1);
  }
  return is_open ? std::nullopt : std::optional(unit);
}

}  // namespace polhode
