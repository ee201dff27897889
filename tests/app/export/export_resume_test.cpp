// SPDX-License-Identifier: MIT
// Exports that are stopped, go on, and are made in parts: in the end the same bytes.
#include "app/export/folder/export_folder.h"
#include "render/image/png.h"
#include "tests/app/export/small_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>

namespace polhode {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;
using Json = nlohmann::json;
namespace fs = std::filesystem;

/// What one uninterrupted process makes.
const std::map<std::string, std::string>& whole_export() {
  static const std::map<std::string, std::string> kFiles = [] {
    const ScratchFolder scratch;
    const ProgramRun run = polhode(small_export(scratch.path()));
    EXPECT_EQ(run.code, 0) << run.err;
    return contents(scratch.path());
  }();
  return kFiles;
}

std::string shard_word(std::int64_t index, std::int64_t count) {
  return std::to_string(index) + '/' + std::to_string(count);
}

std::vector<std::int64_t> shuffled(std::int64_t count, std::mt19937& random) {
  std::vector<std::int64_t> order;
  for (std::int64_t i = 1; i <= count; ++i) order.push_back(i);
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

/// Sends a signal some time after the start.
RunOptions struck(int signal_number, double after_s) {
  RunOptions options;
  options.while_running = [=](pid_t program) {
    std::this_thread::sleep_for(std::chrono::duration<double>(after_s));
    kill(program, signal_number);
  };
  return options;
}

/// Sends a signal as soon as a picture is there.
RunOptions struck_while_drawing(const fs::path& folder, int signal_number) {
  RunOptions options;
  options.while_running = [=](pid_t program) {
    const auto drawn = [&] {
      std::error_code none;
      for (fs::directory_iterator entry(folder, none), end; !none && entry != end; entry.increment(none))
        if (entry->path().extension() == ".png") return true;
      return false;
    };
    for (int tries = 0; tries < 6000 && !drawn(); ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    kill(program, signal_number);
  };
  return options;
}

TEST(ExportShards, InAnyOrderMakeTheBytesOfOneProcess) {
  std::mt19937 random(1);
  for (const std::int64_t count : {1, 2, 3, 5, 8, 13}) {  // 13: more than there are pictures
    const ScratchFolder scratch;
    for (const std::int64_t index : shuffled(count, random)) {
      EXPECT_FALSE(fs::exists(scratch / kManifestName));
      const ProgramRun run = polhode(small_export(scratch.path(), {"--shard", shard_word(index, count)}));
      ASSERT_EQ(run.code, 0) << run.err;
    }
    EXPECT_EQ(contents(scratch.path()), whole_export()) << count;
  }
}

TEST(ExportShards, LeaveAManifestOfTheirOwnUntilAllAreThere) {
  const ScratchFolder scratch;
  const ProgramRun run = polhode(small_export(scratch.path(), {"--shard", "2/5"}));
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("shard 2/5"));
  EXPECT_THAT(names_in(scratch.path()),
              ElementsAre(kMarkerName, "01-steady-frame01.png", "03-rolling-frame06.png",
                          "03-rolling-frame11.png", "manifest.2-of-5.json"));
  const Json manifest = Json::parse(text_of(scratch / "manifest.2-of-5.json"));
  EXPECT_EQ(manifest["files"].size(), 3u);
  EXPECT_EQ(manifest["files"][1]["frame"], 6);
}

TEST(ExportShards, AtTheSameTimeMakeTheBytesOfOneProcess) {
  for (int round = 0; round < 3; ++round) {
    const ScratchFolder scratch;
    std::vector<std::thread> shards;
    std::vector<ProgramRun> runs(3);
    for (std::size_t i = 0; i < runs.size(); ++i)
      shards.emplace_back([&, i] {
        runs[i] = polhode(small_export(scratch.path(), {"--shard", shard_word(static_cast<int>(i) + 1, 3)}));
      });
    for (std::thread& shard : shards) shard.join();
    for (const ProgramRun& run : runs) EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(contents(scratch.path()), whole_export());
  }
}

TEST(ExportShards, AreNotNeededForTwoOfTheSameCommandInOneFolder) {
  const ScratchFolder scratch;
  ProgramRun runs[2];
  std::thread other([&] { runs[1] = polhode(small_export(scratch.path())); });
  runs[0] = polhode(small_export(scratch.path()));
  other.join();
  for (const ProgramRun& run : runs) EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(contents(scratch.path()), whole_export());
}

TEST(ExportShards, MadeAgainInAFinishedFolderLeaveItFinished) {
  const ScratchFolder scratch;
  ASSERT_EQ(polhode(small_export(scratch.path())).code, 0);
  fs::resize_file(scratch / "01-steady-frame01.png", 100);
  EXPECT_EQ(polhode(small_export(scratch.path(), {"--shard", "2/3", "--skip-existing"})).code, 0);
  EXPECT_EQ(contents(scratch.path()), whole_export());
}

TEST(ExportShards, OfDifferentDriversAreToldInTheManifest) {
  const ScratchFolder scratch;
  RunOptions narrow;
  narrow.environment = {{"GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1"}};  // as an older machine
  ASSERT_EQ(polhode(small_export(scratch.path(), {"--shard", "1/2"}), narrow).code, 0);
  const ProgramRun last = polhode(small_export(scratch.path(), {"--shard", "2/2"}));
  ASSERT_EQ(last.code, 0);
  const std::string renderer = Json::parse(text_of(scratch / kManifestName))["renderer"];
  const std::string usual = Json::parse(whole_export().at(kManifestName))["renderer"];
  if (usual.find("128 bits") != std::string::npos) GTEST_SKIP() << "this machine has 128 bits only";
  EXPECT_THAT(renderer, AllOf(HasSubstr("128 bits"), HasSubstr(" | "), HasSubstr(usual)));
  EXPECT_THAT(last.err, HasSubstr("different drivers"));
}

TEST(ExportShards, OfSlurmAreReadFromTheEnvironment) {
  const ScratchFolder scratch;
  for (const char* task : {"7", "5"}) {  // --array=5-7:2
    RunOptions options;
    options.environment = {{"SLURM_ARRAY_TASK_ID", task},
                           {"SLURM_ARRAY_TASK_MIN", "5"},
                           {"SLURM_ARRAY_TASK_STEP", "2"},
                           {"SLURM_ARRAY_TASK_COUNT", "2"}};
    const ProgramRun run = polhode(small_export(scratch.path(), {"--shard", "slurm"}), options);
    EXPECT_EQ(run.code, 0) << run.err;
  }
  EXPECT_EQ(contents(scratch.path()), whole_export());
}

/// Everything under a final name is whole, whenever the process died.
void expect_nothing_half_written(const fs::path& folder) {
  for (const std::string& name : names_in(folder)) {
    if (name.ends_with(".png")) {
      EXPECT_TRUE(read_png(folder / name).ok()) << name;
    }
    if (name.ends_with(".json")) {
      EXPECT_TRUE(Json::accept(text_of(folder / name))) << name;
    }
  }
}

int kills_of_a_test() {
  const char* value = std::getenv("POLHODE_KILLS");
  return value ? std::atoi(value) : 40;
}

/// 200 kills in five tests, each with a seed of its own, so that two cores share them.
class Killed : public testing::TestWithParam<unsigned> {};

TEST_P(Killed, AtAnyTimeAnExportGoesOnToTheBytesOfOneProcess) {
  const auto start = std::chrono::steady_clock::now();
  static_cast<void>(whole_export());
  const double takes_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::mt19937 random(GetParam());
  constexpr int kKillsOfAnExport = 8;
  for (int kills = 0; kills < kills_of_a_test(); kills += kKillsOfAnExport) {
    const ScratchFolder scratch;
    const std::int64_t count = std::uniform_int_distribution<std::int64_t>(1, 8)(random);
    const auto make = [&](std::int64_t index, const RunOptions& options) {
      return polhode(small_export(scratch.path(), {"--skip-existing", "--shard", shard_word(index, count)}),
                     options);
    };
    for (int i = 0; i < kKillsOfAnExport; ++i) {
      const auto index = std::uniform_int_distribution<std::int64_t>(1, count)(random);
      make(index, struck(SIGKILL, std::uniform_real_distribution(0.0, takes_s)(random)));
      expect_nothing_half_written(scratch.path());
    }
    for (const std::int64_t index : shuffled(count, random)) {
      const ProgramRun run = make(index, {});
      ASSERT_EQ(run.code, 0) << run.err;
    }
    ASSERT_EQ(contents(scratch.path()), whole_export()) << kills << " kills, " << count << " shards";
  }
}

INSTANTIATE_TEST_SUITE_P(Export, Killed, testing::Range(1u, 6u));

TEST(Interrupted, SaysTheCommandThatGoesOn) {
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    const ScratchFolder scratch;
    const std::string folder = scratch / "it's here";
    const Words film = {"export",  test_lesson("tiny.md"),
                        "-o",      folder,
                        "--what",  "figure",
                        "--size",  "64x36",
                        "--each",  "frame",
                        "--fps",   "100",
                        "--stage", "rolling"};
    const ProgramRun run = polhode(film, struck_while_drawing(folder, signal_number));
    EXPECT_EQ(run.code, 130) << run.err;
    ASSERT_THAT(run.err, AllOf(HasSubstr("interrupted after "), HasSubstr("of 800 pictures")));
    expect_nothing_half_written(folder);
    EXPECT_TRUE(fs::exists(fs::path(folder) / kMarkerName));
    EXPECT_FALSE(fs::exists(fs::path(folder) / kManifestName));
    const std::string command = run.err.substr(run.err.find("go on with") + 10);
    EXPECT_THAT(command, HasSubstr("'" + (scratch / "it'\\''s here").string() + "'"));
    EXPECT_EQ(std::system((command.substr(0, command.find_last_not_of('\n') + 1) + " 2>/dev/null").c_str()),
              0)
        << command;
    EXPECT_TRUE(fs::exists(fs::path(folder) / kManifestName));
    EXPECT_EQ(names_in(folder).size(), 801u);
  }
}

// 21 November 2026: the last shard wrote a manifest of pictures that were no longer there.
TEST(ExportShards, WhereAPictureIsGoneNoManifestPromisesIt) {
  const ScratchFolder scratch;
  const auto make = [&](const Words& more) { return polhode(small_export(scratch.path(), more)); };
  ASSERT_EQ(make({"--shard", "1/2"}).code, 0);
  fs::remove(scratch / whole_export().begin()->first);
  const ProgramRun last = make({"--shard", "2/2"});
  EXPECT_EQ(last.code, 1) << last.err;
  EXPECT_THAT(last.err,
              AllOf(HasSubstr(whole_export().begin()->first + " is gone"), HasSubstr("go on with")));
  EXPECT_FALSE(fs::exists(scratch / kManifestName));
  EXPECT_EQ(make({"--skip-existing"}).code, 0);
  EXPECT_EQ(contents(scratch.path()), whole_export());
}

// HOSTILE F7
TEST(Export, ReplacesPlantedLinksAndLeavesTheirTargetsAlone) {
  const ScratchFolder scratch, elsewhere;
  const fs::path folder = scratch / "out";
  fs::create_directory(folder);
  for (const auto& [name, bytes] : whole_export()) {
    if (name == kManifestName) continue;  // whatever stands there is refused
    write_text(elsewhere / name, "precious");
    fs::create_symlink(elsewhere / name, folder / name);
  }
  fs::create_symlink(elsewhere / "dangling", folder / kManifestName);
  EXPECT_EQ(polhode(small_export(folder)).code, 0);
  EXPECT_EQ(contents(folder), whole_export());
  for (const std::string& name : names_in(elsewhere.path())) EXPECT_EQ(text_of(elsewhere / name), "precious");
  EXPECT_FALSE(fs::exists(elsewhere / "dangling"));
}

/// Another picture that looks like this one from outside: its size and all it says of itself.
void paint_over(const fs::path& file) {
  auto png = read_png(file);
  ASSERT_TRUE(png.ok()) << png.error();
  for (std::size_t i = 0; i < png->image.rgba.size(); ++i) png->image.rgba[i] = i % 4 == 3 ? 255 : 0;
  fs::remove(file);
  ASSERT_TRUE(write_png(file, png->image, png->metadata).ok());
}

TEST(ExportShards, MadeAgainDoNotVouchForThePicturesOfOthers) {
  const ScratchFolder scratch;
  ASSERT_EQ(polhode(small_export(scratch.path())).code, 0);
  // As if another driver had drawn the first picture, which is of shard 1; of shard 2 one is damaged.
  auto manifest = nlohmann::ordered_json::parse(text_of(scratch / kManifestName));
  manifest["files"][0]["sha256"] = std::string(64, '0');
  write_text(scratch / kManifestName, manifest.dump());
  paint_over(scratch / "01-steady-frame01.png");
  ASSERT_EQ(polhode(small_export(scratch.path(), {"--shard", "1/2", "--skip-existing"})).code, 0);
  EXPECT_EQ(polhode({"verify", scratch.path()}).code, 4);
  ASSERT_EQ(polhode(small_export(scratch.path(), {"--shard", "2/2", "--skip-existing"})).code, 0);
  EXPECT_EQ(contents(scratch.path()), whole_export());
}

TEST(ExportShards, MadeAgainAtTheSameTimeAreAllInTheManifest) {
  const ScratchFolder scratch;
  ASSERT_EQ(polhode(small_export(scratch.path())).code, 0);
  auto manifest = nlohmann::ordered_json::parse(text_of(scratch / kManifestName));
  for (auto& file : manifest["files"]) file["sha256"] = std::string(64, '0');
  write_text(scratch / kManifestName, manifest.dump());
  ASSERT_EQ(polhode(small_export(scratch.path(), {"--jobs", "6"})).code, 0);
  EXPECT_EQ(contents(scratch.path()), whole_export());
}

TEST(ExportShards, MadeAgainByAnotherDriverAreInTheManifest) {
  if (Json::parse(whole_export().at(kManifestName))["renderer"].get<std::string>().find("128 bits") !=
      std::string::npos)
    GTEST_SKIP() << "this machine has 128 bits only";
  const ScratchFolder scratch;
  ASSERT_EQ(polhode(small_export(scratch.path())).code, 0);
  RunOptions narrow;
  narrow.environment = {{"GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1"}};
  ASSERT_EQ(polhode(small_export(scratch.path(), {"--shard", "1/2"}), narrow).code, 0);
  EXPECT_EQ(polhode({"verify", scratch.path()}).code, 0);
}

std::uint64_t inode(const fs::path& file) {
  struct stat status {};
  return stat(file.c_str(), &status) == 0 ? status.st_ino : 0;
}

TEST(SkipExisting, KeepsWhatIsWholeAndMakesTheRestAgain) {
  const ScratchFolder scratch;
  ASSERT_EQ(polhode(small_export(scratch.path())).code, 0);
  const fs::path kept = scratch / "03-rolling-frame06.png", cut = scratch / "03-rolling-frame07.png",
                 flipped = scratch / "03-rolling-frame08.png", other = scratch / "03-rolling-frame09.png",
                 gone = scratch / "03-rolling-frame10.png";
  const auto kept_inode = inode(kept);
  fs::resize_file(cut, fs::file_size(cut) - 1);
  std::string bytes = text_of(flipped);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  write_text(flipped, bytes);
  fs::copy_file(kept, other, fs::copy_options::overwrite_existing);
  fs::remove(gone);
  const ProgramRun run = polhode(small_export(scratch.path(), {"--skip-existing"}));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("8 of them kept"));
  EXPECT_EQ(contents(scratch.path()), whole_export());
  EXPECT_EQ(inode(kept), kept_inode);
  ASSERT_EQ(polhode(small_export(scratch.path())).code, 0);
  EXPECT_NE(inode(kept), kept_inode) << "made again without --skip-existing";
}

