// SPDX-License-Identifier: MIT
#include "lessons/diagnostic.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(Diagnostic, ReadsAsFileLineColumnSeverityMessageHint) {
  EXPECT_EQ(to_string({Severity::error, "a.md", {3, 7}, "unknown key", "did you mean \"at\"?"}),
            "a.md:3:7: error: unknown key (did you mean \"at\"?)");
}

TEST(Diagnostic, LeavesOutTheBracketsWithoutAHint) {
  EXPECT_EQ(to_string({Severity::warning, "a.md", {1, 1}, "odd", ""}), "a.md:1:1: warning: odd");
}

}  // namespace
}  // namespace polhode
