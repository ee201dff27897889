// SPDX-License-Identifier: MIT
#include "physics/body/torque_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace polhode {
namespace {

using ::testing::HasSubstr;

template <class Term>
const Term* term(const Result<TorqueTerm>& parsed) {
  return parsed ? std::get_if<Term>(&*parsed) : nullptr;
}

TEST(ParseTorque, ReadsEveryKind) {
  const auto space = parse_torque_term("space:1,2,-3");
  ASSERT_NE(term<SpaceTorque>(space), nullptr);
  EXPECT_EQ(term<SpaceTorque>(space)->N_S, Vec3(1, 2, -3));
  const auto body = parse_torque_term("body:0,0x1p-1,0");
  ASSERT_NE(term<BodyTorque>(body), nullptr);
  EXPECT_EQ(term<BodyTorque>(body)->N_B, Vec3(0, 0.5, 0));
  const auto heavy = parse_torque_term("heavy:0.5,0,0,2");
  ASSERT_NE(term<HeavyTop>(heavy), nullptr);
  EXPECT_EQ(term<HeavyTop>(heavy)->axis_B, Vec3(0, 0, 1));
  const auto damping = parse_torque_term("damping:0.1");
  ASSERT_NE(term<LinearDamping>(damping), nullptr);
  EXPECT_EQ(term<LinearDamping>(damping)->c, 0.1);
  const auto sink = parse_torque_term("sink:0.2");
  EXPECT_NE(term<EnergySink>(sink), nullptr);
}

TEST(ParseTorque, TakesAnAxisOfAnyLength) {
  for (const char* text : {"heavy:1,0,0.6e-150,0.8e-150", "heavy:1,0,3e-320,4e-320", "heavy:1,0,3e307,4e307",
                           "heavy:1,0,6e307,8e307"}) {
    const auto parsed = parse_torque_term(text);
    ASSERT_NE(term<HeavyTop>(parsed), nullptr) << text;
    // Below the normal numbers the components have but 13 bits: 3e-320 is 6072 times the smallest number.
    EXPECT_LT((term<HeavyTop>(parsed)->axis_B - Vec3(0, 0.6, 0.8)).norm(), 0x1p-12) << text;
    EXPECT_NEAR(term<HeavyTop>(parsed)->axis_B.norm(), 1, 4 * std::numeric_limits<double>::epsilon());
  }
  EXPECT_THAT(parse_torque_term("heavy:1,0,-0,0").error(), HasSubstr("must not be zero"));
}

TEST(ParseTorque, SaysWhatIsWrong) {
  for (const char* text : {"", "space", "space:", "space:1,2", "space:1,2,3,4", "spade:1,2,3",
                           "heavy:1,0,0,0", "damping:x", "body:nan,0,0", "body:inf,0,0"}) {
    const auto parsed = parse_torque_term(text);
    ASSERT_FALSE(parsed) << text;
    EXPECT_FALSE(parsed.error().empty());
  }
}

}  // namespace
}  // namespace polhode
