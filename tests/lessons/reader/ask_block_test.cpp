// SPDX-License-Identifier: MIT
#include "lessons/reader/ask_block.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::TextReport;

std::optional<Ask> ask_from(TextReport& at) {
  return read_ask(testing::toml(at.text), "a", {1, 1}, FrontMatter(), at.texts);
}

TEST(Ask, ReadsAnExpression) {
  TextReport at(
      "type = 'expression'\nprompt = 'What is $y$?'\nanswer = 'w3*w1*(I1 - I3)'\nhints = ['One.', 'Two.']");
  const auto ask = ask_from(at);
  EXPECT_THAT(at.lines(), IsEmpty());
  ASSERT_TRUE(ask);
  EXPECT_EQ(ask->id, "a");
  EXPECT_EQ(ask->type, Ask::Type::expression);
  EXPECT_EQ(ask->prompt, "What is $y$?");
  EXPECT_EQ(ask->expression->text, "w3*w1*(I1 - I3)");
  EXPECT_EQ(ask->modulo, "identity");
  EXPECT_THAT(ask->hints, ElementsAre("One.", "Two."));
}

TEST(Ask, ReadsChoicePredictionAndOrder) {
  const std::string common = "prompt = 'Which?'\nchoices = ['x', 'y', 'z']\n";
  TextReport choice("type = 'choice'\nanswer = 2\n" + common);
  EXPECT_THAT(ask_from(choice)->answers, ElementsAre(2));
  TextReport predict("type = 'predict'\nanswer = 3\n" + common);
  EXPECT_EQ(ask_from(predict)->type, Ask::Type::predict);
  TextReport order("type = 'order'\nanswer = [3, 1, 2]\n" + common);
  EXPECT_THAT(ask_from(order)->answers, ElementsAre(3, 1, 2));
}

class AskRefuses : public ::testing::TestWithParam<const char*> {};
TEST_P(AskRefuses, AndSaysWhy) {
  TextReport at(GetParam());
  EXPECT_FALSE(ask_from(at)) << GetParam();
  EXPECT_TRUE(at.report.has_errors()) << GetParam();
}
INSTANTIATE_TEST_SUITE_P(
    All, AskRefuses,
    ::testing::Values("", "type = 'expression'\nprompt = 'x'", "type = 'expression'\nanswer = 'w1'",
                      "prompt = 'x'\nanswer = 'w1'", "type = 'expression'\nprompt = ' '\nanswer = 'w1'",
                      "type = 'expression'\nprompt = 'x'\nanswer = 'w9'",
                      "type = 'expression'\nprompt = 'x'\nanswer = 'norm(L)'",
                      "type = 'expression'\nprompt = 'x'\nanswer = 1",
                      "type = 'expression'\nprompt = 'x'\nanswer = 'w1'\nmodulo = 'all'",
                      "type = 'expression'\nprompt = 'x'\nanswer = 'w1'\nchoices = ['a', 'b']",
                      "type = 'expression'\nprompt = 'x'\nanswer = 'w1'\nhints = 1",
                      "type = 'quiz'\nprompt = 'x'\nanswer = 'w1'", "type = 1\nprompt = 'x'\nanswer = 'w1'",
                      "type = 'choice'\nprompt = 'x'\nanswer = 1\nchoices = ['a']",
                      "type = 'choice'\nprompt = 'x'\nanswer = 0\nchoices = ['a', 'b']",
                      "type = 'choice'\nprompt = 'x'\nanswer = 3\nchoices = ['a', 'b']",
                      "type = 'choice'\nprompt = 'x'\nanswer = '1'\nchoices = ['a', 'b']",
                      "type = 'choice'\nprompt = 'x'\nanswer = 1\nchoices = ['a', 'b']\nmodulo = 'free'",
                      "type = 'order'\nprompt = 'x'\nanswer = 1\nchoices = ['a', 'b']",
                      "type = 'order'\nprompt = 'x'\nanswer = [1]\nchoices = ['a', 'b']",
                      "type = 'order'\nprompt = 'x'\nanswer = [1, 1]\nchoices = ['a', 'b']",
                      "type = 'order'\nprompt = 'x'\nanswer = [1, 3]\nchoices = ['a', 'b']"));

}  // namespace
}  // namespace polhode
