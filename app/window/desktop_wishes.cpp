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

void take(const std::string& key, const std::string& value, DesktopWishes& wishes) {
  const bool is_dark = value == "1" || value == "prefer-dark";
  if (key == "color-scheme" && is_dark) wishes.theme = Theme::dark;
  if (key == "color-scheme" && (value == "2" || value == "prefer-light") && !wishes.theme)
    wishes.theme = Theme::paper;
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
  DesktopWishes wishes;
  std::istringstream lines{std::string(answer)};
  std::string line, key;
  while (std::getline(lines, line)) {
    const std::size_t variant = line.find("variant");
    if (variant != line.npos && !key.empty()) take(key, value_in(line, variant), wishes);
    key = variant == line.npos ? first_quoted(line) : "";
  }
  return wishes;
}

bool follow(const DesktopWishes& wishes, Preferences& preferences) {
  const Preferences before = preferences;
  if (!preferences.own_theme) preferences.theme = wishes.theme.value_or(Theme::paper);
  if (!preferences.own_motion) preferences.reduced_motion = wishes.reduced_motion.value_or(false);
  return preferences != before;
}

}  // namespace polhode
