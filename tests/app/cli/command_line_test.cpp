// SPDX-License-Identifier: MIT
// The command line as a user meets it: help, versions, mistakes, streams and exit codes.
#include "app/cli/command_line.h"

#include "physics/method.h"
#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <sstream>
#include <thread>

namespace polhode {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using Words = std::vector<std::string>;
using Json = nlohmann::json;

const Words kCommands = {"list", "export", "verify", "lint", "info", "trace", "measure", "compare"};

TEST(Help, NamesEveryCommand) {
  const ProgramRun run = polhode({"--help"});
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, IsEmpty());
  for (const std::string& command : kCommands) EXPECT_THAT(run.out, HasSubstr("  " + command + " "));
}

TEST(Help, FitsAHundredColumns) {
  Words lines;
  for (std::string command : {"", "play", "list", "export", "verify", "lint", "info", "answer", "answers",
                              "derive", "trace", "measure", "compare"}) {
    const ProgramRun run = command.empty() ? polhode({"--help"}) : polhode({command, "--help"});
    EXPECT_EQ(run.code, 0) << command;
    EXPECT_THAT(run.err, IsEmpty());
    std::istringstream text(run.out);
    for (std::string line; std::getline(text, line);) EXPECT_LE(line.size(), 100u) << line;
  }
}

TEST(Help, OfACommandNamesItsOptions) {
  const std::map<std::string, Words> options = {
      {"list", {"--json"}},
      {"lint", {"FILE", "--explain", "--json"}},
      {"info", {"LESSON", "--json"}},
      {"compare", {"--diff", "--json"}},
      {"verify", {"DIR", "--json"}},
      {"trace",
       {"LESSON", "--stage", "--columns", "--inertia", "--omega", "--attitude", "--torque", "--times",
        "--from", "--to", "--every", "--periods", "--samples", "--method", "--step", "--tolerance",
        "--format"}},
      {"measure",
       {"LESSON", "--stage", "--inertia", "--omega", "--attitude", "--torque", "--periods", "--tolerance",
        "--method", "--seconds", "--all", "--csv", "--plot", "--json", "--rendering"}},
      {"export",
       {"LESSON",  "-o",       "--stage",         "--each",  "--what",    "--size",     "--fps",  "--seconds",
        "--at",    "--frames", "--background",    "--theme", "--dpi",     "--png",      "--film", "--deck",
        "--shard", "--jobs",   "--skip-existing", "--sync",  "--context", "--text-size"}}};
  for (const auto& [command, names] : options) {
    const ProgramRun run = polhode({command, "--help"});
    for (const std::string& name : names) EXPECT_THAT(run.out, HasSubstr(name)) << command;
  }
}

TEST(Help, OfTraceNamesEveryMethod) {
  const ProgramRun run = polhode({"trace", "--help"});
  for (const std::string& name : method_names()) EXPECT_THAT(run.out, HasSubstr(name));
}

