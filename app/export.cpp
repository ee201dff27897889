// SPDX-License-Identifier: MIT
// polhode export: pictures of a lesson as PNG files.
#include "app/alt_text.h"
#include "app/commands.h"
#include "app/export_plan.h"
#include "app/interrupt.h"
#include "app/lesson_lookup.h"
#include "app/manifest.h"
#include "app/numbers.h"
#include "app/picture_metadata.h"
#include "app/progress.h"
#include "app/suggest.h"
#include "app/usage.h"
#include "render/gl/renderer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <span>

namespace polhode {

namespace fs = std::filesystem;

namespace {

/// As typed; empty where not given.
struct TypedOptions {
  std::string lesson, folder;
  std::vector<std::string> stages;
  std::string each, what, size, fps, seconds, at, frames, background, dpi, sync, context;
};

struct Output {
  fs::path folder;
  Background background;
  Durability durability = Durability::rename_only;
  ContextKind context = ContextKind::any;
};

CommandError usage(std::string text) { return {ExitCode::usage, std::move(text)}; }

/// The place of `typed` in `choices`, or `standard` if nothing was typed.
std::size_t choice(std::string_view option, const std::string& typed, const std::vector<std::string>& choices,
                   std::size_t standard = 0) {
  if (typed.empty()) return standard;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (choices[i] == typed) return i;
  throw usage(fmt::format("{}: \"{}\" is none of {}{}", option, typed, fmt::join(choices, ", "),
                          did_you_mean(typed, choices)));
}

void check_what(const std::string& what) {
  const std::size_t chosen = choice("--what", what, {"figure", "page", "equation", "transcript"});
  if (chosen != 0) throw usage(fmt::format("--what {} is not available yet; what there is: figure", what));
}

void check_film_options(const TypedOptions& typed, Each each) {
  if (each == Each::frame) return;
  for (const auto& [name, value] : {std::pair{"--fps", &typed.fps}, std::pair{"--seconds", &typed.seconds},
                                    std::pair{"--frames", &typed.frames}})
    if (!value->empty()) throw usage(fmt::format("{} goes with --each frame", name));
}

template <class T>
T read_or_refuse(const std::optional<T>& value, std::string_view option, std::string_view typed,
                 std::string_view form) {
  if (!value) throw usage(fmt::format("{}: \"{}\" is not {}", option, typed, form));
  return *value;
}

ExportOptions export_options(const TypedOptions& typed) {
  ExportOptions options;
  check_what(typed.what);
  options.stages = typed.stages;
  options.each = static_cast<Each>(choice("--each", typed.each, {"stage", "step", "frame"}));
  check_film_options(typed, options.each);
  if (!typed.size.empty()) options.size = picture_size("--size", typed.size, kMaxImageSide);
  if (!typed.fps.empty())
    options.fps = read_or_refuse(frame_rate_from(typed.fps), "--fps", typed.fps,
                                 "a frame rate; write it like 25 or 30000/1001, terms from 1 to 1000000");
  if (!typed.seconds.empty()) options.seconds = finite_number("--seconds", typed.seconds);
  if (options.seconds < 0) throw usage(fmt::format("--seconds: {} is negative", typed.seconds));
  if (!typed.at.empty()) options.at_s = finite_number("--at", typed.at);
  if (!typed.frames.empty())
    options.frames = read_or_refuse(frame_range_from(typed.frames), "--frames", typed.frames,
                                    "a range A:B with 0 <= A < B, like 0:48");
  if (!typed.background.empty()) options.background = typed.background;
  if (!typed.dpi.empty()) options.dpi = static_cast<int>(whole_number("--dpi", typed.dpi, 1, 100000));
  return options;
}

Output output(const TypedOptions& typed, const ExportOptions& options) {
  const std::vector<std::string> backgrounds = {"studio", "paper", "white", "transparent", "#rrggbb"};
  Output out;
  out.folder = typed.folder;
  const auto background = background_from(options.background);
  if (!background)
    throw usage(fmt::format("--background: \"{}\" is none of {}{}", options.background,
                            fmt::join(backgrounds, ", "), did_you_mean(options.background, backgrounds)));
  out.background = *background;
  out.durability =
      choice("--sync", typed.sync, {"end", "frame"}) == 1 ? Durability::sync : Durability::rename_only;
  constexpr ContextKind kKinds[] = {ContextKind::any, ContextKind::osmesa, ContextKind::egl};
  out.context = kKinds[choice("--context", typed.context, {"auto", "osmesa", "egl"})];
  return out;
}

/// A motion may overflow (a huge torque), or lie beyond the steps that its method takes.
void check_computable(const PlannedPicture& picture, const SceneModel& model, double t_s) {
  const bool finite = model.needs.attitude ? model.motion->at(t_s).w_B.allFinite() &&
                                                 model.motion->at(t_s).q_SB.coeffs().allFinite()
                                           : !model.needs.omega || model.motion->w_B_at(t_s).allFinite();
  if (!finite)
    throw CommandError(
        ExitCode::failed,
        fmt::format("stage \"{}\": the motion cannot be computed at t = {:.6g} s: the torque is too "
                    "large, or it is too many steps away",
                    picture.stage->id, t_s));
}

template <class T>
T or_fail(Result<T>&& result) {
  if (!result) throw CommandError(ExitCode::failed, result.error());
  return std::move(result).value();
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error) && !error)
    error = std::make_error_code(std::errc::not_a_directory);
  if (error)
    throw CommandError(ExitCode::failed,
                       fmt::format("cannot make folder {}: {}", folder.string(), error.message()));
}

