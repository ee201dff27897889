// SPDX-License-Identifier: MIT
#include "lessons/reader/front_matter/toml_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace polhode {

std::string toml(double value) {
  std::string digits = fmt::format("{}", value);
  if (digits.find_first_of(".e") == digits.npos) digits += ".0";
  return digits;
}

std::string toml(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (double value : values) texts.push_back(toml(value));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string toml(const Vec3& v) { return toml(std::vector<double>{v[0], v[1], v[2]}); }

std::string toml(const std::string& text) {
  if (text.find_first_of("'\n\r\t") == text.npos) return '\'' + text + '\'';
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      quoted += {'\\', c};
    else if (static_cast<unsigned char>(c) < 0x20)
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      quoted += c;
  }
  return quoted + '"';
}

std::string toml(const char* name) { return fmt::format("\"{}\"", name); }

std::string toml_list(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
  return '[' + list + ']';
}

}  // namespace polhode
