// SPDX-License-Identifier: MIT
#include "app/export/export_plan.h"

#include "app/narration/still_numbers.h"
#include "app/page/page_division.h"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

namespace {

struct Place {
  const Stage* stage;
  std::size_t number;  // 1-based in the lesson
};

Result<std::vector<Place>> selected_stages(const Lesson& lesson, const std::vector<std::string>& ids) {
  for (const std::string& id : ids)
    if (const auto stage = lesson.stage_named(id); !stage) return failure(stage.error());
  std::vector<Place> places;
  for (std::size_t i = 0; i < lesson.stages.size(); ++i) {
    const Stage& stage = lesson.stages[i];
    if (ids.empty() || std::find(ids.begin(), ids.end(), stage.id) != ids.end())
      places.push_back({&stage, i + 1});
  }
  return places;
}

/// Whether there is something of the kind to draw at a step.
bool has(const Step& step, What what) {
  if (what == What::figure) return step.scene != nullptr;
  return what != What::equation || !blocks_of<Equation>(step).empty();
}

/// 0-based indices.
std::vector<std::size_t> steps_with(const Stage& stage, What what) {
  std::vector<std::size_t> steps;
  for (std::size_t i = 0; i < stage.steps.size(); ++i)
    if (has(stage.steps[i], what)) steps.push_back(i);
  return steps;
}

/// The stage of a picture, and how its file's name begins.
struct Subject {
  Place place;
  std::string stem;
  std::string ending;
};

PlannedPicture picture_of(const Subject& subject, std::size_t step, const Equation* equation,
                          const std::string& rest_of_name) {
  const Stage& stage = *subject.place.stage;
  const auto& scene = stage.steps[step].scene;
  return {&stage,
          static_cast<int>(subject.place.number),
          static_cast<int>(step + 1),
          scene ? &*scene : nullptr,
          equation,
          std::nullopt,
          0,
          0,
          subject.stem + rest_of_name + subject.ending,
          0};
}

/// A step's last equation is what it has come to.
const Equation* result_of(const Step& step, What what) {
  return what == What::equation ? blocks_of<Equation>(step).back() : nullptr;
}

void plan_steps(const Subject& subject, What what, ExportPlan& plan) {
  const std::vector<Step>& steps = subject.place.stage->steps;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (has(steps[i], what))
      plan.pictures.push_back(
          picture_of(subject, i, result_of(steps[i], what), fmt::format("-step{}", i + 1)));
}

Status plan_pages(const Subject& subject, const Lesson& lesson, const ExportOptions& options,
                  const Fonts& fonts, StillNumbers& still_numbers, ExportPlan& plan) {
  const Result<std::vector<int>> ends = pages_of_stage({.lesson = lesson,
                                                        .stage = *subject.place.stage,
                                                        .number = static_cast<int>(subject.place.number),
                                                        .size = options.size,
                                                        .theme = options.theme,
                                                        .text_scale = options.text_scale,
                                                        .still_numbers = &still_numbers},
                                                       fonts);
  if (!ends) return failure(ends.error());
  int first = 1;
  for (std::size_t i = 0; i < ends->size(); ++i) {
    const int last = (*ends)[i];
    plan.pictures.push_back(
        picture_of(subject, static_cast<std::size_t>(last - 1), nullptr, fmt::format("-page{}", i + 1)));
    plan.pictures.back().first_step = first;
    first = last + 1;
  }
  return success();
}

void plan_equations(const Subject& subject, ExportPlan& plan) {
  const std::vector<Step>& steps = subject.place.stage->steps;
  for (std::size_t i = 0; i < steps.size(); ++i)
    for (const Equation* equation : blocks_of<Equation>(steps[i]))
      plan.pictures.push_back(picture_of(subject, i, equation, "-" + equation->id));
}

/// The steps of a stage that its frames show, one after the other.
struct Film {
  Subject subject;
  std::vector<std::size_t> steps;  ///< 0-based
};

/// Of `frames` things shared evenly among `parts`, in order: the part that has thing k. The last part has the
/// last thing, however few there are.
std::int64_t part_of(std::int64_t k, std::int64_t frames, std::int64_t parts) {
  return ((k + 1) * parts - 1) / frames;
}

/// The first thing of a part.
std::int64_t first_of(std::int64_t part, std::int64_t frames, std::int64_t parts) {
  return part * frames / parts;
}

PlannedPicture frame_of(const Film& film, std::int64_t frame_of_stage, std::int64_t frames,
                        const std::string& rest_of_name) {
  const std::int64_t steps = std::ssize(film.steps), step = part_of(frame_of_stage, frames, steps);
  PlannedPicture picture =
      picture_of(film.subject, film.steps[static_cast<std::size_t>(step)], nullptr, rest_of_name);
  picture.frame_of_stage = frame_of_stage;
  picture.frame_of_step = frame_of_stage - first_of(step, frames, steps);
  return picture;
}

Result<FrameRange> checked_range(const ExportOptions& options, std::int64_t total) {
  const FrameRange range = options.frames.value_or(FrameRange{0, total});
  if (range.end > total)
    return failure(fmt::format("--frames {}:{}: the selection has {} frames, numbered from 0", range.begin,
                               range.end, total));
  return range;
}

Status plan_films(const std::vector<Film>& films, const ExportOptions& options, ExportPlan& plan) {
  const std::int64_t each = frame_count(options.fps, options.seconds);
  const std::int64_t total = each * static_cast<std::int64_t>(films.size());
  if (each > kMaxFrames || total > kMaxFrames)
    return failure(fmt::format("more than {} frames; shorten --seconds or choose stages", kMaxFrames));
  const Result<FrameRange> range = checked_range(options, total);
  if (!range) return failure(range.error());
  for (std::int64_t frame = range->begin; frame < range->end; ++frame) {
    const Film& film = films[static_cast<std::size_t>(frame / each)];
    PlannedPicture picture = frame_of(film, frame % each, each, "-frame" + zero_padded(frame, total - 1));
    picture.frame = frame;
    plan.pictures.push_back(std::move(picture));
  }
  return success();
}

}  // namespace

