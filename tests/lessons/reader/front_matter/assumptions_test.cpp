// SPDX-License-Identifier: MIT
#include "lessons/reader/front_matter/assumptions.h"

#include "lessons/reader/checks/claim_check.h"
#include "tests/lessons/support.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// A lesson with these tables in its front matter, from line 5 on, and this stage.
std::string lesson(const std::string& tables, const std::string& body) {
  return "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n" + tables +
         "[body.top]\nmoments = [0.09, 0.09, 0.005]\n+++\n# Sample {sample}\n" + body;
}

constexpr const char* kTop =
    "[constants]\nmgl = { value = 2.5, tex = 'mg\\ell', say = 'weight times lever', unit = 'N m' }\n"
    "[define]\nu = { means = 'dot(ez, e3)', tex = 'u' }\nE = { means = 'T + mgl*u', tex = 'E' }\n"
    "[symbols]\nez = { tex = '\\hat e_z' }\n"
    "[assume]\nsymmetric = 'I2 = I1'\nheavy = ['N = mgl*cross(ez, e3)']\n";

/// What reading and proving a lesson say.
std::vector<std::string> faults(const std::string& text) {
  LessonReading reading = read_lesson(text, "a.md");
  if (!reading.lesson) return testing::lines_of(reading.diagnostics);
  EXPECT_FALSE(prove_claims(*reading.lesson));
  return testing::lines_of(check_claims(*reading.lesson, "a.md"));
}

std::string math(const std::string& opening, const std::string& tex) {
  return "```math " + opening + "\n" + tex + "\n```\n";
}

struct Wrong {
  std::string tables, body, says;
};

TEST(Assumptions, ServeFormulasClaimsAndQuestions) {
  EXPECT_THAT(faults(lesson(kTop, math("a motion given heavy", R"(\frac{dE}{dt} = 0)"))), IsEmpty());
  EXPECT_THAT(faults(lesson(kTop, math("a motion given symmetric heavy", R"(\dot\omega_3 = 0)"))), IsEmpty());
  EXPECT_THAT(faults(lesson(kTop, math("a motion given heavy", R"(\dot\omega_3 = 0)"))),
              ElementsAre(HasSubstr("the claim (motion) fails: this does not hold: at I = ")));
  EXPECT_THAT(faults(lesson(kTop, math("a motion", R"(\frac{dE}{dt} = 0)"))),
              ElementsAre(HasSubstr("fails")));
  EXPECT_THAT(faults(lesson(kTop, math("a", "x") + "```claim a free given symmetric in-other-words\n"
                                                   "dw3 = 0\n```\n")),
              IsEmpty());
  const std::string ask =
      "```ask a\ntype = 'expression'\nprompt = 'What?'\nanswer = '(I1 - I3)/I1*w2*w3'\nmodulo = 'free'\n"
      "given = 'symmetric'\n```\n";
  const LessonReading reading = read_lesson(lesson(kTop, ask), "a.md");
  ASSERT_TRUE(reading.lesson) << ::testing::PrintToString(testing::lines_of(reading.diagnostics));
  const Ask& question = *blocks_of<Ask>(reading.lesson->stages[0].steps[0]).front();
  std::string told;
  for (const TextSpan& span : question.prompt_text.back().spans) told += span.text;
  EXPECT_EQ(told, "Given: I_2 = I_1.");
  const auto mark = [&](const std::string& answer) {
    return judge_answer(question, answer, Prover(), &reading.lesson->notation.vocabulary).mark;
  };
  EXPECT_EQ(mark("(I2 - I3)/I1*w2*w3"), AnswerJudgement::Mark::right) << "I2 is I1";
  EXPECT_EQ(mark("(I3 - I1)/I1*w2*w3"), AnswerJudgement::Mark::wrong);
  EXPECT_EQ(mark("(I1 - I3)/I1*w2*w3*E/(T + mgl*u)"), AnswerJudgement::Mark::right) << "the lesson's words";
}

