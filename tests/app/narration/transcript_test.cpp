// SPDX-License-Identifier: MIT
#include "app/narration/transcript.h"

#include "app/narration/speech_text.h"
#include "lessons/reader/checks/lesson_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kLesson = R"(+++
format = 1
id = "spoken"
title = "A spoken lesson"
[symbols]
omega = { tex = '\vec\omega', role = "omega", say = "angular velocity" }
+++
# The first stage {first}
The vector $\vec\omega$ is *long*:

- one item
- another item

```math e
\vec\omega = 0 \tag{7}
```

> [!said] It is small.
> [!meant] It is zero.

```ask q
type = "choice"
prompt = "How long is it?"
choices = ["short", "zero"]
answer = 2
hints = ["a secret hint"]
```

# The second stage {second}
More words.
)";

Lesson lesson() {
  LessonReading reading = check_lesson(kLesson, "spoken.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  return std::move(*reading.lesson);
}

TEST(Transcript, HasWhatIsReadInItsOrder) {
  const std::string text = transcript_of(lesson(), {});
  std::size_t at = 0;
  for (const char* part : {"A spoken lesson\n===============\n", "\n1. The first stage\n------------------\n",
                           "The vector omega is long:\n", "\n  • one item\n  • another item\n",
                           "    Equation (7): vector omega equals 0", "  > The lecture said: It is small.\n",
                           "  > What it meant: It is zero.\n",
                           "Question: How long is it?\n  A. short\n  B. zero\n", "\n2. The second stage\n"}) {
    const std::size_t found = text.find(part, at);
    ASSERT_NE(found, std::string::npos) << part << "\nin\n" << text;
    at = found;
  }
}

TEST(Transcript, HasTheTitlesOfSteps) {
  const LessonReading reading = check_lesson(
      "+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n+++\n# A {a}\n## It holds\nOne.\n\n## It ends\nTwo.\n",
      "x.md");
  EXPECT_THAT(transcript_of(*reading.lesson, {}),
              HasSubstr("\nIt holds\n~~~~~~~~\n\nOne.\n\nIt ends\n~~~~~~~\n\nTwo.\n"));
  EXPECT_THAT(SpeechText(*reading.lesson).words_of_page(reading.lesson->stages[0], 1, 2),
              "A. It holds. One. It ends. Two.");
}

TEST(Transcript, TellsNeitherHintsNorAnswers) {
  EXPECT_THAT(transcript_of(lesson(), {}), Not(HasSubstr("secret")));
}

TEST(Transcript, HasTheStagesAskedFor) {
  const std::string text = transcript_of(lesson(), {"second"});
  EXPECT_THAT(text, HasSubstr("2. The second stage"));
  EXPECT_THAT(text, Not(HasSubstr("first stage")));
}

TEST(Transcript, SaysOnceWhatIsDrawn) {
  std::string with_marks = kLesson;
  with_marks += R"lesson(
# Drawn {drawn}
```scene
trails = [{ of = "omega", on = "sphere" }]
arrows = [{ of = "ddt(omega)", at = "omega", tex = 'a' }, { of = "omega", tex = "" }]
angles = [{ from = "ez", to = "omega", tex = 'b' }]
planes = [{ normal = "omega" }]
notes  = [{ text = "the tip of $c$", at = "omega" }]
```
---
More of it.
)lesson";
  const LessonReading reading = check_lesson(with_marks, "spoken.md");
  ASSERT_TRUE(reading.lesson) << to_string(reading.diagnostics.front());
  std::string text = transcript_of(*reading.lesson, {"drawn"});
  std::replace(text.begin(), text.end(), '\n', ' ');
  for (std::size_t at; (at = text.find("  ")) != text.npos;) text.erase(at, 1);
  EXPECT_THAT(
      text,
      HasSubstr(
          "Drawn: the trail of the direction of vector omega on the unit sphere; the arrow of a at the "
          "tip of vector omega; the arrow of vector omega; the angle b from axis z to vector omega; the "
          "plane normal to vector omega; the note \"the tip of c\" at the tip of vector omega."));
  EXPECT_EQ(text.find("Drawn: "), text.rfind("Drawn: ")) << "a step goes on with it";
}