TEST(SkipExisting, MakesAgainWhatIsNotWhatTheManifestSays) {
  const ScratchFolder scratch;
  ASSERT_EQ(polhode(small_export(scratch.path())).code, 0);
  for (const Words& more : std::vector<Words>{{}, {"--jobs", "2"}, {"--shard", "2/3"}}) {
    paint_over(scratch / "01-steady-frame01.png");  // the second of the plan
    EXPECT_EQ(polhode({"verify", scratch.path()}).code, 4);
    Words words = more;
    words.emplace_back("--skip-existing");
    const ProgramRun run = polhode(small_export(scratch.path(), words));
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(contents(scratch.path()), whole_export());
  }
}

TEST(SkipExisting, MakesAgainWhatIsNotWhatTheManifestOfItsShardSays) {
  const ScratchFolder scratch;
  ASSERT_EQ(polhode(small_export(scratch.path(), {"--shard", "2/3"})).code, 0);
  paint_over(scratch / "01-steady-frame01.png");
  const ProgramRun again = polhode(small_export(scratch.path(), {"--shard", "2/3", "--skip-existing"}));
  EXPECT_THAT(again.err, HasSubstr("(3 of them kept)"));
  paint_over(scratch / "01-steady-frame01.png");
  const ProgramRun all = polhode(small_export(scratch.path(), {"--skip-existing"}));
  EXPECT_THAT(all.err, HasSubstr("(3 of them kept)"));
  EXPECT_EQ(contents(scratch.path()), whole_export());
}