// The examples of FORMAT.md between second rates and inequalities, in a lesson of their own.
TEST(Assumptions, ServeTheReferencesSecondRatesAndInequalities) {
  const std::string format = testing::read_file(test::source_dir() / "lessons/FORMAT.md");
  const std::size_t begin = format.find("```math wobble");
  ASSERT_NE(begin, format.npos);
  const std::string examples = format.substr(begin, format.find("\n````\n", begin) + 1 - begin);
  EXPECT_THAT(faults(lesson(kTop, examples)), IsEmpty());
  EXPECT_NE(examples.find("\\ge"), examples.npos);
  // What is neither proved nor refuted is warned of, and never called proved.
  const std::string motzkin =
      R"(\omega_1^4\omega_2^2 + \omega_1^2\omega_2^4 + \omega_3^6 \ge 3\omega_1^2\omega_2^2\omega_3^2)";
  EXPECT_THAT(faults(lesson(kTop, math("a identity", motzkin))),
              ElementsAre(AllOf(HasSubstr("warning: this is not proved"), HasSubstr(" states"))));
  EXPECT_THAT(faults(lesson(kTop, math("a identity", R"(T > 0)"))), ElementsAre(HasSubstr("fails")));
  EXPECT_THAT(faults(lesson(kTop, math("a measured", R"(T > 0)"))), ElementsAre(HasSubstr("inequality")));
  EXPECT_THAT(faults(lesson(kTop, math("a identity", R"(\vec L > 0)"))),
              ElementsAre(HasSubstr("only of numbers")));
}

constexpr const char* kNear = "[assume]\nnear = { small = ['w1', 'w3'], order = 1 }\nsteep = 'I3 > I1'\n";
constexpr const char* kLinear =
    R"(\ddot\omega_1 \approx \frac{(I_2 - I_3)(I_1 - I_2)}{I_1 I_3}\,\omega_2^2\,\omega_1)";

// The example of FORMAT.md under "What holds to first order", in a lesson of its own.
TEST(Assumptions, ServeTheReferencesClaimsToAnOrder) {
  const std::string format = testing::read_file(test::source_dir() / "lessons/FORMAT.md");
  const std::size_t begin = format.find("[assume]\nnear = "), fence = format.find("```math near-axis-two");
  ASSERT_NE(begin, format.npos);
  ASSERT_NE(fence, format.npos);
  const std::string table = format.substr(begin, format.find("+++", begin) - begin);
  const std::string example = format.substr(fence, format.find("\n````\n", fence) + 1 - fence);
  EXPECT_THAT(faults(lesson(table, example)), IsEmpty());
}

TEST(Assumptions, ServeClaimsToAnOrder) {
  EXPECT_THAT(faults(lesson(kNear, math("a free given near", kLinear))), IsEmpty());
  EXPECT_THAT(faults(lesson(kNear, math("a free given near", R"(\dot\omega_2 \approx 0)"))), IsEmpty());
  EXPECT_THAT(
      faults(lesson(kNear, math("a", "x") + "```claim a free given near in-other-words\n"
                                            "I2*w2^2 ~= 2*T\nL ~= I2*w2*e2 + I1*w1*e1 + I3*w3*e3\n```\n")),
      IsEmpty());
  EXPECT_THAT(faults(lesson(kNear, math("a identity given near steep", R"(2T \approx I_2\omega_2^2)"))),
              IsEmpty());
  EXPECT_THAT(faults(lesson(kNear, math("a false given near", R"(T \approx I_2\omega_2^2)"))), IsEmpty());
  EXPECT_THAT(
      faults(lesson(kNear, math("a free given near", R"(\ddot\omega_1 \approx \omega_2^2\,\omega_1)"))),
      ElementsAre(AllOf(HasSubstr("the claim (free) fails: this does not hold to first order"),
                        HasSubstr("ω = (ε, 1, 0)"))));
  EXPECT_THAT(faults(lesson(kNear, math("a motion given near", R"(\dot\omega_2 \approx 0)"))),
              ElementsAre(HasSubstr("its kind is free")));
  EXPECT_THAT(
      faults(lesson(kNear, math("a identity given near", R"(\omega_1\omega_3 \approx 2\omega_1\omega_3)"))),
      ElementsAre(HasSubstr("both sides are zero to that order: it says nothing")));
  EXPECT_THAT(faults(lesson(kNear, math("a free given steep", R"(I_3 - I_1 > 0)"))), IsEmpty());
}

