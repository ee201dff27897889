// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/inline_text.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::TextReport;

/// "b:", "i:", "c:", "m:" before bold, italic, code, mathematics; "<link>" and "/" behind; blocks by "|".
std::string shown(const RichText& text) {
  std::string all;
  for (const TextBlock& block : text) {
    if (!all.empty()) all += " | ";
    for (int i = 0; i < block.indent; ++i) all += '>';
    all += block.marker;
    for (const TextSpan& span : block.spans) {
      all += '[';
      if (span.kind == TextSpan::Kind::math) all += "m:";
      if (span.bold) all += "b:";
      if (span.italic) all += "i:";
      if (span.code) all += "c:";
      all += span.text;
      if (!span.link.empty()) all += '<' + span.link + '>';
      all += span.break_after ? "/]" : "]";
    }
  }
  return all;
}

struct Read {
  RichText text;
  std::vector<std::string> complaints;
};
Read read(const std::string& markdown, bool line = false) {
  TextReport at(markdown);
  const LocatedText located(at.source, at.source.text());
  Read result;
  result.text = line ? at.texts.line(located) : at.texts.passage(located);
  result.complaints = at.lines();
  return result;
}
std::string passage(const std::string& markdown) {
  const Read result = read(markdown);
  EXPECT_THAT(result.complaints, IsEmpty()) << markdown;
  return shown(result.text);
}

TEST(InlineText, HasEmphasisCodeAndLinks) {
  EXPECT_EQ(
      passage("a *b* **c** ***d*** `e` [f *g*](http://h) <https://i.org>"),
      "[a ][i:b][ ][b:c][ ][b:i:d][ ][c:e][ ][f <http://h>][i:g<http://h>][ ][https://i.org<https://i.org>]");
}

TEST(InlineText, HasFormulas) {
  EXPECT_EQ(passage("The tip of $\\vec L$, *in $S^*$*, **$x_1$**."),
            "[The tip of ][m:\\vec L][, ][i:in ][m:i:S^*][, ][m:b:x_1][.]");
  EXPECT_EQ(passage("$a*b$ and $c*d$ [$e$](f)"), "[m:a*b][ and ][m:c*d][ ][m:e<f>]");
}

TEST(InlineText, TakesMarksInFormulasForMathematics) {
  EXPECT_EQ(passage("$a_1$ and _b_ $[c](d)$ `$e$` $\\{f$"),
            "[m:a_1][ and ][i:b][ ][m:[c](d)][ ][c:$e$][ ][m:\\{f]");
}

TEST(InlineText, HasMarksOfFootnotesByNumber) {
  TextReport at("One[^a], _two_[^b], one again[^a].");
  const RichText text = at.texts.passage(LocatedText(at.source, at.source.text()));
  EXPECT_THAT(at.lines(), IsEmpty());
  std::string words;
  for (const TextSpan& span : text.at(0).spans) words += span.text;
  EXPECT_EQ(words, "One¹, two², one again¹.");
  const auto marks = at.texts.notes().finish_step();
  ASSERT_THAT(marks, SizeIs(2));
  EXPECT_EQ(marks[1].id, "b");
  EXPECT_EQ(marks[1].offset, 16U);
  EXPECT_THAT(at.texts.notes().finish_step(), IsEmpty());
  EXPECT_EQ(at.texts.notes().number_of("a", 0), 3) << "of another step of the stage";
}

TEST(InlineText, HasCitations) {
  TextReport at("As in [cite: LL, §35] and [cite:\nGO].");
  at.texts.citable() = {{"LL", false}, {"GO", false}, {"XX", false}};
  const RichText text = at.texts.passage(LocatedText(at.source, at.source.text()));
  EXPECT_THAT(at.lines(), IsEmpty());
  ASSERT_THAT(text.at(0).spans, SizeIs(5));
  EXPECT_EQ(text[0].spans[1].text, "[LL, §35]");
  EXPECT_EQ(text[0].spans[1].link, "cite:LL");
  EXPECT_EQ(text[0].spans[3].text, "[GO]");
  EXPECT_TRUE(at.texts.citable()["GO"]);
  EXPECT_FALSE(at.texts.citable()["XX"]);
  TextReport unknown("[cite: LK]");
  unknown.texts.citable() = {{"LL", false}};
  unknown.texts.passage(LocatedText(unknown.source, unknown.source.text()));
  EXPECT_THAT(unknown.lines(), ::testing::ElementsAre("1:1: error: no reference \"LK\" to cite (did you mean "
                                                      "\"LL\"?)"));
}

