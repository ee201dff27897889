// SPDX-License-Identifier: MIT
#include "render/drawing/diagrams/diagrams.h"

#include "render/drawing/diagrams/diagram_paper.h"

#include <algorithm>
#include <cassert>

namespace polhode {
namespace {

using diagrams::DiagramKind;

const DiagramKind& kind_of(Overlay diagram) {
  const auto found = std::ranges::find(diagrams::kKinds, diagram, &diagrams::OverlayKind::overlay);
  assert(found != diagrams::kKinds.end() && "no diagram");
  return *found->kind;
}

/// The one that lets the type be larger.
diagrams::Arrangement arrangement_in(const DiagramKind& kind, const PixelBox& box) {
  const auto scale = [&](const Vec2& extent) {
    return std::min(box.width() / extent.x(), box.height() / extent.y());
  };
  return scale(kind.wide) >= scale(kind.tall) ? diagrams::Arrangement::wide : diagrams::Arrangement::tall;
}

}  // namespace

Vec2 diagram_extent(Overlay diagram, const PixelBox& box) {
  const DiagramKind& kind = kind_of(diagram);
  if (kind.most.x() > 0) {
    const double size = std::min(box.width() / kind.wide.x(), box.height() / kind.wide.y());
    return kind.most.cwiseMin(Vec2(box.width(), box.height()) / size);
  }
  return arrangement_in(kind, box) == diagrams::Arrangement::wide ? kind.wide : kind.tall;
}

PixelBox diagram_box(Overlay diagram, const PixelBox& box, const DiagramStyle& style) {
  const Vec2 extent = diagram_extent(diagram, box);
  const double unit = std::min({style.type_size, box.width() / extent.x(), box.height() / extent.y()});
  const double x = box.x0 + 0.5 * (box.width() - unit * extent.x()),
               y = box.y0 + 0.5 * (box.height() - unit * extent.y());
  return {x, y, x + unit * extent.x(), y + unit * extent.y()};
}

Sheet lay_out_diagram(Overlay diagram, const SceneModel& model, double t_s, const PixelBox& box,
                      const DiagramStyle& style, const Fonts& fonts) {
  const DiagramKind& kind = kind_of(diagram);
  diagrams::DiagramPaper paper(diagram_extent(diagram, box), diagram_box(diagram, box, style), style, fonts);
  kind.draw(model, t_s, arrangement_in(kind, box), paper);
  return paper.take();
}

}  // namespace polhode
