// SPDX-License-Identifier: MIT
// The text of an HTML deck; how it behaves is in deck_browser_test.cpp.
#include "app/publish/deck.h"
#include "render/image/png.h"
#include "tests/app/publish/example_deck.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace polhode {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(DeckHtml, HasEverySlideOnceWithItsWords) {
  const ScratchFolder folder;
  const std::string html = written(example_deck(folder), DeckKind::html);
  EXPECT_EQ(count(html, "src=\"data:image/webp;base64,"), 6u);
  EXPECT_EQ(count(html, "<section class=\"slide\""), 6u);
  for (const char* name : {"s1", "s2", "s3", "s4", "s5", "s6"}) {
    EXPECT_EQ(count(html, std::string("id=\"") + name + "\""), 1u);
    EXPECT_THAT(html, HasSubstr(std::string("alt=\"Alt of ") + name + "\""));
    EXPECT_THAT(html, HasSubstr(std::string("<p class=\"text\">Words of ") + name + "</p>"));
  }
  EXPECT_THAT(html, HasSubstr("<title>Examples</title>"));
  EXPECT_THAT(html, HasSubstr("<html lang=\"en\">"));
  EXPECT_THAT(html, HasSubstr("aria-label=\"Stage 3, step 2 of 2\""));
  EXPECT_THAT(html, HasSubstr("aria-label=\"Stage 2\""));
  EXPECT_THAT(html, HasSubstr("width=\"320\" height=\"180\""));
  EXPECT_THAT(html, Not(HasSubstr("{{")));
  EXPECT_THAT(html, testing::EndsWith("</html>\n"));
}

TEST(DeckHtml, NeedsNothingFromElsewhere) {
  const ScratchFolder folder;
  const std::string html = written(example_deck(folder), DeckKind::html);
  EXPECT_FALSE(std::regex_search(html, std::regex("https?:|src=\"(?!data:)|@import|url\\(|<link")));
  EXPECT_THAT(html, HasSubstr("default-src 'none'; img-src data:; style-src 'sha256-"));
  EXPECT_THAT(html, Not(HasSubstr("unsafe")));
  EXPECT_THAT(html, Not(HasSubstr(folder.path().string())));
}

TEST(DeckHtml, NoTextCanBecomeMarkup) {
  const ScratchFolder folder;
  Deck deck = example_deck(folder);
  const std::string bad = "</script></title></style>\"'><img src=x onerror=alert(1)><!-- {{slides}}";
  const auto marks = [](const Deck& of) {
    const std::string html = written(of, DeckKind::html);
    return std::pair(count(html, "<"), count(html, "\""));
  };
  const auto want = marks(deck);
  deck.title = deck.slides[0].title = deck.slides[1].part = deck.slides[2].alt = bad;
  deck.slides[3].notes[0].text = bad;
  EXPECT_EQ(marks(deck), want);
  EXPECT_THAT(written(deck, DeckKind::html), Not(HasSubstr("<img src=x")));
}

TEST(DeckHtml, APrintedPageIsAsLargeAsTheSlide) {
  const ScratchFolder folder;
  Deck deck = example_deck(folder);
  EXPECT_THAT(written(deck, DeckKind::html), HasSubstr("@page { size: 13.3333in 7.5000in; margin: 0; }"));
  deck.dpi = 160;
  EXPECT_THAT(written(deck, DeckKind::html), HasSubstr("@page { size: 2.0000in 1.1250in; margin: 0; }"));
}

TEST(DeckHtml, TheThemeColorsWhatIsAroundTheSlides) {
  const ScratchFolder folder;
  Deck deck = example_deck(folder);
  EXPECT_THAT(written(deck, DeckKind::html), HasSubstr("--paper: #fbfaf6;"));
  deck.theme = Theme::dark;
  const std::string html = written(deck, DeckKind::html);
  EXPECT_THAT(html, HasSubstr("--paper: #1b1e23;"));
  EXPECT_THAT(html, HasSubstr("<meta name=\"color-scheme\" content=\"dark\">"));
}

TEST(DeckHtml, RepeatsToTheByte) {
  const ScratchFolder one, other;
  EXPECT_EQ(written(example_deck(one), DeckKind::html), written(example_deck(other), DeckKind::html));
}

