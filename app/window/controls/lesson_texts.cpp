// SPDX-License-Identifier: MIT
#include "app/window/controls/lesson_texts.h"

#include "app/page/live_numbers.h"
#include "app/window/controls/control_pass.h"
#include "render/typeset/paragraph.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace polhode {

namespace {

// Dear ImGui's sizes are from the highest to the lowest point of a face. So large is Heros' em then, and
// there its baseline, in lines that stand beside those of controls.
constexpr double kTypeSize = 0.73, kAscent = 0.74, kDepth = 0.26;
constexpr double kMargin = 2;  ///< px, for ink that leaves its box

/// Whatever of a text decides how it looks.
std::string name_of(const RichText& text) {
  std::string name;
  for (const TextBlock& block : text)
    name += '\x1d' + std::to_string(block.indent) + block.marker + (block.is_table() ? "table" : "");
  for_each_span(text, [&](const TextSpan& span) {
    name += '\x1e';
    name += static_cast<char>('0' + (span.kind == TextSpan::Kind::math) + 2 * span.bold + 4 * span.italic +
                              8 * span.code + 16 * span.break_after);
    name += span.text;
  });
  return name;
}

std::string as_written(const RichText& text) {
  std::string words;
  for_each_span(text, [&](const TextSpan& span) { words += span.text; });
  return words;
}

Color color_of(TextInk ink, const PageColors& colors) {
  switch (ink) {
    case TextInk::plain:
      return colors.ink;
    case TextInk::quiet:
      return colors.quiet;
    case TextInk::right:
      return colors.meant;
    case TextInk::wrong:
      return colors.accent;
  }
  return colors.ink;
}

}  // namespace

void LessonTexts::begin_frame(const Lesson& lesson, const Step& step, Theme theme, float em) {
  const bool is_same = lesson_ == &lesson && step_ == &step && theme_ == theme && em_ == em;
  if (!is_same) {
    if (lesson_ != &lesson) numbers_ = StillNumbers();
    pictures_.clear();
    symbols_ = symbols_of(lesson, theme);
  }
  lesson_ = &lesson;
  step_ = &step;
  theme_ = theme;
  em_ = em;
  std::erase_if(pictures_, [&](const auto& entry) { return entry.second.frame != frame_; });
  ++frame_;
}

RichText LessonTexts::with_numbers(const RichText& text) {
  PageNumbers numbers(*lesson_, renderer_.fonts());
  const std::vector<int> ids = numbers_in(text);
  if (!ids.empty()) {
    const StillNumbers::Values& values = numbers_.of(*lesson_, *step_);
    for (const int id : ids) {
      const auto value = values.find(id);
      numbers.keep(id, value == values.end() ? std::nullopt : std::optional(value->second));
    }
  }
  return numbers.put_into(text);
}

/// Smaller where a formula is too wide for the room and cannot be broken.
Result<DisplayList> LessonTexts::set(const RichText& text, TextInk ink, int width) const {
  TextStyle style;
  style.size = kTypeSize * em_;
  style.color = style.link_color = color_of(ink, colors_of(theme_));
  style.sans = true;
  style.leading = 1.4;
  style.between = 0.3;
  style.clearance = 0.3;  // a fraction is as high as two lines
  style.width = width;
  // Symbols without a colour of their own are as quiet as the rest.
  std::vector<MathSymbol> symbols = symbols_;
  for (MathSymbol& symbol : symbols)
    if (symbol.color == colors_of(theme_).ink) symbol.color = style.color;
  style.symbols = &symbols;
  constexpr int kMostTries = 4;
  for (int i = 0;; ++i) {
    auto list = set_text(text, style, renderer_.fonts());
    if (!list) return failure(list.error().front().message);
    if (list->width <= width || i == kMostTries) return std::move(list).value();
    style.size *= std::max(0.5, 0.99 * width / list->width);
  }
}

LessonTexts::Picture LessonTexts::drawn(const RichText& text, TextInk ink, int width) {
  ++count_;
  Picture picture;
  Result<DisplayList> list = set(with_numbers(text), ink, width);
  if (!list) return picture;
  const double ascent = std::round(std::max(list->ascent, kAscent * em_));
  picture.width = width;
  picture.height = ascent + std::round(std::max(list->depth, kDepth * em_));
  const Size size{width + 2 * static_cast<int>(kMargin),
                  static_cast<int>(picture.height) + 2 * static_cast<int>(kMargin)};
  Sheet sheet;
  sheet.texts.push_back({.list = std::move(list).value(), .at = {kMargin, kMargin + ascent}});
  auto pixels = Framebuffer::create(gl_, size, 0);
  if (!pixels) return picture;
  const Background nothing{Background::Kind::transparent, {}};
  if (renderer_.paint(sheet, {}, nothing, *pixels)) picture.pixels = std::move(pixels).value();
  return picture;
}

LessonTexts::Picture& LessonTexts::picture_of(const RichText& text, TextInk ink, int width) {
  Key key{name_of(text), ink, width};
  auto found = pictures_.find(key);
  if (found == pictures_.end()) found = pictures_.emplace(std::move(key), drawn(text, ink, width)).first;
  found->second.frame = frame_;
  return found->second;
}

namespace {

int room() { return std::max(1, static_cast<int>(ImGui::GetContentRegionAvail().x)); }

}  // namespace

float LessonTexts::height(const RichText& text, TextInk ink) {
  if (text.empty()) return 0;
  const Picture& picture = picture_of(text, ink, room());
  if (picture.pixels) return static_cast<float>(picture.height);
  return ImGui::CalcTextSize(as_written(text).c_str(), nullptr, false, static_cast<float>(room())).y;
}

void LessonTexts::show(const RichText& text, TextInk ink) {
  if (text.empty()) return;
  const Picture& picture = picture_of(text, ink, room());
  if (!picture.pixels) return ImGui::TextWrapped("%s", as_written(text).c_str());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const auto margin = static_cast<float>(kMargin);
  const ImVec2 low{std::round(at.x) - margin, std::round(at.y) - margin};
  const Size size = picture.pixels->size();
  const ImVec2 high{low.x + static_cast<float>(size.width), low.y + static_cast<float>(size.height)};
  // The bottom row of a framebuffer is its first.
  ImGui::GetWindowDrawList()->AddImage(control_texture(picture.pixels->texture()), low, high, {0, 1}, {1, 0});
  ImGui::Dummy({static_cast<float>(picture.width), static_cast<float>(picture.height)});
}

bool LessonTexts::row(const char* id, const RichText& text, TextInk ink) {
  const ImVec2 at = ImGui::GetCursorPos();
  const float above = ImGui::GetStyle().FramePadding.y;
  ImGui::PushID(id);
  const bool is_picked =
      ImGui::Selectable("##row", false, 0, {static_cast<float>(room()), height(text, ink) + 2 * above});
  ImGui::PopID();
  const ImVec2 below = ImGui::GetCursorPos();
  ImGui::SetCursorPos({at.x, at.y + above});
  show(text, ink);
  ImGui::SetCursorPos(below);
  return is_picked;
}

}  // namespace polhode
