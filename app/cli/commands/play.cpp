// SPDX-License-Identifier: MIT
// polhode play: a lesson in a window.
#include "app/cli/commands/commands.h"
#include "app/cli/lesson_lookup.h"
#include "app/cli/message.h"
#include "app/cli/or_fail.h"
#include "app/export/background_program.h"
#include "app/publish/site/site_index.h"
#include "app/session/answers/progress.h"
#include "app/session/edited_step.h"
#include "app/session/saved/answer_file.h"
#include "app/session/saved/saved_progress.h"
#include "app/session/saved/state_file.h"
#include "app/session/saved/window_place.h"
#include "app/window/window.h"
#include "base/interrupt.h"
#include "base/printable.h"
#include "lessons/reader/checks/claim_check.h"
#include "lessons/reader/checks/lint_budget.h"
#include "lessons/reader/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace polhode {

namespace fs = std::filesystem;

namespace {

constexpr const char* kFirstLesson = "euler-equations";

struct Options {
  std::string lesson{}, stage{};  ///< no lesson: the one where one was last, below the list of all of them
  bool watch = false, speaker = false;
  bool lists_lessons = false;  ///< at first
};

Outcome<std::shared_ptr<const LoadedLesson>> load(const std::string& name, const Fonts& fonts) {
  auto loaded = load_lesson(name);
  if (!loaded) return passed_on(loaded);
  if (const Done can = check_type_of(*loaded, fonts); !can) return passed_on(can);
  if (const Done can = check_scenes_of(*loaded); !can) return passed_on(can);
  return std::make_shared<const LoadedLesson>(std::move(*loaded));
}

/// Looks at the file's time, and reads it when that has changed.
class LessonWatch {
 public:
  LessonWatch(const LoadedLesson& loaded, const Fonts& fonts)
      : fonts_(fonts), path_(loaded.path), sha256_(loaded.sha256), written_(time()) {}

  void look(LessonSession& session, std::string& errors) {
    const auto now = time();
    if (now == written_) return;
    written_ = now;
    // A pipe may have nobody who writes: it would be waited for.
    std::error_code error;
    if (const auto status = fs::status(path_, error); fs::exists(status) && !fs::is_regular_file(status)) {
      errors = printable(fmt::format("cannot read lesson {}: it is not a file", path_.string()));
      return;
    }
    const auto loaded = load(path_.string(), fonts_);
    errors = loaded ? "" : printable(loaded.error().text);
    if (!loaded || (*loaded)->sha256 == sha256_) return;
    sha256_ = (*loaded)->sha256;
    const auto edited = edited_step(session.lesson(), (*loaded)->lesson);
    session.replace_lesson(*loaded);
    if (edited) session.go_to(*edited);
    errors = false_claims((*loaded)->lesson);
  }

 private:
  /// What the lesson claims and is not so, on whatever page that stands.
  std::string false_claims(const Lesson& lesson) const {
    Budget budget(kLintBudget);
    std::string all;
    for (const Diagnostic& diagnostic : check_claims(lesson, path_.string(), budget.effort()))
      if (diagnostic.severity == Severity::error) all += (all.empty() ? "" : "\n") + to_string(diagnostic);
    return printable(all);
  }

  /// An editor may be replacing it just now: the least time then.
  fs::file_time_type time() const {
    std::error_code error;
    const auto written = fs::last_write_time(path_, error);
    return error ? fs::file_time_type::min() : written;
  }

