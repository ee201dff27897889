// SPDX-License-Identifier: MIT
// A lesson as data: stages, their steps, and on each step text, mathematics, claims, questions and a scene.
// The file format is in lessons/FORMAT.md. Texts are there as they are written and ready to be set; the
// places in the latter count bytes of Lesson::source.
#pragma once

#include "base/result.h"
#include "base/words/language.h"
#include "base/words/phrase.h"
#include "lessons/claims/answers/answers.h"
#include "lessons/claims/claim.h"
#include "lessons/diagnostics/diagnostic.h"
#include "lessons/notation/tex_equation.h"
#include "lessons/reader/checks/numbers/computed_number.h"
#include "lessons/reader/front_matter/assumptions.h"
#include "render/scene/description/scene.h"
#include "render/typeset/rich_text.h"

#include <algorithm>
#include <array>
#include <compare>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace polhode {

class VariedScene;  // varied_scene.h

/// Prose between two fences: Markdown as written (inline $…$ included), without the block's own syntax.
struct Prose {
  std::string markdown;
  RichText text;
  SourcePlace place;
};

/// Display mathematics: ```math ID.
struct Equation {
  std::string id;
  std::string tex;
  std::string tag;  ///< of \tag{…}, e.g. "5"; empty: unnumbered
  Math math;
  std::size_t offset = 0;  ///< of the TeX in Lesson::source
  SourcePlace place;
};

/// A call-out: a block quote that opens with [!KIND].
struct Callout {
  enum class Kind { said, meant, note, example, quote, aside, derivation, notes } kind = Kind::said;
  std::string markdown;
  RichText text;  ///< of a quote with the name below it
  SourcePlace place;
  /// Of a derivation what pages show of it: the text is for notes and transcripts. Empty of all others.
  RichText title{};
};

/// What a kind of call-out is called.
struct CalloutNames {
  Callout::Kind kind;
  std::string_view name;  ///< in lessons
  Phrase label;           ///< beside it on a page, unless [labels] has another
  Phrase words;           ///< before it where it is said
};
/// All kinds, in the order of the enumeration.
inline constexpr std::array<CalloutNames, 8> kCallouts = {
    {{Callout::Kind::said, "said", {"As said", "Gesagt"}, {"The lecture said", "Gesagt wird"}},
     {Callout::Kind::meant, "meant", {"As meant", "Gemeint"}, {"What it meant", "Gemeint ist"}},
     {Callout::Kind::note, "note", {"Note", "Hinweis"}, {"Note", "Hinweis"}},
     {Callout::Kind::example, "example", {"Example", "Beispiel"}, {"Example", "Beispiel"}},
     {Callout::Kind::quote, "quote", {"Quote", "Zitat"}, {"Quote", "Zitat"}},
     {Callout::Kind::aside, "aside", {"Aside", "Nebenbei"}, {"Aside", "Nebenbei"}},
     {Callout::Kind::derivation, "derivation", {"Derivation", "Herleitung"}, {"Derivation", "Herleitung"}},
     {Callout::Kind::notes, "notes", {"Notes", "Notizen"}, {"To say", "Zu sagen"}}}};
constexpr const CalloutNames& names_of(Callout::Kind kind) {
  return kCallouts[static_cast<std::size_t>(kind)];
}

/// What stands at the foot of a page, behind the number that its mark has in the text. The last blocks of a
/// step.
struct Footnote {
  int number = 1;
  RichText text;
  SourcePlace place;
};

struct Derivation;
struct StateTask;

/// Of the motion of a step.
struct PlayedInterval {
  double from_s = 0, to_s = 0;
};

/// A question as it stands on a page: ```ask ID.
struct Ask : Question {
  std::string id;
  std::string prompt;
  RichText prompt_text;  ///< with what is given behind it
  std::vector<RichText> choice_texts;
  std::vector<RichText> replies{};  ///< to who picks a choice, one for each; empty texts where there is none
  bool is_listed = false;           ///< its choices are a Markdown list
  std::vector<std::string> hints;
  std::vector<RichText> hint_texts;
  RichText because{};                     ///< why the answer is right; empty: nothing is said
  std::optional<PlayedInterval> plays{};  ///< what a prediction is held against before its verdict
  SourcePlace place;
  std::shared_ptr<const Derivation> derivation{};  ///< of the type derive
  std::vector<int> outcomes{};              ///< which of the lesson's it tests, from 1 (About::outcomes)
  std::shared_ptr<const StateTask> task{};  ///< of the type state
};

using Block = std::variant<Prose, Equation, Claim, Callout, Ask, Footnote>;

/// Of Step::from: there is nothing that a slide goes on from.
inline constexpr std::string_view kRecallsNothing = "none";

