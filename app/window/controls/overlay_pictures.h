// SPDX-License-Identifier: MIT
// A small picture of each overlay, as it is in the scene that is shown: what one chooses among in Show.
#pragma once

#include "app/page/page_theme.h"
#include "render/gl/framebuffer.h"
#include "render/gl/renderer.h"
#include "render/scene/description/scene.h"

#include <map>
#include <optional>

namespace polhode {

class OverlayPictures {
 public:
  /// Both must outlive it.
  OverlayPictures(const Gl& gl, Renderer& renderer) : gl_(gl), renderer_(renderer) {}

  /// Before a frame.
  void begin_frame() { has_drawn_ = is_waiting_ = false; }

  /// As an item of the present ImGui window, `height` px high: the overlay alone at the scene's still, at
  /// first an empty place. A frame draws one at most, and none that is not seen, so that no frame is late. Of
  /// a scene in motion a frame has no time for them: `may_draw` is false. Those of another body, motion or
  /// view are drawn anew. Nothing of what compares methods, which takes seconds to compute.
  void show(Overlay overlay, const Scene& scene, Theme theme, float height, bool may_draw);

  /// The next frame has more to draw.
  bool is_waiting() const { return is_waiting_; }

  /// For tests: how many were drawn since the beginning.
  int count() const { return count_; }

 private:
  std::optional<Framebuffer> drawn(Overlay overlay, const Scene& scene, Theme theme, Size size) const;

  const Gl& gl_;
  Renderer& renderer_;
  std::optional<Scene> scene_;  ///< of the pictures, without what differs from one to another
  Theme theme_ = Theme::paper;
  Size size_{};
  std::map<Overlay, std::optional<Framebuffer>> pictures_;  ///< nothing: it cannot be drawn
  bool has_drawn_ = false, is_waiting_ = false;
  int count_ = 0;
};

}  // namespace polhode
