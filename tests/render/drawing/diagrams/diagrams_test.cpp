// SPDX-License-Identifier: MIT
#include "render/drawing/diagrams/diagrams.h"

#include "physics/body/euler.h"
#include "render/drawing/diagrams/diagram_paper.h"
#include "tests/render/drawing/sheet_texts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr Overlay kDiagrams[] = {Overlay::tensor_bars,  Overlay::cofactors,     Overlay::cyclic_wheel,
                                 Overlay::energy_rows,  Overlay::momentum_rows, Overlay::cards,
                                 Overlay::method_table, Overlay::order_plot};
constexpr PixelBox kBox{40, 30, 700, 520};

Scene scene_of(Overlay diagram, const Vec3& w0_B = {0.9, 0.4, 1.0}) {
  Scene scene;
  scene.w0_B = w0_B;
  scene.show = {diagram};
  return scene;
}

Scene with_body(Scene scene, const char* name) {
  scene.body = find_body(name).value();
  return scene;
}

Sheet sheet_of(const Scene& scene, double t_s, const PixelBox& box = kBox) {
  return lay_out_diagram(diagrams_in(scene.show).front(), make_model(scene), t_s, box, {}, fonts());
}

std::vector<Vec2> points_of(const FlatShape& shape) {
  return std::visit([](const auto& s) { return s.points; }, shape);
}

/// A pixel for baselines, which are whole.
void expect_tidy(const Sheet& sheet, const PixelBox& box) {
  for (std::size_t i = 0; i < sheet.texts.size(); ++i) {
    const PixelBox text = box_of(sheet.texts[i]);
    EXPECT_NEAR(text.overlap(box.grown(1.0)), text.width() * text.height(), 1e-6)
        << sheet.texts[i].text << " leaves its box";
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_EQ(text.overlap(box_of(sheet.texts[k])), 0.0)
          << sheet.texts[i].text << " covers " << sheet.texts[k].text;
  }
  for (const FlatShape& shape : sheet.shapes)
    for (const Vec2& p : points_of(shape))
      EXPECT_TRUE(p.allFinite() && box.grown(1.0).contains(p)) << p.transpose();
}

/// Bars of that paint: their ends along x.
std::vector<std::pair<double, double>> bars_of(const Sheet& sheet, const Color& paint) {
  std::vector<std::pair<double, double>> bars;
  for (const FlatShape& shape : sheet.shapes)
    if (const Area* area = std::get_if<Area>(&shape); area && area->color == paint)
      bars.emplace_back(area->points[0].x(), area->points[1].x());
  return bars;
}

std::vector<std::string> texts_in_order(const Sheet& sheet) {
  std::vector<std::string> texts;
  for (const PlacedType& type : sheet.texts) texts.push_back(type.text);
  return texts;
}

TEST(Diagrams, ComeLastInTheEnumeration) {
  for (int i = 0; i < kOverlayCount; ++i) {
    const auto overlay = static_cast<Overlay>(i);
    EXPECT_EQ(is_diagram(overlay), std::ranges::find(kDiagrams, overlay) != std::end(kDiagrams))
        << name_of(overlay);
  }
}

TEST(Diagrams, AreTidyForAnyBodyAndPlace) {
  std::vector<Scene> scenes;
  for (Overlay diagram : kDiagrams) {
    scenes.push_back(scene_of(diagram));
    scenes.push_back(scene_of(diagram, {0, 0, 0}));
    scenes.push_back(scene_of(diagram, {-300, 250, -1}));
    scenes.push_back(with_body(scene_of(diagram), "phone"));
    scenes.push_back(with_body(scene_of(diagram, {0, 1e-9, 7.3e-5}), "earth"));
    scenes.push_back(with_body(scene_of(diagram), "slender-rod"));
    scenes.push_back(scene_of(diagram));
    scenes.back().torque = {SpaceTorque{{0.3, -0.2, 0.1}}};
  }
  for (const Scene& scene : scenes)
    for (const PixelBox& box : {kBox, PixelBox{0, 0, 480, 270}, PixelBox{5, 9, 245, 400},
                                PixelBox{0, 0, 3840, 2160}, PixelBox{0, 0, 900, 150}}) {
      SCOPED_TRACE(std::string(name_of(diagrams_in(scene.show).front())) + " " + scene.body.name + " " +
                   std::to_string(box.width()));
      for (double t_s : {0.0, 0.37 * make_model(scene).span_s}) expect_tidy(sheet_of(scene, t_s, box), box);
    }
}

