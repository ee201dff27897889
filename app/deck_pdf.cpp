// SPDX-License-Identifier: MIT
// The PDF deck. qpdf writes the objects; what is in them is here: pages with a picture each, the words of the
// slide as invisible text on top, an outline by stage, and the structure that readers of the file for the
// blind follow: a figure with its alternative text, then paragraphs.
#include "app/deck.h"
#include "app/deck_picture.h"
#include "app/pdf_text_layer.h"
#include "app/picture_metadata.h"
#include "render/image/png.h"

#include <fmt/format.h>

#include <algorithm>
#include <qpdf/Pipeline.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFPageObjectHelper.hh>
#include <qpdf/QPDFWriter.hh>
#include <stdexcept>

namespace polhode {

namespace {

using Object = QPDFObjectHandle;

constexpr double kPointsPerInch = 72;
/// Some viewers round a picture's edges outwards, and would stretch it by a pixel at its own resolution.
constexpr double kInset_pt = 0.001;

/// qpdf reports by exceptions, and so does what it calls; they end in append_pdf_deck.
template <class T>
T or_throw(Result<T>&& result) {
  if (!result) throw std::runtime_error(result.error());
  return std::move(result).value();
}

/// Where qpdf writes.
class AppendPipeline final : public Pipeline {
 public:
  explicit AppendPipeline(const AppendBytes& append) : Pipeline("deck", nullptr), append_(append) {}
  void write(const unsigned char* data, std::size_t count) override { or_throw(append_({data, count})); }
  void finish() override {}

 private:
  const AppendBytes& append_;
};

Object number(double value) { return Object::newReal(value, 4); }

Object text(const std::string& utf8) { return Object::newUnicodeString(utf8); }

/// PDF's Flate streams know PNG's filters: pixels without alpha are taken over as they are stored.
bool fits_as_stored(const PngChunks& png) {
  const auto transparent = [](const PngChunk& chunk) { return chunk.type == "tRNS"; };
  return !png.header.interlaced && png.header.bit_depth <= 8 && png.header.color_type <= 3 &&
         std::none_of(png.chunks.begin(), png.chunks.end(), transparent);
}

Object stored_colors(const PngChunks& png) {
  if (png.header.color_type == 0) return Object::newName("/DeviceGray");
  if (png.header.color_type == 2) return Object::newName("/DeviceRGB");
  for (const PngChunk& chunk : png.chunks)
    if (chunk.type == "PLTE") {
      const std::string palette(chunk.data.begin(), chunk.data.end());
      return Object::newArray({Object::newName("/Indexed"), Object::newName("/DeviceRGB"),
                               Object::newInteger(static_cast<int>(palette.size() / 3) - 1),
                               Object::newString(palette)});
    }
  throw std::runtime_error("a PNG with a palette has none");
}

void describe_image(Object& image, Size size, int bits, const Object& colors) {
  Object dictionary = image.getDict();
  dictionary.replaceKey("/Type", Object::newName("/XObject"));
  dictionary.replaceKey("/Subtype", Object::newName("/Image"));
  dictionary.replaceKey("/Width", Object::newInteger(size.width));
  dictionary.replaceKey("/Height", Object::newInteger(size.height));
  dictionary.replaceKey("/BitsPerComponent", Object::newInteger(bits));
  dictionary.replaceKey("/ColorSpace", colors);
}

/// The file is read again when its turn comes: one picture is in memory at a time.
Object stored_image(QPDF& pdf, const std::filesystem::path& file, const PngChunks& png,
                    const std::function<void()>& begin) {
  Object image = Object::newStream(&pdf);
  describe_image(image, png.header.size, png.header.bit_depth, stored_colors(png));
  const Object parameters = Object::parse(
      fmt::format("<< /Predictor 15 /Colors {} /BitsPerComponent {} /Columns {} >>",
                  png.header.color_type == 2 ? 3 : 1, png.header.bit_depth, png.header.size.width));
  image.replaceStreamData(
      [file, begin](Pipeline* out) {
        begin();
        const DeckPicture picture = or_throw(read_deck_picture(file));
        for (const PngChunk& chunk : picture.png.chunks)
          if (chunk.type == "IDAT") out->write(chunk.data.data(), chunk.data.size());
        out->finish();
      },
      Object::newName("/FlateDecode"), parameters);
  return image;
}

/// `count` of each pixel's four bytes, from number `first` on.
Object decoded_image(QPDF& pdf, const std::filesystem::path& file, Size size, std::size_t first,
                     std::size_t count, const std::function<void()>& begin) {
  Object image = Object::newStream(&pdf);
  describe_image(image, size, 8, Object::newName(count == 3 ? "/DeviceRGB" : "/DeviceGray"));
  image.replaceStreamData(
      [file, first, count, begin](Pipeline* out) {
        begin();
        const PngFile png = or_throw(read_png(file));
        std::vector<std::uint8_t> row(static_cast<std::size_t>(png.image.size.width) * count);
        for (int y = 0; y < png.image.size.height; ++y) {
          const std::uint8_t* pixel = png.image.pixel(0, y);
          for (std::size_t i = 0; i < row.size(); ++i) row[i] = pixel[i / count * 4 + first + i % count];
          out->write(row.data(), row.size());
        }
        out->finish();
      },
      Object::newNull(), Object::newNull());
  return image;
}

/// `begin` is called when its bytes are asked for.
Object image_of(QPDF& pdf, const std::filesystem::path& file, const PngChunks& png,
                const std::function<void()>& begin) {
  if (fits_as_stored(png)) return stored_image(pdf, file, png, begin);
  Object image = decoded_image(pdf, file, png.header.size, 0, 3, begin);
  image.getDict().replaceKey("/SMask", decoded_image(pdf, file, png.header.size, 3, 1, begin));
  return image;
}

class PdfDeck {
 public:
  PdfDeck(const Deck& deck, const DeckProgress& go_on) : deck_(deck), go_on_(go_on), layer_(deck) {
    pdf_.emptyPDF();
    fonts_ = layer_.make_fonts(pdf_);
    structure_ = dictionary("<< /Type /StructElem /S /Document >>");
    structure_.replaceKey("/K", Object::newArray());
    page_elements_ = Object::newArray();
    for (const DeckSlide& slide : deck.slides) add(slide);
    describe_document();
    add_outline();
  }

