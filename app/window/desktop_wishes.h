// SPDX-License-Identifier: MIT
// What a person has told the desktop once for all programs: dark, and nothing that moves by itself.
#pragma once

#include "app/session/lesson_session.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// Absent: it has none, or is not known.
struct DesktopWishes {
  std::optional<Theme> theme{};
  std::optional<bool> reduced_motion{};
  bool operator==(const DesktopWishes&) const = default;
};

/// The program that asks the desktop's portal (org.freedesktop.portal.Settings, which GNOME, KDE, Xfce and
/// others answer), and its arguments: https://flatpak.github.io/xdg-desktop-portal/docs/
std::vector<std::string> question_to_desktop();
/// Read from what it prints: color-scheme and reduced-motion, GNOME's enable-animations, KDE's
/// AnimationDurationFactor. What the portal itself says goes before what a desktop's older settings say.
DesktopWishes wishes_in(std::string_view answer);

/// Of what the person has not chosen himself. False: nothing is other than before.
bool follow(const DesktopWishes& wishes, Preferences& preferences);

}  // namespace polhode
