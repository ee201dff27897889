// SPDX-License-Identifier: MIT
// What is saved reads back as what was there.
#include "app/session/saved/saved_scene.h"

#include "lessons/reader/checks/lesson_check.h"
#include "lessons/reader/scene/scene_keys.h"
#include "physics/body/torque_text.h"
#include "render/scene/model/scene_problem.h"
#include "tests/app/run_program.h"
#include "tests/app/session/example_lesson.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace polhode {
namespace {

using test::example;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// What the session shows, as its saved lesson should state it.
Scene shown_in(const LessonSession& session) {
  Scene scene = session.model()->scene;
  const double t_s = session.t_s();
  for (Scene& other : scene.beside)
    if (!caption_holds(other, t_s)) leave_out_caption(other);
  if (!caption_holds(scene, t_s)) leave_out_caption(scene);
  if (!is_computable(*session.model(), scene.at_s)) scene.at_s = t_s;
  for (std::size_t i = 0; i < scene.beside.size(); ++i)
    if (!is_computable(session.model()->beside[i], scene.beside[i].at_s)) scene.beside[i].at_s = t_s;
  scene.still_s = t_s == scene.at_s ? std::nullopt : std::optional(t_s);
  for (Scene& other : scene.beside) other.still_s = scene.still_s;
  return scene;
}

/// The last step of the only stage of the saved lesson.
Step saved_step(const LessonSession& session) {
  const std::string text = lesson_of(session);
  LessonReading reading = check_lesson(text, "saved.md");
  for (const Diagnostic& diagnostic : reading.diagnostics)
    // An overlay that a hand has chosen may show nothing of this motion, and is saved as chosen.
    if (!diagnostic.message.starts_with("in the scene of line "))
      ADD_FAILURE() << to_string(diagnostic) << "\nin\n" << text;
  if (!reading.lesson || reading.lesson->stages.size() != 1) throw std::runtime_error(text);
  EXPECT_EQ(reading.lesson->id, session.stage().id);
  EXPECT_EQ(reading.lesson->stages[0].steps.size(), session.place().step + 1);
  return reading.lesson->stages[0].steps.back();
}

void expect_saved(const LessonSession& session) {
  const Step saved = saved_step(session);
  ASSERT_EQ(saved.scene != nullptr, session.has_scene());
  if (!saved.scene) return;
  Scene expected = shown_in(session);
  ASSERT_EQ(saved.scene->beside.size(), expected.beside.size());
  // Beside one that a hand has turned, the attitude that another has by default is said.
  for (std::size_t i = 0; i < expected.beside.size(); ++i) {
    if (saved.scene->beside[i].attitude && !expected.beside[i].attitude)
      expected.beside[i].attitude = attitude_spec(expected.beside[i]);
    // Of two bodies that a hand has made different the second has a name of its own.
    const std::string& name = saved.scene->beside[i].body.name;
    if (name == expected.beside[i].body.name + "-2") expected.beside[i].body.name = name;
  }
  EXPECT_TRUE(*saved.scene == expected)
      << session.lesson().id << ' ' << session.stage().id << "\nwants\n"
      << scene_keys_text(expected, session.t_s()) << "\nhas\n"
      << scene_keys_text(*saved.scene, still_time_s(*saved.scene)) << "\nin\n"
      << lesson_of(session);
}

void go_to_last_step(LessonSession& session, std::size_t stage) {
  session.go_to({stage, session.lesson().stages[stage].steps.size() - 1});
}

TEST(SavedScene, EveryStageOfTheLessonsComesBack) {
  for (const char* id : test::kLessons) {
    LessonSession session(test::loaded_lesson(id));
    for (std::size_t stage = 0; stage < session.lesson().stages.size(); ++stage) {
      go_to_last_step(session, stage);
      expect_saved(session);
    }
  }
}

TEST(SavedScene, TextEquationsClaimsAndQuestionsComeBack) {
  for (const char* id : test::kLessons) {
    LessonSession session(test::loaded_lesson(id));
    for (std::size_t stage = 0; stage < session.lesson().stages.size(); ++stage) {
      go_to_last_step(session, stage);
      const Step saved = saved_step(session);
      const Step& step = session.step();
      ASSERT_EQ(saved.blocks.size(), step.blocks.size()) << session.stage().id;
      EXPECT_EQ(saved.title.empty(), step.title.empty()) << session.stage().id;
      for (std::size_t i = 0; i < step.blocks.size(); ++i) {
        ASSERT_EQ(saved.blocks[i].index(), step.blocks[i].index());
        if (const auto* equation = std::get_if<Equation>(&step.blocks[i])) {
          EXPECT_EQ(std::get<Equation>(saved.blocks[i]).tex, equation->tex);
        }
        if (const auto* prose = std::get_if<Prose>(&step.blocks[i])) {
          // Links to other stages lead out of what is saved.
          if (prose->markdown.find("](#") == std::string::npos) {
            EXPECT_EQ(std::get<Prose>(saved.blocks[i]).markdown, prose->markdown);
          }
        }
      }
    }
  }
}

TEST(SavedScene, StepsThatBeginWithTheirTitleEndBeforeTheNextOne) {
  LessonSession session(
      test::loaded_text("+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n+++\n# A {a}\n\n## One\n\nfirst\n\n## "
                        "Two\n\nsecond\n\n---\n\nthird\n\n# B {b}\n\nx\n"));
  const auto saved = [&] { return lesson_of(session); };
  EXPECT_THAT(saved(), AllOf(HasSubstr("## One"), HasSubstr("first"), Not(HasSubstr("Two"))));
  session.next_step();
  EXPECT_THAT(saved(), AllOf(HasSubstr("## Two"), HasSubstr("second"), Not(HasSubstr("third"))));
  session.next_step();
  EXPECT_THAT(saved(), AllOf(HasSubstr("third"), Not(HasSubstr("# B"))));
}

TEST(SavedScene, LinksToWhatIsNotSavedLeadToTheLesson) {
  LessonSession session(
      test::loaded_text("+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n+++\n# A {a}\n\nSee [](#b), [it](#b), "
                        "[](#b/eq), [](#here), [later](#late) "
                        "and [](#a).\n\n```math here\nx \\tag{1}\n```\n\n---\n\n```math late\ny "
                        "\\tag{2}\n```\n\n# The other $L$ {b}\n\n"
                        "```math eq\nz \\tag{3}\n```\n"));
  EXPECT_THAT(
      lesson_of(session),
      HasSubstr(
          "See [The other $L$](x#b), [it](x#b), [(3)](x#b/eq), [](#here), [later](x#a/late) and [](#a)."));
  saved_step(session);
  session.next_step();
  EXPECT_THAT(lesson_of(session), HasSubstr("[later](#late)"));
}

TEST(SavedScene, ATableOfAnotherMotionIsLeftOutWithAWord) {
  const std::string table =
      "\n```table\ncolumns = [{ head = \"T\", of = \"T\" }]\nrows = [{ motion = { method = "
      "\"implicit-midpoint\", step = 0.1 } }, {}]\n```\n";
  LessonSession session(test::loaded_text(
      "+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n+++\n# A {a}\n\n```scene\nbody = \"book\"\nomega = [1, 2, "
      "3]\n```\n" +
      table + "\n---\n\nmore\n\n```scene\ntorque = \"body:1,0,0\"\n```\n"));
  EXPECT_THAT(lesson_of(session), HasSubstr("```table"));
  session.next_step();
  EXPECT_THAT(lesson_of(session), AllOf(Not(HasSubstr("```table")), HasSubstr("left out here")));
  saved_step(session);
}

/// What a hand may do, at random.
class Hand {
 public:
  explicit Hand(unsigned seed) : engine_(seed) {}

