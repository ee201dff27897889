// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/scene_keys.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::TextReport;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// The scene after these keys; fails the test on any report.
Scene scene_from(const std::string& text, Scene scene = {}, const LessonBodies& bodies = {}) {
  TextReport at(text);
  LessonScene changed{std::move(scene), {}};
  read_scene_keys(testing::toml(text), bodies, {}, changed, at.texts);
  EXPECT_THAT(at.lines(), IsEmpty()) << text;
  return changed.scene;
}

bool is_refused(const std::string& text) {
  TextReport at(text);
  LessonScene scene;
  read_scene_keys(testing::toml(text), {}, {}, scene, at.texts);
  return at.report.has_errors();
}

TEST(SceneKeys, ReadEveryKey) {
  const Scene scene = scene_from(
      "body = 'racket'\nomega = [1, 2, 3]\nattitude = 'L-up'\ntorque = ['space:1,2,3', 'damping:0.5']\n"
      "motion = 'symmetric'\nviews = ['body', 'space']\nshow = ['omega', 'trail-L']\n"
      "camera = { azimuth_deg = 90, elevation_deg = -30, distance = 3, zoom = 2, hold = 'still', fitted = { "
      "azimuth_deg = 180, omega = [1, 2, 4], attitude = 'L-down' } }\nat = -1.5\nstill = "
      "2.5\nduration = 2\n"
      "velocity = [4, 5, 6]\nforce = [7, 8, 9]\narrow = 'free'\n"
      "rate = 0.5\nhighlight = ['turn', 'omega']\nquality = 'draft'\ncaption = 'A caption'\n"
      "meters = ['drift', 'omega']");
  EXPECT_EQ(scene.body.name, "racket");
  EXPECT_EQ(scene.w0_B, Vec3(1, 2, 3));
  EXPECT_EQ(std::get<LPoints>(*scene.attitude), LPoints::up);
  ASSERT_EQ(scene.torque.size(), 2U);
  EXPECT_EQ(std::get<SpaceTorque>(scene.torque[0]).N_S, Vec3(1, 2, 3));
  EXPECT_EQ(std::get<LinearDamping>(scene.torque[1]).c, 0.5);
  EXPECT_EQ(scene.v0_S, Vec3(4, 5, 6));
  EXPECT_EQ(scene.F_S, Vec3(7, 8, 9));
  EXPECT_EQ(scene.arrow, ArrowHeld::free);
  EXPECT_EQ(scene.motion.method, Method::symmetric);
  EXPECT_THAT(scene.views, ElementsAre(View::body, View::space));
  EXPECT_EQ(scene.show, (OverlaySet{Overlay::omega, Overlay::trail_L}));
  // One rounding each for the factor and the product.
  EXPECT_NEAR(scene.camera.azimuth_rad, std::numbers::pi / 2, 2 * kEpsilon * 2);
  EXPECT_NEAR(scene.camera.elevation_rad, -std::numbers::pi / 6, 2 * kEpsilon);
  EXPECT_EQ(scene.camera.distance, 3);
  EXPECT_EQ(scene.camera.zoom, 2);
  EXPECT_TRUE(scene.camera.holds_still);
  ASSERT_TRUE(scene.camera.fitted);
  EXPECT_NEAR(scene.camera.fitted->azimuth_rad, std::numbers::pi, 2 * kEpsilon * 4);
  EXPECT_EQ(scene.camera.fitted->elevation_rad, CameraSpec{}.elevation_rad);
  EXPECT_EQ(scene.camera.fitted->w0_B, Vec3(1, 2, 4));
  EXPECT_TRUE(scene.camera.fitted->attitude == AttitudeSpec(LPoints::down));
  EXPECT_EQ(scene.at_s, -1.5);
  EXPECT_EQ(still_time_s(scene), 2.5);
  EXPECT_EQ(scene.duration_s, 2);
  EXPECT_EQ(scene.rate, 0.5);
  EXPECT_THAT(scene.highlight, ElementsAre("turn", "omega"));
  EXPECT_EQ(scene.caption, "A caption");
  EXPECT_THAT(scene.meters, ElementsAre(PlotSpec(Meter::drift), PlotSpec(Meter::omega)));
}

