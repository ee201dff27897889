// SPDX-License-Identifier: MIT
#include "app/session/lesson_search.h"

#include "tests/app/session/example_lesson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

class LessonSearchTest : public testing::Test {
 protected:
  std::vector<StepPlace> places(std::string_view typed) const {
    std::vector<StepPlace> all;
    for (const LessonSearch::Found& found : search_.find(typed)) all.push_back(found.place);
    return all;
  }
  std::shared_ptr<const LoadedLesson> loaded_ = test::loaded_lesson("euler-equations");
  SpeechText speech_{loaded_->lesson};
  LessonSearch search_{loaded_->lesson, speech_};
};

TEST_F(LessonSearchTest, FindsWordsOfTheText) {
  const auto found = search_.find("Poinsot pictured");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(loaded_->lesson.stages[found.front().place.stage].id, "poinsot");
  EXPECT_NE(found.front().around.find("Poinsot pictured the whole free motion"), std::string::npos)
      << found.front().around;
  EXPECT_EQ(places("POINSOT pictured"), places("pictured poinsot")) << "in whatever order, with any capitals";
  EXPECT_THAT(places("poins pict"), testing::Contains(found.front().place)) << "while it is typed";
}

TEST_F(LessonSearchTest, FindsFormulasAsTheyAreSaidShownOrTyped) {
  EXPECT_FALSE(places("omega cross").empty());
  EXPECT_EQ(places("ω ×"), places("omega cross"));
  EXPECT_FALSE(places("\\vec\\omega \\times").empty());
  EXPECT_FALSE(places("\\mathbf").empty());
  EXPECT_TRUE(places("mathbf").empty()) << "a command is no word";
  EXPECT_FALSE(places("ω₂").empty());
}

TEST_F(LessonSearchTest, FindsNothingInTheMiddleOfAWord) {
  EXPECT_TRUE(places("oinsot").empty());
  EXPECT_TRUE(places("").empty());
  EXPECT_TRUE(places("  ").empty());
  EXPECT_TRUE(places("no such words anywhere zzz").empty());
}

TEST_F(LessonSearchTest, TellsWholeLinesOrSaysThatTheyGoOn) {
  for (const char* typed : {"the", "energy", "a", "."})
    for (const LessonSearch::Found& found : search_.find(typed)) {
      EXPECT_FALSE(found.around.empty()) << typed;
      EXPECT_LT(found.around.size(), 160U) << found.around;
      EXPECT_EQ(found.around.find('\n'), std::string::npos) << found.around;
    }
}

}  // namespace
}  // namespace polhode
