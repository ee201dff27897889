// SPDX-License-Identifier: MIT
// PPTX decks: their parts, and what another program of presentations makes of them.
#include "app/publish/deck.h"
#include "render/image/png.h"
#include "tests/app/publish/example_deck.h"
#include "tests/support/xml.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

namespace polhode {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

using Parts = std::map<std::string, std::string>;

/// What an archive holds, read to its last byte.
Parts parts_of(const std::string& bytes) {
  Parts parts;
  archive* const zip = archive_read_new();
  archive_read_support_format_zip(zip);
  EXPECT_EQ(archive_read_open_memory(zip, bytes.data(), bytes.size()), ARCHIVE_OK);
  archive_entry* entry = nullptr;
  int state = ARCHIVE_OK;
  while ((state = archive_read_next_header(zip, &entry)) == ARCHIVE_OK) {
    std::string& part = parts[archive_entry_pathname(entry)];
    EXPECT_TRUE(part.empty()) << archive_entry_pathname(entry) << " twice";
    std::array<char, 4096> piece{};
    la_ssize_t count = 0;
    while ((count = archive_read_data(zip, piece.data(), piece.size())) > 0)
      part.append(piece.data(), static_cast<std::size_t>(count));
    EXPECT_EQ(count, 0) << archive_error_string(zip);
  }
  EXPECT_EQ(state, ARCHIVE_EOF) << archive_error_string(zip);
  archive_read_free(zip);
  return parts;
}

Parts parts_of(const Deck& deck) { return parts_of(written(deck, DeckKind::pptx)); }

test::XmlNode part(const Parts& parts, const std::string& name) {
  const auto found = parts.find(name);
  EXPECT_NE(found, parts.end()) << name;
  return found == parts.end() ? test::XmlNode{} : test::read_xml(found->second);
}

/// The text of every paragraph.
std::vector<std::string> paragraphs_of(const test::XmlNode& root) {
  std::vector<std::string> all;
  for (const test::XmlNode* paragraph : test::all_named(root, "a:p")) {
    std::string text;
    for (const test::XmlNode* piece : test::all_named(*paragraph, "a:t"))
      for (const test::XmlNode& child : piece->children) text += child.text;
    all.push_back(text);
  }
  return all;
}

std::string title_of(const Parts& parts, int slide) {
  return paragraphs_of(part(parts, fmt::format("ppt/slides/slide{}.xml", slide))).at(0);
}
std::vector<std::string> notes_of(const Parts& parts, int slide) {
  return paragraphs_of(part(parts, fmt::format("ppt/notesSlides/notesSlide{}.xml", slide)));
}

TEST(DeckPptx, EveryPartIsXmlAndHasAType) {
  const ScratchFolder folder;
  const Parts parts = parts_of(example_deck(folder));
  std::set<std::string> typed;
  const test::XmlNode types = part(parts, "[Content_Types].xml");
  for (const auto* type : test::all_named(types, "Override"))
    EXPECT_TRUE(typed.insert(type->attribute("PartName").substr(1)).second);
  for (const auto& [name, text] : parts) {
    if (name.ends_with(".png")) continue;
    EXPECT_NO_THROW(static_cast<void>(test::read_xml(text))) << name;
    const bool needs_type = name.ends_with(".xml") && name != "[Content_Types].xml";
    EXPECT_EQ(typed.contains(name), needs_type) << name;
  }
  for (const std::string& name : typed) EXPECT_TRUE(parts.contains(name)) << name;
}

TEST(DeckPptx, WhatAPartRefersToIsThere) {
  const ScratchFolder folder;
  const Parts parts = parts_of(example_deck(folder));
  int checked = 0;
  for (const auto& [name, text] : parts) {
    if (!name.ends_with(".rels")) continue;
    // "ppt/slides/_rels/slide1.xml.rels" is of "ppt/slides/slide1.xml".
    const fs::path folder_of = fs::path(name).parent_path().parent_path();
    std::set<std::string> ids;
    const test::XmlNode relations = test::read_xml(text);
    for (const auto* relation : test::all_named(relations, "Relationship")) {
      const fs::path target = (folder_of / relation->attribute("Target")).lexically_normal();
      EXPECT_TRUE(parts.contains(target.string())) << name << ": " << target;
      ids.insert(relation->attribute("Id"));
      ++checked;
    }
    const fs::path of = folder_of / fs::path(name).stem();
    if (!parts.contains(of.string())) continue;
    test::for_each_node(part(parts, of.string()), [&](const test::XmlNode& node) {
      for (const char* key : {"r:id", "r:embed"})
        if (const std::string id = node.attribute(key); !id.empty() && !ids.contains(id))
          ADD_FAILURE() << of << ": " << id;
    });
  }
  EXPECT_GT(checked, 6 * 5) << "of each slide its layout, picture and notes, of these their master and slide";
}

/// "slideLayout" → the part that it leads to.
std::multimap<std::string, std::string> relations_of(const Parts& parts, const fs::path& of) {
  std::multimap<std::string, std::string> all;
  const auto root = part(parts, of.parent_path() / "_rels" / (of.filename().string() + ".rels"));
  for (const auto* relation : test::all_named(root, "Relationship"))
    all.emplace(fs::path(relation->attribute("Type")).filename(),
                (of.parent_path() / relation->attribute("Target")).lexically_normal());
  return all;
}

// By ECMA-376 each master has a theme of its own, and notes lead back to their slide.
TEST(DeckPptx, SlidesLayoutsMastersAndNotesLeadToEachOther) {
  const ScratchFolder folder;
  const Parts parts = parts_of(example_deck(folder));
  using Pair = std::pair<std::string, std::string>;
  const std::string master = "ppt/slideMasters/slideMaster1.xml",
                    layout = "ppt/slideLayouts/slideLayout1.xml",
                    notes_master = "ppt/notesMasters/notesMaster1.xml";
  EXPECT_THAT(relations_of(parts, master),
              ElementsAre(Pair("slideLayout", layout), Pair("theme", "ppt/theme/theme1.xml")));
  EXPECT_THAT(relations_of(parts, layout), ElementsAre(Pair("slideMaster", master)));
  EXPECT_THAT(relations_of(parts, notes_master), ElementsAre(Pair("theme", "ppt/theme/theme2.xml")));
  for (int i = 1; i <= 6; ++i) {
    const std::string slide = fmt::format("ppt/slides/slide{}.xml", i),
                      notes = fmt::format("ppt/notesSlides/notesSlide{}.xml", i);
    EXPECT_THAT(relations_of(parts, slide),
                ElementsAre(Pair("image", fmt::format("ppt/media/slide{}.png", i)), Pair("notesSlide", notes),
                            Pair("slideLayout", layout)));
    EXPECT_THAT(relations_of(parts, notes),
                ElementsAre(Pair("notesMaster", notes_master), Pair("slide", slide)));
  }
}

// The schemas of ECMA-376 have children in one order alone.
TEST(DeckPptx, ChildrenStandInTheOrderOfTheSchemas) {
  const ScratchFolder folder;
  const Parts parts = parts_of(example_deck(folder));
  const auto children_of = [&](const std::string& name) {
    std::vector<std::string> names;
    for (const test::XmlNode& child : part(parts, name).children)
      if (!child.name.empty()) names.push_back(child.name);
    return names;
  };
  EXPECT_THAT(children_of("ppt/presentation.xml"),
              ElementsAre("p:sldMasterIdLst", "p:notesMasterIdLst", "p:sldIdLst", "p:sldSz", "p:notesSz",
                          "p:extLst"));
  EXPECT_THAT(children_of("ppt/slideMasters/slideMaster1.xml"),
              ElementsAre("p:cSld", "p:clrMap", "p:sldLayoutIdLst", "p:txStyles"));
  EXPECT_THAT(children_of("ppt/notesMasters/notesMaster1.xml"),
              ElementsAre("p:cSld", "p:clrMap", "p:notesStyle"));
  for (const char* name :
       {"ppt/slideLayouts/slideLayout1.xml", "ppt/slides/slide1.xml", "ppt/notesSlides/notesSlide1.xml"})
    EXPECT_THAT(children_of(name), ElementsAre("p:cSld", "p:clrMapOvr"));
}

TEST(DeckPptx, EverySlideHasItsTitleItsAlternativeTextAndItsNotes) {
  const ScratchFolder folder;
  Deck deck = example_deck(folder);
  deck.slides[1].notes.clear();
  const Parts parts = parts_of(deck);
  EXPECT_EQ(title_of(parts, 1), "Stage 1, step 1 of 3");
  EXPECT_EQ(title_of(parts, 4), "Stage 2");
  EXPECT_THAT(notes_of(parts, 3), ElementsAre("Words of s3", "Equation (5): ω² − 1 equals 0."));
  EXPECT_THAT(notes_of(parts, 2), ElementsAre("This slide has no notes."));
  for (int i = 1; i <= 6; ++i) {
    const auto slide = part(parts, fmt::format("ppt/slides/slide{}.xml", i));
    const auto pictures = test::all_named(slide, "p:pic");
    ASSERT_EQ(pictures.size(), 1u);
    EXPECT_EQ(test::all_named(*pictures[0], "p:cNvPr").at(0)->attribute("descr"),
              fmt::format("Alt of s{}", i));
    EXPECT_EQ(parts.at(fmt::format("ppt/media/slide{}.png", i)),
              text_of(deck.slides[static_cast<std::size_t>(i - 1)].png));
  }
}

TEST(DeckPptx, WhatIsToBeSaidStandsOutInTheNotes) {
  const ScratchFolder folder;
  Deck deck = example_deck(folder);
  deck.slides[0].notes = {{StepNote::Kind::to_say, "Slowly."}, {StepNote::Kind::text, "Words"}};
  const auto notes = part(parts_of(deck), "ppt/notesSlides/notesSlide1.xml");
  const auto looks = test::all_named(notes, "a:rPr");
  ASSERT_EQ(looks.size(), 2u);
  EXPECT_EQ(looks[0]->attribute("b"), "1");
  EXPECT_EQ(looks[1]->attribute("b"), "");
  EXPECT_THAT(paragraphs_of(notes), ElementsAre("Slowly.", "Words"));
}

TEST(DeckPptx, NoTwoTitlesAreAlike) {
  const ScratchFolder folder;
  Deck deck = example_deck(folder);
  for (DeckSlide& slide : deck.slides) {
    slide.title = "Spin";
    slide.part.clear();
  }
  deck.slides[1].title = "Spin (2)";
  const Parts parts = parts_of(deck);
  std::set<std::string> titles;
  for (int i = 1; i <= 6; ++i) titles.insert(title_of(parts, i));
  EXPECT_EQ(titles.size(), 6u);
  EXPECT_EQ(title_of(parts, 3), "Spin (3)");
}

TEST(DeckPptx, StagesAreItsSections) {
  const ScratchFolder folder;
  const auto presentation = part(parts_of(example_deck(folder)), "ppt/presentation.xml");
  std::vector<std::string> names, ids;
  std::vector<std::size_t> sizes;
  for (const auto* section : test::all_named(presentation, "p14:section")) {
    names.push_back(section->attribute("name"));
    ids.push_back(section->attribute("id"));
    sizes.push_back(test::all_named(*section, "p14:sldId").size());
    EXPECT_THAT(ids.back(),
                testing::MatchesRegex("\\{[0-9A-F]+-[0-9A-F]+-8[0-9A-F]+-8[0-9A-F]+-[0-9A-F]+\\}"));
    EXPECT_EQ(ids.back().size(), 38u);
  }
  EXPECT_THAT(names, ElementsAre("1. Stage 1", "2. Stage 2", "3. Stage 3"));
  EXPECT_THAT(sizes, ElementsAre(3u, 1u, 2u));
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), 3u);
}

