// SPDX-License-Identifier: MIT
#include "app/session/saved/answer_file.h"
#include "app/session/saved/state_file.h"
#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <optional>
#include <thread>

namespace polhode {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Json = nlohmann::json;

class Answer : public ::testing::Test {
 protected:
  ProgramRun answer(const std::string& ask, std::vector<std::string> rest, RunOptions options = {}) {
    std::vector<std::string> arguments = {"answer", lesson_.string(), "quiz", ask};
    arguments.insert(arguments.end(), rest.begin(), rest.end());
    options.environment.emplace("XDG_STATE_HOME", (folder_ / "state").string());
    return polhode(arguments, options);
  }
  std::filesystem::path log() const { return folder_ / "state" / "polhode" / "quiz.answers.json"; }
  Json logged() const { return Json::parse(text_of(log())).at("answers"); }

  void SetUp() override {
    write_text(
        lesson_,
        "+++\nformat = 1\nid = \"quiz\"\ntitle = \"Quiz\"\n+++\n# Quiz {quiz}\nAsk.\n\n"
        "```ask sign\ntype = \"expression\"\nprompt = 'The y component?'\n"
        "answer = \"w3*w1*(I1 - I3)\"\nhints = ['Use $I_1$.', 'Mind the sign.']\n```\n"
        "```ask which\ntype = \"choice\"\nprompt = 'Which?'\nchoices = ['one', 'two']\nanswer = 2\n```\n"
        "```ask listed\ntype = \"choice\"\nprompt = 'Which?'\nshuffle = false\nbecause = 'So it is.'\n"
        "- [ ] one\n  The $\\omega_1$ there is small.\n- [x] two\n```\n"
        "```ask speed\ntype = \"number\"\nprompt = 'How fast?'\nanswer = 2\nunit = 'rad/s'\n"
        "hints = ['One.', 'Two.']\nbecause = 'It is given'\n```\n"
        "```scene\nbody = \"textbook\"\nomega = [0.3, 0.2, 1.5]\n```\n"
        "```ask apart\ntype = \"state\"\nprompt = 'Apart?'\n"
        "goals = [{ of = 'atan2(norm(cross(omega, L)), dot(omega, L))', say = 'angle', is = 20, within = 1, "
        "unit = 'deg' }]\n"
        "change = ['omega']\nsolution = { omega = [1.5, 0, 0.45] }\nhints = ['Drag.']\n```\n");
  }
  ScratchFolder folder_;
  std::filesystem::path lesson_ = folder_ / "quiz.md";
};

TEST_F(Answer, RightIsZeroAndWrongIsFourWithTheReason) {
  const ProgramRun right = answer("sign", {"w1*w3*(I1 - I3)"});
  EXPECT_EQ(right.code, 0) << right.err;
  EXPECT_EQ(right.out, "right\n");
  const ProgramRun wrong = answer("sign", {"w1*w3*(I3 - I1)"});
  EXPECT_EQ(wrong.code, 4);
  EXPECT_THAT(wrong.out, HasSubstr("wrong: wrong sign"));
  EXPECT_THAT(wrong.out, HasSubstr("At I = (2, 3, 4), ω = (1, 0, 1) yours is 2, right is −2."));
}

TEST_F(Answer, AStateIsJudgedByItsMotion) {
  const ProgramRun right = answer("apart", {"omega = [1.5, 0, 0.45]"});
  EXPECT_EQ(right.code, 0) << right.err;
  EXPECT_EQ(right.out, "right\n");
  EXPECT_EQ(logged().at("quiz/apart").at("last"), "omega = [1.5, 0, 0.45]");
  const ProgramRun wrong = answer("apart", {"omega = [0, 0, 1]"});
  EXPECT_EQ(wrong.code, 4);
  EXPECT_THAT(wrong.out, HasSubstr("wrong: angle is 0.0°, 20.0° too small\n"));
  const ProgramRun other = answer("apart", {"t = 1"});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("this question keeps the time as it is"));
  const ProgramRun slip = answer("apart", {"omge = [0, 0, 1]"});
  EXPECT_EQ(slip.code, 2);
  EXPECT_EQ(slip.out, "  omge = [0, 0, 1]\n  ^\n");
  EXPECT_THAT(slip.err, HasSubstr("omge"));
}

