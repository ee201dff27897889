// SPDX-License-Identifier: MIT
// What alternative texts, transcripts and notes of slides say besides the lesson's own words.
#pragma once

#include "base/words/phrase.h"

namespace polhode::words {

// Alternative texts of figures.
inline constexpr Phrase kSeenFromBoth{"Seen from space and from the body, side by side",
                                      "Vom Raumsystem und vom Körper aus gesehen, nebeneinander"};
inline constexpr Phrase kSeenFromBody{"Seen from the body", "Vom Körper aus gesehen"};
inline constexpr Phrase kSeenFromSpace{"Seen from space", "Vom Raumsystem aus gesehen"};
inline constexpr Phrase kDiagrams{"Diagrams", "Diagramme"};
inline constexpr Phrase kADiagram{"A diagram", "Ein Diagramm"};
inline constexpr Phrase kNothing{"nothing", "nichts"};
inline constexpr Phrase kAnd{" and ", " und "};
inline constexpr Phrase kBodyTurnsAt{"At t = {0} s the body turns at {1} rad/s",
                                     "Zur Zeit t = {0} s dreht sich der Körper mit {1} rad/s"};
inline constexpr Phrase kOmegaAlongL{", with ω along L", ", mit ω in Richtung von L"};
inline constexpr Phrase kOmegaAwayFromL{", with ω {0}° away from L", ", ω weicht um {0}° von L ab"};
// Of the pictures of one motion at several moments.
inline constexpr Phrase kTheSameAt{"The same at t = {0} s.", "Dasselbe bei t = {0} s."};
inline constexpr Phrase kScene{"Scene {0}: ", "Szene {0}: "};
inline constexpr Phrase kAxesPoint{
    "Axis 1 of the body points {1}° away from where it pointed at t = {0} s, axis 2 {2}°, axis 3 {3}°.",
    "Achse 1 des Körpers weicht von ihrer Richtung bei t = {0} s um {1}° ab, Achse 2 um {2}°, Achse 3 um "
    "{3}°."};
inline constexpr Phrase kOmegaInBody{
    "Along axes 1, 2, 3 ω has the components {0}, {1}, {2} rad/s.",
    "Längs der Achsen 1, 2, 3 hat ω die Komponenten {0}; {1} und {2} rad/s."};
inline constexpr Phrase kLInBody{"Along axes 1, 2, 3 L has the components {0}, {1}, {2} kg m²/s.",
                                 "Längs der Achsen 1, 2, 3 hat L die Komponenten {0}; {1} und {2} kg m²/s."};
inline constexpr Phrase kPlotsAlone{"Plots alone. ", "Nur Kurven. "};
inline constexpr Phrase kTheBodyIs{"The body is {0}with principal moments {1}, {2}, {3} kg m². ",
                                   "Der Körper {0}hat die Hauptträgheitsmomente {1}; {2} und {3} kg m². "};
inline constexpr Phrase kSceneOf{"Scene {0} of {1}, side by side. ", "Szene {0} von {1}, nebeneinander. "};

// Marks.
inline constexpr Phrase kBodyAtEarlierInstant{"the body as it was at 1 earlier instant",
                                              "der Körper zu einem früheren Zeitpunkt"};
inline constexpr Phrase kBodyAtEarlierInstants{"the body as it was at {0} earlier instants",
                                               "der Körper zu {0} früheren Zeitpunkten"};
inline constexpr Phrase kAtTheTipOf{" at the tip of {0}", " an der Spitze von {0}"};
inline constexpr Phrase kThroughTheTipOf{" through the tip of {0}", " durch die Spitze von {0}"};
inline constexpr Phrase kTrailOnSphere{"the trail of the direction of {0} on the unit sphere",
                                       "die Spur der Richtung von {0} auf der Einheitskugel"};
inline constexpr Phrase kTrailOfTip{"the trail of the tip of {0}", "die Spur der Spitze von {0}"};
inline constexpr Phrase kArrowOf{"the arrow of {0}{1}", "der Pfeil {0}{1}"};
inline constexpr Phrase kAngleFromTo{"the angle {0}from {1} to {2}", "der Winkel {0}zwischen {1} und {2}"};
inline constexpr Phrase kParallelogramOf{"the parallelogram {0}of {1} and {2}",
                                         "das Parallelogramm {0}aus {1} und {2}"};
inline constexpr Phrase kLineFromTo{"a line from the tip of {0} to the tip of {1}",
                                    "eine Linie von der Spitze von {0} zu der von {1}"};
inline constexpr Phrase kPlaneNormalTo{"the plane normal to {0}{1}", "die Ebene senkrecht zu {0}{1}"};
// Of what lies where no reader knows a name for.
inline constexpr Phrase kTheAngle{"the angle {0}", "der Winkel {0}"};
inline constexpr Phrase kTheParallelogram{"the parallelogram {0}", "das Parallelogramm {0}"};
inline constexpr Phrase kLineAt{"a line at the tip of {0}", "eine Linie an der Spitze von {0}"};
inline constexpr Phrase kATrail{"a trail", "eine Spur"}, kTrails{"{0} trails", "{0} Spuren"};
inline constexpr Phrase kAnArrow{"an arrow", "ein Pfeil"}, kArrows{"{0} arrows", "{0} Pfeile"};
inline constexpr Phrase kAnAngle{"an angle", "ein Winkel"}, kAngles{"{0} angles", "{0} Winkel"};
inline constexpr Phrase kAParallelogram{"a parallelogram", "ein Parallelogramm"};
inline constexpr Phrase kParallelograms{"{0} parallelograms", "{0} Parallelogramme"};
inline constexpr Phrase kALine{"a dashed line", "eine gestrichelte Linie"};
inline constexpr Phrase kLines{"{0} dashed lines", "{0} gestrichelte Linien"};
inline constexpr Phrase kAPlane{"a plane", "eine Ebene"}, kPlanes{"{0} planes", "{0} Ebenen"};
inline constexpr Phrase kTheNote{"the note \"{0}\"{1}", "die Notiz „{0}“{1}"};

// Transcripts.
inline constexpr Phrase kTable{"Table.", "Tabelle."};
inline constexpr Phrase kTableWithColumns{"Table with the columns {0}.", "Tabelle mit den Spalten {0}."};
inline constexpr Phrase kEquation{"Equation: {0}", "Gleichung: {0}"};
inline constexpr Phrase kEquationNumber{"Equation ({0}): {1}", "Gleichung ({0}): {1}"};
inline constexpr Phrase kQuestion{"Question: ", "Frage: "};
inline constexpr Phrase kChoice{"Choice {0}: {1}", "Antwort {0}: {1}"};
inline constexpr Phrase kFigure{"Figure: ", "Abbildung: "};
inline constexpr Phrase kFigureOf{"Figure {0} of {1}: ", "Abbildung {0} von {1}: "};
inline constexpr Phrase kVaried{"Varied: ", "Verändert: "};
inline constexpr Phrase kVariedFromTo{"{0} from {1} to {2} {3}", "{0} von {1} bis {2} {3}"};
inline constexpr Phrase kPlotted{"Plotted: ", "Aufgetragen: "};
inline constexpr Phrase kDrawn{"Drawn: ", "Gezeichnet: "};
inline constexpr Phrase kPlottedAgainst{" against ", " über "};
inline constexpr Phrase kTime{"time", "der Zeit"};
inline constexpr Phrase kWithTheLevel{", with the level ", ", mit der Linie bei "};
inline constexpr Phrase kReferences{"References", "Literatur"};

}  // namespace polhode::words
