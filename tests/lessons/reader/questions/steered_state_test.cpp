// SPDX-License-Identifier: MIT
#include "lessons/reader/questions/steered_state.h"

#include "tests/physics/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::HasSubstr;

UnreadableState fault_of(const std::string& text) {
  const auto state = parse_state(text);
  EXPECT_FALSE(state.ok()) << text;
  return state ? UnreadableState() : state.error();
}

TEST(SteeredState, IsReadAsKeysOfAScene) {
  const auto state = parse_state("omega = [1, 2, 3.5]; t = 0.4; torque = \"body:1,0,-2\"");
  ASSERT_TRUE(state) << state.error().message;
  EXPECT_EQ(state->w0_B, Vec3(1, 2, 3.5));
  EXPECT_EQ(state->t_s, 0.4);
  EXPECT_EQ(state->torque, TorqueTerm(BodyTorque{Vec3(1, 0, -2)}));
  EXPECT_FALSE(state->moments || state->attitude);
  EXPECT_EQ(parse_state("t = 1\nomega = [\n0, 0, 1]")->w0_B, Vec3(0, 0, 1)) << "lines part as ; does";
}

TEST(SteeredState, WrittenReadsBackAsTheSame) {
  test::Random random(5);
  const auto number = [&] { return random.uniform(-10, 10); };
  for (int i = 0; i < 200; ++i) {
    SteeredState state;
    if (i % 2 == 0) state.w0_B = Vec3(number(), number(), number());
    if (i % 3 == 0) state.moments = Vec3(1 + 0.01 * number(), 1.1, 1.2);
    if (i % 5 == 0) state.torque = SpaceTorque{Vec3(number(), number(), number())};
    if (i % 7 == 0) state.attitude = i % 2 == 0 ? LPoints::down : LPoints::up;
    if (i % 2 == 1) state.t_s = number();
    const std::string text = text_of(state);
    const auto read = parse_state(text);
    ASSERT_TRUE(read) << text << ": " << read.error().message;
    EXPECT_EQ(*read, state) << text;
  }
}

TEST(SteeredState, WhatIsNoneIsSaidWithItsPlace) {
  EXPECT_THAT(fault_of("").message, HasSubstr("says nothing"));
  EXPECT_THAT(fault_of("omega = [1, 2]").message, HasSubstr("3"));
  EXPECT_THAT(fault_of("t = 1; omge = [1, 2, 3]").message, HasSubstr("omge"));
  EXPECT_EQ(fault_of("t = 1; omge = [1, 2, 3]").column, 8);
  EXPECT_THAT(fault_of("moments = [1, 1, 3]").message, HasSubstr("I3"));
  EXPECT_THAT(fault_of("torque = \"heavy:1,0,0,1\"").message, HasSubstr("constant"));
  EXPECT_THAT(fault_of("torque = []").message, HasSubstr("missing"));
  EXPECT_THAT(fault_of("attitude = [0, 0, 0, 0]").message, HasSubstr("zero"));
  EXPECT_THAT(fault_of("attitude = \"up\"").message, HasSubstr("L-up"));
  EXPECT_THAT(fault_of("t = \"1\"").message, HasSubstr("number"));
  EXPECT_THAT(fault_of("t = nan").message, HasSubstr("finite"));
  for (const char* broken : {"omega =", "omega = [1, 2, 3", "= 1", ";;;", "t = 1 2", "\xff"})
    EXPECT_FALSE(fault_of(broken).message.empty()) << broken;
  EXPECT_THAT(fault_of(std::string(kMaxStateBytes + 1, ' ')).message, HasSubstr("bytes"));
}

TEST(SteeredState, ChangesTheSceneAndLeavesTheRest) {
  Scene scene;
  scene.torque = {LinearDamping{0.1}, SpaceTorque{Vec3(1, 0, 0)}};
  SteeredState state;
  state.torque = SpaceTorque{Vec3(0, 2, 0)};
  const Scene changed = steered(scene, state);
  EXPECT_EQ(changed.torque, (Torque{LinearDamping{0.1}, SpaceTorque{Vec3(0, 2, 0)}}));
  EXPECT_EQ(changed.w0_B, scene.w0_B);
  EXPECT_EQ(changed.body, scene.body);
  EXPECT_EQ(with_constant({}, BodyTorque{Vec3(1, 2, 3)}), Torque{BodyTorque{Vec3(1, 2, 3)}});
}

}  // namespace
}  // namespace polhode
