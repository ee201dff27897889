// SPDX-License-Identifier: MIT
#include "physics/body/bodies.h"

#include "tests/physics/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace polhode {
namespace {

using test::kEps;

using Inside = std::function<bool(const Vec3&)>;

// Moments of unit mass by summing cells of a grid over [-half, half]³ that lie inside.
Vec3 moments_by_cells(const Inside& inside, const Vec3& half, int cells) {
  Vec3 second = Vec3::Zero();
  double count = 0;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      for (int k = 0; k < cells; ++k) {
        const Vec3 unit = (2.0 * Vec3(i + 0.5, j + 0.5, k + 0.5).array() / cells - 1.0).matrix();
        const Vec3 x = unit.cwiseProduct(half);
        if (!inside(x)) continue;
        second += x.cwiseAbs2();
        ++count;
      }
    }
  }
  second /= count;
  return {second[1] + second[2], second[2] + second[0], second[0] + second[1]};
}

// A fraction of about 6/cells of the cells is cut by the surface; the errors of those average out to well
// below half.
void expect_moments(const PrincipalMoments& I, double mass_kg, const Inside& inside, const Vec3& half) {
  constexpr int kCells = 100;
  const Vec3 expected = mass_kg * moments_by_cells(inside, half, kCells);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(I[i], expected[i], expected[i] * 2.0 / kCells) << "axis " << i + 1;
}

const Vec3 kSize(0.5, 0.3, 0.2);

TEST(Bodies, BoxMomentsMatchSummedCells) {
  expect_moments(
      box_moments(kSize, 2), 2, [](const Vec3&) { return true; }, kSize / 2);
}

TEST(Bodies, EllipsoidMomentsMatchSummedCells) {
  const auto inside = [](const Vec3& x) { return (2 * x).cwiseQuotient(kSize).squaredNorm() < 1; };
  expect_moments(ellipsoid_moments(kSize, 2), 2, inside, kSize / 2);
}

TEST(Bodies, CylinderOfEllipticSectionMatchesSummedCells) {
  const auto inside = [](const Vec3& x) { return std::hypot(2 * x[0] / kSize[0], 2 * x[1] / kSize[1]) < 1; };
  expect_moments(cylinder_moments(kSize, 2), 2, inside, kSize / 2);
}

TEST(Bodies, THandleMomentsMatchSummedCells) {
  const Vec3 size(0.3, 0.2, 0.04);
  const THandleGeometry T = t_handle_geometry(size);
  const double r = T.diameter_m / 2;
  const auto inside = [&](const Vec3& x) {
    const bool in_crossbar = std::hypot(x[1] - T.crossbar_at_m, x[2]) < r;
    const bool in_stem = std::hypot(x[0], x[2]) < r && std::abs(x[1] - T.stem_at_m) < T.stem_length_m / 2;
    return in_crossbar || in_stem;
  };
  expect_moments(t_handle_moments(size, 2), 2, inside, {size[0] / 2, size[1], r});
}

TEST(Bodies, THandleIsBalancedAboutTheOriginAndAsHighAsAsked) {
  const Vec3 size(0.3, 0.2, 0.04);
  const THandleGeometry T = t_handle_geometry(size);
  const double moment = T.crossbar_length_m * T.crossbar_at_m + T.stem_length_m * T.stem_at_m;
  EXPECT_NEAR(moment, 0, 4 * kEps * size[0] * size[1]);
  const double top = T.crossbar_at_m + T.diameter_m / 2;
  const double bottom = T.stem_at_m - T.stem_length_m / 2;
  EXPECT_NEAR(top - bottom, size[1], 8 * kEps * size[1]);
  EXPECT_NEAR(T.crossbar_at_m - T.diameter_m / 2, T.stem_at_m + T.stem_length_m / 2, 8 * kEps * size[1]);
}

TEST(Bodies, RoundCylinderIsExactlySymmetric) {
  const PrincipalMoments I = cylinder_moments({0.1, 0.1, 0.37}, 0.3);
  EXPECT_EQ(I[0], I[1]);
  EXPECT_NEAR(I[2], 0.3 * 0.1 * 0.1 / 8, 4 * kEps * I[2]);
}

TEST(Bodies, FlatAndLongShapesNeverBreakTheTriangleInequality) {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 size(random.uniform(0.1, 1), random.uniform(0.1, 1), std::pow(10.0, random.uniform(-12, 0)));
    const double mass_kg = random.uniform(0.1, 10);
    EXPECT_NO_THROW(box_moments(size, mass_kg));
    EXPECT_NO_THROW(ellipsoid_moments(size, mass_kg));
    EXPECT_NO_THROW(cylinder_moments(size, mass_kg));
  }
}

