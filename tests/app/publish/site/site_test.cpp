// SPDX-License-Identifier: MIT
// Sites: which pages there are, in which order, what is drawn again, and what is left alone.
#include "app/publish/site/site_index.h"
#include "app/publish/site/site_record.h"
#include "base/files/temporary_file.h"
#include "render/image/png.h"
#include "tests/app/publish/text_edition/example_edition.h"
#include "tests/app/run_program.h"
#include "tests/base/files/folder.h"
#include "tests/support/xml.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace polhode {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Lesson called(const std::string& id, const std::string& next = "") {
  Lesson lesson;
  lesson.id = lesson.title = id;
  lesson.about.next = next;
  return lesson;
}

std::vector<std::string> ordered(const std::vector<Lesson>& lessons) {
  std::vector<const Lesson*> all;
  for (const Lesson& lesson : lessons) all.push_back(&lesson);
  std::vector<std::string> ids;
  for (const std::size_t i : course_order(all)) ids.push_back(lessons[i].id);
  return ids;
}

TEST(CourseOrder, FollowsEachLessonsNext) {
  EXPECT_THAT(ordered({called("a", "z"), called("b"), called("m", "a"), called("z", "b")}),
              ElementsAre("m", "a", "z", "b"));
}

TEST(CourseOrder, HasEveryLessonOnce) {
  EXPECT_THAT(ordered({called("d"), called("a", "c"), called("b", "c"), called("c")}),
              ElementsAre("a", "c", "b", "d"))
      << "two lead to one";
  EXPECT_THAT(ordered({called("b", "a"), called("a", "b")}), ElementsAre("a", "b")) << "in a circle";
  EXPECT_THAT(ordered({called("a", "gone"), called("b", "b")}), ElementsAre("a", "b"));
}

constexpr const char* kOther = R"(+++
format = 1
id     = "other"
title  = "Another"
outcomes = ["know <more>"]
prerequisites = ["something"]
next   = "edition"
+++
# Where {x}
Words, and [the law](edition#moves/law), [there](edition#asked), [nowhere](gone#x).
```math square
a^2 = b \tag{1}
```
)";

class SiteOfTwo : public testing::Test {
 protected:
  void SetUp() override {
    write_text(folder_ / "edition.md", kEditionLesson);
    write_text(folder_ / "other.md", kOther);
  }
  ProgramRun make(const fs::path& site, std::vector<std::string> more = {},
                  std::vector<std::string> lessons = {"edition", "other"}) {
    std::vector<std::string> words = {"export"};
    for (const std::string& lesson : lessons) words.push_back((folder_ / (lesson + ".md")).string());
    words.insert(words.end(), {"--site", site.string()});
    words.insert(words.end(), more.begin(), more.end());
    return polhode(words);
  }
  ScratchFolder folder_;
};

/// Of a page: where its links lead.
std::set<std::string> links_in(const std::string& html) {
  std::set<std::string> links;
  const test::XmlNode page = test::read_xml(html);
  for (const test::XmlNode* link : test::all_named(page, "a")) links.insert(link->attribute("href"));
  return links;
}

std::set<std::string> ids_in(const std::string& html) {
  std::set<std::string> ids;
  test::for_each_node(test::read_xml(html),
                      [&](const test::XmlNode& node) { ids.insert(node.attribute("id")); });
  return ids;
}

TEST_F(SiteOfTwo, HasAPageForEachLessonAndAnIndex) {
  const fs::path site = folder_ / "site";
  const ProgramRun run = make(site);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(names_in(site),
              ElementsAre("edition.html", "edition.png", "index.html", "other.html", "site.json"));
  const std::string index = text_of(site / "index.html");
  EXPECT_LT(index.find(">Another<"), index.find(">An &lt;edition&gt; &amp; more<"))
      << "the order of the course";
  EXPECT_THAT(index, HasSubstr("<li>know &lt;more&gt;</li>"));
  EXPECT_THAT(index, HasSubstr("<math"));
  const auto preview = read_png(site / "edition.png");
  ASSERT_TRUE(preview) << preview.error();
  EXPECT_EQ(preview->image.size, (Size{1200, 630}));
}

