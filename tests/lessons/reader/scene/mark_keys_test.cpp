// SPDX-License-Identifier: MIT
#include "lessons/reader/scene/mark_keys.h"

#include "lessons/reader/reader.h"
#include "lessons/reader/scene/scene_keys.h"
#include "render/scene/model/model.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Marks marks_of(const std::string& keys) {
  testing::TextReport at(keys);
  LessonScene scene;
  read_scene_keys(testing::toml(keys), {}, {}, scene, at.texts);
  EXPECT_THAT(at.lines(), IsEmpty()) << keys;
  return scene.scene.marks;
}

std::vector<std::string> complaints(const std::string& keys) {
  testing::TextReport at(keys);
  LessonScene scene;
  read_scene_keys(testing::toml(keys), {}, {}, scene, at.texts);
  return at.lines();
}

Vec3 value_of(const MarkVector& vector, const SceneModel& model, double t_s) {
  return vector.quantity.value(model, t_s, model.motion->at(t_s)).value();
}

TEST(MarkKeys, ReadEveryKey) {
  const Marks marks = marks_of(
      "trails = [{ of = 'e3', on = 'sphere' }, { of = 'L' }]\n"
      "arrows = [{ of = 'ddt(e3)', at = 'e3', tex = '\\dot{\\vec e}_3', length = 0.7 },\n"
      "  { of = 'comp(omega, 3)*e3', like = 'omega', tex = '' }]\n"
      "angles = [{ from = 'ez', to = 'e3', tex = '\\theta' }]\n"
      "planes = [{ normal = 'L', through = 'omega' }, { normal = 'ez' }]\n"
      "notes = [{ text = 'nose, $\\theta$', at = 'e3' }, { text = 'tail', at = 'e2', role = 'axis-2' }]");
  ASSERT_EQ(marks.trails.size(), 2U);
  EXPECT_EQ(marks.trails[0].of.quantity.text, "e3");
  EXPECT_TRUE(marks.trails[0].on_sphere);
  EXPECT_FALSE(marks.trails[1].on_sphere);
  ASSERT_EQ(marks.arrows.size(), 2U);
  EXPECT_EQ(marks.arrows[0].at->quantity.text, "e3");
  EXPECT_EQ(marks.arrows[0].tex, "\\dot{\\vec e}_3");
  EXPECT_EQ(marks.arrows[0].length, 0.7);
  EXPECT_FALSE(marks.arrows[0].like);
  EXPECT_EQ(marks.arrows[1].like->overlay, Overlay::omega);
  EXPECT_EQ(marks.arrows[1].tex, "");
  ASSERT_EQ(marks.angles.size(), 1U);
  EXPECT_EQ(marks.angles[0].from.quantity.text, "ez");
  EXPECT_EQ(marks.angles[0].to.quantity.text, "e3");
  EXPECT_EQ(marks.angles[0].tex, "\\theta");
  ASSERT_EQ(marks.planes.size(), 2U);
  EXPECT_EQ(marks.planes[0].through->quantity.text, "omega");
  EXPECT_FALSE(marks.planes[1].through);
  ASSERT_EQ(marks.notes.size(), 2U);
  EXPECT_EQ(marks.notes[0].text, "nose, $\\theta$");
  EXPECT_EQ(marks.notes[0].role, "");
  EXPECT_EQ(marks.notes[1].role, "axis-2");
}

TEST(MarkKeys, KnowWhatAVectorIs) {
  const Marks marks =
      marks_of("arrows = [{ of = 'e3' }, { of = 'omega' }, { of = '(L)' }, { of = 'N' }, { of = 'A' }]");
  ASSERT_EQ(marks.arrows.size(), 5U);
  EXPECT_TRUE(marks.arrows[0].of.is_number);
  EXPECT_FALSE(marks.arrows[0].of.overlay);
  EXPECT_EQ(marks.arrows[1].of.overlay, Overlay::omega);
  EXPECT_FALSE(marks.arrows[1].of.is_number);
  EXPECT_EQ(marks.arrows[2].of.overlay, Overlay::L);
  EXPECT_EQ(marks.arrows[3].of.overlay, Overlay::N);
  EXPECT_TRUE(marks.arrows[4].of.is_number) << "A may be anything";
}

