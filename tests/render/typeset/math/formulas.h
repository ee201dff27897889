// SPDX-License-Identifier: MIT
// The formulas of tests/data/formulas: one on each line, its name, a tab, its TeX.
#pragma once

#include <string>
#include <vector>

namespace polhode::testing {

struct NamedFormula {
  std::string name;
  std::string tex;
};

/// `file` is "lecture" or "corpus".
std::vector<NamedFormula> named_formulas(const std::string& file);
/// Both files.
std::vector<NamedFormula> all_formulas();

}  // namespace polhode::testing
