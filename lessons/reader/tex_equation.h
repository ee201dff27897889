// SPDX-License-Identifier: MIT
// An equation as it is printed, read into the language of claims: what is proved is then what the page shows.
//
// Input is the tree that the formula is set from, so that reader and page cannot differ about the TeX. What
// comes out are the equalities that the formula states, each with its bytes of the TeX, as claims that were
// written by hand would be (expression.h): the same prover settles them. What has no single standard meaning
// is refused, with its place, a reason and, where there is one, a way to write it. Nothing is guessed.
//
//   formula    = [text "tempting:"] sentence { separator sentence } [condition]
//   separator  = ","  |  new line  |  "and"  |  ⇒  |  ⟹  |  "does not give"  |  ":" behind a premise
//   sentence   = side { "=" side }         every link of the chain is an equality of its own
//   side       = [±] term { ± term }       |  \live{…} unit, which stands for its expression
//   term       = run { (⋅ | ×) run } [/ factor]
//   run        = factor factor …           a product without a sign
//   condition  = \quad ( i = 1, 2, 3 )  |  \quad ( {i, j, k} = {1, 2, 3} )  |  \quad ( ω_2 = 0 )
//              |  \quad ( ω⃗ = ω_3 ê_3 )  |  \quad ( N⃗ = 0 )  |  "in S"
//
//   factor                                  means
//   T, m, I_1, ω_1, N_1, \dot ω_1           the quantity of that name; 1, 2, 3 are the axes of the body
//   ω⃗ L⃗ N⃗ p⃗ v⃗ F⃗ A⃗, ê_1; also in bold        the vector; A_1 is its component on a body axis
//   𝐈, 𝐈_S, 𝐈⁻¹, 𝟏, [a⃗]_×                    tensors: applied by ⋅ or by standing before a vector
//   I_{xy}, I_{12}                          components of any inertia tensor; then 𝐈 is that one, and I_x not
//   read (…) […] {…}, |a⃗|, |a⃗|², a⃗²              brackets; length; square of the length \frac{a}{b}, x^n n is
//   a whole number \frac{d…}{dt}, \frac{d}{dt}…, d…/dt     rate as seen from space \frac{d^*…}{dt}, … rate as
//   seen from the body; of a scalar there is no difference \dot                                    of
//   scalars, and of ω⃗, whose rate both frames agree on \sum_i …, \sum_{i=1}^3 …                over the axes
//   2×2 and 3×3 vmatrix; pmatrix            determinants; a tensor by its components on the body axes
//   \tr 𝐈                                   trace
//   a symbol of the lesson                  what its `means` says, or the quantity that has its name
//   x, y, z, \hat i, \hat j, \hat k         the axes 1, 2, 3, where the lesson says so (xyz_are_body_axes)
//
// Precedence, strongest first: powers and subscripts; products without a sign; ⋅ and ×; "/"; Σ and d/dt,
// which take the product without a sign that follows (Σ the whole term); + and −. So `m r⃗×v⃗` is (m r⃗)×v⃗, and
// `a⃗⋅2b⃗` is a⃗⋅(2b⃗). `a⃗×𝐈⋅b⃗` is a⃗×(𝐈⋅b⃗), `a⃗⋅b⃗×c⃗` and `a⃗×b⃗⋅c⃗` are triple products: there is no other way.
//
// Refused, because the page leaves it open: a⃗×b⃗×c⃗, a⃗⋅b⃗⋅c⃗, 𝐈⋅a⃗×b⃗, two vectors without a sign (a dyad), a/b c,
// a/b/c, d/dt (a) b, d/dt a⃗⋅b⃗, \dot of vectors other than ω⃗, T(0) and ω_1(t) (factor or argument?), 2\frac12,
// digits in groups, an index that is neither bound by Σ nor by a condition (no silent sums), + −, ±,
// relations other than "=", second derivatives, functions and roots, primes and unknown names, other words.
//
// Looked through: \term, \textcolor, \boxed, spaces below \quad, alignment, tags, a full stop at the end.
// Braces of TeX group nothing, for nobody sees them. \underbrace holds its contents together; its label,
// unless it is text, is one more equality: contents = label. What is struck out by \cancel states two
// equalities: the one with it, and the one without it, where a struck term is 0 and a struck factor 1.
//
// Aligned lines: one that begins with "=" goes on with the chain, one that begins with + or − with the side
// above if only one of the two lines has a "="; others are sentences of their own.
//
// d|a⃗|/dt = 0 is read as d(a⃗⋅a⃗)/dt = 0, the same wherever |a⃗| has a rate: proofs have no roots.
#pragma once

#include "base/result.h"
#include "lessons/claims/claim.h"
#include "render/typeset/math/math.h"

#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// A symbol of the lesson, as it is printed and what it is.
struct EquationSymbol {
  std::string name;   ///< without `means`: the quantity of that name (or I, J), if there is one
  Math math;          ///< its TeX
  std::string means;  ///< an expression of the language of claims; I and J are the tensors
};

/// How a lesson's formulas are to be read. What a lesson declares goes before what is built in: a symbol that
/// is declared and means nothing known makes the formulas that use it unreadable.
struct EquationNotation {
  std::vector<EquationSymbol> symbols;
  bool xyz_are_body_axes = false;
};

/// left = right.
struct EquationLink {
  Equality equality;
  SourceSpan source;  ///< of both sides, in the TeX
};

/// A chain of links, and how it hangs together with the sentence before it.
struct EquationSentence {
  enum class Joint { none, follows, does_not_follow };
  Joint joint = Joint::none;
  std::vector<EquationLink> links;
  bool is_no_torque = false;  ///< N⃗ = 0 and nothing else
  SourceSpan source;
};

struct ReadEquation {
  std::vector<EquationSentence> sentences;
  bool is_tempting = false;     ///< "tempting:" stands before it
  bool without_torque = false;  ///< a condition says N⃗ = 0
};

/// Why a formula is not read.
struct UnreadableEquation {
  SourceSpan place;  ///< bytes of the TeX
  std::string reason, hint;
};

/// Brackets nest at most so deep, and a formula has at most so many factors once its sums are written out.
inline constexpr int kMaxEquationNesting = 48;
inline constexpr int kMaxEquationFactors = 4000;
inline constexpr std::size_t kMaxEquationLinks = 64;

/// A formula that begins with "=" goes on with the last side of the one `above` it; null if there is none.
/// Linear in the formula, times 3 for each sum in a sum, up to the limits; 20 to 200 µs for one of the
/// lecture, at most 10 ms.
Result<ReadEquation, UnreadableEquation> read_equation(const Math& math, const EquationNotation& notation,
                                                       const Math* above = nullptr);

/// The lines of a claim of this kind, whose places are all `place`.
///
/// kind            lines
/// non-sequitur    premise => conclusion, of a formula "… does not give …" with one equality on either side
/// false           one: the formula states one equality, beside N⃗ = 0 perhaps
/// others          every equality. Of "A ⇒ B" both are proved, which is more than that B follows; but N⃗ = 0
/// is left
///                 out: of the kind free it is assumed, of others the rest is proved with any torque
///
/// "tempting:" goes with the kind false alone. Lengths have to be provable (has_provable_lengths), but for
/// `measured`.
Result<std::vector<ClaimLine>, UnreadableEquation> claim_lines_of(const ReadEquation& equation,
                                                                  ClaimKind kind, SourcePlace place);

}  // namespace polhode
