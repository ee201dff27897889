// SPDX-License-Identifier: MIT
// Films, read again by ffmpeg and ffprobe.
#include "app/publish/film.h"

#include "app/publish/ffmpeg.h"
#include "render/image/png.h"
#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace polhode {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

void make_film(const FilmRequest& request, const InterruptWatch& watch) {
  std::int64_t shown = 0;
  const Status made = write_film(request, watch, [&](std::int64_t) { ++shown; });
  EXPECT_TRUE(made) << made.error();
  EXPECT_GE(shown, std::ssize(request.pictures));
}

/// A bright block on a gradient that moves from frame to frame; its edges are sharp, as those of text are.
Image block(Size size, int frame, std::uint8_t alpha = 255) {
  Image image = Image::blank(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      std::uint8_t* to = &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                          static_cast<std::size_t>(x))];
      const bool inside = std::abs(x - 20 - 4 * frame) < 12 && std::abs(y - size.height / 2) < 12;
      to[0] = static_cast<std::uint8_t>(inside ? 20 : 200 + x % 32);
      to[1] = static_cast<std::uint8_t>(inside ? 150 : 205);
      to[2] = static_cast<std::uint8_t>(inside ? 60 : 190 + y % 32);
      to[3] = inside ? 255 : alpha;
    }
  return image;
}

std::vector<fs::path> written(const ScratchFolder& scratch, const std::vector<Image>& images) {
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < images.size(); ++i) {
    files.push_back(scratch / ("frame" + std::to_string(i) + ".png"));
    EXPECT_TRUE(write_png(files.back(), images[i], {}).ok());
  }
  return files;
}

std::vector<Image> blocks(int count, Size size, std::uint8_t alpha = 255) {
  std::vector<Image> images;
  for (int i = 0; i < count; ++i) images.push_back(block(size, i, alpha));
  return images;
}

std::string said_by(const std::string& command, const ScratchFolder& scratch) {
  const std::string file = scratch / "said";
  EXPECT_EQ(std::system((command + " > '" + file + "'").c_str()), 0) << command;
  return text_of(file);
}

std::string entries(const fs::path& film, const std::string& names, const ScratchFolder& scratch) {
  return said_by(
      "ffprobe -v error -count_frames -select_streams v -of default=noprint_wrappers=1 -show_entries " +
          names + " '" + film.string() + "'",
      scratch);
}

/// All frames of a film.
std::vector<Image> frames_of(const fs::path& film, Size size, const ScratchFolder& scratch) {
  const std::string bytes =
      said_by("ffmpeg -v error -i '" + film.string() + "' -f rawvideo -pix_fmt rgba pipe:1", scratch);
  std::vector<Image> frames;
  const std::size_t each = Image::blank(size).rgba.size();
  EXPECT_EQ(bytes.size() % each, 0u);
  for (std::size_t at = 0; at + each <= bytes.size(); at += each) {
    frames.push_back(Image::blank(size));
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), each, frames.back().rgba.begin());
  }
  return frames;
}

/// Of the colours, in dB, over the pixels of `a`.
double psnr(const Image& a, const Image& b) {
  double sum = 0;
  for (int y = 0; y < a.size.height; ++y)
    for (int x = 0; x < a.size.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const double d = a.pixel(x, y)[c] - b.pixel(x, y)[c];
        sum += d * d;
      }
  const double count = 3.0 * a.size.width * a.size.height;
  return sum == 0 ? 999.0 : 10 * std::log10(255.0 * 255.0 * count / sum);
}

class Film : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("ffmpeg -version > /dev/null 2>&1 && ffprobe -version > /dev/null 2>&1") != 0)
      GTEST_SKIP() << "no ffmpeg";
  }
  ScratchFolder scratch, other;
  InterruptWatch watch;
};

