// SPDX-License-Identifier: MIT
// Equations as outlines: what their files say, and how they look to the programs of others.
#include "render/image/png.h"
#include "tests/app/run_program.h"
#include "tests/support/paths.h"
#include "tests/support/xml.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

namespace polhode {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// Of the lecture: a fraction, products, vectors, a matrix; with terms in colour.
ProgramRun export_as(const std::string& format, const fs::path& folder, std::vector<std::string> more = {}) {
  std::vector<std::string> words = {"export",   (test::source_dir() / "lessons/euler-equations.md").string(),
                                    "-o",       folder.string(),
                                    "--what",   "equation",
                                    "--format", format,
                                    "--dpi",    "600",
                                    "--stage",  "components",
                                    "--stage",  "euler-tensor"};
  words.insert(words.end(), more.begin(), more.end());
  return polhode(words);
}

std::vector<std::string> files_in(const fs::path& folder, const std::string& ending) {
  std::vector<std::string> names;
  for (const std::string& name : names_in(folder))
    if (name.ends_with(ending)) names.push_back(name);
  return names;
}

TEST(Outlines, AnSvgSaysWhatItShows) {
  const ScratchFolder folder;
  const ProgramRun run = export_as("svg", folder.path());
  ASSERT_EQ(run.code, 0) << run.err;
  const std::vector<std::string> names = files_in(folder.path(), ".svg");
  ASSERT_GE(names.size(), 2u);
  std::set<std::string> colors;
  for (const std::string& name : names) {
    const test::XmlNode svg = test::read_xml(text_of(folder / name));
    EXPECT_EQ(svg.attribute("role"), "img");
    ASSERT_EQ(test::all_named(svg, "title").size(), 1u);
    const std::string words = test::all_named(svg, "title")[0]->children.at(0).text;
    EXPECT_THAT(words, HasSubstr("equals")) << name;
    EXPECT_THAT(text_of(folder / "manifest.json"), HasSubstr(words));
    EXPECT_THAT(test::all_named(svg, "desc").at(0)->children.at(0).text, HasSubstr(" – Euler"));
    EXPECT_TRUE(test::all_named(svg, "text").empty()) << "letters are curves";
    for (const test::XmlNode* path : test::all_named(svg, "path")) colors.insert(path->attribute("fill"));
  }
  EXPECT_GE(colors.size(), 3u) << "the ink and those of terms";
  EXPECT_EQ(polhode({"verify", folder.path().string()}).code, 0);
}

TEST(Outlines, RepeatToTheByteAndAreKept) {
  for (const std::string format : {"svg", "pdf"}) {
    const ScratchFolder one, other;
    ASSERT_EQ(export_as(format, one.path()).code, 0);
    ASSERT_EQ(export_as(format, other.path(), {"--jobs", "2"}).code, 0);
    const std::vector<std::string> names = names_in(one.path());
    EXPECT_EQ(names, names_in(other.path()));
    for (const std::string& name : names) EXPECT_EQ(text_of(one / name), text_of(other / name)) << name;
    const std::string damaged = files_in(one.path(), '.' + format).front(), whole = text_of(one / damaged);
    write_text(one / damaged, whole.substr(0, whole.size() / 2));
    EXPECT_EQ(polhode({"verify", one.path().string()}).code, 4);
    const ProgramRun again = export_as(format, one.path(), {"--skip-existing"});
    EXPECT_THAT(again.err, HasSubstr(fmt::format("({} of them kept)", names.size() - 2)));
    EXPECT_EQ(text_of(one / damaged), whole);
  }
}

TEST(Outlines, GoWithEquationsAlone) {
  const ScratchFolder folder;
  const auto refused = [&](std::vector<std::string> words, const char* reason) {
    words.insert(words.begin(), {"export", test_lesson("tiny.md"), "-o", (folder / "out").string()});
    const ProgramRun run = polhode(words);
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr(reason));
  };
  refused({"--format", "svg"}, "goes with --what equation");
  refused({"--format", "pdf", "--what", "figure"}, "goes with --what equation");
  refused({"--format", "svg", "--what", "equation", "--each", "frame"}, "goes with --each stage or step");
  refused({"--format", "svg", "--what", "equation", "--png", "small"}, "does not go with --format svg");
  refused({"--format", "eps", "--what", "equation"}, "none of png, svg, pdf");
}

