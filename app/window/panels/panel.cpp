// SPDX-License-Identifier: MIT
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"

#include <imgui.h>

#include <utility>

namespace polhode {

namespace {

const char* title_of(Panel panel) {
  switch (panel) {
    case Panel::outline:
      return "Outline";
    case Panel::body:
      return "Body and motion";
    case Panel::method:
      return "Speed and accuracy";
    case Panel::show:
      return "What is shown";
    case Panel::question:
      return "Questions";
    case Panel::save:
      return "Take away";
    case Panel::settings:
      return "View";
    default:
      return "Keys";
  }
}

void draw_contents(Desk& desk) {
  switch (desk.companion.panel) {
    case Panel::outline:
      return draw_outline(desk);
    case Panel::body:
      return draw_body(desk);
    case Panel::method:
      return draw_method(desk);
    case Panel::show:
      return draw_show(desk);
    case Panel::question:
      return draw_questions(desk);
    case Panel::save:
      return draw_save(desk);
    case Panel::settings:
      return draw_settings(desk);
    case Panel::help:
      return draw_help(desk);
    case Panel::none:
      return;
  }
}

/// What cannot be is not made, and the panel says why.
void make_edits(Desk& desk) {
  if (!desk.memory.edits) return;
  const Status made = desk.companion.set_edits(*desk.memory.edits);
  desk.memory.refusal = made ? "" : made.error();
  desk.memory.edits.reset();
}

void draw_contents_below_title(Desk& desk) {
  ImGui::BeginChild("contents", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  draw_contents(desk);
  ImGui::EndChild();
  make_edits(desk);
}

}  // namespace

void ask_for_edits(Desk& desk, const SceneEdits& edits) { desk.memory.edits = edits; }

void draw_panel(Desk& desk, const Region& region) {
  ImGui::SetNextWindowPos({region.x, region.y});
  ImGui::SetNextWindowSize({region.width, region.height});
  if (desk.take_focus) ImGui::SetNextWindowFocus();
  ImGui::Begin("panel", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoFocusOnAppearing);
  desk.memory.panel_has_focus = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool focused = desk.memory.panel_has_focus;
  list.PushClipRectFullScreen();
  list.AddLine({region.x + 0.5F, region.y}, {region.x + 0.5F, region.y + region.height},
               ImGui::GetColorU32(focused ? ImGuiCol_NavHighlight : ImGuiCol_Border), focused ? 2.0F : 1.0F);
  list.PopClipRect();
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(bold_control_font());
  ImGui::TextUnformatted(title_of(desk.companion.panel));
  ImGui::PopFont();
  if (desk.memory.shown != std::pair(desk.companion.panel, desk.companion.place()))
    desk.memory.refusal.clear();
  desk.memory.shown = {desk.companion.panel, desk.companion.place()};
  draw_contents_below_title(desk);
  // After the contents, so that keys come to these first.
  const float close = ImGui::GetFrameHeight();
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  ImGui::SetCursorPos({region.width - padding.x - close, padding.y});
  const bool closed = icon_button("close", Icon::close, "", told(Command::leave), close);
  ImGui::End();
  if (closed) desk.companion.panel = Panel::none;
}

}  // namespace polhode
