// SPDX-License-Identifier: MIT
// What is going on while a student walks through a lesson: the place, the time, what was changed of the
// scene, what was answered. No window, no files, no clock of its own: a window shows it and tells it what was
// done; a test does the same. The bodies of its members: lesson_session.cpp, of those before an audience
// presenting.cpp, of those of a counterexample shown_counterexample.cpp.
#pragma once

#include "app/page/loaded_lesson.h"
#include "app/page/page.h"
#include "app/page/page_theme.h"
#include "app/session/answers/answer_log.h"
#include "app/session/answers/derivation_work.h"
#include "app/session/scene_edits.h"
#include "lessons/claims/answers/answers.h"
#include "render/scene/model/model.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// What stands beside the page, or, of all lessons, over it; at most one at a time.
enum class Panel { none, outline, body, method, show, question, save, settings, lessons, help };

/// How a person likes it, in all lessons.
struct Preferences {
  Theme theme = Theme::paper;
  double text_scale = 1;        ///< kLeastTextScale … kMostTextScale
  bool reduced_motion = false;  ///< nothing fades, travels or plays by itself
  bool letter_keys = true;      ///< single letters and signs are commands (app/session/command.h)
  /// Of theme and motion, whether the person has chosen: else they are as the desktop wishes
  /// (app/window/desktop_wishes.h).
  bool own_theme = false, own_motion = false;
  bool operator==(const Preferences&) const = default;
};
inline constexpr double kTextScaleFactor = 1.1;  ///< of one step; the ends: app/page/page_theme.h

/// An answer, and what is to be said of it.
struct JudgedAnswer {
  std::string text;
  AnswerJudgement judgement;
};

inline constexpr double kSlowest = 1.0 / 16, kFastest = 16;
/// Single frames are those of a film: shown seconds.
inline constexpr double kFrameSeconds = 1.0 / 25;
/// How long one line of a derivation takes to become the next, shown seconds.
inline constexpr double kMorphSeconds = 0.7;
inline constexpr double kReplaySlowness = 5;

class LessonSession {
 public:
  /// At the first step, at rest. `loaded` is never null. Motions are computed with `effort`: what that throws
  /// comes out of whatever asks for one.
  explicit LessonSession(std::shared_ptr<const LoadedLesson> loaded, Effort effort = {});
  ~LessonSession();
  const Effort& effort() const { return effort_; }

  // The lesson, and where we are in it.
  const LoadedLesson& loaded() const { return *loaded_; }
  const std::shared_ptr<const LoadedLesson>& loaded_pointer() const { return loaded_; }
  const Lesson& lesson() const { return loaded_->lesson; }
  StepPlace place() const { return place_; }
  const Stage& stage() const { return lesson().stages[place_.stage]; }
  const Step& step() const { return stage().steps[place_.step]; }
  std::optional<StepPlace> next_place() const;      ///< nothing at the end
  std::optional<StepPlace> previous_place() const;  ///< nothing at the beginning
  /// Each returns false, and changes nothing, where there is no such place. Steps run on from stage to stage:
  /// before the first step of a stage comes the last one of the stage before. The two for stages go to first
  /// steps; previous_stage goes to the beginning of the present stage, unless that is where we are. Before an
  /// audience all of them pass over the stages that are left out.
  bool next_step();
  bool previous_step();
  bool next_stage();
  bool previous_stage();
  /// The nearest stage behind (1) or before (-1) the present one that is not passed over; nothing: there is
  /// none.
  std::optional<std::size_t> stage_beside(int way) const;
  /// A place that does not exist becomes the nearest that does. On another stage the scene is the lesson's
  /// again, at its own time and at rest, and the camera follows nothing. On another step of the same stage
  /// everything goes on as it is if the scene is the same. If it is another, edits do not go along, except a
  /// camera that was turned by hand and that the lesson does not turn; time goes on if the motion is the
  /// same. What was changed of a scene is there again when one comes back to it.
  void go_to(StepPlace place);
  /// The same before anything is shown: where it leaves was not seen, unless it is among those of
  /// set_visited.
  void begin_at(StepPlace place);
  /// Ids of stages that were seen, among those of the lesson.
  const std::set<std::string>& visited() const { return visited_; }
  void set_visited(const std::set<std::string>& stages);
  /// Goes on with another reading of the same lesson, whose file its author has changed. The place stays, as
  /// far as the lesson still has a stage of this id and that step; so do time, answers, and the edits unless
  /// they have become impossible. Pointers into the old reading dangle.
  void replace_lesson(std::shared_ptr<const LoadedLesson> loaded);

