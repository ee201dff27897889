// SPDX-License-Identifier: MIT
#include "base/sha256.h"
#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace polhode {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

/// A lesson, and a folder of state for each student.
class Answers : public ::testing::Test {
 protected:
  ProgramRun run(const std::vector<std::string>& arguments, const std::string& student = "me") {
    RunOptions options;
    options.environment = {{"XDG_STATE_HOME", (folder_ / student).string()},
                           {"POLHODE_LESSONS", folder_.path().string()}};
    return polhode(arguments, options);
  }
  std::string in_folder(const std::string& name) const { return (folder_ / name).string(); }
  std::string report(const std::string& student, const std::string& sign, const std::string& choice) {
    run({"answer", "quiz", "quiz", "sign", sign}, student);
    run({"answer", "quiz", "quiz", "which", choice}, student);
    const std::string file = in_folder(student + ".txt");
    const ProgramRun written = run({"answers", "quiz", "--report", file, "--name", student}, student);
    EXPECT_EQ(written.code, 0) << written.err;
    return file;
  }

  void SetUp() override {
    write_text(
        folder_ / "quiz.md",
        "+++\nformat = 1\nid = \"quiz\"\ntitle = \"Quiz\"\noutcomes = ['know signs', 'know more']\n+++\n"
        "# Quiz {quiz}\nAsk.\n\n"
        "```ask sign\ntype = \"expression\"\nprompt = 'The y component?'\n"
        "answer = \"w3*w1*(I1 - I3)\"\nhints = ['Use $I_1$.']\noutcome = 1\n```\n"
        "```ask which\ntype = \"choice\"\nprompt = 'Which?'\nchoices = ['one', 'two']\nanswer = 2\n```\n");
  }
  ScratchFolder folder_;
};

TEST_F(Answers, AreShownForEachOutcomeAndQuestion) {
  run({"answer", "quiz", "quiz", "sign", "--hint"});
  run({"answer", "quiz", "quiz", "sign", "w1*w3*(I3 - I1)"});
  run({"answer", "quiz", "quiz", "sign", "w1*w3*(I1 - I3)"});
  const ProgramRun shown = run({"answers", "quiz"});
  EXPECT_EQ(shown.code, 0) << shown.err;
  EXPECT_EQ(
      shown.out,
      "quiz: 1 of 2 right\n\nOutcomes\n   1 of 1   know signs\n   0 of 1   (other questions)\n\nQuestions\n"
      "  right         quiz/sign: 2 tries, 1 hint\n"
      "  not answered  quiz/which\n");
}

TEST_F(Answers, AreForgottenWithoutAQuestion) {
  run({"answer", "quiz", "quiz", "sign", "w1"});
  run({"answer", "quiz", "quiz", "which", "B"});
  const ProgramRun forgotten = run({"answers", "quiz", "--reset"});
  EXPECT_EQ(forgotten.code, 0) << forgotten.err;
  EXPECT_EQ(forgotten.out, "quiz: 2 questions were forgotten\n");
  EXPECT_THAT(run({"answers", "quiz"}).out, HasSubstr("quiz: 0 of 2 right\n"));
  EXPECT_EQ(run({"answers", "quiz", "--reset"}).out, "quiz: 0 questions were forgotten\n");
}

TEST_F(Answers, AreHandedInAsAText) {
  run({"answer", "quiz", "quiz", "which", "A"});
  const ProgramRun nameless = run({"answers", "quiz", "--report", "-"});
  EXPECT_EQ(nameless.code, 0) << nameless.err;
  EXPECT_THAT(nameless.out, AllOf(StartsWith("Answers to a lesson of polhode"), Not(HasSubstr("Name:")),
                                  HasSubstr("  answer: A\n  reasons: choice-A 1\n")));
  EXPECT_EQ(run({"answers", "quiz", "--report", "-", "--name", "two\nlines"}).code, 2);
}

TEST_F(Answers, OfAClassAreCollected) {
  const std::string anna = report("Anna", "w1*w3*(I1 - I3)", "B"),
                    ben = report("Ben", "w1*w3*(I3 - I1)", "A");
  const ProgramRun csv = run({"answers", "collect", anna, ben, "--csv"});
  EXPECT_EQ(csv.code, 0) << csv.err;
  EXPECT_THAT(csv.err, IsEmpty());
  EXPECT_EQ(
      csv.out,
      "student,file,right,answered,asked,quiz/sign,quiz/sign tries as reported,quiz/sign hints as reported,"
      "quiz/which,quiz/which tries as reported,quiz/which hints as reported\nAnna," +
          anna + ",2,2,2,right,1,0,right,1,0\nBen," + ben + ",0,2,2,wrong,1,0,wrong,1,0\n");
  EXPECT_EQ(run({"answers", "collect", anna, ben, "--reasons"}).out,
            "quiz/sign: 1 of 2 right\n  1 of 2: all signs are the other way round\n"
            "quiz/which: 1 of 2 right\n  1 of 2: A was chosen (\"one\")\n");
  EXPECT_EQ(run({"answers", "collect", anna, ben, "--csv", "-o", in_folder("class.csv")}).out, "");
  EXPECT_EQ(text_of(in_folder("class.csv")), csv.out);
  EXPECT_THAT(run({"answers", "collect", anna, ben}).out,
              AllOf(HasSubstr("    2          0             0  Anna\n"),
                    HasSubstr("    1          1             0  quiz/sign\n")));
}

