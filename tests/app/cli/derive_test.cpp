// SPDX-License-Identifier: MIT
#include "tests/app/run_program.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace polhode {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

class Derive : public ::testing::Test {
 protected:
  ProgramRun derive(const std::string& lines, std::vector<std::string> rest = {}) {
    std::vector<std::string> arguments = {"derive", lesson_, "euler-tensor", "derive-six"};
    arguments.insert(arguments.end(), rest.begin(), rest.end());
    write_text(folder_ / "lines", lines);
    RunOptions options;
    options.wrapper = {"sh", "-c", "from=$1; shift; exec \"$@\" < \"$from\"", "sh",
                       (folder_ / "lines").string()};
    options.environment.emplace("XDG_STATE_HOME", (folder_ / "state").string());
    return polhode(arguments, options);
  }
  const std::string lesson_ = (test::source_dir() / "lessons/euler-equations.md").string();
  ScratchFolder folder_;
};

TEST_F(Derive, EachLineIsJudgedAndTheGoalIsZero) {
  const ProgramRun run =
      derive("d*L/dt - omega x L = N\nd*L/dt + omega x L = N\nI omega' + omega x (I omega) = N\n");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(
      run.out,
      HasSubstr("  1  wrong       d*L/dt - omega x L = N\n     the sign of \"omega x L\" is not right\n"));
  EXPECT_THAT(run.out, HasSubstr("  2  holds       d*L/dt + omega x L = N\n"));
  EXPECT_THAT(
      run.out,
      HasSubstr("  3  goal        I omega' + omega x (I omega) = N\nThe goal is reached, in 2 lines.\n"));
  const Json kept = Json::parse(text_of(folder_ / "state" / "polhode" / "euler-equations.answers.json"));
  EXPECT_EQ(kept.at("answers").at("euler-tensor/derive-six").at("right"), true);
}

TEST_F(Derive, NotThereYetIsFourAndSaysWhatIsNext) {
  const ProgramRun run = derive("d*L/dt + omega x L = N\n", {"--hint", "3"});
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.out, HasSubstr("Not there yet. The goal: I omega' + omega x (I omega) = N\n"));
  EXPECT_THAT(run.out, HasSubstr("Hint: Type: d*(I omega)/dt"));
  EXPECT_EQ(derive("", {"--hint", "9"}).code, 2);
}

// Formulas in hints are said in words: a terminal sets none.
TEST_F(Derive, HintsHaveNoTex) {
  const ProgramRun run = derive("", {"--hint", "2"});
  EXPECT_THAT(run.out, HasSubstr("Hint: "));
  EXPECT_EQ(run.out.find('$'), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find('\\'), std::string::npos) << run.out;
}

TEST_F(Derive, AreNotAnswered) {
  const ProgramRun run = polhode({"answer", lesson_, "euler-tensor", "derive-six", "A"}, {});
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("polhode derive takes its lines"));
}

TEST_F(Derive, AsJsonEveryLineHasItsSlip) {
  const Json json = Json::parse(derive("dL/dt = d*L/dt\nL + \n", {"--json"}).out);
  EXPECT_EQ(json.at("goal_reached"), false);
  ASSERT_EQ(json.at("lines").size(), 2u);
  EXPECT_EQ(json.at("lines")[0].at("verdict"), "wrong");
  EXPECT_EQ(json.at("lines")[0].at("slip"), "transport");
  EXPECT_EQ(json.at("lines")[1].at("verdict"), "unreadable");
  EXPECT_EQ(json.at("lines")[1].at("column"), 5);
}

TEST_F(Derive, OtherQuestionsAreAnswered) {
  const ProgramRun run = polhode({"derive", lesson_, "frames", "opening"}, {});
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("asks for no derivation"));
}

}  // namespace
}  // namespace polhode
