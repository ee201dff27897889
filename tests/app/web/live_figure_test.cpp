// SPDX-License-Identifier: MIT
#include "app/web/live_figure.h"

#include "app/page/page.h"
#include "app/session/camera_moves.h"
#include "app/web/live_json.h"
#include "physics/body/euler.h"
#include "physics/method.h"
#include "render/scene/model/scene_problem.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace polhode {
namespace {

using Json = nlohmann::json;
constexpr Size kSize{640, 480};

const char* const kLesson = R"(+++
format = 1
id = "thrown"
title = "Thrown"
[symbols]
omega = { tex = '\vec\omega', role = "omega", say = "angular velocity", unit = "rad/s" }
+++

# Turning {turning}

The tip of $\vec\omega$ goes round.

```scene
body    = "textbook"
omega   = [0.3, 0.2, 3.0]
attitude = [0.8, 0.6, 0, 0]
show    = ["shape", "omega", "L", "polhode"]
caption = 'a free body'
vary    = { omega3 = { from = 1, to = 4 } }
```

# Words {words}

No figure.
)";

/// Open at its first step, and laid out, so that hands know where things are.
void open(LiveFigure& figure) {
  figure.begin_call();
  ASSERT_TRUE(figure.open_lesson(kLesson, "thrown.md"));
  ASSERT_TRUE(figure.show(std::string_view("turning"), 1));
  ASSERT_TRUE(figure.lay_out(kSize, LiveFigure::Picture::figure, 1));
}

Json state_of(LiveFigure& figure) { return Json::parse(state_json(figure, "")); }

Vec2 tip_of(LiveFigure& figure) {
  const Json tip = state_of(figure).at("tips").at(0);
  return {tip.at("x").get<double>(), tip.at("y").get<double>()};
}

