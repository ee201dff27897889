// SPDX-License-Identifier: MIT
#include "app/window/screen/screen.h"

#include "app/session/answers/answer_keys.h"
#include "app/session/saved/typed_folder.h"
#include "app/window/controls/control_input.h"
#include "app/window/controls/widgets.h"
#include "app/window/screen/figure_marks.h"
#include "app/window/screen/number_sliders.h"
#include "base/words/window_words.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>

namespace polhode {

namespace {

constexpr double kLongestFrame_s = 0.25;  // a window that was stopped does not jump
constexpr double kTipReach = 16;          // px of the display at scale 1: so near the tip of ω is taken
constexpr double kSymbolReach = 4;        // px round the ink of a symbol

double now_s() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Controls grow with the window, half as fast as the page does, and with the text for those who want it
/// large.
double control_scale(const LessonSession& session, const ScreenFrame& frame) {
  const double room = std::min(frame.size.width / 1280.0, frame.size.height / 800.0) / frame.scale;
  return frame.scale * std::clamp(0.5 + 0.5 * room, 1.0, 1.6) *
         std::clamp(session.preferences.text_scale, 0.9, 1.5);
}

/// Where they end below; captions stand there. Infinite: there is none.
float end_of_pictures(const std::vector<Inset>& insets) {
  int lowest = 0;
  for (const Inset& inset : insets) lowest = std::max(lowest, inset.place.y + inset.place.height);
  return lowest > 0 ? static_cast<float>(lowest) : std::numeric_limits<float>::infinity();
}

Size whole(const Region& region) {
  return {std::max(1, static_cast<int>(region.width)), std::max(1, static_cast<int>(region.height))};
}

}  // namespace

Result<std::unique_ptr<Screen>> Screen::create(const GlContext& context, const Fonts& fonts) {
  auto table = Gl::load(context);
  if (!table) return failure(table.error());
  auto renderer = Renderer::create(context, fonts);
  if (!renderer) return failure(renderer.error());
  auto gl = std::make_unique<const Gl>(*table);
  auto controls = ControlPass::create(*gl);
  if (!controls) return failure(controls.error());
  ImGuiContext* imgui = ImGui::CreateContext();
  ImGui::SetCurrentContext(imgui);
  return std::unique_ptr<Screen>(
      new Screen(std::move(gl), std::move(renderer).value(), std::move(controls).value(), imgui));
}

Screen::Screen(std::unique_ptr<const Gl> gl, std::unique_ptr<Renderer> renderer,
               std::unique_ptr<ControlPass> controls, ImGuiContext* imgui)
    : gl_(std::move(gl)),
      renderer_(std::move(renderer)),
      controls_(std::move(controls)),
      imgui_(imgui),
      page_(std::make_unique<PageView>(*gl_, *renderer_)),
      texts_(std::make_unique<LessonTexts>(*gl_, *renderer_)),
      pictures_(std::make_unique<OverlayPictures>(*gl_, *renderer_)) {
  begin_controls();
}

Screen::~Screen() { ImGui::DestroyContext(imgui_); }

std::string Screen::said(const LessonSession& session, const Phrase& phrase) {
  return std::string(phrase.in(session.lesson().about.language));
}

void Screen::adopt_style(const LessonSession& session, const ScreenFrame& frame) {
  const ControlSizes sizes = control_sizes(control_scale(session, frame));
  const Theme theme = session.preferences.theme;
  if (sizes_ != sizes) {
    load_control_fonts(sizes, renderer_->fonts());
    controls_->load_fonts();
  }
  if (sizes_ != sizes || theme_ != theme) set_control_style(theme, sizes);
  sizes_ = sizes;
  theme_ = theme;
  if (spoken_ != &session.lesson()) {
    speech_ = std::make_unique<SpeechText>(session.lesson());
    spoken_ = &session.lesson();
  }
}

/// Where so little of the figure would be left beside it that one sees nothing, it takes the figure's whole
/// side, as the last frame had it; but that of the questions gives way to a motion that answers one, while it
/// plays.
float Screen::panel_width(const LessonSession& session, Size size) const {
  const auto width = static_cast<float>(size.width);
  if (session.panel == Panel::none) return 0;
  if (session.panel == Panel::lessons) return width;
  const float wished = std::min(sizes_->panel, std::round(0.45F * width));
  const Page& page = page_->page();
  const auto text = static_cast<float>(page.meters.x0);  // its end, with the gutter
  const bool is_beside = session.has_scene() && !session.is_enlarged() && page.ceiling <= 0 && text > 0;
  const bool leaves_nothing = width - wished - text < static_cast<float>(page.least_figure);
  if (!is_beside || !leaves_nothing || text >= 0.8F * width) return wished;
  const bool gives_way = session.panel == Panel::question && session.is_playing() && awaits_answer(session);
  return gives_way ? 0 : width - text;
}

/// What the bar leaves. A panel lies over the figure's side: nothing of the text moves.
Region Screen::page_region(const LessonSession& session, Size size) const {
  Region region{0, 0, static_cast<float>(size.width), static_cast<float>(size.height)};
  if (!session.is_presenting())
    region.height -= bar_height(*sizes_, region.width, session.lesson().about.language);
  return region;
}

/// Where the figure is above the text a panel is as high as the figure, as the last frame had it.
float Screen::panel_height(const LessonSession& session, const Region& page) const {
  constexpr float kLeast = 14;  // em
  const auto ceiling = static_cast<float>(page_->page().ceiling);
  if (session.panel == Panel::lessons)  // what is told stands below the list
    return page.height - notices_.height(page, sizes_->padding, clock_s_);
  if (!session.has_scene() || stands_side_by_side(whole(page)) || ceiling <= 0) return page.height;
  return std::min(page.height, std::max(ceiling, kLeast * sizes_->em));
}

/// What of the page a panel lies over.
float Screen::covered_width(const LessonSession& session, Size size) const {
  if (session.panel == Panel::lessons) return 0;  // over all of it, for a moment
  const Region page = page_region(session, size);
  return std::max(0.0F, page.width - (static_cast<float>(size.width) - panel_width(session, size)));
}

Status Screen::draw(LessonSession& session, const ScreenFrame& frame) {
  const double begun_s = now_s();
  ImGui::SetCurrentContext(imgui_);
  clock_s_ += frame.seconds;
  if (frozen_ && !session.is_frozen() && !session.has_speaker()) go_back_to_frozen(session);
  session.advance(was_moving_ ? std::min(frame.seconds, kLongestFrame_s) : 0);  // rest is no time that passes
  adopt_style(session, frame);
  if (shown_place_ != session.place()) {
    if (shown_place_ && session.panel == Panel::lessons)
      session.panel = Panel::none;  // it would hide the place
    shown_place_ = session.place();
    pointer_is_left_ = step_is_new_ = true;
    symbols_.forget(session);
    held_back_.reset();
    choice_in_focus_.reset();
    has_menu_ = false;  // what it offers is of the step before, and so is what was told
    take_number(session);
    if (!notices_.is_new()) tell("");
  }
  forget_what_is_over(session);
  notices_.begin_frame(clock_s_);
  if (session.is_black()) has_menu_ = false;  // nothing of it is seen
  stage_title_ = speech_->words_of_title(session.stage());
  if (!stage_title_.empty() && stage_title_.back() == '.') stage_title_.pop_back();
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(frame.size.width), static_cast<float>(frame.size.height)};
  io.DeltaTime = std::max(1e-4F, static_cast<float>(frame.seconds));
  ImGui::NewFrame();
  let_enter_press();
  type_ahead(session);
  if (io.MouseClicked[0]) session.begin_change();
  if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) {
    pointed_s_ = clock_s_;
    pointer_is_left_ = step_is_new_ = false;
  }
  pointer_is_left_ = pointer_is_left_ || io.MouseClicked[0];
  if (pointer_is_left_) hold_back_tooltips();
  frames_of_tooltip_ = clock_s_ > pointed_s_ + kTooltipDelay_s ? frames_of_tooltip_ + 1 : 0;
  lay_out_controls(session, page_region(session, frame.size), frame.size);
  if (std::exchange(requests_.next_step, false) && !holds_back(session, false))
    do_command(session, Command::next_step);
  lay_out_sliders(session);
  use_pointer(session, page_region(session, frame.size));
  if (!requests_.clipboard.empty()) copy(session);
  if (requests_.save_as) save(session);
  if (!requests_.slides.empty()) name_slides(session);
  symbols_.draw_note(session, *page_, sizes_->em);
  if (!session.has_speaker() && !session.is_black())
    draw_notices(above_chip(region_of_notices(session, frame.size)), sizes_->padding);
  if (!session.is_black()) draw_scroll_marks(session);
  draw_invitation(session);
  draw_spot(session);
  ImGui::Render();

  if (!picture_ || picture_->size() != frame.size) {
    picture_.reset();
    auto made = Framebuffer::create(*gl_, frame.size, 0);
    if (!made) return failure(made.error());
    picture_ = std::move(made).value();
  }
  const bool is_dragging =
      (drag_.is_held() || plots_.is_held() || varies_) && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0);
  const bool moving = session.is_moving() || is_dragging;
  const double resolution = moving ? pace_.resolution() : 1.0;
  const auto painted = show_page(session, page_region(session, frame.size), frame.scale, resolution);
  if (!painted) return failure(painted.error());
  controls_->draw(*ImGui::GetDrawData(), *picture_);
  if (Status kept = keep_for_audience(session); !kept) return kept;
  gl_->Finish();
  frame_s_ = now_s() - begun_s;
  if (*painted) page_s_ = frame_s_;
  if (*painted && moving) pace_.drew(frame_s_);
  is_full_ = resolution == 1.0;
  was_moving_ = session.is_moving();
  return success();
}