TEST_F(Answers, ThatCannotBeCollectedGetALineEach) {
  const std::string anna = report("Anna", "w1*w3*(I1 - I3)", "B");
  write_text(in_folder("cut.txt"), text_of(anna).substr(0, 200));
  write_text(in_folder("letter.txt"), "Dear Sir\n");
  const ProgramRun run_of_all = run({"answers", "collect", in_folder("none.txt"), in_folder("cut.txt"), anna,
                                     in_folder("letter.txt"), anna, folder_.path().string(), "--csv"});
  EXPECT_EQ(run_of_all.code, 4);
  EXPECT_THAT(run_of_all.out, HasSubstr("\nAnna,"));
  EXPECT_THAT(
      run_of_all.err,
      AllOf(HasSubstr("none.txt: cannot be read: No such file or directory: skipped\n"),
            HasSubstr("cut.txt: the end of the file, with its checksum, is missing: skipped\n"),
            HasSubstr("letter.txt: no report of polhode"), HasSubstr("Anna.txt: the newest report of Anna: "),
            HasSubstr(folder_.path().string() + ": cannot be read: it is a folder: skipped\n")));
  EXPECT_EQ(std::count(run_of_all.err.begin(), run_of_all.err.end(), '\n'), 5);
}

TEST_F(Answers, ThatAreNotRightMakeAClassNotWhole) {
  std::string text = text_of(report("Ben", "w1*w3*(I1 - I3)", "A"));
  const std::size_t at = text.find("not right, tries 1");
  ASSERT_NE(at, text.npos);
  text.replace(at, 9, "right");
  // Who can write a new checksum can write this.
  const std::size_t end = text.find("Checksum: ");
  text.replace(end + 10, 16, sha256_hex(text.substr(0, end)).substr(0, 16));
  write_text(in_folder("forged.txt"), text);
  const ProgramRun collected = run({"answers", "collect", in_folder("forged.txt"), "--csv"});
  EXPECT_EQ(collected.code, 4);
  EXPECT_THAT(collected.err, HasSubstr("quiz/which is said to be right, and its answer is not"));
  EXPECT_THAT(collected.out, HasSubstr("wrong"));
}

TEST_F(Answers, AreReadFromRegularFilesAlone) {
  const std::string pipe = in_folder("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string anna = report("Anna", "w1*w3*(I1 - I3)", "B");
  const ProgramRun collected = run({"answers", "collect", pipe, "/dev/zero", anna});
  EXPECT_EQ(collected.code, 4);
  EXPECT_THAT(collected.err, AllOf(HasSubstr("pipe: cannot be read: it is no regular file: skipped\n"),
                                   HasSubstr("/dev/zero: cannot be read: it is no regular file: skipped\n")));
  EXPECT_THAT(collected.out, HasSubstr("Anna\n"));
}

TEST_F(Answers, OfAnotherVersionOfTheLessonAreSkipped) {
  const std::string anna = report("Anna", "w1*w3*(I1 - I3)", "B");
  write_text(folder_ / "quiz.md", text_of(folder_ / "quiz.md") + "\nMore.\n");
  const ProgramRun run_of_all = run({"answers", "collect", anna, "--csv"});
  EXPECT_EQ(run_of_all.code, 4);
  EXPECT_THAT(run_of_all.err, HasSubstr("a report of another version of the lesson: "));
}

TEST_F(Answers, RefuseOptionsThatDoNotGoTogether) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"answers"}, "LESSON"},
      {{"answers", "quiz", "maze"}, "unexpected argument \"maze\""},
      {{"answers", "quiz", "--csv"}, "are of polhode answers collect"},
      {{"answers", "quiz", "--name", "A"}, "--name is of --report"},
      {{"answers", "quiz", "--reset", "--report", "-"}, "not both"},
      {{"answers", "collect"}, "name the reports"},
      {{"answers", "collect", "a.txt", "--reset"}, "collect takes"},
      {{"answers", "qiz"}, "did you mean \"quiz\""}};
  for (const auto& [arguments, wanted] : cases) {
    const ProgramRun refused = run(arguments);
    EXPECT_EQ(refused.code, 2) << wanted;
    EXPECT_THAT(refused.err, HasSubstr(wanted));
  }
}

// A file that somebody calls so, and a name that a spreadsheet would compute.
TEST_F(Answers, AreNoFormulas) {
  const std::string sum = report("=SUM(A1)", "w1", "A");
  EXPECT_THAT(run({"answers", "collect", sum, "--csv"}).out, HasSubstr("\n'=SUM(A1),"));
}

}  // namespace
}  // namespace polhode
