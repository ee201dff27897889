// SPDX-License-Identifier: MIT
#include "app/window/controls/widgets.h"
#include "app/window/panels/answer_controls.h"
#include "app/window/panels/panels.h"
#include "app/window/panels/progress_table.h"
#include "base/words/window_words.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace polhode {

namespace {

/// A dot: full where we are, ringed where we were.
void add_mark(ImVec2 at, float em, bool is_here, bool is_visited) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 color = ImGui::GetColorU32(is_here ? ImGuiCol_NavHighlight : ImGuiCol_CheckMark);
  if (is_here || is_visited)
    list.AddCircleFilled(at, (is_here ? 0.3F : 0.22F) * em, color, 20);
  else
    list.AddCircle(at, 0.22F * em, ImGui::GetColorU32(ImGuiCol_TextDisabled), 20, 1.2F);
}

/// The title, on as many lines as it takes, to be clicked.
bool stage_row(const std::string& title, const std::string& number, bool is_here, bool is_visited) {
  const float em = ImGui::GetFontSize(), left = 2.9F * em;
  const float room = ImGui::GetContentRegionAvail().x - left - 0.3F * em;
  const ImVec2 words = ImGui::CalcTextSize(title.c_str(), nullptr, false, room);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = words.y + 0.5F * em;
  const bool chosen = ImGui::Selectable("##stage", is_here, 0, {0, height});
  const float line = at.y + 0.25F * em;
  add_mark({at.x + 0.5F * em, line + 0.5F * em}, em, is_here, is_visited);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText({at.x + 2.4F * em - ImGui::CalcTextSize(number.c_str()).x, line},
               ImGui::GetColorU32(ImGuiCol_TextDisabled), number.c_str());
  list.AddText(ImGui::GetFont(), em, {at.x + left, line}, ImGui::GetColorU32(ImGuiCol_Text), title.c_str(),
               nullptr, room);
  return chosen;
}

/// A place, and below it what stands there.
bool found_row(const std::string& place, const std::string& around, bool is_here) {
  const float em = ImGui::GetFontSize(), left = 0.4F * em;
  const float room = ImGui::GetContentRegionAvail().x - 2 * left;
  const ImVec2 head = ImGui::CalcTextSize(place.c_str(), nullptr, false, room),
               words = ImGui::CalcTextSize(around.c_str(), nullptr, false, room),
               at = ImGui::GetCursorScreenPos();
  const bool chosen = ImGui::Selectable("##found", is_here, 0, {0, head.y + words.y + 0.7F * em});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 first{at.x + left, at.y + 0.2F * em};
  list.AddText(ImGui::GetFont(), em, first, ImGui::GetColorU32(ImGuiCol_Text), place.c_str(), nullptr, room);
  list.AddText(ImGui::GetFont(), em, {first.x, first.y + head.y + 0.1F * em},
               ImGui::GetColorU32(ImGuiCol_TextDisabled), around.c_str(), nullptr, room);
  return chosen;
}

/// The steps of the present stage, as many as fit in a row.
void step_row(PanelContext& context) {
  LessonSession& session = context.session;
  const float em = ImGui::GetFontSize(), width = 1.9F * em;
  const std::size_t steps = session.stage().steps.size();
  if (steps < 2) return;
  const float left = 2.9F * em;
  for (std::size_t i = 0; i < steps; ++i) {
    const bool fits = i > 0 && ImGui::GetItemRectMax().x + width + 0.5F * em <
                                   ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (fits)
      ImGui::SameLine(0, 0.25F * em);
    else
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + left);
    if (button_of_state(fmt::format("{}##step", i + 1).c_str(), i == session.place().step, width))
      session.go_to({session.place().stage, i});
  }
}

}  // namespace

/// To another lesson, and how far one is in each.
void draw_lessons(PanelContext& context) {
  if (context.lessons.size() < 2) return;
  heading(context.said(words::kLessons).c_str());
  for (const LessonProgress& lesson : context.lessons) {
    const bool here = lesson.id == context.session.lesson().id;
    ImGui::PushID(lesson.id.c_str());
    if (here) {
      plain_words(words::kYouAreHereIn.with(context.language(), {lesson.title}));
    } else {
      if (ImGui::Button(context.said(words::kOpen).c_str())) context.requests.open_lesson = lesson.id;
      ImGui::SameLine();
      plain_words(lesson.title);
      if (!context.session.is_presenting())
        quiet_words(words::kSeenAndRight.with(context.language(),
                                              {std::to_string(lesson.seen), std::to_string(lesson.stages),
                                               words_of(lesson.questions, context.language())}));
    }
    ImGui::PopID();
  }
}

