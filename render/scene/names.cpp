// SPDX-License-Identifier: MIT
#include "render/scene/scene.h"

#include <algorithm>
#include <array>

namespace polhode {
namespace {

constexpr std::array<std::string_view, 4> kMethodNames = {"exact", "uniform", "symmetric", "rk4"};

}  // namespace

std::string_view name_of(Method method) { return kMethodNames[static_cast<std::size_t>(method)]; }

std::optional<Method> method_from(std::string_view name) {
  const auto found = std::find(kMethodNames.begin(), kMethodNames.end(), name);
  if (found == kMethodNames.end()) return std::nullopt;
  return static_cast<Method>(found - kMethodNames.begin());
}

const std::vector<std::string>& method_names() {
  static const std::vector<std::string> names(kMethodNames.begin(), kMethodNames.end());
  return names;
}

}  // namespace polhode
