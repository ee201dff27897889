// SPDX-License-Identifier: MIT
#include "lessons/diagnostics/diagnostic.h"

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

TEST(Diagnostic, IsOnePrintableLine) {
  EXPECT_EQ(to_string({Severity::error, "a\x1b.md", {1, 1}, "bad\nname \xe2\x80\xae", "\xc2\x9b"}),
            "a\\u001b.md:1:1: error: bad\\u000aname \\u202e (\\u009b)");
}

}  // namespace
}  // namespace polhode
