// SPDX-License-Identifier: MIT
#include "app/export/folder/shard.h"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

std::string shard_manifest_name(const Shard& shard) {
  return fmt::format("manifest.{}-of-{}.json", shard.index, shard.count);
}

bool is_shard_manifest_name(std::string_view name) {
  constexpr std::string_view kStart = "manifest.", kMiddle = "-of-", kEnd = ".json";
  if (!name.starts_with(kStart) || !name.ends_with(kEnd) || name.size() < kStart.size() + kEnd.size())
    return false;
  name = name.substr(kStart.size(), name.size() - kStart.size() - kEnd.size());
  const std::size_t middle = name.find(kMiddle);
  if (middle == name.npos) return false;
  const auto is_number = [](std::string_view text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  return is_number(name.substr(0, middle)) && is_number(name.substr(middle + kMiddle.size()));
}

}  // namespace polhode