TEST(SkipExisting, MakesAgainWhatTheManifestHasNoChecksumOf) {
  const ScratchFolder scratch;
  ASSERT_EQ(polhode(small_export(scratch.path())).code, 0);
  auto manifest = nlohmann::ordered_json::parse(text_of(scratch / kManifestName));
  manifest["files"][1]["sha256"] = nullptr;
  write_text(scratch / kManifestName, manifest.dump());
  paint_over(scratch / "01-steady-frame01.png");
  EXPECT_EQ(polhode(small_export(scratch.path(), {"--skip-existing"})).code, 0);
  EXPECT_EQ(contents(scratch.path()), whole_export());
}

// There a manifest cannot tell: these are of before there were checksums.
TEST(SkipExisting, KeepsWhatIsWholeWhereAManifestHasNoChecksums) {
  const ScratchFolder scratch;
  ASSERT_EQ(polhode(small_export(scratch.path())).code, 0);
  auto manifest = nlohmann::ordered_json::parse(text_of(scratch / kManifestName));
  for (auto& file : manifest["files"]) file.erase("sha256");
  write_text(scratch / kManifestName, manifest.dump());
  const ProgramRun run = polhode(small_export(scratch.path(), {"--skip-existing"}));
  EXPECT_THAT(run.err, HasSubstr("12 of them kept"));
  EXPECT_EQ(contents(scratch.path()), whole_export());
}

