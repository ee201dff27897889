// SPDX-License-Identifier: MIT
// A derivation: from a start line to a goal, line by line, each judged as it is typed.
//
// A line holds if each of its equalities does, proved as claims are (lessons/claims/proof/proof.h) under what
// the derivation allows: `identity` for every body, ω, ω̇ and N, `motion` with Euler's law dL/dt = N, `free`
// with N = 0, and what is given. So a line may take several steps at once; but the goal counts only behind as
// many lines of the learner's own as the lesson asks for.
//
// Why a line does not hold is found by mending it (slips.h).
#pragma once

#include "lessons/claims/proof/proof.h"
#include "lessons/derivation/canonical_form.h"
#include "lessons/notation/tex_equation.h"
#include "lessons/notation/typed/typed_formula.h"

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// How lines of a lesson are read.
struct LineNotation {
  const EquationNotation* notation = nullptr;
  TypedNames names;
  MathMacros macros;                              ///< of the lesson, in the names
  std::shared_ptr<const EquationNotation> own{};  ///< that of `notation`, where nobody else has it
};

/// A line that was read: a chain of equalities.
struct DerivedLine {
  std::string typed, tex;
  std::vector<Equality> links;  ///< at least one
  Equality whole;  ///< the first and the last side of the chain, with the lines that it goes on from
};

struct UnreadableLine {
  std::string message, hint;
  int column = 1;         ///< of characters of the line
  std::string tex;        ///< of what can be set of it
  bool of_kinds = false;  ///< it is that of vectors and numbers that do not go together
};

/// `above`: the line before, from whose right side one that begins with "=" goes on; null: there is none.
Result<DerivedLine, UnreadableLine> read_line(std::string_view typed, const LineNotation& how,
                                              const DerivedLine* above);

/// A line of the lesson's own solution, and what is said to who does not find it.
struct WorkedLine {
  DerivedLine line;
  std::string point, teach;  ///< what is to be used; how. Markdown of one line
};

struct Derivation {
  DerivedLine start, goal;
  LawsAssumed laws = LawsAssumed::identity;
  Given given;
  std::vector<DerivedLine> facts;  ///< what may be used
  std::set<std::string> letters;   ///< of all that stands here (letters_in)
  std::vector<WorkedLine> worked;  ///< from the first line behind the start to the goal
  int least_lines = 1;             ///< so many lines that hold lead to the goal, with itself
};

/// The letters that a derivation speaks of.
std::set<std::string> letters_of(const Derivation& derivation);

/// What is typed, for help.
inline constexpr std::string_view kWordsOfDerivations =
    "dL/dt or d/dt (…) as seen from space, d*L/dt from the body; w1' and omega' for rates; omega x L, omega "
    ". L; I omega for the tensor; I1 w1, 1/2, w1^2, |L|^2; = … goes on from the line before";

/// What a mistake is.
enum class Slip {
  none,
  kind,
  signs,
  sign,
  transport,
  missing,
  extra,
  index,
  frame,
  rate,
  inertia,
  power,
  factor,
  indices,
  torque,
  law,
  other
};
std::string_view name_of(Slip slip);

struct LineJudgement {
  /// away: it holds, and leads nowhere.
  enum class Mark { holds, goal, away, wrong, unreadable } mark = Mark::holds;
  Slip slip = Slip::none;           ///< of what is wrong
  std::string reason, hint;         ///< one sentence, without a full stop; of the goal empty
  int column = 0;                   ///< of what cannot be read; 0: the whole
  std::string tex;                  ///< the line as it is set
  std::optional<DerivedLine> line;  ///< of what can be read
  std::optional<Counterexample>
      counterexample;  ///< of what is wrong, if one of small whole numbers was found
};
std::string_view name_of(LineJudgement::Mark mark);

/// Judges a line behind `before`, lines that hold, in their order. At most some 50 ms.
LineJudgement judge_line(const Derivation& derivation, const std::vector<DerivedLine>& before,
                         std::string_view typed, const LineNotation& how, const Prover& prover);

/// Whether lines that hold are a derivation: the last is the goal, and there are enough.
bool is_goal(const Derivation& derivation, const DerivedLine& line, const Prover& prover);

/// The line of the lesson's solution that comes next for who has these: behind the last that is among them.
std::size_t next_worked(const Derivation& derivation, const std::vector<DerivedLine>& lines);

}  // namespace polhode
