// SPDX-License-Identifier: MIT
// Whether what equals the lesson's answer answers the question. Internal to lessons/.
#pragma once

#include "lessons/claims/answers/answers.h"

#include <optional>
#include <set>
#include <string>

namespace polhode {

/// Why something that is true is no answer.
struct NoAnswer {
  std::string reason;  ///< one sentence, without a full stop
  const char* tag = "restated";
};

/// Precondition: the answer equals the lesson's under what the question assumes. It is none
/// - where it says what a formula of the prompt says, but for brackets, order, I·ω for L and components
///   written otherwise, "dot(a, e2)" for "comp(a, 2)";
/// - where it keeps a letter, or a product of vectors, that such a formula has and the lesson's answer has
///   not: what was to be replaced, or worked out;
/// - where it has other letters than those that are asked for (Question::letters).
std::optional<NoAnswer> why_no_answer(const Expression& answer, const Question& question,
                                      const Prover& prover);

/// What an expression is written with, as `letters` of a question lists it: "I", "omega", "L", constants,
/// "omega'" for the rate of ω; kRateOfMore for the rate of anything but one quantity. Axes are no letters.
std::set<std::string> letters_used(const Expression& expression);
inline constexpr const char* kRateOfMore = "d/dt";

/// "I, ω and ω̇"
std::string printed_letters(const std::vector<std::string>& letters);

}  // namespace polhode
