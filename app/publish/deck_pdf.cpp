// SPDX-License-Identifier: MIT
// The PDF deck. pdf_file.h writes the objects; what is in them is here: pages with a picture each, the words
// of the slide as invisible text on top, an outline by stage, and the structure that readers of the file for
// the blind follow: a figure with its alternative text, then paragraphs.
#include "app/export/picture_metadata.h"
#include "app/publish/deck.h"
#include "app/publish/deck_picture.h"
#include "app/publish/pdf_text_layer.h"
#include "render/image/png.h"
#include "render/vector/pdf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace polhode {

namespace {

using Object = PdfObject;

constexpr double kPointsPerInch = 72;
/// Some viewers round a picture's edges outwards, and would stretch it by a pixel at its own resolution.
constexpr double kInset_pt = 0.001;

/// PdfObject reports by exceptions, and so does what it calls; they end in append_pdf_deck.
template <class T>
T or_throw(Result<T>&& result) {
  if (!result) throw std::runtime_error(result.error());
  return std::move(result).value();
}

Object number(double value) { return Object::real(value, 4); }

/// PDF's Flate streams know PNG's filters: pixels without alpha are taken over as they are stored.
bool fits_as_stored(const PngChunks& png) {
  const auto transparent = [](const PngChunk& chunk) { return chunk.type == "tRNS"; };
  return !png.header.interlaced && png.header.bit_depth <= 8 && png.header.color_type <= 3 &&
         std::none_of(png.chunks.begin(), png.chunks.end(), transparent);
}

Object stored_colors(const PngChunks& png) {
  if (png.header.color_type == 0) return Object::name("/DeviceGray");
  if (png.header.color_type == 2) return Object::name("/DeviceRGB");
  for (const PngChunk& chunk : png.chunks)
    if (chunk.type == "PLTE") {
      const std::string palette(chunk.data.begin(), chunk.data.end());
      return Object::array({Object::name("/Indexed"), Object::name("/DeviceRGB"),
                            Object::integer(static_cast<int>(palette.size() / 3) - 1),
                            Object::bytes(palette)});
    }
  throw std::runtime_error("a PNG with a palette has none");
}

void describe_image(Object& image, Size size, int bits, const Object& colors) {
  Object dictionary = image.dictionary();
  dictionary.set("/Type", Object::name("/XObject"));
  dictionary.set("/Subtype", Object::name("/Image"));
  dictionary.set("/Width", Object::integer(size.width));
  dictionary.set("/Height", Object::integer(size.height));
  dictionary.set("/BitsPerComponent", Object::integer(bits));
  dictionary.set("/ColorSpace", colors);
}

/// The file is read again when its turn comes: one picture is in memory at a time.
Object stored_image(PdfFile& pdf, const std::filesystem::path& file, const PngChunks& png,
                    const std::function<void()>& begin) {
  const Object parameters = Object::parse(
      fmt::format("<< /Predictor 15 /Colors {} /BitsPerComponent {} /Columns {} >>",
                  png.header.color_type == 2 ? 3 : 1, png.header.bit_depth, png.header.size.width));
  Object image = pdf.stream(
      [file, begin](const PdfSink& out) {
        begin();
        const DeckPicture picture = or_throw(read_deck_picture(file));
        for (const PngChunk& chunk : picture.png.chunks)
          if (chunk.type == "IDAT") out(chunk.data.data(), chunk.data.size());
      },
      Object::name("/FlateDecode"), parameters);
  describe_image(image, png.header.size, png.header.bit_depth, stored_colors(png));
  return image;
}

/// `count` of each pixel's four bytes, from number `first` on.
Object decoded_image(PdfFile& pdf, const std::filesystem::path& file, Size size, std::size_t first,
                     std::size_t count, const std::function<void()>& begin) {
  Object image = pdf.stream(
      [file, first, count, begin](const PdfSink& out) {
        begin();
        const PngFile png = or_throw(read_png(file));
        std::vector<std::uint8_t> row(static_cast<std::size_t>(png.image.size.width) * count);
        for (int y = 0; y < png.image.size.height; ++y) {
          const std::uint8_t* pixel = png.image.pixel(0, y);
          for (std::size_t i = 0; i < row.size(); ++i) row[i] = pixel[i / count * 4 + first + i % count];
          out(row.data(), row.size());
        }
      },
      Object(), Object());
  describe_image(image, size, 8, Object::name(count == 3 ? "/DeviceRGB" : "/DeviceGray"));
  return image;
}

/// `begin` is called when its bytes are asked for.
Object image_of(PdfFile& pdf, const std::filesystem::path& file, const PngChunks& png,
                const std::function<void()>& begin) {
  if (fits_as_stored(png)) return stored_image(pdf, file, png, begin);
  Object image = decoded_image(pdf, file, png.header.size, 0, 3, begin);
  image.dictionary().set("/SMask", decoded_image(pdf, file, png.header.size, 3, 1, begin));
  return image;
}

class PdfDeck {
 public:
  PdfDeck(const Deck& deck, const DeckProgress& go_on) : deck_(deck), go_on_(go_on), layer_(deck) {
    fonts_ = layer_.make_fonts(pdf_);
    structure_ = dictionary("<< /Type /StructElem /S /Document >>");
    structure_.set("/K", Object::array());
    page_elements_ = Object::array();
    for (const DeckSlide& slide : deck.slides) add(slide);
    describe_document();
    add_outline();
  }

