// SPDX-License-Identifier: MIT
// The deck for programs of presentations: Office Open XML (ECMA-376), a zip of parts of XML. A slide is its
// picture with its alternative text; its title is text of its own, by which such programs list slides and
// read them aloud. What is said stands in its notes, and stages are sections.
#include "app/export/picture_metadata.h"
#include "app/publish/deck.h"
#include "app/publish/deck_picture.h"
#include "app/publish/html_frame.h"
#include "app/publish/pptx_assets.h"
#include "app/publish/zip_file.h"
#include "base/markup.h"
#include "base/sha256.h"
#include "base/words/page_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>

namespace polhode {

namespace {

/// Lengths are in English metric units.
using Emu = std::int64_t;
constexpr Emu kEmuPerInch = 914'400;
/// A hundredth of a millimetre.
constexpr Emu kEmuStep = 360;
/// What a slide may measure.
constexpr double kLeastSide_in = 1, kMostSide_in = 56;
constexpr double kWide = 16.0 / 9;
/// The number of the first slide; less is reserved.
constexpr std::size_t kFirstSlideId = 256;

constexpr const char* kHead = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";
constexpr const char* kNamespaces =
    "xmlns:a=\"http://schemas.openxmlformats.org/drawingml/2006/main\" "
    "xmlns:r=\"http://schemas.openxmlformats.org/officeDocument/2006/relationships\" "
    "xmlns:p=\"http://schemas.openxmlformats.org/presentationml/2006/main\"";
constexpr const char* kGroup =
    "<p:nvGrpSpPr><p:cNvPr id=\"1\" name=\"\"/><p:cNvGrpSpPr/><p:nvPr/></p:nvGrpSpPr>\n<p:grpSpPr/>\n";
constexpr const char* kColorsOfMaster = "<p:clrMapOvr><a:masterClrMapping/></p:clrMapOvr>\n";

Emu emu(double inches) { return std::llround(inches * static_cast<double>(kEmuPerInch)); }

struct Box {
  Emu x = 0, y = 0, width = 0, height = 0;
};

/// What a picture's file says of its pixels.
struct PictureFacts {
  Size size;
  bool has_alpha = false;
};

Result<std::vector<PictureFacts>> facts_of_pictures(const Deck& deck) {
  std::vector<PictureFacts> all;
  for (const DeckSlide& slide : deck.slides) {
    const Result<DeckPicture> picture = read_deck_picture(slide.png);
    if (!picture) return failure(picture.error());
    constexpr int kAlpha = 4;  // bit of a PNG's colour type
    all.push_back({picture->png.header.size, (picture->png.header.color_type & kAlpha) != 0});
  }
  return all;
}

/// Where things lie on the slides. Pictures of one size are slides as they are: they hide the title, which is
/// in most of them. Others, such as equations, stand below it, all at one scale.
struct SlideLayout {
  Emu width = 0, height = 0;
  Box title;
  bool fills = true;
  double emu_per_px = 1;

  explicit SlideLayout(const Deck& deck, const std::vector<PictureFacts>& pictures) {
    PaperSize paper{kDeckSide_in * kWide, kDeckSide_in};
    fills = !pictures.empty() && std::all_of(pictures.begin(), pictures.end(), [&](const PictureFacts& one) {
      return one.size == pictures.front().size && !one.has_alpha;
    });
    if (fills) paper = paper_size(pictures.front().size, deck.dpi);
    // A picture that is too long for a slide in both ways at once lies in a wider one.
    const double longer = std::max(paper.width_in, paper.height_in);
    const double shorter = std::min(paper.width_in, paper.height_in);
    const double factor = std::min(std::max(1.0, kLeastSide_in / shorter), kMostSide_in / longer);
    const auto side = [&](double inches) {
      return emu(std::max(kLeastSide_in, inches * factor)) / kEmuStep * kEmuStep;
    };
    width = side(paper.width_in);
    height = side(paper.height_in);
    title = {width / 20, height / 20, width - width / 10, height / 8};
    emu_per_px = scale_of(deck, pictures);
  }

  /// LibreOffice counts in kEmuStep, makes a picture a step less wide and high than it says, and puts it a
  /// step higher: a step below the upper edge it lies in the corner of the slide, to the pixel, and the strip
  /// that is left has the colour of the paper. Nothing may stand out: Poppler rounds the edges of a picture
  /// outwards, and would stretch it by a pixel.
  Box place(Size picture) const {
    const Emu w = std::llround(picture.width * emu_per_px), h = std::llround(picture.height * emu_per_px);
    if (fills) return {0, kEmuStep, width, height};
    const Emu top = title.y + title.height;
    return {(width - w) / 2, top + (height - top - h) / 2, w, h};
  }