/// Draws and writes pictures one after the other; keeps the model while the scene stays the same.
class Exporter {
 public:
  Exporter(const LoadedLesson& loaded, const ExportOptions& options, const Output& out)
      : lesson_(loaded.lesson), options_(options), out_(out) {
    context_ = or_fail(open_context(out.context));
    renderer_ = or_fail(Renderer::create(*context_));
  }

  ManifestFile make(const PlannedPicture& picture) {
    if (scene_ != picture.scene) {
      model_ = make_model(*picture.scene);
      scene_ = picture.scene;
    }
    const double t_s = time_of(picture, options_, model_.rate);
    check_computable(picture, model_, t_s);
    const double aspect = static_cast<double>(options_.size.width) / options_.size.height;
    const Image image =
        or_fail(renderer_->draw(make_figure(model_, t_s, aspect), options_.size, out_.background));
    const std::string alt = alt_text(*picture.stage, *picture.scene, model_.motion->w_B_at(t_s), t_s);
    or_fail(write_png(out_.folder / picture.file, image,
                      picture_metadata(lesson_, *picture.stage, alt, t_s, options_.dpi), out_.durability));
    return {picture.file,
            picture.stage->id,
            picture.step,
            picture.frame,
            t_s,
            options_.size,
            tex_shown(*picture.stage, picture.step),
            alt,
            std::string(model_.motion->method())};
  }

  std::string driver() const { return renderer_->driver(); }

 private:
  const Lesson& lesson_;
  const ExportOptions& options_;
  const Output& out_;
  std::unique_ptr<GlContext> context_;
  std::unique_ptr<Renderer> renderer_;  // after the context it draws with
  const Scene* scene_ = nullptr;        // of model_
  SceneModel model_;
};

void write_manifest(const Manifest& manifest, const Output& out) {
  const std::string text = to_text(manifest);
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  or_fail(write_file_atomically(out.folder / kManifestName, bytes, out.durability));
  or_fail(sync_folder(out.folder));
}

