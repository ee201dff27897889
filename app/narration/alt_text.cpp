// SPDX-License-Identifier: MIT
#include "app/narration/alt_text.h"

#include "base/angles.h"
#include "base/words/speech_words.h"
#include "physics/body/euler.h"
#include "render/scene/model/drawn_marks.h"
#include "render/scene/model/model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace polhode {

namespace {

Phrase view_words(const std::vector<View>& views) {
  if (views.size() > 1) return words::kSeenFromBoth;
  return !views.empty() && views.front() == View::body ? words::kSeenFromBody : words::kSeenFromSpace;
}

Phrase diagram_words(const OverlaySet& show) {
  const std::size_t count = diagrams_in(show).size();
  return count > 1 ? words::kDiagrams : words::kADiagram;
}

std::string shown_words(const OverlaySet& show, const std::vector<std::string>& marks, Language language) {
  std::vector<std::string> words;
  for (int i = 0; i < kOverlayCount; ++i) {
    const auto overlay = static_cast<Overlay>(i);
    const std::string_view of_overlay = facts_of(overlay).words.in(language);
    if (show.contains(overlay) && !of_overlay.empty()) words.emplace_back(of_overlay);
  }
  words.insert(words.end(), marks.begin(), marks.end());
  if (words.empty()) return std::string(words::kNothing.in(language));
  const std::string last = words.back();
  words.pop_back();
  return words.empty() ? last : fmt::format("{}{}{}", fmt::join(words, ", "), words::kAnd.in(language), last);
}

/// As an overlay, or as an arrow of the lesson.
bool draws(const Scene& scene, Overlay vector) {
  const auto is_it = [vector](const ArrowMark& arrow) { return arrow.of.overlay == vector; };
  const std::vector<ArrowMark>& arrows = scene.marks.arrows;
  return drawn_overlays(scene).contains(vector) ||
         (draws_marks(scene) && std::any_of(arrows.begin(), arrows.end(), is_it));
}

std::string moment_words(const Scene& scene, const Vec3& w_B, double t_s) {
  const Language language = scene.language;
  std::string text =
      words::kBodyTurnsAt.with(language, {fmt::format("{:.4g}", t_s), fmt::format("{:.3g}", w_B.norm())});
  if (!w_B.isZero(0.0) && draws(scene, Overlay::omega) && draws(scene, Overlay::L)) {
    const Vec3 L_B = angular_momentum_B(scene.body.moments, w_B);
    const double angle_deg = angle_between(w_B, L_B) * kDegreesPerRadian;
    constexpr double kParallel_deg = 1e-6;  // what rounding leaves
    text += angle_deg < kParallel_deg
                ? std::string(words::kOmegaAlongL.in(language))
                : words::kOmegaAwayFromL.with(language, {fmt::format("{:.2g}", angle_deg)});
  }
  return with_decimals(text + '.', language);
}

/// Of one of the scenes that a model shows.
std::string change_in_words(const SceneModel& model, double from_s, double t_s) {
  const Scene& scene = model.scene;
  const Language language = scene.language;
  std::string text;
  const auto add = [&](const Phrase& phrase, std::initializer_list<std::string_view> parts) {
    text += (text.empty() ? "" : " ") + with_decimals(phrase.with(language, parts), language);
  };
  const bool is_seen_from_space =
      std::find(scene.views.begin(), scene.views.end(), View::space) != scene.views.end();
  if (t_s != from_s && is_seen_from_space && model.needs.attitude) {
    const Quat from_SB = model.motion->at(from_s).q_SB, now_SB = model.motion->at(t_s).q_SB;
    const auto turned = [&](const Vec3& axis_B) {
      return fmt::format("{:.0f}",
                         angle_between(Vec3(from_SB * axis_B), Vec3(now_SB * axis_B)) * kDegreesPerRadian);
    };
    add(words::kAxesPoint,
        {fmt::format("{:.4g}", from_s), turned(Vec3::UnitX()), turned(Vec3::UnitY()), turned(Vec3::UnitZ())});
  }
  const auto add_components = [&](const Phrase& phrase, const Vec3& vector_B) {
    const double last = 1e-3 * vector_B.norm();  // what no reader could see is 0
    const auto component = [&](int i) {
      return (vector_B[i] < -last ? "−" : "") +
             fmt::format("{:.3g}", std::abs(vector_B[i]) < last ? 0.0 : std::abs(vector_B[i]));
    };
    add(phrase, {component(0), component(1), component(2)});
  };
  const Vec3 w_B = model.motion->w_B_at(t_s);
  if (draws(scene, Overlay::omega)) {
    add_components(words::kOmegaInBody, w_B);
  } else if (draws(scene, Overlay::L)) {
    add_components(words::kLInBody, angular_momentum_B(scene.body.moments, w_B));
  }
  return text;
}

}  // namespace

std::string alt_text(const Scene& scene, const SceneInWords& said, const Vec3& w_B, double t_s) {
  const OverlaySet drawn = drawn_overlays(scene);
  const bool has_marks = draws_marks(scene);
  const Language language = scene.language;
  std::string text =
      shows_nothing(drawn, has_marks) && !scene.meters.empty()
          ? std::string(words::kPlotsAlone.in(language))
          : fmt::format(
                "{}: {}. ",
                (shows_space(drawn, has_marks) ? view_words(scene.views) : diagram_words(drawn)).in(language),
                shown_words(drawn, said.marks, language));
  if (const std::string& caption = said.caption; !caption.empty() && caption_holds(scene, t_s))
    text += caption + (caption.ends_with('.') ? " " : ". ");
  const Vec3& I = scene.body.moments.vector();
  const auto moment = [&](int i) { return with_decimals(fmt::format("{:.4g}", I[i]), language); };
  // What a body is called in lessons are English words.
  const std::string name = language == Language::en ? '"' + scene.body.name + "\" " : "";
  text += words::kTheBodyIs.with(language, {name, moment(0), moment(1), moment(2)});
  if (said.is_asked) {
    text.pop_back();
    return text;
  }
  return text + moment_words(scene, w_B, t_s);
}

std::string alt_text(const SceneModel& model, const std::vector<SceneInWords>& said, double t_s) {
  const std::vector<const SceneModel*> shown = shown_models(model);
  std::string text;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (shown.size() > 1)
      text +=
          (i > 0 ? " " : "") + words::kSceneOf.with(shown[i]->scene.language,
                                                    {std::to_string(i + 1), std::to_string(shown.size())});
    text += alt_text(shown[i]->scene, said[i], shown[i]->motion->w_B_at(t_s), t_s);
  }
  return text;
}

std::string moment_in_words(const SceneModel& model, double from_s, double t_s) {
  const std::vector<const SceneModel*> shown = shown_models(model);
  const Language language = model.scene.language;
  std::string text =
      t_s == from_s ? ""
                    : with_decimals(words::kTheSameAt.with(language, {fmt::format("{:.4g}", t_s)}), language);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const std::string change = change_in_words(*shown[i], from_s, t_s);
    if (change.empty()) continue;
    if (!text.empty()) text += ' ';
    if (shown.size() > 1) text += words::kScene.with(language, {std::to_string(i + 1)});
    text += change;
  }
  return text;
}

}  // namespace polhode
