// SPDX-License-Identifier: MIT
#include "app/session/lesson_session.h"

#include "app/session/answers/answer_keys.h"
#include "base/words/page_words.h"
#include "lessons/derivation/answer_reasons.h"
#include "lessons/reader/questions/line_notation.h"
#include "lessons/reader/questions/state_task.h"
#include "lessons/reader/scene/varied_scene.h"
#include "physics/body/euler.h"
#include "physics/geometry/flips.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace polhode {

namespace {

bool starts_another_motion(const SceneEdits& a, const SceneEdits& b) {
  return a.body != b.body || a.w0_B != b.w0_B || a.attitude != b.attitude || a.torque != b.torque;
}

/// Whether the motion is that of the lesson, computed as it is there.
bool keeps_motion(const SceneEdits& edits) {
  return !starts_another_motion(edits, SceneEdits{}) && !edits.motion && edits.numbers.empty();
}

/// The principal axis whose heading about the vertical is the body's: of the smallest and the largest moment
/// the one that L stays farther from on its polhode, so that it never points along L, which the lectures have
/// vertical. With I_a < I_b < I_c, L_a² is at most I_a (2T I_c − L²)/(I_c − I_a), L_c² at most
/// I_c (L² − 2T I_a)/(I_c − I_a).
Vec3 heading_axis_B(const Scene& scene) {
  const Vec3& I = scene.body.moments.vector();
  const Vec3 L_B = angular_momentum_B(scene.body.moments, scene.w0_B);
  int a = 0, c = 0;
  I.minCoeff(&a);
  I.maxCoeff(&c);
  if (I[a] == I[c]) {
    L_B.cwiseAbs().minCoeff(&a);
    return Vec3::Unit(a);
  }
  const Vec3 two_T_of_axes = L_B.cwiseAbs2().cwiseQuotient(I);
  const double nearest_a = I[a] * (I[c] - I.array()).matrix().dot(two_T_of_axes);
  const double nearest_c = I[c] * (I.array() - I[a]).matrix().dot(two_T_of_axes);
  return Vec3::Unit(nearest_a < nearest_c ? a : c);
}

bool is_seen_from_space(const Scene& scene) {
  return std::find(scene.views.begin(), scene.views.end(), View::space) != scene.views.end();
}

}  // namespace

LessonSession::LessonSession(std::shared_ptr<const LoadedLesson> loaded, Effort effort)
    : loaded_(std::move(loaded)), effort_(std::move(effort)) {
  assert(loaded_ != nullptr && !lesson().stages.empty());
  visited_.insert(stage().id);
  show_lesson_scene();
}

LessonSession::~LessonSession() = default;

std::optional<StepPlace> LessonSession::next_place() const {
  if (place_.step + 1 < stage().steps.size()) return StepPlace{place_.stage, place_.step + 1};
  const auto next = stage_beside(1);
  return next ? std::optional(StepPlace{*next, 0}) : std::nullopt;
}

std::optional<StepPlace> LessonSession::previous_place() const {
  if (place_.step > 0) return StepPlace{place_.stage, place_.step - 1};
  const auto before = stage_beside(-1);
  return before ? std::optional(StepPlace{*before, lesson().stages[*before].steps.size() - 1}) : std::nullopt;
}

bool LessonSession::next_step() {
  const auto next = next_place();
  if (next) go_to(*next);
  return next.has_value();
}

bool LessonSession::previous_step() {
  const auto previous = previous_place();
  if (previous) go_to(*previous);
  return previous.has_value();
}

bool LessonSession::next_stage() {
  const auto next = stage_beside(1);
  if (next) go_to({*next, 0});
  return next.has_value();
}

bool LessonSession::previous_stage() {
  const auto to = place_.step > 0 ? place_.stage : stage_beside(-1);
  if (to) go_to({*to, 0});
  return to.has_value();
}

void LessonSession::go_to(StepPlace place) {
  place.stage = std::min(place.stage, lesson().stages.size() - 1);
  place.step = std::min(place.step, lesson().stages[place.stage].steps.size() - 1);
  if (place != place_) arrive(place);
}

void LessonSession::replay_step() {
  if (place_.step == 0) return;
  transition_ = 0;
  transition_s_ = kReplaySlowness * kMorphSeconds;
}

