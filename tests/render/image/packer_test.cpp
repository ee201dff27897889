// SPDX-License-Identifier: MIT
// What is packed, zlib's own reader must give back: for bytes that do not get smaller, and for all lengths
// where streams and their blocks begin and end.
#include "render/image/packer.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <vector>

namespace polhode {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes unpacked(std::span<const std::uint8_t> packed, std::size_t expected) {
  Bytes bytes(expected + 1);  // one more: what is too long is seen
  uLongf count = bytes.size();
  if (uncompress(bytes.data(), &count, packed.data(), packed.size()) != Z_OK) return {};
  bytes.resize(count);
  return bytes;
}

/// Bytes of one kind: random, a few values only, repeats at a distance, runs between noise.
Bytes bytes_of_kind(int kind, std::size_t count, std::minstd_rand& random) {
  const auto any = [&] { return static_cast<std::uint8_t>(random() >> 8); };
  const std::vector<std::function<std::uint8_t(const Bytes&)>> kinds = {
      [&](const Bytes&) { return any(); },
      [&](const Bytes&) { return static_cast<std::uint8_t>(any() & 3); },
      [&](const Bytes& so_far) {
        return so_far.size() < 32768 || any() < 16 ? any() : so_far[so_far.size() - 32768];
      },
      [&](const Bytes& so_far) { return (so_far.size() / 300) % 2 == 0 ? std::uint8_t{7} : any(); },
  };
  Bytes bytes;
  while (bytes.size() < count) bytes.push_back(kinds.at(static_cast<std::size_t>(kind))(bytes));
  return bytes;
}

class Packers : public testing::TestWithParam<PngPacking> {};

TEST_P(Packers, ZlibGivesBackWhatWasPacked) {
  Packer packer(GetParam());
  std::minstd_rand random(1);
  for (const std::size_t count :
       {0U, 1U, 2U, 3U, 257U, 258U, 259U, 4095U, 32768U, 65535U, 65536U, 65537U, 300001U})
    for (int kind = 0; kind < 4; ++kind) {
      const Bytes bytes = bytes_of_kind(kind, count, random);
      EXPECT_EQ(unpacked(packer.pack(bytes), count), bytes) << count << " bytes of kind " << kind;
    }
}

/// A block that does not get smaller is stored, with some bytes for each 64 KiB.
TEST_P(Packers, NoiseHardlyGrows) {
  std::minstd_rand random(2);
  const Bytes noise = bytes_of_kind(0, 1 << 20, random);
  const std::size_t blocks = noise.size() / 32768;
  EXPECT_LE(Packer(GetParam()).pack(noise).size(), noise.size() + 16 * blocks);
}

TEST_P(Packers, WhatWasPackedBeforeLeavesNoTrace) {
  std::minstd_rand random(3);
  const Bytes first = bytes_of_kind(2, 100000, random), second = bytes_of_kind(3, 50000, random);
  Packer used(GetParam()), fresh(GetParam());
  used.pack(first);
  const auto again = used.pack(second), once = fresh.pack(second);
  EXPECT_TRUE(std::equal(again.begin(), again.end(), once.begin(), once.end()));
}

// 2026-11-27: ISA-L hashed the address of its own state, and one process of seventy packed other bytes.
TEST_P(Packers, TheirPlaceInMemoryLeavesNoTrace) {
  std::minstd_rand random(4);
  const Bytes bytes = bytes_of_kind(1, 200000, random);
  std::vector<std::unique_ptr<Packer>> all;  // each at a place of its own
  std::optional<Bytes> first;
  for (int i = 0; i < 20; ++i) {
    all.push_back(std::make_unique<Packer>(GetParam()));
    const auto packed = all.back()->pack(bytes);
    if (!first) first = Bytes(packed.begin(), packed.end());
    EXPECT_TRUE(std::equal(packed.begin(), packed.end(), first->begin(), first->end())) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Both, Packers, testing::Values(PngPacking::fast, PngPacking::small),
                         [](const auto& tested) {
                           return tested.param == PngPacking::fast ? "fast" : "small";
                         });

}  // namespace
}  // namespace polhode
