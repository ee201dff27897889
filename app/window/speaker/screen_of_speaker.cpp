// SPDX-License-Identifier: MIT
#include "app/window/speaker/screen_of_speaker.h"

#include "app/session/answers/answer_text.h"
#include "app/session/words/step_words.h"
#include "app/window/controls/widgets.h"
#include "app/window/screen/figure_marks.h"
#include "base/ascii.h"
#include "base/words/edition_words.h"
#include "base/words/page_words.h"
#include "base/words/speaker_words.h"
#include "base/words/window_words.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

namespace polhode {

namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing;

/// "14:05"
std::string time_of_day() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  return fmt::format("{:02}:{:02}", local.tm_hour, local.tm_min);
}

/// "7:05", "1:07:05"
std::string duration_text(double seconds) {
  const auto all = static_cast<long>(seconds);
  const long hours = all / 3600, minutes = all / 60 % 60, rest = all % 60;
  return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, rest)
                   : fmt::format("{}:{:02}", minutes, rest);
}

/// "Step 7 of 238", counted through all stages that are for this class, in the lesson's language. What is
/// passed over has no number.
std::string count_text(const LessonSession& session) {
  std::size_t before = 0, all = 0;
  for (const std::size_t i : session.chosen_stages()) {
    const std::size_t steps = session.lesson().stages[i].steps.size();
    before += i < session.place().stage ? steps : 0;
    all += steps;
  }
  const Language language = session.lesson().about.language;
  if (session.passes_over(session.place().stage))
    return words::kNoneOfChosenSteps.with(language, {std::to_string(all)});
  return capitalized(words::kStepOf.with(
      language, {std::to_string(before + session.place().step + 1), std::to_string(all)}));
}

/// What follows goes on in this row if there is room for it.
void same_line_if_fits(const char* words) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float right = ImGui::GetItemRectMax().x + style.ItemSpacing.x + ImGui::CalcTextSize(words).x +
                      2 * style.FramePadding.x;
  if (right < ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x) ImGui::SameLine();
}

/// Of this shape, as large as the region holds, in its upper left corner.
Region fitted(const Region& region, Size shape) {
  const float scale = std::min(region.width / static_cast<float>(std::max(1, shape.width)),
                               region.height / static_cast<float>(std::max(1, shape.height)));
  return {region.x, region.y, std::floor(scale * static_cast<float>(shape.width)),
          std::floor(scale * static_cast<float>(shape.height))};
}

Size whole(const Region& region) {
  return {std::max(1, static_cast<int>(region.width)), std::max(1, static_cast<int>(region.height))};
}

void begin_area(const char* name, const Region& region) {
  ImGui::SetNextWindowPos({region.x, region.y});
  ImGui::SetNextWindowSize({region.width, region.height});
  ImGui::Begin(name, nullptr, kFixed);
}

}  // namespace

Result<std::unique_ptr<ScreenOfSpeaker>> ScreenOfSpeaker::create(Screen& audience) {
  auto controls = ControlPass::create(audience.gl());
  if (!controls) return failure(controls.error());
  ImGuiContext* imgui = ImGui::CreateContext();
  ImGui::SetCurrentContext(imgui);
  return std::unique_ptr<ScreenOfSpeaker>(new ScreenOfSpeaker(audience, std::move(controls).value(), imgui));
}

/// Where the page's figure is in this window; all of the page where it has none.
Region ScreenOfSpeaker::figure_in(const Region& page) const {
  const Size size = audience_.picture().size();
  const Region shown = fitted(page, size);
  const PixelBox& figure = audience_.page().page().figure;
  if (figure.width() <= 0) return shown;
  const float scale = shown.width / static_cast<float>(size.width);
  return {shown.x + scale * static_cast<float>(figure.x0), shown.y + scale * static_cast<float>(figure.y0),
          scale * static_cast<float>(figure.width()), scale * static_cast<float>(figure.y1 - figure.y0)};
}

ScreenOfSpeaker::ScreenOfSpeaker(Screen& audience, std::unique_ptr<ControlPass> controls, ImGuiContext* imgui)
    : audience_(audience),
      controls_(std::move(controls)),
      imgui_(imgui),
      next_page_(audience.gl(), audience.renderer()),
      texts_(audience.gl(), audience.renderer()) {
  begin_controls();
}

