// SPDX-License-Identifier: MIT
#include "lessons/notation/tex_equation.h"

#include "lessons/claims/proof/proof.h"
#include "lessons/reader/checks/claim_check.h"
#include "lessons/reader/reader.h"
#include "tests/fuzz/mutate.h"
#include "tests/lessons/peak_memory.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <limits>
#include <set>

namespace polhode {
namespace {

using ::testing::HasSubstr;

Math math_of(const std::string& tex) {
  auto math = parse_math(tex);
  if (!math) throw std::invalid_argument(tex + ": " + math.error().front().message);
  return *math;
}

EquationNotation notation_with(const std::vector<std::pair<std::string, std::string>>& means) {
  EquationNotation notation;
  for (const auto& [tex, meaning] : means) notation.symbols.push_back({tex, math_of(tex), meaning});
  return notation;
}

std::string text_of(const Equality& equality) { return equality.left.text + " = " + equality.right.text; }

/// "left = right; left = right", or "? reason".
std::string reading(const std::string& tex, const EquationNotation& notation = {}) {
  const auto read = read_equation(math_of(tex), notation);
  if (!read) return "? " + read.error().reason;
  std::string all;
  for (const EquationSentence& sentence : read->sentences) {
    if (sentence.joint == EquationSentence::Joint::follows) all += "=> ";
    if (sentence.joint == EquationSentence::Joint::does_not_follow) all += "/=> ";
    for (const EquationLink& link : sentence.links) all += text_of(link.equality) + "; ";
  }
  return all.substr(0, all.size() - 2);
}

struct Read {
  const char *tex, *claim;
};

TEST(TexEquation, MeansWhatIsPrinted) {
  const Read cases[] = {
      {R"(\frac{d\vec L}{dt} = \vec N)", "ddt(L) = N"},
      {R"(\frac{d^2\vec L}{dt^2} = \frac{d\vec N}{dt})", "ddt(ddt(L)) = ddt(N)"},
      {R"(\frac{d^2}{dt^2}\left(\omega_1^2\right) = 0)", "ddt(ddt(w1^2)) = 0"},
      {R"(\frac{d}{dt}\frac{d^*\vec A}{dt} = 0)", "ddt(star(A)) = 0"},
      {R"(\ddot\omega_1 = -\ddot\omega_2)", "ddt(dw1) = -ddt(dw2)"},
      {R"(\ddot T = 0)", "ddt(ddt(T)) = 0"},
      {R"(\ddot{A_1} = 0)", "ddt(ddt(comp(A, 1))) = 0"},
      {R"(\frac{d^*\vec L}{dt} + \vec\omega\times\vec L = \vec N)", "star(L) + cross(omega, L) = N"},
      {R"(\frac{d^*}{dt}\left(\mathbf I\cdot\vec\omega\right) = 0)", "star(inertia(omega)) = 0"},
      {R"(d^*\vec L/dt = -\vec\omega\times\vec L)", "star(L) = -cross(omega, L)"},
      {R"(\mathbf I\cdot\dot{\vec\omega} = \vec N)", "inertia(star(omega)) = N"},
      {R"(I_1\dot\omega_1 + \omega_2\omega_3\,(I_3 - I_2) = N_1)", "I1*dw1 + w2*w3*(I3 - I2) = N1"},
      {R"(\dot{\omega_1} = \dot{\omega}_1)", "dw1 = dw1"},
      {R"(\dot T = \vec N\cdot\vec\omega)", "ddt(T) = dot(N, omega)"},
      {R"(2T = \vec\omega\cdot\mathbf I\cdot\vec\omega)", "2*T = dot(omega, inertia(omega))"},
      {R"(\mathbf I\vec\omega = \vec L)", "inertia(omega) = L"},
      {R"(m\,\vec v\times\vec p = 0)", "cross(m*v, p) = 0"},
      {R"(\vec\omega\cdot\vec\omega\times\vec L = 0)", "dot(omega, cross(omega, L)) = 0"},
      {R"(\vec\omega\times\vec L\cdot\vec\omega = 0)", "dot(cross(omega, L), omega) = 0"},
      {R"(\vec\omega\times\mathbf I\cdot\vec\omega = 0)", "cross(omega, inertia(omega)) = 0"},
      {R"([\vec\omega]_\times\mathbf I\cdot\hat e_1 = 0)", "cross(omega, inertia(e1)) = 0"},
      {R"(|\vec L|^2 = \vec L^2)", "norm2(L) = norm2(L)"},
      {R"(|\vec L| = \left|\vec p\right|)", "norm(L) = norm(p)"},
      {R"(\frac{d|\vec L|}{dt} = 0)", "ddt(norm2(L)) = 0"},
      {R"(T = \tfrac12\,\omega_1^2 I_1/2)", "T = 1/2*w1^2*I1/2"},
      {R"(-(I_1 - I_2) = 1.5)", "-(I1 - I2) = 1.5"},
      {R"(\frac{a}{b} = 1)", "? the language of claims does not know this symbol"},
      {R"(\frac{I_1}{I_2 I_3} = 1)", "I1/(I2*I3) = 1"},
      {R"(\vec A = \sum_i A_i\,\hat e_i)", "A = comp(A, 1)*e1 + comp(A, 2)*e2 + comp(A, 3)*e3"},
      {R"(T = \sum_{i=1}^{3} \omega_i + m)", "T = w1 + w2 + w3 + m"},
      {R"(\omega_i = 1 \qquad (i = 1, 2, 3))", "w1 = 1; w2 = 1; w3 = 1"},
      {R"(I_i = \omega_j \qquad (\{i, j, k\} = \{1, 2, 3\}))",
       "I1 = w2; I1 = w3; I2 = w1; I2 = w3; I3 = w1; I3 = w2"},
      {R"(\vec\omega\times\vec A = 0 \qquad (\vec\omega = \omega_3\hat e_3))", "cross(w3*e3, A) = 0"},
      {R"(\omega_1\omega_2 = 0 \qquad (\omega_2 = 0))", "w1*0 = 0"},
      {R"(I_1 = I_2 = I_3)", "I1 = I2; I2 = I3"},
      {R"(\begin{aligned} T &= m \\ &= I_1 \\ &\quad - I_2 \end{aligned})", "T = m; m = I1 - I2"},
      {R"(\begin{aligned} &T + m \\ &\; - I_1 = 0 \end{aligned})", "T + m - I1 = 0"},
      {R"(\begin{aligned} T &= m \\ -I_1 &= 0 \end{aligned})", "T = m; -I1 = 0"},
      {R"(\vec p = m\,\vec v\,,\qquad \vec L = \mathbf I\cdot\vec\omega)", "p = m*v; L = inertia(omega)"},
      {R"(\vec N = 0 \;\Rightarrow\; \dot T = 0)", "N = 0; => ddt(T) = 0"},
      {R"(\dot T = 0 \quad\text{does not give}\quad \vec N = 0)", "ddt(T) = 0; /=> N = 0"},
      {R"(\underbrace{m\vec v}_{\vec p} = \vec p \tag{1})", "m*v = p; m*v = p"},
      {R"(\underbrace{m\vec v}_{\text{momentum}} = \vec p.)", "m*v = p"},
      {R"(m + \cancel{I_1} - \cancel{I_1} = m)", "m + I1 - I1 = m; m = m"},
      {R"(\cancel{I_2}\,m = \cancel{I_2}\,T)", "I2*m = I2*T; m = T"},
      {R"(\boxed{\term{a}{T} = m})", "T = m"},
      {R"(T = \text{const})", "ddt(T) = 0"},
      {R"(|\vec L|^2 = \mathrm{const.})", "ddt(norm2(L)) = 0"},
      {R"(\vec L = \text{const.})", "ddt(L) = 0"},
      {R"(\dot{\vec L} = \vec N)", "ddt(L) = N"},
      {R"(L_i = I_i\,\omega_i)", "comp(L, 1) = I1*w1; comp(L, 2) = I2*w2; comp(L, 3) = I3*w3"},
      {R"({\omega_1 + \omega_2}\,T = 0)", "w1 + w2*T = 0"},  // braces of TeX are not seen
      {R"(T = \live[unit={J}]{2*T})", "T = (2*T)"},
      {R"(\begin{aligned} T &= m & I_1 &= I_2 \\ I_1 &= 2 \end{aligned})", "T = m; I1 = I2; I1 = 2"},
      {R"(\begin{vmatrix} \omega_1 & \omega_2 \\ I_1 & I_2 \end{vmatrix} = 0)", "w1*I2 - w2*I1 = 0"},
      {R"(\mathbf 1\cdot\vec A = \vec A)", "A = A"},
      {R"(T = \sqrt{m\,T})", "T = sqrt(m*T)"},
      {R"(\sin T = \cos^2(T + m))", "sin(T) = cos(T + m)^2"},
      {R"(\arccos T\cos m = m\sin T)", "acos(T)*cos(m) = m*sin(T)"},
      {R"((\vec\omega\times\mathbf I\cdot\vec\omega)_1 = I_{12})",
       "comp(cross(omega, apply(J, omega)), 1) = Jxy"},
  };
  for (const Read& one : cases) EXPECT_EQ(reading(one.tex), one.claim) << one.tex;
}

TEST(TexEquation, RefusesWhatThePageLeavesOpen) {
  const Read cases[] = {
      {R"(\vec A\times\vec L\times\vec N = 0)", "more than one reading"},
      {R"(\vec A\cdot\vec L\cdot\vec N = 0)", "more than one reading"},
      {R"(\mathbf I\cdot\vec\omega\times\vec\omega = 0)", "before or behind this product"},
      {R"(\vec\omega\cdot\mathbf I = 0)", "applied to"},
      {R"(\vec A\,\vec L = 0)", "two vectors without a sign"},
      {R"(\vec\omega\,\mathbf I = 0)", "a vector and a tensor"},
      {R"(1/I_1\,\omega_1 = 0)", "how far does this fraction go"},
      {R"(m/I_1/I_2 = 0)", "how far does this fraction go"},
      {R"(m/I_1\cdot\omega_1 = 0)", "how far does this fraction go"},
      {R"(\frac{d}{dt}\vec L\cdot\vec L = 0)", "derivative end"},
      {R"(\frac{d}{dt}(\vec L)\,m = 0)", "how far does this derivative go"},
      {R"(\frac{d^2\vec L}{dt} = 0)", "only d and d^*"},
      {R"(\frac{d^2\vec L}{d^2t} = 0)", "does not know this symbol"},
      {R"(\ddot{\vec\omega} = 0)", "in which frame"},
      {R"(\dot{\dot\omega}_1 = 0)", "dots above dots"},
      {R"(\dddot\omega_1 = 0)", "mark above"},
      {R"(\frac{d^3\vec L}{dt^3} = 0)", "does not know this symbol"},
      {R"(\ddot{\vec L} = \vec N)", "in which frame"},
      {R"(T = \text{const} = 5)", "ends a chain"},
      {R"(T = \text{const} \quad (\omega_2 = 0))", "under a condition"},
      {R"(T(0) = m)", "argument, or a factor"},
      {R"(\omega_1(m) = m)", "argument, or a factor"},
      {R"(2\tfrac12 = m)", "added to the number"},
      {R"(1\,000 = m)", "another number"},
      {R"(\omega_1 2 = m)", "a number stands behind a factor"},
      {R"(T + -m = 0)", "two signs"},
      {R"(T \pm m = 0)", "does not know this symbol"},
      {R"(I_i\,\omega_i = 0)", "index is free"},
      {R"(\sum_i m = 0)", "occurs nowhere"},
      {R"(\sum m = 0)", "a sum over what"},
      {R"(\sum_i\sum_i I_i = 0)", "stands for something already"},
      {R"(\vec A\times\sum_i\hat e_i\times\vec L = 0)", "how far does this sum go"},
      {R"(T \ne m)", "only = < >"},
      {R"(T \sim m)", "only = < >"},
      {R"(T = m \quad\text{for all } m)", "wide space"},
      {R"(T = m \quad I_1 = I_2)", "wide space"},
      {R"(T = \sqrt[3]{m})", "only square roots"},
      {R"(T = \sqrt{\vec L})", "roots are taken of numbers"},
      {R"(\sin = m)", "sin\" of what?"},
      {R"(\sin\vec L = m)", "functions are taken of numbers"},
      {R"(\sin 2T = m)", "how far does the argument"},
      {R"(\sin T m = m)", "how far does the argument"},
      {R"(\tan T = m)", "no function tan"},
      {R"(\sin_1 T = m)", "of what?"},
      {R"(T' = m)", "powers are whole numbers"},
      {R"(T^{1.5} = m)", "powers are whole numbers"},
      {R"(T^{17} = m)", "at most 16"},
      {R"(L = m)", "does not know this symbol"},
      {R"(\vec L_S = 0)", "vector with an index"},
      {R"(\omega_x = 0)", "this index is not read"},
      {R"(\hat i = 0)", "unit vector"},
      {R"(T = 1.4\ \text{J})", "words in a formula"},
      {R"({T + m}^2 = 0)", "group"},
      {R"(T\times m = 0)", "× stands between vectors"},
      {R"(T + \vec L = 0)", "cannot be added"},
      {R"(T = \vec L)", "cannot be equal"},
      {R"((T = m)", "never closed"},
      {R"((T] = m)", "closes nothing"},
      {R"(T)", "no = here"},
      {R"(= T)", "a side is missing"},
      {R"(\frac{d^2\vec N}{dt^2} = 0)", "rate of change of this is not known"},
      {R"(I_{12} = I_1)", "principal moments"},
      {R"(\begin{aligned} T &= m \\ &- I_1 = 0 \end{aligned})", "go on with the one above"},
      {R"(\dot{\vec\omega} = 0 \qquad (\vec\omega = \omega_3\hat e_3))", "under a condition"},
      {R"(\vec L = 0 \qquad (\omega_1 = 0))", "under a condition"},
      {R"(\frac{d^*\vec L}{dt} = 0 \quad\text{in } S)", "as seen from the body"},
      {R"(m - \underbrace{T + m}_{T} = 0)", "hold this sum together"},
      {R"(\vec\omega\times\cancel{\vec\omega} = \vec L)", "what is left"},
      {R"(T \cancel{-} m = 0)", "what is left"},
      {R"(T \cancel{=} m)", "struck out"},
      {R"(\mathcal T = m)", "alphabet"},
      {R"(\mathbb 1 = m)", "alphabet"},
      {R"(\vec{\mathcal L} = 0)", "alphabet"},
      {R"(\mathrm T = m)", "alphabet"},
  };
  for (const Read& one : cases)
    EXPECT_THAT(reading(one.tex), ::testing::AllOf(::testing::StartsWith("? "), HasSubstr(one.claim)))
        << one.tex;
}

TEST(TexEquation, PointsIntoTheTex) {
  const auto place = [](const std::string& tex) {
    const auto read = read_equation(math_of(tex), {});
    return read.ok()
               ? "read"
               : tex.substr(read.error().place.begin, read.error().place.end - read.error().place.begin);
  };
  EXPECT_EQ(place(R"(\frac{d\vec L}{dt} = \vec Q)"), R"(\vec Q)");
  EXPECT_EQ(place(R"(T = I_1 + I_4)"), "I_4");
  EXPECT_EQ(place(R"(T + m = \vec L)"), R"(T + m = \vec L)");
  EXPECT_EQ(place(R"(m + T^{99} = m)"), "{99}");
  const auto read = read_equation(math_of(R"(T = m = I_1)"), {});
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->sentences[0].links[1].source, (SourceSpan{4, 11}));
}

TEST(TexEquation, TakesSymbolsOfTheLesson) {
  const EquationNotation notation = notation_with({{R"(\tan\alpha)", "w1/w3"},
                                                   {R"(\omega_\parallel)", "dot(omega, L)/I1"},
                                                   {R"(\kappa^2)", "I1/I3"},
                                                   {R"(\vec H)", "L"},
                                                   {"h", "m"},
                                                   {R"(\vec L')", "L + m*N"}});
  EXPECT_EQ(reading(R"(\tan\alpha = \omega_1/\omega_3)", notation), "(w1/w3) = w1/w3");
  EXPECT_EQ(reading(R"(\omega_\parallel^2 = \kappa^2)", notation), "(dot(omega, L)/I1)^2 = (I1/I3)");
  EXPECT_EQ(reading(R"(\vec L' = \vec H + h\,\vec N)", notation), "(L + m*N) = L + m*N");
  EXPECT_EQ(reading(R"(\tan^2\alpha = 1)", notation), "? the language of claims has no function tan");
  EXPECT_EQ(reading(R"(\kappa = 1)", notation), "? the language of claims does not know this symbol");
}

TEST(TexEquation, WhatALessonDeclaresHidesWhatIsBuiltIn) {
  EquationNotation notation;
  notation.symbols.push_back({"period", math_of("T"), ""});
  EXPECT_THAT(reading("T = m", notation), HasSubstr("has no meaning"));
  notation.symbols[0] = {"T", math_of("T"), ""};
  EXPECT_EQ(reading("T = m", notation), "T = m");
  notation.symbols[0] = {"T", math_of("T"), "I1"};
  EXPECT_EQ(reading("T = m", notation), "I1 = m");
  notation.symbols[0] = {"T", math_of("T"), "I1 +"};
  EXPECT_THAT(reading("T = m", notation), HasSubstr("cannot be read"));
}

TEST(TexEquation, AxesXYZAreTheBodysWhereTheLessonSaysSo) {
  EquationNotation notation;
  notation.xyz_are_body_axes = true;
  EXPECT_EQ(reading(R"(I_x\dot\omega_x\,\hat i = N_z\,\hat k)", notation), "I1*dw1*e1 = N3*e3");
  EXPECT_EQ(reading(R"(I_{yx} = \omega_y)", notation), "Jxy = w2");
  EXPECT_EQ(reading(R"(\text{tempting on any axes:}\quad \hat e_x\cdot\mathbf I\cdot\hat e_y = 0)", notation),
            "dot(e1, apply(J, e2)) = 0");
}

TEST(TexEquation, GoesOnWithTheOneAbove) {
  const Math above = math_of(R"(I_1(I_3 - I_2)\,,)"), math = math_of(R"({} = I_1I_3 - I_1I_2)");
  const auto read = read_equation(math, {}, &above);
  ASSERT_TRUE(read.ok()) << read.error().reason;
  EXPECT_EQ(text_of(read->sentences[0].links[0].equality), "I1*(I3 - I2) = I1*I3 - I1*I2");
  const Math words = math_of(R"(T \quad\text{so})");
  EXPECT_FALSE(read_equation(math, {}, &words).ok());
}

std::string lines_of_kind(const std::string& tex, ClaimKind kind) {
  const auto read = read_equation(math_of(tex), {});
  if (!read) return "? " + read.error().reason;
  const auto lines = claim_lines_of(*read, kind, [](SourceSpan) { return SourcePlace{3, 1}; });
  if (!lines) return "? " + lines.error().reason;
  std::string all;
  for (const ClaimLine& line : *lines)
    all += text_of(line.equality) + (line.conclusion ? " => " + text_of(*line.conclusion) : "") + "; ";
  return all;
}

TEST(TexEquation, LinesOfAClaimDependOnItsKind) {
  EXPECT_EQ(lines_of_kind(R"(\vec N = 0 \Rightarrow \dot T = 0)", ClaimKind::free), "ddt(T) = 0; ");
  EXPECT_EQ(lines_of_kind(R"(\vec N = 0:\quad \dot T = 0\,,\quad T = m)", ClaimKind::free),
            "ddt(T) = 0; T = m; ");
  EXPECT_EQ(lines_of_kind(R"(T = m \quad\text{does not give}\quad I_1 = m)", ClaimKind::non_sequitur),
            "T = m => I1 = m; ");
  EXPECT_THAT(lines_of_kind(R"(T = m \quad\text{does not give}\quad I_1 = m)", ClaimKind::free),
              HasSubstr("?"));
  EXPECT_THAT(lines_of_kind(R"(T = m)", ClaimKind::non_sequitur), HasSubstr("?"));
  EXPECT_THAT(lines_of_kind(R"(\text{tempting:}\quad T = m)", ClaimKind::free), HasSubstr("?"));
  EXPECT_EQ(lines_of_kind(R"(\text{tempting:}\quad T = m)", ClaimKind::is_false), "T = m; ");
  EXPECT_THAT(lines_of_kind(R"(T = m = I_1)", ClaimKind::is_false), HasSubstr("which of these"));
  EXPECT_THAT(lines_of_kind(R"(|\vec L|\,m = T)", ClaimKind::identity), HasSubstr("root"));
  EXPECT_EQ(lines_of_kind(R"(|\vec L|\,m = T)", ClaimKind::measured), "norm(L)*m = T; ");
  EXPECT_THAT(lines_of_kind(R"(T = m \qquad (\vec N = 0))", ClaimKind::motion), HasSubstr("no torque"));
  EXPECT_EQ(lines_of_kind(R"(\frac{d\vec L}{dt} = 0 \Rightarrow \dot T = 0)", ClaimKind::motion),
            "ddt(L) = 0 => ddt(T) = 0; ");
  EXPECT_EQ(lines_of_kind(R"(I_2 = I_1 \Rightarrow \dot\omega_3 = 0 = m)", ClaimKind::free),
            "I2 = I1 => dw3 = 0; I2 = I1 => 0 = m; ");
  for (const char* open :
       {R"(I_2 = I_1 \Rightarrow \dot\omega_3 = 0, \quad T = m)",
        R"(T = m, \quad I_2 = I_1 \Rightarrow \dot\omega_3 = 0)", R"(I_2 = I_1 = m \Rightarrow T = m)",
        R"(T = m \Rightarrow I_1 = m \Rightarrow I_2 = m)"})
    EXPECT_THAT(lines_of_kind(open, ClaimKind::motion), HasSubstr("follows from what")) << open;
  EXPECT_THAT(lines_of_kind(R"(I_2 = I_1 \Rightarrow T = m)", ClaimKind::is_false), HasSubstr("neither"));
  EXPECT_EQ(lines_of_kind(R"(T \ge 0, \quad m > 0)", ClaimKind::identity), "T = 0; m = 0; ");
  EXPECT_THAT(lines_of_kind(R"(T \ge 0)", ClaimKind::measured), HasSubstr("not of this kind"));
}

// What looks otherwise than it is read, or was read in one of two senses. Found by an attacker, 2026-11-23.
TEST(TexEquation, WhatLooksOtherwiseIsRefused) {
  for (const char* tex :
       {R"(\mathbf I_S = \begin{pmatrix} I_1 & 0 & 0 \\ 0 & I_2 & 0 \\ 0 & 0 & I_3 \end{pmatrix})",
        R"(\mathbf I_S = \mathbf I)",
        R"(\frac{d}{dt}\begin{pmatrix} 1 & 0 & 0 \\ 0 & 2 & 0 \\ 0 & 0 & 3 \end{pmatrix}\vec\omega = 0)",
        R"(1\live{T} = T)", R"(\live{T} = T)", R"(T - \live{-1*T} = 2T)",
        R"(\live{w1}\vec L = \omega_1\vec L)", R"(\hspace{1.8em}3\hspace{-1.8em}-5 = -2)",
        R"(T\!\!\!\!m = Tm)", R"(T + m = T\textcolor{#FCFBF8}{+m})", R"({\color{white}2}T = 2T)",
        R"(2\boxed{T + m} = 2T + m)", R"(T - \boxed{m - T} = -m)", R"(\underbrace{2T}_{\text{= 0}} = 2T)",
        R"(2T = \vec\omega\cdot\vec L \\ -m = -m)", R"(\omega_{\cancel{1}} = \omega_1)",
        R"(\frac{\cancel dT}{\cancel dt} = 0)"})
    EXPECT_EQ(reading(tex).substr(0, 2), "? ") << tex;
}

// 2026-11-27: each was proved, and a reader sees something false. A colour was looked through in indices and
// under accents; a phantom was dropped unread, with the space in it that goes back.
TEST(TexEquation, WhatHidesOrMovesAPartIsRefused) {
  for (const char* tex :
       {R"(\frac{d^{\textcolor{white}{*}}\vec L}{dt} = \vec N - \vec\omega\times\vec L)",
        R"(T^{\textcolor{white}{2}} = T^2)", R"(\vec{\textcolor{white}{L}} = \vec L)",
        R"(\omega_{\textcolor{white}{1}} = \omega_1)", R"(\mathbf{\color{white}I}\vec\omega = \vec L)",
        R"(\proved{T = T},\quad \textcolor{white}{m})"})
    EXPECT_THAT(reading(tex), HasSubstr("a colour may hide")) << tex;
  for (const char* tex :
       {R"(\phantom{\hspace{2em}}T - \phantom{m}2T = -T)", R"(2T - T\phantom{\hspace{-3em}} = T)",
        R"(T\hphantom{\hspace{-1em}} = T)", R"(T^{\phantom{m}2} = T^2)", R"(\frac{T\phantom{m}}{2} = T)",
        R"(2T^2 = \vec\omega\cdot\vec L\phantom{xxxxxx}\,T)"})
    EXPECT_THAT(reading(tex), HasSubstr("not printed")) << tex;
  EXPECT_THAT(reading(R"(\vec{L\hspace{-1em}} = \vec L)"), HasSubstr("goes back"));
  EXPECT_EQ(reading(R"(\term{a}{T}\vphantom{\frac12} = T)"), "T = T");
}

// 2026-11-27: such a line went on with the last equation above, and stands below another one.
TEST(TexEquation, ALineGoesOnWithTheOneEquationAbove) {
  for (const char* tex : {R"(\begin{aligned} T &= m &\quad 2T &= I_1 \\ &= 2T & m &= m \end{aligned})",
                          R"(\begin{aligned} T &= m & 2T &= I_1 \\ &= 2T \end{aligned})",
                          R"(\begin{aligned} T &= m, \quad 2T = I_1 \\ &= 2T \end{aligned})",
                          R"(\begin{aligned} T &= m \quad\text{and}\quad 2T = I_1 \\ &= 2T \end{aligned})",
                          R"(\begin{aligned} T &= m, \quad 2T = I_1 \\ &+ 2T \end{aligned})",
                          R"(\begin{aligned} T &= m, & 2T &= I_1 \\ && &+ 2T \end{aligned})",
                          R"(\begin{gathered} T = m, \quad 2T = I_1 \\ = 2T \end{gathered})"})
    EXPECT_THAT(reading(tex), HasSubstr("which equation of the line above")) << tex;
  EXPECT_EQ(reading(R"(\begin{aligned} T &= m \\ &= I_1 \\ &\quad + I_2 \end{aligned})"),
            "T = m; m = I1 + I2");
  EXPECT_EQ(reading(R"(\begin{aligned} m = m, \quad T &= m \\ &= I_1 \end{aligned})"),
            "m = m; T = m; m = I1");
  EXPECT_EQ(reading(R"(\begin{aligned} T &= m, \quad 2T = I_1 \\ m &= 2T \end{aligned})"),
            "T = m; 2*T = I1; m = 2*T");
  const Math above = math_of(R"(T = m, \quad 2T = I_1)"), math = math_of("= 2T");
  EXPECT_FALSE(read_equation(math, {}, &above).ok());
}

// 2026-11-27: 20 = 0 with a bold 0, T = 2T² behind a gap of narrow spaces, cos(θ/2), a rule as the bar of a
// fraction, T^{1 0} and T over the square of 2 were proved.
TEST(TexEquation, WhatLooksLikeOneThingIsNotReadAsTwo) {
  const Read cases[] = {
      {R"(2\mathbf 0 = 0)", "digits side by side"},
      {R"(2\,\mathbf 1\,\vec\omega = 2\vec\omega)", "digits side by side"},
      {R"(\mathbf{11}\,\vec\omega = \vec\omega)", "digits side by side"},
      {R"(\mathbf 1\mathbf 0 = 0)", "digits side by side"},
      {R"(2T^2 = \vec\omega\cdot\vec L\;\;\;\;\;\;\;T)", "wide space"},
      {R"(2T^2 = m\hspace{0.9em}\hspace{0.9em}T)", "wide space"},
      {R"(\cos T/2 = m)", "how far does the argument"},
      {R"(\cos T\cdot 2 = m)", "how far does the argument"},
      {R"(\begin{gathered} m \\ \hline = 2T \end{gathered})", "bar of a fraction"},
      {R"(\begin{aligned} m &= m \\ \hline T &= T \end{aligned})", "bar of a fraction"},
      {R"(T^{1\;\;0} = T)", "one number"},
      {R"(\frac{T}{2}^2 = m)", "is the fraction raised"},
      {R"(\frac12^{2} = m)", "is the fraction raised"},
  };
  for (const Read& one : cases)
    EXPECT_THAT(reading(one.tex), ::testing::AllOf(::testing::StartsWith("? "), HasSubstr(one.claim)))
        << one.tex;
  EXPECT_EQ(reading(R"(2\cdot\mathbf 1\cdot\vec\omega = 2\vec\omega)"), "2*omega = 2*omega");
  EXPECT_EQ(reading(R"(2\vec 0 = 0)"), "2*0 = 0");
  EXPECT_EQ(reading(R"(\cos(T)/2 = \frac12\cos T)"), "cos(T)/2 = 1/2*cos(T)");
  EXPECT_EQ(reading(R"(T\;=\;\;m)"), "T = m");
  EXPECT_EQ(reading(R"(\underbrace{\;\;\;\;T\;\;\;\;}_{\text{of the spin}} = m)"), "T = m");
}

// 2026-11-27: what an honest author writes is refused with what to write instead.
TEST(TexEquation, SaysWhatToWriteInstead) {
  const auto hint = [](const std::string& tex) {
    const auto read = read_equation(math_of(tex), {});
    return read.ok() ? "read" : read.error().reason + ": " + read.error().hint;
  };
  const Read cases[] = {
      {R"(\vec\omega^{\mathsf T}\vec L = 2T)", "\\cdot"},
      {R"(\vec\omega^\top\vec L = 2T)", "\\cdot"},
      {R"(\left(\frac{d\vec L}{dt}\right)_S = \vec N)", "d^*"},
      {R"(\frac{d\vec L}{dt}\bigg|_S = \vec N)", "d^*"},
      {R"(L_i = I_i\omega_i, \quad i = 1, 2, 3)", "(i = 1, 2, 3)"},
      {R"(\frac{dT}{dt} = \vec\omega\cdot\vec N \qquad \text{(power)})", "words behind a wide space"},
      {R"(\left|\begin{matrix} 1 & 0 \\ 0 & 1 \end{matrix}\right| = 1)", "vmatrix"},
  };
  for (const Read& one : cases) EXPECT_THAT(hint(one.tex), HasSubstr(one.claim)) << one.tex;
}

// 2026-11-23: the premise of the first line was taken for one of all that followed, and ω₁ω₂ = 0 was "always
// true".
TEST(TexEquation, APremiseAboutTheSpinIsThatOfOneEquation) {
  EXPECT_NE(reading(R"(\omega_1 = 0 \Rightarrow \omega_1^2 = 0)").substr(0, 2), "? ");
  for (const char* tex :
       {R"(\begin{aligned} \omega_1 &= 0 \Rightarrow \omega_1^2 = 0 \\ \omega_1\omega_2 &= 0 \end{aligned})",
        R"(\omega_1 = 0 \Rightarrow \omega_1^2 = 0 \\ \omega_1 = 0)",
        R"(\omega_1 = 0 \Rightarrow \omega_1^2 = 0, \quad \omega_1\omega_2 = 0)",
        R"(\omega_1 = 0 \Rightarrow \omega_1^2 = 0 \\ \omega_1 \ge 0)",
        R"(\vec\omega = \omega_3\hat e_3 \Rightarrow \omega_1 = 0 \\ \omega_2 = 0)"})
    EXPECT_EQ(reading(tex).substr(0, 2), "? ") << tex;
}

// --- the lessons ----------------------------------------------------------------------------------------

// Of the equations that carry a verdict the rest has sums over particles, the matrix R, > 0 and the like;
// what is claimed of these stands on the page under them.
TEST(TexEquationOfLessons, FiveOfSixVerdictsAreAboutThePrintedLine) {
  std::size_t printed = 0, all = 0;
  for (const std::string id :
       {"euler-equations", "symmetric-top", "intermediate-axis", "heavy-top", "numerical-lab"}) {
    auto reading = read_lesson(testing::read_file(test::source_dir() / "lessons" / (id + ".md")), id);
    ASSERT_TRUE(reading.lesson);
    EXPECT_FALSE(prove_claims(*reading.lesson));
    for (const Stage& stage : reading.lesson->stages)
      for (const Step& step : stage.steps)
        for (const Claim* claim : blocks_of<Claim>(step)) {
          ++all;
          printed += claim->origin == Claim::Origin::formula ? 1 : 0;
          for (const ClaimLine& line : claim->lines)
            EXPECT_EQ(line.judgement->verdict, Verdict::holds) << id << '/' << claim->equation;
        }
  }
  EXPECT_EQ(all, 237U);
  EXPECT_GE(static_cast<double>(printed), 0.85 * static_cast<double>(all));
}

TEST(LettersInAFormula, AreThoseOfTheLanguageThatItShows) {
  const auto letters = [](const std::string& tex) { return letters_in(math_of(tex), {}); };
  using Set = std::set<std::string>;
  EXPECT_EQ(letters(R"(\frac{d\vec L}{dt} = \vec N \ne 0)"), (Set{"L", "N"}));
  EXPECT_EQ(letters(R"(\vec L = \sum m\,\vec r\times(\vec\omega\times\vec r))"), (Set{"L", "m", "omega"}));
  EXPECT_EQ(letters(R"(\sqrt{I_1\dot\omega_2} > \hat e_1\cdot\mathbf I)"), (Set{"I", "e", "omega"}));
  EXPECT_EQ(letters("E = mc^3"), (Set{"m"}));
}

// --- hostile formulas -----------------------------------------------------------------------------------

std::string repeated(const std::string& unit, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += unit;
  return text;
}

template <class Work>
double milliseconds(const Work& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 3; ++run) {
    const std::clock_t start = std::clock();
    work();
    least = std::min(least, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least;
}

TEST(HostileEquation, IsRefusedAtOnce) {
  const std::string texts[] = {
      repeated("(", 4000) + "T" + repeated(")", 4000) + "=m",
      repeated("(", 8000),
      repeated("|", 8000),
      repeated("{", 60) + "T" + repeated("}", 60) + "= m^2 + \\frac12",
      repeated("\\frac{1+", 60) + "T" + repeated("}{m}", 60) + "=m",
      repeated("\\left(", 60) + "T" + repeated("\\right)", 60) + "=m",
      repeated("\\sum_i\\sum_j\\sum_k\\sum_l ", 1) + repeated("I_iI_jI_kI_l", 200) + "=m",
      repeated("\\mathbf I^{-1}\\cdot", 60) + "\\vec L=0",
      repeated("\\mathbf I\\cdot", 1000) + "\\vec L=0",
      repeated("[\\vec\\omega]_\\times", 500) + "\\vec L=0",
      repeated("\\frac{d}{dt}", 500) + "T=0",
      repeated("T=", 4000) + "T",
      repeated("T+", 4000) + "T=m",
      repeated("T ", 4000) + "=m",
      repeated("-", 8000) + "T=m",
      repeated("T,", 4000) + "T=m",
      "T^{999999999999999999999}=m",
      "2^{16}=" + repeated("9", 8000),
      "T=" + repeated("\\underbrace{", 60) + "T" + repeated("}_{m}", 60),
      "T=" + repeated("\\dot{", 60) + "T" + repeated("}", 60),
      "\\begin{aligned}" + repeated("T &= m \\\\", 600) + "\\end{aligned}",
      "\\begin{vmatrix}" + repeated("T & m \\\\", 600) + "\\end{vmatrix}=0",
      repeated("\\begin{vmatrix} T & m \\\\ m &", 30) + "T" + repeated("\\end{vmatrix}", 30) + "=0",
      "(((T^{16})^{16})^{16})^{16}=0",
      repeated("\\cancel{T} ", 700) + "=" + repeated("\\cancel{T} ", 200),
      "",
  };
  for (const std::string& tex : texts) {
    const auto math = parse_math(tex);
    if (!math) continue;
    const double ms = milliseconds([&] { static_cast<void>(read_equation(*math, {})); });
    if (!testing::kSanitized) {
      EXPECT_LT(ms, 10) << tex.substr(0, 40);
    }
    const auto read = read_equation(*math, {});
    if (read.ok()) continue;
    EXPECT_FALSE(read.error().reason.empty());
    EXPECT_LE(read.error().place.end, tex.size());
  }
}

TEST(HostileEquation, AnythingIsReadOrRefused) {
  const std::string seeds[] = {
      R"(\frac{d^*\vec L}{dt} + \vec\omega\times\vec L = \vec N \tag{5})",
      R"(\begin{aligned} T &= \sum_i I_i\,\omega_i^2 \\ &= \left[|\vec L|^2 - \cancel{m}\right]_1 \end{aligned})",
      R"(\vec N = 0 \;\Rightarrow\; \underbrace{d^*\vec L/dt}_{\vec L} = \hat e_i \qquad (i = 1, 2, 3))"};
  fuzz::Mutator mutator(
      {std::begin(seeds), std::end(seeds)},
      {"\\frac",  "\\cdot",   "\\times",      "{", "}",    "(", "|",     "=",     "_i", "^{-1}",
       "\\sum_i", "\\cancel", "\\Rightarrow", ",", "\\\\", "&", "\\dot", "\\vec", "0",  "."},
      1);
  for (int n = 0; n < 2000; ++n) {
    const std::string tex = mutator.next();
    const auto math = parse_math(tex);
    if (!math) continue;
    const auto read = read_equation(*math, {});
    if (!read) {
      EXPECT_LE(read.error().place.end, tex.size()) << tex;
    } else {
      for (const EquationSentence& sentence : read->sentences) EXPECT_FALSE(sentence.links.empty()) << tex;
    }
  }
}

}  // namespace
}  // namespace polhode