  void write(const AppendBytes& append) {
    pdf_.write([&](const unsigned char* data, std::size_t count) { or_throw(append({data, count})); });
  }

 private:
  Object dictionary(const std::string& pdf_text) { return pdf_.numbered(Object::parse(pdf_text)); }

  void add(const DeckSlide& slide) {
    const DeckPicture picture = or_throw(read_deck_picture(slide.png));
    const PaperSize paper = paper_size(picture.png.header.size, deck_.dpi);
    const double width = paper.width_in * kPointsPerInch, height = paper.height_in * kPointsPerInch;
    Object page = dictionary("<< /Type /Page /Tabs /S /Resources << /XObject << >> >> >>");
    page.set("/MediaBox",
             Object::array({Object::integer(0), Object::integer(0), number(width), number(height)}));
    Object resources = page.get("/Resources");
    resources.get("/XObject")
        .set("/Slide", image_of(pdf_, slide.png, picture.png, [this, number = pages_.size()] {
               if (!go_on_(number)) throw std::runtime_error("stopped");
             }));
    resources.set("/Font", fonts_);
    const std::string content =
        fmt::format("/Figure << /MCID 0 >> BDC\nq {0:.4f} 0 0 {1:.4f} {2} {2} cm /Slide Do Q\nEMC\n",
                    width - 2 * kInset_pt, height - 2 * kInset_pt, kInset_pt) +
        layer_.content(slide, width, height, 1);
    page.set("/Contents", pdf_.stream(content));
    page.set("/StructParents", Object::integer(page_elements_.size() / 2));
    add_structure(slide, page, width, height);
    pdf_.add_page(page);
    pages_.push_back(page);
  }

  /// An element of a page for its marked content `id`.
  Object element(const char* type, Object& page, int id) {
    Object made = dictionary(fmt::format("<< /Type /StructElem /S /{} /K {} >>", type, id));
    made.set("/P", structure_);
    made.set("/Pg", page);
    structure_.get("/K").append(made);
    return made;
  }

  void add_structure(const DeckSlide& slide, Object& page, double width, double height) {
    Object elements = Object::array();
    Object figure = element("Figure", page, 0);
    figure.set("/Alt", Object::text(slide.alt));
    Object layout = Object::parse("<< /O /Layout /Placement /Block >>");
    layout.set("/BBox",
               Object::array({Object::integer(0), Object::integer(0), number(width), number(height)}));
    figure.set("/A", layout);
    elements.append(figure);
    elements.append(element("H1", page, 1));
    for (std::size_t i = 0; i < slide.notes.size(); ++i)
      elements.append(element("P", page, static_cast<int>(i) + 2));
    page_elements_.append(Object::integer(page_elements_.size() / 2));
    page_elements_.append(pdf_.numbered(elements));
  }

