// SPDX-License-Identifier: MIT
// polhode export: pictures of a lesson as PNG files, its text, or what is made of both.
#include "app/cli/commands/commands.h"
#include "app/cli/commands/export_options.h"
#include "app/cli/commands/export_site.h"
#include "app/cli/commands/live_parts.h"
#include "app/cli/lesson_lookup.h"
#include "app/cli/message.h"
#include "app/cli/or_fail.h"
#include "app/cli/progress.h"
#include "app/export/jobs.h"
#include "app/export/picture_export.h"
#include "app/narration/transcript.h"
#include "app/publish/ffmpeg.h"
#include "app/publish/film.h"
#include "app/publish/lesson_deck.h"
#include "app/publish/live/sandbox_page.h"
#include "app/publish/text_edition/reader_page.h"
#include "base/files/left_behind.h"
#include "base/files/temporary_file.h"
#include "base/printable.h"
#include "base/sha256.h"
#include "base/shell_line.h"
#include "lessons/reader/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <span>

namespace polhode {

namespace fs = std::filesystem;

namespace {

void write_text(const std::string& name, const std::string& text, const ExportOutput& out) {
  or_fail(replace_file_atomically(out.folder / name, bytes_of(text), out.durability));
}

/// With the pictures that are there. @throws Interrupted
Status make_deck(const PictureExport& e, const InterruptWatch& watch) {
  Result<Deck> deck = deck_of(e.loaded.lesson, e.options, e.plan, e.out.folder);
  if (!deck) return failure(deck.error());
  if (e.out.live) deck->live = LiveParts{live_program(), text_again(e.loaded), e.out.live_file};
  const std::size_t count = deck->slides.size();
  {
    const ProgressBar progress(static_cast<std::int64_t>(count));
    const auto go_on = [&](std::size_t slide) {
      progress.show(static_cast<std::int64_t>(slide), e.out.deck);
      return !watch.interrupted();
    };
    const Result<DeckEnd> end =
        write_deck(e.out.deck, *deck_kind_of(e.out.deck), *deck, e.out.durability, go_on);
    if (!end) return failure(end.error());
    if (*end == DeckEnd::stopped) throw Interrupted();
  }
  say("{} slide{} in {}\n", count, count == 1 ? "" : "s", e.out.deck);
  return success();
}

/// Frames pass as they are; of stills each is shown for --seconds.
FilmRequest film_of(const PictureExport& e) {
  const Lesson& lesson = e.loaded.lesson;
  FilmRequest film{.file = e.out.film, .pictures = {}, .rate = e.options.fps, .title = lesson.title};
  for (const PlannedPicture& picture : e.plan.pictures) film.pictures.push_back(e.out.folder / picture.file);
  if (e.options.each != Each::frame)
    film.frames_each = std::max<std::int64_t>(1, frame_count(e.options.fps, e.options.seconds));
  return film;
}

/// Every picture lies whole under its name in the folder, and so does the manifest. Also reached where other
/// processes drew them: what is needed of a picture is in its file, the plan and the manifest.
Status make_film_and_deck(const PictureExport& e, const InterruptWatch& watch) {
  if (!e.out.film.empty()) {
    const FilmRequest film = film_of(e);
    {
      const ProgressBar progress(std::ssize(film.pictures));
      const auto show = [&](std::int64_t done) { progress.show(done, film.file.filename().string()); };
      if (Status written = write_film(film, watch, show); !written) return written;
    }
    say("film of {} pictures: {}\n", film.pictures.size(), e.out.film);
  }
  return e.out.deck.empty() ? success() : make_deck(e, watch);
}

/// The pictures of a film or deck that nobody asked to keep. Only what the export has made is removed; the
/// manifest last, by which the folder is still known as ours if we are killed here.
void remove_parts(const PictureExport& e) {
  std::error_code ignored;
  for (const PlannedPicture& picture : e.plan.pictures) fs::remove(e.out.folder / picture.file, ignored);
  fs::remove(e.out.folder / kManifestName, ignored);
  fs::remove(e.out.folder, ignored);
}

void note_left_out(const ExportPlan& plan, What what) {
  const char* missing = what == What::equation ? "equation" : "scene";
  for (const std::string& id : plan.left_out)
    say("polhode: stage \"{}\" has no {} and is left out\n", id, missing);
  if (plan.pictures.empty())
    throw CommandError(ExitCode::usage,
                       fmt::format("nothing to export: no frame, or no stage with {} {}, was selected",
                                   what == What::equation ? "an" : "a", missing));
}

/// It is exported all the same, with "does not hold" beside it: whoever asked for it should know.
void note_refuted(const Lesson& lesson, const std::vector<std::string>& stages) {
  const auto fails = [](const ClaimLine& line) {
    return line.judgement && line.judgement->verdict == Verdict::fails;
  };
  for (const Stage& stage : lesson.stages) {
    if (!stages.empty() && std::find(stages.begin(), stages.end(), stage.id) == stages.end()) continue;
    for (std::size_t i = 0; i < stage.steps.size(); ++i)
      for (const Claim* claim : blocks_of<Claim>(stage.steps[i]))
        if (std::any_of(claim->lines.begin(), claim->lines.end(), fails))
          say("polhode: {}:{}: what \"{}\" claims does not hold, and its page says so; polhode lint says "
              "why\n",
              stage.id, i + 1, claim->equation);
  }
}

Outcome<PicturesMade> make_with_progress(const PictureExport& e, const InterruptWatch& watch) {
  const ProgressBar progress(static_cast<std::int64_t>(e.out.shard.size(e.plan.pictures.size())));
  return make_pictures(
      e,
      [&](std::size_t done, const std::string& next) {
        progress.show(static_cast<std::int64_t>(done), next);
      },
      watch);
}

/// Each process makes a shard of this shard; the last of them to finish writes the manifest.
Outcome<PicturesMade> make_in_jobs(const PictureExport& e, const InterruptWatch& watch) {
  const std::size_t total = e.out.shard.size(e.plan.pictures.size());
  const auto job = [&](int number, const TellJob& tell) -> Outcome<JobEnd> {
    ::setenv("LP_NUM_THREADS", "1", 1);  // the processes share the cores; each drawing in threads costs more
    ExportOutput out = e.out;
    out.shard = e.out.shard.part(number, e.out.jobs);
    const PictureExport part{e.loaded, e.options, out, e.plan};
    const Outcome<PicturesMade> made = make_pictures(
        part, [&](std::size_t, const std::string&) { tell(); }, watch);
    if (!made) return passed_on(made);
    return made->interrupted ? JobEnd::interrupted : JobEnd::done;
  };
  PicturesMade made;
  {
    const ProgressBar progress(static_cast<std::int64_t>(total));
    const auto show = [&](std::size_t begun) {
      made.count = begun;
      progress.show(static_cast<std::int64_t>(begun), fmt::format("in {} processes", e.out.jobs));
    };
    const Outcome<JobEnd> end = run_jobs(e.out.jobs, job, show, watch);
    if (!end) return passed_on(end);
    made.interrupted = *end == JobEnd::interrupted;
  }
  const auto folder = inspect_folder(e.out.folder, identity_of(e.loaded, e.options));
  made.finished = !made.interrupted && folder && folder->finished;
  if (!made.interrupted && !made.finished && e.out.shard.whole())
    return failure_of(Fault::failed,
                      fmt::format("--jobs: {} lost files of its processes", e.out.folder.string()));
  return made;
}

/// The end of a sentence. A command that a terminal does not show as it is could not be copied from there.
std::string go_on_with(const std::vector<std::string>& words) {
  if (!shows_as_it_is(words)) return "go on with the same command and --skip-existing";
  return "go on with\n  " + shell_line(words);
}

void report_interruption(const PictureExport& e, const PicturesMade& made) {
  say("polhode: interrupted after {} of {} pictures in {}; {}\n", made.count,
      e.out.shard.size(e.plan.pictures.size()), e.out.folder.string(), go_on_with(e.out.resume));
}

void report_pictures(const PictureExport& e, const PicturesMade& made) {
  const std::string count = fmt::format("{} picture{}", made.count, made.count == 1 ? "" : "s");
  const std::string kept = made.kept > 0 ? fmt::format(" ({} of them kept)", made.kept) : "";
  const std::string folder = e.out.folder.string();
  if (made.renderer.find(kBetweenRenderers) != std::string::npos)
    say("polhode: drawn by different drivers, which may differ by a level here and there: {}\n",
        made.renderer);
  if (made.finished)
    say("{}{} and {} in {}\n", count, kept, kManifestName, folder);
  else
    say("{}{} of shard {}/{} in {}; the last shard to finish writes {}\n", count, kept, e.out.shard.index,
        e.out.shard.count, folder, kManifestName);
}

/// What failed may be mended: a full disk, a lost connection.
Error with_advice(const PictureExport& e, Error error) {
  const auto folder = inspect_folder(e.out.folder, identity_of(e.loaded, e.options));
  if (error.fault == Fault::failed && folder && folder->ours)
    error.text += fmt::format("\nWhat is whole is kept; {}", go_on_with(e.out.resume));
  return error;
}

/// Pictures, film and deck, and what is said of them. @throws Interrupted
Outcome<ExitCode> make_all(const PictureExport& e, const InterruptWatch& watch) {
  if (!e.out.deck.empty())
    if (const Status folder = make_folder(fs::absolute(e.out.deck).parent_path()); !folder)
      return failed(folder);
  const Outcome<PicturesMade> made = e.out.jobs > 1 ? make_in_jobs(e, watch) : make_with_progress(e, watch);
  if (!made) return passed_on(made);
  if (made->interrupted) {
    report_interruption(e, *made);
    return ExitCode::interrupted;
  }
  if (made->finished)
    if (const Status published = make_film_and_deck(e, watch); !published) return failed(published);
  if (e.out.keep_folder)
    report_pictures(e, *made);
  else
    remove_parts(e);
  return ExitCode::done;
}

void refuse_folder(const char* option, const std::string& file) {
  std::error_code unknown;  // told where the file is written
  if (fs::is_directory(file, unknown))
    throw CommandError(ExitCode::failed,
                       fmt::format("{}: {} is a folder; give it a name of its own", option, file));
}

/// Before all is drawn for nothing.
void refuse_folders(const ExportOutput& out) {
  refuse_folder("--film", out.film);
  refuse_folder("--deck", out.deck);
}

/// What lies in the folder of the pictures. FILE.parts is a name that others can guess, and what is in it
/// goes in the end: there no link is followed, and nothing but what an export of ours left is taken over.
void look_into_folder(const ExportIdentity& mine, const ExportOutput& out) {
  constexpr const char* kAdvice = "move it away, or say where the pictures go with --output DIR";
  std::error_code error;
  const std::string folder = out.folder.string();
  if (!out.keep_folder && fs::is_symlink(out.folder, error))
    throw CommandError(ExitCode::failed, fmt::format("{} is a link; {}", folder, kAdvice));
  const FolderState state = or_fail(inspect_folder(out.folder, mine));
  if (out.keep_folder || state.ours) return;
  for (fs::directory_iterator entry(out.folder, error), end; !error && entry != end; entry.increment(error))
    if (!is_temporary_name(entry->path().filename().string()))
      throw CommandError(ExitCode::failed,
                         fmt::format("{} holds files of something else; {}", folder, kAdvice));
}

}  // namespace

ExitCode export_pictures(const LoadedLesson& loaded, const ExportOptions& options, const ExportOutput& out) {
  const ExportPlan plan = or_usage(plan_export(loaded.lesson, options));
  note_left_out(plan, options.what);
  note_refuted(loaded.lesson, options.stages);
  refuse_folders(out);
  if (out.live) static_cast<void>(live_program());  // before all is drawn for nothing
  look_into_folder(identity_of(loaded, options), out);
  const PictureExport e{loaded, options, out, plan};
  const InterruptWatch watch;
  try {
    Outcome<ExitCode> end = make_all(e, watch);
    if (!end) end = Failure{with_advice(e, end.error())};
    return or_fail(std::move(end));
  } catch (const Interrupted&) {
    say("polhode: interrupted; the pictures are in {}; {}\n", out.folder.string(), go_on_with(out.resume));
    return ExitCode::interrupted;
  }
}

namespace {

ExitCode export_transcript(const LoadedLesson& loaded, const ExportOptions& options,
                           const ExportOutput& out) {
  for (const std::string& id : options.stages) static_cast<void>(stage_of(loaded.lesson, id));
  note_refuted(loaded.lesson, options.stages);
  const ExportIdentity identity = identity_of(loaded, options);
  or_fail(inspect_folder(out.folder, identity));
  or_fail(make_folder(out.folder));
  remove_left_behind_in(out.folder);
  ManifestFile file;
  file.file = loaded.lesson.id + ".txt";
  const std::string text = transcript_of(loaded.lesson, options.stages);
  file.sha256 = sha256_hex(text);
  write_text(file.file, text, out);
  or_fail(sync_folder(out.folder));
  write_text(kManifestName, manifest_head(identity, "") + manifest_entry(file) + manifest_end(false), out);
  say("1 transcript and {} in {}\n", kManifestName, out.folder.string());
  return ExitCode::done;
}

/// Of the lessons among them that can be read, in the language of this one where there is such a translation.
std::map<std::string, ReaderTitle> titles_of_prerequisites(const Lesson& lesson) {
  std::map<std::string, ReaderTitle> titles;
  for (const FoundLesson& found : lessons_and_translations_in(lesson_folders())) {
    const auto is_it = [&](const std::string& line) {
      return found.id == line || found.id == page_name(line, lesson.about.language);
    };
    const std::vector<std::string>& lines = lesson.about.prerequisites;
    const auto line = std::find_if(lines.begin(), lines.end(), is_it);
    if (line == lines.end()) continue;
    const Outcome<std::string> text = read_lesson_text(found.path);
    if (!text) continue;
    // A translation stands behind its original.
    if (const LessonReading other = read_lesson(*text, found.path.string()); other.lesson)
      titles[*line] = {other.lesson->title, other.lesson->about.language};
  }
  return titles;
}

/// What is drawn goes into the file as it is made, so there is nothing to go on with after a stop.
ExitCode export_reader(const LoadedLesson& loaded, const ReaderOutput& out) {
  for (const std::string& id : out.stages) static_cast<void>(stage_of(loaded.lesson, id));
  note_refuted(loaded.lesson, out.stages);
  refuse_folder("--reader", out.file);
  std::optional<LiveParts> live;
  if (out.live) live = LiveParts{live_program(), text_again(loaded)};
  or_fail(make_folder(fs::absolute(out.file).parent_path()));
  const InterruptWatch watch;
  const auto context = or_fail(open_context(out.context));
  const Fonts fonts = or_fail(Fonts::open());
  or_fail(check_type_of(loaded, fonts));
  const auto renderer = or_fail(Renderer::create(*context, fonts));
  const ReaderEdition edition{.lesson = loaded.lesson,
                              .stages = out.stages,
                              .look = {out.theme, out.quality, out.in_both_themes},
                              .place = {},
                              .titles = titles_of_prerequisites(loaded.lesson),
                              .live = live};
  const std::size_t count = steps_of(edition);
  ReaderEnd end = ReaderEnd::stopped;
  {
    const ProgressBar progress(static_cast<std::int64_t>(count));
    const auto go_on = [&](std::size_t step, const Stage& stage) {
      progress.show(static_cast<std::int64_t>(step), stage.id);
      return !watch.interrupted();
    };
    end = or_fail(write_reader(out.file, edition, *renderer, out.durability, go_on, until_interrupted()));
  }
  if (end == ReaderEnd::stopped) {
    say("polhode: interrupted; {} was not written\n", out.file);
    return ExitCode::interrupted;
  }
  say("{} step{} in {}\n", count, count == 1 ? "" : "s", out.file);
  return ExitCode::done;
}

ExitCode export_sandbox(const ReaderOutput& out) {
  refuse_folder("--sandbox", out.file);
  const LiveProgram program = live_program();
  or_fail(make_folder(fs::absolute(out.file).parent_path()));
  const auto context = or_fail(open_context(out.context));
  const Fonts fonts = or_fail(Fonts::open());
  const auto renderer = or_fail(Renderer::create(*context, fonts));
  or_fail(write_sandbox(out.file, program, *renderer, out.durability));
  say("a sandbox in {}\n", out.file);
  return ExitCode::done;
}

ExitCode run_export(const TypedExport& typed) {
  if (!typed.site.empty()) return export_site(typed);
  for (const auto& [name, given] :
       {std::pair{"--url", !typed.url.empty()}, std::pair{"--with", !typed.with.empty()}})
    if (given) throw usage(std::string(name) + " goes with --site");
  if (!typed.sandbox.empty()) return export_sandbox(sandbox_output(typed));
  const std::string& name = lesson_of(typed);
  if (!typed.reader.empty()) {
    const ReaderOutput out = reader_output(typed);
    return export_reader(or_fail(load_lesson(name)), out);
  }
  const ExportOptions options = export_options(typed);
  ExportOutput out = export_output(typed);
  const LoadedLesson loaded = or_fail(load_lesson(name));
  // Told by `polhode verify` wherever that is run.
  if (fs::path(name) == loaded.path)
    std::replace(out.resume_all.begin(), out.resume_all.end(), name, fs::absolute(loaded.path).string());
  or_fail(check_type_of(loaded, or_fail(Fonts::open())));
  return options.what == What::transcript ? export_transcript(loaded, options, out)
                                          : export_pictures(loaded, options, out);
}

}  // namespace

ProgramCommand export_command() {
  const auto typed = std::make_shared<TypedExport>();
  return {
      "export",
      "Export a lesson's pages, equations and figures as PNG files, or its text",
      {{"LESSON", &typed->lessons, "id or file; with --site any number (default: all), with --sandbox none",
        " ", false, offer_lessons()},
       {"-o,--output", &typed->folder, "folder for the files; made if missing", "DIR", false,
        offer_folders()},
       {"--stage", &typed->stages, "only this stage; repeat for more (default: all)", "ID"},
       {"--count-chosen", &typed->count_chosen, "pages count those stages, not all of the lesson"},
       {"--what", &typed->what, "page, equation, figure or transcript (default: page)", "KIND", false,
        offer(export_words().what)},
       {"--profile", &typed->profile, "of pages: slides to project, or page to read (default: slides)",
        "KIND", false, offer(export_words().profile)},
       {"--each", &typed->each, "a picture of each stage, step, frame or page (slides: step, pages: page)",
        "KIND", false, offer(export_words().each)},
       {"--size", &typed->size, "pixels, to 16384 a side, pages from 320x240; or a name (1920x1080)", "WxH",
        false, offer(export_words().size)},
       {"--theme", &typed->theme, "paper or dark (default: paper); --reader and --site also both", "NAME",
        false, offer(export_words().theme)},
       {"--background", &typed->background,
        "studio (figures), paper, white, transparent, transparent-dark, #rrggbb", "NAME", false,
        offer(export_words().background)},
       {"--dpi", &typed->dpi, "dots per inch to note; sizes 12 pt equations (300; svg and pdf: 600)", "N"},
       {"--fps", &typed->fps, "frames per shown second of frames and films (default: 30)", "N|A/B"},
       {"--seconds", &typed->seconds, "shown seconds per stage of frames, per still of a film (default: 8)",
        "S"},
       {"--at", &typed->at, "t in s of stills (default: the scene's), of first frames (0)", "T"},
       {"--frames", &typed->frames, "frames A to B-1 of the whole selection, from 0 (default: all)", "A:B"},
       {"--quality", &typed->quality, "of figures: draft, normal or fine (default: the scene's)", "LEVEL",
        false, offer(export_words().quality)},
       {"--text-size", &typed->text_size, "of pages: 0.7 to 2 times the normal type (default: 1)", "X"},
       {"--png", &typed->png, "fast to pack, or small and slow (default: fast)", "KIND", false,
        offer(export_words().png)},
       {"--format", &typed->format, "of equations: png, or their outlines as svg or pdf (default: png)",
        "KIND", false, offer(export_words().format)},
       {"--film", &typed->film, "make a film (mp4, webm, gif, apng); without -o its frames are removed",
        "FILE", false, offer_files()},
       {"--deck", &typed->deck, "make slides (html, pdf, pptx); without -o their pictures are removed",
        "FILE", false, offer_files()},
       {"--reader", &typed->reader, "make a page of text to read (html), with figures and questions", "FILE",
        false, offer_files()},
       {"--site", &typed->site, "make a folder for the web: pages to read, and an index with a search", "DIR",
        false, offer_folders()},
       {"--url", &typed->url, "of --site: where the folder will lie, for sitemap and pictures of links",
        "ADDRESS"},
       {"--with", &typed->with, "of --site: slides (html, pdf, pptx) or film (mp4) too; repeat for more",
        "KIND", false, offer(export_words().with)},
       {"--live", &typed->live, "figures of --reader, --site, --deck play and turn in pages; after ./web"},
       {"--sandbox", &typed->sandbox, "make a page (html) to throw a body on, of no lesson; after ./web",
        "FILE", false, offer_files()},
       {"--sync", &typed->sync, "flush to disk at the end or after each frame (default: end)", "WHEN", false,
        offer(export_words().sync)},
       {"--context", &typed->context, "OpenGL from auto, osmesa or egl (default: auto)", "KIND", false,
        offer(export_words().context)},
       {"--shard", &typed->shard, "only every N-th picture, from the I-th, of 1 to N", "I/N|slurm", false,
        offer({"slurm"})},
       {"--jobs", &typed->jobs, "draw in N processes, the same in all shards (default: 1)", "N"},
       {"--skip-existing", &typed->skip_existing, "keep what is there and whole; goes on after a stop"}},
      "A slide has the text of one step in large type, its figure and plots, and what it goes on from at\n"
      "the foot. Pages to read have all steps of a stage, each beside its figure, on as few pages as hold\n"
      "them; with --each stage or step a page is of one step, and of those before as there is room for.\n"
      "An equation is cropped to its ink; frame by frame, one line of a stage turns into the next. As svg\n"
      "or pdf it has its type as curves, needs no fonts, and its words as title or alternative text.\n"
      "Frames of pages and figures go through the steps of a stage, the seconds shared evenly among them.\n"
      "A film has frames, or with --each stage or step pictures that stand --seconds each; ffmpeg makes it.\n"
      "A transcript is plain text with the formulas in words.\n"
      "A deck is one HTML file for any browser (? tells its keys), a PDF, or a PPTX for PowerPoint and\n"
      "LibreOffice, with the transcript as notes.\n"
      "A reader's page is one HTML file of text, formulas and figures, for any screen or screen reader;\n"
      "--stage, --theme and --quality of its figures, --live, --sync and --context are the options that go\n"
      "with it; by --theme both each figure is there twice, for light and for dark screens.\n"
      "With --live, as in a sandbox, a figure is a picture until it is pressed, and then computed in the\n"
      "page, without network; the program for it is in build/web or PROGRAM/../share/polhode/web.\n"
      "So is the figure of a slide in a deck for browsers. A site has the program once, and a sandbox.\n"
      "A site is a page of each lesson and index.html in the order of the course, without a server's help;\n"
      "addresses such as ID.html#stage and #stage/step.2 stay. A lesson that has not changed is not drawn\n"
      "again. --theme, --quality, --sync and --context go with it as with a reader's page.\n"
      "Names of sizes: 16:9 1920x1080, 4k 3840x2160, 4:3 1440x1080, a4 3508x2480 at 300 dpi, for print.\n"
      "Files: NN-STAGE.png, or with -EQUATION, -stepK, -frameF or -pageP behind STAGE, and LESSON.txt;\n"
      "NN is the stage's place in the lesson. Each appears whole or not at all; manifest.json comes last.\n"
      "The bytes depend on lesson and options alone. A folder with an export of other options or another\n"
      "lesson text is refused. Processes with the same command but each its --shard, on any machines that\n"
      "share the folder, make one export; slurm reads I and N from the variables of a job array.",
      [typed](const CommandWords& words) {
        typed->words = words;
        return run_export(*typed);
      }};
}

}  // namespace polhode
