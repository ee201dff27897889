// SPDX-License-Identifier: MIT
#include "app/export/picture_writer.h"

#include "base/sha256.h"
#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace polhode {
namespace {

using testing::HasSubstr;

PictureFile picture(const std::string& name, std::uint8_t shade) {
  Image image = Image::blank({40, 30});
  image.rgba[0] = shade;
  return {name, std::move(image), {{{"polhode:stage", name}}, 0}};
}

std::string name_of(int i) { return std::to_string(i) + ".png"; }

TEST(PictureWriter, WritesEveryPictureUnderItsName) {
  const ScratchFolder scratch;
  constexpr int kPictures = 20;
  PictureWriter writer(scratch.path(), PngPacking::fast, Durability::rename_only);
  for (int i = 0; i < kPictures; ++i)
    ASSERT_TRUE(writer.put(picture(name_of(i), static_cast<std::uint8_t>(i))).ok());
  ASSERT_TRUE(writer.finish().ok());
  EXPECT_EQ(names_in(scratch.path()).size(), std::size_t{kPictures});
  for (int i = 0; i < kPictures; ++i) {
    const auto png = read_png(scratch / name_of(i));
    ASSERT_TRUE(png.ok()) << png.error();
    EXPECT_EQ(png->image.rgba[0], i);
    EXPECT_EQ(png->metadata.text[0].second, name_of(i));
  }
}

TEST(PictureWriter, RepeatsTheBytesOfThePictureBefore) {
  const ScratchFolder scratch;
  PictureWriter writer(scratch.path(), PngPacking::fast, Durability::rename_only);
  ASSERT_TRUE(writer.put(picture("a.png", 1)).ok());
  ASSERT_TRUE(writer.put({"b.png", std::nullopt, {}}).ok());
  ASSERT_TRUE(writer.put({"c.png", std::nullopt, {}}).ok());
  ASSERT_TRUE(writer.put(picture("d.png", 2)).ok());
  ASSERT_TRUE(writer.finish().ok());
  EXPECT_EQ(text_of(scratch / "a.png"), text_of(scratch / "b.png"));
  EXPECT_EQ(text_of(scratch / "a.png"), text_of(scratch / "c.png"));
  EXPECT_NE(text_of(scratch / "a.png"), text_of(scratch / "d.png"));
}

TEST(PictureWriter, TellsTheChecksumOfEveryFile) {
  const ScratchFolder scratch;
  PictureWriter writer(scratch.path(), PngPacking::fast, Durability::rename_only);
  ASSERT_TRUE(writer.put(picture("a.png", 1)).ok());
  ASSERT_TRUE(writer.put({"b.png", std::nullopt, {}}).ok());
  ASSERT_TRUE(writer.put(picture("c.png", 2)).ok());
  ASSERT_TRUE(writer.finish().ok());
  EXPECT_EQ(writer.checksums().size(), 3u);
  for (const auto& [name, sha256] : writer.checksums())
    EXPECT_EQ(sha256, sha256_hex(text_of(scratch / name)));
}

// HOSTILE F7: who may write into the folder could have any file of the exporter replaced, or keep it waiting.
TEST(PictureWriter, ReplacesLinksAndPipesUnderAPicturesName) {
  const ScratchFolder scratch, elsewhere;
  write_text(elsewhere / "precious", "precious");
  std::filesystem::create_symlink(elsewhere / "precious", scratch / "a.png");
  std::filesystem::create_symlink(elsewhere / "dangling", scratch / "b.png");
  ASSERT_EQ(mkfifo((scratch / "c.png").c_str(), 0600), 0);
  PictureWriter writer(scratch.path(), PngPacking::fast, Durability::rename_only);
  ASSERT_TRUE(writer.put(picture("a.png", 1)).ok());
  ASSERT_TRUE(writer.put({"b.png", std::nullopt, {}}).ok());
  ASSERT_TRUE(writer.put(picture("c.png", 2)).ok());
  ASSERT_TRUE(writer.finish().ok());
  EXPECT_EQ(text_of(elsewhere / "precious"), "precious");
  EXPECT_FALSE(std::filesystem::exists(elsewhere / "dangling"));
  for (const std::string& name : names_in(scratch.path())) {
    EXPECT_FALSE(std::filesystem::is_symlink(scratch / name)) << name;
    EXPECT_TRUE(read_png(scratch / name).ok()) << name;
  }
}

TEST(PictureWriter, TheFirstErrorStopsItAndStays) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "2.png");
  PictureWriter writer(scratch.path(), PngPacking::fast, Durability::rename_only);
  for (int i = 0; i < 10; ++i) static_cast<void>(writer.put(picture(name_of(i), 1)));  // never waits for ever
  const Status status = writer.finish();
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error(), HasSubstr("2.png"));
  EXPECT_EQ(writer.put(picture("x.png", 1)).error(), status.error());
  EXPECT_THAT(names_in(scratch.path()), testing::ElementsAre("0.png", "1.png", "2.png"));
}

TEST(PictureWriter, AnImageThatCannotBeEncodedIsAnError) {
  const ScratchFolder scratch;
  PictureWriter writer(scratch.path(), PngPacking::fast, Durability::rename_only);
  PictureFile broken = picture("a.png", 1);
  broken.image->rgba.pop_back();
  static_cast<void>(writer.put(std::move(broken)));
  const Status status = writer.finish();
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error(), HasSubstr("a.png"));
}

TEST(PictureWriter, GoesAwayWithPicturesWaiting) {
  const ScratchFolder scratch;
  {
    PictureWriter writer(scratch.path(), PngPacking::fast, Durability::rename_only);
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(writer.put(picture(name_of(i), 1)).ok());
  }
  for (const std::string& name : names_in(scratch.path()))
    EXPECT_TRUE(read_png(scratch / name).ok()) << name << " is not whole";
}

}  // namespace
}  // namespace polhode
