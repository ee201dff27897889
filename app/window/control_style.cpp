// SPDX-License-Identifier: MIT
#include "app/window/control_style.h"

#include <imgui.h>

#include <array>
#include <cmath>

namespace polhode {

namespace {

ImVec4 shade(const Color& color, float alpha = 1.0F) { return {color.r, color.g, color.b, alpha}; }

ImVec4 between(const Color& a, const Color& b, float u) {
  return {a.r + u * (b.r - a.r), a.g + u * (b.g - a.g), a.b + u * (b.b - a.b), 1.0F};
}

void set_distances(ImGuiStyle& style, const ControlSizes& sizes) {
  const float em = sizes.em;
  style.WindowPadding = {sizes.padding * 1.4F, sizes.padding * 1.2F};
  style.FramePadding = {std::round(0.55F * em), std::round(0.24F * em)};
  style.ItemSpacing = {std::round(0.5F * em), std::round(0.45F * em)};
  style.ItemInnerSpacing = {std::round(0.4F * em), std::round(0.3F * em)};
  style.ScrollbarSize = std::round(0.7F * em);
  style.GrabMinSize = std::round(0.8F * em);
  style.WindowRounding = 0;
  style.PopupRounding = style.FrameRounding = style.GrabRounding = style.ScrollbarRounding =
      std::round(0.3F * em);
  style.WindowBorderSize = 0;
  style.PopupBorderSize = style.FrameBorderSize = 1;
  style.DisplaySafeAreaPadding = {0, 0};
}

}  // namespace

ControlSizes control_sizes(double scale) {
  const ControlSizes one;
  const auto scaled = [&](float size) { return std::round(static_cast<float>(scale) * size); };
  return {scaled(one.em), scaled(one.bar), scaled(one.panel), scaled(one.padding)};
}

void load_control_fonts(const ControlSizes& sizes, const Fonts& fonts) {
  // Latin; arrows, signs and Greek from the mathematical face.
  static constexpr std::array<ImWchar, 7> kLatin = {0x20, 0x17F, 0x2010, 0x2027, 0x2211, 0x2213, 0};
  static constexpr std::array<ImWchar, 11> kSigns = {0x370,  0x3FF,  0x2032, 0x2033, 0x2190, 0x21FF,
                                                     0x2200, 0x22FF, 0x25A0, 0x25FF, 0};
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  for (const Face face : {Face::sans, Face::sans_bold}) {
    ImFontConfig config;
    config.OversampleH = 3;
    config.OversampleV = 1;
    config.GlyphOffset.y = -std::round(0.06F * sizes.em);  // what is above the capitals is empty
    const auto add = [&](Face from, const ImWchar* ranges) {
      const float size = from == Face::math ? 0.94F * sizes.em : sizes.em;
      atlas.AddFontFromFileTTF(fonts.path(from).c_str(), size, &config, ranges);
      config.MergeMode = true;
    };
    add(face, kLatin.data());
    add(Face::math, kSigns.data());
  }
  atlas.Build();
}

ImFont* bold_control_font() { return ImGui::GetIO().Fonts->Fonts[1]; }

void set_control_style(Theme theme, const ControlSizes& sizes) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  set_distances(style, sizes);
  const PageColors& page = colors_of(theme);
  const bool dark = theme == Theme::dark;
  const ImVec4 ground = between(page.paper, page.ink, dark ? 0.05F : 0.045F);
  const ImVec4 raised = dark ? between(page.paper, page.ink, 0.13F) : ImVec4{1, 1, 1, 1};
  const ImVec4 hovered = between(page.paper, page.ink, dark ? 0.2F : 0.09F);
  const ImVec4 pressed = between(page.paper, page.ink, dark ? 0.28F : 0.16F);
  const ImVec4 line = between(page.paper, page.ink, 0.24F);
  const ImVec4 focus = shade(page.question);
  ImVec4* const c = style.Colors;
  c[ImGuiCol_Text] = shade(page.ink);
  c[ImGuiCol_TextDisabled] = shade(page.quiet);
  c[ImGuiCol_WindowBg] = ground;
  c[ImGuiCol_ChildBg] = {0, 0, 0, 0};
  c[ImGuiCol_PopupBg] = raised;
  c[ImGuiCol_Border] = line;
  c[ImGuiCol_BorderShadow] = {0, 0, 0, 0};
  c[ImGuiCol_FrameBg] = c[ImGuiCol_Button] = raised;
  c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_ButtonHovered] = hovered;
  c[ImGuiCol_FrameBgActive] = c[ImGuiCol_ButtonActive] = pressed;
  c[ImGuiCol_CheckMark] = focus;
  // The number of a slider stands on its grab.
  c[ImGuiCol_SliderGrab] = shade(page.question, 0.38F);
  c[ImGuiCol_SliderGrabActive] = shade(page.accent, 0.5F);
  c[ImGuiCol_Header] = between(page.paper, page.question, 0.18F);
  c[ImGuiCol_HeaderHovered] = hovered;
  c[ImGuiCol_HeaderActive] = pressed;
  c[ImGuiCol_Separator] = c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = line;
  c[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
  c[ImGuiCol_ScrollbarGrab] = line;
  c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = shade(page.quiet);
  c[ImGuiCol_PlotHistogram] = focus;
  c[ImGuiCol_PlotLines] = shade(page.meant);  // of what is right
  c[ImGuiCol_TextSelectedBg] = between(page.paper, page.question, 0.35F);
  c[ImGuiCol_NavHighlight] = shade(page.accent);
}

}  // namespace polhode
