// SPDX-License-Identifier: MIT
// Pages of the profile slides: the step alone, large, of one size throughout its stage.
#include "app/page/page.h"
#include "app/page/page_theme.h"
#include "app/page/text/page_text.h"
#include "lessons/reader/checks/claim_check.h"
#include "lessons/reader/reader.h"
#include "tests/app/page/sheet_checks.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace polhode {
namespace {

constexpr const char* kHead =
    "+++\nformat = 1\nid = \"x\"\ntitle = \"A lesson\"\n[scene]\nbody = \"textbook\"\nshow = "
    "[\"omega\"]\n+++\n";

Lesson lesson_of(const std::string& stages) {
  LessonReading reading = read_lesson(kHead + stages, "x.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  return std::move(*reading.lesson);
}

constexpr Size kSlides[] = {{1600, 900}, {1024, 768}, {1080, 1920}, {3840, 2160}};

/// The x-height of Pagella and Heros, em.
constexpr double kSerifXHeight = 0.469, kSansXHeight = 0.523;
constexpr double kSmallest = 0.62;  ///< em: ticks of plots, labels of call-outs, headers

class Slides {
 public:
  explicit Slides(const std::string& stages, Size size = kSlides[0])
      : lesson_(lesson_of(stages)), size_(size) {
    EXPECT_FALSE(prove_claims(lesson_)) << "there is time enough";
  }

  const Stage& stage() const { return lesson_.stages[0]; }
  PageRequest request(int step, const SceneModel* model) const {
    return {.lesson = lesson_,
            .stage = stage(),
            .step = step,
            .model = model,
            .size = size_,
            .profile = Profile::slides};
  }
  Page page(int step) const {
    const auto& scene = stage().steps[static_cast<std::size_t>(step - 1)].scene;
    if (!scene) return compose_page(request(step, nullptr), test_fonts()).value();
    const SceneModel model = make_model(*scene, ModelFor::page);
    return compose_page(request(step, &model), test_fonts()).value();
  }

 private:
  Lesson lesson_;
  Size size_;
};

/// Em of the largest letters among those of the column whose text has no other mark than being there.
double prose_em(const Page& page) {
  double least = std::numeric_limits<double>::infinity();
  for (const PlacedType& text : page.sheet.texts)
    if (text.at.x() >= page.column.x0 && text.list.glyphs.size() > 20 && text.at.y() > page.column.y0)
      least = std::min(least, text.list.glyphs.front().size);
  return least;
}

constexpr const char* kTwoSteps =
    "# A stage {s}\n\nThe first step has these words, and a line more of them.\n\n```math first\nT = "
    "1\n```\n\n"
    "```scene\n```\n\n---\n\nThe second step has these other words, and a line more of them.\n\n```math "
    "second\nT = 2\n```\n";

TEST(Slide, HasTheStepAloneAndWhatItGoesOnFrom) {
  const Slides slides(kTwoSteps);
  const Page first = slides.page(1), second = slides.page(2);
  ASSERT_EQ(second.equations.size(), 1u);
  EXPECT_EQ(second.equations[0]->id, "second");
  EXPECT_EQ(second.whole_from, 2);
  const auto foot = [](const Page& page) {
    std::size_t below = 0;
    for (const PlacedType& text : page.sheet.texts)
      below += text.at.x() < page.column.x1 && text.at.y() > page.column.y1 - 0.08 * 900 ? 1u : 0u;
    return below;
  };
  EXPECT_EQ(foot(first), 0u) << "nothing came before";
  EXPECT_EQ(foot(second), 2u) << "words and the equation";
}

// 2026-11-27: what a slide goes on from was left out without a word where it was wider or higher than a line.
TEST(Slide, WhatItGoesOnFromStandsBelowItsWordsWhereNoLineHoldsIt) {
  const auto recalls = [](const std::string& tex, const std::string& words) {
    const std::string stages = "# A stage {s}\n\nWords.\n\n```math first\n" + tex +
                               "\n```\n\n```scene\n```\n\n---\n\n" + words + "\n\n```scene\nat = 1\n```\n";
    const Slides slides(stages);
    const SceneModel model = make_model(*slides.stage().steps[1].scene, ModelFor::page);
    const FittedText text = text_of_page(slides.request(2, &model), test_fonts()).value();
    return std::pair(text.recalled != nullptr, text.scale);
  };
  const std::string tall = "a = \\begin{aligned} b \\\\ c \\\\ d \\end{aligned}";
  std::string wide = "a = 1";
  for (int i = 0; i < 5; ++i) wide += " + b_{0000}";
  for (const std::string& tex : {std::string("a = b"), tall, wide})
    EXPECT_TRUE(recalls(tex, "Words.").first) << tex;
  std::string much;
  for (int i = 0; i < 62; ++i) much += "words ";
  const auto [has_room, scale] = recalls(tall, much);
  EXPECT_FALSE(has_room);
  EXPECT_EQ(scale, recalls("a = b", much).second) << "type smaller for it";
}

TEST(Slide, ATitleOfItsStepIsItsHeadline) {
  const std::string untitled = "# Of the stage {s}\n\nA few words.\n\n```scene\n```\n";
  const std::string titled = "# Of the stage {s}\n\n## Of the step\n\nA few words.\n\n```scene\n```\n";
  const Page plain = Slides(untitled).page(1), named = Slides(titled).page(1);
  // Header, headline and words each.
  ASSERT_EQ(named.sheet.texts.size(), plain.sheet.texts.size());
  std::size_t headlines = 0;
  for (std::size_t i = 0; i < named.sheet.texts.size(); ++i) {
    const DisplayList &a = plain.sheet.texts[i].list, &b = named.sheet.texts[i].list;
    if (a.glyphs.empty() || b.glyphs.empty() || a.glyphs.size() == b.glyphs.size()) continue;
    EXPECT_EQ(a.glyphs.front().size, b.glyphs.front().size);
    ++headlines;
  }
  EXPECT_EQ(headlines, 2u)
      << "the headline, and the stage's title in the header in the place of the lesson's";
}

TEST(Slide, TypeIsLargeEnoughToProject) {
  for (const Size& size : kSlides) {
    const Page page = Slides(kTwoSteps, size).page(2);
    EXPECT_EQ(page.scale, 1.0);
    const double em = prose_em(page), side = std::min(size.width, size.height);
    EXPECT_GE(em * kSerifXHeight, 0.018 * side) << size.width;
    EXPECT_GE(kSmallest * em * kSansXHeight, 0.013 * side) << size.width;
  }
}

// 2026-11-27: badges and names shrank with the text of a full slide, to 1.2 % of its height.
TEST(Slide, SmallTypeIsNotSmallerWhereThereIsMuchText) {
  std::string words;
  for (int i = 0; i < 9; ++i)
    words += "There is more to be said of this than has room in type of the usual size. ";
  const Page page = Slides("# S {s}\n```scene\nshow = [\"omega\"]\n```\n" + words +
                           "\n\n```math a identity\n2T = 2T + 0\n```\n")
                        .page(1);
  ASSERT_LT(page.scale, 1.0);
  double smallest = 1e9;
  for (const PlacedType& text : page.sheet.texts) {
    double size = 0;
    for (const auto& glyph : text.list.glyphs) size = std::max<double>(size, glyph.size);
    if (size > 0) smallest = std::min(smallest, size);
  }
  EXPECT_GE(smallest * kSansXHeight, 0.013 * kSlides[0].height);
}

TEST(Slide, AFigureHasMostOfItWhereTextIsShort) {
  const Page page = Slides(kTwoSteps).page(1);
  EXPECT_GE(page.figure.width() * page.figure.height(), 0.6 * 1600 * 900);
}

TEST(Slide, AllStepsOfAStageHaveOneSizeAndOneColumn) {
  std::string words;
  for (int i = 0; i < 90; ++i) words += fmt::format("word{} ", i);
  const std::string stages = "# A stage {s}\n\nA few words.\n\n```scene\n```\n\n---\n\n" + words + "\n";
  const Slides slides(stages);
  const Page first = slides.page(1), second = slides.page(2);
  EXPECT_EQ(first.scale, second.scale);
  EXPECT_EQ(first.column.x1, second.column.x1);
  EXPECT_GT(first.column.x1, Slides(kTwoSteps).page(1).column.x1) << "wider for the sake of the second";
}

TEST(Slide, WhatIsTooMuchIsSmallerAndNeverCut) {
  std::string words;
  for (int i = 0; i < 400; ++i) words += "many words ";
  const Page page = Slides("# A stage {s}\n\n" + words + "\n\n```scene\n```\n").page(1);
  EXPECT_LT(page.scale, 0.8);
  for (const PlacedType& text : page.sheet.texts) EXPECT_LE(text.at.y() + text.list.depth, 900.0);
}

TEST(Slide, IsTheSameWithATypeThatWasFoundBefore) {
  const Slides slides(kTwoSteps);
  const SceneModel model = make_model(*slides.stage().steps[0].scene, ModelFor::page);
  PageRequest request = slides.request(1, &model);
  const SlideType type = slide_type_of(request, test_fonts()).value();
  const Page found = compose_page(request, test_fonts()).value();
  request.slide_type = &type;
  const Page given = compose_page(request, test_fonts()).value();
  EXPECT_EQ(found.column.x1, given.column.x1);
  EXPECT_EQ(found.sheet.texts.size(), given.sheet.texts.size());
}

/// Panels behind displays in focus.
std::size_t panels_of(const Page& page) {
  return static_cast<std::size_t>(
      std::count_if(page.sheet.shapes.begin(), page.sheet.shapes.end(), [](const FlatShape& shape) {
        const auto* area = std::get_if<Area>(&shape);
        return area != nullptr && area->color == colors_of(Theme::paper).panel;
      }));
}

TEST(Slide, OfTwoEqualDisplaysNeitherIsLess) {
  const std::string one = "# A stage {s}\n\n```math a identity\nT = T \\tag{1}\n```\n\n";
  const std::string numbered = "```math b identity\nI_1 = I_1 \\tag{2}\n```\n";
  const std::string lesser = "```math b identity\nI_1 = I_1\n```\n";
  EXPECT_EQ(panels_of(Slides(one).page(1)), 1u);
  EXPECT_EQ(panels_of(Slides(one + numbered).page(1)), 2u);
  EXPECT_EQ(panels_of(Slides(one + lesser).page(1)), 1u) << "it has no number";
}

TEST(Slide, HasNoVerdictOfWhatIsClaimedBesideAFormulaUnlessItIsFalse) {
  const std::string formula = "# A stage {s}\n\n```math a\n\\vec a_S = R\\,\\vec a_{S^*}\n```\n\n";
  const std::string claim = "```claim a identity in-other-words\ndot(e1, e2) = 0\n```\n";
  const std::string wrong = "```claim a false in-other-words\ndot(L, L) = 0\n```\n";
  const std::size_t without = Slides(formula).page(1).sheet.texts.size();
  EXPECT_EQ(Slides(formula + claim).page(1).sheet.texts.size(), without)
      << "it would seem to be of the formula";
  EXPECT_GT(Slides(formula + wrong).page(1).sheet.texts.size(), without);
}

// 2026-11-27: side by side their type was a third smaller than a single plot's.
TEST(Slide, TwoPlotsStandOneBelowTheOtherOnOneTimeAxis) {
  const std::string meters =
      "meters = [{ plot = \"T\", title = \"Upper\", tex = 'T' }, { plot = \"T\", title = \"Lower\", "
      "tex = '\\text{a long name}' }]\n";
  const Page page =
      Slides("# A stage {s}\n\nA few words.\n\n```scene\nduration = 1\n" + meters + "```\n").page(1);
  const auto titled = [&](const char* title) {
    return *std::find_if(page.sheet.texts.begin(), page.sheet.texts.end(),
                         [&](const PlacedType& text) { return text.text == title; });
  };
  const PlacedType upper = titled("Upper"), lower = titled("Lower");
  EXPECT_EQ(upper.at.x(), lower.at.x());
  EXPECT_LT(upper.at.y() + 100, lower.at.y());
  EXPECT_NEAR(lower.list.glyphs.front().size, kSmallest * 0.0405 * 900, 0.01);
  std::vector<double> starts;  // of the marks "0.4" of both time axes
  for (const PlacedType& text : page.sheet.texts)
    if (text.text == "0.4") starts.push_back(text.at.x());
  ASSERT_EQ(starts.size(), 2u);
  EXPECT_EQ(starts[0], starts[1]);
}

TEST(Slide, PlotsThatStandAloneHaveTheFiguresPlace) {
  const std::string stage =
      "# A stage {s}\n\nA few words.\n\n```scene\nmeters = [\"omega\"]\ncaption = \"c\"\n";
  const Page both = Slides(stage + "```\n").page(1), alone = Slides(stage + "show = []\n```\n").page(1);
  EXPECT_EQ(both.insets.size(), 1u);
  EXPECT_TRUE(alone.insets.empty());
  const auto top_of_plots = [](const Page& page) {
    double top = 900;
    for (const PlacedType& text : page.sheet.texts)
      if (text.text == "Angular velocity in the body") top = text.at.y();
    return top;
  };
  EXPECT_LT(top_of_plots(alone), 0.1 * 900);
  EXPECT_GT(top_of_plots(both), 0.5 * 900);
  for (const PlacedType& text : alone.sheet.texts) EXPECT_LE(text.at.y(), 900.0) << "the caption is there";
}

}  // namespace
}  // namespace polhode
