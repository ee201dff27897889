// SPDX-License-Identifier: MIT
// What the window says and does where something is missing, broken or full.
#include "tests/window/controls.h"
#include "tests/window/window_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

namespace polhode::window_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class Fault : public WindowTest {};

TEST_F(Fault, WithoutADisplayItSaysSoAndNamesExport) {
  Start start = start_of_play(display(), home(), {kPlayed});
  start.environment["XDG_RUNTIME_DIR"] = std::nullopt;
  for (const std::optional<std::string>& name :
       {std::optional<std::string>(), std::optional<std::string>(":9999")}) {
    start.environment["DISPLAY"] = name;
    EXPECT_EQ(Child(start).wait(), 1);
    EXPECT_THAT(text_of(start.err),
                AllOf(StartsWith("polhode: "), HasSubstr("display"), HasSubstr("polhode export")))
        << "what a library says by itself is no message of ours";
  }
}

TEST_F(Fault, ALessonWithErrorsShowsThemAll) {
  const Start start = start_of_play(display(), home(), {test_lesson("two_errors.md")});
  EXPECT_EQ(Child(start).wait(), 3);
  EXPECT_THAT(text_of(start.err) + text_of(start.out),
              AllOf(HasSubstr("two_errors.md:12"), HasSubstr("two_errors.md:16")));
}

TEST_F(Fault, UnknownNamesAreUsage) {
  EXPECT_EQ(Child(start_of_play(display(), home(), {"no-such-lesson"})).wait(), 2);
  EXPECT_EQ(Child(start_of_play(display(), home(), {kPlayed, "--stage", "no-such-stage"})).wait(), 2);
}

TEST_F(Fault, ADisplayWithoutOpenGLGetsAPlainWindow) {
  const Display plain({1280, 800}, {"-extension", "GLX"});
  PlayedLesson lesson(plain, home(), {kPlayed});
  const Image first = lesson.picture_at_rest();
  EXPECT_FALSE(is_blank(first));
  lesson.press({"Right", "Right"});
  EXPECT_TRUE(lesson.comes_to(2, 1));
  EXPECT_TRUE(lesson.changes_from(first));
  lesson.click(kPreviousStep);
  EXPECT_TRUE(lesson.comes_to(1, 2));
}

TEST_F(Fault, DamagedStateIsSetAside) {
  fs::create_directories(home().state());
  const std::vector<std::string> names = {"played.place.json", "played.answers.json", "preferences.json"};
  for (const std::string& name : names) write_text(home().state() / name, "{ this is no such file");
  PlayedLesson lesson(display(), home(), {kPlayed});
  EXPECT_EQ(lesson.place().stage, 1);
  for (const std::string& name : names) {
    EXPECT_EQ(text_of(home().state() / (name + ".damaged")), "{ this is no such file") << name;
    EXPECT_THAT(lesson.said(), HasSubstr(name + ".damaged"));
  }
  lesson.press({"Right"});
  ASSERT_TRUE(lesson.comes_to(1, 2));
  lesson.close();
  EXPECT_EQ(lesson.process().wait(), 0);
  EXPECT_THAT(text_of(home().state() / "played.place.json"), HasSubstr("figure"));
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

TEST_F(Fault, AnAuthorSeesWhatIsWrongBesideTheLastGoodLesson) {
  const std::string text = text_of(kPlayed);
  const fs::path file = home().folder / "edited.md";
  write_text(file, text);
  PlayedLesson lesson(display(), home(), {file.string(), "--watch"});
  lesson.press({"Right"});
  ASSERT_TRUE(lesson.comes_to(1, 2));
  const Image good = lesson.picture_at_rest();

  write_text(file, replaced(text, "[\"energy-ellipsoid\"", "[\"energy-elipsoid\""));
  ASSERT_TRUE(lesson.changes_from(good));
  const Image broken = lesson.picture_at_rest();
  EXPECT_LT(changed_part(good, broken, {0, 0}, {1280, 800}), 0.25) << "the last good lesson is still there";

  write_text(file, replaced(text, "# A figure", "# Another figure"));
  EXPECT_TRUE(eventually([&] { return lesson.place().stage_title == "Another figure"; }));
  EXPECT_TRUE(lesson.comes_to(1, 1)) << "the step that was edited";
  EXPECT_TRUE(lesson.changes_from(broken));
  const Image right = lesson.picture_at_rest();

  write_text(file, replaced(text, "# A figure", "# Another figure") +
                       "\n---\n\n```math untrue\nT = 1\n```\n\n```claim untrue identity\nT = 1\n```\n");
  EXPECT_TRUE(lesson.changes_from(right)) << "the step that was added, and that its claim is not true";
}

// HOSTILE F14: the window waited for somebody to write to the pipe, and heard nobody any more.
TEST_F(Fault, APipeInPlaceOfTheLessonIsNotWaitedFor) {
  const fs::path file = home().folder / "edited.md";
  write_text(file, text_of(kPlayed));
  PlayedLesson lesson(display(), home(), {file.string(), "--watch"});
  lesson.press({"Right"});
  ASSERT_TRUE(lesson.comes_to(1, 2));
  const Image good = lesson.picture_at_rest();
  fs::remove(file);
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  EXPECT_TRUE(lesson.changes_from(good)) << "it is said";
  lesson.press({"Left"});
  EXPECT_TRUE(lesson.comes_to(1, 1));
  lesson.close();
  EXPECT_EQ(lesson.process().wait(), 0);
}

}  // namespace
}  // namespace polhode::window_test