ScreenOfSpeaker::~ScreenOfSpeaker() { ImGui::DestroyContext(imgui_); }

void ScreenOfSpeaker::adopt_style(const LessonSession& session, const ScreenFrame& frame) {
  const ControlSizes sizes = control_sizes(frame.scale);
  const Theme theme = session.preferences.theme;
  if (sizes_ != sizes) {
    load_control_fonts(sizes, audience_.renderer().fonts());
    controls_->load_fonts();
  }
  if (sizes_ != sizes || theme_ != theme) set_control_style(theme, sizes);
  if (sizes_ != sizes) controls_height_.reset();
  sizes_ = sizes;
  theme_ = theme;
}

/// The page takes three fifths of the width, in a high window half of it; below it what is pressed and
/// where we are; beside it what comes next, and what is to be said.
ScreenOfSpeaker::Areas ScreenOfSpeaker::areas_of(Size size) const {
  const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
  const float gap = sizes_->padding, left = std::round((width < height ? 0.5F : 0.6F) * width);
  // In a half of a screen the buttons take a second row, and where we are stands below the time.
  constexpr float kOneRow = 46;  // em; a first guess: the last frame knows how high they are
  const float top = gap + 1.9F * sizes_->em,
              bar = controls_height_.value_or((left < kOneRow * sizes_->em ? 3.2F : 2.0F) * sizes_->bar);
  constexpr float kList = 12;  // em, of the stages
  const float most = std::min(0.62F * height, height - top - bar - kList * sizes_->em);
  const Region room{gap, top, left - 2 * gap, std::max(0.3F * height, most)};
  const Region page = fitted(room, audience_.picture().size());
  const float below = page.y + page.height;
  const Region beside{left + gap, top, width - left - 2 * gap, 0.5F * height};
  const Region next = fitted(beside, audience_.page().picture().size());
  const float under = next.y + next.height + gap;
  return {.page = page,
          .controls = {0, below, left, bar},
          .outline = {0, below + bar, left, std::max(1.0F, height - below - bar)},
          .next = next,
          .notes = {left, under, width - left, std::max(1.0F, height - under)}};
}

void ScreenOfSpeaker::draw_controls(LessonSession& session, const Region& region) {
  begin_area("walk", region);
  const float em = sizes_->em;
  const auto said = [&](const Phrase& phrase) {
    return std::string(phrase.in(session.lesson().about.language));
  };
  ImGui::BeginDisabled(!session.previous_place());
  if (icon_button("back", Icon::back, said(words::kBack), told(Command::previous_step), 4.9F * em))
    session.previous_step();
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(!session.next_place());
  if (icon_button("next", Icon::next, said(words::kNext), told(Command::next_step), 4.9F * em))
    session.next_step();
  ImGui::EndDisabled();
  ImGui::SameLine();
  const bool playing = session.is_playing();
  ImGui::BeginDisabled(!session.has_scene());
  if (icon_button("play", playing ? Icon::pause : Icon::play, "", told(Command::play_pause), 2.1F * em))
    session.set_playing(!playing);
  ImGui::EndDisabled();
  same_line_if_fits(said(words::kBlack).c_str());
  if (toggle_button(said(words::kBlack).c_str(), session.is_black(), told(Command::black)))
    session.set_black(!session.is_black());
  same_line_if_fits(said(words::kSpot).c_str());
  if (toggle_button(said(words::kSpot).c_str(), session.is_pointing(), told(Command::point)))
    session.set_pointing(!session.is_pointing());
  same_line_if_fits(said(words::kFreeze).c_str());
  if (toggle_button(said(words::kFreeze).c_str(), session.is_frozen(), told(Command::freeze)))
    session.set_frozen(!session.is_frozen());
  same_line_if_fits(said(words::kEndOfTalk).c_str());
  if (toggle_button(said(words::kEndOfTalk).c_str(), false, told(Command::leave)))
    session.set_presenting(false);
  draw_clock(session);
  controls_height_ = ImGui::GetCursorPosY() + ImGui::GetStyle().WindowPadding.y;
  ImGui::End();
}

