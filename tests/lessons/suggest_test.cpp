// SPDX-License-Identifier: MIT
#include "lessons/suggest.h"

#include <gtest/gtest.h>

#include <random>

namespace polhode {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("omega", "omega"), 0);
  EXPECT_EQ(edit_distance("omga", "omega"), 1);
  EXPECT_EQ(edit_distance("omeega", "omega"), 1);
  EXPECT_EQ(edit_distance("omaga", "omega"), 1);
  EXPECT_EQ(edit_distance("omgea", "omega"), 1);
  EXPECT_EQ(edit_distance("", "omega"), 5);
  EXPECT_EQ(edit_distance("omega", ""), 5);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(EditDistance, IsSymmetricAndBoundedByTheLongerWord) {
  std::mt19937 random(1);
  const auto word = [&random] {
    std::string text(random() % 8, 'a');
    for (char& c : text) c = static_cast<char>('a' + random() % 3);
    return text;
  };
  for (int i = 0; i < 500; ++i) {
    const std::string a = word();
    const std::string b = word();
    const int distance = edit_distance(a, b);
    EXPECT_EQ(distance, edit_distance(b, a)) << a << ' ' << b;
    EXPECT_LE(distance, static_cast<int>(std::max(a.size(), b.size()))) << a << ' ' << b;
    EXPECT_GE(distance, std::abs(static_cast<int>(a.size()) - static_cast<int>(b.size()))) << a << ' ' << b;
    EXPECT_EQ(distance == 0, a == b) << a << ' ' << b;
  }
}

TEST(Suggestion, NamesTheNearest) {
  const std::vector<std::string> known = {"polhode", "herpolhode", "plane"};
  EXPECT_EQ(suggestion("plhode", known), "did you mean \"polhode\"?");
  EXPECT_EQ(suggestion("herpolhod", known), "did you mean \"herpolhode\"?");
  EXPECT_EQ(suggestion("PLANE", known), "did you mean \"plane\"?");
}

TEST(Suggestion, TakesTheBeginningOfANameForIt) {
  EXPECT_EQ(suggestion("azimuth", {"elevation_deg", "azimuth_deg"}), "did you mean \"azimuth_deg\"?");
  EXPECT_EQ(nearest_name("az", {"azimuth_deg"}), std::nullopt);
}

TEST(Suggestion, ListsWhatThereIsIfNothingIsNear) {
  EXPECT_EQ(suggestion("xyz", {"space", "body"}), "one of space, body");
  EXPECT_EQ(suggestion("xyz", {"box"}), "only box");
  EXPECT_EQ(suggestion("xyz", {}), "");
}

TEST(Suggestion, IsNeverNearForVeryLongWords) {
  EXPECT_EQ(nearest_name(std::string(65, 'a'), {std::string(65, 'a')}), std::nullopt);
  EXPECT_EQ(nearest_name(std::string(64, 'a'), {std::string(64, 'a')}), std::string(64, 'a'));
}

}  // namespace
}  // namespace polhode