/// As it is when it is frozen, before anything else is shown.
Status Screen::keep_for_audience(const LessonSession& session) {
  is_black_ = session.is_black();
  if (!session.is_frozen()) frozen_.reset();
  if (!session.is_frozen() || frozen_) return success();
  auto made = Framebuffer::create(*gl_, picture_->size(), 0);
  if (!made) return failure(made.error());
  frozen_ = std::move(made).value();
  picture_->copy_to(*frozen_, 0, 0);
  seen_ = {session.place(), session.edits(), session.t_s(), session.is_enlarged()};
  return success();
}

/// Who closes the speaker's window, or ends the talk, while the page is frozen has not released it: where he
/// looked was for him alone, and the audience goes on seeing what it saw, at rest.
void Screen::go_back_to_frozen(LessonSession& session) {
  session.panel = Panel::none;
  session.go_to(seen_.place);
  session.begin_change();
  // It was possible before; of a lesson that was changed meanwhile it may not be.
  if (session.edits() != seen_.edits) static_cast<void>(session.set_edits(seen_.edits));
  session.set_enlarged(seen_.is_enlarged);
  if (!session.has_scene()) return;
  session.set_playing(false);
  session.scrub_to(seen_.t_s);
}

/// A notice that is not true any more does not stay for the rest of its time.
void Screen::forget_what_is_over(const LessonSession& session) {
  if (!session.is_presenting()) take_number(session);
  const std::string& told = notices_.told();
  if (!notices_.seconds_left(clock_s_)) {
    digits_.clear();  // who no longer reads what Enter does has not typed it
    return;
  }
  const auto is = [&](const Phrase& phrase) { return told == said(session, phrase); };
  const bool is_held =
      held_back_ == session.place() && !session.is_presenting() && has_open_prediction(session);
  const bool is_of_talk =
      is(words::kHowToPresent) || is(words::kPresenting) || is(words::kPresentingWithSpeaker);
  if ((is(words::kAnswerFirst) && !is_held) || (is_of_talk && !session.is_presenting()) ||
      (is(words::kNoPanelIsOpen) && session.panel != Panel::none) ||
      (is(words::kLettersAreNoCommands) && session.preferences.letter_keys) ||
      (idle_ && why_idle(session, *idle_) != told))
    tell("");
}

