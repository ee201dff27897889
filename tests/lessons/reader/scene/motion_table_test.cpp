// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/motion_table.h"

#include "lessons/reader/checks/claim_check.h"
#include "lessons/reader/checks/lesson_check.h"
#include "lessons/reader/reader.h"
#include "tests/lessons/support.h"
#include "tests/support/paths.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kScene = "\n```scene\nomega = [0.8, 0, 2]\n```\n";

/// The table begins on line 14.
std::string lesson(const std::string& table, const std::string& scene = kScene) {
  return "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n[body.pencil]\nmoments = [1, 1, "
         "0.3]\n[body.coin]\nmoments = [1, 1, 1.9]\n[scene]\nbody = \"pencil\"\n+++\n# S {s}\n```table\n" +
         table + "\n```\n" + scene;
}

std::vector<std::string> faults(const std::string& text) {
  LessonReading reading = read_lesson(text, "a.md");
  if (!reading.lesson) return testing::lines_of(reading.diagnostics);
  prove_claims(*reading.lesson);
  return testing::lines_of(check_claims(*reading.lesson, "a.md"));
}

/// The numbers of the only table, by their ids: row by row.
std::map<int, double> values_of(const std::string& text) {
  LessonReading reading = read_lesson(text, "a.md");
  if (!reading.lesson) {
    ADD_FAILURE() << ::testing::PrintToString(testing::lines_of(reading.diagnostics));
    return {};
  }
  std::vector<int> ids;
  for (int i = 0; i < static_cast<int>(reading.lesson->numbers.size()); ++i) ids.push_back(i);
  return values_in_tables(reading.lesson->numbers, ids);
}

constexpr const char* kRows = "rows = [{ head = \"pencil\" }, { head = \"coin\", body = \"coin\" }]";
std::string table_of(const std::string& column) {
  return "columns = [{ head = \"body\" }, " + column + "]\n" + kRows;
}

// |L|/I1 with L = (0.8 I1, 0, 2 I3).
TEST(MotionTable, HasTheNumbersOfEachRow) {
  const auto values = values_of(lesson(table_of("{ of = \"norm(L)/I1\", unit = \"rad/s\", digits = 4 }")));
  ASSERT_THAT(values, SizeIs(2));
  const double kRounding = 4 * std::numeric_limits<double>::epsilon();
  EXPECT_NEAR(values.at(0), std::hypot(0.8, 0.6), kRounding);
  EXPECT_NEAR(values.at(1), std::hypot(0.8, 3.8), 4 * kRounding);
}

TEST(MotionTable, IsTypesetAsATableWithUnitsInItsHead) {
  const LessonReading reading = read_lesson(
      lesson(table_of("{ head = \"*rate*\", of = \"norm(L)/I1\", unit = \"rad/s\" }, { of = \"T\" }")),
      "a.md");
  ASSERT_TRUE(reading.lesson);
  const auto prose = blocks_of<Prose>(reading.lesson->stages.front().steps.front());
  ASSERT_THAT(prose, SizeIs(1));
  ASSERT_THAT(prose.front()->text, SizeIs(1));
  const TextTable& table = prose.front()->text.front().table;
  using Align = TextTable::Align;
  EXPECT_THAT(table.columns, ElementsAre(Align::left, Align::right, Align::right));
  ASSERT_THAT(table.rows, SizeIs(3));
  const auto text_of = [](const TextTable::Cell& cell) {
    std::string text;
    for (const TextSpan& span : cell) text += span.text;
    return text;
  };
  EXPECT_EQ(text_of(table.rows[0][0]), "body");
  EXPECT_EQ(text_of(table.rows[0][1]), "rate (\\text{rad/s})");
  EXPECT_EQ(text_of(table.rows[0][2]), "T") << "the expression, where there is no head";
  EXPECT_EQ(text_of(table.rows[1][0]), "pencil");
  ASSERT_THAT(table.rows[2][1], SizeIs(1));
  EXPECT_THAT(table.rows[2][1].front().math.live, SizeIs(1));
}

