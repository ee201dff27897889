// SPDX-License-Identifier: MIT
// Units, words and names that a reader would see as false, and that once passed: each was found by an
// attacker.
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

std::string scene(const std::string& keys = "") {
  return "```scene\nshow = [\"omega\"]\n" + keys + "\n```\n";
}

void expect_refused(const std::string& body, const std::string& tables = "", const std::string& keys = "") {
  EXPECT_THAT(complaints_of(body + scene(keys), tables), Not(IsEmpty())) << body << tables << keys;
}
void expect_accepted(const std::string& body, const std::string& tables = "", const std::string& keys = "") {
  EXPECT_THAT(complaints_of(body + scene(keys), tables), IsEmpty()) << body << tables << keys;
}

TEST(FalseUnits, OfTurnsAndRadians) {
  for (const char* number :
       {R"(\live[unit={rad/s}]{w1/(2*pi)})", R"(\live[unit={deg/s}]{w1/(2*pi)})",
        R"(\live[unit={Hz}]{w1/2*pi})", R"(\live[unit={Hz}]{w1*2*pi/(2*pi)})",
        R"(\live[unit={rad/s}]{w1*pi/pi/2/pi})", R"(\value[unit={rad/s}]{0.30}{1/period})",
        R"(\live[unit={rad/s}]{w1 + w2/(2*pi)})", R"(\live[unit={rad}]{I1/I3})", R"(\live[unit={J/rad}]{T})",
        R"(\live[unit={rad^2 J}]{T})"})
    expect_refused("It is $" + std::string(number) + "$.\n");
  for (const char* number :
       {R"(\live[unit={Hz}]{w1/(2*pi)})", R"(\live[unit={rad/s}]{w1})", R"(\live[unit={deg/s}]{norm(omega)})",
        R"(\live[unit={rad/s}]{w1 + w2})", R"(\live[unit={rad}]{acos(dot(ez, e3))})"})
    expect_accepted("It is $" + std::string(number) + "$.\n");
}

TEST(FalseNames, OfConstantsAndDefinitions) {
  for (const char* tex : {"L", "L_z", "\\omega_x", "\\omega_{12}", "T_\\text{rot}", "\\Omega", "N", "\\tau",
                          "I", "I_4", "v", "p", "F"})
    expect_refused("Text.\n", "[constants]\nc = { value = 7, tex = '" + std::string(tex) + "' }\n");
  for (const char* definition :
       {R"x(means = "norm(omega)", tex = 'L')x", R"(means = "omega", tex = '\vec M')",
        R"x(means = "norm2(e1)", tex = 'L', say = "angular momentum")x", R"x(means = "norm(L)", tex = 'E')x",
        R"(means = "2*T", tex = 'b', say = "the angular momentum")"})
    expect_refused("Text.\n", "[define]\na = { " + std::string(definition) + " }\n");
  for (const char* symbols :
       {R"(omega = { tex = '\vec\omega', say = "angular momentum" })", R"(omega = { tex = '\vec L' })",
        R"(omega = { tex = '\vec\omega', role = "L" })", R"(omega = { tex = '\vec M' })"})
    expect_refused("Text.\n", "[symbols]\n" + std::string(symbols) + "\n");
  expect_accepted("Text.\n", R"([constants]
L0 = { value = 7, tex = 'L_0', unit = "kg m²/s" }
slow = { value = 4, tex = '\Omega', say = "rate of slow precession", unit = "rad/s" }
[define]
spin_a = { means = "e1 + e2", tex = '\vec\omega_A', role = "omega", say = "a spin" }
K = { means = "T", tex = 'K', say = "the kinetic energy", unit = "J" }
)");
}

TEST(FalseNames, UnderBraces) {
  expect_refused(
      "```math a identity\n\\underbrace{\\vec\\omega}_{\\text{angular momentum}} = \\vec\\omega\n```\n");
  expect_accepted(
      "```math a identity\n2\\,\\underbrace{T}_{\\text{kinetic energy}} = \\vec\\omega\\cdot\\vec L\n```\n");
}

