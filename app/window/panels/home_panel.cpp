// SPDX-License-Identifier: MIT
#include "app/session/answers/progress.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"
#include "app/window/panels/progress_table.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

namespace polhode {

namespace {

/// Whoever has done nothing yet but open the lesson has not begun it.
bool is_begun(const LessonSession& session) {
  return session.visited().size() > 1 || session.place() != StepPlace{} || !session.answers().empty() ||
         !session.edits().empty();
}

/// A learner's own numbers are those of the moment, not those of when the list was made.
LessonProgress as_it_is(const LessonProgress& listed, const LessonSession& session) {
  LessonProgress now = listed;
  if (listed.id != session.lesson().id) return now;
  now.seen = session.visited().size();
  now.questions = progress_of(session.lesson(), session.answers()).all;
  now.at = session.place().stage + 1;
  if (!is_begun(session)) now.seen = now.at = 0;
  return now;
}

std::string about(const LessonProgress& lesson) {
  std::string words;
  for (const std::string& outcome : lesson.outcomes)
    words += (words.empty() ? "You learn to " : "; ") + outcome;
  return words.empty() ? words : words + ".";
}

std::string how_far(const LessonProgress& lesson) {
  std::string words = lesson.at == 0 ? fmt::format("{} stages, not begun", lesson.stages)
                                     : fmt::format("{} of {} stages seen", lesson.seen, lesson.stages);
  if (lesson.questions.asked == 0) return words;
  const std::string open = open_words(lesson.questions);
  return fmt::format("{}; {} question{}: {}", words, lesson.questions.asked,
                     lesson.questions.asked == 1 ? "" : "s",
                     open.empty()                     ? "all answered right"
                     : lesson.questions.answered == 0 ? "none answered"
                                                      : open);
}

/// Closes the page of lessons, or opens another lesson.
void lesson_row(PanelContext& context, const LessonProgress& lesson, std::size_t number) {
  const bool here = lesson.id == context.session.lesson().id;
  ImGui::PushID(lesson.id.c_str());
  heading(fmt::format("{}  {}", number, lesson.title).c_str());
  quiet_words(about(lesson));
  plain_words(how_far(lesson));
  const std::string words = lesson.at == 0 ? "Begin" : fmt::format("Go on at stage {}", lesson.at);
  if (ImGui::Button((words + "###open").c_str())) {
    context.session.panel = Panel::none;
    if (!here) context.requests.open_lesson = lesson.id;
  }
  if (here && context.session.next_place())
    ImGui::SetItemDefaultFocus();  // at the end the next lesson has it
  if (here && lesson.at != 0) {
    ImGui::SameLine();
    ImGui::TextDisabled("you are here");
  }
  ImGui::Spacing();
  ImGui::PopID();
}

}  // namespace

void draw_home(PanelContext& context) {
  constexpr float kColumn = 46;  // em: lines as long as one likes to read
  const LessonSession& session = context.session;
  const float room = ImGui::GetContentRegionAvail().x, width = std::min(room, kColumn * ImGui::GetFontSize());
  if (!ImGui::BeginTable("home", 3)) return;
  ImGui::TableSetupColumn("left", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("column", ImGuiTableColumnFlags_WidthFixed, width - 2 * ImGui::GetFontSize());
  ImGui::TableSetupColumn("right", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableNextRow();
  ImGui::TableSetColumnIndex(1);
  const bool is_end = !session.next_place();
  if (!is_begun(session))
    quiet_words("Tab goes from lesson to lesson, Enter opens one, Escape closes this list.");
  if (is_end) draw_summary(context);
  for (std::size_t i = 0; i < context.lessons.size(); ++i)
    lesson_row(context, as_it_is(context.lessons[i], session), i + 1);
  if (context.lessons.empty()) quiet_words("No other lesson was found.");
  ImGui::EndTable();
}

}  // namespace polhode
