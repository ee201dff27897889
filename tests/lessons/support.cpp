// SPDX-License-Identifier: MIT
#include "tests/lessons/support.h"

#include "lessons/reader/checks/claim_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace polhode::testing {

std::string front_matter() {
  return "+++\nformat = 1\nid = \"sample\"\ntitle = \"Sample\"\n[scene]\nbody = \"book\"\n+++\n";
}

std::string lesson_with(const std::string& body) { return front_matter() + "# Sample {sample}\n" + body; }

std::vector<std::string> lines_of(const std::vector<Diagnostic>& diagnostics) {
  std::vector<std::string> lines;
  for (Diagnostic diagnostic : diagnostics) {
    diagnostic.file.clear();
    lines.push_back(to_string(diagnostic).substr(1));
  }
  return lines;
}

std::vector<std::string> complaints(const std::string& text) {
  return lines_of(read_lesson(text, "sample.md").diagnostics);
}

std::vector<std::string> complaints_of(const std::string& body, const std::string& tables) {
  std::string text = lesson_with(body);
  const std::size_t end = text.find("+++", 3);
  text.insert(end, tables);
  LessonReading reading = read_lesson(text, "a.md");
  std::vector<std::string> lines = lines_of(reading.diagnostics);
  if (!reading.lesson) return lines;
  if (prove_claims(*reading.lesson)) lines.push_back("too long");
  for (const std::string& line : lines_of(check_claims(*reading.lesson, "a.md"))) lines.push_back(line);
  return lines;
}

Equality equality(const std::string& left, const std::string& right) {
  TextReport at(left), at_right(right);
  return {read_expression(left, {1, 1}, at.report).value(),
          read_expression(right, {1, 1}, at_right.report).value()};
}

TomlTable toml(const std::string& text) {
  TextReport at(text);
  const auto table = parse_toml(text, 1, at.report);
  EXPECT_TRUE(table.has_value()) << text;
  return table.value_or(TomlTable{});
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                            const std::string& extension) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string example_lesson() {
  const std::string text = read_file(test::source_dir() / "lessons" / "FORMAT.md");
  const std::string opening = "\n````markdown\n";
  const std::size_t begin = text.find(opening) + opening.size();
  return text.substr(begin, text.find("\n````\n", begin) + 1 - begin);
}

}  // namespace polhode::testing
