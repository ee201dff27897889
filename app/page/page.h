// SPDX-License-Identifier: MIT
// A page of a lesson: text column, figures and meters, laid out for its size. What a step adds stands whole
// on its page; of the steps before it, as much as there is room for: everything, or their equations alone. A
// page to read may have several steps, each with its figure beside it. On a slide the step stands alone, with
// the equation that was come to before it at the foot.
#pragma once

#include "app/narration/verdict_row.h"
#include "app/page/page_theme.h"
#include "render/drawing/label_layout.h"
#include "render/drawing/plots/time_plot.h"
#include "render/gl/renderer.h"
#include "render/scene/model/model.h"

#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace polhode {

inline constexpr Size kSmallestPage{320, 240};

struct FittedText;
class StillNumbers;

/// A page by itself: nothing comes in.
struct StandingStill {};
/// In a sequence of pages of one stage: the opacity of the text that the step adds. Its room is there from
/// the start, and what was in focus before keeps the room it had.
struct FadingIn {
  double opacity = 1;
};
/// From the page before to this one: what stands on both goes from place to place; the equation in focus,
/// with panel and bar, comes out of the one in focus before (render/typeset/morph.h); what else is new
/// appears, what is gone vanishes (page_transition.h). Figure and plots are those of this page.
struct TurningInto {
  const FittedText* from =
      nullptr;          ///< text of the page before, of the same lesson; null: all that is new fades in
  double progress = 1;  ///< 0…1 in proportion to time; 1: arrived
};

using PageEntrance = std::variant<StandingStill, FadingIn, TurningInto>;

/// What the slides of a stage have in common.
struct SlideType {
  double column = 0;  ///< width of the text beside a figure, px
  double scale = 1;   ///< of the type's normal size; below 1 a step has more than a slide holds
};

/// A line of a learner's derivation, below the question that asks for it.
struct ShownDerivedLine {
  std::string tex;
  std::string word;  ///< of its chip; empty: it is being typed
  Certainty certainty = Certainty::stated;
  bool operator==(const ShownDerivedLine&) const = default;
};
struct ShownDerivation {
  const Ask* ask = nullptr;  ///< null: there is none
  std::vector<ShownDerivedLine> lines{};
  bool operator==(const ShownDerivation&) const = default;
};

/// A step as it stands on a page to read: whole, beside its figure.
struct FiguredStep {
  int step = 1;                       ///< of the stage, from 1
  const SceneModel* model = nullptr;  ///< null: text alone
  double t_s = 0;
};

struct PageRequest {
  const Lesson& lesson;
  const Stage& stage;
  int number = 1;  ///< of the stage, from 1
  /// Which of how many stages it is said to be. Absent: as in the lesson.
  struct Count {
    std::size_t number, count;
  };
  std::optional<Count> counted_as{};
  int step = 1;                       ///< from 1
  const SceneModel* model = nullptr;  ///< null: text alone
  double t_s = 0;
  /// Of a page to read: the steps before this one that stand on it, in order. Absent: as many as there is
  /// room for, without their figures.
  std::optional<std::span<const FiguredStep>> before{};
  Size size;
  Theme theme = Theme::paper;
  Profile profile = Profile::page;
  /// Of this stage, size and text_scale (slide_type_of); null: found for this slide.
  const SlideType* slide_type = nullptr;
  std::optional<QualityLevel> quality{};  ///< of the figure; absent: the scene's
  /// How much larger than normal the reader wants the text, kLeastTextScale … kMostTextScale. The text column
  /// widens and narrows with it, up to 0.62 of a wide page; labels, captions and plots follow half as much.
  /// Text that does not fit at this size is set smaller, as at any other.
  double text_scale = 1;
  PageEntrance entrance{};
  /// Its time goes on: computed numbers run in rooms that are wide enough for all that they come to, so that
  /// the text does not move. Else they are put into the text as they are at t_s, which that text is for.
  bool runs = false;
  bool is_frame = false;  ///< of a film, which has no captions of the still alone
  /// In a window, which can be scrolled: the text of a stage stands still. All steps up to the present one
  /// are there whole, at the size that the reader wants, each below the one before; what is higher than the
  /// page is above it (FittedText::hidden). No type is so small that it cannot be read on a screen
  /// (least_type_px). The caption of the lesson keeps its room below a scene that has none any more.
  bool scrolls = false;
  double display_scale = 1;  ///< of a page that scrolls: px of the display for one of 96 to the inch
  /// px at the right edge over which a panel lies: the figure and its plots keep clear of it, unless less
  /// than Page::least_figure is left for them: then they lie under it. The text stays as it is.
  double covered = 0;
  /// Keeps from page to page what the live numbers of earlier steps are; null: computed for this page.
  StillNumbers* still_numbers = nullptr;
  ShownDerivation derivation{};  ///< of a reader, as far as it goes
  /// Told what laying the text out costs, as if it were evaluations of a motion
  /// (lessons/reader/checks/lint_budget.h); what it throws ends that.
  Effort effort{};
};

