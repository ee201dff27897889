// SPDX-License-Identifier: MIT
#include "app/window/screen/figure_marks.h"

#include "app/session/omega_drag.h"
#include "app/session/symbol_note.h"
#include "app/window/controls/widgets.h"
#include "base/words/answer_words.h"
#include "base/words/page_words.h"
#include "base/words/window_words.h"
#include "lessons/reader/questions/state_task.h"
#include "physics/body/euler.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {

namespace {

std::string words_at_tip(const LessonSession& session, TipHand hand) {
  const Language language = session.lesson().about.language;
  if (hand == TipHand::away) return std::string(words::kDrag.in(language));
  if (hand == TipHand::near) return std::string(words::kDragOmega.in(language));
  if (hand == TipHand::untaken) return std::string(words::kNotThisOmega.in(language));
  const SceneModel& model = *session.model();
  const Vec3 w = model.motion->w_B_at(session.t_s());
  const std::string omega = with_decimals(readable(w), language);
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

/// Boxes so large at the heads of all arrows of the figure.
std::vector<PixelBox> heads_of_arrows(const Inset& inset, double size) {
  std::vector<PixelBox> boxes;
  for (const ArrowOnScreen& arrow : arrows_on_page(inset)) {
    const Vec2 back = arrow.tip - arrow.tail;
    const double length = back.norm();
    const Vec2 at = length > 0 ? Vec2(arrow.tip - std::min(0.5, 0.5 * size / length) * back) : arrow.tip;
    boxes.push_back({at.x() - 0.5 * size, at.y() - 0.5 * size, at.x() + 0.5 * size, at.y() + 0.5 * size});
  }
  return boxes;
}

TakenOnFigure taken_on(const std::vector<Inset>& insets, const std::vector<PixelBox>& names, float em) {
  TakenOnFigure taken{.names = names};
  const auto add = [](std::vector<PixelBox>& all, const std::vector<PixelBox>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  for (const Inset& inset : insets) {
    add(taken.names, heads_of_arrows(inset, static_cast<double>(1.4F * em)));
    add(taken.bodies, along_arrows(inset, static_cast<double>(0.6F * em)));
  }
  return taken;
}

std::string words_of_chip(const LessonSession& session, bool is_tight) {
  const Language language = session.lesson().about.language;
  const auto said = [language](const Phrase& phrase) { return std::string(phrase.in(language)); };
  const Counterexample* counter = session.counterexample();
  if (counter != nullptr) return words::kBodyOfFailure.with(language, {counter->state});
  if (session.is_aside()) return said(words::kBodyOfFailureChanged);
  return said(is_tight ? words::kChanged : words::kChangedByHand);
}

float width_of_button(const std::string& words) {
  return ImGui::CalcTextSize(words.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
}

}  // namespace

bool is_to_be_dragged(const LessonSession& session) {
  const std::vector<const Ask*> asks = session.questions();
  return !session.is_aside() && std::any_of(asks.begin(), asks.end(), [](const Ask* ask) {
    return ask->task && ask->task->change.contains(Steered::omega);
  });
}

double TakenOnFigure::hidden_by(const PixelBox& box) const {
  constexpr double kOfNames = 100;  // a name is worth so much of a body's surface
  double all = 0;
  for (const PixelBox& name : names) all += kOfNames * box.overlap(name);
  for (const PixelBox& body : bodies) all += box.overlap(body);
  return all;
}

std::size_t clearest(const std::vector<PixelBox>& boxes, const TakenOnFigure& taken) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < boxes.size(); ++i)
    if (taken.hidden_by(boxes[i]) < taken.hidden_by(boxes[best])) best = i;
  return best;
}

std::vector<std::pair<double, double>> ring_beside(const Vec2& at, double radius,
                                                   const std::vector<PixelBox>& names) {
  constexpr int kPieces = 90;
  const double piece = 2 * std::numbers::pi / kPieces;
  const auto is_clear = [&](int i) {
    const Vec2 point = at + radius * Vec2(std::cos((i + 0.5) * piece), std::sin((i + 0.5) * piece));
    return std::none_of(names.begin(), names.end(),
                        [&](const PixelBox& name) { return name.contains(point); });
  };
  std::vector<std::pair<double, double>> arcs;
  for (int i = 0; i < kPieces; ++i) {
    if (!is_clear(i)) continue;
    if (!arcs.empty() && arcs.back().second > (i - 0.5) * piece)
      arcs.back().second = (i + 1) * piece;
    else
      arcs.emplace_back(i * piece, (i + 1) * piece);
  }
  return arcs;
}

Vec2 place_beside(const Vec2& at, double gap, const Vec2& size, const PixelBox& room,
                  const TakenOnFigure& taken, std::size_t& place) {
  struct Place {
    int x, y;         // on which side of the point
    double distance;  // gaps
  };
  static constexpr auto kPlaces = std::to_array<Place>(
      {{1, -1, 1},  {1, 1, 1},  {-1, -1, 1}, {-1, 1, 1}, {0, -1, 1}, {0, 1, 1},  {1, -1, 3}, {1, 1, 3},
       {-1, -1, 3}, {-1, 1, 3}, {0, -1, 3},  {0, 1, 3},  {1, 0, 3},  {-1, 0, 3}, {1, -1, 6}, {1, 1, 6},
       {-1, -1, 6}, {-1, 1, 6}, {0, -1, 6},  {0, 1, 6},  {0, -1, 9}, {0, 1, 9},  {1, 0, 6},  {-1, 0, 6},
       {1, -1, 9},  {1, 1, 9},  {-1, -1, 9}, {-1, 1, 9}, {1, 0, 9},  {-1, 0, 9}});
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
    return taken.hidden_by(box) + TakenOnFigure{.names = {point}}.hidden_by(box);
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
  const TakenOnFigure taken =
      hand == TipHand::away ? TakenOnFigure{.names = around.names} : taken_on(insets, around.names, sizes.em);
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
    const auto arcs = ring_beside({tip.x, tip.y}, static_cast<double>(radius), around.names);
    const auto ring = [&](ImGuiCol color, float width) {
      for (const auto& [from, to] : arcs) {
        list.PathArcTo(at, radius, static_cast<float>(from), static_cast<float>(to), 32);
        list.PathStroke(ImGui::GetColorU32(color), 0, width);
      }
    };
    ring(ImGuiCol_WindowBg, 0.3F * sizes.em);
    ring(ImGuiCol_NavHighlight, 0.13F * sizes.em);
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
  const Phrase& phrase = session.is_enlarged() ? words::kBesideText : words::kLargerFigure;
  if (ImGui::Button(std::string(phrase.in(session.lesson().about.language)).c_str()))
    session.set_enlarged(!session.is_enlarged());
  tooltip_of_last(told(Command::enlarge));
  ImGui::End();
}

void draw_scene_chip(LessonSession& session, const std::vector<Inset>& insets,
                     const std::vector<PixelBox>& names, bool is_held, const Region& figure,
                     const ControlSizes& sizes, ChipPlace& place) {
  place.box = {};
  if (is_held) return;
  if (!session.is_aside() && !is_changed(session.edits())) {
    place = {};
    return;
  }
  const ImGuiStyle& style = ImGui::GetStyle();
  const bool is_aside = session.is_aside();
  const auto said = [&](const Phrase& phrase) {
    return std::string(phrase.in(session.lesson().about.language));
  };
  const std::vector<std::string> buttons =
      is_aside ? std::vector<std::string>{said(words::kBackToShown)}
               : std::vector<std::string>{said(words::kUndo), said(words::kBackToLessons)};
  const float room = figure.width - 2 * sizes.padding - 2 * style.WindowPadding.x;
  float of_buttons = 0;
  for (const std::string& button : buttons) of_buttons += width_of_button(button) + style.ItemSpacing.x;
  const auto fits = [&](const std::string& words) {
    return ImGui::CalcTextSize(words.c_str()).x + of_buttons <= room;
  };
  std::string words = words_of_chip(session, false);
  if (!fits(words)) words = words_of_chip(session, true);
  const bool one_line = fits(words), buttons_in_row = of_buttons - style.ItemSpacing.x <= room;
  const float wrap = std::min(19 * sizes.em, room);
  const ImVec2 of_words = ImGui::CalcTextSize(words.c_str(), nullptr, false, one_line ? -1 : wrap);
  const float row = ImGui::GetFrameHeight(),
              rows = static_cast<float>(buttons_in_row ? 1 : buttons.size()) * (row + style.ItemSpacing.y);
  const Vec2 size(
      static_cast<double>(2 * style.WindowPadding.x +
                          (one_line ? of_words.x + of_buttons
                                    : std::max(of_words.x, buttons_in_row ? of_buttons : 0.6F * of_buttons))),
      static_cast<double>(2 * style.WindowPadding.y + (one_line ? row : of_words.y + rows)));

  const double x0 = figure.x + sizes.padding, x1 = figure.x + figure.width - sizes.padding,
               y0 = figure.y + sizes.padding, y1 = figure.y + figure.height - sizes.padding;
  std::vector<PixelBox> corners = {{x1 - size.x(), y0, x1, y0 + size.y()},
                                   {x0, y0, x0 + size.x(), y0 + size.y()}};
  // A top stands on its pivot, low in the picture.
  if (session.model() == nullptr || !session.model()->drawn.contains(Overlay::pivot))
    corners.push_back({x0, y1 - size.y(), x0 + size.x(), y1});
  TakenOnFigure taken = taken_on(insets, names, sizes.em);
  if (!session.variations().empty())  // whose sliders stand in the upper left corner
    taken.names.push_back(
        {x0, y0, x0 + static_cast<double>(17 * sizes.em), y0 + 4.0 * static_cast<double>(sizes.em)});
  const bool is_same = place.of.x == figure.x && place.of.y == figure.y && place.of.width == figure.width &&
                       place.of.height == figure.height;
  if (!is_same || place.corner >= corners.size() ||
      TakenOnFigure{.names = taken.names}.hidden_by(corners[place.corner]) > 0) {
    for (const Inset& inset : insets)
      for (const PixelBox& body : bodies_on_page(inset, static_cast<double>(0.5F * sizes.em)))
        taken.bodies.push_back(body);
    place = {clearest(corners, taken), figure};
  }
  const PixelBox& box = corners[place.corner];
  place.box = {static_cast<float>(box.x0), static_cast<float>(box.y0), static_cast<float>(box.width()),
               static_cast<float>(box.y1 - box.y0)};
  const bool leftward = place.corner > 0, low = place.corner > 1;
  ImGui::SetNextWindowPos({static_cast<float>(leftward ? x0 : x1), static_cast<float>(low ? y1 : y0)},
                          ImGuiCond_Always, {leftward ? 0.0F : 1.0F, low ? 1.0F : 0.0F});
  ImGui::Begin("changed-scene", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
  if (one_line) ImGui::AlignTextToFramePadding();
  ImGui::PushTextWrapPos(one_line ? -1 : style.WindowPadding.x + wrap);
  ImGui::TextUnformatted(words.c_str());
  ImGui::PopTextWrapPos();
  if (one_line) ImGui::SameLine();
  if (is_aside) {
    if (ImGui::Button(buttons[0].c_str())) session.leave_counterexample();
  } else {
    ImGui::BeginDisabled(!session.can_undo());
    if (ImGui::Button(buttons[0].c_str())) session.undo();
    ImGui::EndDisabled();
    tooltip_of_last(told(Command::undo));
    if (one_line || buttons_in_row) ImGui::SameLine();
    if (ImGui::Button(buttons[1].c_str())) session.reset_edits();
    tooltip_of_last(told(Command::reset_scene));
  }
  ImGui::End();
}

}  // namespace polhode
