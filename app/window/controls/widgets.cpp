// SPDX-License-Identifier: MIT
#include "app/window/controls/widgets.h"

#include "app/session/symbol_note.h"
#include "base/ascii.h"
#include "base/words/window_words.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace polhode {

namespace {

constexpr float kIconSize = 0.36F;  // half the height of an icon, em

/// Pointing right (way = 1) or left (−1), its middle at `at`. Clockwise, as edges are softened.
void add_triangle(ImDrawList& list, ImVec2 at, float size, float way, ImU32 color) {
  const float back = at.x - 0.8F * way * size;
  list.AddTriangleFilled({back, at.y - way * size}, {at.x + 0.9F * way * size, at.y},
                         {back, at.y + way * size}, color);
}

void add_bar(ImDrawList& list, float x, float y, float half, float width, ImU32 color) {
  list.AddRectFilled({x - 0.5F * width, y - half}, {x + 0.5F * width, y + half}, color);
}

void add_icon(Icon icon, ImVec2 at, float size, ImU32 color) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float bar = std::max(2.0F, std::round(0.36F * size));
  switch (icon) {
    case Icon::back:
      return add_triangle(list, at, size, -1, color);
    case Icon::next:
    case Icon::play:
      return add_triangle(list, at, size, 1, color);
    case Icon::pause:
      add_bar(list, at.x - 0.45F * size, at.y, size, 1.4F * bar, color);
      return add_bar(list, at.x + 0.45F * size, at.y, size, 1.4F * bar, color);
    case Icon::frame_back:
      add_bar(list, at.x + 0.8F * size, at.y, size, bar, color);
      return add_triangle(list, {at.x - 0.2F * size, at.y}, 0.8F * size, -1, color);
    case Icon::frame_forward:
      add_bar(list, at.x - 0.8F * size, at.y, size, bar, color);
      return add_triangle(list, {at.x + 0.2F * size, at.y}, 0.8F * size, 1, color);
    case Icon::close:
      list.AddLine({at.x - size, at.y - size}, {at.x + size, at.y + size}, color, 0.5F * bar);
      return list.AddLine({at.x - size, at.y + size}, {at.x + size, at.y - size}, color, 0.5F * bar);
    case Icon::reset:
      add_bar(list, at.x - 0.9F * size, at.y, size, bar, color);
      add_triangle(list, {at.x - 0.1F * size, at.y}, 0.7F * size, -1, color);
      return add_triangle(list, {at.x + 0.8F * size, at.y}, 0.7F * size, -1, color);
  }
}

ImU32 color_of(ImGuiCol role) { return ImGui::GetColorU32(role); }

}  // namespace

void let_enter_press() {
#if IMGUI_VERSION_NUM < 18900  // from then on it does so by itself
  ImGuiContext& g = *ImGui::GetCurrentContext();
  if (g.NavActivateInputId != 0) g.NavActivateId = g.NavActivateDownId = g.NavActivateInputId;
#endif
}

void show_hint_from_left() {
#if IMGUI_VERSION_NUM < 18900
  if (ImGuiInputTextState* state = ImGui::GetInputTextState(ImGui::GetItemID())) state->ScrollX = 0;
#endif
}

void type_at_end() {
  ImGuiInputTextState* state = ImGui::GetInputTextState(ImGui::GetActiveID());
  if (state == nullptr) return;
  state->SelectAll();
  state->ClearSelection();
}

std::string told(Command command) {
  for (const CommandFacts& facts : all_commands()) {
    if (facts.command != command) continue;
    return fmt::format("{} ({})", capitalized(facts.does), facts.keys);
  }
  return {};
}

void hold_back_tooltips() { ImGui::GetCurrentContext()->HoveredIdTimer = 0; }