TEST_F(Answer, UnreadableIsTwoWithItsColumn) {
  const ProgramRun run = answer("sign", {"w1*w9"});
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "  w1*w9\n     ^\n");
  EXPECT_THAT(run.err, HasSubstr("there is no \"w9\" here"));
  EXPECT_FALSE(std::filesystem::exists(log())) << "it was no try";
}

TEST_F(Answer, MayBeginWithAMinus) {
  EXPECT_EQ(answer("sign", {"-w3*w1*(I3 - I1)"}).code, 0);
  EXPECT_EQ(answer("sign", {"-I1"}).code, 4);
}

TEST_F(Answer, TriesAreKeptAndCanBeForgotten) {
  answer("sign", {"w1"});
  answer("sign", {"w3*w1*(I1 - I3)"});
  answer("which", {"A"});
  EXPECT_EQ(logged()["quiz/sign"]["tries"], 2);
  EXPECT_EQ(logged()["quiz/sign"]["right"], true);
  EXPECT_EQ(logged()["quiz/which"]["right"], false);
  EXPECT_EQ(answer("sign", {"--reset"}).code, 0);
  EXPECT_FALSE(logged().contains("quiz/sign"));
  EXPECT_TRUE(logged().contains("quiz/which"));
}

TEST_F(Answer, HintsComeOneAtATimeInWords) {
  EXPECT_EQ(answer("sign", {"--hint"}).out, "Hint 1 of 2: Use I sub 1.\n");
  EXPECT_EQ(answer("sign", {"--hint"}).out,
            "Hint 2 of 2: Mind the sign.\nThat was the last hint: after it --hint tells the answer.\n");
}

TEST_F(Answer, BehindTheLastHintTheAnswerIsToldWithItsReason) {
  for (int i = 0; i < 2; ++i) answer("sign", {"--hint"});
  const std::string told = "The answer is w3*w1*(I1 - I3).\n";
  EXPECT_EQ(answer("sign", {"--hint"}).out, told);
  EXPECT_EQ(answer("sign", {"--hint"}).out, told) << "and again";
  EXPECT_EQ(logged()["quiz/sign"]["hints"], 3) << "one more than there are: it was told";
}

TEST_F(Answer, WithoutHintsItIsToldToWhoHasTried) {
  EXPECT_EQ(answer("which", {"--hint"}).out,
            "There is no hint. Try an answer: after it --hint tells the right one.\n");
  EXPECT_FALSE(std::filesystem::exists(log()) && logged().contains("quiz/which"));
  answer("which", {"A"});
  EXPECT_EQ(answer("which", {"--hint"}).out, "The answer is B: two.\n");
}

TEST_F(Answer, AChoiceGetsItsReply) {
  const ProgramRun wrong = answer("listed", {"A"});
  EXPECT_EQ(wrong.code, 4);
  EXPECT_EQ(wrong.out, "A is not right.\nThe omega sub 1 there is small.\n");
  EXPECT_EQ(answer("listed", {"B"}).out, "right\nSo it is.\n");
  const Json json = Json::parse(answer("listed", {"A", "--json"}).out);
  EXPECT_EQ(json["reply"], "The omega sub 1 there is small.");
}

TEST_F(Answer, ANumberIsJudgedWithItsUnit) {
  EXPECT_EQ(answer("speed", {"2 rad/s"}).code, 0);
  EXPECT_EQ(answer("speed", {"19.1 rpm"}).code, 0);
  EXPECT_THAT(answer("speed", {"2000"}).out, HasSubstr("too large by a factor of 1000"));
  const ProgramRun comma = answer("speed", {"2,0"});
  EXPECT_EQ(comma.code, 2);
  EXPECT_THAT(comma.err, HasSubstr("a comma is not read in numbers"));
  for (int i = 0; i < 2; ++i) answer("speed", {"--hint"});
  EXPECT_EQ(answer("speed", {"--hint"}).out, "The answer is 2 rad/s. It is given.\n");
}

TEST_F(Answer, ADamagedLogIsSetAside) {
  answer("which", {"B"});
  write_text(log(), "{\"format\":1,\"answers\":{\"quiz/which\":");
  const ProgramRun run = answer("which", {"B"});
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("damaged"));
  EXPECT_TRUE(std::filesystem::exists(log().string() + ".damaged"));
  EXPECT_EQ(logged()["quiz/which"]["tries"], 1);
}

