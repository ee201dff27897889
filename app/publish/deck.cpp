// SPDX-License-Identifier: MIT
#include "app/publish/deck.h"

#include "app/publish/deck_picture.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace polhode {

namespace fs = std::filesystem;

PaperSize paper_size(Size picture, int dpi) {
  const int side = std::min(picture.width, picture.height);
  const double per_inch = dpi > 0 ? dpi : side / kDeckSide_in;
  return {picture.width / per_inch, picture.height / per_inch};
}

std::string name_of(const DeckSlide& slide) {
  return slide.part.empty() ? slide.title : slide.title + ", " + slide.part;
}

std::optional<DeckKind> deck_kind_of(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (ending == ".html" || ending == ".htm") return DeckKind::html;
  if (ending == ".pdf") return DeckKind::pdf;
  if (ending == ".pptx") return DeckKind::pptx;
  return std::nullopt;
}

Result<DeckPicture> read_deck_picture(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return failure("cannot read " + file.string());
  DeckPicture picture;
  picture.bytes.assign(std::istreambuf_iterator<char>(stream), {});
  Result<PngChunks> png = read_png_chunks(picture.bytes);
  if (!png) return failure("cannot use " + file.string() + ": " + png.error());
  picture.png = std::move(*png);
  return picture;
}

Result<DeckEnd> write_deck(const fs::path& file, DeckKind kind, const Deck& deck, Durability durability,
                           const DeckProgress& go_on) {
  const auto append_deck = kind == DeckKind::html  ? append_html_deck
                           : kind == DeckKind::pdf ? append_pdf_deck
                                                   : append_pptx_deck;
  bool stopped = false;
  const DeckProgress noted = [&](std::size_t slide) {
    stopped = go_on && !go_on(slide);
    return !stopped;
  };
  const Status written = write_file_in_pieces(
      file, [&](const AppendBytes& append) { return append_deck(deck, append, noted); }, durability);
  if (stopped) return DeckEnd::stopped;
  if (!written) return failure(written.error());
  return DeckEnd::written;
}

}  // namespace polhode
