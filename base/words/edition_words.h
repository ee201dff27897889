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
inline constexpr Phrase kInAnotherLanguage{"This lesson in English", "Diese Lektion auf Deutsch"};
inline constexpr Phrase kEquationLabel{"Equation {0}", "Gleichung {0}"};
inline constexpr Phrase kEquationInBrackets{"Equation ({0})", "Gleichung ({0})"};
inline constexpr Phrase kEquationAbove{"The equation above", "Die Gleichung oben"};
inline constexpr Phrase kInTheFigure{"In the figure, at {0}: {1}", "In der Abbildung, bei {0}: {1}"};

// Questions.
inline constexpr Phrase kPredictLabel{"Question: predict", "Frage: Vorhersage"};
inline constexpr Phrase kCheck{"Check", "Prüfen"};
inline constexpr Phrase kHint{"Hint", "Hinweis"};
inline constexpr Phrase kHintNumber{"Hint {0}", "Hinweis {0}"};
inline constexpr Phrase kADerivation{"A derivation", "Eine Herleitung"};
inline constexpr Phrase kAnswer{"Answer", "Antwort"};
inline constexpr Phrase kYourAnswer{"Your answer", "Antwort"};
inline constexpr Phrase kYourAnswerIn{"Your answer, in {0}", "Antwort, in {0}"};
inline constexpr Phrase kToWithinText{"to within {0}", "auf {0} genau"};
inline constexpr Phrase kPlace{"place", "Platz"};
inline constexpr Phrase kReplyTo{"To {0}:", "Zu {0}:"};
inline constexpr Phrase kTyped{"{0}, typed {1}", "{0}, eingegeben {1}"};
inline constexpr Phrase kThen{" then ", " dann "};
inline constexpr Phrase kForExampleTyped{"For example {0}", "Zum Beispiel {0}"};

// What the page's script says, by the names it asks for.
inline constexpr auto kEditionScript = std::to_array<NamedPhrase>({
    {"pickOne", {"Pick one of the choices.", "Eine der Antworten auswählen."}},
    {"right", {"Right.", "Richtig."}},
    {"notRight", {"Not right.", "Nicht richtig."}},
    {"eachAPlace", {"Give each of them a place of its own.", "Jedem Schritt einen eigenen Platz geben."}},
    {"aNumber", {"Type a number, such as 1.5 or 2e-3.", "Eine Zahl eingeben, etwa 1,5 oder 2e-3."}},
    {"aNumberIn",
     {"Type a number in {0}, such as 1.5 or 2e-3.", "Eine Zahl in {0} eingeben, etwa 1,5 oder 2e-3."}},
    {"copyTex", {"Copy the TeX", "TeX kopieren"}},
    {"copyTexOf", {"Copy the TeX of equation {0}", "TeX der Gleichung {0} kopieren"}},
    {"copied", {"copied", "kopiert"}},
    {"wider", {"Wider than the page; scrolls", "Breiter als die Seite; lässt sich verschieben"}},
    {"larger", {"Larger", "Größer"}},
    {"smaller", {"Smaller", "Kleiner"}},
});

}  // namespace polhode::words