/// A step adds blocks to what the stage already shows; its scene is complete (inherited keys filled in).
struct Step {
  RichText title{};  ///< what the step comes to, in a sentence; empty: it has none
  std::vector<Block> blocks;
  /// Of the kind notes: what its author means to say, which is for who speaks. It stands on no page and in no
  /// transcript, and is therefore no block.
  std::vector<Callout> notes{};
  /// Null: text alone. Steps that go on with a scene share it.
  std::shared_ptr<const Scene> scene;
  /// Of the scene and those beside it, in the order in which they stand; null where one has none. Steps that
  /// go on with a caption share it.
  std::vector<std::shared_ptr<const RichText>> captions{};
  /// What their marks write in the figure, shared likewise.
  std::vector<std::shared_ptr<const RichText>> labels{};
  /// The scene with other numbers than it has, for the readers of its `vary`; null: there is none.
  std::shared_ptr<const VariedScene> varied{};
  std::string same{};  ///< why its picture is that of the step before; empty: it should be another
  /// What its slide recalls at the foot: "stage/equation", or "none"; empty: what the stage came to last.
  std::string from{};
  SourcePlace place{};  ///< of the stage's heading, or of the rule or title that it begins with
};

/// The caption of one of the scenes that are shown at a step, in the order in which they stand, or of a scene
/// that is shown without those beside it; null: it has none.
inline const RichText* caption_of(const Step& step, std::size_t shown) {
  return step.captions.empty() ? nullptr : step.captions[std::min(shown, step.captions.size() - 1)].get();
}

/// The blocks of one kind that a step adds, in their order.
template <class Kind>
std::vector<const Kind*> blocks_of(const Step& step) {
  std::vector<const Kind*> found;
  for (const Block& block : step.blocks)
    if (const auto* one = std::get_if<Kind>(&block)) found.push_back(one);
  return found;
}

struct Stage {
  std::string id;
  std::string title;
  RichText title_text;
  std::vector<Step> steps;  ///< at least one
  SourcePlace place;
};

struct Symbol {
  std::string tex;
  Math math;
  std::size_t offset = 0;  ///< of the TeX in Lesson::source
  std::string role;        ///< colour role
  std::string say;         ///< spoken form
  std::string unit;
  std::string note{};   ///< what is told to those who point at it; empty: the spoken form
  std::string means{};  ///< what it is, in the language of claims; "I" and "J" are the tensors
};

/// What the front matter says of the lesson itself; all of it may be left out.
struct About {
  std::vector<std::string> authors;
  std::string licence;
  Language language = Language::en;
  std::vector<std::string> outcomes, prerequisites;  ///< plain lines
  std::string next;                                  ///< id of a lesson
  std::map<Callout::Kind, std::string> labels;       ///< of call-outs that are not to have the usual ones
};

/// A source that the lesson can cite.
struct Reference {
  std::string key;   ///< "LL", as it is cited
  std::string text;  ///< a plain line
  bool is_cited = false;
};

/// Where another lesson is referred to: whoever has that lesson can tell whether there is such a place.
struct OutsideReference {
  std::string lesson;
  std::string stage{}, equation{};  ///< empty: all of the lesson, or of the stage
  SourcePlace place;
};

struct Lesson {
  std::string id;
  std::string title;
  std::map<std::string, Symbol> symbols;
  MathMacros macros;          ///< of the author
  EquationNotation notation;  ///< how its formulas are read
  Assumptions assumptions;    ///< what its claims and questions can be given
  std::vector<Stage> stages;
  std::string source;  ///< the whole file, without a byte order mark
  About about{};
  std::vector<Reference> references{};            ///< by their keys
  std::vector<OutsideReference> other_lessons{};  ///< in their order
  std::vector<ComputedNumber> numbers{};          ///< the place of each is its LiveNumber::id

  const Stage* find_stage(std::string_view stage_id) const;
  /// The error names the one that may have been meant.
  Result<const Stage*> stage_named(std::string_view stage_id) const;
};

/// All display mathematics of a stage.
std::vector<const Equation*> equations_of(const Stage& stage);

/// The ids of the numbers that the formulas of a text show, and those of what a step adds; those of its
/// caption are not among the latter.
std::vector<int> numbers_in(const RichText& text);
std::vector<int> numbers_in(const Block& block);
std::vector<int> numbers_in(const Step& step);

/// A step of a lesson, by its index among those of its stage, and that by its index; both count from 0.
struct StepPlace {
  std::size_t stage = 0, step = 0;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 finds a 0 in what the compiler makes of it
  auto operator<=>(const StepPlace&) const = default;
};
/// Where a link of the lesson's texts leads within the lesson: "#stage", or "#stage/equation" to the step
/// that brings the equation. Nothing for any other link.
std::optional<StepPlace> target_of(const Lesson& lesson, std::string_view link);

/// The equation of "stage/equation"; null if there is none.
const Equation* find_equation(const Lesson& lesson, std::string_view place);

/// The label beside a call-out of the lesson.
std::string_view label_of(const Lesson& lesson, Callout::Kind kind);

}  // namespace polhode