/// At the lower edge of what a panel leaves of the page, but where there is a figure beside the text, or
/// above it, and above the caption. Where a panel leaves too little beside the text it is at the panel's
/// foot.
Region Screen::region_of_notices(const LessonSession& session, Size size) const {
  constexpr float kLeast = 10;  // em
  Region region = page_region(session, size);
  const float covered = covered_width(session, size), whole = region.width;
  region.width -= covered;
  const Page& page = page_->page();
  if (!session.has_scene() || session.panel == Panel::lessons) return region;
  const float pictures = end_of_pictures(page_->insets());
  if (page.ceiling > 0) {
    region.height = std::min({region.height, static_cast<float>(page.ceiling), pictures});
    return region;
  }
  const float text = std::min(static_cast<float>(page.column.x1) + 2 * sizes_->em,
                              static_cast<float>(std::max(page.column.x1, page.meters.x0)));
  region.x = text;
  region.width -= text;
  if (covered > 0 && region.width < kLeast * sizes_->em)
    region.width = whole - text;
  else
    region.height = std::min(region.height, pictures);
  return region;
}

/// What is told covers no button of a changed scene.
Region Screen::above_chip(Region region) const {
  const Region& chip = chip_.box;
  const float strip = notices_.height(region, sizes_->padding, clock_s_), end = region.y + region.height;
  const bool is_beside = chip.x + chip.width <= region.x || chip.x >= region.x + region.width;
  const bool is_clear = chip.y + chip.height <= end - strip || chip.y >= end;
  const bool has_room_above = chip.y - region.y >= strip;
  if (chip.width > 0 && !is_beside && !is_clear && has_room_above) region.height = chip.y - region.y;
  return region;
}

