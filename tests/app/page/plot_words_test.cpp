// SPDX-License-Identifier: MIT
#include "app/page/plot_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace polhode {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// Of one curve over t from 0 to 1 s.
std::string course(const std::function<double(double)>& y, TimePlot plot = {.unit = "J"}) {
  constexpr int kSteps = 400;
  plot.series = {{.label = "$T$"}};
  for (int i = 0; i <= kSteps; ++i) {
    plot.t.push_back(static_cast<double>(i) / kSteps);
    plot.series[0].y.push_back(y(plot.t.back()));
  }
  return course_in_words(plot, plot.series[0]);
}

double sine(double turns) { return std::sin(2.0 * std::numbers::pi * turns); }

// 28 November 2026: of plots only the names of their curves were said.
TEST(PlotWords, TellHowACurveGoes) {
  EXPECT_EQ(course([](double t) { return 1.0 + t; }), "rises from 1 to 2 joules");
  EXPECT_EQ(course([](double t) { return 2.0 - 3.0 * t; }), "falls from 2 to minus 1 joules");
  EXPECT_EQ(course([](double) { return 0.25; }), "stays at 0.25 joules");
  EXPECT_EQ(course([](double t) { return 0.25 + 1e-15 * sine(40.0 * t); }), "stays at 0.25 joules")
      << "what rounding leaves";
  EXPECT_EQ(course([](double t) { return sine(t); }),
            "rises from 0 to 1, falls to minus 1, rises to 0 joules");
  EXPECT_EQ(course([](double t) { return 2.0 * sine(4.0 * t); }),
            "oscillates between minus 2 and 2 joules, with 4 maxima");
  // 29 November 2026: five turns that begin at a top were told as four maxima.
  EXPECT_EQ(course([](double t) { return sine(5.0 * t + 0.25); }),
            "oscillates between minus 1 and 1 joule, with 6 maxima, one at each end");
  EXPECT_EQ(course([](double t) { return sine(4.5 * t + 0.25); }),
            "oscillates between minus 1 and 1 joule, with 5 maxima, one at the start");
  EXPECT_EQ(course([](double t) { return std::exp(-2.0 * t) * sine(4.0 * t); }).find("goes up and down"), 0u)
      << "it dies away";
}

TEST(PlotWords, GapsAreNoCourse) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(course([&](double t) { return t < 0.5 ? none : t; }), "rises from 0.5 to 1 joule");
  EXPECT_EQ(course([&](double) { return none; }), "not defined");
}

TEST(PlotWords, AreOfTheAxisThatIsDrawn) {
  EXPECT_EQ(
      course([](double t) { return std::pow(10.0, -8.0 * (1.0 - t)); }, {.unit = "", .log_floor = 1e-16}),
      "rises from 1 times 10 to the power minus 8 to 1");
  EXPECT_EQ(course([](double) { return 0.0; }, {.unit = "", .log_floor = 1e-16}), "stays at 0");
  EXPECT_EQ(course([](double t) { return t < 0.5 ? 0.0 : 1e-4; }, {.unit = "", .log_floor = 1e-16}),
            "rises from at most 1 times 10 to the power minus 16 to 0.0001");
  EXPECT_EQ(course([](double t) { return 1.0 - t; }, {.unit = "m", .language = Language::de}),
            "fällt von 1 auf 0 Meter");
}

TEST(PlotWords, WhatIsNotDrawnIsNotTold) {
  EXPECT_EQ(course([](double t) { return 10.0 * t; }, {.range = std::pair(0.0, 5.0)}),
            "rises from 0 to 5, then leaves the plot");
  EXPECT_EQ(course([](double) { return 10.0; }, {.range = std::pair(0.0, 5.0)}), "outside the range shown");
  EXPECT_EQ(course([](double t) { return 1.0 - std::cos(4.0 * std::numbers::pi * t); }, {.unit = "J"}),
            "oscillates between 0 and 2 joules, with 2 maxima");
}

TEST(PlotWords, AReaderHearsAxesAndCurves) {
  Scene scene;
  scene.meters = {Meter::omega, Meter::energy};
  scene.duration_s = 1.5;
  Lesson lesson;
  const SpeechText names(lesson);
  const SceneModel model = make_model(scene, ModelFor::page);
  EXPECT_THAT(
      words_of_plots(model, 0.0, names, false),
      AllOf(testing::StartsWith("Angular velocity in the body, against time from 0 to 1.5 seconds. omega "
                                "sub 1: "),
            HasSubstr("; omega sub 3: "), HasSubstr("Kinetic energy, against time"),
            HasSubstr("T: stays at ")));
  // 29 November 2026: where a question was asked of a plot, nothing could be read from it but by eye.
  const std::string asked = words_of_plots(model, 0.0, names, true);
  EXPECT_THAT(asked, Not(HasSubstr("stays"))) << "that may be the answer";
  EXPECT_THAT(asked, ContainsRegex("omega sub 1: [^;]* at 0, [^;]* at 1.5;"));
  EXPECT_THAT(asked, ContainsRegex("T: [^;,]+ at 0, [^;,]+ at 0.75, [^;,]+ joules at 1.5[.]"));
}

// 29 November 2026: of a diagram only its name was told.
TEST(PlotWords, WhatStandsInADiagramIsTold) {
  Scene scene;
  scene.show = {Overlay::energy_rows};
  Lesson lesson;
  const SpeechText names(lesson);
  const Result<Fonts> fonts = Fonts::open();
  ASSERT_TRUE(fonts);
  const SceneModel model = make_model(scene, ModelFor::page);
  const std::string told = words_of_diagrams(model, 0.0, names, *fonts);
  EXPECT_THAT(told, testing::StartsWith("The products, end to end; W; omega sub 1 "));
  EXPECT_THAT(told,
              ContainsRegex("I sub 2 minus I sub 1[^;]*; [−0-9.]+; sum; 0; The first terms, computed; W;"));
  EXPECT_THAT(figure_in_words(model, {{}}, 0.0, names, &*fonts), HasSubstr(" In the diagram: The products"));
  EXPECT_THAT(figure_in_words(model, {{}}, 0.0, names, nullptr), Not(HasSubstr("In the diagram")));
  scene.show = {Overlay::omega};
  EXPECT_EQ(words_of_diagrams(make_model(scene, ModelFor::page), 0.0, names, *fonts), "");
}

}  // namespace
}  // namespace polhode
