// SPDX-License-Identifier: MIT
#include "physics/integrators/moser_veselov.h"

#include "physics/body/euler.h"
#include "physics/integrators/moser_veselov_modification.h"
#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace polhode {
namespace {

using test::kEps;
using test::Random;

struct PublishedSeries {
  Vec3 I, w_B;
  double h;
  int order;
  double s;
  Vec3 sigma;
};

// The published sums at 80 digits, where their cancellation does no harm: ordinary bodies in several axis
// orders, a sphere, a symmetric body, a disc, and needles of 1e-9 and 1e-6. Every input is a double.
const PublishedSeries kPublished[] = {
    {{1.0, 2.0, 3.0},
     {0.1, 1.5, 0.2},
     0.25,
     6,
     0.96096905852141203698,
     {0.96860947374131944439, 0.9762498889612268518, 0.98389030418113425921}},
    {{1.0, 2.0, 3.0},
     {0.1, 1.5, 0.2},
     0.25,
     10,
     0.96096453266025095518,
     {0.96860691264375324524, 0.97624929262725553529, 0.98389167261075782535}},
    {{2.5, 1.0, 1.75},
     {-1, 0.5, 0.75},
     0.5,
     6,
     0.90257726523989722842,
     {0.93747345694717095823, 0.91653574192280672034, 0.92700459943498883929}},
    {{2.5, 1.0, 1.75},
     {-1, 0.5, 0.75},
     0.5,
     10,
     0.90250042819026549294,
     {0.93747271404879920494, 0.91648934253367897774, 0.92698102829123909134}},
    {{1.0, 1.0, 1.0},
     {1, 2, 3},
     0.125,
     6,
     0.94630940755208333333,
     {0.9639404296875, 0.9639404296875, 0.9639404296875}},
    {{1.0, 1.0, 1.0},
     {1, 2, 3},
     0.125,
     10,
     0.94630216682950655619,
     {0.96393835910676438131, 0.96393835910676438131, 0.96393835910676438131}},
    {{1.0, 2.0, 1.0},
     {0.5, 1, 2},
     0.25,
     6,
     0.92537129720052083333,
     {0.94634806315104166667, 0.9673248291015625, 0.94634806315104166667}},
    {{1.0, 2.0, 1.0},
     {0.5, 1, 2},
     0.25,
     10,
     0.92533963089209293037,
     {0.94633803077426458162, 0.96733643065643623287, 0.94633803077426458162}},
    {{1.0, 1.5, 2.5},
     {1, -1, 0.5},
     0.25,
     6,
     0.96655867513020833333,
     {0.974709716796875, 0.97878523763020833333, 0.986936279296875}},
    {{1.0, 1.5, 2.5},
     {1, -1, 0.5},
     0.25,
     10,
     0.96655626279016046717,
     {0.97470862485171652135, 0.97878480588249454843, 0.9869371679440506026}},
    {{9.3132257461547851563e-10, 1.0, 0.99999999976716935635},
     {0.5, 1, 0.25},
     0.25,
     6,
     0.98213210900302359748,
     {0.98213210900939098558, 0.98896903991376560739, 0.98896903991217376036}},
    {{9.3132257461547851563e-10, 1.0, 0.99999999976716935635},
     {0.5, 1, 0.25},
     0.25,
     10,
     0.98213173735966218954,
     {0.9821317373660298697, 0.98896898186465191341, 0.98896898186305999337}},
    {{1.0, 9.5367431640625e-7, 1.0000004768371582031},
     {0.25, 2, 1},
     0.125,
     6,
     0.98611900586576606425,
     {0.99723535195497514206, 0.98611901646713982181, 0.99723535725566202084}},
    {{1.0, 9.5367431640625e-7, 1.0000004768371582031},
     {0.25, 2, 1},
     0.125,
     10,
     0.98611877828667598483,
     {0.99723535104697378336, 0.98611878888826591279, 0.99723535634776874734}},
};

TEST(MoserVeselovModification, IsThePublishedSeriesWithoutItsCancellation) {
  for (const PublishedSeries& p : kPublished) {
    const MoserVeselovModification modification(PrincipalMoments(p.I[0], p.I[1], p.I[2]), p.order);
    const auto [s, sigma] = modification(p.h, triple(p.w_B));
    EXPECT_NEAR(s, p.s, 16 * kEps) << p.I.transpose() << " order " << p.order;
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(vec3(sigma)[i], p.sigma[i], 16 * kEps) << p.I.transpose() << " order " << p.order;
  }
}

TEST(MoserVeselovModification, OfOrder2IsNone) {
  const auto [s, sigma] = MoserVeselovModification(PrincipalMoments(1, 2, 3), 2)(0.25, {1, 2, 3});
  EXPECT_EQ(s, 1);
  EXPECT_EQ(vec3(sigma), Vec3::Ones());
}

// T and L² are kept by the map, so the series are the same all along the motion; and they depend on h².
TEST(MoserVeselovModification, IsTheSameAtEveryPointOfAMotionAndForBothSignsOfTheStep) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const PrincipalMoments I = random.moments();
    const RigidBodyState start = random.state();
    const double h = 0.2 / start.w_B.norm();
    const auto motion = moser_veselov_motion(10, {I, start, {}}, h);
    const MoserVeselovModification modification(I, 10);
    const auto here = modification(h, triple(start.w_B));
    const auto there = modification(-h, triple(motion->at(77 * h).w_B));
    EXPECT_NEAR(here.s, there.s, 77 * 4 * kEps);
    EXPECT_LE((vec3(here.sigma) - vec3(there.sigma)).norm(), 77 * 4 * kEps);
  }
}