TEST(Diagrams, RepeatToTheBit) {
  for (Overlay diagram : kDiagrams) {
    const Sheet once = sheet_of(scene_of(diagram), 0.7), again = sheet_of(scene_of(diagram), 0.7);
    ASSERT_EQ(once.texts.size(), again.texts.size());
    for (std::size_t i = 0; i < once.texts.size(); ++i) {
      EXPECT_EQ(once.texts[i].list, again.texts[i].list);
      EXPECT_EQ(once.texts[i].at, again.texts[i].at);
    }
    for (std::size_t i = 0; i < once.shapes.size(); ++i)
      EXPECT_EQ(points_of(once.shapes[i]), points_of(again.shapes[i]));
  }
}

// Of a page of 1280 x 720 with meters, in px: em of prose 18.6, type of meters 0.62 em.
TEST(Diagrams, TypeIsLegibleOnAPage) {
  constexpr double kLeast = 0.6 * 0.62 * 18.6, kSmallest = 0.72;  // in sizes of a diagram's type
  constexpr PixelBox kPlace{0, 0, 628, 430};
  for (Overlay diagram : kDiagrams) {
    const Vec2 extent = diagram_extent(diagram, kPlace);
    EXPECT_GE(kSmallest * std::min(kPlace.width() / extent.x(), kPlace.height() / extent.y()), kLeast)
        << name_of(diagram);
  }
}

TEST(Diagrams, TensorBarsTurnWithTheBody) {
  Scene scene = scene_of(Overlay::tensor_bars, {0, 0, 1});
  scene.attitude = Quat::Identity();
  const auto numbers = [&](double t_s) {
    std::vector<std::string> found;
    for (const std::string& text : texts_in_order(sheet_of(scene, t_s)))
      if (text.find_first_not_of("−.0123456789") == text.npos && text.size() > 3) found.push_back(text);
    return found;
  };
  const std::vector<std::string> still = {"1.00", "0.00", "0.00", "0.00", "1.75",
                                          "0.00", "0.00", "0.00", "2.50"};
  auto both = still;
  both.insert(both.end(), still.begin(), still.end());
  EXPECT_EQ(numbers(0.0), both);
  constexpr double kQuarter = 1.57079632679489662;  // axis 1 points along y
  std::vector<std::string> turned = {"1.75", "0.00", "0.00", "0.00", "1.00", "0.00", "0.00", "0.00", "2.50"};
  turned.insert(turned.end(), still.begin(), still.end());
  EXPECT_EQ(numbers(kQuarter), turned);
  // I_xy = ½(I_1 − I_2) sin 2φ = −0.325 on the way
  EXPECT_EQ(numbers(kQuarter / 3.0)[1], "−0.32");
}

TEST(Diagrams, CofactorsAreLitOneAfterTheOther) {
  Scene scene = scene_of(Overlay::cofactors);
  scene.duration_s = 3.0;
  const Vec3 I = scene.body.moments.vector();
  const char* units[] = {"$\\hat i$", "$\\hat j$", "$\\hat k$"};
  for (int lit = 0; lit < 3; ++lit) {
    const Sheet sheet = sheet_of(scene, lit + 0.5);
    const Vec3 w = make_model(scene).motion->w_B_at(lit + 0.5);
    const Vec3 value = w.cross(I.cwiseProduct(w));
    EXPECT_EQ(texts_of(sheet, "N m").size(), static_cast<std::size_t>(lit) + 1)
        << "the others are still to be found";
    for (int i = 0; i < 3; ++i) {
      const diagrams::NumberForm form(1.0);  // three digits, as of 1.08 N m, the largest of this motion
      EXPECT_TRUE(i > lit || !texts_of(sheet, form.text(value[i])).empty()) << value[i];
      const bool is_ink = only_text(sheet, units[i]).list.glyphs.front().color == DiagramStyle{}.ink;
      EXPECT_EQ(is_ink, i == lit) << units[i] << " at " << lit;
    }
  }
}

