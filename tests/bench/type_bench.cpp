// SPDX-License-Identifier: MIT
// What formulas cost: one core, nothing kept from one run to the next but the open fonts.
#include "render/typeset/math/math.h"
#include "tests/bench/page_cost.h"
#include "tests/bench/table.h"
#include "tests/support/paths.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace polhode::bench {
namespace {

std::vector<std::string> formulas_of_the_lecture() {
  std::ifstream in(test::source_dir() / "tests/data/formulas/lecture.tsv");
  std::vector<std::string> formulas;
  for (std::string line; std::getline(in, line);) formulas.push_back(line.substr(line.find('\t') + 1));
  return formulas;
}

std::size_t set_all(const std::vector<std::string>& formulas, const Fonts& fonts) {
  MathStyle style;
  style.size = 30.0;
  style.display = true;
  std::size_t glyphs = 0;
  for (const std::string& tex : formulas) {
    const auto math = parse_math(tex);
    if (!math.ok()) continue;
    const auto list = set_math(*math, style, fonts);
    if (list.ok()) glyphs += list->glyphs.size();
  }
  return glyphs;
}

int run() {
  const auto formulas = formulas_of_the_lecture();
  std::vector<double> cold_ms, warm_ms;
  std::size_t glyphs = 0;
  constexpr int kRuns = 40;
  for (int i = 0; i < kRuns; ++i) {
    const auto fonts = Fonts::open();
    if (!fonts.ok()) {
      std::fprintf(stderr, "%s\n", fonts.error().c_str());
      return 1;
    }
    cold_ms.push_back(1e3 * cpu_s([&] { glyphs = set_all(formulas, *fonts); }));
    warm_ms.push_back(1e3 * cpu_s([&] { glyphs = set_all(formulas, *fonts); }));
  }
  const std::string what =
      std::to_string(formulas.size()) + " formulas, " + std::to_string(glyphs) + " glyphs";
  print_row_heading();
  print({"formulas of the lecture, fonts just opened, ms", spread_of(cold_ms), at_most(5.0),
         "read and set: " + what});
  print({"the same again, ms", spread_of(warm_ms), {}, what});
  const auto pages = page_costs_ms();
  print({"a page less its figure, no glyph kept, ms", spread_of(pages), at_most(15.0),
         std::to_string(pages.size()) + " pages of 1600x1000, laid out and drawn; the dearest " +
             std::to_string(*std::max_element(pages.begin(), pages.end()))});
  const auto dearest_of = [](const std::vector<double>& costs) {
    return "the dearest " + std::to_string(*std::max_element(costs.begin(), costs.end()));
  };
  const auto typing = typing_costs_ms();
  print({"a letter of a derivation, read and the page laid out, ms", spread_of(typing), at_most(5.0),
         std::to_string(typing.size()) + " letters; " + dearest_of(typing)});
  const auto judging = judging_costs_ms();
  print({"a line of a derivation, judged, ms", spread_of(judging), at_most(50.0),
         std::to_string(judging.size()) + " lines; " + dearest_of(judging)});
  return 0;
}

}  // namespace
}  // namespace polhode::bench

int main() { return polhode::bench::run(); }