TEST(Bodies, ImpossibleSizesAndMassesAreRefused) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  for (const ShapeKind kind :
       {ShapeKind::box, ShapeKind::ellipsoid, ShapeKind::cylinder, ShapeKind::t_handle}) {
    EXPECT_NO_THROW(make_body("fine", kind, {0.3, 0.2, 0.1}, 1));
    for (const double bad : {0.0, -1.0, kNaN, kInf}) {
      EXPECT_THROW(make_body("mass", kind, {0.3, 0.2, 0.1}, bad), std::domain_error);
      for (int i = 0; i < 3; ++i) {
        Vec3 size(0.3, 0.2, 0.1);
        size[i] = bad;
        EXPECT_THROW(make_body("size", kind, size, 1), std::domain_error);
      }
    }
    EXPECT_THROW(make_body("overflow", kind, {1e200, 2e200, 1e199}, 1), std::domain_error);
  }
  EXPECT_THROW(make_body("no stem", ShapeKind::t_handle, {0.3, 0.1, 0.1}, 1), std::domain_error);
}

TEST(Bodies, EquivalentBoxHasTheMomentsItWasMadeFrom) {
  test::Random random(2);
  for (int i = 0; i < 500; ++i) {
    const PrincipalMoments I = random.moments();
    const Shape box = equivalent_box(I);
    EXPECT_EQ(box.kind, ShapeKind::box);
    const PrincipalMoments back = box_moments(box.size_m, 1.0);
    // Edges come from differences of moments, each with an error of ε of the largest moment.
    EXPECT_LE((back.vector() - I.vector()).cwiseAbs().maxCoeff(), 16 * kEps * I.vector().maxCoeff());
  }
}

TEST(Bodies, EquivalentBoxOfExtremeBodiesCanBeDrawn) {
  for (const Vec3& I : {Vec3(1, 2, 3), Vec3(0.1, 0.7, 0.8), Vec3(1, 1, 1e-12), Vec3(1e-320, 1e-320, 1e-320),
                        Vec3(1e308, 1e308, 1e308), Vec3(8e37, 8e37, 8.03e37)}) {
    const Vec3 size = equivalent_box({I[0], I[1], I[2]}).size_m;
    EXPECT_TRUE(size.allFinite()) << I.transpose();
    EXPECT_GE(size.minCoeff(), size.maxCoeff() / 500 * (1 - 2 * kEps)) << I.transpose();
  }
}

TEST(Bodies, EveryNameGivesABodyWhoseShapeHasItsMoments) {
  for (const std::string& name : named_bodies()) {
    const auto body = find_body(name);
    ASSERT_TRUE(body.has_value()) << name;
    EXPECT_EQ(body->name, name);
    if (!body->shape || name == "earth") continue;  // the Earth is denser inside
    const double mass_kg = 1.0;
    const PrincipalMoments unit = make_body(name, body->shape->kind, body->shape->size_m, mass_kg).moments;
    const Vec3 ratio = body->moments.vector().cwiseQuotient(unit.vector());
    EXPECT_NEAR(ratio[0] / ratio[2], 1, 1e-12) << name;  // sizes of slender-rod are given to 15 digits
    EXPECT_NEAR(ratio[1] / ratio[2], 1, 1e-12) << name;
  }
}

TEST(Bodies, NamesOfTheFormatAreThere) {
  EXPECT_THAT(named_bodies(), testing::IsSupersetOf({"textbook", "book", "racket", "phone", "t-handle",
                                                     "earth", "slender-rod", "needle", "disc", "sphere"}));
  EXPECT_EQ(find_body("Textbook"), std::nullopt);
  EXPECT_EQ(find_body(""), std::nullopt);
}

TEST(Bodies, ThoseThatTumbleHaveMomentsInRisingOrder) {
  for (const char* name : {"textbook", "book", "racket", "phone", "t-handle"}) {
    const PrincipalMoments I = find_body(name)->moments;
    EXPECT_LT(I[0], I[1]) << name;
    EXPECT_LT(I[1], I[2]) << name;
  }
}

TEST(Bodies, KnownOnesHaveTheirKnownMoments) {
  EXPECT_EQ(find_body("textbook")->moments, PrincipalMoments(1.0, 1.75, 2.5));
  EXPECT_EQ(find_body("slender-rod")->moments, PrincipalMoments(1, 1, 1e-4));
  const PrincipalMoments earth = find_body("earth")->moments;
  EXPECT_EQ(earth[0], earth[1]);
  // Euler's period of the free nutation, A/(C − A) sidereal days, is known to be 304 to 306 days.
  const double sidereal_day = 86164.1 / 86400;
  EXPECT_NEAR(earth[0] / (earth[2] - earth[0]) * sidereal_day, 305, 2);
  const PrincipalMoments sphere = find_body("sphere")->moments;
  EXPECT_EQ(sphere[0], sphere[1]);
  EXPECT_EQ(sphere[1], sphere[2]);
}

TEST(Bodies, ShapeNames) {
  EXPECT_EQ(shape_kind_from("box"), ShapeKind::box);
  EXPECT_EQ(shape_kind_from("ellipsoid"), ShapeKind::ellipsoid);
  EXPECT_EQ(shape_kind_from("cylinder"), ShapeKind::cylinder);
  EXPECT_EQ(shape_kind_from("t-handle"), ShapeKind::t_handle);
  EXPECT_EQ(shape_kind_from("cube"), std::nullopt);
  for (const std::string& name : shape_kind_names()) EXPECT_EQ(name_of(shape_kind_from(name).value()), name);
}

}  // namespace
}  // namespace polhode