TEST(DeckPptx, TellsWhereWordsOfItsNotesLead) {
  const ScratchFolder folder;
  Deck deck = example_deck(folder);
  deck.slides[0].notes = {
      {StepNote::Kind::text, "See there and here.", {{4, 9, "https://a.b/c"}, {14, 18, "#s2"}}}};
  EXPECT_THAT(notes_of(parts_of(deck), 1), ElementsAre("See there (https://a.b/c) and here."));
}

TEST(DeckPptx, TextsCannotBecomeMarkup) {
  const ScratchFolder folder;
  Deck deck = example_deck(folder);
  const std::string bad = "</a:t><a:t>\"'&]]>\x01\xEF\xBF\xBF{{ink}}", shown = "</a:t><a:t>\"'&]]> �{{ink}}";
  deck.title = deck.author = deck.slides[0].title = deck.slides[0].alt = bad;
  deck.slides[0].part.clear();
  deck.slides[0].notes[0].text = bad;
  const Parts parts = parts_of(deck);
  for (const auto& [name, text] : parts)
    if (!name.ends_with(".png")) {
      EXPECT_NO_THROW(static_cast<void>(test::read_xml(text))) << name;
    }
  EXPECT_EQ(title_of(parts, 1), shown);
  EXPECT_EQ(notes_of(parts, 1).at(0), shown);
}

