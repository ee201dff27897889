// SPDX-License-Identifier: MIT
// polhode compare: two PNG files by the golden rule.
#include "render/image/compare.h"

#include "app/cli/commands/commands.h"
#include "app/cli/or_fail.h"
#include "render/image/compare_files.h"
#include "render/image/png.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace polhode {

namespace {

struct Options {
  std::string a, b, diff;
  bool json = false;
};

void print_json(const Comparison& found) {
  const nlohmann::ordered_json json = {{"equal", found.equal()},
                                       {"pixels", found.pixels},
                                       {"over_3", found.over_3},
                                       {"over_fraction", found.over_fraction()},
                                       {"max", found.max}};
  fmt::print("{}\n", json.dump(2));
}

void print_words(const Comparison& found, Size a, Size b) {
  if (!found.same_size) {
    fmt::print("different: {}x{} and {}x{} pixels\n", a.width, a.height, b.width, b.height);
    return;
  }
  fmt::print("{}: {} of {} pixels ({:.4f} %) differ by more than {} levels, the largest difference is {}\n",
             found.equal() ? "equal" : "different", found.over_3, found.pixels, 100.0 * found.over_fraction(),
             kGoldenLevels, found.max);
}

/// Only for this both pictures are held whole.
void write_difference(const Options& options) {
  const auto read = [](const std::string& path) { return or_fail(read_png(path)).image; };
  or_fail(write_png(options.diff, difference_image(read(options.a), read(options.b)), {}));
}

ExitCode compare(const Options& options) {
  const FileComparison files = or_fail(compare_png_files(options.a, options.b));
  if (options.json)
    print_json(files.found);
  else
    print_words(files.found, files.a, files.b);
  if (!options.diff.empty()) write_difference(options);
  return files.found.equal() ? ExitCode::done : ExitCode::different;
}

}  // namespace

ProgramCommand compare_command() {
  const auto options = std::make_shared<Options>();
  return {"compare",
          "Compare two PNG files by the golden rule",
          {{"A", &options->a, "PNG file", " ", true, offer_files()},
           {"B", &options->b, "PNG file", " ", true, offer_files()},
           {"--diff", &options->diff, "write a picture of the differences, in red", "FILE.png", false,
            offer_files()},
           {"--json", &options->json, "equal, pixels, over_3, over_fraction and max as JSON"}},
          "Equal: same size, at most 0.02 % of the pixels off by more than 3 levels in any channel (alpha\n"
          "too), none by more than 48. Exit code 4 if different, 1 if a file cannot be read.",
          [options](const CommandWords&) { return compare(*options); }};
}

}  // namespace polhode
