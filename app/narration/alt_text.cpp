// SPDX-License-Identifier: MIT
#include "app/narration/alt_text.h"

#include "app/narration/number_text.h"
#include "base/angles.h"
#include "base/ascii.h"
#include "base/words/speech_words.h"
#include "physics/body/euler.h"
#include "render/scene/model/drawn_marks.h"
#include "render/scene/model/method_orders.h"
#include "render/scene/model/model.h"
#include "render/scene/model/scene_needs.h"
#include "render/scene/model/translation.h"
#include "render/scene/model/transport_arrow.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
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

/// The exact motion beside one of steps, and the weight of a top, are no overlays of their own.
std::vector<Phrase> shown_besides(const Scene& scene, const OverlaySet& show) {
  std::vector<Phrase> besides;
  const Requirements needs = requirements(scene);
  if (show.contains(Overlay::pivot)) besides.push_back(words::kTheWeight);
  if (needs.ghost && needs.solid) besides.push_back(words::kExactBody);
  if (needs.ghost && show.contains(Overlay::L)) besides.push_back(words::kExactLDashed);
  if (needs.ghost && show.contains(Overlay::omega)) besides.push_back(words::kExactOmegaDashed);
  return besides;
}

/// Those of the overlay; of a plot of orders, also what counts as work.
const Phrase& overlay_words(Overlay overlay, const Scene& scene) {
  if (overlay != Overlay::order_plot) return facts_of(overlay).words;
  return scene.compared.by_evaluations ? words::kErrorsAgainstEvaluations : words::kErrorsAgainstSteps;
}

