// SPDX-License-Identifier: MIT
// polhode export: pictures of a lesson as PNG files, or its text.
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/manifest.h"
#include "app/or_fail.h"
#include "app/picture_maker.h"
#include "app/picture_metadata.h"
#include "app/picture_writer.h"
#include "app/progress.h"
#include "app/transcript.h"
#include "app/usage.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <span>

namespace polhode {

namespace fs = std::filesystem;

namespace {

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error) && !error)
    error = std::make_error_code(std::errc::not_a_directory);
  if (error)
    throw CommandError(ExitCode::failed,
                       fmt::format("cannot make folder {}: {}", folder.string(), error.message()));
}

void write_text(const std::string& name, const std::string& text, const ExportOutput& out) {
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  or_fail(write_file_atomically(out.folder / name, bytes, out.durability));
}

void write_manifest(const Manifest& manifest, const ExportOutput& out) {
  write_text(kManifestName, to_text(manifest), out);
  or_fail(sync_folder(out.folder));
}

/// What all makers draw with.
struct Studio {
  explicit Studio(ContextKind kind)
      : context(or_fail(open_context(kind))), renderer(or_fail(Renderer::create(*context))) {}
  std::unique_ptr<GlContext> context;
  std::unique_ptr<Renderer> renderer;  // after the context it draws with
};

std::unique_ptr<PictureMaker> maker_of(const MakerContext& context) {
  switch (context.options.what) {
    case What::figure:
      return make_figure_maker(context);
    case What::equation:
      return make_equation_maker(context);
    case What::page:
    case What::transcript:
      break;
  }
  return make_page_maker(context);
}

/// What can fail without drawing fails before anything is written: of neighbours that differ in time alone,
/// the first and the last are checked.
void check_pictures(const ExportPlan& plan, PictureMaker& maker) {
  const auto same_but_time = [&](std::size_t i, std::size_t k) {
    const PlannedPicture &a = plan.pictures[i], &b = plan.pictures[k];
    return a.stage == b.stage && a.step == b.step && a.equation == b.equation;
  };
  for (std::size_t i = 0; i < plan.pictures.size(); ++i) {
    const bool first = i == 0 || !same_but_time(i - 1, i);
    const bool last = i + 1 == plan.pictures.size() || !same_but_time(i, i + 1);
    if (first || last) maker.check(plan.pictures[i]);
  }
}

/// An export of pictures that has begun.
struct PictureExport {
  const LoadedLesson& loaded;
  const ExportOptions& options;
  const ExportOutput& out;
  const ExportPlan& plan;
};

PictureFile drawn_file(const PlannedPicture& picture, const PictureExport& e, PictureMaker& maker) {
  const PictureDescription description = maker.describe(picture);
  return {picture.file, maker.draw(picture),
          picture_metadata(e.loaded.lesson, *picture.stage, description.alt, description.t_s, e.options.dpi)};
}

/// Draws and writes until all are there or someone interrupts. Returns how many there are.
std::size_t write_pictures(const PictureExport& e, PictureMaker& maker, const InterruptWatch& watch) {
  const ProgressBar progress(static_cast<std::int64_t>(e.plan.pictures.size()));
  PictureWriter writer(e.out.folder, e.options.png, e.out.durability);
  const PlannedPicture* before = nullptr;
  std::size_t count = 0;
  for (const PlannedPicture& picture : e.plan.pictures) {
    if (watch.interrupted()) break;
    progress.show(static_cast<std::int64_t>(count), picture.file);
    const bool repeats = before && maker.same_bytes(*before, picture);
    or_fail(
        writer.put(repeats ? PictureFile{picture.file, std::nullopt, {}} : drawn_file(picture, e, maker)));
    before = &picture;
    ++count;
  }
  or_fail(writer.finish());
  return count;
}

ManifestFile manifest_file(const PlannedPicture& picture, PictureMaker& maker) {
  PictureDescription made = maker.describe(picture);
  return {picture.file, picture.stage->id,   picture.step,        picture.frame,         made.t_s,
          made.size,    std::move(made.tex), std::move(made.alt), std::move(made.method)};
}

/// Every picture lies whole under its name in the folder, and so does the manifest. Also reached where other
/// processes drew them: what is needed of a picture is in its file, the plan and the manifest.
void make_film_and_deck(const PictureExport& e) {
  static_cast<void>(e);
  // if (!e.out.film.empty()) write_film(…)
  // if (!e.out.deck.empty()) write_deck(…)
}

/// The pictures of a film or deck that nobody asked to keep. Only what the export has made is removed.
void remove_parts(const PictureExport& e) {
  std::error_code ignored;
  fs::remove(e.out.folder / kManifestName, ignored);
  for (const PlannedPicture& picture : e.plan.pictures) fs::remove(e.out.folder / picture.file, ignored);
  fs::remove(e.out.folder, ignored);
}

void note_left_out(const ExportPlan& plan, What what) {
  const char* missing = what == What::equation ? "equation" : "scene";
  for (const std::string& id : plan.left_out)
    fmt::print(stderr, "polhode: stage \"{}\" has no {} and is left out\n", id, missing);
  if (plan.pictures.empty())
    throw CommandError(ExitCode::usage,
                       fmt::format("nothing to export: no frame, or no stage with {} {}, was selected",
                                   what == What::equation ? "an" : "a", missing));
}

void report_done(std::size_t count, const char* kind, const ExportOutput& out) {
  fmt::print(stderr, "{} {}{} and {} in {}\n", count, kind, count == 1 ? "" : "s", kManifestName,
             out.folder.string());
}

