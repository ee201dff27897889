// SPDX-License-Identifier: MIT
// The arrows of ARCHITECTURE.md as rules on source text: which room may reach which, and what libraries never
// do. To let a room see another, add that to the table in rules.cpp, and to ARCHITECTURE.md.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace polhode::layers {

/// One `#include`: the name without its quotes or brackets, or the macro that stands for it
/// (`FT_FREETYPE_H`).
struct Include {
  std::string name;
  int line = 1;
  bool operator==(const Include&) const = default;
};

/// A broken rule; `line` counts from 1.
struct Finding {
  std::string file;
  int line = 1;
  std::string message;
};

/// `text` with comments and the insides of string and character literals (raw ones too) blanked; as many
/// lines as before. The operands of `#include` are kept.
std::string code_of(std::string_view text);

/// Every `#include` of the file, in order; commented-out ones are none.
std::vector<Include> includes_of(std::string_view text);

/// Everything in the C++ file at `path` (relative to the repository) that breaks a rule: an include that its
/// room may not see, a library that prints or exits, a header without `#pragma once`.
std::vector<Finding> broken_rules(const std::string& path, std::string_view text);

/// Every file that reaches, through the headers it includes, one that its room may not see. `sources`: all
/// files by their paths, and their texts.
std::vector<Finding> broken_closures(const std::map<std::string, std::string>& sources);

/// Every arrow of the table that no file follows: a room that may see another, and does not, neither itself
/// nor through what it sees.
std::vector<Finding> unused_arrows(const std::map<std::string, std::string>& sources);

/// The types that the file defines for others: each struct, class, union, enum and alias of a namespace with
/// a name, as `polhode::builders::Extent`. What is only declared, or stands in a type, is none.
std::vector<std::string> types_of(std::string_view text);

/// Every header that defines a type that another header defines too. Nothing says so as long as no file
/// includes both, but the program then has two types of one name: what the linker makes of their inline
/// functions and templates, such as std::vector<Command>, is one of the two.
std::vector<Finding> doubled_types(const std::map<std::string, std::string>& sources);

/// Whether the licence is named on the first line, or on the second below `#!`.
bool names_licence(std::string_view text);

}  // namespace polhode::layers