TEST(SceneKeys, MetersMayBeNoneOrKept) {
  EXPECT_THAT(scene_from("at = 1").meters, IsEmpty());
  EXPECT_THAT(scene_from("meters = []").meters, IsEmpty());
  EXPECT_THAT(scene_from("meters = 'energy'").meters, ElementsAre(PlotSpec(Meter::energy)));
  EXPECT_TRUE(is_refused("meters = ['speed']"));
  EXPECT_TRUE(is_refused("meters = 3"));
  EXPECT_TRUE(is_refused("meters = ['omega', 'omega', 'omega', 'omega', 'omega', 'omega', 'omega']"));
}

TEST(SceneKeys, LeaveTheRestOfTheSceneAlone) {
  Scene scene;
  scene.at_s = 7;
  scene.show = {Overlay::plane};
  const Scene changed = scene_from("at = 8", scene);
  EXPECT_EQ(still_time_s(changed), 8) << "absent, `still` is `at`";
  EXPECT_EQ(changed.at_s, 8);
  EXPECT_EQ(changed.show, scene.show);
}

TEST(SceneKeys, ReplaceWholeValues) {
  Scene scene;
  scene.camera.zoom = 3;
  scene.show = {Overlay::plane};
  scene.motion = {.method = Method::rk4, .step_s = 0.1, .ghost = true};
  const Scene changed =
      scene_from("camera = { distance = 2 }\nshow = 'L'\nmotion = { method = 'exact' }", scene);
  EXPECT_EQ(changed.camera.zoom, CameraSpec{}.zoom);
  EXPECT_EQ(changed.show, OverlaySet{Overlay::L});
  EXPECT_EQ(changed.motion, MotionSpec{.method = Method::exact});
}

TEST(SceneKeys, TakeTheLessonsOwnBodyBeforeABuiltInOne) {
  LessonBodies bodies;
  bodies.named.emplace("book", Body{"book", PrincipalMoments(1, 2, 2.5), std::nullopt});
  EXPECT_EQ(scene_from("body = 'book'", {}, bodies).body.moments, PrincipalMoments(1, 2, 2.5));
}

TEST(SceneKeys, ReportAnUnknownBodyOnlyIfAllAreKnown) {
  EXPECT_TRUE(is_refused("body = 'nothing'"));
  LessonBodies bodies;
  bodies.complete = false;
  scene_from("body = 'nothing'", {}, bodies);
}

TEST(SceneKeys, MakeUnitQuaternionsOfAnySize) {
  for (const char* text :
       {"[1, 2, 3, 4]", "[1e300, 2e300, 3e300, 4e300]", "[1e-320, 2e-320, 3e-320, 4e-320]"}) {
    const Scene scene = scene_from(std::string("attitude = ") + text);
    const Quat q = std::get<Quat>(*scene.attitude);
    EXPECT_NEAR(q.norm(), 1, 4 * kEpsilon) << text;
    // Subnormal numbers have fewer digits: 1e-320 is known to 1 in 2000.
    EXPECT_NEAR(q.w() / q.z(), 0.25, 1e-3) << text;
  }
}

TEST(SceneKeys, ReadMotionsAsNameOrTable) {
  EXPECT_EQ(scene_from("motion = 'exact'").motion, MotionSpec{.method = Method::exact});
  EXPECT_EQ(scene_from("motion = 'dormand-prince-5'").motion, MotionSpec{.method = Method::dormand_prince_5});
  EXPECT_EQ(scene_from("motion = { tolerance = 1e-6 }").motion, MotionSpec{.tolerance = 1e-6});
  const MotionSpec adaptive{.method = Method::dormand_prince_8, .tolerance = 1e-8};
  EXPECT_EQ(scene_from("motion = { method = 'dormand-prince-8', tolerance = 1e-8 }").motion, adaptive);
  const MotionSpec rk4{.method = Method::rk4, .step_s = 0.02, .ghost = true};
  EXPECT_EQ(scene_from("motion = { method = 'rk4', step = 0.02, ghost = true }").motion, rk4);
}

