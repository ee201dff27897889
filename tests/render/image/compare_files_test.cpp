// SPDX-License-Identifier: MIT
#include "render/image/compare_files.h"

#include "render/image/png.h"
#include "render/image/png_rows.h"
#include "tests/base/files/folder.h"
#include "tests/render/image/crafted_png.h"
#include "tests/render/image/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace polhode {
namespace {

using test::chunk;
using test::deflated;
using test::Folder;
using test::header;
using test::png_of;
using test::scenic;
using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;
namespace fs = std::filesystem;

class CompareFiles : public testing::Test {
 protected:
  fs::path write(const std::string& name, const Bytes& bytes) const {
    std::ofstream(folder.path() / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return folder.path() / name;
  }
  fs::path write(const std::string& name, const Image& image) const {
    return write(name, encode_png(image, {}).value());
  }
  Folder folder;
};

TEST_F(CompareFiles, FindsWhatIsFoundInMemory) {
  const Image a = scenic({64, 48}, true);
  Image b = a;
  for (std::size_t i = 0; i < b.rgba.size(); i += 97) b.rgba[i] = static_cast<std::uint8_t>(b.rgba[i] ^ 5);
  const auto files = compare_png_files(write("a.png", a), write("b.png", b));
  ASSERT_TRUE(files.ok()) << files.error();
  const Comparison wanted = compare_images(a, b);
  EXPECT_GT(wanted.over_3, 0);
  EXPECT_EQ(files->found.pixels, wanted.pixels);
  EXPECT_EQ(files->found.over_3, wanted.over_3);
  EXPECT_EQ(files->found.max, wanted.max);
  EXPECT_EQ(files->found.equal(), wanted.equal());
}

TEST_F(CompareFiles, OfOtherSizesCountsNothing) {
  const auto files =
      compare_png_files(write("a.png", scenic({64, 48}, true)), write("b.png", scenic({48, 64}, true)));
  ASSERT_TRUE(files.ok()) << files.error();
  EXPECT_FALSE(files->found.same_size);
  EXPECT_EQ(files->found.pixels, 0);
  EXPECT_EQ(files->a, (Size{64, 48}));
  EXPECT_EQ(files->b, (Size{48, 64}));
}

TEST_F(CompareFiles, RefusesWhatDecodingRefuses) {
  const fs::path whole = write("whole.png", scenic({64, 48}, true));
  const Bytes bytes = encode_png(scenic({64, 48}, true), {}).value();
  Bytes flipped = bytes;
  flipped[bytes.size() / 2] ^= 4;
  const Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() - 20));
  for (const Bytes& hurt : {flipped, cut, Bytes(20, 'x'), Bytes()}) {
    const fs::path file = write("hurt.png", hurt);
    EXPECT_FALSE(decode_png(hurt).ok());
    EXPECT_FALSE(compare_png_files(file, whole).ok());
    EXPECT_FALSE(compare_png_files(whole, file).ok());
  }
  const auto missing = compare_png_files(whole, folder.path() / "missing.png");
  ASSERT_FALSE(missing.ok());
  EXPECT_THAT(missing.error(), HasSubstr("missing.png: No such file"));
}

/// Adam7 has for 1x1 but one pass.
TEST_F(CompareFiles, ReadsAnInterlacedPicture) {
  const auto pixel = [](std::uint8_t interlace) {
    return png_of(
        {header(1, 1, 8, 2, interlace), chunk("IDAT", deflated({0, 10, 20, 30})), chunk("IEND", {})});
  };
  const auto files = compare_png_files(write("a.png", pixel(0)), write("b.png", pixel(1)));
  ASSERT_TRUE(files.ok()) << files.error();
  EXPECT_EQ(files->found.pixels, 1);
  EXPECT_EQ(files->found.max, 0);
}

long peak_KiB() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return used.ru_maxrss;
}

// HOSTILE F11: two files of 1 MB took 2.1 GB.
TEST_F(CompareFiles, TakesLittleMemoryForTheLargestPictures) {
  constexpr std::size_t kSide = kMaxPngSide, kRow = 1 + kSide / 8;  // a bit for a pixel
  const fs::path black =
      write("black.png", png_of({header(kSide, kSide, 1, 0, 0), chunk("IDAT", deflated(Bytes(kRow * kSide))),
                                 chunk("IEND", {})}));
  const long before = peak_KiB();
  const auto files = compare_png_files(black, black);
  ASSERT_TRUE(files.ok()) << files.error();
  EXPECT_EQ(files->found.pixels, std::int64_t{kMaxPngSide} * kMaxPngSide);
  EXPECT_TRUE(files->found.equal());
  EXPECT_LT(peak_KiB() - before, 64 * 1024);
}

}  // namespace
}  // namespace polhode
