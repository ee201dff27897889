// SPDX-License-Identifier: MIT
#include "render/image/png.h"

#include "tests/base/files/folder.h"
#include "tests/render/image/crafted_png.h"
#include "tests/render/image/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <string>

namespace polhode {
namespace {

using test::chunk;
using test::deflated;
using test::Folder;
using test::header;
using test::png_of;
using test::put32;
using test::scenic;
using test::uniform;
using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kHeaderEnd = 33;  // 8 of signature, 25 of IHDR
constexpr std::size_t kColorType = 25;  // place of IHDR's colour type

constexpr PngPacking kPackings[] = {PngPacking::fast, PngPacking::small};

Bytes encoded(const Image& image, const PngMetadata& metadata = {}, PngPacking packing = PngPacking::fast) {
  Result<Bytes> bytes = encode_png(image, metadata, packing);
  EXPECT_TRUE(bytes.ok()) << bytes.error();
  return *bytes;
}

PngFile decoded(const Bytes& bytes) {
  Result<PngFile> file = decode_png(bytes);
  if (!file) ADD_FAILURE() << file.error();
  return file ? *file : PngFile{};
}

Bytes with_inserted(Bytes bytes, std::size_t at, const Bytes& inserted) {
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), inserted.begin(), inserted.end());
  return bytes;
}

bool contains(const Bytes& bytes, const char* type) {
  return std::search(bytes.begin(), bytes.end(), type, type + 4) != bytes.end();
}

TEST(Png, RoundTripsOpaqueAndTransparentImagesOfManySizes) {
  for (const Size size : {Size{1, 1}, {1, 7}, {7, 1}, {16, 9}, {321, 123}})
    for (const bool opaque : {true, false})
      for (const PngPacking packing : kPackings) {
        const Image image = scenic(size, opaque);
        const PngFile file = decoded(encoded(image, {}, packing));
        EXPECT_EQ(file.image.size, size);
        EXPECT_EQ(file.image.rgba, image.rgba) << size.width << " x " << size.height;
        EXPECT_TRUE(file.metadata.text.empty());
        EXPECT_EQ(file.metadata.dpi, 0);
      }
}

TEST(Png, ColourUnderFullTransparencySurvives) {
  const Image image = uniform({4, 4}, 10, 20, 30, 0);
  EXPECT_EQ(decoded(encoded(image)).image.rgba, image.rgba);
}

TEST(Png, RgbIfOpaqueEverywhereElseRgba) {
  Image image = scenic({8, 8}, true);
  EXPECT_EQ(encoded(image)[kColorType], PNG_COLOR_TYPE_RGB);
  image.rgba.back() = 254;
  EXPECT_EQ(encoded(image)[kColorType], PNG_COLOR_TYPE_RGB_ALPHA);
}

TEST(Png, MetadataSurvivesInOrder) {
  const PngMetadata metadata{{{"Title", "Intermediate axis"},
                              {"Author", "Euler & Poinsot"},
                              {"Comment", "à 45° ±"},
                              {"polhode:scene", "ω₂ ≫ ω₁, ω₃"},
                              {"Title", "twice"},
                              {"Software", ""}},
                             200};
  const Bytes bytes = encoded(scenic({9, 5}, true), metadata);
  const PngFile file = decoded(bytes);
  EXPECT_EQ(file.metadata.text, metadata.text);
  EXPECT_EQ(file.metadata.dpi, 200);
  EXPECT_TRUE(contains(bytes, "tEXt"));
  EXPECT_TRUE(contains(bytes, "iTXt"));
}

TEST(Png, EveryResolutionSurvives) {
  for (int dpi = 1; dpi <= 1200; ++dpi) {
    const PngMetadata metadata{{}, dpi};
    ASSERT_EQ(decoded(encoded(uniform({1, 1}, 0, 0, 0), metadata)).metadata.dpi, dpi);
  }
  // 300 dpi is 11811.02 pixels per metre.
  const Bytes bytes = encoded(uniform({1, 1}, 0, 0, 0), {{}, 300});
  Bytes data;
  put32(data, 11811);
  put32(data, 11811);
  data.push_back(1);
  const Bytes expected = chunk("pHYs", data);
  EXPECT_NE(std::search(bytes.begin(), bytes.end(), expected.begin(), expected.end()), bytes.end());
}

