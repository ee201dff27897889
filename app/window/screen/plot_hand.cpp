// SPDX-License-Identifier: MIT
#include "app/window/screen/plot_hand.h"

#include "app/session/symbol_note.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace polhode {

namespace {

std::string with_unit(double value, const std::string& unit, Language language) {
  const bool is_plain = !unit.empty() && unit.find_first_of("$;") == unit.npos;  // else the axis has it
  return with_decimals(readable(value), language) + (is_plain ? " " + unit : "");
}

std::optional<std::size_t> plot_at(const std::vector<PlotReading>& plots, const Vec2& at) {
  const auto found = std::find_if(plots.begin(), plots.end(),
                                  [&](const PlotReading& plot) { return plot.frame.contains(at); });
  if (found == plots.end()) return std::nullopt;
  return static_cast<std::size_t>(found - plots.begin());
}

/// On paper, so that the curve behind it does not cross it out.
void write(ImDrawList& list, ImVec2 at, const std::string& words, ImU32 ink, float pad) {
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  list.AddRectFilled({at.x - pad, at.y}, {at.x + size.x + pad, at.y + size.y},
                     ImGui::GetColorU32(ImGuiCol_WindowBg, 0.9F), pad);
  list.AddText(at, ink, words.c_str());
}

ImU32 color_of(const Color& color) { return ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, 1}); }

/// A line at the sample, what x is there among the marks below it, and on each curve a dot with its value
/// beside it.
void draw_reading(const PlotReading& plot, double at_px, Language language, const ControlSizes& sizes) {
  const std::size_t i = plot.nearest(at_px);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float em = sizes.em, x = std::floor(static_cast<float>(plot.x_px[i])) + 0.5F;
  list.AddLine({x, static_cast<float>(plot.frame.y0)}, {x, static_cast<float>(plot.frame.y1)},
               ImGui::GetColorU32(ImGuiCol_Text, 0.55F), std::max(1.0F, 0.08F * em));
  struct Value {
    std::string words;
    float y = 0;
    ImU32 ink = 0;
  };
  std::vector<Value> values;
  float widest = 0;
  for (const PlotReading::Curve& curve : plot.curves) {
    if (i >= curve.y_px.size() || !std::isfinite(curve.y_px[i])) continue;
    values.push_back(
        {with_unit(curve.y[i], plot.unit, language), static_cast<float>(curve.y_px[i]), color_of(curve.ink)});
    widest = std::max(widest, ImGui::CalcTextSize(values.back().words.c_str()).x);
  }
  std::sort(values.begin(), values.end(), [](const Value& a, const Value& b) { return a.y < b.y; });
  std::vector<double> wanted;
  for (const Value& value : values) wanted.push_back(static_cast<double>(value.y));
  const double line = static_cast<double>(1.15F * em);
  const std::vector<double> placed =
      spread_apart(wanted, line, plot.frame.y0 + 0.5 * line, plot.frame.y1 - 0.5 * line);
  const float gap = 0.6F * em, pad = 0.15F * em;
  const bool fits_right = x + gap + widest < static_cast<float>(plot.frame.x1);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Value& value = values[k];
    list.AddCircleFilled({x, value.y}, 0.24F * em, value.ink, 16);
    const float width = ImGui::CalcTextSize(value.words.c_str()).x;
    write(list, {fits_right ? x + gap : x - gap - width, static_cast<float>(placed[k]) - 0.5F * em},
          value.words, value.ink, pad);
  }
  const std::string where = (plot.is_of_time ? "t = " : "") + with_unit(plot.x[i], plot.x_unit, language);
  const float width = ImGui::CalcTextSize(where.c_str()).x;
  const float left =
      std::clamp(x - 0.5F * width, static_cast<float>(plot.frame.x0),
                 std::max(static_cast<float>(plot.frame.x0), static_cast<float>(plot.frame.x1) - width));
  write(list, {left, static_cast<float>(plot.frame.y1) + 0.25F * em}, where,
        ImGui::GetColorU32(ImGuiCol_Text), pad);
}

}  // namespace

bool PlotHand::use_mouse(LessonSession& session, const std::vector<PlotReading>& plots, bool on_page,
                         const ControlSizes& sizes) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.MouseDown[0] || (held_ && *held_ >= plots.size())) held_.reset();
  const Vec2 at(io.MousePos.x, io.MousePos.y);
  const std::optional<std::size_t> under = on_page ? plot_at(plots, at) : std::nullopt;
  if (under && io.MouseClicked[0] && plots[*under].is_of_time) held_ = under;
  const std::optional<std::size_t> shown = held_ ? held_ : under;
  if (!shown) return false;
  const PlotReading& plot = plots[*shown];
  if (plot.is_of_time) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (held_ && (io.MouseClicked[0] || io.MouseDelta.x != 0)) {
    session.set_playing(false);
    session.scrub_to(plot.x_at(at.x()));
  }
  if (!session.is_playing()) draw_reading(plot, at.x(), session.lesson().about.language, sizes);
  return true;
}

}  // namespace polhode
