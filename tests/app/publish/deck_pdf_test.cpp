// SPDX-License-Identifier: MIT
// PDF decks, as the programs of others read them.
#include "app/publish/deck.h"
#include "app/publish/pdf_text_layer.h"
#include "render/image/compare.h"
#include "render/image/png.h"
#include "tests/app/publish/example_deck.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using testing::HasSubstr;

class DeckPdf : public testing::Test {
 protected:
  void write(const Deck& deck) {
    const Result<DeckEnd> end = write_deck(file(), DeckKind::pdf, deck);
    ASSERT_TRUE(end) << end.error();
  }
  std::filesystem::path file() const { return folder_ / "deck.pdf"; }
  std::string said_by(const std::string& program, const std::string& after = "") const {
    return shell(fmt::format("{} '{}' {}", program, file().string(), after)).out;
  }
  ScratchFolder folder_;
};

#define NEED(program) \
  if (!has_program(program)) GTEST_SKIP() << program << " is not installed"

TEST_F(DeckPdf, IsWhole) {
  NEED("qpdf");
  write(example_deck(folder_));
  const ProgramRun run = shell("qpdf --check '" + file().string() + "'");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_THAT(run.out, HasSubstr("No syntax or stream encoding errors found"));
}

TEST_F(DeckPdf, SaysWhatItIs) {
  NEED("pdfinfo");
  Deck deck = example_deck(folder_);
  deck.title = "Euler’s “equations”: ω² − 1";
  write(deck);
  const std::string info = said_by("pdfinfo");
  EXPECT_THAT(info, HasSubstr("Title:           Euler’s “equations”: ω² − 1\n"));
  EXPECT_THAT(info, HasSubstr("Pages:           6\n"));
  EXPECT_THAT(info, HasSubstr("Page size:       960 x 540 pts\n"));
  EXPECT_THAT(info, HasSubstr("Tagged:          yes\n"));
  EXPECT_THAT(info, testing::Not(HasSubstr("Date")));
}

TEST_F(DeckPdf, TheWordsOfASlideAreOnItsPage) {
  NEED("pdftotext");
  Deck deck = example_deck(folder_);
  deck.slides[3].notes = {{StepNote::Kind::text, "ω² − 1 ≤ 𝐈₃ \"(5)\\\" – naïve 漢"},
                          {StepNote::Kind::item, "Item"}};
  write(deck);
  EXPECT_EQ(said_by("pdftotext -f 4 -l 4", "-"), "Stage 2\nω² − 1 ≤ 𝐈₃ \"(5)\\\" – naïve 漢\nItem\n\n\f");
  EXPECT_EQ(said_by("pdftotext -f 6 -l 6", "-"),
            "Stage 3, step 2 of 2\nWords of s6\nEquation (5): ω² − 1 equals 0.\n\n\f");
}

TEST_F(DeckPdf, HoldsMoreCharactersThanAFontHasCodes) {
  NEED("pdftotext");
  Deck deck = example_deck(folder_);
  std::string all;
  for (char32_t c = 0x4E00; c < 0x4E00 + 600; ++c)
    all += {static_cast<char>(0xE0 | c >> 12), static_cast<char>(0x80 | (c >> 6 & 0x3F)),
            static_cast<char>(0x80 | (c & 0x3F))};
  deck.slides[0].notes = {{StepNote::Kind::text, all}};
  write(deck);
  EXPECT_THAT(said_by("pdftotext -raw -f 1 -l 1", "-"), HasSubstr(all));
}

/// The picture of a page as a program draws it, at the resolution where it is as large as its slide.
Image drawn(const std::string& command, const std::filesystem::path& png) {
  const ProgramRun run = shell(command);
  EXPECT_EQ(run.code, 0) << run.err;
  const auto read = read_png(png);
  EXPECT_TRUE(read) << read.error();
  return read ? read->image : Image{};
}