  const Fonts& fonts_;
  fs::path path_;
  std::string sha256_;
  fs::file_time_type written_;
};

/// From 1; 0: there is no such stage.
std::size_t stage_number(const Lesson& lesson, const std::string& id) {
  const Stage* stage = lesson.find_stage(id);
  return stage ? static_cast<std::size_t>(stage - lesson.stages.data()) + 1 : 0;
}

/// How far one is in each of the lessons, in the order of the course; of those that cannot be read nothing is
/// said.
std::vector<LessonProgress> lessons_with_progress(const LessonSession& session) {
  std::vector<LessonProgress> all;
  std::vector<Lesson> lessons;
  const auto folder = state_folder();
  for (const FoundLesson& found : lessons_in(lesson_folders())) {
    const auto text = read_lesson_text(found.path);
    LessonReading reading = text ? read_lesson(*text, found.path.string()) : LessonReading{};
    if (!reading.lesson) continue;
    const Lesson& lesson = *reading.lesson;
    const bool here = lesson.id == session.lesson().id;
    const auto place =
        folder ? read_bookmark(*folder, lesson.id) : StateFileResult<BookmarkReading>(BookmarkReading{});
    const auto log = folder ? read_answer_log(answer_log_path(*folder, lesson.id))
                            : StateFileResult<AnswerLogReading>(AnswerLogReading{});
    all.push_back({.id = found.id,
                   .title = lesson.title,
                   .stages = lesson.stages.size(),
                   .seen = here    ? session.visited().size()
                           : place ? place->bookmark.visited.size()
                                   : 0,
                   .questions = progress_of(lesson, here  ? session.answers()
                                                    : log ? log->log
                                                          : AnswerLog{})
                                    .all,
                   .outcomes = lesson.about.outcomes,
                   .next = lesson.about.next,
                   .at = place ? stage_number(lesson, place->bookmark.stage) : 0});
    lessons.push_back(std::move(*reading.lesson));
  }
  std::vector<const Lesson*> pointers;
  for (const Lesson& lesson : lessons) pointers.push_back(&lesson);
  std::vector<LessonProgress> ordered;
  for (const std::size_t i : course_order(pointers)) ordered.push_back(std::move(all[i]));
  return ordered;
}

/// The lesson in which somebody was last: who has been nowhere begins with the first.
std::string last_lesson() {
  std::string last = kFirstLesson;
  fs::file_time_type latest = fs::file_time_type::min();
  const auto folder = state_folder();
  for (const FoundLesson& found : lessons_in(lesson_folders())) {
    std::error_code unknown;
    const auto kept = folder ? fs::last_write_time(*folder / (found.id + ".place.json"), unknown)
                             : fs::file_time_type::min();
    if (!folder || unknown || kept <= latest) continue;
    latest = kept;
    last = found.id;
  }
  return last;
}

/// Slides of a lesson, made by this program beside the window. They are made to the end when it is closed.
class SlidesJob {
 public:
  /// Of the stages that are chosen. @returns what is to be told
  std::string begin(const LessonSession& session, const fs::path& file) {
    if (is_running()) return fmt::format("{} is still being made.", file_.string());
    std::error_code unknown;
    const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
    if (unknown) return "not saved: this program does not find itself";
    std::vector<std::string> words = {program.string(),
                                      "export",
                                      session.loaded().path.string(),
                                      "--deck",
                                      file.string(),
                                      "--theme",
                                      session.preferences.theme == Theme::dark ? "dark" : "paper"};
    const std::vector<std::size_t> chosen = session.chosen_stages();
    for (const std::size_t stage : chosen) {
      if (chosen.size() == session.lesson().stages.size()) break;
      words.insert(words.end(), {"--stage", session.lesson().stages[stage].id});
    }
    if (chosen.size() < session.lesson().stages.size()) words.emplace_back("--count-chosen");
    auto begun = BackgroundProgram::start(std::move(words));
    if (!begun) return "not saved: " + begun.error();
    program_ = std::move(begun).value();
    file_ = fs::absolute(file, unknown);
    return fmt::format("Slides of {} stage{} are being made; you can go on.", chosen.size(),
                       chosen.size() == 1 ? "" : "s");
  }
  bool is_running() { return program_ && !program_->code(); }
  const fs::path& file() const { return file_; }
  /// What has become of it, once.
  std::string news() {
    const auto code = program_ ? program_->code() : std::nullopt;
    if (!code) return {};
    const std::string words = program_->last_words();
    program_.reset();
    return *code == 0 ? "saved: " + file_.string() : "not saved: " + printable(words);
  }