  // Time: simulated seconds. Any t at once: motions are functions of time.
  double t_s() const { return t_s_; }
  bool is_playing() const { return playing_; }
  double speed() const { return speed_; }  ///< shown seconds a second, kSlowest … kFastest
  void set_playing(bool playing);          ///< nothing without a scene
  void set_speed(double speed);            ///< clamped
  /// As far as the motion reaches; stays where it is if the motion cannot be computed there.
  void scrub_to(double t_s);
  /// `frames` of kFrameSeconds, forward or back; stops the motion.
  void step_frames(int frames);
  void reset_time();  ///< to the scene's own time
  /// To the nearest of shown_flips() after (1) or before (−1) the present time, at rest; stays where there is
  /// none.
  void go_to_flip(int way);
  /// Its time; nothing: there is none.
  std::optional<double> flip_beside(int way) const;
  /// Real time passes; a scene with a duration plays it again and again. The motion stops where it cannot be
  /// computed any further.
  void advance(double seconds);
  /// What the time line shows: the scene's loop, moved on by whole loops so that t lies in it. Where two
  /// loops meet it stays with the one shown before. Precondition: has_scene()
  struct Interval {
    double from_s = 0, to_s = 1;
  };
  Interval time_line() const;
  /// Times of flips (physics/geometry/flips.h) in the interval of the time line; none where the scene needs
  /// no ω.
  const std::vector<double>& flips() const;
  /// Those that may be seen: while something is to be predicted, none behind the scene's still.
  std::vector<double> shown_flips() const;

  // The scene of the step with what was changed.
  bool has_scene() const { return step().scene != nullptr; }
  /// Of a scene that varies numbers what the lesson has, without the filmstrip. Precondition: has_scene()
  const Scene& lesson_scene() const;
  /// Null without a scene. Its camera, quality and highlight are up to date too; what is pointed at is
  /// highlighted.
  const SceneModel* model() const { return model_.get(); }
  /// Goes up whenever the model was made anew (not for camera, quality and highlight).
  unsigned model_number() const { return model_number_; }
  const SceneEdits& edits() const { return edits_; }
  /// Refused, with what is wrong and nothing changed, if the scene cannot be modelled. What starts another
  /// motion (body, ω, attitude) starts it at t = 0; time goes on over a change of method or overlays. Camera
  /// and attitude become the `writable` ones.
  Status set_edits(const SceneEdits& edits);
  /// The numbers that readers may vary, with their present values; none where the scene varies none.
  std::vector<Variation> variations() const;
  /// One of these, within its range; time goes on. Refused as edits are.
  Status vary(std::size_t number, double value);
  /// What is edited from now on is undone by itself; all that is edited between two calls is one change.
  void begin_change() { change_is_new_ = true; }
  bool can_undo() const { return !undo_.empty(); }
  bool can_redo() const { return !redo_.empty(); }
  /// Takes back the last change of this scene, to which reset_edits() belongs, with the time and the camera
  /// that it brought; a camera that was turned since stays. False: there is none.
  bool undo();
  /// Makes again what was taken back last, likewise; a change by hand ends what can be made again.
  bool redo();
  /// Follows nothing any more; a motion that was changed begins at the scene's own time.
  void reset_edits();
  /// Whether a figure can show what makes it one: a body, its ω and torque, and nothing besides.
  bool can_show(const Counterexample& counter) const;
  /// The body of a counterexample in place of the lesson's, as it turns and with its torque, without the
  /// lesson's caption; the body, its axes and ω are seen even if the lesson shows others. That is a change
  /// like others, to be undone and made again. Leaving it gives back what was shown before, with the camera
  /// of now. What goes to another scene, or back to the lesson's, leaves it too, and so does another answer
  /// on this step: then it is not made again. Refused where it cannot be shown.
  Status show_counterexample(const Counterexample& counter);
  void leave_counterexample();
  /// What is shown; null: none, or its body was changed since.
  const Counterexample* counterexample() const {
    return aside_ && !aside_->is_changed ? &aside_->shown : nullptr;
  }
  bool is_aside() const { return aside_.has_value(); }
  /// The camera alone: cheap.
  void set_camera(const CameraSpec& camera);
  /// The camera keeps pace with the body's turning about the vertical; not where the scene is
  /// seen from the body alone, which stands still there.
  bool is_following() const { return following_; }
  void set_following(bool following);
  /// The camera of the present moment: of the scene, or following the body.
  CameraSpec camera() const;