 private:
  double scale_of(const Deck& deck, const std::vector<PictureFacts>& pictures) const {
    // Below a title there is a margin, and type of 12 pt grows to 36 pt at most.
    const double margin = fills ? 0 : static_cast<double>(title.x);
    const double top = fills ? 0 : static_cast<double>(title.y + title.height);
    double scale = fills || deck.dpi <= 0 ? std::numeric_limits<double>::infinity()
                                          : 3.0 * static_cast<double>(kEmuPerInch) / deck.dpi;
    for (const PictureFacts& picture : pictures)
      scale = std::min({scale, (static_cast<double>(width) - 2 * margin) / picture.size.width,
                        (static_cast<double>(height) - top - margin) / picture.size.height});
    return scale;
  }
};

/// Programs that list slides by their titles need each to have its own.
std::vector<std::string> titles_of(const Deck& deck) {
  std::vector<std::string> titles;
  std::set<std::string> taken;
  for (const DeckSlide& slide : deck.slides) {
    const std::string name = name_of(slide);
    std::string title = name;
    for (int number = 2; !taken.insert(title).second; ++number) title = fmt::format("{} ({})", name, number);
    titles.push_back(std::move(title));
  }
  return titles;
}

/// "{8-4-4-4-12 digits}", of the name alone: a version 8 UUID (RFC 9562), whose bits are ours to choose.
std::string guid_of(std::string_view name) {
  std::string digits = sha256_hex(name).substr(0, 32);
  digits[12] = '8';
  digits[16] = '8';
  for (char& c : digits)
    if (c >= 'a' && c <= 'f') c = static_cast<char>(c - 'a' + 'A');
  return fmt::format("{{{}-{}-{}-{}-{}}}", digits.substr(0, 8), digits.substr(8, 4), digits.substr(12, 4),
                     digits.substr(16, 4), digits.substr(20));
}

struct Relation {
  const char* type;
  std::string target;
};

/// Number i from 1 is rId<i>.
std::string relations_xml(const std::vector<Relation>& relations) {
  std::string xml = kHead;
  xml += "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n";
  for (std::size_t i = 0; i < relations.size(); ++i) {
    const bool is_of_package = std::string_view(relations[i].type).starts_with("metadata/");
    xml += fmt::format(
        "<Relationship Id=\"rId{}\" Type=\"http://schemas.openxmlformats.org/{}/2006/"
        "relationships/{}\" Target=\"{}\"/>\n",
        i + 1, is_of_package ? "package" : "officeDocument", relations[i].type, relations[i].target);
  }
  return xml + "</Relationships>\n";
}

std::map<std::string, std::string> color_texts(Theme theme) {
  const PageColors& colors = colors_of(theme);
  std::map<std::string, std::string> texts;
  for (const auto& [name, color] :
       {std::pair{"ink", colors.ink}, std::pair{"paper", colors.paper}, std::pair{"quiet", colors.quiet},
        std::pair{"panel", colors.panel}, std::pair{"accent", colors.accent}, std::pair{"said", colors.said},
        std::pair{"meant", colors.meant}, std::pair{"question", colors.question},
        std::pair{"line", colors.line}})
    texts.emplace(name, hex(color).substr(1));
  return texts;
}

class PptxDeck {
 public:
  PptxDeck(const Deck& deck, const std::vector<PictureFacts>& pictures, const AppendBytes& append)
      : deck_(deck),
        pictures_(pictures),
        layout_(deck, pictures),
        titles_(titles_of(deck)),
        language_(tag_of(deck.language)),
        zip_(append) {}

  Status write(const DeckProgress& go_on) {
    add("[Content_Types].xml", content_types());
    add("_rels/.rels", relations_xml({{"officeDocument", "ppt/presentation.xml"},
                                      {"metadata/core-properties", "docProps/core.xml"},
                                      {"extended-properties", "docProps/app.xml"}}));
    add_properties();
    add_presentation();
    add_masters();
    for (std::size_t i = 0; status_ && i < deck_.slides.size(); ++i) {
      if (!go_on(i)) return failure("stopped");
      add_slide(i);
    }
    return status_ ? zip_.finish() : status_;
  }

 private:
  void add(const std::string& name, const std::string& text) {
    if (status_) status_ = zip_.add(name, text);
  }

