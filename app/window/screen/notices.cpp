// SPDX-License-Identifier: MIT
#include "app/window/screen/notices.h"

#include <imgui.h>

#include <algorithm>

namespace polhode {

namespace {

constexpr double kSeconds = 6;

std::string_view without_blanks_behind(std::string_view text) {
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

}  // namespace

std::string on_lines(std::string_view text, float width,
                     const std::function<float(std::string_view)>& width_of) {
  std::string lines, line;
  const auto end_line = [&] {
    lines += std::string(without_blanks_behind(line)) + '\n';
    line.clear();
  };
  const auto add = [&](std::string_view piece) {
    if (!line.empty() && width_of(line + std::string(without_blanks_behind(piece))) > width) end_line();
    line += piece;
  };
  while (!text.empty()) {
    if (text.front() == '\n') {
      end_line();
      text.remove_prefix(1);
      continue;
    }
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view word = text.substr(0, std::min(text.find(' '), end - 1) + 1);
    text.remove_prefix(word.size());
    const bool breaks = width_of(without_blanks_behind(word)) > width;
    while (!word.empty()) {
      const std::size_t slash = breaks ? word.find('/', 1) : word.npos;
      const std::string_view piece = word.substr(0, slash == word.npos ? slash : slash + 1);
      add(piece);
      word.remove_prefix(piece.size());
    }
  }
  return lines + line;
}

void Notices::tell(const std::string& text) {
  text_ = text;
  until_s_.reset();
}

void Notices::begin_frame(double clock_s) {
  if (!until_s_) until_s_ = clock_s + kSeconds;
}

std::optional<double> Notices::seconds_left(double clock_s) const {
  const double left_s = until_s_ ? *until_s_ - clock_s : kSeconds;
  return text_.empty() || left_s <= 0 ? std::nullopt : std::optional(left_s);
}

std::string Notices::shown(double clock_s) const {
  std::string text = page_error_.empty() ? lesson_errors_ : page_error_;
  if (seconds_left(clock_s)) text += (text.empty() ? "" : "\n\n") + text_;
  return text;
}

std::string Notices::on_lines_of(const Region& page, float padding, const std::string& text) {
  return on_lines(text, page.width - 7 * padding, [](std::string_view words) {
    return ImGui::CalcTextSize(words.data(), words.data() + words.size()).x;
  });
}

float Notices::height(const Region& page, float padding, double clock_s) const {
  const std::string text = on_lines_of(page, padding, shown(clock_s));
  if (text.empty()) return 0;
  const float of_text = ImGui::CalcTextSize(text.c_str(), nullptr, false, page.width - 5 * padding).y;
  return std::min(of_text + 2 * ImGui::GetStyle().WindowPadding.y, 0.6F * page.height) + 2 * padding;
}

void Notices::draw(const Region& page, Theme theme, float padding, double clock_s) const {
  const std::string text = on_lines_of(page, padding, shown(clock_s));
  if (text.empty()) return;
  const bool is_error = !page_error_.empty() || !lesson_errors_.empty();
  const Color accent = colors_of(theme).accent;
  const float most = page.width - 2 * padding;
  ImGui::SetNextWindowPos({page.x + padding, page.y + page.height - padding}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {most, 0.6F * page.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_Border, is_error ? ImVec4{accent.r, accent.g, accent.b, 1}
                                                  : ImGui::GetStyleColorVec4(ImGuiCol_Border));
  ImGui::Begin("strip", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoInputs |
                   ImGuiWindowFlags_NoSavedSettings);
  ImGui::PushTextWrapPos(most - 3 * padding);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace polhode
