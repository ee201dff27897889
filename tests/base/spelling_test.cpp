// SPDX-License-Identifier: MIT
#include "base/spelling.h"

#include <gtest/gtest.h>

#include <algorithm>
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

TEST(ClosestName, PrefersTheFirstLetterOfTheWord) {
  EXPECT_EQ(closest_name("Omgea", {"omega", "Omega"}), "Omega");
  EXPECT_EQ(closest_name("omgea", {"Omega", "omega"}), "omega");
  EXPECT_EQ(closest_name("OMEGA", {"alpha", "omega"}), "omega");
}

TEST(ClosestName, NeverReplacesAllOfAName) {
  EXPECT_EQ(closest_name("x", {"y"}), "");
  EXPECT_EQ(closest_name("l", {"L"}), "L");
  EXPECT_EQ(closest_name("x", {"xi"}), "xi");
}

TEST(ClosestName, IsCloseJustIfFewLettersDiffer) {
  std::mt19937 random(1);
  const auto word = [&random] {
    std::string text(1 + random() % 12, 'a');
    for (char& c : text) c = static_cast<char>('a' + random() % 4);
    return text;
  };
  for (int i = 0; i < 5000; ++i) {
    const std::string a = word(), b = word();
    const auto longer = static_cast<int>(std::max(a.size(), b.size()));
    const bool abbreviated = a.size() >= 3 && b.starts_with(a);
    const int differences = abbreviated ? 1 : edit_distance(a, b);
    const bool close = differences <= std::max(1, longer / 3) && differences < static_cast<int>(b.size());
    EXPECT_EQ(closest_name(a, {b}), close ? b : "") << a << ' ' << b;
  }
}

TEST(Suggestion, NamesTheClosest) {
  const std::vector<std::string> known = {"polhode", "herpolhode", "plane"};
  EXPECT_EQ(suggestion("plhode", known), "did you mean \"polhode\"?");
  EXPECT_EQ(suggestion("herpolhod", known), "did you mean \"herpolhode\"?");
  EXPECT_EQ(suggestion("PLANE", known), "did you mean \"plane\"?");
}

TEST(Suggestion, TakesTheBeginningOfANameForIt) {
  EXPECT_EQ(suggestion("azimuth", {"elevation_deg", "azimuth_deg"}), "did you mean \"azimuth_deg\"?");
  EXPECT_EQ(closest_name("az", {"azimuth_deg"}), "");
}

TEST(Suggestion, ListsWhatThereIsIfNothingIsClose) {
  EXPECT_EQ(suggestion("xyz", {"space", "body"}), "one of space, body");
  EXPECT_EQ(suggestion("xyz", {"box"}), "only box");
  EXPECT_EQ(suggestion("xyz", {}), "");
}

TEST(Suggestion, IsNeverForVeryLongWords) {
  EXPECT_EQ(closest_name(std::string(65, 'a'), {std::string(65, 'a')}), "");
  EXPECT_EQ(closest_name(std::string(64, 'a'), {std::string(64, 'a')}), std::string(64, 'a'));
}

TEST(DidYouMean, EndsASentenceOrSaysNothing) {
  EXPECT_EQ(did_you_mean("plhode", {"polhode", "plane"}), "; did you mean \"polhode\"?");
  EXPECT_EQ(did_you_mean("xyz", {"polhode", "plane"}), "");
}

}  // namespace
}  // namespace polhode