TEST(FalseNames, InFormulasThatAreNotRead) {
  const auto claim = [](const char* tex) {
    return "```math a\n" + std::string(tex) + "\n```\n```claim a identity\n2*T = dot(omega, L)\n```\n";
  };
  expect_refused(claim("\\sinh T = \\vec\\omega\\cdot\\vec L"));
  expect_refused(claim("\\int \\vec L\\,dt = 2T\\,\\vec\\omega\\,\\vec L"));
  expect_refused(claim("2T! = \\vec\\omega\\cdot\\vec L + \\vec N!"));
  expect_accepted(claim("2T = \\vec\\omega\\bullet\\vec L"));
}

TEST(FalseNames, OfPlotsArrowsAnglesAndNotes) {
  for (const char* keys :
       {R"(meters = [{ plot = "T", tex = '-T' }])", R"(meters = [{ plot = "T", tex = '2T' }])",
        R"(meters = [{ plot = "w3", tex = '\omega_3^2' }])", R"(meters = [{ plot = "T", title = '$2T$' }])",
        R"(meters = [{ plot = "T", title = '$\omega_3$ over time' }])",
        R"x(meters = [{ plot = "norm(L)", tex = 'T' }])x",
        R"(meters = [{ plot = "T", title = "angular momentum" }])",
        R"(meters = [{ plot = "T", title = "energy, kJ" }])",
        R"(meters = [{ plot = "w3", tex = '\text{angular momentum}' }])",
        R"(arrows = [{ of = "L", tex = '\omega' }])", R"(arrows = [{ of = "L", tex = '\vec N' }])",
        R"(arrows = [{ of = "L", tex = '\text{angular velocity}' }])",
        R"(arrows = [{ of = "L", tex = '2\vec L' }])",
        R"(arrows = [{ of = "e3", tex = '\text{angular velocity}' }])",
        R"(angles = [{ from = "L", to = "omega", tex = '90^\circ' }])",
        R"(angles = [{ from = "L", to = "omega", tex = '\frac\pi2' }])",
        R"(angles = [{ from = "L", to = "omega", tex = '\omega' }])",
        R"(notes = [{ text = '$\vec\omega$ here', at = "L" }])",
        R"(notes = [{ text = 'tip of $\vec\omega$', at = "L" }])"})
    expect_refused("Text.\n", "", keys);
  for (const char* keys :
       {R"x(meters = [{ plot = "norm2(L)", tex = '|\vec L|^2' }])x",
        R"(meters = [{ plot = ["w1", "w3"], title = '$\omega_3$ and $\omega_1$ over time' }])",
        R"(meters = [{ plot = "T", title = "energy, mJ", unit = "mJ" }])",
        R"(meters = [{ plot = "w1*w2", tex = '(10)' }])", R"(arrows = [{ of = "e3", tex = '\theta' }])",
        R"(angles = [{ from = "e1", to = "e2", tex = '90^\circ' }])",
        R"(angles = [{ from = "e1", to = "e2", tex = '\frac\pi2' }])",
        R"(notes = [{ text = 'tip of $\vec L$', at = "L" }])"})
    expect_accepted("Text.\n", "", keys);
}

// 2026-11-27: of unit vectors only those were told apart that are more than a right angle from each other.
TEST(FalseNames, OfUnitVectors) {
  const std::string own = R"x([define]
n = { means = "e1", tex = '\hat n' }
y = { means = "ddt(L)", tex = '\vec y' }
[symbols]
trial = { means = "e1", tex = '\hat q', say = "a trial axis", unit = "1" }
)x";
  for (const char* keys :
       {R"(arrows = [{ of = 'e3', tex = '\hat e_1' }])", R"(arrows = [{ of = 'e1', tex = '\hat e_3' }])",
        R"(arrows = [{ of = 'ex', tex = '\hat e_z' }])", R"(arrows = [{ of = 'e1', tex = '\hat e_z' }])",
        R"(arrows = [{ of = 'e3', tex = '\hat n' }])", R"(arrows = [{ of = 'n', tex = '\hat e_3' }])",
        R"(arrows = [{ of = 'e1 + e2', tex = '\hat e_1' }])",
        R"(notes = [{ text = '$\hat e_3$', at = 'e1' }])"})
    expect_refused("Text.\n", own, keys);
  for (const char* keys :
       {R"(arrows = [{ of = 'e3', tex = '\hat e_3' }, { of = 'ez', tex = '\hat e_z' }])",
        R"(arrows = [{ of = 'e1', tex = '\hat n' }])", R"(arrows = [{ of = 'n', tex = '\hat e_1' }])",
        R"x(arrows = [{ of = 'cross(e1, e2)', tex = '\hat e_3' }])x",
        R"(arrows = [{ of = 'ey', tex = 'y' }])",  // a coordinate
        R"(notes = [{ text = '$\hat e_1$', at = 'e1' }])"})
    expect_accepted("Text.\n", own, keys);
  // A trial axis is no principal one.
  expect_accepted("Text.\n", own,
                  "omega = [0, 0, 0.2]\nduration = 2\narrows = [{ of = 'ex', tex = '\\hat q' }]");
}

