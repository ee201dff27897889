// SPDX-License-Identifier: MIT
#include "app/cli/measure/measure_report.h"

#include "base/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace polhode {

namespace {

using Rows = std::span<const WorkPrecisionRow>;

/// Name and value of the numbers of a row, as in CSV and JSON; NaN: there is none.
using Fields = std::array<std::pair<const char*, double>, 6>;
Fields numbers_after_evaluations(const WorkPrecisionRow& row) {
  return {{{"ns_per_period", row.ns_per_period},
           {"error_omega", row.error_omega},
           {"error_attitude_rad", row.error_attitude_rad},
           {"drift_T", row.drift_T},
           {"drift_L", row.drift_L},
           {"drift_L_direction_rad", row.drift_L_direction_rad}}};
}

std::string number_or(const char* none, double value) {
  return std::isfinite(value) ? digits17(value) : none;
}

/// What was not computed to its end has no count either.
std::string evaluations_or(const char* none, const WorkPrecisionRow& row) {
  return std::isfinite(row.error()) ? fmt::format("{}", row.evaluations) : none;
}

std::string json_row(const WorkPrecisionRow& row) {
  std::string text = fmt::format("{{\"method\":\"{}\",\"step\":{},\"tolerance\":{},\"evaluations\":{}",
                                 name_of(row.method), number_or("null", row.step_s.value_or(NAN)),
                                 number_or("null", row.tolerance.value_or(NAN)), evaluations_or("null", row));
  for (const auto& [name, value] : numbers_after_evaluations(row))
    text += fmt::format(",\"{}\":{}", name, number_or("null", value));
  return text + "}";
}

std::string duration_text(double ns) {
  if (!std::isfinite(ns)) return "-";
  if (ns < 999.5) return fmt::format("{:.3g} ns", ns);
  if (ns < 999.5e3) return fmt::format("{:.3g} us", ns / 1e3);
  return ns < 999.5e6 ? fmt::format("{:.3g} ms", ns / 1e6) : fmt::format("{:.3g} s", ns / 1e9);
}

std::string small_text(double value) {
  if (!std::isfinite(value)) return "-";
  return value == 0 ? "0" : fmt::format("{:.1e}", value);
}

std::string step_or_tolerance_text(const WorkPrecisionRow& row) {
  if (row.step_s) return fmt::format("{:.3g} s", *row.step_s);
  return row.tolerance ? fmt::format("tol {:.0e}", *row.tolerance) : "";
}

std::optional<std::size_t> most_accurate(Rows rows) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (std::isfinite(rows[i].error()) && (!best || rows[i].error() < rows[*best].error())) best = i;
  return best;
}

/// The row that stands for its method: the cheapest within the tolerance, or the most accurate.
std::size_t spokesman(Rows of_one_method, const std::optional<double>& tolerance) {
  const auto cheapest = tolerance ? cheapest_within(of_one_method, *tolerance) : std::nullopt;
  return cheapest.value_or(most_accurate(of_one_method).value_or(of_one_method.size() - 1));
}

std::vector<bool> shown_rows(const MeasureReport& report, std::vector<bool> shown,
                             const std::vector<bool>& front) {
  const Rows rows = report.rows;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (front[i]) shown[i] = true;
  for (std::size_t first = 0, end = 0; first < rows.size(); first = end) {
    while (end < rows.size() && rows[end].method == rows[first].method) ++end;
    shown[first + spokesman(rows.subspan(first, end - first), report.tolerance)] = true;
  }
  if (report.recommended) shown[*report.recommended] = true;
  return shown;
}

constexpr const char* kTableFormat = "{} {:<21} {:<10} {:>10} {:>8}  {:>8} {:>8} {:>8} {:>8} {:>8}\n";

std::string table_head() {
  return fmt::format("{:<35}{:>10} {:>8}  {:<17} {}\n", "", "evalua-", "CPU time", " error at the end",
                     " largest drift on the way") +
         fmt::format(kTableFormat, " ", "method", "step, tol.", "tions", "a period", "omega", "attitude", "T",
                     "|L|", "L dir.");
}

