// SPDX-License-Identifier: MIT
// What alternative texts, transcripts and notes of slides say besides the lesson's own words.
#pragma once

#include "base/words/phrase.h"

#include <array>
#include <string_view>

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
inline constexpr Phrase kBodyTurnsAt{"At t = {0} the body turns at {1}",
                                     "Zur Zeit t = {0} dreht sich der Körper mit {1}"};
inline constexpr Phrase kOmegaAlongL{", with ω along L", ", mit ω in Richtung von L"};
inline constexpr Phrase kOmegaAwayFromL{", with ω {0} away from L", ", ω weicht um {0} von L ab"};
// Of the pictures of one motion at several moments.
inline constexpr Phrase kTheSameAt{"The same at t = {0}.", "Dasselbe bei t = {0}."};
inline constexpr Phrase kScene{"Scene {0}: ", "Szene {0}: "};
inline constexpr Phrase kAxisPoints{"Axis {0} of the body points {1} away from where it pointed at t = {2}.",
                                    "Achse {0} des Körpers weicht um {1} von ihrer Richtung bei t = {2} ab."};
inline constexpr Phrase kArrowAPoints{"The arrow A points {0} away from where it pointed at t = {1}.",
                                      "Der Pfeil A weicht um {0} von seiner Richtung bei t = {1} ab."};
inline constexpr Phrase kCentreIsAway{"The centre of mass is {0} from where it was at t = {1}.",
                                      "Der Massenmittelpunkt ist {0} von seinem Ort bei t = {1} entfernt."};
inline constexpr Phrase kWentRoundL{"Since t = {0}, {1} has gone round L {2}.",
                                    "Seit t = {0} ist {1} {2} um L gelaufen."};
inline constexpr Phrase kBothWentRoundL{"Since t = {0}, {1} has gone round L {2}, and {3} {4}.",
                                        "Seit t = {0} ist {1} {2} um L gelaufen, und {3} {4}."};
inline constexpr Phrase kOnce{"once", "einmal"};
inline constexpr Phrase kSoManyTimes{"{0} times", "{0} Mal"};
inline constexpr Phrase kWentRoundAxis{
    "Since t = {0}, {1} has gone {2} round axis {3}, {4} seen from its tip.",
    "Seit t = {0} ist {1} {2} um Achse {3} gelaufen, {4}, von ihrer Spitze aus gesehen."};
inline constexpr Phrase kAnticlockwise{"anticlockwise", "gegen den Uhrzeigersinn"};
inline constexpr Phrase kClockwise{"clockwise", "im Uhrzeigersinn"};
inline constexpr Phrase kOmegaInBody{
    "Along axes 1, 2, 3 ω has the components {0}, {1} and {2} radians per second.",
    "Längs der Achsen 1, 2, 3 hat ω die Komponenten {0}; {1} und {2} Radiant pro Sekunde."};
inline constexpr Phrase kLInBody{
    "Along axes 1, 2, 3 L has the components {0}, {1} and {2} kilogram square metres per second.",
    "Längs der Achsen 1, 2, 3 hat L die Komponenten {0}; {1} und {2} Kilogrammquadratmeter pro Sekunde."};
inline constexpr Phrase kPlotsAlone{"Plots alone. ", "Nur Kurven. "};
inline constexpr Phrase kTheBodyIs{
    "The {0} has the principal moments {1}, {2} and {3} kilogram square metres. ",
    "Der {0} hat die Hauptträgheitsmomente {1}; {2} und {3} Kilogrammquadratmeter. "};
inline constexpr Phrase kBody{"body", "Körper"};
inline constexpr Phrase kSceneOf{"Scene {0} of {1}. ", "Szene {0} von {1}. "};

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
inline constexpr Phrase kArrowNamed{"the arrow {0}{1}", "der Pfeil {0}{1}"};  ///< by words
inline constexpr Phrase kInQuotes{"\"{0}\"", "„{0}“"};
inline constexpr Phrase kAxis{"axis {0}", "Achse {0}"};
inline constexpr Phrase kARightAngle{"a right angle{0}", "ein rechter Winkel{0}"};
inline constexpr Phrase kAngleFromTo{"the angle {0}from {1} to {2}", "der Winkel {0}zwischen {1} und {2}"};
inline constexpr Phrase kParallelogramOf{"the parallelogram {0}of {1} and {2}",
                                         "das Parallelogramm {0}aus {1} und {2}"};