/// x, y, cx, cy of the picture, and the size of the slides.
struct Placing {
  std::array<double, 4> picture{};
  std::array<double, 2> slide{};
};
Placing placing(const Parts& parts, int slide) {
  const auto root = part(parts, fmt::format("ppt/slides/slide{}.xml", slide));
  const test::XmlNode* picture = test::all_named(root, "p:pic").at(0);
  const test::XmlNode *at = test::all_named(*picture, "a:off").at(0),
                      *size = test::all_named(*picture, "a:ext").at(0);
  const auto presentation = part(parts, "ppt/presentation.xml");
  const test::XmlNode* of_all = test::all_named(presentation, "p:sldSz").at(0);
  return {{std::stod(at->attribute("x")), std::stod(at->attribute("y")), std::stod(size->attribute("cx")),
           std::stod(size->attribute("cy"))},
          {std::stod(of_all->attribute("cx")), std::stod(of_all->attribute("cy"))}};
}

constexpr double kInch = 914400;

TEST(DeckPptx, PicturesOfOneSizeFillTheirSlides) {
  const ScratchFolder folder;
  Deck deck = example_deck(folder);
  // 13.333 x 7.5 in, in hundredths of a millimetre; LibreOffice puts pictures one of them higher.
  EXPECT_THAT(placing(parts_of(deck), 2).slide, ElementsAre(12191760, 6858000));
  EXPECT_THAT(placing(parts_of(deck), 2).picture, ElementsAre(0, 360, 12191760, 6858000));
  deck.dpi = 160;
  EXPECT_THAT(placing(parts_of(deck), 2).slide, ElementsAre(2 * kInch, 1.125 * kInch - 180));
  deck.dpi = 1;  // 320 in would be refused
  EXPECT_THAT(placing(parts_of(deck), 2).slide, ElementsAre(56 * kInch, 31.5 * kInch));
  deck.dpi = 1000;
  EXPECT_EQ(placing(parts_of(deck), 2).slide[1], kInch);
}

