// SPDX-License-Identifier: MIT
// Equations as outlines: what their files say, and how they look to the programs of others.
#include "render/image/png.h"
#include "tests/app/run_program.h"
#include "tests/render/typeset/math/formulas.h"
#include "tests/support/paths.h"
#include "tests/support/xml.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <set>

namespace polhode {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

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

/// Of all pixels; all of them where there is no such picture, or one of another size.
double part_off(const fs::path& shown, const fs::path& wanted, int levels) {
  const auto a = read_png(shown), b = read_png(wanted);
  EXPECT_TRUE(a) << a.error();
  EXPECT_TRUE(b) << b.error();
  if (!a || !b) return 1;
  EXPECT_EQ(a->image.size, b->image.size) << wanted;
  if (a->image.size != b->image.size) return 1;
  std::size_t off = 0;
  for (std::size_t i = 0; i < a->image.rgba.size(); i += 4) {
    int most = 0;
    for (std::size_t k = 0; k < 4; ++k)
      most = std::max(
          most, std::abs(static_cast<int>(a->image.rgba[i + k]) - static_cast<int>(b->image.rgba[i + k])));
    off += most > levels ? 1 : 0;
  }
  return static_cast<double>(off) / static_cast<double>(a->image.rgba.size() / 4);
}

/// All formulas, several in a stage: a lesson has fewer stages than there are formulas.
std::string lesson_of_formulas(const std::vector<testing::NamedFormula>& formulas) {
  constexpr std::size_t kInStage = 5;
  std::string lesson =
      "+++\nformat = 1\nid = \"formulas\"\ntitle = \"Formulas\"\nauthor = [\"A. B.\"]\nlanguage = \"en\"\n"
      "[scene]\nbody = \"textbook\"\nomega = [0.2, 0.1, 3.0]\n+++\n";
  for (std::size_t i = 0; i < formulas.size(); ++i) {
    if (i % kInStage == 0) lesson += fmt::format("# Formulas {0} {{s{0}}}\n", i);
    lesson += fmt::format("```math {}\n{}\n```\n", formulas[i].name, formulas[i].tex);
  }
  return lesson;
}

class OutlinesShown : public ::testing::TestWithParam<const char*> {
 protected:
  const std::string format_ = GetParam(), program_ = format_ == "svg" ? "rsvg-convert" : "pdftoppm";

  void SetUp() override {
    if (!is_installed(program_)) GTEST_SKIP() << program_ << " is not installed";
  }

  void export_formulas(const std::vector<testing::NamedFormula>& formulas) const {
    write_text(lesson_ / "formulas.md", lesson_of_formulas(formulas));
    for (const auto& [format, folder] :
         {std::pair(format_, &outlines_), std::pair(std::string("png"), &pixels_)}) {
      const ProgramRun run =
          polhode({"export", (lesson_ / "formulas.md").string(), "-o", folder->path().string(), "--what",
                   "equation", "--format", format, "--dpi", "600"});
      EXPECT_EQ(run.code, 0) << run.err;
    }
  }

  void expect_the_same(std::size_t count) const {
    const std::vector<std::string> names = files_in(outlines_.path(), '.' + format_);
    EXPECT_EQ(names.size(), count);
    double worst = 0;
    for (const std::string& name : names) {
      const fs::path file = outlines_ / name, shown = outlines_ / "shown";
      const std::string command =
          format_ == "svg"
              ? fmt::format("rsvg-convert -d 600 -p 600 -o '{}.png' '{}'", shown.string(), file.string())
              : fmt::format("pdftoppm -r 600 -png -singlefile '{1}' '{0}'", shown.string(), file.string());
      ASSERT_EQ(std::system(command.c_str()), 0) << command;
      const double off =
          part_off(shown.string() + ".png", pixels_ / (fs::path(name).stem().string() + ".png"),
                   format_ == "svg" ? kLevelsOfSvg : kLevelsOfPdf);
      EXPECT_LE(off, kMostOff) << name;
      worst = std::max(worst, off);
    }
    std::cout << fmt::format("{}: {} formulas, at most {:.4f} % of the pixels are off\n", format_,
                             names.size(), 100 * worst);
  }

  const ScratchFolder lesson_, outlines_, pixels_;
};

TEST_P(OutlinesShown, AreThePictureOfTheSameResolution) {
  if (const char* formulas = std::getenv("POLHODE_FORMULAS"); formulas && formulas == std::string("all")) {
    const std::vector<testing::NamedFormula> all = testing::all_formulas();
    export_formulas(all);
    expect_the_same(all.size());
    return;
  }
  ASSERT_EQ(export_as(format_, outlines_.path()).code, 0);
  ASSERT_EQ(export_as("png", pixels_.path()).code, 0);
  expect_the_same(files_in(pixels_.path(), ".png").size());
}

TEST_P(OutlinesShown, HaveNoHoleWhereTheLineOfARootLiesOverItsSign) {
  export_formulas({{"roots", "\\sqrt{1 + \\sqrt{1 + \\sqrt{1 + \\sqrt[3]{x}}}}"}});
  expect_the_same(1);
}

INSTANTIATE_TEST_SUITE_P(Formats, OutlinesShown, ::testing::Values("svg", "pdf"),
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
              ::testing::AllOf(HasSubstr("Tagged:          yes"), HasSubstr("Pages:           1")));
  EXPECT_THAT(text_of(file + ".qdf"), ::testing::AllOf(HasSubstr("/Alt"), HasSubstr("/S /Figure")));
}

}  // namespace
}  // namespace polhode