// ω3 = 2 + t under a torque about axis 3 that equals I3.
TEST(MotionTable, IsThatOfItsTime) {
  const auto at = [](const std::string& table_at, const std::string& row_at) {
    return values_of(lesson(table_at +
                            "columns = [{ of = \"w3\" }]\nrows = [{ omega = [0, 0, 2], torque = "
                            "\"body:0,0,0.3\"" +
                            row_at + " }]"))
        .at(0);
  };
  const double kTolerance = 10 * 1e-10;  // that of the method, and its interpolation
  EXPECT_NEAR(at("", ""), 2, kTolerance);
  EXPECT_NEAR(at("at = 1.5\n", ""), 3.5, kTolerance);
  EXPECT_NEAR(at("at = 1.5\n", ", at = 4"), 6, kTolerance);
  EXPECT_NEAR(at("at = 1.5\n", ", at = -1"), 1, kTolerance);
}

TEST(MotionTable, ChangesTheSceneOfItsStepWhereverThatStands) {
  const std::string table = "columns = [{ of = \"w1\" }]\nrows = [{}]";
  EXPECT_NEAR(values_of(lesson(table)).at(0), 0.8, 0);
  EXPECT_NEAR(values_of(lesson("columns = [{ of = \"w1\" }]\nrows = [{}]",
                               "\n```scene\nscenes = [{ omega = [5, 0, 0] }, { omega = [6, 0, 0] }]\n```\n"))
                  .at(0),
              5, 0)
      << "the first of those side by side";
  EXPECT_NEAR(
      values_of(lesson("columns = [{ of = \"w1\" }]\nrows = [{}]",
                       "\n```scene\nomega = [5, 0, 0]\nvary = { omega1 = { from = 1, to = 9 } }\n```\n"))
          .at(0),
      5, 0)
      << "as it is, not at an end of its range";
  std::string second = lesson("columns = [{ of = \"w1\" }]\nrows = [{}]", "");
  second.insert(second.find("```table"), std::string("a\n") + kScene + "\n---\n\n");
  EXPECT_NEAR(values_of(second).at(0), 0.8, 0) << "one that the step goes on with";
  EXPECT_THAT(faults(lesson(table, "")),
              ElementsAre(HasSubstr("13:1: error: the numbers of a table need a scene")));
}

// A closed form has no error; explicit Euler turns ω⊥ by 1 + ix where it should by exp(ix), x = (I3 − I1)/I1
// ω3 h.
TEST(MotionTable, ComparesMethods) {
  const std::string text = lesson(
      "at = 0.1\ncolumns = [{ of = \"error_omega\" }, { of = \"drift_T\" }]\nrows = [\n"
      "{ motion = { method = \"explicit-euler\", step = 0.1 } },\n{ motion = { method = \"rk4\", step = 0.1 "
      "} },\n{}]");
  const auto values = values_of(text);
  ASSERT_THAT(values, SizeIs(5)) << "no error of the closed form, but a drift";
  const double x = -0.7 * 2 * 0.1;
  const double error = std::hypot(1 - std::cos(x), x - std::sin(x)) * 0.8 / std::hypot(0.8, 2);
  const double kRounding = 16 * std::numeric_limits<double>::epsilon();
  EXPECT_NEAR(values.at(0), error, kRounding);
  EXPECT_NEAR(values.at(1), 0.64 * x * x / (0.64 + 0.3 * 4), kRounding);
  EXPECT_LT(values.at(2), std::pow(std::abs(x), 5)) << "of order 4";
  EXPECT_THAT(
      faults(text),
      ElementsAre(HasSubstr("\"error_omega\" is not defined on the motion of this row at t = 0.1 s")));
}