  SceneEdits edits(const Scene& scene) {
    SceneEdits edits;
    if (once_in(2)) edits.body = body();
    if (once_in(2)) edits.w0_B = Vec3(number(), number(), number());
    if (once_in(3)) edits.attitude = Quat(number(), number(), number(), number()).normalized();
    if (once_in(6)) edits.attitude = once_in(2) ? LPoints::down : LPoints::up;
    if (once_in(2)) edits.motion = motion();
    for (int i = 0; i < kOverlayCount; ++i)
      if (once_in(6) && !is_diagram(static_cast<Overlay>(i)))
        set_shown(edits, scene, static_cast<Overlay>(i), once_in(2));
    if (once_in(2)) edits.views = views();
    if (once_in(2)) {
      edits.camera = CameraSpec{number(), 0.5 * number(), 4 + number(), 2 + 0.5 * number()};
      if (once_in(2)) edits.camera->fitted = CameraFit{number(), 0.5 * number()};
      if (edits.camera->fitted && once_in(2)) edits.camera->fitted->w0_B = Vec3(number(), number(), number());
      if (edits.camera->fitted && once_in(2)) edits.camera->fitted->attitude = LPoints::down;
      edits.camera->holds_still = once_in(3);
    }
    if (once_in(2)) edits.quality = once_in(2) ? QualityLevel::draft : QualityLevel::fine;
    return edits;
  }
  double number() { return std::uniform_real_distribution(-3.0, 3.0)(engine_); }