TEST_F(DeckPdf, PagesHaveThePixelsOfTheSlides) {
  NEED("pdftoppm");
  const Deck deck = example_deck(folder_);
  write(deck);
  for (int page : {1, 6}) {
    // 180 px are 7.5 in.
    const Image image = drawn(fmt::format("pdftoppm -r 24 -f {0} -l {0} -png -singlefile '{1}' '{2}'", page,
                                          file().string(), (folder_ / "page").string()),
                              folder_ / "page.png");
    EXPECT_EQ(image.rgba, read_png(deck.slides[static_cast<std::size_t>(page - 1)].png)->image.rgba) << page;
  }
}

TEST_F(DeckPdf, AnotherReaderSeesTheSamePixels) {
  NEED("mutool");
  const Deck deck = example_deck(folder_);
  write(deck);
  const Image image = drawn(
      fmt::format("mutool draw -q -r 24 -o '{}' '{}' 4", (folder_ / "page.png").string(), file().string()),
      folder_ / "page.png");
  EXPECT_EQ(image.rgba, read_png(deck.slides[3].png)->image.rgba);
}

TEST_F(DeckPdf, TransparentPicturesStandOnWhitePaper) {
  NEED("mutool");
  Image image;
  image.size = {64, 32};
  for (int i = 0; i < 64 * 32; ++i)
    image.rgba.insert(image.rgba.end(), {200, 100, 0, static_cast<std::uint8_t>(i % 256)});
  Deck deck;
  deck.slides.push_back(slide_of(folder_, "clear", image));
  deck.dpi = 72;
  write(deck);
  const Image seen = drawn(
      fmt::format("mutool draw -q -r 72 -o '{}' '{}' 1", (folder_ / "page.png").string(), file().string()),
      folder_ / "page.png");
  ASSERT_EQ(seen.size, image.size);
  for (const int x : {0, 17, 40, 63}) {
    const std::uint8_t* from = image.pixel(x, 3);
    for (int c = 0; c < 3; ++c) {
      const double want = 255 + (from[c] - 255) * from[3] / 255.0;
      EXPECT_NEAR(seen.pixel(x, 3)[c], want, 2) << x;  // 8-bit rounding of alpha and of the sum
    }
  }
}

TEST_F(DeckPdf, TheOutlineHasStagesAndTheirSteps) {
  NEED("mutool");
  write(example_deck(folder_));
  const std::string outline = said_by("mutool show", "outline");
  EXPECT_THAT(outline,
              testing::ContainsRegex("\"1\\. Stage 1\".*#page=1&.*\n.*\"step 1 of 3\".*#page=1&.*\n"
                                     ".*\"step 2 of 3\".*#page=2&.*\n.*\"step 3 of 3\".*#page=3&.*\n"
                                     ".*\"2\\. Stage 2\".*#page=4&.*\n.*\"3\\. Stage 3\".*#page=5&"));
}

TEST_F(DeckPdf, PicturesHaveAlternativeTexts) {
  NEED("pdfinfo");
  write(example_deck(folder_));
  const std::string structure = said_by("pdfinfo -struct-text");
  EXPECT_THAT(structure, HasSubstr("Figure"));
  EXPECT_THAT(structure, HasSubstr("Words of s3"));
  NEED("qpdf");
  EXPECT_THAT(
      said_by("qpdf --qdf --object-streams=disable --no-original-object-ids", "-"),
      testing::AllOf(HasSubstr("/Alt (Alt of s1)"), HasSubstr("/Alt (Alt of s6)"), HasSubstr("/Lang (en)")));
}

TEST_F(DeckPdf, PagesAreAsLargeAsTheDotsSay) {
  NEED("pdfinfo");
  Deck deck = example_deck(folder_);
  deck.dpi = 72;
  write(deck);
  EXPECT_THAT(said_by("pdfinfo"), HasSubstr("Page size:       320 x 180 pts\n"));
  deck = example_deck(folder_, {240, 180});
  write(deck);
  EXPECT_THAT(said_by("pdfinfo"), HasSubstr("Page size:       720 x 540 pts\n"));
}

TEST_F(DeckPdf, RepeatsToTheByte) {
  const ScratchFolder other;
  const std::string pdf = written(example_deck(folder_), DeckKind::pdf);
  EXPECT_EQ(pdf, written(example_deck(other), DeckKind::pdf));
  EXPECT_THAT(pdf, testing::Not(HasSubstr(folder_.path().string())));
}

}  // namespace
}  // namespace polhode
