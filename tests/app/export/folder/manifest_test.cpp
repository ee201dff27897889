// SPDX-License-Identifier: MIT
#include "app/export/folder/manifest.h"

#include "tests/app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

const ExportIdentity kTiny{"tiny", "abc", options_json(ExportOptions{})};

std::string text_of_manifest(const std::vector<ManifestFile>& files) {
  std::string text = manifest_head(kTiny, "llvmpipe");
  for (const ManifestFile& file : files)
    text += (&file == &files.front() ? "" : kManifestComma) + manifest_entry(file);
  return text + manifest_end(files.empty());
}

std::vector<ManifestFile> two_files() {
  return {
      {"01-a.png", "a", 2, std::nullopt, 0.1, {4, 3}, {"\\vec\\omega"}, "ω\nand \"more\"", "uniform", "ab01"},
      {"01-a-frame7.png", "a", 2, 7, 0.1, {4, 3}, {}, "", "rk4", "cd02"}};
}

TEST(Manifest, HasTheFieldsOfFormat1) {
  const Json json = Json::parse(text_of_manifest(two_files()));
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
                        {"alt", "ω\nand \"more\""},
                        {"method", "uniform"},
                        {"sha256", "ab01"}}));
  EXPECT_EQ(json["files"][1]["frame"], 7);
}

TEST(Manifest, PiecesMakeTheIndentedFormOfTheWhole) {
  for (const auto& files : {std::vector<ManifestFile>(), {two_files()[0]}, two_files()}) {
    const std::string text = text_of_manifest(files);
    EXPECT_EQ(text, nlohmann::ordered_json::parse(text).dump(1) + '\n');
  }
}

TEST(Manifest, IsSummarizedWithoutItsFiles) {
  const ScratchFolder scratch;
  const auto none = summarize_manifest(scratch / kManifestName);
  ASSERT_TRUE(none.ok());
  EXPECT_FALSE(none->has_value());
  for (const auto& files : {std::vector<ManifestFile>(), two_files()}) {
    write_text(scratch / kManifestName, text_of_manifest(files));
    const auto there = summarize_manifest(scratch / kManifestName);
    ASSERT_TRUE(there.ok() && there->has_value());
    EXPECT_EQ((*there)->of.lesson_id, "tiny");
    EXPECT_EQ((*there)->of.lesson_sha256, "abc");
    EXPECT_EQ((*there)->of.options, kTiny.options);
    EXPECT_EQ((*there)->renderer, "llvmpipe");
    EXPECT_EQ((*there)->files, files.size());
  }
}

TEST(Manifest, TellsTheChecksumsOfItsFiles) {
  const ScratchFolder scratch;
  std::vector<ManifestFile> files = two_files();
  files.push_back({"of-an-older-version.png", "", 0, std::nullopt, std::nullopt, {}, {}, "", "", ""});
  write_text(scratch / kManifestName, text_of_manifest(files));
  const auto found = checksums_in_manifest(scratch / kManifestName);
  ASSERT_TRUE(found.ok()) << found.error();
  EXPECT_EQ(*found,
            (Checksums{{"01-a.png", "ab01"}, {"01-a-frame7.png", "cd02"}, {"of-an-older-version.png", ""}}));
  EXPECT_FALSE(checksums_in_manifest(scratch / "none").ok());
  write_text(scratch / kManifestName, "{");
  EXPECT_FALSE(checksums_in_manifest(scratch / kManifestName).ok());
}

TEST(Manifest, OfSomethingElseIsNotSummarized) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "folder");
  for (const char* text : {"", "{", "[]", "{}", "{\"lesson\":1,\"options\":2}", "\xff\xfe"}) {
    write_text(scratch / kManifestName, text);
    EXPECT_FALSE(summarize_manifest(scratch / kManifestName).ok()) << text;
  }
  const std::string whole = text_of_manifest(two_files());
  for (std::size_t length = 1; length < whole.size() - 1; length += 7) {
    write_text(scratch / kManifestName, whole.substr(0, length));
    EXPECT_FALSE(summarize_manifest(scratch / kManifestName).ok()) << length;
  }
}

TEST(Renderers, AreNamedOnceAndInOrder) {
  EXPECT_EQ(join_renderers({}), "");
  EXPECT_EQ(join_renderers({"b", "", "a", "b"}), "a | b");
  EXPECT_EQ(join_renderers({"b | c", "a | b"}), "a | b | c");
  EXPECT_EQ(join_renderers({"llvmpipe; 4.5"}), "llvmpipe; 4.5");
}

TEST(Manifest, NeverCarriesNaN) {
  std::vector<ManifestFile> files = two_files();
  files[0].t_s = std::nan("");
  EXPECT_TRUE(Json::parse(text_of_manifest(files))["files"][0]["t"].is_null());
}

TEST(Manifest, OptionsOfAnotherKindOfExportAreNull) {
  ExportOptions options;
  EXPECT_TRUE(Json::parse(options_json(options))["fps"].is_null());
  options.each = Each::frame;
  EXPECT_EQ(Json::parse(options_json(options))["fps"], "30");
  EXPECT_EQ(Json::parse(options_json(options))["each"], "frame");
}

TEST(Manifest, TellsOfASizeOfTextThatIsNotTheNormalOne) {
  ExportOptions larger;
  larger.text_scale = 1.4;
  EXPECT_EQ(Json::parse(options_json(larger))["text_size"], 1.4);
  EXPECT_FALSE(Json::parse(options_json(ExportOptions{})).contains("text_size"))
      << "older exports are the same then";
  for (const auto& [there, here] : {std::pair{larger, ExportOptions{}}, {ExportOptions{}, larger}})
    EXPECT_THAT(first_difference(options_json(there), options_json(here)),
                testing::HasSubstr("text_size is"));
}

TEST(Manifest, WhatAFileDoesNotHaveIsNull) {
  ManifestFile text;
  text.file = "tiny.txt";
  const Json file = Json::parse(text_of_manifest({text}))["files"][0];
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
    const Json json = Json::parse(options_json(options));
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

}  // namespace
}  // namespace polhode
