// SPDX-License-Identifier: MIT
#include "render/scene/description/scene.h"

#include <algorithm>

namespace polhode {

std::vector<const Scene*> shown_scenes(const Scene& scene) {
  std::vector<const Scene*> shown;
  for (const Scene& other : scene.beside) shown.push_back(&other);
  shown.insert(shown.begin() + static_cast<std::ptrdiff_t>(scene.before), &scene);
  return shown;
}

bool same_course(Scene a, const Scene& b) {
  a.views = b.views;
  a.show = b.show;
  a.marks = b.marks;
  a.poses = b.poses;
  a.camera = b.camera;
  a.highlight = b.highlight;
  a.quality = b.quality;
  a.caption = b.caption;
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

std::optional<QualityLevel> quality_level_from(std::string_view name) {
  for (const QualityLevel level : {QualityLevel::draft, QualityLevel::normal, QualityLevel::fine})
    if (name == name_of(level)) return level;
  return std::nullopt;
}

const char* name_of(QualityLevel level) {
  switch (level) {
    case QualityLevel::draft:
      return "draft";
    case QualityLevel::normal:
      return "normal";
    case QualityLevel::fine:
      break;
  }
  return "fine";
}

}  // namespace polhode
