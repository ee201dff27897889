// SPDX-License-Identifier: MIT
#include "app/window/screen/symbol_focus.h"

#include "app/session/symbol_note.h"
#include "base/words/page_words.h"
#include "render/typeset/rich_text.h"

#include <fmt/format.h>
#include <imgui.h>

namespace polhode {

namespace {

constexpr std::size_t kMostWords = 60;  // of a term read aloud: a longer one is no help

constexpr const char* kAnyUnit = "any";  // of a letter that may stand for any quantity

constexpr float kWidestNote = 26;  // em

/// Of its window.
float height_of(const SymbolNote& note, float em) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float line = em + style.ItemSpacing.y;
  float height = 2 * style.WindowPadding.y +
                 ImGui::CalcTextSize(note.meaning.c_str(), nullptr, false, kWidestNote * em).y;
  if (!note.value.empty() || !note.unit.empty()) height += line;
  if (!note.value.empty() && !note.frame.empty()) height += line;
  return height;
}

}  // namespace

std::string SymbolFocus::focused(const Symbols& symbols) const {
  return focus_ && *focus_ < symbols.size() ? symbols[*focus_].name : "";
}

void SymbolFocus::light_focus(LessonSession& session, const Symbols& symbols) const {
  session.light(focused(symbols));
}

void SymbolFocus::reach(LessonSession& session, const Symbols& symbols, std::size_t place) {
  focus_ = place;
  explains_ = true;
  light_focus(session, symbols);
}

void SymbolFocus::leave(LessonSession& session) {
  focus_.reset();
  explains_ = false;
  session.light("");
}

void SymbolFocus::forget(LessonSession& session) {
  hovered_.reset();
  leave(session);
}

void SymbolFocus::point_at(LessonSession& session, const Symbols& symbols,
                           const std::optional<PageSymbol>& hovered) {
  const bool was = hovered_.has_value();
  hovered_ = hovered;
  if (hovered_)
    session.light(hovered_->name);
  else if (was)
    light_focus(session, symbols);
}

void SymbolFocus::draw_note(const LessonSession& session, const PageView& page, float em) const {
  const Symbols& symbols = page.symbols();
  const bool has_focus = explains_ && focus_ && *focus_ < symbols.size();
  if (!hovered_ && !has_focus) return;
  const PageSymbol& symbol = hovered_ ? *hovered_ : symbols[*focus_];
  const SceneModel* model = page.speaks_of_shown_motion(session, symbol) ? session.model() : nullptr;
  const SymbolNote note =
      note_of(session.lesson(), symbol.name, model, session.t_s(), session.stage().id, session.place().step);
  const bool is_term = symbol.is_term && !is_link_name(symbol.name);
  if (note.value.empty() && (note.meaning.empty() || (is_term && note.meaning.size() > kMostWords))) return;
  // Not on the formula that it explains; where that is high, a paragraph say, not on its line.
  constexpr float kHighest = 9;  // em
  const bool is_low = symbol.around.y1 - symbol.around.y0 < static_cast<double>(kHighest * em);
  TypeBox box = symbol.box;
  if (is_low) box.y0 = symbol.around.y0, box.y1 = symbol.around.y1;
  const float gap = 0.5F * em;
  const bool above = box.y0 > static_cast<double>(height_of(note, em) + gap);
  ImGui::SetNextWindowPos({static_cast<float>(0.5 * (box.x0 + box.x1)),
                           above ? static_cast<float>(box.y0) - gap : static_cast<float>(box.y1) + gap},
                          ImGuiCond_Always, {box.x0 < 10 * em ? 0.1F : 0.5F, above ? 1.0F : 0.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
  ImGui::Begin("note", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoInputs |
                   ImGuiWindowFlags_NoSavedSettings);
  ImGui::PushTextWrapPos(kWidestNote * em);
  ImGui::TextUnformatted(note.meaning.c_str());
  ImGui::PopTextWrapPos();
  const std::string unit = note.unit == kAnyUnit ? "" : note.unit;
  if (!note.value.empty()) {
    ImGui::TextUnformatted(fmt::format("{}{}{}", note.value, unit.empty() ? "" : " ", unit).c_str());
    const Phrase& frame = note.frame == "space" ? words::kComponentsInSpace : words::kComponentsInBody;
    if (!note.frame.empty())
      ImGui::TextDisabled("%s", std::string(frame.in(session.lesson().about.language)).c_str());
  } else if (!note.unit.empty() && note.unit != kAnyUnit) {
    ImGui::TextDisabled("%s", note.unit.c_str());
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace polhode
