// SPDX-License-Identifier: MIT
// What a window says beside a question that somebody answers, and of the answer. What pages of text say
// there stands in edition_words.h.
#pragma once

#include "base/words/phrase.h"

namespace polhode::words {

inline constexpr Phrase kQuestionNumber{"Question {0} of {1}", "Frage {0} von {1}"};
inline constexpr Phrase kPutInOrder{"Put the letters in order.",
                                    "Die Buchstaben in eine Reihenfolge bringen."};
inline constexpr Phrase kSuchAs{"such as {0}", "etwa {0}"};
inline constexpr Phrase kANumber{"a number", "eine Zahl"};
inline constexpr Phrase kANumberIn{"a number in {0}", "eine Zahl, in {0}"};
inline constexpr Phrase kWatchIt{"Watch what it does.", "Jetzt zeigt sich, was geschieht."};
inline constexpr Phrase kSkipToVerdict{"Skip to the verdict", "Gleich zum Urteil"};

// Hints, and what was answered before.
inline constexpr Phrase kHintOpening{"Hint {0}: ", "Hinweis {0}: "};
inline constexpr Phrase kAHint{"A hint", "Ein Hinweis"};
inline constexpr Phrase kAnotherHint{"Another hint", "Noch ein Hinweis"};
inline constexpr Phrase kShowTheAnswer{"Show the answer", "Die Antwort zeigen"};
inline constexpr Phrase kAnswerOpening{"The answer is ", "Die Antwort ist "};
inline constexpr Phrase kAnsweredBefore{"You have answered this one right.",
                                        "Diese Frage ist schon richtig beantwortet."};
inline constexpr Phrase kYourRightAnswer{"Your answer was right: ", "Die Antwort war richtig: "};
inline constexpr Phrase kEarlierInStage{"Earlier in this stage", "Früher in diesem Abschnitt"};
inline constexpr Phrase kNotAnswered{"not answered", "nicht beantwortet"};
inline constexpr Phrase kAnsweredRight{"answered right", "richtig beantwortet"};
inline constexpr Phrase kNotYetRight{"not yet right", "noch nicht richtig"};
inline constexpr Phrase kEarlierStep{"Step {0}, {1}: ", "Schritt {0}, {1}: "};

// The verdict. A reason stands behind the colon.
inline constexpr Phrase kNotRightFor{"Not right: {0}.", "Nicht richtig: {0}."};
inline constexpr Phrase kCannotBeReadFor{"Cannot be read: {0}.", "Nicht lesbar: {0}."};
inline constexpr Phrase kAtColumnOf{"at column {0} of {1}", "an Stelle {0} von {1}"};
inline constexpr Phrase kYoursAndRight{"At {0} yours is {1}, right is {2}.",
                                       "Bei {0} ergibt die Antwort {1}, richtig ist {2}."};
inline constexpr Phrase kShowInFigure{"Show it in the figure", "In der Abbildung zeigen"};
inline constexpr Phrase kIsInFigure{"It is in the figure", "Es ist in der Abbildung"};

// On a figure that shows something else than the lesson's scene.
inline constexpr Phrase kChanged{"changed", "geändert"};
inline constexpr Phrase kChangedByHand{"changed by hand", "von Hand geändert"};
inline constexpr Phrase kUndo{"Undo", "Rückgängig"};
inline constexpr Phrase kBackToLessons{"Back to the lesson's", "Zurück zur Lektion"};
inline constexpr Phrase kBackToShown{"Back to what was shown", "Zurück zum Gezeigten"};
inline constexpr Phrase kBodyOfFailure{"a body for which it fails: {0}",
                                       "ein Körper, für den es nicht gilt: {0}"};
inline constexpr Phrase kBodyOfFailureChanged{
    "a body for which an answer failed, then changed by hand",
    "ein Körper, für den eine Antwort nicht galt, von Hand geändert"};

// States that are brought to a goal.
inline constexpr Phrase kGivenAtStart{"Given, at $t = 0$: ", "Gegeben, für $t = 0$: "};
inline constexpr Phrase kNow{"Now {0}.", "Jetzt {0}."};
inline constexpr Phrase kNowAtStart{"Now at t = 0 it is {0}.", "Jetzt, für t = 0: {0}."};
inline constexpr Phrase kReached{"Reached: {0}.", "Erreicht: {0}."};
inline constexpr Phrase kReachedAtStart{"Reached: at t = 0 it is {0}.", "Erreicht, für t = 0: {0}."};
inline constexpr Phrase kTooSmall{"{0}, {1} too small", "{0}, um {1} zu klein"};
inline constexpr Phrase kTooLarge{"{0}, {1} too large", "{0}, um {1} zu groß"};
inline constexpr Phrase kNotDefinedOnThis{"not defined on this motion",
                                          "bei dieser Bewegung nicht definiert"};
inline constexpr Phrase kChangedToo{"Changed too: {0}. This question is about the lesson's.",
                                    "Ebenfalls geändert: {0}. Die Frage gilt dem Stand der Lektion."};
inline constexpr Phrase kTheMethod{"the method", "das Verfahren"};
inline constexpr Phrase kPutItBack{"Put it back", "Zurücksetzen"};
inline constexpr Phrase kShowsAnotherBody{
    "The figure shows another body. Go back to this one first.",
    "Die Abbildung zeigt einen anderen Körper. Zuerst zu diesem zurück."};
inline constexpr Phrase kDragOrSlide{
    "Drag the tip of ω in the figure, which keeps T, or use the sliders.",
    "Die Spitze von ω in der Abbildung ziehen, wobei T bleibt, oder die Regler benutzen."};
inline constexpr Phrase kBackToScene{"Back to the lesson's scene", "Zurück zur Szene der Lektion"};
inline constexpr Phrase kLUpright{"upright", "aufrecht"};
inline constexpr Phrase kLHanging{"hanging down", "nach unten"};
inline constexpr Phrase kAlongAxesOfSpace{" along the axes of space", " längs der Achsen des Raums"};

// Why a number is not right, or cannot be read.
inline constexpr Phrase kNumberIsAsked{"a number is asked for", "gefragt ist eine Zahl"};
inline constexpr Phrase kNumberForm{"such as 4.2 or 1.2e3", "etwa 4,2 oder 1,2e3"};
inline constexpr Phrase kTooLong{"this is too long for a number", "das ist zu lang für eine Zahl"};
inline constexpr Phrase kNumberAlone{"the number alone is asked for", "gefragt ist die Zahl allein"};
inline constexpr Phrase kBehindEquals{"type what stands behind the =", "eingeben, was hinter dem = steht"};
inline constexpr Phrase kNoComma{"a comma is not read in numbers", "dieses Komma gehört zu keiner Zahl"};
inline constexpr Phrase kInsteadOfComma{"write 1.5 for 1,5 and 1000 for 1,000",
                                        "eine Zahl hat höchstens ein Komma, und Tausender haben keines"};
inline constexpr Phrase kNoNumber{"this is no number", "das ist keine Zahl"};
inline constexpr Phrase kWriteANumber{"write one such as 4.2, -0.3 or 1.2e3",
                                      "etwa 4,2 oder -0,3 oder 1,2e3 schreiben"};
inline constexpr Phrase kNumberTooLarge{"this number is too large", "diese Zahl ist zu groß"};
inline constexpr Phrase kNumberTooSmall{"this number is too small to be read",
                                        "diese Zahl ist zu klein, um gelesen zu werden"};
inline constexpr Phrase kOneNumber{"one number is asked for, and nothing is computed here",
                                   "gefragt ist eine Zahl, gerechnet wird hier nicht"};
inline constexpr Phrase kTypeTheResult{"type the result", "das Ergebnis eingeben"};
inline constexpr Phrase kUnknownUnit{"unknown unit \"{0}\"", "unbekannte Einheit „{0}“"};
inline constexpr Phrase kUnitsAre{"units are {0}; rpm, rev, min, h, %",
                                  "Einheiten sind {0}; rpm, rev, min, h, %"};
inline constexpr Phrase kWithPowers{" with powers and prefixes", " mit Potenzen und Vorsätzen"};
inline constexpr Phrase kHasNoNumber{"this number has no value on the motion shown",
                                     "diese Zahl hat bei der gezeigten Bewegung keinen Wert"};
inline constexpr Phrase kAskedWithoutUnit{"a number without a unit is asked for",
                                          "gefragt ist eine Zahl ohne Einheit"};
inline constexpr Phrase kAskedInUnit{"an answer in {0} is asked for", "gefragt ist eine Antwort in {0}"};
inline constexpr Phrase kOtherKindOfUnit{"the unit is of another kind: {0}, and this is in {1}",
                                         "die Einheit ist von anderer Art: {0}, und dies ist in {1}"};
inline constexpr Phrase kCountsTurns{"{0} counts turns, and {1}: 1 Hz is 2π rad/s",
                                     "{0} zählt Umdrehungen, und {1}: 1 Hz ist 2π rad/s"};
inline constexpr Phrase kCountsAngles{"{0} counts angles, and {1}: 1 Hz is 2π rad/s",
                                      "{0} zählt Winkel, und {1}: 1 Hz ist 2π rad/s"};
inline constexpr Phrase kWrongSign{"wrong sign: the size is right", "falsches Vorzeichen, der Betrag stimmt"};
inline constexpr Phrase kTooCoarse{"rounded too coarsely: it has to be right to {0}",
                                   "zu grob gerundet, sie muss auf {0} genau sein"};
inline constexpr Phrase kAreDegrees{"these are degrees, and radians are asked for: 180° is π",
                                    "das sind Grad, gefragt ist das Bogenmaß: 180° sind π"};
inline constexpr Phrase kAreRadians{"these are radians, and degrees are asked for: π is 180°",
                                    "das ist das Bogenmaß, gefragt sind Grad: π sind 180°"};
inline constexpr Phrase kTurnsTooLarge{"too large by 2π: radians are counted here as turns, or ω is 2πf",
                                       "um 2π zu groß: Radiant zählen hier als Umdrehungen, oder ω ist 2πf"};
inline constexpr Phrase kTurnsTooSmall{"too small by 2π: turns are counted here as radians, or ω is 2πf",
                                       "um 2π zu klein: Umdrehungen zählen hier als Radiant, oder ω ist 2πf"};
inline constexpr Phrase kTooLargeByFactor{"too large by a factor of {0}", "um den Faktor {0} zu groß"};
inline constexpr Phrase kTooSmallByFactor{"too small by a factor of {0}", "um den Faktor {0} zu klein"};
inline constexpr Phrase kTwice{"twice what is right: a factor 1/2 is missing",
                               "das Doppelte des Richtigen: ein Faktor 1/2 fehlt"};
inline constexpr Phrase kHalf{"half of what is right: a factor 2 is missing",
                              "die Hälfte des Richtigen: ein Faktor 2 fehlt"};
inline constexpr Phrase kIsNotZero{"it is not 0", "sie ist nicht 0"};
inline constexpr Phrase kNeitherSignNorSize{"neither the sign nor the size is right",
                                            "weder das Vorzeichen noch der Betrag stimmt"};
inline constexpr Phrase kNumberIsTooLarge{"too large", "zu groß"};
inline constexpr Phrase kNumberIsTooSmall{"too small", "zu klein"};

}  // namespace polhode::words
