// SPDX-License-Identifier: MIT
#include "app/export/folder/shard.h"

#include <gtest/gtest.h>

#include <vector>

namespace polhode {
namespace {

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
