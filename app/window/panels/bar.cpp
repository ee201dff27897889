// SPDX-License-Identifier: MIT
#include "app/session/symbol_note.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/panel_context.h"
#include "app/window/panels/panel_facts.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace polhode {

namespace {

constexpr float kNarrow = 74;      // em: below it there are two rows, in English
constexpr float kGermanWords = 8;  // em: what the words of the bar take more in German
constexpr float kTight = 41;       // em: below it buttons have no words that have an icon
constexpr float kVeryTight = 36;   // em: below it single frames have their keys alone
constexpr std::array kSpeeds = {1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0, 2.0, 4.0, 8.0, 16.0};

bool is_narrow(const ControlSizes& sizes, float width, Language language) {
  return width < (kNarrow + (language == Language::de ? kGermanWords : 0)) * sizes.em;
}
bool is_tight(const ControlSizes& sizes, float width) { return width < kTight * sizes.em; }
bool is_very_tight(const ControlSizes& sizes, float width) { return width < kVeryTight * sizes.em; }

/// Of a scene whose motion is shown at `rate` seconds a second where the speed is 1: "real time ÷ 22".
std::string speed_text(double rate, double speed, Language language) {
  const double ratio = rate * speed;
  constexpr double kSame = 0.005;  // of three digits
  if (std::abs(ratio - 1) < kSame) return std::string(words::kRealTime.in(language));
  constexpr double kPlain = 1e4;  // above it as a power of ten
  const double factor = ratio > 1 ? ratio : 1 / ratio;
  const std::string number = factor < kPlain ? fmt::format("{:.3g}", factor) : readable(factor);
  const Phrase& phrase = ratio > 1 ? words::kRealTimeTimes : words::kRealTimeOver;
  return phrase.with(language, {with_decimals(number, language)});
}

void draw_walk(PanelContext& context, bool has_words) {
  LessonSession& session = context.session;
  const float width = (has_words ? 4.9F : 2.1F) * context.sizes.em;
  ImGui::BeginDisabled(!session.previous_place());
  if (icon_button("back", Icon::back, has_words ? context.said(words::kBack) : "",
                  told(Command::previous_step), width))
    session.previous_step();
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(!why_idle(session, Command::next_step).empty());
  if (icon_button("next", Icon::next, has_words ? context.said(words::kNext) : "", told(Command::next_step),
                  width))
    context.requests.next_step = true;
  ImGui::EndDisabled();
}

void draw_speed(LessonSession& session, float width) {
  const double rate = session.model()->rate, real = 1 / rate;
  const auto text = [&](double speed) { return speed_text(rate, speed, session.lesson().about.language); };
  ImGui::SetNextItemWidth(width);
  if (ImGui::BeginCombo("##speed", text(session.speed()).c_str(), ImGuiComboFlags_HeightLarge)) {
    std::vector<double> speeds(kSpeeds.begin(), kSpeeds.end());
    if (real > kSlowest && real < kFastest) speeds.push_back(real);
    std::sort(speeds.begin(), speeds.end());
    for (const double speed : speeds)
      if (choice_row(text(speed).c_str(), speed == session.speed())) session.set_speed(speed);
    ImGui::EndCombo();
  }
  tooltip_of_last("Speed. " + told(Command::faster) + "; " + told(Command::slower));
}

/// `width` is that of all together.
void draw_time(PanelContext& context, float width, bool has_frames) {
  LessonSession& session = context.session;
  const float em = context.sizes.em, gap = ImGui::GetStyle().ItemSpacing.x;
  const float icon = 2.1F * em, number = 5.2F * em, speed = 8.2F * em, close = 0.3F * gap;
  if (icon_button("reset", Icon::reset, "", told(Command::reset_time), icon)) session.reset_time();
  ImGui::SameLine(0, close);
  if (has_frames) {
    if (icon_button("frame back", Icon::frame_back, "", told(Command::frame_back), icon))
      session.step_frames(-1);
    ImGui::SameLine(0, close);
  }
  const bool playing = session.is_playing();
  if (icon_button("play", playing ? Icon::pause : Icon::play, "", told(Command::play_pause), icon))
    session.set_playing(!playing);
  if (has_frames) {
    ImGui::SameLine(0, close);
    if (icon_button("frame forward", Icon::frame_forward, "", told(Command::frame_forward), icon))
      session.step_frames(1);
  }
  ImGui::SameLine();
  const float buttons = has_frames ? 4 * icon + 3 * close : 2 * icon + close;
  const float line = width - buttons - number - speed - 3 * gap;
  if (const auto t = time_line(session.time_line(), session.t_s(), session.shown_flips(),
                               std::max(4 * em, line), context.language())) {
    session.set_playing(false);
    session.scrub_to(*t);
  }
  ImGui::SameLine();
  const float x = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  const double t_s = session.t_s();
  const std::string t = with_decimals(fmt::format("t = {}{:.3f} s", t_s < 0 ? "−" : "", std::abs(t_s)),
                                      session.lesson().about.language);
  ImGui::TextUnformatted(t.c_str());
  ImGui::SameLine(x + number + gap);
  draw_speed(session, speed);
}

/// There is a question to answer, for the first time or again. Whether an answer was right is said in the
/// panel alone, and not before the motion has shown it; a prediction is not made twice.
bool asks_something(const LessonSession& session) {
  const std::vector<const Ask*> questions = session.questions();
  return std::any_of(questions.begin(), questions.end(), [&](const Ask* ask) {
    const AnswerRecord* record = session.record(*ask);
    if (!record || record->tries == 0) return true;
    return record->right == 0 && ask->type != Ask::Type::predict && !session.is_awaited(*ask);
  });
}

/// This step, or one before it in its stage; and the end has its summary there.
bool has_questions(const LessonSession& session) {
  if (!session.next_place()) return true;
  const std::vector<Step>& steps = session.stage().steps;
  return std::any_of(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(session.place().step) + 1,
                     [](const Step& step) { return !blocks_of<Ask>(step).empty(); });
}

/// A dot on the corner of the last item.
void mark_last() {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float size = 0.24F * ImGui::GetFontSize();
  ImGui::GetWindowDrawList()->AddCircleFilled({high.x - size, low.y + size}, size,
                                              ImGui::GetColorU32(ImGuiCol_NavHighlight), 16);
}

void draw_panel_buttons(PanelContext& context) {
  LessonSession& session = context.session;
  bool first = true;
  for (const PanelFacts& facts : kPanels) {
    if (!first) ImGui::SameLine(0, 0.5F * ImGui::GetStyle().ItemSpacing.x);
    first = false;
    const bool is_on = session.panel == facts.panel;
    const bool is_of_questions = facts.panel == Panel::question,
               is_marked = is_of_questions && asks_something(session);
    ImGui::BeginDisabled(is_of_questions && !has_questions(session));
    const std::string tooltip = is_marked ? context.said(words::kQuestionHere) : told(facts.command);
    if (toggle_button(context.said(facts.name).c_str(), is_on, tooltip)) {
      session.panel = is_on ? Panel::none : facts.panel;
      context.requests.type_answer = is_of_questions && !is_on;
    }
    ImGui::EndDisabled();
    if (is_marked) mark_last();
  }
}

float panel_buttons_width(const PanelContext& context) {
  const ImGuiStyle& style = ImGui::GetStyle();
  float width = 0;
  for (const PanelFacts& facts : kPanels)
    width += ImGui::CalcTextSize(context.said(facts.name).c_str()).x + 2 * style.FramePadding.x +
             0.5F * style.ItemSpacing.x;
  return width;
}

}  // namespace

