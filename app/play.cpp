// SPDX-License-Identifier: MIT
// polhode play: a lesson in a window.
#include "app/answer_log.h"
#include "app/commands.h"
#include "app/companion/bookmark.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "app/or_fail.h"
#include "app/state_file.h"
#include "app/window/window.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace polhode {

namespace fs = std::filesystem;

namespace {

struct Options {
  std::string lesson = "euler-equations", stage;
  bool watch = false;
};

std::shared_ptr<const LoadedLesson> load(const std::string& name) {
  auto loaded = std::make_shared<const LoadedLesson>(load_lesson(name));
  const Fonts fonts = or_fail(Fonts::open());
  check_type_of(*loaded, fonts);
  check_pages_of(*loaded, fonts);
  return loaded;
}

/// Where, with what answers and how a student left off; written when something of it changes. What cannot be
/// kept does not stop a lesson: it is said once.
class Memory {
 public:
  Memory(Companion& companion, std::string& news) : folder_(state_folder()) {
    if (!folder_) {
      news = "Neither XDG_STATE_HOME nor HOME is set: place and answers are not kept.";
      return;
    }
    const std::string& id = companion.lesson().id;
    const auto note = [&](const std::string& warning) {
      if (!warning.empty()) news += (news.empty() ? "" : "\n") + warning;
    };
    try {
      const PreferencesReading preferences = read_preferences(*folder_);
      note(preferences.warning);
      companion.preferences = preferences.preferences;
      AnswerLogReading answers = read_answer_log(answer_log_path(*folder_, id));
      note(answers.warning);
      companion.set_answers(std::move(answers.log));
      const BookmarkReading bookmark = read_bookmark(*folder_, id);
      note(bookmark.warning);
      restore(companion, bookmark.bookmark);
    } catch (const CommandError& error) {
      note(std::string(error.what()) + ": place and answers are not kept");
      folder_.reset();  // what cannot be read is not written over
    }
    preferences_ = companion.preferences;
    answers_ = companion.answers();
    bookmark_ = bookmark_of(companion);
  }

  /// What is to be told; empty: nothing.
  std::string keep(const Companion& companion) {
    if (!folder_) return {};
    try {
      if (const Bookmark now = bookmark_of(companion); now != bookmark_)
        write_bookmark(*folder_, companion.lesson().id, bookmark_ = now);
      if (companion.answers() != answers_) keep_answers(companion);
      if (companion.preferences != preferences_)
        write_preferences(*folder_, preferences_ = companion.preferences);
      return {};
    } catch (const CommandError& error) {
      folder_.reset();
      return std::string(error.what()) + ": place and answers are not kept";
    }
  }

 private:
  /// Into what is there by now: another window, or `polhode answer`, may have been at it.
  void keep_answers(const Companion& companion) {
    change_answer_log(answer_log_path(*folder_, companion.lesson().id), [&](AnswerLog& log) {
      for (const auto& [name, record] : answers_)
        if (!companion.answers().contains(name)) log.erase(name);
      for (const auto& [name, record] : companion.answers()) {
        const auto before = answers_.find(name);
        merge_record(log[name], before == answers_.end() ? AnswerRecord() : before->second, record);
      }
    });
    answers_ = companion.answers();
  }

  std::optional<fs::path> folder_;
  Bookmark bookmark_;
  AnswerLog answers_;
  Preferences preferences_;
};

/// Looks at the file's time, and reads it when that has changed.
class LessonWatch {
 public:
  explicit LessonWatch(const LoadedLesson& loaded)
      : path_(loaded.path), sha256_(loaded.sha256), written_(time()) {}

  void look(Companion& companion, std::string& errors) {
    const auto now = time();
    if (now == written_) return;
    written_ = now;
    try {
      auto loaded = load(path_.string());
      errors.clear();
      if (loaded->sha256 == sha256_) return;
      sha256_ = loaded->sha256;
      companion.replace_lesson(std::move(loaded));
    } catch (const CommandError& error) {
      errors = error.what();
    }
  }

 private:
  /// An editor may be replacing it just now: the least time then.
  fs::file_time_type time() const {
    std::error_code error;
    const auto written = fs::last_write_time(path_, error);
    return error ? fs::file_time_type::min() : written;
  }

  fs::path path_;
  std::string sha256_;
  fs::file_time_type written_;
};

ExitCode play(const Options& options) {
  const auto loaded = load(options.lesson);
  if (!options.stage.empty()) stage_of(loaded->lesson, options.stage);  // before a window opens
  Companion companion(loaded, until_interrupted());
  WindowOptions window;
  Memory memory(companion, window.news);
  if (!window.news.empty()) say("polhode: {}\n", window.news);
  if (!options.stage.empty()) {
    const Stage& stage = stage_of(loaded->lesson, options.stage);
    companion.go_to({static_cast<std::size_t>(&stage - loaded->lesson.stages.data()), 0});
  }
  window.keep = [&](const Companion& now) { return memory.keep(now); };
  LessonWatch watch(*loaded);
  if (options.watch)
    window.look_for_changes = [&](Companion& now, std::string& errors) { watch.look(now, errors); };
  return run_window(companion, window);
}

}  // namespace

void add_play(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("play", "Walk through a lesson in a window");
  auto options = std::make_shared<Options>();
  command->add_option("LESSON", options->lesson, "Lesson file or id")->capture_default_str();
  command->add_option("--stage", options->stage, "Begin at this stage, wherever you were");
  command->add_flag("--watch", options->watch,
                    "For authors: read the lesson again whenever its file changes");
  command->footer(
      "Left and Right, or Page Up and Page Down as remote clickers send them, go through the steps,\n"
      "Up and Down through the stages; press ? in the window for all its keys. Place, answers and\n"
      "preferences are kept in $XDG_STATE_HOME/polhode, or ~/.local/state/polhode. Without a display, see:\n"
      "polhode export --help");
  command->callback([options, &action] { action = [options] { return play(*options); }; });
}

}  // namespace polhode