/// An earlier step that stands on a page to read as the present one does; null: not on this page.
const FiguredStep* figured(const PageRequest& request, int step);

struct Page {
  Sheet sheet;
  std::vector<Inset> insets;  ///< under the sheet
  /// The size of the type beside its normal one. Below kLeastScale the step alone is too much for a page.
  double scale = 1;
  /// The smallest size of a display beside the one it would have if the column were wide enough.
  double formula_scale = 1;
  /// What the page shows: these equations, in their order, and whole the steps from `whole_from` on (the
  /// first is 1).
  std::vector<const Equation*> equations;
  int whole_from = 1;
  /// Of a page that scrolls: where the choices of the present step's questions stand, each with its number.
  struct Choice {
    const Ask* ask = nullptr;
    std::size_t number = 0;
    PixelBox box;
  };
  std::vector<Choice> choices{};
  /// Likewise those of its questions that are typed, put in order or set by the hand, each as a whole.
  struct OpenQuestion {
    const Ask* ask = nullptr;
    PixelBox box;
  };
  std::vector<OpenQuestion> open_questions{};
  /// Of a page that scrolls: how much of the column is above the page, and how much there is to scroll, px.
  double hidden = 0, overflow = 0;
  /// Of a page that scrolls: text of the column that is above this is not to be seen, whatever stands there;
  /// below a figure it is the figure's end. So many shapes and texts, the first of the sheet, are the
  /// column's.
  double ceiling = 0;
  std::size_t column_shapes = 0, column_texts = 0;
  /// Where text and meters stand; bars and panels of the column reach one em further to each side.
  PixelBox column, meters;
  std::vector<PlotReading> plots{};  ///< of a page that scrolls: those that a hand can read
  PixelBox figure;                   ///< of the space figure, and of diagrams with it; empty: none
  double least_figure = 0;           ///< px in width: less of it beside a panel shows nothing
};

/// Type may be so much smaller than normal before earlier steps are left out.
inline constexpr double kLeastScale = 0.86;
/// A display set smaller than this part of its size is hard to read.
inline constexpr double kLeastFormulaScale = 0.6;

/// Beside the figure the text has as little room as all steps of the request's stage need: where they are
/// short the figure has more than 60 % of the slide. Type is smaller than normal only where the widest column
/// does not hold a step.
/// Errors as of text_of_page.
Result<SlideType> slide_type_of(const PageRequest& request, const Fonts& fonts);

/// The largest type in which the request's step fits a slide, in the widest column, beside the normal size:
/// no slide of its stage has larger type. Errors as of text_of_page.
Result<double> slide_scale_of(const PageRequest& request, const Fonts& fonts);

/// No type of a page that scrolls is smaller, indices apart; 0: there is no such limit.
double least_type_px(const PageRequest& request);

/// Whether a page of this size has its text beside the figure; else below it.
bool stands_side_by_side(Size size);

/// How much of a page to read its text fills, for pages that end with the request's step and begin with it,
/// with the one before it, and so forth up to the first that has more than a page holds; not empty. Errors as
/// of text_of_page.
Result<std::vector<double>> parts_of_page(const PageRequest& request, const Fonts& fonts);

/// The text column (page_text.h), which is the same at all times, if it runs or has no computed numbers, and
/// throughout an entrance; most of what a page costs.
/// The error says which text cannot be set, or that the step has more than a page holds (lint says where).
Result<FittedText> text_of_page(const PageRequest& request, const Fonts& fonts);

/// Pure: depends on its arguments alone. Nothing is ever cut: what is too long is set smaller.
/// Errors as of text_of_page.
Result<Page> compose_page(const PageRequest& request, const Fonts& fonts);
/// The same with the text that text_of_page gave for this request; the request may be further on in its
/// entrance since, and, if it runs, in its time.
Page compose_page(const PageRequest& request, const FittedText& text, const Fonts& fonts);

/// What a page shows of a step besides its text, for documents that have the words themselves and for windows
/// that show it large: figure and plots in all of the request's size that is not covered, without captions;
/// labels of filmstrips stay. Precondition: there is a model, for a page.
Page compose_picture(const PageRequest& request, const Fonts& fonts);
/// The size of such a picture: as high as its plots need.
Size picture_size_of(const SceneModel& model, int width);

}  // namespace polhode
