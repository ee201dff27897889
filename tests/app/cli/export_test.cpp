// SPDX-License-Identifier: MIT
// polhode export, from the files it leaves. Small pictures of tests/data/app/tiny.md.
#include "app/export/folder/export_folder.h"
#include "base/sha256.h"
#include "render/image/png.h"
#include "tests/app/export/small_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <signal.h>

#include <chrono>
#include <thread>

namespace polhode {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Words = std::vector<std::string>;
using Json = nlohmann::json;
namespace fs = std::filesystem;

/// Figures.
ProgramRun export_tiny(const fs::path& folder, Words more = {}, const RunOptions& options = {}) {
  Words words = {"export", test_lesson("tiny.md"), "-o", folder.string(), "--what", "figure", "--size",
                 "320x180"};
  words.insert(words.end(), more.begin(), more.end());
  return polhode(words, options);
}

Json manifest_in(const fs::path& folder) { return Json::parse(text_of(folder / "manifest.json")); }

/// Runs a program after `setup` (a shell command) in a mount namespace of its own, so that nothing outside it
/// changes.
RunOptions in_own_namespace(const std::string& setup, const std::string& after = "true") {
  RunOptions options;
  options.wrapper = {
      "unshare", "-m", "sh", "-c", setup + " && { \"$@\"; code=$?; " + after + "; exit $code; }", "sh"};
  return options;
}

bool can_mount(const std::string& setup) {
  return std::system(("unshare -m sh -c '" + setup + "' 2>/dev/null").c_str()) == 0;
}

TEST(Export, MakesOnePictureForEachStageWithAScene) {
  const ScratchFolder scratch;
  const fs::path folder = scratch / "made/on/the/way";
  const ProgramRun run = export_tiny(folder);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_THAT(run.err, HasSubstr("\"words\" has no scene"));
  EXPECT_EQ(run.err.find('\r'), std::string::npos) << "a progress bar where there is no terminal";
  EXPECT_THAT(names_in(folder), ElementsAre("01-steady.png", "03-rolling.png", "manifest.json"));
  for (const char* name : {"01-steady.png", "03-rolling.png"}) {
    const auto png = read_png(folder / name);
    ASSERT_TRUE(png.ok()) << png.error();
    EXPECT_EQ(png->image.size, (Size{320, 180}));
  }
}

TEST(Export, WritesWhatItDidIntoTheManifest) {
  const ScratchFolder scratch;
  ASSERT_EQ(export_tiny(scratch.path(), {"--stage", "steady", "--stage", "rolling"}).code, 0);
  const Json manifest = manifest_in(scratch.path());
  EXPECT_EQ(manifest["format"], 1);
  EXPECT_EQ(manifest["lesson"]["id"], "tiny");
  EXPECT_EQ(manifest["lesson"]["sha256"], sha256_hex(text_of(test_lesson("tiny.md"))));
  EXPECT_THAT(manifest["renderer"].get<std::string>(), HasSubstr("llvmpipe"));
  EXPECT_EQ(manifest["options"]["size"], "320x180");
  ASSERT_EQ(manifest["files"].size(), 2u);
  const Json& steady = manifest["files"][0];
  EXPECT_EQ(steady["file"], "01-steady.png");
  EXPECT_EQ(steady["step"], 2);
  EXPECT_TRUE(steady["frame"].is_null());
  EXPECT_EQ(steady["t"], 0.5);
  EXPECT_EQ(steady["method"], "uniform");
  ASSERT_EQ(steady["tex"].size(), 2u);
  EXPECT_THAT(steady["alt"].get<std::string>(), HasSubstr("A steady spin"));
  EXPECT_EQ(text_of(scratch / "manifest.json").find(scratch.path().string()), std::string::npos);
}

TEST(Export, PutsTheMetadataIntoEachFile) {
  const ScratchFolder scratch;
  ASSERT_EQ(export_tiny(scratch.path(), {"--stage", "rolling", "--dpi", "300"}).code, 0);
  const auto png = read_png(scratch / "03-rolling.png");
  ASSERT_TRUE(png.ok());
  const std::map<std::string, std::string> text(png->metadata.text.begin(), png->metadata.text.end());
  EXPECT_EQ(text.at("Title"), "Rolling – A tiny lesson");
  EXPECT_EQ(text.at("Description"), manifest_in(scratch.path())["files"][0]["alt"].get<std::string>());
  EXPECT_THAT(text.at("Description"), testing::AllOf(HasSubstr("the polhode"), HasSubstr("At t = 1.25 s")));
  EXPECT_THAT(text.at("Software"), testing::StartsWith("polhode "));
  EXPECT_EQ(text.at("polhode:lesson"), "tiny");
  EXPECT_EQ(text.at("polhode:stage"), "rolling");
  EXPECT_EQ(text.at("polhode:t"), "1.25");
  EXPECT_EQ(png->metadata.dpi, 300);
  EXPECT_EQ(text_of(scratch / "03-rolling.png").find("tIME"), std::string::npos);
}

TEST(Export, RepeatsToTheByteOnEitherContext) {
  const ScratchFolder scratch;
  for (const auto& [name, context] :
       {std::pair{"a", "osmesa"}, std::pair{"b", "osmesa"}, std::pair{"c", "egl"}})
    ASSERT_EQ(export_tiny(scratch / name, {"--context", context}).code, 0) << context;
  EXPECT_EQ(contents(scratch / "a"), contents(scratch / "b"));
  EXPECT_EQ(contents(scratch / "a"), contents(scratch / "c"));
}

TEST(Export, TheNumberOfThreadsChangesNoByte) {
  const ScratchFolder scratch;
  for (const char* threads : {"0", "1", "2", "4"}) {
    RunOptions options;
    options.environment = {{"LP_NUM_THREADS", threads}};
    ASSERT_EQ(export_tiny(scratch / threads, {}, options).code, 0) << threads;
    EXPECT_EQ(contents(scratch / "0"), contents(scratch / threads)) << threads;
  }
}

TEST(Export, AMotionThatCannotBeComputedMakesNoPicture) {  // 2026-11-21: pictures of NaN, exit code 0
  const ScratchFolder scratch;
  const ProgramRun run =
      polhode({"export", test_lesson("overflow.md"), "-o", (scratch / "out").string(), "--at", "9"});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("stage \"torn\": the motion cannot be computed at t = 9 s"));
  EXPECT_FALSE(fs::exists(scratch / "out"));
}