/// Which stages are shown to a class: a mark before each while they are chosen.
void OutlinePanel::choose_for_class(PanelContext& context) {
  LessonSession& session = context.session;
  const std::size_t all = session.lesson().stages.size(), chosen = session.chosen_stages().size();
  if (!chooses_) {
    if (chosen < all)
      quiet_words(
          words::kForYourClass.with(context.language(), {std::to_string(chosen), std::to_string(all)}));
    if (ImGui::Button(context.said(words::kChooseForClass).c_str())) chooses_ = true;
    return;
  }
  quiet_words(context.said(words::kWithoutMark));
  if (ImGui::Button(context.said(words::kDone).c_str())) chooses_ = false;
  ImGui::SameLine();
  if (ImGui::Button(context.said(words::kAll).c_str())) session.set_left_out({});
  ImGui::SameLine();
  if (ImGui::Button(context.said(words::kNoMarks).c_str())) {
    std::set<std::string> stages;
    for (const Stage& stage : session.lesson().stages) stages.insert(stage.id);
    session.set_left_out(stages);
  }
}

/// Where the words stand that are typed. Enter goes to the next of these places.
void OutlinePanel::draw_found(PanelContext& context) {
  LessonSession& session = context.session;
  if (found_.empty()) return quiet_words(context.said(words::kNothingFound));
  quiet_words(found_.size() == 1
                  ? context.said(words::kOneStepFound)
                  : words::kStepsFound.with(context.language(), {std::to_string(found_.size())}));
  ImGui::BeginChild("found", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  std::optional<StepPlace> chosen;
  for (const LessonSearch::Found& found : found_) {
    const Stage& stage = session.lesson().stages[found.place.stage];
    std::string title = context.speech.words_of_title(stage);
    if (!title.empty() && title.back() == '.') title.pop_back();
    const bool here = found.place == session.place();
    ImGui::PushID(&found);
    if (found_row(fmt::format("{}.{}  {}", found.place.stage + 1, found.place.step + 1, title), found.around,
                  here))
      chosen = found.place;
    if (here && scrolled_to_ != session.place()) {
      ImGui::SetScrollHereY(0.4F);
      scrolled_to_ = session.place();
    }
    ImGui::PopID();
  }
  ImGui::EndChild();
  if (chosen) session.go_to(*chosen);
}

/// An author's lesson may be another one by now.
void OutlinePanel::find(PanelContext& context) {
  found_.clear();
  if (looked_for_.empty()) return;
  if (searched_ != context.session.loaded_pointer())
    search_ = std::make_unique<LessonSearch>(context.session.lesson(), context.speech);
  searched_ = context.session.loaded_pointer();
  found_ = search_->find(looked_for_);
}

void OutlinePanel::draw(PanelContext& context) {
  LessonSession& session = context.session;
  ImGui::SetNextItemWidth(-1);
  if (context.take_focus && !context.finds) looked_for_.clear();  // it is opened for the stages
  if (std::exchange(context.finds, false)) ImGui::SetKeyboardFocusHere();
  const std::string before = looked_for_;
  const bool entered = ImGui::InputTextWithHint("##find", context.said(words::kFind).c_str(), &looked_for_,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  take_keyboard_by_tab(context);
  tooltip_of_last(told(Command::find));
  if (looked_for_.empty()) show_hint_from_left();
  if (looked_for_ != before || (searched_ && searched_ != session.loaded_pointer())) find(context);
  if (entered) {
    keep_typing(true);
    const auto next = std::find_if(found_.begin(), found_.end(), [&](const LessonSearch::Found& found) {
      return session.place() < found.place;
    });
    if (!found_.empty()) session.go_to(next == found_.end() ? found_.front().place : next->place);
  }
  if (!looked_for_.empty()) return draw_found(context);
  quiet_words(words::kStagesSeen.with(context.language(), {std::to_string(session.visited().size()),
                                                           std::to_string(session.lesson().stages.size())}));
  draw_progress(context);
  choose_for_class(context);
  draw_stages(context);
}

void OutlinePanel::draw_stages(PanelContext& context) {
  constexpr float kLeast = 12;  // em; where there is less all of the panel scrolls, and nothing in it does
  LessonSession& session = context.session;
  const std::vector<Stage>& stages = session.lesson().stages;
  const float em = ImGui::GetFontSize(), room = ImGui::GetContentRegionAvail().y;
  const bool scrolls = room >= kLeast * em;
  if (scrolls) ImGui::BeginChild("stages", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    std::string title = context.speech.words_of_title(stages[i]);
    if (!title.empty() && title.back() == '.') title.pop_back();
    const bool here = i == session.place().stage;
    ImGui::PushID(static_cast<int>(i));
    if (bool is_shown = !session.left_out().contains(stages[i].id); chooses_) {
      if (ImGui::Checkbox("##shown", &is_shown)) session.leave_out(stages[i].id, !is_shown);
      ImGui::SameLine();
    }
    const auto number = session.stage_number(i);
    const std::string count = number ? std::to_string(number->number) : "–";
    if (stage_row(title, count, here, session.visited().contains(stages[i].id))) session.go_to({i, 0});
    if (here) ImGui::SetItemDefaultFocus();
    ImGui::PopID();
    if (!here) continue;
    if (scrolled_to_ != session.place()) {
      ImGui::SetScrollHereY(0.4F);
      scrolled_to_ = session.place();
    }
    step_row(context);
  }
  draw_lessons(context);
  if (scrolls) ImGui::EndChild();
}

}  // namespace polhode