TEST(InlineText, HasNoMarksOfFootnotesInTitles) {
  TextReport at("A title[^1]");
  at.texts.line(LocatedText(at.source, at.source.text()));
  EXPECT_THAT(at.lines(),
              ::testing::ElementsAre("1:8: error: the mark of a footnote stands in text and call-outs only"));
}

TEST(InlineText, JoinsLinesAndBreaksWhereItIsTold) {
  EXPECT_EQ(passage("a\nb  \nc\\\nd"), "[a b/][c/][d]");
  EXPECT_EQ(passage("a $x\n+ y$ b"), "[a ][m:x\n+ y][ b]");
}

TEST(InlineText, HasParagraphsAndLists) {
  EXPECT_EQ(passage("One.\n\nTwo.\n\n- a\n- b\n  - c\n\n3. d\n4. e\n\n   f"),
            "[One.] | [Two.] | >•[a] | >•[b] | >>–[c] | >3.[d] | >4.[e] | >[f]");
  EXPECT_EQ(passage("1) a\n2) b"), ">1)[a] | >2)[b]");
  EXPECT_EQ(passage("- **Scalar.** $m$ is"), ">•[b:Scalar.][ ][m:m][ is]");
  EXPECT_EQ(passage("- \n- a"), ">• | >•[a]");
}

TEST(InlineText, HasEntitiesAndEscapes) {
  EXPECT_EQ(passage("a &amp; b&nbsp;c &#8594; &#x2260; \\$5 \\* \\_"),
            "[a ][&][ b][\xC2\xA0][c ][→][ ][≠][ ][$5 ][* ][_]");
}

TEST(InlineText, CountsTheBytesOfTheFile) {
  TextReport at("ωω\nab *cd* $x$ &amp; e");
  const RichText text = at.texts.passage(LocatedText(at.source, at.source.line(2)));
  ASSERT_THAT(text, SizeIs(1));
  for (const TextSpan& span : text[0].spans) {
    const std::string there = at.text.substr(span.source.begin, span.source.end - span.source.begin);
    EXPECT_EQ(there, span.text == "&" ? "&amp;" : span.text);
  }
  EXPECT_EQ(text[0].spans.front().source.begin, 5U);
}

TEST(InlineText, LinesOpenNoBlocks) {
  for (const char* text : {"- a", "1. a", "# a", "> a", "---", "```", "+++ a", "a\n---", "    a"}) {
    const Read result = read(text, true);
    EXPECT_THAT(result.complaints, IsEmpty()) << text;
    ASSERT_THAT(result.text, SizeIs(1)) << text;
    EXPECT_EQ(result.text[0].marker, "") << text;
    std::string words;
    for (const TextSpan& span : result.text[0].spans) words += span.text;
    EXPECT_EQ(words.find_first_not_of("-1.#>`+a \n"), std::string::npos) << words;
    EXPECT_EQ(words.empty(), false) << text;
  }
  EXPECT_EQ(shown(read("**a** $x$", true).text), "[b:a][ ][m:x]");
  EXPECT_EQ(shown(read("*a*", true).text), "[i:a]");
}