std::string table_row(const WorkPrecisionRow& row, char mark) {
  return fmt::format(kTableFormat, mark, name_of(row.method), step_or_tolerance_text(row),
                     evaluations_or("-", row), duration_text(row.ns_per_period), small_text(row.error_omega),
                     small_text(row.error_attitude_rad), small_text(row.drift_T), small_text(row.drift_L),
                     small_text(row.drift_L_direction_rad));
}

std::string result_text(const WorkPrecisionRow& row) {
  const char* bound = goes_step_by_step(row.method) ? "errors" : "errors of at most";
  const std::string errors =
      fmt::format("{} {} and {} rad", bound, small_text(row.error_omega), small_text(row.error_attitude_rad));
  return fmt::format("{}: {}, {}", name_of(row.method), cost_text(row), errors);
}

std::optional<WorkPrecisionRow> cheapest_step_by_step(const MeasureReport& report) {
  std::vector<WorkPrecisionRow> rows;
  std::copy_if(report.rows.begin(), report.rows.end(), std::back_inserter(rows),
               [](const WorkPrecisionRow& row) { return goes_step_by_step(row.method); });
  const auto place = cheapest_within(rows, *report.tolerance);
  return place ? std::optional(rows[*place]) : std::nullopt;
}

}  // namespace

std::string cost_text(const WorkPrecisionRow& row) {
  std::string text;
  if (row.step_s) text = fmt::format("step {:.6g} s, ", *row.step_s);
  if (row.tolerance) text = fmt::format("tolerance {:.0e}, ", *row.tolerance);
  return text + duration_text(row.ns_per_period) + " a period";
}

std::string table_text(const MeasureReport& report, bool all) {
  const std::vector<bool> front = pareto_front(report.rows), of_steps = front_step_by_step(report.rows);
  const auto mark = [&](std::size_t i) {
    return i == report.recommended ? '>' : front[i] ? '*' : of_steps[i] ? '+' : ' ';
  };
  const std::vector<bool> shown =
      all ? std::vector<bool>(front.size(), true) : shown_rows(report, of_steps, front);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < shown.size(); ++i)
    if (shown[i]) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return report.rows[a].ns_per_period < report.rows[b].ns_per_period;
  });

  std::string text = table_head();
  for (std::size_t i : order) text += table_row(report.rows[i], mark(i));
  return text;
}

std::string advice_text(const MeasureReport& report) {
  if (!report.tolerance) return "";
  const std::string asked =
      fmt::format("both errors at most {:g} after {:g} {}", *report.tolerance, report.periods, report.unit);
  if (!report.recommended) {
    const auto nearest = most_accurate(report.rows);
    return fmt::format("Nothing measured has {}{}.\n", asked,
                       nearest ? "; nearest comes " + result_text(report.rows[*nearest]) : "");
  }
  const WorkPrecisionRow& best = report.rows[*report.recommended];
  std::string text = fmt::format("The cheapest with {} is {}.\n", asked, result_text(best));
  if (const auto stepper = cheapest_step_by_step(report); stepper && !goes_step_by_step(best.method))
    text += fmt::format("The cheapest that goes step by step is {}.\n", result_text(*stepper));
  return text;
}

std::string csv_text(std::span<const WorkPrecisionRow> rows) {
  std::string text = "method,step,tolerance,evaluations";
  for (const auto& [name, value] : numbers_after_evaluations({})) text += fmt::format(",{}", name);
  text += '\n';
  for (const WorkPrecisionRow& row : rows) {
    text += fmt::format("{},{},{},{}", name_of(row.method), number_or("", row.step_s.value_or(NAN)),
                        number_or("", row.tolerance.value_or(NAN)), evaluations_or("", row));
    for (const auto& [name, value] : numbers_after_evaluations(row)) text += "," + number_or("", value);
    text += '\n';
  }
  return text;
}

std::string json_text(const MeasureReport& report) {
  std::string text = "{\"rows\":[";
  for (std::size_t i = 0; i < report.rows.size(); ++i)
    text += (i == 0 ? "\n" : ",\n") + json_row(report.rows[i]);
  const std::string recommended = report.recommended ? json_row(report.rows[*report.recommended]) : "null";
  return text + "\n],\n\"recommended\":" + recommended + "}\n";
}

}  // namespace polhode