void LessonSession::begin_at(StepPlace place) {
  const std::string left = stage().id;
  go_to(place);
  if (!visited_before_.contains(left) && stage().id != left) visited_.erase(left);
}

void LessonSession::arrive(StepPlace place) {
  const bool same_stage = place.stage == place_.stage;
  const std::shared_ptr<const Scene> left = step().scene;
  keep_edits();
  transition_ = same_stage && place.step == place_.step + 1 && !preferences.reduced_motion ? 0 : 1;
  transition_s_ = kMorphSeconds;
  place_ = place;
  enlarged_ = false;
  visited_.insert(stage().id);
  judged_.clear();
  derivations_.clear();
  awaited_.reset();
  const bool both = left != nullptr && has_scene();
  if (same_stage && (left == step().scene || (both && *left == *step().scene))) return;

  const bool goes_on = same_stage && both && same_course(*left, *step().scene) && keeps_motion(edits_);
  const double t_s = t_s_;
  const bool playing = playing_;
  const auto turned =
      same_stage && both && left->camera == lesson_scene().camera ? edits_.camera : std::nullopt;
  if (!same_stage) following_ = false;
  show_lesson_scene();
  const auto kept = kept_.find(step().scene.get());
  const bool is_kept = kept != kept_.end() && set_edits(kept->second.edits);
  const bool comes_back = is_kept && !kept->second.edits.empty();
  undo_ = is_kept ? kept->second.undo : std::vector<Change>{};
  redo_ = is_kept ? kept->second.redo : std::vector<Change>{};
  change_is_new_ = true;
  if (goes_on) {
    set_time(t_s);
    playing_ = playing;
  }
  if (turned && !comes_back) set_camera(*turned);
}

/// Before the present scene is left, and with it what stands in its place: a counterexample is not kept.
void LessonSession::keep_edits() {
  if (!has_scene()) return;
  forget_counterexamples();
  const SceneEdits& made = aside_ ? aside_->before : edits_;
  std::vector<Change> undo = undo_;
  if (aside_) undo.resize(aside_->changes);
  if (made.empty() && undo.empty() && redo_.empty())
    kept_.erase(step().scene.get());
  else
    kept_[step().scene.get()] = {made, std::move(undo), redo_};
}

void LessonSession::set_visited(const std::set<std::string>& stages) {
  std::set<std::string> seen = {stage().id};  // what is given may be visited_ itself
  for (const Stage& known : lesson().stages)
    if (stages.count(known.id) > 0) seen.insert(known.id);
  visited_before_ = stages;
  visited_ = std::move(seen);
}

void LessonSession::replace_lesson(std::shared_ptr<const LoadedLesson> loaded) {
  assert(loaded != nullptr && !loaded->lesson.stages.empty());
  const std::string id = stage().id;
  const bool had_scene = has_scene();
  const std::shared_ptr<const LoadedLesson> old = std::exchange(loaded_, std::move(loaded));
  kept_.clear();
  const auto& stages = lesson().stages;
  const auto same = std::find_if(stages.begin(), stages.end(), [&](const Stage& s) { return s.id == id; });
  if (same != stages.end()) place_.stage = static_cast<std::size_t>(same - stages.begin());
  place_.stage = std::min(place_.stage, stages.size() - 1);
  place_.step = std::min(place_.step, stage().steps.size() - 1);
  set_visited(visited_);
  set_left_out(left_out_);
  judged_.clear();
  derivations_.clear();
  awaited_.reset();
  transition_ = 1;

  SceneEdits kept = edits_;
  if (!has_scene() || kept.numbers.size() != step().scene->vary.size()) kept.numbers.clear();
  const double t_s = t_s_;
  const bool playing = playing_;
  show_lesson_scene();
  if (!had_scene || !has_scene()) return;
  static_cast<void>(set_edits(kept));
  set_time(t_s);
  playing_ = playing;
}

void LessonSession::show_lesson_scene() {
  playing_ = false;
  edits_ = {};
  undo_.clear();
  redo_.clear();
  change_is_new_ = true;
  aside_.reset();
  t_s_ = loop_ = 0;
  model_.reset();
  if (!has_scene()) return;
  make_model_of({});
  reset_time();
  if (following_) heading_rad_ = heading_at(t_s_);  // another motion begins with the scene's camera
  patch_model();
}

const Scene& LessonSession::lesson_scene() const {
  return step().varied ? step().varied->alone() : *step().scene;
}