TEST(SceneKeys, TurnAzimuthsByWholeTurns) {
  EXPECT_NEAR(scene_from("camera = { azimuth_deg = 370 }").camera.azimuth_rad, std::numbers::pi / 18,
              2 * kEpsilon);
  EXPECT_TRUE(std::isfinite(scene_from("camera = { azimuth_deg = 1e308 }").camera.azimuth_rad));
}

TEST(SceneKeys, ReturnWhatIsHighlightedWithPlaces) {
  TextReport at("highlight = ['turn', 'L']");
  LessonScene scene;
  const auto names = read_scene_keys(testing::toml(at.text), {}, {}, scene, at.texts);
  ASSERT_EQ(names.size(), 2U);
  EXPECT_EQ(names[0].text, "turn");
  EXPECT_EQ(names[0].place, (SourcePlace{1, 14}));
}

class SceneKeysRefuse : public ::testing::TestWithParam<const char*> {};
TEST_P(SceneKeysRefuse, What) { EXPECT_TRUE(is_refused(GetParam())) << GetParam(); }
INSTANTIATE_TEST_SUITE_P(
    All, SceneKeysRefuse,
    ::testing::Values("omega = [nan, 0, 0]", "omega = [1, 2]", "attitude = [0, 0, 0, 0]",
                      "attitude = [1, 0, 0]", "attitude = [inf, 0, 0, 0]", "attitude = 'L-left'",
                      "attitude = 1", "torque = 'space:1,2'", "torque = 'space:nan,0,0'", "torque = 1",
                      "motion = 'euler'", "motion = 'rk4'", "motion = 1", "motion = { method = 'rk4' }",
                      "motion = { method = 'rk4', step = 0 }", "motion = { method = 'rk4', step = inf }",
                      "motion = { method = 'exact', step = 1 }", "motion = { step = 1 }",
                      "motion = 'moser-veselov-10'", "motion = { method = 'splitting' }",
                      "motion = { method = 'rk4', step = 1, tolerance = 1 }",
                      "motion = { method = 'exact', tolerance = 1e-6 }",
                      "motion = { method = 'dormand-prince-8', step = 1 }",
                      "motion = { method = 'dormand-prince-8', tolerance = 0 }",
                      "motion = { method = 'dormand-prince-8', tolerance = nan }", "motion = { gost = true }",
                      "velocity = 1", "velocity = [nan, 0, 0]", "force = [1, 2]", "force = 'gravity'",
                      "arrow = 'side'", "arrow = 1", "views = 'side'", "views = []",
                      "views = ['body', 'body']", "show = 'bars'", "show = [1]", "camera = 'front'",
                      "camera = { zoom = 0 }", "camera = { hold = 'all' }", "camera = { fitted = 3 }",
                      "camera = { fitted = { elevation_deg = 91 } }", "camera = { distance = -1 }",
                      "camera = { elevation_deg = 90.1 }", "camera = { azimuth_deg = nan }",
                      "camera = { roll = 1 }", "at = inf", "duration = 0", "duration = nan", "rate = 0",
                      "rate = '1'", "highlight = 'two words'", "highlight = ['a', 'b', 'c', 'd', 'e']",
                      "quality = 'best'", "caption = 1", "color = 1"));

TEST(SceneKeys, RefuseCaptionsOfSeveralLinesOrTooManyCharacters) {
  EXPECT_TRUE(is_refused("caption = \"a\\nb\""));
  std::string caption;
  for (std::size_t i = 0; i < kMaxCaptionCharacters; ++i) caption += "ω";
  scene_from("caption = '" + caption + "'");
  EXPECT_TRUE(is_refused("caption = '" + caption + "ω'"));
}

// A disc of 1 kg whose centre of mass lies 10 cm from the pivot.
constexpr const char* kRod =
    "+++\nformat = 1\nid = \"rod\"\ntitle = \"Rod\"\n[body.rod]\nshape = \"cylinder\"\n"
    "size_m = [0.2, 0.2, 0.02]\nmass_kg = 1.0\n[body.plate]\nmoments = [1.0, 2.0, 2.9]\ndraw = "
    "\"box\"\n+++\n";

