// SPDX-License-Identifier: MIT
// The methods side by side; what is grossly wrong stands bold on a panel.
#include "base/angles.h"
#include "render/drawing/diagrams/diagram_paper.h"

#include <cmath>

namespace polhode::diagrams {
namespace {

constexpr double kName = 0.3, kFirstColumn = 15.9, kColumn = 5.4;  // right ends of the columns
constexpr double kHead = 6.4, kRow = 1.62;
constexpr int kColumns = 6, kMostRows = 12;
constexpr double kWork = 0.4;  // that the last column is wider
constexpr double kWidth = kFirstColumn + (kColumns - 1) * kColumn + kWork + 0.5;
constexpr double kSmall = 0.8;
constexpr double kGross = 0.01, kGross_deg = 1.0;

struct Column {
  const char *name, *unit;
  double (*value)(const MethodRow& row);
  double gross;  ///< more than that is grossly wrong
};

double degrees(double rad) { return rad * kDegreesPerRadian; }

constexpr double kNever = std::numeric_limits<double>::infinity();
const std::array<Column, kColumns> kTable = {{
    {"$\\vec\\omega$", "relative", [](const MethodRow& r) { return r.error.omega; }, kGross},
    {"attitude", "degrees", [](const MethodRow& r) { return degrees(r.error.attitude_rad); }, kGross_deg},
    {"$T$", "relative", [](const MethodRow& r) { return r.drift.T; }, kGross},
    {"$|\\vec L|$", "relative", [](const MethodRow& r) { return r.drift.L; }, kGross},
    {"$\\angle\\vec L$", "degrees", [](const MethodRow& r) { return degrees(r.drift.L_direction_rad); },
     kGross_deg},
    {"evaluations", "per s of motion", [](const MethodRow& r) { return r.evaluations_per_s; }, kNever},
}};

double right_of(int column) {
  return kFirstColumn + column * kColumn + (column == kColumns - 1 ? kWork : 0.0);
}

/// A title over columns, with a line below it.
void add_group(const char* title, int first, int last, DiagramPaper& paper) {
  const double left = right_of(first) - kColumn + 0.7, right = right_of(last);
  paper.text(title, {0.5 * (left + right), 2.75}, {.align = 0.5, .size = kSmall, .quiet = true});
  paper.line({left, 3.15}, {right, 3.15}, 0.06, paper.style().line);
}

/// Three digits, as of a step that is a part of a period.
std::string step_text(double step_s) {
  constexpr double kLeast = 1e-3, kMost = 1e4;
  if (!(step_s >= kLeast && step_s < kMost)) return signed_short(step_s);
  const double unit = std::pow(10.0, 2 - std::floor(std::log10(step_s)));
  return plain_number(std::round(step_s * unit) / unit);
}

void add_head(const MethodTable& table, DiagramPaper& paper) {
  paper.text("After " + plain_number(table.t_s) + " s in steps of " + step_text(table.step_s) + " s",
             {kName, 1.0});
  paper.text(
      "shaded: more than " + plain_number(100.0 * kGross) + " % or " + plain_number(kGross_deg) + "° off",
      {right_of(kColumns - 1), 1.0}, {.align = 1, .size = kSmall, .quiet = true});
  add_group("error", 0, 1, paper);
  add_group("change since the start", 2, 4, paper);
  add_group("work", 5, 5, paper);
  for (int c = 0; c < kColumns; ++c) {
    const Column& column = kTable[static_cast<std::size_t>(c)];
    paper.text(column.name, {right_of(c), 4.55}, {.align = 1, .size = 0.86});
    paper.text(column.unit, {right_of(c), 5.65}, {.align = 1, .size = 0.85, .quiet = true});
  }
  paper.line({kName, kHead - 0.3}, {kWidth - 0.2, kHead - 0.3}, 0.07, paper.style().muted);
}

/// Three digits of ordinary numbers, two of others.
std::string measured(double value) {
  return value >= 1.0 && value < 1000.0 ? NumberForm(value).text(value) : two_digits(value);
}

/// Of one that went step by step and left the numbers of a double.
bool diverged(const MethodRow& row) {
  return facts_of(row.method).control != StepControl::none && std::isnan(row.error.omega);
}

std::string text_of(const MethodRow& row, int column) {
  if (diverged(row)) return column == 0 ? "diverged" : "–";
  const double value = kTable[static_cast<std::size_t>(column)].value(row);
  if (column < kColumns - 1) return measured(value);
  return facts_of(row.method).control == StepControl::none ? "closed form" : signed_short(value);
}

void add_row(const MethodRow& row, double top, DiagramPaper& paper) {
  const double y = top + 1.1;
  paper.text(std::string(name_of(row.method)), {kName, y}, {.size = 0.92});
  if (facts_of(row.method).control == StepControl::adaptive)  // the step is not its
    paper.text("tol. " + signed_short(kDefaultTolerance), {right_of(0) - kColumn + 0.3, y},
               {.align = 1, .size = 0.85, .quiet = true});
  for (int c = 0; c < kColumns; ++c) {
    const Column& column = kTable[static_cast<std::size_t>(c)];
    const bool is_gross = column.value(row) > column.gross || (c == 0 && diverged(row));
    if (is_gross)
      paper.panel({right_of(c) - kColumn + 0.45, top + 0.06}, {right_of(c) + 0.3, top + kRow - 0.06},
                  paper.style().panel);
    paper.text(text_of(row, c), {right_of(c), y}, {.align = 1, .size = kSmall, .bold = is_gross});
  }
}

void draw(const SceneModel& model, double /*unused*/, Arrangement /*unused*/, DiagramPaper& paper) {
  add_head(model.methods, paper);
  double top = kHead;
  for (const MethodRow& row : model.methods.rows) {
    add_row(row, top, paper);
    top += kRow;
  }
}

}  // namespace

constexpr double kHeight = kHead + kMostRows * kRow;

const DiagramKind kMethodTable{{kWidth, kHeight}, {kWidth, kHeight}, draw};

}  // namespace polhode::diagrams