TEST(Diagrams, TheWheelTellsTheTermsOfEulersEquations) {
  Scene scene = scene_of(Overlay::cyclic_wheel);
  scene.torque = {BodyTorque{{0.25, -0.5, 0.125}}};
  const Sheet sheet = sheet_of(scene, 0.3);
  for (const char* text : {"(7)", "(8)", "(9)", "$N_1$", "0.250", "−0.500", "0.125"})
    EXPECT_EQ(texts_of(sheet, text).size(), 1u) << text;
  scene.torque.clear();
  const Sheet free = sheet_of(scene, 0.3);
  for (const char* text : {"(10)", "(11)", "(12)"}) EXPECT_EQ(texts_of(free, text).size(), 1u) << text;
  EXPECT_TRUE(texts_of(free, "$N_1$").empty());
}

TEST(Diagrams, RowsEndWhereTheyBegan) {
  for (Overlay diagram : {Overlay::energy_rows, Overlay::momentum_rows}) {
    const Sheet sheet = sheet_of(scene_of(diagram), 1.3);
    std::vector<std::pair<double, double>> chain;
    for (int block = 0; block < 2; ++block)
      for (const Role& axis : kBodyAxisRoles)
        chain.push_back(
            bars_of(sheet, axis.paint)[static_cast<std::size_t>(2 * block + 1)]);  // after the swatch
    // Rounding: of ω̇ 1e-11, drawn some hundred pixels long.
    constexpr double kTolerance = 1e-8;
    for (std::size_t first : {0u, 3u}) {
      for (std::size_t i = first; i < first + 2; ++i)
        EXPECT_NEAR(chain[i].second, chain[i + 1].first, kTolerance);
      EXPECT_NEAR(chain[first].first, chain[first + 2].second, kTolerance);
      EXPECT_GT(std::abs(chain[first].second - chain[first].first), 5.0) << "px";
    }
  }
}

TEST(Diagrams, UnderTorqueTheSecondSumIsItsPower) {
  Scene scene = scene_of(Overlay::energy_rows);
  scene.torque = {BodyTorque{{0.25, -0.5, 0.125}}};
  const SceneModel model = make_model(scene);
  const double power = Vec3(0.25, -0.5, 0.125).dot(model.motion->w_B_at(0.4));
  EXPECT_EQ(texts_of(sheet_of(scene, 0.4), diagrams::signed_short(power)).size(), 1u) << power;
}

TEST(Diagrams, CardsHaveTheTwelveEquations) {
  const Sheet sheet = sheet_of(scene_of(Overlay::cards), 0.0);
  for (int n = 1; n <= 12; ++n) EXPECT_EQ(texts_of(sheet, "(" + std::to_string(n) + ")").size(), 1u) << n;
}

TEST(Diagrams, TheTableSaysWhatDivergedAndWhatIsGrosslyWrong) {
  Scene scene = scene_of(Overlay::method_table);
  scene.motion = {.method = Method::rk4, .step_s = 0.3};
  scene.at_s = 100.0;
  const MethodTable table = make_model(scene).methods;
  ASSERT_TRUE(std::isnan(table.rows[1].error.omega)) << "explicit Euler";
  const Sheet sheet = sheet_of(scene, 0.0);
  EXPECT_EQ(texts_of(sheet, "diverged").size(), 1u);
  EXPECT_EQ(texts_of(sheet, "closed form").size(), 1u);
  int bold = 0, gross = 1;  // the diverged one
  for (const PlacedType& text : sheet.texts) bold += text.list.glyphs.front().face == Face::sans_bold;
  for (const MethodRow& row : table.rows)
    gross += (row.error.omega > 0.01) + (row.error.attitude_rad > 0.0174532925199) + (row.drift.T > 0.01) +
             (row.drift.L > 0.01) + (row.drift.L_direction_rad > 0.0174532925199);
  EXPECT_EQ(bold, gross);
  EXPECT_GT(gross, 3);
}

