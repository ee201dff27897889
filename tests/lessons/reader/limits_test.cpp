// SPDX-License-Identifier: MIT
// Each limit of reader.h is taken at the limit and refused one past it.
#include "lessons/reader/front_matter/front_matter.h"
#include "tests/lessons/support.h"

#include <gtest/gtest.h>

#include <functional>

namespace polhode {
namespace {

using testing::front_matter;
using testing::lesson_with;

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

std::string stages(int count) {
  std::string text = front_matter();
  for (int i = 0; i < count; ++i) text += "# T {s" + std::to_string(i) + "}\ntext\n";
  return text;
}

std::string steps(int count) { return lesson_with("text\n\n" + repeated("---\ntext\n\n", count - 1)); }

std::string quotes(int depth) { return lesson_with(repeated("> ", depth - 1) + "> [!said] a\n"); }

std::string lists(int depth) {
  std::string text;
  for (int i = 0; i < depth; ++i) text += std::string(2 * static_cast<std::size_t>(i), ' ') + "- a\n";
  return lesson_with(text);
}

std::string bytes(int count) {
  const std::string text = lesson_with("text ");
  return text + std::string(static_cast<std::size_t>(count) - text.size(), '\n');
}

// Arrays in a key whose value is of the wrong kind whatever the depth: only the message tells.
std::string toml_arrays(int depth) {
  return lesson_with("```scene\nat = " + repeated("[", depth) + repeated("]", depth) + "\n```\n");
}

std::string overlays(int count) {
  return lesson_with("```scene\nshow = [" + repeated("'L', ", count) + "]\n```\n");
}

/// Front matter with a table of so many entries whose names have letters only.
std::string table_of(const std::string& table, const std::string& value, int count) {
  std::string text = "+++\nformat = 1\nid = 'a'\ntitle = 'A'\n[" + table + "]\n";
  for (int i = 0; i < count; ++i)
    text += std::string("a") + static_cast<char>('a' + i / 26) + static_cast<char>('a' + i % 26) + " = " +
            value + "\n";
  return text + "+++\n# T {t}\ntext\n";
}
std::string macros(int count) { return table_of("macros", "'x'", count); }
std::string symbols(int count) { return table_of("symbols", "{ tex = 'x' }", count); }

struct Limit {
  const char* name;
  int limit;
  std::function<std::string(int)> lesson;
  std::string message;  // part of the refusal
};

bool is_refused(const std::string& text, const std::string& message) {
  for (const std::string& line : testing::complaints(text)) {
    if (line.find(message) != std::string::npos) return true;
  }
  return false;
}

class LessonLimit : public ::testing::TestWithParam<Limit> {};
TEST_P(LessonLimit, IsTakenAtTheLimitAndRefusedOnePastIt) {
  const Limit& limit = GetParam();
  EXPECT_FALSE(is_refused(limit.lesson(limit.limit), limit.message));
  EXPECT_TRUE(is_refused(limit.lesson(limit.limit + 1), limit.message));
}
INSTANTIATE_TEST_SUITE_P(
    All, LessonLimit,
    ::testing::Values(Limit{"bytes", static_cast<int>(kMaxLessonBytes), bytes, "bytes, at most"},
                      Limit{"stages", kMaxStages, stages, "at most 200 stages"},
                      Limit{"steps", kMaxStepsPerStage, steps, "at most 100 steps"},
                      Limit{"quotes", kMaxNesting, quotes, "nested deeper"},
                      Limit{"lists", kMaxNesting, lists, "nested deeper"},
                      Limit{"toml", kMaxNesting, toml_arrays, "nested deeper"},
                      Limit{"overlays", kMaxOverlays, overlays, "at most 40"},
                      Limit{"macros", static_cast<int>(kMaxMacros), macros, "at most 64 macros"},
                      Limit{"symbols", static_cast<int>(kMaxSymbols), symbols, "at most 200 symbols"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(LessonLimit, LessonsAtTheirLimitsAreRead) {
  EXPECT_TRUE(read_lesson(bytes(static_cast<int>(kMaxLessonBytes)), "").lesson);
  EXPECT_TRUE(read_lesson(stages(kMaxStages), "").lesson);
  EXPECT_TRUE(read_lesson(steps(kMaxStepsPerStage), "").lesson);
  EXPECT_TRUE(read_lesson(lists(kMaxNesting), "").lesson);
  EXPECT_TRUE(read_lesson(macros(static_cast<int>(kMaxMacros)), "").lesson);
  EXPECT_TRUE(read_lesson(symbols(static_cast<int>(kMaxSymbols)), "").lesson);
  EXPECT_TRUE(read_lesson(overlays(kMaxOverlays), "").lesson);
}

TEST(LessonLimit, OfPartsCountsBlocksAndClaims) {
  // 200 stages of one equation each, and claims of one line each, two parts: just so many fit.
  std::string text = front_matter();
  int left = kMaxParts;
  for (int i = 0; i < kMaxStages; ++i, left -= 2)
    text += "# T {s" + std::to_string(i) + "}\n```math a\nx\n```\n";
  const std::string line = "T=T\n";
  for (; left >= 65; left -= 65) text += "```claim a law\n" + repeated(line, 64) + "```\n";
  text += "```claim a law\n" + repeated(line, left - 1) + "```\n";
  EXPECT_TRUE(read_lesson(text, "").lesson);
  EXPECT_TRUE(is_refused(text + "text\n", "at most 50000 parts"));
}

}  // namespace
}  // namespace polhode