TEST(FilmKindOf, IsOfTheExtension) {
  EXPECT_EQ(film_kind_of("a.mp4"), FilmKind::mp4);
  EXPECT_EQ(film_kind_of("a/b.c.webm"), FilmKind::webm);
  EXPECT_EQ(film_kind_of("a.gif"), FilmKind::gif);
  EXPECT_EQ(film_kind_of("a.apng"), FilmKind::apng);
  for (const char* none : {"a.mov", "mp4", ".mp4", "a.", "a.mp4/b", "a.MP5"})
    EXPECT_FALSE(film_kind_of(none)) << none;
}

TEST_F(Film, HasEveryPictureAtItsRateAndOnlyItsOwnFile) {
  const Size size{96, 64};
  const auto pictures = written(scratch, blocks(10, size));
  for (const char* name : {"f.mp4", "f.webm", "f.gif", "f.apng"}) {
    make_film({other / name, pictures, {30000, 1001}, 1, "Spin & \"roll\""}, watch);
    const std::string said = entries(other / name,
                                     "stream=width,height,nb_read_frames,avg_frame_rate,color_space,color_"
                                     "transfer,color_primaries:format_tags",
                                     scratch);
    EXPECT_THAT(said, AllOf(HasSubstr("width=96"), HasSubstr("height=64"), HasSubstr("nb_read_frames=10")))
        << name;
    if (fs::path(name).extension() == ".gif") continue;  // its clock ticks 100 times a second; no metadata
    EXPECT_THAT(said, HasSubstr("avg_frame_rate=30000/1001")) << name;
    if (fs::path(name).extension() == ".apng") continue;
    EXPECT_THAT(said, HasSubstr("title=Spin & \"roll\"")) << name;
    for (const char* tag : {"color_space=bt709", "color_transfer=bt709", "color_primaries=bt709"})
      EXPECT_THAT(said, HasSubstr(tag)) << name;
  }
  EXPECT_THAT(names_in(other.path()), ElementsAre("f.apng", "f.gif", "f.mp4", "f.webm"));
}

TEST_F(Film, ShowsThePictures) {
  const Size size{96, 64};
  const std::vector<Image> images = blocks(6, size);
  const auto pictures = written(scratch, images);
  // 4:2:0 halves the colours of sharp edges; a palette has 256 of some 1000 colours. Any other frame is below
  // 28 dB.
  const std::map<std::string, double> least = {{"f.mp4", 31}, {"f.webm", 31}, {"f.gif", 31}, {"f.apng", 999}};
  for (const auto& [name, dB] : least) {
    make_film({other / name, pictures, {25, 1}, 1, ""}, watch);
    const std::vector<Image> frames = frames_of(other / name, size, scratch);
    ASSERT_EQ(frames.size(), images.size()) << name;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      EXPECT_GE(psnr(images[i], frames[i]), dB) << name << ", frame " << i;
      // By the matrix of BT.601 the green of the block is off by 18 levels.
      const int x = 20 + 4 * static_cast<int>(i);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(frames[i].pixel(x, 32)[c], images[i].pixel(x, 32)[c], 5) << name;
      EXPECT_LT(psnr(images[(i + 1) % images.size()], frames[i]), 28) << name << ", frame " << i;
    }
  }
}

TEST_F(Film, OfOddAndUnequalSizesLosesNoRow) {
  const auto pictures = written(scratch, {block({61, 41}, 0), block({97, 33}, 1), block({20, 63}, 2)});
  for (const auto& [name, size] :
       {std::pair{"f.mp4", Size{98, 64}}, {"f.gif", Size{97, 63}}, {"f.apng", {97, 63}}}) {
    make_film({other / name, pictures, {10, 1}, 1, ""}, watch);
    EXPECT_THAT(entries(other / name, "stream=width,height,nb_read_frames", scratch),
                AllOf(HasSubstr("width=" + std::to_string(size.width)),
                      HasSubstr("height=" + std::to_string(size.height)), HasSubstr("nb_read_frames=3")))
        << name;
  }
  const Image second = block({97, 33}, 1), frame = frames_of(other / "f.apng", {97, 63}, scratch).at(1);
  for (int y = 0; y < 63; ++y)
    for (int x = 0; x < 97; ++x)
      ASSERT_EQ(frame.pixel(x, y)[0], second.pixel(x, std::clamp(y - 15, 0, 32))[0]) << x << ", " << y;
}

