// SPDX-License-Identifier: MIT
// One target for libFuzzer: POLHODE_FUZZ_TARGET of POLHODE_FUZZ_TARGETS().
#include "tests/fuzz/targets.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace polhode::fuzz {
namespace {

/// CPU time of one input, with sanitizers, which take some five times as long as without. (The timeout of
/// libFuzzer counts time on the clock, also while other programs have the machine.)
constexpr double kMostSeconds = 1.0;

const Target& target() {
  const auto all = POLHODE_FUZZ_TARGETS();
  static const Target& kTarget = *std::find_if(
      all.begin(), all.end(), [](const Target& one) { return one.name == POLHODE_FUZZ_TARGET; });
  return kTarget;
}

[[noreturn]] void found(const char* what) {
  std::fprintf(stderr, "finding: %s\n", what);
  std::abort();
}

}  // namespace
}  // namespace polhode::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace polhode::fuzz;
  const std::clock_t begin = std::clock();
  const std::string finding = target().finding_in({reinterpret_cast<const char*>(data), size});
  if (!finding.empty()) found(finding.c_str());
  if (static_cast<double>(std::clock() - begin) > kMostSeconds * CLOCKS_PER_SEC) found("it takes too long");
  return 0;
}
