// SPDX-License-Identifier: MIT
#include "app/export/background_program.h"

#include "tests/app/run_program.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <thread>

namespace polhode {
namespace {

/// Its code, as soon as it has one.
int code_in_the_end(BackgroundProgram& program) {
  while (!program.code()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  return *program.code();
}

TEST(BackgroundProgram, RunsBesideAndTellsItsEnd) {
  const ScratchFolder folder;
  auto begun = BackgroundProgram::start(
      {"sh", "-c", "cat > \"$0\"; echo told; echo why >&2; echo so >&2; exit 3", (folder / "read").string()});
  ASSERT_TRUE(begun) << begun.error();
  BackgroundProgram program = std::move(begun).value();
  EXPECT_EQ(code_in_the_end(program), 3);
  EXPECT_EQ(program.last_words(), "why\nso");
  EXPECT_EQ(text_of(folder / "read"), "") << "there is nothing to be read";
  program.end();
  EXPECT_EQ(program.code(), 3);
}

TEST(BackgroundProgram, KeepsItsAnswerForWhoAsks) {
  auto begun = BackgroundProgram::start({"sh", "-c", "echo told; echo why >&2"}, true);
  ASSERT_TRUE(begun) << begun.error();
  BackgroundProgram program = std::move(begun).value();
  EXPECT_EQ(code_in_the_end(program), 0);
  EXPECT_EQ(program.answer(), "told\nwhy\n");
}

TEST(BackgroundProgram, IsEnded) {
  auto begun = BackgroundProgram::start({"sleep", "1000"});
  ASSERT_TRUE(begun) << begun.error();
  EXPECT_EQ(begun->code(), std::nullopt);
  BackgroundProgram moved = std::move(begun).value();
  moved.end();
  EXPECT_EQ(moved.code(), 128 + SIGTERM);
}

TEST(BackgroundProgram, SaysWhatIsMissing) {
  const auto begun = BackgroundProgram::start({"no-such-program"});
  ASSERT_FALSE(begun);
  EXPECT_EQ(begun.error(), "there is no no-such-program");
}

}  // namespace
}  // namespace polhode
