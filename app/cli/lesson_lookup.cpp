// SPDX-License-Identifier: MIT
#include "app/cli/lesson_lookup.h"

#include "app/cli/numbers.h"
#include "app/cli/or_fail.h"
#include "app/page/page_lint.h"
#include "base/interrupt.h"
#include "base/sha256.h"
#include "base/spelling.h"
#include "base/words/language.h"
#include "lessons/reader/checks/lesson_check.h"
#include "lessons/reader/checks/lint_budget.h"
#include "lessons/reader/checks/type_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace polhode {

namespace fs = std::filesystem;

namespace {

/// Ids name files in our folders and nothing else: no slash, no dot.
bool is_plain_name(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
}

/// An id, or that of a translation with its language: "euler-equations.de".
bool is_name_of_lesson(std::string_view name) {
  const std::size_t dot = std::min(name.rfind('.'), name.size());
  return is_plain_name(name.substr(0, dot)) && (dot == name.size() || language_from(name.substr(dot + 1)));
}

bool names_file(std::string_view name) { return name.find('/') != name.npos || name.ends_with(".md"); }

/// False for a pipe of a lesson's name, which nobody may write to.
bool is_regular(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool opens_with_front_matter(const fs::path& path) {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  char start[3] = {};
  return file && std::fread(start, 1, sizeof start, file.get()) == sizeof start &&
         std::memcmp(start, "+++", 3) == 0;
}

std::string all_lines(const std::vector<Diagnostic>& diagnostics) {
  std::string lines;
  for (const Diagnostic& diagnostic : diagnostics) lines += to_string(diagnostic) + '\n';
  return lines;
}

Failure<Error> has_errors(const fs::path& path, const std::vector<Diagnostic>& diagnostics) {
  return failure_of(Fault::invalid,
                    fmt::format("lesson {} has errors:\n{}", path.string(), all_lines(diagnostics)));
}

Failure<Error> unknown_lesson(std::string_view name, const std::vector<fs::path>& folders) {
  std::vector<std::string> known, places;
  for (const FoundLesson& lesson : lessons_in(folders)) known.push_back(lesson.id);
  for (const fs::path& folder : folders) places.push_back(folder.string());
  return failure_of(Fault::usage, fmt::format("unknown lesson \"{}\"{} (looked for {}.md in {})", name,
                                              did_you_mean(name, known), name, fmt::join(places, ", ")));
}

/// Ends by the budget, and by an interruption while somebody watches for one.
Effort limited_by(Budget& budget) {
  return [&budget, stop = until_interrupted()](std::int64_t evaluations) {
    stop(evaluations);
    budget.spend(evaluations);
  };
}

}  // namespace

std::vector<fs::path> lesson_folders() {
  std::vector<fs::path> folders;
  if (const char* chosen = std::getenv("POLHODE_LESSONS"); chosen && *chosen) folders.emplace_back(chosen);
  folders.emplace_back("lessons");
  std::error_code error;
  if (const fs::path program = fs::read_symlink("/proc/self/exe", error); !error)
    folders.push_back(program.parent_path().parent_path() / "share" / "polhode" / "lessons");
  return folders;
}

std::vector<FoundLesson> lessons_in(const std::vector<fs::path>& folders) {
  std::vector<FoundLesson> found;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
      FoundLesson lesson{entry->path().stem().string(), entry->path()};
      const bool known =
          std::any_of(found.begin(), found.end(), [&](const auto& f) { return f.id == lesson.id; });
      if (lesson.path.extension() == ".md" && is_plain_name(lesson.id) && !known && is_regular(lesson.path) &&
          opens_with_front_matter(lesson.path))
        found.push_back(std::move(lesson));
    }
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return found;
}

std::vector<fs::path> translations_of(const fs::path& lesson) {
  std::vector<fs::path> found;
  for (const Language language : kLanguages) {
    fs::path path = lesson;
    path.replace_extension(std::string(tag_of(language)) + ".md");
    if (is_regular(path)) found.push_back(std::move(path));
  }
  return found;
}

std::vector<FoundLesson> lessons_and_translations_in(const std::vector<fs::path>& folders) {
  std::vector<FoundLesson> all;
  for (FoundLesson& lesson : lessons_in(folders)) {
    std::vector<fs::path> translations = translations_of(lesson.path);
    all.push_back(std::move(lesson));
    for (fs::path& path : translations) {
      std::string id = path.stem().string();
      all.push_back({std::move(id), std::move(path)});
    }
  }
  return all;
}

Outcome<fs::path> find_lesson(std::string_view name, const std::vector<fs::path>& folders) {
  if (names_file(name)) return fs::path(name);
  if (is_name_of_lesson(name)) {
    for (const fs::path& folder : folders) {
      fs::path path = folder / (std::string(name) + ".md");
      if (is_regular(path)) return path;
    }
  }
  return unknown_lesson(name, folders);
}

Outcome<std::string> read_lesson_text(const fs::path& path) {
  const auto failed = [&](int error) {
    return failure_of(Fault::failed,
                      fmt::format("cannot read lesson {}: {}", path.string(), std::strerror(error)));
  };
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return failed(errno);
  std::string text(kMaxLessonBytes + 1, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  if (std::ferror(file.get())) return failed(errno);
  return text;
}

Outcome<LoadedLesson> load_lesson(std::string_view name) {
  const auto path = find_lesson(name, lesson_folders());
  if (!path) return passed_on(path);
  const auto text = read_lesson_text(*path);
  if (!text) return passed_on(text);
  Budget budget(kLintBudget);
  LessonReading reading = check_lesson(*text, path->string(), limited_by(budget));
  if (!reading.lesson) return has_errors(*path, reading.diagnostics);
  return LoadedLesson{std::move(*reading.lesson), *path, sha256_hex(*text)};
}

Done check_type_of(const LoadedLesson& loaded, const Fonts& fonts) {
  const std::vector<Diagnostic> found = check_type(loaded.lesson, fonts, loaded.path.string());
  if (!found.empty()) return has_errors(loaded.path, found);
  return done();
}

Done check_scenes_of(const LoadedLesson& loaded) {
  Budget budget(kLintBudget);
  const std::vector<Diagnostic> found = scene_errors(loaded.lesson, loaded.path.string(), limited_by(budget));
  if (!found.empty()) return has_errors(loaded.path, found);
  return done();
}

const Stage& stage_of(const Lesson& lesson, std::string_view id) { return *or_usage(lesson.stage_named(id)); }

const Scene& scene_of(const Lesson& lesson, std::string_view stage_and_step) {
  const std::size_t colon = stage_and_step.find(':');
  const Stage& stage = stage_of(lesson, stage_and_step.substr(0, colon));
  if (colon != stage_and_step.npos) {
    const auto step =
        whole_number(fmt::format("the step of \"{}\"", stage.id), stage_and_step.substr(colon + 1), 1,
                     static_cast<long long>(stage.steps.size()));
    const auto& scene = stage.steps[static_cast<std::size_t>(step - 1)].scene;
    if (!scene) throw usage(fmt::format("step {} of stage \"{}\" has no scene", step, stage.id));
    return *scene;
  }
  const auto drawn = std::find_if(stage.steps.rbegin(), stage.steps.rend(),
                                  [](const Step& step) { return step.scene != nullptr; });
  if (drawn == stage.steps.rend()) throw usage(fmt::format("stage \"{}\" has no scene", stage.id));
  return *drawn->scene;
}

}  // namespace polhode
