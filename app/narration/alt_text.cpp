// SPDX-License-Identifier: MIT
#include "app/narration/alt_text.h"

#include "base/angles.h"
#include "physics/body/euler.h"
#include "render/scene/model/drawn_marks.h"
#include "render/scene/model/model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

namespace polhode {

namespace {

std::string view_words(const std::vector<View>& views) {
  if (views.size() > 1) return "Seen from space and from the body, side by side";
  return !views.empty() && views.front() == View::body ? "Seen from the body" : "Seen from space";
}

std::string diagram_words(const OverlaySet& show) {
  const std::size_t count = diagrams_in(show).size();
  return count > 1 ? "Diagrams" : "A diagram";
}

std::string shown_words(const OverlaySet& show, const std::vector<std::string>& marks) {
  std::vector<std::string> words;
  for (int i = 0; i < kOverlayCount; ++i) {
    const auto overlay = static_cast<Overlay>(i);
    const std::string_view of_overlay = facts_of(overlay).words;
    if (show.contains(overlay) && !of_overlay.empty()) words.emplace_back(of_overlay);
  }
  words.insert(words.end(), marks.begin(), marks.end());
  if (words.empty()) return "nothing";
  const std::string last = words.back();
  words.pop_back();
  return words.empty() ? last : fmt::format("{} and {}", fmt::join(words, ", "), last);
}

std::string moment_words(const PrincipalMoments& I, const Vec3& w_B, double t_s) {
  const Vec3 L_B = angular_momentum_B(I, w_B);
  const double angle_deg = angle_between(w_B, L_B) * kDegreesPerRadian;
  std::string text = fmt::format("At t = {:.4g} s the body turns at {:.3g} rad/s", t_s, w_B.norm());
  constexpr double kParallel_deg = 1e-6;  // what rounding leaves
  if (!w_B.isZero(0.0))
    text += angle_deg < kParallel_deg ? ", with ω along L"
                                      : fmt::format(", with ω {:.2g}° away from L", angle_deg);
  return text + '.';
}

}  // namespace

std::string alt_text(const Scene& scene, const SceneInWords& words, const Vec3& w_B, double t_s) {
  const OverlaySet drawn = drawn_overlays(scene);
  const bool has_marks = draws_marks(scene);
  std::string text =
      shows_nothing(drawn, has_marks) && !scene.meters.empty()
          ? "Plots alone. "
          : fmt::format("{}: {}. ",
                        shows_space(drawn, has_marks) ? view_words(scene.views) : diagram_words(drawn),
                        shown_words(drawn, words.marks));
  if (const std::string& caption = words.caption; !caption.empty() && caption_holds(scene, t_s))
    text += caption + (caption.ends_with('.') ? " " : ". ");
  const Vec3& I = scene.body.moments.vector();
  text += fmt::format("The body is \"{}\" with principal moments {:.4g}, {:.4g}, {:.4g} kg m². ",
                      scene.body.name, I[0], I[1], I[2]);
  return text + moment_words(scene.body.moments, w_B, t_s);
}

std::string alt_text(const SceneModel& model, const std::vector<SceneInWords>& words, double t_s) {
  const std::vector<const SceneModel*> shown = shown_models(model);
  std::string text;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (shown.size() > 1)
      text += fmt::format("{}Scene {} of {}, side by side. ", i > 0 ? " " : "", i + 1, shown.size());
    text += alt_text(shown[i]->scene, words[i], shown[i]->motion->w_B_at(t_s), t_s);
  }
  return text;
}

}  // namespace polhode