// HOSTILE F2: of 40 answers that were given at once 3 to 12 were kept.
TEST_F(Answer, AllThatAreGivenAtOnceAreKept) {
  constexpr int kAnswers = 40;
  std::vector<std::thread> learners;
  std::vector<int> codes(kAnswers, -1);
  for (int i = 0; i < kAnswers; ++i)
    learners.emplace_back([&, i] {
      const ProgramRun run = i % 2 == 0 ? answer("which", {"A"}) : answer("sign", {"I1"});
      codes[static_cast<std::size_t>(i)] = run.code;
    });
  for (std::thread& learner : learners) learner.join();
  EXPECT_THAT(codes, testing::Each(4));
  EXPECT_EQ(logged()["quiz/which"]["tries"], kAnswers / 2);
  EXPECT_EQ(logged()["quiz/sign"]["tries"], kAnswers / 2);
}

TEST_F(Answer, ALogThatCannotBeReadTakesNoVerdictAway) {
  answer("which", {"B"});
  write_text(log(), "{\"format\":2}");
  const ProgramRun run = answer("which", {"B"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out, "right\n");
  EXPECT_THAT(run.err, HasSubstr("another version"));
  EXPECT_THAT(run.err, HasSubstr("not kept"));
  EXPECT_EQ(text_of(log()), "{\"format\":2}");
}

// A reset has no verdict to protect: what it was to do is not done.
TEST_F(Answer, AResetThatCannotBeDoneIsAnError) {
  write_text(folder_ / "state", "a file");
  const ProgramRun run = answer("sign", {"--reset"});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("cannot make"));
  EXPECT_THAT(run.err, ::testing::Not(HasSubstr("not kept")));
  RunOptions homeless;
  homeless.environment = {{"XDG_STATE_HOME", ""}, {"HOME", ""}};
  const ProgramRun nowhere = answer("sign", {"--reset"}, homeless);
  EXPECT_EQ(nowhere.code, 1);
  EXPECT_THAT(nowhere.err, HasSubstr("neither XDG_STATE_HOME nor HOME is set"));
}

TEST_F(Answer, AHintThatCannotBeNotedIsGivenAllTheSame) {
  write_text(folder_ / "state", "a file");
  const ProgramRun run = answer("sign", {"--hint"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out, "Hint 1 of 2: Use I sub 1.\n");
  EXPECT_THAT(run.err, HasSubstr(": the hint is not noted\n"));
}

TEST_F(Answer, NobodyWaitsForTheVerdictWhileAnotherHoldsTheLog) {
  using namespace std::chrono_literals;
  std::filesystem::create_directories(log().parent_path());
  std::optional held(StateLock::take(log(), 0ms));
  ASSERT_TRUE(*held);
  RunOptions options;
  options.stdout_to = (folder_ / "out").string();
  options.while_running = [&](pid_t) {
    const auto patience = std::chrono::steady_clock::now() + kAnswerPatience / 2;
    while (text_of(options.stdout_to).empty() && std::chrono::steady_clock::now() < patience)
      std::this_thread::sleep_for(10ms);
    EXPECT_EQ(text_of(options.stdout_to).substr(0, 7), "A is no") << "before the lock was given back";
    held.reset();
  };
  const ProgramRun run = answer("which", {"A"}, options);
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, IsEmpty());
  EXPECT_EQ(logged()["quiz/which"]["tries"], 1);
}

TEST_F(Answer, TheLineThatAsksForAHintCanBeCopied) {
  EXPECT_THAT(answer("sign", {"I1"}).out,
              HasSubstr("A hint: polhode answer " + lesson_.string() + " quiz sign --hint\n"));
  const auto plain = lesson_;
  lesson_ = folder_ / "it's a quiz; $HOME.md";
  std::filesystem::copy(plain, lesson_);
  EXPECT_THAT(answer("sign", {"I1"}).out,
              HasSubstr("A hint: polhode answer '" + (folder_ / "it'\\''s a quiz; $HOME.md").string() +
                        "' quiz sign --hint\n"));
  for (const char* name : {"\x1b[31mquiz.md",
                           "quiz\x9b"
                           "31m.md"}) {
    lesson_ = folder_ / name;
    std::filesystem::copy(plain, lesson_);
    const ProgramRun run = answer("sign", {"I1"});
    EXPECT_EQ(run.code, 4);
    EXPECT_THAT(run.out, ::testing::Not(HasSubstr("A hint"))) << "what does not show as it is is not offered";
    EXPECT_EQ((run.out + run.err).find_first_of("\x1b\x9b"), std::string::npos) << run.out << run.err;
  }
}