TEST(Diagrams, TheTableSaysWhatItsNumbersAreOf) {
  Scene scene = scene_of(Overlay::method_table);
  scene.motion = {.method = Method::rk4, .step_s = 1.0 / 30.0};
  scene.at_s = 10.0;
  const Sheet sheet = sheet_of(scene, 0.0);
  for (const char* text : {"After 10 s in steps of 0.0333 s", "shaded: more than 1 % or 1° off",
                           "per s of motion", "tol. 10⁻¹⁰"})
    EXPECT_EQ(texts_of(sheet, text).size(), 1u) << text;
  expect_tidy(sheet, kBox);
}

TEST(Diagrams, MeasuredNumbersHaveTwoDigits) {
  using diagrams::two_digits;
  EXPECT_EQ(two_digits(0.3), "0.30");
  EXPECT_EQ(two_digits(-0.0996), "−0.10");
  EXPECT_EQ(two_digits(0.05), "0.050");
  EXPECT_EQ(two_digits(1e-3), "1.0 × 10⁻³");
  EXPECT_EQ(two_digits(2e-5), "2.0 × 10⁻⁵");
  EXPECT_EQ(two_digits(7.0), "7.0");
  EXPECT_EQ(two_digits(42.4), "42");
  EXPECT_EQ(two_digits(1.13e70), "1.1 × 10⁷⁰");
  EXPECT_EQ(two_digits(0.0), "0");
  EXPECT_EQ(two_digits(std::nan("")), "–");
}

// 20 s from steps of 0.1 s on: halved six times, errors of RK4 lie between 1e-4 and 1e-11.
TEST(Diagrams, TheOrderPlotMeasuresOrders) {
  Scene scene = scene_of(Overlay::order_plot);
  scene.motion = {.method = Method::rk4, .step_s = 0.1};
  scene.at_s = 20.0;
  EXPECT_EQ(make_model(scene).orders.size(), static_cast<std::size_t>(kOrderSteps));
  const Sheet sheet = sheet_of(scene, 0.0);
  for (const char* label : {"explicit Euler, order 1.0", "explicit midpoint, order 2.0", "RK4, order 4.0",
                            "splitting, order 2.0", "Moser–Veselov 6, order 6.0"})
    EXPECT_EQ(texts_of(sheet, label).size(), 1u) << label;
}

// Of few curves in a narrow column, whose type would be small beside it.
TEST(Diagrams, TheOrderPlotWritesTheOrderBelowANameWhereItIsNarrow) {
  Scene scene = scene_of(Overlay::order_plot);
  scene.motion = {.method = Method::rk4, .step_s = 0.1};
  scene.at_s = 20.0;
  scene.compared = {.methods = {Method::rk4, Method::rk4_projected}};
  const Sheet wide = sheet_of(scene, 0.0, {0, 0, 1200, 600}), narrow = sheet_of(scene, 0.0, {0, 0, 500, 700});
  EXPECT_EQ(texts_of(wide, "RK4 with projection, order 4.0").size(), 1u);
  EXPECT_EQ(texts_of(narrow, "RK4 with projection").size(), 1u);
  EXPECT_EQ(texts_of(narrow, "order 4.0").size(), 2u);
  for (const PlacedType* name : texts_of(narrow, "RK4 with projection"))
    EXPECT_NEAR(name->list.glyphs.front().size, texts_of(narrow, "RK4").front()->list.glyphs.front().size,
                1e-9);
}

// Of a page to read: beside the text one picture has much width and little height.
TEST(Diagrams, TheOrderPlotTakesAllTheRoomOfItsBox) {
  for (const PixelBox& box : {PixelBox{0, 0, 990, 400}, PixelBox{0, 0, 500, 480}, PixelBox{0, 0, 700, 700}}) {
    const Vec2 extent = diagram_extent(Overlay::order_plot, box);
    EXPECT_NEAR(extent.x() / extent.y(), box.width() / box.height(), 1e-12);
    EXPECT_GE(extent.x(), 30 * (1 - 1e-12)) << "rounded";
    EXPECT_GE(extent.y(), 20 * (1 - 1e-12));
  }
}

