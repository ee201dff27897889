// SPDX-License-Identifier: MIT
// The options of `polhode export`, from what was typed.
#pragma once

#include "app/export/export_output.h"
#include "app/export/export_plan.h"

#include <string>
#include <vector>

namespace polhode {

/// As typed; empty where not given.
struct TypedExport {
  std::vector<std::string> lessons;
  std::string folder;
  std::vector<std::string> stages;
  std::string each, what, size, fps, seconds, at, frames, background, theme, profile, quality, text_size, dpi,
      png, format, sync, context;
  std::string film, deck, reader, sandbox, site, url, shard, jobs;
  std::vector<std::string> with;
  bool live = false;
  bool count_chosen = false;
  bool skip_existing = false;
  std::vector<std::string> words;  ///< the command line, program and options, without --skip-existing
};

/// The words that those options take which take a word, in the order of their enumerations; of a size and a
/// background there are others.
struct ExportWords {
  std::vector<std::string> what, each, size, background, theme, profile, quality, png, format, sync, context,
      with;
};
const ExportWords& export_words();

/// @throws CommandError usage: what is malformed, out of range, or does not go with the kind of export.
ExportOptions export_options(const TypedExport& typed);

/// A text edition.
struct ReaderOutput {
  std::string file;
  std::vector<std::string> stages{};
  bool live = false;                    ///< figures can be played
  Theme theme = Theme::paper;           ///< of its figures
  bool in_both_themes = false;          ///< those are drawn on dark ground too
  std::optional<QualityLevel> quality;  ///< likewise; absent: the scenes'
  Durability durability = Durability::rename_only;
  ContextKind context = ContextKind::any;
};
/// Of a text edition, or of a sandbox, which is a page of no lesson. @throws CommandError usage: what is
/// malformed, or does not go with it. Precondition: one is asked for.
ReaderOutput reader_output(const TypedExport& typed);
ReaderOutput sandbox_output(const TypedExport& typed);

/// The one lesson of an export that is no site. @throws CommandError usage: none or several
const std::string& lesson_of(const TypedExport& typed);

/// What lies beside the page of each lesson of a site.
enum class SiteCopy { html_slides, pdf_slides, pptx_slides, film };

struct SiteOutput {
  std::string folder;
  std::string url;  ///< with a slash at its end; empty: not given
  std::vector<SiteCopy> with;
  bool live = false;  ///< figures can be played, and those of HTML slides
  Theme theme = Theme::paper;
  bool in_both_themes = false;  ///< the figures of its pages are drawn in the other, too
  std::optional<QualityLevel> quality;
  Durability durability = Durability::rename_only;
  ContextKind context = ContextKind::any;
};
/// @throws CommandError usage: what is malformed, or does not go with a site. Precondition: one is asked for.
SiteOutput site_output(const TypedExport& typed);

/// @throws CommandError usage
ExportOutput export_output(const TypedExport& typed);

}  // namespace polhode
