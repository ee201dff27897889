// SPDX-License-Identifier: MIT
// text_fuzz COUNT [SEED]: so many mutated texts; ends with 1 and shows the first that is not handled well.
#include "tests/fuzz/text_inputs.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: text_fuzz COUNT [SEED]\n");
    return 2;
  }
  const long count = std::strtol(argv[1], nullptr, 10);
  const auto fonts = polhode::Fonts::open();
  if (!fonts.ok()) {
    std::fprintf(stderr, "%s\n", fonts.error().c_str());
    return 1;
  }
  auto texts = polhode::fuzz::mutated_texts(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
  for (long i = 0; i < count; ++i) {
    const std::string text = texts.next();
    const std::string finding = polhode::fuzz::finding_in_text(text, i % 7 == 0, *fonts);
    if (finding.empty()) continue;
    std::printf("input %ld: %s\n%s\n", i, finding.c_str(), text.c_str());
    return 1;
  }
  std::printf("%ld texts, no finding\n", count);
  return 0;
}
