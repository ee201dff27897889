// SPDX-License-Identifier: MIT
#include "render/typeset/morph.h"

#include "render/typeset/math/math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace polhode {
namespace {

constexpr double kInside[] = {1e-12, 0.1, 0.25, 0.4999, 0.5, 0.5001, 0.75, 0.9, 1.0 - 1e-12};

DisplayList set(const char* tex) {
  static const Fonts kFonts = Fonts::open().value();
  const auto math = parse_math(tex);
  if (!math) throw std::runtime_error(math.error().front().message);
  return set_math(*math, MathStyle{.size = 24, .display = true, .color = {0.1F, 0.2F, 0.3F}}, kFonts).value();
}

/// Lines of a derivation, and what has nothing in common.
const std::vector<std::pair<DisplayList, DisplayList>>& examples() {
  static const std::vector<std::pair<DisplayList, DisplayList>> kExamples = {
      {set(R"(\vec N = \frac{d\vec L}{dt})"),
       set(R"(\vec N = \frac{d^*\vec L}{dt} + \vec\omega\times\vec L)")},
      {set(R"(\term{a}{x} + \term{b}{y} = z)"), set(R"(\term{b}{y} = z - \term{a}{x})")},
      {set(R"(\sqrt{\frac{a}{b}})"), set(R"(\frac{\sqrt a}{\sqrt b})")},
      {set("abc"), set("xyz")},
      {set("a+b"), set("a+b")},
      {DisplayList{}, set(R"(\frac{a}{b})")},
      {DisplayList{}, DisplayList{}},
  };
  return kExamples;
}

std::string name_at(const DisplayList& list, std::int16_t index) {
  return index < 0 ? "" : list.names.at(static_cast<std::size_t>(index));
}

Glyph letter(std::uint32_t id, double x, double y = 0) {
  return {.face = Face::serif, .id = id, .x = x, .y = y, .size = 10, .color = {}, .naming = {}, .source = {}};
}

Rule rule(double x0, double y0, double x1, double y1) {
  return {.x0 = x0, .y0 = y0, .x1 = x1, .y1 = y1, .thickness = 1, .color = {}, .naming = {}, .source = {}};
}

TEST(Morph, IsExactlyItsEndsThereAndBeyond) {
  for (const auto& [from, to] : examples()) {
    for (const double u : {0.0, -0.0, -1e-300, -5.0, -std::numeric_limits<double>::infinity()})
      EXPECT_EQ(morph(from, to, u), from);
    for (const double u : {1.0, 1.0 + 1e-12, 7.0, std::numeric_limits<double>::infinity()})
      EXPECT_EQ(morph(from, to, u), to);
  }
}

TEST(Morph, OfNoNumberIsItsBeginning) {
  for (const auto& [from, to] : examples())
    EXPECT_EQ(morph(from, to, std::numeric_limits<double>::quiet_NaN()), from);
}

TEST(Morph, DependsOnItsArgumentsAlone) {
  for (const auto& [from, to] : examples())
    for (const double u : kInside) {
      const DisplayList copy_of_from = from, copy_of_to = to;
      EXPECT_EQ(morph(from, to, u), morph(copy_of_from, copy_of_to, u));
    }
}

TEST(Morph, OfAListToItselfStandsStill) {
  for (const auto& [from, to] : examples())
    for (const double u : kInside) {
      const DisplayList still = morph(to, to, u);
      ASSERT_EQ(still.glyphs, to.glyphs);
      EXPECT_EQ(still.names, to.names);
      ASSERT_EQ(still.rules.size(), to.rules.size());
      for (std::size_t i = 0; i < to.rules.size(); ++i)
        EXPECT_EQ(still.rules[i].thickness, to.rules[i].thickness);
      EXPECT_EQ(still.width, to.width);
      EXPECT_EQ(still.ascent, to.ascent);
      EXPECT_EQ(still.depth, to.depth);
    }
}

/// What is seen: face, id, place, size, opacity; unordered.
std::multiset<std::tuple<int, std::uint32_t, double, double, double>> seen(const DisplayList& list) {
  std::multiset<std::tuple<int, std::uint32_t, double, double, double>> all;
  const auto rounded = [](double v) { return std::round(v * 1e6) / 1e6; };
  for (const Glyph& g : list.glyphs)
    all.insert({static_cast<int>(g.face), g.id, rounded(g.x), rounded(g.y), rounded(g.color.a)});
  return all;
}

TEST(Morph, BackwardsIsTheSameWay) {
  // The best match is the only one here: of equally good ones, either direction may choose its own.
  const std::pair<DisplayList, DisplayList> ways[] = {
      {set("abcde+f"), set(R"(\frac{a}{b}cxf)")}, {set("abc=d"), set("bc=ad")}, {set("abc"), set("xyz")}};
  for (const auto& [from, to] : ways)
    for (int i = 1; i < 8; ++i)
      EXPECT_EQ(seen(morph(from, to, i / 8.0)), seen(morph(to, from, 1.0 - i / 8.0)));
}

TEST(Morph, EveryGlyphIsOfOneOfTheTwo) {
  for (const auto& [from, to] : examples())
    for (const double u : kInside) {
      const DisplayList between = morph(from, to, u);
      std::size_t most = from.glyphs.size() + to.glyphs.size();
      EXPECT_LE(between.glyphs.size(), most);
      for (const Glyph& g : between.glyphs) {
        const auto is_it = [&](const DisplayList& list) {
          return std::any_of(list.glyphs.begin(), list.glyphs.end(), [&](const Glyph& o) {
            return o.face == g.face && o.id == g.id && o.source == g.source &&
                   name_at(list, o.naming.term) == name_at(between, g.naming.term) &&
                   name_at(list, o.naming.symbol) == name_at(between, g.naming.symbol);
          });
        };
        EXPECT_TRUE(is_it(from) || is_it(to));
        EXPECT_TRUE(std::isfinite(g.x) && std::isfinite(g.y) && g.size > 0.0);
        EXPECT_TRUE(g.color.a > 0.0F && g.color.a <= 1.0F);
      }
    }
}

TEST(Morph, WhatBothHaveMovesInProportion) {
  DisplayList from, to;
  from.glyphs = {letter(1, 0, 0), letter(2, 10, 0)};
  to.glyphs = {letter(1, 40, -8), letter(2, 70, 4)};
  to.glyphs[0].size = 30;
  to.glyphs[0].color = {1.0F, 0.5F, 0.25F};
  from.rules = {rule(0, 0, 10, 0)};
  to.rules = {rule(4, 8, 54, 8)};
  to.rules[0].thickness = 3;
  from.width = 20, to.width = 80;
  from.ascent = 8, to.ascent = 12;
  from.depth = 1, to.depth = 5;
  // Eighths: all products are exact.
  for (int i = 1; i < 8; ++i) {
    const double u = i / 8.0;
    const DisplayList list = morph(from, to, u);
    ASSERT_EQ(list.glyphs.size(), 2u);
    EXPECT_EQ(list.glyphs[0].x, 40 * u);
    EXPECT_EQ(list.glyphs[0].y, -8 * u);
    EXPECT_EQ(list.glyphs[0].size, 10 + 20 * u);
    EXPECT_EQ(list.glyphs[0].color,
              (Color{static_cast<float>(u), static_cast<float>(0.5 * u), static_cast<float>(0.25 * u)}));
    EXPECT_EQ(list.glyphs[1].x, 10 + 60 * u);
    EXPECT_EQ(list.glyphs[1].color.a, 1.0F);
    ASSERT_EQ(list.rules.size(), 1u);
    EXPECT_EQ(list.rules[0].x0, 4 * u);
    EXPECT_EQ(list.rules[0].x1, 10 + 44 * u);
    EXPECT_EQ(list.rules[0].y0, 8 * u);
    EXPECT_EQ(list.rules[0].thickness, 1 + 2 * u);
    EXPECT_EQ(list.width, 20 + 60 * u);
    EXPECT_EQ(list.ascent, 8 + 4 * u);
    EXPECT_EQ(list.depth, 1 + 4 * u);
  }
}

TEST(Morph, OneHalfFadesOutAndTheOtherIn) {
  DisplayList from, to;
  from.glyphs = {letter(1, 3)};
  to.glyphs = {letter(2, 5)};
  to.glyphs[0].color.a = 0.5F;
  from.rules = {rule(0, 0, 10, 0)};
  to.rules = {rule(0, 0, 0, 10)};
  for (int i = 1; i < 8; ++i) {
    const double u = i / 8.0;
    const DisplayList list = morph(from, to, u);
    if (i == 4) {
      EXPECT_TRUE(list.glyphs.empty() && list.rules.empty());
      continue;
    }
    ASSERT_EQ(list.glyphs.size(), 1u);
    ASSERT_EQ(list.rules.size(), 1u);
    const bool goes = u < 0.5;
    EXPECT_EQ(list.glyphs[0].id, goes ? 1u : 2u);
    EXPECT_EQ(list.glyphs[0].x, goes ? 3.0 : 5.0);  // where it was, or will be
    EXPECT_EQ(list.glyphs[0].color.a, static_cast<float>(goes ? 1.0 - 2.0 * u : 0.5 * (2.0 * u - 1.0)));
    EXPECT_EQ(list.rules[0].x1, goes ? 10.0 : 0.0);
    EXPECT_EQ(list.rules[0].color.a, static_cast<float>(std::abs(1.0 - 2.0 * u)));
  }
}

TEST(Morph, MatchesInReadingOrderAlone) {
  // Of "abc" and "cab" the two that keep their order travel.
  DisplayList from, to;
  from.glyphs = {letter(1, 0), letter(2, 10), letter(3, 20)};
  to.glyphs = {letter(3, 0), letter(1, 10), letter(2, 20)};
  const DisplayList list = morph(from, to, 0.25);
  ASSERT_EQ(list.glyphs.size(), 3u);
  EXPECT_EQ(seen(list), (std::multiset<std::tuple<int, std::uint32_t, double, double, double>>{
                            {0, 1, 2.5, 0, 1}, {0, 2, 12.5, 0, 1}, {0, 3, 20, 0, 0.5}}));
}

TEST(Morph, TheSameTermIsPreferred) {
  DisplayList from, to;
  from.names = {"turning"};
  to.names = {"other", "turning"};
  from.glyphs = {letter(9, -10), letter(1, 0), letter(8, 5)};
  from.glyphs[1].naming.term = 0;
  to.glyphs = {letter(7, -10), letter(1, 100), letter(1, 200), letter(6, 300)};
  to.glyphs[1].naming.term = 0;
  to.glyphs[2].naming.term = 1;
  const DisplayList list = morph(from, to, 0.25);
  bool is_there = false;
  for (const Glyph& g : list.glyphs)
    if (g.id == 1) {
      EXPECT_EQ(g.x, 50.0);
      EXPECT_EQ(name_at(list, g.naming.term), "turning");
      is_there = true;
    }
  EXPECT_TRUE(is_there);
}

TEST(Morph, NamesOfBothAreKept) {
  DisplayList from, to;
  from.names = {"a", "b", "c"};
  to.names = {"c", "d"};
  from.glyphs = {letter(1, 0)};
  from.glyphs[0].naming = {1, 2};
  to.glyphs = {letter(2, 0)};
  to.glyphs[0].naming = {0, 1};
  const DisplayList early = morph(from, to, 0.25), late = morph(from, to, 0.75);
  ASSERT_EQ(early.glyphs.size(), 1u);
  EXPECT_EQ(name_at(early, early.glyphs[0].naming.term), "b");
  EXPECT_EQ(name_at(early, early.glyphs[0].naming.symbol), "c");
  ASSERT_EQ(late.glyphs.size(), 1u);
  EXPECT_EQ(name_at(late, late.glyphs[0].naming.term), "c");
  EXPECT_EQ(name_at(late, late.glyphs[0].naming.symbol), "d");
  EXPECT_EQ(std::set<std::string>(early.names.begin(), early.names.end()).size(), early.names.size());
}

TEST(Morph, RulesTravelByTheirDirectionAndDoNotTurnOver) {
  DisplayList from, to;
  from.rules = {rule(0, 0, 10, 0), rule(0, 0, 0, 10), rule(0, 0, 10, 10)};
  to.rules = {rule(30, 4, 20, 4), rule(8, 10, 8, 0), rule(20, 20, 10, 10)};  // drawn from the other end
  const DisplayList list = morph(from, to, 0.5);
  ASSERT_EQ(list.rules.size(), 3u);
  EXPECT_EQ(list.rules[0], rule(10, 2, 20, 2));
  EXPECT_EQ(list.rules[1], rule(4, 0, 4, 10));
  EXPECT_EQ(list.rules[2], rule(5, 5, 15, 15));
  from.rules = {rule(0, 0, 10, 10)};
  to.rules = {rule(0, 10, 10, 0)};
  EXPECT_TRUE(morph(from, to, 0.5).rules.empty());  // rising and falling ones do not match
}

TEST(Morph, GoesOnWithoutJumps) {
  for (const auto& example : examples())
    for (int i = 0; i < 200; ++i) {
      const DisplayList &from = example.first, &to = example.second;
      // What is hardly visible may be missing: opacity changes by at most 2·step.
      const auto visible = [&](double u) {
        double sum = 0;
        for (const Glyph& g : morph(from, to, u).glyphs) sum += static_cast<double>(g.color.a);
        return sum;
      };
      const double step = 1.0 / 200, u = i * step;
      const double most =
          2.0 * step * static_cast<double>(std::max(from.glyphs.size(), to.glyphs.size())) + 1e-5;  // floats
      EXPECT_LE(std::abs(visible(u + step) - visible(u)), most);
    }
}

DisplayList random_list(std::size_t n, unsigned seed) {
  std::mt19937 generator(seed);
  DisplayList list;
  for (std::size_t i = 0; i < n; ++i)
    list.glyphs.push_back(letter(static_cast<std::uint32_t>(generator() % 20), static_cast<double>(i)));
  return list;
}

TEST(Morph, OfLongListsKeepsTheirCommonEndsAndFadesTheRest) {
  constexpr std::size_t kMost = 2000;  // of morph.h
  const auto travelling = [](std::size_t n) {
    DisplayList from = random_list(n, 1), to = random_list(n, 2);
    from.glyphs.front().id = 50, to.glyphs.front().id = 51;
    from.glyphs.back().id = 52, to.glyphs.back().id = 53;
    for (DisplayList* list : {&from, &to}) {
      list->glyphs.insert(list->glyphs.begin(), letter(60, -1));
      list->glyphs.push_back(letter(61, 1e6));
    }
    return morph(from, to, 0.5).glyphs.size();  // all that is there in the middle travels
  };
  EXPECT_GT(travelling(kMost), 2u + kMost / 20);
  EXPECT_EQ(travelling(kMost + 1), 2u);
}

TEST(Morph, OfOneManyEqualLettersMatchesAllThatCanBe) {
  DisplayList from, to;
  for (int i = 0; i < 30; ++i) from.glyphs.push_back(letter(1, i));
  for (int i = 0; i < 50; ++i) to.glyphs.push_back(letter(1, 2 * i));
  EXPECT_EQ(morph(from, to, 0.5).glyphs.size(), 30u);
  EXPECT_EQ(morph(to, from, 0.5).glyphs.size(), 30u);
}

}  // namespace
}  // namespace polhode
