// SPDX-License-Identifier: MIT
#include "render/scene/model/scene_needs.h"

#include "base/words/figure_words.h"
#include "render/scene/model/drawn_marks.h"
#include "render/scene/model/heavy_top_body.h"
#include "render/scene/model/translation.h"

#include <algorithm>
#include <array>

namespace polhode {
namespace {

bool contains(const std::vector<View>& views, View view) {
  return std::find(views.begin(), views.end(), view) != views.end();
}

/// What holds of a scene, of all that overlays may ask for.
SeenIf what_holds(const Scene& scene) {
  SeenIf holds = SeenIf::always;
  const auto if_so = [&](bool so, SeenIf what) { holds = so ? holds | what : holds; };
  const AttitudeSpec attitude = scene.attitude.value_or(LPoints::down);
  const LPoints* points = std::get_if<LPoints>(&attitude);
  if_so(scene.torque.empty(), SeenIf::free);
  if_so(!scene.torque.empty(), SeenIf::torque);
  if_so(!scene.torque.empty() || !scene.w0_B.isZero(0.0), SeenIf::moves);
  if_so(contains(scene.views, View::space), SeenIf::space_view);
  if_so(points && *points == LPoints::down, SeenIf::L_down);
  if_so(drifts(scene), SeenIf::translates);
  if_so(!scene.F_S.isZero(0.0), SeenIf::force);
  if_so(heavy_top_of(scene) != nullptr, SeenIf::pivot);
  return holds;
}

}  // namespace

OverlaySet drawn_overlays(const Scene& scene) {
  const SeenIf holds = what_holds(scene);
  const bool turns = scene.show.contains(Overlay::turn_orders);
  OverlaySet drawn;
  for (int i = 0; i < kOverlayCount; ++i) {
    const OverlayFacts& facts = facts_of(static_cast<Overlay>(i));
    const bool is_seen = (facts.seen_if | holds) == holds && (!turns || facts.stays_in_turns);
    if (is_seen && scene.show.contains(facts.overlay)) drawn.insert(facts.overlay);
  }
  return drawn;
}

bool is_computed(const Scene& scene) {
  return scene.motion.method && facts_of(*scene.motion.method).control != StepControl::none;
}

bool frame_needs_motion(const Scene& scene) {
  const OverlaySet drawn = drawn_overlays(scene);
  return scene.camera.holds_still || drifts(scene) || requirements(scene).marks || !scene.torque.empty() ||
         is_computed(scene) || drawn.contains(Overlay::puck) || drawn.contains(Overlay::transport) ||
         drawn.contains(Overlay::terms);
}

std::string what_is_unseen(Overlay overlay, const Scene& scene) {
  struct Reason {
    SeenIf lacking;
    Phrase words;
  };
  constexpr std::array kReasons = {
      Reason{SeenIf::free, words::kATorqueActs},      Reason{SeenIf::torque, words::kNoTorqueActs},
      Reason{SeenIf::moves, words::kBodyIsAtRest},    Reason{SeenIf::space_view, words::kSeenFromSpaceOnly},
      Reason{SeenIf::L_down, words::kLevelWithLDown}, Reason{SeenIf::translates, words::kCentreIsAtRest},
      Reason{SeenIf::force, words::kNoForceActs},     Reason{SeenIf::pivot, words::kNoHeavyTop}};
  const OverlayFacts& facts = facts_of(overlay);
  const Language language = scene.language;
  const SeenIf holds = what_holds(scene);
  if (scene.show.contains(Overlay::turn_orders) && !facts.stays_in_turns)
    return std::string(words::kIsTurnedByHand.in(language));
  for (const Reason& reason : kReasons) {
    const bool is_asked = (facts.seen_if | reason.lacking) == facts.seen_if;
    if (is_asked && (holds | reason.lacking) != holds)
      return words::kShowsNothing.with(language, {reason.words.in(language)});
  }
  return "";
}

namespace {

/// A quantity of the lesson's own may speak of all there is of a motion.
bool needs_attitude(const PlotSpec& plot, const Scene& scene) {
  const auto* meter = std::get_if<Meter>(&plot);
  return meter == nullptr || *meter == Meter::drift || (*meter == Meter::momentum && !scene.torque.empty());
}

/// A ghost of the exact motion would hide in the same motion.
bool asks_for_ghost(const Scene& scene) {
  return scene.motion.ghost && scene.motion.method &&
         facts_of(*scene.motion.method).control != StepControl::none;
}

Requirements requirements_of_figure(const Scene& scene) {
  const OverlaySet show = drawn_overlays(scene);
  const auto shown = [&](Overlay o) { return show.contains(o); };
  const bool in_space = contains(scene.views, View::space);
  const bool in_body = contains(scene.views, View::body);
  const bool turns = shown(Overlay::turn_orders);  // by a hand: no motion
  Requirements needs;
  for (int i = 0; i < kOverlayCount; ++i) {
    const OverlayFacts& facts = facts_of(static_cast<Overlay>(i));
    if (!shown(facts.overlay)) continue;
    for (bool Requirements::*part : facts.needs)
      if (part) needs.*part = true;
    needs.attitude = needs.attitude || facts.attitude == AttitudeIn::both ||
                     (facts.attitude == AttitudeIn::space && in_space && !turns) ||
                     (facts.attitude == AttitudeIn::body && in_body);
  }
  needs.marks = draws_marks(scene);
  needs.herpolhode = needs.herpolhode && in_space;
  needs.attitude = needs.attitude || needs.herpolhode || needs.marks || (in_body && drifts(scene)) ||
                   depends_on_attitude(scene.torque);
  needs.omega = needs.omega || needs.attitude || needs.polhode;
  needs.ghost =
      asks_for_ghost(scene) && (needs.solid || shown(Overlay::omega) || shown(Overlay::L)) && !turns;
  return needs;
}

}  // namespace

Requirements requirements(const Scene& scene, ModelFor use) {
  if (use == ModelFor::numbers) return {.omega = true, .attitude = true};
  Requirements needs = requirements_of_figure(scene);
  if (use == ModelFor::figure) return needs;
  for (const PlotSpec& plot : scene.meters) {
    needs.meters = needs.omega = true;
    needs.attitude = needs.attitude || needs_attitude(plot, scene);
  }
  return needs;
}

}  // namespace polhode
