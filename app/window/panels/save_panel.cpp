// SPDX-License-Identifier: MIT
#include "app/export/named_sizes.h"
#include "app/session/saved/saved_scene.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/answer_controls.h"
#include "app/window/panels/panels.h"

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

void offer(PanelContext& context, const char* words, SaveAs what, const std::string& tooltip) {
  ImGui::BeginDisabled(!can_save_as(context.session, what));
  if (ImGui::Button(words, {-1, 0})) context.requests.save_as = what;
  ImGui::EndDisabled();
  tooltip_of_last(can_save_as(context.session, what)  ? tooltip
                  : what != SaveAs::equation          ? "This step has no figure."
                  : saves_derivation(context.session) ? "Your derivation has no line yet."
                                                      : "This step has no equation.");
}

}  // namespace

SavePanel::SavePanel() {
  std::error_code unknown;
  folder = std::filesystem::current_path(unknown).string();
}

void SavePanel::draw(PanelContext& context) {
  heading("Pictures");
  choose_size(options);
  ImGui::Checkbox("transparent background", &options.transparent);
  offer(context, "Save the page", SaveAs::page, "As polhode export writes it. " + told(Command::save_page));
  offer(context, "Save the figure", SaveAs::figure, "Without text and plots");
  const bool is_derivation = saves_derivation(context.session);
  offer(context, is_derivation ? "Save the derivation" : "Save the equation", SaveAs::equation,
        is_derivation ? "Yours, as far as it goes, at 300 dots per inch"
                      : "The last one of this step, at 300 dots per inch");
  heading("Motion");
  ImGui::BeginDisabled(!context.session.model());
  if (ImGui::Button("Copy as CSV", {-1, 0})) context.requests.clipboard = trace_of(context.session);
  ImGui::EndDisabled();
  tooltip_of_last(
      "Over the time line, to be pasted into a table: t in s, ω in rad/s, the attitude as a quaternion, T in "
      "J, "
      "L in kg m²/s, each number with all its digits");
  offer(context, "Save as CSV", SaveAs::trace, "The same as a file");
  heading("Scene");
  offer(context, "Save as a lesson", SaveAs::scene,
        "With all that was changed by hand; polhode export makes the same figure of it");
  heading("Slides");
  const std::size_t all = context.session.lesson().stages.size(),
                    chosen = context.session.chosen_stages().size();
  quiet_words(chosen == all ? "Of all stages; Outline chooses some for a class."
                            : fmt::format("Of the {} stages chosen in Outline.", chosen));
  if (ImGui::Button("Save slides for a browser", {-1, 0})) context.requests.slides = ".html";
  tooltip_of_last("One file that any browser shows without network; as polhode export --deck makes it");
  if (ImGui::Button("Save slides as PDF", {-1, 0})) context.requests.slides = ".pdf";
  tooltip_of_last("The same as a PDF. They are made while you go on");
  heading("Answers");
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##student", "your name, if it is to stand there", &options.student);
  take_keyboard_by_tab(context);
  offer(context, "Save a report to hand in", SaveAs::answers,
        "What you answered in this lesson, as a text; without a name it does not say who you are");
  heading("Folder");
  ImGui::SetNextItemWidth(-1);
  ImGui::InputText("##folder", &folder);
  take_keyboard_by_tab(context);
  quiet_words("Nothing is overwritten: a name that is taken gets a number.");
}

}  // namespace polhode
