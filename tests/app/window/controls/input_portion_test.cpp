// SPDX-License-Identifier: MIT
#include "app/window/controls/input_portion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace polhode {
namespace {

using testing::ElementsAre;

// The numbers of GLFW 3.
constexpr int kRelease = 0, kPress = 1, kRepeat = 2, kSpace = 32, kLetterA = 65, kEnter = 257, kShift = 340;
constexpr int kWithCtrl = 2;

/// p: pointer, w: wheel, b B: button pressed, let go, c C: another one, e E: Enter, a A: the key of a letter,
/// l L: with Ctrl, _ -: the space bar, s S: Shift, r: Enter repeats, x: a character.
InputEvent event_of(char sign) {
  using Kind = InputEvent::Kind;
  switch (sign) {
    case 'p':
      return {Kind::pointer};
    case 'w':
      return {Kind::wheel};
    case 'b':
    case 'B':
      return {Kind::button, 0, 0, sign == 'b' ? kPress : kRelease};
    case 'c':
    case 'C':
      return {Kind::button, 1, 0, sign == 'c' ? kPress : kRelease};
    case 'e':
    case 'E':
      return {Kind::key, kEnter, 0, sign == 'e' ? kPress : kRelease};
    case 's':
    case 'S':
      return {Kind::key, kShift, 0, sign == 's' ? kPress : kRelease};
    case 'r':
      return {Kind::key, kEnter, 0, kRepeat};
    case 'a':
    case 'A':
      return {Kind::key, kLetterA, 0, sign == 'a' ? kPress : kRelease};
    case 'l':
    case 'L':
      return {Kind::key, kLetterA, 0, sign == 'l' ? kPress : kRelease, kWithCtrl};
    case '_':
    case '-':
      return {Kind::key, kSpace, 0, sign == '_' ? kPress : kRelease};
    default:
      return {Kind::character, 'x'};
  }
}

/// The frames that a queue of events is given to.
std::vector<std::string> frames_of(const std::string& events) {
  std::vector<std::string> frames(1);
  InputPortion portion;
  for (const char sign : events) {
    if (!portion.takes(event_of(sign))) {
      portion = {};
      frames.emplace_back();
    }
    portion.add(event_of(sign));
    frames.back() += sign;
  }
  return frames;
}

TEST(InputPortion, AClickIsSeenWhereItWasMade) {
  EXPECT_THAT(frames_of("pbBp"), ElementsAre("pb", "B", "p"));
}

TEST(InputPortion, WhatIsDraggedIsSeenWhereItIsLetGo) {
  EXPECT_THAT(frames_of("pppbppBp"), ElementsAre("pppb", "pp", "B", "p"));
}

TEST(InputPortion, WhatIsTurnedAndPressedTogetherIsSeenTogether) {
  EXPECT_THAT(frames_of("pwwbcCB"), ElementsAre("pwwbc", "CB"));
  EXPECT_THAT(frames_of("bw"), ElementsAre("b", "w"));
}

TEST(InputPortion, AKeyIsSeenBeforeItIsLetGo) {
  EXPECT_THAT(frames_of("eEeE"), ElementsAre("e", "E", "e", "E"));
}

TEST(InputPortion, AKeyIsSeenWithItsShift) {
  EXPECT_THAT(frames_of("seSE"), ElementsAre("se", "SE"));
  EXPECT_THAT(frames_of("esESe"), ElementsAre("e", "sE", "Se"));
}

// A machine that draws ten frames a second would type ten letters a second.
TEST(InputPortion, LettersThatAreTypedShareAFrame) {
  EXPECT_THAT(frames_of("axAaxAsaxSA"), ElementsAre("axAaxAsaxSA"));
  EXPECT_THAT(frames_of("lLlL"), ElementsAre("l", "L", "l", "L")) << "Ctrl+A is a command of the field";
  EXPECT_THAT(frames_of("ax_x-axA"), ElementsAre("ax_x", "-axA")) << "it presses buttons, too";
}

TEST(InputPortion, ARepeatedKeyMakesNoQueue) { EXPECT_THAT(frames_of("errrr"), ElementsAre("errrr")); }

// Dear ImGui takes a frame's characters before its keys.
TEST(InputPortion, CharactersAfterEnterWaitAndBeforeItDoNot) {
  EXPECT_THAT(frames_of("axAe"), ElementsAre("axAe"));
  EXPECT_THAT(frames_of("xe"), ElementsAre("xe"));
  EXPECT_THAT(frames_of("ex"), ElementsAre("e", "x"));
  EXPECT_THAT(frames_of("eEx"), ElementsAre("e", "Ex"));
}

}  // namespace
}  // namespace polhode
