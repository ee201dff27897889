// SPDX-License-Identifier: MIT
// The TOML that nearly all fences of lessons hold, read in one go: a fifth of what reading a lesson costs is
// spent where a library reads each character through its own tables of positions.
#pragma once

#include "lessons/reader/front_matter/toml_tree.h"

#include <optional>
#include <string_view>

namespace polhode {

/// What a library would read, to the place of every key: lines `key = value` of strings in one line, decimal
/// numbers, true, false, lists and inline tables. Nothing where something else stands in the text, right or
/// wrong (headers, dotted and quoted keys, dates, other escapes than \" and \\), or it is nested deeper than
/// `limit`: that is left to the library, which also says what is wrong. A test holds both against each other.
std::optional<TomlTable> read_plain_toml(std::string_view text, int first_line, int limit);

}  // namespace polhode
