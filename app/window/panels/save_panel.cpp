// SPDX-License-Identifier: MIT
#include "app/export/named_sizes.h"
#include "app/session/saved/saved_scene.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/answer_controls.h"
#include "app/window/panels/panels.h"
#include "base/words/window_words.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <filesystem>

namespace polhode {

namespace {

void choose_size(SaveOptions& options) {
  const auto text_of = [](Size size) { return fmt::format("{}x{}", size.width, size.height); };
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##size", text_of(options.size).c_str())) return;
  for (const NamedSize& named : named_sizes())
    if (choice_row(fmt::format("{}  ({})", text_of(named.size), named.name).c_str(),
                   named.size == options.size))
      options.size = named.size;
  ImGui::EndCombo();
}

void offer(PanelContext& context, const Phrase& words, SaveAs what, const std::string& tooltip) {
  ImGui::BeginDisabled(!can_save_as(context.session, what));
  if (ImGui::Button(context.said(words).c_str(), {-1, 0})) context.requests.save_as = what;
  ImGui::EndDisabled();
  tooltip_of_last(can_save_as(context.session, what)  ? tooltip
                  : what != SaveAs::equation          ? context.said(words::kStepHasNoFigure)
                  : saves_derivation(context.session) ? context.said(words::kNoLineYet)
                                                      : context.said(words::kNoEquation));
}

}  // namespace

SavePanel::SavePanel() {
  std::error_code unknown;
  folder = std::filesystem::current_path(unknown).string();
}

void SavePanel::draw(PanelContext& context) {
  heading(context.said(words::kPictures).c_str());
  choose_size(options);
  ImGui::Checkbox(context.said(words::kTransparent).c_str(), &options.transparent);
  offer(context, words::kSavePage, SaveAs::page, context.said(words::kAsExportWrites) + " (Ctrl+S)");
  offer(context, words::kSaveFigure, SaveAs::figure, context.said(words::kWithoutText));
  const bool is_derivation = saves_derivation(context.session);
  offer(context, is_derivation ? words::kSaveDerivation : words::kSaveEquation, SaveAs::equation,
        context.said(is_derivation ? words::kYoursAt300 : words::kLastAt300));
  heading(context.said(words::kMotion).c_str());
  ImGui::BeginDisabled(!context.session.model());
  if (ImGui::Button(context.said(words::kCopyCsv).c_str(), {-1, 0}))
    context.requests.clipboard = trace_of(context.session);
  ImGui::EndDisabled();
  tooltip_of_last(context.said(words::kWhatCsvIs));
  offer(context, words::kSaveCsv, SaveAs::trace, context.said(words::kSameAsFile));
  heading(context.said(words::kSceneHeading).c_str());
  offer(context, words::kSaveLesson, SaveAs::scene, context.said(words::kWhatLessonIs));
  heading(context.said(words::kSlides).c_str());
  const std::size_t all = context.session.lesson().stages.size(),
                    chosen = context.session.chosen_stages().size();
  quiet_words(chosen == all ? context.said(words::kOfAllStages)
                            : words::kOfChosenStages.with(context.language(), {std::to_string(chosen)}));
  if (ImGui::Button(context.said(words::kSaveForBrowser).c_str(), {-1, 0})) context.requests.slides = ".html";
  tooltip_of_last(context.said(words::kOneFile));
  if (ImGui::Button(context.said(words::kSavePdf).c_str(), {-1, 0})) context.requests.slides = ".pdf";
  tooltip_of_last(context.said(words::kSameAsPdf));
  heading(context.said(words::kAnswers).c_str());
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##student", context.said(words::kYourName).c_str(), &options.student);
  take_keyboard_by_tab(context);
  offer(context, words::kSaveReport, SaveAs::answers, context.said(words::kWhatReportIs));
  heading(context.said(words::kFolder).c_str());
  ImGui::SetNextItemWidth(-1);
  ImGui::InputText("##folder", &folder);
  take_keyboard_by_tab(context);
  quiet_words(context.said(words::kNothingOverwritten));
}

}  // namespace polhode
