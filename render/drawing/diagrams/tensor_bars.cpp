// SPDX-License-Identifier: MIT
// I_S = R I* Rᵀ beside I*: the same tensor, the same trace and eigenvalues, other components.
#include "render/drawing/diagrams/diagram_paper.h"

#include <Eigen/Eigenvalues>

namespace polhode::diagrams {
namespace {

constexpr double kCellWidth = 5.0, kCellHeight = 3.0;
constexpr double kWidth = 3.0 * kCellWidth, kHeight = 3.0 * kCellHeight;
constexpr double kIndexRoom = 1.3;             // left of the rows
constexpr double kBeside = 2.6, kBelow = 1.6;  // between the matrices
constexpr double kTop = 4.2;                   // of the matrices, below titles and the columns' names
constexpr double kNumber = 1.05;               // baseline in a cell
constexpr double kBarTop = 1.42, kBarBottom = 2.42, kLongestBar = 2.3;
constexpr double kBracket = 0.35, kBracketLine = 0.08, kZeroLine = 0.06;
constexpr double kSmall = 0.78;

using Matrix = Eigen::Matrix3d;
using Names = std::array<const char*, 3>;

Matrix tensor_B(const SceneModel& model) { return model.scene.body.moments.vector().asDiagonal(); }

Matrix tensor_S(const SceneModel& model, double t_s) {
  const Matrix R = model.motion->at(t_s).q_SB.toRotationMatrix();
  return R * tensor_B(model) * R.transpose();
}

void add_brackets(const Vec2& corner, DiagramPaper& paper) {
  const double top = corner.y() - 0.1, bottom = corner.y() + kHeight + 0.1;
  for (const auto& [x, inward] : {std::pair(corner.x(), 1.0), std::pair(corner.x() + kWidth, -1.0)})
    paper.path({{x + inward * kBracket, top}, {x, top}, {x, bottom}, {x + inward * kBracket, bottom}},
               kBracketLine, paper.style().ink);
}

void add_cell(double value, bool diagonal, double largest, const NumberForm& form, const Vec2& corner,
              DiagramPaper& paper) {
  const double zero = corner.x() + 0.5 * kCellWidth, top = corner.y() + kBarTop,
               bottom = corner.y() + kBarBottom;
  paper.text(form.text(value), {zero, corner.y() + kNumber},
             {.align = 0.5, .size = 0.92, .quiet = value == 0.0});
  paper.bar({zero, top}, {zero + kLongestBar * value / largest, bottom},
            paper.paint_of(diagonal ? kTRole : kAxesRole));
  paper.line({zero, top - 0.15}, {zero, bottom + 0.15}, kZeroLine, paper.style().muted);
}

void add_matrix(const Matrix& tensor, const Names& names, const NumberForm& form, double largest,
                const Vec2& corner, DiagramPaper& paper) {
  add_brackets(corner, paper);
  for (int r = 0; r < 3; ++r) {
    const char* name = names[static_cast<std::size_t>(r)];
    paper.math(name, {corner.x() + (r + 0.5) * kCellWidth, corner.y() - 0.5},
               {.align = 0.5, .size = kSmall, .quiet = true});
    paper.math(name, {corner.x() - 0.45, corner.y() + r * kCellHeight + 1.7},
               {.align = 1.0, .size = kSmall, .quiet = true});
    for (int c = 0; c < 3; ++c)
      add_cell(tensor(r, c), r == c, largest, form,
               {corner.x() + c * kCellWidth, corner.y() + r * kCellHeight}, paper);
  }
}

/// Computed of the nine components, so that they are seen to agree.
void add_invariants(const Matrix& tensor, const NumberForm& form, const Vec2& at, DiagramPaper& paper) {
  const Vec3 moments = Eigen::SelfAdjointEigenSolver<Matrix>(tensor, Eigen::EigenvaluesOnly).eigenvalues();
  const DiagramPaper::Type small{.align = 0.5, .size = kSmall, .quiet = true};
  const std::string unit = form.times_unit("kg m²");
  paper.text("trace " + form.text(tensor.trace()) + unit, at, small);
  paper.text("eigenvalues (" + form.text(moments[0]) + ", " + form.text(moments[1]) + ", " +
                 form.text(moments[2]) + ")" + unit,
             at + Vec2(0, 1.2), small);
}

struct Side {
  const char *tex, *words;
  Matrix tensor;
  Names names;
};

void add_side(const Side& side, const NumberForm& form, double largest, const Vec2& corner,
              DiagramPaper& paper) {
  const double middle = corner.x() + kIndexRoom + 0.5 * kWidth;
  paper.math(side.tex, corner + Vec2(kIndexRoom + 0.5 * kWidth, 1.1), {.align = 0.5, .size = 1.15});
  paper.text(side.words, {middle, corner.y() + 2.5}, {.align = 0.5, .size = kSmall, .quiet = true});
  add_matrix(side.tensor, side.names, form, largest, corner + Vec2(kIndexRoom, kTop), paper);
  add_invariants(side.tensor, form, {middle, corner.y() + kTop + kHeight + 1.5}, paper);
}

constexpr double kSideWidth = kIndexRoom + kWidth + 0.2, kSideHeight = kTop + kHeight + 3.1;

void draw(const SceneModel& model, double t_s, Arrangement arrangement, DiagramPaper& paper) {
  const double largest = model.scene.body.moments.vector().maxCoeff();
  const NumberForm form(largest);
  const Side moving{"\\mathbf I_S = R\\,\\mathbf I^* R^{\\top}",
                    "in $S$: it turns with the body",
                    tensor_S(model, t_s),
                    {"x", "y", "z"}};
  const Side still{"\\mathbf I^*", "in $S^*$: it rests", tensor_B(model), {"1", "2", "3"}};
  const bool wide = arrangement == Arrangement::wide;
  add_side(moving, form, largest, {0, 0}, paper);
  add_side(still, form, largest, wide ? Vec2(kSideWidth + kBeside, 0) : Vec2(0, kSideHeight + kBelow), paper);
}

}  // namespace

const DiagramKind kTensorBars{
    {2.0 * kSideWidth + kBeside, kSideHeight}, {kSideWidth, 2.0 * kSideHeight + kBelow}, draw};

}  // namespace polhode::diagrams
