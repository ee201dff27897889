// SPDX-License-Identifier: MIT
#include "app/export/folder/export_folder.h"

#include "base/files/temporary_file.h"
#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>

namespace polhode {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

ExportIdentity identity(const ExportOptions& options = {}, const char* sha256 = "abc") {
  return {"tiny", sha256, options_json(options)};
}

ExportOptions frames(std::int64_t begin, std::int64_t end) {
  ExportOptions options;
  options.each = Each::frame;
  if (end > 0) options.frames = FrameRange{begin, end};
  return options;
}

Marker marker(const ExportOptions& options = {}, const std::string& renderer = "llvmpipe") {
  return {identity(options), renderer, {"polhode", "export"}, {"01-a.png"}};
}

/// Its files are PREFIX0.png, PREFIX1.png …, with the checksums RENDERER0, RENDERER1 …
std::string manifest(const ExportIdentity& of, std::size_t files = 0,
                     const std::string& renderer = "llvmpipe", const std::string& prefix = "") {
  std::string text = manifest_head(of, renderer);
  for (std::size_t i = 0; i < files; ++i) {
    ManifestFile file;
    file.file = prefix + std::to_string(i) + ".png";
    file.sha256 = renderer + std::to_string(i);
    text += (i > 0 ? kManifestComma : "") + manifest_entry(file);
  }
  return text + manifest_end(files == 0);
}

class Folder : public testing::Test {
 protected:
  /// As a finished export, or one that has begun.
  void leave(const ExportOptions& options, bool finished) {
    for (const std::string& name : names_in(scratch.path())) std::filesystem::remove(scratch / name);
    if (finished)
      write_text(scratch / kManifestName, manifest(identity(options)));
    else
      ASSERT_TRUE(begin_in(scratch.path(), marker(options)).ok());
  }
  std::string error_of(const ExportIdentity& mine) {
    const auto state = inspect_folder(scratch.path(), mine);
    return state ? "" : state.error();
  }
  ScratchFolder scratch;
};

TEST_F(Folder, WithNothingOrTheSameTakesAnExport) {
  auto state = inspect_folder(scratch.path(), identity());
  ASSERT_TRUE(state.ok());
  EXPECT_FALSE(state->ours || state->finished);
  leave({}, false);
  state = inspect_folder(scratch.path(), identity());
  ASSERT_TRUE(state.ok()) << state.error();
  EXPECT_TRUE(state->ours);
  EXPECT_FALSE(state->finished);
  leave({}, true);
  state = inspect_folder(scratch.path(), identity());
  ASSERT_TRUE(state.ok()) << state.error();
  EXPECT_TRUE(state->ours && state->finished);
  EXPECT_EQ(state->renderer, "llvmpipe");
  EXPECT_TRUE(inspect_folder(scratch / "none", identity()).ok());
}

// Every option that decides the bytes must count, in a folder that is finished and in one that is not.
TEST_F(Folder, OfOtherOptionsIsRefused) {
  std::vector<std::pair<std::string, ExportOptions>> others(11);
  others[0] = {"size", {}}, others[0].second.size = {640, 360};
  others[1] = {"stage", {}}, others[1].second.stages = {"a"};
  others[2] = {"each", {}}, others[2].second.each = Each::step;
  others[3] = {"at", {}}, others[3].second.at_s = 0.0;
  others[4] = {"background", {}}, others[4].second.background = "white";
  others[5] = {"dpi", {}}, others[5].second.dpi = 300;
  others[6] = {"each", {}}, others[6].second.each = Each::frame;
  others[7] = {"png", {}}, others[7].second.png = PngPacking::small;
  others[8] = {"what", {}}, others[8].second.what = What::figure;
  others[9] = {"theme", {}}, others[9].second.theme = Theme::dark;
  others[10] = {"text_size", {}}, others[10].second.text_scale = 1.4;
  for (const bool finished : {true, false}) {
    leave({}, finished);
    for (const auto& [name, options] : others) {
      EXPECT_THAT(error_of(identity(options)), HasSubstr(name)) << finished;
      EXPECT_FALSE(begin_in(scratch.path(), marker(options)).ok());
    }
  }
}

TEST_F(Folder, OfAnotherLessonTextIsRefused) {
  for (const bool finished : {true, false}) {
    leave({}, finished);
    EXPECT_THAT(error_of(identity({}, "abd")), HasSubstr("another lesson"));
  }
}

TEST_F(Folder, WithAForeignManifestIsRefused) {
  for (const char* name : {kManifestName, kMarkerName}) {
    write_text(scratch / name, "{}");
    EXPECT_THAT(error_of(identity()), HasSubstr(name));
    std::filesystem::remove(scratch / name);
  }
}

TEST_F(Folder, OfSomeFramesTakesMoreOfThem) {
  leave(frames(2, 5), true);
  for (const ExportOptions& more : {frames(2, 6), frames(0, 5), frames(0, 0)}) {
    const auto state = inspect_folder(scratch.path(), identity(more));
    ASSERT_TRUE(state.ok()) << state.error();
    EXPECT_TRUE(state->ours);
    EXPECT_FALSE(state->finished);
  }
  for (const ExportOptions& others : {frames(5, 8), frames(3, 8), frames(2, 4)})
    EXPECT_THAT(error_of(identity(others)),
                testing::AllOf(HasSubstr("frames 2:5"), HasSubstr("--skip-existing")));
  leave(frames(2, 5), false);
  EXPECT_THAT(error_of(identity(frames(0, 0))), HasSubstr("unfinished export of frames 2:5"));
}

TEST_F(Folder, HasAMarkerFromTheBeginningToTheManifest) {
  ASSERT_TRUE(begin_in(scratch.path(), marker()).ok());
  EXPECT_THAT(names_in(scratch.path()), ElementsAre(kMarkerName));
  write_text(scratch / "manifest.1-of-2.json", "");
  write_text(scratch / kManifestName, manifest(identity()));
  remove_traces(scratch.path());
  EXPECT_THAT(names_in(scratch.path()), ElementsAre(kManifestName));
  const auto again = begin_in(scratch.path(), marker());
  ASSERT_TRUE(again.ok());
  EXPECT_TRUE(again->finished);
  EXPECT_THAT(names_in(scratch.path()), ElementsAre(kManifestName)) << "the manifest keeps others out";
}

TEST_F(Folder, LosesWhatKilledProcessesLeft) {
  const std::string left = ".polhode-12345678-1-0.part";
  write_text(scratch / left, "");
  std::filesystem::last_write_time(scratch / left,
                                   std::filesystem::file_time_type::clock::now() - std::chrono::hours(2));
  ASSERT_TRUE(begin_in(scratch.path(), marker()).ok());
  EXPECT_THAT(names_in(scratch.path()), ElementsAre(kMarkerName));
}

TEST_F(Folder, OfTwoWithOtherOptionsAtTheSameMomentOneIsRefused) {
  constexpr int kRounds = 50;
  for (int round = 0; round < kRounds; ++round) {
    const ScratchFolder folder;
    const auto may_begin = [&](int dpi) {
      ExportOptions options;
      options.dpi = dpi;
      return begin_in(folder.path(), marker(options)).ok();
    };
    const pid_t other = fork();
    if (other == 0) _exit(may_begin(100) ? 1 : 0);
    const bool taken_here = may_begin(200);
    int status = 0;
    waitpid(other, &status, 0);
    EXPECT_NE(taken_here, WEXITSTATUS(status) == 1) << round;
    EXPECT_THAT(names_in(folder.path()), ElementsAre(kMarkerName));
  }
}

TEST_F(Folder, RemembersAllDrivers) {
  ASSERT_TRUE(begin_in(scratch.path(), marker({}, "b")).ok());
  EXPECT_EQ(begin_in(scratch.path(), marker({}, "a"))->renderer, "b") << "what was drawn before";
  EXPECT_EQ(begin_in(scratch.path(), marker({}, "a"))->renderer, "a | b");
}

class MergedShards : public testing::Test {
 protected:
  void finish(Shard shard, std::size_t files, const ExportOptions& options = {}, const char* renderer = "r") {
    write_text(scratch / shard_manifest_name(shard),
               manifest(identity(options), files, renderer, std::to_string(shard.index) + '-'));
  }
  ScratchFolder scratch;
};

TEST_F(MergedShards, AreMergedWhenAllAreThere) {
  finish({1, 3}, 2, {}, "b");
  finish({3, 3}, 1);
  auto shards = summarize_shards(scratch.path(), identity(), 3, 4);
  ASSERT_TRUE(shards.ok());
  EXPECT_FALSE(shards->has_value()) << "the second is missing";
  finish({2, 3}, 1, {}, "a");
  shards = summarize_shards(scratch.path(), identity(), 3, 4);
  ASSERT_TRUE(shards.ok() && shards->has_value());
  EXPECT_EQ((*shards)->renderer, "a | b | r");
  EXPECT_EQ((*shards)->checksums,
            (Checksums{{"1-0.png", "b0"}, {"1-1.png", "b1"}, {"2-0.png", "a0"}, {"3-0.png", "r0"}}));
}

TEST_F(MergedShards, OfSomethingElseAreAnError) {
  ExportOptions other;
  other.dpi = 100;
  finish({1, 2}, 2);
  finish({2, 2}, 2, other);
  const auto of_others = summarize_shards(scratch.path(), identity(), 2, 4);
  ASSERT_FALSE(of_others.ok());
  EXPECT_THAT(of_others.error(), HasSubstr("manifest.2-of-2.json"));
  finish({2, 2}, 1);
  EXPECT_FALSE(summarize_shards(scratch.path(), identity(), 2, 4).ok()) << "a picture is missing in it";
  write_text(scratch / "manifest.2-of-2.json", "{");
  EXPECT_FALSE(summarize_shards(scratch.path(), identity(), 2, 4).ok());
}

}  // namespace
}  // namespace polhode