void Screen::draw_notices(const Region& region, float padding) const {
  notices_.draw(region, *theme_, padding, clock_s_);
}

Result<bool> Screen::show_page(LessonSession& session, const Region& region, double scale,
                               double resolution) {
  const PageLook look{.size = whole(region),
                      .scale = scale,
                      .focus = symbols_.place(),
                      .resolution = resolution,
                      .keep_text = drag_.holds_omega() || varies_,
                      .holds_frame = panels_.is_held() && !session.is_following(),
                      .covered = covered_width(session, picture_->size()),
                      .is_enlarged = session.is_enlarged()};
  auto painted = page_->show(session, look);
  notices_.set_page_error(painted ? "" : painted.error());
  picture_->bind();
  const ImVec4& ground =
      session.is_black() ? ImVec4{0, 0, 0, 1} : ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
  gl_->ClearColor(ground.x, ground.y, ground.z, 1);
  gl_->Clear(GL_COLOR_BUFFER_BIT);
  if (session.is_black()) return painted ? *painted : true;
  if (painted) page_->picture().copy_to(*picture_, 0, picture_->size().height - look.size.height);
  return painted ? *painted : true;
}

void Screen::lay_out_controls(LessonSession& session, const Region& page, Size size) {
  const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
  PanelContext context{
      .session = session,
      .speech = *speech_,
      .texts = *texts_,
      .pictures = *pictures_,
      .sizes = *sizes_,
      .requests = requests_,
      .frame_ms = 1e3 * page_s_,
      .clock_s = clock_s_,
      .lessons = lessons_,
      .take_focus = std::exchange(panel_takes_focus_, false) || requests_.type_answer || requests_.find,
      .finds = std::exchange(requests_.find, false),
      .typed_to = std::exchange(requests_.type_answer_to, nullptr)};
  requests_.type_answer = false;
  const bool lists_lessons =
      session.panel == Panel::outline || session.panel == Panel::question || session.panel == Panel::lessons;
  if (lists_lessons && find_lessons_) lessons_ = std::exchange(find_lessons_, nullptr)();
  panels_.begin_frame();
  pictures_->begin_frame();
  texts_->begin_frame(session.lesson(), session.step(), session.preferences.theme, sizes_->em);
  if (session.is_black()) return;
  const float panel = panel_width(session, size);
  if (panel > 0) panels_.draw(context, {width - panel, 0, panel, panel_height(session, page)});
  if (session.is_presenting()) return;
  draw_bar(context, {0, page.height, width, height - page.height});
}

