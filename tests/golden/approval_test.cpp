// SPDX-License-Identifier: MIT
// What the goldens are compared by, on the Mesa that made them and on another.
#include "tests/golden/approval.h"

#include <gtest/gtest.h>

namespace polhode::golden {
namespace {

TEST(Approval, AMesaIsKnownByItsVersion) {
  EXPECT_EQ(mesa_of("llvmpipe (LLVM 15.0.6, 128 bits); 4.5 (Core Profile) Mesa 22.3.6"), "Mesa 22.3.6");
  EXPECT_EQ(mesa_of("llvmpipe (LLVM 19.1.7, 256 bits); 4.5 (Core Profile) Mesa 25.0.7-2+deb13u1"),
            "Mesa 25.0.7-2+deb13u1");
  EXPECT_EQ(mesa_of("another maker's"), "another maker's");
}

Comparison off_by(std::int64_t over_3, int max) {
  return {.same_size = true, .pixels = 10000, .over_3 = over_3, .max = max};
}

TEST(Approval, OnTheMesaOfTheGoldensTheGoldenRuleHolds) {
  for (const auto& [over_3, max] : {std::pair{0, 0}, {2, 48}, {3, 48}, {2, 49}, {2, 96}, {9999, 255}}) {
    const Comparison comparison = off_by(over_3, max);
    EXPECT_EQ(is_as_approved(comparison, false), comparison.equal()) << over_3 << ' ' << max;
  }
  EXPECT_FALSE(is_as_approved(Comparison{}, false));
}

TEST(Approval, AnotherMesaMayBeOffByMoreInAsFewPixels) {
  EXPECT_TRUE(is_as_approved(off_by(2, kOtherMesaMax), true));
  EXPECT_FALSE(is_as_approved(off_by(2, kOtherMesaMax + 1), true));
  EXPECT_FALSE(is_as_approved(off_by(3, 4), true));
  EXPECT_FALSE(is_as_approved(Comparison{}, true)) << "another size";
}

TEST(Approval, ThoseThatAreNamedAreRemade) {
  EXPECT_EQ(remake_of("sphere", "", false), Remake::no);
  EXPECT_EQ(remake_of("sphere", "poinsot sphere", false), Remake::yes);
  EXPECT_EQ(remake_of("sphere", "poinsot spheres", false), Remake::no);
  EXPECT_EQ(remake_of("sphere", "all", false), Remake::yes);
}

TEST(Approval, AnotherMesaRemakesAllOrNone) {
  EXPECT_EQ(remake_of("sphere", "poinsot sphere", true), Remake::refused);
  EXPECT_EQ(remake_of("sphere", "poinsot", true), Remake::no);
  EXPECT_EQ(remake_of("sphere", "all", true), Remake::yes);
  EXPECT_EQ(remake_of("sphere", "sphere all", true), Remake::yes);
}

}  // namespace
}  // namespace polhode::golden