/// A pixel is off if it differs by more than others may count its coverage differently: librsvg by a
/// quarter of it at the very most; poppler by 4 x 4 samples, an eighth at a slanted edge, and their power of
/// 1.5, which is up to 0.15 less, and a quarter more. A stroke that is missing or elsewhere is off by all.
constexpr int kLevelsOfSvg = 64, kLevelsOfPdf = 96;
constexpr double kMostOff = 2e-4;

void expect_same_pixels(const fs::path& shown, const fs::path& wanted, int levels) {
  const auto a = read_png(shown), b = read_png(wanted);
  ASSERT_TRUE(a) << a.error();
  ASSERT_TRUE(b) << b.error();
  ASSERT_EQ(a->image.size, b->image.size) << wanted;
  std::size_t off = 0;
  for (std::size_t i = 0; i < a->image.rgba.size(); i += 4) {
    int most = 0;
    for (std::size_t k = 0; k < 4; ++k)
      most = std::max(
          most, std::abs(static_cast<int>(a->image.rgba[i + k]) - static_cast<int>(b->image.rgba[i + k])));
    off += most > levels ? 1 : 0;
  }
  EXPECT_LE(static_cast<double>(off), kMostOff * static_cast<double>(a->image.rgba.size() / 4)) << wanted;
}

class OutlinesShown : public testing::TestWithParam<const char*> {};

TEST_P(OutlinesShown, AreThePictureOfTheSameResolution) {
  const std::string format = GetParam(), program = format == "svg" ? "rsvg-convert" : "pdftoppm";
  if (!is_installed(program)) GTEST_SKIP() << program << " is not installed";
  const ScratchFolder outlines, pixels;
  ASSERT_EQ(export_as(format, outlines.path()).code, 0);
  ASSERT_EQ(export_as("png", pixels.path()).code, 0);
  for (const std::string& name : files_in(outlines.path(), '.' + format)) {
    const fs::path file = outlines / name, shown = outlines / (name + ".shown");
    const std::string command =
        format == "svg"
            ? fmt::format("rsvg-convert -d 600 -p 600 -o '{}.png' '{}'", shown.string(), file.string())
            : fmt::format("pdftoppm -r 600 -png -singlefile '{1}' '{0}'", shown.string(), file.string());
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    expect_same_pixels(shown.string() + ".png", pixels / (fs::path(name).stem().string() + ".png"),
                       format == "svg" ? kLevelsOfSvg : kLevelsOfPdf);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, OutlinesShown, testing::Values("svg", "pdf"),
                         [](const auto& format) { return std::string(format.param); });

TEST(Outlines, APdfIsOnePageThatSaysItsWords) {
  if (!is_installed("pdfinfo") || !is_installed("qpdf")) GTEST_SKIP() << "pdfinfo or qpdf is not installed";
  const ScratchFolder folder;
  ASSERT_EQ(export_as("pdf", folder.path()).code, 0);
  const std::string file = (folder / files_in(folder.path(), ".pdf").front()).string();
  EXPECT_EQ(std::system(fmt::format("qpdf --check '{}' >/dev/null", file).c_str()), 0);
  ASSERT_EQ(
      std::system(
          fmt::format("pdfinfo '{0}' > '{0}.info'; qpdf --qdf --object-streams=disable '{0}' '{0}.qdf'", file)
              .c_str()),
      0);
  EXPECT_THAT(text_of(file + ".info"),
              testing::AllOf(HasSubstr("Tagged:          yes"), HasSubstr("Pages:           1")));
  EXPECT_THAT(text_of(file + ".qdf"), testing::AllOf(HasSubstr("/Alt"), HasSubstr("/S /Figure")));
}

}  // namespace
}  // namespace polhode