TEST(Diagrams, TheMethodsThatAreComparedAreThoseThatASceneNames) {
  Scene scene = scene_of(Overlay::order_plot);
  scene.motion = {.method = Method::rk4, .step_s = 0.1};
  scene.at_s = 20.0;
  scene.compared = {.methods = {Method::rk4, Method::splitting}, .by_evaluations = true};
  const SceneModel model = make_model(scene);
  for (const MethodTable& table : model.orders) {
    ASSERT_EQ(table.rows.size(), 3u) << "and the exact motion";
    EXPECT_EQ(table.rows[1].method, Method::rk4);
    EXPECT_EQ(table.rows[2].method, Method::splitting);
  }
  const Sheet sheet = sheet_of(scene, 0.0);
  EXPECT_EQ(texts_of(sheet, "RK4, order 4.0").size(), 1u);
  EXPECT_TRUE(texts_of(sheet, "explicit Euler, order 1.0").empty());
  EXPECT_EQ(texts_of(sheet, "evaluations in 20.0 s").size(), 1u);
  EXPECT_TRUE(texts_of(sheet, "steps in 20 s").empty());
}

TEST(Diagrams, AnOrderPlotOfTooManyStepsIsRefused) {
  Scene scene = scene_of(Overlay::order_plot);
  scene.motion = {.method = Method::rk4, .step_s = 0.1};
  scene.at_s = 0.1 / 64 * 1.01 * kMostTableSteps;
  EXPECT_THROW(make_model(scene), std::domain_error);
}

TEST(Diagrams, NothingMoreIsModelledThanTheyNeed) {
  EXPECT_EQ(requirements(scene_of(Overlay::cards)), Requirements{});
  EXPECT_TRUE(requirements(scene_of(Overlay::tensor_bars)).attitude);
  for (Overlay diagram :
       {Overlay::cofactors, Overlay::cyclic_wheel, Overlay::energy_rows, Overlay::momentum_rows}) {
    Requirements omega;
    omega.omega = true;
    EXPECT_EQ(requirements(scene_of(diagram)), omega) << name_of(diagram);
  }
  Requirements methods;
  methods.methods = true;
  EXPECT_EQ(requirements(scene_of(Overlay::method_table)), methods);
  Requirements orders;
  orders.orders = true;
  EXPECT_EQ(requirements(scene_of(Overlay::order_plot)), orders);
  EXPECT_TRUE(make_model(scene_of(Overlay::cards)).methods.rows.empty());
  EXPECT_TRUE(make_model(scene_of(Overlay::method_table)).orders.empty());
}

TEST(NumberForm, HasTheDigitsOfTheLargest) {
  using diagrams::NumberForm;
  EXPECT_EQ(NumberForm(2.5).text(1), "1.00");
  EXPECT_EQ(NumberForm(0.3).text(-0.25), "−0.250");
  EXPECT_EQ(NumberForm(1234).text(1233.7), "1234");
  EXPECT_EQ(NumberForm(2.5, 4).text(1), "1.000");
  EXPECT_EQ(NumberForm(2e-4).text(1.5e-4), "150");
  EXPECT_EQ(NumberForm(2e-4).unit("N m"), "10⁻⁶ N m");
  EXPECT_EQ(NumberForm(2.5).text(-1e-9), "0.00") << "no sign";
  EXPECT_EQ(NumberForm(0).text(0), "0.00");
  EXPECT_EQ(NumberForm(2.5).text(std::nan("")), "–");
  EXPECT_EQ(NumberForm(2e-4).residual(-3e-20), "−3 × 10⁻¹⁴");
}

TEST(NumberForm, ThirdsOfTheSpanRepeat) {
  Scene scene = scene_of(Overlay::cofactors);
  scene.duration_s = 3.0;
  const SceneModel model = make_model(scene);
  for (const auto& [t_s, third] : {std::pair(0.0, 0), {0.99, 0}, {1.01, 1}, {2.5, 2}, {3.0, 0}, {-0.5, 2}})
    EXPECT_EQ(diagrams::third_at(model, t_s), third) << t_s;
}

}  // namespace
}  // namespace polhode
