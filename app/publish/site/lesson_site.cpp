// SPDX-License-Identifier: MIT
#include "app/publish/site/lesson_site.h"

#include "app/export/picture_maker.h"
#include "app/export/picture_metadata.h"
#include "app/publish/html_frame.h"
#include "app/publish/html_text.h"
#include "app/publish/live/live_assets.h"
#include "app/publish/live/sandbox_page.h"
#include "app/publish/site/site_assets.h"
#include "app/publish/site/site_record.h"
#include "app/publish/text_edition/reader_assets.h"
#include "base/files/file_bytes.h"
#include "base/files/left_behind.h"
#include "base/interrupt.h"
#include "base/sha256.h"
#include "render/image/webp.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace polhode {

namespace fs = std::filesystem;

namespace {

/// Of texts one after the other, each with its length before it: no two lists of texts are alike.
std::string digest_of(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += fmt::format("{} ", text.size()) + text;
  return sha256_hex(all);
}

ReaderTitle title_of(const Lesson& lesson) { return {lesson.title, lesson.about.language}; }
std::string page_of(const Lesson& lesson) { return page_name(lesson.id, lesson.about.language) + ".html"; }
std::string preview_name(const Lesson& lesson) {
  return page_name(lesson.id, lesson.about.language) + ".png";
}

/// The first figure of a lesson, and the step it is of. Nothing where there is none.
std::optional<PlannedPicture> first_figure(const Lesson& lesson, const ExportOptions& options) {
  const Result<ExportPlan> plan = plan_export(lesson, options);
  return plan && !plan->pictures.empty() ? std::optional(plan->pictures.front()) : std::nullopt;
}

ExportOptions preview_options(const ReaderFigures::Look& look) {
  ExportOptions options;
  options.what = What::figure;
  options.each = Each::step;
  options.size = {kPreviewWidth, kPreviewHeight};
  options.background = "studio";
  options.quality = look.quality;
  return options;
}

class SiteWriter {
 public:
  SiteWriter(const fs::path& folder, const Site& site, Renderer& renderer, Durability durability,
             const SiteProgress& go_on, const Effort& effort)
      : folder_(folder),
        site_(site),
        renderer_(renderer),
        durability_(durability),
        go_on_(go_on),
        effort_(effort) {
    if (site.live) program_ = live_file(*site.live);
  }

  Outcome<SiteMade> write() {
    Result<std::optional<SiteRecord>> before = read_site_record(folder_);
    if (!before) return failed(before);
    record_ = before->value_or(SiteRecord());
    remove_left_behind_in(folder_);
    const std::vector<std::size_t> wanted = lessons_to_draw();
    made_.kept = site_.lessons.size() - wanted.size();
    if (const Done live = write_live(); !live) return passed_on(live);
    for (const std::size_t i : wanted) {
      const Done drawn = draw(i);
      if (!drawn) return passed_on(drawn);
      if (made_.stopped) return made_;
      ++made_.drawn;
    }
    if (const Done index = write_index(); !index) return passed_on(index);
    if (const Done rest = write_sitemap(); !rest) return passed_on(rest);
    remove_others();
    if (const Status written = write_site_record(folder_, record_, durability_); !written)
      return failed(written);
    return made_;
  }

 private:
  const Lesson& lesson(std::size_t i) const { return site_.lessons[i].loaded.lesson; }

  ReaderEdition edition(std::size_t i) const {
    ReaderPlace place;
    for (const SiteLesson& one : site_.lessons) place.lessons.insert(one.loaded.lesson.id);
    place.lessons.erase(lesson(i).id);
    const auto next = std::find_if(site_.lessons.begin(), site_.lessons.end(), [&](const SiteLesson& one) {
      return one.loaded.lesson.id == lesson(i).about.next;
    });
    if (next != site_.lessons.end()) {
      place.next = next->loaded.lesson.id;
      place.next_title = title_of(next->loaded.lesson);
    }
    for (const SiteLesson& one : site_.lessons)
      if (const Lesson& other = one.loaded.lesson; other.id == lesson(i).id && &other != &lesson(i))
        place.languages.push_back(other.about.language);
    place.url = site_.url;
    if (first_figure(lesson(i), options_)) place.preview = preview_name(lesson(i));
    ReaderEdition of{.lesson = lesson(i), .look = site_.look, .place = std::move(place)};
    // The first of an id is that which links lead to.
    const std::vector<std::string>& lines = lesson(i).about.prerequisites;
    for (const SiteLesson& one : site_.lessons)
      if (const Lesson& other = one.loaded.lesson;
          other.id != lesson(i).id && std::find(lines.begin(), lines.end(), other.id) != lines.end())
        of.titles.emplace(other.id, title_of(other));
    if (program_) of.live = LiveParts{*site_.live, site_.lessons[i].text, program_->name};
    return of;
  }

