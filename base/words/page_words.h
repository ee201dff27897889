// SPDX-License-Identifier: MIT
// What pages, slides, decks and pages of text say besides the lesson's own words.
#pragma once

#include "base/words/phrase.h"

namespace polhode::words {

inline constexpr Phrase kStageOf{"stage {0} of {1}", "Abschnitt {0} von {1}"};
inline constexpr Phrase kCountOf{"{0} of {1}", "{0} von {1}"};
inline constexpr Phrase kStepNumber{"step {0}", "Schritt {0}"};
inline constexpr Phrase kStepsFromTo{"steps {0}–{1}", "Schritte {0}–{1}"};
inline constexpr Phrase kQuestionLabel{"Question", "Frage"};
inline constexpr Phrase kFromBefore{"from before:", "bereits bekannt:"};
inline constexpr Phrase kAnswersToStage{"Answers to stage {0}: {1}", "Antworten zu Abschnitt {0}: {1}"};
inline constexpr Phrase kAnswerOfStep{"step {0}, {1}", "Schritt {0}, {1}"};
inline constexpr Phrase kForExample{"for example {0}", "zum Beispiel {0}"};

// States that are asked for, and what is given to an answer.
inline constexpr Phrase kGivenOpening{"Given: ", "Gegeben: "};
inline constexpr Phrase kGoal{"Goal: ", "Ziel: "};
inline constexpr Phrase kYouMayChange{"You may change ", "Verändert werden darf: "};
inline constexpr Phrase kAsTheMotionBegins{", as the motion begins", ", zu Beginn der Bewegung"};
inline constexpr Phrase kAtLeast{"at least {0}", "mindestens {0}"};
inline constexpr Phrase kAtMost{"at most {0}", "höchstens {0}"};
inline constexpr Phrase kBetween{"between {0} and {1}", "zwischen {0} und {1}"};

// Beside a choice that was picked, in the window.
inline constexpr Phrase kMarkedRight{"right", "richtig"};
inline constexpr Phrase kMarkedNotRight{"not right", "nicht richtig"};

// Numbers that are asked for.
inline constexpr Phrase kAnswerWithANumber{"Answer with a number, to within {0}.",
                                           "Antwort als Zahl, auf {0} genau."};
inline constexpr Phrase kAnswerInUnit{"Answer in {0}, to within {1}.", "Antwort in {0}, auf {1} genau."};
inline constexpr Phrase kUnitDegrees{"degrees", "Grad"};
inline constexpr Phrase kUnitDegreesPerSecond{"degrees per second", "Grad pro Sekunde"};

// Parts of decks.
inline constexpr Phrase kStepsOf{"steps {0}–{1} of {2}", "Schritte {0}–{1} von {2}"};
inline constexpr Phrase kStepOf{"step {0} of {1}", "Schritt {0} von {1}"};
inline constexpr Phrase kEquationPart{"equation {0}", "Gleichung {0}"};
inline constexpr Phrase kNoNotes{"This slide has no notes.", "Diese Folie hat keine Notizen."};
inline constexpr Phrase kBetweenTwoLines{"Between two lines. {0} {1}", "Zwischen zwei Zeilen. {0} {1}"};

}  // namespace polhode::words
