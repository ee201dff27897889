// SPDX-License-Identifier: MIT
#include "app/session/saved_progress.h"

#include "app/session/state_file.h"
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
  explicit Window(const ScratchFolder& scratch) : memory(companion, scratch.path()) {
    companion.go_to({0, 1});
  }
  void answer(const char* text) { companion.answer(*companion.questions().at(0), text); }

  Companion companion{test::example()};
  Memory memory;
};

class MemoryOfAWindow : public ::testing::Test {
 protected:
  std::filesystem::path log() const { return answer_log_path(scratch_.path(), test::example()->lesson.id); }
  AnswerLog logged() const { return read_answer_log(log())->log; }
  ScratchFolder scratch_;
};

TEST_F(MemoryOfAWindow, BringsBackPlaceAnswersAndPreferences) {
  {
    Window window(scratch_);
    window.answer("B");
    window.companion.preferences.theme = Theme::dark;
    EXPECT_THAT(window.memory.keep(window.companion), IsEmpty());
  }
  Companion companion(test::example());
  const Memory memory(companion, scratch_.path());
  EXPECT_THAT(memory.news(), IsEmpty());
  EXPECT_EQ(companion.place(), (Place{0, 1}));
  EXPECT_EQ(companion.answers().at(kAxis), (AnswerRecord{1, 1, 0, "B"}));
  EXPECT_EQ(companion.preferences.theme, Theme::dark);
}

// A was right in the window, and `polhode answer L S A --reset` forgot it before B was answered.
TEST_F(MemoryOfAWindow, DoesNotBringBackWhatAResetForgot) {
  Window window(scratch_);
  window.answer("B");
  window.memory.keep(window.companion);
  ASSERT_TRUE(change_answer_log(log(), [](AnswerLog& log) { log.erase(kAxis); }));
  AnswerLog more = window.companion.answers();
  more["free/other"] = {1, 1, 0, "w1"};
  window.companion.set_answers(more);
  window.memory.keep(window.companion);
  EXPECT_EQ(logged(), (AnswerLog{{"free/other", {1, 1, 0, "w1"}}}));
  window.answer("A");
  window.memory.keep(window.companion);
  EXPECT_EQ(logged().at(kAxis), (AnswerRecord{0, 1, 0, "A"})) << "answered again, and wrong";
}

TEST_F(MemoryOfAWindow, TellsOfALogThatWasDamagedMeanwhile) {
  Window window(scratch_);
  write_text(log(), "{\"format\":1,");
  window.answer("B");
  EXPECT_THAT(window.memory.keep(window.companion), HasSubstr("was damaged: it is now "));
  EXPECT_EQ(logged().at(kAxis), (AnswerRecord{1, 1, 0, "B"}));
  EXPECT_THAT(window.memory.keep(window.companion), IsEmpty()) << "once";
}

TEST_F(MemoryOfAWindow, WaitsForNobodyAndTriesAgain) {
  Window window(scratch_);
  std::optional held(StateLock::take(log(), 0ms));
  ASSERT_TRUE(*held);
  window.answer("B");
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THAT(window.memory.keep(window.companion), IsEmpty());
  EXPECT_LT(std::chrono::steady_clock::now() - begin, kAnswerPatience / 10) << "it is in the drawing loop";
  EXPECT_THAT(logged(), IsEmpty());
  held.reset();
  EXPECT_THAT(window.memory.keep(window.companion), IsEmpty());
  EXPECT_EQ(logged().at(kAxis), (AnswerRecord{1, 1, 0, "B"}));
}

TEST_F(MemoryOfAWindow, AtLastSaysWhatIsNotKept) {
  Window window(scratch_);
  const auto held = StateLock::take(log(), 0ms);
  ASSERT_TRUE(held);
  window.answer("B");
  EXPECT_THAT(window.memory.keep_at_last(window.companion),
              HasSubstr("another polhode has held it for 0.5 s: the last answers are not kept"));
}

TEST_F(MemoryOfAWindow, SaysOnceThatNothingCanBeKept) {
  Window window(scratch_);
  write_text(log(), "{\"format\":2}");
  window.answer("B");
  EXPECT_THAT(window.memory.keep(window.companion), HasSubstr("another version"));
  window.answer("A");
  EXPECT_THAT(window.memory.keep(window.companion), IsEmpty());
  EXPECT_EQ(text_of(log()), "{\"format\":2}");
  Companion companion(test::example());
  EXPECT_THAT(Memory(companion, std::nullopt).news(), HasSubstr("HOME"));
}

}  // namespace
}  // namespace polhode
