// SPDX-License-Identifier: MIT
// polhode measure, from its output alone.
#include "render/image/png.h"
#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace polhode {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using Words = std::vector<std::string>;
using Json = nlohmann::ordered_json;

/// A quick one: two methods, few periods.
ProgramRun measure(Words more, const RunOptions& options = {}) {
  Words words = {"measure",  "--inertia", "1,2,3",    "--omega", "0.1,1.5,0.2", "--periods", "2",
                 "--method", "exact",     "--method", "rk4",     "--seconds",   "0.05"};
  words.insert(words.end(), more.begin(), more.end());
  return polhode(words, options);
}

const Words kKeys = {"method",
                     "step",
                     "tolerance",
                     "evaluations",
                     "ns_per_period",
                     "error_omega",
                     "error_attitude_rad",
                     "drift_T",
                     "drift_L",
                     "drift_L_direction_rad"};

void expect_keys(const Json& row) {
  Words keys;
  for (const auto& [key, value] : row.items()) keys.push_back(key);
  EXPECT_EQ(keys, kKeys);
}

TEST(Measure, JsonHasTheFieldsOfTheContract) {
  const ProgramRun run = measure({"--json", "--tolerance", "1e-3"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Json json = Json::parse(run.out);
  ASSERT_EQ(json.size(), 2u);
  for (const Json& row : json["rows"]) {
    expect_keys(row);
    EXPECT_TRUE(row["tolerance"].is_null());
    EXPECT_EQ(row["step"].is_null(), row["method"] == "exact");
    EXPECT_GT(row["ns_per_period"].get<double>(), 0);
  }
  expect_keys(json["recommended"]);
  EXPECT_THAT(json["rows"], testing::Contains(json["recommended"]));
  EXPECT_LE(json["recommended"]["error_omega"].get<double>(), 1e-3);
  EXPECT_LE(json["recommended"]["error_attitude_rad"].get<double>(), 1e-3);
}

TEST(Measure, RecommendsNothingWhereNothingWillDo) {
  const Words only_rk4 = {"measure",  "--inertia", "1,2,3",     "--omega", "0.1,1.5,0.2", "--periods", "2",
                          "--method", "rk4",       "--seconds", "0.01",    "--tolerance", "1e-30"};
  const ProgramRun table = polhode(only_rk4);
  EXPECT_EQ(table.code, 0) << table.err;
  EXPECT_THAT(table.out, HasSubstr("Nothing measured has both errors at most 1e-30 after 2 periods"));
  Words as_json = only_rk4;
  as_json.push_back("--json");
  const ProgramRun run = polhode(as_json);
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(Json::parse(run.out)["recommended"].is_null());
  EXPECT_TRUE(Json::parse(measure({"--json"}).out)["recommended"].is_null());  // nothing asked for
}

TEST(Measure, PutsNullWhereNothingIsKept) {
  const ProgramRun run =
      polhode({"measure", "--inertia", "1,2,3", "--omega", "0.1,1.5,0.2", "--torque", "damping:0.1",
               "--periods", "1", "--method", "dormand-prince-5", "--seconds", "0.05", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Json rows = Json::parse(run.out)["rows"];
  ASSERT_FALSE(rows.empty());
  for (const Json& row : rows) {
    EXPECT_TRUE(row["drift_T"].is_null());
    EXPECT_TRUE(row["step"].is_null());
    EXPECT_GT(row["tolerance"].get<double>(), 0);
  }
  EXPECT_THAT(run.err, HasSubstr("against dormand-prince-8 at tolerance 1e-14"));
}

TEST(Measure, TheTableSaysInOneSentenceWhatToTake) {
  const ProgramRun run = measure({"--tolerance", "1e-3"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("The cheapest with both errors at most 0.001 after 2 periods is "));
  EXPECT_THAT(run.out, HasSubstr("\n> "));
  EXPECT_THAT(run.err, HasSubstr("2 polhode periods of 13.25"));
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line) && line != "";) EXPECT_LE(line.size(), 100u) << line;
  EXPECT_THAT(measure({}).out, Not(HasSubstr("The cheapest")));
}

TEST(Measure, AllShowsEveryRow) {
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  EXPECT_GT(lines(measure({"--all"}).out), 6);
}

TEST(Measure, WritesCsvWhole) {
  const ScratchFolder folder;
  const ProgramRun run = measure({"--json", "--csv", (folder / "rows.csv").string()});
  ASSERT_EQ(run.code, 0) << run.err;
  std::istringstream lines(text_of(folder / "rows.csv"));
  std::string header, line;
  std::getline(lines, header);
  std::string wanted;
  for (const std::string& key : kKeys) wanted += (wanted.empty() ? "" : ",") + key;
  EXPECT_EQ(header, wanted);
  std::size_t rows = 0;
  while (std::getline(lines, line)) {
    ++rows;
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 9) << line;
  }
  EXPECT_EQ(rows, Json::parse(run.out)["rows"].size());
  EXPECT_EQ(names_in(folder.path()), Words{"rows.csv"});

  const ProgramRun failed = measure({"--csv", "/proc/none/rows.csv"});
  EXPECT_EQ(failed.code, 1);
  EXPECT_THAT(failed.err, HasSubstr("/proc/none/rows.csv"));
}

TEST(Measure, DrawsADiagram) {
  const ScratchFolder folder;
  const ProgramRun run = measure({"--tolerance", "1e-3", "--plot", (folder / "work.png").string()});
  ASSERT_EQ(run.code, 0) << run.err;
  const Result<PngFile> file = read_png(folder / "work.png");
  ASSERT_TRUE(file) << file.error();
  EXPECT_EQ(file->image.size, (Size{1920, 1080}));
  EXPECT_EQ(measure({"--plot", "/proc/none/work.png"}).code, 1);
}

TEST(Measure, RefusesFilesBeforeItMeasures) {
  const ProgramRun nowhere = measure({"--csv", "/proc/none/rows.csv"});
  EXPECT_EQ(nowhere.code, 1);
  EXPECT_EQ(nowhere.err, "polhode: cannot write /proc/none/rows.csv: there is no folder /proc/none\n");
  const ProgramRun kind = measure({"--plot", "work.jpg"});
  EXPECT_EQ(kind.code, 2);
  EXPECT_THAT(kind.err, testing::HasSubstr("--plot work.jpg: the name has to end in .png"));
}

TEST(Measure, TakesTheSceneOfAStage) {
  const ProgramRun run = polhode({"measure", test_lesson("tiny.md"), "--stage", "steady", "--periods", "1",
                                  "--method", "uniform", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(Json::parse(run.out)["rows"][0]["method"], "uniform");
  EXPECT_THAT(run.err, HasSubstr("turns 2 pi/|omega|"));
}

TEST(Measure, SaysWhatIsOutOfReach) {
  const ProgramRun run = measure({"--periods", "1e12", "--json"});
  EXPECT_EQ(run.code, 2);  // --periods twice
  const ProgramRun far = polhode({"measure", "--inertia", "1,2,3", "--omega", "0,0,1", "--periods", "1e12",
                                  "--method", "exact", "--method", "rk4", "--json"});
  ASSERT_EQ(far.code, 0) << far.err;
  EXPECT_THAT(far.err, HasSubstr("left out, too many steps for --seconds 8 even when they are long: rk4"));
  EXPECT_EQ(Json::parse(far.out)["rows"].size(), 1u);
}

TEST(Measure, CountsNoEvaluationsOfWhatCouldNotBeComputed) {
  const ProgramRun run = polhode({"measure", "--inertia", "1,2,3", "--omega", "0.1,1.5,0.2", "--method",
                                  "explicit-euler", "--seconds", "0.01", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Json row = Json::parse(run.out)["rows"][0];  // ten steps a period: Euler's method overflows
  EXPECT_TRUE(row["error_omega"].is_null());
  EXPECT_TRUE(row["evaluations"].is_null());
}

}  // namespace
}  // namespace polhode
