// SPDX-License-Identifier: MIT
#include "render/drawing/diagrams/diagrams.h"

#include "render/drawing/diagrams/diagram_paper.h"

#include <algorithm>

namespace polhode {
namespace {

const boards::BoardKind& kind_of(Overlay board) {
  switch (board) {
    case Overlay::tensor_bars:
      return boards::kTensorBars;
    case Overlay::cofactors:
      return boards::kCofactors;
    case Overlay::cyclic_wheel:
      return boards::kCyclicWheel;
    case Overlay::energy_rows:
      return boards::kEnergyRows;
    case Overlay::momentum_rows:
      return boards::kMomentumRows;
    case Overlay::method_table:
      return boards::kMethodTable;
    case Overlay::order_plot:
      return boards::kOrderPlot;
    default:
      return boards::kCards;
  }
}

/// The one that lets the type be larger.
boards::Arrangement arrangement_in(const boards::BoardKind& kind, const PixelBox& box) {
  const auto scale = [&](const Vec2& extent) {
    return std::min(box.width() / extent.x(), box.height() / extent.y());
  };
  return scale(kind.wide) >= scale(kind.tall) ? boards::Arrangement::wide : boards::Arrangement::tall;
}

std::vector<Overlay> those(const OverlaySet& drawn, bool (*wanted)(Overlay)) {
  std::vector<Overlay> found;
  for (int i = 0; i < kOverlayCount; ++i)
    if (const auto overlay = static_cast<Overlay>(i); drawn.contains(overlay) && wanted(overlay))
      found.push_back(overlay);
  return found;
}

}  // namespace

std::vector<Overlay> boards_in(const OverlaySet& drawn) { return those(drawn, is_diagram); }

bool shows_space(const OverlaySet& drawn) {
  const auto in_space = [](Overlay o) {
    return !is_diagram(o) && o != Overlay::labels && o != Overlay::values;
  };
  return boards_in(drawn).empty() || !those(drawn, in_space).empty();
}

Vec2 board_extent(Overlay board, const PixelBox& box) {
  const boards::BoardKind& kind = kind_of(board);
  return arrangement_in(kind, box) == boards::Arrangement::wide ? kind.wide : kind.tall;
}

Sheet lay_out_board(Overlay board, const SceneModel& model, double t_s, const PixelBox& box,
                    const BoardStyle& style, const Fonts& fonts) {
  const boards::BoardKind& kind = kind_of(board);
  boards::BoardPaper paper(board_extent(board, box), box, style, fonts);
  kind.draw(model, t_s, arrangement_in(kind, box), paper);
  return paper.take();
}

}  // namespace polhode
