// SPDX-License-Identifier: MIT
// From a lesson to its deck, and `polhode export --deck`.
#include "app/publish/lesson_deck.h"

#include "app/narration/step_transcript.h"
#include "lessons/reader/checks/lesson_check.h"
#include "tests/app/publish/example_deck.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <thread>

namespace polhode {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr const char* kLesson = R"(+++
format = 1
id     = "notes"
title  = "Notes"
[symbols]
L = { tex = '\vec L', role = "L", say = "angular momentum", unit = "kg m²/s" }
+++
# How $\vec L$ turns {turn}
First **words**.

- one
- two

```math a
\vec L = 0 \tag{5}
```
---
> [!said] It stops.

```ask why
type    = "choice"
prompt  = "Why?"
choices = ["Because.", 'For $\vec L$.']
answer  = 1
hints   = ["Guess."]
```
---
More.
)";

std::vector<std::string> texts(const std::vector<StepNote>& notes) {
  std::vector<std::string> all;
  for (const StepNote& note : notes) all.push_back(note.text);
  return all;
}

TEST(DeckNotes, AreWhatTheStepsSay) {
  const auto lesson = check_lesson(kLesson, "notes.md");
  ASSERT_TRUE(lesson.lesson) << lesson.diagnostics[0].message;
  const SpeechText speech(*lesson.lesson);
  const Stage& stage = lesson.lesson->stages[0];
  EXPECT_THAT(texts(notes_of(speech, stage, 1, 1)),
              ElementsAre("First words.", "• one", "• two", "Equation (5): vector L equals 0."));
  EXPECT_THAT(texts(notes_of(speech, stage, 2, 3)),
              ElementsAre("The lecture said: It stops.", "Question: Why?", "A. Because.", "B. For vector L.",
                          "More."));
}

// 28 November 2026: the audience sees whether an equation is proved, and who spoke to it did not.
TEST(DeckNotes, HaveTheVerdicts) {
  std::string proved = kLesson;
  proved.replace(proved.find("```math a"), 9, "```math a free");
  proved.replace(proved.find("\\vec L = 0"), 10, "\\frac{d\\vec L}{dt} = 0");
  const auto lesson = check_lesson(proved, "notes.md");
  ASSERT_TRUE(lesson.lesson) << lesson.diagnostics[0].message;
  EXPECT_THAT(texts(notes_of(SpeechText(*lesson.lesson), lesson.lesson->stages[0], 1, 1)),
              ElementsAre("First words.", "• one", "• two", "Equation (5): d vector L over d t equals 0.",
                          "True when no torque acts."));
}

ExportOptions options_of(What what, Each each) {
  ExportOptions options;
  options.what = what;
  options.each = each;
  options.dpi = 96;
  return options;
}

Deck deck_of_tiny(const ExportOptions& options, const ScratchFolder& folder) {
  static const auto lesson = check_lesson(text_of(test_lesson("tiny.md")), "tiny.md");
  const ExportPlan plan = plan_export(*lesson.lesson, options).value();
  for (const PlannedPicture& picture : plan.pictures)
    slide_of(folder, std::filesystem::path(picture.file).stem(),
             Image{{2, 1}, std::vector<std::uint8_t>(8, 255)});
  return *deck_of(*lesson.lesson, options, plan, folder.path());
}

TEST(LessonDeck, HasASlideForEachStepWithItsWords) {
  const ScratchFolder folder;
  const Deck deck = deck_of_tiny(options_of(What::page, Each::step), folder);
  ASSERT_EQ(deck.slides.size(), 4u);
  EXPECT_EQ(deck.title, "A tiny lesson");
  EXPECT_EQ(deck.dpi, 96);
  EXPECT_EQ(name_of(deck.slides[0]), "A steady spin, step 1 of 2");
  EXPECT_EQ(name_of(deck.slides[2]), "Words alone");
  EXPECT_EQ(deck.slides[1].alt, "Alt of 01-steady-step2");
  EXPECT_EQ(deck.slides[3].stage, 3);
  EXPECT_THAT(texts(deck.slides[0].notes), Contains(HasSubstr("About axis 3")));
  EXPECT_THAT(texts(deck.slides[1].notes), Not(Contains(HasSubstr("About axis 3"))));
}

