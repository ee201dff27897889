// SPDX-License-Identifier: MIT
// What a lesson states in passing, in words and formulas of which nothing is called proved.
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace polhode {
namespace {

using testing::complaints_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kTables =
    "[body.plate]\nmoments = [1.0, 2.0, 2.9]\ndraw = \"box\"\n"
    "[symbols]\nomega = { tex = '\\vec\\omega', say = \"angular velocity\", unit = \"rad/s\" }\n"
    "[constants]\ngiant = { value = 20, say = \"mass of a giant\", unit = \"kg\" }\n";

std::vector<std::string> complaints_about(const std::string& body, const std::string& keys = "") {
  return complaints_of(body +
                           "\n\n```scene\nbody = \"plate\"\nomega = [0.5, 3, 0.7]\nat = 0.2\n"
                           "show = [\"energy-ellipsoid\", \"omega\", \"L\"]\n" +
                           keys + "\n```\n",
                       kTables);
}

void expect_false(const std::vector<std::string>& bodies) {
  for (const std::string& body : bodies) EXPECT_THAT(complaints_about(body), Not(IsEmpty())) << body;
}
void expect_true(const std::vector<std::string>& bodies) {
  for (const std::string& body : bodies) EXPECT_THAT(complaints_about(body), IsEmpty()) << body;
}

std::string math(const std::string& kind, const std::string& tex) {
  return "```math a " + kind + "\n" + tex + "\n```\n";
}

// 2026-11-24: a part that is true was printed inside of what is false, with a tick.
TEST(ProvedParts, AreJoinedToNothing) {
  const std::string part = R"(\proved{2T = \vec\omega\cdot\vec L})";
  expect_false({math("identity", part + R"( = |\vec L|^2)"), math("identity", "T = " + part),
                math("identity", "-" + part), math("identity", R"(\frac{1}{)" + part + "}"),
                math("identity", R"(\cancel{)" + part + "}"), math("identity", R"(\boxed{)" + part + "} = 0"),
                math("identity", R"(\text{not } )" + part),
                math("identity", R"(\left()" + part + R"(\right) = 0)"),
                math("identity", part + R"(\quad\Rightarrow\quad \zeta = 0)"),
                math("identity", part + R"(\quad (\omega_1 = 0))"), math("identity", part + R"(\,+\,1)"),
                math("identity", R"(\underbrace{)" + part + R"(}_{= |\vec L|})"),
                math("identity", R"(\zeta = 0 \quad\text{since}\quad )" + part),
                math("free", part + R"(,\quad \frac{d\vec\omega}{dt} = 0)")});
  expect_true({math("identity", part + R"(\,,\quad \zeta = 0)"),
               math("identity", "&" + part + R"(\,, \\ &\zeta = \sum_n \eta_n)"),
               math("identity", part + R"(\quad\text{and}\quad \zeta = \eta.)")});
}

// 2026-11-24: "= 0" was true of all that is less than a half.
TEST(Statements, InWholeNumbersAreNotRoundedToThem) {
  expect_false({math("", R"(\vec\omega\times\vec L = 0)"), "Here $\\dot\\omega_1 = 0$.",
                "It has $I_3 = 3$ kg m².", "Here $I_3 - I_2 = 1$ kg m²."});
  expect_true({"It has $I_2 = 2$ kg m².", "It has $I_3 - I_2 = 0.9$ kg m²."});
}

TEST(Statements, ThatAreNotSoAreErrors) {
  expect_false({R"(The energy is $T = 1$ J.)", R"(It is $T = 1\,\text{J}$.)", R"(Here $I_1 = 5$ kg m².)",
                R"(Here $I_1 = 5 I_2$.)", R"(Here $I_1 > I_2$.)", R"(Here $2T = \vec\omega\cdot\vec\omega$.)",
                R"(So $\vec L = 2$.)", R"(It has $\omega = 2$ rad/s.)", math("", "2T = I_1"),
                math("", R"(T = 1\,\text{J})"), "> [!note] Always $T = 0$.\n"});
  expect_true({R"(Here $I_2 = 2 I_1$ and $I_1 < I_2$.)", R"(If $\omega_1 = 0$, it is a steady spin.)",
               R"(At $\omega_1 = 0$ it turns.)", R"(Is $T = 0$?)", R"(Not so $T = 0$.)",
               R"(At first $\omega_2 = 3$ rad/s.)", R"(Here $2T = \vec\omega\cdot\vec L$.)",
               R"(Without torque $\frac{d\vec L}{dt} = 0$.)", R"(It has $\omega \approx 3$ rad/s.)",
               "If both are equal, then:\n\n" + math("", "I_1 = I_2")});
}

// 2026-11-24: a word of a list switched the check off, whatever it said.
TEST(Statements, AreFreeWhereTheSentenceSaysForWhat) {
  expect_false({R"(For every rigid body $T = 0$.)",
                R"(With (1) we get $T = 0$.)",
                R"(No doubt $T = 0$.)",
                R"(There is no doubt that $T = 0$.)",
                R"(No torque acts, so $\vec\omega = 0$.)",
                R"(Without doubt $T = 0$.)",
                R"(It is not hard to see that $T = 0$.)",
                R"(When we look at it, $T = 0$.)",
                R"(Once more $T = 0$.)",
                R"(If anything, $T = 0$.)",
                R"(Let us see: $T = 0$.)",
                R"(Not only $T = 0$, it is small.)",
                R"(Nothing is wrong in $T = 1$ J.)",
                R"(For all of it: $T = 0$.)",
                R"(The sum is given by $T = 0$.)",
                R"(It does not turn, so $T = 0$.)",
                R"(As we know, $T = 0$.)",
                R"(This is such a body, and $T = 0$.)",
                R"(Never forget that $T = 0$.)",
                R"(The set is whole: $T = 0$.)",
                "With these we get\n\n" + math("", "T = 0"),
                "No torque acts, so\n\n" + math("", "T = 0"),
                math("", R"(T = 0 \quad\text{for every body})")});
  expect_true({R"(For $I_1 = I_2$ one has $\dot\omega_3 = 0$.)",
               R"(With $\omega_1 = 0$ it is a steady spin.)",
               R"(With the energy $T = 7$ J it would turn faster.)",
               R"(Take $\omega_1 = 0$.)",
               R"(Now let $T = 7$ J.)",
               R"(Consider a body of which $I_1 = I_2$. Then $\dot\omega_3 = 0$.)",
               R"(Suppose that $T = 0$.)",
               R"(It does not follow that $\vec\omega = 0$.)",
               R"(This does not mean that $\vec\omega = 0$ and $T = 0$.)",
               R"(The line $T = 0$ is wrong.)",
               R"(When the body is at rest, $T = 0$.)",
               R"(A state such that $T = 0$ is at rest.)",
               R"(The curve on which $T = 7$ J lies inside.)",
               R"(Neither $T = 0$ nor $\vec L = 0$ is so.)",
               R"(It isn't $T = 0$.)",
               R"(No body has $I_1 = 5 I_2$.)",
               R"(Either $T = 0$ or it turns.)",
               R"(For small $\omega_1$ one finds $\omega_3 = 0$.)",
               R"(Here $2T = \vec\omega\cdot\vec L$, if you like.)",
               "Without torque\n\n" + math("", R"(\frac{d\vec L}{dt} = 0)"),
               math("", R"(\dot\omega_3 = 0 \quad\text{for } I_1 = I_2)"),
               math("", R"(\text{if } \omega_1 = 0 \text{ then } T = 0)")});
}

// 2026-11-26: an imperative freed whatever stood in its sentence, and "not" whatever stood behind it.
TEST(Statements, AreNotFreeBehindWordsThatInsist) {
  expect_false({"Take it that $T = 0$.", "One must not forget that $T = 0$.",
                "One must not forget $T = 0$, whatever happens.", "Nobody can overlook that $T = 0$.",
                "It cannot escape us that $T = 0$.", "We cannot help seeing that $T = 0$.",
                "Do not miss the line $T = 0$.", "Put it plainly: $T = 0$.", "Make it clear – $T = 0$."});
  expect_true({"Take it about axis 3, and $\\omega_1 = 0$.", "Spin it about axis 3: it turns.",
               "Consider a rod: $I_1 = 0$.", "The line $T = 0$ is not so, do not forget it."});
}

// 2026-11-26: values at a time, tuples and columns were not read.
TEST(Statements, OfTuplesColumnsAndValuesAtATime) {
  expect_false({R"(Here $T(0) = 1$ J.)", R"(Here $\vec\omega(0) = (1, 2, 3)$.)", R"(Here $T(t) = 1$ J.)",
                R"(Here $\omega_1(0) = \omega_1(1)$.)", R"(Here $\omega_1(t = 1\,\text{s}) = 0.5$ rad/s.)",
                R"(Here $(I_1, I_2) = (2, 1)$.)", R"(Here $(T, \omega_2) = (1, 3)$.)",
                R"(Here $\vec\omega = \begin{pmatrix}3\\0\\0\end{pmatrix}$.)", R"(Here $\vec L(2) = 0$.)",
                math("", R"(\omega_2(0) = 2)")});
  expect_true({R"(Here $T(0) = T(1)$.)", R"(Here $\vec\omega(0) = (0.5, 3, 0.7)$.)",
               R"(Here $\omega_2(0) = 3$ rad/s.)", R"(Here $(I_1, I_2) = (1, 2)$.)",
               R"(Here $\vec\omega(0) = \begin{pmatrix}0.5\\3\\0.7\end{pmatrix}$.)",
               R"(Here $\omega_1(0) \ne \omega_1(1)$.)", R"(Here $\omega_1(0) = 0.5$.)"});
}

// 2026-11-26: signs and words that say the same in another way.
TEST(Statements, OfOtherSignsAndTurnsOfPhrase) {
  expect_false({R"(Here $T \equiv 0$.)", R"(Here $I_1 \gg I_3$.)", R"(Here $I_3 \ll I_1$.)",
                R"(Here $\{T = 0\}$.)", math("", R"(\Rightarrow T = 0)"),
                math("", R"(\vec\omega \Rightarrow T = 0)"), "For once $T = 0$.", "Either way $T = 0$.",
                "Let it be said: $T = 0$.", "Let there be no doubt: $T = 0$.",
                "Suppose what you like: $T = 0$.", "Assume nothing else: $T = 0$.",
                "Half the energy is called $T$.", "At the moment $T = 0$.", "As long as we look, $T = 0$."});
  expect_true({R"(Here $I_3 \gg 0.1 I_1$.)", R"(Here $\vec\omega\cdot\vec L \equiv 2T$.)",
               math("", R"(\Rightarrow \vec L = \text{const})"),
               math("", R"(\omega_1 = 0 \Rightarrow T = 0)"), "Let it rest: then $T = 0$.",
               "Once it rests, $T = 0$.", "At the moment of the flip $T = 0$.",
               "As long as it rests, $T = 0$.", "Change the moments so that $\\omega_3$ stays constant."});
}

TEST(Statements, ThatSomethingDoesNotChangeAreOfAllTimes) {
  expect_false({math("", R"(\vec\omega = \text{const})"), R"(Here $\omega_1 = \text{const}$.)",
                math("", R"(\omega_2 = \mathrm{const.})")});
  expect_true({math("", R"(\vec L = \text{const})"), R"(Here $T = \text{const}$.)"});
  EXPECT_THAT(complaints_about(math("", R"(T = \text{const})"), "torque = \"body:0,0.5,0\""), Not(IsEmpty()));
  EXPECT_THAT(
      complaints_about(R"(Here $\vec L = \text{const}$.)", "omega = [0, 3, 0]\ntorque = \"body:0,0.5,0\""),
      Not(IsEmpty()));
}

// An assumption that no word names is none of the sentence.
TEST(Statements, OfAnAssumptionNameIt) {
  const std::string scene =
      "\n\n```scene\nbody = \"plate\"\nomega = [0.5, 3, 0.7]\nshow = [\"omega\", \"L\"]\n```\n";
  const std::string tables = std::string(kTables) + "[assume]\nsymmetric = \"I2 = I1\"\n";
  EXPECT_THAT(complaints_of(R"(Here $\dot\omega_3 = 0$.)" + scene, tables), Not(IsEmpty()));
  EXPECT_THAT(complaints_of(R"(Here $I_1 = I_2$.)" + scene, tables), Not(IsEmpty()));
  EXPECT_THAT(complaints_of(R"(Of a symmetric body without torque $\dot\omega_3 = 0$.)" + scene, tables),
              IsEmpty());
  EXPECT_THAT(complaints_of(R"(Of a symmetric body $\dot\omega_1 = 0$.)" + scene, tables), Not(IsEmpty()));
}

TEST(Statements, OfVectorsAndOfTimes) {
  expect_false({R"(At first $\vec\omega = (0.5, 2, 0.7)$ rad/s.)",
                R"(Here $\vec\omega = (3, 0, 0)\,\text{rad/s}$.)", R"(Here $\vec L = (1, 2, 3)$.)",
                R"(Here $\vec L \parallel \vec\omega$.)", R"(Here $\vec L \perp \vec\omega$.)",
                R"(Here $2T \ne \vec\omega\cdot\vec L$.)", R"(Here $\vec L \ne \vec L$.)",
                R"(At $t = 1$ s, $\omega_2 = 3$ rad/s.)",
                R"(At $t = 0.7$ s the body has $\omega_1 = 0.5$ rad/s.)"});
  expect_true({R"(At first $\vec\omega = (0.5, 3, 0.7)$ rad/s.)", R"(At first $\vec\omega = (0.5, 3, 0.7)$.)",
               R"(Here $\vec\omega = (\omega_1, \omega_2, \omega_3)$.)",
               R"(Here $\vec L \nparallel \vec\omega$.)",
               R"(Here $\vec L = (I_1\omega_1, I_2\omega_2, I_3\omega_3)$.)",
               R"(Here $\vec\omega\times\vec L \perp \vec\omega$.)", R"(Here $\vec L \ne 0$.)",
               R"(Here $\omega_1 \ne \omega_2$.)", R"(At $t = 0$ the body has $\omega_2 = 3$ rad/s.)",
               R"(From $t = 0$ to $t = 1$ s, $\omega_2 = 3$ rad/s.)"});
}

TEST(Statements, OfHeadlinesAreChecked) {
  const std::string scene =
      "\n\n```scene\nbody = \"plate\"\nomega = [0.5, 3, 0.7]\nshow = [\"omega\", \"L\"]\n```\n";
  EXPECT_THAT(complaints_of("## Here $T = 0$\n\nText." + scene, kTables), Not(IsEmpty()));
  EXPECT_THAT(complaints_of("## Here $T > 0$\n\nText." + scene, kTables), IsEmpty());
}

TEST(Statements, OfQuestionsAreCheckedButForTheChoicesThatAreWrong) {
  const std::string head = "```ask q\ntype = \"choice\"\nprompt = \"Which holds?\"\n";
  EXPECT_THAT(complaints_about(head + "because = 'It is $T = 1$ J.'\n\n- [x] one\n- [ ] other\n  No.\n```\n"),
              Not(IsEmpty()));
  EXPECT_THAT(complaints_about(head + "\n- [x] $T = 0$\n- [ ] other\n  No.\n```\n"), Not(IsEmpty()));
  EXPECT_THAT(complaints_about(head + "\n- [x] one\n- [ ] $T > 5$\n  For $T < 0$.\n```\n"), IsEmpty());
}

TEST(TypedNumbers, AreComputedOrGiven) {
  expect_false({"The energy is 1 kJ.", "The energy is $1$ kJ.", R"($\vec L$ is $5$ kg m²/s long.)",
                "It turns by 27°.", "It weighs 21 kg."});
  expect_true({"The giant weighs 20 kg.", "It turns about axis 2 with 3 rad/s.",
               "The moments are 1, 2 and 2.9 kg&nbsp;m².", "Turned by 90° it is upright.",
               "A day has 24 hours, a year 365 days.", "It is shown after 0.2 s."});
}

// 2026-11-24: a number was taken for right if anything of its unit had it.
TEST(TypedNumbers, AreOfWhatIsSaid) {
  expect_false({"The smallest moment is 2.9 kg m².", R"(The rate about axis 2 is $0.5$ rad/s.)",
                "The angular speed is 0.7 rad/s.", "The energy is always 9.1 J.",
                "| what | is |\n|---|---|\n| energy | 19.671 J |\n",
                "| what | is |\n|---|---|\n| $I_3$ | 2 kg m² |\n"});
  expect_true(
      {"The smallest moment is 1 kg m².", "The largest moment is $2.9$ kg m².", "The energy is 9.84 J.",
       "If the rate about axis 2 is 0.5 rad/s, it is slow.", "The rate about axis 2 is at first 3 rad/s.",
       "| what | is |\n|---|---|\n| energy | 9.84 J |\n", "| what | is |\n|---|---|\n| $I_3$ | 2.9 kg m² |\n",
       "| what | a | b |\n|---|---|---|\n| $I_1$ | 1 kg m² | 2 kg m² |\n"});
}

// 2026-11-26: of a row with several numbers, and below heads, nothing was read.
TEST(TypedNumbers, InTablesAreOfTheirRowsAndColumns) {
  const auto table = [](const std::string& heads, const std::string& row) {
    return "| " + heads + " |\n|---|---|---|\n| " + row + " |\n";
  };
  expect_false({table("what | at first | later", "energy | 3 J | 5 J"),
                table("what | at first | later", "energy (J) | 3 | 5"),
                table("what | at first (J) | later (J)", "energy | 3 | 5"),
                table("a | energy | b", "x | 19.7 J | y"), table("a | energy (J) | b", "x | 5 | y"),
                table("a | $T$ | b", "x | 5 | y"), table("a | largest moment | b", "x | 2 kg m² | y")});
  expect_true({table("what | at first | of another", "energy | 9.84 J | 19.671 J"),
               table("what | at first (J) | later (J)", "energy | 9.84 | 9.84"),
               table("a | energy (J) | b", "x | 9.84 | y"), table("a | $I_3/I_1$ | b", "coin | 1.98 | y"),
               table("a | energy | b", "x | small | y"), table("a | $T$ | 3", "x | 9.84 | 5")});
}

// 2026-11-26: only plain digits were read as a number.
TEST(TypedNumbers, AreReadHoweverTheyAreWritten) {
  expect_false({"Its energy is 5·10³ J.", "Its energy is 5 × 10^3 J.", "Its energy is 5e3 J.",
                "Its energy is 5,000 J.", "Its energy is −9.84 J.", "Its energy is 5·10⁻² J."});
  expect_true({"Its energy is 0.984·10¹ J.", "Its energy is 9.84e0 J.", "The energy, 9.84 J, is kept.",
               "A coin of 5·10⁻³ kg is light."});
}

TEST(TypedNumbers, BelowAxesAndLettersAreTheirs) {
  expect_false({"| $I_1$ | $I_2$ | $I_3$ |\n|---|---|---|\n| 3 | 2 | 1 |\n",
                "| axis | moment |\n|---|---|\n| 1 | 2.9 |\n| 3 | 1 |\n",
                "| axis | moment (kg m²) |\n|---|---|\n| 1 | 2.9 |\n",
                "| | value |\n|---|---|\n| $I_1$ | 3 |\n"});
  expect_true({"| $I_1$ | $I_2$ | $I_3$ |\n|---|---|---|\n| 1 | 2 | 2.9 |\n",
               "| axis | moment |\n|---|---|\n| 1 | 1 |\n| 3 | 2.9 |\n",
               "| axis | colour |\n|---|---|\n| 1 | 7 |\n"});
}

// 2026-11-26: what is said of a coin was held against the body that is shown.
TEST(TypedNumbers, OfAKindOfBodyAreNotThoseOfTheOneThatIsShown) {
  expect_true({"A coin of 5 g is light.", "A person weighs 70 kg.", "Take a book of 300 g.", "Wait 5 s.",
               "Turn it by 5°.", "Imagine a spin of 100 rad/s.", "A wheel of 2 kg would take 40 J."});
  expect_false({"An energy of 5 J is in it.", "It has an energy of 5 J.", "A body of 5 kg is shown.",
                "A turn takes 7 s."});
}

// 2026-11-27: half a unit of the last digit of "2" is a quarter of it.
TEST(TypedNumbers, ThatAreWholeAreNotRoundedToThem) {
  expect_false({"The ratio of $I_3$ to $I_1$ is 3.", "The moment about axis 3 is 3 kg m².",
                "The length of $\\vec\\omega$ is 3 rad/s.",
                "| $I_1$ | $I_2$ | $I_3$ |\n|---|---|---|\n| 2 | 1 | 3 |\n"});
  // ω = 3.121 rad/s, T = 9.836 J, |L| = 6.353 kg m²/s
  expect_true({"The ratio of $I_3$ to $I_1$ is about 3.", "The moment about axis 3 is nearly 3 kg m².",
               "The ratio of $I_2$ to $I_1$ is 2.", "The length of $\\vec\\omega$ is 3.1 rad/s.",
               "The length of $\\vec L$ is 6.4 kg m²/s.", "The energy is 9.8 J."});
}

TEST(NamesInWords, AreHeldAgainstTheFormulaBehindThem) {
  expect_false({"The energy is $2T$.", R"(The energy is $\vec\omega\cdot\vec L$.)",
                R"(The angular momentum is $2\mathbf I\cdot\vec\omega$.)", "The largest moment is $I_1$.",
                "Half the energy is always $T$.", R"(The ratio of $I_1$ to $I_3$ is $I_3/I_1$.)"});
  expect_true({"The energy is $T$.", R"(Twice the energy is $\vec\omega\cdot\vec L$.)",
               R"(The angular momentum is $\mathbf I\cdot\vec\omega$.)", "The largest moment is $I_3$.",
               R"(The angular momentum is $\vec L$.)",
               R"(The angle between $\vec\omega$ and $\vec L$ is $\alpha$.)",
               R"(The length of $\vec L$ is $\sqrt{\vec L\cdot\vec L}$.)", "The energy is not $2T$.",
               "The energy is $2T$ divided by 2.", "Is the energy $2T$?"});
}

// 2026-11-26: what stands behind a formula was not read.
TEST(NamesInWords, AreHeldAgainstTheFormulaBeforeThem) {
  expect_false({"$T$ is half the energy.", "Here $T$ is twice the kinetic energy.",
                "$I_1$ is the largest moment.", "$2T$ is called the energy.",
                "$T$ equals the angular momentum.", "$\\omega_1$ is always the angular speed.",
                "5 J is the energy.", "$5$ J is the energy.", "It has the angular momentum $T$.",
                "So the energy $\\omega_1$ is small.", "Its angular velocity $I_1$ is small."});
  expect_true({"$T$ is the energy.", "$T$ is half of $2T$.", "$I_1$ is the smallest moment.",
               "Half of $2T$ is the energy.", "$T$ is not half the energy.", "$T$ is the energy of the spin.",
               "9.84 J is the energy.", "If $T$ is half the energy, what is $2T$?", "The energy $T$ is kept.",
               "It has the angular momentum $\\vec L$.",
               "It has the energy $\\frac12\\vec\\omega\\cdot\\vec L$.", "$\\vec L$ is the angular momentum.",
               "$\\vec\\omega$ is the angular velocity."});
}

// 2026-11-26: "is larger than", "vanishes", "are parallel" in words were read of no formula.
TEST(Statements, InWordsAreThoseOfTheirSigns) {
  expect_false({"$I_1$ is larger than $I_2$.", "$I_1$ exceeds the largest moment.",
                "$I_3$ is smaller than $I_1$.", "$\\vec L$ is parallel to $\\vec\\omega$.",
                "$\\vec L$ and $\\vec\\omega$ are parallel.", "$I_1$ and $I_2$ are equal.", "$T$ vanishes.",
                "$\\omega_2$ is zero.", "$\\vec\\omega$ is constant.", "$\\omega_2$ never changes.",
                "$\\vec\\omega$ does not change in space.", "$\\vec L$ is perpendicular to $\\vec\\omega$.",
                "$I_1$ is equal to $I_2$.", "The energy is more than 50 J.", "The energy exceeds 50 J.",
                "The smallest moment is less than 0.5 kg m²."});
  expect_true({"$I_3$ is larger than $I_2$.", "$I_1$ is smaller than the largest moment.",
               "$T$ is conserved.", "$\\vec L$ does not change.",
               "$\\vec\\omega\\times\\vec L$ is perpendicular to $\\vec\\omega$.",
               "$\\vec\\omega$ is not constant.", "If $\\omega_2$ is zero, it turns.", "Is $T$ constant?",
               "$I_1$ and $I_2$ are not equal.", "The energy is less than 50 J.",
               "$\\vec\\omega$ is constant in a steady spin."});
}

// 2026-11-26: without a unit a number in words was none.
TEST(TypedNumbers, OfWhatIsSaidNeedNoUnit) {
  expect_false({"The ratio of $I_3$ to $I_1$ is 5.", "The energy is 5.", "$I_3/I_1$ is 5.",
                "The ratio of $I_3$ to $I_1$ is about 5, which is much."});
  expect_true({"The ratio of $I_3$ to $I_1$ is 2.9.", "The ratio of $I_3$ to $I_1$ is 5 in another body.",
               "The number of its faces is 6.", "The energy is 9.84."});
}

TEST(NamesInWords, AreHeldAgainstTheNumberBehindThem) {
  expect_false({R"(Half the energy is $\live[unit={J}]{T}$.)",
                R"(The angular speed is $\live[unit={rad/s}]{w2}$.)",
                R"(The largest moment is $\live[unit={kg m²}]{I2}$.)",
                R"($\vec L$ has the length $\live[unit={J}]{T}$.)",
                R"($\vec L$ has the length $\live[unit={kg m²/s}]{I2*w2}$.)",
                R"(The ratio of $I_1$ to $I_3$ is $\live{I3/I1}$.)",
                R"(The ratio of the smallest to the largest moment is $\live{I3/I1}$.)",
                R"(The body makes $\live[unit={rad/s}]{norm(omega)}$ turns a second.)",
                R"(One turn lasts $\live[unit={s}]{1/norm(omega)}$.)",
                R"(A full turn takes $\live[unit={s}]{1/norm(omega)}$.)",
                R"(The energy is always $\live[unit={J}]{2*T}$.)",
                R"(The norm of $\vec L$ is $\live[unit={kg m²/s}]{norm(L)/2}$.)",
                R"(The rate about axis 1 is $\live[unit={rad/s}]{w3}$.)"});
  expect_true({R"(Half of $I_3$ is $\live[unit={kg m²}]{I3/2}$.)",
               R"(A tenth of $T$ is $\live[unit={J}]{T/10}$.)",
               R"(The sum of $I_1$ and $I_2$ is $\live[unit={kg m²}]{I1+I2}$.)",
               R"(The mean of $\omega_2$ and $\omega_3$ is $\live[unit={rad/s}]{(w2+w3)/2}$.)",
               R"(The ratio of $|\vec L|^2$ to $2T$ is $\live[unit={kg m²}]{norm2(L)/(2*T)}$.)",
               R"($|\vec L|^2$ divided by $2T$ is $\live[unit={kg m²}]{norm2(L)/(2*T)}$.)",
               R"(The momentum $|\vec L|$ over $I_1$ is $\live[unit={rad/s}]{norm(L)/I1}$.)",
               R"(In this throw, twice $T$ is $\live[unit={J}]{2*T}$.)",
               R"(The difference of $\omega_2$ and $\omega_3$ is $\live[unit={rad/s}]{w2-w3}$.)",
               R"(One turn lasts $\live[unit={s}]{2*pi/norm(omega)}$.)",
               R"(It is $\frac{2\pi}{\omega} \approx \live[unit={s}]{2*pi/norm(omega)}$.)",
               R"(The momentum is $L = \live[unit={kg m²/s}]{norm(L)}$.)"});
}

TEST(NamesInWords, AreHeldAgainstColumnsAndPlots) {
  const auto column = [](const std::string& keys) {
    return "```table\ncolumns = [{ head = \"body\" }, { " + keys + " }]\nrows = [{ head = \"a\" }]\n```\n";
  };
  expect_false({column("head = 'angular speed', of = 'norm(L)'"),
                column("head = 'largest moment', of = 'I1'"),
                column("head = 'turns per second', of = 'norm(omega)'"),
                column("head = 'error (%)', of = 'I1/I3'"), column("head = 'twice the energy', of = 'T'"),
                "| axis | moment |\n|---|---|\n| 1 | $\\live{I3}$ |\n| 3 | $\\live{I1}$ |\n"});
  expect_true({column("head = 'half the energy', of = 'T/2'"), column("head = 'error (%)', of = '100*I1/I3'"),
               "| axis | moment |\n|---|---|\n| 1 | $\\live{I1}$ |\n| 3 | $\\live{I3}$ |\n"});
  for (const char* keys :
       {R"(meters = [{ plot = "T", title = "Length of $\\vec L$" }])",
        R"(meters = [{ plot = "T/10", title = "Energy" }])", R"(meters = [{ plot = "2*T", tex = ['T'] }])",
        R"(meters = [{ plot = "-w1", tex = ['\omega_1'] }])",
        R"(arrows = [{ of = "I1*omega", tex = '\vec v' }])", R"(meters = [{ plot = "w1", tex = ['E'] }])",
        R"(meters = [{ plot = "w1", title = "Spin about axis 2" }])",
        R"(meters = [{ plot = "w1", title = '$\omega_1$ against $\omega_2$', against = "w3" }])",
        R"(meters = [{ plot = ["w1", "w2"], tex = ['\text{axis 2}', '\text{axis 1}'] }])",
        R"(arrows = [{ of = "e1", tex = '\text{axis 2}' }])",
        R"(arrows = [{ of = "comp(omega, 1)*e1", tex = '\omega_2' }])",
        R"(notes = [{ text = "axis 2", at = "e1" }])",
        R"(angles = [{ from = "omega", to = "L", tex = '\text{right angle}' }])",
        R"(areas = [{ from = "omega", to = "L", tex = '\vec L\times\vec\omega', role = "violet" }])",
        R"(arrows = [{ of = "e3", tex = '\vec L' }])",
        R"x(arrows = [{ of = "cross(omega, L)", tex = '\vec L\times\vec\omega' }])x",
        R"(notes = [{ text = "The energy is 5 J", at = "e1" }])",
        R"(notes = [{ text = '$T = 0$', at = "e1" }])"})
    EXPECT_THAT(complaints_about("Text.", keys), Not(IsEmpty())) << keys;
  for (const char* keys :
       {R"x(meters = [{ plot = "norm(L)", title = "Length of $\\vec L$" }])x",
        R"(meters = [{ plot = "w1", title = "Spin about axis 1" }])",
        R"(meters = [{ plot = "w1", title = '$\omega_1$ against $\omega_3$', against = "w3" }])",
        R"(arrows = [{ of = "e1", tex = '\text{axis 1}' }])", R"(notes = [{ text = "axis 1", at = "e1" }])",
        R"x(arrows = [{ of = "cross(omega, L)", tex = '\vec\omega\times\vec L' }])x",
        R"(arrows = [{ of = "e3", tex = '\vec r' }])",
        R"(notes = [{ text = "The energy is 9.84 J", at = "e1" }])",
        R"(areas = [{ from = "omega", to = "L", tex = '\vec\omega\times\vec L', role = "violet" }])"})
    EXPECT_THAT(complaints_about("Text.", keys), IsEmpty()) << keys;
}

/// On a symmetric body, I1 = I2 = 1, I3 = 1.8 kg m², with the lines of [symbols] and [define] of a lesson.
std::vector<std::string> complaints_about_top(const std::string& text, const std::string& tables = "",
                                              const std::string& keys = "") {
  return complaints_of(text +
                           "\n\n```scene\nbody = \"top\"\nomega = [0.5, 0, 2]\nshow = [\"omega\", \"L\"]\n" +
                           keys + "\n```\n",
                       "[body.top]\nmoments = [1.0, 1.0, 1.8]\ndraw = \"box\"\n" + tables);
}

// 2026-11-27: a name that a lesson gives made a stranger of each phrase that is a part of it. ω is 14.04°
// from axis 3, and |ω| = 2.062 rad/s.
TEST(NamesInWords, AreNotHiddenByLongerOnesOfTheLesson) {
  for (const char* say : {"axis 3", "axis 3 of the body", "angle between the angular velocity and axis 3"}) {
    const std::string own = "[define]\nmine = { means = \"dot(omega, e3)/norm(omega)\", tex = 'q', say = \"" +
                            std::string(say) + "\" }\n",
                      symbol = "[symbols]\ne3 = { tex = '\\hat e_3', say = \"" + std::string(say) + "\" }\n";
    for (const char* text : {R"(The angle between $\vec\omega$ and axis 3 is 24.2°.)",
                             R"(The component of $\vec\omega$ along axis 3 is 0.9 rad/s.)",
                             R"(The angle between the angular velocity and the angular momentum is 3.1°.)"}) {
      EXPECT_THAT(complaints_about_top(text, symbol), Not(IsEmpty())) << text << symbol;
      if (std::string_view(say) != "axis 3") {
        EXPECT_THAT(complaints_about_top(text, own), Not(IsEmpty())) << text << own;
      }
    }
    for (const char* text : {R"(The angle between $\vec\omega$ and axis 3 is 14.0°.)",
                             R"(The component of $\vec\omega$ along axis 3 is 2 rad/s.)"})
      EXPECT_THAT(complaints_about_top(text, symbol), IsEmpty()) << text << symbol;
  }
  // The phrase itself is the lesson's own.
  const std::string own = "[define]\nE = { means = \"2*T\", tex = 'E', unit = \"J\", say = \"energy\" }\n";
  EXPECT_THAT(complaints_about_top("The energy is 7.45 J.", own), IsEmpty());
  EXPECT_THAT(complaints_about_top("The energy is 3.725 J.", own), Not(IsEmpty()));
}

// 2026-11-27: what is called precession or a cone was compared with anything of its unit. |L|/I1 = 3.635
// rad/s, the cone about axis 3 has 14.04°, that about L 6.13°.
TEST(NamesInWords, ArePrecessionAndConesOfAFreeSymmetricBody) {
  for (const char* text :
       {"The rate of precession is 2.06 rad/s.", "Its precession rate is 2 rad/s.",
        "The half-angle of the body cone is 6.13°.", "The half angle of the space cone is 14.0°."})
    EXPECT_THAT(complaints_about_top(text), Not(IsEmpty())) << text;
  for (const char* text :
       {"The rate of precession is 3.635 rad/s.", "Its precession rate is 3.6 rad/s.",
        "The half-angle of the body cone is 14.0°.", "The half angle of the space cone is 6.13°."})
    EXPECT_THAT(complaints_about_top(text), IsEmpty()) << text;
  // Of what has none it is any number's name, and still somebody has to compute it.
  EXPECT_THAT(complaints_about_top("The rate of precession is 77 rad/s.", "", "torque = \"body:0,0.5,0\""),
              Not(IsEmpty()));
}

// 2026-11-27: Ω without its arrow was nobody.
TEST(Statements, OfVectorsWithoutTheirArrowsAreOfLengths) {
  const std::string own =
      "[define]\nOmega = { means = \"L/I1\", tex = '\\vec\\Omega' }\n"
      "spin_a = { means = \"w3*e3\", tex = '\\vec\\omega_A' }\n";
  for (const std::string& text :
       {math("", R"(\Omega = |\vec L|/I_3)"), math("", R"(\Omega = \frac{|\vec L|}{I_3})"),
        std::string(R"(Here $\Omega = 2.06$ rad/s.)"), std::string(R"(So $\omega_A = \omega_1$.)")})
    EXPECT_THAT(complaints_about_top(text, own), Not(IsEmpty())) << text;
  for (const std::string& text :
       {math("", R"(\Omega = \frac{|\vec L|}{I_1})"), math("", R"(\Omega = |\vec\Omega|)"),
        std::string(R"(Here $\Omega = 3.635$ rad/s.)"), std::string(R"(So $\omega_A = \omega_3$.)")})
    EXPECT_THAT(complaints_about_top(text, own), IsEmpty()) << text;
}

std::string question(const std::string& type, const std::string& keys) {
  return "```ask q\ntype = \"" + type + "\"\n" + keys + "\n```\n";
}

TEST(Prompts, AskForWhatTheAnswerIs) {
  const auto number = [](const std::string& prompt, const std::string& answer, const std::string& unit) {
    return question("number",
                    "prompt = '" + prompt + "'\nanswer = \"" + answer + "\"\nunit = \"" + unit + "\"");
  };
  const auto expression = [](const std::string& prompt, const std::string& answer) {
    return question("expression", "prompt = '" + prompt + "'\nanswer = \"" + answer + "\"");
  };
  expect_false(
      {number("What is $T$?", "norm(L)", "kg m²/s"), number("What is $T$?", "2*T", "J"),
       number("How large is $I_3$?", "I1", "kg m²"), number("What is the energy in J?", "2*T", "J"),
       number(R"(With $\omega_3 = 5$ rad/s, what is $T$?)", "T", "J"),
       expression("What is $T$?", "dot(omega, L)"), expression(R"(What is $\frac{dT}{dt}$?)", "0"),
       expression(R"(What is the component of $\vec\omega\times\vec L$ along axis 2?)", "w3*w1*(I3 - I1)"),
       question("choice", "prompt = 'Which is $2T$?'\n\n- [ ] $T$\n  No.\n- [x] $|\\vec L|^2$"),
       question("order", "prompt = 'Sort them, the smallest first.'\n\n1. $I_3$\n2. $I_2$\n3. $I_1$"),
       question("state",
                "prompt = 'Make it so.'\ngoals = [{ of = \"norm(L)\", say = \"energy\", is = 8, "
                "within = 0.1 }]\nchange = [\"omega\"]\nsolution = { omega = [8, 0, 0] }")});
  expect_true(
      {number("What is $T$?", "T", "J"), number("How large is half the energy?", "T/2", "J"),
       number(R"(What is $\omega_3$ when it has turned?)", "w2", "rad/s"),
       expression(R"(What is $\frac{dT}{dt}$?)", "dot(omega, N)"),
       expression("What is $2T$?", "dot(omega, L)"),
       expression(R"(What is the component of $\vec\omega\times\vec L$ along axis 2?)", "w3*w1*(I1 - I3)"),
       question("order", "prompt = 'Sort them, the smallest first.'\n\n1. $I_1$\n2. $I_2$\n3. $I_3$")});
}

TEST(Symbols, AreNotTypedAsComponents) {
  const auto with = [](const std::string& name) {
    return complaints_of("Text.\n", "[define]\n" + name + " = { means = \"2*T\" }\n[symbols]\n" + name +
                                        "b = { tex = '\\beta', say = \"beta\", means = \"T\" }\n");
  };
  for (const char* name : {"L1", "L_1", "vx", "omega_2"}) EXPECT_THAT(with(name), Not(IsEmpty())) << name;
  EXPECT_THAT(with("L_after"), IsEmpty());
  EXPECT_THAT(
      complaints_of("Text.\n", "[symbols]\nL1 = { tex = \"\\\\vec L'\", say = \"L\", means = \"2*L\" }\n"),
      Not(IsEmpty()));
}

TEST(Symbols, AreSaidAsWhatTheyMean) {
  const auto with = [](const std::string& keys) {
    return complaints_of("Text.\n", "[symbols]\na = { tex = '\\alpha', " + keys + " }\n");
  };
  EXPECT_THAT(with(R"(say = "kinetic energy", means = "2*T")"), Not(IsEmpty()));
  EXPECT_THAT(with(R"x(say = "energy", means = "T + dot(L, omega)")x"), IsEmpty());
  EXPECT_THAT(with(R"x(say = "kinetic energy", means = "dot(L, omega)/2")x"), IsEmpty());
}

// 2026-11-24: of symbols without "means" nobody read what is said of them.
TEST(Symbols, AreSaidAsWhatTheyAre) {
  const auto with = [](const std::string& symbol, const std::string& table = "symbols") {
    return complaints_of("Text.\n\n```scene\nshow = [\"omega\", \"L\"]\n```\n",
                         "[" + table + "]\n" + symbol + "\n");
  };
  for (const char* symbol :
       {R"(a = { tex = '\alpha', say = "the angular momentum of the body", means = "omega" })",
        R"x(a = { tex = 'E_1', say = "a", means = "norm(omega)" })x",
        R"(a = { tex = '\alpha', say = "second component of the angular velocity", means = "w1" })",
        R"(a = { tex = '\alpha', say = "component of omega along axis 2", means = "w1" })",
        R"(a = { tex = '\alpha', say = "largest moment", means = "I1" })",
        R"(omega = { tex = '\vec\omega', say = "linear velocity" })",
        R"(omega = { tex = '\vec\omega', say = "angular momentum vector" })",
        R"(L = { tex = '\vec L', say = "angular velocity in space" })",
        R"(T = { tex = 'T', say = "total momentum of the body" })",
        R"(I1 = { tex = 'I_1', say = "largest moment" })",
        R"(I1 = { tex = 'I_1', say = "moment about axis 2" })",
        R"(I2 = { tex = 'I_2', say = "first principal moment" })",
        R"(w1 = { tex = '\omega_1', say = "second component of the angular velocity" })",
        R"(w1 = { tex = '\omega_1', say = "rate about axis 3" })",
        R"(e1 = { tex = '\hat e_1', say = "axis 2" })", R"(x = { tex = '\vec L', say = "angular velocity" })",
        R"(x = { tex = '\alpha', say = "angular momentum", unit = "rad/s" })"})
    EXPECT_THAT(with(symbol), Not(IsEmpty())) << symbol;
  for (const char* symbol :
       {R"(u = { means = "T", tex = 'u', say = "cosine of the tilt" })",
        R"x(u = { means = "dot(ez, e3)", tex = 'u', say = "tilt" })x",
        R"x(u = { means = "acos(dot(ez, e3))", tex = 'u', say = "cosine of the tilt" })x"})
    EXPECT_THAT(with(symbol, "define"), Not(IsEmpty())) << symbol;
  for (const char* symbol :
       {R"(omega = { tex = '\vec\omega', say = "angular velocity of the body" })",
        R"(T = { tex = 'T', say = "kinetic energy of the rotation" })",
        R"(I1 = { tex = 'I_1', say = "moment of inertia about axis 1" })",
        R"(w1 = { tex = '\omega_1', say = "first component of the angular velocity" })",
        R"(e3 = { tex = '\hat e_3', say = "symmetry axis" })",
        R"(N = { tex = '\vec N', say = "torque of the weight" })",
        R"(Om = { tex = '\vec\Omega', say = "rate of precession", means = "L/I1", unit = "rad/s" })"})
    EXPECT_THAT(with(symbol), IsEmpty()) << symbol;
  for (
      const char* symbol :
      {R"x(theta = { means = "acos(dot(ez, e3))", tex = '\theta', say = "tilt", unit = "rad" })x",
       R"x(u = { means = "dot(ez, e3)", tex = 'u', say = "cosine of the tilt" })x",
       R"x(pphi = { means = "dot(L, ez)", tex = 'p_\varphi', say = "vertical component of the angular momentum" })x",
       R"x(tip = { means = "ddt(L)", tex = '\vec r', say = "the velocity of the tip of L" })x"})
    EXPECT_THAT(with(symbol, "define"), IsEmpty()) << symbol;
}

TEST(Captions, TypeWhatIsSo) {
  EXPECT_THAT(complaints_about("Text.", "caption = 'ω₂ = 1 rad/s'"), Not(IsEmpty()));
  EXPECT_THAT(complaints_about("Text.", "caption = 'ω₂ = 3 rad/s'"), IsEmpty());
  EXPECT_THAT(complaints_about("Text.", "caption = 'From $t = 0$ to $t = 2$ s'"), IsEmpty());
}

TEST(ClaimsBesideFormulas, BesideAFormulaSayItsRelation) {
  const std::string claim = "```claim a identity in-other-words\n2*T = dot(omega, L)\n```\n";
  expect_false({math("", R"(2T > \vec\omega\cdot\vec L \oplus \zeta)") + claim,
                math("", R"(2T > \vec\omega\cdot\vec L + \zeta)") + claim,
                math("", R"(\bar{\bar\zeta} = T + \omega_1)") + claim,
                math("", R"(2T = \omega_1 = \bar{\bar\zeta})") + claim});
  expect_true({math("", R"(2T = \langle\vec\omega, \vec L\rangle)") + claim});
}

// 2026-11-27: "(t)" made a formula unreadable, and T(t) = 7 w(t).L(t) stood above a true claim.
TEST(FunctionsOfTime, AreReadAsWhatTheyAre) {
  const std::string claim = "```claim a identity\n2*T = dot(omega, L)\n```\n";
  expect_false({math("", R"(T(t) = 7\,\vec\omega(t)\cdot\vec L(t))") + claim,
                math("", R"(\frac{dT(t)}{dt} = 7)"), R"(So $\omega_1(t) = 5\,\omega_2(t)$.)",
                R"(So $7T(t) = \vec\omega(t)\cdot\vec L(t)$.)", R"(So $dT(t)/dt = 7\,\text{W}$.)",
                R"(So $\omega_1(t)^2 = 5\,\omega_2^2(t)$.)",
                math("identity", R"(\frac{dT}{dt}(2) = 2\frac{dT}{dt})"),
                math("identity", R"(\frac{dT}{dt}(0) = 0)"), math("identity", R"(T(0) = T)")});
  expect_true({math("identity", R"(2T(t) = \vec\omega(t)\cdot\vec L(t))"),
               math("identity", R"(\omega_1(t)^2 = \omega_1^2(t))"),
               math("motion", R"(\frac{d\vec L(t)}{dt} = \vec N(t))"),
               R"(So $2T(t) = \vec\omega\cdot\vec L(t)$.)"});
}

// 2026-11-27: of a formula that is not read neither the numbers nor a commuted claim were looked at.
TEST(ClaimsBesideFormulas, HaveTheNumbersThatArePrintedAndSaySomething) {
  const std::string formula = R"(T = \tfrac13\langle\vec\omega, \vec L\rangle)";
  expect_false({math("", formula) + "```claim a identity\nT = dot(omega, L)/2\n```\n",
                math("", R"(\vec\omega(t) = \vec\omega(0))") +
                    "```claim a free\ndot(omega, ddt(omega)) = dot(ddt(omega), omega)\n```\n",
                math("", R"(\langle\vec\omega, \vec L\rangle = 0)") +
                    "```claim a identity\ndot(omega, L) - dot(L, omega) = 0\n```\n"});
  expect_true({math("", R"(T = \tfrac12\langle\vec\omega, \vec L\rangle)") +
                   "```claim a identity\nT = 0.5*dot(omega, L)\n```\n",
               math("", R"(\langle\vec\omega, \vec L\rangle = 0)") +
                   "```claim a identity\ndot(omega, cross(omega, L)) = dot(L, cross(omega, omega))\n```\n"});
}

// 2026-11-27: one thing that was not read muted all of a formula in the text.
TEST(Statements, AreSeenThroughWhatOnlyDecorates) {
  expect_false({"So $T = 2T_{}$.", R"(So $\boxed{T} = 3T$.)", R"(So $\textcolor{red}{T} = 50\,\text{J}$.)",
                R"(So $T = 4T\,!$.)", R"(So $T \overset{!}{=} 5T$.)", R"(So $T\!\!\! = 6T$.)",
                R"(So $\scriptstyle T = 7T$.)", R"(So $\left.T\right. = 8T$.)", R"(So $T \doteq 9T$.)",
                math("", R"(\textcolor{red}{T} = 50\,\text{J})")});
  expect_true({R"(So $\boxed{2T} = \vec\omega\cdot\vec L\,!$)", R"(So $T \overset{!}{=} T$.)"});
}

// 2026-11-27: "2T/T = 2" with a tick, and ".5" behind it.
TEST(ProvedParts, EndBeforeNoDigit) {
  const std::string part = R"(\proved{\frac{2T}{T} = 2})";
  expect_false({math("identity", part + ".5"), math("identity", part + "{,}5"), math("identity", part + ",5"),
                math("identity", part + R"(.\,5)"), math("identity", part + R"(.{5})"),
                math("identity", R"(3\quad)" + part)});
  expect_true({math("identity", part + "."), math("identity", part + R"(,\quad \zeta = 5)"),
               math("identity", R"(\zeta = 5,\quad )" + part)});
}

// 2026-11-27: I_1 = I_1 was measured, an identity was a law, and what defines nothing a definition.
TEST(KindsOfClaims, AreWhatTheySay) {
  expect_false({math("measured", "I_1 = I_1"), math("measured", R"(2T = \vec\omega\cdot\vec L)"),
                math("law", R"(2T = \vec\omega\cdot\vec L)"),
                math("definition", R"(\vec\omega\cdot(\vec\omega\times\vec L) = 0)")});
  expect_true({math("measured", R"(\frac{dT}{dt} = 0)"), math("law", R"(\frac{d\vec L}{dt} = \vec N)"),
               math("definition", R"(\vec L = \mathbf I\cdot\vec\omega)")});
}

// 2026-11-28: what Ω means was "true when no torque acts, given I₂ = I₁". Nothing of that is needed.
TEST(KindsOfClaims, NeedWhatTheyName) {
  const auto complaints = [](const std::string& kind, const std::string& tex) {
    return complaints_of(math(kind, tex) + "\n```scene\nomega = [0.5, 3, 0.7]\n```\n",
                         "[symbols]\nOm = { tex = '\\vec\\Omega', say = \"capital omega\", unit = \"rad/s\", "
                         "means = \"L/I1\" }\n"
                         "[assume]\nsymmetric = \"I2 = I1\"\nturns = \"w3^2 > 0\"\n");
  };
  const std::string meaning = R"(\vec\Omega = \frac{\vec L}{I_1})",
                    length = R"(|\vec\Omega| = \frac{|\vec L|}{I_1})",
                    ratio = R"(\frac{\vec\Omega\cdot\hat e_3}{\omega_3} = \frac{I_3}{I_1})",
                    turned = R"(\frac{d\hat e_3}{dt} = \vec\Omega\times\hat e_3)",
                    lasting = R"(\frac{d\vec\Omega}{dt} = 0)";
  for (const char* kind : {"identity", "motion", "free", "free given symmetric"})
    EXPECT_THAT(complaints(kind, meaning), ElementsAre(HasSubstr("what one of its symbols means"))) << kind;
  EXPECT_THAT(complaints("free", length), ElementsAre(HasSubstr("no law of motion is needed")));
  EXPECT_THAT(complaints("free given symmetric", turned),
              ElementsAre(HasSubstr("no law of motion is needed")));
  EXPECT_THAT(complaints("identity given symmetric turns", ratio),
              ElementsAre(HasSubstr("what is given is not needed")));
  EXPECT_THAT(complaints("definition", meaning), IsEmpty());
  EXPECT_THAT(complaints("identity", length), IsEmpty());
  EXPECT_THAT(complaints("identity given turns", ratio), IsEmpty()) << "it says where there is a ratio";
  EXPECT_THAT(complaints("identity given symmetric", turned), IsEmpty());
  EXPECT_THAT(complaints("free", lasting), IsEmpty());
}

// 2026-11-27: a tag said "if no torque acts", and "1e1" stood for 7.93.
TEST(Displays, HaveTagsAndNumbersThatSayNothingElse) {
  expect_false(
      {math("identity", R"(2T = \vec\omega\cdot\vec L \tag{if no torque acts})"),
       math("", R"(2T = \vec\omega\cdot\vec L \tag{always})"),
       math("identity", R"(2.6T = 1.3\,\vec\omega\cdot\vec L = \value[unit={J}]{3\cdot10^{1}}{2.6*T})")});
  for (const char* tag : {"3", "3a", "3'", "A", "3.2"})
    expect_true({math("identity", R"(2T = \vec\omega\cdot\vec L \tag{)" + std::string(tag) + "}")});
}

// 2026-11-27: words at braces and on arrows stated what nobody proved.
TEST(WordsInFormulas, NameWhatStandsThere) {
  expect_false({math("identity", R"(\underbrace{\vec\omega\cdot\vec L}_{\text{kinetic energy}} = 2T)"),
                math("", R"(\underbrace{\vec\omega\cdot\vec L}_{\text{kinetic energy}} = 2T)"),
                math("identity", R"(2T = \overbrace{\vec\omega\cdot\vec L}^{\text{only for a sphere}})"),
                math("identity", R"(2T = \underbrace{\vec\omega\cdot\vec L}_{\text{from axis III}})"),
                math("motion", R"(\frac{d\vec L}{dt} = 0 \xRightarrow{\text{and conversely}} \vec N = 0)")});
  expect_true({math("identity", R"(2\,\underbrace{T}_{\text{kinetic energy}} = \vec\omega\cdot\vec L)")});
}

// 2026-11-28: a quantity at one time beside another time of it was read in none but the simplest form.
TEST(Statements, OfOneTimeAreHeldAgainstThatOfAnother) {
  expect_false({R"(So $T(5) = 2\,T(0)$.)", R"($\vec L(5) = -\vec L(0)$.)", R"($|\vec L(5)| = 3|\vec L(0)|$.)",
                R"($\omega_2 = 3$ rad/s when $t = 4$ s.)"});
  expect_true({R"(So $2\,T(5) = 2\,T(0)$.)", R"($|\vec L(5)| = |\vec L(0)|$.)",
               R"($T(1) + T = T(0)$ is nothing that is read.)"});
}

// 2026-11-28: "with" made a condition of what the body is said to do.
TEST(Statements, SayHowTheBodyMoves) {
  expect_false({R"(The plate spins with $\omega_2 = 7$ rad/s.)"});
  expect_true({R"(The plate starts with $\omega_2 = 3$ rad/s.)",
               R"(With $\omega_2 = 7$ rad/s it would turn faster.)",
               R"(The plate would spin with $\omega_2 = 7$ rad/s.)"});
}

// 2026-11-28: what is said of both motions was so of one.
TEST(Statements, OfBothMotionsAreSoOfEach) {
  const std::string scenes =
      "scenes = [{ caption = \"one\" }, { omega = [0.5, 1, 0.7], caption = \"two\" }]\nrate = 1\nduration = "
      "2";
  EXPECT_THAT(complaints_about(R"(Both have $\omega_2 = 3$ rad/s.)", scenes), Not(IsEmpty()));
  EXPECT_THAT(complaints_about(R"(Both have $\omega_1 = 0.5$ rad/s.)", scenes), IsEmpty());
  EXPECT_THAT(complaints_about(R"($\omega_2 = 3$ rad/s.)", scenes), IsEmpty());
}

// 2026-11-28: a caption's name and number were told to do, and one below several pictures was so of one.
TEST(Captions, HaveNamesAndNumbersOfAllTheyStandBelow) {
  const auto captioned = [](const std::string& caption, const std::string& keys = "") {
    return complaints_about("Look.", "caption = '" + caption + "'\n" + keys);
  };
  EXPECT_THAT(captioned("Energy 3.0 J"), Not(IsEmpty()));
  EXPECT_THAT(captioned("Energy 9.84 J"), IsEmpty());
  EXPECT_THAT(captioned("Spin 99 rad/s"), Not(IsEmpty()));
  EXPECT_THAT(captioned("Spin 3 rad/s"), IsEmpty());
  const std::string vary = "vary = { omega3 = { from = 0.1, to = 9 } }";
  EXPECT_THAT(captioned("The energy is 9.84 J", vary), Not(IsEmpty()));
  EXPECT_THAT(captioned("It begins with $\\omega_1 = 0.5$ rad/s", vary), IsEmpty());
}

// 2026-11-28: honest numbers were nobody's.
TEST(TypedNumbers, AreOfTheBodyOfTheFilmAndOfArithmetic) {
  const auto of_disc = [](const std::string& text) {
    return complaints_of(
        text +
            "\n\n```scene\nbody = \"puck\"\nomega = [0, 0, 200]\nduration = 1.5\nrate = 0.2\n"
            "show = [\"omega\"]\n```\n",
        "[body.puck]\nshape = \"cylinder\"\nsize_m = [0.12, 0.12, 0.02]\nmass_kg = 1\n");
  };
  for (const char* text : {"The puck is 12 cm across and 2 cm thick.", "The film lasts 7.5 s.",
                           "With half the spin, 100 rad/s, it is slower.", "1 rpm is 0.105 rad/s."})
    EXPECT_THAT(of_disc(text), IsEmpty()) << text;
  for (const char* text : {"The puck is 13 cm across.", "The film lasts 8.5 s.",
                           "With half the spin, 120 rad/s, it is slower.", "1 rpm is 0.205 rad/s."})
    EXPECT_THAT(of_disc(text), Not(IsEmpty())) << text;
}

// 2026-11-28: heads of rows said another body and another time than their numbers have.
TEST(ComputedTables, HaveRowsOfWhatTheirHeadsSay) {
  const auto table = [](const std::string& head, const std::string& row) {
    return complaints_about(
        "```table\ncolumns = [{ head = \"" + head +
        "\" }, { head = \"angular speed\", of = \"norm(omega)\", unit = \"rad/s\" }]\nrows = [" + row +
        "]\n```");
  };
  EXPECT_THAT(table("body", R"({ head = '$I_3 = 9\,I_1$', body = "plate" })"), Not(IsEmpty()));
  EXPECT_THAT(table("body", R"({ head = '$I_3 > I_1$', body = "plate" })"), IsEmpty());
  EXPECT_THAT(table("time", R"({ head = "3 s", at = 2 })"), Not(IsEmpty()));
  EXPECT_THAT(table("time", R"({ head = "2 s", at = 2 })"), IsEmpty());
}

}  // namespace
}  // namespace polhode
