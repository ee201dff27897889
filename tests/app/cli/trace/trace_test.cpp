// SPDX-License-Identifier: MIT
// polhode trace, from its output alone.
#include "physics/method.h"
#include "tests/app/run_program.h"
#include "tests/support/euler_angle_top.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <map>
#include <sstream>

namespace polhode {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;
using Row = std::vector<double>;
using Json = nlohmann::json;

const std::string kHeader = "t,w1,w2,w3,qw,qx,qy,qz,T,L,Lx,Ly,Lz";
enum Column { t, w1, w2, w3, qw, qx, qy, qz, T, L, Lx, Ly, Lz };

ProgramRun trace(const std::string& inertia, const std::string& omega, Words more) {
  more.insert(more.begin(), {"trace", "--inertia", inertia, "--omega", omega});
  return polhode(more);
}

std::vector<Row> rows_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, kHeader);
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) {
      double value = NAN;
      std::from_chars(field.data(), field.data() + field.size(), value);
      rows.back().push_back(value);
    }
    EXPECT_EQ(rows.back().size(), 13u);
  }
  return rows;
}

// The invariants of torque-free motion in S. RK4's default step errs by less than 1e-12 in a period (measured
// 3e-14).
void expect_conserved(const std::vector<Row>& rows) {
  constexpr double kTolerance = 1e-12;
  ASSERT_FALSE(rows.empty());
  const Row& first = rows.front();
  for (const Row& row : rows) {
    EXPECT_NEAR(row[T], first[T], kTolerance * first[T]);
    EXPECT_NEAR(row[L], first[L], kTolerance * first[L]);
    for (Column c : {Lx, Ly, Lz}) EXPECT_NEAR(row[c], first[c], kTolerance * first[L]);
    EXPECT_NEAR(std::hypot(std::hypot(row[qw], row[qx]), std::hypot(row[qy], row[qz])), 1.0, 1e-15);
  }
}

TEST(Trace, ConservesTAndLForEveryKindOfBody) {
  for (const char* inertia : {"1,1,1", "1,1,1.5", "1.5,1,1", "1,1.75,2.5", "2.5,1,1.75"}) {
    const ProgramRun run = trace(inertia, "0.3,-0.2,1.5", {"--periods", "1", "--samples", "33"});
    EXPECT_EQ(run.code, 0) << run.err;
    const auto rows = rows_of(run.out);
    EXPECT_EQ(rows.size(), 33u);
    expect_conserved(rows);
  }
}

TEST(Trace, StartsWhereItIsTold) {
  const ProgramRun run = trace("1,2,2.5", "0.1,0x1p-2,-3", {"--attitude", "0.6,0,0.8,0", "--times", "0"});
  const auto rows = rows_of(run.out);
  ASSERT_EQ(rows.size(), 1u);
  constexpr double kRounding = 4 * 0x1p-52;  // of the closed form: a few ε of |ω| and of |q|
  EXPECT_NEAR(rows[0][w1], 0.1, 3 * kRounding);
  EXPECT_NEAR(rows[0][w2], 0.25, 3 * kRounding);
  EXPECT_NEAR(rows[0][w3], -3, 3 * kRounding);
  EXPECT_NEAR(rows[0][qw], 0.6, kRounding);
  EXPECT_NEAR(rows[0][qy], 0.8, kRounding);
  // L_S = R I·ω with R a turn about y: cos = 0.6² − 0.8², sin = 2·0.6·0.8.
  EXPECT_NEAR(rows[0][Lx], -0.28 * 0.1 + 0.96 * -7.5, 1e-14);
  EXPECT_NEAR(rows[0][Lz], -0.96 * 0.1 - 0.28 * -7.5, 1e-14);
}

TEST(Trace, GivesOneRowPerTimeInTheOrderAsked) {
  const auto rows = rows_of(trace("1,1,2", "1,0,1", {"--times", "2,-1,0,2"}).out);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[1][t], -1);
  EXPECT_EQ(rows[0], rows[3]);
}