// Nothing says of which options these files are.
TEST(SkipExisting, KeepsNothingInAFolderWithoutMarkerAndManifest) {
  const ScratchFolder scratch;
  ASSERT_EQ(polhode(small_export(scratch.path(), {"--background", "white"})).code, 0);
  fs::remove(scratch / kManifestName);
  ASSERT_EQ(polhode(small_export(scratch.path(), {"--skip-existing"})).code, 0);
  EXPECT_EQ(contents(scratch.path()), whole_export());
}

TEST(SkipExisting, AddsFramesToAFinishedRange) {
  const ScratchFolder scratch;
  ASSERT_EQ(polhode(small_export(scratch.path(), {"--frames", "2:5"})).code, 0);
  const auto kept = inode(scratch / "01-steady-frame03.png");
  const ProgramRun beside = polhode(small_export(scratch.path(), {"--frames", "5:8"}));
  EXPECT_EQ(beside.code, 1);
  EXPECT_THAT(beside.err, AllOf(HasSubstr("frames 2:5"), HasSubstr("--skip-existing")));
  const ProgramRun more = polhode(small_export(scratch.path(), {"--skip-existing"}));
  EXPECT_EQ(more.code, 0) << more.err;
  EXPECT_EQ(contents(scratch.path()), whole_export());
  EXPECT_EQ(inode(scratch / "01-steady-frame03.png"), kept);
}