  /// All that decides the bytes of a lesson's page and picture.
  std::string digest_of_lesson(std::size_t i) const {
    const ReaderEdition of = edition(i);
    std::vector<std::string> parts = {program_name_and_version(),
                                      reader_assets::kReaderHtml,
                                      reader_assets::kReaderCss,
                                      reader_assets::kReaderJs,
                                      site_.lessons[i].loaded.sha256,
                                      lesson(i).id,
                                      site_.look.both                   ? "both"
                                      : site_.look.theme == Theme::dark ? "dark"
                                                                        : "paper",
                                      site_.look.quality ? name_of(*site_.look.quality) : "",
                                      of.place->next,
                                      of.place->next_title.text,
                                      of.place->url};
    parts.insert(parts.end(), of.place->lessons.begin(), of.place->lessons.end());
    for (const auto& [id, title] : of.titles)
      parts.insert(parts.end(), {id, title.text, std::string(tag_of(title.language))});
    if (program_)
      parts.insert(parts.end(),
                   {program_->name, live_assets::kLiveCss, live_assets::kLiveJs, live_assets::kFiguresJs});
    return digest_of(parts);
  }

  bool is_known(const std::string& file, const std::string& made_of) const {
    return is_there(folder_, record_, file, made_of);
  }

  std::vector<std::size_t> lessons_to_draw() {
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < site_.lessons.size(); ++i) {
      digests_.push_back(digest_of_lesson(i));
      const bool has_preview = first_figure(lesson(i), options_).has_value();
      files_.insert(page_of(lesson(i)));
      if (has_preview) files_.insert(preview_name(lesson(i)));
      for (const SiteDownload& download : site_.lessons[i].downloads) files_.insert(download.file);
      if (is_known(page_of(lesson(i)), digests_[i]) &&
          (!has_preview || is_known(preview_name(lesson(i)), digests_[i])))
        continue;
      wanted.push_back(i);
      steps_ += steps_of(edition(i));
    }
    return wanted;
  }

  /// The file lies there now. The record is written each time, so that nothing is drawn again after a stop.
  Done note(const std::string& file, const std::string& made_of) {
    const auto bytes = read_file_bytes(folder_ / file);
    if (!bytes)
      return failure_of(Fault::failed,
                        fmt::format("cannot read {}: {}", (folder_ / file).string(), bytes.error()));
    record_[file] = {made_of, sha256_hex(*bytes)};
    const Status written = write_site_record(folder_, record_, durability_);
    if (!written) return failed(written);
    return done();
  }

  /// Before the pages that lead to them.
  Done write_live() {
    if (!program_) return done();
    files_.insert({program_->name, kSiteSandbox});
    if (const std::string made_of = sha256_hex(program_->text); !is_known(program_->name, made_of))
      if (const Done put_there = put(program_->name, program_->text, made_of); !put_there) return put_there;
    std::vector<std::string> parts = sandbox_sources();
    parts.push_back(program_->name);
    const std::string made_of = digest_of(parts);
    if (is_known(kSiteSandbox, made_of)) return done();
    const Done written =
        write_sandbox(folder_ / kSiteSandbox, *site_.live, renderer_, durability_, program_->name);
    return written ? note(kSiteSandbox, made_of) : written;
  }

  Done draw(std::size_t i) {
    const ReaderEdition of = edition(i);
    const ReaderProgress go_on = [&](std::size_t, const Stage&) {
      return !go_on_ || go_on_(step_++, steps_, lesson(i).id);
    };
    const Outcome<ReaderEnd> end =
        write_reader(folder_ / page_of(lesson(i)), of, renderer_, durability_, go_on, effort_);
    if (!end) return passed_on(end);
    made_.stopped = *end == ReaderEnd::stopped;
    if (made_.stopped) return done();
    if (const Done noted = note(page_of(lesson(i)), digests_[i]); !noted) return noted;
    return draw_preview(i);
  }

