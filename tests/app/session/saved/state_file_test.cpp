// SPDX-License-Identifier: MIT
#include "app/session/saved/state_file.h"

#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace polhode {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

TEST(StateLock, IsHeldByOneAtATime) {
  const ScratchFolder scratch;
  const auto file = scratch / "polhode" / "quiz.answers.json";
  std::optional first(StateLock::take(file, 0ms));
  ASSERT_TRUE(*first);
  const auto second = StateLock::take(file, 20ms);
  ASSERT_FALSE(second) << "two hold it";
  EXPECT_TRUE(second.error().is_held);
  EXPECT_THAT(second.error().text,
              HasSubstr("cannot lock " + file.string() + ".lock: another polhode has held it for 0.02 s"));
  first.reset();
  EXPECT_TRUE(StateLock::take(file, 0ms));
}

// Of Lustre without -o flock, of some FUSE and 9P file systems, of NFS without its lock daemon.
TEST(StateLock, WhereThereAreNoLocksNobodyIsLockedOut) {
  const ScratchFolder scratch;
  EXPECT_TRUE(StateLock::take(scratch / "a", 0ms, [](int, int) { return errno = ENOSYS, -1; }));
  EXPECT_TRUE(StateLock::take(scratch / "a", 0ms, [](int, int) { return errno = ENOLCK, -1; }));
  EXPECT_TRUE(StateLock::take(scratch / "a", 0ms, [](int, int) { return errno = EOPNOTSUPP, -1; }));
}

TEST(StateLock, AnyOtherFailureIsSaid) {
  const ScratchFolder scratch;
  const auto lock = StateLock::take(scratch / "a", 1h, [](int, int) { return errno = EIO, -1; });
  ASSERT_FALSE(lock);
  EXPECT_FALSE(lock.error().is_held);
  EXPECT_THAT(lock.error().text, HasSubstr("a.lock: Input/output error"));
}

// HOSTILE F12: those of killed processes were never removed.
TEST(WriteStateFile, RemovesWhatAKilledProcessLeft) {
  const ScratchFolder scratch;
  const std::filesystem::path left = scratch / ".polhode-00000000-1-0.part";
  write_text(left, "{");
  std::filesystem::last_write_time(left, std::filesystem::file_time_type::clock::now() - 61min);
  ASSERT_TRUE(write_state_file(scratch / "a.json", {{"a", 1}}));
  EXPECT_THAT(names_in(scratch.path()), testing::ElementsAre("a.json"));
}

// HOSTILE F13: the second damaged file took the place of the first.
TEST(ReadStateFile, SetsEveryDamagedFileAside) {
  const ScratchFolder scratch;
  for (const char* text : {"one", "two", "three"}) {
    write_text(scratch / "a.json", text);
    EXPECT_TRUE(read_state_file(scratch / "a.json", "the log", [](const nlohmann::ordered_json&) {}));
  }
  EXPECT_EQ(text_of(scratch / "a.json.damaged"), "one");
  EXPECT_EQ(text_of(scratch / "a.json.damaged-2"), "two");
  EXPECT_EQ(text_of(scratch / "a.json.damaged-3"), "three");
}

std::string why_unreadable(const std::filesystem::path& file) {
  const auto read = read_state_file(file, "the log", [](const nlohmann::ordered_json&) {});
  return read ? "it was read" : read.error().text;
}

// A pipe is never waited for, and a link to an endless file not followed to its end.
TEST(ReadStateFile, TakesRegularFilesOfAPossibleSizeAlone) {
  const ScratchFolder scratch;
  ASSERT_EQ(mkfifo((scratch / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(why_unreadable(scratch / "pipe"),
              HasSubstr("cannot read " + (scratch / "pipe").string() + ": "));
  std::filesystem::create_symlink("/dev/zero", scratch / "endless");
  EXPECT_THAT(why_unreadable(scratch / "endless"), HasSubstr("cannot read"));
  std::filesystem::create_directory(scratch / "folder");
  EXPECT_THAT(why_unreadable(scratch / "folder"), HasSubstr("cannot read"));
  write_text(scratch / "large", "");
  std::filesystem::resize_file(scratch / "large", std::uintmax_t{1} << 30);  // all holes
  EXPECT_THAT(why_unreadable(scratch / "large"), HasSubstr("larger than it can be"));
}

}  // namespace
}  // namespace polhode
