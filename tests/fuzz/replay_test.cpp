// SPDX-License-Identifier: MIT
// What fuzzers have found, tried again; and that each target takes what is well-formed.
#include "tests/fuzz/targets.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace polhode::fuzz {
namespace {

namespace fs = std::filesystem;

std::vector<Target> all_targets() {
  std::vector<Target> all;
  for (const auto targets : {render_targets(), reader_targets(), program_targets()})
    all.insert(all.end(), targets.begin(), targets.end());
  return all;
}

std::string bytes_of_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

const fs::path& inputs() {
  static const fs::path kInputs = test::source_dir() / "tests/data/fuzz";
  return kInputs;
}

class FuzzTarget : public testing::TestWithParam<Target> {};

TEST_P(FuzzTarget, HandlesWhatWasFoundBefore) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(inputs() / GetParam().name)) files.push_back(entry.path());
  EXPECT_FALSE(files.empty());  // at least one that is well-formed
  for (const fs::path& file : files) EXPECT_EQ(GetParam().finding_in(bytes_of_file(file)), "") << file;
}

TEST_P(FuzzTarget, HandlesEveryByteAloneAndNoneAtAll) {
  EXPECT_EQ(GetParam().finding_in({}), "");
  for (int i = 0; i < 256; ++i) {
    const char byte = static_cast<char>(i);
    EXPECT_EQ(GetParam().finding_in({&byte, 1}), "") << i;
  }
}

INSTANTIATE_TEST_SUITE_P(All, FuzzTarget, testing::ValuesIn(all_targets()),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(FuzzInputs, AreAllOfATarget) {
  for (const auto& folder : fs::directory_iterator(inputs())) {
    const auto all = all_targets();
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Target& one) {
      return one.name == folder.path().filename().string();
    })) << folder.path();
  }
}

}  // namespace
}  // namespace polhode::fuzz
