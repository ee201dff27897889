// SPDX-License-Identifier: MIT
#include "app/session/saved/answer_file.h"

#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace polhode {
namespace {

using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

AnswerJudgement wrong(const std::string& tag) {
  AnswerJudgement judgement;
  judgement.mark = AnswerJudgement::Mark::wrong;
  judgement.tag = tag;
  return judgement;
}
AnswerJudgement right() {
  AnswerJudgement judgement;
  judgement.mark = AnswerJudgement::Mark::right;
  return judgement;
}

TEST(AnswerRecord, KeepsWhyAnswersWereWrongAndWhichOneWasRight) {
  AnswerRecord record;
  note_judged(record, wrong("sign"), "-w1");
  note_judged(record, wrong("sign"), "-w1*1");
  note_judged(record, right(), "w1");
  note_judged(record, wrong(""), "w2");
  EXPECT_EQ(record.tries, 4);
  EXPECT_EQ(record.last, "w2");
  EXPECT_EQ(record.accepted, "w1");
  EXPECT_THAT(record.wrong, UnorderedElementsAre(Pair("sign", 2), Pair("other", 1)));
}

TEST(AnswerLogFile, GivesBackWhatWasKept) {
  const ScratchFolder folder;
  const auto path = folder / "quiz.answers.json";
  AnswerRecord record;
  note_judged(record, wrong("index"), "w2");
  note_judged(record, right(), "w1");
  ASSERT_TRUE(change_answer_log(path, [&](AnswerLog& log) { log["a/b"] = record; }));
  EXPECT_EQ(read_answer_log(path)->log, (AnswerLog{{"a/b", record}}));
}

TEST(AnswerLogFile, OfBeforeReasonsWereKeptIsRead) {
  const ScratchFolder folder;
  const auto path = folder / "quiz.answers.json";
  write_text(path,
             R"({"format": 1, "answers": {"a/b": {"right": true, "tries": 2, "hints": 1, "last": "w1"},)"
             R"("a/c": {"right": false, "tries": 1, "hints": 0, "last": "w2"}}})");
  const auto reading = read_answer_log(path);
  ASSERT_TRUE(reading);
  EXPECT_THAT(reading->warning, IsEmpty());
  EXPECT_EQ(reading->log.at("a/b"), (AnswerRecord{1, 2, 1, "w1", "w1", {}}));
  EXPECT_EQ(reading->log.at("a/c"), (AnswerRecord{0, 1, 0, "w2", "", {}}));
}

TEST(AnswerLogFile, IsReadByAProgramThatKnowsNoReasons) {
  const ScratchFolder folder;
  const auto path = folder / "quiz.answers.json";
  AnswerRecord record;
  note_judged(record, wrong("index"), "w2");
  ASSERT_TRUE(change_answer_log(path, [&](AnswerLog& log) { log["a/b"] = record; }));
  const auto json = nlohmann::json::parse(text_of(path));
  EXPECT_EQ(json.at("format"), 1);
  const auto& entry = json.at("answers").at("a/b");
  EXPECT_EQ(entry.at("right"), false);
  EXPECT_EQ(entry.at("tries"), 1);
  EXPECT_EQ(entry.at("hints"), 0);
  EXPECT_EQ(entry.at("last"), "w2");
}

TEST(AnswerLogFile, PassesOverReasonsThatAreNone) {
  const ScratchFolder folder;
  const auto path = folder / "quiz.answers.json";
  write_text(path,
             R"({"format": 1, "answers": {"a/b": {"right": false, "tries": 2, "hints": 1, "last": "w1",)"
             R"("wrong": {"=1+1": 3, "sign": 1e300, "index": -4}}}})");
  EXPECT_THAT(read_answer_log(path)->log.at("a/b").wrong,
              UnorderedElementsAre(Pair("sign", 1'000'000), Pair("index", 0)));
}

// The window and `polhode answer` at the same time.
TEST(MergedAnswers, AddUpReasonsThatBothHaveNoted) {
  const AnswerLog before{{"a/b", {0, 1, 0, "x", "", {{"sign", 1}}}}};
  AnswerLog here = before, there = before;
  note_judged(here["a/b"], wrong("sign"), "y");
  note_judged(there["a/b"], wrong("index"), "z");
  note_judged(there["a/b"], right(), "w1");
  AnswerLog log = here;
  merge_answers(log, before, there);
  EXPECT_EQ(log.at("a/b"), (AnswerRecord{1, 4, 0, "w1", "w1", {{"index", 1}, {"sign", 2}}}));
}

}  // namespace
}  // namespace polhode
