// SPDX-License-Identifier: MIT
#include "lessons/notation/typed/typed_tokens.h"

#include "base/ascii.h"
#include "base/utf8.h"
#include "lessons/diagnostics/report.h"

#include <utility>

namespace polhode {
namespace {

/// What a character of its own stands for; empty: nothing.
std::string_view sign_of(char32_t c) {
  switch (c) {
    case U'×':
      return "x";
    case U'·':
    case U'⋅':
      return ".";
    case U'−':
    case U'–':
    case U'‐':
    case U'‑':
    case U'‒':
      return "-";
    case U'²':
      return "^2";
    case U'³':
      return "^3";
    case U'′':
      return "'";
    default:
      return "";
  }
}

/// Dots above the letter before: of the rate of what it stands for.
int dots_above(char32_t c) { return c == U'\u0307' ? 1 : c == U'\u0308' ? 2 : 0; }

/// A letter of one character with its dot; empty: it is none.
std::string_view letter_below_dot(char32_t c) {
  switch (c) {
    case U'ẇ':
      return "w";
    case U'Ṫ':
      return "T";
    case U'Ṅ':
      return "N";
    case U'ṗ':
      return "p";
    case U'Ḟ':
      return "F";
    default:
      return "";
  }
}

/// Commands of TeX that are read, for who is used to them.
std::string_view sign_of_command(std::string_view name) {
  if (name == "cdot") return ".";
  return name == "times" ? "x" : "";
}

/// Letters of names that are typed as such.
std::string_view letters_of(char32_t c) {
  switch (c) {
    case U'ω':
      return "omega";
    case U'₁':
      return "1";
    case U'₂':
      return "2";
    case U'₃':
      return "3";
    default:
      return "";
  }
}

class TokenReader {
 public:
  explicit TokenReader(const TypedNames& names) : names_(names) {}

  TypedTokens read(std::string_view line) {
    read_line(line);
    return std::move(read_);
  }

 private:
  using Kind = TypedToken::Kind;

  void fail(std::size_t at, std::string message, std::string hint = {}) {
    if (!read_.fault) read_.fault = TypedFault{at, std::move(message), std::move(hint)};
  }

  void read_line(std::string_view line) {
    std::size_t at = 0;
    if (line.size() > kMaxTypedBytes) {
      fail(kMaxTypedBytes, "a line has at most " + std::to_string(kMaxTypedBytes) + " characters",
           "write it in several steps");
      line = line.substr(0, kMaxTypedBytes);
    }
    while (at < line.size()) {
      const std::size_t begin = at;
      const char c = line[at];
      if (c == ' ' || c == '\t') {
        ++at;
      } else if (is_letter(c)) {
        read_name(line, at);
      } else if (is_digit(c)) {
        while (at < line.size() && is_digit(line[at])) ++at;
        if (at + 1 < line.size() && line[at] == '.' && is_digit(line[at + 1])) {
          ++at;
          while (at < line.size() && is_digit(line[at])) ++at;
        }
        read_.tokens.push_back({Kind::number, std::string(line.substr(begin, at - begin)), begin});
      } else if (std::string_view("=+-*/().,^'|_").find(c) != std::string_view::npos) {
        read_.tokens.push_back({Kind::sign, std::string(1, c), begin});
        ++at;
      } else if (c == '\\') {
        read_command(line, at);
      } else {
        const char32_t character = next_character(line, at);
        if ((!letters_of(character).empty() && !is_digit(letters_of(character).front())) ||
            !letter_below_dot(character).empty()) {
          at = begin;
          read_name(line, at);
        } else if (const std::string_view sign = sign_of(character); !sign.empty()) {
          read_.tokens.push_back({Kind::sign, std::string(sign), begin});
        } else {
          fail(begin, "this character is not read: " + in_quotes(line.substr(begin, at - begin)));
        }
      }
    }
    read_.tokens.push_back({Kind::end, "", line.size()});
  }

