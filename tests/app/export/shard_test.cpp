// SPDX-License-Identifier: MIT
#include "app/export/shard.h"

#include "app/cli/exit_codes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <vector>

namespace polhode {
namespace {

using testing::HasSubstr;

TEST(Shards, AreExactAndDisjointForAllCounts) {  // F4
  for (std::int64_t n = 1; n <= 64; ++n)
    for (std::size_t total = 0; total <= 200; ++total) {
      std::vector<int> taken(total, 0);
      for (Shard shard{1, n}; shard.index <= n; ++shard.index) {
        std::size_t count = 0;
        for (std::size_t place = 0; place < total; ++place)
          if (shard.takes(place)) ++taken[place], ++count;
        ASSERT_EQ(count, shard.size(total)) << shard.index << '/' << n << " of " << total;
      }
      ASSERT_EQ(taken, std::vector<int>(total, 1)) << n << " shards of " << total;
    }
}

TEST(Shards, TakeEveryNthPicture) {
  const Shard second{2, 3};
  EXPECT_FALSE(second.takes(0));
  EXPECT_TRUE(second.takes(1));
  EXPECT_FALSE(second.takes(2));
  EXPECT_TRUE(second.takes(4));
}

TEST(Shards, AreMadeOfParts) {
  constexpr std::size_t kTotal = 50;
  for (std::int64_t n = 1; n <= 4; ++n)
    for (std::int64_t parts = 1; parts <= 4; ++parts)
      for (Shard shard{1, n}; shard.index <= n; ++shard.index)
        for (std::size_t place = 0; place < kTotal; ++place) {
          int taken = 0;
          for (std::int64_t i = 0; i < parts; ++i) {
            const Shard part = shard.part(i, parts);
            EXPECT_TRUE(part.index >= 1 && part.index <= part.count && part.count == n * parts);
            taken += part.takes(place) ? 1 : 0;
          }
          EXPECT_EQ(taken, shard.takes(place) ? 1 : 0);
        }
}

std::string refusal(const std::string& typed) {
  try {
    static_cast<void>(shard_from(typed));
  } catch (const CommandError& error) {
    EXPECT_EQ(error.code, ExitCode::usage);
    return error.what();
  }
  return "";
}

TEST(Shards, AreReadFromText) {
  EXPECT_EQ(shard_from(""), (Shard{1, 1}));
  EXPECT_EQ(shard_from("1/1"), (Shard{1, 1}));
  EXPECT_EQ(shard_from("8/8"), (Shard{8, 8}));
  for (const char* typed :
       {"0/8", "9/8", "8", "1/0", "-1/8", "1/8/2", "a/b", "1/", "/8", "1.5/8", "slrum", "1/1000001"})
    EXPECT_THAT(refusal(typed), HasSubstr("--shard")) << typed;
}

class Slurm : public testing::Test {
 protected:
  void TearDown() override {
    for (const char* name : {"ID", "MIN", "STEP", "COUNT"}) unsetenv(variable(name).c_str());
  }
  static std::string variable(const std::string& name) { return "SLURM_ARRAY_TASK_" + name; }
  static void task(const std::map<std::string, std::string>& values) {
    for (const auto& [name, value] : values) setenv(variable(name).c_str(), value.c_str(), 1);
  }
};

TEST_F(Slurm, SaysWhichShard) {
  task({{"ID", "1"}, {"MIN", "1"}, {"STEP", "1"}, {"COUNT", "4"}});
  EXPECT_EQ(shard_from("slurm"), (Shard{1, 4}));
  task({{"ID", "0"}, {"MIN", "0"}, {"STEP", "1"}, {"COUNT", "4"}});
  EXPECT_EQ(shard_from("slurm"), (Shard{1, 4}));
  task({{"ID", "10"}, {"MIN", "1"}, {"STEP", "3"}, {"COUNT", "4"}});  // --array=1-10:3
  EXPECT_EQ(shard_from("slurm"), (Shard{4, 4}));
}

TEST_F(Slurm, OfAnArrayWithHolesIsRefused) {  // --array=1,5,7
  task({{"ID", "7"}, {"MIN", "1"}, {"STEP", "1"}, {"COUNT", "3"}});
  EXPECT_THAT(refusal("slurm"), HasSubstr("has to be a range"));
  task({{"ID", "2"}, {"MIN", "1"}, {"STEP", "3"}, {"COUNT", "3"}});
  EXPECT_THAT(refusal("slurm"), HasSubstr("has to be a range"));
}

TEST_F(Slurm, OutsideAnArrayIsRefused) {
  EXPECT_THAT(refusal("slurm"), HasSubstr("SLURM_ARRAY_TASK_ID is not set"));
  task({{"ID", "1"}, {"MIN", "1"}, {"STEP", "x"}, {"COUNT", "3"}});
  EXPECT_THAT(refusal("slurm"), HasSubstr("SLURM_ARRAY_TASK_STEP"));
}

TEST(ShardManifests, HaveNamesOfTheirOwn) {
  EXPECT_EQ(shard_manifest_name({2, 14}), "manifest.2-of-14.json");
  EXPECT_TRUE(is_shard_manifest_name("manifest.2-of-14.json"));
  for (const char* name :
       {"manifest.json", "manifest.2-of-.json", "manifest.-of-2.json", "manifest.a-of-2.json",
        "manifest.2-of-14.json.part", "manifest..json", "01-a.png"})
    EXPECT_FALSE(is_shard_manifest_name(name)) << name;
}

}  // namespace
}  // namespace polhode