// 28 November 2026: "a line from the tip of minus 1.1 e hat sub 1 minus 1.1 e hat sub 2 to …".
TEST(Transcript, NoArithmeticOfWhatIsMadeForThePicture) {
  std::string with_marks = kLesson;
  with_marks += R"lesson(
# Drawn {drawn}
```scene
arrows = [{ of = "omega", at = "0.3*ex" }, { of = "2*ey", tex = 'a' }, { of = "ez/2", tex = "" }]
angles = [{ from = "0.5*ez + ex", to = "omega", tex = 'b' }, { from = "2*ez + ex", to = "omega", tex = "" }]
lines = [{ from = "-1.1*ex", to = "1.1*ex" }, { from = "-1.1*ey", to = "1.1*ey" }, { from = "omega", to = "dot(omega, ez)*ez" }]
planes = [{ normal = "cross(omega, ez)" }]
notes  = [{ text = "here", at = "0.6*(omega/norm(omega) + ez)" }]
```
)lesson";
  const LessonReading reading = check_lesson(with_marks, "spoken.md");
  ASSERT_TRUE(reading.lesson) << to_string(reading.diagnostics.front());
  EXPECT_EQ(
      SpeechText(*reading.lesson).words_of_marks(reading.lesson->stages[2].steps[0]),
      "the arrow of vector omega; the arrow of a; an arrow; the angle b; an angle; a line at the tip of "
      "vector omega; 2 dashed lines; the plane of vector omega and axis z; the note \"here\".");
}

std::string marks_of(const std::string& front_matter, const std::string& text) {
  const LessonReading reading = check_lesson(
      "+++\nformat = 1\nid = \"marks\"\ntitle = \"Marks\"\n" + front_matter + "\n+++\n" + text, "marks.md");
  EXPECT_TRUE(reading.lesson) << to_string(reading.diagnostics.front());
  const Stage& last = reading.lesson->stages.back();
  return SpeechText(*reading.lesson).words_of_marks(last.steps.back());
}

// 28 November 2026: "at the tip of part of L along omega", and capital omega before a line had it.
TEST(Transcript, MarksHaveNamesThatTheFigureOrTheTextShows) {
  const std::string words =
      "[define]\nmain = { means = \"I1*omega\", tex = '\\vec k', say = \"a part\", unit = \"kg m²/s\" }";
  const std::string scene =
      "```scene\narrows = [{ of = \"main\", tex = 'I_1\\vec\\omega' }, { of = \"L\", at = \"main\" }]\n"
      "trails = [{ of = \"main\" }]\nangles = [{ from = \"e3\", to = \"L\", tex = '\\theta' }]\n```\n";
  EXPECT_EQ(marks_of(words, "# A {a}\n" + scene),
            "the trail of the tip of I sub 1 vector omega; the arrow of I sub 1 vector omega; the arrow of "
            "vector L at the tip of I sub 1 vector omega; the angle theta from axis 3 to vector L.");
  const std::string trail = "```scene\ntrails = [{ of = \"main\" }]\n```\n";
  EXPECT_EQ(marks_of(words, "# A {a}\n" + trail), "a trail.") << "no reader knows k yet";
  EXPECT_EQ(marks_of("[define]\nt1 = { means = \"1*e1\", tex = 't_1', say = \"axis 1\", unit = \"1\" }",
                     "# A {a}\n```scene\ntrails = [{ of = \"t1\" }]\n```\n"),
            "the trail of the tip of axis 1.");
  EXPECT_EQ(marks_of(words, "# A {a}\nCall it $\\vec k$.\n\n---\n" + trail),
            "the trail of the tip of vector k.");
  EXPECT_EQ(marks_of("", "# A {a}\n```scene\narrows = [{ of = \"e1\", tex = '\\text{mark}' }]\n```\n"),
            "the arrow \"mark\".");
}

// 28 November 2026: twelve times "a line from the tip of the first corner of the box to …".
TEST(Transcript, MarksOfOneKindAreToldTogether) {
  const std::string corners =
      "[define]\na = \"e1 + e2 + e3\"\nb = \"e1 + e2 - e3\"\nc = \"e1 - e2 + e3\"\nd = \"e1 - e2 - e3\"";
  EXPECT_EQ(
      marks_of(corners,
               "# A {a}\n```scene\nlines = [{ from = \"a\", to = \"b\" }, { from = \"c\", to = \"d\" }, { "
               "from = \"a\", "
               "to = \"c\" }, { from = \"b\", to = \"d\" }, { from = \"-a\", to = \"-b\" }, { from = \"-c\", "
               "to = \"-d\" }, "
               "{ from = \"-a\", to = \"-c\" }, { from = \"-b\", to = \"-d\" }, { from = \"a\", to = \"-d\" "
               "}, { from = "
               "\"b\", to = \"-c\" }, { from = \"c\", to = \"-b\" }, { from = \"d\", to = \"-a\" }]\n```\n"),
      "the twelve dashed edges of a box.");
  EXPECT_EQ(
      marks_of(
          "",
          "# A {a}\n```scene\narrows = [{ of = \"w1*e1\", tex = \"\" }, { of = \"w2*e2\", at = "
          "\"w1*e1\", tex = \"\" }]\nangles = [{ from = \"cross(omega, L)\", to = \"L\", tex = '' }]\n```\n"),
      "a chain of 2 arrows from tip to tip; a right angle.");
}

