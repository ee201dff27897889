// SPDX-License-Identifier: MIT
#include "app/window/controls/widgets.h"
#include "app/window/panels/answer_controls.h"
#include "app/window/panels/panel_facts.h"
#include "app/window/panels/panels.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <utility>

namespace polhode {

namespace {

std::string title_of(const PanelContext& context) {
  for (const PanelFacts& facts : kPanels)
    if (facts.panel == context.session.panel) return context.said(facts.title);
  return "";
}

/// Whether the panel that is open has something to be typed.
bool has_text_field(const LessonSession& session, bool finds) {
  if (session.panel == Panel::save || (session.panel == Panel::outline && finds)) return true;
  const std::vector<const Ask*> asks = session.questions();
  return session.panel == Panel::question &&
         std::any_of(asks.begin(), asks.end(), [](const Ask* ask) { return is_typed(*ask); });
}

/// Of the present window, or the one that is told to have it; with a ring.
void focus_first_control() {
  ImGui::NavInitWindow(ImGui::GetCurrentWindow(), true);
  ImGui::GetCurrentContext()->NavInitRequestFromMove = true;
}

/// Asked for before the contents are drawn; the next frame has the result.
void move_focus(ImGuiDir to, ImGuiNavMoveFlags flags) {
  ImGui::NavMoveRequestSubmit(to, to, flags, ImGuiScrollFlags_KeepVisibleEdgeY);
}

}  // namespace

void Panels::draw_contents(PanelContext& context) {
  switch (context.session.panel) {
    case Panel::outline:
      return outline_.draw(context);
    case Panel::body:
      return body_.draw(context, refusal_);
    case Panel::method:
      return method_.draw(context, refusal_);
    case Panel::show:
      return show_.draw(context, refusal_);
    case Panel::question:
      return questions_.draw(context);
    case Panel::save:
      return save_.draw(context);
    case Panel::settings:
      return draw_settings(context);
    case Panel::lessons:
      return draw_home(context);
    case Panel::help:
      return draw_help(context);
    case Panel::none:
      return;
  }
}

/// What cannot be is not made, and the panel says why.
void Panels::make_edits(PanelContext& context) {
  if (context.requests.counterexample) {
    const Status shown = context.session.show_counterexample(*context.requests.counterexample);
    if (!shown) refusal_ = shown.error();
    context.requests.counterexample.reset();
  }
  if (!context.requests.edits) return;
  const Status made = context.session.set_edits(*context.requests.edits);
  refusal_ = made ? "" : made.error();
  context.requests.edits.reset();
}

void Panels::leave_keys() { has_focus_ = takes_keys_ = shows_focus_ = awaits_text_ = false; }

void Panels::begin_frame() {
  method_.count_frame();
  has_focus_ = awaits_text_ = is_held_ = false;
}

/// To what stands beside the control on its line; where there is nothing, which the next frame tells, to the
/// next line, and behind the last one to the first. True: it has come to another control.
bool Panels::step_focus() {
  constexpr int kMostFrames = 5;
  const ImGuiID now = ImGui::GetCurrentContext()->NavId;
  const bool is_reached = frames_to_reach_ > 0 && now != stepped_from_;
  frames_to_reach_ = is_reached ? 0 : std::max(0, frames_to_reach_ - 1);
  const int beside = std::exchange(beside_, 0);
  if (beside != 0 && now == stepped_from_)
    move_focus(beside > 0 ? ImGuiDir_Down : ImGuiDir_Up, ImGuiNavMoveFlags_LoopY);
  beside_ = std::exchange(steps_, 0);
  if (beside_ == 0) return is_reached;
  if (ImGui::GetIO().WantTextInput) ImGui::ClearActiveID();
  takes_keys_ = true;
  stepped_from_ = now;
  frames_to_reach_ = kMostFrames;
  move_focus(beside_ > 0 ? ImGuiDir_Right : ImGuiDir_Left, ImGuiNavMoveFlags_None);
  return false;
}

void Panels::draw(PanelContext& context, const Region& region) {
  ImGui::SetNextWindowPos({region.x, region.y});
  ImGui::SetNextWindowSize({region.width, region.height});
  if (context.take_focus) ImGui::SetNextWindowFocus();
  const bool only_scrolls = context.session.panel == Panel::help;
  ImGui::Begin("panel", nullptr,
               (only_scrolls ? ImGuiWindowFlags_NoNavInputs : 0) | ImGuiWindowFlags_NoTitleBar |
                   ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  const bool is_focused = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
  const ImGuiIO& io = ImGui::GetIO();
  takes_keys_ = takes_keys_ && is_focused && !io.MouseClicked[0];
  // Beside questions the keys are the page's until F6 is pressed, though a control was chosen in a panel
  // before.
  const bool asks = context.session.panel == Panel::question;
  if (is_focused && context.take_focus) takes_keys_ = !asks;
  const bool opens_by_key = is_focused && context.take_focus && !asks && !context.finds;
  if ((std::exchange(shows_focus_, false) || opens_by_key) && !only_scrolls) focus_first_control();
  context.is_reached = is_focused && step_focus();
  has_focus_ = is_focused && (takes_keys_ || (io.NavVisible && !asks) || io.WantTextInput);
  awaits_text_ =
      is_focused && !io.WantTextInput &&
      (frames_to_reach_ > 0 || (!takes_keys_ && has_text_field(context.session, outline_.finds())));
  context.has_keys = has_focus_;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRectFullScreen();
  list.AddLine({region.x + 0.5F, region.y}, {region.x + 0.5F, region.y + region.height},
               ImGui::GetColorU32(has_focus_ ? ImGuiCol_NavHighlight : ImGuiCol_Border),
               has_focus_ ? 2.0F : 1.0F);
  list.PopClipRect();
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(bold_control_font());
  ImGui::TextUnformatted(title_of(context).c_str());
  ImGui::PopFont();
  const std::pair now(context.session.panel, context.session.place());
  const std::pair before = std::exchange(shown_, now);
  const bool is_same_model =
      std::exchange(refused_of_, context.session.model_number()) == context.session.model_number();
  if (before != now || !is_same_model) refusal_.clear();
  ImGui::BeginChild("contents", {0, 0}, false,
                    only_scrolls ? ImGuiWindowFlags_NoNavInputs : ImGuiWindowFlags_NavFlattened);
  if (before.first != now.first) ImGui::SetScrollY(0);
  draw_contents(context);
  ImGui::EndChild();
  is_held_ = is_focused && io.MouseDown[0] && ImGui::IsAnyItemActive();
  make_edits(context);
  const float close = ImGui::GetFrameHeight();
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  ImGui::SetCursorPos({region.width - padding.x - close, padding.y});
  // By keys Escape closes: Space on what has the focus is never that.
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);
  const bool closed = icon_button("close", Icon::close, "", told(Command::leave), close);
  ImGui::PopItemFlag();
  ImGui::End();
  if (closed) context.session.panel = Panel::none;
}

}  // namespace polhode