TEST(DeckPptx, PicturesOfManySizesStandBelowTheirTitlesAtOneScale) {
  const ScratchFolder folder;
  Deck deck = example_deck(folder);
  Image wide = Image::blank({1200, 100}), small = Image::blank({60, 50});
  deck.slides = {slide_of(folder, "wide", wide), slide_of(folder, "small", small)};
  deck.dpi = 300;
  const Parts parts = parts_of(deck);
  const Placing a = placing(parts, 1), b = placing(parts, 2);
  // The wide one is 4 in at 300 dpi; 3 times that is as wide as the margins leave, within an inch.
  EXPECT_NEAR(a.picture[2], 12 * kInch, kInch);
  EXPECT_NEAR(a.picture[2] / 1200, b.picture[2] / 60, 0.01 * kInch / 300) << "a unit of rounding in 60 px";
  const auto master = part(parts, "ppt/slideMasters/slideMaster1.xml");
  const double bottom_of_title = std::stod(test::all_named(master, "a:off").at(0)->attribute("y")) +
                                 std::stod(test::all_named(master, "a:ext").at(0)->attribute("cy"));
  for (const Placing& one : {a, b}) {
    EXPECT_GE(one.picture[0], 0);
    EXPECT_GE(one.picture[1], bottom_of_title);
    EXPECT_LE(one.picture[1] + one.picture[3], one.slide[1]);
  }
}