TEST_F(Film, TransparentPicturesStayWhereTheKindCanAndBecomeWhiteElsewhere) {
  const Size size{64, 64};
  const auto pictures = written(scratch, blocks(3, size, 0));
  for (const char* name : {"f.mp4", "f.gif", "f.apng", "f.webm"})
    make_film({other / name, pictures, {10, 1}, 1, ""}, watch);
  for (const char* name : {"f.mp4", "f.gif"}) {
    const Image solid = frames_of(other / name, size, scratch).at(0);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(solid.pixel(60, 2)[c], 255, 3) << name;
    EXPECT_EQ(solid.pixel(60, 2)[3], 255) << name;
  }
  EXPECT_THAT(entries(other / "f.webm", "stream_tags", scratch), HasSubstr("alpha_mode=1"));
  EXPECT_EQ(frames_of(other / "f.apng", size, scratch).at(0).rgba, block(size, 0, 0).rgba);
}

TEST_F(Film, ShowsStillsForAWhile) {
  const auto pictures = written(scratch, blocks(3, {64, 64}));
  for (const char* name : {"f.mp4", "f.webm"}) {
    make_film({other / name, pictures, {30, 1}, 45, ""}, watch);
    EXPECT_THAT(entries(other / name, "stream=nb_read_frames,r_frame_rate", scratch),
                AllOf(HasSubstr("nb_read_frames=135"), HasSubstr("r_frame_rate=30/1")));
  }
  make_film({other / "f.gif", pictures, {30, 1}, 45, ""}, watch);
  EXPECT_THAT(entries(other / "f.gif", "stream=nb_read_frames:format=duration", scratch),
              AllOf(HasSubstr("nb_read_frames=3"), HasSubstr("duration=4.5")));
}

TEST_F(Film, AnyFileNameIsAFileName) {
  const auto pictures = written(scratch, blocks(2, {32, 32}));
  const std::string name = "made/on the way/-i http:%d 'q'.mp4";
  make_film({other / name, pictures, {10, 1}, 1, "-title=$HOME"}, watch);
  EXPECT_THAT(names_in(other / "made/on the way"), ElementsAre("-i http:%d 'q'.mp4"));
}

/// The error of a film, whose folder is as it was.
std::string error_of(const FilmRequest& request, const InterruptWatch& watch) {
  const auto before = names_in(request.file.parent_path());
  const Status made = write_film(request, watch, [](std::int64_t) {});
  EXPECT_EQ(names_in(request.file.parent_path()), before);
  return made ? "made" : made.error();
}

TEST_F(Film, DamagedAndMissingPicturesAreNamed) {
  auto pictures = written(scratch, blocks(3, {64, 64}));
  fs::resize_file(pictures[1], 200);
  EXPECT_THAT(error_of({other / "f.mp4", pictures, {10, 1}, 1, ""}, watch), HasSubstr("frame1.png"));
  fs::remove(pictures[1]);
  EXPECT_THAT(error_of({other / "f.mp4", pictures, {10, 1}, 1, ""}, watch), HasSubstr("frame1.png"));
}

TEST_F(Film, AFolderOfItsNameIsAnError) {
  fs::create_directory(other / "f.mp4");
  EXPECT_THAT(error_of({other / "f.mp4", written(scratch, blocks(1, {32, 32})), {10, 1}, 1, ""}, watch),
              HasSubstr("f.mp4: Is a directory"));
}

/// A program called ffmpeg that does as `script` says, first in PATH as long as this lives.
class StandIn {
 public:
  explicit StandIn(const std::string& script) : path_(::getenv("PATH")) {
    write_text(folder_ / "ffmpeg", "#!/bin/sh\n" + script + "\n");
    fs::permissions(folder_ / "ffmpeg", fs::perms::owner_all);
    ::setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
  }
  ~StandIn() { ::setenv("PATH", path_.c_str(), 1); }
  StandIn(const StandIn&) = delete;
  StandIn& operator=(const StandIn&) = delete;

 private:
  ScratchFolder folder_;
  std::string path_;
};

