// SPDX-License-Identifier: MIT
#include "base/near_name.h"

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

TEST(NearName, PrefersTheFirstLetterOfTheWord) {
  EXPECT_EQ(near_name("Omgea", {"omega", "Omega"}), "Omega");
  EXPECT_EQ(near_name("omgea", {"Omega", "omega"}), "omega");
  EXPECT_EQ(near_name("OMEGA", {"alpha", "omega"}), "omega");
}

TEST(NearName, NeverReplacesAllOfAName) {
  EXPECT_EQ(near_name("x", {"y"}), "");
  EXPECT_EQ(near_name("l", {"L"}), "L");
  EXPECT_EQ(near_name("x", {"xi"}), "xi");
}

TEST(NearName, IsNearJustIfFewLettersDiffer) {
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
    const bool near = differences <= std::max(1, longer / 3) && differences < static_cast<int>(b.size());
    EXPECT_EQ(near_name(a, {b}), near ? b : "") << a << ' ' << b;
  }
}

}  // namespace
}  // namespace polhode
