// SPDX-License-Identifier: MIT
#include "app/publish/site/site_index.h"

#include "app/export/picture_metadata.h"
#include "app/publish/html_frame.h"
#include "app/publish/html_text.h"
#include "app/publish/site/site_assets.h"
#include "app/publish/text_edition/reader_style.h"
#include "base/words/edition_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

namespace polhode {

namespace {

std::string language_of(const Lesson& lesson, Language of_page) {
  return lang_of(lesson.about.language, of_page);
}

/// In this language if it is there in it.
const Lesson* find(const std::vector<SiteIndexLesson>& lessons, const std::string& id, Language language) {
  const Lesson* found = nullptr;
  for (const SiteIndexLesson& one : lessons)
    if (one.lesson.id == id && (found == nullptr || one.lesson.about.language == language))
      found = &one.lesson;
  return found;
}

/// From 1; a translation has the number of its original.
std::size_t number_in_course(const std::vector<SiteIndexLesson>& lessons, std::size_t i) {
  std::vector<std::string> ids;
  for (std::size_t k = 0; k <= i; ++k)
    if (std::ranges::find(ids, lessons[k].lesson.id) == ids.end()) ids.push_back(lessons[k].lesson.id);
  return static_cast<std::size_t>(std::ranges::find(ids, lessons[i].lesson.id) - ids.begin()) + 1;
}

std::string link_to(const Lesson& lesson, Language of_page) {
  return fmt::format("<a href=\"{}.html\"{}>{}</a>",
                     html_escaped(page_name(lesson.id, lesson.about.language)), language_of(lesson, of_page),
                     html_escaped(lesson.title));
}

/// A line of what one should know; it may be another lesson.
std::string prerequisite(const std::vector<SiteIndexLesson>& lessons, const std::string& line,
                         Language language) {
  const Lesson* lesson = find(lessons, line, language);
  return lesson == nullptr ? html_escaped(line) : link_to(*lesson, language);
}

std::string lesson_html(const std::vector<SiteIndexLesson>& all, std::size_t i) {
  const SiteIndexLesson& one = all[i];
  const Lesson& lesson = one.lesson;
  std::string html = fmt::format(
      "<li class=\"lesson\"{}>\n<div class=\"about\">\n<h2><span class=\"number\">{}</span>{}</h2>\n",
      language_of(lesson, all.front().lesson.about.language), number_in_course(all, i),
      link_to(lesson, lesson.about.language));
  if (!lesson.about.authors.empty())
    html += fmt::format("<p class=\"authors\">{}</p>\n",
                        html_escaped(fmt::format("{}", fmt::join(lesson.about.authors, ", "))));
  if (!lesson.about.outcomes.empty()) {
    html += fmt::format("<h3>{}</h3>\n<ul>\n", words::kOutcomes.in(lesson.about.language));
    for (const std::string& line : lesson.about.outcomes) html += "<li>" + html_escaped(line) + "</li>\n";
    html += "</ul>\n";
  }
  if (!lesson.about.prerequisites.empty()) {
    html += fmt::format("<h3>{}</h3>\n<ul>\n", words::kPrerequisites.in(lesson.about.language));
    for (const std::string& line : lesson.about.prerequisites)
      html += "<li>" + prerequisite(all, line, lesson.about.language) + "</li>\n";
    html += "</ul>\n";
  }
  if (!one.downloads.empty()) {
    std::vector<std::string> links;
    for (const SiteDownload& download : one.downloads)
      links.push_back(
          fmt::format("<a href=\"{}\">{}</a>", html_escaped(download.file), html_escaped(download.words)));
    html += "<p>" +
            words::kToTakeAlong.with(lesson.about.language, {fmt::format("{}", fmt::join(links, ", "))}) +
            "</p>\n";
  }
  html += "</div>\n";
  // It says nothing that is not said beside it.
  if (!one.picture.empty())
    html += fmt::format("<img width=\"{}\" height=\"{}\" alt=\"\" src=\"{}\"/>\n", kPreviewWidth,
                        kPreviewHeight, one.picture);
  return html + "</li>\n";
}

/// Words that the script looks through: those of the entry, and its name in addresses.
std::string entry_html(const Lesson& lesson, const ReaderEntry& entry) {
  return fmt::format("<li{} data-words=\"{} {}\"><a href=\"{}.html#{}\">{}</a></li>\n",
                     entry.kind == ReaderEntry::Kind::stage ? "" : " class=\"within\"",
                     html_escaped(entry.words), html_escaped(entry.id),
                     html_escaped(page_name(lesson.id, lesson.about.language)), html_escaped(entry.id),
                     entry.html);
}

std::string entries_html(const std::vector<SiteIndexLesson>& lessons) {
  std::string html;
  for (const SiteIndexLesson& one : lessons) {
    html += fmt::format("<details{}>\n<summary>{}</summary>\n<ul>\n",
                        language_of(one.lesson, lessons.front().lesson.about.language),
                        html_escaped(one.lesson.title));
    for (const ReaderEntry& entry : one.entries) html += entry_html(one.lesson, entry);
    html += "</ul>\n</details>\n";
  }
  return html;
}

/// With the colours of the symbols of all lessons.
std::string style_of(const std::vector<SiteIndexLesson>& lessons) {
  Lesson all;
  for (const SiteIndexLesson& one : lessons)
    for (const auto& [name, symbol] : one.lesson.symbols)
      all.symbols.emplace(one.lesson.id + ' ' + name, symbol);
  return reader_style(all) + site_assets::kSiteCss;
}

}  // namespace

std::vector<std::size_t> course_order(const std::vector<const Lesson*>& lessons) {
  std::map<std::string, std::size_t> place;
  std::set<std::string> follow;
  for (std::size_t i = 0; i < lessons.size(); ++i) {
    place.emplace(lessons[i]->id, i);
    follow.insert(lessons[i]->about.next);
  }
  std::vector<std::size_t> order;
  std::set<std::size_t> taken;
  const auto take_chain = [&](std::size_t i) {
    while (taken.insert(i).second) {
      order.push_back(i);
      const auto next = place.find(lessons[i]->about.next);
      if (next == place.end()) return;
      i = next->second;
    }
  };
  for (const auto& [id, i] : place)
    if (!follow.contains(id)) take_chain(i);
  for (const auto& [id, i] : place) take_chain(i);  // those that lead round in a circle
  return order;
}

std::string site_index_html(const std::vector<SiteIndexLesson>& lessons, const std::string& url,
                            const std::string& preview, const std::string& sandbox) {
  const std::string style = style_of(lessons), script = std::string("\n") + site_assets::kSiteJs;
  const Language language = lessons.empty() ? Language::en : lessons.front().lesson.about.language;
  const auto said = [&](const Phrase& phrase) { return html_escaped(phrase.in(language)); };
  std::string shown;
  for (std::size_t i = 0; i < lessons.size(); ++i) shown += lesson_html(lessons, i);
  const std::map<std::string, std::string> texts = {
      {"language", std::string(tag_of(language))},
      // Nothing is fetched, and nothing runs but what is written here, whatever the lessons say.
      {"policy",
       fmt::format("default-src 'none'; img-src data:; style-src {}; script-src {}; base-uri 'none'; "
                   "form-action 'none'",
                   policy_hash(style), policy_hash(script))},
      {"program", html_escaped(program_name_and_version())},
      {"title", said(words::kSiteTitle)},
      {"head", social_head(url, "", std::string(words::kSiteTitle.in(language)),
                           std::string(words::kSiteLead.in(language)), preview)},
      {"style", style},
      {"lead", said(words::kSiteLead)},
      {"to-the-lessons", said(words::kToTheLessons)},
      {"find", said(words::kFindHeading)},
      {"headings", said(words::kHeadingsAndEquations)},
      {"words", html_escaped(json_of(words::kSiteScript, language))},
      {"sandbox",
       sandbox.empty()
           ? ""
           : "<p class=\"lead\">" + words::kThrowABody.with(language, {html_escaped(sandbox)}) + "</p>\n"},
      {"lessons", shown},
      {"entries", entries_html(lessons)},
      {"script", script},
  };
  return filled_frame(site_assets::kSiteHtml, texts);
}

std::string sitemap_xml(const std::string& url, const std::vector<std::string>& files) {
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<urlset "
      "xmlns=\"http://www.sitemaps.org/schemas/sitemap/0.9\">\n";
  for (const std::string& file : files) xml += "<url><loc>" + escaped(url + file) + "</loc></url>\n";
  return xml + "</urlset>\n";
}

}  // namespace polhode
