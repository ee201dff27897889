// SPDX-License-Identifier: MIT
// What the window says of itself: its bar, its panels, what it tells. What stands beside questions is in
// answer_words.h, what the speaker alone sees in speaker_words.h. The table of keys, what a command is called
// where a pointer rests, the menus of the right button and the refusals of files are in English.
#pragma once

#include "base/words/phrase.h"

namespace polhode::words {

// The bar, and the time line.
inline constexpr Phrase kBack{"Back", "Zurück"};
inline constexpr Phrase kNext{"Next", "Weiter"};
inline constexpr Phrase kRealTime{"real time", "Echtzeit"};
inline constexpr Phrase kRealTimeTimes{"real time × {0}", "Echtzeit × {0}"};
inline constexpr Phrase kRealTimeOver{"real time ÷ {0}", "Echtzeit ÷ {0}"};
inline constexpr Phrase kFlipAt{"flip at t = {0} s", "Kippen bei t = {0} s"};
inline constexpr Phrase kQuestionHere{"There is a question here (Q)", "Hier steht eine Frage (Q)"};
inline constexpr Phrase kStepHasNoFigure{"This step has no figure.",
                                         "Zu diesem Schritt gibt es keine Abbildung."};

// What the panels are called, on the bar and at their heads.
inline constexpr Phrase kLessons{"Lessons", "Lektionen"};
inline constexpr Phrase kOutline{"Outline", "Gliederung"};
inline constexpr Phrase kBodyPanel{"Body", "Körper"};
inline constexpr Phrase kBodyAndSpin{"Body and its spin", "Der Körper und seine Drehung"};
inline constexpr Phrase kMethod{"Method", "Verfahren"};
inline constexpr Phrase kFastOrAccurate{"Method: fast or accurate", "Verfahren: schnell oder genau"};
inline constexpr Phrase kShow{"Show", "Zeigen"};
inline constexpr Phrase kToAnswer{"Answer", "Antwort"};
inline constexpr Phrase kSave{"Save", "Sichern"};
inline constexpr Phrase kView{"View", "Ansicht"};
inline constexpr Phrase kHelp{"?", "?"};
inline constexpr Phrase kKeys{"Keys", "Tasten"};

// What is told for some seconds, and how to begin.
inline constexpr Phrase kAnswerFirst{"Answer first, or press again to see it.",
                                     "Erst antworten, oder noch einmal drücken, um es zu sehen."};
inline constexpr Phrase kMotionAnswersFirst{"The motion answers first.", "Zuerst antwortet die Bewegung."};
inline constexpr Phrase kIsAnsweredAlready{"This question is answered already.",
                                           "Diese Frage ist schon beantwortet."};
inline constexpr Phrase kIsReadAloud{"This step is read aloud; the same key stops it.",
                                     "Der Schritt wird vorgelesen; dieselbe Taste beendet es."};
inline constexpr Phrase kCopied{"copied", "kopiert"};
inline constexpr Phrase kSavedAs{"saved: {0}", "gesichert: {0}"};
inline constexpr Phrase kTextEnds{"The text ends here.", "Hier endet der Text."};
inline constexpr Phrase kTextBegins{"The text begins here.", "Hier beginnt der Text."};
inline constexpr Phrase kNothingHasNote{"Nothing on this page has a note.",
                                        "Auf dieser Seite ist nichts erläutert."};
inline constexpr Phrase kTabFirst{"Tab goes to a symbol, a link or a choice first.",
                                  "Zuerst führt Tab zu einem Zeichen, einem Verweis oder einer Auswahl."};
inline constexpr Phrase kNoPanelIsOpen{"No panel is open: the keys are the page's.",
                                       "Keine Tafel ist offen: Die Tasten gelten der Seite."};
inline constexpr Phrase kLettersAreNoCommands{
    "Letters and signs are no commands, as chosen in View (F2). Buttons for what they do are there and below "
    "the page.",
    "Buchstaben und Zeichen sind keine Befehle, wie in Ansicht (F2) gewählt. Knöpfe dafür gibt es dort und "
    "unter der Seite."};
inline constexpr Phrase kEnterGoesToStage{"Enter: go to stage {0}", "Enter: zu Abschnitt {0}"};
inline constexpr Phrase kNoSuchStage{"There is no stage {0}; the last is {1}.",
                                     "Einen Abschnitt {0} gibt es nicht, der letzte ist {1}."};
inline constexpr Phrase kPresentingWithSpeaker{
    "You are presenting already: Escape ends it, N closes your window.",
    "Der Vortrag läuft schon: Escape beendet ihn, N schließt das Fenster für den Vortragenden."};
inline constexpr Phrase kPresenting{"You are presenting already: Escape or P ends it.",
                                    "Der Vortrag läuft schon: Escape oder P beendet ihn."};
inline constexpr Phrase kHowToPresent{
    "Escape ends the presentation; . is a black screen, L a spot, a number and Enter a stage.",
    "Escape beendet den Vortrag; . macht den Bildschirm schwarz, L zeigt einen Punkt, eine Zahl und Enter "
    "führen zu einem Abschnitt."};
inline constexpr Phrase kHowToBegin{
    "Space plays, a drag turns the figure, → goes on, Ctrl+L lists the lessons, ? all keys.",
    "Die Leertaste spielt ab, Ziehen dreht die Abbildung, → geht weiter, Strg+L zeigt die Lektionen, ? alle "
    "Tasten."};

// Why a key has nothing to do.
inline constexpr Phrase kIsTheEnd{"This is the end.", "Das ist das Ende."};
inline constexpr Phrase kIsLastStage{"This is the last stage.", "Das ist der letzte Abschnitt."};
inline constexpr Phrase kIsTheBeginning{"This is the beginning.", "Das ist der Anfang."};
inline constexpr Phrase kNothingMoves{"Nothing moves by itself: so it is chosen in View.",
                                      "Nichts bewegt sich von selbst: So ist es unter „Ansicht“ gewählt."};
inline constexpr Phrase kIsFirstStep{"This is the first step of its stage.",
                                     "Das ist der erste Schritt des Abschnitts."};
inline constexpr Phrase kNoFlipBehind{"No flip is shown behind this time.",
                                      "Nach dieser Zeit ist kein Kippen zu sehen."};
inline constexpr Phrase kNoFlipBefore{"No flip is shown before this time.",
                                      "Vor dieser Zeit ist kein Kippen zu sehen."};
inline constexpr Phrase kIsAtZero{"t is 0 already.", "t ist schon 0."};
inline constexpr Phrase kIsFastest{"It is as fast as can be.", "Schneller geht es nicht."};
inline constexpr Phrase kIsSlowest{"It is as slow as can be.", "Langsamer geht es nicht."};
inline constexpr Phrase kNoNumberToVary{"This step has no number to vary.",
                                        "Dieser Schritt hat keine Zahl, die sich ändern lässt."};
inline constexpr Phrase kNoSecondNumber{"This step has no second number to vary.",
                                        "Dieser Schritt hat keine zweite Zahl, die sich ändern lässt."};
inline constexpr Phrase kNothingMoreExact{
    "Nothing more exact is known to stand beside it: M chooses a method.",
    "Genaueres zum Danebenstellen ist nicht bekannt: M wählt ein Verfahren."};
inline constexpr Phrase kNothingForGhost{
    "Neither the body nor ω nor L is shown, whose ghost one would see.",
    "Weder der Körper noch ω noch L ist zu sehen, neben denen das Genaue stünde."};
inline constexpr Phrase kIsLessonsScene{"This is the lesson's scene.", "Das ist die Szene der Lektion."};
inline constexpr Phrase kNothingToUndo{"There is no change to undo.",
                                       "Es gibt keine Änderung, die rückgängig zu machen wäre."};
inline constexpr Phrase kNothingToRedo{"Nothing was undone that could be made again.",
                                       "Nichts wurde rückgängig gemacht, was wiederherzustellen wäre."};
inline constexpr Phrase kTextIsLargest{"The text is as large as can be.", "Größer geht der Text nicht."};
inline constexpr Phrase kTextIsSmallest{"The text is as small as can be.", "Kleiner geht der Text nicht."};
inline constexpr Phrase kTextIsNormal{"The text is at 100 %.", "Der Text hat 100 %."};
inline constexpr Phrase kBlackIsForAudience{
    "A black screen is for an audience: P presents.",
    "Ein schwarzer Bildschirm ist für ein Publikum: P beginnt den Vortrag."};
inline constexpr Phrase kSpotIsForAudience{"The spot is for an audience: P presents.",
                                           "Der Punkt ist für ein Publikum: P beginnt den Vortrag."};
inline constexpr Phrase kFreezeNeedsWindow{
    "The page can stay while you look elsewhere in a window of your own: N.",
    "Stehen bleibt die Seite, wenn es ein eigenes Fenster für den Vortragenden gibt: N."};

// Questions and derivations.
inline constexpr Phrase kNoQuestion{"There is no question on this step.",
                                    "Zu diesem Schritt gibt es keine Frage."};
inline constexpr Phrase kHowToWrite{"How to write it", "So wird es geschrieben"};
inline constexpr Phrase kKeysGoToAnswer{"Keys go to the answer. Escape: back to the page.",
                                        "Die Tasten gehen an die Antwort. Escape: zurück zur Seite."};
inline constexpr Phrase kKeysGoToPanel{
    "Keys go to this panel, Tab to the answer. F6: back to the page.",
    "Die Tasten gehen an diese Tafel, Tab zur Antwort. F6: zurück zur Seite."};
inline constexpr Phrase kKeysGoToPage{
    "Keys go to the page: ← → walk, Space plays. F6: to this panel.",
    "Die Tasten gehen an die Seite: ← → blättern, die Leertaste spielt ab. F6: an diese Tafel."};
inline constexpr Phrase kForgetAnswers{"Forget my answers…", "Meine Antworten vergessen…"};
inline constexpr Phrase kForgetOneHint{"Forget 1 hint?", "1 Hinweis vergessen?"};
inline constexpr Phrase kForgetHints{"Forget {0} hints?", "{0} Hinweise vergessen?"};
inline constexpr Phrase kForgetOneLine{"Forget 1 line?", "1 Zeile vergessen?"};
inline constexpr Phrase kForgetLines{"Forget {0} lines?", "{0} Zeilen vergessen?"};
inline constexpr Phrase kForgetOneAnswer{"Forget 1 answer?", "1 Antwort vergessen?"};
inline constexpr Phrase kForgetSomeAnswers{"Forget {0} answers?", "{0} Antworten vergessen?"};
inline constexpr Phrase kForgetIt{"Yes, forget it", "Ja, vergessen"};
inline constexpr Phrase kForgetThem{"Yes, forget them", "Ja, alle vergessen"};
inline constexpr Phrase kKeepIt{"Keep it", "Behalten"};
inline constexpr Phrase kKeepThem{"Keep them", "Alle behalten"};
inline constexpr Phrase kFrom{"From  ", "Von  "};
inline constexpr Phrase kTo{"To  ", "Zu  "};
inline constexpr Phrase kLeadsAwayFor{"Leads away: {0}.", "Führt weg: {0}."};
inline constexpr Phrase kLeadsAway{"Leads away.", "Führt weg."};
inline constexpr Phrase kAtColumn{"at column {0}", "an Stelle {0}"};
inline constexpr Phrase kSidesAre{"At {0} the left side is {1}, the right side {2}.",
                                  "Bei {0} ist die linke Seite {1}, die rechte {2}."};
inline constexpr Phrase kNextLine{"the next line, such as a = b + c", "die nächste Zeile, etwa a = b + c"};
inline constexpr Phrase kEnterLine{"Next", "Weiter"};
inline constexpr Phrase kGoalIsReached{"The goal is reached: ", "Das Ziel ist erreicht: "};
inline constexpr Phrase kGoalWithoutLines{
    "That is the goal itself: show how you get there, in at least {0} lines.",
    "Das ist das Ziel selbst. Es fehlt der Weg dorthin, in mindestens {0} Zeilen."};
inline constexpr Phrase kTakeBackLine{"Take back the last line", "Die letzte Zeile zurücknehmen"};
inline constexpr Phrase kLessonsWay{"The lesson's own way, to compare:",
                                    "Der Weg der Lektion, zum Vergleich:"};
inline constexpr Phrase kHintToLine{"Hint: ", "Hinweis: "};
inline constexpr Phrase kHow{"How?", "Wie?"};
inline constexpr Phrase kShowTheLine{"Show the line", "Die Zeile zeigen"};

// How far one is, and where to go.
inline constexpr Phrase kFind{"find in this lesson", "in dieser Lektion suchen"};
inline constexpr Phrase kNothingFound{"Nothing in this lesson has these words.",
                                      "Diese Worte kommen in der Lektion nicht vor."};
inline constexpr Phrase kOneStepFound{"1 step; Enter: the next", "1 Schritt; Enter: der nächste"};
inline constexpr Phrase kStepsFound{"{0} steps; Enter: the next", "{0} Schritte; Enter: der nächste"};
inline constexpr Phrase kStagesSeen{"{0} of {1} stages seen", "{0} von {1} Abschnitten gesehen"};
inline constexpr Phrase kNotBegun{"{0} stages, not begun", "{0} Abschnitte, nicht begonnen"};
inline constexpr Phrase kForYourClass{
    "For your class: {0} of {1} stages; the others are passed over while you present.",
    "Für die Klasse: {0} von {1} Abschnitten; die anderen werden im Vortrag übersprungen."};
inline constexpr Phrase kChooseForClass{"Choose stages for a class…", "Abschnitte für eine Klasse wählen…"};
inline constexpr Phrase kWithoutMark{
    "What has no mark is passed over while you present, and is not in the slides that Save makes. As long as "
    "there is no mark, all stages are shown.",
    "Was kein Häkchen hat, wird im Vortrag übersprungen und fehlt in den Folien, die „Sichern“ macht. "
    "Solange es kein Häkchen gibt, werden alle Abschnitte gezeigt."};
inline constexpr Phrase kDone{"Done", "Fertig"};
inline constexpr Phrase kAll{"All", "Alle"};
inline constexpr Phrase kNoMarks{"No marks", "Keine"};
inline constexpr Phrase kYouAreHereIn{"{0}: you are here", "{0}: diese Lektion"};
inline constexpr Phrase kYouAreHere{"you are here", "diese Lektion"};
inline constexpr Phrase kOpen{"Open", "Öffnen"};
inline constexpr Phrase kSeenAndRight{"{0} of {1} stages seen; questions: {2}",
                                      "{0} von {1} Abschnitten gesehen; Fragen: {2}"};
inline constexpr Phrase kQuestionsRight{"Questions: {0}", "Fragen: {0}"};
inline constexpr Phrase kOutcome{"outcome", "Lernziel"};
inline constexpr Phrase kOtherQuestions{"other questions", "übrige Fragen"};
inline constexpr Phrase kRightOfAsked{"right/asked", "richtig/gefragt"};
inline constexpr Phrase kCountRight{"{0} of {1} right", "{0} von {1} richtig"};
inline constexpr Phrase kCountRightAnswered{"{0} of {1} right, {2} answered",
                                            "{0} von {1} richtig, {2} beantwortet"};
inline constexpr Phrase kCountNotAnswered{"{0} not answered", "{0} nicht beantwortet"};
inline constexpr Phrase kCountNotYetRight{"{0} not yet right", "{0} noch nicht richtig"};
inline constexpr Phrase kSomeQuestions{" ({0} questions)", " ({0} Fragen)"};
inline constexpr Phrase kLastLesson{"This is the last lesson of the course.",
                                    "Das ist die letzte Lektion des Kurses."};
inline constexpr Phrase kToGoOn{"To go on: {0}", "Weiter mit: {0}"};
inline constexpr Phrase kToNextLesson{"Next lesson", "Nächste Lektion"};
inline constexpr Phrase kEndOfLesson{"The end of this lesson", "Das Ende dieser Lektion"};
inline constexpr Phrase kToRepeat{"To repeat: not yet answered right",
                                  "Zum Wiederholen: noch nicht richtig beantwortet"};
inline constexpr Phrase kPassedOverQuestions{"Passed over: not answered", "Übergangen: nicht beantwortet"};
inline constexpr Phrase kAllRight{"You have answered all questions right.",
                                  "Alle Fragen sind richtig beantwortet."};
inline constexpr Phrase kYouLearnTo{"You learn to {0}.", "Lernziele: {0}."};
inline constexpr Phrase kOneQuestion{"{0}; 1 question: {1}", "{0}; 1 Frage: {1}"};
inline constexpr Phrase kQuestions{"{0}; {1} questions: {2}", "{0}; {1} Fragen: {2}"};
inline constexpr Phrase kAllAnsweredRight{"all answered right", "alle richtig beantwortet"};
inline constexpr Phrase kNoneAnswered{"none answered", "keine beantwortet"};
inline constexpr Phrase kBegin{"Begin", "Beginnen"};
inline constexpr Phrase kGoOnAt{"Go on at stage {0}", "Weiter bei Abschnitt {0}"};
inline constexpr Phrase kHowToChoose{
    "Tab goes from lesson to lesson, Enter opens one, Escape closes this list.",
    "Tab geht von Lektion zu Lektion, Enter öffnet eine, Escape schließt die Liste."};
inline constexpr Phrase kNoOtherLesson{"No other lesson was found.",
                                       "Eine andere Lektion wurde nicht gefunden."};

// The body, and how it is seen.
inline constexpr Phrase kMomentsOfItsOwn{"moments of its own", "eigene Momente"};
inline constexpr Phrase kTheLessons{"the lesson's", "der Körper der Lektion"};
inline constexpr Phrase kOfTheLesson{"{0} (the lesson's)", "{0} (aus der Lektion)"};
inline constexpr Phrase kAngularVelocity{"Angular velocity", "Winkelgeschwindigkeit"};
inline constexpr Phrase kAtPresent{"Now", "Jetzt"};
inline constexpr Phrase kAngleOfOmegaAndL{"angle between ω and L", "Winkel zwischen ω und L"};
inline constexpr Phrase kEarthTurns{"The Earth turns once in 23 h 56 min.",
                                    "Die Erde dreht sich in 23 h 56 min einmal."};
inline constexpr Phrase kBodyAxes{"Body axes, at t = 0.", "Im Körpersystem, für t = 0."};
inline constexpr Phrase kOneOfScenes{
    "The body in picture {0} of {1}. A picture that begins in the same way changes with it.",
    "Der Körper in Bild {0} von {1}. Ein Bild, das ebenso beginnt, ändert sich mit."};
inline constexpr Phrase kBodyAxesOrDrag{
    "Body axes, at t = 0. Or take the tip of ω in the figure.",
    "Im Körpersystem, für t = 0. Oder die Spitze von ω in der Abbildung fassen."};
inline constexpr Phrase kSeenFrom{"Seen from", "Gesehen aus"};
inline constexpr Phrase kSpace{"space", "dem Raum"};
inline constexpr Phrase kFromBody{"body", "dem Körper"};
inline constexpr Phrase kBoth{"both", "beiden"};
inline constexpr Phrase kCamera{"Camera", "Kamera"};
inline constexpr Phrase kFollowBody{"follow the body", "mit dem Körper drehen"};
inline constexpr Phrase kLessonsCamera{"the lesson's camera", "die Kamera der Lektion"};
inline constexpr Phrase kOrDoubleClick{
    "Or double-click the figure; drag to turn, wheel to zoom",
    "Oder ein Doppelklick auf die Abbildung; Ziehen dreht, das Rad vergrößert"};
inline constexpr Phrase kInSpace{"In space", "Im Raum"};
inline constexpr Phrase kNamesAtArrows{"names at arrows and axes", "Namen an Pfeilen und Achsen"};
inline constexpr Phrase kDrawnByLesson{"drawn by an arrow of this lesson",
                                       "von einem Pfeil der Lektion gezeigt"};
inline constexpr Phrase kFromThreeQuarter{"three-quarter", "schräg"};
inline constexpr Phrase kFromFront{"front", "vorn"};
inline constexpr Phrase kFromSide{"side", "seitlich"};
inline constexpr Phrase kFromTop{"top", "oben"};
inline constexpr Phrase kFromBelow{"below", "unten"};
inline constexpr Phrase kRangeOfNumber{"From {0} to {1} {2}; double click: the lesson's value.",
                                       "Von {0} bis {1} {2}; Doppelklick: der Wert der Lektion."};

// Methods. Their names, and what is said of each, are in English.
inline constexpr Phrase kFromFastToAccurate{"From fast to accurate", "Von schnell bis genau"};
inline constexpr Phrase kFast{"fast", "schnell"};
inline constexpr Phrase kAccurate{"accurate", "genau"};
inline constexpr Phrase kMeasuring{"measuring the methods on this motion …",
                                   "die Verfahren werden gemessen …"};
inline constexpr Phrase kNotMeasured{"Nothing could be measured on this motion.",
                                     "An dieser Bewegung war nichts zu messen."};
inline constexpr Phrase kNotOnFront{
    "Each step of the slider is the fastest for its accuracy. The present method is none of them.",
    "Jede Stufe des Reglers ist die schnellste ihrer Genauigkeit. Das jetzige Verfahren ist keine davon."};
inline constexpr Phrase kMethodOfStep{"{0}, step {1} s", "{0}, Schritt {1} s"};
inline constexpr Phrase kMethodOfTolerance{"{0}, tolerance {1}", "{0}, Toleranz {1}"};
inline constexpr Phrase kMethodOfClosedForm{"{0}, closed form", "{0}, geschlossene Form"};
inline constexpr Phrase kFrontStep{"{0}: {1}, {2} a period", "{0}: {1}, {2} je Periode"};
inline constexpr Phrase kReferenceOfOthers{"what the errors of the others are against",
                                           "an ihm werden die anderen gemessen"};
inline constexpr Phrase kErrorAfterPeriods{"error after 10 periods {0}", "Fehler nach 10 Perioden {0}"};
inline constexpr Phrase kClosedForm{"A closed form: any t at once, no step.",
                                    "Eine geschlossene Form: jedes t sofort, ohne Schritte."};
inline constexpr Phrase kStepS{"step, s", "Schritt, s"};
inline constexpr Phrase kTolerance{"tolerance", "Toleranz"};
inline constexpr Phrase kGhostBeside{"the exact body beside it, as a ghost",
                                     "den genauen Körper daneben zeigen"};
inline constexpr Phrase kNowAndSince{"Now, and since t = 0", "Jetzt, und seit t = 0"};
inline constexpr Phrase kErrorOfOmega{"error of ω", "Fehler von ω"};
inline constexpr Phrase kErrorOfAttitude{"error of attitude", "Fehler der Lage"};
inline constexpr Phrase kTheReference{"the reference", "das Maß"};
inline constexpr Phrase kNoClosedForm{"no closed form", "keine geschlossene Form"};
inline constexpr Phrase kChangeOfT{"largest change of T", "größte Änderung von T"};
inline constexpr Phrase kChangeOfL{"largest change of |L|", "größte Änderung von |L|"};
inline constexpr Phrase kChangeOfDirection{"largest turn of L", "größte Drehung von L"};
inline constexpr Phrase kMotionPerFrame{"motion, per frame", "Bewegung, je Bild"};
inline constexpr Phrase kPicturePerFrame{"picture, per frame", "Abbildung, je Bild"};
inline constexpr Phrase kPicture{"Picture", "Abbildung"};
inline constexpr Phrase kDraft{"draft", "grob"};
inline constexpr Phrase kNormal{"normal", "normal"};
inline constexpr Phrase kFine{"fine", "fein"};
inline constexpr Phrase kSidesDiffer{"Both sides of the equations differ by",
                                     "Die Seiten der Gleichungen unterscheiden sich um"};
inline constexpr Phrase kAllowed{"{0}, allowed {1}", "{0}, erlaubt {1}"};
inline constexpr Phrase kWhatSceneRequires{"What the scene requires", "Was die Szene verlangt"};

// What is taken away, and how one likes it.
inline constexpr Phrase kPictures{"Pictures", "Bilder"};
inline constexpr Phrase kTransparent{"transparent background", "durchsichtiger Hintergrund"};
inline constexpr Phrase kSavePage{"Save the page", "Die Seite sichern"};
inline constexpr Phrase kSaveFigure{"Save the figure", "Die Abbildung sichern"};
inline constexpr Phrase kSaveDerivation{"Save the derivation", "Die Herleitung sichern"};
inline constexpr Phrase kSaveEquation{"Save the equation", "Die Gleichung sichern"};
inline constexpr Phrase kAsExportWrites{"As polhode export writes it.",
                                        "So, wie polhode export sie schreibt."};
inline constexpr Phrase kWithoutText{"Without text and plots", "Ohne Text und Kurven"};
inline constexpr Phrase kYoursAt300{"Yours, as far as it goes, at 300 dots per inch",
                                    "Die eigene, so weit sie reicht, mit 300 dpi"};
inline constexpr Phrase kLastAt300{"The last one of this step, at 300 dots per inch",
                                   "Die letzte dieses Schritts, mit 300 dpi"};
inline constexpr Phrase kNoLineYet{"Your derivation has no line yet.",
                                   "Die eigene Herleitung hat noch keine Zeile."};
inline constexpr Phrase kNoEquation{"This step has no equation.", "Dieser Schritt hat keine Gleichung."};
inline constexpr Phrase kMotion{"Motion", "Bewegung"};
inline constexpr Phrase kCopyCsv{"Copy as CSV", "Als CSV kopieren"};
inline constexpr Phrase kSaveCsv{"Save as CSV", "Als CSV sichern"};
inline constexpr Phrase kSameAsFile{"The same as a file", "Dasselbe als Datei"};
inline constexpr Phrase kWhatCsvIs{
    "Over the time line, to be pasted into a table: t in s, ω in rad/s, the attitude as a quaternion, T in "
    "J, L in kg m²/s, each number with all its digits",
    "Über die Zeitleiste, zum Einfügen in eine Tabelle: t in s, ω in rad/s, die Lage als Quaternion, T in J, "
    "L in kg m²/s, jede Zahl mit allen Stellen"};
inline constexpr Phrase kSceneHeading{"Scene", "Szene"};
inline constexpr Phrase kSaveLesson{"Save as a lesson", "Als Lektion sichern"};
inline constexpr Phrase kWhatLessonIs{
    "With all that was changed by hand; polhode export makes the same figure of it",
    "Mit allem, was von Hand geändert ist; polhode export macht daraus dieselbe Abbildung"};
inline constexpr Phrase kSlides{"Slides", "Folien"};
inline constexpr Phrase kOfAllStages{"Of all stages; Outline chooses some for a class.",
                                     "Von allen Abschnitten; „Gliederung“ wählt einige für eine Klasse."};
inline constexpr Phrase kOfChosenStages{"Of the {0} stages chosen in Outline.",
                                        "Von den {0} unter „Gliederung“ gewählten Abschnitten."};
inline constexpr Phrase kSaveForBrowser{"Save slides for a browser", "Folien für einen Browser sichern"};
inline constexpr Phrase kSavePdf{"Save slides as PDF", "Folien als PDF sichern"};
inline constexpr Phrase kOneFile{
    "One file that any browser shows without network; as polhode export --deck makes it",
    "Eine Datei, die jeder Browser ohne Netz zeigt, wie von polhode export --deck"};
inline constexpr Phrase kSameAsPdf{"The same as a PDF. They are made while you go on",
                                   "Dasselbe als PDF. Sie entstehen, während es weitergeht"};
inline constexpr Phrase kAnswers{"Answers", "Antworten"};
inline constexpr Phrase kYourName{"your name, if it is to stand there", "der Name, wenn er dort stehen soll"};
inline constexpr Phrase kSaveReport{"Save a report to hand in", "Einen Bericht zum Abgeben sichern"};
inline constexpr Phrase kWhatReportIs{
    "What you answered in this lesson, as a text; without a name it does not say who you are",
    "Die Antworten zu dieser Lektion, als Text; ohne Namen sagt er nicht, von wem"};
inline constexpr Phrase kFolder{"Folder", "Ordner"};
inline constexpr Phrase kNothingOverwritten{
    "Nothing is overwritten: a name that is taken gets a number.",
    "Nichts wird überschrieben: Ein vergebener Name bekommt eine Zahl."};
inline constexpr Phrase kTextSize{"Text size", "Textgröße"};
inline constexpr Phrase kSmaller{"smaller", "kleiner"};
inline constexpr Phrase kLarger{"larger", "größer"};
inline constexpr Phrase kNowPercent{"now {0} %", "jetzt {0} %"};
inline constexpr Phrase kTheme{"Theme", "Farben"};
inline constexpr Phrase kAsDesktop{"as the desktop", "wie der Desktop"};
inline constexpr Phrase kPaper{"paper", "Papier"};
inline constexpr Phrase kDark{"dark", "dunkel"};
inline constexpr Phrase kMotionOnPage{"Motion on the page", "Bewegung auf der Seite"};
inline constexpr Phrase kFull{"full", "voll"};
inline constexpr Phrase kReduced{"reduced", "vermindert"};
inline constexpr Phrase kWhatReducedIs{"Reduced: nothing fades, travels or plays by itself.",
                                       "Vermindert: Nichts blendet, wandert oder spielt von selbst."};
inline constexpr Phrase kLettersAreCommands{"letters are commands", "Buchstaben sind Befehle"};
inline constexpr Phrase kWithoutLetters{
    "Without it letters and signs do nothing; buttons, the mouse and its right button's menus do it. "
    "Before an audience the period, which clickers send, still makes the screen black, and a number with "
    "Enter leads to a stage.",
    "Sonst tun Buchstaben und Zeichen nichts; dafür gibt es Knöpfe, die Maus und die Menüs ihrer rechten "
    "Taste. Vor Publikum macht der Punkt, den Presenter senden, trotzdem den Bildschirm schwarz, und eine "
    "Zahl mit Enter führt zu einem Abschnitt."};
inline constexpr Phrase kForAnAudience{"For an audience", "Für ein Publikum"};
inline constexpr Phrase kPresent{"Present", "Vortragen"};
inline constexpr Phrase kPresentWithWindow{"Present, with a window of your own",
                                           "Vortragen, mit eigenem Fenster"};
inline constexpr Phrase kFullScreen{"Full screen", "Ganzer Bildschirm"};
inline constexpr Phrase kLargerFigure{"Larger", "Größer"};
inline constexpr Phrase kBesideText{"Beside the text", "Neben den Text"};

}  // namespace polhode::words
