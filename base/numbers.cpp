// SPDX-License-Identifier: MIT
#include "base/numbers.h"

#include <array>
#include <cassert>
#include <cctype>
#include <charconv>

namespace polhode {
namespace {

bool starts_with_hex_prefix(std::string_view text) {
  return text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X') &&
         (text[2] == '.' || std::isxdigit(static_cast<unsigned char>(text[2])) != 0);
}

/// The digits of the largest double, and as many decimals as anybody asks for.
constexpr std::size_t kLongest = 400;

template <class... Form>
std::string written(double value, Form... form) {
  std::array<char, kLongest> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value, form...);
  assert(error == std::errc{});
  return std::string(text.data(), end);
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

std::string digits(double value, int most) { return written(value, std::chars_format::general, most); }
std::string fixed(double value, int decimals) { return written(value, std::chars_format::fixed, decimals); }
std::string scientific(double value, int decimals) {
  return written(value, std::chars_format::scientific, decimals);
}
std::string shortest(double value) { return written(value); }

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

}  // namespace polhode