TEST(Png, TheSameImageGivesTheSameBytesWithoutATime) {
  const PngMetadata metadata{{{"Title", "ω"}}, 96};
  const Image image = scenic({200, 100}, false);
  for (const PngPacking packing : kPackings) {
    const Bytes first = encoded(image, metadata, packing);
    EXPECT_EQ(first, encoded(image, metadata, packing));
    EXPECT_FALSE(contains(first, "tIME"));
  }
}

TEST(Png, AnEncoderForgetsTheImageBefore) {
  for (const PngPacking packing : kPackings) {
    PngEncoder encoder(packing);
    for (const auto& [size, opaque] : {std::pair{Size{64, 48}, false}, {{20, 10}, true}, {{90, 70}, false}}) {
      const PngMetadata metadata{{{"Title", std::to_string(size.width)}}, size.width};
      const auto bytes = encoder.encode(scenic(size, opaque), metadata);
      ASSERT_TRUE(bytes.ok()) << bytes.error();
      EXPECT_EQ(Bytes(bytes->begin(), bytes->end()), encoded(scenic(size, opaque), metadata, packing));
      EXPECT_FALSE(encoder.encode({{2, 2}, Bytes(15)}, {}).ok()) << "wrong number of bytes";
    }
  }
}

/// As libpng writes the rows by itself.
std::size_t bytes_by_default(const Image& image) {
  png_image form{};
  form.version = PNG_IMAGE_VERSION;
  form.format = PNG_FORMAT_RGB;
  form.width = static_cast<png_uint_32>(image.size.width);
  form.height = static_cast<png_uint_32>(image.size.height);
  Bytes rgb;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    rgb.insert(rgb.end(), &image.rgba[i], &image.rgba[i] + 3);
  png_alloc_size_t size = 0;
  EXPECT_TRUE(png_image_write_to_memory(&form, nullptr, &size, 0, rgb.data(), 0, nullptr)) << form.message;
  return size;
}

TEST(Png, FastIsHardlyLargerThanLibpngsDefaultAndSmallIsSmaller) {
  const Image scene = scenic({480, 270}, true), flat = uniform({480, 270}, 251, 250, 246);
  const auto ratio = [](const Image& image, PngPacking packing) {
    return static_cast<double>(encoded(image, {}, packing).size()) /
           static_cast<double>(bytes_by_default(image));
  };
  EXPECT_LT(ratio(scene, PngPacking::fast), 1.15);
  EXPECT_LT(ratio(scene, PngPacking::small), 1.0);
  // Both are a few hundred bytes, chunks and all.
  EXPECT_LT(ratio(flat, PngPacking::fast), 3.0);
  EXPECT_LT(ratio(flat, PngPacking::small), 1.15);
}

TEST(Png, WhatDoesNotPackIsSplitOverSeveralChunks) {
  Image noise = Image::blank({1700, 1400});  // 9.1 MiB; a chunk has at most 8
  std::minstd_rand random(1);
  for (std::uint8_t& byte : noise.rgba) byte = static_cast<std::uint8_t>(random() >> 8);
  const Bytes bytes = encoded(noise);
  EXPECT_EQ(decoded(bytes).image.rgba, noise.rgba);
  int chunks = 0;
  for (std::size_t at = 8; at < bytes.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8 | bytes[at + i];
    if (std::memcmp(&bytes[at + 4], "IDAT", 4) == 0) ++chunks;
    at += 12 + length;
  }
  EXPECT_EQ(chunks, 2);
}

TEST(Png, ImpossibleTextIsRefused) {
  const Image image = uniform({1, 1}, 0, 0, 0);
  const auto error = [&](const std::string& keyword, const std::string& text) {
    const Result<Bytes> bytes = encode_png(image, {{{keyword, text}}, 0});
    return bytes ? std::string("accepted") : bytes.error();
  };
  EXPECT_THAT(error("", "x"), HasSubstr("1 to 79"));
  EXPECT_THAT(error(std::string(80, 'k'), "x"), HasSubstr("1 to 79"));
  EXPECT_THAT(error("Title", "\xFF"), HasSubstr("\"Title\" is not UTF-8"));
  EXPECT_THAT(error("Title", std::string("a\0b", 3)), HasSubstr("not UTF-8"));
  const std::string omega = "\u03C9";  // iTXt, which has the longer frame
  EXPECT_THAT(error("Title", omega + std::string(kMaxPngTextBytes, 'x')), HasSubstr("1 MiB"));
  const std::string longest =
      omega + std::string(kMaxPngTextBytes - std::strlen("Title") - 5 - omega.size(), 'x');
  EXPECT_EQ(decoded(encoded(image, {{{"Title", longest}}, 0})).metadata.text.at(0).second, longest);
}