TEST(LessonDeck, WhateverIsSaidIsSaidOnce) {
  for (const What what : {What::page, What::figure})
    for (const Each each : {Each::stage, Each::step}) {
      const ScratchFolder folder;
      std::vector<std::string> all;
      for (const DeckSlide& slide : deck_of_tiny(options_of(what, each), folder).slides)
        for (const StepNote& note : slide.notes) all.push_back(note.text);
      for (const char* words : {"About axis 3, and it stays.", "The same, from the body.",
                                "The ellipsoid rolls on the invariable plane."})
        EXPECT_EQ(std::count(all.begin(), all.end(), words), 1) << words;
    }
}

// 29 November 2026: who spoke to a slide had not what stands at its foot.
TEST(LessonDeck, NotesHaveWhatASlideGoesOnFrom) {
  const auto lesson = check_lesson(kLesson, "notes.md");
  ASSERT_TRUE(lesson.lesson);
  const ScratchFolder folder;
  const auto notes_of_second = [&](const ExportOptions& options) {
    const ExportPlan plan = plan_export(*lesson.lesson, options).value();
    for (const PlannedPicture& picture : plan.pictures)
      slide_of(folder, fs::path(picture.file).stem(), Image{{2, 1}, std::vector<std::uint8_t>(8, 255)});
    return texts(deck_of(*lesson.lesson, options, plan, folder.path())->slides.at(1).notes);
  };
  const std::string recalled = "From before: Equation (5): vector L equals 0.";
  EXPECT_EQ(notes_of_second(options_of(What::page, Each::step)).back(), recalled);
  ExportOptions to_read = options_of(What::page, Each::step);
  to_read.profile = Profile::page;
  EXPECT_THAT(notes_of_second(to_read), testing::Not(testing::Contains(recalled)));
}

TEST(LessonDeck, EquationsAreNamed) {
  const ScratchFolder folder;
  const Deck deck = deck_of_tiny(options_of(What::equation, Each::stage), folder);
  ASSERT_EQ(deck.slides.size(), 2u);
  EXPECT_EQ(name_of(deck.slides[0]), "A steady spin, equation steady-eq");
}

TEST(LessonDeck, AMissingPictureIsAnError) {
  const auto lesson = check_lesson(text_of(test_lesson("tiny.md")), "tiny.md");
  const ExportOptions options;
  const auto deck =
      deck_of(*lesson.lesson, options, plan_export(*lesson.lesson, options).value(), "/nowhere");
  ASSERT_FALSE(deck);
  EXPECT_THAT(deck.error(), HasSubstr("/nowhere/01-steady.png"));
}

ProgramRun export_deck(const std::filesystem::path& file, std::vector<std::string> more = {}) {
  std::vector<std::string> words = {"export", test_lesson("tiny.md"), "--deck", file.string(), "--size",
                                    "320x240"};
  words.insert(words.end(), more.begin(), more.end());
  return polhode(words);
}

