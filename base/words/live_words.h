// SPDX-License-Identifier: MIT
// What stands around a figure that moves in a page, and what its script says (assets/web/live.js and
// figures.js). The names are those by which the scripts ask for the words.
#pragma once

#include "base/words/phrase.h"

#include <array>

namespace polhode::words {

inline constexpr auto kLive = std::to_array<NamedPhrase>({
    // Its picture.
    {"live", {"Live", "Live"}},
    {"press",
     {"Live: play this figure, turn it, start it anew", "Live: Abbildung abspielen, drehen, neu beginnen"}},
    {"staysPicture", {"The figure stays a picture: {0}.", "Die Abbildung bleibt ein Bild: {0}."}},
    // Why it stays one.
    {"noProgram", {"this page was written without its program", "die Seite enthält das Programm nicht"}},
    {"tooOld",
     {"this browser is too old to run the program in the page",
      "dieser Browser ist zu alt für das Programm der Seite"}},
    {"noWebGl",
     {"this browser draws no pictures in space (it has no WebGL2)",
      "dieser Browser zeichnet keine räumlichen Bilder (ihm fehlt WebGL2)"}},
    {"noWebGlNow",
     {"this browser draws no pictures in space at the moment (WebGL2: {0})",
      "dieser Browser zeichnet gerade keine räumlichen Bilder (WebGL2: {0})"}},
    {"graphicsLost",
     {"the browser has taken the graphics away; press again to go on",
      "der Browser hat die Grafik beendet; noch einmal drücken, um fortzufahren"}},
    {"noFile", {"{0} does not lie beside this page", "{0} liegt nicht neben der Seite"}},
    {"doesNotStart", {"the program does not start ({0})", "das Programm startet nicht ({0})"}},
    // The figure.
    {"canvas", {"The figure, live", "Die Abbildung, live"}},
    {"figure",
     {"Live figure. Arrow keys turn it, plus and minus zoom, Space plays.",
      "Live-Abbildung. Pfeiltasten drehen sie, Plus und Minus ändern die Größe, die Leertaste spielt ab."}},
    {"flatFigure", {"Live figure. Space plays.", "Live-Abbildung. Die Leertaste spielt ab."}},
    // Its controls.
    {"play", {"Play", "Abspielen"}},
    {"pause", {"Pause", "Anhalten"}},
    {"left", {"Turn to the left", "Nach links drehen"}},
    {"right", {"Turn to the right", "Nach rechts drehen"}},
    {"up", {"Turn up", "Nach oben drehen"}},
    {"down", {"Turn down", "Nach unten drehen"}},
    {"nearer", {"Nearer", "Näher"}},
    {"farther", {"Farther", "Weiter weg"}},
    {"reset", {"As in the lesson", "Wie in der Lektion"}},
    {"copyLink", {"Copy link", "Link kopieren"}},
    {"picture", {"Picture", "Bild"}},
    {"anew", {"Start it anew", "Neu beginnen"}},
    {"anewHint",
     {"Take the tip of ω in the figure, or set its components in the body at t = 0:",
      "Die Spitze von ω in der Abbildung ziehen oder ihre Komponenten im Körper für t = 0 einstellen:"}},
    {"numbers", {"Numbers", "Zahlen"}},
    {"copied",
     {"The link is copied: it opens what is shown now.",
      "Der Link ist kopiert: Er öffnet, was jetzt zu sehen ist."}},
    {"inAddress",
     {"The link stands in the address line: it opens what is shown now.",
      "Der Link steht in der Adresszeile: Er öffnet, was jetzt zu sehen ist."}},
});

inline constexpr Phrase kLiveNoScript{
    "The figures are pictures here. Where the page may run its script, which sends nothing, they can be "
    "played, turned and started anew.",
    "Die Abbildungen sind hier Bilder. Wo die Seite ihr Skript ausführen darf, das nichts sendet, lassen sie "
    "sich abspielen, drehen und neu beginnen."};

}  // namespace polhode::words