  Done draw_preview(std::size_t i) {
    const std::optional<PlannedPicture> picture = first_figure(lesson(i), options_);
    if (!picture) return done();
    const auto maker = make_figure_maker({lesson(i), options_, renderer_, effort_});
    if (const Done checked = maker->check(*picture); !checked) return checked;
    const Outcome<PictureDescription> description = maker->describe(*picture);
    if (!description) return passed_on(description);
    const Outcome<Image> image = maker->draw(*picture);
    if (!image) return passed_on(image);
    const PngMetadata metadata =
        picture_metadata(lesson(i), *picture->stage, description->alt, description->t_s, options_.dpi);
    const Status written = write_png(folder_ / preview_name(lesson(i)), *image, metadata, durability_);
    if (!written) return failed(written);
    return note(preview_name(lesson(i)), digests_[i]);
  }

  /// For the index, as an address that holds the picture itself: it is the same from a disk as from a host.
  Result<std::string> preview_address(std::size_t i) const {
    const Result<PngFile> png = read_png(folder_ / preview_name(lesson(i)));
    if (!png) return failure(png.error());
    const Result<std::vector<std::uint8_t>> webp = encode_small_webp(png->image);
    if (!webp) return failure(webp.error());
    return "data:image/webp;base64," + base64(*webp);
  }

  Done write_index() {
    std::vector<std::string> parts = {site_assets::kSiteHtml, site_assets::kSiteCss, site_assets::kSiteJs,
                                      site_.live ? kSiteSandbox : ""};
    for (std::size_t i = 0; i < site_.lessons.size(); ++i) {
      parts.push_back(digests_[i]);
      for (const SiteDownload& download : site_.lessons[i].downloads) {
        parts.push_back(download.file);
        parts.push_back(download.words);
      }
    }
    const std::string made_of = digest_of(parts);
    files_.insert(kSiteIndex);
    if (is_known(kSiteIndex, made_of)) return done();
    std::vector<SiteIndexLesson> lessons;
    std::string preview;
    for (std::size_t i = 0; i < site_.lessons.size(); ++i) {
      const ReaderEdition of = edition(i);
      SiteIndexLesson one{lesson(i), entries_of(of, renderer_, effort_), {}, site_.lessons[i].downloads};
      if (!of.place->preview.empty()) {
        Result<std::string> address = preview_address(i);
        if (!address) return failed(address);
        one.picture = std::move(*address);
        if (preview.empty()) preview = of.place->preview;
      }
      lessons.push_back(std::move(one));
    }
    return put(kSiteIndex, site_index_html(lessons, site_.url, preview, site_.live ? kSiteSandbox : ""),
               made_of);
  }

  Done put(const std::string& file, const std::string& text, const std::string& made_of) {
    const Status written = replace_file_atomically(folder_ / file, bytes_of(text), durability_);
    if (!written) return failed(written);
    return note(file, made_of);
  }

  Done write_sitemap() {
    if (site_.url.empty()) return done();
    std::vector<std::string> pages = {""};
    if (site_.live) pages.push_back(kSiteSandbox);
    for (std::size_t i = 0; i < site_.lessons.size(); ++i) pages.push_back(page_of(lesson(i)));
    const std::string xml = sitemap_xml(site_.url, pages);
    constexpr const char* kName = "sitemap.xml";
    files_.insert(kName);
    return put(kName, xml, sha256_hex(xml));
  }

  void remove_others() {
    std::erase_if(record_, [&](const auto& known) {
      if (files_.contains(known.first)) return false;
      std::error_code ignored;
      fs::remove(folder_ / known.first, ignored);
      return true;
    });
  }

  const fs::path& folder_;
  const Site& site_;
  Renderer& renderer_;
  Durability durability_;
  const SiteProgress& go_on_;
  const Effort& effort_;
  const ExportOptions options_ = preview_options(site_.look);

  std::optional<LiveFile> program_;
  SiteRecord record_;
  std::vector<std::string> digests_;  ///< of the lessons
  std::set<std::string> files_;       ///< that are of this site
  std::size_t step_ = 0, steps_ = 0;  ///< of those that are drawn
  SiteMade made_;
};

}  // namespace

Status check_site_folder(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) return success();
  const Result<std::optional<SiteRecord>> record = read_site_record(folder);
  if (!record) return failure(record.error());
  if (*record) return success();
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (!is_temporary_name(entry->path().filename().string()))
      return failure(fmt::format("{} holds files of something else; give the site a folder of its own",
                                 folder.string()));
  return success();
}

Outcome<SiteMade> write_site(const fs::path& folder, const Site& site, Renderer& renderer,
                             Durability durability, const SiteProgress& go_on, const Effort& effort) try {
  return SiteWriter(folder, site, renderer, durability, go_on, effort).write();
} catch (const Interrupted&) {
  return SiteMade{.stopped = true};
}

}  // namespace polhode
