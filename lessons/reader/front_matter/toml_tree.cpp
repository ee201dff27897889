// SPDX-License-Identifier: MIT
#include "lessons/reader/front_matter/toml_tree.h"

#include "lessons/reader/reader.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <utility>

namespace polhode {
namespace {

SourcePlace moved(const toml::source_region& region, int first_line) {
  return {static_cast<int>(region.begin.line) + first_line - 1, static_cast<int>(region.begin.column)};
}

TomlValue converted(const toml::node& node, int first_line);

TomlTable converted_table(const toml::table& table, int first_line) {
  TomlTable result;
  result.entries.reserve(table.size());
  for (const auto& [key, node] : table) {
    result.entries.push_back(
        {std::string(key.str()), moved(key.source(), first_line), converted(node, first_line)});
  }
  return result;
}

// Recursive: the nesting was limited before anything was parsed.
TomlValue converted(const toml::node& node, int first_line) {
  TomlValue result;
  result.place = moved(node.source(), first_line);
  if (const auto* text = node.as_string()) {
    result.held = text->get();
  } else if (const auto* integer = node.as_integer()) {
    result.held = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    result.held = number->get();
  } else if (const auto* flag = node.as_boolean()) {
    result.held = flag->get();
  } else if (const auto* array = node.as_array()) {
    TomlArray values;
    values.reserve(array->size());
    for (const toml::node& element : *array) values.push_back(converted(element, first_line));
    result.held = std::move(values);
  } else if (const auto* table = node.as_table()) {
    result.held = converted_table(*table, first_line);
  }
  return result;
}

// Follows brackets and keys through a TOML text, right or wrong.
class NestingScan {
 public:
  NestingScan(std::string_view text, int limit) : text_(text), limit_(limit) {}

  std::optional<std::size_t> run() {
    for (i_ = 0; i_ < text_.size(); ++i_) {
      if (!kIsMark[static_cast<unsigned char>(text_[i_])]) continue;
      step();
      if (static_cast<int>(open_.size()) + dots_ > limit_) return i_;
    }
    return std::nullopt;
  }

 private:
  void step() {
    switch (text_[i_]) {
      case '#':
        skip_to_line_end();
        return;
      case '"':
      case '\'':
        skip_string();
        return;
      case '[':
      case '{':
        open();
        return;
      case ']':
      case '}':
        close();
        return;
      case '=':
        in_key_ = false, dots_ = 0;
        return;
      case ',':
        in_key_ = !open_.empty() && open_.back() == '{', dots_ = 0;
        return;
      case '\n':
        if (open_.empty()) in_key_ = true, dots_ = 0;
        return;
      case '.':
        if (in_key_) ++dots_;
        return;
      default:
        return;
    }
  }

  void open() {
    const bool header = in_key_ && text_[i_] == '[';
    open_.push_back(text_[i_]);
    in_key_ = header || text_[i_] == '{';
    dots_ = 0;
  }
  void close() {
    if (!open_.empty()) open_.pop_back();
    in_key_ = false;
    dots_ = 0;
  }
  void skip_to_line_end() {
    while (i_ + 1 < text_.size() && text_[i_ + 1] != '\n') ++i_;
  }
  void skip_string() {
    const char quote = text_[i_];
    const std::string triple(3, quote);
    const bool multiline = text_.substr(i_, 3) == triple;
    i_ += multiline ? 3 : 1;
    while (i_ < text_.size()) {
      if (quote == '"' && text_[i_] == '\\')
        ++i_;
      else if (multiline ? text_.substr(i_, 3) == triple : text_[i_] == quote || text_[i_] == '\n')
        break;
      ++i_;
    }
    if (multiline)
      i_ += 2;
    else if (i_ < text_.size() && text_[i_] == '\n')
      --i_;  // an unfinished string ends with its line
  }

  /// What step() looks at: few of the characters of a text.
  static constexpr auto kIsMark = [] {
    std::array<bool, 256> is_mark{};
    for (const char c : std::string_view("#\"'[]{}=,.\n")) is_mark[static_cast<unsigned char>(c)] = true;
    return is_mark;
  }();

  std::string_view text_;
  int limit_;
  std::size_t i_ = 0;
  std::string open_;
  bool in_key_ = true;
  int dots_ = 0;
};

}  // namespace

const TomlEntry* TomlTable::find(std::string_view key) const {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [key](const TomlEntry& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

std::string_view TomlValue::kind() const {
  constexpr std::array<std::string_view, 7> kKinds = {"a date or time", "a string", "a number", "a number",
                                                      "true or false",  "a list",   "a table"};
  return kKinds[held.index()];
}

std::optional<std::size_t> first_toml_nested_deeper(std::string_view text, int limit) {
  return NestingScan(text, limit).run();
}

std::optional<TomlTable> parse_toml(std::string_view text, int first_line, Report& report) {
  if (text.size() > kMaxTomlBytes) {
    report.error({first_line, 1}, "this TOML has " + std::to_string(text.size()) + " bytes, at most " +
                                      std::to_string(kMaxTomlBytes) + " are allowed");
    return std::nullopt;
  }
  if (const auto deep = first_toml_nested_deeper(text, kMaxNesting)) {
    const SourcePlace place = SourceText(text).place_of(std::min(*deep, text.size()));
    report.error({place.line + first_line - 1, place.column},
                 "TOML is nested deeper than " + std::to_string(kMaxNesting));
    return std::nullopt;
  }
  try {
    return converted_table(toml::parse(text), first_line);
  } catch (const toml::parse_error& error) {
    report.error(moved(error.source(), first_line), "TOML: " + std::string(error.description()));
    return std::nullopt;
  }
}

}  // namespace polhode
