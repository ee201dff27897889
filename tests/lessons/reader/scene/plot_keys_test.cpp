// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/plot_keys.h"

#include "physics/body/euler_angles.h"
#include "render/scene/model/model.h"
#include "tests/lessons/support.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

std::string lesson_with_meters(const std::string& meters) {
  return "+++\nformat = 1\nid = \"plots\"\ntitle = \"Plots\"\n"
         "[constants]\nmgl = { value = 2.5, unit = \"N m\" }\n"
         "[define]\nu = { means = \"dot(ez, e3)\", tex = 'u' }\n"
         "E = { means = \"T + mgl*u\", tex = 'E', unit = \"J\" }\n"
         "[scene]\nbody = \"book\"\nomega = [0.3, 1, 20]\n+++\n\n# A stage {stage}\n\n```scene\nmeters = " +
         meters + "\n```\n";
}

std::vector<PlotSpec> plots_of(const std::string& meters) {
  LessonReading reading = read_lesson(lesson_with_meters(meters), "plots.md");
  EXPECT_THAT(testing::lines_of(reading.diagnostics), IsEmpty()) << meters;
  if (!reading.lesson) return {};
  return reading.lesson->stages.front().steps.front().scene->meters;
}

OwnPlot own_plot(const std::string& table) {
  const auto plots = plots_of("[" + table + "]");
  return plots.empty() ? OwnPlot() : std::get<OwnPlot>(plots.front());
}

/// The first thing that is said of a plot.
std::string complaint(const std::string& meters) {
  const auto lines = testing::complaints(lesson_with_meters(meters));
  return lines.empty() ? "nothing was said" : lines.front();
}

TEST(PlotKeys, StandBesideNames) {
  const auto plots = plots_of(R"x(["omega", { plot = ["T", "mgl*u", "E"] }, { plot = "u" }])x");
  ASSERT_EQ(plots.size(), 3u);
  EXPECT_EQ(plots[0], PlotSpec(Meter::omega));
  EXPECT_EQ(std::get<OwnPlot>(plots[1]).curves.size(), 3u);
  EXPECT_EQ(std::get<OwnPlot>(plots[1]).y, (PlotUnit{"J", 1}));
  EXPECT_EQ(std::get<OwnPlot>(plots[2]).curves.front().text, "u");
}

TEST(PlotKeys, ScaleByTheirUnit) {
  const OwnPlot angle = own_plot(R"x({ plot = "acos(u)", unit = "deg" })x");
  EXPECT_EQ(angle.y.unit, "deg");
  EXPECT_NEAR(angle.y.per_si, 180 / std::numbers::pi, 100 * kEpsilon);
  EXPECT_NEAR(own_plot(R"x({ plot = "E", unit = "mJ" })x").y.per_si, 1000, 1000 * kEpsilon);
  const OwnPlot path = own_plot(R"x({ plot = "w2", against = { of = "w1", unit = "deg/s" } })x");
  EXPECT_EQ(path.x.unit, "deg/s");
  EXPECT_EQ(path.y.unit, "rad/s");
  EXPECT_FALSE(path.is_scaled_alike) << "numbers of different units";
  EXPECT_TRUE(own_plot(R"x({ plot = "w2", against = "w1" })x").is_scaled_alike);
  EXPECT_FALSE(own_plot(R"x({ plot = "T", against = "w1" })x").is_scaled_alike);
}