  // What is pointed at: a symbol of the lesson or a term, by name; empty: none.
  const std::string& lit() const { return lit_; }
  void light(const std::string& name);

  // Questions of this step, in order.
  std::vector<const Ask*> questions() const;
  const AnswerLog& answers() const { return answers_; }
  void set_answers(AnswerLog answers) { answers_ = std::move(answers); }
  /// Judges and notes it; what cannot be read is judged, not noted.
  const AnswerJudgement& answer(const Ask& ask, std::string_view text);
  /// What was answered last to this question since the place was reached; null: nothing.
  const JudgedAnswer* judged(const Ask& ask) const;
  const AnswerRecord* record(const Ask& ask) const;  ///< null: never answered
  /// Whether the motion is to answer a prediction first (Ask::plays): it was made, and what it is held
  /// against is not over. Then nothing is to be said of it.
  bool is_awaited(const Ask& ask) const { return awaited_ && awaited_->ask == ask.id; }
  void end_play();  ///< says it now
  /// Whether a question of this step asks what will happen, and nobody has said so yet, or it is being
  /// played: then nothing is to be shown of what comes.
  bool is_predicting() const;
  void show_hint(const Ask& ask);  ///< one more, if there is one, and then the answer
  void forget_answer(const Ask& ask);
  /// The derivation that a question of the type derive asks for, as far as it goes; as it was left, where
  /// that is kept.
  DerivationWork& derivation(const Ask& ask);
  /// Judges a line of it, and notes how far it goes.
  void derive(const Ask& ask, std::string_view line);
  void undo_derived_line(const Ask& ask);
  /// What the page shows of that of the present step; empty before it was begun, now or earlier.
  ShownDerivation shown_derivation() const;

  // How it is shown.
  Panel panel = Panel::none;
  Preferences preferences{};
  void change_text_scale(int steps);  ///< of kTextScaleFactor; a single one never goes past normal size
  /// The figure and its plots as large as the page, without the text, until one leaves the step.
  bool is_enlarged() const { return enlarged_ && has_scene(); }
  void set_enlarged(bool enlarged) { enlarged_ = enlarged; }
  /// The page alone, for an audience.
  bool is_presenting() const { return presenting_; }
  void set_presenting(bool presenting);
  /// A window of the speaker's own, with the author's notes, beside the one of the audience, which has none
  /// of them. It comes with presenting and goes with it.
  bool has_speaker() const { return has_speaker_; }
  void set_speaker(bool wanted);
  /// A black screen, so that an audience looks up: only while presenting.
  bool is_black() const { return black_; }
  void set_black(bool black) { black_ = presenting_ && black; }
  /// The audience goes on seeing what it saw, while the speaker looks elsewhere: only beside a speaker's
  /// window.
  bool is_frozen() const { return frozen_; }
  void set_frozen(bool frozen);
  /// A spot on the audience's page that follows the mouse: only while presenting.
  bool is_pointing() const { return pointing_; }
  void set_pointing(bool pointing) { pointing_ = presenting_ && pointing; }
  /// Ids of stages that are not for this class: while presenting they are passed over, unless that would be
  /// all of them. Whoever goes to one of them is there all the same.
  const std::set<std::string>& left_out() const { return left_out_; }
  void set_left_out(const std::set<std::string>& stages);
  void leave_out(const std::string& stage, bool is_left_out);
  /// Those that are for this class, in order: all of them, if none would be left.
  std::vector<std::size_t> chosen_stages() const;
  bool passes_over(std::size_t stage) const;
  /// Those that are counted now: before an audience the ones for this class, else all.
  std::vector<std::size_t> counted_stages() const;
  /// The place of a stage among them, from 1, and how many they are; nothing: it is not one of them.
  struct StageNumber {
    std::size_t number = 1, count = 1;
    bool operator==(const StageNumber&) const = default;
  };
  std::optional<StageNumber> stage_number(std::size_t stage) const;