// Explicit Euler in steps of 10 s makes ω⊥ fourteen times as long in each.
TEST(MotionTable, SaysOfARowThatItsMotionCannotBeFollowed) {
  const auto checked = [](const std::string& text) {
    return testing::lines_of(check_lesson(text, "a.md").diagnostics);
  };
  EXPECT_THAT(checked(lesson("at = 4000\ncolumns = [{ of = \"w1\" }, { of = \"T\" }]\nrows = [\n"
                             "{ motion = { method = \"explicit-euler\", step = 10 } }]")),
              ElementsAre(HasSubstr("error: the motion of this row cannot be followed to t = 4000 s")));
}

TEST(MotionTable, SaysWhatIsWrongWithItsKeys) {
  const auto says = [](const std::string& table, const std::string& what) {
    EXPECT_THAT(faults(lesson(table)), ElementsAre(HasSubstr(what))) << table;
  };
  const std::string columns = "columns = [{ of = \"T\" }]\n", rows = "rows = [{}]\n";
  says(rows, "13:1: error: the table lacks \"columns\"");
  says(columns, "13:1: error: the table lacks \"rows\"");
  says("columns = []\n" + rows, "14:11: error: \"columns\" is empty (for example");
  says(columns + "rows = []", "15:8: error: \"rows\" is empty");
  says("columns = \"T\"\n" + rows, "14:11: error: \"columns\" takes a list of tables, found a string");
  says("columns = [1]\n" + rows, "14:12: error: \"columns\" takes a list of tables, found a number in it");
  says(columns + "rows = 1", "15:8: error: \"rows\" takes a list of tables, found a number");
  says(columns + rows + "att = 1", "16:1: error: unknown key \"att\" in a table (did you mean \"at\"?)");
  says(columns + rows + "at = \"1\"", "16:6: error: \"at\" takes a number");
  says("columns = [{ head = \"a\" }]\nrows = [{ head = \"a\" }]",
       "14:11: error: nothing of this table is computed");
  says("columns = [{ of = \"T\", digit = 3 }]\n" + rows,
       "unknown key \"digit\" in a column (did you mean \"digits\"?)");
  says("columns = [{ of = \"T\", digits = 0 }]\n" + rows, "digits is a whole number from 1 to 15");
  says("columns = [{ of = \"T\", digits = 16 }]\n" + rows, "digits is a whole number from 1 to 15");
  says("columns = [{ of = \"T\", digits = 2.5 }]\n" + rows, "digits is a whole number from 1 to 15");
  says("columns = [{ of = \"T\", unit = \"cal\" }]\n" + rows, "14:31: error: unknown unit \"cal\"");
  says("columns = [{ of = \"T\", unit = \"rad/s\" }]\n" + rows,
       "14:31: error: units disagree: the expression is kg m²/s², and \"rad/s\" is 1/s");
  says("columns = [{ of = \"T + w1\" }]\n" + rows, "units disagree");
  says("columns = [{ of = \"Tt\" }]\n" + rows, "14:20: error: unknown symbol \"Tt\"");
  says("columns = [{ of = \"omega\" }]\n" + rows, "14:20: error: a computed number is a scalar");
  says("columns = [{ of = \"h\" }]\n" + rows, "\"h\" is any number");
  says("columns = [{ of = \"\" }]\n" + rows, "an expression is one line");
  says("columns = [{ of = 1 }]\n" + rows, "\"of\" takes a string");
  says("columns = [{ head = \"a\", unit = \"s\" }, { of = \"T\" }]\nrows = [{ head = \"a\" }]",
       "\"unit\" belongs to a column of numbers");
  says("columns = [{}, { of = \"T\" }]\nrows = [{ head = \"a\" }]", "14:12: error: a column has a \"head\"");
  says("columns = [{ head = '$\\frac$', of = \"T\" }]\n" + rows, "14:");
  says("columns = [{ head = '$\\live{T}$', of = \"T\" }]\n" + rows, "a computed number stands in");
}

