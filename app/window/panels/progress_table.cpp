// SPDX-License-Identifier: MIT
#include "app/window/panels/progress_table.h"

#include "app/session/answers/answer_text.h"
#include "app/session/answers/progress.h"
#include "app/window/controls/widgets.h"
#include "base/words/window_words.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace polhode {

namespace {

/// A row: the outcome, on as many lines as it takes, and right/asked behind it.
void outcome_row(const std::string& outcome, const QuestionCount& count) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", outcome.c_str());
  ImGui::TableNextColumn();
  const std::string numbers = fmt::format("{}/{}", count.right, count.asked);
  if (count.right == count.asked)
    right_words(numbers);
  else
    ImGui::TextUnformatted(numbers.c_str());
}

}  // namespace

void draw_progress(const PanelContext& context) {
  if (context.session.is_presenting()) return;
  const Lesson& lesson = context.session.lesson();
  const Progress progress = progress_of(lesson, context.session.answers());
  if (progress.all.asked == 0) return;
  quiet_words(words::kQuestionsRight.with(context.language(), {words_of(progress.all, context.language())}));
  if (!progress.tests_outcomes() || !ImGui::BeginTable("outcomes", 2)) return;
  const std::string numbers = context.said(words::kRightOfAsked);
  ImGui::TableSetupColumn("outcome", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn(numbers.c_str(), ImGuiTableColumnFlags_WidthFixed,
                          ImGui::CalcTextSize(numbers.c_str()).x);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", context.said(words::kOutcome).c_str());
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", numbers.c_str());
  for (std::size_t i = 0; i < progress.outcomes.size(); ++i)
    if (progress.outcomes[i].asked > 0) outcome_row(lesson.about.outcomes[i], progress.outcomes[i]);
  if (progress.others.asked > 0) outcome_row(context.said(words::kOtherQuestions), progress.others);
  ImGui::EndTable();
  ImGui::Spacing();
}

namespace {

/// Stages with such questions, to be clicked. @returns the first of the stage that was
std::optional<StepPlace> stages_of(PanelContext& context, const Phrase& title,
                                   const std::vector<PlacedAsk>& questions) {
  std::optional<StepPlace> chosen;
  if (questions.empty()) return chosen;
  const std::string head = context.said(title);
  heading(head.c_str());
  ImGui::PushID(head.c_str());
  for (std::size_t i = 0; i < questions.size();) {
    const StepPlace first = questions[i].place;
    std::size_t count = 0;
    for (; i < questions.size() && questions[i].place.stage == first.stage; ++i) ++count;
    const Stage& stage = context.session.lesson().stages[first.stage];
    RichText words = opened_by(fmt::format("{}  ", first.stage + 1), stage.title_text);
    if (count > 1)
      words = in_a_row(std::move(words),
                       words_text(words::kSomeQuestions.with(context.language(), {std::to_string(count)})));
    if (context.texts.row(stage.id.c_str(), words)) chosen = first;
  }
  ImGui::PopID();
  return chosen;
}

/// To the lesson behind this one; where that is not found its name is all there is to say.
void go_on_to(PanelContext& context, const std::string& next) {
  const bool is_of_course =
      std::any_of(context.lessons.begin(), context.lessons.end(),
                  [&](const LessonProgress& lesson) { return lesson.next == context.session.lesson().id; });
  if (next.empty()) return plain_words(is_of_course ? context.said(words::kLastLesson) : "");
  const auto found = std::find_if(context.lessons.begin(), context.lessons.end(),
                                  [&](const LessonProgress& lesson) { return lesson.id == next; });
  if (found == context.lessons.end())
    return quiet_words(words::kToGoOn.with(context.language(), {"polhode play " + next}));
  if (ImGui::Button(context.said(words::kToNextLesson).c_str())) context.requests.open_lesson = next;
  if (context.session.panel == Panel::lessons) ImGui::SetItemDefaultFocus();
  ImGui::SameLine();
  plain_words(found->title);
}

}  // namespace

void draw_summary(PanelContext& context) {
  LessonSession& session = context.session;
  heading(context.said(words::kEndOfLesson).c_str());
  go_on_to(context, session.lesson().about.next);
  ImGui::Spacing();
  if (session.is_presenting()) return;
  draw_progress(context);
  const ToRepeat repeat = to_repeat(session.lesson(), session.answers());
  auto chosen = stages_of(context, words::kToRepeat, repeat.wrong);
  if (const auto skipped = stages_of(context, words::kPassedOverQuestions, repeat.skipped)) chosen = skipped;
  if (repeat.wrong.empty() && repeat.skipped.empty() && !questions_of(session.lesson()).empty())
    right_words(context.said(words::kAllRight));
  ImGui::Spacing();
  if (!chosen) return;
  if (session.panel == Panel::lessons) session.panel = Panel::none;
  session.go_to(*chosen);
}

}  // namespace polhode
