// SPDX-License-Identifier: MIT
#include "app/publish/pdf_text_layer.h"

#include "app/narration/transcript.h"
#include "base/utf8.h"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

namespace {

constexpr std::size_t kCodes = 255;   ///< of a font: 1 to 255
constexpr double kLetterWidth = 0.5;  ///< em, of every character
constexpr double kLineHeight = 1.3;   ///< em
constexpr double kMargin = 0.06;      ///< of the page's shorter side

std::u32string utf16_units(char32_t character) {
  if (character < 0x10000) return {character};
  const char32_t rest = character - 0x10000;
  return {0xD800 + (rest >> 10), 0xDC00 + (rest & 0x3FF)};
}

/// What a reader of the file copies for each code.
std::string to_unicode(const std::vector<char32_t>& characters) {
  std::string map =
      "/CIDInit /ProcSet findresource begin\n12 dict begin\nbegincmap\n/CMapType 2 def\n"
      "/CMapName /polhode def\n1 begincodespacerange\n<00> <FF>\nendcodespacerange\n";
  constexpr std::size_t kMost = 100;  // entries of a section
  for (std::size_t i = 0; i < characters.size(); i += kMost) {
    const std::size_t end = std::min(characters.size(), i + kMost);
    map += fmt::format("{} beginbfchar\n", end - i);
    for (std::size_t k = i; k < end; ++k) {
      map += fmt::format("<{:02X}> <", k + 1);
      for (const char32_t unit : utf16_units(characters[k]))
        map += fmt::format("{:04X}", static_cast<std::uint32_t>(unit));
      map += ">\n";
    }
    map += "endbfchar\n";
  }
  return map + "endcmap\nCMapName currentdict /CMap defineresource pop\nend\nend\n";
}

PdfObject font_of(PdfFile& pdf, const std::vector<char32_t>& characters, const PdfObject& letter) {
  const auto count = static_cast<int>(characters.size());
  std::string names, widths;
  for (int i = 0; i < count; ++i) {
    names += " /letter";
    widths += fmt::format(" {}", 1000 * kLetterWidth);
  }
  PdfObject font = PdfObject::parse(
      fmt::format("<< /Type /Font /Subtype /Type3 /FontBBox [0 -250 {} 750] "
                  "/FontMatrix [0.001 0 0 0.001 0 0] /FirstChar 1 /LastChar {} /Widths [{} ] "
                  "/Encoding << /Type /Encoding /Differences [1{} ] >> /Resources << >> >>",
                  1000 * kLetterWidth, count, widths, names));
  PdfObject glyphs = PdfObject::parse("<< >>");
  glyphs.set("/letter", letter);
  font.set("/CharProcs", glyphs);
  font.set("/ToUnicode", pdf.stream(to_unicode(characters)));
  return pdf.numbered(font);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    lines.push_back(text.substr(begin, end - begin));
  if (begin < text.size()) lines.push_back(text.substr(begin));
  return lines;
}

}  // namespace

PdfTextLayer::PdfTextLayer(const Deck& deck) {
  std::set<char32_t> found;
  const auto add = [&](std::string_view text) {
    for (const char32_t character : code_points(text)) found.insert(character);
  };
  for (const DeckSlide& slide : deck.slides) {
    add(name_of(slide));
    for (const StepNote& note : slide.notes) add(note.text);
  }
  found.insert(U' ');
  characters_.assign(found.begin(), found.end());
}

PdfTextLayer::Code PdfTextLayer::code_of(char32_t character) const {
  const auto found = std::lower_bound(characters_.begin(), characters_.end(), character);
  const auto number = static_cast<std::size_t>(found - characters_.begin());
  return {number / kCodes, static_cast<int>(number % kCodes) + 1};
}

/// Operators that show a line, from font to font.
std::string PdfTextLayer::shown(std::string_view line) const {
  std::string content;
  std::optional<std::size_t> font;
  for (const char32_t character : code_points(line)) {
    const Code code = code_of(character);
    if (font != code.font) {
      if (font) content += "> Tj ";
      content += fmt::format("/T{} 1 Tf <", code.font);
      font = code.font;
    }
    content += fmt::format("{:02X}", code.code);
  }
  return font ? content + "> Tj" : content;
}

std::string PdfTextLayer::content(const DeckSlide& slide, double width, double height, int first_id) const {
  std::vector<std::vector<std::string>> paragraphs = {lines_of(wrapped(name_of(slide), ""))};
  for (const StepNote& note : slide.notes) paragraphs.push_back(lines_of(wrapped(note.text, "")));
  std::size_t lines = 0;
  for (const auto& paragraph : paragraphs) lines += paragraph.size();
  const double margin = kMargin * std::min(width, height);
  const double across = (width - 2 * margin) / (kLetterWidth * kTranscriptColumns);
  const double along =
      (height - 2 * margin) / (kLineHeight * static_cast<double>(std::max<std::size_t>(1, lines)));
  const double size = std::min(across, along);

  std::string content = "BT 3 Tr\n";
  double y = height - margin - size;
  int id = first_id;
  for (const auto& paragraph : paragraphs) {
    content += fmt::format("/{} << /MCID {} >> BDC\n", id == first_id ? "H1" : "P", id);
    ++id;
    for (const std::string& line : paragraph) {
      // A word that no line can hold is narrow.
      const auto columns = static_cast<double>(code_points(line).size());
      const double narrow = std::min(1.0, static_cast<double>(kTranscriptColumns) / columns);
      content +=
          fmt::format("{:.4f} 0 0 {:.3f} {:.3f} {:.3f} Tm {}\n", size * narrow, size, margin, y, shown(line));
      y -= kLineHeight * size;
    }
    content += "EMC\n";
  }
  return content + "ET\n";
}

PdfObject PdfTextLayer::make_fonts(PdfFile& pdf) const {
  const PdfObject letter = pdf.stream(fmt::format("{0} 0 0 -250 {0} 750 d1\n", 1000 * kLetterWidth));
  PdfObject fonts = PdfObject::parse("<< >>");
  for (std::size_t begin = 0; begin < characters_.size(); begin += kCodes) {
    const std::size_t end = std::min(characters_.size(), begin + kCodes);
    const std::vector<char32_t> some(characters_.begin() + static_cast<std::ptrdiff_t>(begin),
                                     characters_.begin() + static_cast<std::ptrdiff_t>(end));
    fonts.set(fmt::format("/T{}", begin / kCodes), font_of(pdf, some, letter));
  }
  return fonts;
}

}  // namespace polhode
