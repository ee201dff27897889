// SPDX-License-Identifier: MIT
#include "app/manifest.h"

#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace polhode {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

Manifest example() {
  Manifest manifest{"tiny", "abc", to_json(ExportOptions{}), "llvmpipe", {}};
  manifest.files.push_back({"01-a.png", "a", 2, std::nullopt, 0.1, {4, 3}, {"\\vec\\omega"}, "ω", "uniform"});
  manifest.files.push_back({"01-a-frame7.png", "a", 2, 7, 0.1, {4, 3}, {}, "", "rk4"});
  return manifest;
}

TEST(Manifest, HasTheFieldsOfFormat1) {
  const Json json = Json::parse(to_text(example()));
  EXPECT_EQ(json["format"], 1);
  EXPECT_EQ(json["lesson"]["id"], "tiny");
  EXPECT_EQ(json["lesson"]["sha256"], "abc");
  EXPECT_EQ(json["renderer"], "llvmpipe");
  const Json& file = json["files"][0];
  EXPECT_EQ(file, (Json{{"file", "01-a.png"},
                        {"stage", "a"},
                        {"step", 2},
                        {"frame", nullptr},
                        {"t", 0.1},
                        {"width", 4},
                        {"height", 3},
                        {"tex", {"\\vec\\omega"}},
                        {"alt", "ω"},
                        {"method", "uniform"}}));
  EXPECT_EQ(json["files"][1]["frame"], 7);
}

TEST(Manifest, NeverCarriesNaN) {
  Manifest manifest = example();
  manifest.files[0].t_s = std::nan("");
  EXPECT_TRUE(Json::parse(to_text(manifest))["files"][0]["t"].is_null());
}

TEST(Manifest, OptionsOfAnotherKindOfExportAreNull) {
  ExportOptions options;
  EXPECT_TRUE(to_json(options)["fps"].is_null());
  options.each = Each::frame;
  EXPECT_EQ(to_json(options)["fps"], "30");
  EXPECT_EQ(to_json(options)["each"], "frame");
}

TEST(Manifest, WhatAFileDoesNotHaveIsNull) {
  Manifest manifest = example();
  manifest.files = {ManifestFile{}};
  manifest.files[0].file = "tiny.txt";
  const Json file = Json::parse(to_text(manifest))["files"][0];
  for (const char* name : {"stage", "step", "frame", "t", "width", "height", "method"})
    EXPECT_TRUE(file[name].is_null()) << name;
}

TEST(Manifest, OptionsWithoutEffectOnAKindAreNull) {
  ExportOptions options;
  for (const auto& [what, nulls] : {std::pair<What, std::vector<const char*>>{What::page, {}},
                                    {What::figure, {"theme"}},
                                    {What::equation, {"size"}},
                                    {What::transcript, {"each", "size", "background", "theme"}}}) {
    options.what = what;
    const Json json = to_json(options);
    for (const char* name : {"each", "size", "background", "theme"})
      EXPECT_EQ(json[name].is_null(), std::count(nulls.begin(), nulls.end(), std::string_view(name)) > 0)
          << json["what"] << ' ' << name;
  }
}

TEST(TexShown, GrowsWithTheSteps) {
  Stage stage{"a", "A", {}, {Step{}, Step{}}, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    Equation equation;
    equation.tex = i == 0 ? "x" : "y";
    stage.steps[i].blocks.emplace_back(std::move(equation));
  }
  EXPECT_THAT(tex_shown(stage, 1), ElementsAre("x"));
  EXPECT_THAT(tex_shown(stage, 2), ElementsAre("x", "y"));
}

class MayExportInto : public testing::Test {
 protected:
  Status ask(const ExportOptions& options, const char* sha256 = "abc") {
    return may_export_into(scratch.path(), sha256, to_json(options));
  }
  ScratchFolder scratch;
};

TEST_F(MayExportInto, FolderWithoutManifestOrWithTheSame) {
  EXPECT_TRUE(ask({}).ok());
  write_text(scratch / kManifestName, to_text(example()));
  EXPECT_TRUE(ask({}).ok());
}

// Every option that decides the bytes must count.
TEST_F(MayExportInto, NotWithOtherOptions) {
  write_text(scratch / kManifestName, to_text(example()));
  std::vector<std::pair<std::string, ExportOptions>> others(10);
  others[0] = {"size", {}}, others[0].second.size = {640, 360};
  others[1] = {"stage", {}}, others[1].second.stages = {"a"};
  others[2] = {"each", {}}, others[2].second.each = Each::step;
  others[3] = {"at", {}}, others[3].second.at_s = 0.0;
  others[4] = {"background", {}}, others[4].second.background = "white";
  others[5] = {"dpi", {}}, others[5].second.dpi = 300;
  others[6] = {"each", {}}, others[6].second.each = Each::frame;
  others[7] = {"frames", {}}, others[7].second.frames = FrameRange{0, 1};
  others[8] = {"what", {}}, others[8].second.what = What::figure;
  others[9] = {"theme", {}}, others[9].second.theme = Theme::dark;
  for (const auto& [name, options] : others) {
    const Status status = ask(options);
    ASSERT_FALSE(status.ok()) << name;
    EXPECT_THAT(status.error(), HasSubstr(name));
  }
}

TEST_F(MayExportInto, NotWithAnotherLessonText) {
  write_text(scratch / kManifestName, to_text(example()));
  const Status status = ask({}, "abd");
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error(), HasSubstr("another lesson"));
}

TEST_F(MayExportInto, NotOverAForeignManifest) {
  for (const char* text : {"", "{", "[]", "{}", "{\"lesson\":1,\"options\":2}", "\xff\xfe"}) {
    write_text(scratch / kManifestName, text);
    EXPECT_FALSE(ask({}).ok()) << text;
  }
}

}  // namespace
}  // namespace polhode