// The program is there once, whatever pages there are, under a name that is of its bytes.
TEST_F(SiteOfTwo, HasOneProgramForAllFiguresThatMove) {
  const fs::path site = folder_ / "site", web = folder_ / "web";
  fs::create_directories(web);
  const auto make_live = [&](const std::string& script) {
    write_text(web / "polhode.wasm", "wasm");
    write_text(web / "polhode.js", script);
    RunOptions there;
    there.environment["POLHODE_WEB"] = web.string();
    const ProgramRun run =
        polhode({"export", (folder_ / "edition.md").string(), (folder_ / "other.md").string(), "--live",
                 "--with", "html", "--site", site.string()},
                there);
    EXPECT_EQ(run.code, 0) << run.err;
    return run.err;
  };
  const auto program_name = [&] {
    std::string name;
    for (const std::string& file : names_in(site))
      if (file.starts_with("polhode-")) name = file;
    return name;
  };
  make_live("one()");
  const std::string first = program_name();
  EXPECT_THAT(names_in(site),
              ElementsAre("edition-slides.html", "edition.html", "edition.png", "index.html",
                          "other-slides.html", "other.html", first, "sandbox.html", "site.json"));
  for (const char* page : {"edition.html", "edition-slides.html", "other.html", "sandbox.html"})
    EXPECT_THAT(text_of(site / page), testing::AllOf(HasSubstr(first), HasSubstr("'strict-dynamic'"),
                                                     Not(HasSubstr("id=\"polhode.wasm"))))
        << page;
  EXPECT_THAT(text_of(site / "index.html"), HasSubstr("href=\"sandbox.html\""));
  EXPECT_THAT(make_live("one()"), HasSubstr("(2 of them kept)"));
  EXPECT_THAT(make_live("another()"), Not(HasSubstr("kept"))) << "another program";
  EXPECT_NE(program_name(), first);
  EXPECT_EQ(make(site).code, 0);
  EXPECT_THAT(names_in(site),
              ElementsAre("edition.html", "edition.png", "index.html", "other.html", "site.json"))
      << "nothing moves any more";
}

TEST_F(SiteOfTwo, EveryLinkWithinItLeadsSomewhere) {
  const fs::path site = folder_ / "site";
  ASSERT_EQ(make(site).code, 0);
  std::map<std::string, std::set<std::string>> ids;
  for (const char* page : {"index.html", "edition.html", "other.html"})
    ids[page] = ids_in(text_of(site / page));
  int within = 0;
  for (const auto& [page, unused] : ids)
    for (const std::string& link : links_in(text_of(site / page))) {
      if (link.starts_with("http") || link.starts_with("mailto:")) continue;
      const std::size_t hash = std::min(link.find('#'), link.size());
      const std::string to = hash == 0 ? page : link.substr(0, hash);
      ASSERT_TRUE(ids.contains(to)) << page << ": " << link;
      const bool has_place = hash == link.size() || ids[to].contains(link.substr(hash + 1));
      EXPECT_TRUE(has_place) << page << ": " << link;
      ++within;
    }
  EXPECT_GT(within, 20);
  const auto of_other = links_in(text_of(site / "other.html"));
  EXPECT_TRUE(of_other.contains("edition.html#moves/law"));
  EXPECT_TRUE(of_other.contains("edition.html")) << "the next lesson";
  EXPECT_TRUE(of_other.contains("index.html"));
  EXPECT_TRUE(links_in(text_of(site / "index.html")).contains("edition.html#moves/step.1"));
}

std::map<std::string, std::string> bytes_in(const fs::path& site) {
  std::map<std::string, std::string> bytes;
  for (const std::string& name : names_in(site)) bytes[name] = text_of(site / name);
  return bytes;
}

TEST_F(SiteOfTwo, RepeatsToTheByteAndDrawsWhatHasChangedAlone) {
  const fs::path site = folder_ / "site";
  ASSERT_EQ(make(site).code, 0);
  const auto before = bytes_in(site);
  const auto time = fs::last_write_time(site / "edition.html");
  const ProgramRun again = make(site, {}, {"other", "edition"});
  EXPECT_THAT(again.err, HasSubstr("2 lessons in " + (site / "index.html").string() + " (2 of them kept)"));
  EXPECT_EQ(fs::last_write_time(site / "edition.html"), time);
  EXPECT_TRUE(bytes_in(site) == before);
  ASSERT_EQ(make(folder_ / "twin").code, 0);
  EXPECT_TRUE(bytes_in(folder_ / "twin") == before);

  std::string text = kOther;
  text.replace(text.find("Words"), 5, "Terms");
  write_text(folder_ / "other.md", text);
  EXPECT_THAT(make(site).err, HasSubstr("(1 of them kept)"));
  EXPECT_EQ(fs::last_write_time(site / "edition.html"), time);
  EXPECT_THAT(text_of(site / "other.html"), HasSubstr("Terms, and"));

  write_text(site / "edition.html", "damaged");
  EXPECT_THAT(make(site).err, HasSubstr("(1 of them kept)"));
  EXPECT_TRUE(text_of(site / "edition.html") == before.at("edition.html"));
}

