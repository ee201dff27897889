// SPDX-License-Identifier: MIT
// The wheel 1 → 2 → 3 → 1, and Euler's equations, each the next one's when the wheel goes on by a third.
#include "physics/analysis/euler_terms.h"
#include "render/drawing/diagrams/diagram_paper.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polhode::diagrams {
namespace {

constexpr double kRadius = 4.4, kNode = 1.25, kRim = 0.12, kLitRim = 0.24;
constexpr double kWheelWidth = 13.4, kWheelHeight = 11.6;
constexpr double kArrowFrom = 0.36, kArrowTo = 0.42;  // of a node's neighbourhood left free, rad
// The equations, from their upper left corner.
constexpr double kWidth = 25.6, kTop = 2.9, kRow = 4.4, kHeight = kTop + 3.0 * kRow;
constexpr double kFirst = 3.3, kPlus = 6.4, kSecond = 11.4, kEquals = 16.6, kThird = 19.2,
                 kUnitEnd = 25.1;  // middles of the three terms and what is between them
constexpr double kSmall = 0.92;

/// Clockwise from the top.
Vec2 on_rim(const Vec2& hub, double angle) { return hub + kRadius * Vec2(std::sin(angle), -std::cos(angle)); }

double angle_of(int node) { return 2.0 * std::numbers::pi * node / 3.0; }

/// Along the rim from a node to the next, with its head.
void add_rim_arrow(const Vec2& hub, int from, bool is_lit, DiagramPaper& paper) {
  constexpr int kPieces = 24;
  const double begin = angle_of(from) + kArrowFrom, end = angle_of(from + 1) - kArrowTo;
  std::vector<Vec2> points;
  for (int i = 0; i <= kPieces; ++i)
    points.push_back(on_rim(hub, std::lerp(begin, end, i / double{kPieces})));
  const Color color = is_lit ? paper.style().ink : paper.style().muted;
  paper.path(std::move(points), is_lit ? 0.2 : 0.11, color);
  constexpr double kHead = 0.15, kHalfWidth = 0.42;
  const Vec2 outward = (on_rim(hub, end) - hub).normalized();
  paper.area({on_rim(hub, end + kHead), on_rim(hub, end - 0.02) + kHalfWidth * outward,
              on_rim(hub, end - 0.02) - kHalfWidth * outward},
             color);
}

void add_wheel(const Vec2& hub, int lit, DiagramPaper& paper) {
  for (int i = 0; i < 3; ++i) add_rim_arrow(hub, i, i == lit, paper);
  constexpr std::array<const char*, 3> kPlaces = {"i", "j", "k"};
  for (int node = 0; node < 3; ++node) {
    const Vec2 at = on_rim(hub, angle_of(node));
    const bool is_lit = node == lit;
    paper.disc(at, kNode, is_lit ? paper.style().ink : paper.style().muted);
    paper.disc(at, kNode - (is_lit ? kLitRim : kRim), is_lit ? paper.style().panel : paper.style().paper);
    paper.math(std::to_string(node + 1), at + Vec2(0, 0.52), {.align = 0.5, .size = 1.5});
    const Vec2 inside = hub + 0.52 * (at - hub);
    paper.math(kPlaces[static_cast<std::size_t>((node - lit + 3) % 3)], inside + Vec2(0, 0.3),
               {.align = 0.5, .size = 1.0, .quiet = !is_lit});
  }
}

std::string index(int i) { return std::to_string(i % 3 + 1); }

void add_equation(int i, const EulerTerms& terms, bool is_free, bool is_lit, const NumberForm& form,
                  const Vec2& corner, DiagramPaper& paper) {
  const auto at = [&](double x, double y) -> Vec2 { return corner + Vec2(x, y); };
  constexpr double kFormula = 1.7, kNumber = 3.2;
  const bool quiet = !is_lit;
  if (is_lit) paper.panel(corner, at(kWidth, kRow - 0.3), paper.style().panel);
  const std::string a = index(i), b = index(i + 1), c = index(i + 2);
  const DiagramPaper::Type formula{.align = 0.5, .size = 1.1, .quiet = quiet};
  paper.math("I_" + a + "\\,\\dot\\omega_" + a, at(kFirst, kFormula), formula);
  paper.math("+", at(kPlus, kFormula), formula);
  paper.math("(I_" + c + " - I_" + b + ")\\,\\omega_" + b + "\\omega_" + c, at(kSecond, kFormula), formula);
  paper.math("=", at(kEquals, kFormula), formula);
  paper.math(is_free ? "0" : "N_" + a, at(kThird, kFormula), formula);
  paper.text("(" + std::to_string((is_free ? 10 : 7) + i) + ")", at(kUnitEnd, kFormula),
             {.align = 1, .quiet = true});
  const DiagramPaper::Type number{.align = 0.5, .size = 0.92, .quiet = quiet};
  paper.text(form.text(terms.inertial_B[i]), at(kFirst, kNumber), number);
  paper.text(form.text(terms.gyroscopic_B[i]), at(kSecond, kNumber), number);
  if (!is_free) paper.text(form.text(terms.N_B[i]), at(kThird, kNumber), number);
  paper.text(form.unit("N m"), at(kUnitEnd, kNumber), {.align = 1, .size = kSmall, .quiet = true});
}

void add_equations(const SceneModel& model, double t_s, int lit, const Vec2& corner, DiagramPaper& paper) {
  const bool is_free = model.scene.torque.empty();
  paper.math(is_free ? "I_i\\,\\dot\\omega_i + (I_k - I_j)\\,\\omega_j\\omega_k = 0"
                     : "I_i\\,\\dot\\omega_i + (I_k - I_j)\\,\\omega_j\\omega_k = N_i",
             corner + Vec2(0.6, 1.3), {.size = 1.1});
  paper.math("i = " + index(lit) + ",\\; j = " + index(lit + 1) + ",\\; k = " + index(lit + 2),
             corner + Vec2(kUnitEnd, 1.3), {.align = 1, .quiet = true});
  const EulerTerms terms = euler_terms_at(*model.motion, model.scene.body.moments, model.scene.torque, t_s);
  const Vec3 differences = cyclic_differences(model.scene.body.moments.vector());
  const auto gyroscopic = [&](const Vec3& w) -> Vec3 { return differences.cwiseProduct(cyclic_products(w)); };
  constexpr int kDigits = 4;  // so that the last ones are seen to add up
  const NumberForm form(std::max(largest_over_span(model, t_s, gyroscopic), terms.N_B.cwiseAbs().maxCoeff()),
                        kDigits);
  for (int i = 0; i < 3; ++i)
    add_equation(i, terms, is_free, i == lit, form, corner + Vec2(0, kTop + i * kRow), paper);
}

void draw(const SceneModel& model, double t_s, Arrangement arrangement, DiagramPaper& paper) {
  const int lit = third_at(model, t_s);
  const bool wide = arrangement == Arrangement::wide;
  const double left = 0.5 * (wide ? kWheelWidth : kWidth), top = wide ? 0.5 * (kHeight - kWheelHeight) : 0.0;
  add_wheel({left, top + kRadius + kNode + 0.2}, lit, paper);
  add_equations(model, t_s, lit, wide ? Vec2(kWheelWidth, 0) : Vec2(0, kWheelHeight), paper);
}

}  // namespace

const DiagramKind kCyclicWheel{{kWheelWidth + kWidth, kHeight}, {kWidth, kWheelHeight + kHeight}, draw};

}  // namespace polhode::diagrams