 private:
  bool once_in(int n) { return std::uniform_int_distribution(1, n)(engine_) == 1; }

  Body body() {
    if (once_in(2)) {
      const auto names = named_bodies();
      return *find_body(names[std::uniform_int_distribution<std::size_t>(0, names.size() - 1)(engine_)]);
    }
    const double a = 4 + number(), b = 4 + number();
    return body_with_moments({a, b, std::abs(a - b) + 0.3 * std::min(a, b)}).value();
  }

  MotionSpec motion() {
    if (once_in(2))
      return {.method = Method::rk4, .step_s = 0.02 + 1e-3 * std::abs(number()), .ghost = once_in(2)};
    return {.method = Method::dormand_prince_8, .tolerance = 1e-9 * std::abs(number()), .ghost = true};
  }

  std::vector<View> views() {
    if (once_in(3)) return {View::space, View::body};
    return {once_in(2) ? View::space : View::body};
  }

  std::mt19937 engine_;
};

TEST(SavedScene, WhatAHandHasMadeOfItComesBackToTheBit) {
  unsigned seed = 1;
  int taken = 0, all = 0;
  for (const char* id : test::kLessons) {
    LessonSession session(test::loaded_lesson(id));
    for (std::size_t stage = 0; stage < session.lesson().stages.size(); ++stage) {
      go_to_last_step(session, stage);
      if (!session.has_scene()) continue;
      Hand hand(seed++);
      ++all;
      // Some cannot be: a herpolhode of too many turns, a body that flies too far.
      for (int tries = 0; tries < 5; ++tries)
        if (session.set_edits(hand.edits(session.lesson_scene())).ok()) {
          ++taken;
          break;
        }
      session.scrub_to(hand.number());
      expect_saved(session);
      session.set_following(true);
      session.scrub_to(hand.number());
      expect_saved(session);
    }
  }
  EXPECT_GT(taken, all / 2);
}

/// As an author writes its axis, with few digits.
TorqueTerm heavy_top(Hand& hand) {
  const auto text = fmt::format("heavy:{},{:.3g},{:.3g},{:.3g}", hand.number(), hand.number(), hand.number(),
                                hand.number());
  return parse_torque_term(text).value();
}

/// Components of an attitude likewise.
AttitudeSpec attitude(Hand& hand) {
  const auto rounded = [&] { return std::round(1e3 * hand.number()) / 1e3; };
  return attitude_from({rounded(), rounded(), rounded(), rounded()});
}

// What is saved has its still at the present t, of which such a caption does not speak.
TEST(SavedScene, ACaptionOfAnotherStillIsLeftOut) {
  LessonSession session(test::loaded_text(
      "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n+++\n# A stage {one}\n```scene\ncaption = 'Halfway'\n"
      "caption_when = 'still'\nat = 2\nshow = 'omega'\n```\nIt turns.\n"));
  EXPECT_THAT(lesson_of(session), AllOf(HasSubstr("Halfway"), HasSubstr("caption_when = \"still\"")));
  expect_saved(session);
  session.scrub_to(1);
  EXPECT_THAT(lesson_of(session), AllOf(Not(HasSubstr("Halfway")), Not(HasSubstr("caption_when"))));
}

TEST(SavedScene, DirectionsComeBackToTheBit) {
  Hand hand(7);
  const std::string front = "+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n+++\n# X {x}\n```scene\n";
  for (int i = 0; i < 200; ++i) {
    Scene scene;
    scene.attitude = i % 3 == 0 ? attitude(hand) : writable(attitude(hand));
    scene.torque = {SpaceTorque{{hand.number(), 1e-7, -1e20}}, BodyTorque{{0, hand.number(), 0.1}},
                    LinearDamping{std::abs(hand.number())}};
    if (i % 2 == 0) {
      scene.torque.push_back(heavy_top(hand));
    } else {  // what is held at a pivot has neither
      scene.v0_S = {hand.number(), 0, 1e-300};
      scene.F_S = {0, hand.number(), 3};
    }
    scene.arrow = i % 2 == 0 ? ArrowHeld::free : ArrowHeld::in_body;
    scene.duration_s = std::abs(hand.number());
    scene.rate = 1.0 / 3;
    scene.caption = "It's $\\vec L$ \\ \"so\"";
    scene.meters = std::vector<PlotSpec>{Meter::momentum, Meter::omega};
    const LessonReading reading = read_lesson(front + scene_keys_text(scene, 0) + "```\n", "x.md");
    ASSERT_TRUE(reading.lesson) << to_string(reading.diagnostics.front());
    EXPECT_TRUE(*reading.lesson->stages[0].steps[0].scene == scene) << scene_keys_text(scene, 0);
  }
}

TEST(SavedScene, SaysNothingOfWhatIsUsual) {
  EXPECT_EQ(scene_keys_text(Scene{}, 0), "");
  EXPECT_EQ(scene_keys_text(Scene{}, 2), "still = 2.0\n");
  for (const std::string& name : named_bodies()) EXPECT_EQ(own_body_of(*find_body(name), {}), "") << name;
}

TEST(SavedScene, PointingAtSomethingIsNotSaved) {
  LessonSession session(example());
  const std::string before = lesson_of(session);
  session.light("omega");
  EXPECT_EQ(lesson_of(session), before);
}

TEST(SavedScene, AStepThatWasItsSceneAloneIsThereStill) {
  LessonSession session(
      test::loaded_text("+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n+++\n# X {x}\n```scene\n"
                        "show = \"omega\"\n```\n---\n```scene\nshow = \"L\"\n```\n---\nText.\n"));
  session.go_to({0, 2});
  expect_saved(session);
  session.go_to({0, 1});
  expect_saved(session);
}

TEST(SavedScene, HighlightsOfTermsThatAreNotInItAreLeftOut) {
  LessonSession session(test::loaded_text(
      "+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n+++\n# X {x}\nText.\n```scene\nshow = \"omega\"\n"
      "highlight = [\"later\", \"omega\"]\n```\n---\n```math a\n\\term{later}{x} = 1\n```\n"));
  const Step saved = saved_step(session);
  EXPECT_EQ(saved.scene->highlight, std::vector<std::string>{"omega"});
  session.next_step();
  expect_saved(session);
}

TEST(SavedScene, MacrosAndSymbolsComeBack) {
  LessonSession session(test::loaded_text(
      "+++\nformat = 1\nid = \"x\"\ntitle = 'The \"X\"'\n[macros]\nprimed = { arguments = "
      "1, tex = \"#1'\" }\n"
      "half = '\\frac12'\n[symbols]\nomega = { tex = '\\vec\\omega', role = \"omega\", say = \"spin\", unit "
      "= \"rad/s\" }\nprimes = { tex = \"x'\" }\n+++\n# X {x}\nText $\\half\\primed{x}$.\n"));
  const std::string text = lesson_of(session);
  const LessonReading reading = check_lesson(text, "saved.md");
  ASSERT_TRUE(reading.lesson) << to_string(reading.diagnostics.front()) << text;
  const Lesson& lesson = session.lesson();
  EXPECT_EQ(reading.lesson->title, lesson.title);
  ASSERT_EQ(reading.lesson->macros.size(), lesson.macros.size());
  for (const auto& [name, macro] : lesson.macros) {
    EXPECT_EQ(reading.lesson->macros.at(name).body, macro.body);
    EXPECT_EQ(reading.lesson->macros.at(name).arguments, macro.arguments);
  }
  ASSERT_EQ(reading.lesson->symbols.size(), lesson.symbols.size());
  for (const auto& [name, symbol] : lesson.symbols) {
    const Symbol& read = reading.lesson->symbols.at(name);
    EXPECT_EQ(read.tex, symbol.tex);
    EXPECT_EQ(read.role, symbol.role);
    EXPECT_EQ(read.say, symbol.say);
    EXPECT_EQ(read.unit, symbol.unit);
  }
}

TEST(SavedScene, WhatCanBeAssumedComesBack) {
  LessonSession session(test::loaded_text(
      "+++\nformat = 1\nid = \"x\"\ntitle = 'X'\n[assume]\n"
      "near = { small = ['w1', 'w3'], order = 2 }\nflat = ['I2 = I1', 'I3 > I1']\n+++\n# X {x}\n"
      "```math a free given near\n\\dot\\omega_1 \\approx \\frac{I_2 - I_3}{I_1}\\omega_2\\omega_3\n```\n"
      "```math b identity given flat\nI_3 > I_2\n```\n"));
  const std::string text = lesson_of(session);
  const LessonReading reading = check_lesson(text, "saved.md");
  ASSERT_TRUE(reading.lesson) << to_string(reading.diagnostics.front()) << text;
  const Given& near = reading.lesson->assumptions.at("near");
  EXPECT_EQ(near.small.quantities, (std::vector{Quantity::w1, Quantity::w3}));
  EXPECT_EQ(near.small.order, 2);
  const Given& flat = reading.lesson->assumptions.at("flat");
  ASSERT_EQ(flat.bounds.size(), 1U);
  EXPECT_EQ(flat.bounds[0].text, "I3 > I1");
  EXPECT_EQ(flat.settings.size(), 1U);
}

TEST(SavedTrace, HasTheRowsThatTraceGives) {
  LessonSession session(test::loaded_text(
      "+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n[body.own]\nmoments = [1.0, 2.0, 2.5]\n+++\n# X "
      "{x}\n```scene\n"
      "body = \"own\"\nomega = [0.25, 2.0, 0.5]\nattitude = [1.0, 0.0, 0.0, 0.0]\nduration = 2.0\nrate = "
      "12.5\nshow = \"omega\"\n```\n"));
  const ProgramRun run = polhode({"trace", "--inertia", "1,2,2.5", "--omega", "0.25,2,0.5", "--from", "0",
                                  "--to", "2", "--every", "0.5"});
  EXPECT_EQ(trace_of(session), run.out) << run.err;
  session.scrub_to(3);
  EXPECT_THAT(trace_of(session), HasSubstr("\n3.5,"));
  EXPECT_THAT(trace_of(session), Not(HasSubstr("\n1.5,"))) << "the loop that is shown";
}

TEST(SavedTrace, IsOfBoundedLength) {
  LessonSession session(example());
  std::string text = example()->lesson.source;
  text.replace(text.find("at = 0.5"), 8, "duration = 1000.0\nrate = 1e-6");
  session.replace_lesson(test::loaded_text(text));
  const std::string csv = trace_of(session);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + kMostTraceLines);
  session.go_to({1, 0});
  EXPECT_EQ(trace_of(session), "");
}

