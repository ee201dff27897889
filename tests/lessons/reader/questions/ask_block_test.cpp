// SPDX-License-Identifier: MIT
#include "lessons/reader/questions/ask_block.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <utility>

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

/// A question whose keys are `keys`, with this list below them, in a stage "s" of a lesson "l".
struct Listed {
  explicit Listed(const std::string& keys, const std::string& list, const std::string& id = "a")
      : keys_at("prompt = 'Which?'\n" + keys), at(list) {
    front.id = "l";
    at.texts.speak(front.notation.vocabulary, {});
    const ChoiceList choices = read_choice_list(1, at.source.line_count(), at.report);
    ask = read_ask(testing::toml(keys_at.text), id, {1, 1}, front, at.texts, &choices, "s");
    said = at.lines();
  }

  FrontMatter front;
  TextReport keys_at, at;
  std::optional<Ask> ask;
  std::vector<std::string> said;
};

std::string words_of(const RichText& text) {
  std::string words;
  for (const TextBlock& block : text)
    for (const TextSpan& span : block.spans) words += span.text;
  return words;
}

constexpr const char* kList = "- [ ] x\n  Not x.\n- [x] y\n- [ ] $z$\n  Not $z$:\n  no.\n";

TEST(ListedAsk, KeepsTextsRepliesAndAnswerTogether) {
  bool moved = false;
  for (const char* id : {"a", "b", "c", "d"}) {
    const Listed at("type = 'choice'\nbecause = 'It is $y$.'", kList, id);
    EXPECT_THAT(at.said, IsEmpty());
    ASSERT_TRUE(at.ask);
    const Ask& ask = *at.ask;
    ASSERT_EQ(ask.choices.size(), 3U);
    ASSERT_EQ(ask.replies.size(), 3U);
    ASSERT_EQ(ask.answers.size(), 1U);
    const auto answer = static_cast<std::size_t>(ask.answers.front() - 1);
    EXPECT_EQ(ask.choices[answer], "y");
    EXPECT_THAT(ask.replies[answer], IsEmpty());
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string words = words_of(ask.choice_texts[i]);
      EXPECT_EQ(words, ask.choices[i] == "$z$" ? "z" : ask.choices[i]);
      EXPECT_EQ(words_of(ask.replies[i]), words == "x" ? "Not x." : words == "z" ? "Not z: no." : "");
    }
    EXPECT_EQ(words_of(ask.because), "It is y.");
    moved = moved || ask.choices.front() != "x";
  }
  EXPECT_TRUE(moved) << "of four ids not all leave the order as it is";
}

TEST(ListedAsk, EditingTheTextsMovesNothing) {
  const Listed before("type = 'predict'", "- [ ] x\n- [x] y\n- [ ] z");
  const Listed after("type = 'predict'", "- [ ] other\n- [x] words\n  and a reply\n- [ ] here");
  EXPECT_EQ(before.ask->answers, after.ask->answers);
}

TEST(ListedAsk, StaysAsWrittenWhereItIsNotShuffled) {
  for (const char* id : {"a", "b", "c", "d"}) {
    const Listed at("type = 'choice'\nshuffle = false", "- [ ] x\n- [ ] y\n- [x] z", id);
    EXPECT_THAT(at.ask->choices, ElementsAre("x", "y", "z"));
    EXPECT_THAT(at.ask->answers, ElementsAre(3));
  }
  TextReport older("type = 'choice'\nprompt = 'Which?'\nchoices = ['x', 'y']\nanswer = 1");
  EXPECT_THAT(ask_from(older)->choices, ElementsAre("x", "y")) << "a lesson of keys keeps its letters";
}

TEST(ListedAsk, AnOrderIsNeverShownInItsOrder) {
  for (char id = 'a'; id <= 'z'; ++id) {
    const Listed at("type = 'order'", "1. first\n2. second\n3. third", std::string(1, id));
    EXPECT_THAT(at.said, IsEmpty());
    std::vector<std::string> in_order;
    for (const int answer : at.ask->answers)
      in_order.push_back(at.ask->choices[static_cast<std::size_t>(answer - 1)]);
    EXPECT_THAT(in_order, ElementsAre("first", "second", "third"));
    EXPECT_NE(at.ask->choices, in_order);
  }
}