float bar_height(const ControlSizes& sizes, float width, Language language) {
  return is_narrow(sizes, width, language) ? std::round(1.6F * sizes.bar) : sizes.bar;
}

void draw_bar(PanelContext& context, const Region& region) {
  const ImGuiStyle& style = ImGui::GetStyle();
  ImGui::SetNextWindowPos({region.x, region.y});
  ImGui::SetNextWindowSize({region.width, region.height});
  const float frame = ImGui::GetFontSize() + 2 * style.FramePadding.y;
  const bool narrow = is_narrow(context.sizes, region.width, context.language());
  const float above =
      narrow ? 0.5F * (region.height - 2 * frame - style.ItemSpacing.y) : 0.5F * (region.height - frame);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.sizes.padding * 1.4F, std::round(above)));
  ImGui::Begin("bar", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleVar();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRectFullScreen();
  list.AddLine({region.x, region.y + 0.5F}, {region.x + region.width, region.y + 0.5F},
               ImGui::GetColorU32(ImGuiCol_Border));
  list.PopClipRect();
  // Where there are two rows time has one of them, and the panels stand beside Back and Next.
  const float gap = 2 * style.ItemSpacing.x, edge = region.x + region.width - context.sizes.padding * 1.4F;
  const bool has_time = context.session.has_scene();
  if (narrow) {
    if (has_time)
      draw_time(context, edge - ImGui::GetCursorScreenPos().x, !is_very_tight(context.sizes, region.width));
    else
      ImGui::Dummy({1, frame});
    draw_walk(context, !is_tight(context.sizes, region.width));
    ImGui::SameLine(0, gap);
  } else {
    draw_walk(context, true);
    const float left = ImGui::GetItemRectMax().x + gap, right = edge - panel_buttons_width(context) - gap;
    if (has_time) {
      ImGui::SameLine(0, gap);
      draw_time(context, right - left, true);
    }
    ImGui::SameLine(right + gap - region.x);
  }
  // Where there is not room for all, each gives some of its own.
  const float room = edge - ImGui::GetCursorScreenPos().x, lacks = panel_buttons_width(context) - room,
              each = lacks > 0 ? lacks / (2 * static_cast<float>(kPanels.size())) : 0;
  const ImVec2 padding{std::max(2.0F, std::floor(style.FramePadding.x - each)), style.FramePadding.y};
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, padding);
  draw_panel_buttons(context);
  ImGui::PopStyleVar();
  ImGui::End();
}

}  // namespace polhode
