// SPDX-License-Identifier: MIT
#include "lessons/reader/front_matter/toml_tree.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using testing::TextReport;

TEST(ParseToml, KeepsValuesAndPlaces) {
  const std::string quoted_key = "a = 1\n\"ω\" = [1.5, \"x\"]\n[t]\n  k = true";
  TextReport at(quoted_key);
  const auto table = parse_toml(quoted_key, 10, at.report);
  ASSERT_TRUE(table);
  EXPECT_EQ(*table->find("a")->value.as<std::int64_t>(), 1);
  EXPECT_EQ(table->find("a")->place, (SourcePlace{10, 1}));
  EXPECT_EQ(table->find("a")->value.place, (SourcePlace{10, 5}));
  const auto& list = *table->find("ω")->value.as<TomlArray>();
  EXPECT_EQ(*list[0].as<double>(), 1.5);
  EXPECT_EQ(*list[1].as<std::string>(), "x");
  EXPECT_EQ(list[1].place, (SourcePlace{11, 13}));
  const auto& inner = *table->find("t")->value.as<TomlTable>();
  EXPECT_TRUE(*inner.find("k")->value.as<bool>());
  EXPECT_EQ(inner.find("k")->place, (SourcePlace{13, 3}));
  EXPECT_EQ(inner.find("x"), nullptr);
}

TEST(ParseToml, NamesTheKindsOfValues) {
  const TomlTable table = testing::toml("a=1\nb=1.0\nc=''\nd=true\ne=[]\nf={}\ng=1979-05-27");
  std::vector<std::string_view> kinds;
  for (const TomlEntry& entry : table.entries) kinds.push_back(entry.value.kind());
  EXPECT_THAT(kinds, ElementsAre("a number", "a number", "a string", "true or false", "a list", "a table",
                                 "a date or time"));
}

TEST(ParseToml, ReportsSyntaxWhereItIs) {
  TextReport at("a = 1\nb = \n");
  EXPECT_FALSE(parse_toml(at.text, 1, at.report));
  const auto lines = at.lines();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].substr(0, 18), "2:5: error: TOML: ");
}

TEST(ParseToml, RefusesOneByteTooMany) {
  const std::string fits = "#" + std::string(kMaxTomlBytes - 1, 'a');
  TextReport good(fits);
  EXPECT_TRUE(parse_toml(fits, 1, good.report));
  TextReport bad(fits + "a");
  EXPECT_FALSE(parse_toml(bad.text, 1, bad.report));
}

std::string nested(const std::string& open, int depth, const std::string& close) {
  std::string text = "a = ";
  for (int i = 0; i < depth; ++i) text += open;
  text += "1";
  for (int i = 0; i < depth; ++i) text += close;
  return text;
}

struct Nesting {
  std::string at_limit;
  std::string beyond;
};
class TomlNesting : public ::testing::TestWithParam<Nesting> {};
TEST_P(TomlNesting, IsTakenAtTheLimitAndRefusedOnePastIt) {
  EXPECT_EQ(first_toml_nested_deeper(GetParam().at_limit, 3), std::nullopt) << GetParam().at_limit;
  EXPECT_NE(first_toml_nested_deeper(GetParam().beyond, 3), std::nullopt) << GetParam().beyond;
}
INSTANTIATE_TEST_SUITE_P(
    All, TomlNesting,
    ::testing::Values(Nesting{nested("[", 3, "]"), nested("[", 4, "]")},
                      Nesting{nested("{b=", 3, "}"), nested("{b=", 4, "}")},
                      Nesting{"a.b.c.d = 1", "a.b.c.d.e = 1"}, Nesting{"[a.b.c]", "[a.b.c.d]"},
                      Nesting{"[[a.b]]", "[[a.b.c]]"}, Nesting{"x = {a.b.c = 1}", "x = {a.b.c.d = 1}"},
                      Nesting{"x = [1.5, 2.5, 3.5, 4.5]", "x = [[[[1.5]]]]"},
                      Nesting{"x = '[[[[' # [[[[\ny = \"[[\\\"[[\"", "x = '['\ny = [[[["},
                      Nesting{"x = '''\n[[[['''\ny = \"\"\"[[\"[[\"\"\"", "x = ''''''\ny = [[[["},
                      Nesting{"x = '[[[[\ny = [[[1]]]", "x = '[[[[\ny = [[[[1]]]]"}));

}  // namespace
}  // namespace polhode
