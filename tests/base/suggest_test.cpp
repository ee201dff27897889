// SPDX-License-Identifier: MIT
#include "base/suggest.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

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