Vec3 moments_of(const std::string& scenes, std::size_t step) {
  const LessonReading reading = read_lesson(kRod + ("# A stage {one}\nText.\n" + scenes), "rod.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  return reading.lesson->stages[0].steps.at(step).scene->body.moments.vector();
}

TEST(SceneKeys, ABodyOfAShapeHasItsMomentsAboutThePivot) {
  const Vec3 free(0.01 / 4 + 0.0004 / 12, 0.01 / 4 + 0.0004 / 12, 0.01 / 2);  // m(r²/4 + h²/12), m r²/2
  const Vec3 on_pivot = free + Vec3(0.01, 0.01, 0);                           // m l²
  const std::string heavy = "```scene\nbody = \"rod\"\ntorque = \"heavy:0.980665,0,0,1\"\n```\n";
  EXPECT_LT((moments_of(heavy, 0) - on_pivot).norm(), 8 * kEpsilon);
  EXPECT_LT((moments_of(heavy + "---\nMore.\n", 1) - on_pivot).norm(), 8 * kEpsilon) << "not twice";
  EXPECT_LT((moments_of(heavy + "---\n```scene\ntorque = []\n```\n", 1) - free).norm(), 8 * kEpsilon)
      << "without the pivot those about the centre of mass";
}

TEST(SceneKeys, MomentsThatAreGivenAreThoseAboutThePivot) {
  EXPECT_EQ(moments_of("```scene\nbody = \"plate\"\ntorque = \"heavy:0.5,0,0,1\"\n```\n", 0),
            Vec3(1.0, 2.0, 2.9));
}

TEST(SceneKeys, RefuseAShapeThatHangsOnNoPrincipalAxis) {
  const auto complaints = [](const std::string& keys) {
    return testing::complaints(testing::lesson_with("```scene\n" + keys + "\n```\n"));
  };
  const std::string says =
      "error: the moments of \"book\" about the pivot: its weight hangs on no principal axis, so that 1, 2, "
      "3 are not principal at the pivot (let the axis of \"heavy\" be that of 1, 2 or 3, or give the body by "
      "moments about the pivot)";
  EXPECT_THAT(complaints("torque = \"heavy:0.5,0,1,1\""), ElementsAre("10:10: " + says));
  EXPECT_THAT(complaints("torque = \"heavy:0.5,0,1,0\""), IsEmpty());
  EXPECT_THAT(complaints("body = \"textbook\"\ntorque = \"heavy:0.5,0,1,1\""), IsEmpty()) << "by moments";
  EXPECT_THAT(complaints("body = \"textbook\"\ntorque = \"heavy:0.5,0,1,1\"\n```\n---\n```scene\n"
                         "body = \"book\""),
              ElementsAre("15:8: " + says));
  EXPECT_EQ(complaints("torque = \"heavy:1e200,0,0,1\"").size(), 1U) << "moments overflow";
}

TEST(SceneKeys, AForceThatIsTheWeightIsThatOfTheBodysMass) {
  const auto force_in = [](const std::string& scenes, std::size_t step) {
    const LessonReading reading = read_lesson(kRod + ("# A stage {one}\nText.\n" + scenes), "rod.md");
    if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
    return reading.lesson->stages[0].steps.at(step).scene->F_S;
  };
  const std::string falls = "```scene\nbody = \"rod\"\nforce = \"weight\"\n```\n";
  EXPECT_EQ(force_in(falls, 0), Vec3(0, 0, -9.80665));
  EXPECT_EQ(force_in(falls + "---\n```scene\nbody = \"book\"\n```\n", 1)[2],
            -find_body("book")->mass_kg * 9.80665)
      << "of the body that is shown";
  EXPECT_EQ(force_in(falls + "---\n```scene\nforce = [1, 0, 0]\n```\n", 1), Vec3(1, 0, 0));
  EXPECT_THAT(testing::complaints(
                  testing::lesson_with("```scene\ntorque = \"heavy:1,0,0,1\"\nforce = \"weight\"\n```\n")),
              ElementsAre(::testing::HasSubstr("a body that is held at a pivot does not follow")));
}

TEST(SceneKeys, PosesAreCountedAndReadBack) {
  const Scene scene = scene_from("poses = { count = 5, over = 0.8 }");
  EXPECT_EQ(scene.poses, (Poses{5, 0.8}));
  EXPECT_EQ(scene_from(scene_keys_text(scene, scene.at_s)).poses, scene.poses);
  EXPECT_EQ(scene_from("poses = {}", scene).poses, Poses());
  for (const char* wrong :
       {"poses = 5", "poses = { count = 5 }", "poses = { over = 1 }", "poses = { count = 0, over = 1 }",
        "poses = { count = 13, over = 1 }", "poses = { count = 2.5, over = 1 }",
        "poses = { count = 2, over = -1 }", "poses = { count = 2, over = 1, pale = true }"})
    EXPECT_TRUE(is_refused(wrong)) << wrong;
}

TEST(SceneKeys, ComparedMethodsAreReadBack) {
  const Scene scene = scene_from("compare = { methods = ['rk4', 'splitting'], against = 'evaluations' }");
  EXPECT_EQ(scene.compared.methods, (std::vector{Method::rk4, Method::splitting}));
  EXPECT_TRUE(scene.compared.by_evaluations);
  EXPECT_EQ(scene_from(scene_keys_text(scene, scene.at_s)).compared, scene.compared);
  EXPECT_FALSE(scene_from("compare = { against = 'steps' }").compared.by_evaluations);
  EXPECT_EQ(scene_from("compare = {}", scene).compared, ComparedMethods());
  for (const char* wrong : {"compare = 'rk4'", "compare = { methods = ['rk5'] }",
                            "compare = { against = 'time' }", "compare = { method = ['rk4'] }"})
    EXPECT_TRUE(is_refused(wrong)) << wrong;
}

TEST(SceneKeys, APictureThatStaysSaysWhyInItsStep) {
  EXPECT_TRUE(is_refused("same = \"a question\"")) << "in the front matter";
  TextReport at("same = \" \"");
  LessonScene scene;
  read_scene_keys(testing::toml("same = \" \""), {}, {}, scene, at.texts, SourcePlace{1, 1});
  EXPECT_TRUE(at.report.has_errors());
}

/// What a step's scene with one key more is to the scene without it.
enum class Effect {
  of_step,        ///< the same scene: it is said of the step
  other_picture,  ///< from another camera, or finer: the same model serves it
  other_look,     ///< of the same motion, on which t goes on
  other_course
};
void PrintTo(Effect effect, std::ostream* out) {
  *out << std::array{"of the step", "other picture", "other look", "other course"}[std::size_t(effect)];
}

// 2026-11-26: captions such as "halfway over" stood below all of the motion.
TEST(SceneKeys, ACaptionOfTheStillIsOneUntilThereIsAnother) {
  const std::string text =
      "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n+++\n# A stage {one}\n```scene\n"
      "caption = 'Halfway over'\ncaption_when = 'still'\nat = 2\n```\nIt turns.\n\n---\n"
      "```scene\nshow = 'omega'\n```\nIt turns.\n\n---\n```scene\ncaption = 'A book'\n```\n"
      "It turns.\n";
  const LessonReading reading = read_lesson(text, "a.md");
  ASSERT_TRUE(reading.lesson) << to_string(reading.diagnostics.front());
  const auto& steps = reading.lesson->stages[0].steps;
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_TRUE(caption_holds(*steps.at(i).scene, 2)) << i;
    EXPECT_FALSE(caption_holds(*steps.at(i).scene, 2.01)) << i;
  }
  EXPECT_TRUE(caption_holds(*steps.at(2).scene, 2.01));
}

