// SPDX-License-Identifier: MIT
#include "base/files/file_bytes.h"

#include "tests/base/files/folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace polhode {
namespace {

using testing::HasSubstr;

TEST(FileBytes, AreThoseOfTheFile) {
  const test::Folder folder;
  test::put(folder / "a", {1, 0, 255});
  test::put(folder / "empty", {});
  EXPECT_EQ(*read_file_bytes(folder / "a"), (std::vector<std::uint8_t>{1, 0, 255}));
  EXPECT_TRUE(read_file_bytes(folder / "empty")->empty());
}

TEST(FileBytes, OfTooManyAreRefusedBeforeTheyAreRead) {
  const test::Folder folder;
  test::put(folder / "a", {1, 2, 3});
  EXPECT_TRUE(read_file_bytes(folder / "a", 3).ok());
  EXPECT_THAT(read_file_bytes(folder / "a", 2).error(), HasSubstr("larger"));
}

TEST(FileBytes, OfWhatIsNoFileAreRefusedAtOnce) {
  const test::Folder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(read_file_bytes(folder / "pipe").error(), "it is not a file");
  EXPECT_EQ(read_file_bytes(folder.path()).error(), "it is not a file");
  EXPECT_THAT(read_file_bytes(folder / "none").error(), HasSubstr("No such file"));
}

}  // namespace
}  // namespace polhode
