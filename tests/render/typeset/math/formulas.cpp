// SPDX-License-Identifier: MIT
#include "tests/render/typeset/math/formulas.h"

#include "tests/support/paths.h"

#include <fstream>

namespace polhode::testing {

std::vector<NamedFormula> named_formulas(const std::string& file) {
  std::ifstream in(test::source_dir() / "tests/data/formulas" / (file + ".tsv"));
  std::vector<NamedFormula> formulas;
  for (std::string line; std::getline(in, line);) {
    const std::size_t tab = line.find('\t');
    if (tab != std::string::npos) formulas.push_back({line.substr(0, tab), line.substr(tab + 1)});
  }
  return formulas;
}

std::vector<NamedFormula> all_formulas() {
  std::vector<NamedFormula> all = named_formulas("lecture");
  for (NamedFormula& f : named_formulas("corpus")) all.push_back(std::move(f));
  return all;
}

}  // namespace polhode::testing
