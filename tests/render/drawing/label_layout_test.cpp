// SPDX-License-Identifier: MIT
#include "render/drawing/label_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

const PixelBox kFrame{0, 0, 800, 450};

TEST(LabelLayout, LabelsOfOneSpotDoNotOverlap) {
  const std::vector<LabelRequest> labels(5,
                                         {.anchor = {400, 225}, .width = 80, .height = 24, .leader = true});
  const auto placed = place_labels(labels, {}, {}, kFrame);
  for (std::size_t i = 0; i < placed.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_EQ(placed[i].box.overlap(placed[k].box), 0.0) << i << ' ' << k;
}

TEST(LabelLayout, LabelsStayInTheFrame) {
  for (const Vec2& anchor : {Vec2(2, 2), Vec2(798, 448), Vec2(2, 448), Vec2(798, 225)}) {
    const auto placed = place_labels({{.anchor = anchor, .width = 90, .height = 24}}, {}, {}, kFrame);
    EXPECT_NEAR(placed[0].box.overlap(kFrame), 90.0 * 24.0, 1e-6) << anchor.transpose();
  }
}

TEST(LabelLayout, LabelsOfWhatLiesJustOutsideAreNotCut) {
  for (const Vec2& anchor : {Vec2(850, 225), Vec2(-40, 225), Vec2(400, 465), Vec2(820, -10)}) {
    const auto placed = place_labels({{.anchor = anchor, .width = 90, .height = 24}}, {}, {}, kFrame);
    EXPECT_NEAR(placed[0].box.overlap(kFrame), 90.0 * 24.0, 1e-6) << anchor.transpose();
  }
}

TEST(LabelLayout, LabelsKeepOffTakenBoxes) {
  const PixelBox panel{300, 180, 560, 270};
  const auto placed =
      place_labels({{.anchor = {300, 225}, .width = 80, .height = 24, .leader = true}}, {}, {panel}, kFrame);
  EXPECT_EQ(placed[0].box.overlap(panel), 0.0);
}

TEST(LabelLayout, LabelsPreferTheSideWithoutLines) {
  std::vector<Vec2> line;  // everything to the right of the anchor is busy
  for (int x = 405; x < 560; x += 6)
    for (int y = 190; y < 262; y += 6) line.emplace_back(x, y);
  const auto placed = place_labels({{.anchor = {400, 225}, .width = 80, .height = 24}}, line, {}, kFrame);
  for (const Vec2& p : line) EXPECT_FALSE(placed[0].box.contains(p));
}

TEST(LabelLayout, AFarLabelIsJoinedToItsAnchorByALeader) {
  const auto placed =
      place_labels({{.anchor = {400, 225}, .width = 80, .height = 24, .leader = true}}, {}, {}, kFrame);
  EXPECT_TRUE(placed[0].has_leader);
  EXPECT_TRUE(placed[0].box.grown(0.2 * 24).contains(placed[0].leader_end));
}

// 26 November 2026: "herpolhode" went from the right below and back within 0.2 s of a film, as a line passed.
TEST(LabelLayout, ALabelKeepsItsSideWhileALinePasses) {
  const LabelRequest label{.anchor = {400, 225},
                           .width = 80,
                           .height = 24,
                           .outward = {0.8, 0.6},
                           .keeps_side = true,
                           .leader = true};
  LabelRequest free = label;
  free.keeps_side = false;
  const auto place = [](const LabelRequest& request, int shift) {
    std::vector<Vec2> line;  // upright, a little further to the right each time
    for (int y = 0; y < 450; y += 2) line.emplace_back(300 + shift, y);
    const PixelBox box = place_labels({request}, line, {}, kFrame, {.cost_covered = 0.15})[0].box;
    return Vec2(box.x0, box.y0);
  };
  bool strays = false;
  for (int shift = 0; shift < 300; shift += 3) {
    EXPECT_EQ(place(label, shift), place(label, 0)) << shift;
    strays = strays || place(free, shift) != place(free, 0);
  }
  EXPECT_TRUE(strays) << "else there was nothing to keep it from";
}

TEST(LabelLayout, ALabelThatKeepsItsSideGivesWayToAnother) {
  const LabelRequest label{
      .anchor = {400, 225}, .width = 80, .height = 24, .outward = {1, 0}, .keeps_side = true, .leader = true};
  const PixelBox there = place_labels({label}, {}, {}, kFrame)[0].box;
  EXPECT_EQ(place_labels({label}, {}, {there}, kFrame)[0].box.overlap(there), 0.0);
}

// 27 November 2026: the name of ω went round its shaft in 60 of 743 frames: on its way out of its own arrow
// it was in its own way, wherever it went.
TEST(LabelLayout, ANameBesideItsShaftStaysThereWhileAnotherArrowPasses) {
  const LabelRequest name{
      .anchor = {400, 225}, .width = 24, .height = 24, .outward = {1, 0}, .keeps_side = true, .beside = true};
  const auto upright = [](double x) {
    std::vector<PixelBox> boxes;
    for (double y = 0; y < 450; y += 12) boxes.push_back({x - 6, y - 6, x + 6, y + 6});
    return boxes;
  };
  int changes = 0;
  bool was_right = true;
  for (double x = 150; x < 650; x += 2) {
    std::vector<PixelBox> taken = upright(400), other = upright(x);
    taken.insert(taken.end(), other.begin(), other.end());
    const PixelBox box = place_labels({name}, {}, taken, kFrame)[0].box;
    for (const PixelBox& arrow : taken) EXPECT_EQ(box.overlap(arrow), 0.0) << x;
    const bool is_right = box.x0 > 400;
    EXPECT_TRUE(is_right || box.x1 < 400) << x;
    changes += is_right != was_right ? 1 : 0;
    was_right = is_right;
  }
  EXPECT_EQ(changes, 2) << "to the left before the other arrow, and back behind it";
}

TEST(LabelLayout, ANameBeyondItsTipTurnsNoFurtherThanItMust) {
  const LabelRequest name{
      .anchor = {400, 225}, .width = 24, .height = 24, .outward = {0, -1}, .keeps_side = true};
  const auto middle = [](const PixelBox& box) -> Vec2 {
    return {0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
  };
  const Vec2 free = middle(place_labels({name}, {}, {}, kFrame)[0].box);
  EXPECT_EQ(free.x(), 400.0) << "straight above the tip";
  const PixelBox other{free.x() + 4, free.y() - 40, free.x() + 30, free.y() + 12};
  const Vec2 turned = middle(place_labels({name}, {}, {other}, kFrame)[0].box);
  EXPECT_LT(turned.x(), 400.0);
  EXPECT_LT(turned.y(), 225.0) << "still on the side of the tip";
}

TEST(LabelLayout, ALevelLeaderLeavesAGapBeforeTheText) {  // or it is a minus: "—herpolhode"
  constexpr double kGap = 0.5;
  const LabelRequest label{
      .anchor = {400, 225}, .width = 80, .height = 24, .outward = {1, 0}, .keeps_side = true, .leader = true};
  const auto placed = place_labels({label}, {}, {}, kFrame, {.level_gap = kGap})[0];
  ASSERT_TRUE(placed.has_leader);
  EXPECT_NEAR(placed.box.x0 - placed.leader_end.x(), kGap * label.height, 1e-9);
}

TEST(LabelLayout, LevelLeadersMayBeMadeDear) {
  const LabelRequest label{.anchor = {400, 225}, .width = 80, .height = 24, .leader = true};
  const auto placed = place_labels({label}, {}, {}, kFrame, {.cost_level = 2})[0];
  const Vec2 way = placed.leader_end - label.anchor;
  EXPECT_GE(std::abs(way.y()), 0.3 * std::abs(way.x()));
}

TEST(LabelLayout, ALabelKeepsClearOfItsMark) {
  const auto placed =
      place_labels({{.anchor = {400, 225}, .width = 80, .height = 24, .clear = 30}}, {}, {}, kFrame);
  const PixelBox& box = placed[0].box;
  const Vec2 nearest(std::clamp(400.0, box.x0, box.x1), std::clamp(225.0, box.y0, box.y1));
  EXPECT_GE((nearest - Vec2(400, 225)).norm(), 30.0);
}

TEST(LabelLayout, MoreRoundsMakeRoomForThoseThatComeLast) {
  // The first label takes the only free side of the second, which comes with its own obstacles all around.
  std::vector<Vec2> busy;
  for (int x = 300; x <= 560; x += 8)
    for (int y = 120; y <= 225; y += 8) busy.emplace_back(x, y);
  const std::vector<LabelRequest> labels = {
      {.anchor = {430, 232}, .width = 90, .height = 24, .leader = true, .close = true},
      {.anchor = {430, 228}, .width = 90, .height = 24, .leader = true, .close = true},
      {.anchor = {430, 230}, .width = 90, .height = 24, .leader = true, .close = true}};
  const auto placed = place_labels(labels, busy, {}, kFrame, {.starts = 3, .rounds = 3, .cost_covered = 0.5});
  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (const Vec2& p : busy) EXPECT_FALSE(placed[i].box.contains(p)) << i;
    for (std::size_t k = 0; k < i; ++k) EXPECT_EQ(placed[i].box.overlap(placed[k].box), 0.0) << i << ' ' << k;
  }
}

TEST(LabelLayout, LeadersAvoidLinesWhereThatIsAsked) {
  // A line runs past the anchor on the right, where the label wants to go, and all that is near is busy.
  std::vector<Vec2> line;
  for (int y = 100; y <= 350; y += 4) line.emplace_back(430, y);
  const LabelRequest label{
      .anchor = {400, 225}, .width = 60, .height = 24, .outward = {1, 0}, .leader = true};
  const auto crosses = [&](const LabelRules& rules) {
    const PlacedLabel placed = place_labels({label}, line, {}, kFrame, rules)[0];
    return placed.leader_end.x() > 430.0;
  };
  EXPECT_TRUE(crosses({.cost_covered = 0.5}));
  EXPECT_FALSE(crosses({.cost_covered = 0.5, .cost_crossed = 5.0}));
}

TEST(LabelLayout, TheSameRequestsGiveTheSamePlaces) {
  const std::vector<LabelRequest> labels(3, {.anchor = {120, 80}, .width = 60, .height = 20});
  const auto a = place_labels(labels, {{130, 80}}, {}, kFrame),
             b = place_labels(labels, {{130, 80}}, {}, kFrame);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].box.x0, b[i].box.x0);
}

