// SPDX-License-Identifier: MIT
// All that the window shows: the page, the bar below it, the panel beside it, as one picture in a
// framebuffer. It knows Dear ImGui and OpenGL, but no window: a test gives it an off-screen context and the
// input of a mouse.
#pragma once

#include "app/session/command.h"
#include "app/window/controls/control_pass.h"
#include "app/window/panels/panels.h"
#include "app/window/screen/figure_drag.h"
#include "app/window/screen/figure_marks.h"
#include "app/window/screen/notices.h"
#include "app/window/screen/pace.h"
#include "app/window/screen/page_view.h"
#include "app/window/screen/plot_hand.h"
#include "app/window/screen/symbol_focus.h"

#include <functional>

struct ImGuiContext;

namespace polhode {

/// One frame's circumstances. Pointer and buttons are in ImGui's io, in pixels of the picture.
struct ScreenFrame {
  Size size;
  double scale = 1;    ///< of controls: 1 for about 96 dots per inch
  double seconds = 0;  ///< since the frame before
};

class Screen {
 public:
  /// Both must outlive it. Makes an ImGui context, which is the current one as long as it lives.
  static Result<std::unique_ptr<Screen>> create(const GlContext& context, const Fonts& fonts);
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// A key as app/session/command.h names it; repeated while it is held. False: it is for the panel that
  /// has the focus, or for nobody.
  bool press(LessonSession& session, std::string_view key, bool is_repeated = false);
  /// The same in the speaker's window, where it is for the page whatever has the focus here.
  bool press_from_afar(LessonSession& session, std::string_view key, bool is_repeated);
  /// Lets time pass, then draws. What goes wrong with the page is shown in its place.
  Status draw(LessonSession& session, const ScreenFrame& frame);

  /// What the last frame asks of the window.
  WindowRequests& requests() { return requests_; }
  /// When the next frame will differ without any input: 0 while something moves, or waits to be drawn in
  /// full.
  double seconds_to_wake(const LessonSession& session) const;
  /// Whether the last frame's figures were drawn with all their pixels.
  bool is_full() const { return is_full_; }

  /// Shown in a strip above the bar: an error of the lesson until it is mended, news for a few seconds.
  void tell(const std::string& text) {
    notices_.tell(text);
    idle_.reset();
  }
  /// What lessons there are: asked for when a panel first lists them.
  void set_lessons(std::function<std::vector<LessonProgress>()> lessons) {
    find_lessons_ = std::move(lessons);
  }
  void set_lesson_errors(std::string errors) { notices_.set_lesson_errors(std::move(errors)); }

  /// Of the present stage, in words.
  const std::string& stage_title() const { return stage_title_; }

  const Framebuffer& picture() const { return *picture_; }
  /// What an audience sees: that picture, or the one of the moment when it was frozen. A black screen is
  /// black.
  const Framebuffer& for_audience() const { return frozen_ && !is_black_ ? *frozen_ : *picture_; }
  Image read() const { return picture_->read(); }

  // What the speaker's window shows and draws with.

  /// Where the spot is while one points in that window, in parts of this picture's size; nothing: not on the
  /// page there.
  void point_from_afar(const std::optional<Vec2>& at) { pointed_from_afar_ = at; }

  const PageView& page() const { return *page_; }  ///< with the places of the last frame
  const SpeechText& speech() const { return *speech_; }
  /// Into the current ImGui context. Beside a speaker's window they are not for the audience.
  void draw_notices(const Region& region, float padding) const;
  Renderer& renderer() { return *renderer_; }
  const Gl& gl() const { return *gl_; }
  ImGuiContext* imgui() const { return imgui_; }

  // For tests. A user reads the notice, and types the folder into its field.

  const std::string& notice() const { return notices_.told(); }  ///< told last
  const LessonTexts& texts() const { return *texts_; }           ///< in the panels
  const OverlayPictures& overlay_pictures() const { return *pictures_; }
  void set_folder(const std::string& folder) { panels_.save().folder = folder; }  ///< where things are saved