TEST(Assumptions, WhatIsSaidOfWhatIsSmallIsChecked) {
  const std::string assume = "[assume]\n";
  const auto near = [&](const std::string& keys) { return assume + "a = { " + keys + " }\n"; };
  const auto proof = [](const std::string& tex) { return math("a identity given near", tex); };
  const Wrong cases[] = {
      {near("small = ['w1'], order = 0"), "",
       "6:31: error: \"order\" is a whole number from 1 to 4, found 0"},
      {near("small = ['w1'], order = 5"), "",
       "6:31: error: \"order\" is a whole number from 1 to 4, found 5"},
      {near("small = ['w1'], order = 'two'"), "",
       "6:31: error: \"order\" is a whole number from 1 to 4, found a string"},
      {near("small = ['w1'], order = 1.0"), "", "6:31: error: \"order\" is a whole number"},
      {near("small = ['w1']"), "", "6:5: error: this does not say to which order in what is small"},
      {near("order = 1"), "", "6:5: error: this does not say what is small"},
      {near(""), "", "6:5: error: this does not say what is small"},
      {near("small = [], order = 1"), "", "6:15: error: nothing is small here"},
      {near("small = ['w4'], order = 1"), "",
       "error: what can be small is w1 w2 w3, N, N1 N2 N3, h or k: \"w4\""},
      {near("small = ['T'], order = 1"), "", "\"T\" is none of them"},
      {near("small = ['w1', 'w1'], order = 1"), "", "\"w1\" is small already"},
      {near("small = ['N', 'N1'], order = 1"), "", "\"N1\" is small already"},
      {near("small = 3, order = 1"), "", "6:15: error:"},
      {near("smal = ['w1'], order = 1"), "", "6:5: error: this does not say what is small"},
      {assume + "a = ['I1 > I2', 'I2 > I1']\n", "", "6:5: error: these inequalities leave no room"},
      {assume + "a = 'L > 0'\n", "", "6:6: error: of two vectors none is the greater"},
      {assume + "a = 'dw1 > 0'\n", "", "6:6: error: an assumption holds at an instant: it has no rates"},
      {assume + "a = 'norm(L) > 0'\n", "", "6:6: error: a proof has no roots"},
      {assume + "a = 'I3 > T'\n", "", "6:6: error: units disagree"},
      {assume + "a = 'I3 > '\n", "", "6:10: error: an expression is missing here"},
      {assume + "a = 'I3 > I4'\n", "", "6:11: error:"},
      {assume + "a = 'I1 > I2'\nb = 'I2 > I1'\n", math("a free given a b", "T = T"),
       "no body is as these assumptions together say"},
      {kNear, proof("T = T"), "write \\approx: with what is given it holds to first order only"},
      {kNear, math("a", "x") + "```claim a identity given near\nT = T\n```\n",
       "write ~=: with what is given"},
      {kNear, math("a", "x") + "```claim a identity given near\nT ~ T\n```\n",
       "write ~= for what is approximately"},
      {kNear, proof(R"(T \ge 0)"), "an inequality is not proved to an order"},
      {kNear, proof(R"(|\vec L| \approx |\vec L|)"), "a length is a root"},
      {"", math("a identity", R"(T \approx T)"), "nothing is small here"},
      {"", math("a", "x") + "```claim a identity\nT ~= T\n```\n", "nothing is small here"},
      {kNear, math("a measured given near", R"(T \approx T)"), "within a tolerance that is said"},
      {kNear, math("a motion given near", R"(\omega_1 = 0 \Rightarrow T \approx 0)"), ""},
      {assume + "a = { small = ['w1'], order = 1 }\nb = 'w1 = 0'\n",
       math("a identity given a b", R"(T \approx T)"), "what is small is set already, by \"w1 = 0\""},
      {assume + "a = { small = ['w1'], order = 1 }\nb = { small = ['w3'], order = 2 }\n",
       math("a identity given a b", R"(T \approx T)"), "\"b\" is of another order"},
      {assume + "a = { small = ['N1'], order = 1 }\n", math("a free given a", R"(T \approx T)"),
       "the kind free says that there is none"},
      {kNear, "```ask a\ntype = 'expression'\nprompt = 'What?'\nanswer = 'T'\ngiven = 'near'\n```\n",
       "it is given nothing that is small"},
  };
  for (const Wrong& c : cases) {
    const auto said = faults(lesson(c.tables, c.body.empty() ? "Text.\n" : c.body));
    ASSERT_FALSE(said.empty()) << c.tables << c.body;
    EXPECT_THAT(said.front(), HasSubstr(c.says)) << c.tables << c.body;
  }
}

TEST(Assumptions, FormulasShowTheWordsOfTheLesson) {
  EXPECT_THAT(faults(lesson(kTop, math("a definition", R"(E = T + mg\ell\,u)"))), IsEmpty());
  EXPECT_THAT(faults(lesson(kTop, math("a definition", R"(E = T - mg\ell\,u)"))),
              ElementsAre(HasSubstr("fails")));
  EXPECT_THAT(faults(lesson(kTop, math("a definition", R"(u = \hat e_z\cdot\hat e_3)"))), IsEmpty());
}