  std::string content_types() const {
    constexpr const char* kPresentation = "presentationml.";
    std::string xml = kHead;
    xml +=
        "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
        "<Default Extension=\"rels\" "
        "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
        "<Default Extension=\"xml\" ContentType=\"application/xml\"/>\n"
        "<Default Extension=\"png\" ContentType=\"image/png\"/>\n"
        "<Override PartName=\"/docProps/core.xml\" "
        "ContentType=\"application/vnd.openxmlformats-package.core-properties+xml\"/>\n";
    const auto part = [&](const std::string& name, const std::string& type) {
      xml += fmt::format(
          "<Override PartName=\"/{}\" "
          "ContentType=\"application/vnd.openxmlformats-officedocument.{}+xml\"/>\n",
          name, type);
    };
    part("docProps/app.xml", "extended-properties");
    part("ppt/presentation.xml", kPresentation + std::string("presentation.main"));
    part("ppt/theme/theme1.xml", "theme");
    part("ppt/theme/theme2.xml", "theme");
    part("ppt/slideMasters/slideMaster1.xml", kPresentation + std::string("slideMaster"));
    part("ppt/slideLayouts/slideLayout1.xml", kPresentation + std::string("slideLayout"));
    part("ppt/notesMasters/notesMaster1.xml", kPresentation + std::string("notesMaster"));
    for (std::size_t i = 1; i <= deck_.slides.size(); ++i) {
      part(fmt::format("ppt/slides/slide{}.xml", i), kPresentation + std::string("slide"));
      part(fmt::format("ppt/notesSlides/notesSlide{}.xml", i), kPresentation + std::string("notesSlide"));
    }
    return xml + "</Types>\n";
  }

  void add_properties() {
    add("docProps/core.xml",
        fmt::format(
            "{}<cp:coreProperties "
            "xmlns:cp=\"http://schemas.openxmlformats.org/package/2006/metadata/core-properties\" "
            "xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n<dc:title>{}</dc:title>\n{}"
            "<dc:language>{}</dc:language>\n</cp:coreProperties>\n",
            kHead, escaped(deck_.title),
            deck_.author.empty() ? "" : fmt::format("<dc:creator>{}</dc:creator>\n", escaped(deck_.author)),
            language_));
    add("docProps/app.xml",
        fmt::format("{}<Properties "
                    "xmlns=\"http://schemas.openxmlformats.org/officeDocument/2006/extended-properties\">\n"
                    "<Slides>{}</Slides>\n<Application>{}</Application>\n</Properties>\n",
                    kHead, deck_.slides.size(), escaped(program_name_and_version())));
  }

  void add_presentation() {
    std::vector<Relation> relations = {{"slideMaster", "slideMasters/slideMaster1.xml"},
                                       {"notesMaster", "notesMasters/notesMaster1.xml"},
                                       {"theme", "theme/theme1.xml"}};
    std::string slides;
    for (std::size_t i = 0; i < deck_.slides.size(); ++i) {
      relations.push_back({"slide", fmt::format("slides/slide{}.xml", i + 1)});
      slides += fmt::format("<p:sldId id=\"{}\" r:id=\"rId{}\"/>\n", kFirstSlideId + i, relations.size());
    }
    if (!slides.empty()) slides = "<p:sldIdLst>\n" + slides + "</p:sldIdLst>\n";
    add("ppt/presentation.xml",
        fmt::format("{}<p:presentation {}>\n"
                    "<p:sldMasterIdLst><p:sldMasterId id=\"2147483648\" r:id=\"rId1\"/></p:sldMasterIdLst>\n"
                    "<p:notesMasterIdLst><p:notesMasterId r:id=\"rId2\"/></p:notesMasterIdLst>\n{}"
                    "<p:sldSz cx=\"{}\" cy=\"{}\"/>\n<p:notesSz cx=\"{}\" cy=\"{}\"/>\n{}"
                    "</p:presentation>\n",
                    kHead, kNamespaces, slides, layout_.width, layout_.height, kNotesWidth, kNotesHeight,
                    sections()));
    add("ppt/_rels/presentation.xml.rels", relations_xml(relations));
  }

