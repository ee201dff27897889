// SPDX-License-Identifier: MIT
// Formulas of every kind in real browsers: set as MathML, with the words that a screen reader says, and as
// wide as our own type.
#include "app/publish/html_text.h"
#include "app/publish/text_edition/reader_style.h"
#include "render/typeset/math/mathml.h"
#include "tests/app/publish/browser.h"
#include "tests/app/publish/firefox.h"
#include "tests/render/typeset/math/formulas.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace polhode {
namespace {

using ::testing::IsEmpty;
using Json = nlohmann::json;

constexpr double kEm = 32;  // px
/// Browsers space signs in scripts and cells of tables in their own way; what is missing or twice there is
/// more.
constexpr double kMostWider = 0.2, kMostWider_em = 0.3;

struct Shown {
  std::string name, words;
  double width = 0;  ///< as we set it, em
};

/// A page of all formulas, each by itself, in the style of pages to read; those that lines may be broken in
/// stand there in pieces, too.
class FormulaPage {
 public:
  FormulaPage() {
    const auto fonts = Fonts::open();
    EXPECT_TRUE(fonts) << fonts.error();
    std::string html;
    for (const auto& [name, tex] : testing::all_formulas()) {
      const auto math = parse_math(tex);
      if (!math) {
        ADD_FAILURE() << name;
        continue;
      }
      const bool display = !name.starts_with("inline-");
      MathStyle style;
      style.size = kEm;
      style.display = display;
      const auto list = set_math(*math, style, *fonts);
      EXPECT_TRUE(list) << name;
      const std::string words = spoken(*math, {}, {});
      const double width = list ? list->width / kEm : 0;
      MathMlStyle in_pieces{.display = display, .words = words, .tex = tex};
      const std::string whole = mathml(*math, in_pieces);
      in_pieces.in_pieces = true;
      const std::string broken = mathml(*math, in_pieces);
      html += "<div>" + whole + "</div>\n";
      all.push_back({name, words, width});
      if (broken == whole) continue;
      html += "<div>" + broken + "</div>\n";
      all.push_back({name + ", in pieces", words, width});
    }
    write_text(file(),
               fmt::format(
                   "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><title>Formulas</title>"
                   "<style>{} math {{ font-size: {}px; }} math:not(.pieces) {{ display: inline-block; }} "
                   "math[display=block]:not(.pieces) {{ display: inline block math; }} body {{ max-width: "
                   "none; }}</style></head>"
                   "<body>{}</body></html>",
                   reader_style(Lesson()), kEm, html));
  }

  std::filesystem::path file() const { return folder_ / "formulas.html"; }

  std::vector<Shown> all;

 private:
  ScratchFolder folder_;
};

template <class AnyBrowser>
void expect_formulas(AnyBrowser& browser) {
  const FormulaPage page;
  ASSERT_GE(page.all.size(), 500u);
  browser.open(page.file());
  const Json widths = browser.value_of(
      "[...document.getElementsByTagName('math')].map((m) => m.className === '' ? "
      "m.getBoundingClientRect().width : "
      "m.lastElementChild.getBoundingClientRect().right - m.firstElementChild.getBoundingClientRect().left)");
  ASSERT_EQ(widths.size(), page.all.size());
  for (std::size_t i = 0; i < page.all.size(); ++i) {
    const double width = widths[i].template get<double>() / kEm;
    if (page.all[i].name.starts_with("arrows")) continue;  // TeX puts no space between two relations
    EXPECT_NEAR(width, page.all[i].width, kMostWider * page.all[i].width + kMostWider_em) << page.all[i].name;
  }
  const std::vector<std::string> names = browser.names_of_formulas();
  ASSERT_EQ(names.size(), page.all.size());
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(names[i], page.all[i].words) << page.all[i].name;
  EXPECT_THAT(browser.complaints(), IsEmpty());
}

TEST(FormulasInBrowsers, AreSetAndSpokenByChromium) {
  const auto browser = Browser::start(1600, 1000);
  if (!browser) GTEST_SKIP() << "no Chromium is installed";
  expect_formulas(*browser);
}

TEST(FormulasInBrowsers, AreSetAndSpokenByFirefox) {
  const auto browser = Firefox::start(1600, 1000);
  if (!browser) GTEST_SKIP() << "no Firefox is installed";
  expect_formulas(*browser);
}

}  // namespace
}  // namespace polhode