void ScreenOfSpeaker::draw_clock(const LessonSession& session) {
  ImGui::PushFont(bold_control_font());
  const Language language = session.lesson().about.language;
  const std::string elapsed = words::kElapsed.with(language, {duration_text(elapsed_s())});
  ImGui::TextUnformatted((time_of_day() + "   " + elapsed).c_str());
  ImGui::PopFont();
  ImGui::SameLine();
  if (ImGui::SmallButton(std::string(words::kFromZero.in(language)).c_str())) begun_s_ = clock_s_;
  tooltip_of_last(std::string(words::kCountAgain.in(language)));
  const std::string where =
      fmt::format("{}; {}, {}", count_text(session), stage_count(session), step_count(session));
  same_line_if_fits(where.c_str());
  plain_words(where);
}

void ScreenOfSpeaker::draw_outline(LessonSession& session, const Region& region) {
  begin_area("outline", region);
  const std::vector<Stage>& stages = session.lesson().stages;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    std::string title = audience_.speech().words_of_title(stages[i]);
    if (!title.empty() && title.back() == '.') title.pop_back();
    const bool is_here = i == session.place().stage, is_passed = session.passes_over(i);
    if (is_passed) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    const std::string note =
        is_passed ? "   " + std::string(words::kPassedOver.in(session.lesson().about.language)) : "";
    const auto stage = session.stage_number(i);
    const std::string number = stage ? std::to_string(stage->number) : "–";
    if (choice_row(fmt::format("{}   {}{}##{}", number, title, note, i).c_str(), is_here))
      session.go_to({i, 0});
    if (is_passed) ImGui::PopStyleColor();
    if (!is_here || outlined_ == session.place()) continue;
    ImGui::SetScrollHereY(0.3F);
    outlined_ = session.place();
  }
  ImGui::End();
}

/// What the author means to say, what a derivation leaves out on the page, and what is right: none of it is
/// before the audience.
void ScreenOfSpeaker::draw_notes(const LessonSession& session, const Region& region) {
  begin_area("notes", region);
  const Step& step = session.step();
  for (const Callout& note : step.notes) texts_.show(note.text);
  const auto said = [&](const Phrase& phrase) {
    return std::string(phrase.in(session.lesson().about.language));
  };
  if (step.notes.empty()) quiet_words(said(words::kStepHasNoNote));
  for (const Callout* callout : blocks_of<Callout>(step)) {
    if (callout->kind != Callout::Kind::derivation) continue;
    heading(said(words::kDerivationHeading).c_str());
    texts_.show(callout->title);
    texts_.show(callout->text, TextInk::quiet);
  }
  for (const Ask* ask : session.questions()) {
    heading(said(words::kAnswer).c_str());
    if (!ask->derivation) texts_.show(answer_text(session.lesson(), *ask));
    if (ask->derivation)
      for (const WorkedLine& worked : ask->derivation->worked)
        texts_.show(formula_text("\\displaystyle " + worked.line.tex));
  }
  ImGui::End();
}

/// All that the audience sees; the page even while its screen is black.
void ScreenOfSpeaker::show_page(const LessonSession& session, const Region& region) {
  const Framebuffer& shown = session.is_black() ? audience_.page().picture() : audience_.picture();
  const Region at = fitted(region, shown.size());
  shown.copy_to(*picture_, static_cast<int>(at.x),
                picture_->size().height - static_cast<int>(at.y) - whole(at).height, whole(at));
}

/// With the mouse over the page here the spot is at the same place of the audience's.
void ScreenOfSpeaker::point(const LessonSession& session, const Region& page) const {
  const ImVec2& at = ImGui::GetIO().MousePos;
  const double x = (at.x - page.x) / page.width, y = (at.y - page.y) / page.height;
  const bool is_on = session.is_pointing() && x >= 0 && x < 1 && y >= 0 && y < 1;
  audience_.point_from_afar(is_on ? std::optional(Vec2(x, y)) : std::nullopt);
}

