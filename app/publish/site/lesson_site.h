// SPDX-License-Identifier: MIT
// Lessons as a folder of static files, for any host and for reading without network: ID.html, the text
// edition of each lesson, whose parts have addresses that stay (ID.html#stage, #stage/step.2,
// #stage/equation); ID.png, a picture of it for where it is linked to; index.html; sitemap.xml, where the
// address of the folder is known; site.json, what was made of what. Where figures move, the program for them
// as one file for all pages, and sandbox.html. The same lessons give the same bytes.
#pragma once

#include "app/page/loaded_lesson.h"
#include "app/publish/site/site_index.h"
#include "physics/effort.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace polhode {

struct SiteLesson {
  const LoadedLesson& loaded;
  std::vector<SiteDownload> downloads{};  ///< files that lie in the folder and are in its record
  std::string text{};                     ///< that it was read from; needed where figures move
};

struct Site {
  std::vector<SiteLesson> lessons;  ///< in their order (course_order), a translation behind its original; no
                                    ///< two have one id and language, and none is "index" or "sandbox"
  ReaderFigures::Look look{};
  std::string url{};                  ///< of the folder on the web, with a slash at its end; empty: unknown
  std::optional<LiveProgram> live{};  ///< absent: figures are pictures, and nothing else
};

/// An error where the folder holds something else than a site.
Status check_site_folder(const std::filesystem::path& folder);

struct SiteMade {
  std::size_t drawn = 0, kept = 0;  ///< lessons
  bool stopped = false;
};

/// Told which step of those that are to be drawn comes next, of how many, and of which lesson; false stops.
using SiteProgress = std::function<bool(std::size_t step, std::size_t steps, const std::string& lesson)>;

/// Files appear whole or not at all, each as soon as it is made. A lesson whose page lies there, made of the
/// same text by the same version of the program with the same options, is not drawn again, so that a site
/// that was stopped goes on. Files of lessons that are gone are removed, and nothing else.
/// Stopped: `go_on` said false, or `effort` threw Interrupted. Precondition: check_site_folder
Outcome<SiteMade> write_site(const std::filesystem::path& folder, const Site& site, Renderer& renderer,
                             Durability durability, const SiteProgress& go_on, const Effort& effort = {});

}  // namespace polhode