Scene LessonSession::scene_with(const SceneEdits& edits) const {
  if (edits.numbers.empty() || !step().varied) return edited(lesson_scene(), edits);
  Result<Scene> varied = step().varied->at(edits.numbers);
  if (!varied) throw std::domain_error(varied.error());
  return edited(std::move(varied).value(), edits);
}

void LessonSession::make_model_of(const SceneEdits& edits) {
  model_ = std::make_unique<SceneModel>(make_model(scene_with(edits), ModelFor::page, effort_));
  edits_ = edits;
  ++model_number_;
}

void LessonSession::patch_model() {
  if (!model_) return;
  Scene& scene = model_->scene;
  scene.camera = camera();
  scene.quality = edits_.quality.value_or(lesson_scene().quality);
  scene.highlight = with_lit(lesson_scene());
  for (std::size_t i = 0; i < model_->beside.size(); ++i) {
    const Scene& of_lesson = lesson_scene().beside[i];
    Scene& other = model_->beside[i].scene;
    other.camera = camera_beside(lesson_scene().camera, of_lesson.camera, scene.camera);
    other.quality = scene.quality;
    other.highlight = with_lit(of_lesson);
    scene.beside[i] = other;
  }
}

std::vector<std::string> LessonSession::with_lit(const Scene& scene) const {
  std::vector<std::string> lights = scene.highlight;
  if (overlay_from(lit_) && std::find(lights.begin(), lights.end(), lit_) == lights.end())
    lights.push_back(lit_);
  return lights;
}

// Time.

void LessonSession::set_time(double t_s) {
  if (!model_ || !std::isfinite(t_s)) return;
  t_s = std::clamp(t_s, -model_->reach_s, model_->reach_s);
  if (!is_computable(*model_, t_s)) return;
  t_s_ = t_s;
  const Interval shown = time_line();
  if (t_s_ < shown.from_s || t_s_ > shown.to_s) loop_ = std::floor(t_s_ / model_->span_s);
  if (following_) patch_model();
}

void LessonSession::set_playing(bool playing) { playing_ = playing && model_; }

void LessonSession::set_speed(double speed) {
  if (!std::isnan(speed)) speed_ = std::clamp(speed, kSlowest, kFastest);
}

void LessonSession::scrub_to(double t_s) { set_time(t_s); }

void LessonSession::step_frames(int frames) {
  if (!model_) return;
  playing_ = false;
  set_time(t_s_ + frames * kFrameSeconds * model_->rate);
}

void LessonSession::reset_time() {
  if (!has_scene()) return;
  loop_ = 0;  // of the first loop the end is its end, not the beginning of the next
  set_time(still_time_s(lesson_scene()));
}

std::optional<double> LessonSession::flip_beside(int way) const {
  std::optional<double> nearest;
  for (const double t_s : shown_flips()) {
    const double ahead_s = way * (t_s - t_s_);
    if (ahead_s > 1e-9 * model_->span_s && (!nearest || ahead_s < way * (*nearest - t_s_))) nearest = t_s;
  }
  return nearest;
}

void LessonSession::go_to_flip(int way) {
  const auto nearest = flip_beside(way);
  if (!nearest) return;
  playing_ = false;
  set_time(*nearest);
}

void LessonSession::advance(double seconds) {
  if (!(seconds > 0)) return;
  transition_ = preferences.reduced_motion ? 1 : std::min(1.0, transition_ + seconds / transition_s_);
  if (!playing_) return;
  double next_s = t_s_ + model_->rate * speed_ * seconds;
  if (awaited_ && next_s >= awaited_->to_s) return end_play();
  const Interval loop = time_line();
  if (lesson_scene().duration_s && next_s > loop.to_s)  // what has an end begins again
    next_s = loop.from_s + std::fmod(next_s - loop.from_s, model_->span_s);
  set_time(next_s);
  if (t_s_ == next_s) return;
  playing_ = false;
  awaited_.reset();  // what cannot be played is not waited for
}

LessonSession::Interval LessonSession::time_line() const {
  assert(model_);
  return {loop_ * model_->span_s, (loop_ + 1) * model_->span_s};
}

