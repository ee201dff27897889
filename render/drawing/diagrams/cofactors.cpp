// SPDX-License-Identifier: MIT
// ω×(I·ω) on principal axes as a determinant, expanded along its first row.
#include "physics/body/euler.h"
#include "render/drawing/diagrams/diagram_paper.h"

namespace polhode::diagrams {
namespace {

constexpr double kColumn = 4.8, kRow = 2.9;
constexpr double kDeterminantLeft = 8.0;  // of the cells
constexpr double kDeterminantTop = 0.4;
constexpr std::array<double, 3> kBaselines = {1.55, 1.25,
                                              1.25};  // in a cell: below the symbols stand numbers
constexpr double kNumberBelow = 1.32;
constexpr double kExpansionTop = 10.8, kExpansionRow = 2.3;
constexpr double kWidth = 27.2;
constexpr double kSmall = 0.92;

using Texts = std::array<const char*, 3>;
constexpr Texts kUnit = {"\\hat i", "\\hat j", "\\hat k"};
constexpr Texts kOmegas = {"\\omega_x", "\\omega_y", "\\omega_z"};
constexpr Texts kMomenta = {"I_x\\omega_x", "I_y\\omega_y", "I_z\\omega_z"};
constexpr Texts kMinors = {"\\omega_y\\,I_z\\omega_z - \\omega_z\\,I_y\\omega_y",
                           "\\omega_x\\,I_z\\omega_z - \\omega_z\\,I_x\\omega_x",
                           "\\omega_x\\,I_y\\omega_y - \\omega_y\\,I_x\\omega_x"};
constexpr Texts kSigns = {"+", "-", "+"};

Vec2 cell(int row, int column) { return {kDeterminantLeft + column * kColumn, kDeterminantTop + row * kRow}; }

/// The four entries that are left when row and column of the lit unit vector are struck.
double minor(const Vec3& w_B, const Vec3& L_B, int lit) {
  const int a = lit == 0 ? 1 : 0, b = lit == 2 ? 1 : 2;
  return w_B[a] * L_B[b] - w_B[b] * L_B[a];
}

void add_marks(int lit, DiagramPaper& paper) {
  const Vec2 size(kColumn, kRow);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      if ((row == 0) == (column == lit))
        paper.panel(cell(row, column) + Vec2(0.15, 0.1), cell(row, column) + size - Vec2(0.15, 0.1),
                    paper.style().panel);
}

void add_strikes(int lit, DiagramPaper& paper) {
  const double y = cell(0, 0).y() + 0.5 * kRow, x = cell(0, lit).x() + 0.5 * kColumn;
  constexpr double kStrike = 0.08, kFree = 1.15;  // around the lit unit vector
  const double left = cell(0, 0).x() + 0.4, right = cell(0, 3).x() - 0.4;
  if (x - kFree > left) paper.line({left, y}, {x - kFree, y}, kStrike, paper.style().muted);
  if (x + kFree < right) paper.line({x + kFree, y}, {right, y}, kStrike, paper.style().muted);
  paper.line({x, cell(1, 0).y()}, {x, cell(3, 0).y() - 0.3}, kStrike, paper.style().muted);
}

struct Forms {
  NumberForm omega, L, expansion;
};

void add_determinant(const Vec3& w_B, const Vec3& L_B, int lit, const Forms& forms, DiagramPaper& paper) {
  paper.math("\\vec\\omega\\times(\\mathbf I\\cdot\\vec\\omega)\\;=",
             {kDeterminantLeft - 1.1, kDeterminantTop + 1.6 * kRow}, {.align = 1.0, .size = 1.15});
  for (double x : {kDeterminantLeft - 0.3, kDeterminantLeft + 3.0 * kColumn + 0.3})
    paper.line({x, kDeterminantTop - 0.1}, {x, kDeterminantTop + 3.0 * kRow + 0.1}, 0.08, paper.style().ink);
  for (int column = 0; column < 3; ++column) {
    const auto k = static_cast<std::size_t>(column);
    const auto at = [&](int row) -> Vec2 {
      return cell(row, column) + Vec2(0.5 * kColumn, kBaselines[static_cast<std::size_t>(row)]);
    };
    paper.math(kUnit[k], at(0) + Vec2(0, 0.25), {.align = 0.5, .size = 1.2, .quiet = column != lit});
    paper.math(kOmegas[k], at(1), {.align = 0.5, .size = 1.1, .quiet = column == lit});
    paper.math(kMomenta[k], at(2), {.align = 0.5, .size = 1.1, .quiet = column == lit});
    const DiagramPaper::Type number{.align = 0.5, .size = kSmall, .quiet = true};
    if (column == lit) continue;  // struck
    paper.text(forms.omega.text(w_B[column]), at(1) + Vec2(0, kNumberBelow), number);
    paper.text(forms.L.text(L_B[column]), at(2) + Vec2(0, kNumberBelow), number);
  }
  const DiagramPaper::Type unit{.align = 0, .size = kSmall, .quiet = true};
  const double x = kDeterminantLeft + 3.0 * kColumn + 0.7;
  paper.text(forms.omega.unit("rad/s"), {x, cell(1, 0).y() + kBaselines[1] + kNumberBelow}, unit);
  paper.text(forms.L.unit("kg m²/s"), {x, cell(2, 0).y() + kBaselines[2] + kNumberBelow}, unit);
}

void add_expansion(const Vec3& w_B, const Vec3& L_B, int lit, const NumberForm& form, DiagramPaper& paper) {
  Vec3 value;
  for (int i = 0; i < 3; ++i) value[i] = (i == 1 ? -1.0 : 1.0) * minor(w_B, L_B, i);
  for (int i = 0; i <= lit; ++i) {  // the others are still to be found
    const auto k = static_cast<std::size_t>(i);
    const double top = kExpansionTop + i * kExpansionRow, y = top + 1.5;
    const bool is_lit = i == lit;
    if (is_lit) paper.panel({2.0, top + 0.1}, {kWidth - 0.1, top + kExpansionRow - 0.1}, paper.style().panel);
    const std::string tex =
        std::string(kSigns[k]) + "\\," + kUnit[k] + "\\,\\left(" + kMinors[k] + "\\right)";
    paper.math(tex, {2.6, y}, {.size = 1.1, .quiet = !is_lit});
    paper.math(std::string(kUnit[k]) + ":", {19.8, y}, {.align = 1.0, .quiet = !is_lit});
    paper.text(form.text(value[i]), {23.8, y}, {.align = 1.0, .quiet = !is_lit, .bold = is_lit});
    paper.text(form.unit("N m"), {24.3, y}, {.size = kSmall, .quiet = true});
  }
}

void draw(const SceneModel& model, double t_s, Arrangement /*unused*/, DiagramPaper& paper) {
  const Vec3 w_B = model.motion->w_B_at(t_s);
  const PrincipalMoments& I = model.scene.body.moments;
  const Vec3 L_B = angular_momentum_B(I, w_B);
  const int lit = third_at(model, t_s);
  const Forms forms{
      NumberForm(largest_over_span(model, t_s, [](const Vec3& w) { return w; })),
      NumberForm(largest_over_span(model, t_s, [&](const Vec3& w) { return angular_momentum_B(I, w); })),
      NumberForm(largest_over_span(
          model, t_s, [&](const Vec3& w) -> Vec3 { return w.cross(angular_momentum_B(I, w)); }))};
  add_marks(lit, paper);
  add_strikes(lit, paper);
  add_determinant(w_B, L_B, lit, forms, paper);
  add_expansion(w_B, L_B, lit, forms.expansion, paper);
}

}  // namespace

constexpr double kHeight = kExpansionTop + 3.0 * kExpansionRow + 0.2;

const DiagramKind kCofactors{{kWidth + 1.2, kHeight}, {kWidth + 1.2, kHeight}, draw};

}  // namespace polhode::diagrams