TEST(ExportDeck, LeavesTheDeckAlone) {
  const ScratchFolder folder;
  for (const char* name : {"deck.html", "deck.pdf", "deck.pptx"}) {
    const ProgramRun run = export_deck(folder / "made" / name, {"--each", "step"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("4 slides in "));
  }
  EXPECT_THAT(names_in(folder / "made"), ElementsAre("deck.html", "deck.pdf", "deck.pptx"));
  EXPECT_THAT(text_of(folder / "made/deck.html"), HasSubstr("aria-label=\"A steady spin, step 2 of 2\""));
}

TEST(ExportDeck, IsTheSameWithAndWithoutAFolderForThePictures) {
  const ScratchFolder folder;
  for (const char* ending : {".html", ".pdf", ".pptx"}) {
    const std::string a = std::string("a") + ending, b = std::string("b") + ending;
    ASSERT_EQ(export_deck(folder / a).code, 0);
    ASSERT_EQ(export_deck(folder / b, {"-o", (folder / "kept").string()}).code, 0);
    EXPECT_TRUE(text_of(folder / a) == text_of(folder / b)) << ending;
  }
  EXPECT_THAT(names_in(folder / "kept"),
              ElementsAre("01-steady-step1.png", "01-steady-step2.png", "02-words-step1.png",
                          "03-rolling-step1.png", "manifest.json"));
}

// Whoever may write beside the deck can guess the name of the folder that its pictures pass through.
TEST(ExportDeck, FollowsNoLinkForItsPictures) {
  const ScratchFolder folder, elsewhere;
  for (const bool dangling : {false, true}) {
    const fs::path target = elsewhere / (dangling ? "none" : "there");
    if (!dangling) {
      fs::create_directory(target);
      write_text(target / "01-steady.png", "precious");
    }
    fs::create_symlink(target, folder / "deck.html.parts");
    const ProgramRun run = export_deck(folder / "deck.html");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.err, testing::AllOf(HasSubstr("deck.html.parts is a link"), HasSubstr("--output DIR")));
    EXPECT_THAT(names_in(folder.path()), ElementsAre("deck.html.parts"));
    fs::remove(folder / "deck.html.parts");
  }
  EXPECT_THAT(names_in(elsewhere.path()), ElementsAre("there"));
  EXPECT_EQ(text_of(elsewhere / "there/01-steady.png"), "precious");
}

TEST(ExportDeck, TakesNoFolderOfOthersForItsPictures) {
  const ScratchFolder folder;
  const fs::path parts = folder / "deck.html.parts";
  fs::create_directory(parts);
  write_text(parts / "01-steady.png", "precious");
  const ProgramRun run = export_deck(folder / "deck.html");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, testing::AllOf(HasSubstr("deck.html.parts holds files of something else"),
                                      HasSubstr("--output DIR")));
  EXPECT_THAT(names_in(folder.path()), ElementsAre("deck.html.parts"));
  EXPECT_THAT(names_in(parts), ElementsAre("01-steady.png"));
  EXPECT_EQ(text_of(parts / "01-steady.png"), "precious");
}

TEST(ExportDeck, TakesTheFolderThatAKilledExportLeft) {
  const ScratchFolder folder;
  const fs::path parts = folder / "deck.html.parts";
  // Killed before its marker had its name, while it drew, and while it cleaned up.
  const auto begun = [&] { write_text(parts / ".polhode-12345678-1-0.part", "{"); };
  const auto drawing = [&] {
    ASSERT_EQ(export_deck(folder / "other.html", {"-o", parts.string()}).code, 0);
    fs::rename(parts / "manifest.json", parts / ".polhode-unfinished.json");
    fs::remove(parts / "03-rolling.png");
  };
  const auto cleaning_up = [&] {
    ASSERT_EQ(export_deck(folder / "other.html", {"-o", parts.string()}).code, 0);
    fs::remove(parts / "01-steady.png");
  };
  for (const std::function<void()>& killed :
       std::vector<std::function<void()>>{[] {}, begun, drawing, cleaning_up}) {
    fs::create_directory(parts);
    killed();
    const ProgramRun run = export_deck(folder / "deck.html");
    EXPECT_EQ(run.code, 0) << run.err;
    fs::remove(parts / ".polhode-12345678-1-0.part");  // it may be of another machine, and stays for an hour
    fs::remove(parts);
    EXPECT_FALSE(fs::exists(parts));
  }
}

TEST(ExportDeck, IntoAPipeThatNobodyReadsIsCode1) {
  const ScratchFolder folder;
  ASSERT_EQ(mkfifo((folder / "deck.html").c_str(), 0600), 0);
  const ProgramRun run = export_deck(folder / "deck.html");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("nobody reads from this pipe"));
}

