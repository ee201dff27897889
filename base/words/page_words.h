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
inline constexpr Phrase kAsTheMotionBegins{", at the start", ", zu Beginn der Bewegung"};
inline constexpr Phrase kAtLeast{"at least {0}", "mindestens {0}"};
inline constexpr Phrase kAtMost{"at most {0}", "höchstens {0}"};
inline constexpr Phrase kBetween{"between {0} and {1}", "zwischen {0} und {1}"};

// Beside a choice that was picked, in the window, and what is said of it.
inline constexpr Phrase kMarkedRight{"right", "richtig"};
inline constexpr Phrase kMarkedNotRight{"not right", "nicht richtig"};
inline constexpr Phrase kCannotBeRead{"Cannot be read.", "Nicht lesbar."};
inline constexpr Phrase kChoiceIsNotRight{"{0} is not right.", "{0} ist nicht richtig."};

// Behind the lines of a learner's derivation.
inline constexpr Phrase kLineHolds{"holds", "gilt"};
inline constexpr Phrase kLineIsGoal{"goal", "Ziel"};
inline constexpr Phrase kLineLeadsAway{"leads away", "führt weg"};
inline constexpr Phrase kLineIsWrong{"wrong", "falsch"};
inline constexpr Phrase kLineIsUnreadable{"unreadable", "unlesbar"};
inline constexpr Phrase kGoalWithoutWay{"the goal itself: show the way", "das Ziel selbst: der Weg fehlt"};

// What a window says of what is pointed at, or held, and of where one is.
inline constexpr Phrase kComponentsInSpace{"components in the space frame", "Komponenten im Raumsystem"};
inline constexpr Phrase kComponentsInBody{"components in the body frame", "Komponenten im Körpersystem"};
inline constexpr Phrase kGoTo{"Go to: {0}", "Gehe zu: {0}"};
inline constexpr Phrase kInAnotherLesson{"In another lesson: {0}", "In einer anderen Lektion: {0}"};
inline constexpr Phrase kClickToCopy{"Click to copy: {0}", "Ein Klick kopiert: {0}"};
inline constexpr Phrase kDrag{"drag", "ziehen"};
inline constexpr Phrase kDragOmega{"drag: another ω with the same T; Shift: its length",
                                   "ziehen: ein anderes ω mit demselben T; Umschalt: seine Länge"};
inline constexpr Phrase kOmegaAtConstT{"ω = {0} rad/s in the body frame, T kept",
                                       "ω = {0} rad/s im Körpersystem, T bleibt"};
inline constexpr Phrase kOmegaNoNearer{
    "ω = {0} rad/s in the body frame, T kept: none of this T ends nearer to the pointer; Shift changes T",
    "ω = {0} rad/s im Körpersystem, T bleibt: keines mit diesem T endet näher am Zeiger; Umschalt ändert T"};
inline constexpr Phrase kOmegaAtOtherT{"ω = {0} rad/s in the body frame, T = {1} J, not kept",
                                       "ω = {0} rad/s im Körpersystem, T = {1} J, bleibt nicht"};
inline constexpr Phrase kNotThisOmega{
    "this arrow is ω at another length or from another point, and cannot be dragged; the panel Body changes "
    "ω",
    "dieser Pfeil ist ω in anderer Länge oder von einem anderen Punkt aus und lässt sich nicht ziehen; ω "
    "ändert "
    "man unter „Körper“"};
inline constexpr Phrase kStageNotChosen{"stage {0} (not one of the {1} chosen)",
                                        "Abschnitt {0} (nicht unter den {1} ausgewählten)"};
inline constexpr Phrase kNoneOfChosenSteps{"Not one of the {0} chosen steps",
                                           "Keiner der {0} ausgewählten Schritte"};

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
