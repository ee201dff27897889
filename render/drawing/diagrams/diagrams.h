// SPDX-License-Identifier: MIT
// Diagrams: flat figures of a scene at one time, as data. They stand in a figure's place alone, or beside the
// figure in space. Layout only; every number is computed from the model's motion.
//
//   tensor-bars   I_S = R I* Rᵀ (moves) beside I* (rests), with traces and eigenvalues
//   cofactors     ω×(I·ω) as a determinant, one cofactor found after the other: a third of the span each
//   cyclic-wheel  1 → 2 → 3 → 1 and the equations (7), (8), (9) it turns into each other, one lit likewise
//   energy-rows   (10)·ω1, (11)·ω2, (12)·ω3: the products and the first terms, each chained to their sum
//   momentum-rows (10)·I1ω1, (11)·I2ω2, (12)·I3ω3 likewise
//   cards         the twelve equations with what they are
//   method-table  how far each method is from the true motion at the time of the still, and what it costs
//   order-plot    the error of ω there against the number of steps, and the order that each method shows
//
// ω̇ is a difference quotient of the motion (euler_terms.h), not solved for in the equations that the
// diagrams show to hold. Numbers of one kind have the same decimals: three digits of the largest over the
// model's span, which also sets the scale of bars, so that nothing but the values moves in a film.
#pragma once

#include "render/drawing/label_layout.h"
#include "render/palette.h"
#include "render/scene/model/model.h"
#include "render/typeset/fonts.h"

#include <vector>

namespace polhode {

struct DiagramStyle {
  double type_size = 24;  ///< px, the largest: a diagram that needs more room than there is has smaller type
  Color ink = kInk, muted = color_from_hex(0x5F656D), line = color_from_hex(0xDDD8CB), paper = kPaper,
        panel = color_from_hex(0xF3EDDD);  ///< panel: behind what is lit
};

/// Width and height of a diagram as it is arranged in a box of that size, in sizes of its type.
Vec2 diagram_extent(Overlay diagram, const PixelBox& box);

/// What a diagram takes of a box: in its middle, the type as large as there is room for.
PixelBox diagram_box(Overlay diagram, const PixelBox& box, const DiagramStyle& style);

/// There. Pure.
Sheet lay_out_diagram(Overlay diagram, const SceneModel& model, double t_s, const PixelBox& box,
                      const DiagramStyle& style, const Fonts& fonts);

}  // namespace polhode
