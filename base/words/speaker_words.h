// SPDX-License-Identifier: MIT
// What the window of who speaks says of the page, beside its buttons.
#pragma once

#include "base/words/phrase.h"

namespace polhode::words {

inline constexpr Phrase kBeforeAudience{"Before the audience", "Vor dem Publikum"};
inline constexpr Phrase kScreenIsBlack{"The audience's screen is black",
                                       "Der Bildschirm des Publikums ist schwarz"};
inline constexpr Phrase kBeforeYouAlone{"Before you alone: the audience still sees what it saw",
                                        "Nur hier: Das Publikum sieht noch, was es sah"};
inline constexpr Phrase kComesNext{"Next", "Als Nächstes"};
inline constexpr Phrase kIsLastStep{"This is the last step", "Das ist der letzte Schritt"};
inline constexpr Phrase kStepHasNoNote{"There is no note to this step.",
                                       "Zu diesem Schritt gibt es keine Notiz."};
inline constexpr Phrase kDerivationHeading{"Derivation", "Herleitung"};
inline constexpr Phrase kPassedOver{"(passed over)", "(übersprungen)"};
inline constexpr Phrase kElapsed{"{0} elapsed", "{0} vergangen"};
inline constexpr Phrase kCountAgain{"Begin to count the time again", "Die Zeit von vorn zählen"};
inline constexpr Phrase kBlack{"Black", "Schwarz"};
inline constexpr Phrase kSpot{"Spot", "Punkt"};
inline constexpr Phrase kFreeze{"Freeze", "Halten"};
inline constexpr Phrase kEndOfTalk{"End", "Ende"};
inline constexpr Phrase kFromZero{"from 0:00", "ab 0:00"};

}  // namespace polhode::words