/// On the figure as the last frame had it: the first has none yet.
void Screen::lay_out_sliders(LessonSession& session) {
  varies_ = false;
  chip_.box = {};
  const PixelBox& at = page_->page().figure;
  if (session.is_black() || session.panel == Panel::lessons || at.width() <= 0) return;
  // What of it is beside a panel, if that is enough: what lies on the figure is covered with it, and never
  // lies on the text.
  constexpr float kRoomOfButton = 7, kRoomOfAll = 13;  // em
  const ImVec2& size = ImGui::GetIO().DisplaySize;
  const float free = page_region(session, {static_cast<int>(size.x), static_cast<int>(size.y)}).width -
                     covered_width(session, {static_cast<int>(size.x), static_cast<int>(size.y)});
  const float right = std::min(static_cast<float>(at.x1), free), left = static_cast<float>(at.x0);
  const TipHand hand = drag_.scales_omega()      ? TipHand::scales
                       : drag_.is_short()        ? TipHand::short_of
                       : drag_.holds_omega()     ? TipHand::turns
                       : drag_.is_near_omega()   ? TipHand::near
                       : drag_.is_near_untaken() ? TipHand::untaken
                                                 : TipHand::away;
  AroundTip around{.room = {at.x0, at.y0, static_cast<double>(right), at.y1}, .place = &place_at_tip_};
  if (hand == TipHand::away) place_at_tip_ = 0;
  if (hand != TipHand::away || (is_to_be_dragged(session) && !session.is_moving()))
    around.names = page_->type_beside_text();
  draw_drag_marks(session, page_->insets(), hand, around, *sizes_);
  if (right - left < kRoomOfButton * sizes_->em) return;
  const auto top = static_cast<float>(at.y0),
             end = std::min(static_cast<float>(at.y1), end_of_pictures(page_->insets()));
  const Region figure{left, top, right - left, end - top};
  draw_size_chip(session, page_->has_small_type(), figure, *sizes_);
  if (figure.width < kRoomOfAll * sizes_->em) return;
  const SlidersUsed used = draw_number_sliders(session, figure, *sizes_);
  varies_ = used.is_held;
  if (!used.refusal.empty()) tell(used.refusal);
  if (!session.is_presenting())  // the speaker's window has it
    draw_scene_chip(session, page_->insets(),
                    session.is_moving() ? std::vector<PixelBox>() : page_->type_beside_text(),
                    drag_.holds_omega(), figure, *sizes_, chip_);
}

/// On the page, or in a figure that rests: while it moves its names do, too.
std::optional<PageSymbol> Screen::pointed_symbol(const LessonSession& session,
                                                 std::optional<std::size_t> under) const {
  const ImGuiIO& io = ImGui::GetIO();
  if (drag_.is_held() || io.MouseDown[0]) return std::nullopt;
  if (under) return page_->symbols()[*under];
  if (io.WantCaptureMouse || session.is_moving() || drag_.is_near_omega()) return std::nullopt;
  return page_->figure_name_at(session, {io.MousePos.x, io.MousePos.y}, kSymbolReach);
}

void Screen::use_pointer(LessonSession& session, const Region& page) {
  if (session.is_black() || session.is_frozen()) return;  // nobody sees what would be pointed at
  const ImGuiIO& io = ImGui::GetIO();
  const bool on_page = io.MousePos.x >= 0 && io.MousePos.y >= 0 && io.MousePos.x < page.width &&
                       io.MousePos.y < page.height && !io.WantCaptureMouse;
  const auto under =
      on_page ? page_->symbol_under({io.MousePos.x, io.MousePos.y}, kSymbolReach) : std::nullopt;
  draw_page_menu(session, on_page, under);
  symbols_.point_at(session, page_->symbols(), step_is_new_ ? std::nullopt : pointed_symbol(session, under));
  if (under && io.MouseClicked[0] && follow(session, page_->symbols()[*under].name)) return;
  if (on_page) scroll_by_wheel();
  if (on_page && io.MouseClicked[0] && !under) {
    ImGui::SetWindowFocus(nullptr);
    symbols_.leave(session);
    choice_in_focus_.reset();
  }
  if (use_questions(session, on_page)) return;
  if (!drag_.is_held() && plots_.use_mouse(session, page_->page().plots, on_page && !under, *sizes_)) return;
  if (walks_by_click(session, {io.MousePos.x, io.MousePos.y}, on_page && !under)) return;
  if (!drag_.is_held() && !on_page) return;
  const std::string refusal =
      drag_.use_mouse(session, page_->insets(), on_page, kTipReach * sizes_->em / 15.0);
  if (!refusal.empty()) tell(refusal);
}

