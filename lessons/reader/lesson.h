// SPDX-License-Identifier: MIT
// A lesson as data: stages, their steps, and on each step text, mathematics, claims, questions and a scene.
// The file format is in lessons/FORMAT.md. Texts are there as they are written and ready to be set; the
// places in the latter count bytes of Lesson::source.
#pragma once

#include "base/result.h"
#include "lessons/claims/answers.h"
#include "lessons/claims/claim.h"
#include "lessons/diagnostics/diagnostic.h"
#include "lessons/reader/assumptions.h"
#include "lessons/reader/tex_equation.h"
#include "render/scene/description/scene.h"
#include "render/typeset/rich_text.h"

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace polhode {

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
  std::vector<Expression> live{};  ///< of its \live numbers: scalars
};

/// What the lecture said, or meant: a block quote that opens with [!said] or [!meant].
struct Callout {
  enum class Kind { said, meant } kind = Kind::said;
  std::string markdown;
  RichText text;
  SourcePlace place;
};

/// A question as it stands on a page: ```ask ID.
struct Ask : Question {
  std::string id;
  std::string prompt;
  RichText prompt_text;
  std::vector<RichText> choice_texts;
  std::vector<std::string> hints;
  std::vector<RichText> hint_texts;
  SourcePlace place;
};

using Block = std::variant<Prose, Equation, Claim, Callout, Ask>;

/// A step adds blocks to what the stage already shows; its scene is complete (inherited keys filled in).
struct Step {
  std::vector<Block> blocks;
  std::optional<Scene> scene;  ///< absent: text alone
  /// The scene's, null if it has none; steps that go on with a caption share it.
  std::shared_ptr<const RichText> caption;
};

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
  std::string means{};  ///< what it is, in the language of claims; "I" and "J" are the tensors
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

  const Stage* find_stage(std::string_view stage_id) const;
  /// The error names the one that may have been meant.
  Result<const Stage*> stage_named(std::string_view stage_id) const;
};

/// All display mathematics of a stage.
std::vector<const Equation*> equations_of(const Stage& stage);

}  // namespace polhode
