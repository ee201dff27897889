// SPDX-License-Identifier: MIT
// Invisible text on pages of a PDF: to be searched, selected, copied and read aloud. Its letters are those of
// fonts of type 3 without ink, made for the characters that occur, so every character there is can be had.
#pragma once

#include "app/publish/deck.h"
#include "render/vector/pdf_file.h"

#include <map>
#include <set>

namespace polhode {

class PdfTextLayer {
 public:
  /// Of all pages that it is to write on.
  explicit PdfTextLayer(const Deck& deck);

  /// The part of a page's content that sets the slide's name, as a heading with the marked content id
  /// `first_id`, and its notes, paragraphs with the next ones: in lines from the top of a page of `width` x
  /// `height` points down, as large as there is room.
  std::string content(const DeckSlide& slide, double width, double height, int first_id) const;

  /// The fonts that content() names, for the resources of each page.
  PdfObject make_fonts(PdfFile& pdf) const;

 private:
  struct Code {
    std::size_t font;
    int code;
  };
  Code code_of(char32_t character) const;
  std::string shown(std::string_view line) const;

  std::vector<char32_t> characters_;  ///< sorted; number n is code 1 + n mod 255 of font n / 255
};

}  // namespace polhode