  /// Programs from before sections pass over them.
  std::string sections() const {
    std::string all;
    const std::vector<DeckSlide>& slides = deck_.slides;
    for (std::size_t begin = 0, end = 0; begin < slides.size(); begin = end) {
      std::string ids;
      for (; end < slides.size() && slides[end].stage == slides[begin].stage; ++end)
        ids += fmt::format("<p14:sldId id=\"{}\"/>", kFirstSlideId + end);
      const std::string name = fmt::format("{}. {}", slides[begin].stage, slides[begin].title);
      all += fmt::format("<p14:section name=\"{}\" id=\"{}\"><p14:sldIdLst>{}</p14:sldIdLst></p14:section>\n",
                         escaped(name), guid_of(fmt::format("{} {}", begin, name)), ids);
    }
    if (all.empty()) return all;
    return "<p:extLst><p:ext uri=\"{521415D9-36F7-43E2-AB2F-B90AF26B5E84}\">\n<p14:sectionLst "
           "xmlns:p14=\"http://schemas.microsoft.com/office/powerpoint/2010/main\">\n" +
           all + "</p14:sectionLst>\n</p:ext></p:extLst>\n";
  }

  void add_masters() {
    const auto text = [](Emu length) { return fmt::format("{}", length); };
    std::map<std::string, std::string> texts = {{"language", language_},
                                                {"title_x", text(layout_.title.x)},
                                                {"title_y", text(layout_.title.y)},
                                                {"title_width", text(layout_.title.width)},
                                                {"title_height", text(layout_.title.height)}};
    const double scale =
        std::min(6.0 * static_cast<double>(kEmuPerInch) / static_cast<double>(layout_.width),
                 3.375 * static_cast<double>(kEmuPerInch) / static_cast<double>(layout_.height));
    const Emu width = std::llround(static_cast<double>(layout_.width) * scale);
    texts.emplace("slide_width", text(width));
    texts.emplace("slide_height", text(std::llround(static_cast<double>(layout_.height) * scale)));
    texts.emplace("slide_x", text((kNotesWidth - width) / 2));
    add("ppt/theme/theme1.xml", filled_frame(pptx_assets::kThemeXml, color_texts(deck_.theme)));
    add("ppt/theme/theme2.xml", filled_frame(pptx_assets::kThemeXml, color_texts(Theme::paper)));
    add("ppt/slideMasters/slideMaster1.xml", filled_frame(pptx_assets::kMasterXml, texts));
    add("ppt/slideMasters/_rels/slideMaster1.xml.rels",
        relations_xml(
            {{"slideLayout", "../slideLayouts/slideLayout1.xml"}, {"theme", "../theme/theme1.xml"}}));
    add("ppt/slideLayouts/slideLayout1.xml", filled_frame(pptx_assets::kLayoutXml, texts));
    add("ppt/slideLayouts/_rels/slideLayout1.xml.rels",
        relations_xml({{"slideMaster", "../slideMasters/slideMaster1.xml"}}));
    add("ppt/notesMasters/notesMaster1.xml", filled_frame(pptx_assets::kNotesXml, texts));
    add("ppt/notesMasters/_rels/notesMaster1.xml.rels", relations_xml({{"theme", "../theme/theme2.xml"}}));
  }

  void add_slide(std::size_t i) {
    const std::size_t number = i + 1;
    const DeckSlide& slide = deck_.slides[i];
    const Result<DeckPicture> picture = read_deck_picture(slide.png);
    if (!picture) {
      status_ = failure(picture.error());
      return;
    }
    const std::string file = fmt::format("ppt/media/slide{}.png", number);
    if (status_) status_ = zip_.add(file, picture->bytes);
    add(fmt::format("ppt/slides/slide{}.xml", number), slide_xml(i));
    add(fmt::format("ppt/slides/_rels/slide{}.xml.rels", number),
        relations_xml({{"slideLayout", "../slideLayouts/slideLayout1.xml"},
                       {"image", fmt::format("../media/slide{}.png", number)},
                       {"notesSlide", fmt::format("../notesSlides/notesSlide{}.xml", number)}}));
    add(fmt::format("ppt/notesSlides/notesSlide{}.xml", number), notes_xml(slide));
    add(fmt::format("ppt/notesSlides/_rels/notesSlide{}.xml.rels", number),
        relations_xml({{"notesMaster", "../notesMasters/notesMaster1.xml"},
                       {"slide", fmt::format("../slides/slide{}.xml", number)}}));
  }

