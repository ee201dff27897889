// SPDX-License-Identifier: MIT
#include "app/window/screen/number_sliders.h"

#include "app/session/symbol_note.h"
#include "app/window/controls/widgets.h"
#include "base/words/window_words.h"
#include "lessons/reader/scene/varied_scene.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace polhode {

namespace {

constexpr std::array kKeys = {
    std::array{Command::smaller_number, Command::larger_number},
    std::array{Command::smaller_second_number, Command::larger_second_number},
};

}  // namespace

SlidersUsed draw_number_sliders(LessonSession& session, const Region& figure, const ControlSizes& sizes) {
  const std::vector<Variation> numbers = session.variations();
  if (numbers.empty()) return {};
  const float width = std::min(17 * sizes.em, figure.width - 2 * sizes.padding);
  // Bodies and captions stand in the middle.
  ImGui::SetNextWindowPos({figure.x + sizes.padding, figure.y + sizes.padding}, ImGuiCond_Always);
  ImGui::SetNextWindowSize({width, 0});
  ImGui::Begin("numbers", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
  SlidersUsed used;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Variation& number = numbers[i];
    const VariedNumber& facts = *find_varied_number(number.number);
    ImGui::PushID(static_cast<int>(i));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(std::string(facts.label).c_str());
    ImGui::SameLine(4.5F * sizes.em);
    ImGui::SetNextItemWidth(-1);
    double value = number.value;
    const std::string format = fmt::format("%.4g {}", facts.unit);
    bool changed = number_slider("##value", value, number.from, number.to, format.c_str(),
                                 ImGuiSliderFlags_NoInput, session.lesson().about.language);
    // A slider follows the mouse as long as it is down, after the second click too.
    if (ImGui::IsItemActive() && ImGui::GetIO().MouseClickedLastCount[0] > 1) {
      value = session.step().scene->vary[i].value;
      changed = true;
    }
    used.is_held = used.is_held || ImGui::IsItemActive();
    const auto end = [&](double at) {
      return with_decimals(with_minus(fmt::format("{:.4g}", at)), session.lesson().about.language);
    };
    tooltip_of_last(words::kRangeOfNumber.with(session.lesson().about.language,
                                               {end(number.from), end(number.to), facts.unit}) +
                    ' ' + told(kKeys[i][0]) + "; " + told(kKeys[i][1]));
    if (changed)
      if (const Status made = session.vary(i, value); !made) used.refusal = made.error();
    ImGui::PopID();
  }
  ImGui::End();
  return used;
}

}  // namespace polhode