TEST(MarkKeys, SpeakOfTheMotion) {
  Scene scene;
  scene.w0_B = Vec3(0.3, 1.2, 0.7);
  const SceneModel model = make_model(scene, ModelFor::numbers);
  const Marks marks = marks_of("arrows = [{ of = 'ddt(e3)', at = 'omega - comp(omega, 3)*e3' }]");
  for (const double t_s : {0.0, 0.9}) {
    const RigidBodyState now = model.motion->at(t_s);
    const Vec3 w_S = now.q_SB * now.w_B, e3_S = now.q_SB * Vec3::UnitZ();
    // ddt is a difference of the motion, good to 1e-13 of the rates (physics/analysis/difference.h).
    EXPECT_LT((value_of(marks.arrows[0].of, model, t_s) - w_S.cross(e3_S)).norm(), 1e-11 * w_S.norm());
    EXPECT_LT((value_of(*marks.arrows[0].at, model, t_s) - (w_S - now.w_B.z() * e3_S)).norm(), 64 * kEpsilon);
  }
}

TEST(MarkKeys, TakeATableAlone) {
  EXPECT_EQ(marks_of("trails = { of = 'e3' }").trails.size(), 1U);
  EXPECT_THAT(marks_of("trails = []").trails, IsEmpty());
}

TEST(MarkKeys, ReplaceTheWholeList) {
  testing::TextReport at("");
  LessonScene scene;
  read_scene_keys(testing::toml("arrows = [{ of = 'e1' }]\nnotes = [{ text = 'n', at = 'e1' }]"), {}, {},
                  scene, at.texts);
  read_scene_keys(testing::toml("arrows = [{ of = 'e2' }, { of = 'e3' }]"), {}, {}, scene, at.texts);
  EXPECT_EQ(scene.scene.marks.arrows.size(), 2U);
  EXPECT_EQ(scene.scene.marks.notes.size(), 1U) << "another key";
  EXPECT_THAT(at.lines(), IsEmpty());
}

TEST(MarkKeys, ATrailHasTheColourThatItSays) {
  const Marks marks = marks_of("trails = [{ of = 'e3', role = 'axis-2' }, { of = 'L', role = 'crimson' }]");
  ASSERT_EQ(marks.trails.size(), 2U);
  EXPECT_EQ(marks.trails[0].of.quantity.role, "axis-2");
  EXPECT_EQ(marks.trails[1].of.quantity.role, "crimson") << "in the place of the vector's own";
  EXPECT_THAT(complaints("trails = [{ of = 'e3', role = 'axis-4' }]"),
              ElementsAre(HasSubstr("unknown role \"axis-4\"")));
}

TEST(MarkKeys, AreWrittenAsTheyWereRead) {
  for (const char* keys :
       {"trails = [{ of = 'e3', on = 'sphere' }, { of = 'L', role = 'axis-1' }]\n",
        "arrows = [{ of = 'ddt(e3)', at = 'e3', tex = '\\dot e', length = 0.7 }, { of = 'comp(omega, 3)*e3', "
        "tex = '', like = 'omega' }]\n",
        "angles = [{ from = 'ez', to = 'e3', tex = '\\theta' }, { from = 'ex', to = 'e1' }]\n",
        "planes = [{ normal = 'L', through = 'omega' }, { normal = 'ez' }]\n",
        "notes = [{ text = \"it's \\\"odd\\\"\", at = 'e3' }, { text = 'n', at = 'e1', role = 'axes' }]\n"}) {
    Scene scene;
    scene.marks = marks_of(keys);
    const std::string text = scene_keys_text(scene, 0);
    EXPECT_EQ(marks_of(text), scene.marks) << text;
    EXPECT_THAT(all_scene_keys_text(scene), HasSubstr(text));
  }
  EXPECT_EQ(text_of(marks_of("arrows = [{ of = 'e3', tex = 'n', length = 0.7 }]").arrows),
            "[{ of = 'e3', tex = 'n', length = 0.7 }]");
}

