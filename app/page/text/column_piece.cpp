// SPDX-License-Identifier: MIT
#include "app/page/text/column_piece.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace polhode {

void add(ColumnPiece& piece, ColumnPiece part, const Vec2& at) {
  for (LiveSlot slot : part.live) {
    slot.end += at;
    piece.live.push_back(std::move(slot));
  }
  for (LiveNumberSlot slot : part.numbers) {
    slot.room.at += at;
    piece.numbers.push_back(slot);
  }
  append(piece.sheet, std::move(part.sheet), at);
}

Stack stack(const std::vector<const ColumnPiece*>& pieces) {
  Stack made;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i > 0) made.height += std::round(std::max(pieces[i - 1]->gap, pieces[i]->gap));
    const ColumnPiece& piece = *pieces[i];
    made.pieces.push_back({.sheet = {},
                           .height = piece.height,
                           .gap = piece.gap,
                           .formula_scale = piece.formula_scale,
                           .of = piece.of,
                           .formula = piece.formula,
                           .is_main = piece.is_main,
                           .is_new = piece.is_new,
                           .step = piece.step,
                           .panel = piece.panel});
    for (QuestionRows rows : piece.questions) {
      for (double& y : rows.y) y += made.height;
      made.pieces.back().questions.push_back(std::move(rows));
    }
    add(made.pieces.back(), piece, {0, made.height});
    made.height += piece.height;
  }
  return made;
}

double height_of(const std::vector<const ColumnPiece*>& pieces) {
  double height = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    height += pieces[i]->height + (i > 0 ? std::round(std::max(pieces[i - 1]->gap, pieces[i]->gap)) : 0.0);
  return height;
}

}  // namespace polhode