std::string shown_words(const Scene& scene, const OverlaySet& show, const std::vector<std::string>& marks) {
  const Language language = scene.language;
  std::vector<std::string> words;
  for (int i = 0; i < kOverlayCount; ++i) {
    const auto overlay = static_cast<Overlay>(i);
    const std::string_view of_overlay = overlay_words(overlay, scene).in(language);
    if (show.contains(overlay) && !of_overlay.empty()) words.emplace_back(of_overlay);
  }
  for (const Phrase& phrase : shown_besides(scene, show)) words.emplace_back(phrase.in(language));
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

std::string time_words(double t_s, Language language) {
  return with_unit(short_number_words(t_s, 4, language), "s", language);
}

std::string moment_words(const Scene& scene, const Vec3& w_B, double t_s) {
  const Language language = scene.language;
  std::string text = words::kBodyTurnsAt.with(
      language, {time_words(t_s, language),
                 with_unit(short_number_words(w_B.stableNorm(), 3, language), "rad/s", language)});
  if (!w_B.isZero(0.0) && draws(scene, Overlay::omega) && draws(scene, Overlay::L)) {
    const Vec3 L_B = angular_momentum_B(scene.body.moments, w_B);
    const double angle_deg = angle_between(w_B, L_B) * kDegreesPerRadian;
    if (!std::isfinite(angle_deg)) return text + '.';
    constexpr double kParallel_deg = 1e-6;  // what rounding leaves
    const int digits = angle_deg < 100.0 ? 2 : 3;
    text +=
        angle_deg < kParallel_deg
            ? std::string(words::kOmegaAlongL.in(language))
            : words::kOmegaAwayFromL.with(
                  language, {with_unit(short_number_words(angle_deg, digits, language), "deg", language)});
  }
  return text + '.';
}

/// Instants so close that between two of them nothing turns by half a round; none where that would be too
/// many.
std::vector<double> instants(const SceneModel& model, double from_s, double to_s) {
  constexpr double kStepsPerRadian = 8.0, kLeast = 64.0, kMost = 20000.0;
  const double turned = model.scene.w0_B.stableNorm() * std::abs(to_s - from_s);
  const double steps = std::max(std::ceil(kStepsPerRadian * turned), kLeast);
  if (!(steps <= kMost)) return {};
  std::vector<double> times;
  for (int i = 0; i <= static_cast<int>(steps); ++i) times.push_back(std::lerp(from_s, to_s, i / steps));
  return times;
}

/// How often a vector goes round an axis, anticlockwise seen from its tip. Nothing where it comes so close to
/// the axis that nobody could tell.
class Rounds {
 public:
  explicit Rounds(const Vec3& axis) : axis_(axis.normalized()) {}

  void add(const Vec3& vector) {
    constexpr double kLeastLean = 0.01;
    const Vec3 aside = vector - axis_.dot(vector) * axis_;
    is_seen_ = is_seen_ && aside.norm() > kLeastLean * vector.norm();
    if (last_) angle_ += std::atan2(axis_.dot(last_->cross(aside)), last_->dot(aside));
    last_ = aside;
  }
  std::optional<double> rounds() const {
    return is_seen_ && last_ ? std::optional(angle_ / (2.0 * std::numbers::pi)) : std::nullopt;
  }

 private:
  Vec3 axis_;
  std::optional<Vec3> last_;
  double angle_ = 0.0;
  bool is_seen_ = true;
};

/// "0.66 times", "once".
std::string rounds_words(double rounds, Language language) {
  constexpr double kHundredths = 100.0;
  const double rounded = std::round(std::abs(rounds) * kHundredths) / kHundredths;
  return rounded == 1.0 ? std::string(words::kOnce.in(language))
                        : words::kSoManyTimes.with(language, {short_number_words(rounded, 4, language)});
}

int largest_component(const Vec3& vector) {
  int largest = 0;
  vector.cwiseAbs().maxCoeff(&largest);
  return largest;
}

/// Of one of the scenes that a model shows.
class ChangeInWords {
 public:
  ChangeInWords(const SceneModel& model, const SceneInWords& said, double from_s, double to_s, double t_s)
      : model_(model),
        said_(said),
        scene_(model.scene),
        language_(scene_.language),
        from_s_(from_s),
        to_s_(to_s),
        t_s_(t_s) {}

  std::string run() const {
    const bool is_seen_from_space =
        std::find(scene_.views.begin(), scene_.views.end(), View::space) != scene_.views.end();
    if (is_seen_from_space && model_.needs.attitude) {
      if (t_s_ == from_s_) return "";
      std::string text = scene_.torque.empty() && draws(scene_, Overlay::L) ? round_L() : "";
      if (text.empty()) text = turned_axis();
      for (const std::string& more : {arrow_A(), centre()})
        if (!more.empty()) text += (text.empty() ? "" : " ") + more;
      return text;
    }
    if (!draws(scene_, Overlay::omega) && !draws(scene_, Overlay::L)) return "";
    std::string rounds = t_s_ == from_s_ ? "" : round_axis();
    return rounds.empty() ? components() : rounds;
  }

 private:
  /// ω where it is drawn, else L.
  Vec3 vector_at(double t_s) const {
    const Vec3 w_B = model_.motion->w_B_at(t_s);
    return draws(scene_, Overlay::omega) ? w_B : angular_momentum_B(scene_.body.moments, w_B);
  }

  std::string axis_words(int axis) const {
    const std::string& name = said_.axes[static_cast<std::size_t>(axis)];
    return name.empty() ? words::kAxis.with(language_, {std::to_string(axis + 1)}) : name;
  }

  /// Of the axis of symmetry, and of another. Of other bodies rounds tell nothing: an axis may come close to
  /// L, and turn over.
  std::string round_L() const {
    const Vec3 L_B = angular_momentum_B(scene_.body.moments, model_.motion->w_B_at(from_s_));
    if (L_B.isZero(0.0)) return "";
    const Vec3 L_S = model_.motion->at(from_s_).q_SB * L_B;
    const int nearest = largest_component(L_B);
    constexpr double kAlike = 1e-6;
    const Vec3& I = scene_.body.moments.vector();
    const double one = I[(nearest + 1) % 3], other = I[(nearest + 2) % 3];
    if (std::abs(one - other) > kAlike * one) return "";
    const std::array<int, 2> axes = {nearest, (nearest + 1) % 3};
    std::array<Rounds, 2> rounds = {Rounds(L_S), Rounds(L_S)};
    for (const double t_s : instants(model_, from_s_, t_s_)) {
      const Quat q_SB = model_.motion->at(t_s).q_SB;
      for (std::size_t i = 0; i < 2; ++i) rounds[i].add(q_SB * Vec3(Vec3::Unit(axes[i])));
    }
    const auto first = rounds[0].rounds(), second = rounds[1].rounds();
    const std::string from = time_words(from_s_, language_);
    if (!first && !second) return "";
    if (first && second)
      return words::kBothWentRoundL.with(
          language_, {from, axis_words(axes[0]), rounds_words(*first, language_), axis_words(axes[1]),
                      rounds_words(*second, language_)});
    return words::kWentRoundL.with(language_, {from, axis_words(first ? axes[0] : axes[1]),
                                               rounds_words(first ? *first : *second, language_)});
  }

  /// By how much a vector that goes with the motion points away from where it pointed.
  template <class Vector>
  double away_deg(const Vector& vector_S, double t_s) const {
    return angle_between(vector_S(from_s_), vector_S(t_s)) * kDegreesPerRadian;
  }

  std::string whole_degrees(double angle_deg) const {
    return with_unit(fmt::format("{:.0f}", angle_deg), "deg", language_);
  }

  auto axis_S(int axis) const {
    return [this, axis](double t_s) { return model_.motion->at(t_s).q_SB * Vec3(Vec3::Unit(axis)); };
  }

  /// The axis about which it turns, or, if that stays where it is, the next that does not: all pictures of
  /// the motion are told by one. Nothing if none moves.
  std::optional<int> axis_that_turns() const {
    constexpr double kSeen_deg = 0.5;
    const int first = largest_component(model_.motion->w_B_at(from_s_));
    const std::vector<double> times = instants(model_, from_s_, to_s_);
    if (times.empty()) return first;
    for (int i = 0; i < 3; ++i) {
      const int axis = (first + i) % 3;
      if (std::any_of(times.begin(), times.end(),
                      [&](double t_s) { return away_deg(axis_S(axis), t_s) >= kSeen_deg; }))
        return axis;
    }
    return std::nullopt;
  }

  std::string turned_axis() const {
    const std::optional<int> axis = axis_that_turns();
    if (!axis) return "";
    return words::kAxisPoints.with(language_,
                                   {std::to_string(*axis + 1), whole_degrees(away_deg(axis_S(*axis), t_s_)),
                                    time_words(from_s_, language_)});
  }

  std::string arrow_A() const {
    if (!drawn_overlays(scene_).contains(Overlay::transport)) return "";
    const double angle_deg = away_deg([this](double t_s) { return arrow_A_S(model_, t_s); }, t_s_);
    return words::kArrowAPoints.with(language_, {whole_degrees(angle_deg), time_words(from_s_, language_)});
  }

  std::string centre() const {
    if (!drifts(scene_)) return "";
    const Vec3 way_S = translation_at(scene_, t_s_).r_S - translation_at(scene_, from_s_).r_S;
    return words::kCentreIsAway.with(
        language_, {with_unit(short_number_words(way_S.norm(), 3, language_), "m", language_),
                    time_words(from_s_, language_)});
  }

  /// Where it goes at least a part of a round over all that is shown, about one axis.
  std::string round_axis() const {
    constexpr double kLeastRounds = 0.25;
    const Vec3 begin = vector_at(from_s_);
    if (begin.isZero(0.0)) return "";
    const int axis = largest_component(begin);
    Rounds all(Vec3::Unit(axis));
    for (const double t_s : instants(model_, from_s_, to_s_)) {
      const Vec3 vector_B = vector_at(t_s);
      if (!(vector_B[axis] * begin[axis] > 0.0)) return "";
      all.add(vector_B);
    }
    if (!all.rounds() || std::abs(*all.rounds()) < kLeastRounds) return "";
    Rounds now(Vec3::Unit(axis));
    for (const double t_s : instants(model_, from_s_, t_s_)) now.add(vector_at(t_s));
    return words::kWentRoundAxis.with(
        language_, {time_words(from_s_, language_), draws(scene_, Overlay::omega) ? "ω" : "L",
                    rounds_words(*now.rounds(), language_), std::to_string(axis + 1),
                    (*now.rounds() < 0.0 ? words::kClockwise : words::kAnticlockwise).in(language_)});
  }

  std::string components() const {
    const Vec3 vector_B = vector_at(t_s_);
    const double last = 1e-3 * vector_B.norm();  // what no reader could see is 0
    const auto component = [&](int i) {
      return short_number_words(std::abs(vector_B[i]) < last ? 0.0 : vector_B[i], 3, language_);
    };
    return (draws(scene_, Overlay::omega) ? words::kOmegaInBody : words::kLInBody)
        .with(language_, {component(0), component(1), component(2)});
  }

  const SceneModel& model_;
  const SceneInWords& said_;
  const Scene& scene_;
  Language language_;
  double from_s_, to_s_, t_s_;
};

/// Both ends of each curve of a plot of orders, and how steep it is.
std::string orders_in_words(const SceneModel& model) {
  const Language language = model.scene.language;
  const bool by_evaluations = model.scene.compared.by_evaluations;
  const auto number = [&](double value, int digits) { return short_number_words(value, digits, language); };
  std::vector<std::string> told;
  for (const MethodOrder& one : method_orders(model.orders, by_evaluations)) {
    const auto [first_work, first_error] = one.points.front();
    const auto [last_work, last_error] = one.points.back();
    told.push_back((by_evaluations ? words::kMethodInEvaluations : words::kMethodInSteps)
                       .with(language, {facts_of(one.method).term, number(first_error, 2),
                                        number(std::round(first_work), 6), number(last_error, 2),
                                        number(std::round(last_work), 6)}));
    if (one.order) told.back() += words::kOfOrder.with(language, {number(*one.order, 2)});
  }
  return told.empty() ? "" : capitalized(fmt::format("{}. ", fmt::join(told, "; ")));
}

/// @param computed what is told of a diagram's curves, which it prints whatever is asked
/// @param before the scene that was told before it, whose body need not be told again; null: there is none
std::string scene_in_words(const Scene& scene, const SceneInWords& said, const std::string& computed,
                           const Vec3& w_B, double t_s, const Scene* before) {
  const OverlaySet drawn = drawn_overlays(scene);
  const bool has_marks = draws_marks(scene);
  const Language language = scene.language;
  std::string text =
      shows_nothing(drawn, has_marks) && !scene.meters.empty()
          ? std::string(words::kPlotsAlone.in(language))
          : fmt::format(
                "{}: {}. ",
                (shows_space(drawn, has_marks) ? view_words(scene.views) : diagram_words(drawn)).in(language),
                shown_words(scene, drawn, said.marks));
  text += computed;
  if (const std::string& caption = said.caption; !caption.empty() && caption_holds(scene, t_s))
    text += caption + (caption.ends_with('.') ? " " : ". ");
  if (before == nullptr || !(before->body == scene.body)) {
    const Vec3& I = scene.body.moments.vector();
    const auto moment = [&](int i) { return short_number_words(I[i], 4, language); };
    // What a body is called in lessons are English words.
    const bool has_name = language == Language::en && !said.body.empty();
    text +=
        words::kTheBodyIs.with(language, {has_name ? std::string_view(said.body) : words::kBody.in(language),
                                          moment(0), moment(1), moment(2)});
  }
  if (!said.is_asked) return text + moment_words(scene, w_B, t_s);
  text.pop_back();
  return text;
}

}  // namespace

