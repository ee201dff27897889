// SPDX-License-Identifier: MIT
// target_fuzz TARGET COUNT SEED FOLDER…: so many mutations of the files in these folders and in
// tests/data/fuzz/TARGET, without a look at what they reach: where there is no libFuzzer, or no time to build
// for it. Ends with 1 at the first finding, which is kept in the file "finding".
#include "tests/fuzz/mutate.h"
#include "tests/fuzz/targets.h"
#include "tests/support/paths.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <vector>

namespace polhode::fuzz {
namespace {

namespace fs = std::filesystem;

std::vector<Target> all_targets() {
  std::vector<Target> all;
  for (const auto targets : {render_targets(), reader_targets(), program_targets()})
    all.insert(all.end(), targets.begin(), targets.end());
  return all;
}

void add_files_of(const fs::path& folder, std::vector<std::string>& all) {
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.insert(entry.path());
  for (const fs::path& file : files) {
    std::ifstream stream(file, std::ios::binary);
    all.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
}

/// The words of the seeds, and what breaks texts.
std::vector<std::string> tokens_of(const std::vector<std::string>& seeds) {
  std::set<std::string> tokens = {"[",  "]",       "{",     "}",    "(",        ")",     "\"",          "'''",
                                  "\n", "\r\n",    "\0",    "\xFF", "\xE2\x82", "1e999", "-1",          "nan",
                                  "0",  "\\u001b", "\x1b[", "```",  "+++",      "$",     "99999999999", "=>"};
  for (const std::string& seed : seeds) {
    std::istringstream words(seed);
    constexpr std::size_t kMost = 4000, kLongest = 40;
    for (std::string word; words >> word && tokens.size() < kMost;)
      if (word.size() <= kLongest) tokens.insert(word);
  }
  return {tokens.begin(), tokens.end()};
}

int run(const Target& target, long count, std::uint64_t seed, const std::vector<fs::path>& folders) {
  std::vector<std::string> seeds;
  add_files_of(test::source_dir() / "tests/data/fuzz" / target.name, seeds);
  for (const fs::path& folder : folders) add_files_of(folder, seeds);
  Mutator inputs(seeds, tokens_of(seeds), seed);
  double slowest_s = 0;
  for (long i = 0; i < count; ++i) {
    const std::string input = inputs.next();
    const std::clock_t begin = std::clock();
    const std::string finding = target.finding_in(input);
    slowest_s = std::max(slowest_s, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    if (finding.empty() && slowest_s <= 1.0) continue;
    std::ofstream("finding", std::ios::binary) << input;
    std::printf("%s, input %ld: %s (%.2f s)\n", std::string(target.name).c_str(), i, finding.c_str(),
                slowest_s);
    return 1;
  }
  std::printf("%s: %ld inputs, slowest %.3f s, no finding\n", std::string(target.name).c_str(), count,
              slowest_s);
  return 0;
}

}  // namespace
}  // namespace polhode::fuzz

int main(int argc, char** argv) {
  using namespace polhode::fuzz;
  const auto all = all_targets();
  const auto target = std::find_if(all.begin(), all.end(),
                                   [&](const Target& one) { return argc > 1 && one.name == argv[1]; });
  if (argc < 4 || target == all.end()) {
    std::fprintf(stderr, "usage: target_fuzz TARGET COUNT SEED [FOLDER...], TARGET one of:");
    for (const Target& one : all) std::fprintf(stderr, " %s", std::string(one.name).c_str());
    std::fprintf(stderr, "\n");
    return 2;
  }
  return run(*target, std::strtol(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10),
             {argv + 4, argv + argc});
}
