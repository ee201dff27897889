// SPDX-License-Identifier: MIT
#include "app/window/controls/control_style.h"

#include "app/session/symbol_note.h"
#include "base/utf8.h"
#include "lessons/reader/front_matter/front_matter.h"
#include "physics/body/bodies.h"
#include "physics/method.h"
#include "tests/app/session/example_lesson.h"
#include "tests/app/window/control_glyphs.h"
#include "tests/support/paths.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <vector>

namespace polhode {
namespace {

/// The fonts of the controls, and what they lack of the texts that they are given.
class ControlFont : public testing::Test {
 protected:
  ControlFont() : imgui_(ImGui::CreateContext()) {
    const auto fonts = Fonts::open();
    if (!fonts) throw std::runtime_error(fonts.error());
    load_control_fonts(control_sizes(1), *fonts);
  }
  ~ControlFont() override { ImGui::DestroyContext(imgui_); }

  static const ImFontGlyph* glyph(ImWchar character) {
    return test::glyphs_of(*ImGui::GetIO().Fonts->Fonts[0]).FindGlyphNoFallback(character);
  }

  void expect_all_of(std::string_view text, const std::string& where) {
    for (const char32_t character : code_points(text))
      if (character >= 0x20 && !(character <= 0xFFFF && glyph(static_cast<ImWchar>(character))) &&
          told_.insert(character).second)
        ADD_FAILURE() << fmt::format("no glyph for U+{:04X} in {}: {}", static_cast<unsigned>(character),
                                     where, text);
  }

