// SPDX-License-Identifier: MIT
// Whether a claim holds: settled by exact arithmetic, with a counterexample where it does not.
//
// The two sides are rational functions of the state (moments, components of ω, ω̇, N …, quaternion) with
// rational coefficients, and so are their rates: those of ω̇, N and F that no law says are numbers of the
// state like others. They are compared at kSamples points drawn at random modulo p = 2⁶¹ − 1. One point where
// they differ refutes the claim for certain. Two different functions agree only at the zeros of a polynomial.
// Its degree d is bounded as the expressions are read (degree.h), by at most 2·kMaxDegree + 64. A random
// point is such a zero with a probability of at most d/p ≤ 8256/p < 4e-15 (Schwartz, J. ACM 27 (1980)
// 701-717, Lemma 1; Zippel, EUROSAM 1979); kSamples independent points all are with one below 3e-116. The
// points are drawn from a fixed seed, so that runs repeat. Lest somebody make up a claim that agrees at just
// these, it is tried at two more points, whose seed is a hash of its own text.
//
// Coefficients that p divides would vanish too. All operations turn with their vectors, so the claim says the
// same where the axes of body and space coincide; there the coefficients of the difference are whole
// numbers whose size is bounded as the degree is (Degree). Below 2⁶⁰ none but 0 is divisible by p. Otherwise
// the sides are compared at one more point modulo 2¹²⁷ − 1, whose product with p divides none but 0 below
// 2¹⁸⁷; beyond, the claim is undecided.
//
// Lengths, norm(a) = norm(b), are compared by their squares: neither is negative.
//
// What a lesson assumes beyond the kind (given.h) is put into the points before anything is evaluated: I2 =
// I1 replaces the second moment by the first, and N changes as what it is set to does. The sides are then
// functions of what is left. Settings build on each other, each multiplying degrees by up to
// kMaxSettingDegree; so degree and coefficients are bounded once more, with each quantity of the degree of
// what it is set to. From kMostProvableDegree = 2²⁸ on the claim is undecided; below, a point is a zero of
// the difference with a probability below 2⁻³³, and kSamples are with one below 1e-79.
#pragma once

#include "lessons/claims/claim.h"
#include "lessons/claims/claim_state.h"

#include <optional>
#include <string>
#include <vector>

namespace polhode {

inline constexpr int kSamples = 8;
/// States that are tried for kSamples at which both sides are defined.
inline constexpr int kMostSamples = 16;

/// Draws its states once (90 µs). A claim of the lecture then costs some 5 to 20 µs, one of 4096 bytes up to
/// 10 ms; the search for a counterexample up to some 50 ms (tests/bench/claims_bench.cpp).
class Prover {
 public:
  Prover();

  Verdict settle(const Equality& equality, LawsAssumed laws, const Given& given = {}) const;
  /// Whether both sides have a value anywhere. What is undecided and has one is too large to be decided.
  bool is_defined(const Equality& equality, LawsAssumed laws, const Given& given = {}) const;
  /// A state where the equality fails; nothing if none of those tried is one.
  std::optional<Counterexample> refute(const Equality& equality, LawsAssumed laws,
                                       const Given& given = {}) const;
  /// Where quantities are small. What is undecided has its reason with it.
  Judgement settle_in_series(const Equality& equality, LawsAssumed laws, const Given& given) const;
  /// A line that states an inequality: proved (signs.h), refuted by a possible state, or neither.
  Judgement settle_inequality(const ClaimLine& line, LawsAssumed laws, const Given& given = {}) const;
  /// A motion with any torque in which the premise holds and the conclusion fails.
  std::optional<Counterexample> refute_inference(const Equality& premise, const Equality& conclusion,
                                                 const Given& given = {}) const;

 private:
  /// At one of the samples; nothing: it is not defined there.
  std::optional<bool> agrees_at(std::size_t sample, const Equality& equality, LawsAssumed laws,
                                const Given& given) const;
  const std::vector<ClaimState<FieldElement>>& samples(LawsAssumed laws) const {
    return samples_[static_cast<std::size_t>(laws)];
  }
  Verdict agree_in_series(const Equality& equality, LawsAssumed laws, const Given& given,
                          std::string& why) const;
  bool agrees_at_its_own_points(const Equality& equality, LawsAssumed laws, const Given& given) const;
  Verdict confirmed(const Equality& equality, LawsAssumed laws, const Given& given) const;

  std::array<std::vector<StateNumbers<FieldElement>>, 3> numbers_;  ///< of the samples
  std::array<std::vector<ClaimState<FieldElement>>, 3> samples_;
  StateNumbers<WideFieldElement> wide_;
};

/// Of any kind but measured, which is a matter of the scene: live_claims.h.
Judgement judge(const ClaimLine& line, ClaimKind kind, const Prover& prover, const Given& given = {});

/// What a kind assumes; of `false`, what it must fail under: no torque, unless one is given.
LawsAssumed laws_assumed_by(ClaimKind kind, const Given& given = {});

}  // namespace polhode
