// SPDX-License-Identifier: MIT
#include "app/window/controls/control_style.h"

#include <imgui.h>
#if IMGUI_VERSION_NUM >= 19200
#include <imgui_internal.h>  // ImFontAtlasBakedAddFontGlyph
#endif

#include <array>
#include <cmath>
#include <string_view>

namespace polhode {

namespace {

ImVec4 shade(const Color& color, float alpha = 1.0F) { return {color.r, color.g, color.b, alpha}; }

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

// Superscripts and subscripts: TeX Gyre has ¹²³ alone, and these are hard to read on a screen. They are signs
// of the face itself, a little larger than those three.
constexpr float kSmall = 0.68F;
constexpr std::u16string_view kSigns = u"0123456789+−=()", kSuperscripts = u"⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾",
                              kSubscripts = u"₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎";

// From 1.92 on a font has a set of glyphs for each size at which it is drawn; these are loaded at one.
#if IMGUI_VERSION_NUM >= 19200
using Glyphs = ImFontBaked;
Glyphs& glyphs_of(ImFont& font) { return *font.GetFontBaked(font.LegacySize); }
float size_of(const Glyphs& glyphs) { return glyphs.Size; }
#else
using Glyphs = ImFont;
Glyphs& glyphs_of(ImFont& font) { return font; }
float size_of(const Glyphs& glyphs) { return glyphs.FontSize; }
#endif

/// The same picture as `of`, moved down by y.
void add_glyph(ImFontAtlas& atlas, Glyphs& glyphs, char16_t sign, const ImFontGlyph& of, float y) {
#if IMGUI_VERSION_NUM >= 19200
  ImFontGlyph glyph = of;
  glyph.Codepoint = sign;
  glyph.Y0 += y;
  glyph.Y1 += y;
  glyph.PackId = ImFontAtlasRectId_Invalid;  // the place in the atlas stays that of the other
  ImFontAtlasBakedAddFontGlyph(&atlas, &glyphs, nullptr, &glyph);
#else
  static_cast<void>(atlas);
  glyphs.AddGlyph(nullptr, sign, of.X0, of.Y0 + y, of.X1, of.Y1 + y, of.U0, of.V0, of.U1, of.V1, of.AdvanceX);
#endif
}

/// `small` has kSigns at kSmall of the size of `font`. What is above the line is as high as a digit, what is
/// below it reaches down by a third of its own height.
void add_small_signs(ImFontAtlas& atlas, Glyphs& font, Glyphs& small) {
  const ImFontGlyph &digit = *font.FindGlyph('1'), &small_digit = *small.FindGlyph('1');
  const float raised = std::round(digit.Y0 - small_digit.Y0),
              lowered = std::round(digit.Y1 - small_digit.Y1 + (small_digit.Y1 - small_digit.Y0) / 3);
  for (std::size_t i = 0; i < kSigns.size(); ++i) {
    const ImFontGlyph& of = *small.FindGlyph(kSigns[i]);
    add_glyph(atlas, font, kSuperscripts[i], of, raised);
    add_glyph(atlas, font, kSubscripts[i], of, lowered);
  }
#if IMGUI_VERSION_NUM < 19200
  font.BuildLookupTable();
#endif
}

/// The characters that are in no range of a list.
template <std::size_t N>
constexpr std::array<ImWchar, N + 2> all_but(const std::array<ImWchar, N>& ranges) {
  std::array<ImWchar, N + 2> rest = {1};
  for (std::size_t i = 0; i + 1 < N; i += 2) {
    rest[i + 1] = static_cast<ImWchar>(ranges[i] - 1);
    rest[i + 2] = static_cast<ImWchar>(ranges[i + 1] + 1);
  }
  rest[N] = 0xFFFD;
  return rest;
}

}  // namespace

ControlSizes control_sizes(double scale) {
  const ControlSizes one;
  const auto scaled = [&](float size) { return std::round(static_cast<float>(scale) * size); };
  return {scaled(one.em), scaled(one.bar), scaled(one.panel), scaled(one.padding)};
}

void load_control_fonts(const ControlSizes& sizes, const Fonts& fonts) {
  // Of signs and Greek the mathematical face comes first, and then whatever a page may have, for texts of any
  // author; ImGui's characters end at 16 bits. Headings are ours.
  static constexpr std::array<ImWchar, 13> kLatin = {
      0x20,  0xB1,   0xB4,   0xB8,   0xBA,  // ²³¹ are small signs
      0x36F, 0x1E00, 0x1EFF, 0x2010, 0x2027, 0x2211, 0x2213, 0};
  static constexpr std::array<ImWchar, 15> kNotLatin = all_but(kLatin);
  static constexpr std::array<ImWchar, 5> kRest = {0xBA, 0xD7FF, 0xF900, 0xFFFD, 0};
  static constexpr std::array<ImWchar, 5> kOfSmallSigns = {'(', '=', 0x2212, 0x2212, 0};
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  const auto add = [&](Face face, float size, const ImWchar* ranges, bool merged = false) -> ImFont& {
    ImFontConfig config;
    config.OversampleH = 3;
    config.OversampleV = 1;
    config.GlyphOffset.y = -std::round(0.06F * sizes.em);  // what is above the capitals is empty
    config.MergeMode = merged;
#if IMGUI_VERSION_NUM >= 19200
    // A face is asked for all that it has, in whichever ranges; those of Latin letters have Greek ones, too.
    if (ranges == kLatin.data()) config.GlyphExcludeRanges = kNotLatin.data();
#else
    static_cast<void>(kNotLatin);
#endif
    // Dear ImGui takes whole sizes from 1.90 on, and cuts off the rest of others.
    return *atlas.AddFontFromFileTTF(fonts.path(face).c_str(), std::round(size * sizes.em), &config, ranges);
  };
  ImFont& regular = add(Face::sans, 1, kLatin.data());
  add(Face::math, 0.94F, kRest.data(), true);
  add(Face::sans, 1, kRest.data(), true);
  add(Face::sans_bold, 1, kLatin.data());
  ImFont& small = add(Face::sans, kSmall, kOfSmallSigns.data());
#if IMGUI_VERSION_NUM >= 19200
  atlas.TexDesiredFormat = ImTextureFormat_Alpha8;  // that which is drawn from: another would be built anew
#endif
  atlas.Build();
  add_small_signs(atlas, glyphs_of(regular), glyphs_of(small));
}

void begin_controls() {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
#if IMGUI_VERSION_NUM < 18700
  for (int key = 0; key < ImGuiKey_COUNT; ++key)
    io.KeyMap[key] = key;  // until a window's back end knows better
#else
  io.ConfigInputTrickleEventQueue = false;  // what goes into one frame: app/window/controls/input_portion.h
#endif
}

ImFont* bold_control_font() { return ImGui::GetIO().Fonts->Fonts[1]; }

float control_baseline(float em) {
  const Glyphs& glyphs = glyphs_of(*ImGui::GetFont());
  return glyphs.Ascent * em / size_of(glyphs);
}

void set_control_style(Theme theme, const ControlSizes& sizes) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  set_distances(style, sizes);
  const PageColors& page = colors_of(theme);
  const bool dark = theme == Theme::dark;
  const ImVec4 ground = shade(between(page.paper, page.ink, dark ? 0.05F : 0.045F));
  const ImVec4 raised = dark ? shade(between(page.paper, page.ink, 0.13F)) : ImVec4{1, 1, 1, 1};
  // So near to what is at rest that words of all colours can be read on them; what is held sinks in.
  const ImVec4 hovered = shade(between(page.paper, page.ink, dark ? 0.16F : 0.075F));
  const ImVec4 pressed = shade(between(page.paper, page.ink, dark ? 0.09F : 0.11F));
  const ImVec4 pointed_row = shade(between(page.paper, page.ink, dark ? 0.085F : 0.075F));
  const ImVec4 line = shade(between(page.paper, page.ink, 0.24F));
  // What says where a control is, or how far: 3:1 (WCAG 2.2, 1.4.11).
  const ImVec4 outline = shade(between(page.paper, page.ink, dark ? 0.56F : 0.61F));
  const ImVec4 focus = shade(page.question);
  ImVec4* const c = style.Colors;
  c[ImGuiCol_Text] = shade(page.ink);
  c[ImGuiCol_TextDisabled] = shade(page.quiet);
  c[ImGuiCol_WindowBg] = ground;
  c[ImGuiCol_ChildBg] = {0, 0, 0, 0};
  c[ImGuiCol_PopupBg] = raised;
  c[ImGuiCol_Border] = outline;
  c[ImGuiCol_BorderShadow] = {0, 0, 0, 0};
  c[ImGuiCol_FrameBg] = c[ImGuiCol_Button] = raised;
  c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_ButtonHovered] = hovered;
  c[ImGuiCol_FrameBgActive] = c[ImGuiCol_ButtonActive] = pressed;
  c[ImGuiCol_CheckMark] = focus;
  // No number stands on a slider's grab (number_slider).
  c[ImGuiCol_SliderGrab] = focus;
  c[ImGuiCol_SliderGrabActive] = shade(page.accent);
  c[ImGuiCol_Header] = shade(between(page.paper, page.question, 0.14F));
  c[ImGuiCol_HeaderHovered] = c[ImGuiCol_HeaderActive] = pointed_row;
  c[ImGuiCol_Separator] = c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = line;
  c[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
  c[ImGuiCol_ScrollbarGrab] = outline;
  c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = shade(page.quiet);
  c[ImGuiCol_PlotHistogram] = focus;
  c[ImGuiCol_PlotLines] = shade(page.meant);  // of what is right
  c[ImGuiCol_TextSelectedBg] = shade(between(page.paper, page.question, 0.35F));
  c[ImGuiCol_NavHighlight] = shade(page.accent);
}

}  // namespace polhode