ExitCode export_pictures(const LoadedLesson& loaded, const ExportOptions& options, const ExportOutput& out) {
  const ExportPlan plan = plan_export(loaded.lesson, options);
  note_left_out(plan, options.what);
  Manifest manifest{loaded.lesson.id, loaded.sha256, to_json(options), "", {}};
  or_fail(may_export_into(out.folder, loaded.sha256, manifest.options));

  const Studio studio(out.context);
  const auto maker = maker_of({loaded.lesson, options, *studio.renderer});
  check_pictures(plan, *maker);
  manifest.renderer = studio.renderer->driver();
  const PictureExport e{loaded, options, out, plan};
  const InterruptWatch watch;
  make_folder(out.folder);
  const std::size_t count = write_pictures(e, *maker, watch);
  if (watch.interrupted()) {
    fmt::print(stderr, "polhode: interrupted after {} of {} pictures in {}; no manifest written\n", count,
               plan.pictures.size(), out.folder.string());
    return ExitCode::interrupted;
  }
  for (const PlannedPicture& picture : plan.pictures)
    manifest.files.push_back(manifest_file(picture, *maker));
  write_manifest(manifest, out);
  make_film_and_deck(e);
  if (out.keep_folder)
    report_done(count, "picture", out);
  else
    remove_parts(e);
  return ExitCode::done;
}

ExitCode export_transcript(const LoadedLesson& loaded, const ExportOptions& options,
                           const ExportOutput& out) {
  for (const std::string& id : options.stages) static_cast<void>(stage_of(loaded.lesson, id));
  Manifest manifest{loaded.lesson.id, loaded.sha256, to_json(options), "", {}};
  or_fail(may_export_into(out.folder, loaded.sha256, manifest.options));
  make_folder(out.folder);
  const std::string name = loaded.lesson.id + ".txt";
  write_text(name, transcript_of(loaded.lesson, options.stages), out);
  ManifestFile file;
  file.file = name;
  manifest.files.push_back(std::move(file));
  write_manifest(manifest, out);
  report_done(1, "transcript", out);
  return ExitCode::done;
}

ExitCode run_export(const TypedExport& typed) {
  const ExportOptions options = export_options(typed);
  const ExportOutput out = export_output(typed);
  const LoadedLesson loaded = load_lesson(typed.lesson);
  check_type_of(loaded, or_fail(Fonts::open()));
  return options.what == What::transcript ? export_transcript(loaded, options, out)
                                          : export_pictures(loaded, options, out);
}

}  // namespace

void add_export(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "export", "Export a lesson's pages, equations and figures as PNG files, or its text");
  auto typed = std::make_shared<TypedExport>();
  const auto option = [&](const char* name, std::string& value, const char* form, const char* text) {
    return command->add_option(name, value, text)->option_text(form)->check(refuse_empty);
  };
  option("LESSON", typed->lesson, " ", "id or file")->required();
  option("-o,--output", typed->folder, "DIR", "folder for the files; made if missing");
  command->add_option("--stage", typed->stages, "only this stage; repeat for more (default: all)")
      ->option_text("ID")
      ->check(refuse_empty)
      ->allow_extra_args(false);
  option("--what", typed->what, "KIND", "page, equation, figure or transcript (default: page)");
  option("--each", typed->each, "KIND", "a picture for each stage, step or frame (default: stage)");
  option("--size", typed->size, "WxH", "pixels, each 1 to 16384, of pages from 320x240 (default: 1920x1080)");
  option("--theme", typed->theme, "NAME", "of pages and equations: paper or dark (default: paper)");
  option("--background", typed->background, "NAME",
         "studio (default of figures), paper, white, transparent, #rrggbb");
  option("--dpi", typed->dpi, "N", "dots per inch to note in the files; sizes 12 pt equations (300)");
  option("--fps", typed->fps, "N|A/B", "frames per shown second, with --each frame (default: 30)");
  option("--seconds", typed->seconds, "S", "shown seconds per stage, with --each frame (default: 8)");
  option("--at", typed->at, "T", "t in s of stills (default: the scene's), of first frames (0)");
  option("--frames", typed->frames, "A:B", "frames A to B-1 of the whole selection, from 0 (default: all)");
  option("--png", typed->png, "KIND", "fast to pack, or small and slow (default: fast)");
  option("--film", typed->film, "FILE", "make a film of the frames; without -o they are removed then");
  option("--deck", typed->deck, "FILE", "make slides of the pictures; without -o these are removed then");
  option("--sync", typed->sync, "WHEN", "flush to disk at the end or after each frame (default: end)");
  option("--context", typed->context, "KIND", "OpenGL from auto, osmesa or egl (default: auto)");
  command->footer(
      "A page has text, equations, figure and plots. It shows a stage at its last step, or step by step.\n"
      "An equation is cropped to its ink; frame by frame, one line of a stage turns into the next.\n"
      "A transcript is plain text with the formulas in words.\n"
      "Files: NN-STAGE.png, NN-STAGE-EQUATION.png, NN-STAGE-stepK.png, NN-STAGE-frameF.png, LESSON.txt;\n"
      "NN is the stage's place in the lesson. Each appears whole or not at all; manifest.json comes last.\n"
      "The bytes depend on lesson and options alone. A folder with an export of other options or another\n"
      "lesson text is refused.");
  command->callback([typed, &action] { action = [typed] { return run_export(*typed); }; });
}

}  // namespace polhode
