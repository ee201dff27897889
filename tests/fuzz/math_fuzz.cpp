// SPDX-License-Identifier: MIT
// math_fuzz COUNT [SEED]: so many mutated formulas; ends with 1 and shows the first that is not handled well.
#include "tests/fuzz/math_inputs.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: math_fuzz COUNT [SEED]\n");
    return 2;
  }
  const long count = std::strtol(argv[1], nullptr, 10);
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const auto fonts = polhode::Fonts::open();
  if (!fonts.ok()) {
    std::fprintf(stderr, "%s\n", fonts.error().c_str());
    return 1;
  }
  auto formulas = polhode::fuzz::mutated_formulas(seed);
  long set = 0;
  for (long i = 0; i < count; ++i) {
    const std::string tex = formulas.next();
    const std::string finding = polhode::fuzz::finding_in(tex, *fonts);
    set += polhode::parse_math(tex).ok() ? 1 : 0;
    if (finding.empty()) continue;
    std::printf("input %ld: %s\n%s\n", i, finding.c_str(), tex.c_str());
    return 1;
  }
  std::printf("%ld inputs, %ld of them set, no finding\n", count, set);
  return 0;
}
