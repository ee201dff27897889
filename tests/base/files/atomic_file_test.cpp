// SPDX-License-Identifier: MIT
#include "base/files/atomic_file.h"

#include "tests/base/files/folder.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <numeric>
#include <string>
#include <thread>

namespace polhode {
namespace {

using test::bytes_of;
using test::Folder;
using test::put;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Bytes = std::vector<std::uint8_t>;

Bytes numbered(std::size_t count) {
  Bytes bytes(count);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{1});
  return bytes;
}

const Bytes kOld = {9, 9, 9};
const Bytes kNew = numbered(1000);

// The real file system, except that operation number `fail_at` (from 0) fails with `error`; error 0 makes a
// write short instead.
class FailingFiles final : public FileOps {
 public:
  FailingFiles(int fail_at, int error) : fail_at_(fail_at), error_(error) {}

  int open(const char* path, int flags, mode_t mode) override {
    return fails() ? -1 : real_.open(path, flags, mode);
  }
  ssize_t write(int file, const void* bytes, std::size_t count) override {
    if (fails()) return -1;
    return real_.write(file, bytes, short_now_ ? (count + 1) / 2 : count);
  }
  int fsync(int file) override { return fails() ? -1 : real_.fsync(file); }
  int syncfs(int file) override { return fails() ? -1 : real_.syncfs(file); }
  // As on Linux: the file is closed even when close reports an error.
  int close(int file) override {
    real_.close(file);
    return fails() ? -1 : 0;
  }
  int rename(const char* from, const char* to) override { return fails() ? -1 : real_.rename(from, to); }
  int unlink(const char* path) override { return fails() ? -1 : real_.unlink(path); }

  int operations() const { return count_; }
  bool reached() const { return count_ > fail_at_; }

 private:
  bool fails() {
    short_now_ = false;
    if (count_++ != fail_at_) return false;
    short_now_ = error_ == 0;
    errno = error_;
    return error_ != 0;
  }

  PosixFileOps real_;
  int fail_at_;
  int error_;
  int count_ = 0;
  bool short_now_ = false;
};

constexpr int kNever = -1;

TEST(AtomicFile, WritesANewFile) {
  const Folder folder;
  ASSERT_TRUE(write_file_atomically(folder / "a.png", kNew).ok());
  EXPECT_EQ(bytes_of(folder / "a.png"), kNew);
  EXPECT_THAT(folder.names(), ElementsAre("a.png"));
}

TEST(AtomicFile, WritesNothingAtAllToo) {
  const Folder folder;
  ASSERT_TRUE(write_file_atomically(folder / "a.png", {}).ok());
  EXPECT_THAT(folder.names(), ElementsAre("a.png"));
  EXPECT_THAT(bytes_of(folder / "a.png"), IsEmpty());
}

TEST(AtomicFile, WritesPieceByPiece) {
  const Folder folder;
  const std::span<const std::uint8_t> all(kNew);
  const Status status = write_file_in_pieces(folder / "a", [&](const AppendBytes& append) {
    EXPECT_TRUE(append(all.first(1)));
    EXPECT_TRUE(append({}));
    return append(all.subspan(1));
  });
  EXPECT_TRUE(status) << status.error();
  EXPECT_EQ(bytes_of(folder / "a"), kNew);
}

TEST(AtomicFile, AFillThatGivesUpLeavesTheOldFile) {
  const Folder folder;
  put(folder / "a", kOld);
  const Status status = write_file_in_pieces(folder / "a", [&](const AppendBytes& append) -> Status {
    EXPECT_TRUE(append(kNew));
    return failure("picture 7 is damaged.");
  });
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error(), testing::EndsWith("a: picture 7 is damaged."));
  EXPECT_EQ(bytes_of(folder / "a"), kOld);
  EXPECT_THAT(folder.names(), ElementsAre("a"));
}

TEST(AtomicFileInjection, AFullDiskIsReportedEvenIfTheFillGoesOn) {
  const Folder folder;
  FailingFiles files(2, ENOSPC);  // open, write, write
  const Status status = write_file_in_pieces(
      files, folder / "a",
      [&](const AppendBytes& append) {
        for (int i = 0; i < 5; ++i) static_cast<void>(append(kNew));
        return success();
      },
      Durability::rename_only);
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error(), HasSubstr("No space left on device"));
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(AtomicFile, ReplacesAnOldFile) {
  const Folder folder;
  put(folder / "a.png", kOld);
  for (const Durability durability : {Durability::rename_only, Durability::sync}) {
    ASSERT_TRUE(write_file_atomically(folder / "a.png", kNew, durability).ok());
    EXPECT_EQ(bytes_of(folder / "a.png"), kNew);
    EXPECT_THAT(folder.names(), ElementsAre("a.png"));
  }
}

