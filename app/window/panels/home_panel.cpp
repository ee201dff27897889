// SPDX-License-Identifier: MIT
#include "app/session/answers/progress.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"
#include "app/window/panels/progress_table.h"
#include "base/words/window_words.h"

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

std::string about(const LessonProgress& lesson, Language language) {
  std::string outcomes;
  for (const std::string& outcome : lesson.outcomes) outcomes += (outcomes.empty() ? "" : "; ") + outcome;
  return outcomes.empty() ? outcomes : words::kYouLearnTo.with(language, {outcomes});
}

std::string how_far(const LessonProgress& lesson, Language language) {
  const std::string stages = std::to_string(lesson.stages);
  const std::string seen = lesson.at == 0
                               ? words::kNotBegun.with(language, {stages})
                               : words::kStagesSeen.with(language, {std::to_string(lesson.seen), stages});
  const int asked = lesson.questions.asked;
  if (asked == 0) return seen;
  std::string open = open_words(lesson.questions, language);
  if (open.empty())
    open = words::kAllAnsweredRight.in(language);
  else if (lesson.questions.answered == 0)
    open = words::kNoneAnswered.in(language);
  return asked == 1 ? words::kOneQuestion.with(language, {seen, open})
                    : words::kQuestions.with(language, {seen, std::to_string(asked), open});
}

/// Closes the page of lessons, or opens another lesson.
void lesson_row(PanelContext& context, const LessonProgress& lesson, std::size_t number) {
  const bool here = lesson.id == context.session.lesson().id;
  ImGui::PushID(lesson.id.c_str());
  heading(fmt::format("{}  {}", number, lesson.title).c_str());
  quiet_words(about(lesson, context.language()));
  if (!context.session.is_presenting()) plain_words(how_far(lesson, context.language()));
  const std::string words = lesson.at == 0
                                ? context.said(words::kBegin)
                                : words::kGoOnAt.with(context.language(), {std::to_string(lesson.at)});
  if (ImGui::Button((words + "###open").c_str())) {
    context.session.panel = Panel::none;
    if (!here) context.requests.open_lesson = lesson.id;
  }
  if (here && context.session.next_place())
    ImGui::SetItemDefaultFocus();  // at the end the next lesson has it
  if (here && lesson.at != 0) {
    ImGui::SameLine();
    ImGui::TextDisabled("%s", context.said(words::kYouAreHere).c_str());
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
  if (!is_begun(session)) quiet_words(context.said(words::kHowToChoose));
  if (is_end) draw_summary(context);
  for (std::size_t i = 0; i < context.lessons.size(); ++i)
    lesson_row(context, as_it_is(context.lessons[i], session), i + 1);
  if (context.lessons.empty()) quiet_words(context.said(words::kNoOtherLesson));
  ImGui::EndTable();
}

}  // namespace polhode
