// SPDX-License-Identifier: MIT
#include "app/web/live_json.h"

#include "app/session/omega_drag.h"
#include "base/angles.h"
#include "lessons/reader/scene/varied_scene.h"
#include "physics/analysis/characteristic_time.h"
#include "physics/analysis/euler_terms.h"
#include "physics/body/euler.h"
#include "physics/method.h"
#include "render/scene/model/scene_needs.h"
#include "render/scene/model/scene_problem.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <variant>

namespace polhode {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Vec3& v) { return {v[0], v[1], v[2]}; }

template <class T>
Json json_of(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

const char* name_of(StepControl control) {
  switch (control) {
    case StepControl::none:
      return "none";
    case StepControl::fixed:
      return "fixed";
    default:
      return "adaptive";
  }
}

Method method_of(const Scene& scene) {
  return scene.motion.method.value_or(default_method(problem_of(scene)));
}

Json json_of_method(const SceneModel& model) {
  const MethodFacts& facts = facts_of(method_of(model.scene));
  const MotionSpec& spec = model.scene.motion;
  const bool adapts = facts.control == StepControl::adaptive;
  return {{"name", facts.name},
          {"step", json_of(spec.step_s)},
          {"tolerance", adapts ? Json(spec.tolerance.value_or(kDefaultTolerance)) : Json(nullptr)},
          {"control", name_of(facts.control)},
          {"why", model.why},
          {"usual_step", table_step_s(model.scene)}};
}

Json json_of_variations(const LessonSession& session) {
  Json all = Json::array();
  for (const Variation& one : session.variations()) {
    const VariedNumber& facts = *find_varied_number(one.number);
    all.push_back({{"number", one.number},
                   {"label", facts.label},
                   {"from", one.from},
                   {"to", one.to},
                   {"value", one.value},
                   {"unit", facts.unit},
                   {"tex", facts.tex}});
  }
  return all;
}

Json json_of_overlays(const SceneModel& model) {
  Json all = Json::array();
  for (const OverlayFacts& facts : kOverlays)
    all.push_back({{"name", facts.name},
                   {"shown", model.scene.show.contains(facts.overlay)},
                   {"words", facts.words.in(model.scene.language)},
                   {"unseen", what_is_unseen(facts.overlay, model.scene)}});
  return all;
}

/// Null as well where an edit has L stand, which the lesson's scene and an address say in other ways.
Json json_of_attitude(const SceneEdits& edits) {
  const Quat* q_SB = edits.attitude ? std::get_if<Quat>(&*edits.attitude) : nullptr;
  return q_SB ? Json{q_SB->w(), q_SB->x(), q_SB->y(), q_SB->z()} : Json(nullptr);
}

/// Whether anything is there to be turned: a diagram is flat, and so are plots that stand alone.
bool is_in_space(const SceneModel& model) {
  const auto is = [](const SceneModel& one) {
    return shows_space(one.drawn, one.needs.marks) && !shows_nothing(one.drawn, one.needs.marks);
  };
  return is(model) || std::any_of(model.beside.begin(), model.beside.end(), is);
}

Json json_of_tips(const LiveFigure& figure, const SceneModel& model, double t_s) {
  Json all = Json::array();
  for (const TipOnScreen& tip : omega_tips(model, t_s, figure.insets()))
    all.push_back({{"x", tip.x}, {"y", tip.y}});
  return all;
}

/// Two digits; as a power of ten where that is shorter.
std::string size_in_words(double value, const char* unit) {
  const double size = std::abs(value);
  return size == 0 || (size >= 0.01 && size < 1000) ? fmt::format("{:.2g}{}", value, unit)
                                                    : fmt::format("{:.1e}{}", value, unit);
}

}  // namespace

