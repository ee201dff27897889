// SPDX-License-Identifier: MIT
// Which pictures an export makes, under which names.
#pragma once

#include "app/export/timeline.h"
#include "app/page/page_theme.h"
#include "lessons/reader/lesson.h"
#include "render/image/image.h"
#include "render/image/png.h"

#include <optional>
#include <string>
#include <vector>

namespace polhode {

enum class What { page, equation, figure, transcript };
/// Pages to read show several steps each, and all of a stage.
enum class Each { stage, step, frame, page };
/// Pixels, or outlines: svg and pdf are for equations, whose type they have as curves.
enum class PictureFormat { png, svg, pdf };
/// "svg", as files end and manifests say.
const char* name_of(PictureFormat format);

/// The options that decide the bytes of an export; what is not here (folder, context, syncing) does not.
struct ExportOptions {
  What what = What::page;
  std::vector<std::string> stages;  ///< ids; empty: all
  /// Pages say "stage 2 of 3" of those stages, as before an audience; else as the lesson counts.
  bool counts_chosen = false;
  Each each = Each::stage;
  Size size{1920, 1080};       ///< of pages and figures
  FrameRate fps;               ///< of Each::frame
  double seconds = 8;          ///< shown, per stage, of Each::frame
  std::optional<double> at_s;  ///< t of stills, of the first frame of films; absent: the scene's `at`, 0
  std::optional<FrameRange> frames;     ///< of Each::frame; absent: all
  std::string background = "paper";     ///< of pages that of the theme
  Theme theme = Theme::paper;           ///< of pages and equations
  std::optional<QualityLevel> quality;  ///< of pages and figures; absent: the scene's
  Profile profile = Profile::slides;    ///< of pages
  double text_scale = 1;                ///< of pages
  int dpi = 0;                          ///< noted in the files, 0: none; of equations also their size
  PngPacking png = PngPacking::fast;
  PictureFormat format = PictureFormat::png;
};

/// Of equations: 12 pt type has so many dots per inch where nothing else is said.
inline constexpr int kDefaultEquationDpi = 300;
/// Of outlines it is the grid on which type stands: that of a printer.
inline constexpr int kDefaultOutlineDpi = 600;
/// Fewer give no legible formula.
inline constexpr int kFewestEquationDpi = 24;

struct PlannedPicture {
  const Stage* stage;
  int number;                         ///< of the stage in the lesson, from 1
  int step;                           ///< from 1
  const Scene* scene;                 ///< of the step; null: none
  const Equation* equation;           ///< of What::equation: the one to show; null in films, which show all
  std::optional<std::int64_t> frame;  ///< 0-based over the whole selection
  std::int64_t frame_of_stage = 0;    ///< 0-based within its stage, through which time runs,
  std::int64_t frame_of_step = 0;     ///< and within its step
  std::string file;                   ///< name without folder
  int first_step = 0;                 ///< of Each::page: the first of the steps on it, from 1
};

/// The step of a picture.
inline const Step& step_of(const PlannedPicture& picture) {
  return picture.stage->steps[static_cast<std::size_t>(picture.step - 1)];
}

struct ExportPlan {
  std::vector<PlannedPicture> pictures;  ///< in the order of the lesson; they point into it
  std::vector<std::string> left_out;     ///< ids of selected stages that have nothing of the kind to draw
};

/// In the options' format, with its ending: NN-<stage>.png, NN-<stage>-step<K>.png or
/// NN-<stage>-frame<F>.png, NN-<stage>-page<P>.png; equations stage by stage are NN-<stage>-<equation>.png. A
/// stage is shown at its last step with something of the kind to draw: a scene, an equation; pages have all
/// steps. The frames of a stage are shared evenly among its steps, in order; those of equations belong to the
/// last one. Not for transcripts. Each::page lays the text out. The error: an unknown stage, a range beyond
/// the frames there are, too many frames, a text that cannot be set, no fonts.
Result<ExportPlan> plan_export(const Lesson& lesson, const ExportOptions& options);

/// t of a picture that has a scene, s. @param speed simulated seconds per shown second
double time_of(const PlannedPicture& picture, const ExportOptions& options, double speed);

}  // namespace polhode
