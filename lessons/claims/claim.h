// SPDX-License-Identifier: MIT
// What an equation claims, as data. proof.h settles it, live_claims.h says what it comes to on a motion.
#pragma once

#include "lessons/claims/expressions/expression.h"
#include "lessons/claims/given.h"
#include "lessons/claims/relation.h"
#include "lessons/diagnostics/diagnostic.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

enum class ClaimKind { identity, definition, law, motion, free, is_false, measured, non_sequitur };
std::string_view name_of(ClaimKind kind);
/// Nothing if no kind has the name.
std::optional<ClaimKind> claim_kind_from(std::string_view name);
std::vector<std::string> claim_kind_names();

/// not_refuted: an inequality without a proof, which held in every state that was tried. undecided: too
/// seldom defined, or its numbers too large.
enum class Verdict { holds, not_refuted, fails, undecided };

/// The body of a counterexample, how it turns, and the torque on it, as far as a figure can show them: kg m²,
/// rad/s and N m on its axes; whatever the sides do not depend on is some possible number.
struct CounterBody {
  std::array<double, 3> I{}, w{}, N{};
  std::array<double, 4> q{1, 0, 0, 0};  ///< w x y z, of any length but 0: body to space
  bool has_more =
      false;  ///< the counterexample has numbers besides: of p, v, A, constants, rates of their own
};

/// A possible body in a state of small whole numbers; axes of body and space coincide.
struct Counterexample {
  std::string state;                  ///< "I = (2, 3, 4), ω = (1, 1, 0)"
  std::string left, right;            ///< values of both sides; of a non-sequitur those of the conclusion
  std::optional<CounterBody> body{};  ///< nothing where something is small without being a number
  std::string state_tex{};            ///< "$(I_1, I_2, I_3) = (2, 3, 4)$, $\\vec\\omega = (1, 1, 0)$"
};
/// Of the text of a number, or of several, of a counterexample: "−1, √2, 2ε" is "-1, \\sqrt{2},
/// 2\\varepsilon".
std::string numbers_as_tex(std::string_view text);
/// "at I = …: left …, right …"
std::string to_string(const Counterexample& counterexample);

/// What is to be said of a line of a claim.
struct Judgement {
  Verdict verdict = Verdict::holds;  ///< whether the line is what its kind says
  std::string message, hint;         ///< of what is not
  /// Where the line does not hold; for the kinds false and non-sequitur that is what is claimed.
  std::optional<Counterexample> counterexample;
  int states = 0;  ///< of what is not refuted: in how many it held
};

/// One line of a claim: `left = right`, `left <= right`, or `premise => conclusion`: what follows, and for a
/// non-sequitur what does not. proof.h settles it.
struct ClaimLine {
  Equality equality;                   ///< the sides; where something follows or not, the premise
  std::optional<Equality> conclusion;  ///< where something follows or not
  std::optional<double> within;        ///< of `measured`: relative tolerance after the word
  SourcePlace place;
  bool goes_on = false;  ///< the chain of the line before: its left side is that line's right side
  /// Its sides are two that stand on the page. Not so of the columns of a tensor, what is said with a struck
  /// term left out, or the label of an underbrace.
  bool is_side_by_side = true;
  std::optional<Judgement> judgement{};  ///< once it is proved (lessons/reader/checks/claim_check.h)
  Relation relation = Relation::equal;   ///< of the sides
  std::string tex{};                     ///< of what is not the formula itself: how it is printed
  bool is_number = false;                ///< its right side is printed as a number that is computed
};
struct Claim {
  std::string equation;  ///< id of an equation of the same stage
  ClaimKind kind = ClaimKind::identity;
  std::vector<ClaimLine> lines;
  SourcePlace place;
  /// Where the lines come from: read from the equation's TeX, or from what \proved{…} marks in it, or written
  /// beside it by an author. Whoever shows the verdict shows them too unless they are the whole formula.
  enum class Origin { beside, part, formula } origin = Origin::beside;
  Given given{};  ///< what it assumes beyond its kind
  /// The author knows that the lines speak of other quantities than the formula does.
  bool in_other_words = false;
};

}  // namespace polhode
