// SPDX-License-Identifier: MIT
// Every broken lesson of tests/data/lessons/invalid gets just the diagnostics stored beside it.
#include "tests/lessons/support.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

const std::filesystem::path kFolder = test::source_dir() / "tests/data/lessons/invalid";

class InvalidLesson : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(InvalidLesson, GetsTheExpectedDiagnostics) {
  const LessonReading reading = read_lesson(testing::read_file(GetParam()), "lesson.md");
  std::string found;
  for (const std::string& line : testing::lines_of(reading.diagnostics)) found += line + '\n';
  std::filesystem::path expected = GetParam();
  expected.replace_extension(".expected");
  EXPECT_EQ(found, testing::read_file(expected));
  EXPECT_FALSE(reading.lesson);
}

INSTANTIATE_TEST_SUITE_P(Files, InvalidLesson, ::testing::ValuesIn(testing::files_in(kFolder, ".md")),
                         [](const auto& test) {
                           std::string name = test.param.stem().string();
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(InvalidLessons, AreManyAndEachHasItsExpectation) {
  EXPECT_GE(testing::files_in(kFolder, ".md").size(), 30U);
  EXPECT_EQ(testing::files_in(kFolder, ".md").size(), testing::files_in(kFolder, ".expected").size());
}

}  // namespace
}  // namespace polhode
