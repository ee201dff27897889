// SPDX-License-Identifier: MIT
// The tree of a formula as what a reader sees: atoms in a row, brackets with their contents. Internal to
// lessons/notation/ (tex_equation.h).
#pragma once

#include "lessons/claims/relation.h"
#include "render/typeset/math/tree.h"

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// Why a formula is not read. Thrown and caught within lessons/notation/.
struct TexFault : std::runtime_error {
  TexFault(SourceSpan at, const std::string& reason, std::string hint_ = {})
      : std::runtime_error(reason), place(at), hint(std::move(hint_)) {}
  SourceSpan place;
  std::string hint;
};
/// What is wrong is that vectors, numbers and tensors do not go together.
struct TexKindFault : TexFault {
  using TexFault::TexFault;
};

/// Widths of spaces, em, less a little for rounding: \quad, which parts what stands beside it; \!, which goes
/// back.
inline constexpr double kQuad = 0.99;
inline constexpr double kThinBack = -0.17;

/// What to write instead of (d𝐋/dt)_S.
inline constexpr std::string_view kRatesOfFrames =
    "\\frac{d\\vec L}{dt} is the rate as seen from space, \\frac{d^*\\vec L}{dt} that as seen from the body";

struct TexItem {
  enum class Kind {
    operand,   ///< `node`, with scripts
    group,     ///< `inside` between brackets `open`, with scripts
    sign,      ///< + or −: `character`
    times,     ///< `character` ⋅ × or /
    relation,  ///< `character`; arrows and ":" too
    comma,     ///< "," or ";"
    text,      ///< `node`: words
    gap,       ///< a space of \quad or more
    line       ///< a new line of an alignment
  };
  Kind kind = Kind::operand;
  const MathNode* node = nullptr;                 ///< the nucleus
  const MathNode *sub = nullptr, *sup = nullptr;  ///< null if absent
  const MathNode* label = nullptr;                ///< of an \underbrace, a group with `open` U+23DF
  char32_t character = 0, open = 0;
  bool struck = false;
  SourceSpan span;
  std::vector<TexItem> inside;

  bool is(Kind k, char32_t c) const { return kind == k && character == c; }
};
using TexItems = std::vector<TexItem>;

/// What hides a part of a formula, or takes it from its place: a colour, a space that goes back, the room of
/// something that is not printed. Null if nothing does.
const MathNode* hidden_part(const MathNode& node);
/// Throws TexFault at one.
void check_is_seen(const MathNode& root);

/// What stands in a row, brackets matched; nested at most `depth` deep. Throws TexFault.
TexItems items_of(const MathNode& node, int depth);

/// Whether it is more than one equation, so that what goes on may go on with either. Words in front are not.
bool has_several_equations(std::span<const TexItem> items);

/// The lines of the formula one behind the other, with a `line` between sentences (tex_equation.h).
TexItems whole_formula(const MathNode& root, int depth);
/// The same; where parts are marked by \proved{…}, these alone, one behind the other.
TexItems formula_items(const MathNode& root, int depth);

/// The parts of a formula that \proved{…} marks. They are joined to the rest of it, which nobody proves, by
/// nothing but commas, wide spaces and new lines, and no words but "and" and the like stand beside them: in
/// 5 = \proved{…}, under a root or behind "not" a true part would be said of something else. Throws TexFault
/// (tex_proved_parts.cpp).
std::vector<const MathNode*> proved_parts(const MathNode& root);
/// Whether it marks any.
bool has_proved_part(const MathNode& root);

/// Whether words in a formula, such as the label of a brace, state something: digits, a relation, or that
/// something vanishes, is constant, the half. Nobody proves words: they are to name what they stand at.
bool states_something(const MathNode& words);

/// The words of \text, one behind the other; empty of what is more than words.
std::string words_of(const MathNode& node);

/// "\text{const}", "\text{constant}" as all of a side: what stands before its = does not change.
bool says_constant(std::span<const TexItem> side);

/// Nothing of \sim, arrows and others, of which nothing is proved.
std::optional<Relation> relation_of(const TexItem& item);

/// `first` to `last`.
SourceSpan joined_span(SourceSpan first, SourceSpan last);

}  // namespace polhode
