// SPDX-License-Identifier: MIT
// Whatever reads bytes of others, as a function of these bytes, and what must hold of any of them. libFuzzer
// looks for bytes of which it does not hold (the preset fuzz, tests/fuzz/fuzz.py); what it found lies in
// tests/data/fuzz, and every ./check tries that again.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace polhode::fuzz {

struct Target {
  std::string_view name;  ///< of its fuzzer, and of its folder in tests/data/fuzz
  /// What is wrong with what is made of the bytes; empty: nothing. That nothing crashes, and what a sanitizer
  /// says, is for the caller to see.
  std::string (*finding_in)(std::string_view bytes);
};

/// What needs no lesson: png, and tex, formulas as they are set.
std::span<const Target> render_targets();

/// What reads lessons, and what is typed as an answer: lesson, front_matter, formula (what it states), text,
/// expression, line, answer.
std::span<const Target> reader_targets();

/// What reads files of our own and the command line: record (manifest and marker of an export), state (files
/// of the state folder), report (answers handed in), command.
std::span<const Target> program_targets();

}  // namespace polhode::fuzz
