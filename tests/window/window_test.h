// SPDX-License-Identifier: MIT
// What tests of the window begin with.
#pragma once

#include "render/image/png.h"
#include "tests/support/paths.h"
#include "tests/window/played_lesson.h"

#include <gtest/gtest.h>

#include <memory>

namespace polhode::window_test {

/// A small lesson: a figure of two steps (the closed form, rk4), a question, an end.
inline const std::string kPlayed = test::source_dir() / "tests/data/window/played.md";
inline const std::string kSteered = test::source_dir() / "tests/data/window/steered.md";

/// A display and a home for each test; skipped where there can be none. What was seen last when a test failed
/// is in out/check/window-NAME.png.
class WindowTest : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string why = Display::why_not(); !why.empty()) GTEST_SKIP() << why;
    display_ = std::make_unique<Display>();
  }
  void TearDown() override {
    if (!display_ || !HasFailure()) return;
    const std::filesystem::path folder = test::source_dir() / "out/check";
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::filesystem::create_directories(folder);
    static_cast<void>(
        write_png(folder / (std::string("window-") + test->name() + ".png"), display_->last_picture(), {}));
  }
  const Display& display() const { return *display_; }
  const Home& home() const { return home_; }

 private:
  Home home_;
  std::unique_ptr<Display> display_;
};

}  // namespace polhode::window_test
