// SPDX-License-Identifier: MIT
// Which outcomes of the lesson a question tests: `outcome = 2`, or `outcome = [1, 3]`.
#pragma once

#include "lessons/diagnostics/report.h"
#include "lessons/reader/front_matter/toml_tree.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace polhode {

/// Numbers from 1 to `count`, that of the outcomes in the front matter, each once and in their order.
/// Nothing, and a report, if the value is anything else.
std::optional<std::vector<int>> read_outcomes(const TomlEntry& entry, std::size_t count, Report& report);

}  // namespace polhode