// 0.1 is not a double: all 17 digits must be there.
TEST(Trace, Has17SignificantDigits) {
  EXPECT_THAT(trace("1,1,1", "0.1,0,0", {"--times", "0"}).out, HasSubstr("0.10000000000000001"));
}

TEST(Trace, JsonHasTheSameNumbers) {
  const Words times = {"--periods", "0.5", "--samples", "3"};
  const auto rows = rows_of(trace("1,1,1.5", "0.3,0.2,1", times).out);
  Words as_json = times;
  as_json.insert(as_json.end(), {"--format", "json"});
  const Json json = Json::parse(trace("1,1,1.5", "0.3,0.2,1", as_json).out);
  EXPECT_EQ(json["method"], "symmetric");
  EXPECT_TRUE(json.contains("condition"));
  EXPECT_TRUE(json["horizon_periods"].contains("1e-3"));
  EXPECT_TRUE(json["horizon_periods"].contains("1e-1"));
  // Half a period of the symmetric top, 2π/|ν| with ν = ω3 (I3 − I1)/I1.
  EXPECT_NEAR(json["period"].get<double>(), 2 * M_PI / 0.5, 1e-14);
  ASSERT_EQ(json["rows"].size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const char* name : {"t", "w1", "qw", "T", "L", "Lz"}) {
      std::size_t column = 0;
      std::istringstream names(kHeader);
      for (std::string n; std::getline(names, n, ',') && n != name;) ++column;
      EXPECT_EQ(json["rows"][i][name].get<double>(), rows[i][column]) << name;
    }
}

