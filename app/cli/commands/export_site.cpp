// SPDX-License-Identifier: MIT
#include "app/cli/commands/export_site.h"

#include "app/cli/commands/live_parts.h"
#include "app/cli/lesson_lookup.h"
#include "app/cli/message.h"
#include "app/cli/or_fail.h"
#include "app/cli/progress.h"
#include "app/export/picture_export.h"
#include "app/export/picture_metadata.h"
#include "app/publish/site/lesson_site.h"
#include "app/publish/site/site_record.h"
#include "base/files/file_bytes.h"
#include "base/sha256.h"
#include "base/words/edition_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace polhode {

namespace fs = std::filesystem;

namespace {

/// Those that are named, or all there are; in the order of the course.
std::vector<LoadedLesson> lessons_of(const TypedExport& typed) {
  std::vector<std::string> names = typed.lessons;
  if (names.empty())
    for (const FoundLesson& found : lessons_and_translations_in(lesson_folders()))
      names.push_back(found.path.string());
  if (names.empty()) throw usage("there are no lessons to make a site of; see: polhode list");
  std::vector<LoadedLesson> loaded;
  std::set<std::string> ids;
  for (const std::string& name : names) {
    LoadedLesson one = or_fail(load_lesson(name));
    if (!ids.insert(page_name(one.lesson.id, one.lesson.about.language)).second)
      throw usage(
          fmt::format("two lessons have the id \"{}\": their pages would have one name", one.lesson.id));
    if (one.lesson.id == "index")
      throw usage("a lesson with the id \"index\" cannot be in a site: that is the name of its first page");
    if (typed.live && one.lesson.id + ".html" == kSiteSandbox)
      throw usage(fmt::format(
          "a lesson with the id \"{}\" cannot be in a site with --live: one of its pages has this name",
          one.lesson.id));
    loaded.push_back(std::move(one));
  }
  // The first of each id is in the course, and behind it the same lesson in other languages.
  std::vector<const Lesson*> lessons;
  for (std::size_t i = 0; i < loaded.size(); ++i) {
    const auto is_same = [&](const Lesson* one) { return one->id == loaded[i].lesson.id; };
    if (std::any_of(lessons.begin(), lessons.end(), is_same)) continue;
    lessons.push_back(&loaded[i].lesson);
  }
  std::vector<std::size_t> order;
  for (const std::size_t first : course_order(lessons))
    for (std::size_t i = 0; i < loaded.size(); ++i)
      if (loaded[i].lesson.id == lessons[first]->id) order.push_back(i);
  std::vector<LoadedLesson> ordered;
  for (const std::size_t i : order) ordered.push_back(std::move(loaded[i]));
  return ordered;
}

struct CopyKind {
  const char* ending;  ///< behind the lesson's id
  Phrase words;
};
const CopyKind& kind_of(SiteCopy copy) {
  static constexpr CopyKind kKinds[] = {{"-slides.html", words::kSlidesForBrowsers},
                                        {".pdf", words::kSlidesAsPdf},
                                        {".pptx", words::kSlidesForPrograms},
                                        {".mp4", words::kAFilm}};
  return kKinds[static_cast<std::size_t>(copy)];
}

/// As `polhode export LESSON --deck FILE`, or --film, makes it.
ExportOptions options_of(SiteCopy copy, const SiteOutput& out) {
  ExportOptions options;
  options.each = copy == SiteCopy::film ? Each::frame : Each::step;
  options.theme = out.theme;
  options.quality = out.quality;
  return options;
}

/// Makes what is not there yet. @return how it ended; the record is told of each file
/// @param live_file name of the program beside the pages; empty: nothing moves
ExitCode make_copies(const LoadedLesson& loaded, const SiteOutput& out, const std::string& live_file,
                     std::vector<SiteDownload>& made) {
  const fs::path folder = out.folder;
  for (const SiteCopy copy : out.with) {
    const ExportOptions options = options_of(copy, out);
    const std::string name = page_name(loaded.lesson.id, loaded.lesson.about.language) + kind_of(copy).ending;
    const ExportIdentity identity = identity_of(loaded, options);
    const bool live = !live_file.empty() && copy == SiteCopy::html_slides;
    const std::string made_of =
        sha256_hex(program_name_and_version() + ' ' + name + ' ' + identity.lesson_sha256 + ' ' +
                   identity.options + (live ? ' ' + live_file : ""));
    SiteRecord record = or_fail(read_site_record(folder)).value_or(SiteRecord());
    if (!is_there(folder, record, name, made_of)) {
      ExportOutput to;
      (copy == SiteCopy::film ? to.film : to.deck) = (folder / name).string();
      to.folder = folder / (name + ".parts");
      to.keep_folder = false;
      to.live = live;
      to.live_file = live_file;
      to.durability = out.durability;
      to.context = out.context;
      if (const ExitCode end = export_pictures(loaded, options, to); end != ExitCode::done) return end;
      record[name] = {made_of, sha256_hex(or_fail(read_file_bytes(folder / name)))};
      or_fail(write_site_record(folder, record, out.durability));
    }
    made.push_back({name, std::string(kind_of(copy).words.in(loaded.lesson.about.language))});
  }
  return ExitCode::done;
}

}  // namespace

ExitCode export_site(const TypedExport& typed) {
  const SiteOutput out = site_output(typed);
  or_fail(check_site_folder(out.folder));
  const std::vector<LoadedLesson> lessons = lessons_of(typed);
  const Fonts fonts = or_fail(Fonts::open());
  for (const LoadedLesson& loaded : lessons) or_fail(check_type_of(loaded, fonts));
  or_fail(make_folder(out.folder));
  // From now on the folder is known as ours, whatever stops us.
  if (!or_fail(read_site_record(out.folder))) or_fail(write_site_record(out.folder, {}, out.durability));
  Site site{.lessons = {}, .look = {out.theme, out.quality, out.in_both_themes}, .url = out.url};
  if (out.live) site.live = live_program();
  const std::string live_name = site.live ? live_file(*site.live).name : "";
  for (const LoadedLesson& loaded : lessons) {
    SiteLesson one{loaded};
    if (out.live) one.text = text_again(loaded);
    if (const ExitCode end = make_copies(loaded, out, live_name, one.downloads); end != ExitCode::done)
      return end;
    site.lessons.push_back(std::move(one));
  }
  const InterruptWatch watch;
  const auto context = or_fail(open_context(out.context));
  const auto renderer = or_fail(Renderer::create(*context, fonts));
  std::optional<ProgressBar> progress;
  const auto go_on = [&](std::size_t step, std::size_t steps, const std::string& lesson) {
    if (!progress) progress.emplace(static_cast<std::int64_t>(steps));
    progress->show(static_cast<std::int64_t>(step), lesson);
    return !watch.interrupted();
  };
  const SiteMade made =
      or_fail(write_site(out.folder, site, *renderer, out.durability, go_on, until_interrupted()));
  progress.reset();
  if (made.stopped) {
    say("polhode: interrupted; the same command goes on\n");
    return ExitCode::interrupted;
  }
  const std::size_t count = made.drawn + made.kept;
  say("{} lesson{} in {}{}\n", count, count == 1 ? "" : "s", (fs::path(out.folder) / kSiteIndex).string(),
      made.kept > 0 ? fmt::format(" ({} of them kept)", made.kept) : "");
  return ExitCode::done;
}

}  // namespace polhode