ExitCode make_pictures(const ExportPlan& plan, const InterruptWatch& watch, Exporter& exporter,
                       Manifest& manifest, const Output& out) {
  const auto total = static_cast<std::int64_t>(plan.pictures.size());
  {
    const ProgressBar progress(total);
    for (const PlannedPicture& picture : plan.pictures) {
      if (watch.interrupted()) break;
      progress.show(static_cast<std::int64_t>(manifest.files.size()), picture.file);
      manifest.files.push_back(exporter.make(picture));
    }
  }
  if (watch.interrupted()) {
    fmt::print(stderr, "polhode: interrupted after {} of {} pictures in {}; no manifest written\n",
               manifest.files.size(), total, out.folder.string());
    return ExitCode::interrupted;
  }
  write_manifest(manifest, out);
  return ExitCode::done;
}

void note_skipped(const ExportPlan& plan) {
  for (const std::string& id : plan.without_scene)
    fmt::print(stderr, "polhode: stage \"{}\" has no scene and is left out\n", id);
  if (plan.pictures.empty())
    throw usage("nothing to export: no frame, or no stage with a scene, was selected");
}

ExitCode run_export(const TypedOptions& typed) {
  const ExportOptions options = export_options(typed);
  const Output out = output(typed, options);
  const LoadedLesson loaded = load_lesson(typed.lesson);
  const ExportPlan plan = plan_export(loaded.lesson, options);
  note_skipped(plan);

  Manifest manifest{loaded.lesson.id, loaded.sha256, to_json(options), "", {}};
  make_folder(out.folder);
  or_fail(may_export_into(out.folder, loaded.sha256, manifest.options));

  const InterruptWatch watch;
  Exporter exporter(loaded, options, out);
  manifest.renderer = exporter.driver();
  const ExitCode code = make_pictures(plan, watch, exporter, manifest, out);
  if (code == ExitCode::done)
    fmt::print(stderr, "{} picture{} and {} in {}\n", manifest.files.size(),
               manifest.files.size() == 1 ? "" : "s", kManifestName, out.folder.string());
  return code;
}

}  // namespace

void add_export(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("export", "Export a lesson's pictures as PNG files and a manifest.json");
  auto typed = std::make_shared<TypedOptions>();
  const auto option = [&](const char* name, std::string& value, const char* form, const char* text) {
    return command->add_option(name, value, text)->option_text(form)->check(refuse_empty);
  };
  option("LESSON", typed->lesson, " ", "id or file")->required();
  option("-o,--output", typed->folder, "DIR", "folder for the files; made if missing (required)")->required();
  command->add_option("--stage", typed->stages, "only this stage; repeat for more (default: all)")
      ->option_text("ID")
      ->check(refuse_empty)
      ->allow_extra_args(false);
  option("--each", typed->each, "KIND", "a picture for each stage, step or frame (default: stage)");
  option("--what", typed->what, "KIND", "figure; page, equation, transcript: not yet (default: figure)");
  option("--size", typed->size, "WxH", "pixels, each 1 to 16384 (default: 1920x1080)");
  option("--fps", typed->fps, "N|A/B", "frames per shown second, with --each frame (default: 30)");
  option("--seconds", typed->seconds, "S", "shown seconds per stage, with --each frame (default: 8)");
  option("--at", typed->at, "T", "t in s of stills (default: the scene's), of first frames (0)");
  option("--frames", typed->frames, "A:B", "frames A to B-1 of the whole selection, from 0 (default: all)");
  option("--background", typed->background, "NAME",
         "studio, paper, white, transparent, #rrggbb (default: studio)");
  option("--dpi", typed->dpi, "N", "dots per inch noted in the files (default: none)");
  option("--sync", typed->sync, "WHEN", "flush to disk at the end or after each frame (default: end)");
  option("--context", typed->context, "KIND", "OpenGL from auto, osmesa or egl (default: auto)");
  command->footer(
      "Files: NN-STAGE.png, NN-STAGE-stepK.png, NN-STAGE-frameF.png; NN is the stage's place in the lesson.\n"
      "Each appears whole or not at all; manifest.json comes last. The bytes depend on lesson and options\n"
      "alone. A folder with an export of other options or another lesson text is refused.");
  command->callback([typed, &action] { action = [typed] { return run_export(*typed); }; });
}

}  // namespace polhode