/// "l", "c", "r" for each column, then the rows by "/", their cells by "|".
std::string shown(const TextTable& table) {
  std::string all;
  for (const TextTable::Align align : table.columns)
    all += align == TextTable::Align::left ? 'l' : align == TextTable::Align::center ? 'c' : 'r';
  for (const auto& row : table.rows) {
    all += '/';
    for (const TextTable::Cell& cell : row) {
      if (&cell != row.data()) all += '|';
      for (const TextSpan& span : cell) all += (span.kind == TextSpan::Kind::math ? "m:" : "") + span.text;
    }
  }
  return all;
}

TEST(InlineText, HasTables) {
  const Read result = read(
      "Before.\n\n| body | $T/|L|$ | `a|b` |\n|:-----|:-:|--:|\n| *coin* | 1 \\| 2 | |\n  x | [y](http://z) "
      "| 3\n\nBehind.");
  EXPECT_THAT(result.complaints, IsEmpty());
  ASSERT_THAT(result.text, SizeIs(3));
  EXPECT_EQ(shown(result.text[1].table), "lcr/body|m:T/|L||a|b/coin|1 | 2|/x|y|3");
  EXPECT_EQ(result.text[1].table.rows[2][1].at(0).link, "http://z");
  EXPECT_TRUE(result.text[1].table.rows[1][0].at(0).italic);
  EXPECT_FALSE(result.text[0].is_table() || result.text[2].is_table());
}

// Two tables in one text; a table of a head alone.
TEST(InlineText, TablesEndWithTheirLines) {
  const Read result = read("| a |\n|---|\n\n| b | c |\n|---|---|\n| | d |\n");
  EXPECT_THAT(result.complaints, IsEmpty());
  ASSERT_THAT(result.text, SizeIs(2));
  EXPECT_EQ(shown(result.text[0].table), "l/a");
  EXPECT_EQ(shown(result.text[1].table), "ll/b|c/|d");
}

TEST(InlineText, TablesHaveALimitOfRows) {
  std::string table = "| a |\n|---|\n";
  for (std::size_t i = 0; i < kMaxTableRows; ++i) table += "| b |\n";
  EXPECT_THAT(read(table).complaints, IsEmpty());
  EXPECT_THAT(read(table + "| c |\n").complaints, SizeIs(1));
}

struct Refused {
  const char* markdown;
  const char* complaint;
};
class InlineTextRefuses : public ::testing::TestWithParam<Refused> {};
TEST_P(InlineTextRefuses, WithItsPlace) {
  const Read result = read(GetParam().markdown);
  ASSERT_THAT(result.complaints, SizeIs(1)) << GetParam().markdown;
  EXPECT_THAT(result.complaints[0], HasSubstr(GetParam().complaint));
}
INSTANTIATE_TEST_SUITE_P(
    All, InlineTextRefuses,
    ::testing::Values(
        Refused{"a ![b](c)", "1:3: error: images are not read"},
        Refused{"- a\n\n  | b | c |\n  |---|---|\n", "3:3: error: a table inside a list is not read"},
        Refused{"| a | b |\n|---|---|\n| c | d | e |", "3:1: error: this row has 3 cells, the head has 2"},
        Refused{"| a | b |\n|---|---|\n| c |", "3:1: error: this row has 1 cell, the head has 2"},
        Refused{"| a | b | c |\n|---|---|\n| c | d |",
                "1:1: error: the head has 3 cells, and the line below it 2"},
        Refused{"words\n| a | b |\n|---|---|", "3:1: error: no table comes of this line"},
        Refused{"|1|2|3|4|5|6|7|8|9|10|11|12|13|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|",
                "1:1: error: a table has at most 12 columns, and below its head 64 rows"},
        Refused{"ω <b>c", "1:3: error: HTML is not read"},
        Refused{"a\n\n<div>\nb", "3:1: error: HTML is not read"},
        Refused{"- a\n\n  > b", "3:3: error: a quote inside a text is not read"},
        Refused{"- a\n\n  ***\n", "3:3: error: a rule inside a text is not read"},
        Refused{"a &omegga; b", "1:3: error: unknown character &omegga;"},
        Refused{"a &#0; b", "1:3: error: unknown character &#0;"},
        Refused{"a &#155; b", "1:3: error: unknown character &#155;"},
        Refused{"ωω $\\vec{a$", "1:9: error: { is never closed"},
        Refused{"a [b](c$d$)", "1:8: error: a formula cannot stand here"},
        Refused{"a $b \\tag{1}$", "1:11: error: \\tag numbers a display"},
        Refused{"a $b & c$", "1:4: error: & and \\\\ make rows of a display"},
        Refused{"a $$x$$", "1:3: error: display mathematics stands in a fence"}));

