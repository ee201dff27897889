// SPDX-License-Identifier: MIT
// polhode lint on lessons that are out to hurt it: it says what is wrong and where, in bounded time.
#include "lessons/reader/checks/lint_budget.h"
#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

namespace polhode {
namespace {

using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

std::string lesson_with(const std::string& front, const std::string& body) {
  return "+++\nformat = 1\nid = \"hard\"\ntitle = \"Hard\"\n" + front + "+++\n" + body;
}

std::string scene(const std::string& keys) { return "# One {one}\nWords.\n\n```scene\n" + keys + "\n```\n"; }

/// CPU seconds of all children that have ended.
double cpu_of_children_s() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

struct Linted {
  Json json;  ///< empty array: nothing is wrong
  int code = -1;
  double cpu_s = 0;
  std::string messages() const {
    std::string all;
    for (const Json& one : json)
      all += one["message"].get<std::string>() + "; " + one["hint"].get<std::string>() + '\n';
    return all;
  }
};

Linted linted(const std::string& text) {
  const ScratchFolder scratch;
  write_text(scratch / "hard.md", text);
  const double before_s = cpu_of_children_s();
  const ProgramRun run = polhode({"lint", "--json", scratch / "hard.md"});
  Linted result{Json::parse(run.out, nullptr, false), run.code, cpu_of_children_s() - before_s};
  EXPECT_TRUE(result.json.is_array()) << run.out << run.err;
  for (const Json& one : result.json) {
    EXPECT_GE(one["line"], 1);
    EXPECT_GE(one["column"], 1);
  }
  return result;
}

constexpr const char* kCurves =
    "show = [\"polhode-family\", \"polhode\", \"separatrix\", \"herpolhode\", \"cones\", "
    "\"energy-ellipsoid\", \"omega\", \"L\", \"plane\"]\n";

/// Of NAME.de.md, beside NAME.md if that has a text.
ProgramRun linted_beside(const std::string& translation, const std::string& original,
                         const std::string& name = "spin.de.md") {
  const ScratchFolder scratch;
  write_text(scratch / name, translation);
  if (!original.empty()) write_text(scratch / "spin.md", original);
  return polhode({"lint", scratch / name});
}

TEST(Lint, HoldsATranslationAgainstItsOriginal) {
  const std::string original = lesson_with("", "# One {one}\nAt 0.5 s it is $T$.\n");
  const std::string german = lesson_with("language = \"de\"\n", "# Eins {one}\nBei 0,5 s ist es $T$.\n");
  EXPECT_THAT(linted_beside(german, original).err, HasSubstr("0 errors, 0 warnings"));
  const ProgramRun wrong =
      linted_beside(lesson_with("language = \"de\"\n", "# Eins {one}\nBei 0,6 s ist es $T$.\n"), original);
  EXPECT_EQ(wrong.code, 3);
  EXPECT_THAT(wrong.out, HasSubstr("lacks the number \"0.5\" that stands in "));
  EXPECT_THAT(linted_beside(german, "").out, HasSubstr("the lesson that this one translates is missing: "));
  EXPECT_THAT(linted_beside(original, original).out, HasSubstr("another language than the lesson's, \"en\""));
  EXPECT_THAT(linted_beside(german, "", "alone.md").out,
              HasSubstr("warning: what the sentences of this lesson say"));
}

TEST(Lint, NearlyEqualMomentsAreABody) {
  for (const char* middle :
       {"1.0000000000000002", "1.0000000000000004", "1.0000000000000009", "1.000000000000001"}) {
    const Linted found =
        linted(lesson_with(std::string("[body.near]\nmoments = [1.0, ") + middle + ", 1.5]\n",
                           scene(std::string("body = \"near\"\nomega = [0.3, 1.0, 0.2]\n") + kCurves)));
    EXPECT_EQ(found.code, 0) << middle << found.messages();
  }
}

TEST(Lint, AHugeOrTinyAngularVelocityIsOneOrHasADiagnostic) {
  for (const char* omega :
       {"[1e160, 1.0, 1e160]", "[1e300, 1e300, 1e300]", "[1.7e308, 0, 0]", "[1e-160, 1e-161, 1e-160]",
        "[1e-300, 1e-300, 1e-300]", "[1.7e308, 1.7e308, 1.7e308]", "[4e-324, 0, 0]"}) {
    const Linted found = linted(lesson_with("", scene(std::string("omega = ") + omega + "\n" + kCurves)));
    EXPECT_THAT(found.messages(), Not(HasSubstr("chord tolerance"))) << omega;
    const bool is_extreme = std::string(omega).find("7e308, 1.7") != std::string::npos ||
                            std::string(omega).find("4e-324") != std::string::npos;
    EXPECT_EQ(found.code, is_extreme ? 3 : 0) << omega << found.messages();
    if (!is_extreme) continue;
    EXPECT_THAT(found.messages(), HasSubstr("to be drawn"));
  }
}

TEST(Lint, OfAHugeAngularVelocityThereIsAPicture) {
  const ScratchFolder scratch;
  for (const char* omega :
       {"[1e160, 1.0, 1e160]", "[1e300, 1e300, 1e300]", "[1.7e308, 0, 0]", "[1e-300, 1e-300, 1e-300]"}) {
    write_text(scratch / "hard.md", lesson_with("", scene(std::string("omega = ") + omega + "\n" + kCurves)));
    const ProgramRun run =
        polhode({"export", scratch / "hard.md", "-o", scratch / omega, "--size", "320x240"});
    EXPECT_EQ(run.code, 0) << omega << run.err;
  }
}

TEST(Lint, WhatExportRefusesItRefusesWithATrueReason) {
  const std::string euler =
      "motion = { method = \"explicit-euler\", step = 0.01 }\nat = 1e4\nshow = [\"omega\"]";
  const Linted ghost = linted(lesson_with("", scene(euler)));
  EXPECT_EQ(ghost.code, 3);
  EXPECT_THAT(ghost.messages(),
              testing::AllOf(HasSubstr("cannot be computed at t = 10000"), Not(HasSubstr("torque"))));
  for (const char* keys : {"motion = { method = \"dormand-prince-8\" }\nat = 1e9\nshow = [\"omega\"]",
                           "torque = \"heavy:1e9,0,0,1\"\nat = 1e9\nshow = [\"omega\"]",
                           "torque = \"damping:1e300\"\nat = 1e9\nshow = [\"omega\"]"}) {
    const Linted found = linted(lesson_with("", scene(keys)));
    EXPECT_EQ(found.code, 3) << keys;
    EXPECT_THAT(found.messages(), HasSubstr("the scene of stage \"one\" cannot be")) << keys;
  }
}

/// The budget is in evaluations, some 50 ns each where the machine is quiet; sanitizers and other users make
/// them slower, so that this sees only what is not counted at all.
constexpr double kMostCpu_s = double(kLintBudget) * 50e-9 * 12;

void expect_bounded(const std::string& name, const std::string& text, int code) {
  const Linted found = linted(text);
  testing::Test::RecordProperty("cpu_s_" + name, std::to_string(found.cpu_s));
  EXPECT_EQ(found.code, code) << name << found.messages();
  EXPECT_LT(found.cpu_s, kMostCpu_s) << name;
}

TEST(LintBudget, HoldsForMeasuredClaimsUnderAViolentTorque) {
  std::string body = scene("torque = \"heavy:1e3,0,0,1\"\nduration = 1e6\nshow = [\"omega\"]");
  body += "```math a\nx\n```\n```claim a measured\nddt(L) = N\n```\n";
  expect_bounded("heavy", lesson_with("", body), 3);
}

TEST(LintBudget, HoldsForManyStagesOfMeasuredClaims) {
  std::string body;
  for (int stage = 0; stage < 100; ++stage) {
    body += "# Stage {s" + std::to_string(stage) +
            "}\n```scene\nshow = [\"omega\"]\nduration = 100\nmotion = { method = \"rk4\", step = 1e-4 }\n"
            "omega = [0.1, " +
            std::to_string(1 + stage) + ", 0.2]\n```\n```math a\nx\n```\n```claim a measured\n";
    for (int line = 0; line < 64; ++line)
      body += "ddt(L) = N within 0.0" + std::to_string(10 - line % 9) + "\n";
    body += "```\n";
  }
  const Linted found = linted(lesson_with("", body));
  EXPECT_EQ(found.code, 3);
  EXPECT_THAT(found.messages(), HasSubstr("too long to check"));
  EXPECT_GT(found.json.back()["line"], 20);
  EXPECT_LT(found.cpu_s, kMostCpu_s);
}

TEST(LintBudget, HoldsForManySteps) {
  std::string body;
  for (int stage = 0; stage < 200; ++stage) {
    body += "# Stage {s" + std::to_string(stage) + "}\nWords.\n";
    for (int step = 1; step < 100; ++step) body += "\n---\n\nMore.\n";
  }
  const Linted found = linted(lesson_with("", body));
  EXPECT_EQ(found.code, 3);
  EXPECT_THAT(found.messages(), HasSubstr("too long to check"));
  EXPECT_LT(found.cpu_s, kMostCpu_s);
}

#if defined(__SANITIZE_ADDRESS__)
constexpr double kSlower = 12;  // measured: to set formulas is mostly to allocate
#else
constexpr double kSlower = 1;
#endif

// Each formula is some ten bytes, stands for `length` letters, and is set again on the pages of later steps.
TEST(LintBudget, HoldsForFormulasThatMacrosMakeLong) {
  for (const auto& [length, steps] : {std::pair(16384, 20), std::pair(16384, 5), std::pair(1024, 80)}) {
    const std::string macros = "[macros]\na = '" + std::string(static_cast<std::size_t>(length / 8), 'x') +
                               "'\nd = '\\a\\a\\a\\a\\a\\a\\a\\a'\n";
    std::string body = "# One {one}\nWord $\\d$ word.\n";
    for (int step = 1; step < steps; ++step) body += "\n---\n\nWord $\\d$ word.\n";
    const Linted found = linted(lesson_with(macros, body));
    testing::Test::RecordProperty("cpu_s_" + std::to_string(length) + "_" + std::to_string(steps),
                                  std::to_string(found.cpu_s));
    EXPECT_LT(found.cpu_s, kSlower * kMostCpu_s / 3) << length << ", " << steps << found.messages();
  }
}

TEST(Lint, OfAFileThatIsNotThereTheJsonIsJsonToo) {
  EXPECT_TRUE(Json::parse(polhode({"lint", "--json", "no-such-lesson"}).out).is_array());
  EXPECT_TRUE(Json::parse(polhode({"lint", "--json", "./no/such.md"}).out).is_array());
}

TEST(Lint, EchoesNothingThatSteersATerminal) {
  const ScratchFolder scratch;
  const std::string front =
      "\"\\u001b[31mRED\\u0007\" = 1\n[symbols]\n\"\\u202eL\" = { role = \"\\u009b31m\", say = "
      "\"\\u001b[31mred\" }\n"
      "[body.\"\\u0000x\"]\nmoments = [1, 1, 1]\n";
  write_text(scratch / "hard.md", lesson_with(front, "# One {one}\nWords.\n"));
  for (const char* json : {"", "--json"}) {
    std::vector<std::string> words = {"lint", scratch / "hard.md"};
    if (*json) words.emplace_back(json);
    const ProgramRun run = polhode(words);
    EXPECT_EQ(run.code, 3);
    for (const char* bad : {"\x1b", "\x07", "\xe2\x80\xae", "\xc2\x9b"}) {
      EXPECT_THAT(run.out, Not(HasSubstr(bad))) << json;
      EXPECT_THAT(run.err, Not(HasSubstr(bad))) << json;
    }
    EXPECT_EQ(run.out.find('\0'), std::string::npos);
    EXPECT_THAT(run.out, HasSubstr("\\u001b[31mRED")) << json;
    if (*json == '\0') continue;
    EXPECT_TRUE(Json::parse(run.out).is_array());
  }
}

TEST(Lint, HoldsWhatALessonSaysOfOthersAgainstThem) {
  const ScratchFolder scratch;
  const auto lesson = [](const std::string& id, const std::string& front, const std::string& body) {
    return "+++\nformat = 1\nid = \"" + id + "\"\ntitle = \"X\"\n" + front + "+++\n# One {one}\n" + body +
           '\n';
  };
  write_text(scratch / "other.md", lesson("other", "", "Words.\n\n```math eq\nx\n```"));
  write_text(scratch / "broken.md", lesson("broken", "", "[x](#nowhere)"));
  write_text(scratch / "this.md",
             lesson("this", "next = \"othr\"\n",
                    "[a](other#one) [b](other#one/eq) [c](other#two) [d](other#one/eqq) [e](broken#one)"));
  const ProgramRun run = polhode({"lint", scratch / "this.md"});
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.out, HasSubstr("this.md:5:8: warning: no lesson \"othr\" is beside this one; did you mean "
                                 "\"other\"? (so what refers to it is not checked)\n"));
  EXPECT_THAT(run.out, HasSubstr("this.md:8:35: error: lesson \"other\" has no stage \"two\""));
  EXPECT_THAT(run.out,
              HasSubstr("this.md:8:50: error: stage \"one\" of lesson \"other\" has no equation \"eqq\" "
                        "(did you mean \"eq\"?)"));
  EXPECT_THAT(run.out, HasSubstr("this.md:8:69: warning: lesson \"broken\" has errors itself"));
  EXPECT_THAT(run.err, HasSubstr("2 errors, 2 warnings"));
}

}  // namespace
}  // namespace polhode