 private:
  std::optional<BackgroundProgram> program_;
  fs::path file_;
};

void keep_place(const WindowPlace& place) {
  const auto folder = state_folder();
  if (folder && place.size.width > 0) static_cast<void>(write_window_place(*folder, place));
}

WindowPlace kept_place() {
  const auto folder = state_folder();
  const auto place = folder ? read_window_place(*folder) : StateFileResult<WindowPlace>(WindowPlace{});
  return place ? *place : WindowPlace{};
}

/// Answers are a lesson's by its id: who has copied one to change it is told. A translation is the same
/// lesson.
std::string shared_with(const LoadedLesson& loaded) {
  std::error_code unknown;
  const auto is_loaded = [&](const fs::path& path) {
    return fs::equivalent(path, loaded.path, unknown) || unknown;
  };
  for (const FoundLesson& found : lessons_in(lesson_folders()))
    if (found.id == loaded.lesson.id && !is_loaded(found.path) &&
        std::ranges::none_of(translations_of(found.path), is_loaded))
      return printable(
          fmt::format("This file has the id of {}: place and answers are shared with it. Another "
                      "id in its front matter makes it a lesson of its own.",
                      found.path.string()));
  return {};
}

WindowEnd play_one(const Options& options, const Fonts& fonts, SlidesJob& slides) {
  const auto loaded = or_fail(load(options.lesson, fonts));
  if (!options.stage.empty()) stage_of(loaded->lesson, options.stage);  // before a window opens
  LessonSession session(loaded, until_interrupted());
  WindowOptions window;
  SavedProgress progress(session, state_folder());
  window.notice = progress.notice();
  if (!window.notice.empty()) say("polhode: {}\n", window.notice);
  if (const std::string shared = shared_with(*loaded); !shared.empty())
    window.notice += (window.notice.empty() ? "" : "\n") + shared;
  if (!options.stage.empty()) {
    const Stage& stage = stage_of(loaded->lesson, options.stage);
    session.begin_at({static_cast<std::size_t>(&stage - loaded->lesson.stages.data()), 0});
  }
  session.set_speaker(options.speaker);
  window.keep = [&](const LessonSession& now) { return progress.keep(now); };
  window.lessons = [&] { return lessons_with_progress(session); };
  window.begins_with_lessons = options.lists_lessons;
  window.follows_desktop = true;
  window.place = kept_place();
  window.make_slides = [&](const LessonSession& now, const fs::path& file) {
    return slides.begin(now, file);
  };
  window.news = [&] { return slides.news(); };
  LessonWatch watch(*loaded, fonts);
  if (options.watch)
    window.look_for_changes = [&](LessonSession& now, std::string& errors) { watch.look(now, errors); };
  WindowEnd end = or_fail(run_window(session, fonts, window));
  if (const std::string notice = progress.keep_at_last(session); !notice.empty())
    say("polhode: {}\n", notice);
  keep_place(end.place);
  return end;
}

ExitCode play(Options options) {
  const Fonts fonts = or_fail(Fonts::open());
  SlidesJob slides;
  options.lists_lessons = options.lesson.empty() && options.stage.empty() && !options.speaker;
  if (options.lesson.empty()) options.lesson = options.lists_lessons ? last_lesson() : kFirstLesson;
  while (true) {
    const WindowEnd end = play_one(options, fonts, slides);
    if (end.kind == WindowEnd::Kind::interrupted) return ExitCode::interrupted;
    if (end.kind == WindowEnd::Kind::closed) {
      if (slides.is_running()) say("polhode: {} is still being made\n", slides.file().string());
      return ExitCode::done;
    }
    options.lesson = end.lesson;
    options.stage.clear();
    options.lists_lessons = false;
  }
}

}  // namespace

ProgramCommand play_command() {
  const auto options = std::make_shared<Options>();
  return {
      "play",
      "Walk through a lesson in a window",
      {{"LESSON", &options->lesson, "Lesson file or id; without it all lessons are listed", "", false,
        offer_lessons()},
       {"--stage", &options->stage, "Begin at this stage, wherever you were", "ID"},
       {"--speaker", &options->speaker, "Present, with a window of your own: next step, notes, time"},
       {"--watch", &options->watch, "For authors: read the lesson again whenever its file changes"}},
      "Left and Right, or Page Up and Page Down as remote clickers send them, go through the steps,\n"
      "Up and Down through the stages; press ? in the window for all its keys. Place, answers and\n"
      "preferences are kept in $XDG_STATE_HOME/polhode, or ~/.local/state/polhode. Without a display, see:\n"
      "polhode export --help",
      [options](const CommandWords&) { return play(*options); }};
}

}  // namespace polhode
