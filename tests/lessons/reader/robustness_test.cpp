// SPDX-License-Identifier: MIT
// Thousands of damaged lessons: no crash, and every refusal says at least one place that exists; the
// same under the sanitizers of the asan preset.
#include "tests/fuzz/mutate.h"
#include "tests/lessons/support.h"

#include <gtest/gtest.h>

#include <random>
#include <tuple>

namespace polhode {
namespace {

constexpr int kMutations = 4000;

const std::vector<std::string> kPieces = {"+++\n",       "---\n",
                                          "```",         "```scene\n",
                                          "```math a\n", "```claim a law\n",
                                          "```ask a\n",  "> ",
                                          "> [!said] ",  "- ",
                                          "# A {a}\n",   "[",
                                          "]",           "{",
                                          "}",           "=",
                                          "=>",          "\"",
                                          "'",           "'''",
                                          "\\",          "$",
                                          "$$",          "nan",
                                          "inf",         "1e999",
                                          "\xFF",        std::string(1, 0),
                                          "ω",           "\r",
                                          "\t",          "\n",
                                          "\n\n",        "(",
                                          ")",           ",",
                                          " within ",    "\\term{",
                                          "\\tag{",      "\\left",
                                          ".",           "#",
                                          "0x",          "9223372036854775808"};

using fuzz::Mutator;

void expect_sound(const std::string& text, const std::string& what) {
  const LessonReading reading = read_lesson(text, "lesson.md");
  const SourceText source(text);
  bool has_error = false;
  SourcePlace last{1, 1};
  for (const Diagnostic& d : reading.diagnostics) {
    has_error = has_error || d.severity == Severity::error;
    ASSERT_FALSE(d.message.empty()) << what;
    ASSERT_EQ(source.clamp(d.place), d.place) << what << ": " << to_string(d);
    ASSERT_LE(std::tie(last.line, last.column), std::tie(d.place.line, d.place.column)) << what;
    last = d.place;
  }
  ASSERT_NE(reading.lesson.has_value(), has_error) << what << ": a refusal has an error, a lesson has none";
}

TEST(Robustness, DamagedLessonsAreReadOrRefusedWithAPlace) {
  const std::string sample = testing::example_lesson();
  Mutator mutated({sample}, kPieces, 2024);
  for (int i = 0; i < kMutations; ++i) expect_sound(mutated.next(), "mutation " + std::to_string(i));
}

TEST(Robustness, EveryBeginningOfALessonIsReadOrRefused) {
  const std::string sample = testing::example_lesson();
  for (std::size_t size = 0; size <= sample.size(); ++size)
    expect_sound(sample.substr(0, size), std::to_string(size));
}

TEST(Robustness, DamagedBrokenLessonsToo) {
  for (const auto& path : testing::files_in(test::source_dir() / "tests/data/lessons/invalid", ".md")) {
    Mutator mutated({testing::read_file(path)}, kPieces, 7);
    for (int i = 0; i < 20; ++i)
      expect_sound(mutated.next(), path.filename().string() + ' ' + std::to_string(i));
  }
}

TEST(Robustness, RandomPiecesToo) {
  std::mt19937 random(11);
  for (int i = 0; i < 1000; ++i) {
    std::string text = testing::lesson_with("");
    for (int pieces = 0; pieces < 40; ++pieces) text += kPieces[random() % kPieces.size()];
    std::erase(text, '\xFF');
    std::erase(text, '\0');
    expect_sound(text, "pieces " + std::to_string(i));
  }
}

}  // namespace
}  // namespace polhode
