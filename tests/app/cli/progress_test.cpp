// SPDX-License-Identifier: MIT
#include "app/cli/progress.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(ProgressLine, FillsWithTheWork) {
  EXPECT_EQ(progress_line(0, 2, "a", 80, false), "[                              ] 0/2 a");
  EXPECT_EQ(progress_line(1, 2, "b", 80, false), "[###############               ] 1/2 b");
  EXPECT_EQ(progress_line(2, 2, "c", 80, false), "[##############################] 2/2 c");
}

TEST(ProgressLine, StaysWithinTheTerminal) {
  EXPECT_LT(progress_line(1, 2, std::string(500, 'x'), 60, false).size(), 60u);
}

TEST(ProgressLine, HasEscapesOnlyWhenColored) {
  EXPECT_EQ(progress_line(1, 2, "a", 80, false).find('\x1b'), std::string::npos);
  EXPECT_NE(progress_line(1, 2, "a", 80, true).find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace polhode
