// SPDX-License-Identifier: MIT
// Words around numbers that passed though the motion says otherwise: of which body, of all times, between
// what, and what is asked for. Each was found by an attacker.
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace polhode {
namespace {

using testing::complaints_of;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kTables =
    "[body.brick]\nmoments = [1.0, 2.0, 2.9]\ndraw = \"box\"\n"
    "[body.slab]\nmoments = [2.0, 3.0, 4.9]\ndraw = \"box\"\n";

std::vector<std::string> complaints_about(const std::string& body, const std::string& keys) {
  return complaints_of(body + "\n\n```scene\nbody = \"brick\"\nomega = [0.1, 3.0, 0.1]\n" + keys + "\n```\n",
                       kTables);
}

/// T is 9.0195 J of the brick, 13.5345 J of the slab.
std::vector<std::string> of_two(const std::string& body) {
  return complaints_about(
      body, "scenes = [{ body = \"brick\", caption = \"a\" }, { body = \"slab\", caption = \"b\" }]");
}

TEST(NumbersOfSeveralBodies, AreThoseOfTheOneThatIsNamed) {
  for (const char* body :
       {R"(The second body has the energy $\live[unit={J}]{T}$.)",
        R"(The energy of the second body is $\live[unit={J}]{T}$.)",
        R"(The slab has the energy $\live[unit={J}]{T}$.)", R"(The slab's energy is $\live[unit={J}]{T}$.)",
        "The energy of the second body is 9.02 J.", "The second body has 9.02 J.",
        "The body on top turns slowly, the right picture has 9.02 J.", "The slab has the energy 9.02 J.",
        "The second body has $T = 9.02$ J.", "The second scene has $I_1 = 1$ kg m².",
        "The first body has $I_1 = 2$ kg m²."})
    EXPECT_THAT(of_two(body), Not(IsEmpty())) << body;
}

TEST(NumbersOfSeveralBodies, AreOfAnyWhereNoneIsNamedAlone) {
  for (const char* body :
       {R"(The first body has the energy $\live[unit={J}]{T}$.)", "The second body has 13.5 J.",
        R"(The brick has the energy $\live[unit={J}]{T}$, and that of the slab is larger.)",
        R"(In both the rate is $\live[unit={rad/s}]{w2}$: the second body has $\live[unit={rad/s}]{w2}$.)",
        "The second body has the energy 13.5 J, the first 9.02 J.",
        "The first body turns more slowly than the second body: its energy is 9.02 J.",
        "The brick has 9.02 J and the slab has 13.5 J.", "The second component is 3 rad/s."})
    EXPECT_THAT(of_two(body), IsEmpty()) << body;
}

TEST(Ranges, HoldAllAlong) {
  const std::string keys = "show = [\"omega\"]\nduration = 20";
  for (const char* body :
       {"The angular speed stays between 2.9 rad/s and 3.1 rad/s.",
        R"($\omega_2$ stays between 2 and 3 rad/s.)", R"($\omega_2$ stays between $2$ and $3$.)",
        R"($\omega_2$ lies between 2 and 4 rad/s.)", "The energy stays between 9.1 J and 10 J.",
        "The angular speed stays below 2.9 rad/s.", R"(Here $\omega_2 > 2$ at all times.)",
        "The spin about axis 2 is always 3 rad/s.", "The spin about axis 2 stays 3 rad/s."})
    EXPECT_THAT(complaints_about(body, keys), Not(IsEmpty())) << body;
  for (const char* body :
       {R"($\omega_2$ stays between $-3.1$ and $3.1$.)", R"($\omega_2$ stays between −3.1 and 3.1 rad/s.)",
        "The energy stays between 9 J and 10 J.", "The energy is always 9.02 J.",
        R"($\omega_2$ is between 2 and 4 rad/s.)", R"(Here $\omega_2 < 4$ at all times.)"})
    EXPECT_THAT(complaints_about(body, keys), IsEmpty()) << body;
}

// At the still, t = 4 s, ω₂ is −2.69 rad/s.
TEST(Captions, AreTrueAsLongAsTheirFilmPlaysOrAsItBegins) {
  const std::string scene = "show = [\"omega\"]\nat = 4\nduration = 20\ncaption = '";
  for (const char* caption :
       {R"(Here $\omega_2 = -2.69$ rad/s)", R"(The spin is $\value[unit={rad/s}]{-2.69}{w2}$)",
        "The rate about axis 2 is −2.69 rad/s", R"(Here $\omega_2 < 0$)"}) {
    const std::string keys = scene + caption + "'\n";
    EXPECT_THAT(complaints_about("Text.", keys), Not(IsEmpty())) << caption;
    EXPECT_THAT(complaints_about("Text.", keys + "caption_when = \"still\""), IsEmpty()) << caption;
  }
  for (const char* caption :
       {R"($\omega_2 = 3$ rad/s)", R"(Begins with $\omega_2 = 3$ rad/s)",
        R"(The energy is $\value[unit={J}]{9.02}{T}$)", "The energy is 9.02 J",
        R"(With $\omega_2 = 3$ rad/s)", R"(At 4 s the spin is $\value[unit={rad/s}]{-2.69}{w2}$)",
        R"(At $t = 0$ there is $\omega_2 = 3$ rad/s)", R"(Now $\omega_2 = \live[unit={rad/s}]{w2}$)"})
    EXPECT_THAT(complaints_about("Text.", scene + caption + "'"), IsEmpty()) << caption;
  EXPECT_THAT(complaints_about("Text.", scene + "The spin about axis 2 is always 3 rad/s'"), Not(IsEmpty()));
}

TEST(Questions, ThatSayWhatIsToBeFoundAskForTheirAnswer) {
  const auto asked = [](const std::string& prompt, const std::string& answer) {
    return complaints_about("Text.\n\n```ask q\ntype = \"number\"\nprompt = '" + prompt + "'\nanswer = \"" +
                                answer + "\"\nunit = \"J\"\nhints = [\"a\"]\n```\n",
                            "show = [\"omega\"]");
  };
  for (const char* prompt : {"Find the kinetic energy.", "Compute the kinetic energy in J.",
                             "Determine the energy, in this motion.", "Give $T$ in J."}) {
    EXPECT_THAT(asked(prompt, "2*T"), Not(IsEmpty())) << prompt;
    EXPECT_THAT(asked(prompt, "T"), IsEmpty()) << prompt;
  }
  EXPECT_THAT(asked("Find a spin of twice this energy.", "2*T"), IsEmpty());
}

TEST(LettersWithAnIndex, AreWhatTheLetterIsAsTheMotionBegins) {
  const auto said = [](const std::string& text) {
    return complaints_about(text, "show = [\"omega\"]\nat = 4\nduration = 20");
  };
  for (const char* text :
       {"At the start $T_0 = 5$ J.", "Here $T_0 = 2T$.", R"(Here $|\vec L| = 7$, $\omega_0 = 4$.)"})
    EXPECT_THAT(said(text), Not(IsEmpty())) << text;
  for (const char* text : {"At the start $T_0 = 9.02$ J.", "Here $T_0 = T$.", R"(Here $\zeta_0 = 5$.)"})
    EXPECT_THAT(said(text), IsEmpty()) << text;
  // Nor is it the letter, in whatever words that is claimed.
  const std::string claim = "```claim a identity in-other-words\n2*T = dot(omega, L)\n```\n";
  for (const char* tex : {R"(2T_0 = \vec\omega\cdot\vec L)", R"(2T_0 = \langle\vec\omega, \vec L\rangle)"})
    EXPECT_THAT(complaints_about("```math a\n" + std::string(tex) + "\n```\n" + claim, "show = [\"omega\"]"),
                Not(IsEmpty()))
        << tex;
  EXPECT_THAT(complaints_about("```math a\n2T = \\langle\\vec\\omega, \\vec L\\rangle\n```\n" + claim,
                               "show = [\"omega\"]"),
              IsEmpty());
}

// 2026-11-28, four holes of the sixth attacker.
TEST(Questions, OfTheMotionAloneHaveItsNumber) {
  const auto asked = [](const std::string& prompt, const char* answer) {
    return complaints_about("Text.\n\n```ask q\ntype = \"number\"\nprompt = '" + prompt +
                                "'\nanswer = " + answer + "\nunit = \"J\"\nhints = [\"a\"]\n```\n",
                            "show = [\"omega\"]");
  };
  EXPECT_THAT(asked("What is $T$?", "5"), Not(IsEmpty()));
  EXPECT_THAT(asked("What is $T$?", "9.02"), IsEmpty());
  EXPECT_THAT(asked("A body has 3 rad/s. What is its $T$?", "5"), IsEmpty()) << "that of another one";
  EXPECT_THAT(asked("What is $T$ at $t = 3$ s?", "\"T\""), IsEmpty());
  EXPECT_THAT(asked("What is $I_1\\omega_1^2$ at $t = 3$ s?", "\"I1*w1^2\""), Not(IsEmpty()))
      << "of the still, t = 0";
}

TEST(Bounds, ThatNeverFailHoldAllAlong) {
  const auto said = [](const std::string& text) {
    return complaints_about(text, "show = [\"omega\"]\nduration = 20");  // ω₁ comes to 3.5 rad/s
  };
  for (const char* text :
       {R"($\omega_1$ never exceeds 0.2 rad/s.)", R"($\omega_1$ is always below 0.2 rad/s.)",
        R"($\omega_2$ never falls below 2 rad/s.)", R"($\omega_1$ does not exceed 0.05 rad/s.)"})
    EXPECT_THAT(said(text), Not(IsEmpty())) << text;
  for (const char* text :
       {R"($\omega_1$ never exceeds 4 rad/s.)", R"($\omega_1$ is always below 4 rad/s.)",
        R"($\omega_2$ never falls below $-4$ rad/s.)", R"($\omega_1$ does not exceed 0.2 rad/s.)"})
    EXPECT_THAT(said(text), IsEmpty()) << text;
}

TEST(Questions, ThatAskInOtherWordsHaveTheirAnswer) {
  const auto asked = [](const std::string& type, const std::string& prompt, const std::string& rest) {
    return complaints_about("Text.\n\n```ask q\ntype = \"" + type + "\"\nprompt = '" + prompt +
                                "'\nbecause = \"So.\"\n" + rest + "```\n",
                            "show = [\"omega\"]");
  };
  const std::string right = "answer = \"(I2-I3)/I1*w2*w3\"\nmodulo = \"free\"\nhints = [\"Look.\"]\n",
                    wrong = "answer = \"(I3-I2)/I1*w2*w3\"\nmodulo = \"free\"\nhints = [\"Look.\"]\n";
  for (const char* prompt :
       {R"(Solve for $\dot\omega_1$.)", R"(Write down $\dot\omega_1$.)",
        R"(Express $\dot\omega_1$ in terms of the moments and $\omega_2$, $\omega_3$.)"}) {
    EXPECT_THAT(asked("expression", prompt, wrong), Not(IsEmpty())) << prompt;
    EXPECT_THAT(asked("expression", prompt, right), IsEmpty()) << prompt;
  }
  const std::string choices =
                        "\n- [x] $\\vec L\\cdot\\vec L/I_1$\n- [ ] $\\vec\\omega\\cdot\\vec L$\n  No.\n",
                    others = "\n- [ ] $\\vec L\\cdot\\vec L/I_1$\n  No.\n- [x] $\\vec\\omega\\cdot\\vec L$\n";
  EXPECT_THAT(asked("choice", "Which of these equals $2T$?", "hints = [\"Look.\"]\n" + choices),
              Not(IsEmpty()));
  EXPECT_THAT(asked("choice", "Which of these equals $2T$?", "hints = [\"Look.\"]\n" + others), IsEmpty());
  const std::string falling = "hints = [\"Look.\"]\n\n1. $I_3$\n2. $I_2$\n3. $I_1$\n";
  EXPECT_THAT(asked("order", "Put them in ascending order.", falling), Not(IsEmpty()));
  EXPECT_THAT(asked("order", "Put them in descending order.", falling), IsEmpty());
}

TEST(Equations, ThatAClaimCallsFalseAreNotSo) {
  const std::string refuted = "```math a false\n\\dot\\omega_3 = 0\n```\n";
  EXPECT_THAT(complaints_about(refuted + R"(Hence $\dot\omega_3 = 0$ for this brick.)", "show = [\"omega\"]"),
              Not(IsEmpty()));
  EXPECT_THAT(complaints_about(refuted + R"(It is not so that $\dot\omega_3 = 0$.)", "show = [\"omega\"]"),
              IsEmpty());
}

// The block spins about axis 2 alone at first: of most rates 0 = 0 is all that can be told then.
TEST(Equations, AreNotToldByWhatIsNothing) {
  const auto said = [](const std::string& text) {
    return complaints_of(text +
                             "\n\n```scene\nbody = \"brick\"\nomega = [0, 3, 0]\ntorque = \"body:0.3,0,0\"\n"
                             "duration = 10\nshow = [\"omega\"]\n```\n",
                         kTables);
  };
  for (const char* text :
       {R"(Here $\omega_1 = -\frac{L_1}{I_1}$.)", R"(Here $\dot\omega_3 = \frac{L_1L_2}{I_3}$.)"})
    EXPECT_THAT(said(text), Not(IsEmpty())) << text;
  for (const char* text :
       {R"(Here $\omega_1 = \frac{L_1}{I_1}$.)", R"(At the start $\omega_1 = -\frac{L_1}{I_1}$.)",
        R"(At the start $\omega_1 = 0$.)"})
    EXPECT_THAT(said(text), IsEmpty()) << text;
}

// A reviewer's honest lines.
TEST(HonestLines, AreNotRefused) {
  const std::string keys = "show = [\"omega\"]\nduration = 20";
  for (const char* text :
       {R"(At the start $\omega_2 = 3$ rad/s and the energy stays the same.)",
        "The energy lies between 9000 and 10000 mJ.", R"($\omega_2$ swings between $3.1$ and $-3.1$ rad/s.)",
        R"($\omega_2$ is at most 3 rad/s.)"})
    EXPECT_THAT(complaints_about(text, keys), IsEmpty()) << text;
  for (const char* text : {R"(The energy $\live[unit={J}]{T}$ is less than that of the slab.)",
                           R"(Unlike the slab it has the energy $\live[unit={J}]{T}$.)"})
    EXPECT_THAT(of_two(text), IsEmpty()) << text;
}

TEST(ClaimsBesideWhatIsNotRead, HaveItsMinusSigns) {
  const auto beside = [](const std::string& tex, const std::string& line) {
    return complaints_about("```math a\n" + tex + "\n```\n```claim a motion\n" + line + "\n```\n",
                            "show = [\"L\"]");
  };
  EXPECT_THAT(beside(R"(dT = -\vec N\cdot\vec\omega\,dt)", "ddt(T) = dot(N, omega)"), Not(IsEmpty()));
  EXPECT_THAT(beside(R"(dT = \vec N\cdot\vec\omega\,dt)", "ddt(T) = dot(N, omega)"), IsEmpty());
  EXPECT_THAT(beside(R"(\langle\vec\omega, \vec L\rangle^{-1}(-2T) = -1)", "-2*T/dot(omega, L) = -1"),
              IsEmpty());
}

TEST(ComputedNumbers, OfOneDigitAreNotFarOff) {
  for (const char* text : {R"($I_3/I_1 = \value{3}{I3/I1}$)", R"($\omega_2 = \value[unit={rad/s}]{3}{w2}$)"})
    EXPECT_THAT(complaints_about(text, "show = [\"omega\"]"), IsEmpty()) << text;
  for (const char* text : {R"($I_3/I_1 = \value{3}{0.9*I3/I1}$)", R"($c = \value{1}{w2/5}$)"})
    EXPECT_THAT(complaints_about(text, "show = [\"omega\"]"), Not(IsEmpty())) << text;
}

TEST(Inequalities, ThatNoStateRefutesAreMeasured) {
  EXPECT_THAT(complaints_about(R"(The brick has $\omega_2 < 1$ rad/s.)", "show = [\"omega\"]"),
              Not(IsEmpty()));
  EXPECT_THAT(complaints_about(R"(The brick has $\omega_2 < 100$ rad/s.)", "show = [\"omega\"]"), IsEmpty());
}

}  // namespace
}  // namespace polhode