TEST(MarkKeys, RefuseWhatIsNoMark) {
  EXPECT_THAT(
      complaints("arrows = 'e3'"),
      ElementsAre("1:10: error: \"arrows\" takes a list of tables, found a string (for example arrows = "
                  "[{ of = \"ddt(e3)\", at = \"e3\" }])"));
  EXPECT_THAT(complaints("trails = ['e3', 3]").size(), 2U) << "several errors at once";
  EXPECT_THAT(complaints("trails = ['e3']"),
              ElementsAre("1:11: error: a trail is a table, found a string (for example { of = \"e3\", on = "
                          "\"sphere\" })"));
  EXPECT_THAT(
      complaints("notes = [{ text = 'nose' }]"),
      ElementsAre("1:10: error: a note has \"at\", this one has none (for example { text = \"nose\", at = "
                  "\"e3\" })"));
  EXPECT_EQ(complaints("angles = [{ tex = 'a' }]").size(), 2U);
  EXPECT_THAT(complaints("planes = [{ normal = 'L', thru = 'omega' }]"), ElementsAre(HasSubstr("thru")));
  EXPECT_THAT(
      complaints("trails = [{ of = 'e3', on = 'cube' }]"),
      ElementsAre("1:29: error: unknown \"on\" \"cube\" (write \"sphere\", or leave it out: the path of the "
                  "tip)"));
  EXPECT_THAT(complaints("trails = [{ of = 'e3', on = 3 }]"), ElementsAre(HasSubstr("1:29: error")));
}

TEST(MarkKeys, RefuseWhatIsNoVector) {
  EXPECT_THAT(complaints("arrows = [{ of = 'T' }]"),
              ElementsAre("1:18: error: \"of\" takes a vector, \"T\" is none (for example \"e3\", \"L\" or "
                          "\"ddt(e3)\")"));
  EXPECT_THAT(complaints("planes = [{ normal = '0' }]"), ElementsAre(HasSubstr("takes a vector")));
  EXPECT_THAT(complaints("arrows = [{ of = 3 }]"), ElementsAre(HasSubstr("1:18: error")));
  EXPECT_THAT(complaints("arrows = [{ of = 'e4' }]"), ElementsAre(HasSubstr("e4")));
  EXPECT_THAT(complaints("trails = [{ of = 'h*e3' }]"), ElementsAre(HasSubstr("\"h\" is any number")));
  EXPECT_THAT(complaints("notes = [{ text = 'n', at = 'omega + L' }]"),
              ElementsAre(HasSubstr("units disagree")));
  EXPECT_THAT(complaints("arrows = [{ of = 'e3', at = 'T' }]"),
              ElementsAre(HasSubstr("\"at\" takes a vector")));
}

TEST(MarkKeys, RefuseWhatCannotBeDrawn) {
  EXPECT_THAT(complaints("angles = [{ from = 'e3', to = '(e3)' }]"),
              ElementsAre(HasSubstr("an angle lies between two vectors")));
  for (const char* length : {"0", "-1", "0.05", "3.5", "inf", "nan", "'long'"})
    EXPECT_EQ(complaints(std::string("arrows = [{ of = 'e3', length = ") + length + " }]").size(), 1U)
        << length;
  EXPECT_THAT(complaints("arrows = [{ of = 'e3', length = 1, like = 'e1' }]"),
              ElementsAre(HasSubstr("not both")));
  EXPECT_THAT(complaints("arrows = [{ of = 'L', like = 'omega' }]"),
              ElementsAre("1:30: error: units disagree: \"omega\" is in rad/s, \"L\" in kg m²/s"));
  EXPECT_THAT(complaints("arrows = [{ of = 'e3', like = 'L' }]"), ElementsAre(HasSubstr("pure numbers")));
}

