// SPDX-License-Identifier: MIT
// A small film of tests/data/app/tiny.md, for tests of how an export is made rather than of what it shows.
#pragma once

#include "tests/app/run_program.h"

#include <map>

namespace polhode {

inline constexpr std::size_t kSmallFrames = 12;

inline std::vector<std::string> small_export(const std::filesystem::path& folder,
                                             const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"export",    test_lesson("tiny.md"),
                                    "-o",        folder.string(),
                                    "--what",    "figure",
                                    "--size",    "48x27",
                                    "--each",    "frame",
                                    "--fps",     "3",
                                    "--stage",   "steady",
                                    "--stage",   "rolling",
                                    "--seconds", "2"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Name → bytes of all files, hidden ones too.
inline std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const std::string& name : names_in(folder)) files[name] = text_of(folder / name);
  return files;
}

}  // namespace polhode