TEST(Repeated, PicturesAreOneFileUnderTwoNames) {
  const ScratchFolder scratch;
  const ProgramRun run =
      polhode({"export", test_lesson("tiny.md"), "-o", scratch.path(), "--what", "equation", "--dpi", "50",
               "--each", "frame", "--fps", "10", "--seconds", "1"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(inode(scratch / "01-steady-frame0.png"), inode(scratch / "01-steady-frame2.png"));
  EXPECT_NE(inode(scratch / "01-steady-frame2.png"), inode(scratch / "01-steady-frame3.png"));
  EXPECT_EQ(inode(scratch / "01-steady-frame7.png"), inode(scratch / "01-steady-frame9.png"));
}

TEST(Failed, ExportSaysWhatToDo) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "03-rolling-frame06.png");
  const ProgramRun run = polhode(small_export(scratch.path()));
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, AllOf(HasSubstr("03-rolling-frame06.png"), HasSubstr("go on with"),
                             HasSubstr(" --skip-existing\n")));
  fs::remove(scratch / "03-rolling-frame06.png");
  EXPECT_EQ(polhode(small_export(scratch.path(), {"--skip-existing"})).code, 0);
  EXPECT_EQ(contents(scratch.path()), whole_export());
}

// What a terminal does not show as it is cannot be copied from it.
TEST(Failed, ExportOffersNoCommandThatIsNotTheCommand) {
  const ScratchFolder scratch;
  const fs::path folder = scratch / "a\x1b[31mb";
  fs::create_directories(folder / "03-rolling-frame06.png");
  const ProgramRun run = polhode(small_export(folder));
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, AllOf(HasSubstr("go on with the same command and --skip-existing\n"),
                             Not(HasSubstr(" export "))));
}

