// SPDX-License-Identifier: MIT
// What `measure` says of its rows: a table for a person, CSV, JSON, one sentence of advice.
#pragma once

#include "physics/analysis/work_precision.h"

#include <string>

namespace polhode {

struct MeasureReport {
  std::vector<WorkPrecisionRow> rows;
  double period_s = 1, periods = 100;
  std::string unit = "periods";            ///< what is counted; "turns" where there is no polhode period
  std::optional<double> tolerance;         ///< that was asked for
  std::optional<std::size_t> recommended;  ///< place in rows
};

/// A table, sorted by cost. It has the rows of the Pareto front (marked *), those of the front of the methods
/// that go step by step (marked +), and of each method its cheapest row within the tolerance, or its most
/// accurate one if none is. With `all` it has every row.
std::string table_text(const MeasureReport& report, bool all);

/// Which row meets the tolerance at the least cost, and which does among the methods that go step by step. If
/// no row meets it: that, and which comes nearest. Empty without a tolerance.
std::string advice_text(const MeasureReport& report);

/// Header and one line a row; 17 digits; a field that is null in JSON is empty.
std::string csv_text(std::span<const WorkPrecisionRow> rows);

/// {"rows":[…],"recommended":{…}|null}; 17 digits, NaN is null.
std::string json_text(const MeasureReport& report);

/// "step 0.0625 s, 12.5 us a period"
std::string cost_text(const WorkPrecisionRow& row);

}  // namespace polhode