void tooltip_of_last(const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  if (ImGui::GetCurrentContext()->HoveredIdTimer < kTooltipDelay_s) return;
  // Clear of the pointer's way to what is beside the item: above it, or below what stands high.
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax(),
               &all = ImGui::GetIO().DisplaySize;
  const float gap = 0.4F * ImGui::GetFontSize();
  const bool above = low.y > 0.3F * all.y, leftward = low.x > 0.6F * all.x;
  ImGui::SetNextWindowPos({leftward ? high.x : low.x, above ? low.y - gap : high.y + gap}, ImGuiCond_Always,
                          {leftward ? 1.0F : 0.0F, above ? 1.0F : 0.0F});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(22 * ImGui::GetFontSize());
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool icon_button(const char* id, Icon icon, const std::string& words, const std::string& tooltip,
                 float width) {
  ImGui::PushID(id);
  const float em = ImGui::GetFontSize();
  const bool pressed = ImGui::Button("##icon", {width, 0});
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float words_width = !words.empty() ? ImGui::CalcTextSize(words.c_str()).x + 0.5F * em : 0;
  const float middle = 0.5F * (low.x + high.x), y = std::round(0.5F * (low.y + high.y));
  const bool words_first = icon == Icon::next;
  const float icon_x = middle + (words_first ? 0.5F : -0.5F) * words_width;
  add_icon(icon, {std::round(icon_x), y}, kIconSize * em, color_of(ImGuiCol_Text));
  if (!words.empty()) {
    const float x = words_first ? middle - 0.5F * words_width - 0.35F * em : icon_x + 0.75F * em;
    ImGui::GetWindowDrawList()->AddText({std::round(x), std::round(y - 0.5F * em)}, color_of(ImGuiCol_Text),
                                        words.c_str());
  }
  tooltip_of_last(tooltip);
  ImGui::PopID();
  return pressed;
}

bool toggle_button(const char* words, bool is_on, const std::string& tooltip) {
  const bool pressed = button_of_state(words, is_on, 0);
  tooltip_of_last(tooltip);
  return pressed;
}

bool button_of_state(const char* words, bool is_on, float width) {
  if (is_on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_Header));
  const bool pressed = ImGui::Button(words, {width, 0});
  if (is_on) ImGui::PopStyleColor();
  // Its ground alone would be too faint to tell it by.
  if (is_on)
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                        color_of(ImGuiCol_CheckMark), ImGui::GetStyle().FrameRounding, 0,
                                        std::max(2.0F, std::round(0.12F * ImGui::GetFontSize())));
  return pressed;
}

bool choice_row(const char* words, bool is_on, int flags) {
  const bool pressed = ImGui::Selectable(words, is_on, flags);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float width = std::max(2.0F, std::round(0.2F * ImGui::GetFontSize()));
  if (is_on)
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, high.y}, color_of(ImGuiCol_CheckMark));
  return pressed;
}

bool radio_button(const char* words, bool is_on) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  constexpr std::array kOfCircles = {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
                                     ImGuiCol_Border};
  std::array<ImU32, kOfCircles.size()> colors{};
  for (std::size_t i = 0; i < kOfCircles.size(); ++i) {
    colors[i] = ImGui::GetColorU32(kOfCircles[i]);
    ImGui::PushStyleColor(kOfCircles[i], IM_COL32_BLACK_TRANS);
  }
  const bool pressed = ImGui::RadioButton(words, false);
  ImGui::PopStyleColor(static_cast<int>(kOfCircles.size()));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 center{std::round(low.x + 0.5F * height), std::round(low.y + 0.5F * height)};
  constexpr int kPieces = 48;
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  list.AddCircleFilled(center, 0.5F * height - 1, colors[held && hovered ? 2 : hovered ? 1 : 0], kPieces);
  if (is_on) list.AddCircleFilled(center, 0.3F * height, ImGui::GetColorU32(ImGuiCol_CheckMark), kPieces);
  list.AddCircle(center, 0.5F * height - 1, colors[3], kPieces);
  return pressed;
}

std::optional<double> time_line(const LessonSession::Interval& interval, double t_s,
                                const std::vector<double>& flips, float width, Language language) {
  const float em = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
  ImGui::InvisibleButton("##time line", {width, height});
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const ImVec2 low = ImGui::GetItemRectMin();
  const float y = std::round(low.y + 0.5F * height), x0 = low.x + 0.5F * em, x1 = low.x + width - 0.5F * em;
  const double span = interval.to_s - interval.from_s;
  const auto x_of = [&](double t) {
    return x0 + (x1 - x0) * static_cast<float>(std::clamp((t - interval.from_s) / span, 0.0, 1.0));
  };
  const auto t_at = [&](float x) {
    return interval.from_s + span * std::clamp(static_cast<double>((x - x0) / (x1 - x0)), 0.0, 1.0);
  };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float thick = std::max(2.0F, std::round(0.2F * em));
  list.AddRectFilled({x0, y - 0.5F * thick}, {x1, y + 0.5F * thick}, color_of(ImGuiCol_Border), thick);
  list.AddRectFilled({x0, y - 0.5F * thick}, {x_of(t_s), y + 0.5F * thick}, color_of(ImGuiCol_CheckMark),
                     thick);
  const float mark = 0.28F * em;
  const ImU32 accent = color_of(ImGuiCol_NavHighlight);
  for (const double flip : flips) {
    const float x = x_of(flip), above = y;
    list.AddQuadFilled({x, above - mark}, {x + mark, above}, {x, above + mark}, {x - mark, above}, accent);
  }
  list.AddCircleFilled({x_of(t_s), y}, (active || hovered ? 0.48F : 0.42F) * em,
                       active ? accent : color_of(ImGuiCol_CheckMark), 24);
  const float pointer = ImGui::GetIO().MousePos.x;
  if (hovered && !active) {
    const auto near = std::find_if(flips.begin(), flips.end(),
                                   [&](double flip) { return std::abs(x_of(flip) - pointer) < 0.6F * em; });
    const double pointed_s = near != flips.end() ? *near : t_at(pointer);
    const std::string t = with_decimals(with_minus(fmt::format("{:.4g}", pointed_s)), language);
    tooltip_of_last(near != flips.end() ? words::kFlipAt.with(language, {t}) : "t = " + t + " s");
  }
  if (!active) return std::nullopt;
  // On a mark it is the flip itself.
  for (const double flip : flips)
    if (std::abs(x_of(flip) - pointer) < 0.3F * em) return flip;
  return t_at(pointer);
}

