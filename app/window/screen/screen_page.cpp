// SPDX-License-Identifier: MIT
// What the screen lays over the page, and what a pointer does to its text: choices, scrolling, how to begin.
#include "app/session/answers/answer_text.h"
#include "app/session/words/step_words.h"
#include "app/window/controls/control_style.h"
#include "app/window/screen/screen.h"
#include "base/words/page_words.h"
#include "base/words/window_words.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

namespace polhode {

/// Of questions that are still open, in their order.
std::vector<const Page::Choice*> Screen::open_choices(const LessonSession& session) const {
  const std::vector<const Ask*> asked = session.questions();
  std::vector<const Page::Choice*> open;
  for (const Page::Choice& choice : page_->page().choices) {
    if (std::find(asked.begin(), asked.end(), choice.ask) == asked.end()) continue;  // the page before
    const JudgedAnswer* judged = session.judged(*choice.ask);
    const bool is_right = judged != nullptr && judged->judgement.mark == AnswerJudgement::Mark::right;
    if (!is_right && !session.is_awaited(*choice.ask)) open.push_back(&choice);
  }
  return open;
}

const Page::Choice* Screen::choice_at(const LessonSession& session, const Vec2& at) const {
  if (at.y() < page_->page().ceiling) return nullptr;  // scrolled away under the figure
  for (const Page::Choice* choice : open_choices(session)) {
    const PixelBox& box = choice->box;
    if (at.x() >= box.x0 && at.x() < box.x1 && at.y() >= box.y0 && at.y() < box.y1) return choice;
  }
  return nullptr;
}

namespace {

/// Of what is read first in the box, in the column.
double first_baseline(const Page& page, const PixelBox& box) {
  for (std::size_t i = 0; i < page.column_texts; ++i) {
    const PlacedType& text = page.sheet.texts[i];
    for (const Glyph& glyph : text.list.glyphs)
      if (const Vec2 at = text.at + Vec2(glyph.x, glyph.y); box.contains(at)) return at.y();
  }
  return box.y1;
}

}  // namespace

void Screen::pick(LessonSession& session, const Page::Choice& choice) {
  session.panel = Panel::question;  // where the reply stands
  session.answer(*choice.ask, std::string(1, letter_of_choice(choice.number)));
}

namespace {

/// Whether the question was answered right, now or when one was here before. An audience sees it fresh.
bool is_answered_right(const LessonSession& session, const Ask& ask) {
  if (session.is_awaited(ask)) return false;
  if (const JudgedAnswer* judged = session.judged(ask))
    return judged->judgement.mark == AnswerJudgement::Mark::right;
  const AnswerRecord* record = session.record(ask);
  return !session.is_presenting() && record != nullptr && record->right > 0;
}

/// Of the choice that was picked, now or when one was here before, whether it is right; nothing of the
/// others.
std::optional<bool> mark_of(const LessonSession& session, const Page::Choice& choice) {
  if (session.is_awaited(*choice.ask)) return std::nullopt;
  const bool is_right = is_answered_right(session, *choice.ask);
  if (const JudgedAnswer* judged = session.judged(*choice.ask))
    return judged->judgement.choice == static_cast<int>(choice.number) + 1 ? std::optional(is_right)
                                                                           : std::nullopt;
  const bool is_known =
      is_right && choice_named(*choice.ask, session.record(*choice.ask)->accepted) == choice.number;
  return is_known ? std::optional(true) : std::nullopt;
}

}  // namespace

/// A frame round the one that a click would pick, and a bolder one round the one that Enter would; beside the
/// one that was picked whether it is right, unless the motion is still to show it.
void Screen::draw_choices(const LessonSession& session, const Page::Choice* pointed_at) const {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float em = sizes_->em;
  const auto corner = [](double x, double y) { return ImVec2(static_cast<float>(x), static_cast<float>(y)); };
  const std::vector<const Ask*> asked = session.questions();
  const std::vector<const Page::Choice*> open = open_choices(session);
  const Page::Choice* reached =
      choice_in_focus_ && *choice_in_focus_ < open.size() ? open[*choice_in_focus_] : nullptr;
  for (const Page::Choice& choice : page_->page().choices) {
    if (std::find(asked.begin(), asked.end(), choice.ask) == asked.end()) continue;
    const PixelBox& box = choice.box;
    if (box.y0 < page_->page().ceiling) continue;
    if (&choice == pointed_at) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (&choice == pointed_at || &choice == reached) {
      const double aside = static_cast<double>(0.35F * em),
                   below = 0.12 * (box.y1 - box.y0);  // clear of the type
      list.AddRect(corner(box.x0 - aside, box.y0 + below), corner(box.x1, box.y1 + below),
                   ImGui::GetColorU32(&choice == reached ? ImGuiCol_NavHighlight : ImGuiCol_CheckMark),
                   0.3F * em, 0, (&choice == reached ? 0.16F : 0.1F) * em);
    }
    if (const auto is_right = mark_of(session, choice))
      draw_mark_beside(session, box, first_baseline(page_->page(), box), *is_right);
  }
}

void Screen::draw_mark_beside(const LessonSession& session, const PixelBox& box, double baseline,
                              bool is_right) const {
  const float em = sizes_->em;
  const Phrase& phrase = is_right ? words::kMarkedRight : words::kMarkedNotRight;
  const std::string word(phrase.in(session.lesson().about.language));
  const double left = box.x0 - 0.9 * page_->page().scale * em - ImGui::CalcTextSize(word.c_str()).x;
  ImGui::GetBackgroundDrawList()->AddText(
      {static_cast<float>(left), static_cast<float>(baseline - control_baseline(em))},
      ImGui::GetColorU32(is_right ? ImGuiCol_PlotLines : ImGuiCol_NavHighlight), word.c_str());
}

/// Below the word "Question", which stands beside the first line. The lines of a derivation have marks of
/// their own.
void Screen::draw_answered(const LessonSession& session) const {
  const std::vector<const Ask*> asked = session.questions();
  for (const Page::OpenQuestion& question : page_->page().open_questions) {
    const bool is_of_step = std::find(asked.begin(), asked.end(), question.ask) != asked.end();
    if (!is_of_step || question.ask->derivation || !is_answered_right(session, *question.ask)) continue;
    const double line = first_baseline(page_->page(), question.box) + 1.5 * static_cast<double>(sizes_->em);
    if (line > page_->page().ceiling + static_cast<double>(sizes_->em))
      draw_mark_beside(session, question.box, line, true);
  }
}

/// Of the present step's, not of the page before.
const Page::OpenQuestion* Screen::question_at(const LessonSession& session, const Vec2& at) const {
  if (at.y() < page_->page().ceiling) return nullptr;
  const std::vector<const Ask*> asked = session.questions();
  for (const Page::OpenQuestion& question : page_->page().open_questions) {
    const PixelBox& box = question.box;
    const bool is_in = at.x() >= box.x0 && at.x() < box.x1 && at.y() >= box.y0 && at.y() < box.y1;
    if (is_in && std::find(asked.begin(), asked.end(), question.ask) != asked.end()) return &question;
  }
  return nullptr;
}

/// A click on a choice picks it, one on another question leads to where it is answered. True: it did.
bool Screen::use_questions(LessonSession& session, bool on_page) {
  const ImGuiIO& io = ImGui::GetIO();
  const Vec2 at(io.MousePos.x, io.MousePos.y);
  const Page::Choice* choice = on_page ? choice_at(session, at) : nullptr;
  draw_choices(session, choice);
  draw_answered(session);
  const Page::OpenQuestion* question = on_page ? question_at(session, at) : nullptr;
  if (question != nullptr) {
    const PixelBox& box = question->box;
    const double top = std::max(box.y0, page_->page().ceiling);
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    const float left = static_cast<float>(box.x0) - 0.35F * sizes_->em;  // clear of the type
    ImGui::GetBackgroundDrawList()->AddRect(
        {left, static_cast<float>(top)}, {static_cast<float>(box.x1), static_cast<float>(box.y1)},
        ImGui::GetColorU32(ImGuiCol_CheckMark), 0.3F * sizes_->em, 0, 0.1F * sizes_->em);
  }
  if (!io.MouseClicked[0] || (choice == nullptr && question == nullptr)) return false;
  if (choice != nullptr) {
    pick(session, *choice);
  } else {
    session.panel = Panel::question;
    requests_.type_answer = true;
    requests_.type_answer_to = question->ask;
  }
  return true;
}

/// Before an audience a click beside the figure goes on, as everywhere.
bool Screen::walks_by_click(LessonSession& session, const Vec2& at, bool is_free) const {
  if (!session.is_presenting() || !is_free || !ImGui::GetIO().MouseClicked[0]) return false;
  const PixelBox& figure = page_->page().figure;
  const bool on_figure =
      at.x() >= figure.x0 && at.x() < figure.x1 && at.y() >= figure.y0 && at.y() < figure.y1;
  return !on_figure && session.next_step();
}

namespace {

/// Where the text of the column ends; its upper edge where there is none.
double end_of_text(const Page& page) {
  double end = page.column.y0;
  for (std::size_t i = 0; i < page.column_texts; ++i)
    end = std::max(end, page.sheet.texts[i].at.y() + page.sheet.texts[i].list.depth);
  return end;
}

}  // namespace

/// Who has never been here is told how to begin: until something is done, where there is room below the text.
void Screen::draw_invitation(const LessonSession& session) {
  const bool is_new = session.visited().size() == 1 && session.place() == StepPlace{} &&
                      session.edits().empty() && session.answers().empty();
  const bool is_still = session.has_scene() && !session.is_playing() && !session.is_presenting() &&
                        session.panel == Panel::none && session.t_s() == still_time_s(session.lesson_scene());
  const PixelBox& column = page_->page().column;
  if (!is_new || !is_still || page_->page().overflow > 0 || column.width() <= 0) return;
  const std::string words(words::kHowToBegin.in(session.lesson().about.language));
  const auto width = static_cast<float>(column.width());
  const float height = ImGui::CalcTextSize(words.c_str(), nullptr, false, width).y,
              top = static_cast<float>(column.y1) - 0.2F * sizes_->em - height;
  if (top < static_cast<float>(end_of_text(page_->page())) + 0.5F * sizes_->em) return;
  ImGui::GetBackgroundDrawList()->AddText(
      ImGui::GetFont(), ImGui::GetFontSize(), {static_cast<float>(column.x0), top},
      ImGui::GetColorU32(ImGuiCol_TextDisabled), words.c_str(), nullptr, width);
}

/// The mouse's cursor is too small for a hall, and is not seen in the speaker's window: a spot in its place.
void Screen::draw_spot(const LessonSession& session) const {
  if (!session.is_pointing() || session.is_black() || session.is_frozen()) return;
  const ImGuiIO& io = ImGui::GetIO();
  ImVec2 at = io.MousePos;
  if (pointed_from_afar_) {
    at = {static_cast<float>(pointed_from_afar_->x()) * io.DisplaySize.x,
          static_cast<float>(pointed_from_afar_->y()) * io.DisplaySize.y};
  } else {
    if (at.x < 0 || at.y < 0 || at.x >= io.DisplaySize.x || at.y >= io.DisplaySize.y) return;
    ImGui::SetMouseCursor(ImGuiMouseCursor_None);
  }
  const float radius = 0.6F * sizes_->em, rim = 0.14F * sizes_->em;
  constexpr ImU32 kRed = IM_COL32(214, 30, 30, 190), kWhite = IM_COL32(255, 255, 255, 235);
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddCircleFilled(at, radius, kRed, 32);
  list.AddCircle(at, radius + 0.5F * rim, kWhite, 32, rim);
}

/// By the other button of the mouse: what can be done with what is there, and by which key.
void Screen::draw_page_menu(LessonSession& session, bool on_page, std::optional<std::size_t> under) {
  const ImGuiIO& io = ImGui::GetIO();
  const char* const name = "page menu";
  if (on_page && io.MouseClicked[1]) {
    const PixelBox& figure = page_->page().figure;
    const double x = io.MousePos.x, y = io.MousePos.y;
    menu_of_ = under ? page_->symbols()[*under].name : "";
    const Block* block = page_->block_at(session, {x, y});
    menu_words_ = block != nullptr ? words_of_block(*block) : "";
    menu_is_of_equation_ = block != nullptr && std::holds_alternative<Equation>(*block);
    menu_is_of_figure_ = x >= figure.x0 && x < figure.x1 && y >= figure.y0 && y < figure.y1;
    has_menu_ = true;
    ImGui::OpenPopup(name);
  }
  if (!has_menu_) {
    if (ImGui::IsPopupOpen(name)) ImGui::ClosePopupToLevel(0, true);
    return;
  }
  if (!ImGui::BeginPopup(name, ImGuiWindowFlags_NoMove)) {
    has_menu_ = false;
    return;
  }
  if (menu_is_of_figure_)
    offer_of_figure(session);
  else
    offer_of_text(session);
  ImGui::EndPopup();
}

namespace {

bool menu_item(Command command, const char* words, bool is_possible = true) {
  const std::string_view keys = facts_of(command).keys;
  return ImGui::MenuItem(words, std::string(keys.substr(0, keys.find(','))).c_str(), false, is_possible);
}

}  // namespace

void Screen::offer_of_text(LessonSession& session) {
  if (menu_of_.find("://") != menu_of_.npos) {
    if (ImGui::MenuItem("Copy this address")) follow(session, menu_of_);
    ImGui::Separator();
  }
  if (!menu_words_.empty() &&
      ImGui::MenuItem(menu_is_of_equation_ ? "Copy this equation as TeX" : "Copy this paragraph"))
    requests_.clipboard = menu_words_;
  if (menu_item(Command::copy_step, "Copy this step as text")) do_in_window(session, Command::copy_step);
  const std::string tex = tex_of_step(session);
  if (ImGui::MenuItem("Copy its equations as TeX", nullptr, false, !tex.empty())) requests_.clipboard = tex;
  if (menu_item(Command::read_aloud, "Read it aloud")) do_in_window(session, Command::read_aloud);
  if (menu_item(Command::find, "Find…")) do_in_window(session, Command::find);
}

void Screen::offer_of_figure(LessonSession& session) {
  if (menu_item(Command::play_pause, session.is_playing() ? "Pause" : "Play"))
    do_command(session, Command::play_pause);
  if (menu_item(Command::enlarge, session.is_enlarged() ? "Beside the text" : "As large as the page"))
    do_command(session, Command::enlarge);
  if (menu_item(Command::next_view, "Seen from: the next")) do_command(session, Command::next_view);
  if (ImGui::MenuItem("The lesson's camera")) session.set_camera(session.lesson_scene().camera);
  if (menu_item(Command::undo, "Undo", session.can_undo())) do_command(session, Command::undo);
  if (menu_item(Command::redo, "Redo", session.can_redo())) do_command(session, Command::redo);
  if (menu_item(Command::reset_scene, "The lesson's scene", !session.edits().empty()))
    do_command(session, Command::reset_scene);
  if (ImGui::MenuItem("Save the figure")) requests_.save_as = SaveAs::figure;
  if (menu_item(Command::show, "What is shown…")) session.panel = Panel::show;
  if (menu_item(Command::body, "Body and spin…")) session.panel = Panel::body;
}

void Screen::scroll_by_wheel() {
  constexpr float kNotch = 3;  // em
  const ImGuiIO& io = ImGui::GetIO();
  const PixelBox& column = page_->page().column;
  const bool over_text = io.MousePos.x < column.x1 + sizes_->em && io.MousePos.y >= page_->page().ceiling;
  if (io.MouseWheel != 0 && over_text)
    page_->scroll(-static_cast<double>(kNotch * io.MouseWheel * sizes_->em));
}

/// Where the text goes on above the page or below it: a thumb beside it, and a strip above, where the stage
/// and the step are read whose head has gone out of sight.
void Screen::draw_scroll_marks(const LessonSession& session) {
  const Page& page = page_->page();
  if (page.overflow <= 0) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float em = sizes_->em;
  const auto x0 = static_cast<float>(page.column.x0), x1 = static_cast<float>(page.column.x1),
             y0 = static_cast<float>(page.column.y0), y1 = static_cast<float>(page.column.y1);
  const float all = y1 - y0 + static_cast<float>(page.overflow), part = (y1 - y0) / all;
  const float top = y0 + (y1 - y0) * static_cast<float>(page.hidden) / all;
  const float thick = 0.35F * em, figure = static_cast<float>(page.meters.x0);
  const float right = figure > x1 ? std::min(x1 + 1.4F * em, figure - 1.5F * thick) : x1 + 1.4F * em;
  list.AddRectFilled({right, top}, {right + thick, top + (y1 - y0) * part},
                     ImGui::GetColorU32(ImGuiCol_ScrollbarGrab), 0.2F * em);
  if (page.hidden <= 0) return;
  const Color paper = colors_of(*theme_).paper;
  const auto ceiling = static_cast<float>(page.ceiling);
  const float strip = ceiling > 0 ? std::min(2.2F * em, y0 - ceiling) : 2.2F * em, low = ceiling + strip;
  list.AddRectFilled({x0 - 2 * em, ceiling}, {x1 + em, low},
                     ImGui::ColorConvertFloat4ToU32({paper.r, paper.g, paper.b, 1}));
  list.AddLine({x0 - 2 * em, low}, {x1 + em, low}, ImGui::GetColorU32(ImGuiCol_Border));
  const std::string words =
      stage_title_ + "  ·  " +
      words::kStepOf.with(session.lesson().about.language, {std::to_string(session.place().step + 1),
                                                            std::to_string(session.stage().steps.size())});
  list.AddText({x0, ceiling + 0.5F * (strip - em)}, ImGui::GetColorU32(ImGuiCol_TextDisabled), words.c_str());
}

}  // namespace polhode
