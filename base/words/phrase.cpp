// SPDX-License-Identifier: MIT
#include "base/words/phrase.h"

#include <algorithm>

namespace polhode {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

std::string Phrase::with(Language language, std::initializer_list<std::string_view> parts) const {
  const std::string_view text = in(language);
  std::string filled;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_part = text[i] == '{' && i + 2 < text.size() && is_digit(text[i + 1]) && text[i + 2] == '}';
    if (!is_part) {
      filled += text[i];
      continue;
    }
    const auto which = static_cast<std::size_t>(text[i + 1] - '0');
    if (which < parts.size()) filled += parts.begin()[which];
    i += 2;
  }
  return filled;
}

std::string json_of(std::span<const NamedPhrase> phrases, Language language) {
  std::string json = "{\"decimal\":\"";
  json += decimal_mark(language);
  for (const auto& [name, words] : phrases)
    json.append("\",\"").append(name).append("\":\"").append(words.in(language));
  return json + "\"}";
}

std::string with_decimals_in_formulas(std::string line, Language language) {
  if (decimal_mark(language) == '.') return line;
  std::string text;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t begin = std::min(line.find('$', at), line.size());
    const std::size_t end =
        begin == line.size() ? begin : std::min(line.find('$', begin + 1), line.size() - 1) + 1;
    text += line.substr(at, begin - at) + with_decimals(line.substr(begin, end - begin), language);
    at = end;
  }
  return text;
}

std::string with_decimals(std::string line, Language language) {
  if (decimal_mark(language) == '.') return line;
  std::string text;
  bool is_formula = false;
  const auto begins_number = [](std::string_view rest) {
    while (rest.starts_with(' ')) rest.remove_prefix(1);
    return !rest.empty() && (is_digit(rest.front()) || rest.front() == '-' || rest.starts_with("−"));
  };
  const auto is_decimal = [&](std::size_t i) {
    return line[i] == '.' && i > 0 && is_digit(line[i - 1]) && i + 1 < line.size() && is_digit(line[i + 1]);
  };
  bool has_decimals = false;
  for (std::size_t i = 0; i < line.size(); ++i) has_decimals = has_decimals || is_decimal(i);
  if (!has_decimals) return line;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '$') is_formula = !is_formula;
    const bool is_behind_digit = i > 0 && is_digit(line[i - 1]);
    if (is_decimal(i))
      text += is_formula ? "{,}" : ",";
    else if (c == ',' && is_behind_digit && begins_number(std::string_view(line).substr(i + 1)))
      text += ';';
    else
      text += c;
  }
  return text;
}

}  // namespace polhode
