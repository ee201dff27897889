// SPDX-License-Identifier: MIT
#include "app/cli/numbers.h"

#include "app/cli/exit_codes.h"
#include "base/numbers.h"

#include <gtest/gtest.h>

#include <clocale>
#include <functional>

namespace polhode {
namespace {

/// The exit code a reading ends in; done if it reads.
ExitCode code_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const CommandError& error) {
    EXPECT_NE(std::string(error.what()).find("--x"), std::string::npos)
        << "the option is not named: " << error.what();
    return error.code;
  }
  return ExitCode::done;
}

TEST(FiniteNumber, IsDecimalOrHexadecimal) {
  EXPECT_EQ(finite_number("--x", "0.1"), 0.1);
  EXPECT_EQ(finite_number("--x", "-2.5e-3"), -2.5e-3);
  EXPECT_EQ(finite_number("--x", "0x1.8p+1"), 3.0);
  EXPECT_EQ(finite_number("--x", "-0x1p-2"), -0.25);
}

TEST(FiniteNumber, MalformedIsUsageAndInfiniteIsInvalid) {
  for (const char* text : {"", " 1", "1 ", "1,5", "one", "1e", "0x", "--1", "1.2.3"})
    EXPECT_EQ(code_of([&] { finite_number("--x", text); }), ExitCode::usage) << text;
  for (const char* text : {"nan", "NaN", "inf", "-inf", "infinity"})
    EXPECT_EQ(code_of([&] { finite_number("--x", text); }), ExitCode::invalid) << text;
}

TEST(FiniteNumber, DoesNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) std::setlocale(LC_ALL, name);
  EXPECT_EQ(finite_number("--x", "0.5"), 0.5);
  EXPECT_EQ(digits17(0.5), "0.5");
  std::setlocale(LC_ALL, before.c_str());
}

TEST(FiniteVector, HasThreeNumbers) {
  EXPECT_EQ(finite_vector("--x", "1,-2,0x1p1"), Vec3(1, -2, 2));
  for (const char* text : {"1,2", "1,2,3,4", "1,,3", "1,2,", ",1,2", ""})
    EXPECT_EQ(code_of([&] { finite_vector("--x", text); }), ExitCode::usage) << text;
  EXPECT_EQ(code_of([&] { finite_vector("--x", "1,nan,3"); }), ExitCode::invalid);
}

TEST(PictureSize, IsWithinItsLimits) {
  EXPECT_EQ(picture_size("--x", "1920x1080", 16384), (Size{1920, 1080}));
  EXPECT_EQ(picture_size("--x", "1x16384", 16384), (Size{1, 16384}));
  for (const char* text : {"0x0", "0x100", "100x0", "16385x1", "1x16385", "-1x5", "100", "100x", "x100",
                           "1x2x3", "axb", "1.5x2", "99999999999999999999x1", "100X100", ""})
    EXPECT_EQ(code_of([&] { picture_size("--x", text, 16384); }), ExitCode::usage) << text;
}

TEST(WholeNumber, IsWithinItsLimits) {
  EXPECT_EQ(whole_number("--x", "2", 2, 5), 2);
  EXPECT_EQ(whole_number("--x", "5", 2, 5), 5);
  for (const char* text : {"1", "6", "2.0", "", "x", "1e3"})
    EXPECT_EQ(code_of([&] { whole_number("--x", text, 2, 5); }), ExitCode::usage) << text;
}

}  // namespace
}  // namespace polhode
