// SPDX-License-Identifier: MIT
#include "app/cli/measure/measure_rendering.h"

#include "render/image/png.h"
#include "tests/app/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace polhode {
namespace {

RenderingRow row(double cpu_ms, double rms) { return {{}, cpu_ms, cpu_ms, rms, 0}; }

TEST(MeasureRendering, ErrorsAreThoseOfTheColours) {
  Image a = Image::blank({2, 2}), b = a;
  EXPECT_EQ(pixel_errors(a, b).rms, 0.0);
  b.rgba[0] = static_cast<std::uint8_t>(a.rgba[0] ^ 0x40);  // 64 levels in one of 12 values
  b.rgba[7] = static_cast<std::uint8_t>(a.rgba[7] ^ 0x80);  // alpha is no colour
  EXPECT_DOUBLE_EQ(pixel_errors(a, b).rms, 64.0 / std::sqrt(12.0));
  EXPECT_EQ(pixel_errors(a, b).max, 64);
}

TEST(MeasureRendering, RecommendsTheCheapestThatIsGoodEnough) {
  const std::vector<RenderingRow> rows = {row(100, 3.0), row(200, 1.0), row(150, 1.0), row(400, 0.5)};
  EXPECT_EQ(cheapest_within(rows, 1.0), 2u);
  EXPECT_EQ(cheapest_within(rows, 5.0), 0u);
  EXPECT_EQ(cheapest_within(rows, 0.1), std::nullopt);
  EXPECT_EQ(cheapest_within({}, 1.0), std::nullopt);
}

TEST(MeasureRendering, SettingsAreWhatTheDriverHasAndTheUsualOne) {
  for (int most : {0, 4, 8, 32}) {
    std::set<std::string> names;
    for (const RenderingSetting& setting : rendering_settings(most)) {
      EXPECT_LE(setting.quality.samples, most) << setting.name;
      EXPECT_EQ(setting.name.find_first_of(" ,\""), std::string::npos) << setting.name;
      EXPECT_TRUE(names.insert(setting.name).second) << setting.name << " comes twice";
    }
    EXPECT_EQ(names.contains("msaa4"), most >= 4);
    EXPECT_EQ(names.contains("normal"), most >= 4);
    EXPECT_TRUE(names.contains("draft"));
  }
}

TEST(MeasureRendering, WritesJsonCsvAndPlot) {
  const ScratchFolder folder;
  RenderingRequest request{
      .scene = usual_rendering_scene(), .of = "a scene", .size = {160, 90}, .tolerance = 1e3, .json = true};
  request.csv = folder / "rows.csv";
  request.plot = folder / "plot.png";
  testing::internal::CaptureStdout();
  EXPECT_EQ(measure_rendering(request), ExitCode::done);
  const auto json = nlohmann::json::parse(testing::internal::GetCapturedStdout());

  ASSERT_GE(json["rows"].size(), 3u);
  double rough = 0, fine = 0;
  for (const auto& r : json["rows"]) {
    EXPECT_GT(r["ms_per_frame"], 0.0);
    EXPECT_GE(r["max"], r["rms"]);
    if (r["setting"] == "1x1") rough = r["rms"];
    if (r["setting"] == "fine") fine = r["rms"];
  }
  EXPECT_LT(fine, rough);
  EXPECT_TRUE(std::find(json["rows"].begin(), json["rows"].end(), json["recommended"]) != json["rows"].end());

  const std::string csv = text_of(folder / "rows.csv");
  EXPECT_TRUE(csv.starts_with(
      "setting,samples,supersampling,chord_tolerance,ms_per_frame,cpu_ms_per_frame,rms,max\n"));
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), json["rows"].size() + 1);
  EXPECT_TRUE(read_png(folder / "plot.png").ok());
}

TEST(MeasureRendering, WithoutAToleranceNothingIsRecommended) {
  RenderingRequest request{.scene = usual_rendering_scene(), .of = "a scene", .size = {64, 36}, .json = true};
  testing::internal::CaptureStdout();
  EXPECT_EQ(measure_rendering(request), ExitCode::done);
  EXPECT_TRUE(nlohmann::json::parse(testing::internal::GetCapturedStdout())["recommended"].is_null());
}

}  // namespace
}  // namespace polhode