Vec3 vector_of(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

TEST(LiveFigure, OpensALessonAndShowsTheFigureOfAStep) {
  LiveFigure figure;
  open(figure);
  EXPECT_EQ(state_of(figure).at("stage_id"), "turning");
  EXPECT_GT(figure.height_for(640), 100);
  const Json words = Json::parse(words_json(figure));
  EXPECT_NE(words.at("alt").get<std::string>().find("angular velocity"), std::string::npos) << words;
  EXPECT_EQ(words.at("captions").at(0).at("text"), "a free body");
  EXPECT_EQ(Json::parse(choices_json(figure)).at("methods").size(), all_methods().size());
}

// A number that is typed and checked (\value) stays as it is typed, also where a caption's formulas are read
// anew.
TEST(LiveFigure, SaysACaptionsTypedAndComputedNumbers) {
  std::string text = kLesson;
  const std::string caption = "'a free body'";
  text.replace(text.find(caption), caption.size(),
               R"('at $\value{3.02}{norm(omega)}$ and $\live[digits=4]{w3}$')");
  LiveFigure figure;
  figure.begin_call();
  ASSERT_TRUE(figure.open_lesson(text, "thrown.md"));
  ASSERT_TRUE(figure.show(std::string_view("turning"), 1));
  ASSERT_TRUE(figure.set_time(0));
  const Json words = Json::parse(words_json(figure));
  EXPECT_EQ(words.at("captions").at(0).at("text"), "at 3.02 and 3.000");
  EXPECT_NE(words.at("alt").get<std::string>().find("3.02"), std::string::npos) << words;
}

// A diagram cannot be turned.
TEST(LiveFigure, KnowsWhetherItIsInSpace) {
  LiveFigure figure;
  open(figure);
  EXPECT_EQ(state_of(figure).at("in_space"), true);
  ASSERT_TRUE(figure.open_scene("body = \"textbook\"\nomega = [0.1, 3, 0.1]\nshow = [\"tensor-bars\"]", ""));
  EXPECT_EQ(state_of(figure).at("in_space"), false);
  ASSERT_TRUE(figure.open_scene(
      "body = \"textbook\"\nomega = [0.1, 3, 0.1]\nshow = [\"tensor-bars\", \"shape\"]", ""));
  EXPECT_EQ(state_of(figure).at("in_space"), true);
  ASSERT_TRUE(figure.open_scene(
      "body = \"textbook\"\nomega = [0.1, 3, 0.1]\nshow = []\nmeters = [{ plot = [\"T\"] }]", ""));
  EXPECT_EQ(state_of(figure).at("in_space"), false) << "plots alone";
}

// As the lesson has it, it stands for L's place, which goes with ω; stated, it is a place of its own.
TEST(LiveFigure, StartsFromAnAttitudeThatIsStated) {
  LiveFigure figure;
  open(figure);
  EXPECT_TRUE(state_of(figure).at("attitude0").is_null());
  ASSERT_TRUE(figure.set_attitude(Quat(2, 0, 2, 0)));
  ASSERT_TRUE(figure.set_omega({1, 2, 3}));
  ASSERT_TRUE(figure.set_time(0));
  const Json state = state_of(figure);
  const double half = std::sqrt(0.5);
  for (const char* name : {"attitude0", "quaternion"}) {
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(state.at(name).at(i).get<double>(), i % 2 == 0 ? half : 0, 1e-15) << name;
  }
  ASSERT_TRUE(figure.reset());
  EXPECT_TRUE(state_of(figure).at("attitude0").is_null());
}

// A stage is read when it is shown, as in the whole lesson; a slide, which may speak of others, has it whole.
TEST(LiveFigure, ReadsAStageWhenItIsShown) {
  std::string text = kLesson;
  text += "\n---\n\nIt goes with {broken.\n\n```scene\nbody = \"no-such-body\"\n```\n";
  LiveFigure figure;
  figure.begin_call();
  ASSERT_TRUE(figure.open_lesson(text, "thrown.md"));
  EXPECT_EQ(figure.session()->lesson().stages.size(), 2U);
  EXPECT_EQ(figure.session()->lesson().stages[1].id, "words");
  ASSERT_TRUE(figure.show(std::string_view("turning"), 1));
  ASSERT_TRUE(figure.set_omega({1, 2, 3}));
  const Status broken = figure.show(std::string_view("words"), 2);
  ASSERT_FALSE(broken);
  EXPECT_NE(broken.error().find("no-such-body"), std::string::npos) << broken.error();
  EXPECT_EQ(vector_of(state_of(figure).at("omega0")), Vec3(1, 2, 3)) << "what was shown stays";
  EXPECT_FALSE(figure.lay_out(kSize, LiveFigure::Picture::slide, 1)) << "a slide has the lesson whole";
  open(figure);
  ASSERT_TRUE(figure.set_omega({1, 2, 3}));
  ASSERT_TRUE(figure.set_time(0.5));
  const Json before = state_of(figure);
  ASSERT_TRUE(figure.lay_out(kSize, LiveFigure::Picture::slide, 1));
  EXPECT_EQ(figure.session()->lesson().stages[1].steps[0].blocks.size(), 1U);
  const Json after = state_of(figure);
  for (const char* name : {"stage", "omega0", "t", "changed"}) EXPECT_EQ(after.at(name), before.at(name));
}

TEST(LiveFigure, RefusesInWords) {
  LiveFigure figure;
  EXPECT_EQ(state_json(figure, ""), "null");
  EXPECT_FALSE(figure.show(1, 1));
  EXPECT_FALSE(figure.set_omega({1, 2, 3}));
  open(figure);
  const Status no_stage = figure.show(std::string_view("nowhere"), 1);
  ASSERT_FALSE(no_stage);
  EXPECT_EQ(no_stage.error(), "The lesson has no such stage.");
  EXPECT_FALSE(figure.show(1, 2));
  EXPECT_FALSE(figure.show(std::string_view("words"), 1));
  EXPECT_FALSE(figure.set_moments({1, 1, 3}));  // more than the sum of the other two
  EXPECT_FALSE(figure.set_method("rk5", 0.01));
  EXPECT_FALSE(figure.set_attitude(Quat(0, 0, 0, 0)));
  EXPECT_FALSE(figure.set_body("cloud"));
  EXPECT_FALSE(figure.show_overlay("halo", true));
  EXPECT_FALSE(figure.draw(kSize, LiveFigure::Picture::figure, 1)) << "without a canvas";
  EXPECT_FALSE(state_of(figure).at("changed").get<bool>());
  const Status wrong = figure.open_lesson("no lesson", "none.md");
  EXPECT_FALSE(wrong);
  EXPECT_EQ(state_of(figure).at("stage_id"), "turning") << "the lesson of before stays";
}

TEST(LiveFigure, TellsTheMotionWithAllItsDigits) {
  LiveFigure figure;
  open(figure);
  ASSERT_TRUE(figure.set_time(1.25));
  const Json state = state_of(figure);
  const RigidBodyState now = figure.model()->motion->at(1.25);
  EXPECT_EQ(vector_of(state.at("omega")), now.w_B);
  EXPECT_EQ(state.at("quaternion").at(0).get<double>(), now.q_SB.w());
  EXPECT_EQ(state.at("T").get<double>(), kinetic_energy(figure.model()->scene.body.moments, now.w_B));
  EXPECT_TRUE(state.at("error").is_null());
  const Vec3 sum =
      vector_of(state.at("terms").at("inertial")) + vector_of(state.at("terms").at("gyroscopic"));
  EXPECT_LT(sum.norm(), 1e-10);  // N = 0; the rate is a difference quotient
}

/// The keys of all objects in it.
void add_keys(const Json& json, std::set<std::string>& keys) {
  if (json.is_object())
    for (const auto& [key, value] : json.items()) keys.insert(key);
  if (json.is_structured())
    for (const Json& part : json) add_keys(part, keys);
}

std::set<std::string> keys_of(const std::string& text) {
  std::set<std::string> keys;
  add_keys(Json::parse(text), keys);
  return keys;
}

/// The keys that live_api.h says an answer has: what stands in quotes above the function, but for values.
std::set<std::string> described_keys(const std::string& function) {
  std::ostringstream header;
  header << std::ifstream(test::source_dir() / "app/web/live_api.h").rdbuf();
  std::string text = header.str();
  const std::size_t end = text.find(function);
  EXPECT_NE(end, text.npos) << function;
  text.resize(end);
  text.erase(0, text.rfind(";\n") + 1);
  static const std::regex kValue(R"re(": *"\w+"(\|"\w+")*)re"), kKey(R"re("(\w+)")re");
  text = std::regex_replace(text, kValue, "\"");
  std::set<std::string> keys;
  for (std::sregex_iterator at(text.begin(), text.end(), kKey), none; at != none; ++at)
    keys.insert((*at)[1].str());
  return keys;
}

TEST(LiveFigure, SaysWhatItsHeaderLists) {
  LiveFigure figure;
  open(figure);
  EXPECT_EQ(keys_of(words_json(figure)), described_keys("const char* polhode_words(void)"));
  ASSERT_TRUE(figure.set_method("explicit-euler", 0.01));
  ASSERT_TRUE(figure.set_time(1));
  ASSERT_TRUE(figure.lay_out(kSize, LiveFigure::Picture::figure, 1));
  EXPECT_EQ(keys_of(state_json(figure, "")), described_keys("const char* polhode_state(void)"));
  EXPECT_EQ(keys_of(choices_json(figure)), described_keys("const char* polhode_choices(void)"));
}

TEST(LiveFigure, AMethodHasItsErrorAgainstTheClosedForm) {
  LiveFigure figure;
  open(figure);
  ASSERT_TRUE(figure.set_method("explicit-euler", 0.01));
  ASSERT_TRUE(figure.set_time(1));
  const double coarse = state_of(figure).at("error").at("omega").get<double>();
  ASSERT_TRUE(figure.set_method("rk4", 0.01));
  const double fine = state_of(figure).at("error").at("omega").get<double>();
  EXPECT_GT(coarse, 1e3 * fine);
  EXPECT_GT(fine, 0);
  ASSERT_TRUE(figure.set_method("", 0));
  EXPECT_TRUE(state_of(figure).at("error").is_null());
}

TEST(LiveFigure, TheTipOfOmegaGoesWithTheHandAndKeepsItsEnergy) {
  LiveFigure figure;
  open(figure);
  const double T = state_of(figure).at("T").get<double>();
  const Vec2 from = tip_of(figure), to = from + Vec2(30, 24);
  EXPECT_EQ(figure.point_move(from, 12), FigureHand::On::omega);
  ASSERT_EQ(figure.point_down(from, 12), FigureHand::On::omega);
  // The caption goes with the first change, as it may be true no longer, and the figure has its room: a hand
  // is told of it by the next picture.
  EXPECT_EQ(figure.point_move((from + to) / 2, 12), FigureHand::On::omega);
  ASSERT_TRUE(figure.lay_out(kSize, LiveFigure::Picture::figure, 1));
  EXPECT_EQ(figure.point_move(to, 12), FigureHand::On::omega);
  EXPECT_EQ(figure.refused_drag(), "");
  ASSERT_TRUE(figure.lay_out(kSize, LiveFigure::Picture::figure, 1));
  EXPECT_LT((tip_of(figure) - to).norm(), 0.5);  // px; the search ends within 0.2
  figure.point_up();
  const Json state = state_of(figure);
  EXPECT_NEAR(state.at("T").get<double>(), T, 1e-12 * T);
  EXPECT_TRUE(state.at("changed").get<bool>());
  // What is shown from now on is the motion that starts there.
  const Scene& scene = figure.model()->scene;
  ASSERT_TRUE(figure.set_time(2));
  const auto motion = make_motion(problem_of(scene), {Method::exact});
  EXPECT_EQ(vector_of(state_of(figure).at("omega")), motion->at(2).w_B);
  ASSERT_TRUE(figure.undo());
  EXPECT_EQ(figure.model()->scene.w0_B, Vec3(0.3, 0.2, 3.0));
  EXPECT_FALSE(figure.undo());
}

// 2026-11-27: the tip was taken and did not move, for "uniform" serves no other ω.
TEST(LiveFigure, AHandOnASteadyRotationGetsTheMotionThatAnyOmegaHas) {
  LiveFigure figure;
  figure.begin_call();
  const Status opened = figure.open_scene(
      "body = \"textbook\"\nomega = [0, 0, 2]\nmotion = \"uniform\"\nshow = [\"shape\", \"omega\"]\n", "");
  ASSERT_TRUE(opened) << opened.error();
  ASSERT_TRUE(figure.show(1, 1));
  ASSERT_TRUE(figure.lay_out(kSize, LiveFigure::Picture::figure, 1));
  const Vec2 from = tip_of(figure);
  ASSERT_EQ(figure.point_down(from, 12), FigureHand::On::omega);
  figure.point_move(from + Vec2(25, 5), 12);
  EXPECT_EQ(figure.refused_drag(), "");
  EXPECT_EQ(figure.model()->motion->method(), name_of(Method::exact));
  EXPECT_GT(figure.model()->scene.w0_B.head<2>().norm(), 0.1);
}

// 2026-11-27: names were half as large while a slow machine drew half of the pixels.
TEST(LiveFigure, ItsNamesKeepTheirSizeWhileItIsDrawnByFewerPixels) {
  LiveFigure figure;
  open(figure);
  for (const LiveFigure::Picture what : {LiveFigure::Picture::figure, LiveFigure::Picture::slide}) {
    ASSERT_TRUE(figure.lay_out(kSize, what, 1));
    const double size = figure.insets().at(0).figure.caption_px;
    ASSERT_TRUE(figure.lay_out(kSize, what, 0.5));
    EXPECT_EQ(figure.insets().at(0).figure.caption_px, size);
  }
}

TEST(LiveFigure, ADragBesideItTurnsTheCameraAsInTheWindow) {
  LiveFigure figure;
  open(figure);
  const Inset& inset = figure.insets().at(0);
  const Vec2 at(inset.place.x + 5, inset.place.y + 5);
  const CameraSpec wanted = writable(orbited(figure.model()->scene.camera, 40, -25, inset.place.height));
  ASSERT_EQ(figure.point_down(at, 12), FigureHand::On::figure);
  figure.point_move(at + Vec2(40, -25), 12);
  figure.point_up();
  EXPECT_EQ(figure.session()->camera(), wanted);
  figure.zoom(2);
  EXPECT_EQ(figure.session()->camera(), writable(zoomed(wanted, 2)));
  figure.point_twice();
  EXPECT_EQ(figure.session()->camera().azimuth_rad,
            writable(figure.session()->lesson_scene().camera).azimuth_rad);
}

TEST(LiveFigure, PlaysAndStandsAndIsTheLessonsAgain) {
  LiveFigure figure;
  open(figure);
  EXPECT_FALSE(figure.advance(0.1));
  figure.set_playing(true);
  EXPECT_TRUE(figure.advance(0.1));
  EXPECT_GT(figure.session()->t_s(), still_time_s(figure.session()->lesson_scene()));
  ASSERT_TRUE(figure.vary(0, 2));
  EXPECT_EQ(state_of(figure).at("omega0").at(2).get<double>(), 2);
  ASSERT_TRUE(figure.press_key("R"));
  EXPECT_FALSE(figure.press_key("Ctrl+Q")) << "a command of the window";
  ASSERT_TRUE(figure.reset());
  const Json state = state_of(figure);
  EXPECT_FALSE(state.at("changed").get<bool>());
  EXPECT_FALSE(state.at("playing").get<bool>());
  EXPECT_EQ(state.at("t"), state.at("still"));
}

TEST(LiveFigure, ASceneWithoutALesson) {
  LiveFigure figure;
  figure.begin_call();
  ASSERT_TRUE(figure.open_scene("body = \"own\"\nomega = [0.1, 2, 0.1]\nshow = [\"shape\", \"omega\"]",
                                "moments = [1.0, 2.0, 2.9]"));
  EXPECT_EQ(vector_of(state_of(figure).at("moments")), Vec3(1.0, 2.0, 2.9));
  EXPECT_FALSE(figure.open_scene("body = \"no-such-body\"", ""));
}

TEST(LiveFigure, WhatTakesTooLongIsNotComputed) {
  LiveFigure figure;
  open(figure);
  ASSERT_TRUE(figure.set_method("rk4", 1e-9));
  figure.begin_call();
  bool is_followed = true;  // 80 billion evaluations: refused by what it would cost, or ended on the way
  try {
    is_followed = figure.set_time(20).ok();
  } catch (const BudgetSpent&) {
    is_followed = false;
  }
  EXPECT_FALSE(is_followed);
}

TEST(LiveFigure, DrawsThePictureOfAReadersPage) {
  auto context = open_context(ContextKind::any);
  ASSERT_TRUE(context) << context.error();
  LiveFigure figure;
  open(figure);
  ASSERT_TRUE(figure.attach(std::move(context).value()));
  ASSERT_TRUE(figure.draw(kSize, LiveFigure::Picture::figure, 1));
  const Result<Image> first = figure.read();
  ASSERT_TRUE(first);
  ASSERT_TRUE(figure.draw(kSize, LiveFigure::Picture::figure, 1));
  EXPECT_EQ(figure.read()->rgba, first->rgba);
  ASSERT_TRUE(figure.set_time(1));
  ASSERT_TRUE(figure.draw(kSize, LiveFigure::Picture::figure, 1));
  EXPECT_NE(figure.read()->rgba, first->rgba);
  ASSERT_TRUE(figure.reset());
  ASSERT_TRUE(figure.draw(kSize, LiveFigure::Picture::slide, 1)) << "the slide";
  EXPECT_NE(figure.read()->rgba, first->rgba);
  figure.detach();
  EXPECT_FALSE(figure.read());
  auto again = open_context(ContextKind::any);
  ASSERT_TRUE(again) << again.error();
  ASSERT_TRUE(figure.attach(std::move(again).value()));
  ASSERT_TRUE(figure.draw(kSize, LiveFigure::Picture::figure, 1));
  EXPECT_EQ(figure.read()->rgba, first->rgba) << "after a context was lost";
}

}  // namespace
}  // namespace polhode
