// SPDX-License-Identifier: MIT
#include "render/image/png_summary.h"

#include "tests/render/image/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using testing::HasSubstr;

const PngMetadata kMetadata{
    {{"Title", "plain"}, {"Description", "ω – and “quotes”"}, {"x:y", ""}, {"L", "é"}}, 300};

std::vector<std::uint8_t> a_png() {
  Image image = Image::blank({31, 17});
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = static_cast<std::uint8_t>(i * 7 % 251);
  return *encode_png(image, kMetadata);
}

TEST(PngSummary, SaysWhatTheFileSays) {
  const auto summary = summarize_png(a_png());
  ASSERT_TRUE(summary.ok()) << summary.error();
  EXPECT_EQ(summary->size, (Size{31, 17}));
  EXPECT_EQ(summary->metadata.text, kMetadata.text);
  EXPECT_EQ(summary->metadata.dpi, kMetadata.dpi);
}

TEST(PngSummary, RefusesEveryTruncation) {
  const auto whole = a_png();
  for (std::size_t length = 0; length < whole.size(); ++length)
    ASSERT_FALSE(summarize_png(std::span(whole).first(length)).ok()) << length;
}

TEST(PngSummary, RefusesEveryChangedByte) {
  const auto whole = a_png();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    auto damaged = whole;
    damaged[at] ^= 0x40;
    ASSERT_FALSE(summarize_png(damaged).ok()) << at;
  }
}

TEST(PngSummary, OfAFileThatIsNotThereSaysWhy) {
  const auto summary = summarize_png_file("/nowhere/a.png");
  ASSERT_FALSE(summary.ok());
  EXPECT_THAT(summary.error(), HasSubstr("No such file"));
}

}  // namespace
}  // namespace polhode
