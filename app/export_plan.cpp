// SPDX-License-Identifier: MIT
#include "app/export_plan.h"

#include "app/exit_codes.h"
#include "app/lesson_lookup.h"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

namespace {

struct Place {
  const Stage* stage;
  std::size_t number;  // 1-based in the lesson
};

std::vector<Place> selected_stages(const Lesson& lesson, const std::vector<std::string>& ids) {
  for (const std::string& id : ids) static_cast<void>(stage_of(lesson, id));  // throws for an unknown one
  std::vector<Place> places;
  for (std::size_t i = 0; i < lesson.stages.size(); ++i) {
    const Stage& stage = lesson.stages[i];
    if (ids.empty() || std::find(ids.begin(), ids.end(), stage.id) != ids.end())
      places.push_back({&stage, i + 1});
  }
  return places;
}

/// 0-based index of the last step with a scene.
std::optional<std::size_t> last_drawn_step(const Stage& stage) {
  for (std::size_t i = stage.steps.size(); i-- > 0;)
    if (stage.steps[i].scene) return i;
  return std::nullopt;
}

PlannedPicture picture_of(const Stage& stage, std::size_t step, std::string file) {
  return {&stage, &*stage.steps[step].scene, static_cast<int>(step + 1), std::nullopt, 0, std::move(file)};
}

void plan_steps(const Stage& stage, const std::string& stem, ExportPlan& plan) {
  for (std::size_t step = 0; step < stage.steps.size(); ++step)
    if (stage.steps[step].scene)
      plan.pictures.push_back(picture_of(stage, step, fmt::format("{}-step{}.png", stem, step + 1)));
}

struct Film {
  const Stage* stage;
  std::string stem;
  std::size_t step;
};

FrameRange checked_range(const ExportOptions& options, std::int64_t total) {
  const FrameRange range = options.frames.value_or(FrameRange{0, total});
  if (range.end > total)
    throw CommandError(ExitCode::usage,
                       fmt::format("--frames {}:{}: the selection has {} frames, numbered from 0",
                                   range.begin, range.end, total));
  return range;
}

void plan_films(const std::vector<Film>& films, const ExportOptions& options, ExportPlan& plan) {
  const std::int64_t each = frame_count(options.fps, options.seconds);
  const std::int64_t total = each * static_cast<std::int64_t>(films.size());
  if (each > kMaxFrames || total > kMaxFrames)
    throw CommandError(ExitCode::usage,
                       fmt::format("more than {} frames; shorten --seconds or choose stages", kMaxFrames));
  const FrameRange range = checked_range(options, total);
  for (std::int64_t frame = range.begin; frame < range.end; ++frame) {
    const Film& film = films[static_cast<std::size_t>(frame / each)];
    PlannedPicture picture = picture_of(
        *film.stage, film.step, fmt::format("{}-frame{}.png", film.stem, zero_padded(frame, total - 1)));
    picture.frame = frame;
    picture.frame_of_stage = frame % each;
    plan.pictures.push_back(std::move(picture));
  }
}

}  // namespace

ExportPlan plan_export(const Lesson& lesson, const ExportOptions& options) {
  ExportPlan plan;
  std::vector<Film> films;
  const auto last_number = static_cast<std::int64_t>(lesson.stages.size());
  for (const Place& place : selected_stages(lesson, options.stages)) {
    const Stage& stage = *place.stage;
    const auto number = static_cast<std::int64_t>(place.number);
    const std::string stem = fmt::format("{}-{}", zero_padded(number, last_number, 2), stage.id);
    const auto step = last_drawn_step(stage);
    if (!step)
      plan.without_scene.push_back(stage.id);
    else if (options.each == Each::step)
      plan_steps(stage, stem, plan);
    else if (options.each == Each::frame)
      films.push_back({&stage, stem, *step});
    else
      plan.pictures.push_back(picture_of(stage, *step, stem + ".png"));
  }
  if (options.each == Each::frame) plan_films(films, options, plan);
  return plan;
}

double time_of(const PlannedPicture& picture, const ExportOptions& options, double speed) {
  if (!picture.frame) return options.at_s.value_or(picture.scene->at_s);
  return frame_time(options.fps, picture.frame_of_stage, speed, options.at_s.value_or(0.0));
}

}  // namespace polhode
