// SPDX-License-Identifier: MIT
#include "lessons/reader/front_matter/plain_toml.h"

#include "lessons/reader/reader.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

namespace polhode {
namespace {

std::string written(const TomlTable& table);

/// All of a value, its place and its bits.
std::string written(const TomlValue& value) {
  std::ostringstream out;
  out << value.place.line << ':' << value.place.column << ' ' << value.held.index() << ' ';
  if (const auto* text = value.as<std::string>()) out << *text;
  if (const auto* integer = value.as<std::int64_t>()) out << *integer;
  if (const auto* number = value.as<double>()) out << std::hexfloat << *number;
  if (const auto* flag = value.as<bool>()) out << *flag;
  if (const auto* list = value.as<TomlArray>())
    for (const TomlValue& one : *list) out << '[' << written(one) << ']';
  if (const auto* table = value.as<TomlTable>()) out << '{' << written(*table) << '}';
  return out.str();
}

std::string written(const TomlTable& table) {
  std::ostringstream out;
  for (const TomlEntry& entry : table.entries)
    out << entry.key << '@' << entry.place.line << ':' << entry.place.column << '=' << written(entry.value)
        << '\n';
  return out.str();
}

/// What the library makes of it; nothing if it refuses it.
std::optional<std::string> by_library(const std::string& text) {
  const SourceText source(text);
  Report report(source, "");
  const auto table = parse_any_toml(text, 7, report);
  return table ? std::optional(written(*table)) : std::nullopt;
}

std::optional<std::string> plainly(const std::string& text) {
  const auto table = read_plain_toml(text, 7, kMaxNesting);
  return table ? std::optional(written(*table)) : std::nullopt;
}

/// What is read is what the library reads.
void expect_same(const std::string& text) {
  const auto read = plainly(text);
  if (!read) return;
  EXPECT_EQ(read, by_library(text)) << text;
}

/// The fences of scenes and questions of all lessons, without their lists of choices.
std::vector<std::string> fences() {
  std::vector<std::string> texts;
  for (const auto& file : std::filesystem::directory_iterator(test::source_dir() / "lessons")) {
    if (file.path().extension() != ".md") continue;
    std::ifstream lines(file.path());
    std::string text;
    bool is_inside = false;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("```")) {
        if (is_inside) texts.push_back(std::exchange(text, {}));
        is_inside = line == "```scene" || line == "```table" || line.starts_with("```ask");
      } else if (is_inside && !line.starts_with("- [") && !line.starts_with("  ") &&
                 !line.starts_with("1.")) {
        text += line + '\n';
      }
    }
  }
  return texts;
}

TEST(PlainToml, IsReadAsByTheLibrary) {
  for (const char* text : {"",
                           "\n",
                           "a = 1",
                           "a = -0\nb=0.50 # half\n\n",
                           "ω = 1",
                           "a = 'ω\\vec L'   \nb = \"ω\"",
                           "a = [1, 2.5e-3,\n 3,]",
                           "b = 1\na = { z = 'ω', y = [[1], []] }",
                           "a = true\nc-d_1 = false",
                           "a = \"\\\\vec \\\"L\\\"\"",
                           "a = {}",
                           "a = [ # list\n  'x', # ω\n\t'y'\n]",
                           "t = '''x'''",
                           "t = \"\"\"x\"\"\"",
                           "a = 2024-01-02",
                           "a.b = 1",
                           "[a]\nb = 1",
                           "a = 1\na = 2",
                           "a = { b = 1, b = 2 }",
                           "a = 01",
                           "a = 1_000",
                           "a = +1",
                           "a = inf",
                           "a = 1.",
                           "a = .5",
                           "a = 1e400",
                           "a = 99999999999999999999",
                           "a = 9223372036854775807",
                           "a = 0.1e+2",
                           "a = 1E5",
                           "a = 'x",
                           "a = \"\\u00e9\"",
                           "a = 1 2",
                           "a = [1 2]",
                           "a = {b = 1,}",
                           "a = 1\r\nb = 2",
                           "a = 'x\x01'",
                           "# \x01",
                           "a = '\xff'",
                           "a = [[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]"})
    expect_same(text);
}

TEST(PlainToml, IsWhatNearlyAllFencesHold) {
  const auto texts = fences();
  ASSERT_GT(texts.size(), 700u);
  std::size_t plain = 0;
  for (const std::string& text : texts) {
    plain += plainly(text) ? 1 : 0;
    expect_same(text);
  }
  EXPECT_GT(plain, texts.size() * 9 / 10);
}

TEST(PlainToml, IsNeverReadOtherwiseThanByTheLibrary) {
  std::mt19937 random(11);
  const auto texts = fences();
  const std::string marks = "\"'\\[]{}=,.#\n \t-+eE0159_abtf\r\x80\xcf\x89";
  for (std::size_t i = 0; i < 6000; ++i) {
    std::string text = texts[random() % texts.size()].substr(0, 400);
    for (std::size_t n = 1 + random() % 3; n > 0 && !text.empty(); --n) {
      const std::size_t at = random() % text.size();
      const char mark = marks[random() % marks.size()];
      if (random() % 3 == 0)
        text.erase(at, 1);
      else if (random() % 2 == 0)
        text[at] = mark;
      else
        text.insert(at, 1, mark);
    }
    expect_same(text);
  }
}

}  // namespace
}  // namespace polhode
