// SPDX-License-Identifier: MIT
// What the window lays over a figure: where to take hold, and what is shown in place of the lesson's scene.
#pragma once

#include "app/window/panels/panel_context.h"
#include "render/gl/renderer.h"

#include <vector>

namespace polhode {

/// What a hand has to do with the tip of ω; short_of: it is where no ω of this energy ends; untaken: it
/// points at an arrow by which ω is not taken.
enum class TipHand { away, near, turns, scales, short_of, untaken };

/// Where words of this size stand beside a point, `gap` from it, px: inside the room and clear of what is
/// there, as far as that can be. `place` is which of some places they had, and have now: they stay while they
/// are clear.
Vec2 place_beside(const Vec2& at, double gap, const Vec2& size, const PixelBox& room,
                  const std::vector<PixelBox>& taken, std::size_t& place);

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

/// In an upper corner of the figure, the region, clear of the tips of ω: that the scene was changed, or is
/// that of a counterexample, with a button that leads back. Nothing of the lesson's own scene, nor while the
/// hand has ω.
void draw_scene_chip(LessonSession& session, const std::vector<Inset>& insets, bool is_held,
                     const Region& figure, const ControlSizes& sizes);

/// In the lower right corner of the figure: larger, where it has type that is too small to be read; and back.
void draw_size_chip(LessonSession& session, bool is_too_small, const Region& figure,
                    const ControlSizes& sizes);

}  // namespace polhode