TEST(DeckPptx, RepeatsToTheByteInEveryTimeZone) {
  const ScratchFolder one, other;
  const std::string want = written(example_deck(one), DeckKind::pptx);
  const char* const zone = std::getenv("TZ");
  const std::string before = zone == nullptr ? "" : zone;
  ::setenv("TZ", "Pacific/Kiritimati", 1);
  ::tzset();
  EXPECT_TRUE(written(example_deck(other), DeckKind::pptx) == want);
  zone == nullptr ? ::unsetenv("TZ") : ::setenv("TZ", before.c_str(), 1);
  ::tzset();
}

TEST(DeckPptx, ADeckOfNothingIsOneToo) {
  const Parts parts = parts_of(Deck{.title = "Nothing", .slides = {}});
  EXPECT_THAT(parts.at("docProps/core.xml"), HasSubstr("<dc:title>Nothing</dc:title>"));
  EXPECT_THAT(parts.at("ppt/presentation.xml"), Not(HasSubstr("sldIdLst")));
}

/// Levels, of all pixels and colours.
double root_mean_square(const Image& a, const Image& b) {
  EXPECT_EQ(a.size, b.size);
  if (a.size != b.size) return 255;
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const double difference = static_cast<double>(a.rgba[i]) - static_cast<double>(b.rgba[i]);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(a.rgba.size()));
}

/// What LibreOffice makes of folder/deck.pptx: deck.<ending>, by a profile of its own.
ProgramRun converted(const ScratchFolder& folder, const std::string& to) {
  return shell(
      fmt::format("cd '{0}' && HOME='{0}' timeout 120 soffice -env:UserInstallation=file://'{0}'/profile "
                  "--headless --convert-to '{1}' deck.pptx",
                  folder.path().string(), to));
}

/// Elements of LibreOffice's own format: what it has understood.
std::vector<test::XmlNode> elements_of(const std::string& document, const std::string& name) {
  std::vector<test::XmlNode> all;
  const std::string close = "</" + name + '>';
  for (std::size_t at = 0; (at = document.find('<' + name + ' ', at)) != std::string::npos;) {
    const std::size_t end = document.find(close, at) + close.size();
    all.push_back(test::read_xml(std::string_view(document).substr(at, end - at)));
    at = end;
  }
  return all;
}

std::vector<std::string> texts_of(const test::XmlNode& root, const char* name) {
  std::vector<std::string> all;
  for (const test::XmlNode* element : test::all_named(root, name)) {
    std::string& text = all.emplace_back();
    test::for_each_node(*element, [&](const test::XmlNode& node) { text += node.text; });
  }
  return all;
}

/// The frame that has a role in a presentation.
const test::XmlNode& frame_of(const test::XmlNode& page, const char* role) {
  for (const test::XmlNode* frame : test::all_named(page, "draw:frame"))
    if (frame->attribute("presentation:class") == role) return *frame;
  throw std::runtime_error(std::string("no frame is a ") + role);
}

