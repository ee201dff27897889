// SPDX-License-Identifier: MIT
#include "render/typeset/fonts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>

namespace polhode {
namespace {

namespace fs = std::filesystem;

class FontsTest : public testing::Test {
 protected:
  std::uint32_t glyph(char32_t character, Face face = Face::serif) const {
    return fonts_->glyph(face, character).value();
  }
  double ink(const GlyphMask& m) const { return std::accumulate(m.ink.begin(), m.ink.end(), 0.0) / 255.0; }

  Result<Fonts> fonts_ = Fonts::open();
  void SetUp() override { ASSERT_TRUE(fonts_.ok()) << fonts_.error(); }
};

TEST_F(FontsTest, TheSameGlyphGivesTheSameBytesWhateverCameBetween) {
  const GlyphMask first = fonts_->mask(Face::math, glyph(U'𝜔', Face::math), 37, 0.25, 0);
  fonts_->mask(Face::math, glyph(U'𝐿', Face::math), 91, 0.5, 0.75);
  fonts_->shape(Face::serif, "office");
  EXPECT_EQ(fonts_->mask(Face::math, glyph(U'𝜔', Face::math), 37, 0.25, 0).ink, first.ink);
}

TEST_F(FontsTest, NoInkIsCutOffAndNoneStandsOutsideItsBox) {
  for (char32_t c : U"Åjgq/∑*") {
    if (c == 0) continue;
    const Face face = c == U'∑' ? Face::math : Face::serif;
    const GlyphMask m = fonts_->mask(face, glyph(c, face), 60, 0.5, 0.25);
    const GlyphBox box = fonts_->box(face, glyph(c, face));
    // Pixels that the box touches, and one for outlines rounded to 1/64 px.
    EXPECT_NEAR(m.left, std::floor(60 * box.left + 0.5), 1) << static_cast<unsigned>(c);
    EXPECT_NEAR(m.left + m.width, std::ceil(60 * box.right + 0.5), 1);
    EXPECT_NEAR(-m.top, std::floor(-60 * box.top + 0.25), 1);
    EXPECT_NEAR(m.height - m.top, std::ceil(-60 * box.bottom + 0.25), 1);
  }
}

TEST_F(FontsTest, ShiftsMoveTheInk) {
  const auto middle = [&](double shift_x, double shift_y) {
    const GlyphMask m = fonts_->mask(Face::serif, glyph(U'g'), 40, shift_x, shift_y);
    double x = 0, y = 0;
    for (int row = 0; row < m.height; ++row)
      for (int column = 0; column < m.width; ++column) {
        const double weight = m.ink[static_cast<std::size_t>(row * m.width + column)] / 255.0;
        x += weight * (m.left + column), y += weight * (row - m.top);
      }
    return std::pair(x / ink(m), y / ink(m));
  };
  const auto [x, y] = middle(0, 0);
  for (double shift : {0.25, 0.5, 0.75}) {
    EXPECT_NEAR(middle(shift, 0).first, x + shift, 0.01) << "8 bits a pixel";
    EXPECT_NEAR(middle(0, shift).second, y + shift, 0.01);
  }
}

/// FreeType draws glyphs of some thousand pixels in parts only.
TEST_F(FontsTest, TheLargestGlyphsHaveTheInkOfSmallOnes) {
  const auto relative = [&](double size) {
    return ink(fonts_->mask(Face::serif, glyph(U'M'), size, 0.5, 0)) / (size * size);
  };
  // Outlines are rounded to 1/64 px; that of this letter is ten ems long.
  constexpr double kRounding = 10.0 / 128.0 / 1000.0;
  for (double size : {4000.0, 6000.0, 9000.0}) EXPECT_NEAR(relative(size), relative(1000), kRounding) << size;
}

TEST_F(FontsTest, LigaturesAndKerningComeWithTheShape) {
  EXPECT_EQ(fonts_->shape(Face::serif, "fi").size(), 1u);
  const auto pair = fonts_->shape(Face::serif, "AV");
  ASSERT_EQ(pair.size(), 2u);
  EXPECT_LT(pair[1].x, fonts_->advance(Face::serif, pair[0].id));
}

TEST_F(FontsTest, WhatAFaceLacksIsNoGlyphOfIt) {
  EXPECT_FALSE(fonts_->glyph(Face::sans, U'𝜔'));
  EXPECT_TRUE(fonts_->glyph(Face::math, U'𝜔'));
  ASSERT_EQ(fonts_->shape(Face::sans, "𝜔").size(), 1u);
  EXPECT_EQ(fonts_->shape(Face::sans, "𝜔")[0].id, 0u);
}

TEST_F(FontsTest, TheInkBoxHoldsGlyphsAndRules) {
  DisplayList list;
  EXPECT_TRUE(ink_box(list, *fonts_).empty());
  Glyph g;
  g.id = glyph(U'M');
  g.size = 100;
  g.x = 10;
  list.glyphs.push_back(g);
  const GlyphBox m = fonts_->box(Face::serif, g.id);
  EXPECT_DOUBLE_EQ(ink_box(list, *fonts_).x0, 10 + 100 * m.left);
  EXPECT_DOUBLE_EQ(ink_box(list, *fonts_).y0, -100 * m.top);
  Rule r;
  r.x0 = 0, r.x1 = 300, r.y0 = r.y1 = 20, r.thickness = 4;
  list.rules.push_back(r);
  EXPECT_DOUBLE_EQ(ink_box(list, *fonts_).y1, 22);
  EXPECT_DOUBLE_EQ(ink_box(list, *fonts_).x1, 300);
}

/// A folder for $POLHODE_FONTS, while it lives.
class ChosenFonts {
 public:
  ChosenFonts() {
    std::string name = (fs::temp_directory_path() / "polhode-fonts-XXXXXX").string();
    if (!mkdtemp(name.data())) std::abort();
    path_ = name;
    ::setenv("POLHODE_FONTS", path_.c_str(), 1);
  }
  ~ChosenFonts() {
    ::unsetenv("POLHODE_FONTS");
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ChosenFonts(const ChosenFonts&) = delete;
  ChosenFonts& operator=(const ChosenFonts&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// HOSTILE F16: a font that could not be read, for want of memory, was told to be missing.
TEST(FontFiles, ThatCannotBeReadAreNamed) {
  const ChosenFonts chosen;
  EXPECT_TRUE(Fonts::open().ok()) << "an empty folder takes nothing away";
  const fs::path damaged = chosen.path() / "texgyrepagella-italic.otf";
  std::ofstream(damaged) << "no font";
  const auto fonts = Fonts::open();
  ASSERT_FALSE(fonts.ok());
  EXPECT_THAT(fonts.error(), testing::AllOf(testing::HasSubstr("TeX Gyre Pagella Italic cannot be read"),
                                            testing::HasSubstr(damaged.string())));
}

}  // namespace
}  // namespace polhode
