// SPDX-License-Identifier: MIT
// The text edition of a lesson: one file of HTML for any browser, phone or screen reader, to be read without
// network and without script. Headings, prose, formulas as MathML, figures as pictures with alternative
// texts, what was proved in plain words, questions with their answers. Bytes depend on the lesson and the
// look alone, and on the driver that draws.
#pragma once

#include "app/publish/live/live_program.h"
#include "app/publish/text_edition/reader_figure.h"
#include "base/files/atomic_file.h"
#include "base/outcome.h"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace polhode {

/// The title of another lesson, in the language of its own.
struct ReaderTitle {
  std::string text;
  Language language = Language::en;
};

/// Where a page lies among others of a site (app/publish/site/): ID.html beside each other, and an index.
struct ReaderPlace {
  /// The same lesson in other languages.
  std::vector<Language> languages{};
  std::set<std::string> lessons{};  ///< ids of those that links of the lesson may lead to
  std::string next{};               ///< the lesson behind this one; empty: none
  ReaderTitle next_title{};
  std::string url{};      ///< of the folder on the web, with a slash at its end; may be empty
  std::string preview{};  ///< name of a picture of 1200 x 630 px; empty: none
};
/// The name of a lesson's page, without its ending: "euler-equations", "euler-equations.de".
std::string page_name(const std::string& lesson_id, Language language);
inline constexpr const char* kSiteIndex = "index.html";
inline constexpr const char* kSiteSandbox = "sandbox.html";

struct ReaderEdition {
  const Lesson& lesson;
  std::vector<std::string> stages{};  ///< ids; empty: all. Nothing leads to the others
  ReaderFigures::Look look{};  ///< of the figures: texts follow the reader's own wish for light or dark
  std::optional<ReaderPlace> place{};           ///< absent: it lies alone
  std::map<std::string, ReaderTitle> titles{};  ///< of other lessons that it builds on, by their ids
  std::optional<LiveParts> live{};              ///< absent: figures are pictures, and nothing else
};

/// Told which of the edition's steps comes next, from 0, and the stage it is of; false stops.
using ReaderProgress = std::function<bool(std::size_t step, const Stage& stage)>;

enum class ReaderEnd { written, stopped };

std::size_t steps_of(const ReaderEdition& edition);

/// What can be looked for on the page: headings and equations, in their order.
struct ReaderEntry {
  enum class Kind { stage, step, equation } kind = Kind::stage;
  std::string id;     ///< the page's address behind '#'
  std::string html;   ///< within a line
  std::string words;  ///< as it is read aloud
};
/// @throws what `effort` throws
std::vector<ReaderEntry> entries_of(const ReaderEdition& edition, Renderer& renderer,
                                    const Effort& effort = {});

/// The file appears whole or not at all: if `go_on`, which may be empty, says false, or `effort` throws
/// Interrupted, it is stopped, and what stood under the name stays. One figure is in memory at a time.
Outcome<ReaderEnd> write_reader(const std::filesystem::path& file, const ReaderEdition& edition,
                                Renderer& renderer, Durability durability = Durability::rename_only,
                                const ReaderProgress& go_on = {}, const Effort& effort = {});

}  // namespace polhode