TEST(Trace, ChoosesTheBestMethodAndNamesTheOthers) {
  const auto method = [](const std::string& inertia, const std::string& omega, Words more) {
    more.insert(more.end(), {"--times", "0.1", "--format", "json"});
    return Json::parse(trace(inertia, omega, more).out)["method"].get<std::string>();
  };
  EXPECT_EQ(method("1,1,1", "1,2,3", {}), "uniform");
  EXPECT_EQ(method("1,2,2.5", "0,2,0", {}), "uniform");
  EXPECT_EQ(method("1,1,1.5", "1,2,3", {}), "symmetric");
  EXPECT_EQ(method("1,2,2.5", "1,2,3", {}), "exact");
  EXPECT_EQ(method("1,1,1", "1,2,3", {"--torque", "damping:0.1"}), "dormand-prince-8");
  EXPECT_EQ(method("1,1,1", "1,2,3", {"--method", "exact"}), "uniform");
  EXPECT_EQ(method("1,1,1", "1,2,3", {"--method", "rk4", "--step", "0.01"}), "rk4");
  const ProgramRun refused = trace("1,1,1.5", "1,2,3", {"--times", "0", "--method", "uniform"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("not steady; what can: exact, symmetric, explicit-euler"));
}

TEST(Trace, SaysWhatItChoseWhereNumbersDependOnIt) {
  const auto said = [](Words more) {
    more.insert(more.end(), {"--times", "0.1"});
    return trace("1,2,2.5", "1,2,3", more).err;
  };
  EXPECT_THAT(said({"--torque", "damping:0.1"}), HasSubstr("method dormand-prince-8, tolerance 1e-10"));
  EXPECT_THAT(said({"--method", "dormand-prince-5"}), HasSubstr("method dormand-prince-5, tolerance 1e-10"));
  EXPECT_THAT(said({"--method", "dormand-prince-5", "--tolerance", "1e-6"}),
              testing::Not(HasSubstr("tolerance")));
  EXPECT_THAT(said({}), testing::Not(HasSubstr("method")));
}

TEST(Trace, FollowsByEveryMethodThatServes) {
  for (const MethodFacts& facts : all_methods()) {
    if (facts.method == Method::uniform || facts.method == Method::symmetric) continue;
    if (facts.method == Method::lagrange_top) continue;  // that takes a weight
    Words words = {"--times", "0.25", "--format", "json", "--method", std::string(facts.name)};
    if (facts.control == StepControl::fixed) words.insert(words.end(), {"--step", "0.01"});
    if (facts.control == StepControl::adaptive) words.insert(words.end(), {"--tolerance", "1e-6"});
    const ProgramRun run = trace("1,2,2.5", "1,2,3", words);
    ASSERT_EQ(run.code, 0) << facts.name << run.err;
    EXPECT_EQ(Json::parse(run.out)["method"], facts.name);
  }
}

TEST(Trace, ClosedFormAndIntegratorAgree) {
  const Words times = {"--times", "0.7,1.9"};
  Words rk4 = times;
  rk4.insert(rk4.end(), {"--method", "rk4", "--step", "0x1p-10"});
  const auto exact = rows_of(trace("1,1,1.5", "0.3,0.2,1", times).out);
  const auto steps = rows_of(trace("1,1,1.5", "0.3,0.2,1", rk4).out);
  // RK4: (|ω|h)⁴·|ω|t/120 ≈ 2e-14 here, and some rounding.
  for (std::size_t i = 0; i < exact.size(); ++i)
    for (std::size_t c = 0; c < 13; ++c) EXPECT_NEAR(exact[i][c], steps[i][c], 1e-12) << i << ' ' << c;
}

TEST(Trace, TorqueIsSummed) {
  const Words times = {"--times", "0.5"};
  const auto with = [&](Words torque) {
    torque.insert(torque.end(), times.begin(), times.end());
    return rows_of(trace("1,1,1", "0,0,1", torque).out);
  };
  const auto twice = with({"--torque", "space:0,0,1", "--torque", "space:0,0,1"});
  EXPECT_NEAR(twice[0][Lz], 1 + 2 * 0.5, 1e-13);
  EXPECT_EQ(twice, with({"--torque", "space:0,0,2"}));
}

TEST(Trace, PeriodIsNullWithoutOne) {
  const auto period = [](const std::string& omega, Words more) {
    more.insert(more.end(), {"--periods", "1", "--samples", "2", "--format", "json"});
    const Json json = Json::parse(trace("1,2,2.5", omega, more).out);
    return std::pair(json["period"], json["rows"][1]["t"].get<double>());
  };
  EXPECT_EQ(period("0,2,0", {}), (std::pair(Json(nullptr), M_PI)));
  EXPECT_EQ(period("0,2,0", {"--torque", "damping:0.1"}), (std::pair(Json(nullptr), M_PI)));
  const auto [polhode_period, end] = period("1,0.2,1", {});
  EXPECT_EQ(polhode_period.get<double>(), end);
  EXPECT_EQ(trace("1,2,2.5", "0,0,0", {"--periods", "1", "--samples", "2"}).code, 2);
}

TEST(Trace, SaysHowFarTheMotionCanBePredicted) {
  const Words times = {"--times", "0", "--format", "json"};
  const Json json = Json::parse(trace("1,2,3", "0.1,1.5,0.2", times).out);
  const double condition = json["condition"].get<double>();
  EXPECT_GT(condition, 2 * M_PI);  // doubling ω halves the period: the phase of one period moves by 2π
  // One ε = 2⁻⁵³ of the inputs moves the phase by condition·ε a period.
  EXPECT_NEAR(json["horizon_periods"]["1e-3"].get<double>() * condition * 0x1p-53, 1e-3, 1e-12);
  EXPECT_NEAR(json["horizon_periods"]["1e-1"].get<double>() * condition * 0x1p-53, 1e-1, 1e-10);
  EXPECT_THAT(trace("1,2,3", "0.1,1.5,0.2", {"--times", "0"}).err, HasSubstr("prediction horizon: "));

  Words damped = times;
  damped.insert(damped.end(), {"--torque", "damping:0.1"});
  EXPECT_TRUE(Json::parse(trace("1,2,3", "0.1,1.5,0.2", damped).out)["condition"].is_null());
  const ProgramRun at_rest = trace("1,2,3", "0,0,0", times);
  EXPECT_TRUE(Json::parse(at_rest.out)["horizon_periods"]["1e-3"].is_null());
}

TEST(Trace, NeverPutsNaNInJson) {
  const ProgramRun run = trace("1,2,2.5", "1e200,1e200,1e200",
                               {"--times", "1", "--method", "rk4", "--step", "0.5", "--format", "json"});
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.err.find("cannot be computed at t = 1 s"), std::string::npos) << run.err;
  EXPECT_TRUE(Json::parse(run.out)["rows"][0]["w1"].is_null());
}

