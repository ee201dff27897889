// SPDX-License-Identifier: MIT
#include "app/session/saved/saved_progress.h"

#include "app/session/saved/answer_file.h"
#include "app/session/saved/state_file.h"
#include "tests/app/run_program.h"
#include "tests/app/session/example_lesson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

namespace polhode {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kAxis = "free/axis";

/// A window on the example, at its question; its state folder is that of the test.
struct Window {
  explicit Window(const ScratchFolder& scratch) : progress(session, scratch.path()) { session.go_to({0, 1}); }
  void answer(const char* text) { session.answer(*session.questions().at(0), text); }

  LessonSession session{test::example()};
  SavedProgress progress;
};

class SavedProgressOfAWindow : public ::testing::Test {
 protected:
  std::filesystem::path log() const { return answer_log_path(scratch_.path(), test::example()->lesson.id); }
  AnswerLog logged() const { return read_answer_log(log())->log; }
  ScratchFolder scratch_;
};

TEST_F(SavedProgressOfAWindow, BringsBackPlaceAnswersAndPreferences) {
  {
    Window window(scratch_);
    window.answer("B");
    window.session.preferences.theme = Theme::dark;
    EXPECT_THAT(window.progress.keep(window.session), IsEmpty());
  }
  LessonSession session(test::example());
  const SavedProgress progress(session, scratch_.path());
  EXPECT_THAT(progress.notice(), IsEmpty());
  EXPECT_EQ(session.place(), (StepPlace{0, 1}));
  EXPECT_EQ(session.answers().at(kAxis), (AnswerRecord{1, 1, 0, "B", "B", {}}));
  EXPECT_EQ(session.preferences.theme, Theme::dark);
}

// A was right in the window, and `polhode answer L S A --reset` forgot it before B was answered.
TEST_F(SavedProgressOfAWindow, DoesNotBringBackWhatAResetForgot) {
  Window window(scratch_);
  window.answer("B");
  window.progress.keep(window.session);
  ASSERT_TRUE(change_answer_log(log(), [](AnswerLog& log) { log.erase(kAxis); }));
  AnswerLog more = window.session.answers();
  more["free/other"] = {1, 1, 0, "w1", "w1", {}};
  window.session.set_answers(more);
  window.progress.keep(window.session);
  EXPECT_EQ(logged(), (AnswerLog{{"free/other", {1, 1, 0, "w1", "w1", {}}}}));
  window.answer("A");
  window.progress.keep(window.session);
  EXPECT_EQ(logged().at(kAxis), (AnswerRecord{0, 1, 0, "A", "", {{"choice-A", 1}}}))
      << "answered again, and wrong";
}

TEST_F(SavedProgressOfAWindow, TellsOfALogThatWasDamagedMeanwhile) {
  Window window(scratch_);
  write_text(log(), "{\"format\":1,");
  window.answer("B");
  EXPECT_THAT(window.progress.keep(window.session), HasSubstr("was damaged: it is now "));
  EXPECT_EQ(logged().at(kAxis), (AnswerRecord{1, 1, 0, "B", "B", {}}));
  EXPECT_THAT(window.progress.keep(window.session), IsEmpty()) << "once";
}

TEST_F(SavedProgressOfAWindow, WaitsForNobodyAndTriesAgain) {
  Window window(scratch_);
  std::optional held(StateLock::take(log(), 0ms));
  ASSERT_TRUE(*held);
  window.answer("B");
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THAT(window.progress.keep(window.session), IsEmpty());
  EXPECT_LT(std::chrono::steady_clock::now() - begin, kAnswerPatience / 10) << "it is in the drawing loop";
  EXPECT_THAT(logged(), IsEmpty());
  held.reset();
  EXPECT_THAT(window.progress.keep(window.session), IsEmpty());
  EXPECT_EQ(logged().at(kAxis), (AnswerRecord{1, 1, 0, "B", "B", {}}));
}

TEST_F(SavedProgressOfAWindow, AtLastSaysWhatIsNotKept) {
  Window window(scratch_);
  const auto held = StateLock::take(log(), 0ms);
  ASSERT_TRUE(held);
  window.answer("B");
  EXPECT_THAT(window.progress.keep_at_last(window.session),
              HasSubstr("another polhode has held it for 0.5 s: the last answers are not kept"));
}

TEST_F(SavedProgressOfAWindow, SaysOnceThatNothingCanBeKept) {
  Window window(scratch_);
  write_text(log(), "{\"format\":2}");
  window.answer("B");
  EXPECT_THAT(window.progress.keep(window.session), HasSubstr("another version"));
  window.answer("A");
  EXPECT_THAT(window.progress.keep(window.session), IsEmpty());
  EXPECT_EQ(text_of(log()), "{\"format\":2}");
  LessonSession session(test::example());
  EXPECT_THAT(SavedProgress(session, std::nullopt).notice(), HasSubstr("HOME"));
}

}  // namespace
}  // namespace polhode