  void describe_document() {
    Object root = pdf_.root();
    root.set("/Lang", Object::text(std::string(tag_of(deck_.language))));
    root.set("/MarkInfo", Object::parse("<< /Marked true >>"));
    root.set("/ViewerPreferences", Object::parse("<< /DisplayDocTitle true >>"));
    root.set("/PageLayout", Object::name("/SinglePage"));
    Object tree = dictionary("<< /Type /StructTreeRoot >>");
    tree.set("/K", structure_);
    Object numbers = dictionary("<< >>");
    numbers.set("/Nums", page_elements_);
    tree.set("/ParentTree", numbers);
    tree.set("/ParentTreeNextKey", Object::integer(static_cast<int>(pages_.size())));
    structure_.set("/P", tree);
    root.set("/StructTreeRoot", tree);
    Object info = dictionary("<< >>");
    info.set("/Title", Object::text(deck_.title));
    if (!deck_.author.empty()) info.set("/Author", Object::text(deck_.author));
    info.set("/Creator", Object::text(program_name_and_version()));
    pdf_.trailer().set("/Info", info);
  }

  Object outline_item(const std::string& title, std::size_t slide) {
    Object item = dictionary("<< >>");
    item.set("/Title", Object::text(title));
    item.set("/Dest", Object::array({pages_[slide], Object::name("/Fit")}));
    return item;
  }

  /// Links the items of one level below `parent`; `open`: they are seen at first.
  static void link(Object& parent, std::vector<Object>& items, bool open) {
    if (items.empty()) return;
    for (std::size_t i = 0; i < items.size(); ++i) {
      items[i].set("/Parent", parent);
      if (i > 0) items[i].set("/Prev", items[i - 1]);
      if (i + 1 < items.size()) items[i].set("/Next", items[i + 1]);
    }
    parent.set("/First", items.front());
    parent.set("/Last", items.back());
    const auto count = static_cast<int>(items.size());
    parent.set("/Count", Object::integer(open ? count : -count));
  }

  void add_outline() {
    Object outline = dictionary("<< /Type /Outlines >>");
    std::vector<Object> stages;
    const std::vector<DeckSlide>& slides = deck_.slides;
    for (std::size_t begin = 0, end = 0; begin < slides.size(); begin = end) {
      while (end < slides.size() && slides[end].stage == slides[begin].stage) ++end;
      Object stage = outline_item(fmt::format("{}. {}", slides[begin].stage, slides[begin].title), begin);
      std::vector<Object> parts;
      for (std::size_t i = begin; end - begin > 1 && i < end; ++i)
        parts.push_back(outline_item(slides[i].part, i));
      link(stage, parts, false);
      stages.push_back(stage);
    }
    link(outline, stages, true);
    pdf_.root().set("/Outlines", outline);
    pdf_.root().set("/PageMode", Object::name("/UseOutlines"));
  }

  const Deck& deck_;
  const DeckProgress& go_on_;
  PdfTextLayer layer_;
  PdfFile pdf_;
  Object fonts_, structure_, page_elements_;
  std::vector<Object> pages_;
};

}  // namespace

Status append_pdf_deck(const Deck& deck, const AppendBytes& append, const DeckProgress& go_on) try {
  Deck handed_out = deck;
  for (DeckSlide& slide : handed_out.slides)
    std::erase_if(slide.notes, [](const StepNote& note) { return note.kind == StepNote::Kind::to_say; });
  PdfDeck(handed_out, go_on).write(append);
  return success();
} catch (const std::exception& error) {
  return failure(error.what());
}

}  // namespace polhode
