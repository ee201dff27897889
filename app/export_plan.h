// SPDX-License-Identifier: MIT
// Which pictures an export makes, under which names.
#pragma once

#include "app/timeline.h"
#include "lessons/lesson.h"
#include "render/image/image.h"

#include <optional>
#include <string>
#include <vector>

namespace polhode {

enum class Each { stage, step, frame };

/// The options that decide the bytes of an export; what is not here (folder, context, syncing) does not.
struct ExportOptions {
  std::vector<std::string> stages;  ///< ids; empty: all
  Each each = Each::stage;
  Size size{1920, 1080};
  FrameRate fps;               ///< of Each::frame
  double seconds = 8;          ///< shown, per stage, of Each::frame
  std::optional<double> at_s;  ///< t of stills, of the first frame of films; absent: the scene's `at`, 0
  std::optional<FrameRange> frames;  ///< of Each::frame; absent: all
  std::string background = "studio";
  int dpi = 0;  ///< 0: none written
};

struct PlannedPicture {
  const Stage* stage;
  const Scene* scene;
  int step;                           ///< 1-based
  std::optional<std::int64_t> frame;  ///< 0-based over the whole selection
  std::int64_t frame_of_stage = 0;    ///< 0-based within its stage
  std::string file;                   ///< name without folder
};

struct ExportPlan {
  std::vector<PlannedPicture> pictures;    ///< in the order of the lesson; they point into it
  std::vector<std::string> without_scene;  ///< ids of selected stages that have nothing to draw
};

/// NN-<stage>.png (its last step that has a scene), NN-<stage>-step<K>.png or NN-<stage>-frame<F>.png.
/// @throws CommandError usage: unknown stage, a range beyond the frames there are, too many frames.
ExportPlan plan_export(const Lesson& lesson, const ExportOptions& options);

/// t of a picture, s. @param speed simulated seconds per shown second
double time_of(const PlannedPicture& picture, const ExportOptions& options, double speed);

}  // namespace polhode
