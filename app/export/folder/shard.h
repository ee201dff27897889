// SPDX-License-Identifier: MIT
// An export in parts that processes make at the same time, on one machine or many, without a word to each
// other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace polhode {

inline constexpr std::int64_t kMostShards = 1'000'000;

/// Of all pictures of the plan, every count-th: neighbours cost alike, so that shards take alike.
struct Shard {
  std::int64_t index = 1;  ///< 1…count
  std::int64_t count = 1;

  bool whole() const { return count == 1; }
  /// `place` of a picture in the plan, from 0.
  bool takes(std::size_t place) const { return static_cast<std::int64_t>(place) % count == index - 1; }
  /// How many it takes of `total`.
  std::size_t size(std::size_t total) const {
    const auto n = static_cast<std::int64_t>(total);
    return static_cast<std::size_t>(n < index ? 0 : (n - index) / count + 1);
  }
  /// Part `i` (from 0) of `parts` of this shard.
  Shard part(std::int64_t i, std::int64_t parts) const { return {index + count * i, count * parts}; }
  bool operator==(const Shard&) const = default;
};

/// "manifest.2-of-4.json"
std::string shard_manifest_name(const Shard& shard);
bool is_shard_manifest_name(std::string_view name);

}  // namespace polhode
