// SPDX-License-Identifier: MIT
#include "lessons/reader/markdown/markdown.h"

#include "lessons/reader/reader.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::TextReport;

// "heading 1-1", "prose 3-4", ...
std::vector<std::string> blocks_of(const std::string& text) {
  TextReport at(text);
  const char* const names[] = {"heading", "rule", "fence", "quote", "prose"};
  std::vector<std::string> lines;
  for (const MarkdownBlock& block : read_markdown(at.source, 1, at.report).blocks) {
    lines.push_back(std::string(names[static_cast<int>(block.kind)]) + ' ' +
                    std::to_string(block.first_line) + '-' + std::to_string(block.last_line));
  }
  return lines;
}

TEST(ReadMarkdown, TellsTheBlocksAndTheirLines) {
  EXPECT_THAT(
      blocks_of("# Title {t}\n\nText\nmore.\n\n```math a\nx\n```\n---\n> quote\nlazy\n> more\n\n- list\n"),
      ElementsAre("heading 1-1", "prose 3-4", "fence 6-8", "rule 9-9", "quote 10-12", "prose 14-14"));
}

TEST(ReadMarkdown, FindsBlocksWithoutText) {
  EXPECT_THAT(blocks_of("#\n```\n```\n***\n- - -\n>\n\n~~~ math\n~~~\n___"),
              ElementsAre("heading 1-1", "fence 2-3", "rule 4-4", "rule 5-5", "quote 6-6", "fence 8-9",
                          "rule 10-10"));
}

TEST(ReadMarkdown, TakesParagraphsAndListsTogetherAsProse) {
  EXPECT_THAT(blocks_of("One.\n\n- a\n- b\n\nTwo.\n\n\n# T\n"), ElementsAre("prose 1-6", "heading 9-9"));
}

TEST(ReadMarkdown, KeepsWhatIsInAFenceInTheFence) {
  EXPECT_THAT(blocks_of("````math a\n# no\n---\n```\n> no\n````\nText"),
              ElementsAre("fence 1-6", "prose 7-7"));
}

TEST(ReadMarkdown, TakesAFenceToTheEndIfItIsNotClosed) {
  TextReport at("```math a\nx\n\ny");
  const auto reading = read_markdown(at.source, 1, at.report);
  ASSERT_EQ(reading.blocks.size(), 1U);
  EXPECT_FALSE(reading.blocks[0].closed);
  EXPECT_EQ(reading.blocks[0].last_line, 4);
}

TEST(ReadMarkdown, SaysWhenARuleMadeAHeading) {
  TextReport at("Text\nmore\n---\n\nText");
  const auto reading = read_markdown(at.source, 1, at.report);
  ASSERT_EQ(reading.blocks.size(), 2U);
  EXPECT_TRUE(reading.blocks[0].underlined);
  EXPECT_EQ(reading.blocks[0].first_line, 1);
  EXPECT_EQ(reading.blocks[0].last_line, 3);
  EXPECT_EQ(reading.blocks[1].first_line, 5);
}

TEST(ReadMarkdown, InlineMarksMakeNoBlocks) {
  EXPECT_THAT(blocks_of("<div>\n# no html\n</div>\n\n[a]: b\n\n    indented\n"),
              ElementsAre("prose 1-1", "heading 2-2", "prose 3-7"));
}

TEST(ReadMarkdown, ReportsFencesAndHeadingsInsideOtherBlocks) {
  TextReport at("- a\n\n  ```math x\n  y\n  ```\n\n> # T\n");
  read_markdown(at.source, 1, at.report);
  const auto lines = at.lines();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].substr(0, 4), "3:1:");
  EXPECT_EQ(lines[1].substr(0, 4), "7:1:");
}

TEST(ReadMarkdown, EndsAtTheLimitOfNesting) {
  std::string text;
  for (int depth = 0; depth < kMaxNesting; ++depth)
    text += std::string(2 * static_cast<std::size_t>(depth), ' ') + "- a\n";
  TextReport good(text);
  EXPECT_TRUE(read_markdown(good.source, 1, good.report).complete);
  EXPECT_THAT(good.lines(), IsEmpty());
  TextReport bad(text + std::string(2 * kMaxNesting, ' ') + "- a\n");
  EXPECT_FALSE(read_markdown(bad.source, 1, bad.report).complete);
  EXPECT_EQ(bad.lines().size(), 1U);
}

TEST(MarkdownNesting, CountsTheMarksAtTheStartOfALine) {
  EXPECT_EQ(first_markdown_nested_deeper("> > a", 2), std::nullopt);
  EXPECT_EQ(first_markdown_nested_deeper("> > > a", 2), 4U);
  EXPECT_EQ(first_markdown_nested_deeper("a\n1. - > a", 2), 7U);
  EXPECT_EQ(first_markdown_nested_deeper("- - - - - - -", 2), std::nullopt) << "a rule";
  EXPECT_EQ(first_markdown_nested_deeper("a > > > >", 2), std::nullopt);
}

TEST(WithoutInlineMarks, KeepsBlocksAndPlaces) {
  EXPECT_EQ(without_inline_marks("# *a* [b]\n> `c`\n```math\n***\n- - -\n1. <d>\nTitle\n==="),
            "# xax xbx\n> xcx\n```math\n***\n- - -\n1. xdx\nTitle\n===");
}

TEST(HeadingLevel, CountsTheHashes) {
  EXPECT_EQ(heading_level("# a"), 1);
  EXPECT_EQ(heading_level("   ### a"), 3);
  EXPECT_EQ(heading_level("#"), 1);
  EXPECT_EQ(heading_level("#a"), 0);
  EXPECT_EQ(heading_level("####### a"), 0);
  EXPECT_EQ(heading_level("    # a"), 0);
}

TEST(IsRuleLine, NeedsThreeOfOneMark) {
  for (const char* rule : {"---", "***", "___", "- - -", "   -----  "})
    EXPECT_TRUE(is_rule_line(rule)) << rule;
  for (const char* none : {"--", "-*-", "===", "--- a", "    ---", ""})
    EXPECT_FALSE(is_rule_line(none)) << none;
}

}  // namespace
}  // namespace polhode