const std::vector<double>& LessonSession::flips() const {
  if (model_ && flips_.model_number == model_number_ && flips_.loop == loop_) return flips_.times_s;
  flips_ = {model_number_, loop_, {}};
  if (!model_ || !model_->needs.omega) return flips_.times_s;
  const auto [from_s, to_s] = time_line();
  flips_.times_s = flip_times(*model_->motion, model_->scene.body.moments, std::max(from_s, -model_->reach_s),
                              std::min(to_s, model_->reach_s));
  return flips_.times_s;
}

std::vector<double> LessonSession::shown_flips() const {
  std::vector<double> shown = flips();
  if (!is_predicting()) return shown;
  const double known_s = still_time_s(lesson_scene());
  std::erase_if(shown, [=](double t_s) { return t_s > known_s; });
  return shown;
}

// The scene.

Status LessonSession::set_edits(const SceneEdits& edits) {
  if (!has_scene()) return failure("this step has no scene");
  SceneEdits wanted = edits;
  if (following_ && wanted.camera == edits_.camera) wanted.camera = camera();
  if (wanted.camera) wanted.camera = writable(*wanted.camera);
  if (wanted.attitude) wanted.attitude = writable(*wanted.attitude);
  const SceneEdits before = edits_;
  const double before_s = t_s_;
  bool another = false;
  try {
    if (same_model(scene_with(wanted), scene_with(edits_))) {
      edits_ = wanted;
    } else {
      another = starts_another_motion(wanted, edits_);
      make_model_of(wanted);
      go_on_from(another ? 0 : t_s_);
    }
  } catch (const std::domain_error& error) {
    return failure(error.what());
  }
  note_change(before, before_s);
  if (aside_ && another) aside_->is_changed = true;
  heading_rad_ = heading_at(t_s_);
  patch_model();
  return success();
}

void LessonSession::note_change(const SceneEdits& before, double before_s) {
  constexpr std::size_t kMostKept = 100;
  SceneEdits of_look_before = before;  // a camera is turned back by hand
  of_look_before.camera = edits_.camera;
  if (of_look_before == edits_) return;
  if (std::exchange(change_is_new_, false)) {
    redo_.clear();
    undo_.push_back({before, before_s, {}, aside_});
    if (undo_.size() > kMostKept) {
      undo_.erase(undo_.begin());
      if (aside_ && aside_->changes > 0) --aside_->changes;
    }
  }
  if (!undo_.empty()) undo_.back().camera = edits_.camera;
}

/// To what was before the last of `from`; what is shown now is what the last of `to` leads back to.
bool LessonSession::go_back(std::vector<Change>& from, std::vector<Change>& to) {
  if (from.empty()) return false;
  Change change = std::move(from.back());
  from.pop_back();
  Change back{edits_, t_s_, {}, aside_};
  if (edits_.camera != change.camera) change.before.camera = edits_.camera;
  const bool another = starts_another_motion(change.before, edits_);
  std::vector<Change> undo = std::move(undo_), redo = std::move(redo_);  // this is no change by hand
  const bool is_made = static_cast<bool>(set_edits(change.before));
  if (is_made && another) go_on_from(change.before_s);
  undo_ = std::move(undo);
  redo_ = std::move(redo);
  change_is_new_ = true;
  if (!is_made) return false;
  aside_ = std::move(change.aside);
  back.camera = edits_.camera;
  to.push_back(std::move(back));
  return true;
}

bool LessonSession::undo() { return go_back(undo_, redo_); }
bool LessonSession::redo() { return go_back(redo_, undo_); }

std::vector<Variation> LessonSession::variations() const {
  if (!step().varied) return {};
  std::vector<Variation> present = step().scene->vary;
  for (std::size_t i = 0; i < edits_.numbers.size(); ++i) present[i].value = edits_.numbers[i];
  return present;
}

Status LessonSession::vary(std::size_t number, double value) {
  const std::vector<Variation> present = variations();
  if (number >= present.size() || !std::isfinite(value)) return failure("this step has no such number");
  SceneEdits edits = edits_;
  edits.numbers.clear();
  bool is_lessons = true;
  for (std::size_t i = 0; i < present.size(); ++i) {
    edits.numbers.push_back(i == number ? std::clamp(value, present[i].from, present[i].to)
                                        : present[i].value);
    is_lessons = is_lessons && edits.numbers[i] == step().scene->vary[i].value;
  }
  if (is_lessons) edits.numbers.clear();
  return set_edits(edits);
}

