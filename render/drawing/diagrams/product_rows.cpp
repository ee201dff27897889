// SPDX-License-Identifier: MIT
// Three rows that add up to nothing: the bars of the products, each beginning where the one above it ended.
#include "physics/analysis/euler_terms.h"
#include "render/drawing/diagrams/diagram_paper.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode::diagrams {
namespace {

constexpr double kWidth = 26.0;
constexpr double kLabel = 0.4, kZero = 16.2, kReach = 4.6, kNumberEnd = 25.4;
constexpr double kHead = 2.1, kRow = 2.0, kSum = 2.2;  // heights
constexpr double kBlock = kHead + 3.0 * kRow + kSum;
constexpr double kBetween = 1.0;  // the blocks
constexpr double kBarHalf = 0.52, kBaseline = 0.36;
constexpr double kSmall = 0.92;

using Texts = std::array<std::string, 3>;

struct Block {
  std::string title, unit;
  Texts terms;
  Vec3 values;
  std::string sum;  ///< what it is
  double rounding;  ///< of the values, relative to the largest
};

constexpr double kOfProducts = 64 * std::numeric_limits<double>::epsilon();  // a few factors each
constexpr double kOfRates = 1e-11;  // what euler_terms.h promises of the exact motion, and some more

/// The sums after one, two, three of the values.
std::array<double, 4> running_sums(const Vec3& values) {
  std::array<double, 4> sums{};
  for (std::size_t i = 0; i < 3; ++i) sums[i + 1] = sums[i] + values[static_cast<int>(i)];
  return sums;
}

void add_row(const Block& block, int i, double from, double to, const NumberForm& form, double y,
             DiagramPaper& paper) {
  const auto k = static_cast<std::size_t>(i);
  const Color color = paper.paint_of_axis(i);
  paper.bar({kLabel, y - 0.42}, {kLabel + 0.5, y + 0.42}, color);
  paper.math(block.terms[k], {kLabel + 1.1, y + kBaseline}, {.size = 1.05});
  paper.bar({from, y - kBarHalf}, {to, y + kBarHalf}, color);
  paper.line({to, y}, {to, y + kRow}, 0.07, paper.style().muted, 0.22);
  paper.text(form.text(block.values[i]), {kNumberEnd, y + kBaseline}, {.align = 1});
}

struct Scale {
  NumberForm form;
  double longest;  ///< partial sum
  double x_of(double value) const { return kZero + (longest > 0.0 ? kReach * value / longest : 0.0); }
};

void add_block(const Block& block, const Scale& scale, double top, DiagramPaper& paper) {
  const NumberForm& form = scale.form;
  const auto x_of = [&](double value) { return scale.x_of(value); };
  const std::array<double, 4> sums = running_sums(block.values);
  paper.text(block.title, {kLabel, top + 1.1}, {.size = 0.92, .quiet = true});
  paper.text(form.unit(block.unit), {kNumberEnd, top + 1.1}, {.align = 1, .size = kSmall, .quiet = true});
  const double first = top + kHead + 0.5 * kRow, last = first + 3.0 * kRow;
  paper.line({kZero, first - 0.5 * kRow}, {kZero, last + 0.8}, 0.07, paper.style().muted);
  for (int i = 0; i < 3; ++i)
    add_row(block, i, x_of(sums[static_cast<std::size_t>(i)]), x_of(sums[static_cast<std::size_t>(i) + 1]),
            form, first + i * kRow, paper);
  paper.line({kLabel, last - 0.5 * kRow}, {kNumberEnd, last - 0.5 * kRow}, 0.07, paper.style().ink);
  paper.math(block.sum, {kLabel + 1.1, last + kBaseline + 0.15}, {.size = 1.05});
  paper.disc({x_of(sums[3]), last}, 0.3, paper.style().ink);
  const double rounding = block.rounding * block.values.cwiseAbs().maxCoeff();
  const double sum = std::abs(sums[3]) <= rounding ? 0.0 : sums[3];
  paper.text(form.residual(sum), {kNumberEnd, last + kBaseline + 0.15}, {.align = 1, .bold = true});
}

std::string product(int i, const std::string& factor) {
  constexpr std::array<const char*, 3> kBrackets = {"(I_3 - I_2)", "(I_1 - I_3)", "(I_2 - I_1)"};
  return "\\omega_1\\omega_2\\omega_3\\," + factor + kBrackets[static_cast<std::size_t>(i)];
}

/// Rows for the factors ω_i (weight 1) or I_i ω_i (weight I_i).
void draw_rows(const SceneModel& model, double t_s, bool with_moments, DiagramPaper& paper) {
  const Vec3 I = model.scene.body.moments.vector();
  const Vec3 weights = with_moments ? I : Vec3::Ones();
  const auto products = [&](const Vec3& w) -> Vec3 {
    return w.prod() * weights.cwiseProduct(cyclic_differences(I));
  };
  const Vec3 w_B = model.motion->w_B_at(t_s);
  const EulerTerms terms = euler_terms_at(*model.motion, model.scene.body.moments, model.scene.torque, t_s);
  const std::string unit = with_moments ? "kg² m⁴/s³" : "W";
  Block first{"The products, end to end", unit, {}, products(w_B), "\\text{sum}", kOfProducts};
  Block second{"The first terms, computed",
               unit,
               {},
               weights.cwiseProduct(w_B).cwiseProduct(terms.inertial_B),
               with_moments ? "\\text{sum} = \\tfrac12\\,d(\\vec L\\cdot\\vec L)/dt" : "\\text{sum} = dT/dt",
               kOfRates};
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const std::string n = std::to_string(i + 1), I_n = "I_" + n;
    first.terms[k] = product(i, with_moments ? I_n + "\\," : "");
    second.terms[k] = I_n + (with_moments ? "^2" : "") + "\\,\\omega_" + n + "\\dot\\omega_" + n;
  }
  const auto sums_of = [](const Vec3& v) { return Vec3(v[0], v[0] + v[1], v.sum()); };
  const double longest =
      std::max(largest_over_span(model, t_s, [&](const Vec3& w) { return sums_of(products(w)); }),
               sums_of(second.values).cwiseAbs().maxCoeff());
  const double largest =
      std::max(largest_over_span(model, t_s, products), second.values.cwiseAbs().maxCoeff());
  const Scale scale{NumberForm(largest), longest};
  add_block(first, scale, 0.0, paper);
  add_block(second, scale, kBlock + kBetween, paper);
}

void draw_energy(const SceneModel& model, double t_s, Arrangement /*unused*/, DiagramPaper& paper) {
  draw_rows(model, t_s, false, paper);
}
void draw_momentum(const SceneModel& model, double t_s, Arrangement /*unused*/, DiagramPaper& paper) {
  draw_rows(model, t_s, true, paper);
}

constexpr double kHeight = 2.0 * kBlock + kBetween;

}  // namespace

const DiagramKind kEnergyRows{{kWidth, kHeight}, {kWidth, kHeight}, draw_energy};
const DiagramKind kMomentumRows{{kWidth, kHeight}, {kWidth, kHeight}, draw_momentum};

}  // namespace polhode::diagrams
