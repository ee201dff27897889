// SPDX-License-Identifier: MIT
#include "app/window/controls/overlay_pictures.h"

#include "app/page/figure_place.h"
#include "app/window/controls/control_pass.h"
#include "render/scene/model/model.h"

#include <imgui.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace polhode {

namespace {

constexpr double kAspect = 4.0 / 3.0;

/// Names and numbers are those of something.
bool needs_others(Overlay overlay) { return overlay == Overlay::labels || overlay == Overlay::values; }

bool takes_long(Overlay overlay) {
  return overlay == Overlay::method_table || overlay == Overlay::order_plot;
}

/// What the picture of an overlay takes over: the motion, and from where it is seen.
Scene without_rest(Scene scene) {
  scene.beside.clear();
  scene.before = 0;
  scene.vary.clear();
  scene.label.clear();
  scene.marks = {};
  scene.poses = {};
  scene.meters.clear();
  scene.highlight.clear();
  scene.caption.clear();
  scene.camera.fitted.reset();
  scene.camera.zoom = 1;
  scene.quality = QualityLevel::normal;
  scene.motion.ghost = false;
  scene.views.resize(1, View::space);
  return scene;
}

}  // namespace

std::optional<Framebuffer> OverlayPictures::drawn(Overlay overlay, const Scene& scene, Theme theme,
                                                  Size size) const {
  constexpr double kLabels = 6;  // px: they are seen, not read
  Scene shown = without_rest(scene);
  shown.show = {overlay};
  if (needs_others(overlay)) shown.show = {Overlay::omega, Overlay::axes_body, overlay};
  const Color ground = theme == Theme::dark ? colors_of(theme).backdrop : colors_of(theme).paper;
  FigurePlace place{.rect = {0, 0, size.width, size.height}, .caption_px = kLabels, .theme = theme};
  place.background = {Background::Kind::color, ground};
  place.ground = ground;
  try {
    const SceneModel model = make_model(shown);
    const PlacedFigure figure = place_figure(model, still_time_s(shown), place, renderer_.fonts());
    auto pixels = Framebuffer::create(gl_, size, 0);
    if (!pixels || !renderer_.paint(figure.sheet, figure.insets, place.background, *pixels))
      return std::nullopt;
    return std::move(pixels).value();
  } catch (const std::domain_error&) {  // the present scene cannot be modelled with it
    return std::nullopt;
  }
}

void OverlayPictures::show(Overlay overlay, const Scene& scene, Theme theme, float height, bool may_draw) {
  const Size pixels{static_cast<int>(std::lround(kAspect * static_cast<double>(height))),
                    static_cast<int>(std::lround(height))};
  const ImVec2 size{static_cast<float>(pixels.width), static_cast<float>(pixels.height)};
  const ImVec2 at = ImGui::GetCursorScreenPos(), low{std::round(at.x), std::round(at.y)},
               high{low.x + size.x, low.y + size.y};
  ImGui::Dummy(size);
  if (takes_long(overlay)) return;
  Scene now = without_rest(scene);
  now.camera = {};  // a hand that turns the figure leaves them as they are
  now.show = {};
  if (scene_ != now || theme_ != theme || size_ != pixels) {
    pictures_.clear();
    scene_ = std::move(now);
    theme_ = theme;
    size_ = pixels;
  }
  auto found = pictures_.find(overlay);
  const bool is_seen = ImGui::IsRectVisible(low, high);
  if (found == pictures_.end() && is_seen) {
    is_waiting_ = is_waiting_ || has_drawn_;
    if (has_drawn_ || !may_draw) return;
    has_drawn_ = true;
    ++count_;
    found = pictures_.emplace(overlay, drawn(overlay, scene, theme, pixels)).first;
    is_waiting_ = true;  // to be shown, and others
  }
  if (found == pictures_.end() || !found->second) return;
  // The bottom row of a framebuffer is its first.
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddImage(control_texture(found->second->texture()), low, high, {0, 1}, {1, 0});
  list.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Separator));
}

}  // namespace polhode
