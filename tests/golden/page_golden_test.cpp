// SPDX-License-Identifier: MIT
// Golden pages, equations and a frame of a morph, by the golden rule, each proved able to fail.
#include "app/page/page.h"
#include "lessons/reader/checks/lesson_check.h"
#include "render/image/compare.h"
#include "render/typeset/morph.h"
#include "tests/golden/approval.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <sstream>

namespace polhode::golden {
namespace {

enum class Kind { page, text_alone, equation, morph };

struct Asked {
  Kind kind = Kind::page;
  Size size;
  int step = 2;
  Theme theme = Theme::paper;
  double later_s = 0;  ///< than the scene's time
  double way = 0.7;    ///< of the morph
  std::string lesson;  ///< the text
};

struct Row {
  std::string name;
  Kind kind;
  Size size;
  int step = 2;
  Theme theme = Theme::paper;
};

const std::vector<Row>& rows() {
  static const std::vector<Row> kRows = {
      {"page-paper", Kind::page, {960, 540}},
      {"page-dark", Kind::page, {960, 540}, 2, Theme::dark},
      {"page-portrait", Kind::page, {540, 960}},
      {"page-four-by-three", Kind::page, {800, 600}, 1},
      {"page-text-alone", Kind::text_alone, {720, 540}},
      {"equation-transparent", Kind::equation, {440, 120}},
      {"morph-frame", Kind::morph, {440, 120}},
  };
  return kRows;
}

const std::string& lesson_text() {
  static const std::string kText = [] {
    std::ifstream file(test::source_dir() / "tests/data/golden/page.md");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }();
  return kText;
}

Asked asked_of(const Row& row) {
  return {.kind = row.kind,
          .size = row.size,
          .step = row.step,
          .theme = row.theme,
          .later_s = 0,
          .way = 0.7,
          .lesson = lesson_text()};
}

Lesson read(const std::string& text) {
  LessonReading reading = check_lesson(text, "page.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  return std::move(*reading.lesson);
}

Image or_throw(Result<Image> image) {
  if (!image) throw std::runtime_error(image.error());
  return std::move(image).value();
}

Image page_picture(const Asked& asked, const Lesson& lesson) {
  const Stage& stage = lesson.stages[0];
  const Scene& scene = *stage.steps[static_cast<std::size_t>(asked.step - 1)].scene;
  const SceneModel model = make_model(scene, ModelFor::page);
  const Page page = compose_page({.lesson = lesson,
                                  .stage = stage,
                                  .number = 1,
                                  .step = asked.step,
                                  .model = asked.kind == Kind::page ? &model : nullptr,
                                  .t_s = scene.at_s + asked.later_s,
                                  .size = asked.size,
                                  .theme = asked.theme},
                                 renderer().fonts())
                        .value();
  return or_throw(renderer().draw(page.sheet, page.insets, asked.size,
                                  {Background::Kind::color, colors_of(asked.theme).paper}));
}

/// About x = 0, as displays stand on a page.
DisplayList equation_list(const Asked& asked, const Lesson& lesson, int step) {
  const std::vector<MathSymbol> symbols = symbols_of(lesson, asked.theme);
  const MathStyle style{
      .size = 40, .display = true, .color = colors_of(asked.theme).ink, .symbols = &symbols};
  for (const Block& block : lesson.stages[0].steps[static_cast<std::size_t>(step - 1)].blocks)
    if (const auto* equation = std::get_if<Equation>(&block)) {
      const DisplayList list = set_math(equation->math, style, renderer().fonts()).value();
      DisplayList centred;
      append(centred, list, -0.5 * list.width, 0.0);
      return centred;
    }
  throw std::runtime_error("a step without equation");
}

Image equation_picture(const Asked& asked, const Lesson& lesson) {
  DisplayList list = equation_list(asked, lesson, asked.step);
  const bool moving = asked.kind == Kind::morph;
  if (moving) list = morph(equation_list(asked, lesson, 1), list, asked.way);
  Sheet sheet;
  sheet.texts.push_back({.list = std::move(list), .at = {0.5 * asked.size.width, 72}, .moving = moving});
  Image image = or_throw(renderer().draw(sheet, asked.size, background_from("transparent").value()));
  lay_over_violet(image);
  return image;
}

Image picture(const Asked& asked) {
  const Lesson lesson = read(asked.lesson);
  const bool is_page = asked.kind == Kind::page || asked.kind == Kind::text_alone;
  return is_page ? page_picture(asked, lesson) : equation_picture(asked, lesson);
}

void replace(Asked& asked, const std::string& what, const std::string& with) {
  const auto at = asked.lesson.find(what);
  ASSERT_NE(at, std::string::npos) << what;
  asked.lesson.replace(at, what.size(), with);
}

struct Mutation {
  const char* what;
  std::function<void(Asked&)> change;
  std::function<bool(const Row&)> can_show = [](const Row&) { return true; };
};

const std::vector<Mutation>& mutations() {
  const auto is_of_page = [](const Row& r) { return r.kind == Kind::page || r.kind == Kind::text_alone; };
  const auto has_figure = [](const Row& r) { return r.kind == Kind::page; };
  const auto second = [is_of_page](const Row& r) { return is_of_page(r) && r.step == 2; };
  static const std::vector<Mutation> kMutations = {
      {"one letter of a formula", [](Asked& a) { replace(a, R"(\vec N = \frac{d)", R"(\vec N = \frac{b)"); },
       [](const Row& r) { return r.kind == Kind::morph || (r.kind != Kind::equation && r.step == 1); }},
      {"one letter of the second formula",
       [](Asked& a) { replace(a, R"(\vec N = \frac{d^*)", R"(\vec N = \frac{b^*)"); },
       [](const Row& r) { return r.kind != Kind::morph && r.step == 2; }},
      {"one letter of the title", [](Asked& a) { replace(a, "looks", "books"); }, is_of_page},
      {"one letter of what was said", [](Asked& a) { replace(a, "sees another", "seas another"); }, second},
      {"one letter of a choice", [](Asked& a) { replace(a, "\"never\"", "\"newer\""); }, second},
      {"another step", [](Asked& a) { a.step = 3 - a.step; }},
      {"the colour of a symbol", [](Asked& a) { replace(a, R"(role = "omega")", R"(role = "polhode")"); },
       [](const Row& r) { return r.kind != Kind::morph; }},
      {"the colour of another", [](Asked& a) { replace(a, R"(role = "L")", R"(role = "herpolhode")"); }},
      {"no highlight", [](Asked& a) { replace(a, "highlight = \"carried\"", ""); }, second},
      {"a number", [](Asked& a) { replace(a, "\\tag{3}", "\\tag{8}"); },
       [is_of_page](const Row& r) { return is_of_page(r) && r.step == 1; }},
      {"another number", [](Asked& a) { replace(a, "\\tag{4}", "\\tag{8}"); }, second},
      {"a frame later", [](Asked& a) { a.later_s = 0.04; }, has_figure},
      {"the other theme", [](Asked& a) { a.theme = a.theme == Theme::paper ? Theme::dark : Theme::paper; }},
      {"a little further on its way", [](Asked& a) { a.way = 0.71; },
       [](const Row& r) { return r.kind == Kind::morph; }},
  };
  return kMutations;
}

class GoldenPage : public testing::TestWithParam<Row> {};

TEST_P(GoldenPage, IsAsApproved) { expect_as_approved(GetParam().name, picture(asked_of(GetParam()))); }

TEST_P(GoldenPage, RefusesEveryMutationThatCanChangeIt) {
  const Image approved = picture(asked_of(GetParam()));
  int tried = 0;
  for (const Mutation& mutation : mutations()) {
    if (!mutation.can_show(GetParam())) continue;
    Asked asked = asked_of(GetParam());
    mutation.change(asked);
    EXPECT_FALSE(compare_images(approved, picture(asked)).equal()) << mutation.what;
    ++tried;
  }
  EXPECT_GE(tried, 5);
}

TEST_P(GoldenPage, RepeatsToTheByte) {
  const Image first = picture(asked_of(GetParam()));
  EXPECT_EQ(first.rgba, picture(asked_of(GetParam())).rgba);
}

INSTANTIATE_TEST_SUITE_P(All, GoldenPage, testing::ValuesIn(rows()), [](const auto& row) {
  std::string name = row.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace

std::vector<std::string> page_names() {
  std::vector<std::string> names;
  for (const Row& row : rows()) names.push_back(row.name);
  return names;
}

}  // namespace polhode::golden