TEST_F(SiteOfTwo, FiguresForDarkScreensAreDrawnWhereTheyAreAskedFor) {
  const fs::path site = folder_ / "site";
  ASSERT_EQ(make(site).code, 0);
  EXPECT_THAT(text_of(site / "edition.html"), Not(HasSubstr("<source ")));
  ASSERT_EQ(make(site, {"--theme", "both"}).code, 0);
  EXPECT_THAT(text_of(site / "edition.html"),
              HasSubstr("<source media=\"screen and (prefers-color-scheme: dark)\""));
}

TEST_F(SiteOfTwo, RemovesThePagesOfALessonThatIsGoneAndNothingElse) {
  const fs::path site = folder_ / "site";
  ASSERT_EQ(make(site).code, 0);
  write_text(site / "mine.txt", "precious");
  ASSERT_EQ(make(site, {}, {"other"}).code, 0);
  EXPECT_THAT(names_in(site), ElementsAre("index.html", "mine.txt", "other.html", "site.json"));
  EXPECT_THAT(text_of(site / "other.html"), Not(HasSubstr("edition.html")));
}

TEST_F(SiteOfTwo, ClearsWhatAKilledProcessLeft) {
  const fs::path site = folder_ / "site";
  fs::create_directory(site);
  write_text(site / test::name_of_the_dead(), "half");
  ASSERT_EQ(make(site).code, 0);
  EXPECT_TRUE(left_behind_in(site).empty());
}

TEST_F(SiteOfTwo, TakesNoFolderOfOthers) {
  const fs::path site = folder_ / "site";
  fs::create_directory(site);
  write_text(site / "index.html", "precious");
  const ProgramRun run = make(site);
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("holds files of something else"));
  EXPECT_THAT(names_in(site), ElementsAre("index.html"));
  // Nor does a record reach out of its folder.
  write_text(
      site / kSiteRecordName,
      R"({"kind": "polhode site", "files": [{"file": "../edition.md", "made_of": "", "sha256": ""}]})");
  EXPECT_EQ(make(site).code, 1);
  EXPECT_EQ(text_of(folder_ / "edition.md"), kEditionLesson);
}

TEST_F(SiteOfTwo, KnowsWhereItWillLie) {
  const fs::path site = folder_ / "site";
  ASSERT_EQ(make(site, {"--url", "https://example.org/a&b"}).code, 0);
  std::vector<std::string> places;
  const test::XmlNode map = test::read_xml(text_of(site / "sitemap.xml"));
  for (const test::XmlNode* place : test::all_named(map, "loc")) places.push_back(place->children.at(0).text);
  EXPECT_THAT(places, ElementsAre("https://example.org/a&b/", "https://example.org/a&b/other.html",
                                  "https://example.org/a&b/edition.html"));
  const std::string page = text_of(site / "edition.html");
  EXPECT_THAT(page, HasSubstr("<link rel=\"canonical\" href=\"https://example.org/a&amp;b/edition.html\"/>"));
  EXPECT_THAT(page, HasSubstr("content=\"https://example.org/a&amp;b/edition.png\""));
  ASSERT_EQ(make(site).code, 0);
  EXPECT_FALSE(fs::exists(site / "sitemap.xml")) << "of an address that is no longer said";
}