// 28 November 2026: "the body axes 1, 2, 3, … the note 1, the note 2 and the note 3".
TEST(Transcript, WhatAnOverlaySaysIsNotSaidAgain) {
  EXPECT_EQ(
      marks_of(
          "",
          "# A {a}\n```scene\nshow = [\"axes-body\", \"omega\"]\narrows = [{ of = \"omega\" }, { of = "
          "\"L\" }]\nnotes = [{ text = \"1\", at = \"1.3*e1\" }, { text = \"north\", at = \"ez\" }]\n```\n"),
      "the arrow of vector L; the note \"north\" at the tip of axis z.");
}

TEST(SpeechText, SaysAPage) {
  const Lesson l = lesson();
  EXPECT_THAT(SpeechText(l).words_of_page(l.stages[0], 1, 1),
              testing::AllOf(testing::StartsWith("The first stage. The vector omega is long:"),
                             HasSubstr("Equation (7): "), HasSubstr("Choice B: zero.")));
}

std::string spoken_prose(const std::string& prose) {
  std::string text = kLesson;
  text.replace(text.find("More words."), std::string("More words.").size(), prose);
  LessonReading reading = check_lesson(text, "spoken.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  const Lesson& l = *reading.lesson;
  return SpeechText(l).words(std::get<Prose>(l.stages[1].steps[0].blocks[0]).text);
}

// 27 November 2026: "Omega sub 1" began a sentence, and was heard and read as Ω.
TEST(SpeechText, TellsCapitalGreekFromSmallAtTheStartOfASentence) {
  EXPECT_EQ(spoken_prose("$\\lambda$ is small. $\\Omega$ is large."),
            "lambda is small. Capital omega is large.");
}

// 27 November 2026: an alternative text said "Not confirmed, there is no motion here" where the picture said
// that it was checked.
TEST(SpeechText, KnowsTheMotionOfWhatIsMeasured) {
  const LessonReading reading = check_lesson(
      "+++\nformat = 1\nid = \"measured\"\ntitle = \"Measured\"\n[symbols]\nT = { tex = 'T', say = "
      "\"energy\" }\n"
      "[scene]\nbody = \"textbook\"\nomega = [0.9, 0.4, 1.0]\n+++\n# A stage {one}\n```math size measured\n"
      "\\frac{dT}{dt} = 0\n```\n```scene\nat = 1\n```\n",
      "measured.md");
  ASSERT_TRUE(reading.lesson);
  EXPECT_THAT(SpeechText(*reading.lesson).words_of_page(reading.lesson->stages[0], 1, 1),
              HasSubstr("Checked on this motion"));
}

// 28 November 2026: "A point P of the rim" was read "a point a point of the rim of the body cone of the rim".
TEST(SpeechText, SaysLettersInLinesOfText) {
  EXPECT_EQ(spoken_prose("The angular velocity $\\vec\\omega$ is."), "The angular velocity vector omega is.");
  EXPECT_EQ(spoken_prose("It. $\\vec\\omega$ is"), "It. Vector omega is");
  EXPECT_EQ(spoken_prose("e.g.\u00A0$\\vec\\omega$"), "e.g.\u00A0vector omega");
  EXPECT_EQ(spoken_prose("The vector $\\vec\\omega$"), "The vector omega");
  EXPECT_EQ(spoken_prose("The **vector** $\\vec\\omega$"), "The vector omega");
  EXPECT_EQ(spoken_prose("Rotovector$\\vec\\omega$"), "Rotovectorvector omega") << "another word";
  EXPECT_EQ(spoken_prose("$\\omega = |\\vec\\omega|$"), "omega equals magnitude of vector omega");
  EXPECT_EQ(spoken_prose("$e$ is"), "e is");
  EXPECT_EQ(spoken_prose("In $S$ $S$ is"), "In S S is");
}

// 28 November 2026: a vector and its magnitude had one name, in German L and ω too.
TEST(SpeechText, TellsAVectorFromItsMagnitude) {
  const auto said = [](const std::string& language, const std::string& symbol) {
    const LessonReading reading =
        check_lesson("+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n" + language + "[symbols]\n" + symbol +
                         "\n+++\n# A {a}\n```math e\n\\vec L = \\vec M + L\n```\n",
                     "x.md");
    EXPECT_TRUE(reading.lesson) << to_string(reading.diagnostics.front());
    return SpeechText(*reading.lesson).words(*blocks_of<Equation>(reading.lesson->stages[0].steps[0]).at(0));
  };
  EXPECT_EQ(said("", "L = { tex = '\\vec L', say = 'angular momentum' }"),
            "Equation: vector L equals vector M plus L.");
  EXPECT_EQ(said("", "L = { tex = '\\vec L', say = 'L' }"), "Equation: vector L equals vector M plus L.");
  EXPECT_EQ(said("language = 'de'\n", "L = { tex = '\\vec L', say = 'L' }"),
            "Gleichung: Vektor L gleich Vektor M plus L.");
}

constexpr const char* kNumbers = R"(+++
format = 1
id = "numbers"
title = "Numbers"
[body.spun]
moments = [1.5, 1.5, 2]
[scene]
body = "spun"
omega = [0, 0, 3]
torque = "body:0,0,2"
at = 1
+++
# A stage {one}
It spins at $\live[unit={rad/s}]{w3}$, once at $\value{3}{3*w3/4}$.

| time | spin |
|------|-----:|
| now  | $\live{w3}$ |
| | $-\omega_3$ |
```scene
caption = 'Spin $\live{w3}$'
```

---

Later.
```scene
at = 2
```
)";