TEST(Trace, HasNoRowWhereThereIsNoState) {
  const ProgramRun run =
      trace("1,2,2.5", "1e200,1e200,1e200", {"--times", "0,1,0", "--method", "rk4", "--step", "0.5"});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("cannot be computed at t = 1 s"));
  EXPECT_EQ(run.out.find("nan"), run.out.npos) << run.out;
}

TEST(Trace, SaysWhatOverflows) {
  const ProgramRun energy = trace("1,1,1.5", "1e300,1,0", {"--times", "0"});
  EXPECT_EQ(energy.code, 1);
  EXPECT_THAT(energy.err, HasSubstr("T at t = 0 s is too large for a double"));
  EXPECT_EQ(trace("1,1,1.5", "1e300,1,0", {"--times", "0", "--columns", "t,w1"}).code, 0);
  const ProgramRun time = trace("1,1,1.5", "1e-308,0,0", {"--periods", "1", "--samples", "2"});
  EXPECT_EQ(time.code, 2);
  EXPECT_THAT(time.err, HasSubstr("a time that is too large for a double"));
}

TEST(Trace, SaysWhatLiesBeyondTheHorizon) {
  const auto told = [](const std::string& time) {
    return trace("1,1.75,2.5", "0.9,0.4,1", {"--times", time, "--format", "json"}).err;
  };
  EXPECT_THAT(told("1e300"), HasSubstr("t = 1e+300 s is beyond the horizon"));
  EXPECT_EQ(told("1e6").find("beyond"), std::string::npos);
}

// |L|² is neither in range here; |L| is.
TEST(Trace, TheLengthOfLOverflowsOnlyWhenItDoes) {
  const auto huge = rows_of(trace("3e300,4e300,5e300", "1,1,0", {"--times", "0"}).out);
  EXPECT_NEAR(huge.at(0)[L], 5e300, 5e300 * 1e-15);
  const auto tiny = rows_of(trace("3e-200,4e-200,5e-200", "1,1,0", {"--times", "0"}).out);
  EXPECT_NEAR(tiny.at(0)[L], 5e-200, 5e-200 * 1e-15);
}

TEST(Trace, BackwardsStartsAtZeroAndNotAtItsNegative) {
  const ProgramRun run = trace("1,2,3", "0,0,1", {"--periods", "-2", "--samples", "3"});
  EXPECT_THAT(run.out, HasSubstr("\n0,"));
}

TEST(Trace, TellsWhyAnAdaptiveMethodHasNoState) {
  const ProgramRun run = trace("1,2,3", "1,1,1", {"--times", "1", "--torque", "sink:1e300"});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("at t = 1 s: no step is short enough: the torque is too large"));
}

/// Numbers of a CSV text under any header.
std::vector<Row> numbers_of(const std::string& csv, const std::string& header) {
  EXPECT_EQ(csv.substr(0, csv.find('\n')), header);
  std::vector<Row> rows;
  std::istringstream lines(csv.substr(csv.find('\n') + 1));
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(std::stod(field));
  }
  return rows;
}

ProgramRun trace_of_top(const std::string& stage, Words more) {
  more.insert(more.begin(), {"trace", test_lesson("tops.md"), "--stage", stage});
  return polhode(more);
}

