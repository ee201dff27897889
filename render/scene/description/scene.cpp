// SPDX-License-Identifier: MIT
#include "render/scene/description/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polhode {
namespace {

// In the order of the enumerators.
constexpr std::array kQualityNames = {"draft", "normal", "fine"};

}  // namespace

std::vector<const Scene*> shown_scenes(const Scene& scene) {
  std::vector<const Scene*> shown;
  for (const Scene& other : scene.beside) shown.push_back(&other);
  shown.insert(shown.begin() + static_cast<std::ptrdiff_t>(scene.before), &scene);
  return shown;
}

Scene without_picture(Scene scene, double at_s) {
  scene.at_s = at_s;
  scene.still_s.reset();
  scene.show = {};
  scene.marks = {};
  scene.meters.clear();
  scene.highlight.clear();
  leave_out_caption(scene);
  scene.vary.clear();
  scene.motion.ghost = false;
  return scene;
}

bool same_course(Scene a, const Scene& b) {
  a.views = b.views;
  a.show = b.show;
  a.compared = b.compared;
  a.marks = b.marks;
  a.poses = b.poses;
  a.camera = b.camera;
  a.highlight = b.highlight;
  a.quality = b.quality;
  a.caption = b.caption;
  a.caption_when = b.caption_when;
  a.meters = b.meters;
  const bool same_beside =
      std::equal(a.beside.begin(), a.beside.end(), b.beside.begin(), b.beside.end(), same_course);
  a.beside = b.beside;
  return same_beside && a == b;
}

bool same_model(Scene a, const Scene& b) {
  a.camera = b.camera;
  a.quality = b.quality;
  const bool same_beside =
      std::equal(a.beside.begin(), a.beside.end(), b.beside.begin(), b.beside.end(), same_model);
  a.beside = b.beside;
  return same_beside && a == b;
}

bool caption_holds(const Scene& scene, double t_s) {
  const double still_s = still_time_s(scene);
  return scene.caption_when == CaptionWhen::always ||
         std::abs(t_s - still_s) <= 1e-9 * std::max(1.0, std::abs(still_s));
}

void leave_out_caption(Scene& scene) {
  scene.caption.clear();
  scene.caption_when = CaptionWhen::always;
}

const char* name_of(QualityLevel level) { return kQualityNames[static_cast<std::size_t>(level)]; }

std::vector<std::string> quality_level_names() { return {kQualityNames.begin(), kQualityNames.end()}; }

std::optional<QualityLevel> quality_level_from(std::string_view name) {
  const auto found = std::find(kQualityNames.begin(), kQualityNames.end(), name);
  if (found == kQualityNames.end()) return std::nullopt;
  return static_cast<QualityLevel>(found - kQualityNames.begin());
}

}  // namespace polhode