  /// How far the page is on its way from the step before to this one, 0…1; 1: it is there. Only a step
  /// forward within a stage has a way.
  double transition() const { return preferences.reduced_motion ? 1 : transition_; }
  /// That way once more, kReplaySlowness times as slowly; nothing on the first step of a stage.
  void replay_step();
  /// Whether something changes by itself: playing, or a line on its way.
  bool is_moving() const;

 private:
  void arrive(StepPlace place);
  void leave_answered();
  void forget_counterexamples();
  /// An audience sees a question as it is asked: what was tried before it came, or while it saw nothing of
  /// it.
  void forget_trials();
  DerivationWork& found_derivation(const Ask& ask) const;
  void show_lesson_scene();
  Scene scene_with(const SceneEdits& edits) const;
  void make_model_of(const SceneEdits& edits);
  void go_on_from(double t_s);
  void patch_model();
  void keep_edits();
  void note_change(const SceneEdits& before, double before_s);
  void play_for(const Ask& ask);
  std::vector<std::string> with_lit(const Scene& scene) const;  ///< what is highlighted of it now
  void set_time(double t_s);
  double heading_at(double t_s) const;

  std::shared_ptr<const LoadedLesson> loaded_;
  Effort effort_;
  StepPlace place_{};
  std::set<std::string> visited_;
  std::set<std::string> visited_before_;  ///< as it was set
  double t_s_ = 0, speed_ = 1, transition_ = 1, transition_s_ = kMorphSeconds;
  double loop_ = 0;         ///< number of the loop that the time line shows
  double heading_rad_ = 0;  ///< of the body where the camera has the azimuth of the scene, while following
  bool playing_ = false, following_ = false;
  SceneEdits edits_;
  std::unique_ptr<SceneModel> model_;
  unsigned model_number_ = 0;
  struct Flips {
    unsigned model_number = 0;
    double loop = 0;
    std::vector<double> times_s;
  };
  mutable Flips flips_;  ///< found when asked for
  struct Aside {
    Counterexample shown;
    SceneEdits before;
    double t_s = 0;
    std::size_t changes = 0;  ///< so many of undo_ were made before
    bool is_changed = false;
  };
  std::optional<Aside> aside_;  ///< from the lesson's scene, to a counterexample
  struct Change {
    SceneEdits before;
    double before_s = 0;               ///< the time then
    std::optional<CameraSpec> camera;  ///< as it left it
    std::optional<Aside> aside;        ///< that was shown then
  };
  std::vector<Change> undo_;  ///< each change of this scene
  bool change_is_new_ = true;
  std::vector<Change> redo_;  ///< each that was taken back
  bool go_back(std::vector<Change>& from, std::vector<Change>& to);
  struct Kept {
    SceneEdits edits;
    std::vector<Change> undo, redo;
  };
  std::map<const Scene*, Kept> kept_;  ///< of scenes that were left
  std::string lit_;
  AnswerLog answers_;
  std::map<std::string, JudgedAnswer> judged_;                 ///< by ask, since the place was reached
  mutable std::map<std::string, DerivationWork> derivations_;  ///< likewise; read again when asked for
  struct Awaited {
    std::string ask;
    double to_s = 0;
  };
  std::optional<Awaited> awaited_;  ///< likewise
  bool presenting_ = false, has_speaker_ = false, black_ = false, frozen_ = false, pointing_ = false;
  bool enlarged_ = false;
  std::set<std::string> left_out_;
};

}  // namespace polhode