TEST(Assumptions, WhatIsWrongIsSaidWhereItStands) {
  const std::string assume = "[assume]\n";
  const Wrong cases[] = {
      {assume + "a = 'I2'\n", "",
       "6:6: error: an assumption reads quantity = expression, there is no = here"},
      {assume + "a = 'I4 = I1'\n", "", "6:6: error: what is assumed is that a quantity is something: \"I4\""},
      {assume + "a = 'I2 = I1 + e1'\n", "", "6:14: error: a scalar and a vector cannot be added"},
      {assume + "a = 'N = T'\n", "", "6:6: error: \"N\" is a vector, and this is a scalar"},
      {assume + "a = ['I2 = I1', 'I1 = I2']\n", "", "6:18: error: what is set here is used by \"I2 = I1\""},
      {assume + "a = 'I2 = 0*I1'\n", "", "6:5: error: no body is like this"},
      {assume + "a = []\n", "", "6:5: error: nothing is assumed here"},
      {assume + "a = 3\n", "", "6:5: error:"},
      {assume + "'a b' = 'I2 = I1'\n", "", "6:1: error: bad name of an assumption"},
      {"assume = 3\n", "", "5:10: error: \"assume\" takes a table"},
      {assume + "sym = 'I2 = I1'\n", math("a free given sim", "T = T"), "unknown assumption \"sim\""},
      {"", math("a free given sim", "T = T"), "(the front matter has no [assume])"},
      {assume + "a = 'I2 = I1'\n", math("a free given a a", "T = T"), "\"a\" is given twice"},
      {assume + "a = 'I2 = I1'\nb = 'I2 = I3'\n", math("a free given a b", "T = T"),
       "\"b\" does not go with what stands before it: this is set already"},
      {assume + "a = 'I2 = I1'\nb = 'I3 = 3*I1'\n", math("a free given a b", "T = T"),
       "no body is as these assumptions together say"},
      {assume + "a = 'N = h*omega'\n", math("a free given a", "T = T"),
       "the kind free says that there is none"},
      {assume + "a = 'w1 = 0'\n", math("a free given a", R"(\dot\omega_1 = 0)"), "says nothing of rates"},
      {assume + "a = 'I2 = I1'\n", math("a free given", "T = T"), "this fence opens with"},
      {"[constants]\ng = 'x'\n", "", "6:5: error:"},
      {"[constants]\ng = inf\n", "", "6:5: error:"},
      {"[constants]\nomega = 3\n", "", "6:1: error: bad name \"omega\": expressions have this word already"},
      {"[constants]\ng = { tex = 'g' }\n", "", "6:1: error: constant \"g\" lacks \"value\""},
      {"[define]\na = 'b'\nb = 'T'\n", "", "6:6: error: \"b\" is defined further down"},
      {"[define]\na = 'a + 1'\n", "", "6:6: error: \"a\" is defined further down"},
      {"[define]\na = 'T + e1'\n", "", "6:8: error: a scalar and a vector cannot be added"},
      {"[define]\na = { tex = 'a' }\n", "", "6:1: error: definition \"a\" lacks \"means\""},
      {"[constants]\na = 1\n[define]\na = 'T'\n", "", "8:1: error: \"a\" is a constant already, or defined"},
      {"[define]\na = { means = 'T', tex = 'a' }\n[symbols]\na = { tex = 'b' }\n", "",
       "8:1: error: symbol \"a\" is there already"},
      {"[define]\na = 'T'\n[symbols]\na = { tex = 'a', means = 'T' }\n", "", "has a meaning already, above"},
      {"define = 3\n", "", "5:10: error: \"define\" takes a table"},
      {"[define]\nE = 'T + w1'\n", "", "6:1: error: \"E\": units disagree: kg m²/s² and 1/s are added"},
      {"[define]\nE = { means = '2*T', unit = 'kg m²/s' }\n", "",
       "6:29: error: units disagree: \"E\" is in kg m²/s², and this is kg m²/s"},
      {"[symbols]\nL = { tex = '\\vec L', unit = 'N m' }\n", "", "units disagree: \"L\" is in kg m²/s"},
      {"[constants]\nc = { value = 2, unit = 'kg' }\n[assume]\na = 'N = c*omega'\n", "",
       "8:6: error: units disagree: \"N\" is in kg m²/s², this is in kg/s"},
  };
  for (const Wrong& c : cases) {
    const auto said = faults(lesson(c.tables, c.body.empty() ? "Text.\n" : c.body));
    ASSERT_FALSE(said.empty()) << c.tables << c.body;
    EXPECT_THAT(said.front(), HasSubstr(c.says)) << c.tables << c.body;
  }
}