/// Its place is left empty where there is none, or where it cannot be set: that is told when it is reached.
void ScreenOfSpeaker::show_next(const LessonSession& session, const Region& region) {
  const auto next = session.next_place();
  if (!next) return;
  if (!next_ || next_->place() != *next || &next_->lesson() != &session.lesson()) {
    next_ = std::make_unique<LessonSession>(session.loaded_pointer(), session.effort());
    next_->go_to(*next);
  }
  next_->set_left_out(session.left_out());  // as it will be before the audience
  next_->set_presenting(session.is_presenting());
  next_->preferences = session.preferences;
  next_->preferences.reduced_motion = true;
  if (!next_page_.show(*next_, {.size = whole(region), .fits = true})) return;
  next_page_.picture().copy_to(*picture_, static_cast<int>(region.x),
                               picture_->size().height - static_cast<int>(region.y) - whole(region).height);
}

Status ScreenOfSpeaker::draw(LessonSession& session, const ScreenFrame& frame) {
  ImGui::SetCurrentContext(imgui_);
  clock_s_ += frame.seconds;
  adopt_style(session, frame);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(frame.size.width), static_cast<float>(frame.size.height)};
  io.DeltaTime = std::max(1e-4F, static_cast<float>(frame.seconds));
  ImGui::NewFrame();
  if (shown_place_ != session.place()) pointer_is_left_ = true;
  shown_place_ = session.place();
  if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) pointer_is_left_ = false;
  pointer_is_left_ = pointer_is_left_ || io.MouseClicked[0];
  if (pointer_is_left_) hold_back_tooltips();
  if (!picture_ || picture_->size() != frame.size) {
    picture_.reset();
    auto made = Framebuffer::create(audience_.gl(), frame.size, 0);
    if (!made) return failure(made.error());
    picture_ = std::move(made).value();
  }
  const Areas areas = areas_of(frame.size);
  texts_.begin_frame(session.lesson(), session.step(), session.preferences.theme, sizes_->em);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const auto label = [&](const Region& below, const Phrase& phrase, ImGuiCol color) {
    const std::string said(phrase.in(session.lesson().about.language));
    list.AddText(bold_control_font(), sizes_->em, {below.x, below.y - 1.5F * sizes_->em},
                 ImGui::GetColorU32(color), said.c_str());
  };
  if (session.is_black())
    label(areas.page, words::kScreenIsBlack, ImGuiCol_NavHighlight);
  else if (session.is_frozen())
    label(areas.page, words::kBeforeYouAlone, ImGuiCol_NavHighlight);
  else
    label(areas.page, words::kBeforeAudience, ImGuiCol_Text);
  // What is not what the audience sees has a frame that one cannot overlook.
  if (session.is_frozen() || session.is_black()) {
    const float width = std::max(3.0F, std::round(0.3F * sizes_->em)), half = 0.5F * width;
    const Region at = fitted(areas.page, audience_.picture().size());
    list.AddRect({at.x - half, at.y - half}, {at.x + at.width + half, at.y + at.height + half},
                 ImGui::GetColorU32(ImGuiCol_NavHighlight), 0, 0, width);
  }
  ChipPlace upper_right;
  draw_scene_chip(session, {}, {}, false, figure_in(areas.page), *sizes_, upper_right);
  label(areas.next, session.next_place() ? words::kComesNext : words::kIsLastStep, ImGuiCol_Text);
  draw_notes(session, areas.notes);
  draw_outline(session, areas.outline);
  draw_controls(session, areas.controls);
  point(session, areas.page);
  // Over the list's last rows: the page is what is spoken about.
  audience_.draw_notices({0, 0, areas.outline.width, areas.outline.y + areas.outline.height},
                         sizes_->padding);
  ImGui::Render();

  picture_->bind();
  const ImVec4& ground = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
  audience_.gl().ClearColor(ground.x, ground.y, ground.z, 1);
  audience_.gl().Clear(GL_COLOR_BUFFER_BIT);
  show_page(session, areas.page);
  show_next(session, areas.next);
  controls_->draw(*ImGui::GetDrawData(), *picture_);
  audience_.gl().Finish();
  return success();
}

double ScreenOfSpeaker::seconds_to_wake() const {
  return std::max(0.01, 1 - std::fmod(clock_s_ - begun_s_, 1.0));
}

}  // namespace polhode