struct WrongList {
  const char *keys, *list, *says;
};
class ListedAskRefuses : public ::testing::TestWithParam<WrongList> {};
TEST_P(ListedAskRefuses, WithThePlaceAndWhatToWrite) {
  const Listed at(GetParam().keys, GetParam().list);
  EXPECT_FALSE(at.ask);
  ASSERT_FALSE(at.said.empty());
  EXPECT_THAT(at.said.front(), ::testing::HasSubstr(GetParam().says));
}
INSTANTIATE_TEST_SUITE_P(
    All, ListedAskRefuses,
    ::testing::Values(
        WrongList{"type = 'choice'\nanswer = 1", kList, "3:1: error: \"answer\" and a list of choices"},
        WrongList{"type = 'choice'\nchoices = ['x', 'y']", kList, "\"choices\" and a list of choices"},
        WrongList{"type = 'choice'", "- [ ] x\n- [ ] y",
                  "1:1: error: none of the choices is marked as right"},
        WrongList{"type = 'choice'", "- [x] x\n- [x] y", "2:1: error: two choices are marked as right"},
        WrongList{"type = 'choice'", "- [x] x", "needs at least two choices"},
        WrongList{"type = 'choice'", "1. x\n2. y", "\"choice\" takes a list with boxes"},
        WrongList{"type = 'order'", kList, "\"order\" takes a list with numbers"},
        WrongList{"type = 'order'", "1. x\n  reply\n2. y", "1:1: error: no part of an order has a reply"},
        WrongList{"type = 'order'\nshuffle = false", "1. x\n2. y", "an order in a list is always shuffled"},
        WrongList{"type = 'expression'", kList, "\"expression\" has no list of choices"},
        WrongList{"type = 'choice'\nplays = [0, 1]", kList, "\"plays\" is of questions of type \"predict\""},
        WrongList{"type = 'predict'\nplays = [1, 1]", kList, "this plays nothing"},
        WrongList{"type = 'choice'\nunit = 'J'", kList, "\"unit\" is of questions of type \"number\""}));

TEST(Ask, ReadsANumberWithItsUnitAndTolerance) {
  TextReport at(
      "type = 'number'\nprompt = 'How fast?'\nanswer = 'norm(omega)'\nunit = 'deg/s'\nwithin = 0.05");
  at.texts.speak({}, {});
  const auto ask = ask_from(at);
  EXPECT_THAT(at.lines(), IsEmpty());
  ASSERT_TRUE(ask && ask->number && ask->number->expression);
  EXPECT_EQ(ask->number->unit, "deg/s");
  EXPECT_TRUE(ask->number->is_relative);
  EXPECT_EQ(words_of({ask->prompt_text.back()}), "Answer in degrees per second, to within 5 %.");

  TextReport absolute("type = 'number'\nprompt = 'p'\nanswer = 40\nunit = 'deg'\nwithin = '0.01 rad'");
  absolute.texts.speak({}, {});
  const auto other = ask_from(absolute);
  EXPECT_THAT(absolute.lines(), IsEmpty());
  ASSERT_TRUE(other && other->number && other->number->value);
  EXPECT_DOUBLE_EQ(*other->number->value, 40);
  EXPECT_FALSE(other->number->is_relative);
  EXPECT_DOUBLE_EQ(other->number->within, 0.01 * 180 / std::numbers::pi);
  EXPECT_EQ(other->number->within_text, "0.01 rad");

  TextReport degrees("type = 'number'\nprompt = 'p'\nanswer = 40\nunit = 'deg'\nwithin = '1 deg'");
  degrees.texts.speak({}, {});
  EXPECT_EQ(ask_from(degrees).value().number->within_text, "1°");
}

class NumberRefuses : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};
TEST_P(NumberRefuses, AndSaysWhy) {
  TextReport at(std::string("type = 'number'\nprompt = 'p'\n") + GetParam().first);
  at.texts.speak({}, {});
  EXPECT_FALSE(ask_from(at));
  const auto said = at.lines();
  ASSERT_FALSE(said.empty());
  EXPECT_THAT(said.front(), ::testing::HasSubstr(GetParam().second));
}
INSTANTIATE_TEST_SUITE_P(
    All, NumberRefuses,
    ::testing::Values(std::pair{"unit = 'J'", "lacks \"answer\""},
                      std::pair{"answer = 'T'", "this is in kg m²/s², and the question has no unit"},
                      std::pair{"answer = 'T'\nunit = 'N'", "units disagree"},
                      std::pair{"answer = 'T'\nunit = 'erg'", "4:8: error: unknown unit \"erg\""},
                      std::pair{"answer = 'L'\nunit = 'J'", "is a scalar"},
                      std::pair{"answer = 'T +'\nunit = 'J'", "error"},
                      std::pair{"answer = [1]", "\"answer\""},
                      std::pair{"answer = 1\nwithin = 0", "\"within\""},
                      std::pair{"answer = 1\nwithin = 0.5", "this decides nothing"},
                      std::pair{"answer = 1\nwithin = 'about'", "a tolerance is a part of the answer"},
                      std::pair{"answer = 1\nunit = 'J'\nwithin = '1 s'", "units disagree"},
                      std::pair{"answer = 1\nchoices = ['a', 'b']", "a question for a number has no choices"},
                      std::pair{"answer = 1\nmodulo = 'free'",
                                "\"modulo\" is of questions for an expression"},
                      std::pair{"answer = 1\nshuffle = true", "\"shuffle\" is of questions"}));

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
