// SPDX-License-Identifier: MIT
// A block of a lesson as it stands in the text column of a page, and how blocks stand one below the other.
#pragma once

#include "app/page/live_numbers.h"
#include "lessons/reader/lesson.h"
#include "render/drawing/sheet.h"
#include "render/typeset/paragraph.h"

#include <optional>
#include <vector>

namespace polhode {

/// Where live values of a claim are to stand: the right end of their first row.
struct LiveSlot {
  const Claim* claim = nullptr;
  Vec2 end{0, 0};
  double room = 0;  ///< px; longer rows are set smaller
  double line = 0;  ///< px from row to row
  TextStyle style;
};

/// Where a number that runs with the page is to stand.
struct LiveNumberSlot {
  const ComputedNumber* number = nullptr;
  LiveRoom room;
};

/// The rows of a question that a click is for, px: of its choices, or, where it has none to pick, one row
/// that is all of it.
struct QuestionRows {
  const Ask* ask = nullptr;
  double x0 = 0, x1 = 0;
  std::vector<double> y;  ///< of each row its upper edge, and the lower one of the last
};

/// Something in the column: its drawing from the upper left corner, and the room it takes.
struct ColumnPiece {
  Sheet sheet;
  double height = 0;         ///< whole px
  double width = 0;          ///< of what another one can stand beside
  double gap = 0;            ///< least distance to what is above and below
  double formula_scale = 1;  ///< of a display: its size beside the normal one; below 1 where it was too wide
  std::vector<LiveSlot> live{};
  std::vector<LiveNumberSlot> numbers{};
  std::vector<QuestionRows> questions{};  ///< of a page that can be clicked: one at most
  const void* of = nullptr;               ///< the part of the lesson it shows: the same on another page
  std::optional<std::size_t> formula{};   ///< of an equation: which of the sheet's texts it is
  bool is_main = false;                   ///< the equation that its step has come to
  bool is_new = false;                    ///< of the present step
  int step = 0;                           ///< of the stage, from 1, to which it belongs; 0: to none
  std::size_t panel = 0;  ///< how many of the sheet's shapes, from the first, are panel and bar of the focus
};

/// Drawing and slots of `part`, moved by `at`, over those of `piece`.
void add(ColumnPiece& piece, ColumnPiece part, const Vec2& at);

/// Pieces one below the other, each in its place; the height they take together.
struct Stack {
  std::vector<ColumnPiece> pieces;
  double height = 0;
};
Stack stack(const std::vector<const ColumnPiece*>& pieces);
/// The same without drawing.
double height_of(const std::vector<const ColumnPiece*>& pieces);

}  // namespace polhode
