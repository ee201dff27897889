// SPDX-License-Identifier: MIT
// Ctrl-C while a motion is computed: it is obeyed at once, whatever the command is.
#include "base/interrupt.h"

#include "app/export/folder/export_folder.h"
#include "physics/effort.h"
#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <functional>
#include <thread>

namespace polhode {
namespace {

using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

/// Legal, and dear in every part of it: a million steps to each of its times, in many stages.
std::string dear_lesson() {
  std::string text = "+++\nformat = 1\nid = \"dear\"\ntitle = \"Dear\"\n+++\n";
  for (int stage = 0; stage < 60; ++stage)
    text += "# Stage {s" + std::to_string(stage) + "}\nWords.\n\n```scene\nomega = [0.1, " +
            std::to_string(stage + 1) +
            ", 0.2]\nmotion = { method = \"moser-veselov-10\", step = 1e-4 }\nat = 100\nshow = "
            "[\"omega\"]\n```\n";
  return text;
}

struct Interrupted130 {
  ProgramRun run;
  double obeyed_s = 0;
};

/// Whether it has made Ctrl-C its own business.
bool catches_sigint(pid_t program) {
  const std::string status = text_of("/proc/" + std::to_string(program) + "/status");
  const std::size_t at = status.find("SigCgt:");
  return at != std::string::npos &&
         (std::stoull(status.substr(at + 7), nullptr, 16) >> (SIGINT - 1) & 1U) != 0;
}

/// @param begun what is waited for before the time begins to run
Interrupted130 interrupted(
    const std::vector<std::string>& words, double after_s,
    const std::function<bool(pid_t)>& begun = [](pid_t) { return true; }) {
  Interrupted130 result;
  Clock::time_point sent;
  RunOptions options;
  options.while_running = [&](pid_t program) {
    for (int tries = 0; tries < 6000 && !begun(program); ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::this_thread::sleep_for(std::chrono::duration<double>(after_s));
    sent = Clock::now();
    kill(program, SIGINT);
  };
  result.run = polhode(words, options);
  result.obeyed_s = std::chrono::duration<double>(Clock::now() - sent).count();
  return result;
}

class CtrlC : public testing::Test {
 protected:
  void SetUp() override { write_text(lesson(), dear_lesson()); }
  std::string lesson() const { return scratch / "dear.md"; }
  ScratchFolder scratch;
};

TEST_F(CtrlC, EndsEveryCommandWithinASecond) {
  const std::vector<std::vector<std::string>> commands = {
      {"lint", lesson()},
      {"info", lesson()},
      {"export", lesson(), "-o", scratch / "out", "--size", "320x240"},
      {"measure", lesson(), "--stage", "s5", "--seconds", "100"},
      {"trace", "--inertia", "1,1.75,2.5", "--omega", "0.2,0.1,3", "--method", "rk4", "--step", "1e-6",
       "--times", "90"}};
  for (const auto& words : commands)
    for (const double after_s : {0.3, 1.2}) {
      const Interrupted130 ended = interrupted(words, after_s);
      EXPECT_EQ(ended.run.code, 130) << words[0] << ended.run.out << ended.run.err;
      EXPECT_LT(ended.obeyed_s, 1.0) << words[0];
    }
}

/// The export itself, and not the reading before it, which a signal ends at once: --at leads to where many
/// steps have to be made, past what the scenes ask for.
TEST_F(CtrlC, StopsAnExportThatComputesAMotion) {
  write_text(lesson(),
             "+++\nformat = 1\nid = \"dear\"\ntitle = \"Dear\"\n+++\n# One {one}\nWords.\n\n```scene\n"
             "omega = [0.1, 3, 0.2]\nmotion = { method = \"moser-veselov-10\", step = 1e-6 }\nshow = "
             "[\"omega\", \"shape\"]\n```\n");
  const Interrupted130 ended = interrupted(
      {"export", lesson(), "-o", scratch / "out", "--what", "figure", "--size", "320x240", "--at", "99"}, 1.5,
      catches_sigint);
  EXPECT_EQ(ended.run.code, 130) << ended.run.err;
  EXPECT_LT(ended.obeyed_s, 1.0);
  EXPECT_THAT(ended.run.err, HasSubstr("interrupted after 0 of 1 pictures"));
  EXPECT_THAT(ended.run.err, HasSubstr("--skip-existing"));
}

TEST(UntilInterrupted, ThrowsWhileAWatchHasSeenASignal) {
  const Effort effort = until_interrupted();
  EXPECT_NO_THROW(effort(1));
  {
    const InterruptWatch watch;
    EXPECT_NO_THROW(effort(1));
    raise(SIGINT);
    EXPECT_TRUE(watch.interrupted());
    EXPECT_THROW(effort(1), Interrupted);
  }
  EXPECT_NO_THROW(effort(1));
}

}  // namespace
}  // namespace polhode