TEST(SavedScene, ABodyOfAShapeOnItsPivotComesBack) {
  for (const char* body : {"book", "rod"}) {
    LessonSession session(test::loaded_text(fmt::format(
        "+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n[body.rod]\nshape = \"cylinder\"\n"
        "size_m = [0.2, 0.2, 0.02]\nmass_kg = 1.0\n+++\n# X {{x}}\nText.\n```scene\nbody = \"{}\"\n"
        "torque = \"heavy:0.980665,0,0,1\"\nshow = [\"shape\", \"pivot\"]\n```\n",
        body)));
    expect_saved(session);
    EXPECT_TRUE(saved_step(session).scene->body.shape) << body;
  }
}

TEST(SavedScene, ABodyByTheNameOfTheUsualOneComesBack) {
  LessonSession session(
      test::loaded_text("+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n[body.textbook]\nmoments = [1.0, 2.0, "
                        "2.5]\nmass_kg = 0.3\n+++\n# X {x}\nText.\n```scene\nbody = \"textbook\"\nshow = "
                        "\"shape\"\n```\n"));
  expect_saved(session);
  EXPECT_EQ(saved_step(session).scene->body.mass_kg, 0.3);
}

TEST(SavedScene, ATopComesBackToTheBit) {
  const char* const bodies[] = {"shape = \"cylinder\"\nsize_m = [0.2, 0.2, 0.02]\nmass_kg = 0.7",
                                "moments = [1.3, 1.3, 0.7]\nmass_kg = 0.3"};
  for (const char* body : bodies)
    for (double theta_deg : {0.0, 1.0, 33.3, 60.0, 90.0, 175.0})
      for (const char* more : {"", ", precession = -1.7", ", precession = \"slow\""}) {
        if (theta_deg == 0 && *more != '\0') continue;
        LessonSession session(test::loaded_text(fmt::format(
            "+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n[body.rod]\n{}\npivot_m = [0, 0, -0.13]\n+++\n# X "
            "{{x}}\n"
            "Text.\n```scene\nbody = \"rod\"\ntorque = [\"weight\", \"damping:0.1\"]\nshow = [\"shape\", "
            "\"pivot\"]\nstart = {{ theta_deg = {}, phi_deg = 17, psi_deg = -40, spin = 90{} }}\n```\n",
            body, theta_deg, more)));
        expect_saved(session);
      }
}

