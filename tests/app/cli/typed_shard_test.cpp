// SPDX-License-Identifier: MIT
#include "app/cli/typed_shard.h"

#include "app/cli/exit_codes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

namespace polhode {
namespace {

using testing::HasSubstr;

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

}  // namespace
}  // namespace polhode