TEST(PlotKeys, AFunctionIsThatOfItsVariable) {
  const OwnPlot own = own_plot(
      R"x({ curve = "T*s^2 + mgl*s", var = "s", x = { of = "u", from = -1, to = 0.5 }, level = "E" })x");
  ASSERT_TRUE(own.function);
  EXPECT_EQ(own.function->of.text, "u");
  EXPECT_EQ(own.function->level->text, "E");
  EXPECT_EQ(own.y.unit, "J");
  EXPECT_THAT(own.function->tex, HasSubstr("u^{2}")) << "the variable is printed as what it is on the motion";
  Scene scene;
  scene.w0_B = Vec3(0.1, 0.2, 0.3);
  const SceneModel model = make_model(scene, ModelFor::page);
  const Vec3& I = scene.body.moments.vector();
  const double T = 0.5 * scene.w0_B.cwiseAbs2().dot(I);
  const auto y = own.function->values(model, {-1, 0.0, 0.5});
  for (const auto& [value, s] : {std::pair(y[0], -1.0), std::pair(y[1], 0.0), std::pair(y[2], 0.5)})
    EXPECT_NEAR(value, T * s * s + 2.5 * s, 16 * kEpsilon * (T + 2.5));
}

TEST(PlotKeys, AFunctionHasGapsAtItsPoles) {
  const OwnPlot own = own_plot(R"x({ curve = "1/x", x = { of = "u", from = -1, to = 1 } })x");
  const SceneModel model = make_model(Scene(), ModelFor::page);
  const auto y = own.function->values(model, {0.0, 0.5});
  EXPECT_TRUE(std::isnan(y[0]));
  EXPECT_EQ(y[1], 2.0);
}

TEST(PlotKeys, ReadAsTheyAreWritten) {
  for (const char* table :
       {R"x({ plot = ["T", "mgl*u", "E"], tex = ['T', 'V', 'E'], range = "tight" })x",
        R"x({ plot = "acos(u)", unit = "deg", range = [0, 180], title = "Tilt $\theta$" })x",
        R"x({ plot = ["w2", "w3"], against = { of = "w1", unit = "deg/s" }, unit = "mrad/s" })x",
        R"x({ curve = "mgl*x", x = { of = "u", from = -0.5, to = 0.5 }, level = "E", tex = 'U' })x",
        R"x({ curve = "cos(y)", var = "y", x = { of = "acos(u)", unit = "deg", from = 10, to = 90 } })x"}) {
    std::string lines(table);
    // What TOML takes between double quotes has other backslashes.
    const std::size_t at = lines.find("\"Tilt $\\theta$\"");
    if (at != lines.npos) lines.replace(at, 15, "'Tilt $\\theta$'");
    const auto plots = plots_of("[" + lines + "]");
    EXPECT_EQ(plots_of(plots_text(plots)), plots) << plots_text(plots);
  }
}

TEST(PlotKeys, SayWhatIsWrongAndWhere) {
  // Column of the value, in the line "meters = …".
  EXPECT_THAT(complaint("3"), HasSubstr("18:10: error: \"meters\" takes a list of plots, found a number"));
  EXPECT_THAT(complaint("[3]"), HasSubstr("18:11: error: a plot is a name or a table"));
  EXPECT_THAT(complaint("[{ }]"), HasSubstr("has neither"));
  EXPECT_THAT(complaint(R"x([{ plot = "T", curve = "x" }])x"), HasSubstr("not both"));
  EXPECT_THAT(complaint(R"x([{ plot = [] }])x"), HasSubstr("nothing is plotted"));
  EXPECT_THAT(complaint(R"x([{ plot = 7 }])x"), HasSubstr("takes a string or a list of strings"));
  EXPECT_THAT(complaint(R"x([{ plot = ["T","T","T","T","T","T","T"] }])x"), HasSubstr("at most 6"));
  EXPECT_THAT(complaint(R"x([{ plot = "tilt" }])x"), HasSubstr("tilt"));
  EXPECT_THAT(complaint(R"x([{ plot = "L" }])x"), HasSubstr("comp(L, 1)"));
  EXPECT_THAT(complaint(R"x([{ plot = ["T", "w1"] }])x"), HasSubstr("units disagree"));
  EXPECT_THAT(complaint(R"x([{ plot = "T", unit = "mm" }])x"), HasSubstr("units disagree"));
  EXPECT_THAT(complaint(R"x([{ plot = "T", unit = "ells" }])x"), HasSubstr("unknown unit"));
  EXPECT_THAT(complaint(R"x([{ plot = "T", range = "wide" }])x"), HasSubstr("unknown range"));
  EXPECT_THAT(complaint(R"x([{ plot = "T", range = [2, 1] }])x"), HasSubstr("[lowest, highest]"));
  EXPECT_THAT(complaint(R"x([{ plot = "T", range = [0, inf] }])x"), HasSubstr("must be finite"));
  EXPECT_THAT(complaint(R"x([{ plot = ["T", "E"], tex = ['T'] }])x"), HasSubstr("there are 2, and 1 names"));
  EXPECT_THAT(complaint(R"x([{ plot = "T", tex = '\frac' }])x"), HasSubstr("error"));
  EXPECT_THAT(complaint(R"x([{ plot = "T", title = " " }])x"), HasSubstr("a title is one line"));
  EXPECT_THAT(complaint(R"x([{ plot = "T", titel = "T" }])x"), HasSubstr("titel"));
  EXPECT_THAT(complaint(R"x([{ plot = "T", level = "E" }])x"), HasSubstr("level"));
  EXPECT_THAT(complaint(R"x([{ plot = "T", against = 3 }])x"), HasSubstr("takes a string or a table"));
  EXPECT_THAT(complaint(R"x([{ plot = "T", against = "omega" }])x"), HasSubstr("is a vector"));
  EXPECT_THAT(complaint(R"x([{ plot = "T", against = { unit = "J" } }])x"), HasSubstr("lacks \"of\""));
}