TEST_F(Film, WhatFfmpegSaysAtItsEndIsShown) {
  const auto pictures = written(scratch, blocks(40, {320, 200}));  // more than a pipe holds
  const FilmRequest request{other / "f.mp4", pictures, {10, 1}, 1, ""};
  {
    const StandIn stand_in(
        "for i in $(seq 99999); do echo chatter >&2; done; echo 'No such codec' >&2; exit 3");
    const std::string error = error_of(request, watch);
    EXPECT_THAT(error, AllOf(HasSubstr("code 3"), HasSubstr("No such codec")));
    EXPECT_LT(error.size(), 1000u);
  }
  {
    const StandIn stand_in("kill -SEGV $$");
    EXPECT_THAT(error_of(request, watch), HasSubstr("signal 11"));
  }
  const StandIn stand_in("exit 0");
  EXPECT_THAT(error_of(request, watch), HasSubstr("before the last picture"));
}

TEST_F(Film, InterruptedLeavesNothingNotEvenFfmpeg) {
  const auto pictures = written(scratch, blocks(40, {320, 200}));
  for (const char* script :
       {"echo $$ > \"$PID_FILE\"; sleep 60", "echo $$ > \"$PID_FILE\"; cat > /dev/null; sleep 60"}) {
    ::setenv("PID_FILE", (scratch / "pid").c_str(), 1);
    fs::remove(scratch / "pid");
    const StandIn stand_in(script);
    const InterruptWatch mine;
    std::thread impatient([&] {
      while (text_of(scratch / "pid").empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
      ::raise(SIGINT);
    });
    EXPECT_THROW(
        static_cast<void>(write_film({other / "f.mp4", pictures, {10, 1}, 1, ""}, mine, [](std::int64_t) {})),
        Interrupted);
    impatient.join();
    EXPECT_THAT(names_in(other.path()), IsEmpty());
    EXPECT_EQ(::kill(std::stoi(text_of(scratch / "pid")), 0), -1) << "it still runs";
  }
}

ProgramRun export_film(const ScratchFolder& scratch, const std::string& file,
                       const std::vector<std::string>& more = {}, const RunOptions& options = {}) {
  std::vector<std::string> words = {
      "export", test_lesson("tiny.md"), "--film", scratch / file, "--what", "figure", "--size", "160x90"};
  words.insert(words.end(), more.begin(), more.end());
  return polhode(words, options);
}

TEST_F(Film, OfAnExportLeavesOnlyTheFilmUnlessAFolderIsNamed) {
  const ProgramRun run = export_film(other, "f.mp4", {"--fps", "5", "--seconds", "2"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("f.mp4"));
  EXPECT_THAT(names_in(other.path()), ElementsAre("f.mp4"));
  EXPECT_THAT(entries(other / "f.mp4", "stream=nb_read_frames,avg_frame_rate:format_tags=title", scratch),
              AllOf(HasSubstr("nb_read_frames=20"), HasSubstr("avg_frame_rate=5/1"),
                    HasSubstr("title=A tiny lesson")));
  const ProgramRun kept = export_film(other, "f.mp4", {"--fps", "5", "--seconds", "2", "-o", other / "kept"});
  EXPECT_EQ(kept.code, 0) << kept.err;
  EXPECT_EQ(names_in(other / "kept").size(), 21u);
}

TEST_F(Film, AFolderOfItsNameIsSaidBeforeAnythingIsDrawn) {
  fs::create_directory(other / "f.mp4");
  const ProgramRun run = export_film(other, "f.mp4", {"--fps", "5", "--seconds", "2"});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("f.mp4 is a folder"));
  EXPECT_THAT(names_in(other.path()), ElementsAre("f.mp4"));
}

TEST_F(Film, OfStepsShowsEachForItsSeconds) {
  const ProgramRun run = export_film(other, "f.mp4", {"--each", "step", "--seconds", "1.5", "--fps", "10"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(entries(other / "f.mp4", "stream=nb_read_frames", scratch), HasSubstr("nb_read_frames=45"));
}

TEST_F(Film, WithoutFfmpegTheFramesAreThereAndThePackageIsNamed) {
  RunOptions options;
  options.environment["PATH"] = other.path();
  const ProgramRun run = export_film(other, "f.mp4", {"--fps", "2", "--seconds", "1"}, options);
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, AllOf(HasSubstr("install the package ffmpeg"), HasSubstr("--skip-existing")));
  EXPECT_THAT(names_in(other.path()), ElementsAre("f.mp4.parts"));
  EXPECT_EQ(names_in(other / "f.mp4.parts").size(), 5u);
  const ProgramRun resumed = export_film(other, "f.mp4", {"--fps", "2", "--seconds", "1", "--skip-existing"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_THAT(names_in(other.path()), ElementsAre("f.mp4"));
}

TEST_F(Film, AnInterruptedExportKeepsItsFramesAndNothingHalf) {
  const StandIn stand_in("sleep 60");
  RunOptions options;
  options.while_running = [&](pid_t program) {
    for (int tries = 0; tries < 6000 && !fs::exists(other / "f.mp4.parts/manifest.json"); ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    kill(program, SIGINT);
  };
  const ProgramRun run = export_film(other, "f.mp4", {"--fps", "2", "--seconds", "1"}, options);
  EXPECT_EQ(run.code, 130) << run.err;
  EXPECT_THAT(run.err, AllOf(HasSubstr("interrupted"), HasSubstr("f.mp4.parts")));
  EXPECT_THAT(names_in(other.path()), ElementsAre("f.mp4.parts"));
}

// HOSTILE F16: it said that there is no ffmpeg, or that it cannot be started.
TEST_F(Film, WithoutAPlaceForATemporaryFileSaysSo) {
  if (!fs::is_directory("/dev/shm")) GTEST_SKIP() << "there is no other place for files";
  const std::string mount = "mount -t tmpfs -o ro none /tmp";
  if (std::system(("unshare -m sh -c '" + mount + "' 2>/dev/null").c_str()) != 0)
    GTEST_SKIP() << "nothing can be mounted here";
  RunOptions options;
  options.wrapper = {"unshare", "-m", "sh", "-c", mount + " && exec \"$@\"", "sh"};
  ::setenv("TMPDIR", "/dev/shm", 1);
  const ScratchFolder elsewhere;
  const ProgramRun run = export_film(elsewhere, "f.mp4", {"--fps", "2", "--seconds", "1"}, options);
  ::unsetenv("TMPDIR");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("a temporary file, and /tmp takes none: Read-only file system"));
}

TEST_F(Film, WhatAKilledExportLeftGoesWithTheNext) {
  {
    // Writes to its last argument, as ffmpeg does.
    const StandIn stand_in("for last; do :; done; echo half > \"${last#file:}\"; sleep 1");
    RunOptions options;
    options.while_running = [&](pid_t program) {
      for (int tries = 0; tries < 6000 && names_in(other.path()).size() < 2; ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      kill(program, SIGKILL);
    };
    export_film(other, "f.mp4", {"--fps", "20", "--seconds", "1"}, options);
  }
  if (names_in(other.path()).size() < 2) GTEST_SKIP() << "it was quicker";
  const ProgramRun run = export_film(other, "f.mp4", {"--fps", "20", "--seconds", "1", "--skip-existing"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(names_in(other.path()), ElementsAre("f.mp4"));
}

TEST(FilmOptions, OtherKindsAndTooQuickGifsAreRefused) {
  const ScratchFolder scratch;
  for (const char* file : {"f.mov", "f", "f.mp4.zip"}) {
    const ProgramRun run = export_film(scratch, file);
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr(".mp4, .webm, .gif or .apng"));
  }
  EXPECT_EQ(export_film(scratch, "f.gif", {"--fps", "60"}).code, 2);
  EXPECT_EQ(export_film(scratch, "f.mp4", {"--each", "stage", "--frames", "0:2"}).code, 2);
  EXPECT_THAT(names_in(scratch.path()), IsEmpty());
}

}  // namespace
}  // namespace polhode