inline constexpr Phrase kLineFromTo{"a line from the tip of {0} to the tip of {1}",
                                    "eine Linie von der Spitze von {0} zu der von {1}"};
inline constexpr Phrase kPlaneNormalTo{"the plane normal to {0}{1}", "die Ebene senkrecht zu {0}{1}"};
inline constexpr Phrase kPlaneOf{"the plane of {0} and {1}{2}", "die Ebene von {0} und {1}{2}"};
inline constexpr Phrase kEdgesOfBox{"the twelve dashed edges of a box",
                                    "die zwölf gestrichelten Kanten eines Quaders"};
inline constexpr Phrase kArrowsTipToTail{"a chain of {0} arrows from tip to tip",
                                         "eine Kette von {0} Pfeilen"};
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

inline constexpr Phrase kExactOmegaDashed{"the exact ω, dashed", "das exakte ω, gestrichelt"};
inline constexpr Phrase kExactLDashed{"the exact L, dashed", "das exakte L, gestrichelt"};
inline constexpr Phrase kExactBody{"the body of the exact motion", "der Körper der exakten Bewegung"};
inline constexpr Phrase kTheWeight{"the weight", "das Gewicht"};
inline constexpr Phrase kErrorsAgainstSteps{
    "the errors of methods against the number of their steps, and their measured orders",
    "die Fehler der Verfahren über der Anzahl ihrer Schritte und ihre gemessenen Ordnungen"};
inline constexpr Phrase kErrorsAgainstEvaluations{
    "the errors of methods against the number of their evaluations, and their measured orders",
    "die Fehler der Verfahren über der Anzahl ihrer Auswertungen und ihre gemessenen Ordnungen"};
/// What a plot of orders shows: the method, its error and its work at both ends, and its order.
inline constexpr Phrase kMethodInSteps{"{0}: an error of {1} with {2} steps, of {3} with {4}",
                                       "{0}: ein Fehler von {1} bei {2} Schritten, von {3} bei {4}"};
inline constexpr Phrase kMethodInEvaluations{"{0}: an error of {1} with {2} evaluations, of {3} with {4}",
                                             "{0}: ein Fehler von {1} bei {2} Auswertungen, von {3} bei {4}"};
inline constexpr Phrase kOfOrder{", order {0}", ", Ordnung {0}"};

// Plots: what they show against what, and how each curve goes.
inline constexpr Phrase kAgainstFromTo{"against {0} from {1} to {2}. ", "über {0} von {1} bis {2}. "};
inline constexpr Phrase kFromTo{"from {0} to {1}. ", "von {0} bis {1}. "};
inline constexpr Phrase kStaysAt{"stays at {0}", "bleibt bei {0}"};
inline constexpr Phrase kRises{"rises from {0} to {1}", "steigt von {0} auf {1}"};
inline constexpr Phrase kFalls{"falls from {0} to {1}", "fällt von {0} auf {1}"};
inline constexpr Phrase kThenRises{", rises to {0}", ", steigt auf {0}"};
inline constexpr Phrase kThenFalls{", falls to {0}", ", fällt auf {0}"};
inline constexpr Phrase kOscillates{"oscillates between {0} and {1}, with {2}",
                                    "schwingt zwischen {0} und {1}, mit {2}"};
inline constexpr Phrase kGoesUpAndDown{"goes up and down between {0} and {1}, with {2}",
                                       "geht auf und ab zwischen {0} und {1}, mit {2}"};