TEST(AtomicFile, ObeysTheUmask) {
  const Folder folder;
  const mode_t old = umask(027);
  ASSERT_TRUE(write_file_atomically(folder / "a.png", kNew).ok());
  umask(old);
  struct stat found {};
  ASSERT_EQ(stat((folder / "a.png").c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 0777u, 0640u);
}

TEST(AtomicFile, ARelativeNameGoesToTheWorkingFolder) {
  const Folder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const Status written = write_file_atomically("a.png", kNew, Durability::sync);
  std::filesystem::current_path(before);
  EXPECT_TRUE(written.ok());
  EXPECT_EQ(bytes_of(folder / "a.png"), kNew);
}

TEST(AtomicFile, SyncFlushesTheFileBeforeTheRenameAndTheFolderAfter) {
  class Recorder final : public FileOps {
   public:
    int open(const char*, int, mode_t) override { return log("open"); }
    ssize_t write(int, const void*, std::size_t count) override {
      return log("write"), static_cast<ssize_t>(count);
    }
    int fsync(int) override { return log("fsync"); }
    int syncfs(int) override { return log("syncfs"); }
    int close(int) override { return log("close"); }
    int rename(const char*, const char*) override { return log("rename"); }
    int unlink(const char*) override { return log("unlink"); }
    std::vector<std::string> calls;

   private:
    int log(const char* call) { return calls.emplace_back(call), 0; }
  };
  const Folder folder;
  Recorder fast;
  ASSERT_TRUE(write_file_atomically(fast, folder / "a.png", kNew, Durability::rename_only).ok());
  EXPECT_THAT(fast.calls, ElementsAre("open", "write", "close", "rename"));
  Recorder careful;
  ASSERT_TRUE(write_file_atomically(careful, folder / "a.png", kNew, Durability::sync).ok());
  EXPECT_THAT(careful.calls,
              ElementsAre("open", "write", "fsync", "close", "rename", "open", "fsync", "close"));
  Recorder whole;
  ASSERT_TRUE(sync_folder(whole, folder.path()).ok());
  EXPECT_THAT(whole.calls, ElementsAre("open", "syncfs", "close"));
}

// SQLite's idea at our size: let operation n fail, for every n.
void expect_clean_failures(Durability durability, int error, bool old_exists) {
  for (int n = 0;; ++n) {
    const Folder folder;
    if (old_exists) put(folder / "a.png", kOld);
    FailingFiles files(n, error);
    const Status written = write_file_atomically(files, folder / "a.png", kNew, durability);
    if (!files.reached()) {
      EXPECT_TRUE(written.ok());
      EXPECT_GE(n, 4) << "open, write, close, rename";
      return;
    }
    SCOPED_TRACE("operation " + std::to_string(n) + " fails with errno " + std::to_string(error));
    ASSERT_FALSE(written.ok());
    EXPECT_THAT(written.error(), HasSubstr((folder / "a.png").string()));
    EXPECT_THAT(written.error(), HasSubstr(std::generic_category().message(error)));
    const bool after_rename = n > 4;  // only the folder's flush, with Durability::sync
    const Bytes expected = after_rename ? kNew : old_exists ? kOld : Bytes{};
    EXPECT_EQ(bytes_of(folder / "a.png"), expected);
    EXPECT_EQ(folder.names().size(), expected.empty() ? 0u : 1u) << "no stray file";
  }
}

TEST(AtomicFileInjection, EveryFailingOperationLeavesTheFolderAsItWas) {
  for (const Durability durability : {Durability::rename_only, Durability::sync})
    for (const int error : {ENOSPC, EIO})
      for (const bool old_exists : {false, true}) expect_clean_failures(durability, error, old_exists);
}

// `error` 0: short writes.
void expect_survival(int error) {
  for (int n = 0;; ++n) {
    const Folder folder;
    FailingFiles files(n, error);
    const Status written = write_file_atomically(files, folder / "a.png", kNew, Durability::sync);
    SCOPED_TRACE("operation " + std::to_string(n));
    ASSERT_TRUE(written.ok()) << written.error();
    EXPECT_EQ(bytes_of(folder / "a.png"), kNew);
    EXPECT_THAT(folder.names(), ElementsAre("a.png"));
    if (!files.reached()) return;
  }
}

TEST(AtomicFileInjection, SurvivesASignalInAnyOperation) { expect_survival(EINTR); }

TEST(AtomicFileInjection, SurvivesShortWrites) { expect_survival(0); }

TEST(AtomicFileInjection, SurvivesADiskThatTakesOneByteAtATime) {
  class Slow final : public FileOps {
   public:
    int open(const char* path, int flags, mode_t mode) override { return real_.open(path, flags, mode); }
    ssize_t write(int file, const void* bytes, std::size_t) override { return real_.write(file, bytes, 1); }
    int fsync(int file) override { return real_.fsync(file); }
    int syncfs(int file) override { return real_.syncfs(file); }
    int close(int file) override { return real_.close(file); }
    int rename(const char* from, const char* to) override { return real_.rename(from, to); }
    int unlink(const char* path) override { return real_.unlink(path); }

   private:
    PosixFileOps real_;
  };
  const Folder folder;
  Slow files;
  ASSERT_TRUE(write_file_atomically(files, folder / "a.png", kNew, Durability::rename_only).ok());
  EXPECT_EQ(bytes_of(folder / "a.png"), kNew);
}

TEST(AtomicFileInjection, ADiskThatTakesNothingIsAnErrorNotALoop) {
  class Deaf final : public FileOps {
   public:
    int open(const char* path, int flags, mode_t mode) override { return real_.open(path, flags, mode); }
    ssize_t write(int, const void*, std::size_t) override { return 0; }
    int fsync(int file) override { return real_.fsync(file); }
    int syncfs(int file) override { return real_.syncfs(file); }
    int close(int file) override { return real_.close(file); }
    int rename(const char* from, const char* to) override { return real_.rename(from, to); }
    int unlink(const char* path) override { return real_.unlink(path); }

   private:
    PosixFileOps real_;
  };
  const Folder folder;
  Deaf files;
  EXPECT_FALSE(write_file_atomically(files, folder / "a.png", kNew, Durability::rename_only).ok());
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(AtomicFileInjection, SaysSoIfTheUnfinishedFileCannotBeRemoved) {
  class Stuck final : public FileOps {
   public:
    int open(const char*, int, mode_t) override { return 99; }
    ssize_t write(int, const void*, std::size_t) override { return errno = ENOSPC, -1; }
    int fsync(int) override { return 0; }
    int syncfs(int) override { return 0; }
    int close(int) override { return 0; }
    int rename(const char*, const char*) override { return 0; }
    int unlink(const char*) override { return errno = EIO, -1; }
  };
  Stuck files;
  const Status written = write_file_atomically(files, "/nowhere/a.png", kNew, Durability::rename_only);
  ASSERT_FALSE(written.ok());
  EXPECT_THAT(written.error(), HasSubstr("No space left on device"));
  EXPECT_THAT(written.error(), HasSubstr(kTemporaryPrefix));
  EXPECT_THAT(written.error(), HasSubstr("cannot be removed"));
}

TEST(AtomicFileInjection, SyncFolderReportsEveryFailure) {
  const Folder folder;
  for (int n = 0; n < 3; ++n) {
    FailingFiles files(n, EIO);
    const Status synced = sync_folder(files, folder.path());
    ASSERT_FALSE(synced.ok()) << n;
    EXPECT_THAT(synced.error(), HasSubstr(folder.path().string()));
  }
  FailingFiles files(kNever, EIO);
  EXPECT_TRUE(sync_folder(files, folder.path()).ok());
}

TEST(AtomicFile, WhatAKilledProcessLeftGoes) {
  const Folder folder;
  put(folder / test::name_of_the_dead(), kOld);
  ASSERT_TRUE(write_file_atomically(folder / "a.png", kNew).ok());
  EXPECT_THAT(folder.names(), ElementsAre("a.png"));
}

TEST(AtomicFile, WhatALivingProcessWritesIsNotTouched) {
  const Folder folder;
  const std::string taken = temporary_name(0);
  put(folder / taken, kOld);
  ASSERT_TRUE(write_file_atomically(folder / "a.png", kNew).ok());
  EXPECT_EQ(bytes_of(folder / taken), kOld);
  EXPECT_EQ(bytes_of(folder / "a.png"), kNew);
  EXPECT_EQ(folder.names().size(), 2u);
}

TEST(AtomicFile, AFullDeviceIsReported) {
  const Status written = write_file_atomically("/dev/full", kNew);
  ASSERT_FALSE(written.ok());
  EXPECT_THAT(written.error(), HasSubstr("/dev/full"));
  EXPECT_THAT(written.error(), HasSubstr("No space left on device"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full")) << "a device is not replaced";
}

TEST(AtomicFile, ADeviceIsWrittenInPlace) {
  EXPECT_TRUE(write_file_atomically("/dev/null", kNew).ok());
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(AtomicFile, APipeThatNobodyReadsIsReported) {
  const Folder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  alarm(60);  // it once waited for ever
  const Status written = write_file_atomically(folder / "pipe", kNew);
  alarm(0);
  ASSERT_FALSE(written.ok());
  EXPECT_THAT(written.error(), HasSubstr("pipe: nobody reads from this pipe"));
}

TEST(AtomicFile, APipeWaitsForItsReader) {
  const Folder folder;
  const Bytes many = numbered(1'000'000);  // more than a pipe holds
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  const int end = open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(end, 0);
  Bytes found;
  std::thread reader([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    Bytes some(4096);
    for (pollfd ready{end, POLLIN, 0}; poll(&ready, 1, 60'000) == 1;) {
      const ssize_t count = read(end, some.data(), some.size());
      if (count <= 0) break;
      found.insert(found.end(), some.begin(), some.begin() + count);
    }
  });
  const Status written = write_file_atomically(folder / "pipe", many);
  reader.join();
  close(end);
  EXPECT_TRUE(written.ok()) << written.error();
  EXPECT_EQ(found, many);
}

TEST(AtomicFile, ALinkStaysAndItsTargetIsReplaced) {
  const Folder folder;
  std::filesystem::create_directory(folder / "inner");
  put(folder / "inner/real.png", kOld);
  std::filesystem::create_symlink("inner/real.png", folder / "link.png");
  ASSERT_TRUE(write_file_atomically(folder / "link.png", kNew).ok());
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.png"));
  EXPECT_EQ(bytes_of(folder / "inner/real.png"), kNew);
}

TEST(AtomicFile, AFolderInTheWayIsReported) {
  const Folder folder;
  std::filesystem::create_directory(folder / "a.png");
  const Status written = write_file_atomically(folder / "a.png", kNew);
  ASSERT_FALSE(written.ok());
  EXPECT_THAT(written.error(), HasSubstr("Is a directory"));
  EXPECT_THAT(folder.names(), ElementsAre("a.png"));
  EXPECT_FALSE(write_file_atomically(folder.path() / "", kNew).ok());
}

TEST(AtomicFile, AMissingFolderIsReported) {
  const Folder folder;
  const Status written = write_file_atomically(folder / "none/a.png", kNew);
  ASSERT_FALSE(written.ok());
  EXPECT_THAT(written.error(), HasSubstr("No such file or directory"));
  EXPECT_FALSE(sync_folder(folder / "none").ok());
}

TEST(AtomicFile, TheLongestNameWorksALongerOneIsReported) {
  const Folder folder;
  EXPECT_TRUE(write_file_atomically(folder / std::string(255, 'n'), kNew).ok());
  const Status written = write_file_atomically(folder / std::string(256, 'n'), kNew);
  ASSERT_FALSE(written.ok());
  EXPECT_THAT(written.error(), HasSubstr("File name too long"));
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(AtomicFile, AReadOnlyFolderIsReported) {
  const Folder folder;
  std::filesystem::permissions(folder.path(),
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  // Root writes anywhere; /proc refuses new files even to root.
  const auto path = geteuid() == 0 ? std::filesystem::path("/proc/polhode.png") : folder / "a.png";
  const Status written = write_file_atomically(path, kNew);
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
  ASSERT_FALSE(written.ok());
  EXPECT_THAT(written.error(), HasSubstr(path.string()));
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(AtomicFile, ManyThreadsWriteTheSameFolder) {
  const Folder folder;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&folder, t] {
      for (int i = 0; i < 50; ++i)
        EXPECT_TRUE(write_file_atomically(folder / (std::to_string(t) + "-" + std::to_string(i)), kNew).ok());
    });
  for (std::thread& thread : threads) thread.join();
  const auto names = folder.names();
  EXPECT_EQ(names.size(), 200u);
  for (const std::string& name : names) EXPECT_EQ(bytes_of(folder / name), kNew) << name;
}

// Writes for ever until it is killed.
[[noreturn]] void write_for_ever(const Folder& folder, const Bytes& bytes) {
  for (unsigned i = 0;; ++i)
    if (!write_file_atomically(folder / ("frame" + std::to_string(i % 8)), bytes)) _exit(1);
}

TEST(AtomicFile, AKilledProcessLeavesOnlyWholeFilesUnderFinalNames) {
  const Bytes large = numbered(1 << 20);
  int seen = 0;
  for (int round = 0; round < 20; ++round) {
    const Folder folder;
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) write_for_ever(folder, large);
    std::this_thread::sleep_for(std::chrono::microseconds(5000 + 1700 * round));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    for (const std::string& name : folder.names()) {
      if (name.rfind(kTemporaryPrefix, 0) == 0) continue;
      ++seen;
      EXPECT_EQ(bytes_of(folder / name), large) << name;
    }
  }
  EXPECT_GT(seen, 0);
}

}  // namespace
}  // namespace polhode
