// SPDX-License-Identifier: MIT
// A lesson's figure in a canvas: a session, and its picture on whatever OpenGL there is. What live_api.h says
// of each call holds here; a refusal is an error with a sentence for readers.
#pragma once

#include "app/narration/speech_text.h"
#include "app/page/page.h"
#include "app/page/text/page_text.h"
#include "app/session/accuracy_meter.h"
#include "app/session/figure_hand.h"
#include "app/session/lesson_session.h"
#include "render/gl/context/context.h"
#include "render/gl/framebuffer.h"
#include "render/gl/renderer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

class LiveFigure {
 public:
  enum class Picture { figure, slide };

  LiveFigure();
  LiveFigure(const LiveFigure&) = delete;
  LiveFigure& operator=(const LiveFigure&) = delete;
  ~LiveFigure();

  /// Before each of the calls below: what it computes may cost so much and no more, else it throws
  /// BudgetSpent.
  void begin_call();

  /// A text with errors is refused with the first of them; of a lesson that is read when its page is written,
  /// those of its front matter now, and those of a stage when it is shown: until then a stage is not read.
  Status open_lesson(std::string_view text, std::string_view file_name);
  Status open_scene(std::string_view scene_toml, std::string_view own_body_toml);
  /// From 1.
  Status show(std::size_t stage, std::size_t step);
  Status show(std::string_view stage_id, std::size_t step);

  /// Draws in this context from now on.
  Status attach(std::unique_ptr<GlContext> context);
  /// Of a context that is lost or gone nothing is asked any more.
  void detach();

  /// 0 without a scene.
  int height_for(int width) const;
  /// What draw() does without a canvas: then the places of hands are known.
  Status lay_out(Size size, Picture what, double resolution);
  Status draw(Size size, Picture what, double resolution);
  /// What the last draw() came to, for tests and for saving. Fails where nothing was drawn.
  Result<Image> read() const;
  const std::vector<Inset>& insets() const { return page_.insets; }

  FigureHand::On point_down(const Vec2& at, double reach);
  FigureHand::On point_move(const Vec2& at, double reach);
  void point_up() { hand_.let_go(); }
  void point_twice();
  void zoom(double notches);
  void turn(double dx, double dy);
  Status press_key(std::string_view key);

  void set_theme(Theme theme);
  void set_playing(bool playing);
  /// True: the picture changes by itself.
  bool advance(double seconds);
  Status set_time(double t_s);
  void set_speed(double speed);

  void begin_change();
  Status set_omega(const Vec3& w0_B);
  Status set_attitude(const Quat& q_SB);
  Status set_moments(const Vec3& moments);
  Status set_body(std::string_view name);
  Status vary(std::size_t number, double value);
  Status set_method(std::string_view name, double step);
  Status show_overlay(std::string_view name, bool shown);
  Status set_camera(double azimuth_rad, double elevation_rad, double zoom);
  Status undo();
  Status reset();
  void light(std::string_view id);

  /// Null before a lesson was opened.
  const LessonSession* session() const { return session_.get(); }
  const SceneModel* model() const { return session_ ? session_->model() : nullptr; }
  /// Of the present motion and time.
  const AccuracyReading& accuracy();
  /// In the words of the lesson. Precondition: there is a scene.
  std::string alt_text_now();
  std::vector<std::string> captions_now();
  /// What a drag could not do; empty: it did.
  const std::string& refused_drag() const { return refused_drag_; }

 private:
  /// Contexts are gone before fonts are.
  struct Drawing {
    std::unique_ptr<GlContext> context;
    std::unique_ptr<const Gl> gl;
    std::unique_ptr<Renderer> renderer;
    std::optional<Framebuffer> picture;
  };
  /// What a picture depends on.
  struct Key {
    StepPlace place;
    unsigned model_number = 0, lesson_number = 0;
    Size size;
    Picture what = Picture::figure;
    double resolution = 1, t_s = 0;
    CameraSpec camera;
    QualityLevel quality = QualityLevel::normal;
    std::string lit;
    Theme theme = Theme::paper;
    bool operator==(const Key&) const = default;
  };

  Status take(std::shared_ptr<const LoadedLesson> loaded);
  Result<std::shared_ptr<const LoadedLesson>> with_stage(const std::string& id) const;
  Status read_whole();
  Status edit(const SceneEdits& edits);
  Result<const Fonts*> fonts();
  Result<Page> compose(const Key& key);
  Result<Page> compose_slide(const PageRequest& request, const Key& key);
  Effort effort();

  std::optional<Fonts> fonts_;
  std::unique_ptr<Drawing> drawing_;
  std::shared_ptr<const LoadedLesson> loaded_;
  std::optional<std::string> open_stage_;  ///< of a lesson whose other stages are not read
  std::unique_ptr<LessonSession> session_;
  std::unique_ptr<SpeechText> speech_;
  std::unique_ptr<AccuracyMeter> meter_;
  std::optional<AccuracyReading> accuracy_;
  unsigned meter_of_ = 0, lesson_number_ = 0;
  double accuracy_at_s_ = 0;
  FigureHand hand_;
  Vec2 last_{0, 0};
  std::string refused_drag_;
  Page page_;
  std::optional<Key> laid_out_, drawn_;
  /// The text of a slide.
  struct Slide {
    Key key;
    SlideType type;
    FittedText text;
  };
  std::optional<Slide> slide_;
  Theme theme_ = Theme::paper;
  std::int64_t left_ = 0;  ///< evaluations that the present call may take
};

}  // namespace polhode
