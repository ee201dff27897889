// SPDX-License-Identifier: MIT
// What is said of claims: the badges below equations and the notes behind them.
#pragma once

#include "base/words/phrase.h"

#include <array>

namespace polhode::words {

// The kinds of claims.
inline constexpr Phrase kAlwaysTrue{"always true", "immer wahr"};
inline constexpr Phrase kDefinition{"definition", "Definition"};
inline constexpr Phrase kLaw{"law", "Gesetz"};
inline constexpr Phrase kTrueInEveryMotion{"true in every motion", "wahr bei jeder Bewegung"};
inline constexpr Phrase kTrueWithoutTorque{"true when no torque acts", "wahr, wenn kein Drehmoment wirkt"};
inline constexpr Phrase kFalse{"false", "falsch"};
inline constexpr Phrase kCheckedOnThisMotion{"checked on this motion", "an dieser Bewegung geprüft"};
inline constexpr Phrase kDoesNotFollow{"does not follow", "folgt nicht"};

inline constexpr Phrase kDoesNotHold{"does not hold", "gilt nicht"};
inline constexpr Phrase kNotProved{"not proved", "nicht bewiesen"};
inline constexpr Phrase kNotRefuted{"not refuted at {0} states", "in {0} Zuständen nicht widerlegt"};
inline constexpr Phrase kAnExampleShowsIt{"an example shows it", "ein Beispiel zeigt es"};
inline constexpr Phrase kNotConfirmed{"not confirmed", "nicht bestätigt"};
inline constexpr Phrase kNoMotionHere{"there is no motion here", "hier gibt es keine Bewegung"};
inline constexpr Phrase kCheckedOnAMotion{"checked on a motion", "an einer Bewegung geprüft"};
inline constexpr Phrase kUnderAnAssumption{", under an assumption", ", unter einer Annahme"};
inline constexpr Phrase kUnderTheSameConditions{"under the same conditions", "unter denselben Bedingungen"};
inline constexpr Phrase kInOtherWords{"in other words", "mit anderen Worten"};

// What has become of lines that are claimed beside an equation.
inline constexpr Phrase kInPart{"in part", "zum Teil"};
inline constexpr Phrase kProved{"proved", "bewiesen"};
inline constexpr Phrase kChecked{"checked", "geprüft"};
inline constexpr Phrase kStated{"stated", "angegeben"};
inline constexpr Phrase kClaimed{"claimed", "behauptet"};

// How a motion is computed.
inline constexpr Phrase kInClosedForm{"in closed form", "in geschlossener Form"};
inline constexpr Phrase kWithMethodAndStep{"with {0}, $h$ = {1} s", "mit {0}, $h$ = {1} s"};
inline constexpr Phrase kWithMethodAndTolerance{"with {0}, tolerance {1}", "mit {0}, Toleranz {1}"};

// What is given.
inline constexpr Phrase kGiven{"given", "unter der Annahme"};
inline constexpr Phrase kForSmall{"for small", "für kleine"};
inline constexpr Phrase kToOrderIn{"to {0} order in", "in {0} Ordnung in"};
inline constexpr std::array<Phrase, 4> kOrders = {
    {{"first", "erster"}, {"second", "zweiter"}, {"third", "dritter"}, {"fourth", "vierter"}}};
inline constexpr Phrase kNotOfThisBody{"not of this body, which loses energy inside",
                                       "nicht für diesen Körper, der im Inneren Energie verliert"};
inline constexpr Phrase kHereOneActs{"here one acts", "hier wirkt eines"};

// Counterexamples, and measurements.
inline constexpr Phrase kPremiseHolds{"at {0} the premise holds, and {1}",
                                      "bei {0} gilt die Voraussetzung, und {1}"};
inline constexpr Phrase kForExampleAt{"for example at {0}: {1}", "zum Beispiel bei {0}: {1}"};
inline constexpr Phrase kAnyState{"any state", "jedem Zustand"};
inline constexpr Phrase kAttitude{"attitude", "Lage"};
inline constexpr Phrase kToWithin{"to within {0} %", "auf {0} % genau"};
inline constexpr Phrase kHasNoValue{"has no value at some time", "hat zeitweise keinen Wert"};
inline constexpr Phrase kStepTooLong{"the step is too long to tell",
                                     "der Schritt ist zu lang für ein Urteil"};
inline constexpr Phrase kTermsCancel{"the terms cancel too far to tell",
                                     "die Terme heben sich zu weit auf für ein Urteil"};
inline constexpr Phrase kFailsAt{"fails at $t$ = {0} s", "gilt nicht bei $t$ = {0} s"};

}  // namespace polhode::words