TEST(Png, SizesBeyondTheLimitAreRefusedTheLimitIsNot) {
  for (const Size size : {Size{0, 1}, {1, 0}, {-1, 1}, {kMaxPngSide + 1, 1}, {1, kMaxPngSide + 1}}) {
    const Result<Bytes> bytes = encode_png({size, Bytes(4)}, {});
    ASSERT_FALSE(bytes.ok());
    EXPECT_THAT(bytes.error(), HasSubstr("16384"));
  }
  EXPECT_FALSE(encode_png({{2, 2}, Bytes(15)}, {}).ok()) << "wrong number of bytes";
  for (const Size size : {Size{kMaxPngSide, 1}, {1, kMaxPngSide}})
    EXPECT_EQ(decoded(encoded(uniform(size, 1, 2, 3))).image.size, size);
}

TEST(PngReading, EveryTruncationIsRefusedWithAMessage) {
  const Bytes whole = encoded(scenic({20, 10}, false), {{{"Title", "ω"}}, 72});
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const Result<PngFile> file = decode_png(std::span(whole).first(length));
    ASSERT_FALSE(file.ok()) << length << " of " << whole.size();
    ASSERT_GT(file.error().size(), 10u);
  }
}

TEST(PngReading, NoDamagedByteCrashesAndPixelsAreGuardedByTheirChecksum) {
  const Bytes whole = encoded(scenic({20, 10}, true), {{{"Title", "plain"}}, 72});
  const Image image = decoded(whole).image;
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (const int flip : {0x01, 0x80, 0xFF}) {
      Bytes bytes = whole;
      bytes[i] = static_cast<std::uint8_t>(bytes[i] ^ flip);
      const Result<PngFile> file = decode_png(bytes);
      ASSERT_TRUE(!file.ok() || file->image.rgba == image.rgba) << "byte " << i;
    }
}

TEST(PngReading, RandomBytesAfterTheSignatureAreRefused) {
  std::minstd_rand random(1);
  for (int round = 0; round < 2000; ++round) {
    Bytes bytes = png_of({header(4, 4, 8, 2, 0)});
    for (int i = 0; i < 64; ++i) bytes.push_back(static_cast<std::uint8_t>(random()));
    ASSERT_FALSE(decode_png(bytes).ok());
  }
}

TEST(PngReading, OtherFilesAreNamedAsSuch) {
  for (const std::string text : {"", "GIF89a.........", "\x89PNG"}) {
    const Result<PngFile> file = decode_png(Bytes(text.begin(), text.end()));
    ASSERT_FALSE(file.ok());
    EXPECT_EQ(file.error(), "not a PNG file");
  }
}

TEST(PngReading, MoreThan16384PixelsASideAreRefused) {
  for (const auto& [width, height] : {std::pair{16385, 1}, {1, 16385}, {1000000, 1000000}}) {
    const Bytes bytes =
        png_of({header(static_cast<std::size_t>(width), static_cast<std::size_t>(height), 8, 0, 0),
                chunk("IDAT", deflated(Bytes(2))), chunk("IEND", {})});
    const Result<PngFile> file = decode_png(bytes);
    ASSERT_FALSE(file.ok());
    EXPECT_THAT(file.error(), HasSubstr("PNG"));
  }
}

TEST(PngReading, AShortFileThatClaimsToBeEnormousTakesNoMemory) {
  const Bytes bytes =
      png_of({header(16384, 16384, 8, 6, 0), chunk("IDAT", deflated(Bytes(1000))), chunk("IEND", {})});
  const Result<PngFile> file = decode_png(bytes);
  ASSERT_FALSE(file.ok());
  EXPECT_THAT(file.error(), HasSubstr("far too short"));
}