// 2026-11-27: \dddot T = T, |\hat x|² = 4, 5O T = 5T and U^{-1} = 2T were proved of symbols so printed.
TEST(FalseNames, OfMarksDigitsAndPowers) {
  const auto with = [](const std::string& tex, const std::string& means) {
    return complaints_of("Text.\n", "[define]\na = { means = \"" + means + "\", tex = '" + tex + "' }\n");
  };
  const std::pair<const char*, const char*> refused[] = {{"\\dddot\\beta", "w1"},
                                                         {"\\ddddot\\beta", "w1"},
                                                         {"\\hat x", "2*ex"},
                                                         {"\\hat n_1", "L"},
                                                         {"\\widehat n", "L"},
                                                         {"\\hat c", "dot(ez, e3)"},
                                                         {"\\mathrm O", "dot(e1, e1)"},
                                                         {"\\iota", "dot(ez, e3)"},
                                                         {"o", "dot(ez, e3)"},
                                                         {"\\mathsf l", "dot(ez, e3)"},
                                                         {"U^{-1}", "2*T"},
                                                         {"U^{10}", "2*T"}};
  for (const auto& [tex, means] : refused) EXPECT_THAT(with(tex, means), Not(IsEmpty())) << tex;
  const std::pair<const char*, const char*> accepted[] = {{"\\hat x", "-1*ex"},
                                                          {"\\hat n", "L/norm(L)"},
                                                          {"\\kappa^2", "I1/I3"},
                                                          {"o_0", "dot(ez, e3)"},
                                                          {"l_0", "dot(ez, e3)"}};
  for (const auto& [tex, means] : accepted) EXPECT_THAT(with(tex, means), IsEmpty()) << tex;
}

TEST(FalseTables, InTheirHeads) {
  const auto typed = [](const std::string& head, const std::string& number) {
    return "| a | " + head + " |\n|---|---|\n| b | $\\live{" + number + "}$ |\n\n";
  };
  for (const char* head : {"$T$, kJ", "$T$ [kJ]", "$T$ kJ", "energy/kJ", "energy, kJ", "the $|\\vec L|$",
                           "energy $|\\vec L|$", "angular momentum", "the angular momentum", "$L$", "W"})
    expect_refused(typed(head, "T"));
  for (const char* head :
       {"$T$, J", "$T$ [J]", "$T$ J", "energy/J", "the energy $T$", "energy", "$E$", "what $T$ was"})
    expect_accepted(typed(head, "T"));
  expect_refused("| a | b | unit |\n|---|---|---|\n| $T$ | $\\live{T}$ | kJ |\n\n");
  expect_refused("| a | b | |\n|---|---|---|\n| $T$ | $\\live{T}$ | million |\n\n");
  expect_accepted("| a | b | unit |\n|---|---|---|\n| $T$ | $\\live{T}$ | J |\n\n");
}

TEST(FalseTables, InTheHeadsOfTheirRows) {
  const auto computed = [](const std::string& row, const char* head = "energy") {
    return "```table\ncolumns = [{ head = \"\" }, { head = '" + std::string(head) +
           "', of = \"T\" }]\nrows = [{ " + row + " }]\n```\n";
  };
  for (const char* row : {R"(head = '$t = 2$ s', at = 1)", R"(head = '$t = 2\,\text{s}$', at = 1)",
                          R"(head = '$\omega_3 = 5$', omega = [0, 0, 1])",
                          R"(head = '$\omega_3 = 1$ deg/s', omega = [0, 0, 1])", R"(head = '$\omega_3$')"})
    expect_refused(computed(row));
  for (const char* row : {R"(head = '$t = 1$ s', at = 1)",
                          R"(head = '$\omega_3 = 1$ rad/s', omega = [0, 0, 1])", R"(head = '$10^{-3}$')"})
    expect_accepted(computed(row));
  expect_refused(computed("head = \"a\"", "period, ms"));
  expect_refused(computed("head = \"a\"", "angular momentum"));
}