TEST(InlineText, KeepsWhatIsLeftAfterAnError) {
  EXPECT_EQ(shown(read("a $\\nosuch$ **b**").text), "[a ][ ][b:b]");
}

TEST(InlineText, IsNotLongerThanTheLimit) {
  EXPECT_THAT(read(std::string(kMaxPassageBytes, 'a')).complaints, IsEmpty());
  EXPECT_THAT(read(std::string(kMaxPassageBytes + 1, 'a')).complaints,
              ElementsAre("1:1: error: this text has 16385 bytes, at most 16384 stand together (put it into "
                          "several steps with ---)"));
}

TEST(InlineText, FormulasOfALessonHaveALimit) {
  TextReport at(std::string(kMaxMathBytes, 'x') + '\n');
  const LocatedText tex(at.source, at.source.line(1));
  for (std::size_t bytes = 0; bytes + kMaxMathBytes <= kMaxLessonMathBytes; bytes += kMaxMathBytes)
    EXPECT_TRUE(at.texts.formula(tex));
  EXPECT_FALSE(at.texts.formula(tex));
  EXPECT_FALSE(at.texts.formula(tex));
  EXPECT_THAT(at.lines(), SizeIs(1)) << "said once";
}

TEST(InlineText, FormulasAreAsLongAsWhatTheirMacrosStandFor) {
  TextReport at("\\many");
  const LocatedText tex(at.source, at.source.line(1));
  at.texts.macros() = {{"many", {0, std::string(kMaxMathBytes, 'x')}}};
  std::size_t read = 0;
  while (read < 100 && at.texts.formula(tex)) ++read;
  EXPECT_EQ(read, kMaxLessonMathBytes / (kMaxMathBytes + 1 + std::string_view("\\many").size()));
  EXPECT_THAT(at.lines(), ElementsAre(HasSubstr("with the signs that macros stand for")));
}

TEST(InlineText, AFormulaThatIsTooLongIsSaidToBe) {
  TextReport at(std::string(kMaxLessonMathBytes, 'x'));
  EXPECT_FALSE(at.texts.formula(LocatedText(at.source, at.source.text())));
  ASSERT_THAT(at.lines(), SizeIs(1));
  TextReport again("x");
  EXPECT_TRUE(again.texts.formula(LocatedText(again.source, again.source.text())));
}

TEST(InlineText, MacrosStandInFormulas) {
  TextReport at("$\\w\\times\\v{r}$");
  at.texts.macros() = {{"w", {0, "\\vec\\omega"}}, {"v", {1, "\\vec{#1}"}}};
  at.texts.passage(LocatedText(at.source, at.source.text()));
  EXPECT_THAT(at.lines(), IsEmpty());
}

TEST(Captions, ArePlainTextWithFormulas) {
  TextReport at("$S$ stands *still* · $5");
  EXPECT_EQ(shown(at.texts.caption(LocatedText(at.source, at.source.text()))), "[m:S][ stands *still* · $5]");
  EXPECT_THAT(at.lines(), IsEmpty());
  TextReport escaped("a \\$5, \\$6 $x$");
  EXPECT_EQ(shown(escaped.texts.caption(LocatedText(escaped.source, escaped.source.text()))),
            "[a ][$5, ][$6 ][m:x]");
  TextReport bad("a $\\vecc L$");
  bad.texts.caption(LocatedText(bad.source, bad.source.text()));
  ASSERT_THAT(bad.lines(), SizeIs(1));
}

}  // namespace
}  // namespace polhode
