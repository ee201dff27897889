// SPDX-License-Identifier: MIT
// Formulas around computed numbers that a reader would see as false, and that once passed: each was found by
// an attacker.
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using testing::complaints_of;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kScene = "```scene\nshow = [\"omega\"]\n```\n";

/// In a line of text, and displayed.
void expect_refused(const std::string& tex) {
  EXPECT_THAT(complaints_of("```math a\n" + tex + "\n```\n" + kScene), Not(IsEmpty())) << tex;
  EXPECT_THAT(complaints_of("Here $" + tex + "$.\n" + kScene), Not(IsEmpty())) << tex;
}
void expect_accepted(const std::string& tex) {
  EXPECT_THAT(complaints_of("Here $" + tex + "$.\n" + kScene), IsEmpty()) << tex;
}

TEST(FalseNumbers, HaveNothingBesideThemThatStatesNothing) {
  for (const char* tex :
       {R"(T = \live{T}\quad\mathrm{kJ})", R"(T = \live{T}\quad k J)", R"(T = \live{T},\ \mathrm{kJ})",
        R"(T = \live{T}, \quad \text{in kJ})", R"(T = \live{T}\quad 10^3)", R"(T = \live{T},\; \cdot 10^3)",
        R"(- , T = \live{T})", R"(2\quad T = \live{T})", R"(2, T = \live{T})", R"(\lnot\quad T = \live{T})",
        R"(\text{not:}\quad T = \live{T})", R"(\text{per hour: } T = \live{T})", R"(T \quad \live{w3})",
        R"(T, \live{w3})", R"(T; \live{w3})"})
    expect_refused(tex);
  for (const char* tex :
       {R"(\begin{gathered}T = \live{T}\\ \times 10^{3}\end{gathered})",
        R"(\begin{aligned}T &= \live{T}\\ &\mathrm{kJ}\end{aligned})", R"(T = \live{T} \tag{kJ})"})
    EXPECT_THAT(complaints_of(std::string("```math a\n") + tex + "\n```\n" + kScene), Not(IsEmpty())) << tex;
}

TEST(FalseNumbers, HaveBothSidesOfTheirSigns) {
  for (const char* tex :
       {R"(T = \quad \live{w3})", R"(T\quad = \live{w3})", R"(T, = \live{w3})", R"(T = ,\live{w3})",
        R"(\begin{gathered}T=\\\live{w3}\end{gathered})", R"(\live{w3} > \text{a lot})"})
    expect_refused(tex);
}

TEST(FalseNumbers, AreThoseOfAnotherSideThatIsDefinite) {
  for (const char* tex : {R"(\pi = \live{w3})",
                          R"(2\pi = \live{w3})",
                          R"(\frac{\pi}{2} = \live{w3})",
                          R"(5! = \live{w3})",
                          R"(1 = \live{T/T}\,\%)",
                          R"(e = \live{w3})",
                          R"(\infty = \live{w3})",
                          R"(7\times2 = \live{w3})",
                          R"(7\,2 = \live{w3})",
                          R"(90^\circ = \live[unit={deg}]{atan2(w1,w2)})",
                          R"(5\,\mathrm{J} = \live{2*T})",
                          R"(\live{T} > 100\,\mathrm{MJ})",
                          R"(45\,\text{J} < \live{T} < 45.1\,\text{J})",
                          R"(\live{w3} > 10\pi)",
                          R"(\live{w3} > \tan 1.57)",
                          R"(t = \live{T})",
                          R"(t > \live{T})",
                          R"(T(0) = \live{w3})",
                          R"(T(t) = \live{w3})",
                          R"(\ln T = \live{T})",
                          R"(\max T = \live{w3})",
                          R"(\int T\,dt = \live{T})",
                          R"(|\omega_1| = \live{w3})",
                          R"(\sqrt[3]{T} = \live{T})",
                          R"(\overline{T} = \live{w3})",
                          R"(\mathrm{T} = \live{w3})",
                          R"(\mathbf{T} = \live{w3})",
                          R"(\operatorname{T} = \live{w3})",
                          R"(T_0 = \live{w3})",
                          R"(T_{\text{kin}} = \live{w1})",
                          R"(\Delta T = \live{w3})",
                          R"(\omega_z = \live{w1})",
                          R"(L_x = \live{w1})",
                          R"(\omega = \live{T})",
                          R"(\omega^2 = \live{w1})",
                          R"(L = \live{w1})",
                          R"(\frac12 L = \live{w1})",
                          R"(I = \live{T})",
                          R"(E = \live{w1})",
                          R"(\theta = \live{T})",
                          R"(\text{energy} = \live{w1})",
                          R"(\omega_3\,\mathrm{s} = \live{w1})",
                          R"(\vec\omega\bullet\vec L = \live{w1})",
                          R"(\vec L = \live{w1})",
                          R"(\dddot\omega_1 = \live{w3})",
                          R"(T_{t=5} = \live{w3})",
                          R"(3\sqrt{2}\,\text{J} = \live{T})"})
    expect_refused(tex);
}

TEST(FalseNumbers, InListsAreComparedOneByOne) {
  for (const char* tex :
       {R"((T, \omega_1) = (\live{w3}, \live{w2}))", R"(T = [\live{w3}, \live{w2}])",
        R"(\vec L = (\live{w3}, \live{T}))", R"(\vec L = [\live{w1}, \live{w2}, \live{w3}])",
        R"(\vec M = (\live{w1}, \live{w2}, \live{w3}))", R"(T, \omega_1 = \live{T}, \live{w2})",
        R"(\begin{pmatrix}T\\ \omega_1\end{pmatrix} = \begin{pmatrix}\live{w3}\\ \live{w2}\end{pmatrix})",
        R"(\begin{matrix}T & = & \live{w3}\end{matrix})", R"(\begin{array}{rcl}T & = & \live{w3}\end{array})",
        R"(\begin{array}{rl}T = & \live{w3}\end{array})", R"(\vec\omega = (\live{w1}, x, \live{w3}))"})
    expect_refused(tex);
}

TEST(TrueNumbers, AreAcceptedBesideWhatIsReadOrNothingKnown) {
  for (const char* tex :
       {R"(2\pi/2 = \live[digits=3]{pi})", R"(T > 1\,\mathrm{mJ} < \live{T})", R"(\alpha = \live{I1/I3})",
        R"(\Delta t = \live[unit={s}]{1/w3})", R"(\sin\alpha_{\text{max}} = \live{I1/I3})",
        R"(E_0 = \live[unit={J}]{T})", R"(\frac{1}{\sigma} = \live{I1/I3})",
        R"((T, \omega_1) = (\live{T}, \live{w1}))", R"(\vec r = (\live{w1}, \live{w2}, \live{w3}))",
        R"(\omega_1 = \live{w1},\quad \omega_2 = \live{w2} \quad\text{and}\quad \omega_3 = \live{w3})",
        R"(\live{w1},\; \live{w2},\; \live{w3})", R"(\live{w1}, \ldots, \live{w3})",
        R"(P = \live[unit={s}]{1/w3})", R"(p = \live{I3/I1})", R"(m\,v^2 = \live[unit={J}]{T})",
        R"(\dot\varphi = \live{w3})", R"(\vec L = [\live{comp(L, 1)}, \live{comp(L, 2)}, \live{comp(L, 3)}])",
        R"(0 \le \live[unit={deg}]{acos(dot(ez, e3))} \le 180^\circ)"})
    expect_accepted(tex);
}

}  // namespace
}  // namespace polhode
