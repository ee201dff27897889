// SPDX-License-Identifier: MIT
#include "physics/method.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace polhode {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

const PrincipalMoments kAsymmetric(1, 2, 2.5);
const RigidBodyState kTumbling{Quat::Identity(), Vec3(1, 0.2, 1)};

TEST(Methods, NamesMapBothWays) {
  for (const MethodFacts& facts : all_methods()) {
    EXPECT_EQ(&facts_of(facts.method), &facts);
    EXPECT_EQ(method_from(facts.name), facts.method);
    EXPECT_THAT(method_names(), Contains(std::string(facts.name)));
  }
  EXPECT_FALSE(method_from("runge-kutta"));
}

/// Step or tolerance as the method needs it.
MethodChoice choice_of(const MethodFacts& facts) {
  MethodChoice choice{.method = facts.method};
  if (facts.control == StepControl::fixed) choice.step_s = 0.01;
  return choice;
}

TEST(Methods, EveryOneThatServesMakesAMotionThatStartsAtTheStart) {
  const Problem free{kAsymmetric, kTumbling, {}};
  const Problem heavy{kAsymmetric, kTumbling, {HeavyTop{0.5, Vec3::UnitZ()}}};
  const Problem damped{kAsymmetric, kTumbling, {LinearDamping{0.1}}};
  for (const Problem& problem : {free, heavy, damped})
    for (const MethodFacts& facts : all_methods()) {
      if (why_not(facts.method, problem)) {
        EXPECT_THROW(make_motion(problem, choice_of(facts)), std::domain_error) << facts.name;
        continue;
      }
      const auto motion = make_motion(problem, choice_of(facts));
      // The closed form rounds at the start too, by a few ε.
      EXPECT_LE((motion->at(0).w_B - kTumbling.w_B).norm(), 4 * 0x1p-52 * kTumbling.w_B.norm()) << facts.name;
      EXPECT_TRUE(motion->at(0.1).w_B.allFinite()) << facts.name;
      EXPECT_EQ(motion->method(), facts.name);
    }
}

TEST(Methods, AClosedFormIsTheDefaultWhereThereIsOne) {
  const PrincipalMoments symmetric(1, 1, 0.5);
  const Torque weight{HeavyTop{0.5, Vec3::UnitZ()}};
  EXPECT_EQ(closed_form({kAsymmetric, kTumbling, {}}), Method::exact);
  EXPECT_EQ(closed_form({symmetric, kTumbling, weight}), Method::lagrange_top);
  EXPECT_EQ(default_method({symmetric, kTumbling, weight}), Method::lagrange_top);
  EXPECT_FALSE(closed_form({kAsymmetric, kTumbling, weight}));
  EXPECT_EQ(default_method({kAsymmetric, kTumbling, weight}), Method::dormand_prince_8);
  EXPECT_EQ(default_method({symmetric, kTumbling, {weight[0], LinearDamping{0.1}}}),
            Method::dormand_prince_8);
  EXPECT_EQ(why_not(Method::lagrange_top, {kAsymmetric, kTumbling, weight}),
            "the two moments across the axis of the weight are not equal");
  EXPECT_EQ(why_not(Method::lagrange_top, {symmetric, kTumbling, {}}), "no weight acts");
  const auto motion = make_motion({symmetric, kTumbling, weight}, {Method::lagrange_top});
  EXPECT_EQ(motion->method(), "lagrange-top");
  EXPECT_TRUE(motion->at(-1e6).w_B.allFinite());
}

TEST(Methods, ARefusalNamesThoseThatServe) {
  const Problem damped{kAsymmetric, kTumbling, {LinearDamping{0.1}}};
  EXPECT_THAT(serving_methods(damped), Not(Contains("splitting")));
  try {
    make_motion(damped, {Method::exact, {}, {}});
    FAIL() << "a closed form under a torque";
  } catch (const std::domain_error& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("what can: explicit-euler, explicit-midpoint, rk4, dormand-prince-5"));
  }
}

TEST(Methods, RefuseStepsTolerancesAndLimitsThatCannotBe) {
  const Problem free{kAsymmetric, kTumbling, {}};
  const double inf = std::numeric_limits<double>::infinity();
  for (const MethodChoice& choice :
       std::initializer_list<MethodChoice>{{Method::rk4, {}, {}},
                                           {Method::rk4, 0.0, {}},
                                           {Method::rk4, -1.0, {}},
                                           {Method::rk4, NAN, {}},
                                           {Method::rk4, inf, {}},
                                           {Method::rk4, 0.1, 1e-6},
                                           {Method::exact, 0.1, {}},
                                           {Method::exact, {}, 1e-6},
                                           {Method::dormand_prince_8, 0.1, {}},
                                           {Method::dormand_prince_8, {}, 0.0},
                                           {Method::dormand_prince_8, {}, NAN},
                                           {Method::dormand_prince_8, {}, {}, 0},
                                           {Method::dormand_prince_8, {}, {}, -1},
                                           {Method::exact, {}, {}, 0}})
    EXPECT_THROW(make_motion(free, choice), std::domain_error) << name_of(choice.method);
}

}  // namespace
}  // namespace polhode