const char* name_of(PictureFormat format) {
  switch (format) {
    case PictureFormat::svg:
      return "svg";
    case PictureFormat::pdf:
      return "pdf";
    case PictureFormat::png:
      break;
  }
  return "png";
}

Result<ExportPlan> plan_export(const Lesson& lesson, const ExportOptions& options) {
  const auto stages = selected_stages(lesson, options.stages);
  if (!stages) return failure(stages.error());
  ExportPlan plan;
  std::vector<Film> films;
  StillNumbers still_numbers;
  std::optional<Fonts> fonts;
  if (options.each == Each::page) {
    Result<Fonts> opened = Fonts::open();
    if (!opened) return failure(opened.error());
    fonts = std::move(opened).value();
  }
  const auto last_number = static_cast<std::int64_t>(lesson.stages.size());
  for (const Place& place : *stages) {
    const auto number = static_cast<std::int64_t>(place.number);
    const Subject subject{place, fmt::format("{}-{}", zero_padded(number, last_number, 2), place.stage->id),
                          fmt::format(".{}", name_of(options.format))};
    std::vector<std::size_t> steps = steps_with(*place.stage, options.what);
    if (steps.empty())
      plan.left_out.push_back(place.stage->id);
    else if (options.each == Each::step)
      plan_steps(subject, options.what, plan);
    else if (fonts) {
      if (Status planned = plan_pages(subject, lesson, options, *fonts, still_numbers, plan); !planned)
        return failure(planned.error());
    } else if (options.each == Each::frame)
      films.push_back(
          {subject, options.what == What::equation ? std::vector{steps.back()} : std::move(steps)});
    else if (options.what == What::equation)
      plan_equations(subject, plan);
    else
      plan.pictures.push_back(picture_of(subject, steps.back(), nullptr, ""));
  }
  if (options.each == Each::frame)
    if (const Status planned = plan_films(films, options, plan); !planned) return failure(planned.error());
  return plan;
}

double time_of(const PlannedPicture& picture, const ExportOptions& options, double speed) {
  if (!picture.frame) return options.at_s.value_or(still_time_s(*picture.scene));
  return frame_time(options.fps, picture.frame_of_stage, speed, options.at_s.value_or(0.0));
}

}  // namespace polhode
