// SPDX-License-Identifier: MIT
#include "app/cli/trace/trace_times.h"

#include "app/cli/exit_codes.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TypedTimes every(const char* from, const char* to, const char* step) { return {"", from, to, step, "", ""}; }
TypedTimes samples(const char* periods, const char* n) { return {"", "", "", "", periods, n}; }
TypedTimes listed(const char* times) { return {times, "", "", "", "", ""}; }

ExitCode code_of(const TypedTimes& typed, double period_s = 1.0) {
  try {
    trace_times(typed, period_s);
  } catch (const CommandError& error) {
    return error.code;
  }
  return ExitCode::done;
}

TEST(TraceTimes, ListedKeepTheOrderAsked) {
  const TraceTimes times = trace_times(listed("3,-1,0x1p-1,3"), 0);
  ASSERT_EQ(times.count(), 4);
  EXPECT_EQ(times(0), 3);
  EXPECT_EQ(times(1), -1);
  EXPECT_EQ(times(2), 0.5);
  EXPECT_EQ(times(3), 3);
  EXPECT_EQ(times.furthest_s(), 3);
}

// 0.3/0.1 is 2.9999999999999996 in doubles: the end must be there all the same.
TEST(TraceTimes, EveryIncludesAnEndThatRoundingMisses) {
  const TraceTimes times = trace_times(every("0", "0.3", "0.1"), 0);
  ASSERT_EQ(times.count(), 4);
  EXPECT_EQ(times(3), 3 * 0.1);
  EXPECT_EQ(trace_times(every("0", "1", "0.1"), 0).count(), 11);
  EXPECT_EQ(trace_times(every("0", "0.95", "0.1"), 0).count(), 10);
  EXPECT_EQ(trace_times(every("2", "2", "0.1"), 0).count(), 1);
}

TEST(TraceTimes, EveryMayGoBack) {
  const TraceTimes times = trace_times(every("1", "-1", "-0.5"), 0);
  ASSERT_EQ(times.count(), 5);
  EXPECT_EQ(times(4), -1);
  EXPECT_EQ(code_of(every("1", "-1", "0.5")), ExitCode::usage);
}

TEST(TraceTimes, SamplesIncludeBothEnds) {
  const TraceTimes times = trace_times(samples("2", "5"), 3.0);
  ASSERT_EQ(times.count(), 5);
  EXPECT_EQ(times(0), 0);
  EXPECT_EQ(times(2), 3);
  EXPECT_EQ(times(4), 6);
}

TEST(TraceTimes, SamplesMayBeBetweenTwoTimes) {
  const TraceTimes times = trace_times({"", "1", "-2", "", "", "4"}, 0);
  ASSERT_EQ(times.count(), 4);
  EXPECT_EQ(times(0), 1);
  EXPECT_EQ(times(1), 0);
  EXPECT_EQ(times(3), -2);
  EXPECT_EQ(times.furthest_s(), 2);
  EXPECT_EQ(code_of({"", "0", "3", "1", "", "4"}), ExitCode::usage) << "--every and --samples";
  EXPECT_EQ(code_of({"", "", "", "1", "2", "4"}), ExitCode::usage) << "--every of periods";
  EXPECT_EQ(code_of({"", "0", "3", "", "", ""}), ExitCode::usage);
  EXPECT_EQ(code_of({"", "0", "", "", "", "4"}), ExitCode::usage);
  EXPECT_EQ(code_of({"", "-1.7e308", "1.7e308", "", "", "4"}), ExitCode::usage);
}

TEST(TraceTimes, RefusesWhatMakesNoRow) {
  EXPECT_EQ(code_of({}), ExitCode::usage);
  EXPECT_EQ(code_of(every("0", "1", "0")), ExitCode::usage);
  EXPECT_EQ(code_of(every("0", "1", "")), ExitCode::usage);
  EXPECT_EQ(code_of(every("0", "1e300", "1e-300")), ExitCode::usage);
  EXPECT_EQ(code_of(every("0", "nan", "1")), ExitCode::invalid);
  EXPECT_EQ(code_of(samples("1", "1")), ExitCode::usage);
  EXPECT_EQ(code_of(samples("1", "2"), 0.0), ExitCode::usage);
  EXPECT_EQ(code_of({"1", "0", "1", "1", "", ""}), ExitCode::usage);
  EXPECT_EQ(code_of({"1", "", "", "", "1", "2"}), ExitCode::usage);
}

}  // namespace
}  // namespace polhode