TEST(MotionTable, SaysWhatIsWrongWithItsRows) {
  const auto says = [](const std::string& row, const std::string& what) {
    EXPECT_THAT(
        faults(lesson("columns = [{ head = \"a\" }, { of = \"T\" }]\nrows = [{ head = \"a\"" + row + " }]")),
        ElementsAre(HasSubstr(what)))
        << row;
  };
  says(", body = \"coins\"", "15:30: error: unknown body \"coins\" (did you mean \"coin\"?)");
  says(", omega = [1]", "\"omega\" takes a list of 3 numbers");
  says(", at = \"now\"", "\"at\" takes a number");
  says(", show = [\"omega\"]",
       "15:23: error: \"show\" is of a picture, and the rows of a table are motions (a row "
       "has body, omega, attitude, start, torque, velocity, force, arrow, motion)");
  says(", scenes = []", "\"scenes\" is of a picture");
  says(", still = 1", "\"still\" is of a picture");
  says(", omeg = [1, 2, 3]", "unknown key \"omeg\" in a row (did you mean \"omega\"?)");
  says(", xyzzy = 1",
       "unknown key \"xyzzy\" in a row (one of body, omega, attitude, start, torque, velocity, force, "
       "arrow, motion, head, at)");
  says(", motion = \"rk4\"", "\"rk4\" needs a step in seconds");
  says(", torque = \"weight\"", "and \"pencil\" has none");
  says(", start = { theta_deg = 60, spin = 1 }, omega = [1, 1, 1]",
       "a scene has a start, or omega and attitude");
  const auto head = [](const std::string& rows, const std::string& what) {
    EXPECT_THAT(faults(lesson("columns = [{ head = \"a\" }, { of = \"T\" }]\nrows = [" + rows + "]")),
                ElementsAre(HasSubstr(what)));
  };
  head("{}",
       "15:9: error: the head of a row has a text for each column without \"of\": there are 1, and 0 texts");
  head("{ head = [\"a\", \"b\"] }", "there are 1, and 2 texts");
  head("{ head = 1 }", "\"head\" takes a string or a list of strings");
}

TEST(MotionTable, IsAsLargeAsOtherTables) {
  const auto with = [](std::size_t columns, std::size_t rows) {
    std::string text = "columns = [";
    for (std::size_t i = 0; i < columns; ++i) text += "{ of = \"T\" }, ";
    text += "]\nrows = [";
    for (std::size_t i = 0; i < rows; ++i) text += "{}, ";
    return lesson(text + ']');
  };
  EXPECT_THAT(faults(with(kMaxTableColumns, kMaxTableRows)), IsEmpty());
  EXPECT_THAT(faults(with(kMaxTableColumns + 1, 1)),
              ElementsAre(HasSubstr("a table has at most 12 columns, found 13")));
  EXPECT_THAT(faults(with(1, kMaxTableRows + 1)),
              ElementsAre(HasSubstr("a table has at most 64 rows, found 65")));
}

TEST(MotionTable, IsWrittenAsTheFormatSays) {
  const std::string format = testing::read_file(test::source_dir() / "lessons/FORMAT.md");
  const std::string opening = "\n````markdown\n```table\n";
  const std::size_t begin = format.find(opening, format.find("\n### Computed tables\n")) + opening.size();
  const auto text = lesson(format.substr(begin, format.find("\n```\n", begin) - begin));
  EXPECT_THAT(faults(text), IsEmpty());
  const auto values = values_of(text);
  ASSERT_THAT(values, SizeIs(4));
  const double kRounding = 16 * std::numeric_limits<double>::epsilon();
  EXPECT_NEAR(values.at(1), 2 * std::numbers::pi / std::hypot(0.8, 0.6), 2 * std::numbers::pi * kRounding);
  std::string words = "| word | is |\n|---|---|\n";
  for (const MotionWord& word : motion_words())
    words += "| `" + std::string(word.name) + "` | " + std::string(word.means) + " |\n";
  EXPECT_THAT(format, HasSubstr(words + '\n'));
}

}  // namespace
}  // namespace polhode