std::string state_json(LiveFigure& figure, const std::string& message) {
  const SceneModel* model = figure.model();
  if (model == nullptr) return "null";
  const LessonSession& session = *figure.session();
  const Scene& scene = model->scene;
  const double t_s = session.t_s();
  const PrincipalMoments& I = scene.body.moments;
  const RigidBodyState now = model->motion->at(t_s);
  const Vec3 L_B = angular_momentum_B(I, now.w_B);
  const EulerTerms terms = euler_terms_at(*model->motion, I, scene.torque, t_s);
  const CameraSpec camera = session.camera();
  const LessonSession::Interval line = session.time_line();
  const AccuracyReading& accuracy = figure.accuracy();
  Json state = {
      {"t", t_s},
      {"omega", json_of(now.w_B)},
      {"quaternion", {now.q_SB.w(), now.q_SB.x(), now.q_SB.y(), now.q_SB.z()}},
      {"L", json_of(Vec3(now.q_SB * L_B))},
      {"T", kinetic_energy(I, now.w_B)},
      {"L_norm", L_B.norm()},
      {"terms",
       {{"inertial", json_of(terms.inertial_B)},
        {"gyroscopic", json_of(terms.gyroscopic_B)},
        {"torque", json_of(terms.N_B)}}},
      {"omega0", json_of(scene.w0_B)},
      {"attitude0", json_of_attitude(session.edits())},
      {"moments", json_of(I.vector())},
      {"body", scene.body.name},
      {"torque_free", scene.torque.empty()},
      {"camera",
       {{"azimuth", camera.azimuth_rad}, {"elevation", camera.elevation_rad}, {"zoom", camera.zoom}}},
      {"in_space", is_in_space(*model)},
      {"following", session.is_following()},
      {"stage", session.place().stage + 1},
      {"stage_id", session.stage().id},
      {"step", session.place().step + 1},
      {"changed", !session.edits().empty()},
      {"can_undo", session.can_undo()},
      {"playing", session.is_playing()},
      {"speed", session.speed()},
      {"rate", model->rate},
      {"from", line.from_s},
      {"to", line.to_s},
      {"duration", model->span_s},
      {"still", still_time_s(session.lesson_scene())},
      {"period", json_of(polhode_period(problem_of(scene)))},
      {"flips", session.shown_flips()},
      {"method", json_of_method(*model)},
      {"error", nullptr},
      {"drift",
       {{"T", accuracy.drift.T}, {"L", accuracy.drift.L}, {"L_direction", accuracy.drift.L_direction_rad}}},
      {"vary", json_of_variations(session)},
      {"overlays", json_of_overlays(*model)},
      {"tips", json_of_tips(figure, *model, t_s)},
      {"message", message}};
  if (accuracy.error)
    state["error"] = {{"omega", accuracy.error->omega}, {"attitude", accuracy.error->attitude_rad}};
  return state.dump();
}

std::string choices_json(const LiveFigure& figure) {
  const SceneModel* model = figure.model();
  if (model == nullptr) return "null";
  Json bodies = Json::array(), methods = Json::array();
  for (const std::string& name : named_bodies())
    bodies.push_back({{"name", name}, {"moments", json_of(find_body(name)->moments.vector())}});
  const Problem problem = problem_of(model->scene);
  for (const MethodFacts& facts : all_methods())
    methods.push_back({{"name", facts.name},
                       {"words", facts.term},
                       {"keeps", facts.keeps},
                       {"control", name_of(facts.control)},
                       {"why_not", json_of(why_not(facts.method, problem))}});
  return Json({{"bodies", bodies}, {"methods", methods}}).dump();
}

std::string words_json(LiveFigure& figure) {
  const SceneModel* model = figure.model();
  if (model == nullptr) return "null";
  const PrincipalMoments& I = model->scene.body.moments;
  const Vec3 w_B = model->motion->w_B_at(figure.session()->t_s());
  const Vec3 L_B = angular_momentum_B(I, w_B);
  Json captions = Json::array(), readouts = Json::array();
  for (const std::string& caption : figure.captions_now()) captions.push_back({{"text", caption}});
  const auto read = [&](const char* name, std::string value) {
    readouts.push_back({{"name", name}, {"value", std::move(value)}});
  };
  read("ω", fmt::format("({:.4g}, {:.4g}, {:.4g}) rad/s", w_B[0], w_B[1], w_B[2]));
  read("|ω|", fmt::format("{:.4g} rad/s", w_B.norm()));
  read("T", fmt::format("{:.5g} J", kinetic_energy(I, w_B)));
  read("|L|", fmt::format("{:.5g} kg m²/s", L_B.norm()));
  if (w_B.norm() > 0)
    read("angle between ω and L", fmt::format("{:.2f}°", angle_between(w_B, L_B) * kDegreesPerRadian));
  if (const auto& error = figure.accuracy().error) {
    read("error of ω", size_in_words(error->omega, ""));
    read("error of attitude", size_in_words(error->attitude_rad, " rad"));
  }
  return Json({{"alt", figure.alt_text_now()}, {"captions", captions}, {"readouts", readouts}}).dump();
}

}  // namespace polhode