 private:
  Screen(std::unique_ptr<const Gl> gl, std::unique_ptr<Renderer> renderer,
         std::unique_ptr<ControlPass> controls, ImGuiContext* imgui);
  static std::string said(const LessonSession& session, const Phrase& phrase);
  void adopt_style(const LessonSession& session, const ScreenFrame& frame);
  Region page_region(const LessonSession& session, Size size) const;
  float panel_width(const LessonSession& session, Size size) const;
  float panel_height(const LessonSession& session, const Region& page) const;
  Region region_of_notices(const LessonSession& session, Size size) const;
  Region above_chip(Region region) const;
  float covered_width(const LessonSession& session, Size size) const;
  bool press_while_presenting(LessonSession& session, std::string_view key);
  bool holds_back(const LessonSession& session, bool is_repeated);
  bool do_in_window(LessonSession& session, Command command);
  void move_focus_on_page(LessonSession& session, int by);
  bool pick_in_focus(LessonSession& session);
  void type_ahead(LessonSession& session);
  void scroll_by_wheel();
  void draw_page_menu(LessonSession& session, bool on_page, std::optional<std::size_t> under);
  void offer_of_text(LessonSession& session);
  void offer_of_figure(LessonSession& session);
  bool walks_by_click(LessonSession& session, const Vec2& at, bool is_free) const;
  void draw_scroll_marks(const LessonSession& session);
  void draw_invitation(const LessonSession& session);
  std::vector<const Page::Choice*> open_choices(const LessonSession& session) const;
  static void pick(LessonSession& session, const Page::Choice& choice);
  const Page::Choice* choice_at(const LessonSession& session, const Vec2& at) const;
  void draw_choices(const LessonSession& session, const Page::Choice* pointed_at) const;
  void draw_answered(const LessonSession& session) const;
  void draw_mark_beside(const LessonSession& session, const PixelBox& box, double baseline,
                        bool is_right) const;
  const Page::OpenQuestion* question_at(const LessonSession& session, const Vec2& at) const;
  bool use_questions(LessonSession& session, bool on_page);
  Result<bool> show_page(LessonSession& session, const Region& region, double scale, double resolution);
  void lay_out_controls(LessonSession& session, const Region& page, Size size);
  void lay_out_sliders(LessonSession& session);
  void use_pointer(LessonSession& session, const Region& page);
  std::optional<PageSymbol> pointed_symbol(const LessonSession& session,
                                           std::optional<std::size_t> under) const;
  bool follow(LessonSession& session, const std::string& link);
  void save(LessonSession& session);
  void name_slides(const LessonSession& session);
  void copy(const LessonSession& session);
  std::string words_of_step(const LessonSession& session) const;
  std::string words_of_block(const Block& block) const;
  void draw_spot(const LessonSession& session) const;
  Status keep_for_audience(const LessonSession& session);
  void go_back_to_frozen(LessonSession& session);
  std::string take_number(const LessonSession& session);
  void forget_what_is_over(const LessonSession& session);

  std::unique_ptr<const Gl> gl_;
  std::unique_ptr<Renderer> renderer_;
  std::unique_ptr<ControlPass> controls_;
  ImGuiContext* imgui_;
  std::unique_ptr<PageView> page_;
  std::optional<Framebuffer> picture_, frozen_;
  /// Where the session was in that moment: what the audience sees in frozen_.
  struct Seen {
    StepPlace place;
    SceneEdits edits;
    double t_s = 0;
    bool is_enlarged = false;
  };
  Seen seen_{};
  bool is_black_ = false;  ///< in the last frame
  std::optional<Vec2> pointed_from_afar_{};
  Pace pace_;
  WindowRequests requests_;
  Panels panels_;
  SymbolFocus symbols_;
  FigureDrag drag_;
  PlotHand plots_;
  ChipPlace chip_;                ///< of the changed scene
  std::size_t place_at_tip_ = 0;  ///< of the words at the tip of ω (place_beside)
  bool varies_ = false;           ///< a number, by a slider that is held
  Notices notices_;
  std::unique_ptr<SpeechText> speech_;
  std::unique_ptr<LessonTexts> texts_;
  std::unique_ptr<OverlayPictures> pictures_;
  const Lesson* spoken_ = nullptr;  ///< the lesson of speech_
  std::optional<ControlSizes> sizes_;
  std::optional<Theme> theme_;
  std::string stage_title_;
  double clock_s_ = 0, page_s_ = 0, frame_s_ = 0, pointed_s_ = 0;  ///< pointed_s_: the pointer moved
  bool has_menu_ = false;  ///< what can be done with what is there: open
  bool menu_is_of_figure_ = false;
  std::string menu_of_{};     ///< the symbol or link that it was opened on; empty: none
  std::string menu_words_{};  ///< the paragraph there, or the TeX of the equation; empty: there is none
  bool menu_is_of_equation_ = false;
  /// Since a key or a button was pressed, or another step came, the pointer has not moved: it asks for
  /// nothing.
  bool pointer_is_left_ = false, step_is_new_ = false;
  int frames_of_tooltip_ = 0;  ///< since the pointer has rested for as long as a tooltip waits
  bool is_full_ = true, was_moving_ = false;
  std::optional<StepPlace> shown_place_{};
  std::optional<std::size_t> choice_in_focus_{};               ///< among open_choices(): keys reached it
  std::optional<StepPlace> held_back_{};                       ///< where one was asked to answer first
  bool panel_takes_focus_ = false;                             ///< it was opened by a key
  std::function<std::vector<LessonProgress>()> find_lessons_;  ///< null: asked already, or there are none
  std::vector<LessonProgress> lessons_;
  bool types_ahead_ = false;           ///< characters of this frame begin an answer
  const Ask* begun_ = nullptr;         ///< to this
  std::vector<unsigned> typed_ahead_;  ///< before its field had the keyboard
  std::string digits_;                 ///< typed while presenting: the number of a stage
  std::optional<Command> idle_;        ///< what was told last is why it has nothing to do
};

}  // namespace polhode
