// SPDX-License-Identifier: MIT
#include "app/window/speaker/two_places.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

constexpr Size kLeast{640, 480};

bool overlap(const DesktopBox& a, const DesktopBox& b) {
  return a.x < b.x + b.size.width && b.x < a.x + a.size.width && a.y < b.y + b.size.height &&
         b.y < a.y + a.size.height;
}

bool holds(const DesktopBox& screen, const DesktopBox& box) {
  return box.x >= screen.x && box.y >= screen.y && box.x + box.size.width <= screen.x + screen.size.width &&
         box.y + box.size.height <= screen.y + screen.size.height;
}

TEST(TwoPlaces, TheFirstStaysWhereThereIsRoomBesideIt) {
  const DesktopBox wide{0, 30, {2600, 1000}};
  EXPECT_EQ(two_places(wide, {0, 40, {1280, 800}}, kLeast).second, (DesktopBox{1280, 40, {1280, 800}}));
  EXPECT_EQ(two_places(wide, {1300, 40, {1280, 800}}, kLeast).second, (DesktopBox{20, 40, {1280, 800}}));
  const DesktopBox high{0, 0, {1300, 1700}};
  EXPECT_EQ(two_places(high, {10, 0, {1280, 800}}, kLeast).second, (DesktopBox{10, 800, {1280, 800}}));
  EXPECT_EQ(two_places(high, {10, 850, {1280, 800}}, kLeast).second, (DesktopBox{10, 50, {1280, 800}}));
  for (const DesktopBox& first : {DesktopBox{0, 40, {1280, 800}}, DesktopBox{1300, 40, {1280, 800}}})
    EXPECT_EQ(two_places(wide, first, kLeast).first, first);
}

TEST(TwoPlaces, OnTheScreensThatThereAreNeitherHidesTheOther) {
  for (const Size& size :
       {Size{1280, 800}, Size{1366, 768}, Size{1920, 1080}, Size{2560, 1440}, Size{1080, 1920}})
    for (const DesktopBox& first : {DesktopBox{0, 0, {1280, 800}}, DesktopBox{120, 90, {900, 600}},
                                    DesktopBox{0, 0, size}, DesktopBox{-40, -40, {4000, 3000}}}) {
      const DesktopBox screen{0, 30, {size.width, size.height - 30}};
      const TwoPlaces places = two_places(screen, first, kLeast);
      EXPECT_FALSE(overlap(places.first, places.second)) << size.width << ' ' << first.size.width;
      EXPECT_TRUE(holds(screen, places.second)) << size.width << ' ' << first.size.width;
      EXPECT_GE(places.second.size.width, kLeast.width);
      EXPECT_GE(places.second.size.height, kLeast.height);
    }
}

TEST(TwoPlaces, OnASmallScreenSomeOfEachIsSeen) {
  const DesktopBox screen{0, 0, {1024, 700}};
  const TwoPlaces places = two_places(screen, {0, 0, {1024, 700}}, kLeast);
  EXPECT_TRUE(holds(screen, places.first));
  EXPECT_TRUE(holds(screen, places.second));
  EXPECT_GE(places.second.x - places.first.x, 100);
  EXPECT_GE(places.second.y - places.first.y, 100);
}

TEST(TwoPlaces, TheSecondIsAsHighAsTheScreenBesideOneThatGivesWay) {
  const TwoPlaces places = two_places({0, 0, {1920, 1080}}, {0, 0, {1280, 800}}, kLeast);
  EXPECT_EQ(places.second, (DesktopBox{960, 0, {960, 1080}}));
}

}  // namespace
}  // namespace polhode