TEST(PlotKeys, SayWhatIsWrongWithAFunction) {
  const auto with = [](const std::string& curve, const std::string& rest) {
    return complaint("[{ curve = \"" + curve + "\", " + rest + " }]");
  };
  const std::string x = "x = { of = \"u\", from = -1, to = 1 }";
  EXPECT_THAT(complaint(R"x([{ curve = "x" }])x"), HasSubstr("a curve needs an axis"));
  EXPECT_THAT(with("x", "x = [-1, 1]"), HasSubstr("\"x\" takes a table"));
  EXPECT_THAT(with("x", R"(x = { of = "u", from = -1 })"), HasSubstr("lacks \"to\""));
  EXPECT_THAT(with("x", R"(x = { of = "u", from = 1, to = -1 })"), HasSubstr("must be greater than"));
  EXPECT_THAT(with("x", R"(x = { of = "u", from = nan, to = -1 })"), HasSubstr("must be finite"));
  EXPECT_THAT(with("x", R"(x = { of = "e3", from = 0, to = 1 })"), HasSubstr("is a vector"));
  EXPECT_THAT(with("mgl*y", x), HasSubstr("y"));
  EXPECT_THAT(with("mgl", x), HasSubstr("does not depend on \"x\""));
  EXPECT_THAT(with("x*omega", x), HasSubstr("is a vector"));
  EXPECT_THAT(with("T + x", x), HasSubstr("units disagree"));
  EXPECT_THAT(with("mgl*x", x + ", level = \"w1\""), HasSubstr("units disagree"));
  EXPECT_THAT(with("mgl*u", x + ", var = \"u\""), HasSubstr("has this word already"));
  EXPECT_THAT(with("mgl*T", x + ", var = \"T\""), HasSubstr("no word for a variable"));
}

TEST(PlotKeys, WhatStepsGoOnWithIsBounded) {
  // Words of a definition count where they are written out.
  std::string sum = "T";
  for (int i = 0; i < 200; ++i) sum += "+T";
  EXPECT_THAT(complaint("[{ plot = \"" + sum + "\" }]"), HasSubstr("at most 256 parts"));
  // 36 curves of 4 KiB in all: some 300 of 128 bytes with what they need besides, in the scene of
  // each of 2000 steps.
  std::string curves;
  for (int i = 0; i < 6; ++i) curves += "\"" + std::string(600, ' ') + "T\", ";
  std::string meters;
  for (int i = 0; i < 6; ++i) meters += "{ plot = [" + curves + "] }, ";
  std::string text = lesson_with_meters("[" + meters + "]");
  for (int stage = 0; stage < 20; ++stage) {
    text += "\n# T {s" + std::to_string(stage) + "}\n\n```scene\nmeters = [" + meters + "]\n```\n";
    for (int step = 1; step < 100; ++step) text += "\n---\n\n```scene\nat = 1\n```\n";
  }
  const auto lines = testing::complaints(text);
  ASSERT_FALSE(lines.empty());
  EXPECT_THAT(lines.front(), HasSubstr("at most 50000 parts"));
}