  /// The title comes first, for who listens; where pictures fill the slides it lies behind them.
  std::string slide_xml(std::size_t i) const {
    const Box at = layout_.place(pictures_[i].size);
    return fmt::format(
        "{}<p:sld {}>\n<p:cSld>\n<p:spTree>\n{}"
        "<p:sp>\n<p:nvSpPr><p:cNvPr id=\"2\" name=\"Title\"/><p:cNvSpPr><a:spLocks "
        "noGrp=\"1\"/></p:cNvSpPr><p:nvPr><p:ph type=\"title\"/></p:nvPr></p:nvSpPr>\n<p:spPr/>\n"
        "<p:txBody><a:bodyPr/><a:lstStyle/><a:p>{}</a:p></p:txBody>\n</p:sp>\n"
        "<p:pic>\n<p:nvPicPr><p:cNvPr id=\"3\" name=\"Picture\" descr=\"{}\"/><p:cNvPicPr><a:picLocks "
        "noChangeAspect=\"1\"/></p:cNvPicPr><p:nvPr/></p:nvPicPr>\n"
        "<p:blipFill><a:blip r:embed=\"rId2\"/><a:stretch><a:fillRect/></a:stretch></p:blipFill>\n"
        "<p:spPr><a:xfrm><a:off x=\"{}\" y=\"{}\"/><a:ext cx=\"{}\" cy=\"{}\"/></a:xfrm>"
        "<a:prstGeom prst=\"rect\"><a:avLst/></a:prstGeom></p:spPr>\n</p:pic>\n"
        "</p:spTree>\n</p:cSld>\n{}</p:sld>\n",
        kHead, kNamespaces, kGroup, run(titles_[i], ""), escaped(deck_.slides[i].alt), at.x, at.y, at.width,
        at.height, kColorsOfMaster);
  }

  std::string run(std::string_view text, const char* look) const {
    return fmt::format("<a:r><a:rPr lang=\"{}\"{}/><a:t>{}</a:t></a:r>", language_, look, escaped(text));
  }

  /// The text, each address of the web behind the words that lead there. Nothing in notes can be clicked
  /// while one speaks.
  static std::string with_addresses(const StepNote& note) {
    std::string text;
    std::size_t at = 0;
    for (const NoteLink& link : note.links) {
      text += note.text.substr(at, link.end - at);
      at = link.end;
      const bool is_told = note.text.compare(link.begin, link.end - link.begin, link.to) == 0;
      if (!link.to.starts_with('#') && !is_told) text += " (" + link.to + ')';
    }
    return text + note.text.substr(at);
  }

  std::string notes_xml(const DeckSlide& slide) const {
    std::string paragraphs;
    for (const StepNote& note : slide.notes) {
      const char* look = note.kind == StepNote::Kind::to_say     ? " b=\"1\""
                         : note.kind == StepNote::Kind::equation ? " i=\"1\""
                                                                 : "";
      paragraphs += "<a:p>" + run(with_addresses(note), look) + "</a:p>\n";
    }
    if (paragraphs.empty())
      paragraphs = "<a:p>" + run(std::string(words::kNoNotes.in(deck_.language)), "") + "</a:p>\n";
    return fmt::format(
        "{}<p:notes {}>\n<p:cSld>\n<p:spTree>\n{}"
        "<p:sp>\n<p:nvSpPr><p:cNvPr id=\"2\" name=\"Slide\"/><p:cNvSpPr><a:spLocks noGrp=\"1\" noRot=\"1\" "
        "noChangeAspect=\"1\"/></p:cNvSpPr><p:nvPr><p:ph type=\"sldImg\" idx=\"2\"/></p:nvPr></p:nvSpPr>\n"
        "<p:spPr/>\n</p:sp>\n"
        "<p:sp>\n<p:nvSpPr><p:cNvPr id=\"3\" name=\"Notes\"/><p:cNvSpPr><a:spLocks "
        "noGrp=\"1\"/></p:cNvSpPr><p:nvPr><p:ph type=\"body\" sz=\"quarter\" "
        "idx=\"3\"/></p:nvPr></p:nvSpPr>\n<p:spPr/>\n"
        "<p:txBody><a:bodyPr/><a:lstStyle/>\n{}</p:txBody>\n</p:sp>\n</p:spTree>\n</p:cSld>\n{}</p:notes>\n",
        kHead, kNamespaces, kGroup, paragraphs, kColorsOfMaster);
  }

  static constexpr Emu kNotesWidth = 6'858'000, kNotesHeight = 9'144'000;  // 7.5 x 10 in

  const Deck& deck_;
  const std::vector<PictureFacts>& pictures_;
  SlideLayout layout_;
  std::vector<std::string> titles_;
  std::string language_;
  ZipFile zip_;
  Status status_ = success();
};

}  // namespace

Status append_pptx_deck(const Deck& deck, const AppendBytes& append, const DeckProgress& go_on) try {
  const Result<std::vector<PictureFacts>> pictures = facts_of_pictures(deck);
  if (!pictures) return failure(pictures.error());
  return PptxDeck(deck, *pictures, append).write(go_on);
} catch (const std::exception& error) {  // no memory
  return failure(error.what());
}

}  // namespace polhode
