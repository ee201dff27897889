// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/numbers/computed_number.h"

#include "base/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {

std::optional<double> value_of(const ComputedNumber& number, const LiveState& live) {
  const auto value = live_number(number.expression, live);
  if (!value) return std::nullopt;
  return *value / number.unit_si;
}

std::optional<double> value_of(const ComputedNumber& number, MotionNumbers& motion) {
  const auto value = motion.value_of(number.expression);
  if (!value) return std::nullopt;
  return *value / number.unit_si;
}

std::map<int, double> values_in_tables(const std::vector<ComputedNumber>& numbers,
                                       const std::vector<int>& ids, const Effort& effort) {
  std::map<const TableRow*, std::vector<int>> by_row;
  for (const int id : ids)
    if (const auto& row = numbers[static_cast<std::size_t>(id)].row) by_row[row.get()].push_back(id);
  std::map<int, double> values;
  for (const auto& [row, of_row] : by_row) {
    const SceneModel model = make_model(row->scene, ModelFor::numbers, effort);
    MotionNumbers motion(model, row->scene.at_s, effort);
    for (const int id : of_row)
      if (const auto value = value_of(numbers[static_cast<std::size_t>(id)], motion))
        values.emplace(id, *value);
  }
  return values;
}

std::optional<std::string> right_instead(const ComputedNumber& number, double value) {
  const std::string& typed = number.written.typed;
  const std::size_t e = std::min(typed.find('e'), typed.size()), point = std::min(typed.find('.'), e);
  const int decimals = point == e ? 0 : static_cast<int>(e - point) - 1;
  const int power = e == typed.size() ? 0 : std::stoi(typed.substr(e + 1));
  const double last_digit = std::pow(10.0, power - decimals), shown = parse_number(typed).value();
  // A number that lies in the middle between two may be rounded either way, whatever is lost in the last
  // bits.
  constexpr double kBits = 64;
  const double lost = kBits * std::numeric_limits<double>::epsilon() * (std::abs(value) + std::abs(shown));
  const bool says_nothing = shown == 0 && std::abs(value) > lost + 1e-12 * last_digit;
  // "1e1" would be right of all between 5 and 15, and "1" of 0.6.
  constexpr double kOfWhole = 0.05;
  const bool is_far = shown != 0 && std::abs(value - shown) > kOfWhole * std::abs(shown) + lost;
  const bool is_rounded = std::abs(value - shown) <= 0.5 * last_digit + lost;
  if (is_rounded && !says_nothing && !is_far) return std::nullopt;
  const double nearest = last_digit * std::round(value / last_digit);
  const bool has_few_digits = nearest != 0 && std::abs(value - nearest) > kOfWhole * std::abs(nearest);
  if (says_nothing || (is_far && (is_rounded || power != 0 || has_few_digits)))
    return fmt::format("{:.2g}", value);
  std::string right = fmt::format("{:.{}f}", value / std::pow(10.0, power), decimals);
  if (right.find_first_not_of("-0.") == right.npos && right.front() == '-') right.erase(0, 1);
  return power == 0 ? right : fmt::format("{}\\cdot10^{{{}}}", right, power);
}

}  // namespace polhode
