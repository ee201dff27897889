// SPDX-License-Identifier: MIT
// A TOML document as plain data with a place for every key and value. Keeps toml++ (slow to compile) in one
// source.
#pragma once

#include "lessons/diagnostics/diagnostic.h"
#include "lessons/diagnostics/report.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace polhode {

/// One TOML text of a lesson (the front matter, or a fence) is at most this long: a document tree takes some
/// hundred times the bytes of its shortest text.
inline constexpr std::size_t kMaxTomlBytes = std::size_t{1} << 16;

struct TomlEntry;
struct TomlValue;
using TomlArray = std::vector<TomlValue>;
struct TomlTable {
  std::vector<TomlEntry> entries;  ///< keys are unique
  const TomlEntry* find(std::string_view key) const;
};
/// Dates and times: nothing in a lesson takes them.
struct TomlOther {};

struct TomlValue {
  SourcePlace place;
  std::variant<TomlOther, std::string, std::int64_t, double, bool, TomlArray, TomlTable> held;

  template <class T>
  const T* as() const {
    return std::get_if<T>(&held);
  }
  /// "a string", "a number", "a list", ...
  std::string_view kind() const;
};

struct TomlEntry {
  std::string key;
  SourcePlace place;  ///< of the key
  TomlValue value;
};

/// Byte at which brackets, braces and dotted keys nest deeper than `limit`; nothing if they never do. Looks
/// at the text alone: what parses it recursively is safe afterwards.
std::optional<std::size_t> first_toml_nested_deeper(std::string_view text, int limit);

/// Parses a text that starts on line `first_line` of the source. Nothing if it is too long, too deeply nested
/// or no TOML; the report says so.
std::optional<TomlTable> parse_toml(std::string_view text, int first_line, Report& report);

}  // namespace polhode