  /// \omega, \cdot and \times; others are refused, with what to type.
  void read_command(std::string_view line, std::size_t& at) {
    const std::size_t begin = at++;
    std::size_t end = at;
    while (end < line.size() && is_letter(line[end])) ++end;
    const std::string_view name = line.substr(at, end - at);
    if (const std::string_view sign = sign_of_command(name); !sign.empty()) {
      read_.tokens.push_back({Kind::sign, std::string(sign), begin});
      at = end;
    } else if (name != "omega") {
      fail(begin, "of TeX only \\omega, \\cdot and \\times are read",
           "type L for \\vec L, w1' for \\dot\\omega_1, a/b for a fraction");
      at = end;
    }
  }

  /// Letters, and an index behind them: "w1", "w_1", "dw1", "ω₁".
  void read_name(std::string_view line, std::size_t& at) {
    const std::size_t begin = at;
    std::string name;
    bool has_digit = false;
    int dots = 0;
    while (at < line.size()) {
      std::size_t behind = at;
      const char32_t c = next_character(line, behind);
      const bool braces =
          c == U'_' && behind + 2 < line.size() && line[behind] == '{' && line[behind + 2] == '}';
      if (dots_above(c) > 0 || braces) {
        dots += dots_above(c);
        if (braces) {  // "_{1}"
          has_digit = has_digit || is_digit(line[behind + 1]);
          name += line[behind + 1];
          behind += 3;
        }
        at = behind;
        continue;
      }
      if (!letter_below_dot(c).empty() && !has_digit && name.empty()) {
        name += letter_below_dot(c);
        ++dots;
        at = behind;
        continue;
      }
      const std::string_view letters = letters_of(c);
      const bool letter =
          (c < 0x80 && is_letter(static_cast<char>(c))) || (!letters.empty() && !is_digit(letters[0]));
      const bool digit =
          (c < 0x80 && is_digit(static_cast<char>(c))) || (!letters.empty() && is_digit(letters[0]));
      if (letter && has_digit) break;  // "I1w1" is two
      if (c == U'_' && behind < line.size() && (is_letter(line[behind]) || is_digit(line[behind]))) {
        has_digit = has_digit || is_digit(line[behind]);
        name += '_';
      } else if (letter || digit) {
        has_digit = has_digit || digit;
        name += letters.empty() ? line.substr(at, behind - at) : letters;
      } else {
        break;
      }
      at = behind;
    }
    if (name == "x")
      read_.tokens.push_back({Kind::sign, name, begin});
    else if (const std::vector<std::size_t> parts = parts_of(name); parts.size() > 1)
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::size_t end = i + 1 < parts.size() ? parts[i + 1] : name.size();
        read_.tokens.push_back({Kind::name, name.substr(parts[i], end - parts[i]), begin});
      }
    else
      read_.tokens.push_back({Kind::name, std::move(name), begin});
    for (int i = 0; i < dots; ++i) read_.tokens.push_back({Kind::sign, "'", begin});
  }

  /// Where the names begin of which one that is not known is made: "kT", "kw". None with an x, which could be
  /// meant as a cross product, and none that begins with d, as rates do.
  std::vector<std::size_t> parts_of(const std::string& name) const {
    if (name.empty() || name.front() == 'd' || name.find('x') != name.npos || printed_name(name, names_))
      return {};
    std::vector<std::size_t> parts;
    for (std::size_t at = 0; at < name.size();) {
      std::size_t end = name.size();
      while (end > at && !printed_name(name.substr(at, end - at), names_)) --end;
      if (end == at) return {};
      parts.push_back(at);
      at = end;
    }
    return parts;
  }

  const TypedNames& names_;
  TypedTokens read_;
};

}  // namespace

TypedTokens read_typed_tokens(std::string_view line, const TypedNames& names) {
  return TokenReader(names).read(line);
}

}  // namespace polhode
