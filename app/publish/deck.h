// SPDX-License-Identifier: MIT
// Slides: pictures of a lesson in one file that is shown as it is, with what is said to each of them. An HTML
// deck is a page for any browser, without network; a PDF deck has the words as invisible text behind the
// pictures, and an outline; a PPTX deck is for the programs of presentations (PowerPoint, LibreOffice
// Impress), with titles, notes and sections as those have them. Bytes depend on the deck alone.
#pragma once

#include "app/narration/step_note.h"
#include "app/page/page_theme.h"
#include "app/publish/live/live_program.h"
#include "base/files/atomic_file.h"
#include "base/words/language.h"
#include "render/image/image.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

struct DeckSlide {
  std::filesystem::path png;    ///< its name without folder and ending identifies the slide; no two are alike
  int stage = 1;                ///< from 1; slides of a stage follow each other
  std::string title;            ///< of the stage
  std::string part;             ///< "step 2 of 3", or its title; empty: the slide is all of its stage
  std::string alt;              ///< what is seen
  std::vector<StepNote> notes;  ///< their links lead to "#slide", or to an address of the web
  std::string live{};           ///< live_attributes of its step; empty: nothing on it moves
};

struct Deck {
  std::string title;
  std::string author{};  ///< all of them in one line; may be empty
  Language language = Language::en;
  Theme theme = Theme::paper;  ///< around the pictures
  int dpi = 0;                 ///< of printed pictures; 0: their shorter side is kDeckSide_in
  std::vector<DeckSlide> slides;
  /// Of an HTML deck: once it is pressed, the figure of a slide takes the slide's place and moves. Absent:
  /// slides are pictures, and nothing else.
  std::optional<LiveParts> live{};
};

/// As of a slide show: 16:9 is 13.333 x 7.5 in, 4:3 is 10 x 7.5 in.
inline constexpr double kDeckSide_in = 7.5;

struct PaperSize {
  double width_in = 0, height_in = 0;
};
PaperSize paper_size(Size picture, int dpi);

/// "Title, step 2 of 3"
std::string name_of(const DeckSlide& slide);

enum class DeckKind { html, pdf, pptx };
/// By the ending: .html, .htm, .pdf or .pptx, in any case.
std::optional<DeckKind> deck_kind_of(const std::filesystem::path& file);

/// Told which slide comes next, from 0; false stops.
using DeckProgress = std::function<bool(std::size_t slide)>;

enum class DeckEnd { written, stopped };

/// The file appears whole or not at all: if `go_on`, which may be empty, says false, the deck is stopped, and
/// what stood under the name stays. A few slides are in memory at a time. Fails if a picture cannot be read
/// or is damaged.
Result<DeckEnd> write_deck(const std::filesystem::path& file, DeckKind kind, const Deck& deck,
                           Durability durability = Durability::rename_only, const DeckProgress& go_on = {});

/// What write_deck writes. In a PDF the notes lie behind the pictures, as its text: that of who speaks is
/// left out. In a PPTX two slides of the same name get a number behind it. All also fail where `go_on`, which
/// is not empty, says false.
Status append_html_deck(const Deck& deck, const AppendBytes& append, const DeckProgress& go_on);
Status append_pdf_deck(const Deck& deck, const AppendBytes& append, const DeckProgress& go_on);
Status append_pptx_deck(const Deck& deck, const AppendBytes& append, const DeckProgress& go_on);

}  // namespace polhode