TEST(DeckPptx, LibreOfficeUnderstandsTitlesAlternativeTextsAndNotes) {
  if (!has_program("soffice")) GTEST_SKIP() << "soffice is not installed";
  const ScratchFolder folder;
  Deck deck = example_deck(folder);
  deck.author = "E. Poinsot";
  deck.language = Language::de;
  deck.slides[2].part = deck.slides[1].part;
  deck.slides[3].alt = "a \"b\" < c & d, ω";
  deck.slides[4].notes.clear();
  ASSERT_TRUE(write_deck(folder / "deck.pptx", DeckKind::pptx, deck));
  const ProgramRun run = converted(folder, "fodp");
  ASSERT_EQ(run.code, 0) << run.out << run.err;
  const std::string document = text_of(folder / "deck.fodp");
  for (const char* fact :
       {"<dc:title>Examples</dc:title>", "<meta:initial-creator>E. Poinsot</", "<dc:language>de</"})
    EXPECT_THAT(document, HasSubstr(fact));
  const std::vector<test::XmlNode> pages = elements_of(document, "draw:page");
  ASSERT_EQ(pages.size(), deck.slides.size());
  std::vector<std::string> titles;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    titles.push_back(pages[i].attribute("draw:name"));
    EXPECT_THAT(texts_of(frame_of(pages[i], "title"), "text:p"), ElementsAre(titles.back()));
    EXPECT_THAT(texts_of(pages[i], "svg:desc"), ElementsAre(deck.slides[i].alt)) << "of the picture alone";
    const std::vector<std::string> notes = texts_of(frame_of(pages[i], "notes"), "text:p");
    if (deck.slides[i].notes.empty())
      EXPECT_THAT(notes, ElementsAre("Diese Folie hat keine Notizen."));
    else
      EXPECT_THAT(notes, ElementsAre(deck.slides[i].notes[0].text, deck.slides[i].notes[1].text));
  }
  EXPECT_THAT(titles, ElementsAre("Stage 1, step 1 of 3", "Stage 1, step 2 of 3", "Stage 1, step 2 of 3 (2)",
                                  "Stage 2", "Stage 3, step 1 of 2", "Stage 3, step 2 of 2"));
}

TEST(DeckPptx, LibreOfficeShowsTheSlides) {
  for (const char* program : {"soffice", "pdftocairo", "pdftoppm", "pdfinfo"})
    if (!has_program(program)) GTEST_SKIP() << program << " is not installed";
  const ScratchFolder folder;
  const Deck deck = example_deck(folder, {960, 540});
  ASSERT_TRUE(write_deck(folder / "deck.pptx", DeckKind::pptx, deck));
  const std::string at = folder.path().string();
  // Pictures as they are: it would pack them anew, as JPEG.
  const ProgramRun run = converted(
      folder,
      "pdf:impress_pdf_Export:{\"UseLosslessCompression\":{\"type\":\"boolean\",\"value\":\"true\"},"
      "\"ReduceImageResolution\":{\"type\":\"boolean\",\"value\":\"false\"}}");
  ASSERT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_THAT(shell(fmt::format("pdfinfo '{}/deck.pdf'", at)).out, HasSubstr("Pages:           6\n"));
  for (const char* program : {"pdftocairo", "pdftoppm"})
    for (const int page : {1, 4, 6}) {
      SCOPED_TRACE(fmt::format("page {} by {}", page, program));
      // 960 px are 13.333 in.
      ASSERT_EQ(shell(fmt::format("{0} -r 72 -f {1} -l {1} -png -singlefile '{2}/deck.pdf' '{2}/page'",
                                  program, page, at))
                    .code,
                0);
      const auto shown = read_png(folder / "page.png");
      ASSERT_TRUE(shown) << shown.error();
      constexpr double kLevels = 2;
      const DeckSlide& slide = deck.slides[static_cast<std::size_t>(page - 1)];
      EXPECT_LE(root_mean_square(shown->image, read_png(slide.png)->image), kLevels);
    }
}

}  // namespace
}  // namespace polhode