TEST(SceneKeys, ACaptionIsOfNoOtherMoments) { EXPECT_TRUE(is_refused("caption_when = 'noon'")); }

struct KeyEffect {
  const char *key, *value;
  Effect effect;
};

// A row for each key of the table: a field that same_course or same_model forgets is seen here.
constexpr KeyEffect kEffects[] = {
    {"body", "'textbook'", Effect::other_course},
    {"omega", "[1, 2, 3]", Effect::other_course},
    {"attitude", "'L-up'", Effect::other_course},
    {"start", "{ theta_deg = 30, spin = 50 }", Effect::other_course},
    {"torque", "'damping:0.5'", Effect::other_course},
    {"velocity", "[1, 0, 0]", Effect::other_course},
    {"force", "[1, 0, 0]", Effect::other_course},
    {"arrow", "'body'", Effect::other_course},
    {"motion", "'dormand-prince-5'", Effect::other_course},
    {"views", "'body'", Effect::other_look},
    {"show", "'omega'", Effect::other_look},
    {"compare", "{ methods = ['rk4'], against = 'evaluations' }", Effect::other_look},
    {"trails", "[{ of = 'e3' }]", Effect::other_look},
    {"arrows", "[{ of = 'e3' }]", Effect::other_look},
    {"angles", "[{ from = 'ez', to = 'e3' }]", Effect::other_look},
    {"areas", "[{ from = 'omega', to = 'e3' }]", Effect::other_look},
    {"lines", "[{ from = 'omega', to = 'e3' }]", Effect::other_look},
    {"planes", "[{ normal = 'L', through = 'omega' }]", Effect::other_look},
    {"notes", "[{ text = 'tip', at = 'e3' }]", Effect::other_look},
    {"poses", "{ count = 5, over = 0.8 }", Effect::other_look},
    {"camera", "{ distance = 3 }", Effect::other_picture},
    {"at", "1", Effect::other_course},
    {"still", "1", Effect::other_course},
    {"duration", "1", Effect::other_course},
    {"rate", "1", Effect::other_course},
    {"highlight", "'omega'", Effect::other_look},
    {"quality", "'fine'", Effect::other_picture},
    {"caption", "'A caption'", Effect::other_look},
    {"caption_when", "'still'", Effect::other_look},
    {"meters", "'energy'", Effect::other_look},
    {"scenes", "[{}, { omega = [1, 2, 3] }]", Effect::other_course},
    {"vary", "{ omega3 = { from = 1, to = 9 } }", Effect::other_course},
    {"same", "'a question about it'", Effect::of_step},
    {"from", "'a'", Effect::of_step},
};

