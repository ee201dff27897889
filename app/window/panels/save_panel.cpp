// SPDX-License-Identifier: MIT
#include "app/export/named_sizes.h"
#include "app/session/saved_scene.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace polhode {

namespace {

void choose_size(TakeAwayOptions& options) {
  const auto text_of = [](Size size) { return fmt::format("{}x{}", size.width, size.height); };
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##size", text_of(options.size).c_str())) return;
  for (const NamedSize& named : named_sizes())
    if (ImGui::Selectable(fmt::format("{}  ({})", text_of(named.size), named.name).c_str(),
                          named.size == options.size))
      options.size = named.size;
  ImGui::EndCombo();
}

void offer(Desk& desk, const char* words, TakeAway what, const std::string& tooltip) {
  ImGui::BeginDisabled(!can_take_away(desk.companion, what));
  if (ImGui::Button(words, {-1, 0})) desk.wishes.take_away = what;
  ImGui::EndDisabled();
  tooltip_of_last(tooltip);
}

}  // namespace

void draw_save(Desk& desk) {
  heading("Pictures");
  choose_size(desk.memory.take_away);
  ImGui::Checkbox("transparent background", &desk.memory.take_away.transparent);
  offer(desk, "Save the page", TakeAway::page, "As polhode export writes it. " + told(Command::save_page));
  offer(desk, "Save the figure", TakeAway::figure, "Without text and plots");
  offer(desk, "Save the equation", TakeAway::equation, "The last one of this step, at 300 dots per inch");
  heading("Motion");
  ImGui::BeginDisabled(!desk.companion.model());
  if (ImGui::Button("Copy as CSV", {-1, 0})) desk.wishes.clipboard = trace_of(desk.companion);
  ImGui::EndDisabled();
  tooltip_of_last("ω, attitude, T and L over the time line, to be pasted into a table");
  offer(desk, "Save as CSV", TakeAway::trace, "The same as a file");
  heading("Scene");
  offer(desk, "Save as a lesson", TakeAway::scene,
        "With all that was changed by hand; polhode export makes the same figure of it");
  heading("Folder");
  ImGui::SetNextItemWidth(-1);
  ImGui::InputText("##folder", &desk.memory.folder);
  quiet_words("Nothing is overwritten: a name that is taken gets a number.");
}

}  // namespace polhode