void LessonSession::reset_edits() {
  if (!has_scene() || (edits_.empty() && !following_)) return;
  const bool another = starts_another_motion(edits_, SceneEdits{});
  const SceneEdits before = aside_ ? aside_->before : edits_;
  following_ = false;
  if (aside_) undo_.resize(aside_->changes);
  aside_.reset();
  make_model_of({});
  change_is_new_ = true;
  note_change(before, t_s_);
  change_is_new_ = true;
  go_on_from(another ? still_time_s(lesson_scene()) : t_s_);
  patch_model();
}

void LessonSession::go_on_from(double t_s) {
  if (t_s != t_s_) loop_ = 0;
  t_s_ = 0;  // the motion can be computed there at least
  set_time(t_s);
  if (t_s_ != t_s) playing_ = false;
}

void LessonSession::set_camera(const CameraSpec& camera) {
  if (!has_scene()) return;
  edits_.camera = writable(camera);
  heading_rad_ = heading_at(t_s_);
  patch_model();
}

void LessonSession::set_following(bool following) {
  if (!model_ || following == following_) return;
  const CameraSpec shown = camera();
  if (following_) edits_.camera = shown;
  following_ = following;
  heading_rad_ = heading_at(t_s_);
  patch_model();
}

double LessonSession::heading_at(double t_s) const {
  if (!model_ || !following_ || !is_seen_from_space(model_->scene)) return 0;
  const Vec3 axis_S = model_->motion->at(t_s).q_SB * heading_axis_B(model_->scene);
  return std::atan2(axis_S.y(), axis_S.x());
}

CameraSpec LessonSession::camera() const {
  if (!has_scene()) return {};
  CameraSpec camera = edits_.camera.value_or(lesson_scene().camera);
  if (!following_ || !model_) return camera;
  const double turned_rad = heading_at(t_s_) - heading_rad_;
  if (turned_rad == 0) return camera;
  camera = turned_from_here(camera);
  camera.azimuth_rad += turned_rad;
  return writable(camera);
}

void LessonSession::light(const std::string& name) {
  if (name == lit_) return;
  lit_ = name;
  patch_model();
}

// Questions.

std::vector<const Ask*> LessonSession::questions() const {
  std::vector<const Ask*> found;
  for (const Block& block : step().blocks)
    if (const auto* ask = std::get_if<Ask>(&block)) found.push_back(ask);
  return found;
}

const AnswerJudgement& LessonSession::answer(const Ask& ask, std::string_view text) {
  using Mark = AnswerJudgement::Mark;
  leave_answered();
  JudgedAnswer& judged = judged_[ask.id] = {
      std::string(text), ask.task ? judge_state(*ask.task, text, effort_)
                                  : judge_with_reasons(ask, text, Prover(), line_notation(lesson(), ask))};
  if (judged.judgement.mark != Mark::unreadable) {
    note_judged(answers_[answer_name(stage().id, ask.id)], judged.judgement, text);
    if (ask.plays && model_) play_for(ask);
  }
  return judged.judgement;
}

/// The lesson's motion, whatever was made of it before.
void LessonSession::play_for(const Ask& ask) {
  if (!keeps_motion(edits_)) reset_edits();
  if (preferences.reduced_motion) return set_time(ask.plays->to_s);
  set_time(ask.plays->from_s);
  set_playing(true);
  awaited_ = Awaited{ask.id, ask.plays->to_s};
}

void LessonSession::end_play() {
  if (!awaited_) return;
  set_time(awaited_->to_s);
  set_playing(false);
  awaited_.reset();
}

bool LessonSession::is_predicting() const {
  const std::vector<const Ask*> asked = questions();
  const bool is_played =
      std::any_of(asked.begin(), asked.end(), [this](const Ask* ask) { return is_awaited(*ask); });
  return is_played || has_open_prediction(*this);
}

const JudgedAnswer* LessonSession::judged(const Ask& ask) const {
  const auto found = judged_.find(ask.id);
  return found == judged_.end() ? nullptr : &found->second;
}

const AnswerRecord* LessonSession::record(const Ask& ask) const {
  const auto found = answers_.find(answer_name(stage().id, ask.id));
  return found == answers_.end() ? nullptr : &found->second;
}

DerivationWork& LessonSession::derivation(const Ask& ask) { return found_derivation(ask); }