TEST(PngReading, TheDensestHonestImageIsNotTakenForABomb) {
  // One colour: as near to deflate's best ratio as pixels come.
  const std::size_t side = 4096;
  Bytes rows((1 + side / 8) * side);
  const Bytes bytes = png_of({header(side, side, 1, 0, 0), chunk("IDAT", deflated(rows)), chunk("IEND", {})});
  EXPECT_EQ(decoded(bytes).image.size, (Size{4096, 4096}));
}

TEST(PngReading, AChunkOfOneMebibyteIsReadALongerOneRefused) {
  Bytes data{'C', 'o', 'm', 'm', 'e', 'n', 't', 0};
  data.resize(kMaxPngTextBytes, 'x');
  const Bytes plain = encoded(uniform({1, 1}, 0, 0, 0));
  const PngFile file = decoded(with_inserted(plain, kHeaderEnd, chunk("tEXt", data)));
  ASSERT_EQ(file.metadata.text.size(), 1u);
  EXPECT_EQ(file.metadata.text[0].second.size(), kMaxPngTextBytes - 8u);
  data.push_back('x');
  const Result<PngFile> refused = decode_png(with_inserted(plain, kHeaderEnd, chunk("tEXt", data)));
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error(), HasSubstr("longer than 1 MiB"));
  // Nor does libpng take memory for one of which no more is there than how long it is.
  Bytes cut(plain.begin(), plain.begin() + kHeaderEnd);
  for (const char c : {'\x28', '\0', '\0', '\0', 'i', 'T', 'X', 't', 'x'})
    cut.push_back(static_cast<std::uint8_t>(c));
  EXPECT_THAT(decode_png(cut).error(), HasSubstr("longer than 1 MiB"));
}

TEST(PngReading, ACompressedTextBombIsLeftOut) {
  Bytes data{'C', 'o', 'm', 'm', 'e', 'n', 't', 0, 0};
  const Bytes bomb = deflated(Bytes(64 << 20, 'x'));
  ASSERT_LT(bomb.size(), 100000u);
  data.insert(data.end(), bomb.begin(), bomb.end());
  const Image image = scenic({5, 5}, true);
  const PngFile file = decoded(with_inserted(encoded(image), kHeaderEnd, chunk("zTXt", data)));
  EXPECT_TRUE(file.metadata.text.empty());
  EXPECT_EQ(file.image.rgba, image.rgba);
}

TEST(PngReading, CompressedTextIsRead) {
  Bytes data{'C', 'o', 'm', 'm', 'e', 'n', 't', 0, 0};
  const Bytes text = deflated({'4', '5', 0xB0});  // 45° in Latin-1
  data.insert(data.end(), text.begin(), text.end());
  const PngFile file =
      decoded(with_inserted(encoded(uniform({1, 1}, 0, 0, 0)), kHeaderEnd, chunk("zTXt", data)));
  ASSERT_EQ(file.metadata.text.size(), 1u);
  EXPECT_EQ(file.metadata.text[0].second, "45°");
}

// Two pixels in each of the colour types, as RGBA.
struct Kind {
  const char* name;
  std::uint8_t depth;
  std::uint8_t color;
  std::vector<Bytes> before;
  Bytes row;
  Bytes rgba;
};