TEST(SceneKeyFacts, AreAllOfTheMotionOrOfItsLook) {
  std::vector<std::string_view> names, tried;
  for (const SceneKeyFacts& key : scene_key_facts()) names.push_back(key.name);
  for (const KeyEffect& row : kEffects) tried.emplace_back(row.key);
  EXPECT_EQ(tried, names);

  // A top on its pivot, whose start two numbers tell.
  const std::string top =
      "+++\nformat = 1\nid = \"top\"\ntitle = \"Top\"\n[body.top]\nshape = \"cylinder\"\n"
      "size_m = [0.2, 0.2, 0.02]\nmass_kg = 1.0\npivot_m = [0, 0, -0.1]\n[scene]\nbody = \"top\"\n+++\n";
  for (const KeyEffect& row : kEffects) {
    const std::string line = std::string(row.key) + " = " + row.value + '\n';
    const std::string weight = std::string_view(row.key) == "start" ? "torque = 'weight'\n" : "";
    const LessonReading reading =
        read_lesson(top + "# A stage {one}\n```math a\nx = y\n```\n```scene\n" + weight +
                        "```\n\n---\n```math b\nx = z\n```\n```scene\n" + line + "```\n",
                    "top.md");
    ASSERT_TRUE(reading.lesson) << to_string(reading.diagnostics.front());
    const auto& steps = reading.lesson->stages[0].steps;
    const Scene &before = *steps.at(0).scene, &after = *steps.at(1).scene;
    const Effect effect = after == before              ? Effect::of_step
                          : same_model(before, after)  ? Effect::other_picture
                          : same_course(before, after) ? Effect::other_look
                                                       : Effect::other_course;
    EXPECT_EQ(effect, row.effect) << line;
  }
}

TEST(SceneKeyFacts, AreTheTableOfTheFormat) {
  std::string table = "| key | value | default |\n|---|---|---|\n";
  for (const SceneKeyFacts& key : scene_key_facts())
    table += "| `" + std::string(key.name) + "` | " + std::string(key.value) + " | " +
             std::string(key.usual) + " |\n";
  EXPECT_THAT(testing::read_file(test::source_dir() / "lessons/FORMAT.md"),
              ::testing::HasSubstr(table + '\n'));
}

}  // namespace
}  // namespace polhode