TEST(Trace, FollowsTheSceneOfALesson) {
  const ProgramRun run =
      trace_of_top("heavy:1", {"--columns", "t,theta_deg,phi_deg,w3,E", "--times", "0,0.05,0.5"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto rows = numbers_of(run.out, "t,theta_deg,phi_deg,w3,E");
  ASSERT_EQ(rows.size(), 3u);
  const double I1 = 0.01 / 4 + 0.0004 / 12 + 0.01, I3 = 0.005, mgl = 0.980665;
  const test::EulerAngleTop top{I1, I3, mgl, 60};
  for (const Row& row : rows) {
    // Some hundred steps of Dormand-Prince 8 at a tolerance of 1e-10, in degrees.
    const auto y = top.after({M_PI / 3, 0, 0, 0, 0}, row[0], 20'000);
    EXPECT_NEAR(row[1], y[0] * 180 / M_PI, 1e-6);
    EXPECT_NEAR(row[2], y[1] * 180 / M_PI, 1e-6);
    EXPECT_NEAR(row[3], 60, 1e-7);
    EXPECT_NEAR(row[4], 0.5 * I3 * 60 * 60 + mgl * 0.5, 1e-7) << "T + V stays";
  }
}

TEST(Trace, OfALessonIsOverTheDurationOfTheScene) {
  const auto rows = [&](const Words& more) { return rows_of(trace_of_top("heavy", more).out); };
  EXPECT_EQ(rows({}).size(), 101u);
  EXPECT_EQ(rows({}).back()[t], 0.5);
  EXPECT_EQ(rows({"--samples", "11"}).at(1)[t], 0.05);
  EXPECT_GT(rows({"--samples", "2"}).at(0)[w2], 1) << "the last scene of the stage: it precesses";
  EXPECT_EQ(rows_of(trace_of_top("heavy:2", {"--samples", "2"}).out).at(0)[w2], 0);
  EXPECT_EQ(Json::parse(trace_of_top("free", {"--format", "json"}).out)["method"], "symmetric");
  EXPECT_EQ(
      Json::parse(
          trace_of_top("heavy", {"--format", "json", "--method", "rk4", "--step", "1e-3"}).out)["method"],
      "rk4");
}

TEST(Trace, ColumnsAreChosenByName) {
  const ProgramRun json =
      trace("1,2,2.5", "0,0,3", {"--times", "0", "--columns", "psi_deg,e3z,V", "--format", "json"});
  EXPECT_EQ(Json::parse(json.out)["rows"][0], Json::parse("{\"psi_deg\":0,\"e3z\":1,\"V\":0}")) << json.out;
  const ProgramRun unknown = trace("1,2,2.5", "0,0,3", {"--times", "0", "--columns", "t,theta"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("--columns: no column \"theta\""));
  EXPECT_THAT(unknown.err, HasSubstr("(there are t, w1, w2, w3, qw, qx, qy, qz, T, L, Lx, Ly, Lz, theta_deg, "
                                     "phi_deg, psi_deg, e3x, e3y, e3z, V, E)"));
  EXPECT_EQ(unknown.out, "");
}

TEST(Trace, OfALessonRefusesWhatIsNotThere) {
  const std::vector<std::pair<Words, std::string>> refused = {
      {{"trace", test_lesson("tops.md")}, "--stage is needed"},
      {{"trace", test_lesson("tops.md"), "--stage", "havy"}, "did you mean \"heavy\"?"},
      {{"trace", test_lesson("tops.md"), "--stage", "heavy:4"}, "the step of \"heavy\""},
      {{"trace", test_lesson("tops.md"), "--stage", "heavy:x"}, "the step of \"heavy\""},
      {{"trace", test_lesson("tops.md"), "--stage", "words"}, "stage \"words\" has no scene"},
      {{"trace", test_lesson("tops.md"), "--stage", "words:1"}, "step 1 of stage \"words\" has no scene"},
      {{"trace", test_lesson("tops.md"), "--stage", "heavy", "--inertia", "1,1,1"}, "not both"},
      {{"trace", "--stage", "heavy", "--inertia", "1,1,1", "--omega", "1,2,3"}, "--stage is of a LESSON"},
      {{"trace", "--times", "0"}, "what to trace is needed"}};
  for (const auto& [words, says] : refused) {
    const ProgramRun run = polhode(words);
    EXPECT_EQ(run.code, 2) << says;
    EXPECT_THAT(run.err, HasSubstr(says));
  }
}

}  // namespace
}  // namespace polhode
