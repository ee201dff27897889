// SPDX-License-Identifier: MIT
// What stands around the slides of an HTML deck: its buttons, its help, and what its script says. The names
// are those of the places in assets/deck/deck.html.
#pragma once

#include "base/words/phrase.h"

#include <array>

namespace polhode::words {

inline constexpr auto kDeck = std::to_array<NamedPhrase>({
    {"slides-label", {"Slides", "Folien"}},
    {"controls", {"Slide controls", "Steuerung der Folien"}},
    {"back", {"Back", "Zurück"}},
    {"next", {"Next", "Weiter"}},
    {"notes", {"Notes", "Notizen"}},
    {"overview", {"Overview", "Übersicht"}},
    {"full-screen", {"Full screen", "Vollbild"}},
    {"help", {"Help", "Hilfe"}},
    {"keys", {"Keys", "Tasten"}},
    {"space-key", {"Space", "Leertaste"}},
    {"page-down-key", {"Page Down", "Bild ab"}},
    {"page-up-key", {"Page Up", "Bild auf"}},
    {"backspace-key", {"Backspace", "Rücktaste"}},
    {"home-key", {"Home", "Pos1"}},
    {"end-key", {"End", "Ende"}},
    {"enter-key", {"Enter", "Eingabe"}},
    {"to-next", {"next slide", "nächste Folie"}},
    {"to-previous", {"previous slide", "vorige Folie"}},
    {"to-stages", {"next, previous stage", "nächster, voriger Abschnitt"}},
    {"to-ends", {"first, last slide", "erste, letzte Folie"}},
    {"to-number", {"slide 12", "Folie 12"}},
    {"for-notes", {"notes: the words of the slide", "Notizen: die Worte der Folie"}},
    {"for-overview", {"overview; arrows choose, ", "Übersicht; Pfeile wählen, "}},
    {"opens", {" opens", " öffnet"}},
    {"for-tab",
     {"to the notes, which arrows scroll, and to the buttons",
      "zu den Notizen, die sich mit den Pfeiltasten bewegen lassen, und zu den Schaltflächen"}},
    {"for-full-screen", {"full screen", "Vollbild"}},
    {"for-help", {"this help", "diese Hilfe"}},
    {"for-escape", {"closes what is open", "schließt, was offen ist"}},
    {"for-hands",
     {"Click or tap a slide to go on, its left third to go back; or swipe.",
      "Klicken oder Tippen auf eine Folie führt weiter, auf ihr linkes Drittel zurück; oder wischen."}},
    {"close", {"Close", "Schließen"}},
});

// What the script says.
inline constexpr auto kDeckScript = std::to_array<NamedPhrase>({
    {"slide", {"Slide {0} of {1}: {2}", "Folie {0} von {1}: {2}"}},
    {"typed", {"Slide {0}", "Folie {0}"}},
    {"none", {"There is no slide {0}; the last is {1}", "Es gibt keine Folie {0}; die letzte ist {1}"}},
});

}  // namespace polhode::words
