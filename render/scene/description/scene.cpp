// SPDX-License-Identifier: MIT
#include "render/scene/description/scene.h"

namespace polhode {

std::vector<const Scene*> shown_scenes(const Scene& scene) {
  std::vector<const Scene*> shown;
  for (const Scene& other : scene.beside) shown.push_back(&other);
  shown.insert(shown.begin() + static_cast<std::ptrdiff_t>(scene.before), &scene);
  return shown;
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
