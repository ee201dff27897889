// SPDX-License-Identifier: MIT
#include "app/window/desktop_wishes.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

/// As dbus-send prints the answer of a portal.
std::string answer(const std::string& key, const std::string& value, const std::string& more = "") {
  return "method return time=1.5 sender=:1.22 -> destination=:1.310 serial=9 reply_serial=2\n   array [\n"
         "      dict entry(\n         string \"org.freedesktop.appearance\"\n         array [\n"
         "            dict entry(\n               string \"accent-color\"\n"
         "               variant                   struct {\n                     double 0.2\n"
         "                  }\n            )\n            dict entry(\n               string \"" +
         key + "\"\n               variant                   " + value + "\n            )\n" + more +
         "         ]\n      )\n   ]\n";
}

TEST(DesktopWishes, AreReadFromThePortalsAnswer) {
  EXPECT_EQ(wishes_in(answer("color-scheme", "uint32 1")).theme, Theme::dark);
  EXPECT_EQ(wishes_in(answer("color-scheme", "uint32 2")).theme, Theme::paper);
  EXPECT_EQ(wishes_in(answer("color-scheme", "uint32 0")), DesktopWishes{}) << "no preference";
  EXPECT_EQ(wishes_in(answer("color-scheme", "string \"prefer-dark\"")).theme, Theme::dark);
  EXPECT_EQ(wishes_in(answer("color-scheme", "variant                      uint32 1")).theme, Theme::dark);
  EXPECT_EQ(wishes_in(answer("reduced-motion", "uint32 1")).reduced_motion, true);
  EXPECT_EQ(wishes_in(answer("enable-animations", "boolean false")).reduced_motion, true);
  EXPECT_EQ(wishes_in(answer("enable-animations", "boolean true")).reduced_motion, false);
  EXPECT_EQ(wishes_in(answer("AnimationDurationFactor", "string \"0\"")).reduced_motion, true);
  const std::string more = "            string \"enable-animations\"\n            variant   boolean true\n";
  EXPECT_EQ(wishes_in(answer("reduced-motion", "uint32 1", more)).reduced_motion, true)
      << "one that wishes it is enough";
  const std::string old =
      "      string \"org.gnome.desktop.interface\"\n         string \"enable-animations\"\n"
      "         variant   boolean false\n         string \"color-scheme\"\n"
      "         variant   string \"prefer-dark\"\n";
  const std::string portal = answer("reduced-motion", "uint32 0") + answer("color-scheme", "uint32 2");
  for (const std::string& both : {old + portal, portal + old}) {
    EXPECT_EQ(wishes_in(both).reduced_motion, false) << "the portal knows better than GNOME's old settings";
    EXPECT_EQ(wishes_in(both).theme, Theme::paper);
  }
  EXPECT_EQ(wishes_in(old).reduced_motion, true);
  for (const char* none : {"", "Error org.freedesktop.DBus.Error.ServiceUnknown: The name is not known", "\"",
                           "variant", "string \"color-scheme\"\nvariant"})
    EXPECT_EQ(wishes_in(none), DesktopWishes{}) << none;
}

TEST(DesktopWishes, AreFollowedUnlessThePersonHasChosen) {
  Preferences preferences;
  const DesktopWishes wishes{Theme::dark, true};
  EXPECT_TRUE(follow(wishes, preferences));
  EXPECT_EQ(preferences.theme, Theme::dark);
  EXPECT_TRUE(preferences.reduced_motion);
  EXPECT_FALSE(follow(wishes, preferences));
  EXPECT_TRUE(follow({}, preferences)) << "as it is where nothing is wished";
  EXPECT_EQ(preferences, Preferences{});
  preferences.own_theme = preferences.own_motion = true;
  EXPECT_FALSE(follow(wishes, preferences));
  EXPECT_EQ(preferences.theme, Theme::paper);
}

}  // namespace
}  // namespace polhode
