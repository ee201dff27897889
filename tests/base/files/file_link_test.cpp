// SPDX-License-Identifier: MIT
#include "base/files/file_link.h"

#include "tests/base/files/folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>

namespace polhode {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using test::Folder;
using test::put;
using testing::ElementsAre;
using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

const Bytes kOld = {9, 9}, kNew = {1, 2, 3};

/// The real file system, but operation `fail_at` fails (from 0), and so do all links if there are none.
class Files final : public FileOps {
 public:
  explicit Files(int fail_at = -1, int error = EIO, int link_error = 0)
      : fail_at_(fail_at), error_(error), link_error_(link_error) {}
  int open(const char* path, int flags, mode_t mode) override {
    return fails() ? -1 : real_.open(path, flags, mode);
  }
  ssize_t write(int file, const void* bytes, std::size_t count) override {
    return fails() ? -1 : real_.write(file, bytes, count);
  }
  int fsync(int file) override { return fails() ? -1 : real_.fsync(file); }
  int syncfs(int file) override { return fails() ? -1 : real_.syncfs(file); }
  int close(int file) override {
    real_.close(file);
    return fails() ? -1 : 0;
  }
  int rename(const char* from, const char* to) override { return fails() ? -1 : real_.rename(from, to); }
  int unlink(const char* path) override { return fails() ? -1 : real_.unlink(path); }
  int link(const char* from, const char* to) override {
    if (fails()) return -1;
    if (link_error_ == 0) return real_.link(from, to);
    errno = link_error_;
    return -1;
  }
  bool reached() const { return count_ > fail_at_; }

 private:
  bool fails() {
    if (count_++ != fail_at_) return false;
    errno = error_;
    return true;
  }
  PosixFileOps real_;
  int fail_at_, error_, link_error_;
  int count_ = 0;
};

TEST(LinkFile, GivesASecondNameInPlaceOfWhatWasThere) {
  for (const bool old_exists : {false, true}) {
    const Folder folder;
    put(folder / "a", kNew);
    if (old_exists) put(folder / "b", kOld);
    Files files;
    ASSERT_TRUE(link_file_atomically(files, folder / "a", folder / "b").ok());
    EXPECT_EQ(bytes_of(folder / "b"), kNew);
    EXPECT_TRUE(fs::equivalent(folder / "a", folder / "b"));
    EXPECT_THAT(folder.names(), ElementsAre("a", "b"));
  }
}

TEST(LinkFile, AgainLeavesNothingBesides) {  // rename does nothing between two names of one file
  const Folder folder;
  put(folder / "a", kNew);
  Files files;
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(link_file_atomically(files, folder / "a", folder / "b").ok());
  EXPECT_THAT(folder.names(), ElementsAre("a", "b"));
}

TEST(LinkFile, AnyFailureLeavesThePathAsItWas) {
  for (int n = 0;; ++n) {
    const Folder folder;
    put(folder / "a", kNew);
    put(folder / "b", kOld);
    Files files(n);
    const Status linked = link_file_atomically(files, folder / "a", folder / "b");
    if (!files.reached()) {
      EXPECT_GE(n, 3) << "link, rename, unlink";
      break;
    }
    if (!linked) {
      EXPECT_THAT(linked.error(), HasSubstr((folder / "b").string()));
    }
    EXPECT_EQ(bytes_of(folder / "b"), n < 2 ? kOld : kNew) << n;
    if (n < 2) {
      EXPECT_FALSE(linked.ok()) << n;
    }
    EXPECT_THAT(folder.names(), ElementsAre("a", "b")) << n;
  }
}

TEST(CreateFile, MakesItOnce) {
  const Folder folder;
  Files files;
  const auto first = create_file_atomically(files, folder / "a", kNew);
  ASSERT_TRUE(first.ok()) << first.error();
  EXPECT_TRUE(*first);
  const auto second = create_file_atomically(files, folder / "a", kOld);
  ASSERT_TRUE(second.ok());
  EXPECT_FALSE(*second);
  EXPECT_EQ(bytes_of(folder / "a"), kNew);
  EXPECT_THAT(folder.names(), ElementsAre("a"));
}

TEST(CreateFile, WhoComesBetweenLookingAndMakingWins) {
  class Late final : public FileOps {
   public:
    explicit Late(fs::path path) : path_(std::move(path)) {}
    int open(const char* path, int flags, mode_t mode) override { return real_.open(path, flags, mode); }
    ssize_t write(int file, const void* bytes, std::size_t n) override { return real_.write(file, bytes, n); }
    int fsync(int file) override { return real_.fsync(file); }
    int syncfs(int file) override { return real_.syncfs(file); }
    int close(int file) override { return real_.close(file); }
    int rename(const char* from, const char* to) override { return real_.rename(from, to); }
    int unlink(const char* path) override { return real_.unlink(path); }
    int link(const char* from, const char* to) override {
      put(path_, kOld);
      return real_.link(from, to);
    }

   private:
    fs::path path_;
    PosixFileOps real_;
  };
  const Folder folder;
  Late files(folder / "a");
  const auto made = create_file_atomically(files, folder / "a", kNew);
  ASSERT_TRUE(made.ok());
  EXPECT_FALSE(*made);
  EXPECT_EQ(bytes_of(folder / "a"), kOld);
  EXPECT_THAT(folder.names(), ElementsAre("a"));
}

TEST(CreateFile, WorksWithoutLinks) {
  for (const int error : {EPERM, EOPNOTSUPP, ENOSYS}) {
    const Folder folder;
    Files files(-1, 0, error);
    const auto made = create_file_atomically(files, folder / "a", kNew);
    ASSERT_TRUE(made.ok()) << made.error();
    EXPECT_TRUE(*made);
    EXPECT_EQ(bytes_of(folder / "a"), kNew);
    EXPECT_THAT(folder.names(), ElementsAre("a"));
  }
}

TEST(CreateFile, AnyFailureLeavesNothingHalfWritten) {
  for (const int link_error : {0, EPERM})
    for (int n = 0;; ++n) {
      const Folder folder;
      Files files(n, ENOSPC, link_error);
      const auto made = create_file_atomically(files, folder / "a", kNew);
      if (!files.reached()) break;
      if (!made) {
        EXPECT_THAT(made.error(), HasSubstr("No space left")) << n;
      }
      for (const std::string& name : folder.names()) EXPECT_EQ(bytes_of(folder / name), kNew) << n << name;
      if (made.ok()) {
        EXPECT_EQ(bytes_of(folder / "a"), kNew) << n;
      }
    }
}

}  // namespace
}  // namespace polhode