// dω3/dt = 1 rad/s²: 4 rad/s at the still of the first step, 5 at that of the second.
TEST(Transcript, HasTheNumbersOfTheStills) {
  LessonReading reading = check_lesson(kNumbers, "numbers.md");
  ASSERT_TRUE(reading.lesson) << to_string(reading.diagnostics.front());
  const std::string text = transcript_of(*reading.lesson, {});
  EXPECT_THAT(text, HasSubstr("\nIt spins at 4.00 rad/s, once at 3.\n"));
  EXPECT_THAT(
      text,
      HasSubstr(
          "\nTable with the columns time, spin.\n  time: now; spin: 4.00.\n  spin: Minus omega sub 3.\n"));
  EXPECT_THAT(text, HasSubstr("Figure: Spin 4.00\n"));
  const SpeechText speech(*reading.lesson);
  EXPECT_EQ(speech.words_of_figure(reading.lesson->stages[0].steps[0]).at(0).caption, "Spin 4.00");
  EXPECT_EQ(speech.words_of_figure(reading.lesson->stages[0].steps[1]).at(0).caption, "Spin 5.00")
      << "the caption goes on, the scene too";
}

constexpr const char* kTable = R"(+++
format = 1
id = "table"
title = "Table"
[body.spun]
moments = [1.5, 1.5, 2]
[scene]
body = "spun"
omega = [0, 0, 3]
+++
# A {a}
```table
columns = [{ head = "body" }, { head = "spin", of = "w3", unit = "rad/s" }, { of = "body_precession" }]
rows = [{ head = "spun" }, { head = "pushed", omega = [0, 0, 6], torque = "body:0,0,1" }]
```
```scene
show = ["omega"]
```
)";

TEST(Transcript, SaysComputedTablesRowByRow) {
  LessonReading reading = check_lesson(kTable, "table.md");
  ASSERT_TRUE(reading.lesson) << to_string(reading.diagnostics.front());
  EXPECT_THAT(
      transcript_of(*reading.lesson, {}),
      HasSubstr("\nTable with the columns body, spin (rad/s), precession in the body.\n  body: spun; spin "
                "(rad/s): 3.00; precession in the body: 1.00.\n  body: pushed; spin (rad/s): 6.00; "
                "precession in the body: Not defined.\n"));
}

std::size_t widest(const std::string& text) {
  std::size_t most = 0, line = 0;
  for (char c : text) {
    line = c == '\n' ? 0 : line + ((static_cast<unsigned char>(c) & 0xC0) != 0x80 ? 1 : 0);
    most = std::max(most, line);
  }
  return most;
}

