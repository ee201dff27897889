// SPDX-License-Identifier: MIT
// Which equations of a step count most, and which of earlier steps stand on a page again.
#pragma once

#include "app/page/page.h"

#include <vector>

namespace polhode {

/// The equation that a step has come to, which the accent bar stands beside: of those that hold the first
/// with a number, else the first. Null: none.
const Equation* focus_of(const Stage& stage, const Step& step);

/// Whether a display stands as the one in focus does: of two equations of one weight none is less than the
/// other.
bool is_in_focus(const Stage& stage, const Step& step, const Equation& equation);

/// An equation of an earlier step, without its text.
struct Recalled {
  const Equation* equation = nullptr;
  const Step* of = nullptr;
  std::size_t step = 0;  ///< its number in the page's stage; 0: it is of another stage
  int weight = 0;        ///< of two that have no room together the heavier stays
};

/// All that may stand above step `whole_from` (from 0), in their order: those of the stage's earlier steps.
/// On a page to read those alone that its steps say they go on from, of other stages too: the others stand on
/// the pages before it.
std::vector<Recalled> recallable(const PageRequest& request, std::size_t whole_from);

/// What a slide says that it goes on from, or the last equation that an earlier step has come to. Null:
/// nothing.
const Equation* recalled_on_slide(const PageRequest& request);

}  // namespace polhode
