// SPDX-License-Identifier: MIT
#include "app/window/screen/figure_marks.h"

#include "app/session/omega_drag.h"
#include "app/session/symbol_note.h"
#include "app/window/controls/widgets.h"
#include "base/words/page_words.h"
#include "lessons/reader/questions/state_task.h"
#include "physics/body/euler.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace polhode {

namespace {

bool is_to_be_dragged(const LessonSession& session) {
  const std::vector<const Ask*> asks = session.questions();
  return !session.is_aside() && std::any_of(asks.begin(), asks.end(), [](const Ask* ask) {
    return ask->task && ask->task->change.contains(Steered::omega);
  });
}

std::string words_at_tip(const LessonSession& session, TipHand hand) {
  const Language language = session.lesson().about.language;
  if (hand == TipHand::away) return std::string(words::kDrag.in(language));
  if (hand == TipHand::near) return std::string(words::kDragOmega.in(language));
  if (hand == TipHand::untaken) return std::string(words::kNotThisOmega.in(language));
  const SceneModel& model = *session.model();
  const Vec3 w = model.motion->w_B_at(session.t_s());
  const std::string omega =
      with_decimals(fmt::format("({:.3g}, {:.3g}, {:.3g})", w[0], w[1], w[2]), language);
  if (hand == TipHand::short_of) return words::kOmegaNoNearer.with(language, {omega});
  if (hand == TipHand::turns) return words::kOmegaAtConstT.with(language, {omega});
  const double T = kinetic_energy(model.scene.body.moments, w);
  return words::kOmegaAtOtherT.with(language, {omega, with_decimals(readable(T, 3), language)});
}

/// With ground round it, which `pad` is the width of.
void label(ImDrawList& list, ImVec2 at, const std::string& words, float wrap, float pad) {
  const ImVec2 size = ImGui::CalcTextSize(words.c_str(), nullptr, false, wrap);
  list.AddRectFilled({at.x - pad, at.y - 0.5F * pad}, {at.x + size.x + pad, at.y + size.y + 0.5F * pad},
                     ImGui::GetColorU32(ImGuiCol_WindowBg), pad);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, ImGui::GetColorU32(ImGuiCol_Text), words.c_str(),
               nullptr, wrap);
}

/// Boxes so large along all arrows of the figure: an arrow is thin, and its box is not.
std::vector<PixelBox> along_arrows(const Inset& inset, double size) {
  std::vector<PixelBox> boxes;
  for (const ArrowOnScreen& arrow : arrows_on_page(inset)) {
    const Vec2 along = arrow.tip - arrow.tail;
    const int count = 1 + static_cast<int>(std::min(200.0, along.norm() / size));
    for (int i = 0; i <= count; ++i) {
      const Vec2 at = arrow.tip - static_cast<double>(i) / count * along;
      boxes.push_back({at.x() - 0.5 * size, at.y() - 0.5 * size, at.x() + 0.5 * size, at.y() + 0.5 * size});
    }
  }
  return boxes;
}

/// Whether something else is shown than the lesson's. A camera is turned back by a double click, and numbers
/// that readers may vary have sliders of their own.
bool is_changed(SceneEdits edits) {
  edits.camera.reset();
  edits.numbers.clear();
  return !edits.empty();
}

/// Whether a tip of ω is, with what is written beside it, where the chip stands in the right corner.
bool hides_a_tip(const LessonSession& session, const std::vector<Inset>& insets, const Region& figure,
                 const ControlSizes& sizes) {
  constexpr float kChipHeight = 6, kRoom = 3;  // em
  if (session.model() == nullptr) return false;
  const float left = figure.x + figure.width - std::min(19 * sizes.em, 0.6F * figure.width) - sizes.padding,
              low = figure.y + sizes.padding + kChipHeight * sizes.em, room = kRoom * sizes.em;
  const std::vector<TipOnScreen> tips = omega_tips(*session.model(), session.t_s(), insets);
  return std::any_of(tips.begin(), tips.end(), [&](const TipOnScreen& tip) {
    return tip.x > static_cast<double>(left - room) && tip.y < static_cast<double>(low + room);
  });
}

std::string words_of_chip(const LessonSession& session) {
  const Counterexample* counter = session.counterexample();
  if (counter == nullptr)
    return session.is_aside() ? "a body for which an answer failed, then changed by hand" : "changed by hand";
  return fmt::format("a body for which it fails: {}", counter->state);
}

}  // namespace