TEST(Wrapped, FillsLinesToTheirLimit) {
  std::string words;
  for (int i = 0; i < 60; ++i) words += "ωωω ωω ";
  const std::string text = wrapped(words, "> ");
  EXPECT_LE(widest(text), kTranscriptColumns);
  EXPECT_GT(widest(text), kTranscriptColumns - 4);
  EXPECT_THAT(text, testing::StartsWith("> ωωω"));
  EXPECT_THAT(text, HasSubstr("\n  ωω"));
  EXPECT_TRUE(text.ends_with('\n'));
}

TEST(Wrapped, AWordThatIsTooLongHasALineOfItsOwn) {
  const std::string word(200, 'x');
  EXPECT_EQ(wrapped("a " + word + " b", ""), "a\n" + word + "\nb\n");
}

TEST(Wrapped, NoWordsAreNoLine) {
  EXPECT_EQ(wrapped("", "- "), "");
  EXPECT_EQ(wrapped(" \n ", ""), "");
}

constexpr const char* kReferring = R"(+++
format = 1
id = "referring"
title = "A lesson that refers"
[references]
LL = "Landau, Lifshitz: Mechanics"
GO = "Goldstein: Classical Mechanics"
[labels]
said = "The book"
+++
# One {one}
By [](#e), as [cite: LL, §35] has it[^n].

```math e
x = 0 \tag{7}
```

> [!said] So it is.[^n]

> [!quote Newton] Hypotheses non fingo.

> [!derivation Why] Because of $\eqref{e}$.

[^n]: Not all.
)";

TEST(Transcript, HasFootnotesCallOutsAndWhatIsCited) {
  LessonReading reading = check_lesson(kReferring, "referring.md");
  ASSERT_TRUE(reading.lesson) << to_string(reading.diagnostics.front());
  const std::string text = transcript_of(*reading.lesson, {});
  std::size_t at = 0;
  for (const char* part :
       {"By (7), as [LL, §35] has it¹.\n", "Equation (7): x equals 0.\n", "  > The book: So it is.¹\n",
        "  > Quote: Hypotheses non fingo. — Newton.\n", "  > Derivation: Why. Because of (7).\n",
        "¹ Not all.\n", "References\n----------\n\n[LL] Landau, Lifshitz: Mechanics\n"}) {
    const std::size_t found = text.find(part, at);
    ASSERT_NE(found, std::string::npos) << part << "\nin\n" << text;
    at = found;
  }
  EXPECT_THAT(text, Not(HasSubstr("Goldstein"))) << "it is not cited";
  EXPECT_THAT(SpeechText(*reading.lesson).words_of_page(reading.lesson->stages[0], 1, 1),
              HasSubstr("¹ Not all."));
}

std::string told(const std::string& scene) {
  const std::string text =
      "+++\nformat = 1\nid = 'a'\ntitle = 'A'\n+++\n# S {s}\n\n```scene\n" + scene + "\n```\n";
  LessonReading reading = check_lesson(text, "a.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
  return transcript_of(*reading.lesson, {});
}

TEST(Transcript, ScenesSideBySideHaveALineEachUnlessTheirCaptionIsOne) {
  const std::string own = told("scenes = [{ caption = 'slow' }, {}, { caption = 'fast' }]");
  EXPECT_THAT(own, HasSubstr("\nFigure 1 of 3: slow\n"));
  EXPECT_THAT(own, HasSubstr("\nFigure 3 of 3: fast\n"));
  EXPECT_THAT(own, Not(HasSubstr("2 of 3")));
  const std::string common = told("caption = 'both'\nscenes = [{}, { omega = [0, 0, 1] }]");
  EXPECT_THAT(common, HasSubstr("\nFigure: both\n"));
  EXPECT_THAT(common, Not(HasSubstr("of 2")));
  const std::string numbers =
      told("body = 'book'\ncaption = '$T = \\live{T}$'\nscenes = [{}, { omega = [0, 0, 9] }]");
  EXPECT_THAT(numbers, HasSubstr("\nFigure 1 of 2: T")) << "each has the number of its own motion";
  EXPECT_THAT(numbers, HasSubstr("\nFigure 2 of 2: T"));
}

TEST(Transcript, TheRangeOfWhatIsVariedIsSaid) {
  const std::string text =
      told("caption = 'faster'\nomega = [0, 0.1, 3]\nvary = { omega3 = { from = 1, to = 9 } }");
  EXPECT_THAT(text, HasSubstr("\nFigure: faster\n"));
  EXPECT_THAT(text, testing::ContainsRegex("\nVaried: .* from 1 to 9 rad/s\n"));
}

}  // namespace
}  // namespace polhode
