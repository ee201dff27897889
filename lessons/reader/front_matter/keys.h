// SPDX-License-Identifier: MIT
// Typed values of TOML keys; what does not fit is reported where it stands.
#pragma once

#include "lessons/diagnostics/report.h"
#include "lessons/reader/front_matter/toml_tree.h"
#include "physics/body/types.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// Letters, digits and hyphens of ASCII, 1 to 64 of them.
bool is_id(std::string_view text);
inline constexpr std::string_view kIdRule = "an id has 1 to 64 of the characters a-z, A-Z, 0-9 and -";

/// Each returns nothing, and reports why, if the value of the key is not what is asked for.
std::optional<std::string> read_text(const TomlEntry& entry, Report& report);
std::optional<bool> read_flag(const TomlEntry& entry, Report& report);
std::optional<double> read_number(const TomlEntry& entry, Report& report);           ///< finite
std::optional<double> read_positive_number(const TomlEntry& entry, Report& report);  ///< finite and > 0
std::optional<std::vector<double>> read_numbers(const TomlEntry& entry, std::size_t count, Report& report);
std::optional<Vec3> read_vector(const TomlEntry& entry, Report& report);
/// Null if it is none; `form` is how one is written.
const TomlTable* read_table(const TomlEntry& entry, std::string_view form, Report& report);

/// A string, or each string of a list, with its place.
struct PlacedText {
  std::string text;
  SourcePlace place;
};
std::optional<std::vector<PlacedText>> read_texts(const TomlEntry& entry, std::size_t max_count,
                                                  Report& report);

/// "unknown body "bok"", with the known name that is most like it.
void report_unknown(std::string_view what, const PlacedText& name, const std::vector<std::string>& known,
                    Report& report);

/// Place of the first character of a string's text, after its opening quote (exact for strings on one line).
inline SourcePlace inside_quotes(SourcePlace value) { return {value.line, value.column + 1}; }

/// What to do with each key of a table; other keys are reported with "did you mean".
struct KeyHandler {
  std::string name;
  std::function<void(const TomlEntry&)> read;
};
/// `where` names the table in messages: "[scene]".
void read_keys(const TomlTable& table, std::string_view where, const std::vector<KeyHandler>& handlers,
               Report& report);
/// The same without a list of handlers: `read` says whether it knows a key, `known` which there are.
void read_keys(const TomlTable& table, std::string_view where,
               const std::function<bool(const TomlEntry&)>& read,
               const std::function<std::vector<std::string>()>& known, Report& report);

}  // namespace polhode
