// SPDX-License-Identifier: MIT
// Exports by several processes of one command.
#include "app/cli/exit_codes.h"
#include "app/export/folder/export_folder.h"
#include "app/export/jobs.h"
#include "tests/app/export/small_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

namespace polhode {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(Jobs, AreAllRunAndCounted) {
  const InterruptWatch watch;
  std::size_t last = 0;
  const auto end = run_jobs(
      5,
      [](int number, const TellJob& tell) -> Outcome<JobEnd> {
        for (int i = 0; i <= number; ++i) tell();
        return JobEnd::done;
      },
      [&](std::size_t told) { last = told; }, watch);
  ASSERT_TRUE(end);
  EXPECT_EQ(*end, JobEnd::done);
  EXPECT_EQ(last, 1 + 2 + 3 + 4 + 5u);
}

TEST(Jobs, AnErrorStopsTheOthersAndIsToldOnce) {
  const InterruptWatch watch;
  const auto job = [&](int number, const TellJob&) -> Outcome<JobEnd> {
    if (number == 1) return failure_of(Fault::invalid, "no such body.\nSecond line: dii.");
    for (int i = 0; i < 3000 && !watch.interrupted(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return watch.interrupted() ? JobEnd::interrupted : JobEnd::done;
  };
  const auto start = std::chrono::steady_clock::now();
  const auto end = run_jobs(
      3, job, [](std::size_t) {}, watch);
  ASSERT_FALSE(end);
  EXPECT_EQ(end.error().fault, Fault::invalid);
  EXPECT_EQ(end.error().text, "no such body.\nSecond line: dii.");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20)) << "the others went on";
}

TEST(Jobs, OneThatIsKilledIsAnError) {
  const InterruptWatch watch;
  const auto job = [](int, const TellJob&) -> Outcome<JobEnd> {
    ::kill(::getpid(), SIGKILL);
    return JobEnd::done;
  };
  const auto end = run_jobs(
      2, job, [](std::size_t) {}, watch);
  ASSERT_FALSE(end);
  EXPECT_EQ(end.error().fault, Fault::failed);
  EXPECT_THAT(end.error().text, HasSubstr("signal 9"));
}

TEST(ExportJobs, MakeTheBytesOfOneProcess) {
  const ScratchFolder scratch;
  ASSERT_EQ(polhode(small_export(scratch / "one")).code, 0);
  for (const char* jobs : {"2", "5"}) {
    const ProgramRun run = polhode(small_export(scratch / jobs, {"--jobs", jobs}));
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "12 pictures and manifest.json in " + (scratch / jobs).string() + "\n");
    EXPECT_EQ(contents(scratch / jobs), contents(scratch / "one"));
  }
  for (const char* shard : {"2/2", "1/2"})
    ASSERT_EQ(polhode(small_export(scratch / "both", {"--shard", shard, "--jobs", "3"})).code, 0);
  EXPECT_EQ(contents(scratch / "both"), contents(scratch / "one"));
}

TEST(ExportJobs, ReportAnErrorOnce) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "03-rolling-frame06.png");
  const ProgramRun run = polhode(small_export(scratch.path(), {"--jobs", "3"}));
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("go on with"));
  EXPECT_EQ(run.err.find("03-rolling-frame06.png"), run.err.rfind("03-rolling-frame06.png")) << run.err;
  const ProgramRun bad = polhode({"export", test_lesson("overflow.md"), "-o", scratch / "out", "--at", "9",
                                  "--jobs", "2", "--each", "step"});
  EXPECT_EQ(bad.code, 1);
  EXPECT_EQ(bad.err.find("cannot be computed"), bad.err.rfind("cannot be computed")) << bad.err;
  EXPECT_FALSE(fs::exists(scratch / "out"));
}

/// Processes whose command line has a word.
std::size_t processes_with(const std::string& word) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::error_code none;
    if (!fs::exists(entry.path() / "cmdline", none)) continue;
    count += text_of(entry.path() / "cmdline").find(word) != std::string::npos ? 1 : 0;
  }
  return count;
}

void wait_for_pictures(const fs::path& folder) {
  const auto drawn = [&] {
    std::error_code none;
    for (fs::directory_iterator entry(folder, none), end; !none && entry != end; entry.increment(none))
      if (entry->path().extension() == ".png") return true;
    return false;
  };
  for (int tries = 0; tries < 6000 && !drawn(); ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

TEST(ExportJobs, AreInterruptedTogetherAndGoOn) {
  const ScratchFolder scratch;
  const std::vector<std::string> film = {"export",  test_lesson("tiny.md"),
                                         "-o",      scratch.path(),
                                         "--what",  "figure",
                                         "--size",  "48x27",
                                         "--each",  "frame",
                                         "--fps",   "100",
                                         "--stage", "rolling",
                                         "--jobs",  "3"};
  RunOptions options;
  options.while_running = [&](pid_t program) {
    wait_for_pictures(scratch.path());
    kill(program, SIGINT);
  };
  const ProgramRun run = polhode(film, options);
  EXPECT_EQ(run.code, 130) << run.err;
  EXPECT_THAT(run.err, testing::AllOf(HasSubstr("interrupted after"), HasSubstr("--jobs 3 --skip-existing")));
  EXPECT_EQ(processes_with(scratch.path().string()), 0u);
  EXPECT_FALSE(fs::exists(scratch / kManifestName));
}

TEST(ExportJobs, EndWithTheProcessThatStartedThem) {
  const ScratchFolder scratch;
  const std::vector<std::string> film = {"export",  test_lesson("tiny.md"),
                                         "-o",      scratch.path(),
                                         "--what",  "figure",
                                         "--size",  "48x27",
                                         "--each",  "frame",
                                         "--fps",   "1000",
                                         "--stage", "rolling",
                                         "--jobs",  "2"};
  RunOptions options;
  options.while_running = [&](pid_t program) {
    wait_for_pictures(scratch.path());
    kill(program, SIGKILL);
  };
  EXPECT_EQ(polhode(film, options).code, 128 + SIGKILL);
  for (int tries = 0; tries < 2000 && processes_with(scratch.path().string()) > 0; ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(processes_with(scratch.path().string()), 0u);
  EXPECT_LT(names_in(scratch.path()).size(), 8000u);
}

}  // namespace
}  // namespace polhode