 private:
  ImGuiContext* imgui_;
  std::set<char32_t> told_;  ///< once each
};

TEST_F(ControlFont, HasWhatNotesSay) {
  for (const char* id : test::kLessons) {
    const Lesson& lesson = test::loaded_lesson(id)->lesson;
    for (const std::string& body : named_bodies())
      for (const double speed : {1e-8, 0.3, 7e5}) {
        Scene scene;
        scene.body = *find_body(body);
        scene.w0_B = speed * Vec3(0.2, -1, 0.4);
        scene.v0_S = 1e-3 * scene.w0_B;
        scene.show = {Overlay::omega, Overlay::transport};
        const SceneModel model = make_model(scene);
        for (const auto& [name, symbol] : lesson.symbols) {
          const SymbolNote note = note_of(lesson, name, &model, 0.3);
          for (const std::string& text : {note.meaning, note.value, note.unit, note.frame})
            expect_all_of(text, fmt::format("the note on {} of {}, {}", name, body, id));
        }
      }
  }
}

// Titles, prompts, choices and hints stand in panels as they are written.
TEST_F(ControlFont, HasWhatLessonsSay) {
  for (const char* id : test::kLessons) {
    std::ifstream file(test::source_dir() / fmt::format("lessons/{}.md", id));
    for (std::string line; std::getline(file, line);) expect_all_of(line, id);
  }
}

TEST_F(ControlFont, HasWhatRefusalsSay) {
  const auto refused = body_with_moments(Vec3(1e-9, 2e-9, 3.1e-4));
  ASSERT_FALSE(refused);
  expect_all_of(refused.error(), "moments");
  for (const MethodFacts& facts : all_methods()) {
    expect_all_of(facts.term, "a method");
    expect_all_of(facts.keeps, "a method");
  }
  LessonSession session(test::loaded_lesson("euler-equations"));
  std::size_t judged = 0;
  for (bool more = true; more; more = session.next_step())
    for (const Ask* ask : session.questions()) {
      for (const char* answer : {"w1*(", "w1 + w4", "2*w1*N2", "A", "A B", "omega"}) {
        const AnswerJudgement judgement = session.answer(*ask, answer);
        expect_all_of(judgement.reason + judgement.hint, ask->id);
        if (!judgement.counterexample) continue;
        expect_all_of(to_string(*judgement.counterexample), ask->id);
        ++judged;
      }
    }
  EXPECT_GT(judged, 0u);
}

double luminance(const ImVec4& color) {
  const auto linear = [](float part) {
    return part <= 0.04045F ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.x) + 0.7152 * linear(color.y) + 0.0722 * linear(color.z);
}

/// Of two colours, the first of which may let the second through.
double contrast(ImVec4 color, const ImVec4& ground) {
  const auto over = [&](float top, float below) { return color.w * top + (1 - color.w) * below; };
  color = {over(color.x, ground.x), over(color.y, ground.y), over(color.z, ground.z), 1};
  const double one = luminance(color) + 0.05, other = luminance(ground) + 0.05;
  return std::max(one, other) / std::min(one, other);
}

// WCAG 2.2: 3:1 where a control is, how far it is moved and which one is chosen (1.4.11), 4.5:1 for the words
// on it (1.4.3): at rest, below the pointer and while it is held.
TEST_F(ControlFont, ControlsStandOutFromTheirGround) {
  struct Pair {
    int part, ground;
    double least;
  };
  std::vector<Pair> pairs;
  const auto add = [&](const std::vector<int>& parts, const std::vector<int>& grounds, double least) {
    for (const int part : parts)
      for (const int ground : grounds) pairs.push_back({part, ground, least});
  };
  const std::vector<int> kControl = {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
                                     ImGuiCol_Button,  ImGuiCol_ButtonHovered,  ImGuiCol_ButtonActive};
  const std::vector<int> kRow = {ImGuiCol_Header, ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive};
  const std::vector<int> kSheet = {ImGuiCol_WindowBg, ImGuiCol_PopupBg};
  const std::vector<int> kLine = {ImGuiCol_Border, ImGuiCol_CheckMark, ImGuiCol_NavHighlight};
  add(kLine, kSheet, 3);
  add(kLine, kControl, 3);
  add({ImGuiCol_CheckMark, ImGuiCol_NavHighlight}, kRow, 3);
  add({ImGuiCol_SliderGrab}, {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered}, 3);
  add({ImGuiCol_SliderGrabActive}, {ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive}, 3);
  add({ImGuiCol_ScrollbarGrab, ImGuiCol_ScrollbarGrabHovered, ImGuiCol_ScrollbarGrabActive}, kSheet, 3);
  add({ImGuiCol_Text}, kSheet, 4.5);
  add({ImGuiCol_Text}, kControl, 4.5);
  add({ImGuiCol_Text}, kRow, 4.5);
  add({ImGuiCol_Text}, {ImGuiCol_TextSelectedBg}, 4.5);
  // Words that are quiet, a warning or a praise, and those of a lesson in its colours stand in rows too; the
  // hint of a field that is empty is quiet.
  add({ImGuiCol_TextDisabled, ImGuiCol_NavHighlight, ImGuiCol_PlotLines}, kSheet, 4.5);
  add({ImGuiCol_TextDisabled}, kRow, 4.5);
  add({ImGuiCol_NavHighlight, ImGuiCol_PlotLines}, {ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive}, 4.5);
  add({ImGuiCol_TextDisabled}, {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive}, 4.5);
  for (const Theme theme : {Theme::paper, Theme::dark}) {
    set_control_style(theme, control_sizes(1));
    const ImVec4* const c = ImGui::GetStyle().Colors;
    for (const Pair& pair : pairs)
      EXPECT_GE(contrast(c[pair.part], c[pair.ground]), pair.least)
          << ImGui::GetStyleColorName(pair.part) << " on " << ImGui::GetStyleColorName(pair.ground)
          << (theme == Theme::dark ? ", dark" : ", paper");
    const auto of_lesson = [](const Color& color) { return ImVec4{color.r, color.g, color.b, 1}; };
    for (const std::string& role : color_roles())
      for (const int ground : {ImGuiCol_WindowBg, ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive})
        EXPECT_GE(contrast(of_lesson(on_paper(role_from(role).value().ink, theme)), c[ground]), 4.5)
            << role << " on " << ImGui::GetStyleColorName(ground);
  }
}

// The signs that are made of others stand where and as large as those of print.
TEST_F(ControlFont, HasSmallSignsAboveAndBelowTheLine) {
  const ImFontGlyph &one = *glyph('1'), &low_x = *glyph('x');
  for (const char* signs : {"⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾", "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎"}) expect_all_of(signs, "small signs");
  const ImFontGlyph *raised = glyph(0xB9), *four = glyph(0x2074), *lowered = glyph(0x2081);
  ASSERT_TRUE(raised && four && lowered);
  const float digit = one.Y1 - one.Y0, pixel = 1;
  for (const ImFontGlyph* small : {raised, lowered}) {
    EXPECT_GT(small->Y1 - small->Y0, 0.6F * digit - pixel);
    EXPECT_LT(small->Y1 - small->Y0, 0.75F * digit + pixel);
    EXPECT_LT(small->AdvanceX, 0.75F * one.AdvanceX);
  }
  EXPECT_NEAR(raised->Y0, one.Y0, pixel) << "as high as a digit";
  EXPECT_NEAR(four->Y0, raised->Y0, pixel) << "as all others";
  EXPECT_GT(lowered->Y1, low_x.Y1 + 0.5F * pixel) << "below the line";
}

}  // namespace
}  // namespace polhode