TEST(Interrupted, OffersNoCommandThatIsNotTheCommand) {
  const ScratchFolder scratch;
  const fs::path folder = scratch / "a\x1b[31mb";
  const ProgramRun run =
      polhode({"export", test_lesson("tiny.md"), "-o", folder, "--film", folder / "f.mp4", "--fps", "200"},
              struck_while_drawing(folder, SIGINT));
  EXPECT_EQ(run.code, 130) << run.err;
  EXPECT_THAT(run.err, AllOf(HasSubstr("go on with the same command and --skip-existing\n"),
                             Not(HasSubstr(" export "))));
}

TEST(Failed, ExportIntoAFolderThatTakesNothingLeavesNothing) {
  const ScratchFolder scratch;
  const fs::path disk = scratch / "disk";
  fs::create_directory(disk);
  const std::string mount = "mount -t tmpfs -o ro none " + disk.string();
  if (std::system(("unshare -m sh -c '" + mount + "' 2>/dev/null").c_str()) != 0)
    GTEST_SKIP() << "nothing can be mounted here";
  RunOptions options;
  options.wrapper = {"unshare", "-m", "sh", "-c", mount + " && exec \"$@\"", "sh"};
  const ProgramRun run = polhode(small_export(disk), options);
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("Read-only file system"));
  const ProgramRun long_name = polhode(small_export(scratch / std::string(300, 'x')));
  EXPECT_EQ(long_name.code, 1);
  EXPECT_THAT(long_name.err, HasSubstr("File name too long"));
  EXPECT_THAT(names_in(scratch.path()), ElementsAre("disk"));
}

}  // namespace
}  // namespace polhode
