// SPDX-License-Identifier: MIT
// An equation as it is printed, read into the language of claims: what is proved is then what the page shows.
//
// Input is the tree that the formula is set from, so that reader and page cannot differ about the TeX. What
// comes out are the equalities that the formula states, each with its bytes of the TeX, as claims that were
// written by hand would be (expression.h): the same prover settles them. What has no single standard meaning
// is refused, with its place, a reason and, where there is one, a way to write it. Nothing is guessed.
//
//   formula    = ["tempting:"] sentence { separator sentence } [condition]
//   separator  = ","  |  new line  |  "and"  |  "does not give"  |  \Rightarrow or ":" behind a condition
//   sentence   = side { relation side }  every link of the chain is a statement of its own
//   relation   = "="  |  \approx  |  \le  |  \ge  |  "<"  |  ">", the last four between numbers
//   side       = [sign] term { sign term }  |  at the end of a chain \live{…} unit, for its expression
//   term       = run { (\cdot | \times) run } [/ factor]
//   run        = factor factor …         a product without a sign
//   condition  = \quad (i = 1, 2, 3)  |  \quad (\{i, j, k\} = \{1, 2, 3\})  |  "in S"
//              | \quad (\omega_2 = 0)  |  \quad (\vec\omega = \omega_3\hat e_3)  |  \quad (\vec N = 0)
//
//   factor                               means
//   T, m, I_1, \omega_1, \dot\omega_1    the quantity; 1, 2, 3 are the axes of the body
//   \vec\omega, \vec L, N p v F A        vectors, in bold too; A_1 is a component on the body's axis
//   \hat e_1, \hat e_z, \vec 0           a body axis; an axis of space, unless x, y, z are the body's; zero
//   \mathbf I, \mathbf I_S               the inertia tensor; applied by \cdot or by standing before a vector
//   \mathbf I^{-1}, \mathbf 1            other tensors; [\vec a]_\times is b -> a x b
//   I_{xy}, I_{12}                       components of any inertia tensor: then \mathbf I is that one, and
//                                        moments I_x are not read
//   (…) […] \{…\}                        brackets; (…)_1 is a component
//   |\vec a|, |\vec a|^2, \vec a^2       length; its square
//   \frac{a}{b}, a^n                     n is a whole number
//   \frac{d…}{dt}, \frac{d}{dt}…, d…/dt  rate as seen from space
//   the same with d^*                    rate as seen from the body; of scalars there is but one
//   \frac{d^2…}{dt^2}, \frac{d^2}{dt^2}…  second rate, as seen from space
//   \dot                                 rate as seen from space; of \vec\omega both frames agree
//   \ddot                                second rate of scalars
//   a = \text{const}                     the rate of a, as seen from space, is 0; at the end of a formula
//   \sum_i …, \sum_{i=1}^{3} …           over the axes; i, j, k or l
//   vmatrix of 2 or 3 rows               determinant; unit vectors may stand in the first row of three
//   pmatrix, bmatrix of 3 rows           tensor, by its components on the body's axes
//   \text{tr}                            trace
//   \sqrt{a}, \sin, \cos, \arccos        of numbers: \cos\theta, \cos(2\theta); for what is measured, but
//                                        \cos of an angle that means acos(a) is a
//   a symbol of the lesson               what its `means` says, or the quantity or word that has its name
//   x, y, z, \hat i, \hat j, \hat k      axes 1, 2, 3 where the lesson says so (xyz_are_body_axes)
//
// Precedence, strongest first: powers and indices; products without a sign; \cdot and \times; "/"; \sum and
// d/dt, which take what follows as a product without a sign (\sum all of its term); + and −. So "m r x v" is
// (m r) x v, and "a · 2b" is a · (2b). "a x I·b" is a x (I·b); "a·b x c" and "a x b·c" are triple products:
// there is no other way.
//
// Refused, because the page leaves it open: a x b x c, a·b·c, I·a x b, two vectors without a sign, a/b c,
// a/b/c, d/dt (a) b, d/dt a·b, \dot of other vectors, T(0) and \omega_1(t) (factor or argument?), 2\frac12,
// \cos\theta/2, 2\mathbf 0, \frac{a}{b}^2, digits in groups, an index that no \sum and no condition binds,
// unless it is the only one and both sides of each relation have it: L_i = I_i\omega_i is said of each axis
// (no silent sums), two signs in a row, \pm, other relations, third derivatives, other functions and roots,
// primes and unknown names, letters of other alphabets, other words.
//
// Where parts are marked by \proved{…} these alone are read, each as a formula of its own; nothing but
// commas, wide spaces and new lines joins them to the rest (tex_proved_parts.cpp).
//
// Refused wherever it stands, because it hides or moves something: colours, phantoms with a width, spaces and
// lines that go back, rules between lines.
//
// Looked through: \term, a \boxed around all, spaces that together stay below \quad, alignment, tags, a full
// stop at the end. Braces of TeX group nothing, for nobody sees them. \underbrace holds its contents
// together; its label, unless it is text, is one more equality: contents = label. What is struck out by
// \cancel states two equalities: the one with it, and the one without it, where a struck term is 0 and a
// struck factor 1.
//
// Aligned lines: one that begins with a relation goes on with the chain, one that begins with + or − with the
// side above if only one of the two lines has a "="; others are sentences of their own. Above a line that
// goes on there is one equation: of two, or of one behind a comma, the page leaves open which.
//
// "d|a|/dt = 0" is read as d(a·a)/dt = 0, the same wherever |a| has a rate: proofs have no roots. The rate of
// a tensor is that of its columns: (dI/dt) e = d(I·e)/dt − I·de/dt.
#pragma once

