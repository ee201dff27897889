// SPDX-License-Identifier: MIT
// The first page of a site: its lessons in the order of the course, what one learns in each, and all headings
// and equations, among which its script looks for words. Without script it can be read all the same.
#pragma once

#include "app/publish/text_edition/reader_page.h"

#include <cstddef>
#include <string>
#include <vector>

namespace polhode {

/// Another form of a lesson, beside its page.
struct SiteDownload {
  std::string file;
  std::string words;  ///< "slides as PDF"
};

struct SiteIndexLesson {
  const Lesson& lesson;
  std::vector<ReaderEntry> entries{};
  std::string picture{};  ///< an address; empty: none
  std::vector<SiteDownload> downloads{};
};

/// The order of a course: each lesson stands before its `next`, and chains of lessons follow each other by
/// the ids of their first ones. @return places in `lessons`
std::vector<std::size_t> course_order(const std::vector<const Lesson*>& lessons);

/// @param url of the folder on the web, with a slash at its end; may be empty
/// @param preview file of a picture for the page where it is linked to; may be empty
/// @param sandbox file of the sandbox (app/publish/live/sandbox_page.h); empty: there is none
std::string site_index_html(const std::vector<SiteIndexLesson>& lessons, const std::string& url,
                            const std::string& preview, const std::string& sandbox = "");

/// https://www.sitemaps.org/protocol.html
std::string sitemap_xml(const std::string& url, const std::vector<std::string>& files);

}  // namespace polhode
