// SPDX-License-Identifier: MIT
#include "lessons/reader/front_matter/about_keys.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using testing::complaints;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::string lesson_about(const std::string& keys, const std::string& text = "Text.") {
  return "+++\nformat = 1\nid = \"a\"\ntitle = \"A\"\n" + keys + "\n+++\n# One {one}\n" + text + '\n';
}

// As in the text: what stands in a page's title is no other apostrophe than the one below it.
TEST(AboutKeys, AreSetWithCurledMarks) {
  const LessonReading reading = read_lesson(
      "+++\nformat = 1\nid = \"a\"\ntitle = \"Euler's 'law'\"\noutcomes = \"know \\\"Newton's\\\" "
      "law\"\n[references]\nF = \"You're Joking\"\n+++\n# One {one}\nSee [cite: F].\n",
      "a.md");
  ASSERT_TRUE(reading.lesson);
  EXPECT_EQ(reading.lesson->title, "Euler’s ‘law’");
  EXPECT_THAT(reading.lesson->about.outcomes, ElementsAre("know “Newton’s” law"));
  EXPECT_EQ(reading.lesson->references.at(0).text, "You’re Joking");
}

TEST(AboutKeys, AreRead) {
  const LessonReading reading = read_lesson(
      lesson_about("author = [\"A. B.\", \"C. D.\"]\nlicence = \"CC BY 4.0\"\nlanguage = \"de\"\noutcomes = "
                   "\"know it\"\nprerequisites = [\"algebra\", \"euler-equations\"]\nnext = \"b\"\n[labels]\n"
                   "said = \"Dito\"\n[references]\nLL = \"Landau\"\nGO = \"Goldstein\"",
                   "See [cite: GO]."),
      "a.md");
  ASSERT_TRUE(reading.lesson);
  const About& about = reading.lesson->about;
  EXPECT_THAT(about.authors, ElementsAre("A. B.", "C. D."));
  EXPECT_EQ(about.licence, "CC BY 4.0");
  EXPECT_EQ(about.language, Language::de);
  EXPECT_THAT(about.outcomes, ElementsAre("know it"));
  EXPECT_THAT(about.prerequisites, ElementsAre("algebra", "euler-equations"));
  EXPECT_EQ(about.next, "b");
  ASSERT_THAT(reading.lesson->other_lessons, SizeIs(1));
  EXPECT_EQ(reading.lesson->other_lessons[0].lesson, "b");
  EXPECT_EQ(label_of(*reading.lesson, Callout::Kind::said), "Dito");
  EXPECT_EQ(label_of(*reading.lesson, Callout::Kind::meant), "Gemeint");
  ASSERT_THAT(reading.lesson->references, SizeIs(2));
  EXPECT_EQ(reading.lesson->references[0].key, "GO") << "by their keys";
  EXPECT_TRUE(reading.lesson->references[0].is_cited);
  EXPECT_THAT(
      testing::lines_of(reading.diagnostics),
      ElementsAre("14:1: warning: reference \"LL\" is cited nowhere (write [cite: LL] in a text, or leave "
                  "it out)"));
}

TEST(AboutKeys, MayAllBeLeftOut) {
  const LessonReading reading = read_lesson(lesson_about(""), "a.md");
  ASSERT_TRUE(reading.lesson);
  EXPECT_EQ(reading.lesson->about.language, Language::en);
  EXPECT_THAT(reading.lesson->about.authors, IsEmpty());
  EXPECT_THAT(reading.lesson->references, IsEmpty());
}

TEST(AboutKeys, ReportWhatDoesNotFit) {
  EXPECT_THAT(
      complaints(lesson_about("author = 3\nlicence = \"\"\nlanguage = \"e\"\noutcomes = [1]\n"
                              "prerequisites = [\"a\\nb\"]\nnext = \"no such\"")),
      ElementsAre("5:10: error: \"author\" takes a string or a list of strings, found a number",
                  "6:11: error: \"licence\" is one line of text without control characters",
                  "7:12: error: unknown language \"e\" (a lesson is in \"en\" or \"de\")",
                  "8:13: error: \"outcomes\" takes a list of strings, found a number",
                  "9:18: error: \"prerequisites\" is one line of text without control characters",
                  "10:8: error: bad lesson id \"no such\" (an id has 1 to 64 of the characters a-z, A-Z, "
                  "0-9 and -)"));
  EXPECT_THAT(
      complaints(lesson_about("labels = 3\nreferences = \"LL\"")),
      ElementsAre("5:10: error: \"labels\" takes a table, found a number (write [labels], and said = \"…\" "
                  "below)",
                  "6:14: error: \"references\" takes a table, found a string (write [references], and KEY = "
                  "\"…\" below)"));
  EXPECT_THAT(
      complaints(lesson_about("[labels]\nsayd = \"x\"\nmeant = \"A label that is far too long\"\n"
                              "[references]\n\"a b\" = \"x\"\nc = 3")),
      ElementsAre(
          "6:1: error: unknown key \"sayd\" in [labels] (did you mean \"said\"?)",
          "7:9: error: a label has at most 24 characters",
          "9:1: error: bad key of a reference \"a b\" (an id has 1 to 64 of the characters a-z, A-Z, "
          "0-9 and -)",
          "10:1: warning: reference \"c\" is cited nowhere (write [cite: c] in a text, or leave it out)",
          "10:5: error: \"c\" takes a string, found a number"));
}

TEST(AboutKeys, KnowTheLanguagesThatPagesSpeak) {
  for (const char* tag : {"en", "de"})
    EXPECT_THAT(complaints(lesson_about("language = \"" + std::string(tag) + '"')), IsEmpty()) << tag;
  for (const char* tag : {"", "-", "en-", "en-GB", "DE", "fr", "english", "ä"})
    EXPECT_THAT(complaints(lesson_about("language = \"" + std::string(tag) + '"')), SizeIs(1)) << tag;
}

TEST(AboutKeys, EndAtTheirLimits) {
  std::string references = "[references]\n", cited;
  for (std::size_t i = 0; i < kMaxReferences; ++i) {
    references += "r" + std::to_string(i) + " = \"x\"\n";
    cited += "[cite: r" + std::to_string(i) + "] ";
  }
  EXPECT_THAT(complaints(lesson_about(references, cited)), IsEmpty());
  EXPECT_THAT(complaints(lesson_about(references + "more = \"x\"\n")),
              ElementsAre("5:2: error: a lesson has at most 100 references"));
  std::string authors;
  for (std::size_t i = 0; i <= kMaxAboutLines; ++i) authors += "\"x\", ";
  EXPECT_THAT(complaints(lesson_about("author = [" + authors + ']')), SizeIs(1));
}

}  // namespace
}  // namespace polhode
