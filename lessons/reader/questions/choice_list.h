// SPDX-License-Identifier: MIT
// The choices of a question as a Markdown list, below the keys of its ```ask fence:
//
//   - [ ] a choice, in one line        1. what comes first
//     what is said to who picks it     2. what comes second
//   - [x] the right one
//
// and the order in which they are shown.
#pragma once

#include "lessons/diagnostics/report.h"
#include "lessons/reader/markdown/located_text.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace polhode {

struct ChoiceList {
  struct Item {
    LocatedText text;
    LocatedText reply;  ///< without its indentation; empty: none
    bool is_right = false;
    SourcePlace place;
  };
  std::vector<Item> items;
  bool is_numbered = false;
  SourcePlace place;
};

/// The line of first…last where such a list begins, `last` + 1 if there is none: the lines before it are
/// TOML, in whose strings of several lines no list begins.
int first_line_of_list(const SourceText& source, int first, int last);

/// What is wrong is reported, and the list is read as far as it can be.
ChoiceList read_choice_list(int first, int last, Report& report);

/// In which order `count` choices are shown, as places in the order in which they are written. Fixed by the
/// three ids alone: their texts may be edited. All orders are equally likely over many ids.
std::vector<std::size_t> shuffled_order(std::string_view lesson_id, std::string_view stage_id,
                                        std::string_view ask_id, std::size_t count);

}  // namespace polhode