// 1e5 steps: T and |L| walk at random, by the rounding of the increments alone.
TEST(MoserVeselov, KeepsEnergyAndMomentumOverManySteps) {
  const PrincipalMoments I(1, 2, 3);
  const RigidBodyState start{Quat::Identity(), {0.1, 1.5, 0.2}};
  const double h = 0.1;
  const int steps = 100'000;
  for (const int order : {2, 6, 10}) {
    const auto motion = moser_veselov_motion(order, {I, start, {}}, h);
    for (int k = -steps; k <= steps; k += 5000) {
      const RigidBodyState y = motion->at(k * h);
      const double walk = 2 * std::sqrt(steps) * kEps;
      EXPECT_NEAR(kinetic_energy(I, y.w_B) / kinetic_energy(I, start.w_B), 1, walk) << k;
      EXPECT_NEAR(angular_momentum_B(I, y.w_B).norm() / angular_momentum_B(I, start.w_B).norm(), 1, walk)
          << k;
      // L in space is carried by q, 4ε a step without compensation.
      const double turned = (angular_momentum_S(I, y) - angular_momentum_S(I, start)).norm() /
                            angular_momentum_S(I, start).norm();
      EXPECT_LE(turned, 16 * walk) << k;
    }
  }
}

// I = (1, 2, 3), ω = (0.1, 1.5, 0.2): the state after 1000 periods, from the closed form at 60 digits.
TEST(MoserVeselov, Of80StepsAPeriodIsGoodTo1e8After1000Periods) {
  const RigidBodyState start{Quat::Identity(), {0.1, 1.5, 0.2}};
  const double t = 0x1.9e1032a2f7eb8p+13;
  const RigidBodyState truth{
      Quat(-0.005647308555344351082, 0.032668055080623368199, 0.98004165241315352229, 0.19600833048272633821),
      {0.1000000000011238611, 1.4999999999999250763, 0.20000000000018732036}};
  const auto motion = moser_veselov_motion(10, {PrincipalMoments(1, 2, 3), start, {}}, t / 80e3);
  EXPECT_LE(test::w_error(motion->at(t).w_B, truth.w_B), 1e-8);
  EXPECT_LE(test::q_error(motion->at(t).q_SB, truth.q_SB), 1e-8);
}

// A quarter turn a step is too long for any root: α h ω = 2c has none for c = tan(θ/2) once hω̃ > 1.
TEST(MoserVeselov, WithoutARootIsNotANumber) {
  const PrincipalMoments I(1, 2, 3);
  for (const Vec3& w_B : {Vec3(0, 0, 1), Vec3(0.3, 0.2, 1)}) {
    const auto motion = moser_veselov_motion(2, {I, {Quat::Identity(), w_B}, {}}, 1.5);
    EXPECT_TRUE(std::isnan(motion->at(1.5).w_B[0]));
    EXPECT_TRUE(std::isnan(motion->at(1e8).q_SB.w()));
  }
}

// h² and the determinant of the Jacobian overflow one after the other: that is no root either.
TEST(MoserVeselov, WithoutARootIsNotANumberHoweverLongTheStep) {
  const PrincipalMoments I(1, 2, 3);
  for (int e = 1; e <= 1000; ++e) {
    const double h = std::ldexp(1.5, e);
    const auto motion = moser_veselov_motion(2, {I, {Quat::Identity(), {0, 0, 1}}, {}}, h);
    EXPECT_TRUE(std::isnan(motion->at(h).w_B[0])) << e;
  }
}

TEST(MoserVeselov, RefusesOtherOrdersAndTorqueOfOmega) {
  const PrincipalMoments I(1, 2, 3);
  EXPECT_THROW(moser_veselov_motion(4, {I, {}, {}}, 0.1), std::domain_error);
  EXPECT_THROW(moser_veselov_motion(6, {I, {}, {LinearDamping{0.1}}}, 0.1), std::domain_error);
}

}  // namespace
}  // namespace polhode