// 2026-11-23: what a reviewer found accepted.
TEST(Assumptions, NothingFalseIsPrintedAsProved) {
  const std::string E = "[define]\nE = { means = 'T + 1*T', tex = 'E' }\n";
  const auto define = [](const std::string& tex) {
    return "[define]\nX = { means = '0*T', tex = '" + tex + "' }\n";
  };
  const Wrong cases[] = {
      {E + "X = { means = '0*T', tex = '\\frac{dE}{dt}' }\n", "", "has a sign that formulas use otherwise"},
      {E + "X = { means = '0*T', tex = '\\dot E' }\n", "", "has a sign that formulas use otherwise"},
      {define("\\dot{\\vec L}"), "", "is known already: it is ddt(L)"},
      {define("\\tan\\theta"), "", "has a sign that formulas use otherwise"},
      {define("T^{}"), "", "X\" "},
      {define("\\overset{}{T}"), "", "has a sign that formulas use otherwise"},
      {define("E\\quad"), "", "has a sign that formulas use otherwise"},
      {define("\\omega_\\text{1}"), "", "X\" "},
      {define("\\phantom{x}"), "", "has a sign that formulas use otherwise"},
      {"[constants]\ng = { value = 2, tex = 'g' }\nX = { value = 5, tex = 'g^2' }\n", "",
       "is known already: the other symbols make it g^2"},
      {"[constants]\ng = { value = 2, tex = 'g' }\nX = { value = 5, tex = 'm g' }\n", "", "is known already"},
      {"[assume]\na = 'N = cross(omega, L)'\n",
       math("a false given a", R"(\frac{d\vec L}{dt} = 0\quad(\vec N = 0))"), "put it into [assume]"},
      {"[assume]\na = 'w1 = w2'\n", math("a false given a", R"(\omega_1 = 0\quad(\omega_2 = 0))"),
       "put it into [assume]"},
      {"[constants]\nb = 1\n[assume]\na = 'I3 = I1 + I2 + (I1 - I2)^2/I1'\n",
       math("a false given a", R"(I_1 = I_2)"), "no possible body was found"},
      {"[assume]\na = 'I2 = I1'\n",
       math("a identity given a", R"(I_2 = I_1 = \live{I1})") + "```scene\nbody = 'book'\n```\n",
       "a computed number is of a motion on which what is given does not hold at t = "},
  };
  for (const Wrong& c : cases) {
    const auto said = faults(lesson(c.tables, c.body.empty() ? "Text.\n" : c.body));
    ASSERT_FALSE(said.empty()) << c.tables << c.body;
    EXPECT_THAT(said.front(), HasSubstr(c.says)) << c.tables << c.body;
  }
}

TEST(Assumptions, DefinitionsTogetherAreNotTooLong) {
  std::string tables = "[define]\na0 = 'w1 + w2'\n", sum = "a0";
  for (int n = 1; n < 10; ++n)
    tables +=
        "a" + std::to_string(n) + " = 'a" + std::to_string(n - 1) + " + a" + std::to_string(n - 1) + "'\n";
  for (int n = 0; n < 9; ++n) tables += "b" + std::to_string(n) + " = 'a9 + w1'\n";
  const auto said = faults(lesson(tables, "Text.\n"));
  ASSERT_FALSE(said.empty());
  EXPECT_THAT(said.front(), HasSubstr("at most 20000 parts"));
}

TEST(Assumptions, TooManyConstantsAreRefused) {
  std::string tables = "[constants]\n";
  for (std::size_t n = 0; n <= kMaxConstants; ++n) tables += "c" + std::to_string(n) + " = 1\n";
  EXPECT_THAT(faults(lesson(tables, "Text.\n")), ElementsAre(HasSubstr("a lesson has at most 16 constants")));
}

TEST(Assumptions, WhatIsMeasuredHasToBeMeasuredWhereTheyHold) {
  const auto measured = [](const std::string& body_and_torque) {
    return faults(lesson(kTop,
                         "```math a measured given symmetric heavy\n\\frac{dE}{dt} = 0\n```\n"
                         "```scene\nomega = [1, 0.5, 30]\nattitude = [0.8, 0.6, 0, 0]\n" +
                             body_and_torque + "```\n"));
  };
  EXPECT_THAT(measured("body = 'top'\ntorque = 'heavy:2.5,0,0,1'\nduration = 0.5\n"), IsEmpty());
  EXPECT_THAT(measured("body = 'top'\ntorque = 'heavy:2.6,0,0,1'\nduration = 0.5\n"),
              ElementsAre(HasSubstr("on which what is given does not hold")));
  EXPECT_THAT(measured("body = 'book'\ntorque = 'heavy:2.5,0,0,1'\nduration = 0.5\n"),
              ElementsAre(HasSubstr("on which what is given does not hold")));
}

}  // namespace
}  // namespace polhode
