// SPDX-License-Identifier: MIT
// The twelve equations of the lecture.
#include "render/drawing/diagrams/diagram_paper.h"

namespace polhode::diagrams {
namespace {

struct Card {
  int number;
  const char *tex, *words;
};

/// In pairs: translation and rotation, then with torque and without.
constexpr std::array<std::array<Card, 2>, 6> kRows = {{
    {{{1, "d\\vec p/dt = \\vec F", "law: the centre of mass"},
      {2, "d\\vec L/dt = \\vec N", "law: the rotation, in $S$"}}},
    {{{3, "\\vec p = m\\,\\vec v", "definition: $m$ is a number"},
      {4, "\\vec L = \\mathbf I\\cdot\\vec\\omega", "definition: $\\mathbf I$ is a tensor"}}},
    {{{5, "d^*\\vec L/dt + \\vec\\omega\\times\\vec L = \\vec N", "(2), seen from the body"},
      {6, "\\mathbf I\\cdot\\dot{\\vec\\omega} + \\vec\\omega\\times(\\mathbf I\\cdot\\vec\\omega) = \\vec N",
       "(5) with (4): $\\mathbf I$ is constant in $S^*$"}}},
    {{{7, "I_1\\dot\\omega_1 + \\omega_2\\omega_3(I_3 - I_2) = N_1", "Euler, principal axis 1"},
      {10, "I_1\\dot\\omega_1 + \\omega_2\\omega_3(I_3 - I_2) = 0", "without torque"}}},
    {{{8, "I_2\\dot\\omega_2 + \\omega_3\\omega_1(I_1 - I_3) = N_2", "Euler, principal axis 2"},
      {11, "I_2\\dot\\omega_2 + \\omega_3\\omega_1(I_1 - I_3) = 0", "without torque"}}},
    {{{9, "I_3\\dot\\omega_3 + \\omega_1\\omega_2(I_2 - I_1) = N_3", "Euler, principal axis 3"},
      {12, "I_3\\dot\\omega_3 + \\omega_1\\omega_2(I_2 - I_1) = 0", "without torque"}}},
}};

constexpr double kCardWidth = 17.4, kCardHeight = 3.9, kGap = 0.55;

void add_card(const Card& card, const Vec2& corner, DiagramPaper& paper) {
  paper.panel(corner, corner + Vec2(kCardWidth, kCardHeight), paper.style().panel);
  paper.text("(" + std::to_string(card.number) + ")", corner + Vec2(2.4, 1.75), {.align = 1, .quiet = true});
  paper.math(card.tex, corner + Vec2(3.1, 1.75));
  paper.text(card.words, corner + Vec2(3.1, 3.35), {.size = 0.9, .quiet = true});
}

void draw(const SceneModel& /*unused*/, double /*unused*/, Arrangement /*unused*/, DiagramPaper& paper) {
  for (std::size_t row = 0; row < kRows.size(); ++row)
    for (std::size_t column = 0; column < 2; ++column)
      add_card(kRows[row][column],
               {static_cast<double>(column) * (kCardWidth + kGap),
                static_cast<double>(row) * (kCardHeight + kGap)},
               paper);
}

}  // namespace

constexpr double kWidth = 2.0 * kCardWidth + kGap, kHeight = 6.0 * kCardHeight + 5.0 * kGap;

const DiagramKind kCards{{kWidth, kHeight}, {kWidth, kHeight}, draw};

}  // namespace polhode::diagrams
