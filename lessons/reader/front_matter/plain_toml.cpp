// SPDX-License-Identifier: MIT
#include "lessons/reader/front_matter/plain_toml.h"

#include "base/ascii.h"
#include "base/utf8.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

namespace polhode {
namespace {

class PlainToml {
 public:
  PlainToml(std::string_view text, int first_line, int limit)
      : text_(text), line_(first_line), limit_(limit) {}

  std::optional<TomlTable> run() {
    TomlTable table;
    while (skip_lines() && at_ < text_.size()) {
      if (!entry(table)) return std::nullopt;
      skip_blanks();
      if (at_ < text_.size() && peek() != '\n' && peek() != '#') return std::nullopt;
    }
    return at_ == text_.size() && sort(table) ? std::optional(std::move(table)) : std::nullopt;
  }

 private:
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char c) { return peek() == c && at_ < text_.size() ? (++at_, true) : false; }
  SourcePlace place() const { return {line_, static_cast<int>(at_ - line_begin_ - inside_) + 1}; }
  void skip_blanks() {
    while (peek() == ' ' || peek() == '\t') ++at_;
  }

  /// Blanks, comments and ends of lines. False where a comment holds what none may hold.
  bool skip_lines() {
    for (skip_blanks(); at_ < text_.size(); skip_blanks()) {
      if (peek() == '#') {
        while (at_ < text_.size() && peek() != '\n')
          if (!character()) return false;
      } else if (peek() != '\n') {
        return true;
      }
      if (!take('\n')) return true;
      ++line_;
      line_begin_ = at_;
      inside_ = 0;
    }
    return true;
  }

  /// Goes on by one of a string or a comment; false where it may not stand there.
  bool character() {
    const auto byte = static_cast<unsigned char>(text_[at_]);
    if (byte < 0x80) {
      if (byte != '\t' && (byte < 0x20 || byte == 0x7F)) return false;
      return ++at_, true;
    }
    const std::size_t begin = at_;
    std::size_t behind = at_;
    if (next_character(text_, behind) == kMalformed) return false;
    at_ = behind;
    inside_ += at_ - begin - 1;
    return true;
  }

  /// Tables of the library are sorted by their keys, each of which there is once.
  static bool sort(TomlTable& table) {
    std::ranges::sort(table.entries, {}, &TomlEntry::key);
    return std::ranges::adjacent_find(table.entries, {}, &TomlEntry::key) == table.entries.end();
  }

  bool entry(TomlTable& table) {
    const std::size_t begin = at_;
    const SourcePlace at = place();
    while (is_letter(peek()) || is_digit(peek()) || peek() == '_' || peek() == '-') ++at_;
    const std::string_view key = text_.substr(begin, at_ - begin);
    skip_blanks();
    if (key.empty() || !take('=')) return false;
    skip_blanks();
    TomlEntry& made = table.entries.emplace_back(TomlEntry{std::string(key), at, {}});
    return value(made.value);
  }

  bool value(TomlValue& into) {
    into.place = place();
    switch (peek()) {
      case '"':
      case '\'':
        return string(into.held.emplace<std::string>());
      case '[':
        return nested([&] { return list(into.held.emplace<TomlArray>()); });
      case '{':
        return nested([&] { return table(into.held.emplace<TomlTable>()); });
      case 't':
        into.held = true;
        return word("true");
      case 'f':
        into.held = false;
        return word("false");
      default:
        return number(into);
    }
  }

  template <class Read>
  bool nested(const Read& read) {
    ++at_;
    if (++depth_ > limit_ || !read()) return false;
    --depth_;
    return true;
  }

  bool string(std::string& into) {
    const char quote = text_[at_++];
    std::size_t begin = at_;
    while (peek() != quote) {
      if (at_ == text_.size()) return false;
      const bool is_escape = quote == '"' && peek() == '\\';
      if (is_escape) {
        into += text_.substr(begin, at_ - begin);
        begin = ++at_;  // what it stands for is itself
        if (peek() != '"' && peek() != '\\') return false;
      }
      if (!character()) return false;
    }
    into += text_.substr(begin, at_ - begin);
    ++at_;
    return peek() != quote;  // """ begins another kind
  }

  bool list(TomlArray& into) {
    for (;;) {
      if (!skip_lines()) return false;
      if (take(']')) return true;
      if (!value(into.emplace_back()) || !skip_lines()) return false;
      if (!take(',')) return take(']');
    }
  }

  bool table(TomlTable& into) {
    skip_blanks();
    if (take('}')) return true;
    do {
      skip_blanks();
      if (!entry(into)) return false;
      skip_blanks();
    } while (take(','));
    return take('}') && sort(into);
  }

  /// Whether a value may end here.
  bool ends() const {
    return at_ == text_.size() || std::string_view(" \t\n,]}#").find(peek()) != text_.npos;
  }

  bool word(std::string_view word) {
    if (!text_.substr(at_).starts_with(word)) return false;
    at_ += word.size();
    return ends();
  }

  std::size_t take_digits() {
    const std::size_t begin = at_;
    while (is_digit(peek())) ++at_;
    return at_ - begin;
  }

  bool number(TomlValue& into) {
    constexpr std::size_t kMostDigits = 18;  // of 2⁶³
    const std::size_t begin = at_;
    take('-');
    const bool is_zero = peek() == '0';
    const std::size_t digits = take_digits();
    if (digits == 0 || digits > kMostDigits || (is_zero && digits > 1)) return false;
    bool is_float = false;
    if (take('.')) {
      is_float = true;
      if (take_digits() == 0) return false;
    }
    if (take('e') || take('E')) {
      is_float = true;
      if (!take('-')) take('+');
      if (take_digits() == 0) return false;
    }
    if (!ends()) return false;
    const char *from = text_.data() + begin, *to = text_.data() + at_;
    const auto read = [&](auto& target) {
      const auto result = std::from_chars(from, to, target);
      return result.ec == std::errc() && result.ptr == to;
    };
    return is_float ? read(into.held.emplace<double>()) : read(into.held.emplace<std::int64_t>());
  }

  std::string_view text_;
  int line_;
  int limit_;
  std::size_t at_ = 0, line_begin_ = 0;
  std::size_t inside_ = 0;  ///< bytes of this line that begin no character
  int depth_ = 0;
};

}  // namespace

std::optional<TomlTable> read_plain_toml(std::string_view text, int first_line, int limit) {
  return PlainToml(text, first_line, limit).run();
}

}  // namespace polhode
