// SPDX-License-Identifier: MIT
// What the window lays over a figure: where to take hold, and what is shown in place of the lesson's scene.
#pragma once

#include "app/window/panels/panel_context.h"
#include "render/gl/renderer.h"

#include <utility>
#include <vector>

namespace polhode {

/// What a hand has to do with the tip of ω; short_of: it is where no ω of this energy ends; untaken: it
/// points at an arrow by which ω is not taken.
enum class TipHand { away, near, turns, scales, short_of, untaken };

/// What something that lies on a figure keeps clear of, px.
struct TakenOnFigure {
  std::vector<PixelBox> names{};   ///< and tips of arrows: to be kept clear of above all
  std::vector<PixelBox> bodies{};  ///< shafts of arrows, surfaces
  /// Of what a box there would hide.
  double hidden_by(const PixelBox& box) const;
};

/// Where words of this size stand beside a point, `gap` from it, px: inside the room and clear of what is
/// there, as far as that can be. `place` is which of some places they had, and have now: they stay while they
/// are clear.
Vec2 place_beside(const Vec2& at, double gap, const Vec2& size, const PixelBox& room,
                  const TakenOnFigure& taken, std::size_t& place);

/// Which of these boxes hides least, the first of those that hide the same.
std::size_t clearest(const std::vector<PixelBox>& boxes, const TakenOnFigure& taken);

/// From where to where, rad clockwise from the right, a ring about a point is to be drawn, so that it crosses
/// none of the boxes.
std::vector<std::pair<double, double>> ring_beside(const Vec2& at, double radius,
                                                   const std::vector<PixelBox>& names);

/// Whether a question of the step asks for another ω, while the lesson's body is shown.
bool is_to_be_dragged(const LessonSession& session);

/// What the words at a tip keep clear of, besides arrows.
struct AroundTip {
  PixelBox room{};                ///< of the figure
  std::vector<PixelBox> names{};  ///< and captions
  std::size_t* place = nullptr;   ///< of place_beside
};
/// A ring round the tip of ω where a question asks to drag it, and where a hand is near; while it is held,
/// its components and what is kept. Where the pointer is at an arrow that is no such ω, that it is none.
void draw_drag_marks(const LessonSession& session, const std::vector<Inset>& insets, TipHand hand,
                     const AroundTip& around, const ControlSizes& sizes);

/// Where the chip of a changed scene stands in a figure. It stays as long as the figure has the same place,
/// unless it would hide a name or the head of an arrow.
struct ChipPlace {
  std::size_t corner = 0;  ///< upper right, upper left, lower left
  Region of{};             ///< the figure
  Region box{};            ///< of the chip as it was drawn last; without width: it was not
};
/// In a corner of the figure, the region, clear of what is drawn there as far as can be: that the scene was
/// changed, or is that of a counterexample, with a button that leads back; on one line where it has room.
/// Nothing of the lesson's own scene, nor while the hand has ω.
/// @param names what is written in the figure; of one that moves they need not be known
void draw_scene_chip(LessonSession& session, const std::vector<Inset>& insets,
                     const std::vector<PixelBox>& names, bool is_held, const Region& figure,
                     const ControlSizes& sizes, ChipPlace& place);

/// In the lower right corner of the figure: larger, where it has type that is too small to be read; and back.
void draw_size_chip(LessonSession& session, bool is_too_small, const Region& figure,
                    const ControlSizes& sizes);

}  // namespace polhode