TEST(MarkKeys, RefuseWhatCannotBeSet) {
  EXPECT_THAT(complaints("arrows = [{ of = 'e3', tex = '\\nothing' }]"),
              ElementsAre(HasSubstr("1:31: error")));
  EXPECT_THAT(complaints("angles = [{ from = 'ez', to = 'e3', tex = '\\frac{1}' }]").size(), 1U);
  EXPECT_THAT(complaints("arrows = [{ of = 'e3', tex = 'a \\\\ b' }]").size(), 1U);
  EXPECT_THAT(complaints("arrows = [{ of = 'e3', tex = '\\eqref{a}' }]").size(), 1U);
  EXPECT_THAT(complaints("notes = [{ text = 'a $\\nothing$', at = 'e3' }]"),
              ElementsAre(HasSubstr("1:23: error")));
  EXPECT_THAT(complaints("notes = [{ text = ' ', at = 'e3' }]"), ElementsAre(HasSubstr("one line of text")));
  EXPECT_THAT(complaints("notes = [{ text = \"a\\nb\", at = 'e3' }]"),
              ElementsAre(HasSubstr("one line of text")));
  EXPECT_THAT(complaints("notes = [{ text = '" + std::string(61, 'a') + "', at = 'e3' }]"),
              ElementsAre(HasSubstr("at most 60 characters, found 61")));
  EXPECT_EQ(marks_of("notes = [{ text = '" + std::string(60, 'a') + "', at = 'e3' }]").notes.size(), 1U);
}

TEST(MarkKeys, AreTwelveOfAKind) {
  const auto list = [](int count) {
    std::string text = "trails = [";
    for (int i = 0; i < count; ++i) text += "{ of = 'e" + std::to_string(i % 3 + 1) + "' }, ";
    return text + "]";
  };
  EXPECT_EQ(marks_of(list(12)).trails.size(), 12U);
  EXPECT_THAT(complaints(list(13)), ElementsAre("1:10: error: \"trails\" takes at most 12, found 13"));
}

TEST(MarkKeys, KnowTheWordsOfTheLesson) {
  const std::string text =
      "+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n[symbols]\n"
      "L = { tex = '\\vec L', role = \"L\", say = \"angular momentum\" }\n"
      "[define]\nn = { means = \"cross(ez, e3)\", tex = '\\vec n', role = \"herpolhode\" }\n+++\n# X "
      "{x}\n```scene\n"
      "arrows = [{ of = \"n\" }, { of = \"L\" }]\nnotes = [{ text = \"line of nodes ☃\", at = \"n\" "
      "}]\n```\n";
  const LessonReading reading = read_lesson(text, "x.md");
  ASSERT_TRUE(reading.lesson) << testing::lines_of(reading.diagnostics).front();
  const Step& step = reading.lesson->stages[0].steps[0];
  ASSERT_EQ(step.scene->marks.arrows.size(), 2U);
  EXPECT_EQ(step.scene->marks.arrows[0].of.quantity.tex, "\\vec n");
  EXPECT_EQ(step.scene->marks.arrows[0].of.quantity.role, "herpolhode");
  EXPECT_EQ(step.scene->marks.arrows[1].of.quantity.role, "L");
  ASSERT_EQ(step.labels.size(), 2U) << "what arrows and notes write is checked against the fonts";
}

TEST(MarkKeys, AreAsTheFormatSays) {
  const std::string format = testing::read_file(test::source_dir() / "lessons/FORMAT.md");
  const std::size_t begin = format.find("\n### Marks\n"), end = format.find("\n## ", begin);
  ASSERT_NE(begin, format.npos);
  const std::string section = format.substr(begin, end - begin);
  int examples = 0;
  for (std::size_t at = 0; (at = section.find("\n| `", at)) != section.npos; ++examples) {
    const std::size_t first = at + 4, last = section.find('`', first);
    at = last;
    const Marks marks = marks_of(section.substr(first, last - first));
    EXPECT_FALSE(marks.empty());
    Scene scene;
    scene.w0_B = Vec3(0.4, 1.1, 1.6);
    scene.marks = marks;
    EXPECT_THAT(unseen_marks(make_model(scene)), IsEmpty()) << section.substr(first, last - first);
  }
  EXPECT_EQ(examples, 12);
}

}  // namespace
}  // namespace polhode