TEST(PngReading, EveryColourTypeAndDepthBecomesRgba8) {
  const Bytes palette = chunk("PLTE", {10, 20, 30, 40, 50, 60});
  const std::vector<Kind> kinds = {
      {"grey 1", 1, 0, {}, {0x40}, {0, 0, 0, 255, 255, 255, 255, 255}},
      {"grey 2", 2, 0, {}, {0x60}, {85, 85, 85, 255, 170, 170, 170, 255}},
      {"grey 4", 4, 0, {}, {0x1F}, {17, 17, 17, 255, 255, 255, 255, 255}},
      {"grey 8", 8, 0, {}, {7, 200}, {7, 7, 7, 255, 200, 200, 200, 255}},
      {"grey 16", 16, 0, {}, {0x80, 0x80, 0xFF, 0xFF}, {128, 128, 128, 255, 255, 255, 255, 255}},
      {"grey 8, 200 clear", 8, 0, {chunk("tRNS", {0, 200})}, {7, 200}, {7, 7, 7, 255, 200, 200, 200, 0}},
      {"RGB 8", 8, 2, {}, {1, 2, 3, 4, 5, 6}, {1, 2, 3, 255, 4, 5, 6, 255}},
      {"palette 1", 1, 3, {palette}, {0x40}, {10, 20, 30, 255, 40, 50, 60, 255}},
      {"palette 8, first half clear",
       8,
       3,
       {palette, chunk("tRNS", {128})},
       {1, 0},
       {40, 50, 60, 255, 10, 20, 30, 128}},
      {"grey and alpha 8", 8, 4, {}, {7, 8, 9, 10}, {7, 7, 7, 8, 9, 9, 9, 10}},
      {"RGBA 8", 8, 6, {}, {1, 2, 3, 4, 5, 6, 7, 8}, {1, 2, 3, 4, 5, 6, 7, 8}},
  };
  for (const Kind& kind : kinds) {
    std::vector<Bytes> chunks{header(2, 1, kind.depth, kind.color, 0)};
    chunks.insert(chunks.end(), kind.before.begin(), kind.before.end());
    Bytes row = kind.row;
    row.insert(row.begin(), 0);  // no filter
    chunks.push_back(chunk("IDAT", deflated(row)));
    chunks.push_back(chunk("IEND", {}));
    EXPECT_EQ(decoded(png_of(chunks)).image.rgba, kind.rgba) << kind.name;
  }
}

TEST(PngReading, GammaIsNotApplied) {
  Bytes gamma;
  put32(gamma, 100000);
  const Image image = scenic({6, 6}, true);
  EXPECT_EQ(decoded(with_inserted(encoded(image), kHeaderEnd, chunk("gAMA", gamma))).image.rgba, image.rgba);
}

TEST(PngReading, InterlacedImagesAreRead) {
  // Adam7 of 2 x 2: passes 1 (0,0), 6 (1,0), 7 (second row).
  const Bytes rows{0, 10, 0, 20, 0, 30, 40};
  const PngFile file =
      decoded(png_of({header(2, 2, 8, 0, 1), chunk("IDAT", deflated(rows)), chunk("IEND", {})}));
  ASSERT_EQ(file.image.size, (Size{2, 2}));
  EXPECT_EQ(file.image.pixel(0, 0)[0], 10);
  EXPECT_EQ(file.image.pixel(1, 0)[0], 20);
  EXPECT_EQ(file.image.pixel(0, 1)[0], 30);
  EXPECT_EQ(file.image.pixel(1, 1)[0], 40);
}

TEST(PngFiles, WriteThenReadGivesTheSame) {
  const Folder folder;
  const Image image = scenic({40, 30}, false);
  const PngMetadata metadata{{{"Title", "ω"}}, 144};
  ASSERT_TRUE(write_png(folder / "a.png", image, metadata).ok());
  const Result<PngFile> file = read_png(folder / "a.png");
  ASSERT_TRUE(file.ok()) << file.error();
  EXPECT_EQ(file->image.rgba, image.rgba);
  EXPECT_EQ(file->metadata.text, metadata.text);
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(PngFiles, ErrorsNameTheFile) {
  const Folder folder;
  const auto error = [&](const std::string& name) {
    const Result<PngFile> file = read_png(folder / name);
    return file ? std::string("accepted") : file.error();
  };
  test::put(folder / "text.png", {'h', 'e', 'l', 'l', 'o', '\n', '\n', '\n', '\n'});
  std::filesystem::create_directory(folder / "folder.png");
  EXPECT_THAT(error("none.png"), testing::AllOf(HasSubstr("none.png"), HasSubstr("No such file")));
  EXPECT_THAT(error("text.png"), testing::AllOf(HasSubstr("text.png"), HasSubstr("not a PNG file")));
  EXPECT_THAT(error("folder.png"), HasSubstr("folder.png"));
  const Status written = write_png(folder / "none/a.png", uniform({1, 1}, 0, 0, 0), {});
  ASSERT_FALSE(written.ok());
  EXPECT_THAT(written.error(), HasSubstr("none/a.png"));
}

}  // namespace
}  // namespace polhode
