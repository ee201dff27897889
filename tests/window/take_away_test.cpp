// SPDX-License-Identifier: MIT
// What is saved in the window: a page as `polhode export` makes it, a scene as a lesson, slides; whole or not
// at all.
#include "render/image/png.h"
#include "tests/window/controls.h"
#include "tests/window/window_test.h"

#include <gtest/gtest.h>
#include <signal.h>

namespace polhode::window_test {
namespace {

namespace fs = std::filesystem;

class TakeAway : public WindowTest {
 protected:
  /// Files with this ending anywhere in the home, but for the program's state.
  std::vector<fs::path> files(const std::string& ending) const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(home().folder.path()))
      if (entry.is_regular_file() && entry.path().extension() == ending) found.push_back(entry.path());
    return found;
  }
};

std::string text_in(const PngFile& file, const std::string& keyword) {
  for (const auto& [name, text] : file.metadata.text)
    if (name == keyword) return text;
  return {};
}

/// `polhode export` of the same page or figure.
Image exported(const std::string& lesson, const PngFile& like, const std::string& what,
               const std::string& name) {
  const ScratchFolder folder;
  const std::string size =
      std::to_string(like.image.size.width) + 'x' + std::to_string(like.image.size.height);
  std::vector<std::string> words = {"export",  lesson,
                                    "-o",      (folder / "out").string(),
                                    "--stage", text_in(like, "polhode:stage"),
                                    "--each",  "step",
                                    "--what",  what,
                                    "--size",  size,
                                    "--at",    text_in(like, "polhode:t")};
  if (what == "page") words.insert(words.end(), {"--profile", "page"});
  const ProgramRun run = polhode(words);
  EXPECT_EQ(run.code, 0) << run.err;
  Result<PngFile> file = read_png(folder / "out" / name);
  EXPECT_TRUE(file);
  return file ? file->image : Image{};
}

TEST_F(TakeAway, ASavedPageIsThatOfExport) {
  PlayedLesson lesson(display(), home(), {kPlayed});
  lesson.press({"shift+Right", "shift+Right", "Right", "shift+Right"});
  ASSERT_TRUE(lesson.comes_to(1, 2));
  lesson.picture_at_rest();
  lesson.press({"ctrl+s"});
  ASSERT_TRUE(eventually([&] { return files(".png").size() == 1; }));
  Result<PngFile> saved = read_png(files(".png").front());
  ASSERT_TRUE(saved);
  EXPECT_EQ(text_in(*saved, "polhode:stage"), "figure");
  EXPECT_NE(text_in(*saved, "polhode:t"), "0");
  EXPECT_EQ(saved->image.rgba, exported(kPlayed, *saved, "page", "01-figure-step2.png").rgba);
}

TEST_F(TakeAway, WhatWasMadeByHandIsALessonOfTheSameFigure) {
  PlayedLesson lesson(display(), home(), {kPlayed});
  const Image start = lesson.picture_at_rest();
  lesson.drag({kOmegaTip, {kOmegaTip.x - 40, kOmegaTip.y + 20}});
  ASSERT_TRUE(lesson.changes_from(start));
  lesson.drag({kInFigure, {kInFigure.x + 50, kInFigure.y}});
  lesson.press({"shift+Right", "shift+Right", "e"});
  lesson.picture_at_rest();
  lesson.click(kSaveFigure);
  ASSERT_TRUE(eventually([&] { return files(".png").size() == 1; }));
  lesson.click(kSaveLesson);
  ASSERT_TRUE(eventually([&] { return files(".md").size() == 1; }));
  Result<PngFile> saved = read_png(files(".png").front());
  ASSERT_TRUE(saved);
  const std::string made = files(".md").front().string();
  EXPECT_EQ(saved->image.rgba, exported(made, *saved, "figure", "01-figure-step1.png").rgba);
  EXPECT_NE(saved->image.rgba, exported(kPlayed, *saved, "figure", "01-figure-step1.png").rgba);
}

// They are made beside the window, by the program itself.
TEST_F(TakeAway, SlidesAreMadeOfTheStagesThatAreChosen) {
  std::filesystem::create_directories(home().state());
  write_text(home().state() / "played.place.json",
             R"({"format": 1, "stage": "figure", "step": 1, "visited": ["figure"], "left_out": ["end"]})");
  PlayedLesson lesson(display(), home(), {kPlayed});
  lesson.press({"e"});
  lesson.picture_at_rest();
  lesson.click(kSaveSlides);
  ASSERT_TRUE(eventually([&] { return files(".html").size() == 1; }));
  const std::string deck = text_of(files(".html").front());
  EXPECT_NE(deck.find("A question"), std::string::npos);
  EXPECT_EQ(deck.find("The end"), std::string::npos);
  const fs::path parts = files(".html").front().string() + ".parts";
  EXPECT_TRUE(eventually([&] { return !fs::exists(parts); })) << "nothing else is left";
}

// Asked to close, or torn away at any moment of a save: what is there is whole.
TEST_F(TakeAway, AWindowClosedDuringASaveLeavesNothingHalfWritten) {
  for (int delay_ms : {0, 0, 20, 60, 100, 140}) {
    PlayedLesson lesson(display(), home(), {kPlayed});
    lesson.press({"ctrl+s"});
    std::this_thread::sleep_for(std::chrono::milliseconds(delay_ms));
    if (delay_ms == 0) {
      lesson.close();
      EXPECT_EQ(lesson.process().wait(), 0);
    } else {
      kill(lesson.process().id(), SIGKILL);
      EXPECT_EQ(lesson.process().wait(), 128 + SIGKILL);
    }
  }
  EXPECT_GE(files(".png").size(), 1u);
  for (const fs::path& path : files(".png")) EXPECT_TRUE(read_png(path)) << path;
}

}  // namespace
}  // namespace polhode::window_test