TEST(ExportDeck, GoesThroughAPipe) {
  const ScratchFolder folder;
  ASSERT_EQ(export_deck(folder / "want.html").code, 0);
  const fs::path pipe = folder / "deck.html";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string found;
  std::thread reader([&] { found = text_of(pipe); });
  const ProgramRun run = export_deck(pipe);
  EXPECT_EQ(run.code, 0) << run.err;
  if (run.code != 0) std::ofstream(pipe) << "";  // or the reader waited for ever
  reader.join();
  EXPECT_TRUE(found == text_of(folder / "want.html"));
}

TEST(ExportDeck, SaysWhatCannotBe) {
  const ScratchFolder folder;
  const auto expect = [&](const ProgramRun& run, const char* text) {
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr(text));
    EXPECT_THAT(names_in(folder.path()), testing::IsEmpty());
  };
  expect(export_deck(folder / "deck.odp"), "has to end in .html, .pdf or .pptx");
  expect(export_deck(folder / "deck.html", {"--each", "frame"}), "goes with --each stage or step");
  expect(polhode({"export", test_lesson("tiny.md"), "--what", "transcript", "--deck",
                  (folder / "a.html").string()}),
         "a transcript is text");
}

constexpr const char* kReferring = R"(+++
format = 1
id     = "referring"
title  = "Referring"
author = ["A. B.", "C. D."]
language = "de"
[references]
LL = "Landau"
+++
# One {one}
See [](#two/late), [here](#one), [there](other#x), [the web](https://a.b) and [cite: LL].

> [!note] Or [](#two).

# Two {two}
Words[^n].

[^n]: Of [One](#one).

---
```math late
x \tag{3}
```
)";

TEST(LessonDeck, LeadsFromItsNotesToItsSlides) {
  const auto lesson = check_lesson(kReferring, "referring.md");
  ASSERT_TRUE(lesson.lesson) << lesson.diagnostics[0].message;
  const ScratchFolder folder;
  const ExportOptions options = options_of(What::page, Each::step);
  const ExportPlan plan = plan_export(*lesson.lesson, options).value();
  for (const PlannedPicture& picture : plan.pictures)
    slide_of(folder, fs::path(picture.file).stem(), Image{{2, 1}, std::vector<std::uint8_t>(8, 255)});
  const Deck deck = *deck_of(*lesson.lesson, options, plan, folder.path());
  EXPECT_EQ(deck.author, "A. B., C. D.");
  EXPECT_EQ(deck.language, Language::de);
  ASSERT_EQ(deck.slides.size(), 3u);
  const auto links = [](const StepNote& note) {
    std::string all;
    for (const NoteLink& link : note.links)
      all += '[' + note.text.substr(link.begin, link.end - link.begin) + "](" + link.to + ')';
    return all;
  };
  EXPECT_EQ(links(deck.slides[0].notes[0]),
            "[(3)](#02-two-step2)[here](#01-one-step1)[the web](https://a.b)");
  EXPECT_EQ(links(deck.slides[0].notes[1]), "[Two](#02-two-step1)");
  EXPECT_EQ(deck.slides[1].notes.back().text, "¹ Of One.");
  EXPECT_EQ(links(deck.slides[1].notes.back()), "[One](#01-one-step1)");
  EXPECT_EQ(deck.slides[2].notes.back().text, "[LL] Landau") << "at the end of the last slide's";
  ExportOptions one = options;
  one.stages = {"one"};
  const ExportPlan part = plan_export(*lesson.lesson, one).value();
  EXPECT_EQ(links(deck_of(*lesson.lesson, one, part, folder.path())->slides[0].notes[0]),
            "[here](#01-one-step1)[the web](https://a.b)")
      << "what is not in the deck is led to by no link";
}

}  // namespace
}  // namespace polhode