#include "base/result.h"
#include "lessons/claims/claim.h"
#include "lessons/claims/expressions/vocabulary.h"
#include "render/typeset/math/math.h"

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace polhode {

struct TexItem;  // lessons/notation/tex_items.h

/// A symbol of the lesson, as it is printed and what it is.
struct EquationSymbol {
  std::string name;   ///< without `means`: the quantity or word of that name (or I, J), if there is one
  Math math;          ///< its TeX
  std::string means;  ///< an expression of the language of claims; I and J are the tensors
  /// `math` told apart into atoms, once for all formulas that are read; null: each does it anew.
  std::shared_ptr<const std::vector<TexItem>> items{};
};
/// A symbol with its items.
EquationSymbol equation_symbol(std::string name, Math math, std::string means);

/// How a lesson's formulas are to be read. What a lesson declares goes before what is built in: a symbol that
/// is declared and means nothing known makes the formulas that use it unreadable.
struct EquationNotation {
  std::vector<EquationSymbol> symbols;
  Vocabulary vocabulary;  ///< what they mean may use these words
  bool xyz_are_body_axes = false;
};

/// left = right, left ≈ right, or an inequality.
struct EquationLink {
  Equality equality;
  SourceSpan source;            ///< of both sides, in the TeX
  bool goes_on = false;         ///< with the link before, whose right side is its left side
  bool is_side_by_side = true;  ///< as of ClaimLine
  Relation relation = Relation::equal;
  bool is_number = false;  ///< the right side is a number that the program computes
};

/// A chain of links, and how it hangs together with the sentence before it.
struct EquationSentence {
  enum class Joint { none, follows, does_not_follow };
  Joint joint = Joint::none;
  std::vector<EquationLink> links;
  bool is_no_torque = false;  ///< N = 0 and nothing else
  SourceSpan source;
};

struct ReadEquation {
  std::vector<EquationSentence> sentences;
  bool is_tempting = false;     ///< "tempting:" stands before it
  bool without_torque = false;  ///< a condition says N = 0
  bool has_condition = false;   ///< a condition on N or ω stands in it
  bool is_part = false;         ///< what \proved{…} marks; the rest was not read
};

/// Why a formula is not read.
struct UnreadableEquation {
  SourceSpan place;  ///< bytes of the TeX
  std::string reason, hint;
  bool of_kinds = false;  ///< vectors, numbers and tensors do not go together
};

/// Brackets nest at most so deep, and a formula has at most so many factors once its sums are written out.
inline constexpr int kMaxEquationNesting = 48;
inline constexpr int kMaxEquationFactors = 4000;
inline constexpr std::size_t kMaxEquationLinks = 64;

/// A formula that begins with "=" or \approx goes on with the last side of the one `above` it; null if there
/// is none. Linear in the formula, times 3 for each sum in a sum, up to the limits; 15 µs for one of the
/// lecture, of the largest 40, at most 10 ms.
Result<ReadEquation, UnreadableEquation> read_equation(const Math& math, const EquationNotation& notation,
                                                       const Math* above = nullptr);

/// The letters of the language of claims that a formula shows, whether or not it can be read: "T", "I",
/// "omega", "L", "N", "m", "p", "v", "F", "A", "e", "h", "k". Components, rates and the tensor count as their
/// letter.
enum class IndexedLetters { left_out, as_printed };  ///< T_0, which is nothing that is known: "T_0"
std::set<std::string> letters_in(const Math& math, const EquationNotation& notation,
                                 IndexedLetters indexed = IndexedLetters::left_out);
/// The same of an expression.
std::set<std::string> letters_in(const Expression& expression);
/// All that these can be.
std::vector<std::string> quantity_letters();

using PlaceOfSpan = std::function<SourcePlace(SourceSpan)>;

/// The lines of a claim of this kind; `place_of` says where bytes of the TeX stand in the lesson.
///
/// kind            lines
/// non-sequitur    premise => conclusion, of a formula "… does not give …" with one equality on either side
/// false           one: the formula states one equality, beside N = 0 perhaps
/// others          every equality. Of "A ⇒ B" that B follows from A, premise => conclusion; but behind N = 0,
///                 which of the kind free is assumed, the rest is proved with any torque of other kinds
///
/// "tempting:" goes with the kind false alone. Lengths have to be provable (is_provable), but for
/// `measured`.
Result<std::vector<ClaimLine>, UnreadableEquation> claim_lines_of(const ReadEquation& equation,
                                                                  ClaimKind kind,
                                                                  const PlaceOfSpan& place_of);

}  // namespace polhode