TEST(Export, FramesDoNotDependOnTheRangeTheyAreMadeIn) {
  const ScratchFolder scratch;
  const Words film = {"--each", "frame", "--fps", "3", "--seconds", "2"};
  const auto with = [&](const char* frames) {
    Words words = film;
    words.insert(words.end(), {"--frames", frames});
    return words;
  };
  ASSERT_EQ(export_tiny(scratch / "whole", film).code, 0);
  ASSERT_EQ(export_tiny(scratch / "part", with("5:9")).code, 0);
  auto whole = contents(scratch / "whole"), part = contents(scratch / "part");
  EXPECT_EQ(whole.size(), 2 * 6 + 1u);
  EXPECT_EQ(part.size(), 4 + 1u);
  part.erase("manifest.json");
  for (const auto& [name, bytes] : part) EXPECT_EQ(bytes, whole[name]) << name;
  EXPECT_TRUE(part.count("01-steady-frame05.png"));
  EXPECT_TRUE(part.count("03-rolling-frame06.png"));
  // Frame 8 of the whole is frame 2 of "rolling", shown at 2/3 s, at the scene's rate of 2.
  EXPECT_DOUBLE_EQ(manifest_in(scratch / "whole")["files"][8]["t"].get<double>(), 2.0 / 3.0 * 2.0);
  EXPECT_EQ(manifest_in(scratch / "whole")["files"][8]["frame"], 8);
  EXPECT_NE(whole["03-rolling-frame06.png"], whole["03-rolling-frame07.png"]) << "nothing moves";
}