TEST(SpreadApart, WhatHasRoomStaysWhereItWants) {
  const std::vector<double> wanted = {80, 10, 45};
  EXPECT_EQ(spread_apart(wanted, 20, 0, 100), wanted);
}

TEST(SpreadApart, NeighboursShareTheWay) {
  EXPECT_EQ(spread_apart({50, 52, 10}, 20, 0, 100), (std::vector<double>{41, 61, 10}));
  EXPECT_EQ(spread_apart({50, 50, 50}, 10, 0, 100), (std::vector<double>{40, 50, 60}));
}

TEST(SpreadApart, StaysWithinTheEndsAndInOrder) {
  const std::vector<double> wanted = {-5, 3, 2, 97, 120, 99};
  const std::vector<double> placed = spread_apart(wanted, 12, 0, 100);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_GE(placed[i], 0.0);
    EXPECT_LE(placed[i], 100.0);
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_GE(std::abs(placed[i] - placed[k]), 12 - 1e-9);
      EXPECT_EQ(placed[i] < placed[k], wanted[i] < wanted[k]);
    }
  }
}

TEST(SpreadApart, WithoutRoomItBeginsAtTheLowEnd) {
  EXPECT_EQ(spread_apart({5, 5, 5}, 10, 0, 15), (std::vector<double>{0, 10, 20}));
  EXPECT_TRUE(spread_apart({}, 10, 0, 15).empty());
}

}  // namespace
}  // namespace polhode
