// SPDX-License-Identifier: MIT
#include "base/files/temporary_file.h"

#include "base/files/left_behind.h"
#include "tests/base/files/folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

namespace polhode {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::name_of_the_dead;
using test::put;
using testing::ElementsAre;
using testing::IsEmpty;

void make_old(const fs::path& file, std::chrono::minutes age = std::chrono::minutes(61)) {
  fs::last_write_time(file, fs::file_time_type::clock::now() - age);
}

TEST(TemporaryFile, HasANameOfItsProcess) {
  EXPECT_EQ(temporary_name(0), temporary_name(0));
  EXPECT_NE(temporary_name(0), temporary_name(1));
  EXPECT_NE(temporary_name(0), name_of_the_dead(0));
  EXPECT_THAT(temporary_name(7), testing::MatchesRegex("\\.polhode-[0-9a-f]{8}-[0-9]+-7\\.part"));
  EXPECT_TRUE(is_temporary_name(temporary_name(7)));
  EXPECT_FALSE(is_temporary_name(".polhode-unfinished.json") || is_temporary_name("a.part"));
}

TEST(TemporaryFile, OfADeadProcessIsLeftBehind) {
  const Folder folder;
  const std::string dead = name_of_the_dead(3);
  put(folder / dead, {1});
  put(folder / temporary_name(0), {1});
  make_old(folder / temporary_name(0));  // a clock may be set, and a living process may wait
  EXPECT_THAT(left_behind_in(folder.path()), ElementsAre(folder / dead));
}

// HOSTILE F12: it was kept for ever where another process had got the number of a killed one.
TEST(TemporaryFile, OfANumberThatWasGivenAgainIsLeftBehindAfterADay) {
  const Folder folder;
  put(folder / temporary_name(0), {1});
  make_old(folder / temporary_name(0), std::chrono::hours(23));
  EXPECT_THAT(left_behind_in(folder.path()), IsEmpty());
  make_old(folder / temporary_name(0), std::chrono::hours(25));
  EXPECT_THAT(left_behind_in(folder.path()), ElementsAre(folder / temporary_name(0)));
}

TEST(TemporaryFile, WhatIsLeftBehindIsRemoved) {
  const Folder folder;
  put(folder / name_of_the_dead(3), {1});
  put(folder / temporary_name(0), {1});
  remove_left_behind_in(folder.path());
  EXPECT_FALSE(fs::is_empty(folder.path()));
  EXPECT_TRUE(fs::exists(folder / temporary_name(0)));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(TemporaryFile, OfAnotherMachineIsLeftBehindOnlyWhenOld) {
  const Folder folder;
  const fs::path fresh = folder / ".polhode-00000000-1-0.part", old = folder / ".polhode-00000000-2-0.part",
                 old_form = folder / ".polhode-99-0.part";
  for (const fs::path& file : {fresh, old, old_form}) put(file, {1});
  make_old(old);
  make_old(old_form);
  EXPECT_THAT(left_behind_in(folder.path()), ElementsAre(old, old_form));
}

TEST(TemporaryFile, OtherFilesAreNot) {
  const Folder folder;
  for (const char* name : {".polhode-unfinished.json", "a.part", "01-a.png", ".polhode"}) {
    put(folder / name, {1});
    make_old(folder / name);
  }
  EXPECT_THAT(left_behind_in(folder.path()), IsEmpty());
  EXPECT_THAT(left_behind_in(folder / "none"), IsEmpty());
}

}  // namespace
}  // namespace polhode
