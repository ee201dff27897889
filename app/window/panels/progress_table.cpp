// SPDX-License-Identifier: MIT
#include "app/window/panels/progress_table.h"

#include "app/session/answers/answer_text.h"
#include "app/session/answers/progress.h"
#include "app/window/controls/widgets.h"

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
  const Lesson& lesson = context.session.lesson();
  const Progress progress = progress_of(lesson, context.session.answers());
  if (progress.all.asked == 0) return;
  quiet_words("Questions: " + words_of(progress.all));
  if (!progress.tests_outcomes() || !ImGui::BeginTable("outcomes", 2)) return;
  constexpr const char* kNumbers = "right/asked";
  ImGui::TableSetupColumn("outcome", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn(kNumbers, ImGuiTableColumnFlags_WidthFixed, ImGui::CalcTextSize(kNumbers).x);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("outcome");
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", kNumbers);
  for (std::size_t i = 0; i < progress.outcomes.size(); ++i)
    if (progress.outcomes[i].asked > 0) outcome_row(lesson.about.outcomes[i], progress.outcomes[i]);
  ImGui::EndTable();
  ImGui::Spacing();
}

void draw_summary(PanelContext& context) {
  LessonSession& session = context.session;
  heading("How far you have come");
  draw_progress(context);
  std::vector<PlacedAsk> open;
  for (PlacedAsk& question : questions_of(session.lesson())) {
    const auto record = session.answers().find(question.name);
    if (record == session.answers().end() || record->second.right == 0) open.push_back(std::move(question));
  }
  if (!open.empty()) {
    heading("Not yet answered right");
    std::optional<StepPlace> chosen;
    for (std::size_t i = 0; i < open.size();) {
      const StepPlace first = open[i].place;
      std::size_t count = 0;
      for (; i < open.size() && open[i].place.stage == first.stage; ++i) ++count;
      const Stage& stage = session.lesson().stages[first.stage];
      RichText title = stage.title_text;
      if (count > 1) title = in_a_row(std::move(title), words_text(fmt::format(" ({} questions)", count)));
      if (context.texts.row(stage.id.c_str(), title)) chosen = first;
    }
    if (chosen) session.go_to(*chosen);
  }
  ImGui::Spacing();
  if (const std::string& next = session.lesson().about.next; !next.empty())
    quiet_words(fmt::format("To go on: polhode play {}", next));
}

}  // namespace polhode
