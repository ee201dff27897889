// SPDX-License-Identifier: MIT
#include "app/window/panels/answer_controls.h"

#include "app/session/answers/answer_text.h"
#include "app/window/controls/widgets.h"
#include "base/words/answer_words.h"
#include "base/words/window_words.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <utility>

namespace polhode {

void keep_typing(bool is_wanted) {
  if (is_wanted)
    ImGui::SetKeyboardFocusHere(-1);
  else
    ImGui::SetWindowFocus(nullptr);
}

void take_keyboard_by_tab(PanelContext& context) {
  if (context.is_reached && ImGui::IsItemFocused()) {
    ImGui::SetKeyboardFocusHere(-1);
    context.is_reached = false;
  }
}

bool text_field(PanelContext& context, const char* id, const char* form, const char* button,
                std::string& typed) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float behind = ImGui::CalcTextSize(button).x + 2 * style.FramePadding.x + style.ItemSpacing.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - behind);
  if (std::exchange(context.take_focus, false)) {
    ImGui::SetWindowFocus();  // after the focus went to no window Dear ImGui 1.90 finds no field in this one
    ImGui::SetKeyboardFocusHere();
  }
  const bool entered = ImGui::InputTextWithHint(id, form, &typed, ImGuiInputTextFlags_EnterReturnsTrue);
  take_keyboard_by_tab(context);
  if (typed.empty()) show_hint_from_left();
  if (entered && typed.empty()) keep_typing(true);
  return entered && !typed.empty();
}

void say_who_has_keys(const PanelContext& context) {
  const std::array said = {context.said(words::kKeysGoToAnswer), context.said(words::kKeysGoToPanel),
                           context.said(words::kKeysGoToPage)};
  // The buttons below stay where they are while the pointer presses one, whoever has the keys then.
  const float top = ImGui::GetCursorPosY(), width = ImGui::GetContentRegionAvail().x;
  float tallest = 0;
  for (const std::string& one : said)
    tallest = std::max(tallest, ImGui::CalcTextSize(one.c_str(), nullptr, false, width).y);
  quiet_words(said[ImGui::GetIO().WantTextInput ? 0 : context.has_keys ? 1 : 2]);
  ImGui::SetCursorPosY(top + tallest + ImGui::GetStyle().ItemSpacing.y);
}

void show_accepted(PanelContext& context, const Ask& ask) {
  const Lesson& lesson = context.session.lesson();
  const AnswerRecord* record = context.session.record(ask);
  const std::string accepted = record != nullptr ? record->accepted : "";
  const Phrase& opening = accepted.empty() ? words::kAnsweredBefore : words::kYourRightAnswer;
  context.texts.show(
      opened_by(std::string(opening.in(lesson.about.language)), accepted_text(lesson, ask, accepted)),
      TextInk::right);
  context.texts.show(ask.because, TextInk::quiet);
}

void show_it_button(PanelContext& context, const Counterexample& counter) {
  if (!context.session.can_show(counter)) return;
  const Counterexample* shown = context.session.counterexample();
  const bool is_shown = shown != nullptr && shown->state == counter.state;
  ImGui::BeginDisabled(is_shown);
  const Phrase& phrase = is_shown ? words::kIsInFigure : words::kShowInFigure;
  const std::string said(phrase.in(context.session.lesson().about.language));
  if (ImGui::Button((said + "###show").c_str())) context.requests.counterexample = counter;
  ImGui::EndDisabled();
}

}  // namespace polhode
