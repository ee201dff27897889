// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/callouts.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::TextReport;

std::vector<Callout> callouts_from(TextReport& at) {
  return read_callouts(1, at.source.line_count(), at.texts);
}

TEST(Callouts, StartAtTheirMarks) {
  TextReport at("> [!said] One\n> two\nlazy\n> [!meant]\n>\n> Three $x\n> + y$.");
  const auto callouts = callouts_from(at);
  EXPECT_THAT(at.lines(), IsEmpty());
  ASSERT_THAT(callouts, SizeIs(2));
  EXPECT_EQ(callouts[0].kind, Callout::Kind::said);
  EXPECT_EQ(callouts[0].markdown, "One\ntwo\nlazy");
  EXPECT_EQ(callouts[0].place, (SourcePlace{1, 3}));
  EXPECT_EQ(callouts[1].kind, Callout::Kind::meant);
  EXPECT_EQ(callouts[1].markdown, "Three $x\n+ y$.");
  EXPECT_EQ(callouts[1].place, (SourcePlace{4, 3}));
}

TEST(Callouts, ReportWhatIsNone) {
  TextReport plain("> Just a quote.\n> More.");
  EXPECT_THAT(callouts_from(plain), IsEmpty());
  EXPECT_THAT(
      plain.lines(),
      ElementsAre("1:3: error: a quote opens with the kind of call-out that it is: [!said] or another "
                  "(one of said, meant, note, example, quote, aside, derivation, notes)"));
  TextReport unknown("> [!meent] So.");
  callouts_from(unknown);
  EXPECT_THAT(unknown.lines(),
              ElementsAre("1:3: error: unknown call-out \"[!meent]\" (did you mean \"meant\"?)"));
  TextReport empty("> [!said]\n>");
  callouts_from(empty);
  EXPECT_THAT(empty.lines(), ElementsAre("1:3: error: this call-out is empty"));
}

std::string words_of(const RichText& text) {
  std::string words;
  for (const TextBlock& block : text)
    for (const TextSpan& span : block.spans) words += span.text;
  return words;
}

TEST(Callouts, AreOfEightKinds) {
  for (const CalloutNames& names : kCallouts) {
    if (names.kind == Callout::Kind::derivation) continue;
    TextReport at("> [!" + std::string(names.name) + "] Words.");
    const auto callouts = callouts_from(at);
    EXPECT_THAT(at.lines(), IsEmpty());
    ASSERT_THAT(callouts, SizeIs(1));
    EXPECT_EQ(callouts[0].kind, names.kind);
    EXPECT_EQ(words_of(callouts[0].text), "Words.");
    EXPECT_THAT(callouts[0].title, IsEmpty());
  }
}

TEST(Callouts, HaveTheNameOfWhoIsQuotedBelow) {
  TextReport at("> [!quote R. P. Feynman] Words.\n> More.");
  const auto callouts = callouts_from(at);
  EXPECT_THAT(at.lines(), IsEmpty());
  ASSERT_THAT(callouts, SizeIs(1));
  ASSERT_THAT(callouts[0].text, SizeIs(2));
  EXPECT_EQ(words_of({callouts[0].text[1]}), "— R. P. Feynman");
  EXPECT_EQ(callouts[0].markdown, "Words.\nMore.");
}

TEST(Callouts, OfADerivationHaveATitle) {
  TextReport at("> [!derivation Of $[\\vec a]_\\times$, by parts] Steps.");
  const auto callouts = callouts_from(at);
  EXPECT_THAT(at.lines(), IsEmpty());
  ASSERT_THAT(callouts, SizeIs(1));
  EXPECT_EQ(words_of(callouts[0].title), "Of [\\vec a]_\\times, by parts");
  EXPECT_EQ(words_of(callouts[0].text), "Steps.");
  TextReport untitled("> [!derivation] Steps.");
  callouts_from(untitled);
  EXPECT_THAT(untitled.lines(),
              ElementsAre("1:3: error: a derivation has a title, which stands for it on pages "
                          "(write [!derivation What is derived])"));
  TextReport titled("> [!note Title] Steps.\n> [!said");
  callouts_from(titled);
  EXPECT_THAT(titled.lines(),
              ElementsAre("1:3: error: only a quote and a derivation have more than their kind in brackets "
                          "(write [!note] Title)",
                          "2:3: error: the kind of this call-out is never closed (end it with ])"));
}

TEST(Callouts, ReportMathematicsAtItsPlace) {
  TextReport at("> [!said] One\n> $\\vec{a$");
  callouts_from(at);
  EXPECT_THAT(at.lines(), ElementsAre("2:8: error: { is never closed"));
}

TEST(Callouts, EndAtTheLimit) {
  std::string text;
  for (std::size_t i = 0; i < kMaxCallouts; ++i) text += "> [!said] x\n";
  TextReport good(text);
  EXPECT_THAT(callouts_from(good), SizeIs(kMaxCallouts));
  EXPECT_THAT(good.lines(), IsEmpty());
  TextReport bad(text + "> [!said] x\n> [!said] x");
  callouts_from(bad);
  EXPECT_THAT(bad.lines(), ElementsAre("65:3: error: a quote has at most 64 call-outs"));
}

}  // namespace
}  // namespace polhode
