// SPDX-License-Identifier: MIT
// 1 MiB of anything takes at most 1 s and 64 MiB. Each input is a family some Markdown, TOML or
// TeX reader was slow on, or fills one of our own lists.
#include "lessons/reader/markdown/inline_text.h"
#include "lessons/reader/scene/scene_keys.h"
#include "tests/lessons/peak_memory.h"
#include "tests/lessons/support.h"

#include <gtest/gtest.h>

#include <ctime>
#include <functional>

namespace polhode {
namespace {

using testing::front_matter;
using testing::lesson_with;

constexpr double kMaxSeconds = 1.0;
constexpr long kMaxKilobytes = 64 * 1024;

// `unit` again and again until just 1 MiB is full, `tail` at the end.
std::string filled(std::string text, const std::string& unit, const std::string& tail = "") {
  while (text.size() + unit.size() + tail.size() <= kMaxLessonBytes) text += unit;
  return text + tail;
}
std::string stage_of(const std::string& unit) { return filled(lesson_with(""), unit); }
std::string math_of(const std::string& unit) { return filled(lesson_with("```math a\n"), unit, "\n```\n"); }
std::string claim_of(const std::string& begin, const std::string& unit, const std::string& end) {
  return filled(lesson_with("```math a\nx\n```\n```claim a measured\n" + begin), unit, end + "\n```\n");
}
std::string repeated(const std::string& unit, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += unit;
  return text;
}

std::string runs_of_backticks() {
  std::string text = lesson_with("");
  for (std::size_t run = 1; text.size() + run + 1 <= kMaxLessonBytes; ++run)
    text += 'a' + std::string(run, '`');
  return text;
}

// Texts as long as they may be, of this again and again.
std::string passages_of(const std::string& unit) {
  std::string passage;
  while (passage.size() + unit.size() <= kMaxPassageBytes) passage += unit;
  return stage_of(passage + "\n\n---\n");
}

std::string tables_in_scenes() {
  std::string keys = "```scene\n";
  for (int i = 0; keys.size() + 32 < kMaxTomlBytes; ++i) keys += "a" + std::to_string(i) + "={}\n";
  return stage_of(keys + "```\n---\n");
}

// Every step has a scene as large as scenes can be, and the rest of the text is filled with small blocks.
std::string largest_scenes() {
  const std::string caption = repeated("😀", static_cast<int>(kMaxCaptionCharacters));
  const std::string term(62, 't');
  std::string torque;
  std::string terms;
  std::string highlight;
  for (std::size_t i = 0; i < kMaxTorqueTerms; ++i) torque += "'space:1,2,3', ";
  for (std::size_t i = 0; i < kMaxHighlights; ++i) terms += "\\term{" + term + std::to_string(i) + "}{x}";
  for (std::size_t i = 0; i < kMaxHighlights; ++i) highlight += '\'' + term + std::to_string(i) + "', ";
  std::string text =
      "+++\nformat=1\nid='a'\ntitle='A'\n[scene]\ncaption='" + caption + "'\ntorque=[" + torque + "]\n+++\n";
  for (int stage = 0; stage < kMaxStages; ++stage) {
    text += "# A {a" + std::to_string(stage) + "}\n```math a\n" + terms + "\n```\n```scene\nhighlight=[" +
            highlight + "]\n```\n";
    text += repeated("---\na\n\n", kMaxStepsPerStage - 1);
  }
  while (text.size() + 1000 < kMaxLessonBytes) text += repeated("> [!said] x\n", 60) + "\na\n\n";
  return text;
}

// As many steps as there can be, each with a fence of these keys.
std::string scenes_of(const std::string& keys) {
  std::string text = "+++\nformat=1\nid='a'\ntitle='A'\n";
  for (int i = 0; text.size() < kMaxTomlBytes - 100; ++i)
    text += "[body.b" + std::to_string(i) + "]\nmoments=[1,1,1]\n";
  text += "+++\n";
  for (int stage = 0; stage < kMaxStages && text.size() + 100 * (keys.size() + 30) < kMaxLessonBytes; ++stage)
    text += "# A {a" + std::to_string(stage) + "}\n" +
            repeated("```scene\n" + keys + "\n```\n---\n", kMaxStepsPerStage - 1) + "a\n";
  return text + repeated("\na\n", static_cast<int>((kMaxLessonBytes - text.size()) / 3));
}

struct Input {
  const char* name;
  std::function<std::string()> text;
};

const std::vector<Input>& inputs() {
  static const std::vector<Input> all = {
      {"a_long_line", [] { return stage_of("a"); }},
      {"backslashes", [] { return stage_of("\\"); }},
      {"backtick_runs", runs_of_backticks},
      {"backticks", [] { return stage_of("a `b"); }},
      {"block_quotes", [] { return stage_of("> a\n\n"); }},
      {"brackets", [] { return stage_of("["); }},
      {"call_outs", [] { return stage_of("> [!said] a\n\na\n\n"); }},
      {"characters", [] { return stage_of("😀"); }},
      {"claim_brackets", [] { return claim_of("", "(", ""); }},
      {"claim_lines", [] { return claim_of("", "L=L\n", ""); }},
      {"claim_sum", [] { return claim_of("L=", "L+", "L"); }},
      {"claim_withins", [] { return claim_of("L=", " within", "L"); }},
      {"claims",
       [] {
         return filled(lesson_with("```math a\nx\n```\n"),
                       "```claim a law\n" + repeated("L=L\n", 60) + "```\n");
       }},
      {"deep_list", [] { return stage_of(repeated("  ", 15) + "- a\n"); }},
      {"dollars", [] { return stage_of("$"); }},
      {"display_dollars", [] { return stage_of("$$ "); }},
      {"emphasis", [] { return stage_of("a**b_c* "); }},
      {"entities", [] { return stage_of("&a;"); }},
      {"fences", [] { return stage_of("```\n```\n"); }},
      {"footnotes", [] { return stage_of("[^a]: b\n"); }},
      {"formulas", [] { return stage_of("$a$ "); }},
      {"front_matter", [] { return filled("+++\na=", "[", "\n+++\n"); }},
      {"headings", [] { return stage_of("#\n"); }},
      {"html", [] { return stage_of("<!-- "); }},
      {"scenes_side_by_side", [] { return scenes_of("scenes=[{},{},{}]"); }},
      {"scenes_varied",
       [] { return scenes_of("body='b0'\nvary={I1={from=0.9,to=1.1},I2={from=0.9,to=1.1}}"); }},
      {"largest_scenes", largest_scenes},
      {"link_definitions", [] { return stage_of("[a]: <b> \"c\"\n\n[a]\n\n"); }},
      {"links", [] { return stage_of("![[a]("); }},
      {"list_items", [] { return stage_of("- a\n  - b\n"); }},
      {"list_marks", [] { return stage_of("- "); }},
      {"math_braces", [] { return math_of("{"); }},
      {"math_closing", [] { return math_of("}"); }},
      {"math_tags", [] { return math_of("\\tag{1}"); }},
      {"math_terms", [] { return math_of("\\term{a}{b}"); }},
      {"numbered", [] { return stage_of("1. a\n"); }},
      {"one_dollar_each", [] { return stage_of("a\n\n$"); }},
      {"passages_of_angles", [] { return passages_of("<a "); }},
      {"passages_of_backticks", [] { return passages_of("`` ` a"); }},
      {"passages_of_brackets", [] { return passages_of("["); }},
      {"passages_of_citations", [] { return passages_of("[cite: a] "); }},
      {"passages_of_emphasis", [] { return passages_of("*a **b _c "); }},
      {"passages_of_entities", [] { return passages_of("&amp;"); }},
      {"passages_of_escapes", [] { return passages_of("\\*a"); }},
      {"passages_of_footnote_marks", [] { return passages_of("[^a] "); }},
      {"passages_of_formulas", [] { return passages_of("$a_1^2$ "); }},
      {"passages_of_images", [] { return passages_of("![[a]("); }},
      {"passages_of_items", [] { return passages_of("- a\n"); }},
      {"passages_of_links", [] { return passages_of("[a](b) "); }},
      {"passages_of_references", [] { return passages_of("[a]: b\n\n[a]\n\n"); }},
      {"passages_of_words", [] { return passages_of("*a* b "); }},
      {"fences_of_formulas",
       [] { return stage_of("```math a\n" + repeated("\\frac{a_1}{b^2}", 450) + "\n```\n---\n"); }},
      {"quote_marks", [] { return stage_of(">"); }},
      {"rules", [] { return stage_of("---\n"); }},
      {"scenes", [] { return stage_of("```scene\n```\n---\n"); }},
      {"spaces", [] { return stage_of(" "); }},
      {"steps", [] { return stage_of("a\n\n---\n"); }},
      {"tables_in_scenes", tables_in_scenes},
      {"toml_dots",
       [] {
         return stage_of("```scene\nx=[" + repeated("{a.a.a.a.a.a.a.a.a.a.a.a=1},", 2000) + "]\n```\n---\n");
       }},
      {"toml_lists", [] { return stage_of("```scene\nx=[" + repeated("1,", 32000) + "]\n```\n---\n"); }},
      {"underlined", [] { return stage_of("a\n-\n"); }},
      {"windows_lines", [] { return stage_of("a\r\n"); }},
  };
  return all;
}

class ReaderCost : public ::testing::TestWithParam<Input> {};

TEST_P(ReaderCost, IsAtMostASecondAndSixtyFourMebibytes) {
  const std::string text = GetParam().text();
  EXPECT_GT(text.size(), kMaxLessonBytes / 2);
  EXPECT_LE(text.size(), kMaxLessonBytes);

  if (testing::kSanitized) {
    read_lesson(text, "lesson.md");
    GTEST_SKIP() << "costs are measured without sanitizers";
  }

  const long kilobytes =
      testing::peak_kilobytes([&text] { return read_lesson(text, "lesson.md").diagnostics.size(); });
  RecordProperty("kilobytes", std::to_string(kilobytes));
  EXPECT_GT(kilobytes, 0);
  EXPECT_LE(kilobytes, kMaxKilobytes);

  const std::clock_t start = std::clock();  // processor time: other programs do not count
  read_lesson(text, "lesson.md");
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  RecordProperty("seconds", std::to_string(seconds));
  EXPECT_LE(seconds, kMaxSeconds);
}

INSTANTIATE_TEST_SUITE_P(All, ReaderCost, ::testing::ValuesIn(inputs()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace polhode