TEST(Export, StepsAreFilesOfTheirOwn) {
  const ScratchFolder scratch;
  ASSERT_EQ(export_tiny(scratch.path(), {"--each", "step", "--stage", "steady", "--at", "0x1p-1"}).code, 0);
  EXPECT_THAT(names_in(scratch.path()),
              ElementsAre("01-steady-step1.png", "01-steady-step2.png", "manifest.json"));
}

TEST(Export, RefusesAFolderOfOtherOptions) {
  const ScratchFolder scratch;
  ASSERT_EQ(export_tiny(scratch.path(), {"--stage", "steady"}).code, 0);
  const auto before = contents(scratch.path());
  const ProgramRun other = export_tiny(scratch.path(), {"--stage", "steady", "--background", "white"});
  EXPECT_EQ(other.code, 1);
  EXPECT_THAT(other.err, HasSubstr("background"));
  EXPECT_EQ(contents(scratch.path()), before);
  EXPECT_EQ(export_tiny(scratch.path(), {"--stage", "steady"}).code, 0);
  EXPECT_EQ(contents(scratch.path()), before);
}

TEST(Export, RefusesAFolderOfAnotherLessonText) {
  const ScratchFolder scratch;
  write_text(scratch / "tiny.md", text_of(test_lesson("tiny.md")) + "\nOne more line.\n");
  ASSERT_EQ(export_tiny(scratch / "out", {"--stage", "steady"}).code, 0);
  const ProgramRun other = polhode({"export", scratch / "tiny.md", "-o", scratch / "out", "--what", "figure",
                                    "--size", "320x180", "--stage", "steady"});
  EXPECT_EQ(other.code, 1);
  EXPECT_THAT(other.err, HasSubstr("another lesson text"));
}

TEST(Export, FolderThatCannotBeMadeIsCode1) {
  const ScratchFolder scratch;
  write_text(scratch / "file", "");
  for (const fs::path& folder : {scratch / "file", scratch / "file/below", fs::path("/proc/polhode")}) {
    const ProgramRun run = export_tiny(folder);
    EXPECT_EQ(run.code, 1) << folder;
    EXPECT_THAT(run.err, HasSubstr(folder.string()));
  }
}

TEST(Export, FileThatCannotBeReplacedIsCode1) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "01-steady.png");
  const ProgramRun run = export_tiny(scratch.path());
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("01-steady.png"));
  EXPECT_THAT(names_in(scratch.path()), ElementsAre(kMarkerName, "01-steady.png"));
}

TEST(Export, FullDiskLeavesNoPartialFile) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "disk");
  const std::string disk = (scratch / "disk").string(), kept = (scratch / "kept").string();
  const std::string mount = "mount -t tmpfs -o size=64k none " + disk;
  if (!can_mount(mount)) GTEST_SKIP() << "a small tmpfs cannot be mounted here";
  // Pictures of 640x360 do not fit into 64 KiB; what is on the disk at the end is copied out of the
  // namespace.
  const ProgramRun run =
      polhode({"export", test_lesson("tiny.md"), "-o", disk, "--what", "figure", "--size", "640x360"},
              in_own_namespace(mount, "cp -r " + disk + " " + kept));
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_THAT(run.err, HasSubstr("No space left on device"));
  for (const std::string& name : names_in(kept))
    if (name != kMarkerName) {
      EXPECT_TRUE(read_png(fs::path(kept) / name).ok()) << name;
    }
}

/// Hides the library with that name by a file that is none.
std::string hide(const std::string& library) {
  return "for f in /usr/lib/*/" + library + "*; do mount --bind /dev/null \"$f\" || exit 99; done";
}

TEST(Export, AbsentOsmesaIsNamedWithItsPackage) {
  if (!can_mount(hide("libOSMesa.so."))) GTEST_SKIP() << "a library cannot be hidden here";
  const ScratchFolder scratch;
  const ProgramRun run =
      export_tiny(scratch.path(), {"--context", "osmesa"}, in_own_namespace(hide("libOSMesa.so.")));
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("libosmesa6"));
  EXPECT_THAT(names_in(scratch.path()), IsEmpty());
  const ProgramRun fallback =
      export_tiny(scratch.path(), {"--stage", "steady"}, in_own_namespace(hide("libOSMesa.so.")));
  EXPECT_EQ(fallback.code, 0) << "auto did not turn to EGL: " << fallback.err;
}

