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

void draw_contents(PanelContext& context) {
  switch (context.session.panel) {
    case Panel::outline:
      return draw_outline(context);
    case Panel::body:
      return draw_body(context);
    case Panel::method:
      return draw_method(context);
    case Panel::show:
      return draw_show(context);
    case Panel::question:
      return draw_questions(context);
    case Panel::save:
      return draw_save(context);
    case Panel::settings:
      return draw_settings(context);
    case Panel::help:
      return draw_help(context);
    case Panel::none:
      return;
  }
}

/// What cannot be is not made, and the panel says why.
void make_edits(PanelContext& context) {
  if (!context.memory.edits) return;
  const Status made = context.session.set_edits(*context.memory.edits);
  context.memory.refusal = made ? "" : made.error();
  context.memory.edits.reset();
}

void draw_contents_below_title(PanelContext& context) {
  ImGui::BeginChild("contents", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  draw_contents(context);
  ImGui::EndChild();
  make_edits(context);
}

}  // namespace

void ask_for_edits(PanelContext& context, const SceneEdits& edits) { context.memory.edits = edits; }

void draw_panel(PanelContext& context, const Region& region) {
  ImGui::SetNextWindowPos({region.x, region.y});
  ImGui::SetNextWindowSize({region.width, region.height});
  if (context.take_focus) ImGui::SetNextWindowFocus();
  ImGui::Begin("panel", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoFocusOnAppearing);
  context.memory.panel_has_focus = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool focused = context.memory.panel_has_focus;
  list.PushClipRectFullScreen();
  list.AddLine({region.x + 0.5F, region.y}, {region.x + 0.5F, region.y + region.height},
               ImGui::GetColorU32(focused ? ImGuiCol_NavHighlight : ImGuiCol_Border), focused ? 2.0F : 1.0F);
  list.PopClipRect();
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(bold_control_font());
  ImGui::TextUnformatted(title_of(context.session.panel));
  ImGui::PopFont();
  if (context.memory.shown != std::pair(context.session.panel, context.session.place()))
    context.memory.refusal.clear();
  context.memory.shown = {context.session.panel, context.session.place()};
  draw_contents_below_title(context);
  // After the contents, so that keys come to these first.
  const float close = ImGui::GetFrameHeight();
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  ImGui::SetCursorPos({region.width - padding.x - close, padding.y});
  const bool closed = icon_button("close", Icon::close, "", told(Command::leave), close);
  ImGui::End();
  if (closed) context.session.panel = Panel::none;
}

}  // namespace polhode