TEST(FalseWords, AroundNumbers) {
  const std::string number = "$\\live{T}$", in_joules = "$\\live[unit={J}]{T}$";
  for (const std::string& text : std::vector<std::string>{"It is " + in_joules + " per second.",
                                                          "It is " + in_joules + "/s.",
                                                          "It is " + in_joules + " $\\text{/s}$.",
                                                          "It is " + number + " (kJ).",
                                                          "It is " + number + "\\\nkJ.",
                                                          "It is " + number + " percent.",
                                                          "It is minus " + number + ".",
                                                          "It is twice " + number + ".",
                                                          "It is one million times " + number + ".",
                                                          "The energy in kJ is " + number + ".",
                                                          "The energy in mJ: " + number + ".",
                                                          "The momentum $|\\vec L|$ is " + number + ".",
                                                          "The angular momentum $L$ is " + number + ".",
                                                          "The angular momentum is " + in_joules + ".",
                                                          "$\\theta$ is " + in_joules + ".",
                                                          "$2T$ is " + number + ".",
                                                          "$2T$: " + number + ".",
                                                          "It is " + number + " Kilo-Joules.",
                                                          "It is " + number + ", in kJ.",
                                                          "$T$ is more than $\\live{2*T}$."})
    expect_refused(text + "\n");
  for (const std::string& text : std::vector<std::string>{
           "It is " + in_joules + " per turn.", "It is " + number + " (J).",
           "The energy in J is " + number + ".", "The energy $T$ is " + number + " J.",
           "The kinetic energy is " + in_joules + ".", "It turns $\\live{w1/(2*pi)}$ times per second.",
           "$2T$ is more than " + number + ".", "At times " + in_joules + "!",
           "It is " + number + " in Joule."})
    expect_accepted(text + "\n");
}

TEST(FalseCaptions, OfOnePictureOrOfSeveral) {
  for (const char* keys :
       {R"(caption = '$T = 3$')", R"(caption = "T = 3 kJ")", R"(caption = '$\omega_3 = 4$ rad/s')",
        "vary = { omega3 = { from = 1, to = 9 } }\ncaption = '$\\omega_3 = 3$'",
        "scenes = [{ omega = [1, 0, 0] }, { omega = [2, 0, 0] }]\ncaption = '$\\omega_1 = 1$'",
        "scenes = [{ omega = [1, 0, 0] }, { omega = [0, 0, 2], caption = '$\\omega_3 = 9$' }]"})
    expect_refused("Text.\n", "", keys);
  for (const char* keys : {R"(caption = '$\omega_3 = 3.0$ rad/s')",
                           "vary = { omega3 = { from = 1, to = 9 } }\ncaption = '$\\omega_1 = 0.2$ rad/s'"})
    expect_accepted("Text.\n", "", keys);
}

// 2026-11-27: a number had an arrow, a vector none, and the x-component of L the index z.
TEST(FalseNames, OfVectorsAndTheirComponents) {
  for (const char* definition :
       {R"x(means = "T", tex = '\vec n', unit = "J")x", R"x(means = "2*L", tex = 'b', unit = "kg m²/s")x",
        R"x(means = "dot(L, ex)", tex = 'L_z', unit = "kg m²/s")x",
        R"x(means = "dot(ez, e3)", tex = '\theta', unit = "1")x",
        R"x(means = "dot(omega, ey)", tex = '\omega_x', unit = "rad/s")x"})
    expect_refused("Text.\n", "[define]\na = { say = \"it\", " + std::string(definition) + " }\n");
  for (const char* definition : {R"x(means = "2*L", tex = '\vec b', unit = "kg m²/s")x",
                                 R"x(means = "dot(L, ez)", tex = 'L_z', unit = "kg m²/s")x"})
    expect_accepted("Text.\n", "[define]\na = { say = \"it\", " + std::string(definition) + " }\n");
}

// 2026-11-27: "c > 0" was assumed of a c that the lesson gives as -2.
TEST(FalseNames, OfAssumptionsAgainstConstants) {
  const std::string constant = "[constants]\nc = { value = -2, tex = 'c_0' }\n[assume]\n";
  expect_refused("Text.\n", constant + "pos = \"c > 0\"\n");
  expect_accepted("Text.\n", constant + "neg = \"c < 0\"\n");
}

}  // namespace
}  // namespace polhode
