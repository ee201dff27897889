// SPDX-License-Identifier: MIT
#include "render/drawing/diagrams/diagrams.h"

#include "render/drawing/diagrams/diagram_paper.h"

#include <algorithm>
#include <cassert>

namespace polhode {
namespace {

const diagrams::DiagramKind& kind_of(Overlay diagram) {
  switch (diagram) {
    case Overlay::tensor_bars:
      return diagrams::kTensorBars;
    case Overlay::cofactors:
      return diagrams::kCofactors;
    case Overlay::cyclic_wheel:
      return diagrams::kCyclicWheel;
    case Overlay::energy_rows:
      return diagrams::kEnergyRows;
    case Overlay::momentum_rows:
      return diagrams::kMomentumRows;
    case Overlay::method_table:
      return diagrams::kMethodTable;
    case Overlay::order_plot:
      return diagrams::kOrderPlot;
    case Overlay::cards:
      return diagrams::kCards;
    default:
      break;
  }
  assert(false && "no diagram");
  return diagrams::kCards;
}

/// The one that lets the type be larger.
diagrams::Arrangement arrangement_in(const diagrams::DiagramKind& kind, const PixelBox& box) {
  const auto scale = [&](const Vec2& extent) {
    return std::min(box.width() / extent.x(), box.height() / extent.y());
  };
  return scale(kind.wide) >= scale(kind.tall) ? diagrams::Arrangement::wide : diagrams::Arrangement::tall;
}

std::vector<Overlay> those(const OverlaySet& drawn, bool (*wanted)(Overlay)) {
  std::vector<Overlay> found;
  for (int i = 0; i < kOverlayCount; ++i)
    if (const auto overlay = static_cast<Overlay>(i); drawn.contains(overlay) && wanted(overlay))
      found.push_back(overlay);
  return found;
}

}  // namespace

std::vector<Overlay> diagrams_in(const OverlaySet& drawn) { return those(drawn, is_diagram); }

bool shows_space(const OverlaySet& drawn) {
  const auto in_space = [](Overlay o) {
    return !is_diagram(o) && o != Overlay::labels && o != Overlay::values;
  };
  return diagrams_in(drawn).empty() || !those(drawn, in_space).empty();
}

Vec2 diagram_extent(Overlay diagram, const PixelBox& box) {
  const diagrams::DiagramKind& kind = kind_of(diagram);
  return arrangement_in(kind, box) == diagrams::Arrangement::wide ? kind.wide : kind.tall;
}

Sheet lay_out_diagram(Overlay diagram, const SceneModel& model, double t_s, const PixelBox& box,
                      const DiagramStyle& style, const Fonts& fonts) {
  const diagrams::DiagramKind& kind = kind_of(diagram);
  diagrams::DiagramPaper paper(diagram_extent(diagram, box), box, style, fonts);
  kind.draw(model, t_s, arrangement_in(kind, box), paper);
  return paper.take();
}

}  // namespace polhode
