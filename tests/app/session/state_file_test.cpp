// SPDX-License-Identifier: MIT
#include "app/session/state_file.h"

#include "app/cli/exit_codes.h"
#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <chrono>
#include <optional>

namespace polhode {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

TEST(StateLock, IsHeldByOneAtATime) {
  const ScratchFolder scratch;
  const auto file = scratch / "polhode" / "quiz.answers.json";
  std::optional<StateLock> first(std::in_place, file, 0ms);
  try {
    const StateLock second(file, 20ms);
    FAIL() << "two hold it";
  } catch (const StateIsHeld& error) {
    EXPECT_EQ(error.code, ExitCode::failed);
    EXPECT_THAT(error.what(), HasSubstr("cannot lock " + file.string() +
                                        ".lock: another polhode has held it "
                                        "for 0.02 s"));
  }
  first.reset();
  EXPECT_NO_THROW(StateLock(file, 0ms));
}

// Of Lustre without -o flock, of some FUSE and 9P file systems, of NFS without its lock daemon.
TEST(StateLock, WhereThereAreNoLocksNobodyIsLockedOut) {
  const ScratchFolder scratch;
  EXPECT_NO_THROW(StateLock(scratch / "a", 0ms, [](int, int) { return errno = ENOSYS, -1; }));
  EXPECT_NO_THROW(StateLock(scratch / "a", 0ms, [](int, int) { return errno = ENOLCK, -1; }));
  EXPECT_NO_THROW(StateLock(scratch / "a", 0ms, [](int, int) { return errno = EOPNOTSUPP, -1; }));
}

TEST(StateLock, AnyOtherFailureIsSaid) {
  const ScratchFolder scratch;
  try {
    const StateLock lock(scratch / "a", 1h, [](int, int) { return errno = EIO, -1; });
    FAIL();
  } catch (const CommandError& error) {
    EXPECT_EQ(dynamic_cast<const StateIsHeld*>(&error), nullptr);
    EXPECT_THAT(error.what(), HasSubstr("a.lock: Input/output error"));
  }
}

}  // namespace
}  // namespace polhode
