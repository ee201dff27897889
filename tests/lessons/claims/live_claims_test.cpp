// SPDX-License-Identifier: MIT
#include "lessons/claims/live_claims.h"

#include "lessons/reader/claim_lines.h"
#include "physics/body/bodies.h"
#include "physics/body/torque_text.h"
#include "tests/lessons/support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polhode {
namespace {

Claim claim_of(const std::string& text, ClaimKind kind) {
  testing::TextReport at(text);
  Claim claim;
  claim.kind = kind;
  claim.lines = read_claim_lines(at.source, 1, at.source.line_count(), kind, at.report);
  EXPECT_FALSE(claim.lines.empty()) << text;
  return claim;
}

Scene tumbling(const std::string& torque = {}) {
  Scene scene;
  scene.w0_B = Vec3(0.9, 0.4, 1.0);
  if (!torque.empty()) scene.torque.push_back(parse_torque_term(torque).value());
  return scene;
}

Scene with_method(Method method, std::optional<double> step_s, const std::string& torque = {}) {
  Scene scene = tumbling(torque);
  scene.motion.method = method;
  scene.motion.step_s = step_s;
  return scene;
}

LiveValue value_of(const std::string& text, const Scene& scene, double t_s, View view = View::space) {
  const SceneModel model = make_model(scene);
  const auto live = live_state(model, t_s);
  EXPECT_TRUE(live);
  const auto value = live_value(claim_of(text, ClaimKind::law), *live, view);
  EXPECT_TRUE(value) << text;
  return value.value_or(LiveValue());
}

constexpr const char* kLaws[] = {"ddt(L) = N",
                                 "inertia(star(omega)) + cross(omega, inertia(omega)) = N",
                                 "ddt(T) = dot(N, omega)",
                                 "ddt(e2) = cross(omega, e2)",
                                 "ddt(A) = star(A) + cross(omega, A)",
                                 "dot(e1, e1) = 1",
                                 "ddt(p) = F"};

TEST(LiveClaims, LawsHoldOnTheExactMotionToRounding) {
  for (const char* law : kLaws)
    for (const double t_s : {0.0, 1.7, -4.0, 300.0}) {
      const LiveValue value = value_of(law, tumbling(), t_s);
      EXPECT_LE(value.residual, value.tolerance) << law << " at " << t_s;
      // 64 ε/0.01 of the differences, more with the phase at 300 s
      EXPECT_LT(value.tolerance, 64 * 2.3e-16 / 0.01 * (1 + 1.5 * std::abs(t_s)));
    }
}

TEST(LiveClaims, LawsHoldOnComputedMotionsAsFarAsMethodAndStepAllow) {
  for (const MethodFacts& facts : all_methods()) {
    if (facts.control != StepControl::fixed) continue;
    for (const double step_s : {0.05, 0.02})
      for (const char* law : kLaws) {
        const LiveValue value = value_of(law, with_method(facts.method, step_s), 1.73);
        EXPECT_LE(value.residual, value.tolerance) << law << ' ' << facts.name << ' ' << step_s;
      }
  }
}

TEST(LiveClaims, UnderTorqueToo) {
  for (const char* torque : {"space:1.1,0,0", "body:0.2,1,0", "damping:0.3", "heavy:0.7,0,0,1"})
    for (const Method method : {Method::dormand_prince_8, Method::dormand_prince_5, Method::rk4}) {
      const auto step = method == Method::rk4 ? std::optional(0.01) : std::nullopt;
      for (const char* law : kLaws) {
        const LiveValue value = value_of(law, with_method(method, step, torque), 1.3);
        EXPECT_LE(value.residual, value.tolerance) << law << ' ' << torque << ' ' << name_of(method);
      }
    }
}

constexpr const char* kSecondLaws[] = {
    "ddt(ddt(L)) = ddt(N)", "I1*ddt(dw1) = (I2 - I3)*(dw2*w3 + w2*dw3) + ddt(N1)",
    "ddt(ddt(e2)) = cross(ddt(omega), e2) + cross(omega, cross(omega, e2))",
    "ddt(ddt(dot(ez, e3))) = dot(ez, cross(ddt(omega), e3) + cross(omega, cross(omega, e3)))",
    ("ddt(ddt(A)) = star(star(A)) + 2*cross(omega, star(A)) + cross(star(omega), A) + cross(omega, "
     "cross(omega, A))")};

TEST(LiveClaims, SecondRatesAreThoseOfTheMotion) {
  for (const char* law : kSecondLaws) {
    for (const double t_s : {0.0, 1.7, -4.0}) {
      const LiveValue value = value_of(law, tumbling(), t_s);
      EXPECT_LE(value.residual, value.tolerance) << law << " at " << t_s;
      EXPECT_LT(value.tolerance, 64 * 2.3e-16 / 1e-4 * (1 + 1.5 * std::abs(t_s)));
    }
    for (const MethodFacts& facts : all_methods()) {
      if (facts.control != StepControl::fixed) continue;
      for (const double step_s : {0.05, 0.02})
        for (const double t_s : {1.73, 1.75, 1.751}) {  // within a step, and across its end
          const LiveValue value = value_of(law, with_method(facts.method, step_s), t_s);
          EXPECT_LE(value.residual, value.tolerance)
              << law << ' ' << facts.name << ' ' << step_s << ' ' << t_s;
        }
    }
    for (const char* torque : {"space:1.1,0,0", "body:0.2,1,0", "damping:0.3", "heavy:0.7,0,0,1"})
      for (const Method method : {Method::dormand_prince_8, Method::dormand_prince_5, Method::rk4}) {
        const auto step = method == Method::rk4 ? std::optional(0.01) : std::nullopt;
        const LiveValue value = value_of(law, with_method(method, step, torque), 1.3);
        EXPECT_LE(value.residual, value.tolerance) << law << ' ' << torque << ' ' << name_of(method);
        EXPECT_LT(value.tolerance, 0.01) << "it decides";
      }
  }
  for (const char* wrong : {"ddt(ddt(L)) = star(star(L))", "ddt(dw1) = dw1", "ddt(ddt(A)) = star(star(A))"})
    EXPECT_GT(value_of(wrong, tumbling(), 1.7).residual, 1e-3) << wrong;
}

// A crude method shows: the law is compared with what was computed, not with itself.
TEST(LiveClaims, ACrudeStepIsSeen) {
  const LiveValue crude = value_of(kLaws[1], with_method(Method::explicit_euler, 0.2), 1.73);
  const LiveValue fine = value_of(kLaws[1], with_method(Method::explicit_euler, 0.02), 1.73);
  EXPECT_GT(crude.residual, 3e-3);
  EXPECT_LT(fine.residual, crude.residual / 4) << "first order: ten times less, within a factor of the phase";
}

TEST(LiveClaims, WhatIsFalseIsFarApart) {
  for (const char* wrong : {"star(L) = 0", "cross(omega, L) = 0", "ddt(A) = star(A) - cross(omega, A)",
                            "dot(e1, apply(J, e2)) = 0"}) {
    const LiveValue value = value_of(wrong, tumbling(), 1.7);
    EXPECT_GT(value.residual, 1e-3) << wrong;
  }
}

// Seen from axes that are turned one way, a body is turned the other way.
TEST(LiveClaims, JIsTheTensorOnAxesThatAreTurned) {
  const Scene scene = tumbling();
  const Vec3 I = scene.body.moments.vector();
  const Eigen::AngleAxisd turn(kTurnOfAxes, Vec3(1, 1, 1).normalized());
  const Vec3 x = turn * Vec3::UnitX(), y = turn * Vec3::UnitY();
  const LiveValue value = value_of("dot(e1, apply(J, e2)) = 0", scene, 1.7);
  EXPECT_NEAR(value.left[0], x.dot(I.cwiseProduct(y)), 8 * 2.3e-16 * I.maxCoeff());
}

TEST(LiveClaims, SidesComeInTheFrameOfTheView) {
  const Scene scene = tumbling();
  const LiveValue body = value_of("omega = omega", scene, 0.0, View::body);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(body.left[i], scene.w0_B[static_cast<int>(i)], 8 * 2.3e-16) << "ω₀ as it was given";
  const LiveValue space = value_of("L = L", scene, 2.0, View::space);
  EXPECT_NEAR(space.left[0], 0, 1e-14) << "L points up";
  EXPECT_GT(space.left[2], 1);
}

TEST(LiveClaims, MeasureTakesTheWorstOfTheInterval) {
  testing::TextReport at("T = w1 within 1e-9");
  const auto lines = read_claim_lines(at.source, 1, 1, ClaimKind::measured, at.report);
  const SceneModel model = make_model(tumbling());
  const auto wrong = measure(lines[0].equality, lines[0].within, model);
  ASSERT_TRUE(wrong);
  EXPECT_FALSE(wrong->holds());
  EXPECT_EQ(wrong->tolerance, 1e-9);
  const Claim energy = claim_of("2*T = dot(omega, L)", ClaimKind::measured);
  EXPECT_TRUE(measure(energy.lines[0].equality, std::nullopt, model)->holds());
}

TEST(LiveClaims, AreAbsentWhereThereIsNoMotionOrNoValue) {
  const SceneModel model = make_model(with_method(Method::rk4, 0.01));
  EXPECT_FALSE(live_state(model, 2 * model.motion->max_time_s()));
  const auto live = live_state(model, 1.0);
  ASSERT_TRUE(live);
  EXPECT_FALSE(live_value(claim_of("1/(w1 - w1) = 1", ClaimKind::law), *live, View::space));
  EXPECT_FALSE(live_value(claim_of("T = 0 => T = 0", ClaimKind::non_sequitur), *live, View::space));
}

TEST(LiveClaims, GiveTheNumbersOfFormulas) {
  const SceneModel model = make_model(tumbling());
  const auto live = live_state(model, 0.0);
  testing::TextReport at("2*T");
  const auto two_T = read_expression(at.text, {1, 1}, at.report);
  const double expected = 1.0 * 0.81 + 1.75 * 0.16 + 2.5 * 1.0;
  EXPECT_NEAR(*live_number(*two_T, *live), expected, 8 * 2.3e-16 * expected);
}

// A component that is small beside the whole is no rounding: at the start it is what the author wrote.
TEST(LiveClaims, SmallNumbersAreNoZeros) {
  Scene scene = tumbling();
  const auto number = [](const char* text, const LiveState& live) {
    testing::TextReport at(text);
    return *live_number(*read_expression(at.text, {1, 1}, at.report), live);
  };
  for (const double w1 : {1e-3, 3e-9, 2e-12}) {
    scene.w0_B = Vec3(w1, 3, 0);
    const auto live = live_state(make_model(scene), 0.0);
    EXPECT_EQ(number("w1", *live), w1);
    EXPECT_EQ(number("w3", *live), 0);
    EXPECT_EQ(number("dot(L, cross(omega, L))", *live), 0) << "what is left of terms that cancel";
    testing::TextReport at("omega");
    const auto omega = live_quantity(*read_expression(at.text, {1, 1}, at.report), *live, View::body);
    EXPECT_NEAR(omega->components[0], w1, 8 * 2.3e-16 * 3) << "turned into the space frame and back";
  }
}

TEST(LiveClaims, OnlyRatesHaveAPartInTheErrorOfAStep) {
  const SceneModel model = make_model(with_method(Method::explicit_euler, 0.2));
  const auto live = live_state(model, 1.0);
  const auto tolerance = [&](const char* text) {
    return live_value(claim_of(text, ClaimKind::law), *live, View::space)->tolerance;
  };
  EXPECT_GT(tolerance("ddt(T) = 0"), kDecisive);
  EXPECT_LT(tolerance("T = dot(omega, L)/2"), 1e-10) << "rounding";
}

TEST(LiveClaims, SpeakOfWhatTheSceneHas) {
  Scene scene = tumbling();
  const auto shown = [&](const char* text, ClaimKind kind = ClaimKind::identity) {
    return can_be_shown(claim_of(text, kind), scene);
  };
  EXPECT_TRUE(shown("ddt(L) = star(L) + cross(omega, L)"));
  EXPECT_FALSE(shown("ddt(A) = star(A) + cross(omega, A)"));
  EXPECT_FALSE(shown("p = m*v"));
  EXPECT_FALSE(shown("star(apply(J, L)) = apply(J, star(L))"));
  EXPECT_TRUE(shown("ddt(trace(J)) = 0", ClaimKind::measured));
  EXPECT_TRUE(shown("dot(e1, apply(J, e2)) = 0", ClaimKind::is_false));
  EXPECT_FALSE(shown("dot(omega, apply(J, omega)) = 2*T", ClaimKind::is_false))
      << "J has its components on other axes than omega";
  scene.show.insert(Overlay::transport);
  scene.v0_S = Vec3(1, 0, 0);
  EXPECT_TRUE(shown("ddt(A) = star(A) + cross(omega, A)"));
  EXPECT_TRUE(shown("p = m*v"));
  scene.torque.push_back(EnergySink{0.1});
  EXPECT_FALSE(shown("ddt(L) = star(L) + cross(omega, L)")) << "the body slips";
  EXPECT_TRUE(shown("2*T = dot(omega, L)"));
}

// At rest nothing changes, and nothing is divided by.
TEST(LiveClaims, ABodyAtRestHasValues) {
  Scene scene = tumbling();
  scene.w0_B = Vec3::Zero();
  for (const char* law : kLaws) EXPECT_LE(value_of(law, scene, 1.0).residual, 1e-14) << law;
}

TEST(LiveClaims, LengthsAreRootsAndHaveRates) {
  const SceneModel model = make_model(tumbling());
  const auto live = live_state(model, 0.0);
  const auto number = [&](const char* text) {
    testing::TextReport at(text);
    return *live_number(*read_expression(at.text, {1, 1}, at.report), *live);
  };
  const double length = std::sqrt(0.81 + 0.16 + 1.0);
  EXPECT_NEAR(number("norm(omega)"), length, 8 * 2.3e-16 * length);
  EXPECT_NEAR(number("ddt(norm(omega))"), number("dot(omega, ddt(omega))") / length, 64 * 2.3e-16 / 0.01)
      << "as the differences allow";
  EXPECT_EQ(number("norm(N)"), 0);
}

}  // namespace
}  // namespace polhode
