// SPDX-License-Identifier: MIT
#include "app/window/desktop_wishes.h"

#include <sstream>

namespace polhode {

namespace {

/// Between the first quotes; empty: there are none.
std::string first_quoted(const std::string& line) {
  const std::size_t begin = line.find('"'), end = line.find('"', begin + 1);
  return begin == line.npos || end == line.npos ? "" : line.substr(begin + 1, end - begin - 1);
}

/// "uint32 1", "boolean false", "string \"prefer-dark\"", behind the word "variant".
std::string value_in(const std::string& line, std::size_t variant) {
  std::istringstream words(line.substr(variant));
  std::string type = "variant", value;
  while (type == "variant" && words >> type) {
  }
  if (type == "string") return first_quoted(line);
  words >> value;
  return value;
}

/// A setting: of the portal's own, which every desktop answers for, or of a desktop's older ones.
struct Taken {
  DesktopWishes of_portal, of_desktop;
};

void take(const std::string& group, const std::string& key, const std::string& value, Taken& taken) {
  DesktopWishes& wishes = group == "org.freedesktop.appearance" ? taken.of_portal : taken.of_desktop;
  if (key == "color-scheme" && (value == "1" || value == "prefer-dark")) wishes.theme = Theme::dark;
  if (key == "color-scheme" && (value == "2" || value == "prefer-light")) wishes.theme = Theme::paper;
  const bool stands = (key == "reduced-motion" && value == "1") ||
                      (key == "enable-animations" && value == "false") ||
                      (key == "AnimationDurationFactor" && value == "0");
  const bool moves = (key == "reduced-motion" && value == "0") ||
                     (key == "enable-animations" && value == "true") ||
                     (key == "AnimationDurationFactor" && value != "0");
  if (stands || moves) wishes.reduced_motion = stands || wishes.reduced_motion.value_or(false);
}

}  // namespace

std::vector<std::string> question_to_desktop() {
  return {"dbus-send",
          "--session",
          "--print-reply",
          "--reply-timeout=3000",
          "--dest=org.freedesktop.portal.Desktop",
          "/org/freedesktop/portal/desktop",
          "org.freedesktop.portal.Settings.ReadAll",
          "array:string:org.freedesktop.appearance,org.gnome.desktop.interface,org.kde.kdeglobals.KDE"};
}

DesktopWishes wishes_in(std::string_view answer) {
  Taken taken;
  std::istringstream lines{std::string(answer)};
  std::string line, group, key;
  while (std::getline(lines, line)) {
    const std::size_t variant = line.find("variant");
    if (variant != line.npos && !key.empty()) take(group, key, value_in(line, variant), taken);
    key = variant == line.npos ? first_quoted(line) : "";
    if (key.starts_with("org.")) group = key;
  }
  const DesktopWishes &portal = taken.of_portal, &desktop = taken.of_desktop;
  return {portal.theme ? portal.theme : desktop.theme,
          portal.reduced_motion ? portal.reduced_motion : desktop.reduced_motion};
}

bool follow(const DesktopWishes& wishes, Preferences& preferences) {
  const Preferences before = preferences;
  if (!preferences.own_theme) preferences.theme = wishes.theme.value_or(Theme::paper);
  if (!preferences.own_motion) preferences.reduced_motion = wishes.reduced_motion.value_or(false);
  return preferences != before;
}

}  // namespace polhode