TEST(Export, AMissingFontIsNamedWithItsPackage) {
  const std::string setup =
      "for f in $(find /usr/share -name \"texgyrepagella-math*\"); do mount --bind /dev/null \"$f\" || exit "
      "99; done";
  if (!can_mount(setup)) GTEST_SKIP() << "a font cannot be hidden here";
  const ScratchFolder scratch;
  for (const char* what : {"page", "equation"}) {
    const ProgramRun run = polhode({"export", test_lesson("tiny.md"), "-o", scratch / what, "--what", what},
                                   in_own_namespace(setup));
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.err, HasSubstr("fonts-texgyre-math"));
    EXPECT_FALSE(fs::exists(scratch / what));
  }
}

TEST(Export, WithoutAnyContextBothPackagesAreNamed) {
  const std::string setup = hide("libOSMesa.so.") + " && " + hide("libEGL.so.");
  if (!can_mount(setup)) GTEST_SKIP() << "libraries cannot be hidden here";
  const ScratchFolder scratch;
  const ProgramRun run = export_tiny(scratch.path(), {}, in_own_namespace(setup));
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, testing::AllOf(HasSubstr("libosmesa6"), HasSubstr("libegl1")));
}

/// What `export --context egl` says where no file that this pattern matches can be read.
ProgramRun export_by_egl_without(const std::string& files) {
  const ScratchFolder scratch;
  return export_tiny(scratch.path(), {"--context", "egl", "--stage", "steady"},
                     in_own_namespace(hide(files)));
}

TEST(Export, EglWithoutMesaNamesThePackageThatIsMissing) {
  if (!can_mount(hide("libEGL_mesa.so."))) GTEST_SKIP() << "a library cannot be hidden here";
  const ProgramRun run = export_by_egl_without("libEGL_mesa.so.");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("Install the Debian package libegl-mesa0, or"));
}

// Newer releases of Mesa have the driver in a library that libegl-mesa0 depends on.
TEST(Export, EglWithoutItsDriverNamesThePackageThatIsMissing) {
  if (!can_mount(hide("dri/"))) GTEST_SKIP() << "the drivers cannot be hidden here";
  const ProgramRun run = export_by_egl_without("dri/");
  if (run.code == 0) GTEST_SKIP() << "this release of Mesa needs no driver of libgl1-mesa-dri";
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("Install the Debian package libgl1-mesa-dri, or"));
}