  void write(const AppendBytes& append) {
    AppendPipeline out(append);
    QPDFWriter writer(pdf_);
    writer.setOutputPipeline(&out);
    writer.setDeterministicID(true);
    writer.setCompressStreams(true);
    writer.setDecodeLevel(qpdf_dl_none);
    writer.setObjectStreamMode(qpdf_o_generate);
    writer.write();
  }

 private:
  Object dictionary(const std::string& pdf_text) {
    return pdf_.makeIndirectObject(Object::parse(&pdf_, pdf_text));
  }

  void add(const DeckSlide& slide) {
    const DeckPicture picture = or_throw(read_deck_picture(slide.png));
    const PaperSize paper = paper_size(picture.png.header.size, deck_.dpi);
    const double width = paper.width_in * kPointsPerInch, height = paper.height_in * kPointsPerInch;
    Object page = dictionary("<< /Type /Page /Tabs /S /Resources << /XObject << >> >> >>");
    page.replaceKey("/MediaBox", Object::newArray({Object::newInteger(0), Object::newInteger(0),
                                                   number(width), number(height)}));
    Object resources = page.getKey("/Resources");
    resources.getKey("/XObject")
        .replaceKey("/Slide", image_of(pdf_, slide.png, picture.png, [this, number = pages_.size()] {
                      if (go_on_ && !go_on_(number)) throw std::runtime_error(kDeckStopped);
                    }));
    resources.replaceKey("/Font", fonts_);
    const std::string content =
        fmt::format("/Figure << /MCID 0 >> BDC\nq {0:.4f} 0 0 {1:.4f} {2} {2} cm /Slide Do Q\nEMC\n",
                    width - 2 * kInset_pt, height - 2 * kInset_pt, kInset_pt) +
        layer_.content(slide, width, height, 1);
    page.replaceKey("/Contents", Object::newStream(&pdf_, content));
    page.replaceKey("/StructParents", Object::newInteger(page_elements_.getArrayNItems() / 2));
    add_structure(slide, page, width, height);
    QPDFPageDocumentHelper(pdf_).addPage(QPDFPageObjectHelper(page), false);
    pages_.push_back(page);
  }