/// The example of FORMAT.md.
const Lesson& example() {
  static const Lesson kLesson = [] {
    const std::string text = testing::read_file(test::source_dir() / "lessons" / "FORMAT.md");
    const std::string opening = "\n````markdown\n";
    const std::size_t begin = text.find(opening, text.find("\n## Plots\n")) + opening.size();
    LessonReading reading =
        read_lesson(text.substr(begin, text.find("\n````\n", begin) + 1 - begin), "effective-potential.md");
    if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
    EXPECT_THAT(testing::lines_of(reading.diagnostics), IsEmpty());
    return std::move(*reading.lesson);
  }();
  return kLesson;
}

TEST(PlotsOfTheFormat, TheTopTurnsBackWhereItsPotentialMeetsItsLevel) {
  const Scene& scene = *example().stages.front().steps.front().scene;
  const SceneModel model = make_model(scene, ModelFor::page);
  const PlotFunction& f = *std::get<OwnPlot>(scene.meters.at(1)).function;
  const auto level_at = [&](double t_s) { return f.level->value(model, t_s, model.motion->at(t_s))->x(); };
  const auto u_at = [&](double t_s) { return f.of.value(model, t_s, model.motion->at(t_s))->x(); };
  // E' − U(u) = ½ I1 θ̇², with θ̇ the rate of Euler's angle: a difference of the motion's angles.
  const double I1 = scene.body.moments.vector()[0];
  constexpr double kStep_s = 1e-4;
  for (const double t_s : {0.01, 0.1, 0.37}) {
    const auto theta = [&](double at_s) { return euler_angles_of(model.motion->at(at_s).q_SB).theta_rad; };
    const double rate = (theta(t_s + kStep_s) - theta(t_s - kStep_s)) / (2 * kStep_s);
    const double kinetic = 0.5 * I1 * rate * rate, U = f.values(model, {u_at(t_s)}).front();
    // The difference is good to (Ωh)²/6 of θ̇, at the rate Ω = I3 ω3/I1 of the nutation; the motion to 1e-10
    // a step, of the energy of the spin, which is taken away.
    const double I3 = scene.body.moments.vector()[2], w3 = scene.w0_B[2];
    const double step = I3 * w3 / I1 * kStep_s, spin = 0.5 * I3 * w3 * w3;
    EXPECT_NEAR(level_at(t_s) - U, kinetic, step * step * kinetic + 1e-8 * spin) << t_s;
  }
  // Let go at rest in θ: there it meets the level.
  EXPECT_NEAR(f.values(model, {u_at(0)}).front(), level_at(0), 1e-12 * std::abs(level_at(0)));
}

TEST(PlotKeys, AScaleMayBeLogarithmic) {
  EXPECT_FALSE(own_plot("{ plot = 'w1' }").is_log);
  const OwnPlot plot = own_plot("{ plot = 'norm(omega)', scale = 'log', range = [1e-6, 1] }");
  EXPECT_TRUE(plot.is_log);
  EXPECT_EQ(plot.range, std::pair(1e-6, 1.0));
  EXPECT_THAT(plots_text({plot}), HasSubstr("scale = \"log\""));
  EXPECT_THAT(complaint("[{ plot = 'w1', scale = 'logs' }]"), HasSubstr("unknown scale \"logs\""));
  EXPECT_THAT(complaint("[{ plot = 'w1', scale = 'log', range = [0, 1] }]"),
              HasSubstr("a logarithmic scale begins above 0"));
}

}  // namespace
}  // namespace polhode
