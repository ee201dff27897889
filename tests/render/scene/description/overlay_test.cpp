// SPDX-License-Identifier: MIT
#include "render/scene/description/overlay.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(Overlay, NamesAndValuesMapBothWays) {
  ASSERT_EQ(overlay_names().size(), static_cast<std::size_t>(kOverlayCount));
  for (int i = 0; i < kOverlayCount; ++i) {
    const auto overlay = static_cast<Overlay>(i);
    EXPECT_EQ(overlay_from(name_of(overlay)), overlay);
    EXPECT_EQ(overlay_names()[static_cast<std::size_t>(i)], name_of(overlay));
  }
}

TEST(Overlay, UnknownNamesAreNone) {
  for (const char* name : {"", "Omega", "ellipsoid", "energy_ellipsoid", "omega "})
    EXPECT_FALSE(overlay_from(name));
}

TEST(Overlay, DiagramsShareAFigureWithWhatIsInSpace) {
  using O = Overlay;
  EXPECT_TRUE(shows_space({}, false));
  EXPECT_TRUE(shows_space({O::labels}, false));
  EXPECT_FALSE(shows_space({O::cards}, false));
  EXPECT_FALSE(shows_space({O::cards, O::labels, O::values}, false));
  EXPECT_TRUE(shows_space({O::cards, O::omega}, false));
  EXPECT_TRUE(shows_space({O::cards}, true)) << "marks are in space";
  EXPECT_EQ(diagrams_in({O::omega, O::cards, O::cofactors}), (std::vector{O::cofactors, O::cards}));
}

TEST(OverlaySet, HoldsWhatWasInsertedAndNotWhatWasErased) {
  OverlaySet set{Overlay::omega, Overlay::L};
  set.erase(Overlay::L);
  EXPECT_TRUE(set.contains(Overlay::omega));
  EXPECT_FALSE(set.contains(Overlay::L));
  EXPECT_FALSE(set.empty());
  EXPECT_EQ(set, OverlaySet{Overlay::omega});
}

}  // namespace
}  // namespace polhode