  /// An element of a page for its marked content `id`.
  Object element(const char* type, Object& page, int id) {
    Object made = dictionary(fmt::format("<< /Type /StructElem /S /{} /K {} >>", type, id));
    made.replaceKey("/P", structure_);
    made.replaceKey("/Pg", page);
    structure_.getKey("/K").appendItem(made);
    return made;
  }

  void add_structure(const DeckSlide& slide, Object& page, double width, double height) {
    Object elements = Object::newArray();
    Object figure = element("Figure", page, 0);
    figure.replaceKey("/Alt", text(slide.alt));
    Object layout = Object::parse("<< /O /Layout /Placement /Block >>");
    layout.replaceKey("/BBox", Object::newArray({Object::newInteger(0), Object::newInteger(0), number(width),
                                                 number(height)}));
    figure.replaceKey("/A", layout);
    elements.appendItem(figure);
    elements.appendItem(element("H1", page, 1));
    for (std::size_t i = 0; i < slide.notes.size(); ++i)
      elements.appendItem(element("P", page, static_cast<int>(i) + 2));
    page_elements_.appendItem(Object::newInteger(page_elements_.getArrayNItems() / 2));
    page_elements_.appendItem(pdf_.makeIndirectObject(elements));
  }

  void describe_document() {
    Object root = pdf_.getRoot();
    root.replaceKey("/Lang", text(deck_.language));
    root.replaceKey("/MarkInfo", Object::parse("<< /Marked true >>"));
    root.replaceKey("/ViewerPreferences", Object::parse("<< /DisplayDocTitle true >>"));
    root.replaceKey("/PageLayout", Object::newName("/SinglePage"));
    Object tree = dictionary("<< /Type /StructTreeRoot >>");
    tree.replaceKey("/K", structure_);
    Object numbers = dictionary("<< >>");
    numbers.replaceKey("/Nums", page_elements_);
    tree.replaceKey("/ParentTree", numbers);
    tree.replaceKey("/ParentTreeNextKey", Object::newInteger(static_cast<int>(pages_.size())));
    structure_.replaceKey("/P", tree);
    root.replaceKey("/StructTreeRoot", tree);
    Object info = dictionary("<< >>");
    info.replaceKey("/Title", text(deck_.title));
    info.replaceKey("/Creator", text(program_name_and_version()));
    pdf_.getTrailer().replaceKey("/Info", info);
  }

  Object outline_item(const std::string& title, std::size_t slide) {
    Object item = dictionary("<< >>");
    item.replaceKey("/Title", text(title));
    item.replaceKey("/Dest", Object::newArray({pages_[slide], Object::newName("/Fit")}));
    return item;
  }

  /// Links the items of one level below `parent`; `open`: they are seen at first.
  static void link(Object& parent, std::vector<Object>& items, bool open) {
    if (items.empty()) return;
    for (std::size_t i = 0; i < items.size(); ++i) {
      items[i].replaceKey("/Parent", parent);
      if (i > 0) items[i].replaceKey("/Prev", items[i - 1]);
      if (i + 1 < items.size()) items[i].replaceKey("/Next", items[i + 1]);
    }
    parent.replaceKey("/First", items.front());
    parent.replaceKey("/Last", items.back());
    const auto count = static_cast<int>(items.size());
    parent.replaceKey("/Count", Object::newInteger(open ? count : -count));
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
    pdf_.getRoot().replaceKey("/Outlines", outline);
    pdf_.getRoot().replaceKey("/PageMode", Object::newName("/UseOutlines"));
  }

  const Deck& deck_;
  const DeckProgress& go_on_;
  PdfTextLayer layer_;
  QPDF pdf_;
  Object fonts_, structure_, page_elements_;
  std::vector<Object> pages_;
};

}  // namespace

Status append_pdf_deck(const Deck& deck, const AppendBytes& append, const DeckProgress& go_on) try {
  PdfDeck(deck, go_on).write(append);
  return success();
} catch (const std::exception& error) {
  return failure(error.what());
}

}  // namespace polhode