TEST(DeckHtml, ADeckOfNothingIsAPageToo) {
  EXPECT_THAT(written(Deck{.title = "Nothing", .slides = {}}, DeckKind::html), HasSubstr("<h1>Nothing</h1>"));
}

TEST(Deck, ADamagedPictureLeavesNoFileAndIsNamed) {
  for (const DeckKind kind : {DeckKind::html, DeckKind::pdf, DeckKind::pptx}) {
    const ScratchFolder folder, out;
    const Deck deck = example_deck(folder);
    const std::string png = text_of(deck.slides[4].png);
    write_text(deck.slides[4].png, png.substr(0, png.size() / 2));
    const Result<DeckEnd> end = write_deck(out / "deck", kind, deck);
    ASSERT_FALSE(end);
    EXPECT_THAT(end.error(), testing::AllOf(HasSubstr("s5.png"), HasSubstr("truncated or damaged")));
    EXPECT_THAT(names_in(out.path()), testing::IsEmpty());
    std::filesystem::remove(deck.slides[4].png);
    EXPECT_THAT(write_deck(out / "deck", kind, deck).error(), HasSubstr("cannot read "));
  }
}

TEST(Deck, CanBeStoppedAtAnySlideAndLeavesTheOldFile) {
  for (const DeckKind kind : {DeckKind::html, DeckKind::pdf, DeckKind::pptx})
    for (const std::size_t last : {0u, 3u, 5u}) {
      const ScratchFolder folder, out;
      const Deck deck = example_deck(folder);
      write_text(out / "deck", "old");
      const auto go_on = [&](std::size_t slide) { return slide < last; };
      const Result<DeckEnd> end = write_deck(out / "deck", kind, deck, Durability::rename_only, go_on);
      ASSERT_TRUE(end) << end.error();
      EXPECT_EQ(*end, DeckEnd::stopped);
      EXPECT_EQ(text_of(out / "deck"), "old");
      EXPECT_THAT(names_in(out.path()), testing::ElementsAre("deck"));
    }
}

TEST(Deck, TheKindIsInTheName) {
  EXPECT_EQ(deck_kind_of("a/b.html"), DeckKind::html);
  EXPECT_EQ(deck_kind_of("b.HTM"), DeckKind::html);
  EXPECT_EQ(deck_kind_of("b.Pdf"), DeckKind::pdf);
  EXPECT_EQ(deck_kind_of("b.pptx"), DeckKind::pptx);
  for (const char* other : {"b", "b.pdf.png", ".html", "pdf", ""})
    EXPECT_EQ(deck_kind_of(other), std::nullopt);
}

TEST(Deck, PaperIsThatOfASlideShowOrAsManyDotsSay) {
  const auto expect = [](PaperSize paper, double width_in, double height_in) {
    EXPECT_DOUBLE_EQ(paper.width_in, width_in);
    EXPECT_DOUBLE_EQ(paper.height_in, height_in);
  };
  expect(paper_size({1920, 1080}, 0), 7.5 * 16 / 9, 7.5);
  expect(paper_size({1600, 1200}, 0), 10, 7.5);
  expect(paper_size({1080, 1920}, 0), 7.5, 7.5 * 16 / 9);
  expect(paper_size({3508, 2480}, 300), 3508 / 300.0, 2480 / 300.0);
}

TEST(DeckHtml, HasLinksInItsNotesAndItsAuthor) {
  const ScratchFolder folder;
  Deck deck = example_deck(folder);
  EXPECT_THAT(written(deck, DeckKind::html), Not(HasSubstr("name=\"author\"")));
  deck.author = "A <B>";
  deck.slides[0].notes = {{StepNote::Kind::text, "a < \"two\" > b", {{4, 9, "#s2"}}}};
  const std::string html = written(deck, DeckKind::html);
  EXPECT_THAT(html, HasSubstr("<meta name=\"author\" content=\"A &lt;B&gt;\">\n<title>"));
  EXPECT_THAT(html, HasSubstr("<p class=\"text\">a &lt; <a href=\"#s2\">&quot;two&quot;</a> &gt; b</p>"));
}

}  // namespace
}  // namespace polhode
