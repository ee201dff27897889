// SPDX-License-Identifier: MIT
// The panels beside the page, one of which is open: each in a file of its own, with the state that it keeps.
#pragma once

#include "app/session/accuracy_meter.h"
#include "app/session/lesson_search.h"
#include "app/session/method_cost.h"
#include "app/window/panels/panel_context.h"
#include "lessons/claims/live_claims.h"

#include <map>
#include <memory>
#include <utility>

namespace polhode {

class OutlinePanel {
 public:
  void draw(PanelContext& context);
  bool finds() const { return !looked_for_.empty(); }  ///< words are typed that are looked for

 private:
  void choose_for_class(PanelContext& context);
  void find(PanelContext& context);
  void draw_found(PanelContext& context);
  void draw_stages(PanelContext& context);

  std::string looked_for_;
  std::unique_ptr<LessonSearch> search_;          ///< made when something is looked for first
  std::shared_ptr<const LoadedLesson> searched_;  ///< the lesson of search_
  std::vector<LessonSearch::Found> found_;

  std::optional<StepPlace> scrolled_to_;
  bool chooses_ = false;  ///< stages for a class are being chosen
};

class BodyPanel {
 public:
  void draw(PanelContext& context, std::string& refusal);

 private:
  void set_ranges(const Scene& scene);
  void edit_moments(PanelContext& context, const Scene& scene, std::string& refusal) const;
  void edit_omega(PanelContext& context, const Scene& scene) const;

  // Ends of sliders; they stand while one is held.
  Vec3 least_moments_{0, 0, 0}, most_moments_{1, 1, 1};
  double most_omega_ = 1;
  int power_ = 0, omega_power_ = 0;  ///< of ten, which the sliders of moments and of ω leave out
};

/// Measures the methods when it opens, and again for another motion.
class MethodPanel {
 public:
  void draw(PanelContext& context, const std::string& refusal);
  /// Before a frame.
  void count_frame() { frames_to_settle_ = std::max(0, frames_to_settle_ - 1); }
  /// After how long it has something new to show; nothing: it waits for nothing.
  std::optional<double> seconds_to_wake() const;

 private:
  void choose_from_front(PanelContext& context, const SceneModel& model);
  void show_accuracy(PanelContext& context, const SceneModel& model);

  std::unique_ptr<FrontMeasurement> front_;
  std::optional<Scene> front_of_;  ///< whose motion was measured
  int frames_to_settle_ = 0;       ///< full while the front is awaited, then down to 0
  std::unique_ptr<AccuracyMeter> meter_;
  unsigned meter_of_ = 0;  ///< number of its model
  AccuracyReading now_;
  std::optional<LiveState> live_;  ///< of the same time; absent: it has no state
  double read_at_s_ = -1;          ///< of the clock: numbers change slowly enough to be read
  double read_of_t_s_ = 0;
};

class ShowPanel {
 public:
  void draw(PanelContext& context, const std::string& refusal);
};

class QuestionsPanel {
 public:
  void draw(PanelContext& context);

 private:
  void draw_question(PanelContext& context, const Ask& ask, std::size_t number, std::size_t count);
  void draw_forget(PanelContext& context, const Ask& ask);
  void draw_earlier(PanelContext& context, bool is_alone);
  void draw_as_set(PanelContext& context, const Ask& ask);

  struct SetExpression {
    std::string typed, tex;
  };
  std::map<std::string, std::string> typed_;  ///< by "stage/question"
  std::map<std::string, SetExpression> set_;  ///< likewise
  std::string forgetting_;                    ///< the one of which that is asked; empty: none
};

class SavePanel {
 public:
  SavePanel();
  void draw(PanelContext& context);

  std::string folder;  ///< as typed; at first the present one
  SaveOptions options;
};

/// The lessons that there are: in the outline, and at the end of one.
void draw_lessons(PanelContext& context);
/// All lessons, in the order of the course, over the whole page; at the end of one first what is to be
/// repeated of it.
void draw_home(PanelContext& context);
void draw_settings(PanelContext& context);
void draw_help(PanelContext& context);

class Panels {
 public:
  /// Draws the panel that is open, then makes the edits that it asks for.
  void draw(PanelContext& context, const Region& region);
  /// Before a frame: none has the focus unless it says so.
  void begin_frame();
  /// Whether all keys are for the panel: one that was opened or chosen by a key. After a click in it those
  /// that walk and play are the page's, until a control is chosen by keys or a text is typed; beside
  /// questions they always are.
  bool has_focus() const { return has_focus_; }
  /// The keyboard is the panel's, and it has a text to be typed: letters beside its field are no commands.
  bool awaits_text() const { return awaits_text_; }
  /// The mouse holds a control of it, a slider say.
  bool is_held() const { return is_held_; }
  /// F6: from now on until the focus goes elsewhere they are for the panel of questions too. The next frame
  /// shows which of its controls has them.
  void take_keys() { takes_keys_ = shows_focus_ = true; }
  /// Tab in a panel that has the keys: to the control behind (1) or before (-1) the present one, as one
  /// reads; from the last to the first. It leaves a field that is typed in, and one that it reaches is typed
  /// in.
  void tab(int way) { steps_ = way; }
  /// What is pressed from now on is for the page, whatever had the focus.
  void leave_keys();
  std::optional<double> seconds_to_wake() const { return method_.seconds_to_wake(); }
  SavePanel& save() { return save_; }

 private:
  void draw_contents(PanelContext& context);
  bool step_focus();
  void make_edits(PanelContext& context);

  OutlinePanel outline_;
  BodyPanel body_;
  MethodPanel method_;
  ShowPanel show_;
  QuestionsPanel questions_;
  SavePanel save_;
  std::pair<Panel, StepPlace> shown_{};  ///< panel and place of the frame before
  std::string refusal_;                  ///< why the last edit was not made; empty: it was
  unsigned refused_of_ = 0;              ///< number of the model of the frame before
  bool has_focus_ = false;
  bool takes_keys_ = false;
  bool shows_focus_ = false;  ///< the next frame gives it to a control
  int steps_ = 0;             ///< of the focus, in the next frame
  /// 1 or -1: the frame before asked for the control to the right or left of the one of id `stepped_from_`;
  /// if the focus is still there, the next is above or below it. 0: nothing was asked for.
  int beside_ = 0;
  unsigned stepped_from_ = 0;
  int frames_to_reach_ = 0;  ///< so long at most Tab may still lead to a control; 0: it is not on its way
  bool awaits_text_ = false, is_held_ = false;
};

}  // namespace polhode