/// Goes where a link of the lesson leads; the address of another is copied. False: there is nothing to
/// follow.
bool Screen::follow(LessonSession& session, const std::string& link) {
  if (const auto place = target_of(session.lesson(), link)) {
    session.go_to(*place);
    return true;
  }
  if (link.find("://") == link.npos) return false;
  requests_.clipboard = link;
  return true;
}

/// What is pointed at is lit in the window alone.
void Screen::save(LessonSession& session) {
  const std::string lit = session.lit();
  session.light("");
  const Result<std::filesystem::path> folder = typed_folder(panels_.save().folder);
  if (!folder) tell("not saved: " + folder.error());
  if (folder) {
    const auto path = save_as(session, *requests_.save_as, panels_.save().options, *folder, *renderer_);
    std::error_code unknown;
    const auto real = path ? std::filesystem::canonical(*path, unknown) : "";
    tell(path ? words::kSavedAs.with(session.lesson().about.language, {(unknown ? *path : real).string()})
              : "not saved: " + path.error());
  }
  session.light(lit);
  requests_.save_as.reset();
}

/// What is to be made is made beside the window, which goes on.
void Screen::name_slides(const LessonSession& session) {
  const std::string ending = std::exchange(requests_.slides, "");
  const Result<std::filesystem::path> folder = typed_folder(panels_.save().folder);
  if (folder)
    requests_.slides_file = slides_path(session, *folder, ending);
  else
    tell("not saved: " + folder.error());
}

std::string Screen::words_of_step(const LessonSession& session) const {
  const int step = static_cast<int>(session.place().step) + 1;
  return stage_title_ + "\n\n" + speech_->words_of_page(session.stage(), step, step) + "\n";
}

/// An equation as TeX, the rest as it is said.
std::string Screen::words_of_block(const Block& block) const {
  return std::visit(
      [&](const auto& part) -> std::string {
        using Part = std::decay_t<decltype(part)>;
        if constexpr (std::is_same_v<Part, Equation>)
          return part.tex;
        else if constexpr (std::is_same_v<Part, Prose> || std::is_same_v<Part, Footnote>)
          return speech_->words(part.text);
        else
          return speech_->words(part);
      },
      block);
}

void Screen::copy(const LessonSession& session) {
  ImGui::SetClipboardText(requests_.clipboard.c_str());
  requests_.clipboard.clear();
  tell(said(session, words::kCopied));
}

double Screen::seconds_to_wake(const LessonSession& session) const {
  ImGui::SetCurrentContext(imgui_);
  const bool moving = session.is_moving();
  if (moving || !is_full_ || pictures_->is_waiting()) return 0;
  if (ImGui::GetIO().WantTextInput) return 0.3;  // the caret blinks
  if (const auto seconds = panels_.seconds_to_wake()) return *seconds;
  // Dear ImGui measures a window that is new in a frame in which it does not show it.
  const double to_tooltip_s = pointed_s_ + kTooltipDelay_s + 0.1 - clock_s_;
  if (frames_of_tooltip_ < kSettlingFrames && ImGui::IsAnyItemHovered()) return std::max(0.0, to_tooltip_s);
  if (const auto seconds = notices_.seconds_left(clock_s_)) return *seconds + 0.01;
  return 3600;
}

}  // namespace polhode
