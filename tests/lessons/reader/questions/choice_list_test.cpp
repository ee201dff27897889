// SPDX-License-Identifier: MIT
#include "lessons/reader/questions/choice_list.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::TextReport;

ChoiceList list_of(TextReport& at) { return read_choice_list(1, at.source.line_count(), at.report); }

TEST(ChoiceList, HasAReplyBelowEachChoice) {
  TextReport at("- [ ] one\n  No: $x$.\n\n  Nor this.\n\n- [x] two\n- [ ]   three\n    - a\n      b\n");
  const ChoiceList list = list_of(at);
  EXPECT_THAT(at.lines(), IsEmpty());
  ASSERT_EQ(list.items.size(), 3U);
  EXPECT_FALSE(list.is_numbered);
  EXPECT_EQ(list.items[0].text.text(), "one");
  EXPECT_EQ(list.items[0].reply.text(), "No: $x$.\n\nNor this.");
  EXPECT_EQ(at.source.place_of(list.items[0].reply.offset_of(4)).line, 2);
  EXPECT_EQ(at.source.place_of(list.items[0].reply.offset_of(4)).column, 7);
  EXPECT_FALSE(list.items[0].is_right);
  EXPECT_TRUE(list.items[1].is_right);
  EXPECT_EQ(list.items[1].reply.text(), "");
  EXPECT_EQ(list.items[2].text.text(), "three");
  EXPECT_EQ(list.items[2].reply.text(), "- a\n  b");
}

TEST(ChoiceList, OfAnOrderIsNumbered) {
  TextReport at("1. first\n2. second\n3. third");
  const ChoiceList list = list_of(at);
  EXPECT_THAT(at.lines(), IsEmpty());
  EXPECT_TRUE(list.is_numbered);
  ASSERT_EQ(list.items.size(), 3U);
  EXPECT_EQ(list.items[2].text.text(), "third");
}

TEST(ChoiceList, SaysWhatIsWrongWithIt) {
  TextReport boxes("- one\n- [x] two\n- [y] three\n2. four\n- [ ] \nunindented");
  list_of(boxes);
  EXPECT_THAT(boxes.lines(),
              ElementsAre(HasSubstr("1:1: error: a choice begins with its box"),
                          HasSubstr("3:1: error: a choice begins with its box"),
                          HasSubstr("4:1: error: one list has both boxes and numbers"),
                          HasSubstr("5:1: error: this choice is empty"),
                          HasSubstr("6:1: error: below a list of choices stand choices and replies only")));
  TextReport numbers("1. one\n3. two");
  list_of(numbers);
  EXPECT_THAT(numbers.lines(),
              ElementsAre(HasSubstr("2:1: error: an order is numbered 1, 2, 3 …: this is number 2")));
}

TEST(ChoiceList, BeginsBelowTheKeys) {
  const SourceText text(
      "type = 'choice'\nhints = ['''\n- [x] no list\n''', \"\"\"\n1. nor this\"\"\"]\n- [x] it\n");
  EXPECT_EQ(first_line_of_list(text, 1, 6), 6);
  const SourceText keys("type = 'choice'\nanswer = [\n1, 2]\n-key- = 1");
  EXPECT_EQ(first_line_of_list(keys, 1, 4), 5);
}

TEST(ShuffledOrder, IsAPermutationFixedByTheIds) {
  for (std::size_t count = 0; count <= 16; ++count) {
    std::vector<std::size_t> order = shuffled_order("lesson", "stage", "ask", count);
    EXPECT_EQ(order, shuffled_order("lesson", "stage", "ask", count));
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    EXPECT_EQ(order, all);
  }
  // So it was when lessons were first shuffled, and answers that learners have kept name choices by letters.
  EXPECT_THAT(shuffled_order("lesson", "stage", "ask", 4), ElementsAre(0, 2, 1, 3));
  EXPECT_NE(shuffled_order("lesson", "stage", "ask", 8), shuffled_order("lesson", "stage", "other", 8));
  EXPECT_NE(shuffled_order("lesson", "stage", "ask", 8), shuffled_order("lesson", "other", "ask", 8));
  EXPECT_NE(shuffled_order("lesson", "stage", "ask", 8), shuffled_order("other", "stage", "ask", 8));
}

TEST(ShuffledOrder, PutsEachChoiceUnderEachLetterAlikeOften) {
  constexpr std::size_t kIds = 4000, kChoices = 4;
  std::array<std::array<int, kChoices>, kChoices> often{};
  for (std::size_t id = 0; id < kIds; ++id) {
    const auto order = shuffled_order("euler-equations", "stage", "q" + std::to_string(id), kChoices);
    for (std::size_t i = 0; i < kChoices; ++i) ++often[i][order[i]];
  }
  // Each count is binomial: five of its standard deviations.
  const double mean = kIds / static_cast<double>(kChoices), sigma = std::sqrt(mean * (1 - 1.0 / kChoices));
  for (const auto& row : often)
    for (const int count : row) EXPECT_NEAR(count, mean, 5 * sigma);
}

}  // namespace
}  // namespace polhode
