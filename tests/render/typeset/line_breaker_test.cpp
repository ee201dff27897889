// SPDX-License-Identifier: MIT
#include "render/typeset/line_breaker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using Edge = LineShape::Edge;

std::vector<LinePart> words(const std::vector<double>& widths) {
  std::vector<LinePart> parts;
  for (const double width : widths) parts.push_back({width, 1.0, 0.5, 0.25, 0.0, false});
  return parts;
}

std::vector<LinePart> random_words(std::mt19937& random, std::size_t count) {
  std::vector<LinePart> parts;
  for (std::size_t i = 0; i < count; ++i) {
    const bool hyphen = random() % 8 == 0;
    parts.push_back({1.0 + static_cast<double>(random() % 80) / 10.0, hyphen ? 0.0 : 1.0, hyphen ? 0.0 : 0.5,
                     hyphen ? 0.0 : 0.25, hyphen ? 60.0 : 0.0, random() % 40 == 0});
  }
  return parts;
}

/// Length of the line [begin, end) without the space at its end; added up from the end, as break_lines does,
/// so that both round alike.
double line_length(const std::vector<LinePart>& parts, std::size_t begin, std::size_t end) {
  double length = parts[end - 1].width;
  for (std::size_t i = end - 1; i-- > begin;) length = length + parts[i].width + parts[i].space;
  return length;
}

/// As many parts on each line as it holds.
std::vector<std::size_t> first_fit(const std::vector<LinePart>& parts, double width) {
  std::vector<std::size_t> ends;
  std::size_t begin = 0;
  for (std::size_t end = 1; end <= parts.size(); ++end) {
    const bool more =
        end < parts.size() && !parts[end - 1].ends_line && line_length(parts, begin, end + 1) <= width;
    if (more) continue;
    ends.push_back(end);
    begin = end;
  }
  return ends;
}

/// The least demerits of all ways to break, by trying each.
double least_demerits(const std::vector<LinePart>& parts, const LineShape& shape) {
  double least = std::numeric_limits<double>::infinity();
  for (unsigned way = 0; way < (1U << (parts.size() - 1)); ++way) {
    std::vector<std::size_t> ends;
    std::size_t begin = 0;
    bool possible = true;
    for (std::size_t end = 1; end <= parts.size(); ++end) {
      const bool ends_here = end == parts.size() || ((way >> (end - 1)) & 1U) != 0;
      possible = possible && (ends_here || !parts[end - 1].ends_line);
      if (!ends_here) continue;
      possible = possible && line_length(parts, begin, end) <= shape.width;
      ends.push_back(end);
      begin = end;
    }
    if (possible) least = std::min(least, demerits(parts, ends, shape));
  }
  return least;
}

TEST(BreakLines, TakesOneLineIfAllFits) {
  EXPECT_THAT(break_lines(words({3, 4, 5}), {20.0, Edge::ragged, 4.0}), ElementsAre(3));
  EXPECT_TRUE(break_lines({}, {20.0, Edge::ragged, 4.0}).empty());
}

TEST(BreakLines, EndsLinesWhereItMust) {
  std::vector<LinePart> parts = words({3, 4, 5});
  parts[0].ends_line = true;
  EXPECT_THAT(break_lines(parts, {20.0, Edge::ragged, 4.0}), ElementsAre(1, 3));
}

TEST(BreakLines, LeavesALineShorterIfTheNextGains) {
  // First fit: "9 | 5 4 | 9"; its first line lacks 1 and its second none, but a hyphen ends the second.
  std::vector<LinePart> parts = words({4, 5, 4, 5, 9});
  EXPECT_THAT(break_lines(parts, {10.0, Edge::ragged, 3.0}), ElementsAre(2, 4, 5));
  parts[1].penalty = 1000.0;
  EXPECT_THAT(break_lines(parts, {10.0, Edge::ragged, 3.0}), ElementsAre(1, 3, 4, 5));
}

TEST(BreakLines, AvoidsALastLineOfOneWord) {
  const std::vector<LinePart> parts = words({4, 4, 4, 4, 4, 4, 4});
  const auto ends = break_lines(parts, {14.5, Edge::ragged, 6.0});
  EXPECT_THAT(ends, ElementsAre(3, 5, 7));
}

TEST(BreakLines, BalancesHeadingsWithoutMoreLines) {
  const std::vector<LinePart> parts = words({4, 4, 4, 4, 4, 4, 4});
  EXPECT_THAT(break_lines(parts, {30.0, Edge::balanced, 6.0}), ElementsAre(4, 7));
  EXPECT_THAT(break_lines(parts, {34.0, Edge::balanced, 6.0}), ElementsAre(7));
}

TEST(BreakLines, PutsAWideWordOnItsOwnLine) {
  EXPECT_THAT(break_lines(words({3, 30, 3}), {10.0, Edge::ragged, 3.0}), ElementsAre(1, 2, 3));
}

class EveryEdge : public ::testing::TestWithParam<Edge> {};

TEST_P(EveryEdge, NoWayToBreakIsBetter) {
  std::mt19937 random(3);
  for (int i = 0; i < 60; ++i) {
    const std::vector<LinePart> parts = random_words(random, 2 + random() % 11);
    const LineShape shape{15.0, GetParam(), 4.0};
    const double found = demerits(parts, break_lines(parts, shape), shape);
    // Sums of up to 12 lines, each with one rounding. Justified lines may also shrink, which is better still.
    EXPECT_LE(found, least_demerits(parts, shape) * (1.0 + 12 * 2.3e-16)) << i;
  }
}

TEST_P(EveryEdge, FirstFitIsNeverBetter) {
  std::mt19937 random(5);
  for (int i = 0; i < 300; ++i) {
    const std::vector<LinePart> parts = random_words(random, 60);
    const LineShape shape{30.0, GetParam(), 6.0};
    const auto ends = break_lines(parts, shape);
    EXPECT_LE(demerits(parts, ends, shape), demerits(parts, first_fit(parts, shape.width), shape));
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
      ASSERT_LT(begin, end);
      double shrink = 0.0;
      for (std::size_t p = begin; p + 1 < end; ++p) shrink += parts[p].shrink;
      EXPECT_LE(line_length(parts, begin, end) - (GetParam() == Edge::justified ? shrink : 0.0), 30.0 + 1e-6);
      begin = end;
    }
    EXPECT_EQ(begin, parts.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Edges, EveryEdge, ::testing::Values(Edge::ragged, Edge::justified, Edge::balanced));

TEST(SpaceChange, MakesJustifiedLinesJustSoLong) {
  std::mt19937 random(9);
  const LineShape shape{30.0, Edge::justified, 6.0};
  for (int i = 0; i < 100; ++i) {
    const std::vector<LinePart> parts = random_words(random, 60);
    std::size_t begin = 0;
    for (const std::size_t end : break_lines(parts, shape)) {
      const double change = space_change(parts, begin, end, shape);
      double length = line_length(parts, begin, end);
      double spaces = 0.0;
      for (std::size_t p = begin; p + 1 < end; ++p) {
        length += change * (change < 0.0 ? parts[p].shrink : parts[p].stretch);
        spaces += parts[p].space;
      }
      const bool last = end == parts.size() || parts[end - 1].ends_line;
      if (!last && spaces > 0.0) {
        EXPECT_NEAR(length, 30.0, 1e-6);
      }
      EXPECT_LE(length, 30.0 + 1e-6);
      begin = end;
    }
  }
}

}  // namespace
}  // namespace polhode