/// Two moments of a window's copy, and what lies in the file by then.
AnswerLog merged(AnswerLog there, const AnswerLog& before, const AnswerLog& now) {
  merge_answers(there, before, now);
  return there;
}

TEST(AnswerLogs, OfTwoProcessesAddUp) {
  const AnswerRecord before{0, 2, 1, "a"}, there{1, 5, 2, "b"};  // three tries and a hint of another process
  EXPECT_EQ(merged({{"q", there}}, {{"q", before}}, {{"q", before}}), (AnswerLog{{"q", there}}));
  EXPECT_EQ(merged({{"q", there}}, {{"q", before}}, {{"q", {0, 3, 3, "c"}}}),
            (AnswerLog{{"q", {1, 6, 3, "c"}}}));
  EXPECT_EQ(merged({{"q", there}}, {{"q", before}}, {{"q", {0, 3, 1, "c"}}}),
            (AnswerLog{{"q", {1, 6, 2, "c"}}}));
}

// A was right, `polhode answer L S A --reset` forgot it, and then the window was given an answer to B.
TEST(AnswerLogs, WhatAnotherProcessForgotStaysForgotten) {
  const AnswerRecord a{1, 2, 2, "w1"}, b{0, 1, 0, "w2"};
  EXPECT_EQ(merged({}, {{"A", a}}, {{"A", a}, {"B", b}}), (AnswerLog{{"B", b}}));
  EXPECT_EQ(merged({}, {{"A", a}}, {{"A", {1, 3, 2, "w3"}}}), (AnswerLog{{"A", {0, 1, 0, "w3"}}}))
      << "only what was answered since, which was wrong";
  EXPECT_EQ(merged({}, {{"A", a}}, {{"A", {2, 3, 2, "w1"}}}), (AnswerLog{{"A", {1, 1, 0, "w1"}}}))
      << "or right";
}

TEST(AnswerLogs, WhatThisProcessForgotIsForgotten) {
  const AnswerRecord a{1, 2, 2, "w1"};
  EXPECT_EQ(merged({{"A", a}, {"B", a}}, {{"A", a}}, {}), (AnswerLog{{"B", a}}));
}

TEST_F(Answer, IsJsonIfAskedFor) {
  const ProgramRun run = answer("sign", {"w1*w9", "--json"});
  EXPECT_EQ(run.code, 2);
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["verdict"], "unreadable");
  EXPECT_EQ(json["column"], 4);
  EXPECT_TRUE(json["counterexample"].is_null());
  EXPECT_EQ(Json::parse(answer("sign", {"I1", "--json"}).out)["verdict"], "wrong");
}

TEST_F(Answer, EchoesNothingThatSteersATerminal) {
  const ProgramRun unreadable = answer("sign", {"w1 + \x1b[31m"});
  EXPECT_EQ(unreadable.code, 2);
  EXPECT_THAT(unreadable.out, HasSubstr("  w1 + \\u001b[31m\n       ^\n"));
  for (const ProgramRun& run :
       {unreadable, answer("\x1b[2J", {"w1"}),
        answer("sign", {"\xc2\x9b"
                        "31m"}),
        polhode({"info", "\x1b[2J"}), polhode({"lint", "\x1b[2J"}), polhode({"\x1b[2J"})}) {
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ((run.out + run.err).find_first_of("\x1b\x9b"), std::string::npos) << run.out << run.err;
  }
}

TEST_F(Answer, SaysWhichQuestionsThereAre) {
  const ProgramRun run = answer("sing", {"w1"});
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("did you mean \"sign\"?"));
  EXPECT_EQ(answer("sign", {}).code, 2);
  EXPECT_EQ(answer("sign", {"w1", "--hint"}).code, 2);
}

TEST_F(Answer, WithoutAHomeTheVerdictIsGivenAllTheSame) {
  RunOptions options;
  options.environment = {{"XDG_STATE_HOME", ""}, {"HOME", ""}};
  const ProgramRun run = polhode({"answer", (folder_ / "quiz.md").string(), "quiz", "which", "2"}, options);
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("not kept"));
}

}  // namespace
}  // namespace polhode