namespace {

/// Rounded to what a format shows of it.
double as_written(const char* format, double value) {
  std::array<char, 64> written{};
  ImFormatString(written.data(), written.size(), format, value);
  return std::strtod(written.data(), nullptr);
}

}  // namespace

bool number_slider(const char* id, double& value, double from, double to, const char* format, int flags,
                   Language language) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
  const bool is_typed = ImGui::TempInputIsActive(ImGui::GetID(id));
  const bool is_log = (flags & ImGuiSliderFlags_Logarithmic) != 0 && from > 0;
  // Dear ImGui takes what is below the last decimal that a format shows for 0, and of "%.1e" for 10: where a
  // logarithm begins lower, its grab would stand elsewhere than the value.
  const std::string with_all_digits =
      is_log ? fmt::format("%.{}g", std::clamp(1 - static_cast<int>(std::floor(std::log10(from))), 4, 17))
             : "";
  if (!is_typed) ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_BLACK_TRANS);
  const bool changed = ImGui::SliderScalar(id, ImGuiDataType_Double, &value, &from, &to,
                                           is_log ? with_all_digits.c_str() : format, flags);
  if (is_typed) return changed;
  if (is_log && changed) value = as_written(format, value);
  ImGui::PopStyleColor();
  const double part = is_log ? std::log(std::clamp(value, from, to) / from) / std::log(to / from)
                             : (value - from) / (to - from);
  std::array<char, 64> formatted{};
  ImFormatString(formatted.data(), formatted.size(), format, value);
  const std::string number = with_decimals(with_minus(formatted.data()), language);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float edge = 2, width = ImGui::CalcTextSize(number.c_str()).x, half = 0.5F * style.GrabMinSize,
              gap = 0.3F * ImGui::GetFontSize();
  const float thumb = low.x + edge + half +
                      (high.x - low.x - 2 * (edge + half)) * static_cast<float>(std::clamp(part, 0.0, 1.0));
  const float middle = 0.5F * (low.x + high.x);
  float left = middle - 0.5F * width;
  if (left < thumb + half + gap && left + width > thumb - half - gap)
    left = thumb > middle ? thumb - half - gap - width : thumb + half + gap;
  ImGui::GetWindowDrawList()->AddText({std::round(left), low.y + style.FramePadding.y}, ink, number.c_str());
  return changed;
}

void heading(const char* text) {
  ImGui::Dummy({0, 0.2F * ImGui::GetFontSize()});
  ImGui::PushFont(bold_control_font());
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
  ImGui::Separator();
}

namespace {

void wrapped(const std::string& text, const ImVec4& color) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

}  // namespace

void plain_words(const std::string& text) {
  if (!text.empty()) wrapped(text, ImGui::GetStyleColorVec4(ImGuiCol_Text));
}

void quiet_words(const std::string& text) { wrapped(text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled)); }

void warning_words(const std::string& text) {
  wrapped(text, ImGui::GetStyleColorVec4(ImGuiCol_NavHighlight));
}

void right_words(const std::string& text) { wrapped(text, ImGui::GetStyleColorVec4(ImGuiCol_PlotLines)); }

void value_row(const char* name, const std::string& value) {
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(0.55F * ImGui::GetWindowContentRegionMax().x);
  ImGui::TextUnformatted(value.empty() ? "–" : value.c_str());
}

}  // namespace polhode