std::string alt_text(const Scene& scene, const SceneInWords& said, const Vec3& w_B, double t_s) {
  return scene_in_words(scene, said, "", w_B, t_s, nullptr);
}

std::string alt_text(const SceneModel& model, const std::vector<SceneInWords>& said, double t_s) {
  const std::vector<const SceneModel*> shown = shown_models(model);
  std::string text;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (shown.size() > 1)
      text +=
          (i > 0 ? " " : "") + words::kSceneOf.with(shown[i]->scene.language,
                                                    {std::to_string(i + 1), std::to_string(shown.size())});
    text += scene_in_words(shown[i]->scene, said[i], orders_in_words(*shown[i]),
                           shown[i]->motion->w_B_at(t_s), t_s, i > 0 ? &shown[i - 1]->scene : nullptr);
  }
  return text;
}

std::string moment_in_words(const SceneModel& model, const std::vector<SceneInWords>& said, double from_s,
                            double to_s, double t_s) {
  const std::vector<const SceneModel*> shown = shown_models(model);
  const Language language = model.scene.language;
  std::string text = t_s == from_s ? "" : words::kTheSameAt.with(language, {time_words(t_s, language)});
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const SceneInWords words_of_scene = i < said.size() ? said[i] : SceneInWords{};
    const std::string change = ChangeInWords(*shown[i], words_of_scene, from_s, to_s, t_s).run();
    if (change.empty()) continue;
    if (!text.empty()) text += ' ';
    if (shown.size() > 1) text += words::kScene.with(language, {std::to_string(i + 1)});
    text += change;
  }
  return text;
}

}  // namespace polhode
