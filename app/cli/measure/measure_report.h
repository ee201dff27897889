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

/// Sorted by cost: the Pareto front (*), that of the methods that go step by step (+), and of each method the
/// cheapest row within the tolerance, or else its most accurate one. `all`: every row.
std::string table_text(const MeasureReport& report, bool all);

/// Which row meets the tolerance for the least, and which of the methods that go step by step; or that none
/// does and what comes nearest. Empty without a tolerance.
std::string advice_text(const MeasureReport& report);

/// Header and one line a row; 17 digits; a field that is null in JSON is empty.
std::string csv_text(std::span<const WorkPrecisionRow> rows);

/// {"rows":[…],"recommended":{…}|null}; 17 digits, NaN is null.
std::string json_text(const MeasureReport& report);

/// "step 0.0625 s, 12.5 us a period"
std::string cost_text(const WorkPrecisionRow& row);

}  // namespace polhode