std::shared_ptr<const LoadedLesson> lesson_of_scene(const std::string& front, const std::string& keys) {
  const std::string text =
      "+++\nformat = 1\nid = 'a'\ntitle = 'A'\n" + front + "+++\n# S {s}\n\n```scene\n" + keys + "\n```\n";
  LessonReading reading = check_lesson(text, "a.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  return std::make_shared<const LoadedLesson>(LoadedLesson{std::move(*reading.lesson), "a.md", ""});
}

TEST(SavedScene, ScenesSideBySideAreSavedWithTheirBodies) {
  LessonSession session(
      lesson_of_scene("[body.coin]\nmoments = [1, 1, 1.9]\ndraw = 'box'\n",
                      "show = 'omega'\nscenes = [{ body = 'coin' }, { body = 'book', caption = 'b' }, "
                      "{ body = 'coin', omega = [0, 0, 1], meters = 'omega' }]"));
  expect_saved(session);
  session.set_camera({.azimuth_rad = 1, .elevation_rad = 0.5});
  session.scrub_to(0.5);
  expect_saved(session);
}

TEST(SavedScene, ABodyThatHangsInOneSceneAndFliesInAnotherIsSavedAsTwo) {
  LessonSession session(
      lesson_of_scene("[body.top]\nmoments = [1, 1, 0.5]\nmass_kg = 1\npivot_m = [0, 0, 1]\n",
                      "body = 'top'\nomega = [0, 0.1, 20]\nscenes = [{ torque = 'weight' }, {}]"));
  const Step saved = saved_step(session);
  EXPECT_EQ(saved.scene->body.moments, PrincipalMoments(2, 2, 0.5));
  EXPECT_EQ(saved.scene->beside.at(0).body.moments, PrincipalMoments(1, 1, 0.5));
}

TEST(SavedScene, WhatWasVariedIsSavedAsItIs) {
  LessonSession session(lesson_of_scene("", "omega = [0, 0, 3]\nvary = { omega3 = { from = 1, to = 9 } }"));
  ASSERT_TRUE(session.vary(0, 5));
  EXPECT_EQ(saved_step(session).scene->w0_B, Vec3(0, 0, 5));
  expect_saved(session);
}

}  // namespace
}  // namespace polhode
