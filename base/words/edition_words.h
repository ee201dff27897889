// SPDX-License-Identifier: MIT
// What pages of text, and the index of a site, say besides the lesson's own words. Their scripts find theirs
// in the page (assets/text_edition/reader.html).
#pragma once

#include "base/words/phrase.h"

#include <array>

namespace polhode::words {

inline constexpr Phrase kOutcomes{"What you will be able to do", "Lernziele"};
inline constexpr Phrase kPrerequisites{"What you should know", "Voraussetzungen"};
inline constexpr Phrase kToTheText{"To the text", "Zum Text"};
inline constexpr Phrase kContents{"Contents", "Inhalt"};
inline constexpr Phrase kAllLessons{"All lessons", "Alle Lektionen"};
inline constexpr Phrase kNextLesson{"The next lesson: {0}", "Die nächste Lektion: {0}"};
/// Behind the title of a lesson, by the language that it is in, where the page is in another one.
inline constexpr Phrase kInEnglish{"in English", "auf Englisch"}, kInGerman{"in German", "auf Deutsch"};
inline constexpr Phrase kInAnotherLanguage{"This lesson in English", "Diese Lektion auf Deutsch"};
inline constexpr Phrase kEquationLabel{"Equation {0}", "Gleichung {0}"};
inline constexpr Phrase kEquationInBrackets{"Equation ({0})", "Gleichung ({0})"};
inline constexpr Phrase kEquationAbove{"The equation above", "Die Gleichung oben"};
inline constexpr Phrase kInTheFigure{"Both sides in the figure, at {0}: {1}",
                                     "Beide Seiten in der Abbildung, bei {0}: {1}"};

// Questions.
inline constexpr Phrase kPredictLabel{"Question: predict", "Frage: Vorhersage"};
inline constexpr Phrase kCheck{"Check", "Prüfen"};
inline constexpr Phrase kHint{"Hint", "Hinweis"};
inline constexpr Phrase kHintNumber{"Hint {0}", "Hinweis {0}"};
inline constexpr Phrase kADerivation{"A derivation", "Eine Herleitung"};
inline constexpr Phrase kAnswer{"Answer", "Antwort"};
inline constexpr Phrase kYourAnswer{"Your answer", "Antwort"};
inline constexpr Phrase kPlace{"place", "Platz"};
inline constexpr Phrase kReplyTo{"On {0}:", "Zu {0}:"};
inline constexpr Phrase kTyped{"{0}, typed {1}", "{0}, eingegeben {1}"};
inline constexpr Phrase kForExampleTyped{"For example {0}", "Zum Beispiel {0}"};

inline constexpr Phrase kRight{"Right.", "Richtig."};
inline constexpr Phrase kNotRight{"Not right.", "Nicht richtig."};

/// The name of what the keyboard can scroll.
inline constexpr Phrase kWider{"Wider than the page; scrolls",
                               "Breiter als die Seite; lässt sich verschieben"};

// What the page's script says, by the names it asks for.
inline constexpr auto kEditionScript = std::to_array<NamedPhrase>({
    {"pickOne", {"Pick one of the choices.", "Eine der Antworten auswählen."}},
    {"right", kRight},
    {"notRight", kNotRight},
    {"eachAPlace", {"Give each of them a place of its own.", "Jedem Schritt einen eigenen Platz geben."}},
    {"aNumber", {"Type a number, such as 1.5 or 2e-3.", "Eine Zahl eingeben, etwa 1,5 oder 2e-3."}},
    {"aNumberIn",
     {"Type a number in {0}, such as 1.5 or 2e-3.", "Eine Zahl in {0} eingeben, etwa 1,5 oder 2e-3."}},
    {"copyTexOf", {"Copy the TeX of equation {0}", "TeX der Gleichung {0} kopieren"}},
    {"copied", {"copied", "kopiert"}},
    {"wider", kWider},
    {"larger", {"Larger", "Größer"}},
    {"smaller", {"Smaller", "Kleiner"}},
});

// The index of a site, in the language of its first lesson.
inline constexpr Phrase kSiteTitle{"Lectures on the rotation of a rigid body",
                                   "Vorlesungen über die Rotation starrer Körper"};
inline constexpr Phrase kSiteLead{
    "Each equation stands beside a body that moves by it, and below it whether it was proved. The pages can "
    "be read on any screen, by a screen reader, without network and without script.",
    "Neben jeder Gleichung steht ein Körper, der sich nach ihr bewegt, und unter ihr, ob sie bewiesen ist. "
    "Die Seiten lassen sich auf jedem Bildschirm und mit einer Sprachausgabe lesen, ohne Netz und Skript."};
inline constexpr Phrase kToTheLessons{"To the lessons", "Zu den Lektionen"};
inline constexpr Phrase kFindHeading{"Find a heading or an equation",
                                     "Eine Überschrift oder Gleichung suchen"};
inline constexpr Phrase kHeadingsAndEquations{"Headings and equations", "Überschriften und Gleichungen"};
inline constexpr Phrase kThrowABody{
    "<a href=\"{0}\">Throw a body</a> yourself: choose it, start it, and see how it turns.",
    "Selbst <a href=\"{0}\">einen Körper werfen</a>: ihn wählen, ihm einen Anstoß geben und sehen, wie er "
    "sich dreht."};
inline constexpr Phrase kToTakeAlong{"To take along: {0}", "Zum Mitnehmen: {0}"};
inline constexpr Phrase kSlidesForBrowsers{"slides for a browser", "Folien für den Browser"};
inline constexpr Phrase kSlidesAsPdf{"slides as PDF", "Folien als PDF"};
inline constexpr Phrase kSlidesForPrograms{"slides for PowerPoint and LibreOffice",
                                           "Folien für PowerPoint und LibreOffice"};
inline constexpr Phrase kAFilm{"a film", "ein Film"};
// What its script says, by the names it asks for.
inline constexpr auto kSiteScript = std::to_array<NamedPhrase>({
    {"nothing", {"Nothing found.", "Nichts gefunden."}},
    {"one", {"1 place", "1 Stelle"}},
    {"several", {"{0} places", "{0} Stellen"}},
    {"wider", kWider},
});

}  // namespace polhode::words