Vec2 place_beside(const Vec2& at, double gap, const Vec2& size, const PixelBox& room,
                  const std::vector<PixelBox>& taken, std::size_t& place) {
  struct Place {
    int x, y;         // on which side of the point
    double distance;  // gaps
  };
  static constexpr auto kPlaces = std::to_array<Place>(
      {{1, -1, 1},  {1, 1, 1},  {-1, -1, 1}, {-1, 1, 1}, {0, -1, 1}, {0, 1, 1},  {1, -1, 3}, {1, 1, 3},
       {-1, -1, 3}, {-1, 1, 3}, {0, -1, 3},  {0, 1, 3},  {1, 0, 3},  {-1, 0, 3}, {1, -1, 6}, {1, 1, 6},
       {-1, -1, 6}, {-1, 1, 6}, {0, -1, 6},  {0, 1, 6},  {0, -1, 9}, {0, 1, 9}});
  const auto along = [&](int side, double from, double length, double distance) {
    return side > 0 ? from + distance * gap : side < 0 ? from - distance * gap - length : from - 0.5 * length;
  };
  // One that would reach out of the room is moved along its edge.
  const auto inside = [](double from, double length, double low, double high) {
    return std::max(low, std::min(from, high - length));
  };
  const auto corner_of = [&](const Place& one) {
    return Vec2(inside(along(one.x, at.x(), size.x(), one.distance), size.x(), room.x0, room.x1),
                inside(along(one.y, at.y(), size.y(), one.distance), size.y(), room.y0, room.y1));
  };
  const PixelBox point{at.x() - gap, at.y() - gap, at.x() + gap, at.y() + gap};
  const auto hidden_by = [&](const Place& one) {
    const Vec2 corner = corner_of(one);
    const PixelBox box{corner.x(), corner.y(), corner.x() + size.x(), corner.y() + size.y()};
    double all = box.overlap(point);
    for (const PixelBox& other : taken) all += box.overlap(other);
    return all;
  };
  if (place < kPlaces.size() && hidden_by(kPlaces[place]) <= 0) return corner_of(kPlaces[place]);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kPlaces.size() && least > 0; ++i)
    if (const double hidden = hidden_by(kPlaces[i]); hidden < least) {
      least = hidden;
      place = i;
    }
  return corner_of(kPlaces[place]);
}

void draw_drag_marks(const LessonSession& session, const std::vector<Inset>& insets, TipHand hand,
                     const AroundTip& around, const ControlSizes& sizes) {
  if ((!is_to_be_dragged(session) && hand == TipHand::away) || session.model() == nullptr) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float radius = 0.7F * sizes.em, pad = 0.4F * sizes.em;
  const std::string words = words_at_tip(session, hand);
  const float wrap = std::min(24 * sizes.em, static_cast<float>(around.room.width()) - 2 * pad);
  const ImVec2 size = ImGui::CalcTextSize(words.c_str(), nullptr, false, wrap);
  std::vector<PixelBox> taken = around.names;
  if (hand != TipHand::away && !insets.empty())
    for (const PixelBox& box : along_arrows(insets.front(), static_cast<double>(0.6F * sizes.em)))
      taken.push_back(box);
  const auto write_beside = [&](const Vec2& at) {
    std::size_t first = 0;
    const Vec2 room(static_cast<double>(size.x + 2 * pad), static_cast<double>(size.y + pad));
    const Vec2 corner = place_beside(at, static_cast<double>(1.2F * radius), room, around.room, taken,
                                     around.place != nullptr ? *around.place : first);
    label(list, {static_cast<float>(corner.x()) + pad, static_cast<float>(corner.y()) + 0.5F * pad}, words,
          wrap, pad);
  };
  if (hand == TipHand::untaken) {
    const ImVec2& at = ImGui::GetIO().MousePos;
    return write_beside({static_cast<double>(at.x), static_cast<double>(at.y)});
  }
  for (const TipOnScreen& tip : omega_tips(*session.model(), session.t_s(), insets)) {
    const ImVec2 at{static_cast<float>(tip.x), static_cast<float>(tip.y)};
    list.AddCircle(at, radius, ImGui::GetColorU32(ImGuiCol_WindowBg), 32, 0.3F * sizes.em);
    list.AddCircle(at, radius, ImGui::GetColorU32(ImGuiCol_NavHighlight), 32, 0.13F * sizes.em);
    write_beside({tip.x, tip.y});
  }
}

void draw_size_chip(LessonSession& session, bool is_too_small, const Region& figure,
                    const ControlSizes& sizes) {
  if (session.is_presenting() || (!session.is_enlarged() && !is_too_small)) return;
  ImGui::SetNextWindowPos({figure.x + figure.width - sizes.padding, figure.y + figure.height - sizes.padding},
                          ImGuiCond_Always, {1, 1});
  ImGui::Begin("size-of-figure", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
  if (ImGui::Button(session.is_enlarged() ? "Beside the text" : "Larger"))
    session.set_enlarged(!session.is_enlarged());
  tooltip_of_last(told(Command::enlarge));
  ImGui::End();
}

void draw_scene_chip(LessonSession& session, const std::vector<Inset>& insets, bool is_held,
                     const Region& figure, const ControlSizes& sizes) {
  constexpr float kBothButtons = 18;  // em: on one line
  if (is_held || (!session.is_aside() && !is_changed(session.edits()))) return;
  const bool leftward = hides_a_tip(session, insets, figure, sizes);
  ImGui::SetNextWindowPos({leftward ? figure.x + sizes.padding : figure.x + figure.width - sizes.padding,
                           figure.y + sizes.padding},
                          ImGuiCond_Always, {leftward ? 0.0F : 1.0F, 0});
  ImGui::Begin("changed-scene", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
  ImGui::PushTextWrapPos(std::min(19 * sizes.em, 0.6F * figure.width));
  ImGui::TextUnformatted(words_of_chip(session).c_str());
  ImGui::PopTextWrapPos();
  if (session.is_aside()) {
    if (ImGui::Button("Back to what was shown")) session.leave_counterexample();
  } else {
    ImGui::BeginDisabled(!session.can_undo());
    if (ImGui::Button("Undo")) session.undo();
    ImGui::EndDisabled();
    tooltip_of_last(told(Command::undo));
    if (figure.width > kBothButtons * sizes.em) ImGui::SameLine();
    if (ImGui::Button("Back to the lesson's")) session.reset_edits();
    tooltip_of_last(told(Command::reset_scene));
  }
  ImGui::End();
}

}  // namespace polhode