inline constexpr Phrase kAMaximum{"one maximum", "einem Maximum"};
inline constexpr Phrase kMaxima{"{0} maxima", "{0} Maxima"};
inline constexpr Phrase kOneAtTheStart{", one at the start", ", eines am Anfang"};
inline constexpr Phrase kOneAtTheEnd{", one at the end", ", eines am Ende"};
inline constexpr Phrase kOneAtEachEnd{", one at each end", ", je eines an beiden Enden"};
inline constexpr Phrase kOutsideThePlot{"outside the range shown", "außerhalb des gezeigten Bereichs"};
inline constexpr Phrase kThenLeaves{", then leaves the plot", ", und verlässt dann das Bild"};
/// A value of a curve, and where it was read.
inline constexpr Phrase kReadAt{"{0} at {1}", "{0} bei {1}"};
inline constexpr Phrase kPathBetween{"a path between {0} and {1}", "eine Bahn zwischen {0} und {1}"};
inline constexpr Phrase kPathCloses{", which comes back to where it began",
                                    ", die zu ihrem Anfang zurückkehrt"};

/// What is said of a unit, of one and of any other number of them; others are said as they are written.
struct UnitWords {
  std::string_view unit;
  Phrase one, words;
};
inline constexpr auto kUnits = std::to_array<UnitWords>({
    {"s", {"second", "Sekunde"}, {"seconds", "Sekunden"}},
    {"ms", {"millisecond", "Millisekunde"}, {"milliseconds", "Millisekunden"}},
    {"rad/s", {"radian per second", "Radiant pro Sekunde"}, {"radians per second", "Radiant pro Sekunde"}},
    {"mrad/s",
     {"milliradian per second", "Milliradiant pro Sekunde"},
     {"milliradians per second", "Milliradiant pro Sekunde"}},
    {"rad", {"radian", "Radiant"}, {"radians", "Radiant"}},
    {"deg", {"degree", "Grad"}, {"degrees", "Grad"}},
    {"°", {"degree", "Grad"}, {"degrees", "Grad"}},
    {"m", {"metre", "Meter"}, {"metres", "Meter"}},
    {"m/s", {"metre per second", "Meter pro Sekunde"}, {"metres per second", "Meter pro Sekunde"}},
    {"J", {"joule", "Joule"}, {"joules", "Joule"}},
    {"mJ", {"millijoule", "Millijoule"}, {"millijoules", "Millijoule"}},
    {"µJ", {"microjoule", "Mikrojoule"}, {"microjoules", "Mikrojoule"}},
    {"J² s²",
     {"joule squared times second squared", "Quadratjoule mal Quadratsekunde"},
     {"joules squared times seconds squared", "Quadratjoule mal Quadratsekunden"}},
    {"W", {"watt", "Watt"}, {"watts", "Watt"}},
    {"N m", {"newton metre", "Newtonmeter"}, {"newton metres", "Newtonmeter"}},
    {"kg m²",
     {"kilogram square metre", "Kilogrammquadratmeter"},
     {"kilogram square metres", "Kilogrammquadratmeter"}},
    {"kg m²/s",
     {"kilogram square metre per second", "Kilogrammquadratmeter pro Sekunde"},
     {"kilogram square metres per second", "Kilogrammquadratmeter pro Sekunde"}},
    {"rad/s²",
     {"radian per second squared", "Radiant pro Quadratsekunde"},
     {"radians per second squared", "Radiant pro Quadratsekunde"}},
    {"rad²/s²",
     {"radian squared per second squared", "Quadratradiant pro Quadratsekunde"},
     {"radians squared per second squared", "Quadratradiant pro Quadratsekunde"}},
    {"1/s", {"per second", "pro Sekunde"}, {"per second", "pro Sekunde"}},
    {"kg", {"kilogram", "Kilogramm"}, {"kilograms", "Kilogramm"}},
});

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
inline constexpr Phrase kInTheDiagram{"In the diagram: ", "Im Diagramm: "};
inline constexpr Phrase kPlotted{"Plotted: ", "Aufgetragen: "};
inline constexpr Phrase kDrawn{"Drawn: ", "Gezeichnet: "};
inline constexpr Phrase kPlottedAgainst{" against ", " über "};
inline constexpr Phrase kTime{"time", "der Zeit"};
inline constexpr Phrase kWithTheLevel{", with the level ", ", mit der Linie bei "};
inline constexpr Phrase kReferences{"References", "Literatur"};

}  // namespace polhode::words