TEST(Export, InterruptedEndsWith130AndWholeFiles) {
  const ScratchFolder scratch;
  RunOptions options;
  options.while_running = [&](pid_t program) {
    for (int tries = 0; tries < 6000 && names_in(scratch.path()).size() < 2; ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    kill(program, SIGINT);
  };
  const ProgramRun run = export_tiny(scratch.path(), {"--each", "frame", "--seconds", "600"}, options);
  EXPECT_EQ(run.code, 130) << run.err;
  EXPECT_THAT(run.err, HasSubstr("interrupted"));
  const auto names = names_in(scratch.path());
  EXPECT_FALSE(names.empty());
  for (const std::string& name : names) {
    if (name == kMarkerName) continue;
    EXPECT_THAT(name, testing::EndsWith(".png"));
    EXPECT_TRUE(read_png(scratch / name).ok()) << name;
  }
}

ProgramRun export_what(const char* what, const fs::path& folder, Words more = {},
                       const RunOptions& options = {}) {
  Words words = {"export", test_lesson("tiny.md"), "-o", folder.string(), "--what", what};
  words.insert(words.end(), more.begin(), more.end());
  return polhode(words, options);
}

TEST(ExportPages, SlidesAreTheDefaultAndEveryStepHasOne) {
  const ScratchFolder scratch;
  const ProgramRun run =
      polhode({"export", test_lesson("tiny.md"), "-o", scratch.path(), "--size", "640x400"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(names_in(scratch.path()),
              ElementsAre("01-steady-step1.png", "01-steady-step2.png", "02-words-step1.png",
                          "03-rolling-step1.png", "manifest.json"));
  const Json manifest = manifest_in(scratch.path());
  EXPECT_EQ(manifest["options"]["profile"], "slides");
  const std::string second = manifest["files"][1]["alt"];
  EXPECT_THAT(second, HasSubstr("The same, from the body."));
  EXPECT_THAT(second, testing::Not(HasSubstr("About axis 3"))) << "of the step before";
}

// 2026-11-29: slides that the window saved of chosen stages said "stage 3 of 14" where the presentation of
// the same said 2 of 3.
TEST(ExportPages, CountTheStagesThatAreChosen) {
  const ScratchFolder scratch;
  const Words chosen = {"--size", "320x240", "--stage", "words", "--stage", "rolling"};
  Words counted = chosen;
  counted.emplace_back("--count-chosen");
  ASSERT_EQ(export_what("page", scratch / "a", chosen).code, 0);
  ASSERT_EQ(export_what("page", scratch / "b", counted).code, 0);
  EXPECT_EQ(names_in(scratch / "a"), names_in(scratch / "b")) << "files have the lesson's numbers";
  const auto of_lesson = read_png(scratch / "a/03-rolling-step1.png");
  const auto of_chosen = read_png(scratch / "b/03-rolling-step1.png");
  ASSERT_TRUE(of_lesson.ok() && of_chosen.ok());
  EXPECT_NE(of_lesson->image.rgba, of_chosen->image.rgba) << "stage 3 of 3, stage 2 of 2";
  Words all = {"--size", "320x240", "--stage", "steady", "--stage", "words", "--stage", "rolling"};
  ASSERT_EQ(export_what("page", scratch / "c", all).code, 0);
  all.emplace_back("--count-chosen");
  ASSERT_EQ(export_what("page", scratch / "d", all).code, 0);
  EXPECT_EQ(read_png(scratch / "c/03-rolling-step1.png")->image.rgba,
            read_png(scratch / "d/03-rolling-step1.png")->image.rgba);
  const ProgramRun refused = export_what("figure", scratch / "e", {"--stage", "rolling", "--count-chosen"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("goes with --stage and pages"));
}

TEST(ExportPages, ProfilesAreOfPages) {
  const ScratchFolder scratch;
  const ProgramRun run = export_what("figure", scratch.path(), {"--profile", "slides"});
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("--profile goes with pages"));
}

TEST(ExportPages, HaveAllStepsOfAStageEachBesideItsFigure) {
  const ScratchFolder scratch;
  const ProgramRun run = polhode(
      {"export", test_lesson("tiny.md"), "-o", scratch.path(), "--size", "640x400", "--profile", "page"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(names_in(scratch.path()), ElementsAre("01-steady-page1.png", "02-words-page1.png",
                                                    "03-rolling-page1.png", "manifest.json"));
  const Json manifest = manifest_in(scratch.path());
  EXPECT_EQ(manifest["options"]["each"], "page");
  const std::string alt = manifest["files"][0]["alt"].get<std::string>();
  const auto first = alt.find("Figure: ");
  EXPECT_NE(first, alt.npos);
  EXPECT_NE(alt.find("Figure: ", first + 1), alt.npos) << "of each step: " << alt;
}

TEST(ExportPages, TheFirstOfAStageTellsTheAnswersToTheStageBeforeInItsAlternativeTextToo) {
  const ScratchFolder scratch;
  const std::filesystem::path lesson = scratch / "asked.md";
  write_text(lesson,
             "+++\nformat = 1\nid = \"asked\"\ntitle = \"Asked\"\n+++\n# A {a}\nWords.\n\n---\n\n"
             "```ask n\ntype = \"number\"\nprompt = \"How long does it take?\"\nanswer = 12.5\n"
             "unit = \"s\"\nbecause = \"So it is.\"\n```\n# B {b}\nWords.\n");
  const ProgramRun run =
      polhode({"export", lesson.string(), "-o", scratch / "out", "--size", "640x400", "--profile", "page"});
  EXPECT_EQ(run.code, 0) << run.err;
  const Json files = manifest_in(scratch / "out")["files"];
  EXPECT_THAT(files[0]["alt"].get<std::string>(), testing::Not(HasSubstr("Answers")))
      << "nobody sees them beside their questions";
  EXPECT_THAT(files.back()["alt"].get<std::string>(),
              testing::EndsWith("Answers to stage 1: step 2, 12.5 s."));
}

TEST(ExportPages, OfSeveralStepsAreNoSlidesAndNoFigures) {
  const ScratchFolder scratch;
  for (const Words& words : {Words{"--profile", "slides"}, Words{"--what", "figure"}}) {
    Words all = {"export", test_lesson("tiny.md"), "-o", scratch.path(), "--each", "page"};
    all.insert(all.end(), words.begin(), words.end());
    const ProgramRun run = polhode(all);
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("--each page goes with --profile page"));
  }
}

TEST(ExportPages, EveryStageHasOneWithItsStepsBefore) {
  const ScratchFolder scratch;
  const ProgramRun run = polhode({"export", test_lesson("tiny.md"), "-o", scratch.path(), "--size", "640x400",
                                  "--profile", "page", "--each", "stage"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(names_in(scratch.path()),
              ElementsAre("01-steady.png", "02-words.png", "03-rolling.png", "manifest.json"));
  const Json manifest = manifest_in(scratch.path());
  EXPECT_EQ(manifest["options"]["what"], "page");
  EXPECT_EQ(manifest["options"]["theme"], "paper");
  const Json &steady = manifest["files"][0], &words = manifest["files"][1];
  EXPECT_EQ(steady["width"], 640);
  EXPECT_EQ(steady["t"], 0.5);
  EXPECT_THAT(steady["alt"].get<std::string>(),
              testing::AllOf(HasSubstr("The same, from the body."), HasSubstr("Figure: ")));
  EXPECT_TRUE(words["t"].is_null());
  EXPECT_THAT(words["alt"].get<std::string>(), HasSubstr("Nothing to draw here."));
  const auto png = read_png(scratch / "02-words.png");
  ASSERT_TRUE(png.ok());
  EXPECT_EQ(png->image.rgba[0], 0xFB) << "paper";
}

TEST(ExportPages, HaveAThemeAndRepeatToTheByte) {
  const ScratchFolder scratch;
  const Words small = {"--size", "480x320", "--stage", "rolling", "--theme", "dark", "--profile", "page"};
  ASSERT_EQ(export_what("page", scratch / "a", small).code, 0);
  ASSERT_EQ(export_what("page", scratch / "b", small).code, 0);
  EXPECT_EQ(contents(scratch / "a"), contents(scratch / "b"));
  const auto png = read_png(scratch / "a/03-rolling-page1.png");
  ASSERT_TRUE(png.ok());
  EXPECT_LT(png->image.rgba[0], 0x40) << "not dark";
}

TEST(ExportPages, FramesDoNotDependOnTheRangeTheyAreMadeIn) {
  const ScratchFolder scratch;
  Words film = {"--size", "320x240", "--stage", "rolling", "--each", "frame", "--fps", "2", "--seconds", "2"};
  ASSERT_EQ(export_what("page", scratch / "whole", film).code, 0);
  film.insert(film.end(), {"--frames", "2:3"});
  ASSERT_EQ(export_what("page", scratch / "part", film).code, 0);
  const std::string name = "03-rolling-frame2.png";
  EXPECT_EQ(text_of(scratch / "part" / name), text_of(scratch / "whole" / name));
  EXPECT_NE(text_of(scratch / "whole/03-rolling-frame1.png"), text_of(scratch / "whole" / name));
}

TEST(ExportPages, FrameByFrameTheStepsOfAStageComeOneAfterTheOther) {
  const ScratchFolder scratch;
  const Words film = {"--size", "320x240", "--stage",   "steady", "--each",    "frame",
                      "--fps",  "10",      "--seconds", "1.6",    "--profile", "page"};
  ASSERT_EQ(export_what("page", scratch.path(), film).code, 0);
  const Json files = manifest_in(scratch.path())["files"];
  const auto text_column = [&](std::size_t frame) {  // the left half
    const Image image = read_png(scratch / files[frame]["file"].get<std::string>()).value().image;
    std::string bytes;
    for (int y = 0; y < 240; ++y) bytes.append(reinterpret_cast<const char*>(image.pixel(0, y)), 4 * 150);
    return bytes;
  };
  EXPECT_EQ(files[7]["step"], 1);
  EXPECT_EQ(files[8]["step"], 2);
  EXPECT_EQ(files[8]["tex"].size(), 2u);
  EXPECT_DOUBLE_EQ(files[8]["t"].get<double>(), 8 * files[1]["t"].get<double>()) << "time does not run on";
  EXPECT_EQ(text_column(0), text_column(7)) << "the first step stands from its first frame";
  for (std::size_t frame = 7; frame < 11; ++frame)
    EXPECT_NE(text_column(frame), text_column(frame + 1)) << frame;
  EXPECT_EQ(text_column(11), text_column(15)) << "0.4 s are over";
}

TEST(ExportEquations, AreCroppedToTheirInk) {
  const ScratchFolder scratch;
  ASSERT_EQ(export_what("equation", scratch.path(), {"--background", "transparent"}).code, 0);
  EXPECT_THAT(names_in(scratch.path()),
              ElementsAre("01-steady-steady-body.png", "01-steady-steady-eq.png", "manifest.json"));
  const auto png = read_png(scratch / "01-steady-steady-eq.png");
  ASSERT_TRUE(png.ok());
  EXPECT_EQ(png->metadata.dpi, 300);
  const Image& image = png->image;
  // Ink, and a margin of at most half an em (25 px) around it.
  const auto has_ink = [&](int x0, int y0, int x1, int y1) {
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x)
        if (image.pixel(x, y)[3] > 0) return true;
    return false;
  };
  const int w = image.size.width, h = image.size.height;
  EXPECT_FALSE(has_ink(0, 0, w, 10) || has_ink(0, h - 10, w, h) || has_ink(0, 0, 10, h) ||
               has_ink(w - 10, 0, w, h));
  EXPECT_TRUE(has_ink(0, 0, w, 26) && has_ink(0, h - 26, w, h) && has_ink(0, 0, 26, h) &&
              has_ink(w - 26, 0, w, h));
  const Json manifest = manifest_in(scratch.path());
  EXPECT_EQ(manifest["files"][0]["tex"], Json({"\\vec\\omega = \\mathrm{const}"}));
  EXPECT_THAT(manifest["files"][0]["alt"].get<std::string>(), testing::StartsWith("Equation: "));
  EXPECT_TRUE(manifest["files"][0]["t"].is_null());
}

TEST(ExportEquations, GrowWithDpi) {
  const ScratchFolder scratch;
  const auto size_at = [&](const char* dpi) {
    EXPECT_EQ(export_what("equation", scratch / dpi, {"--dpi", dpi}).code, 0);
    const auto png = read_png(scratch / dpi / "01-steady-steady-body.png");
    EXPECT_EQ(png->metadata.dpi, std::stoi(dpi));
    return png->image.size;
  };
  const Size small = size_at("100"), large = size_at("400");
  // Both lengths are rounded up to whole pixels twice.
  EXPECT_NEAR(large.width, 4.0 * small.width, 4 * 2 + 2);
  EXPECT_NEAR(large.height, 4.0 * small.height, 4 * 2 + 2);
}

TEST(ExportEquations, OneTurnsIntoTheNextOnOneCanvas) {
  const ScratchFolder scratch;
  const Words film = {"--each", "frame", "--fps", "6", "--seconds", "1", "--dpi", "100"};
  ASSERT_EQ(export_what("equation", scratch.path(), film).code, 0);
  const Json files = manifest_in(scratch.path())["files"];
  ASSERT_EQ(files.size(), 6u);
  for (const Json& file : files) EXPECT_EQ(file["width"], files[0]["width"]);
  EXPECT_EQ(files[0]["tex"].size(), 1u);
  EXPECT_EQ(files[2]["tex"].size(), 2u) << "between two lines";
  EXPECT_EQ(files[5]["tex"].size(), 1u);
  EXPECT_NE(files[0]["tex"], files[5]["tex"]);
  auto made = contents(scratch.path());
  EXPECT_EQ(made["01-steady-frame0.png"].size(), made["01-steady-frame1.png"].size()) << "stands first";
  EXPECT_NE(made["01-steady-frame2.png"], made["01-steady-frame3.png"]) << "nothing moves";
}

TEST(ExportTranscript, IsTextInWords) {
  const ScratchFolder scratch;
  const ProgramRun run = export_what("transcript", scratch.path());
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(names_in(scratch.path()), ElementsAre("manifest.json", "tiny.txt"));
  const std::string text = text_of(scratch / "tiny.txt");
  EXPECT_THAT(text, testing::StartsWith("A tiny lesson\n=============\n"));
  EXPECT_THAT(text, HasSubstr("\n3. Rolling\n----------\n"));
  EXPECT_EQ(text.find('\\'), std::string::npos) << "TeX";
  EXPECT_EQ(manifest_in(scratch.path())["files"][0]["file"], "tiny.txt");
}

class Compare : public testing::Test {
 protected:
  void SetUp() override {
    Image image = Image::blank({100, 100});
    write("a.png", image);
    image.rgba[0] = static_cast<std::uint8_t>(image.rgba[0] ^ 2);
    write("near.png", image);
    image.rgba[0] = static_cast<std::uint8_t>(image.rgba[0] ^ 128);
    write("far.png", image);
    write("small.png", Image::blank({10, 10}));
    write_text(scratch / "junk.png", "junk");
  }
  void write(const std::string& name, const Image& image) {
    ASSERT_TRUE(write_png(scratch / name, image, {}).ok());
  }
  ProgramRun compare(const std::string& b, Words more = {}) {
    more.insert(more.begin(), {"compare", scratch / "a.png", scratch / b});
    return polhode(more);
  }
  ScratchFolder scratch;
};

TEST_F(Compare, EqualIs0DifferentIs4UnreadableIs1) {
  EXPECT_EQ(compare("a.png").code, 0);
  EXPECT_EQ(compare("near.png").code, 0);
  EXPECT_EQ(compare("far.png").code, 4);
  EXPECT_EQ(compare("small.png").code, 4);
  EXPECT_EQ(compare("junk.png").code, 1);
  EXPECT_EQ(compare("missing.png").code, 1);
  EXPECT_THAT(compare("missing.png").err, HasSubstr("missing.png"));
}

TEST_F(Compare, SaysHowMuch) {
  const Json far = Json::parse(compare("far.png", {"--json"}).out);
  EXPECT_EQ(far["equal"], false);
  EXPECT_EQ(far["pixels"], 10000);
  EXPECT_EQ(far["over_3"], 1);
  EXPECT_EQ(far["over_fraction"], 1e-4);
  EXPECT_GE(far["max"], 126);
  EXPECT_EQ(Json::parse(compare("near.png", {"--json"}).out)["max"], 2);
  EXPECT_THAT(compare("small.png").out, HasSubstr("100x100 and 10x10"));
}

TEST_F(Compare, DrawsTheDifference) {
  EXPECT_EQ(compare("far.png", {"--diff", scratch / "diff.png"}).code, 4);
  EXPECT_TRUE(read_png(scratch / "diff.png").ok());
  EXPECT_EQ(compare("far.png", {"--diff", scratch / "no/such/folder.png"}).code, 1);
}

}  // namespace
}  // namespace polhode
