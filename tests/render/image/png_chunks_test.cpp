// SPDX-License-Identifier: MIT
#include "render/image/png_chunks.h"

#include "render/image/png.h"
#include "tests/render/image/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

Bytes some_png() { return *encode_png(test::scenic({60, 40}, true), {{{"Title", "ω"}}, 300}); }

TEST(PngChunks, AreThoseOfTheFileInOrder) {
  const Bytes bytes = some_png();
  const auto png = read_png_chunks(bytes);
  ASSERT_TRUE(png) << png.error();
  EXPECT_EQ(png->header.size, (Size{60, 40}));
  EXPECT_EQ(png->header.bit_depth, 8);
  EXPECT_EQ(png->header.color_type, 2);
  EXPECT_FALSE(png->header.interlaced);
  std::vector<std::string_view> types;
  std::size_t total = 8;
  for (const PngChunk& chunk : png->chunks) {
    types.push_back(chunk.type);
    total += 12 + chunk.data.size();
  }
  EXPECT_THAT(types, testing::IsSupersetOf({"IHDR", "pHYs", "iTXt", "IDAT", "IEND"}));
  EXPECT_EQ(types.front(), "IHDR");
  EXPECT_EQ(types.back(), "IEND");
  EXPECT_EQ(total, bytes.size());
}

TEST(PngChunks, RefuseEveryTruncation) {
  const Bytes bytes = some_png();
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_FALSE(read_png_chunks(std::span(bytes).first(length))) << length;
}

TEST(PngChunks, RefuseAChangedBitAnywhere) {
  Bytes bytes = some_png();
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] ^= 0x10;
    EXPECT_FALSE(read_png_chunks(bytes)) << i;
    bytes[i] ^= 0x10;
  }
  EXPECT_TRUE(read_png_chunks(bytes));
}

TEST(PngChunks, RefuseWhatGoesOnAfterTheEnd) {
  Bytes bytes = some_png();
  bytes.push_back('\n');
  EXPECT_THAT(read_png_chunks(bytes).error(), HasSubstr("after its end"));
}

TEST(PngChunks, SayWhatIsWrong) {
  Bytes bytes = some_png();
  bytes.resize(100);
  EXPECT_THAT(read_png_chunks(bytes).error(), HasSubstr("truncated or damaged after "));
  EXPECT_EQ(read_png_chunks(Bytes{'h', 'e', 'l', 'l', 'o'}).error(), "it is not a PNG");
}

}  // namespace
}  // namespace polhode