DerivationWork& LessonSession::found_derivation(const Ask& ask) const {
  const auto [found, is_new] = derivations_.try_emplace(ask.id, lesson(), ask);
  const AnswerRecord* kept = is_new ? record(ask) : nullptr;
  if (kept != nullptr) found->second.restore(kept->last);
  return found->second;
}

void LessonSession::derive(const Ask& ask, std::string_view line) {
  leave_answered();
  DerivationWork& work = derivation(ask);
  const bool was_done = work.is_done();
  const LineJudgement& judgement = work.add(line);
  if (judgement.mark == LineJudgement::Mark::unreadable || was_done) return;
  AnswerRecord& record = answers_[answer_name(stage().id, ask.id)];
  note_try(record, work.is_done(), work.text());
  if (judgement.mark == LineJudgement::Mark::wrong) note_reason(record, name_of(judgement.slip));
}

void LessonSession::undo_derived_line(const Ask& ask) {
  leave_answered();
  derivation(ask).undo();
  if (const auto kept = answers_.find(answer_name(stage().id, ask.id)); kept != answers_.end())
    kept->second.last = derivation(ask).text();
}

namespace {

const Phrase& words_of(LineJudgement::Mark mark) {
  switch (mark) {
    case LineJudgement::Mark::holds:
      return words::kLineHolds;
    case LineJudgement::Mark::goal:
      return words::kLineIsGoal;
    case LineJudgement::Mark::away:
      return words::kLineLeadsAway;
    case LineJudgement::Mark::wrong:
      return words::kLineIsWrong;
    case LineJudgement::Mark::unreadable:
      break;
  }
  return words::kLineIsUnreadable;
}

ShownDerivedLine shown_line(const LineJudgement& judgement, Language language) {
  using Mark = LineJudgement::Mark;
  const bool leads_on = judgement.mark == Mark::holds || judgement.mark == Mark::goal;
  return {judgement.tex, std::string(words_of(judgement.mark).in(language)),
          leads_on                        ? Certainty::proved
          : judgement.mark == Mark::wrong ? Certainty::refuted
                                          : Certainty::open};
}

}  // namespace

ShownDerivation LessonSession::shown_derivation() const {
  for (const Ask* ask : questions()) {
    if (!ask->derivation || (!derivations_.contains(ask->id) && record(*ask) == nullptr)) continue;
    const DerivationWork& work = found_derivation(*ask);
    ShownDerivation shown{ask, {}};
    for (const DerivationWork::TypedLine& line : work.lines())
      shown.lines.push_back(shown_line(line.judgement, lesson().about.language));
    if (work.is_too_short()) {  // it is true, and not yet shown
      shown.lines.back().word = words::kGoalWithoutWay.in(lesson().about.language);
      shown.lines.back().certainty = Certainty::open;
    }
    const std::string typing = work.typed_tex();
    if (!typing.empty() && (shown.lines.empty() || shown.lines.back().tex != typing))
      shown.lines.push_back({typing, "", Certainty::stated});
    return shown;
  }
  return {};
}

void LessonSession::show_hint(const Ask& ask) {
  const AnswerRecord* known = this->record(ask);
  AnswerRecord record = known != nullptr ? *known : AnswerRecord();
  const auto shown =
      ask.derivation ? note_hint(record, DerivationWork::kMostHints) : note_help(record, ask.hints.size());
  if (shown) answers_[answer_name(stage().id, ask.id)] = std::move(record);
}

void LessonSession::forget_answer(const Ask& ask) {
  leave_answered();
  answers_.erase(answer_name(stage().id, ask.id));
  judged_.erase(ask.id);
  derivations_.erase(ask.id);
  if (is_awaited(ask)) awaited_.reset();
}

// How it is shown.

void LessonSession::change_text_scale(int steps) {
  const double present = preferences.text_scale;
  double wanted = std::clamp(present * std::pow(kTextScaleFactor, steps), kLeastTextScale, kMostTextScale);
  // From an end of the range the steps do not meet normal size: it is one of them all the same.
  if (std::abs(steps) == 1 && present != 1 && (present < 1) == (wanted > 1 - 1e-9)) wanted = 1;
  preferences.text_scale = std::abs(wanted - 1) < 1e-9 ? 1 : wanted;
}

bool LessonSession::is_moving() const { return playing_ || transition() < 1; }

}  // namespace polhode
