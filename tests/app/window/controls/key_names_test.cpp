// SPDX-License-Identifier: MIT
#include "app/window/controls/key_names.h"

#include "app/session/command.h"

#include <gtest/gtest.h>

#include <set>

// GLFW's codes, which are its interface (glfw3.h); tests do not see its header.
constexpr int kTab = 258, kRight = 262, kF1 = 290, kF11 = 300, kS = 83, kShift = 1, kControl = 2;

namespace polhode {
namespace {

TEST(KeyNames, AreThoseOfCommands) {
  EXPECT_EQ(key_name(kRight, 0), "Right");
  EXPECT_EQ(key_name(kTab, kShift), "Shift+Tab");
  EXPECT_EQ(key_name(kS, kControl, "s"), "Ctrl+S");
  EXPECT_EQ(key_name(kS, kControl, "o"), "Ctrl+O");  // where the layout has another letter there
  EXPECT_EQ(key_name(kF1, 0), "F1");
  EXPECT_EQ(key_name(kF11, 0), "F11");
}

TEST(KeyNames, CharactersComeAsTheKeyboardHasThem) {
  EXPECT_EQ(key_name(kS, 0), "");
  EXPECT_EQ(character_name('s'), "S");
  EXPECT_EQ(character_name('S'), "S");
  EXPECT_EQ(character_name('+'), "+");
  EXPECT_EQ(character_name('?'), "?");
  EXPECT_EQ(character_name(' '), "");  // comes as a key
  EXPECT_EQ(character_name(0x3C9), "");
}

/// Every command can be given from a keyboard: its keys are among those that the window makes.
TEST(KeyNames, EveryCommandHasAKeyThatTheWindowMakes) {
  std::set<std::string> made;
  for (int key = 32; key < 349; ++key)
    for (const int modifiers : {0, kShift, kControl, kShift | kControl}) {
      const std::string letter(1, static_cast<char>(key));  // of a US keyboard
      made.insert(key_name(key, modifiers, key >= 'A' && key <= 'Z' ? letter : ""));
    }
  for (unsigned character = 0; character < 128; ++character) made.insert(character_name(character));
  std::set<Command> given;
  for (const std::string& name : made)
    if (const auto command = command_of(name)) given.insert(*command);
  for (const CommandFacts& facts : all_commands()) EXPECT_TRUE(given.contains(facts.command)) << facts.does;
}

}  // namespace
}  // namespace polhode
