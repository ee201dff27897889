// SPDX-License-Identifier: MIT
// Lessons to test with.
#pragma once

#include "lessons/claims/expressions/expression.h"
#include "lessons/diagnostics/report.h"
#include "lessons/reader/front_matter/toml_tree.h"
#include "lessons/reader/markdown/inline_text.h"
#include "lessons/reader/reader.h"
#include "tests/support/paths.h"

#include <filesystem>
#include <string>
#include <vector>

namespace polhode::testing {

/// A front matter without faults, 7 lines long, its scene's body a book.
std::string front_matter();

/// A lesson of one stage "sample": its heading is line 8, `body` begins on line 9.
std::string lesson_with(const std::string& body);

/// Lines "line:column: severity: message (hint)" of what was reported.
std::vector<std::string> lines_of(const std::vector<Diagnostic>& diagnostics);

/// What read_lesson says of a text.
std::vector<std::string> complaints(const std::string& text);

/// The same, and what its proofs and checks say, of a lesson_with whose front matter has `tables` too.
std::vector<std::string> complaints_of(const std::string& body, const std::string& tables = "");

/// A report on its own text, and the lines it holds.
struct TextReport {
  explicit TextReport(std::string the_text)
      : text(std::move(the_text)), source(text), report(source, "text"), texts(report) {}
  std::vector<std::string> lines() { return lines_of(report.take()); }

  std::string text;
  SourceText source;
  Report report;
  TextReader texts;
};

/// left = right; throws what std::optional throws if one of them cannot be read.
Equality equality(const std::string& left, const std::string& right);

/// Table of a TOML text; fails the test and returns an empty one if it is none.
TomlTable toml(const std::string& text);

std::string read_file(const std::filesystem::path& path);
/// Files of a folder with this extension, sorted.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                            const std::string& extension);

/// The complete example of lessons/FORMAT.md.
std::string example_lesson();

}  // namespace polhode::testing