TEST_F(SiteOfTwo, LinksALessonWithItsTranslation) {
  std::string german = kOther;
  german.insert(german.find("outcomes"), "language = \"de\"\n");
  write_text(folder_ / "other.de.md", german);
  const fs::path site = folder_ / "site";
  const ProgramRun run = make(site, {"--url", "https://x.org/"}, {"edition", "other", "other.de"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(text_of(site / "other.html"),
              testing::AllOf(
                  HasSubstr("<link rel=\"alternate\" hreflang=\"de\" href=\"https://x.org/other.de.html\"/>"),
                  HasSubstr("href=\"other.de.html\"")));
  EXPECT_THAT(text_of(site / "other.de.html"),
              testing::AllOf(HasSubstr("<html lang=\"de\">"),
                             HasSubstr("hreflang=\"en\" href=\"https://x.org/other.html\""),
                             HasSubstr("Die nächste Lektion: <a href=\"edition.html\" lang=\"en\">An "
                                       "&lt;edition&gt; &amp; more</a> (auf Englisch)")));
  // One lesson of the course, in two languages.
  EXPECT_THAT(text_of(site / "index.html"),
              testing::AllOf(HasSubstr("<span class=\"number\">1</span><a href=\"other.html\""),
                             HasSubstr("<span class=\"number\">1</span><a href=\"other.de.html\""),
                             HasSubstr("<span class=\"number\">2</span><a href=\"edition.html\"")));
}

// 28 November 2026: a German lesson lay in an English frame.
TEST_F(SiteOfTwo, AnIndexIsInTheLanguageOfItsFirstLesson) {
  std::string german = kOther;
  german.insert(german.find("outcomes"), "language = \"de\"\n");
  write_text(folder_ / "other.md", german);
  const fs::path site = folder_ / "site";
  ASSERT_EQ(make(site, {"--with", "pdf"}, {"other"}).code, 0);
  const std::string index = text_of(site / "index.html");
  EXPECT_THAT(index, testing::AllOf(HasSubstr("<html lang=\"de\">"),
                                    HasSubstr("<h1>Vorlesungen über die Rotation starrer Körper</h1>"),
                                    HasSubstr("Zum Mitnehmen: <a href=\"other.de.pdf\">Folien als PDF</a>"),
                                    HasSubstr("Nichts gefunden.")));
  for (const char* english : {"Lectures", "To the lessons", "Find a", "Headings", "places"})
    EXPECT_THAT(index, Not(HasSubstr(english)));
}

TEST_F(SiteOfTwo, ShowsWhatALessonBuildsOnByItsTitle) {
  std::string other = kOther;
  other.replace(other.find("[\"something\"]"), 13, "[\"edition\", \"something\"]");
  write_text(folder_ / "other.md", other);
  const fs::path site = folder_ / "site";
  ASSERT_EQ(make(site).code, 0);
  EXPECT_THAT(
      text_of(site / "other.html"),
      HasSubstr("<li><a href=\"edition.html\">An &lt;edition&gt; &amp; more</a></li>\n<li>something</li>"));
}

TEST_F(SiteOfTwo, OffersSlides) {
  const fs::path site = folder_ / "site";
  ASSERT_EQ(make(site, {"--with", "pptx"}, {"other"}).code, 0);
  EXPECT_THAT(names_in(site), ElementsAre("index.html", "other.html", "other.pptx", "site.json"));
  EXPECT_TRUE(links_in(text_of(site / "index.html")).contains("other.pptx"));
  const auto time = fs::last_write_time(site / "other.pptx");
  ASSERT_EQ(make(site, {"--with", "pptx"}, {"other"}).code, 0);
  EXPECT_EQ(fs::last_write_time(site / "other.pptx"), time);
}

TEST_F(SiteOfTwo, SaysWhatCannotBe) {
  const fs::path site = folder_ / "site";
  const auto expect = [&](const ProgramRun& run, const char* reason) {
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr(reason));
    EXPECT_FALSE(fs::exists(site));
  };
  expect(make(site, {"--what", "figure"}), "does not go with --site");
  expect(make(site, {"--url", "ftp://a"}), "has to begin with https://");
  expect(make(site, {"--with", "docx"}), "none of html, pdf, pptx, mp4");
  expect(make(site, {}, {"other", "other"}), "two lessons have the id \"other\"");
  const std::string other = (folder_ / "other.md").string();
  expect(polhode({"export", other, other, "-o", site.string()}), "unexpected argument");
  expect(polhode({"export", "-o", site.string()}), "LESSON is required");
  expect(polhode({"export", other, "--url", "https://a", "-o", site.string()}), "--url goes with --site");
}

}  // namespace
}  // namespace polhode