TEST(Version, IsOneLineOnStdout) {
  const ProgramRun run = polhode({"--version"});
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, testing::MatchesRegex("polhode [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

struct Mistake {
  Words words;
  std::string said;
};

TEST(Usage, MistakesAreNamedOnStderrWithCode2) {
  const std::string tiny = test_lesson("tiny.md");
  const Words trace = {"trace", "--inertia", "1,2,2.5", "--omega", "1,2,3"};
  const Words measure = {"measure", "--inertia", "1,2,2.5", "--omega", "1,2,3"};
  const auto with = [](Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const Words export_tiny = {"export", tiny, "-o", "/proc/never-made"};
  const std::vector<Mistake> mistakes = {
      {{}, "a command is needed"},
      {{"exprot"}, "unknown command \"exprot\"; did you mean \"export\"?"},
      {{"list", "--jsno"}, "did you mean \"--json\"?"},
      {{"list", "extra"}, "unexpected argument \"extra\""},
      {{"export", tiny}, "--output"},
      {with(export_tiny, {"--shard", "3/2"}), "from 1 to 2"},
      {with(export_tiny, {"--shard", "slurm"}), "SLURM_ARRAY_TASK_ID is not set"},
      {with(export_tiny, {"--shard", "1/2", "--deck", "a.html"}), "all shards"},
      {with(export_tiny, {"--what", "transcript", "--shard", "1/2"}), "a transcript is text"},
      {with(export_tiny, {"--jobs", "0"}), "--jobs"},
      {{"verify"}, "DIR"},
      {{"verify", ""}, "empty"},
      {with(export_tiny, {"--png", "smal"}), "did you mean \"small\"?"},
      {with(export_tiny, {"--what", "transcript", "--png", "fast"}), "a transcript is text"},
      {{"export", tiny, "--what", "transcript", "--deck", "deck.html"}, "a transcript is text"},
      {{"export", "-o", "x"}, "LESSON"},
      {{"info", "no-such-lesson"}, "unknown lesson \"no-such-lesson\""},
      {with(export_tiny, {"--sise", "1x1"}), "did you mean \"--size\"?"},
      {with(export_tiny, {"--stage", "stedy"}), "did you mean \"steady\"?"},
      {with(export_tiny, {"--size", "0x0"}), "1 to 16384"},
      {with(export_tiny, {"--size", "0x100"}), "1 to 16384"},
      {with(export_tiny, {"--size", "16385x16"}), "1 to 16384"},
      {with(export_tiny, {"--size", "-16x16"}), "--size"},
      {with(export_tiny, {"--size", "big"}), "1920x1080"},
      {with(export_tiny, {"--size"}), "--size"},
      {with(export_tiny, {"--size", ""}), "empty"},
      {with(export_tiny, {"--stage", ""}), "empty"},
      {with(trace, {"--times", ""}), "empty"},
      {with(export_tiny, {"--size", "1x1", "--size", "2x2"}), "--size"},
      {with(export_tiny, {"--each", "frmae"}), "did you mean \"frame\"?"},
      {with(export_tiny, {"--what", "pgae"}), "did you mean \"page\"?"},
      {with(export_tiny, {"--size", "319x240"}), "at least 320x240"},
      {with(export_tiny, {"--size", "640x239"}), "at least 320x240"},
      {with(export_tiny, {"--background", "transparent"}), "a page has the paper of its --theme"},
      {with(export_tiny, {"--what", "equation", "--background", "transparent-dark"}), "in the --theme dark"},
      {with(export_tiny, {"--text-size", "0.69"}), "from 0.7 to 2"},
      {with(export_tiny, {"--text-size", "2.01"}), "from 0.7 to 2"},
      {with(export_tiny, {"--text-size", "large"}), "is not a number"},
      {with(export_tiny, {"--what", "figure", "--text-size", "1"}), "goes with pages"},
      {with(export_tiny, {"--what", "equation", "--text-size", "1"}), "--dpi"},
      {with(export_tiny, {"--what", "transcript", "--text-size", "1"}), "a transcript is text"},
      {with(export_tiny, {"--theme", "drak"}), "did you mean \"dark\"?"},
      {with(export_tiny, {"--what", "figure", "--theme", "dark"}), "pages and equations"},
      {with(export_tiny, {"--what", "equation", "--size", "100x100"}), "--dpi"},
      {with(export_tiny, {"--what", "equation", "--at", "1"}), "no time"},
      {with(export_tiny, {"--what", "equation", "--dpi", "23"}), "24 to"},
      {with(export_tiny, {"--what", "equation", "--dpi", "99999"}), "at most 16384"},
      {with(export_tiny, {"--what", "transcript", "--dpi", "100"}), "a transcript is text"},
      {with(export_tiny, {"--what", "transcript", "--each", "step"}), "a transcript is text"},
      {with(export_tiny, {"--what", "transcript", "--stage", "stedy"}), "did you mean \"steady\"?"},
      {with(export_tiny, {"--fps", "25"}), "--each frame"},
      {with(export_tiny, {"--each", "frame", "--fps", "0"}), "--fps"},
      {with(export_tiny, {"--each", "frame", "--seconds", "-1"}), "negative"},
      {with(export_tiny, {"--each", "frame", "--seconds", "1e9"}), "1000000 frames"},
      {with(export_tiny, {"--each", "frame", "--seconds", "0"}), "nothing to export"},
      {with(export_tiny, {"--each", "frame", "--seconds", "1", "--frames", "5:5"}), "--frames"},
      {with(export_tiny, {"--each", "frame", "--seconds", "1", "--frames", "0:91"}), "90 frames"},
      {with(export_tiny, {"--what", "figure", "--background", "whtie"}), "did you mean \"white\"?"},
      {with(export_tiny, {"--what", "figure", "--background", "#12345g"}), "#rrggbb"},
      {with(export_tiny, {"--dpi", "0"}), "--dpi"},
      {with(export_tiny, {"--sync", "never"}), "--sync"},
      {with(export_tiny, {"--context", "glx"}), "auto, osmesa, egl"},
      {with(export_tiny, {"--at", "soon"}), "--at"},
      {with(export_tiny, {"--what", "figure", "--stage", "words"}), "nothing to export"},
      {with(export_tiny, {"--what", "equation", "--stage", "words"}), "nothing to export"},
      {{"export", tiny, "-o", ""}, "empty"},
      {{"trace", "--omega", "1,2,3", "--times", "0"}, "--inertia"},
      {{"trace", "--inertia", "1,2", "--omega", "1,2,3", "--times", "0"}, "three"},
      {{"trace", "--inertia", "1,2,x", "--omega", "1,2,3", "--times", "0"}, "not a number"},
      {trace, "--times"},
      {with(trace, {"--times", "0,,1"}), "not a number"},
      {with(trace, {"--times", "0", "--attitude", "1,0,0"}), "w,x,y,z"},
      {with(trace, {"--times", "0", "--format", "xml"}), "csv"},
      {with(trace, {"--times", "0", "--method", "rk5"}), "did you mean \"rk4\"?"},
      {with(trace, {"--times", "0", "--method", "rk4"}), "--step"},
      {with(trace, {"--times", "0", "--method", "rk4", "--step", "0"}), "> 0"},
      {with(trace, {"--times", "1e9", "--method", "rk4", "--step", "1e-3"}), "larger --step"},
      {with(trace, {"--times", "0", "--method", "exact", "--torque", "sink:0.1"}),
       "what can: explicit-euler"},
      {with(trace, {"--times", "0", "--step", "0.1"}), "followed by exact"},
      {with(trace, {"--times", "0", "--tolerance", "1e-6"}), "followed by exact"},
      {with(trace, {"--times", "0", "--method", "rk4", "--step", "1", "--tolerance", "1e-6"}),
       "rk4 has none"},
      {with(trace, {"--times", "0", "--method", "dormand-prince-8", "--step", "1"}), "fixed step"},
      {with(trace, {"--times", "0", "--method", "dormand-prince-8", "--tolerance", "0"}), "> 0"},
      {with(trace, {"--times", "0", "--method", "dormand-prince-8", "--tolerance", "1"}), "< 1"},
      {with(trace, {"--times", "0", "--torque", "wind:1,2,3"}), "unknown torque"},
      {with(trace, {"--times", "0", "--torque", "space:1,2"}), "--torque"},
      {{"measure"}, "--inertia"},
      {{"measure", "--inertia", "1,2,3"}, "--omega"},
      {{"measure", tiny}, "--stage is needed"},
      {{"measure", tiny, "--stage", "stedy"}, "did you mean \"steady\"?"},
      {{"measure", tiny, "--stage", "words"}, "no scene"},
      {{"measure", tiny, "--stage", "steady", "--omega", "1,2,3"}, "not both"},
      {{"measure", "--stage", "steady"}, "none is given"},
      {with(measure, {"--periods", "0"}), "> 0"},
      {with(measure, {"--tolerance", "-1"}), "> 0"},
      {with(measure, {"--seconds", "soon"}), "not a number"},
      {with(measure, {"--method", "rk5"}), "did you mean \"rk4\"?"},
      {with(measure, {"--method", "symmetric"}), "what can: exact, explicit-euler"},
      {with(measure, {"--method", "exact", "--torque", "sink:0.1"}), "what can: explicit-euler"},
      {{"measure", "--inertia", "1,2,3", "--omega", "0,0,0"}, "at rest"},
      {with(measure, {"--rendering"}), "--rendering goes with"},
      {{"measure", "--rendering", "--all"}, "--rendering goes with"},
      {{"measure", "--rendering", "--stage", "steady"}, "none is given"},
      {{"measure", tiny, "--rendering"}, "--stage is needed"},
      {{"compare", "one.png"}, "B"},
  };
  for (const Mistake& mistake : mistakes) {
    const ProgramRun run = polhode(mistake.words);
    const std::string line = testing::PrintToString(mistake.words);
    EXPECT_EQ(run.code, 2) << line << run.err;
    EXPECT_THAT(run.err, StartsWith("polhode: ")) << line;
    EXPECT_THAT(run.err, HasSubstr(mistake.said)) << line;
    EXPECT_THAT(run.out, IsEmpty()) << line;
  }
}

TEST(Usage, ImpossibleBodiesAndStatesAreCode3) {
  const auto trace = [](const char* inertia, const char* omega, Words more = {}) {
    Words words = {"trace", "--inertia", inertia, "--omega", omega, "--times", "0"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const std::vector<Mistake> mistakes = {
      {trace("1,1,3", "1,2,3"), "I1 + I2"},
      {trace("0,1,1", "1,2,3"), "not positive"},
      {trace("-1,1,1", "1,2,3"), "not positive"},
      {trace("nan,1,1", "1,2,3"), "nan"},
      {trace("1,1,inf", "1,2,3"), "inf"},
      {trace("1,2,2.5", "nan,0,0"), "nan"},
      {trace("1,2,2.5", "1,2,3", {"--attitude", "0,0,0,0"}), "zero"},
      {trace("1,2,2.5", "1,2,3", {"--attitude", "nan,0,0,0"}), "nan"},
      {trace("1,2,2.5", "1,2,3", {"--torque", "space:nan,0,0"}), "nan"},
      {trace("1,2,2.5", "1,2,3", {"--method", "rk4", "--step", "nan"}), "nan"},
      {{"export", test_lesson("tiny.md"), "-o", "/proc/never-made", "--at", "nan"}, "nan"},
      {{"export", test_lesson("two_errors.md"), "-o", "/proc/never-made"}, "two_errors.md:16:"},
      {{"info", test_lesson("impossible_scene.md")}, "impossible_scene.md:10:"},
  };
  for (const Mistake& mistake : mistakes) {
    const ProgramRun run = polhode(mistake.words);
    const std::string line = testing::PrintToString(mistake.words);
    EXPECT_EQ(run.code, 3) << line << run.err;
    EXPECT_THAT(run.err, HasSubstr(mistake.said)) << line;
    EXPECT_THAT(run.out, IsEmpty()) << line;
  }
}

TEST(Usage, ValuesMayBeginWithAMinus) {
  for (const char* omega : {"-1,2,3", "-.5,2,3", "-0x1p1,2,3"}) {
    const ProgramRun run = polhode({"trace", "--inertia", "1,1,1", "--omega", omega, "--times", "-1"});
    EXPECT_EQ(run.code, 0) << omega << run.err;
  }
}

TEST(Usage, ResultsThatCannotBeWrittenAreCode1) {
  RunOptions full;
  full.stdout_to = "/dev/full";
  for (const Words& words : {Words{"trace", "--inertia", "1,1,1", "--omega", "1,2,3", "--times", "0"},
                             Words{"lint", test_lesson("two_errors.md")}}) {
    const ProgramRun run = polhode(words, full);
    EXPECT_EQ(run.code, 1) << words[0];
    EXPECT_THAT(run.err, HasSubstr("stdout"));
  }
}

TEST(Usage, HelpThatCannotBeWrittenIsCode1) {
  RunOptions full;
  full.stdout_to = "/dev/full";
  for (const char* word : {"--help", "--version"}) EXPECT_EQ(polhode({word}, full).code, 1) << word;
}

/// Runs the program with its stderr redirected by the shell: "2>/dev/full".
RunOptions redirected(const std::string& redirection) {
  RunOptions options;
  options.wrapper = {"sh", "-c", "\"$@\" " + redirection, "sh"};
  return options;
}

// HOSTILE F1: the program aborted (134), also after success.
TEST(Usage, MessagesThatCannotBeWrittenAreLostAndNothingElse) {
  const ScratchFolder scratch;
  const Words trace = {"trace", "--inertia", "1,1.75,2.5", "--omega", "1,2,3", "--times", "0"};
  const std::vector<std::pair<Words, int>> runs = {{trace, 0},
                                                   {{"lint", test_lesson("tiny.md")}, 0},
                                                   {{"info", "no-such-lesson"}, 2},
                                                   {{"lint", test_lesson("two_errors.md")}, 3},
                                                   {{"verify", scratch / "absent"}, 1}};
  for (const auto& [words, code] : runs)
    for (const char* redirection : {"2>/dev/full", "2>&-"})
      EXPECT_EQ(polhode(words, redirected(redirection)).code, code) << words[0] << ' ' << redirection;
}

TEST(Usage, AMessageToAPipeThatNobodyReadsDoesNotEndTheProgram) {
  const ScratchFolder scratch;
  const std::string code = scratch / "code";
  RunOptions options;
  // The reader is gone long before the lesson is read.
  options.wrapper = {"sh", "-c", "{ sleep 0.2; \"$@\"; echo $? >'" + code + "'; } 2>&1 >/dev/null | true",
                     "sh"};
  polhode({"info", "no-such-lesson"}, options);
  for (int tries = 0; tries < 500 && text_of(code).empty(); ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(text_of(code), "2\n");
}

TEST(Usage, WithoutAStderrNoMessageGoesIntoAPicture) {
  const ScratchFolder scratch;
  const Words exporting = {
      "export", test_lesson("tiny.md"), "-o", scratch / "out", "--what", "figure", "--size", "48x27"};
  EXPECT_EQ(polhode(exporting, redirected("2>&-")).code, 0);
  EXPECT_EQ(polhode({"verify", scratch / "out"}).code, 0);
}

// HOSTILE F8: SIGXFSZ ended the program without a word.
TEST(Usage, AFileLargerThanTheLimitIsAnError) {
  const ScratchFolder scratch;
  RunOptions options;
  options.wrapper = {"sh", "-c", "ulimit -f 1; exec \"$@\"", "sh"};
  const ProgramRun run =
      polhode({"export", test_lesson("tiny.md"), "-o", scratch / "out", "--size", "320x240"}, options);
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_THAT(run.err, HasSubstr("File too large"));
}

/// Beside a copy of the program, which so has no share/ of its own.
TEST(FontFiles, AreLookedForBesideTheProgram) {
  const ScratchFolder scratch;
  const std::filesystem::path fonts = scratch / "share/polhode/fonts";
  std::filesystem::create_directories(fonts);
  std::filesystem::create_directories(scratch / "bin");
  RunOptions options;
  options.wrapper = {"sh", "-c", "cp \"$1\" \"$0\" && shift && exec \"$0\" \"$@\"", scratch / "bin/polhode"};
  EXPECT_EQ(polhode({"lint", test_lesson("tiny.md")}, options).code, 0);
  write_text(fonts / "texgyrepagella-italic.otf", "no font");
  const ProgramRun run = polhode({"lint", test_lesson("tiny.md")}, options);
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr(fonts / "texgyrepagella-italic.otf"));
}

TEST(List, ReadsTheFolderOfTheEnvironmentFirst) {
  RunOptions options;
  options.environment["POLHODE_LESSONS"] = test_lesson("");
  const ProgramRun run = polhode({"list", "--json"}, options);
  EXPECT_EQ(run.code, 0);
  const Json lessons = Json::parse(run.out);
  const auto tiny =
      std::find_if(lessons.begin(), lessons.end(), [](const Json& l) { return l["id"] == "tiny"; });
  ASSERT_NE(tiny, lessons.end());
  EXPECT_EQ((*tiny)["title"], "A tiny lesson");
  EXPECT_EQ((*tiny)["stages"], 3);
  EXPECT_THAT((*tiny)["path"].get<std::string>(), testing::EndsWith("tests/data/app/tiny.md"));
  EXPECT_THAT(polhode({"list"}, options).out, HasSubstr("A tiny lesson"));
  EXPECT_THAT(run.err, HasSubstr("two_errors.md")) << "a lesson with errors is passed over silently";
}

TEST(List, HasATranslationBehindItsOriginal) {
  const ScratchFolder scratch;
  std::filesystem::copy(test_lesson("tiny.md"), scratch / "tiny.md");
  std::string german = text_of(test_lesson("tiny.md"));
  const std::size_t title = german.find("title");
  ASSERT_NE(title, german.npos);
  write_text(scratch / "tiny.de.md", german.insert(title, "language = \"de\"\n"));
  RunOptions options;
  options.environment["POLHODE_LESSONS"] = scratch.path();
  const Json lessons = Json::parse(polhode({"list", "--json"}, options).out);
  const auto at = [&](std::string_view id) {
    return std::find_if(lessons.begin(), lessons.end(), [&](const Json& l) { return l["id"] == id; });
  };
  ASSERT_NE(at("tiny"), lessons.end());
  ASSERT_NE(at("tiny.de"), lessons.end());
  EXPECT_EQ(at("tiny.de") - at("tiny"), 1);
  EXPECT_EQ((*at("tiny"))["language"], "en");
  EXPECT_EQ((*at("tiny.de"))["language"], "de");
}

TEST(List, FindsLessonsInTheFolderItRunsIn) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "lessons");
  std::filesystem::copy(test_lesson("tiny.md"), scratch / "lessons/other.md");
  RunOptions options;
  options.folder = scratch.path();
  EXPECT_THAT(polhode({"list"}, options).out, HasSubstr("other"));
  EXPECT_EQ(polhode({"lint", "other"}, options).code, 0);
}

TEST(Lint, SaysWhereOnStdoutAndEndsWithCode3) {
  const ProgramRun run = polhode({"lint", test_lesson("two_errors.md")});
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.out, HasSubstr("two_errors.md:12:"));
  EXPECT_THAT(run.out, HasSubstr("two_errors.md:16:"));
  EXPECT_THAT(run.out, HasSubstr(": error: "));
}

TEST(Lint, GivesTheSameAsJson) {
  const ProgramRun run = polhode({"lint", "--json", test_lesson("two_errors.md"), test_lesson("tiny.md")});
  EXPECT_EQ(run.code, 3);
  const Json found = Json::parse(run.out);
  ASSERT_GE(found.size(), 2u);
  for (const Json& one : found) {
    EXPECT_TRUE(one["line"].is_number_integer());
    EXPECT_TRUE(one["column"].is_number_integer());
    for (const char* field : {"file", "severity", "message", "hint"})
      EXPECT_TRUE(one[field].is_string()) << field;
  }
  EXPECT_EQ(Json::parse(polhode({"lint", "--json", test_lesson("tiny.md")}).out), Json::array());
}

TEST(Lint, BadFilesHaveOneAnswerAndNoCrash) {
  const ScratchFolder scratch;
  write_text(scratch / "empty.md", "");
  write_text(scratch / "junk.md", std::string("\0\xff\xfe+++\x80", 8));
  write_text(scratch / "large.md", std::string(2 << 20, 'a'));
  for (const char* name : {"empty.md", "junk.md", "large.md"}) {
    const ProgramRun run = polhode({"lint", scratch / name});
    EXPECT_EQ(run.code, 3) << name;
    EXPECT_THAT(run.out, HasSubstr(name));
  }
  const ProgramRun missing = polhode({"lint", scratch / "missing.md", test_lesson("two_errors.md")});
  EXPECT_EQ(missing.code, 1);
  EXPECT_THAT(missing.err, HasSubstr("missing.md"));
  EXPECT_THAT(missing.out, HasSubstr("two_errors.md")) << "the other file was not looked at";
}

TEST(Info, SaysWhatEachStageRequires) {
  const ProgramRun run = polhode({"info", test_lesson("tiny.md"), "--json"});
  EXPECT_EQ(run.code, 0) << run.err;
  const Json info = Json::parse(run.out);
  EXPECT_EQ(info["lesson"], "tiny");
  const Json& stages = info["stages"];
  ASSERT_EQ(stages.size(), 3u);
  EXPECT_EQ(stages[0]["id"], "steady");
  EXPECT_EQ(stages[0]["steps"], 2);
  EXPECT_EQ(stages[0]["motion"], "uniform");
  EXPECT_GT(stages[0]["setup_ns"], 0);
  EXPECT_GT(stages[0]["call_ns"], 0);
  EXPECT_TRUE(stages[1]["motion"].is_null());
  EXPECT_EQ(stages[1]["requires"], Json::array());
  EXPECT_NE(stages[2]["motion"], "uniform");
  EXPECT_THAT(stages[2]["requires"], testing::Contains("polhode"));
  const ProgramRun table = polhode({"info", test_lesson("tiny.md")});
  EXPECT_THAT(table.out, HasSubstr("rolling"));
  EXPECT_THAT(table.out, HasSubstr("[1] " + stages[0]["why"].get<std::string>()));
}

/// Each of its stages takes as many steps as are made before a motion is given up: a second of one core.
TEST(Info, EndsWhereALessonIsTooLongToMeasure) {
  const ScratchFolder scratch;
  std::string text = "+++\nformat = 1\nid = \"dear\"\ntitle = \"Dear\"\n+++\n";
  for (int stage = 0; stage < 30; ++stage)
    text += "# Stage {s" + std::to_string(stage) +
            "}\nWords.\n\n```scene\nomega = [0.9, 0.4, 1.0]\ntorque = \"heavy:1e300,0,0,1\"\nshow = "
            "[\"omega\"]\n```\n";
  write_text(scratch / "dear.md", text);
  const ProgramRun run = polhode({"info", scratch / "dear.md"});
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("dear.md:"));
  EXPECT_THAT(run.err, HasSubstr("too long to check"));
}

TEST(Info, SaysWhatALessonIsAbout) {
  const ScratchFolder scratch;
  write_text(
      scratch / "about.md",
      "+++\nformat = 1\nid = \"about\"\ntitle = \"About\"\nauthor = [\"A. B.\", \"C. D.\"]\nlicence = \"CC "
      "BY 4.0\"\noutcomes = \"know it\"\nnext = \"tiny\"\n[references]\nLL = \"Landau\"\n+++\n# One "
      "{one}\n[cite: LL]\n");
  const Json info = Json::parse(polhode({"info", scratch / "about.md", "--json"}).out);
  EXPECT_EQ(info["title"], "About");
  EXPECT_EQ(info["about"]["author"], (Json{"A. B.", "C. D."}));
  EXPECT_EQ(info["about"]["licence"], "CC BY 4.0");
  EXPECT_EQ(info["about"]["language"], "en");
  EXPECT_EQ(info["about"]["outcomes"], Json::array({"know it"}));
  EXPECT_EQ(info["about"]["prerequisites"], Json::array());
  EXPECT_EQ(info["about"]["next"], "tiny");
  EXPECT_EQ(info["about"]["references"]["LL"], "Landau");
  const ProgramRun table = polhode({"info", scratch / "about.md"});
  EXPECT_THAT(table.out, HasSubstr("author         A. B.\n               C. D.\nlicence        CC BY 4.0\n"));
  EXPECT_THAT(table.out, HasSubstr("[LL]           Landau\n"));
}

TEST(Info, TellsTheNumbersOfEachMotion) {
  const ProgramRun run = polhode({"info", test_lesson("tops.md"), "--json"});
  EXPECT_EQ(run.code, 0) << run.err;
  const Json stages = Json::parse(run.out)["stages"];
  ASSERT_EQ(stages[0]["scenes"].size(), 2u) << "another camera is no other motion";
  const Json &cusps = stages[0]["scenes"][0], &steady = stages[0]["scenes"][1],
             &free = stages[1]["scenes"][0];
  EXPECT_EQ(cusps["steps"], Json::parse("[1,2]"));
  EXPECT_EQ(steady["steps"], Json::parse("[3,3]"));
  // Of a disc of 1 kg, 20 cm across and 2 cm thick, 10 cm from the pivot.
  const double I1 = 0.01 / 4 + 0.0004 / 12 + 0.01, I3 = 0.005, mgl = 0.980665, b = I3 * 60;
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(cusps["moments"][0].get<double>(), I1, kRounding);
  EXPECT_EQ(cusps["mass_kg"], 1.0);
  EXPECT_NEAR(cusps["T"].get<double>(), I3 * 60 * 60 / 2, kRounding);
  EXPECT_NEAR(cusps["L"].get<double>(), b, kRounding);
  EXPECT_TRUE(cusps["period"].is_null());
  const Json& heavy = cusps["heavy_top"];
  const double root = std::sqrt(b * b - 2 * I1 * mgl);  // 4 I1 cosθ mgl, cosθ = 1/2
  EXPECT_NEAR(heavy["theta_deg"].get<double>(), 60, kRounding);
  EXPECT_NEAR(heavy["slow"].get<double>(), (b - root) / I1, 1e3 * kRounding);
  EXPECT_NEAR(heavy["fast"].get<double>(), (b + root) / I1, 1e3 * kRounding);
  EXPECT_NEAR(heavy["theta_least_deg"].get<double>(), 60, 1e-6);
  EXPECT_NEAR(heavy["theta_most_deg"].get<double>(), 75.9, 0.05);
  EXPECT_NEAR(steady["heavy_top"]["theta_most_deg"].get<double>(), 60, 1e-4);
  EXPECT_TRUE(cusps["free_precession"]["in_space"].is_null());

  const double across = std::sin(M_PI / 9), w3 = 3, J1 = I1 - 0.01;
  EXPECT_NEAR(free["moments"][0].get<double>(), J1, kRounding) << "about its centre of mass";
  EXPECT_NEAR(free["free_precession"]["in_space"].get<double>(), std::hypot(J1 * across, I3 * w3) / J1,
              kRounding);
  EXPECT_NEAR(free["free_precession"]["in_body"].get<double>(), (I3 - J1) / J1 * w3, kRounding);
  EXPECT_NEAR(free["period"].get<double>(), 2 * M_PI / ((I3 - J1) / J1 * w3), kRounding);
  EXPECT_EQ(stages[2]["scenes"], Json::array());

  const ProgramRun table = polhode({"info", test_lesson("tops.md")});
  EXPECT_THAT(table.out, HasSubstr("heavy at 60 deg: slow 3.529"));
  EXPECT_THAT(table.out, HasSubstr("free: "));
}

TEST(Lint, ExplainsTheSceneOfAStep) {
  const ProgramRun run = polhode({"lint", test_lesson("tops.md"), "--explain", "heavy:2"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, testing::StartsWith("```scene\nbody = \"top\"\nomega = [0.0, 0.0, 60.0]\n"));
  EXPECT_THAT(run.out, HasSubstr("\nduration = 0.5\n"));
  EXPECT_THAT(run.out, HasSubstr("\nat = 0.0  # default\n"));
  EXPECT_THAT(run.out, HasSubstr("\nmotion = { method = \"lagrange-top\" }  # default\n"));
  EXPECT_THAT(run.out, HasSubstr("\nmeters = []  # default\n"));

  // In the same lesson it is the same motion, and says all of it.
  const std::string lesson = text_of(test_lesson("tops.md"));
  const ScratchFolder scratch;
  write_text(scratch / "again.md", lesson + "\n# Again {again}\n\n" + run.out);
  const ProgramRun again = polhode({"lint", scratch / "again.md", "--explain", "again"});
  ASSERT_EQ(again.code, 0) << again.err;
  const auto without_comments = [](std::string text) {
    for (std::size_t at; (at = text.find("  # default")) != text.npos;) text.erase(at, 11);
    return text;
  };
  EXPECT_EQ(without_comments(again.out), without_comments(run.out));
  const auto traced = [&](const std::string& stage) {
    return polhode({"trace", scratch / "again.md", "--stage", stage}).out;
  };
  EXPECT_EQ(traced("again"), traced("heavy:2"));
}

TEST(Lint, ExplainsNothingThatIsNotThere) {
  const ProgramRun unknown = polhode({"lint", test_lesson("tops.md"), "--explain", "heavy:9"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("the step of \"heavy\""));
  EXPECT_EQ(polhode({"lint", test_lesson("tops.md"), test_lesson("tiny.md"), "--explain", "heavy"}).code, 2);
  EXPECT_EQ(polhode({"lint", test_lesson("tops.md"), "--json", "--explain", "heavy"}).code, 2);
  const ProgramRun faulty = polhode({"lint", test_lesson("two_errors.md"), "--explain", "one"});
  EXPECT_EQ(faulty.code, 3);
  EXPECT_THAT(faulty.err, HasSubstr("two_errors.md:"));
}

}  // namespace
}  // namespace polhode
