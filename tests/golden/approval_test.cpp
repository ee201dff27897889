// SPDX-License-Identifier: MIT
// Whose goldens these are, and which of them are remade.
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
